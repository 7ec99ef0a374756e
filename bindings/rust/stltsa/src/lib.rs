// SPDX-License-Identifier: BSD-3-Clause
//! libstltsa for Rust: motion-capture clips as low-dimensional curves, motion units and cycles.
//!
//! The method is spatio-temporal local tangent space alignment: H. Li, J. Niu, L. Zhang, B. Hu,
//! *Spatio-temporal LTSA and Its Application to Motion Decomposition*, ICONIP 2012; "section" and
//! "equation" in these pages are that paper's.
//!
//! ```no_run
//! use stltsa::{Clip, Options};
//!
//! let units = Clip::open("walk.bvh")?.decompose(&Options::new())?;
//! for unit in units.units() {
//!     println!("{} {:.2} s .. {:.2} s", unit.kind, unit.begin_s, unit.end_s);
//! }
//! # Ok::<(), stltsa::Error>(())
//! ```
//!
//! * [`Clip`]: reads and writes clips, forward kinematics, features.
//! * [`Clip::decompose`]: motion units and cycles ([`Decomposition`]).
//! * [`Model`]: the curve itself, from clips or from your own matrix; [maps](Model::map) new frames
//!   onto it and [coordinates back](Model::unmap_clip) to poses; can be saved to files. Option
//!   `intrinsic` also estimates the dimension of the motion.
//! * [`Denoising`]: a curve without its noise.
//! * [`Phase`]: a phase for every frame, and signals on 0 to 100 % of each cycle ([`Cycles`]).
//! * [`Comparison`]: the cycles of two clips, or left and right of one, aligned by phase.
//! * [`Synthesis`]: new motion from pieces of clips.
//! * [`Batch`]: many clips, decomposed into files of a folder.
//! * [`Info`]: everything that a clip or a result says, by key.
//! * [`Options`]: deviations from the defaults, progress and cancelling.
//!
//! # Conventions
//!
//! Frames are rows and are counted from 0 in the source file. Intervals are half-open. Lengths are
//! in the file's unit, seconds are frame / fps, rotations are quaternions w x y z. Arguments are
//! [`View`]s, made from slices of arrays (`f32`, `f64`, any strides) or, with the feature
//! `ndarray`, from its arrays; results are [`Matrix`].
//!
//! Same input, options and build give the same bits on every run, for any number of threads.
//!
//! All types are `Send` and `Sync`: results do not change, and any number of threads may read them
//! at once. While a fit runs, OpenBLAS is set to one thread for the whole process.
//!
//! Errors are [`Error`], with the library's text. The library prints nothing and never ends the
//! process; a panic in a progress closure continues in the caller.
//!
//! # Features
//!
//! * `ndarray`: arguments and results as arrays of the crate ndarray (0.15 to 0.17).
//! * `static`: links `libstltsa.a`; see the crate `stltsa-sys`.
#![warn(missing_docs, unsafe_op_in_unsafe_fn)]

mod array;
mod batch;
mod clip;
mod comparison;
mod decomposition;
mod denoising;
mod error;
mod events;
mod handle;
mod info;
mod kinds;
mod live;
mod mapping;
mod model;
mod options;
mod phase;
mod progress;
mod rows;
mod sides;
mod synthesis;
#[cfg(feature = "ndarray")]
mod with_ndarray;

pub use array::{Element, Matrix, View};
pub use batch::{Batch, BatchRow};
pub use clip::{Clip, Points, Rotations};
pub use comparison::Comparison;
pub use decomposition::Decomposition;
pub use denoising::Denoising;
pub use error::{Error, ErrorKind, Result};
pub use events::Events;
pub use info::Info;
pub use kinds::{
    Axis, BuildPart, Fact, Features, Format, Gaps, Mode, OptionKey, Quantity, SegmentKind, Stage,
    UnitKind, WarningKind,
};
pub use live::{Live, LiveFrame};
pub use mapping::{Hints, Mapped, Poses, Unmapped};
pub use model::Model;
pub use options::{options_table, OptionInfo, Options};
pub use phase::{Cycles, Phase};
pub use rows::*;
pub use sides::Side;
pub use synthesis::{Piece, Synthesis};

/// Tests the README's programs together with the documentation.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

/// The version of the library at run time, such as "0.1.0".
pub fn version() -> String {
    // SAFETY: a static text.
    unsafe { error::text(stltsa_sys::stltsa_version()) }
}

/// Whether this build of the library has an optional part.
///
/// ```
/// let has_cholmod = stltsa::has(stltsa::BuildPart::Cholmod);
/// # let _ = has_cholmod;
/// ```
pub fn has(part: BuildPart) -> bool {
    // SAFETY: it takes any number.
    unsafe { stltsa_sys::stltsa_has(part.raw()) != 0 }
}
