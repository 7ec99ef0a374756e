// SPDX-License-Identifier: BSD-3-Clause
//! Prints the motion units and cycles of a clip as a table.
//!
//!     cargo run --example decompose -- walk.bvh

use stltsa::{Clip, Options};

fn print(kind: &str, frames: std::ops::Range<usize>, begin_s: f64, end_s: f64) {
    let std::ops::Range { start, end } = frames;
    println!("{kind:<10} frames {start:>5} .. {end:<5}  {begin_s:>7.3} s .. {end_s:.3} s");
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args_os().nth(1).ok_or("usage: decompose CLIP")?;
    let found = Clip::open(path)?.decompose(&Options::new())?;

    for unit in found.units() {
        print(&unit.kind.to_string(), unit.frames(), unit.begin_s, unit.end_s);
    }
    for cycle in found.cycles() {
        print("cycle", cycle.frames(), cycle.begin_s, cycle.end_s);
    }
    // A clip without cycles is not an error; the reason explains why there are none.
    if let Some(reason) = found.reason() {
        println!("no cycle: {reason}");
    }
    for warning in found.warnings() {
        println!("warning: {}", warning.text);
    }
    Ok(())
}
