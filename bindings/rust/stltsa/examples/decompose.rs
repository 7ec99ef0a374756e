// SPDX-License-Identifier: BSD-3-Clause
//! Prints the motion units and cycles of a clip as a table.
//!
//!     cargo run --example decompose -- walk.bvh

use stltsa::{Clip, Interval, Options};

fn print(interval: &Interval) {
    let Interval { kind, begin, end, begin_s, end_s } = interval;
    println!("{kind:<10} frames {begin:>5} .. {end:<5}  {begin_s:>7.3} s .. {end_s:.3} s");
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args_os().nth(1).ok_or("usage: decompose CLIP")?;
    let found = Clip::open(path)?.decompose(&Options::new())?;

    found.units().iter().chain(found.cycles()).for_each(print);
    // A clip without cycles is not an error; the reason explains why there are none.
    if let Some(reason) = found.reason() {
        println!("no cycle: {reason}");
    }
    for warning in found.warnings() {
        println!("warning: {warning}");
    }
    Ok(())
}
