// SPDX-License-Identifier: BSD-3-Clause
//! Repeats the best cycle of a clip.
//!
//!     cargo run --example loop_cycle -- walk.bvh 8 loop.bvh

use stltsa::{Clip, Options, Piece, Synthesis};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [source, times, target] = match arguments.as_slice() {
        [source, times, target] => [source, times, target],
        _ => return Err("usage: loop_cycle CLIP TIMES NEW_CLIP".into()),
    };
    let clip = Clip::open(source)?;
    let found = clip.decompose(&Options::new())?;
    let best = match found.best() {
        Some(best) => best.frames(),
        None => return Err(found.reason().unwrap_or_default().into()),
    };
    println!("cycle: frames {} .. {}", best.start, best.end);

    let pieces = [Piece::new(&clip, best).repeat(times.parse()?)];
    let made = Synthesis::new(&pieces, &Options::new())?;
    for seam in made.seams() {
        let (frame, posture, step) = (seam.frame, seam.posture, seam.step);
        println!("seam at frame {frame}: posture {posture:.3}, step {step:.3} (1: not to be seen)");
    }
    made.clip().save(target)?;
    println!("{} frames written", made.clip().frames());
    Ok(())
}
