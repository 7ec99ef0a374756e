// SPDX-License-Identifier: BSD-3-Clause
//! [`Decomposition`]: motion units and cycles of a clip (section 3.1 of the paper).

use std::ops::Range;

use stltsa_sys as sys;

use crate::array::Matrix;
use crate::clip::Clip;
use crate::error::{check, count, owned_text, text, texts, Result};
use crate::facts::Facts;
use crate::handle::Owned;
use crate::kinds::{Fact, Features, UnitKind};
use crate::options::Options;

/// Motion units and cycles of a clip, and the curve from which they were cut. Made by
/// [`Clip::decompose`].
#[derive(Debug)]
pub struct Decomposition {
    pub(crate) handle: Owned<sys::stltsa_decomposition>,
    units: Vec<Interval>,
    cycles: Vec<Interval>,
    info: DecompositionInfo,
}

/// A unit or a cycle: half-open, in frames of the source and in seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Kind of unit.
    pub kind: UnitKind,
    /// First frame, rounded.
    pub begin: usize,
    /// The frame after the last one, rounded.
    pub end: usize,
    /// Begin in seconds, fractions of a frame kept.
    pub begin_s: f64,
    /// End in seconds, fractions of a frame kept.
    pub end_s: f64,
}

impl Interval {
    /// `begin..end`, as [`Piece::new`](crate::Piece::new) takes it.
    pub fn frames(&self) -> Range<usize> {
        self.begin..self.end
    }

    fn of(raw: sys::stltsa_interval) -> Result<Self> {
        Ok(Self {
            kind: UnitKind::from_raw(raw.kind),
            begin: count(raw.begin)?,
            end: count(raw.end)?,
            begin_s: raw.begin_s,
            end_s: raw.end_s,
        })
    }
}

/// Parameters and quality of a decomposition.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct DecompositionInfo {
    /// Working samples: rows of curve and loop.
    pub samples: usize,
    /// Sample i is frame `first_frame + i * frame_step`.
    pub first_frame: usize,
    /// See `first_frame`.
    pub frame_step: usize,
    /// k, in samples.
    pub neighbors: usize,
    /// w, in samples.
    pub window: usize,
    /// Tangent dimension.
    pub dimension: usize,
    /// Column from which units were cut, counted from 1; `None`: none.
    pub coordinate: Option<usize>,
    /// Features of the fit.
    pub features: Features,
    /// Period in seconds; `None` if there is none.
    pub period: Option<f64>,
    /// How well that coordinate repeats once per period; 1: perfect.
    pub cyclicity: f64,
    /// How well the clip repeats after one period; 1: perfect.
    pub lag_quality: f64,
    /// Working samples per second.
    pub fps: f64,
}

impl Decomposition {
    pub(crate) fn new(clip: &Clip, options: &Options) -> Result<Self> {
        let handle = options.call(|options| {
            // SAFETY: live handles.
            Owned::make(|out| unsafe { sys::stltsa_decompose(clip.raw(), options, out) })
        })?;
        Ok(Self {
            units: units(&handle)?,
            cycles: cycles(&handle)?,
            info: DecompositionInfo::of(&handle)?,
            handle,
        })
    }

    /// Units in temporal order; they cover the clip without gap or overlap.
    pub fn units(&self) -> &[Interval] {
        &self.units
    }

    /// Cycles in temporal order, back to back.
    pub fn cycles(&self) -> &[Interval] {
        &self.cycles
    }

    /// The paper's choice of a cycle (the first to third candidate).
    pub fn representative(&self) -> Option<&Interval> {
        self.cycle_of(Fact::Representative)
    }

    /// The cycle that is most similar to the others.
    pub fn best(&self) -> Option<&Interval> {
        self.cycle_of(Fact::Best)
    }

    /// Parameters and quality of the decomposition.
    pub fn info(&self) -> &DecompositionInfo {
        &self.info
    }

    /// The smoothed coordinate from which units were cut, sample by sample.
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn curve(&self) -> Result<Vec<f64>> {
        let curve = Matrix::filled(self.info.samples, 1, |out| {
            // SAFETY: a live handle, an array of the size it says.
            unsafe { sys::stltsa_decomposition_curve(self.raw(), out) }
        })?;
        Ok(curve.into_vec())
    }

    /// All coordinates of the fit that was cut, not smoothed: samples x
    /// [`dimension`](DecompositionInfo::dimension).
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn coords(&self) -> Result<Matrix> {
        Matrix::filled(self.info.samples, self.info.dimension, |out| {
            // SAFETY: a live handle, an array of the size it says.
            unsafe { sys::stltsa_decomposition_coords(self.raw(), out) }
        })
    }

    /// The two coordinates of the loop (Fig. 1 of the paper): samples x 2.
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn loop_coords(&self) -> Result<Matrix> {
        Matrix::filled(self.info.samples, 2, |out| {
            // SAFETY: a live handle, an array of the size it says.
            unsafe { sys::stltsa_decomposition_loop(self.raw(), out) }
        })
    }

    /// Why there are no cycles, with the numbers; `None` if there are cycles.
    pub fn reason(&self) -> Option<String> {
        // SAFETY: a live handle, to which the text belongs until it is copied.
        let reason = unsafe { text(sys::stltsa_decomposition_reason(self.raw())) };
        Some(reason).filter(|reason| !reason.is_empty())
    }

    /// Warnings about the result.
    pub fn warnings(&self) -> Vec<String> {
        // SAFETY: a live handle, to which the texts belong until they are copied.
        unsafe {
            let count = sys::stltsa_decomposition_warning_count(self.raw());
            texts(count, |index| sys::stltsa_decomposition_warning(self.raw(), index))
        }
    }

    /// One JSON object (schema: stltsa-decomposition/1).
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn json(&self) -> Result<String> {
        // SAFETY: a live handle.
        owned_text(|out| unsafe { sys::stltsa_decomposition_json(self.raw(), out) })
    }

    fn cycle_of(&self, key: Fact) -> Option<&Interval> {
        let index = self.facts().int(key, 0).ok()?;
        self.cycles.get(usize::try_from(index).ok()?)
    }

    fn raw(&self) -> *const sys::stltsa_decomposition {
        self.handle.raw()
    }
}

fn units(handle: &Owned<sys::stltsa_decomposition>) -> Result<Vec<Interval>> {
    // SAFETY: a live handle.
    unsafe {
        let count = sys::stltsa_decomposition_unit_count(handle.raw());
        intervals(count, |index, out| sys::stltsa_decomposition_unit(handle.raw(), index, out))
    }
}

fn cycles(handle: &Owned<sys::stltsa_decomposition>) -> Result<Vec<Interval>> {
    // SAFETY: a live handle.
    unsafe {
        let count = sys::stltsa_decomposition_cycle_count(handle.raw());
        intervals(count, |index, out| sys::stltsa_decomposition_cycle(handle.raw(), index, out))
    }
}

fn intervals(
    count: i64,
    get: impl Fn(i64, &mut sys::stltsa_interval) -> sys::stltsa_status,
) -> Result<Vec<Interval>> {
    let mut raw =
        sys::stltsa_interval { begin: 0, end: 0, begin_s: 0.0, end_s: 0.0, kind: 0, reserved: 0 };
    let interval = |index| {
        check(get(index, &mut raw))?;
        Interval::of(raw)
    };
    (0..count).map(interval).collect()
}

impl DecompositionInfo {
    fn of(handle: &Owned<sys::stltsa_decomposition>) -> Result<Self> {
        // SAFETY: a live handle.
        let facts = unsafe { Facts::new(sys::stltsa_decomposition_info(handle.raw())) };
        let int = |key| count(facts.int(key, 0)?);
        let real = |key| facts.real(key, 0);
        let features = int(Fact::Features)? as i32;
        let coordinate = int(Fact::Coordinate)?;
        let period = real(Fact::Period)?;
        Ok(Self {
            samples: int(Fact::Rows)?,
            first_frame: int(Fact::FirstFrame)?,
            frame_step: int(Fact::FrameStep)?,
            neighbors: int(Fact::Neighbors)?,
            window: int(Fact::Window)?,
            dimension: int(Fact::Dimension)?,
            coordinate: Some(coordinate).filter(|column| *column > 0),
            features: Features::from_raw(features),
            period: Some(period).filter(|period| *period != 0.0),
            cyclicity: real(Fact::Cyclicity)?,
            lag_quality: real(Fact::LagQuality)?,
            fps: real(Fact::Fps)?,
        })
    }
}
