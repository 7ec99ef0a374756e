// SPDX-License-Identifier: BSD-3-Clause
//! [`Decomposition`]: motion units and cycles of a clip (section 3.1 of the paper).

use std::ops::Range;

use stltsa_sys as sys;

use crate::array::Matrix;
use crate::clip::Clip;
use crate::error::{check, count, owned_text, text, texts, Result};
use crate::facts::Facts;
use crate::handle::Owned;
use crate::kinds::{Fact, Features, SegmentKind, UnitKind};
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

/// A stretch of one behavior: half-open, in frames of the source and in seconds.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Segment {
    /// Kind of segment.
    pub kind: SegmentKind,
    /// 0, 1, ... in order of appearance: the same number is the same motion; `None`: a rest.
    pub label: Option<usize>,
    /// First frame, rounded.
    pub begin: usize,
    /// The frame after the last one, rounded.
    pub end: usize,
    /// Begin in seconds, fractions of a frame kept.
    pub begin_s: f64,
    /// End in seconds, fractions of a frame kept.
    pub end_s: f64,
    /// Cycles or repetitions.
    pub count: usize,
    /// Median length of the cycles in seconds.
    pub period: Option<f64>,
    /// A period that was seen, but is not claimed, in seconds.
    pub candidate_period: Option<f64>,
    /// Mean likeness to the others of its label, 0 to 1.
    pub likeness: Option<f64>,
    /// Share of such answers that are right, 0 to 1.
    pub confidence: f64,
    /// The same of the border at its begin; `None` for the first segment.
    pub begin_confidence: Option<f64>,
    /// Whether the clip begins within this motion.
    pub open_begin: bool,
    /// Whether the clip ends within this motion.
    pub open_end: bool,
    /// Joints, markers or columns that move most.
    pub carried_by: Vec<String>,
    /// Why there are no cycles, with the numbers.
    pub reason: Option<String>,
}

/// A cycle, a step or a repetition: half-open, in frames of the source and in seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Part {
    /// Index of its segment.
    pub segment: usize,
    /// Of a step the index of its cycle.
    pub cycle: Option<usize>,
    /// First frame, rounded.
    pub begin: usize,
    /// The frame after the last one, rounded.
    pub end: usize,
    /// Begin in seconds, fractions of a frame kept.
    pub begin_s: f64,
    /// End in seconds, fractions of a frame kept.
    pub end_s: f64,
    /// Which side of the body leads: 0 or 1, the same in all clips of a skeleton.
    pub side: Option<usize>,
    /// To the mean cycle of its segment, or to the other repetitions, 0 to 1.
    pub likeness: Option<f64>,
    /// Share of such answers that are right, 0 to 1.
    pub confidence: f64,
}

/// The cycles or repetitions of one label; seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Summary {
    /// See [`Segment::label`].
    pub label: usize,
    /// Cycles or repetitions.
    pub count: usize,
    /// Within the time from the first to the last of each segment.
    pub per_minute: f64,
    /// Mean length.
    pub mean: f64,
    /// Standard deviation of the lengths; 0 for a single one.
    pub sd: f64,
    /// `sd / mean`.
    pub cv: f64,
    /// Relative change of the length per minute.
    pub trend: f64,
}

fn positive(value: f64) -> Option<f64> {
    Some(value).filter(|value| *value > 0.0)
}

fn number(value: f64) -> Option<f64> {
    Some(value).filter(|value| value.is_finite())
}

impl Part {
    fn of(raw: sys::stltsa_part) -> Result<Self> {
        Ok(Self {
            segment: count(raw.segment)?,
            cycle: usize::try_from(raw.parent).ok(),
            begin: count(raw.begin)?,
            end: count(raw.end)?,
            begin_s: raw.begin_s,
            end_s: raw.end_s,
            side: usize::try_from(raw.side).ok(),
            likeness: number(raw.likeness),
            confidence: raw.confidence,
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

    /// Segments in temporal order; they cover the clip without gap or overlap.
    ///
    /// # Errors
    /// None in practice: the numbers of a live handle are valid.
    pub fn segments(&self) -> Result<Vec<Segment>> {
        // SAFETY: a live handle.
        let count = unsafe { sys::stltsa_decomposition_segment_count(self.raw()) };
        (0..count).map(|index| self.segment(index)).collect()
    }

    fn segment(&self, index: i64) -> Result<Segment> {
        let mut raw = std::mem::MaybeUninit::zeroed();
        // SAFETY: a live handle; a struct of numbers, which the call fills.
        let (raw, reason, carried_by) = unsafe {
            check(sys::stltsa_decomposition_segment(self.raw(), index, raw.as_mut_ptr()))?;
            let carriers = sys::stltsa_decomposition_carrier_count(self.raw(), index);
            (
                raw.assume_init(),
                text(sys::stltsa_decomposition_segment_reason(self.raw(), index)),
                texts(carriers, |i| sys::stltsa_decomposition_carrier(self.raw(), index, i)),
            )
        };
        Ok(Segment {
            kind: SegmentKind::from_raw(raw.kind),
            label: usize::try_from(raw.label).ok(),
            begin: count(raw.begin)?,
            end: count(raw.end)?,
            begin_s: raw.begin_s,
            end_s: raw.end_s,
            count: count(raw.count)?,
            period: positive(raw.period_s),
            candidate_period: positive(raw.candidate_period_s),
            likeness: number(raw.likeness),
            confidence: raw.confidence,
            begin_confidence: number(raw.begin_confidence),
            open_begin: raw.open_begin == 1,
            open_end: raw.open_end == 1,
            carried_by,
            reason: Some(reason).filter(|reason| !reason.is_empty()),
        })
    }

    fn parts(&self, kind: i32) -> Result<Vec<Part>> {
        // SAFETY: a live handle.
        let count = unsafe { sys::stltsa_decomposition_part_count(self.raw(), kind) };
        let part = |index| {
            let mut raw = std::mem::MaybeUninit::zeroed();
            // SAFETY: a live handle; a struct of numbers, which the call fills.
            Part::of(unsafe {
                check(sys::stltsa_decomposition_part(self.raw(), kind, index, raw.as_mut_ptr()))?;
                raw.assume_init()
            })
        };
        (0..count).map(part).collect()
    }

    /// Segment, side, likeness and confidence of each cycle.
    ///
    /// # Errors
    /// None in practice: the numbers of a live handle are valid.
    pub fn cycle_facts(&self) -> Result<Vec<Part>> {
        self.parts(sys::STLTSA_PART_CYCLE)
    }

    /// Halves of cycles in which both sides of the body alternate; none if they do not.
    ///
    /// # Errors
    /// None in practice: the numbers of a live handle are valid.
    pub fn steps(&self) -> Result<Vec<Part>> {
        self.parts(sys::STLTSA_PART_STEP)
    }

    /// The actions of the segments that repeat with pauses.
    ///
    /// # Errors
    /// None in practice: the numbers of a live handle are valid.
    pub fn repetitions(&self) -> Result<Vec<Part>> {
        self.parts(sys::STLTSA_PART_REPETITION)
    }

    /// How often and how fast, for each label that repeats.
    ///
    /// # Errors
    /// None in practice: the numbers of a live handle are valid.
    pub fn summary(&self) -> Result<Vec<Summary>> {
        // SAFETY: a live handle.
        let labels = unsafe { sys::stltsa_decomposition_summary_count(self.raw()) };
        let summary = |index| {
            let mut raw = std::mem::MaybeUninit::zeroed();
            // SAFETY: a live handle; a struct of numbers, which the call fills.
            let raw = unsafe {
                check(sys::stltsa_decomposition_summary(self.raw(), index, raw.as_mut_ptr()))?;
                raw.assume_init()
            };
            Ok(Summary {
                label: count(raw.label.into())?,
                count: count(raw.count)?,
                per_minute: raw.per_minute,
                mean: raw.mean_s,
                sd: raw.sd_s,
                cv: raw.cv,
                trend: raw.trend,
            })
        };
        (0..labels).map(summary).collect()
    }

    /// Units in temporal order; they cover the clip without gap or overlap.
    pub fn units(&self) -> &[Interval] {
        &self.units
    }

    /// Cycles in temporal order, back to back within a segment.
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

    /// Why nothing repeats, with the numbers; `None` if anything does.
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

    /// One JSON object (schema: stltsa-decomposition/2).
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

    pub(crate) fn raw(&self) -> *const sys::stltsa_decomposition {
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
        sys::stltsa_interval { begin: 0, end: 0, begin_s: 0.0, end_s: 0.0, kind: 0, segment: 0 };
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
