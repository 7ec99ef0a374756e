// SPDX-License-Identifier: BSD-3-Clause
//! Fits the curve of one clip, maps the frames of another onto it, and turns the result into poses.
//!
//!     cargo run --example map -- walk.bvh other.bvh poses.bvh

use stltsa::{Clip, Fact, Model, Options};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<_> = std::env::args_os().skip(1).collect();
    let [learned, other, poses] = match arguments.as_slice() {
        [learned, other, poses] => [learned, other, poses],
        _ => return Err("usage: map LEARNED OTHER POSES.bvh".into()),
    };
    let defaults = Options::new();

    // Three coordinates distinguish the forward from the backward swing; one cannot.
    let model = Model::fit_clip(&Clip::open(learned)?, &Options::new().dimension(3))?;
    let (rows, neighbors) = (model.info().int(Fact::Rows)?, model.info().int(Fact::Neighbors)?);
    println!("{rows} frames learned, {neighbors} neighbors");

    // Frames with a distance above 1 are unlike the fitted ones.
    let clip = Clip::open(other)?;
    let mapped = model.map_clip(&clip, &defaults)?;
    let unlike = mapped.distance.iter().filter(|distance| **distance > 1.0).count();
    println!("{} frames mapped, {unlike} of them unlike what was learned", mapped.coords.rows());

    // One point for each frame of the clip; the model has fewer rows per second.
    let timing = Options::new().fps(clip.fps().unwrap_or_default());
    let made = model.unmap_clip(&mapped.coords, None, &timing)?;
    made.clip.save(poses)?;
    println!("{} poses written", made.clip.frames());
    Ok(())
}
