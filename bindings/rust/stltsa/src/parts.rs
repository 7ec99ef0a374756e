// SPDX-License-Identifier: BSD-3-Clause
//! The rows of a decomposition: segments, parts, and what is known of them together.

use stltsa_sys as sys;

use crate::error::{count, Result};
use crate::kinds::SegmentKind;
use crate::sides::Side;

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
    /// Share of a cycle that its first step takes; `None`: there are no steps.
    pub first_step_share: Option<f64>,
    /// The 95 % interval of that share reaches so far to each side.
    pub first_step_margin: Option<f64>,
    /// Why cycles have no steps.
    pub steps_reason: Option<String>,
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
    /// That side, if the names of joints or points state it.
    pub side_name: Option<Side>,
    /// To the mean cycle of its segment, or to the other repetitions, 0 to 1.
    pub likeness: Option<f64>,
    /// Share of such answers that are right, 0 to 1.
    pub confidence: f64,
    /// How the body travels over the ground; `None` if that is unknown, as in a matrix.
    pub travel: Option<Travel>,
}

/// How the body travels over the ground during a part; lengths in the unit of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Travel {
    /// Length of the path of the body root, or of the mean of the points.
    pub way: f64,
    /// Distance between the ends of the path.
    pub stride: f64,
    /// `way` a second.
    pub speed: f64,
    /// Degrees, counterclockwise as seen from above.
    pub turn: Option<f64>,
}

/// What [`crate::Decomposition::statistics`] is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Quantity {
    /// Length in seconds.
    Time,
    /// See [`Travel::way`].
    Way,
    /// See [`Travel::stride`].
    Stride,
    /// See [`Travel::speed`].
    Speed,
    /// See [`Travel::turn`].
    Turn,
}

/// A kind of [`Part`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PartKind {
    /// See [`crate::Decomposition::cycle_facts`].
    Cycle,
    /// See [`crate::Decomposition::steps`].
    Step,
    /// See [`crate::Decomposition::repetitions`].
    Repetition,
}

/// Of one quantity of several parts.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Statistics {
    /// Number of parts.
    pub count: usize,
    /// Mean.
    pub mean: f64,
    /// Standard deviation; 0 for a single part.
    pub sd: f64,
    /// `sd / mean`; `None` of turns.
    pub cv: Option<f64>,
    /// Relative change per minute; `None` of turns.
    pub trend: Option<f64>,
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

pub(crate) fn positive(value: f64) -> Option<f64> {
    Some(value).filter(|value| *value > 0.0)
}

pub(crate) fn number(value: f64) -> Option<f64> {
    Some(value).filter(|value| value.is_finite())
}

impl Part {
    pub(crate) fn of(
        raw: sys::stltsa_part,
        side_name: Option<Side>,
        travel: sys::stltsa_travel,
    ) -> Result<Self> {
        Ok(Self {
            segment: count(raw.segment)?,
            cycle: usize::try_from(raw.parent).ok(),
            begin: count(raw.begin)?,
            end: count(raw.end)?,
            begin_s: raw.begin_s,
            end_s: raw.end_s,
            side: usize::try_from(raw.side).ok(),
            side_name,
            likeness: number(raw.likeness),
            confidence: raw.confidence,
            travel: number(travel.way).map(|way| Travel {
                way,
                stride: travel.stride,
                speed: travel.speed,
                turn: number(travel.turn),
            }),
        })
    }
}
