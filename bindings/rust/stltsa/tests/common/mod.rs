// SPDX-License-Identifier: BSD-3-Clause
//! Helpers shared by several tests; each uses some of them.
#![allow(dead_code)]

use std::path::PathBuf;

use stltsa::{Clip, Matrix, Model, Options};

/// Frames per turn of [`circle`].
pub const PERIOD: usize = 100;

/// Three turns of a circle, bent into four dimensions and drifting, so that no frame repeats.
pub fn circle() -> Vec<[f64; 4]> {
    let bent = |t: usize| {
        let a = std::f64::consts::TAU * t as f64 / PERIOD as f64;
        [a.cos(), a.sin(), 0.3 * (2.0 * a).sin(), 0.2 * a.cos() * a.cos() + 1e-3 * t as f64]
    };
    (0..3 * PERIOD).map(bent).collect()
}

pub fn circle_options() -> Options {
    Options::new().neighbors(PERIOD * 6 / 5).dimension(2)
}

pub fn circle_model() -> Model {
    Model::fit(&circle(), &circle_options()).expect("the circle is fitted")
}

pub fn bits(numbers: &[f64]) -> Vec<u64> {
    numbers.iter().map(|number| number.to_bits()).collect()
}

pub fn same_bits(a: &Matrix, b: &Matrix) -> bool {
    (a.rows(), a.cols()) == (b.rows(), b.cols()) && bits(a.as_slice()) == bits(b.as_slice())
}

/// A clip of the synthetic walker, for tests that are ignored without it.
pub fn walker_path() -> PathBuf {
    std::env::var_os("STLTSA_TEST_CLIP").expect("STLTSA_TEST_CLIP names a clip").into()
}

pub fn walker() -> Clip {
    Clip::open(walker_path()).expect("the walker's clip is read")
}

/// A file of this test run.
pub fn scratch(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name)
}

/// The text after the first `"key":` of a JSON text.
pub fn after<'a>(json: &'a str, key: &str) -> &'a str {
    let name = format!("\"{key}\":");
    &json[json.find(&name).unwrap_or_else(|| panic!("no {key} in {json}")) + name.len()..]
}

/// The first number, word or text of that key.
pub fn value<'a>(json: &'a str, key: &str) -> &'a str {
    after(json, key).split(&[',', '}', ']'][..]).next().expect("a value").trim_matches('"')
}
