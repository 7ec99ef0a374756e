// SPDX-License-Identifier: BSD-3-Clause
//! [`Options`]: what a call is to do otherwise than by default.

use std::collections::BTreeMap;
use std::fmt;
use std::mem::size_of;
use std::ops::{ControlFlow, RangeInclusive};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use stltsa_sys as sys;

use crate::error::{c_path, check, text, Result};
use crate::handle::Owned;
use crate::kinds::{Axis, Features, Mode, Stage};
use crate::progress::{watched, Callback};

#[derive(Clone, Debug, PartialEq)]
enum Value {
    Int(i64),
    Real(f64),
    Path(PathBuf),
}

/// Options of a call; those that are not set have the library's defaults, which suit most clips.
///
/// Values are checked by the call that gets them: what is out of range is
/// [`ErrorKind::Argument`](crate::ErrorKind::Argument) there, with the range in the text. Options
/// that a call does not use are left alone. [`options_table`] lists all with ranges and defaults.
///
/// ```
/// use stltsa::{Mode, Options};
///
/// let options = Options::new().dimension(3).neighbors(40).mode(Mode::Temporal);
/// # let _ = options;
/// ```
#[derive(Clone, Default)]
pub struct Options {
    values: BTreeMap<i32, Value>,
    progress: Option<Callback>,
}

macro_rules! setters {
    ($($(#[$text:meta])* $name:ident($value:ident: $kind:ty) => $key:ident, $to:expr;)*) => {$(
        $(#[$text])*
        #[must_use]
        pub fn $name(self, $value: $kind) -> Self {
            self.with(sys::$key, $to)
        }
    )*};
}

impl Options {
    /// The defaults.
    pub fn new() -> Self {
        Self::default()
    }

    setters! {
        /// Neighbors of each frame, k; 0: 1.2 periods where a period is found, else 1.2 seconds (12
        /// where the frame rate is unknown).
        neighbors(k: usize) => STLTSA_OPT_NEIGHBORS, int(k);
        /// Frames to each side that neighbors come from, w; 0: as neighbors.
        window(frames: usize) => STLTSA_OPT_WINDOW, int(frames);
        /// Tangent dimension and number of coordinates, d; 0: fit 2, decompose the best of 1 to 3.
        dimension(d: usize) => STLTSA_OPT_DIMENSION, int(d);
        /// Where neighbors are looked for.
        mode(mode: Mode) => STLTSA_OPT_MODE, Value::Int(mode.raw().into());
        /// Whether a frame is among its own k neighbors (Zhang and Zha) or not (scikit-learn).
        include_self(yes: bool) => STLTSA_OPT_INCLUDE_SELF, Value::Int(yes.into());
        /// Mode recurrent: neighbors from outside the exclusion zone.
        links(count: usize) => STLTSA_OPT_LINKS, int(count);
        /// Mode recurrent: half width of that zone in frames; 0: as window.
        exclusion(frames: usize) => STLTSA_OPT_EXCLUSION, int(frames);
        /// Threads; 0: every core. Results are the same for any number.
        threads(count: usize) => STLTSA_OPT_THREADS, int(count);
        /// What a pose is described by.
        features(features: Features) => STLTSA_OPT_FEATURES, Value::Int(features.raw().into());
        /// The axis that points up; found from the clip where it is not set.
        up_axis(axis: Axis) => STLTSA_OPT_UP_AXIS, Value::Int(axis as i64);
        /// Whether a T-pose at the start is kept.
        keep_start(yes: bool) => STLTSA_OPT_KEEP_START, Value::Int(yes.into());
        /// Frames a second, over what the file says; 0: the file's.
        fps(rate: f64) => STLTSA_OPT_FPS, Value::Real(rate);
        /// Clips are decimated to about this many frames a second: one frame in fps / rate,
        /// rounded, is kept; 0: all.
        rate(rate: f64) => STLTSA_OPT_RATE, Value::Real(rate);
        /// Sigma in seconds of the Gaussian that smooths features; 0: none.
        smoothing(seconds: f64) => STLTSA_OPT_SMOOTHING, Value::Real(seconds);
        /// Shortest period looked for, in seconds.
        period_min(seconds: f64) => STLTSA_OPT_PERIOD_MIN, Value::Real(seconds);
        /// Longest period looked for, in seconds.
        period_max(seconds: f64) => STLTSA_OPT_PERIOD_MAX, Value::Real(seconds);
        /// Dimension: the gap of eigenvalues that counts (tau), as a fraction of k.
        eigengap(tau: f64) => STLTSA_OPT_EIGENGAP, Value::Real(tau);
        /// Dimension: share of local variance that local principal directions must hold.
        variance(share: f64) => STLTSA_OPT_VARIANCE, Value::Real(share);
        /// The ASF file of an AMC clip; found beside the clip where it is not set.
        skeleton(path: impl AsRef<Path>) => STLTSA_OPT_SKELETON, Value::Path(path.as_ref().into());
        /// Whether a model keeps the frames it was fitted to, and so can map and unmap.
        keep_frames(yes: bool) => STLTSA_OPT_KEEP_FRAMES, Value::Int(yes.into());
        /// Rows that a local map rests on; 0: d + 5, at least 10.
        map_neighbors(rows: usize) => STLTSA_OPT_MAP_NEIGHBORS, int(rows);
        /// Local maps that are blended.
        map_blend(count: usize) => STLTSA_OPT_MAP_BLEND, int(count);
        /// Rows to each side of a hint in which a frame is looked for; 0: a fifth of k.
        hint_window(rows: usize) => STLTSA_OPT_HINT_WINDOW, int(rows);
        /// Unmapping: component that the coordinates are of, counted from 0; the only one there is
        /// where it is not set.
        component(index: usize) => STLTSA_OPT_COMPONENT, int(index);
        /// Denoising: points farther than this from the curve are moved (gamma), in units of the
        /// coordinate; one robust standard deviation of the residuals where it is not set.
        gamma(gamma: f64) => STLTSA_OPT_GAMMA, Value::Real(gamma);
        /// Denoising: seconds (rows where the rate is unknown) between knots; 0: a tenth of the
        /// period, else 2 rows.
        knots(seconds: f64) => STLTSA_OPT_KNOTS, Value::Real(seconds);
        /// Denoising: whether spikes are kept from pulling at the curve.
        robust(yes: bool) => STLTSA_OPT_ROBUST, Value::Int(yes.into());
        /// Synthesis: seconds to each side of a seam that are blended; a tenth of the cycle that is
        /// repeated, 0.15 s where clips join, where it is not set.
        crossfade(seconds: f64) => STLTSA_OPT_CROSSFADE, Value::Real(seconds);
        /// Synthesis: seconds by which a cut may move to find a common posture; a tenth of the cycle
        /// that is repeated, half a cycle and at least 0.5 s where clips join, where it is not set.
        search(seconds: f64) => STLTSA_OPT_SEARCH, Value::Real(seconds);
        /// Synthesis: largest distance of the postures at a seam, over what is common between a
        /// motion's own repetitions; 0: none.
        posture_limit(distance: f64) => STLTSA_OPT_POSTURE_LIMIT, Value::Real(distance);
        /// Opening a clip: whether the file is mapped into memory. The numbers of an NPY file
        /// (float64, C order) then stay in the file. While the clip, or a model that keeps its
        /// frames, lives, whoever writes into the file changes them, and whoever cuts it short ends
        /// the process (SIGBUS).
        memory_map(yes: bool) => STLTSA_OPT_MEMORY_MAP, Value::Int(yes.into());
    }

    /// Calls `report` as the work goes on, with the stage and the fraction of it that is done, from 0
    /// to 1; `Break` cancels, and the call ends with
    /// [`ErrorKind::Cancelled`](crate::ErrorKind::Cancelled).
    ///
    /// It runs on the thread of the call. A panic in it cancels too, and goes on from the call.
    /// Clones of these options share it; while it runs, reports of other calls are left out.
    ///
    /// ```
    /// use std::ops::ControlFlow;
    /// use stltsa::{ErrorKind, Model, Options};
    ///
    /// let frames: Vec<[f64; 3]> =
    ///     (0..300).map(|t| t as f64 / 16.0).map(|a| [a.cos(), a.sin(), (2.0 * a).sin()]).collect();
    /// let mut reports = 0;
    /// let options = Options::new().neighbors(120).progress(move |_stage, _fraction| {
    ///     reports += 1;
    ///     if reports < 3 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    /// });
    /// let error = Model::fit(&frames, &options).unwrap_err();
    /// assert_eq!(error.kind(), ErrorKind::Cancelled);
    /// ```
    #[must_use]
    pub fn progress(
        mut self,
        report: impl FnMut(Stage, f64) -> ControlFlow<()> + Send + 'static,
    ) -> Self {
        self.progress = Some(Arc::new(Mutex::new(report)));
        self
    }

    fn with(mut self, key: i32, value: Value) -> Self {
        self.values.insert(key, value);
        self
    }

    /// Runs `body`, one call of the library, with these options as C takes them.
    pub(crate) fn call<T>(
        &self,
        body: impl FnOnce(*const sys::stltsa_options) -> Result<T>,
    ) -> Result<T> {
        let mut raw = self.raw()?;
        match &self.progress {
            Some(callback) => watched(&mut raw, callback, body),
            None => body(raw.raw()),
        }
    }

    fn raw(&self) -> Result<Owned<sys::stltsa_options>> {
        // SAFETY: handles and strings live through each call.
        unsafe {
            let mut options = Owned::make(|out| sys::stltsa_options_new(out))?;
            let raw = options.raw_mut();
            for (&key, value) in &self.values {
                check(match value {
                    Value::Int(value) => sys::stltsa_options_set_int(raw, key, *value),
                    Value::Real(value) => sys::stltsa_options_set_real(raw, key, *value),
                    Value::Path(path) => {
                        let path = c_path(path)?;
                        sys::stltsa_options_set_text(raw, key, path.as_ptr())
                    }
                })?;
            }
            Ok(options)
        }
    }
}

impl fmt::Debug for Options {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = |key: &i32| {
            let row = options_table().into_iter().find(|row| row.key == *key);
            row.map_or_else(|| key.to_string(), |row| row.name)
        };
        let mut map = f.debug_map();
        map.entries(self.values.iter().map(|(key, value)| (name(key), value)));
        map.entries(self.progress.iter().map(|_| ("progress", "..."))).finish()
    }
}

/// What is too large for C is out of range there, too.
fn int(value: usize) -> Value {
    Value::Int(i64::try_from(value).unwrap_or(i64::MAX))
}

/// One row of the library's table of options.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct OptionInfo {
    key: i32,
    /// As the command `stltsa` has it, `--name`; the method of [`Options`] has `_` for `-`.
    pub name: String,
    /// One sentence.
    pub text: String,
    /// `temporal=1 spatial=2` where values have names.
    pub choices: Option<String>,
    /// Smallest and largest number; `None` for texts.
    pub range: Option<RangeInclusive<f64>>,
    /// The default of a number.
    pub standard: f64,
}

/// Every option of the library that runs, in the order of its keys.
///
/// ```
/// let table = stltsa::options_table();
/// let links = table.iter().find(|row| row.name == "links").unwrap();
/// assert_eq!(links.standard, 4.0);
/// ```
pub fn options_table() -> Vec<OptionInfo> {
    // SAFETY: it only counts.
    let count = unsafe { sys::stltsa_option_count() };
    (0..count).filter_map(describe).collect()
}

fn describe(index: i64) -> Option<OptionInfo> {
    let none = std::ptr::null();
    let mut row = sys::stltsa_option_info {
        size: size_of::<sys::stltsa_option_info>(),
        key: 0,
        type_: 0,
        name: none,
        text: none,
        choices: none,
        minimum: 0.0,
        maximum: 0.0,
        standard: 0.0,
    };
    // SAFETY: the struct says its size, and the texts that come back are static.
    unsafe {
        check(sys::stltsa_option_describe(index, &mut row)).ok()?;
        Some(OptionInfo {
            key: row.key,
            name: text(row.name),
            text: text(row.text),
            choices: if row.choices.is_null() { None } else { Some(text(row.choices)) },
            range: (row.type_ != sys::STLTSA_TYPE_TEXT).then_some(row.minimum..=row.maximum),
            standard: row.standard,
        })
    }
}
