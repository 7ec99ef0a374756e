// SPDX-License-Identifier: BSD-3-Clause
// Made by scripts/generate-bindings: do not edit.
use super::*;

impl Options {
    /// Neighbors of each frame (k); auto: 1.2 periods, without a period 1.2 seconds, or 12 frames
    /// without a rate.
    #[must_use]
    pub fn neighbors(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_NEIGHBORS, int(value))
    }

    /// Window (w), frames to each side; auto: as neighbors.
    #[must_use]
    pub fn window(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_WINDOW, int(value))
    }

    /// Tangent dimension, the number of coordinates (d); auto: 2.
    #[must_use]
    pub fn dimension(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_DIMENSION, int(value))
    }

    /// Candidates for neighbors: temporal, frames of the clip within the window; spatial, all
    /// frames; recurrent, frames within the window and, as links, frames outside the exclusion
    /// zone.
    #[must_use]
    pub fn mode(self, value: Mode) -> Self {
        self.with(sys::STLTSA_OPT_MODE, Value::Int(value.raw().into()))
    }

    /// Count a frame among its own neighbors.
    #[must_use]
    pub fn include_self(self, value: bool) -> Self {
        self.with(sys::STLTSA_OPT_INCLUDE_SELF, Value::Int(value.into()))
    }

    /// Recurrent: neighbors beyond the exclusion zone.
    #[must_use]
    pub fn links(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_LINKS, int(value))
    }

    /// Recurrent: half width of that zone, frames; auto: window.
    #[must_use]
    pub fn exclusion(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_EXCLUSION, int(value))
    }

    /// Threads; auto: one for each core.
    #[must_use]
    pub fn threads(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_THREADS, int(value))
    }

    /// Description of a pose: positions (of the joints, without root position and yaw),
    /// rotations6d, euler (the file's angles), raw (the file's numbers) or points (such as markers,
    /// three columns each, without path and heading); auto: positions if there is a skeleton,
    /// points if the columns are named so (heel_x, heel_y, heel_z, ...), otherwise raw.
    #[must_use]
    pub fn features(self, value: Features) -> Self {
        self.with(sys::STLTSA_OPT_FEATURES, Value::Int(value.raw().into()))
    }

    /// The axis that points up; auto: found from the skeleton; of points, the file's, or else
    /// guessed.
    #[must_use]
    pub fn up_axis(self, value: Axis) -> Self {
        self.with(sys::STLTSA_OPT_UP_AXIS, Value::Int(value.raw().into()))
    }

    /// Keep a T-pose at the start instead of dropping it.
    #[must_use]
    pub fn keep_start(self, value: bool) -> Self {
        self.with(sys::STLTSA_OPT_KEEP_START, Value::Int(value.into()))
    }

    /// Frames per second, for files without a rate, or instead of theirs (not in batch); of
    /// unmapped points; auto: the file's, or the model's.
    #[must_use]
    pub fn fps(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_FPS, Value::Real(value))
    }

    /// Decimate clips to about this frame rate; 0: keep all.
    #[must_use]
    pub fn sample_rate(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_SAMPLE_RATE, Value::Real(value))
    }

    /// Smoothing of the features: sigma in seconds; 0: none.
    #[must_use]
    pub fn smoothing(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_SMOOTHING, Value::Real(value))
    }

    /// Shortest period of the search, in seconds; in frames if the rate is unknown, 4 by default.
    #[must_use]
    pub fn period_min(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_PERIOD_MIN, Value::Real(value))
    }

    /// Longest period of the search, in seconds; in frames if the rate is unknown, half of all, at
    /// most 1000, by default.
    #[must_use]
    pub fn period_max(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_PERIOD_MAX, Value::Real(value))
    }

    /// Smallest eigengap that counts (tau), as a share of k.
    #[must_use]
    pub fn eigengap(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_EIGENGAP, Value::Real(value))
    }

    /// Share of local variance that local PCA must explain.
    #[must_use]
    pub fn variance(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_VARIANCE, Value::Real(value))
    }

    /// Also estimate the intrinsic dimension, in two ways.
    #[must_use]
    pub fn intrinsic(self, value: bool) -> Self {
        self.with(sys::STLTSA_OPT_INTRINSIC, Value::Int(value.into()))
    }

    /// The ASF file of an AMC clip; auto: found beside the clip.
    #[must_use]
    pub fn skeleton(self, value: impl AsRef<Path>) -> Self {
        self.with(sys::STLTSA_OPT_SKELETON, Value::Text(value.as_ref().into()))
    }

    /// Keep the fitted frames in the model, so that it can map.
    #[must_use]
    pub fn keep_frames(self, value: bool) -> Self {
        self.with(sys::STLTSA_OPT_KEEP_FRAMES, Value::Int(value.into()))
    }

    /// Rows for each local map; auto: d + 5, at least 10.
    #[must_use]
    pub fn map_neighbors(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_MAP_NEIGHBORS, int(value))
    }

    /// Local maps to blend, each from its own part of the curve.
    #[must_use]
    pub fn map_blend(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_MAP_BLEND, int(value))
    }

    /// Rows to search on each side of a hint; auto: k / 5.
    #[must_use]
    pub fn hint_window(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_HINT_WINDOW, int(value))
    }

    /// Component of the coordinates, from 0; auto: the only one.
    #[must_use]
    pub fn component(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_COMPONENT, int(value))
    }

    /// Distance from the curve beyond which a point is noisy; auto: one robust deviation of the
    /// residuals.
    #[must_use]
    pub fn gamma(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_GAMMA, Value::Real(value))
    }

    /// Seconds between knots, or rows if the rate is unknown; auto: a tenth of the period,
    /// otherwise 2 rows.
    #[must_use]
    pub fn knot_spacing(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_KNOT_SPACING, Value::Real(value))
    }

    /// Reduce the influence of spikes on the curve.
    #[must_use]
    pub fn robust(self, value: bool) -> Self {
        self.with(sys::STLTSA_OPT_ROBUST, Value::Int(value.into()))
    }

    /// Seconds to blend on each side of a seam; auto: a tenth of the repeated cycle, or 0.15
    /// between clips.
    #[must_use]
    pub fn crossfade(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_CROSSFADE, Value::Real(value))
    }

    /// Seconds by which a cut may move; auto: a tenth of the repeated cycle; between clips half a
    /// cycle, at least 0.5.
    #[must_use]
    pub fn cut_range(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_CUT_RANGE, Value::Real(value))
    }

    /// Max distance of the postures at a seam, relative to that of repetitions; 0: no limit.
    #[must_use]
    pub fn posture_limit(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_POSTURE_LIMIT, Value::Real(value))
    }

    /// Number of segments in motion; auto: as behavior changes.
    #[must_use]
    pub fn segments(self, value: usize) -> Self {
        self.with(sys::STLTSA_OPT_SEGMENTS, int(value))
    }

    /// Missing points or values: fill, up to 0.25 s over time, longer ones from the others in the
    /// same frame; skip, all from the others, so that they add nothing to distances; refuse, an
    /// error.
    #[must_use]
    pub fn gaps(self, value: Gaps) -> Self {
        self.with(sys::STLTSA_OPT_GAPS, Value::Int(value.raw().into()))
    }

    /// Points seen with less confidence are missing.
    #[must_use]
    pub fn min_confidence(self, value: f64) -> Self {
        self.with(sys::STLTSA_OPT_MIN_CONFIDENCE, Value::Real(value))
    }

    /// Make a loop: the last frame meets the first.
    #[must_use]
    pub fn r#loop(self, value: bool) -> Self {
        self.with(sys::STLTSA_OPT_LOOP, Value::Int(value.into()))
    }

    /// Remove the travel and the turn of a loop.
    #[must_use]
    pub fn in_place(self, value: bool) -> Self {
        self.with(sys::STLTSA_OPT_IN_PLACE, Value::Int(value.into()))
    }

    /// Person or animal in a file: the prefix of its points (Viktor of Viktor:LHEE) or its name;
    /// auto: the only one.
    #[must_use]
    pub fn subject(self, value: impl AsRef<str>) -> Self {
        self.with(sys::STLTSA_OPT_SUBJECT, Value::Text(value.as_ref().into()))
    }
}
