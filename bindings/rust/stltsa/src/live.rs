// SPDX-License-Identifier: BSD-3-Clause
//! [`Live`]: the phase of a stream, frame by frame.

use stltsa_sys as sys;

use crate::array::View;
use crate::clip::{Clip, Rotations};
use crate::error::{c_count, c_name, check, Result};
use crate::handle::Owned;
use crate::kinds::{Fact, SegmentKind};
use crate::model::Model;
use crate::options::Options;
use crate::phase::Phase;

impl Model {
    /// Keeps the mean cycle of the clip's motion that has the most frames in cycles, for [`Live`].
    /// Model files keep it. Marks that were kept before are forgotten. Option used: progress.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) if there are no cycles, or they are too short for the
    /// filter to settle; [`Shape`](crate::ErrorKind::Shape) if the features are not those of the model;
    /// [`Degenerate`](crate::ErrorKind::Degenerate) if all columns only drift.
    pub fn keep_cycle(&mut self, phase: &Phase, options: &Options) -> Result<()> {
        let model = self.handle.raw_mut();
        options.call(|options| {
            // SAFETY: live handles; the model is not shared.
            check(unsafe { sys::stltsa_model_keep_cycle(model, phase.raw(), options) })
        })
    }

    /// Names the phase of a frame, which need not be whole, in those cycles; a stream reports it as
    /// it passes. At most 62.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) if the frame lies in no cycle of that motion, or the name
    /// is empty.
    pub fn keep_mark(&mut self, phase: &Phase, frame: f64, name: &str) -> Result<()> {
        let name = c_name(name)?;
        // SAFETY: live handles; the model is not shared; a text that ends with zero.
        check(unsafe {
            sys::stltsa_model_keep_mark(self.handle.raw_mut(), phase.raw(), frame, name.as_ptr())
        })
    }

    /// Whether the model keeps a mean cycle.
    pub fn has_cycle(&self) -> bool {
        self.info().int(Fact::HasCycle) == Ok(1)
    }
}

/// What a frame of a stream is.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct LiveFrame {
    /// Of the clip that was kept, in [0, 1).
    pub phase: f64,
    /// Turns a second.
    pub rate_hz: f64,
    /// Turns since the first frame, not rounded.
    pub cycles: f64,
    /// From the mean cycle; above 1 it is another motion; NaN for a missing frame.
    pub distance: f64,
    /// 0 to 1: how sharply the phase is known; falls while frames are missing.
    pub confidence: f64,
    /// False: another motion, for 0.1 s at least, or a frame that is missing.
    pub known: bool,
    /// Cyclic, action (not known) or rest (the body is still).
    pub kind: SegmentKind,
    /// Indexes of the marks, see [`Live::marks`], that were passed since the frame before.
    passed: i64,
}

impl LiveFrame {
    /// Whether this mark was passed since the frame before, by its index in [`Live::marks`].
    pub fn passed(&self, mark: usize) -> bool {
        mark < 63 && self.passed >> mark & 1 == 1
    }
}

/// Follows one stream of frames with a model that keeps a mean cycle. Push one frame after another,
/// each in the form in which it comes. Pushing frames allocates no memory and has no delay; no
/// answer depends on later frames.
///
/// ```no_run
/// use stltsa::{Clip, Live, Model, Options, Phase};
///
/// let walk = Clip::open("walk.bvh")?;
/// let options = Options::new();
/// let phase = Phase::find(&walk.decompose(&options)?, &options)?;
/// let mut model = Model::fit_clip(&walk, &options)?;
/// model.keep_cycle(&phase, &options)?;
/// let mut live = Live::new(&model)?;
/// for index in 0..walk.frames() {
///     let now = live.push_frame(index as f64 / walk.fps().unwrap(), &walk, index)?;
///     println!("{:.2} {:.2} Hz", now.phase, now.rate_hz);
/// }
/// # Ok::<(), stltsa::Error>(())
/// ```
#[derive(Debug)]
pub struct Live {
    pub(crate) handle: Owned<sys::stltsa_live>,
}

impl Live {
    /// Starts a stream. It does not refer to the model.
    ///
    /// # Errors
    /// [`Unsupported`](crate::ErrorKind::Unsupported) if the model keeps no mean cycle.
    pub fn new(model: &Model) -> Result<Self> {
        // SAFETY: a live handle.
        let make = |out| unsafe { sys::stltsa_live_new(model.raw(), out) };
        Ok(Self { handle: Owned::make(make)? })
    }

    /// Names of the model's marks, in the order in which they were kept.
    pub fn marks(&self) -> Vec<String> {
        self.info().texts(Fact::Mark).unwrap_or_default()
    }

    /// Takes the next frame as features: with a skeleton a row of
    /// [`Clip::features`](crate::Clip::features); otherwise the numbers of the columns of the file,
    /// NaN if one is lost.
    ///
    /// `seconds` rises from call to call. Frames may be dropped. If a frame has the time of the
    /// one before, or one up to 0.25 s earlier, it is left out. If the time falls by more, or
    /// after more than a second without frames, the filter starts anew and settles within 0.15 s,
    /// in which no mark is passed.
    /// If too little is known of a frame, it is missing: the phase goes on as before, less and
    /// less surely.
    ///
    /// # Errors
    /// [`Shape`](crate::ErrorKind::Shape), [`Argument`](crate::ErrorKind::Argument) if `seconds` is not finite.
    pub fn push(&mut self, seconds: f64, features: &[f64]) -> Result<LiveFrame> {
        let input = View::new(features, 1, features.len())?.raw()?;
        // SAFETY: a live handle that is not shared, an array of the size it says.
        self.answer(|live, frame| unsafe { sys::stltsa_live_push(live, seconds, &input, frame) })
    }

    /// Takes the next frame as points, points x 2 or 3 in the order and the unit of the model's
    /// clip; a point is lost if it is NaN, or if all of its coordinates are 0. `confidence`: one
    /// number for each point, 0: lost; empty: all are seen. Where the body is and which way it
    /// faces does not count.
    ///
    /// # Errors
    /// As [`push`](Self::push); [`Unsupported`](crate::ErrorKind::Unsupported): the model is of a clip
    /// without points.
    pub fn push_points(
        &mut self,
        seconds: f64,
        points: View<'_>,
        confidence: &[f64],
    ) -> Result<LiveFrame> {
        let input = points.raw()?;
        let sure = View::new(confidence, confidence.len(), 1)?.raw()?;
        let sure: *const _ = if confidence.is_empty() { std::ptr::null() } else { &sure };
        // SAFETY: a live handle that is not shared, arrays of the size they say or NULL.
        self.answer(|live, frame| unsafe {
            sys::stltsa_live_push_points(live, seconds, &input, sure, frame)
        })
    }

    /// Takes the next frame as local rotations of the joints of the model's skeleton: joints x 4 or
    /// 9, or 1 x channels. `root`: its position, which counts only if a joint above the body's root
    /// moves.
    ///
    /// # Errors
    /// As [`push`](Self::push); [`Argument`](crate::ErrorKind::Argument): the numbers are no rotation;
    /// [`Unsupported`](crate::ErrorKind::Unsupported): the model is of a clip without a skeleton, or its
    /// features are numbers of the file.
    pub fn push_pose(
        &mut self,
        seconds: f64,
        rotations: Rotations<'_>,
        root: Option<[f64; 3]>,
    ) -> Result<LiveFrame> {
        let (form, rows) = rotations.parts();
        let input = rows.raw()?;
        let place = root.unwrap_or_default();
        let place = View::new(&place, 1, 3)?.raw()?;
        let place: *const _ = if root.is_some() { &place } else { std::ptr::null() };
        // SAFETY: a live handle that is not shared, arrays of the size they say or NULL.
        self.answer(|live, frame| unsafe {
            sys::stltsa_live_push_pose(live, seconds, form, &input, place, frame)
        })
    }

    /// Takes a frame of a clip with the joints or columns of the model's clip; its other frames are
    /// not looked at.
    ///
    /// # Errors
    /// As [`push`](Self::push).
    pub fn push_frame(&mut self, seconds: f64, clip: &Clip, index: usize) -> Result<LiveFrame> {
        let index = c_count(index)?;
        // SAFETY: live handles; the stream is not shared.
        self.answer(|live, frame| unsafe {
            sys::stltsa_live_push_frame(live, seconds, clip.raw(), index, frame)
        })
    }

    fn answer<F>(&mut self, push: F) -> Result<LiveFrame>
    where
        F: FnOnce(*mut sys::stltsa_live, *mut sys::stltsa_live_frame) -> sys::stltsa_status,
    {
        // SAFETY: a struct of numbers, for which zeros are valid.
        let mut raw: sys::stltsa_live_frame = unsafe { std::mem::zeroed() };
        raw.size = std::mem::size_of::<sys::stltsa_live_frame>();
        check(push(self.handle.raw_mut(), &mut raw))?;
        Ok(LiveFrame {
            phase: raw.phase,
            rate_hz: raw.rate_hz,
            cycles: raw.cycles,
            distance: raw.distance,
            confidence: raw.confidence,
            known: raw.known == 1,
            kind: i64::from(raw.kind).into(),
            passed: raw.passed,
        })
    }
}
