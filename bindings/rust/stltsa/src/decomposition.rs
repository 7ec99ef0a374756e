// SPDX-License-Identifier: BSD-3-Clause
//! [`Decomposition`]: motion units and cycles of a clip (section 3.1 of the paper).

use std::ops::Range;
use std::path::Path;

use stltsa_sys as sys;

use crate::array::Matrix;
use crate::clip::Clip;
use crate::error::{c_name, c_path, check, count, owned_text, text, texts, Result};
use crate::facts::Facts;
use crate::handle::Owned;
use crate::kinds::{Fact, Features, SegmentKind, UnitKind};
use crate::options::Options;
use crate::parts::{number, positive, Part, PartKind, Quantity, Segment, Statistics, Summary};
use crate::sides::Side;

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
    /// k of the fit, in samples of 24 per cycle; 0 if nothing is cyclic.
    pub neighbors: usize,
    /// w of the fit, in samples of 24 per cycle; 0 if nothing is cyclic.
    pub window: usize,
    /// Tangent dimension of the fit; 0 if nothing is cyclic.
    pub dimension: usize,
    /// Coordinate of the fit whose margins count, from 1; `None`: none.
    pub coordinate: Option<usize>,
    /// Features of the fit.
    pub features: Features,
    /// Period in seconds; `None` if there is none.
    pub period: Option<f64>,
    /// How well that coordinate repeats once per period; 1: perfect.
    pub cyclicity: f64,
    /// Match of the velocities one period apart; 1: perfect.
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
        let (mut share, mut margin) = (f64::NAN, f64::NAN);
        // SAFETY: a live handle; structs of numbers and numbers, which the calls fill.
        let (raw, reason, steps_reason, carried_by) = unsafe {
            check(sys::stltsa_decomposition_segment(self.raw(), index, raw.as_mut_ptr()))?;
            check(sys::stltsa_decomposition_first_step(
                self.raw(),
                index,
                &mut share,
                &mut margin,
            ))?;
            let carriers = sys::stltsa_decomposition_carrier_count(self.raw(), index);
            (
                raw.assume_init(),
                text(sys::stltsa_decomposition_segment_reason(self.raw(), index)),
                text(sys::stltsa_decomposition_steps_reason(self.raw(), index)),
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
            first_step_share: number(share),
            first_step_margin: number(margin),
            steps_reason: Some(steps_reason).filter(|reason| !reason.is_empty()),
        })
    }

    fn parts(&self, kind: i32) -> Result<Vec<Part>> {
        // SAFETY: a live handle.
        let count = unsafe { sys::stltsa_decomposition_part_count(self.raw(), kind) };
        let part = |index| {
            let mut part = std::mem::MaybeUninit::zeroed();
            let mut travel = std::mem::MaybeUninit::zeroed();
            // SAFETY: a live handle; structs of numbers, which the calls fill.
            unsafe {
                let handle = self.raw();
                check(sys::stltsa_decomposition_part(handle, kind, index, part.as_mut_ptr()))?;
                check(sys::stltsa_decomposition_travel(handle, kind, index, travel.as_mut_ptr()))?;
                let part = part.assume_init();
                let side = sys::stltsa_decomposition_side(handle, part.side);
                Part::of(part, Side::from_raw(side), travel.assume_init())
            }
        };
        (0..count).map(part).collect()
    }

    /// Segment, side, likeness, confidence and travel of each cycle.
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

    /// Of a quantity of the parts of one kind and label, see [`Segment::label`], and of one side,
    /// 0 or 1, or of both. `None` if there is no such part of which the quantity is known.
    ///
    /// # Errors
    /// `side` is neither 0 nor 1.
    pub fn statistics(
        &self,
        kind: PartKind,
        label: usize,
        side: Option<usize>,
        quantity: Quantity,
    ) -> Result<Option<Statistics>> {
        let kind = match kind {
            PartKind::Cycle => sys::STLTSA_PART_CYCLE,
            PartKind::Step => sys::STLTSA_PART_STEP,
            PartKind::Repetition => sys::STLTSA_PART_REPETITION,
        };
        let quantity = match quantity {
            Quantity::Time => sys::STLTSA_QUANTITY_TIME,
            Quantity::Way => sys::STLTSA_QUANTITY_WAY,
            Quantity::Stride => sys::STLTSA_QUANTITY_STRIDE,
            Quantity::Speed => sys::STLTSA_QUANTITY_SPEED,
            Quantity::Turn => sys::STLTSA_QUANTITY_TURN,
        };
        let label = i32::try_from(label).unwrap_or(i32::MAX);
        let side = side.map_or(-1, |side| i32::try_from(side).unwrap_or(i32::MAX));
        let mut raw = std::mem::MaybeUninit::<sys::stltsa_statistics>::zeroed();
        // SAFETY: a live handle; a struct of numbers, which the call fills.
        let raw = unsafe {
            check(sys::stltsa_decomposition_statistics(
                self.raw(),
                kind,
                label,
                side,
                quantity,
                raw.as_mut_ptr(),
            ))?;
            raw.assume_init()
        };
        if raw.count == 0 {
            return Ok(None);
        }
        Ok(Some(Statistics {
            count: count(raw.count)?,
            mean: raw.mean,
            sd: raw.sd,
            cv: number(raw.cv),
            trend: number(raw.trend),
        }))
    }

    /// How similar the segments of two labels are, 0 to 1: the mean over pairs of their segments.
    /// Moderate differences in size and tempo change it little. `None` if `label` is `other` and
    /// only one segment has it.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) if a label is out of range.
    pub fn label_likeness(&self, label: usize, other: usize) -> Result<Option<f64>> {
        let of = |label| i32::try_from(label).unwrap_or(-1);
        let mut likeness = f64::NAN;
        // SAFETY: a live handle; a number, which the call sets.
        check(unsafe {
            sys::stltsa_decomposition_label_likeness(
                self.raw(),
                of(label),
                of(other),
                &mut likeness,
            )
        })?;
        Ok(number(likeness))
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

    /// The smoothed coordinate whose margins count, sample by sample; 0 outside cyclic segments.
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

    /// The curve and a coordinate a quarter of a cycle behind: samples x 2.
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn coords(&self) -> Result<Matrix> {
        Matrix::filled(self.info.samples, 2, |out| {
            // SAFETY: a live handle, an array of the size it says.
            unsafe { sys::stltsa_decomposition_coords(self.raw(), out) }
        })
    }

    /// The two coordinates of the loop (Fig. 1 of the paper): samples x 2. Each cyclic segment has
    /// coordinates of its own, so the loops of two segments cannot share axes.
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

    /// Writes a report of the clip that was decomposed with these options: one HTML page that a
    /// browser shows without a network. `command`: the command or call that makes it again.
    ///
    /// # Errors
    /// [`Io`](crate::ErrorKind::Io), [`Argument`](crate::ErrorKind::Argument) if the decomposition
    /// is of another clip, or `command` contains a NUL.
    pub fn report(
        &self,
        clip: &Clip,
        path: impl AsRef<Path>,
        command: Option<&str>,
        options: &Options,
    ) -> Result<()> {
        let path = c_path(path.as_ref())?;
        let command = command.map(c_name).transpose()?;
        let text = command.as_ref().map_or(std::ptr::null(), |text| text.as_ptr());
        options.call(|options| {
            // SAFETY: live handles, and strings that live through the call.
            check(unsafe {
                sys::stltsa_report_save(clip.raw(), self.raw(), options, text, path.as_ptr())
            })
        })
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
        let of_fit = |key| facts.ints(key)?.first().map_or(Ok(0), |value| count(*value));
        let real = |key| facts.real(key, 0);
        let features = int(Fact::Features)? as i32;
        let coordinate = int(Fact::Coordinate)?;
        let period = real(Fact::Period)?;
        Ok(Self {
            samples: int(Fact::Rows)?,
            first_frame: int(Fact::FirstFrame)?,
            frame_step: int(Fact::FrameStep)?,
            neighbors: of_fit(Fact::Neighbors)?,
            window: of_fit(Fact::Window)?,
            dimension: of_fit(Fact::Dimension)?,
            coordinate: Some(coordinate).filter(|column| *column > 0),
            features: Features::from_raw(features),
            period: Some(period).filter(|period| *period != 0.0),
            cyclicity: real(Fact::Cyclicity)?,
            lag_quality: real(Fact::LagQuality)?,
            fps: real(Fact::Fps)?,
        })
    }
}
