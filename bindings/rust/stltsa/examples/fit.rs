// SPDX-License-Identifier: BSD-3-Clause
//! Fits your own numbers: one row per frame instead of a clip file. The frames follow a circle,
//! bent into six dimensions, three times. Also shows options, progress and cancelling.
//!
//!     cargo run --example fit

use std::ops::ControlFlow::{Break, Continue};

use stltsa::{ErrorKind, Fact, Model, Options};

const PERIOD: usize = 100;

fn frame(t: usize) -> [f64; 6] {
    let (y, x) = (std::f64::consts::TAU * t as f64 / PERIOD as f64).sin_cos();
    [x, y, 0.3 * x * y, 0.2 * x * x, 0.5 * x + y, 0.1 * y * y]
}

fn main() -> Result<(), stltsa::Error> {
    let frames: Vec<[f64; 6]> = (0..3 * PERIOD).map(frame).collect();
    // 1.2 periods: with fewer, the first coordinate only follows time.
    let options = Options::new().dimension(2).neighbors(PERIOD * 6 / 5);
    let model = Model::fit(&frames, &options)?;

    let coords = model.coords();
    println!("{} frames, {} neighbors", coords.rows(), model.info().int(Fact::Neighbors)?);
    for t in (0..frames.len()).step_by(PERIOD / 4) {
        println!("frame {t:3}  {:8.5}  {:8.5}", coords[(t, 0)], coords[(t, 1)]);
    }

    // The same fit, cancelled at the second report.
    let mut reports = 0;
    let impatient = options.progress(move |_stage, _fraction| {
        reports += 1;
        if reports < 2 {
            Continue(())
        } else {
            Break(())
        }
    });
    match Model::fit(&frames, &impatient) {
        Err(error) if error.kind() == ErrorKind::Cancelled => println!("cancelled, as asked"),
        other => return other.map(drop),
    }
    Ok(())
}
