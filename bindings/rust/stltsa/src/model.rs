// SPDX-License-Identifier: BSD-3-Clause
//! [`Model`]: the manifold curve of one or several clips.

use std::path::Path;

use stltsa_sys as sys;

use crate::array::{list_in, list_out, Matrix, View};
use crate::clip::Clip;
use crate::error::{c_count, c_path, check, count, owned_text, texts, Error, ErrorKind, Result};
use crate::facts::Facts;
use crate::handle::Owned;
use crate::kinds::{Fact, Mode};
use crate::options::Options;

/// A fitted curve (spatio-temporal LTSA): coordinates of every frame, and their quality.
///
/// ```
/// use stltsa::{Model, Options};
///
/// // Three turns of a circle, bent into four dimensions.
/// let frames: Vec<[f64; 4]> = (0..300)
///     .map(|t| std::f64::consts::TAU * t as f64 / 100.0)
///     .map(|a| [a.cos(), a.sin(), 0.3 * (2.0 * a).sin(), 0.2 * a.cos() * a.cos()])
///     .collect();
/// let model = Model::fit(&frames, &Options::new().dimension(2).neighbors(120))?;
///
/// let coords = model.coords()?;
/// assert_eq!((coords.rows(), coords.cols()), (300, 2));
/// assert!(model.info().residual < 1e-9);
///
/// // A fitted frame gets its own coordinates, to the bit.
/// let mapped = model.map(&frames[..10], &Options::new())?;
/// assert_eq!(mapped.coords.row(3), coords.row(3));
/// # Ok::<(), stltsa::Error>(())
/// ```
#[derive(Debug)]
pub struct Model {
    pub(crate) handle: Owned<sys::stltsa_model>,
    info: ModelInfo,
}

/// Data, parameters and quality of a fit. Frames are rows of the model.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ModelInfo {
    /// Rows of the coordinates.
    pub frames: usize,
    /// Number of fitted columns.
    pub features: usize,
    /// Number of coordinates, d.
    pub dimension: usize,
    /// k of the fit.
    pub neighbors: usize,
    /// w of the fit.
    pub window: usize,
    /// Candidates for neighbors.
    pub mode: Mode,
    /// Whether a frame was among its own neighbors.
    pub include_self: bool,
    /// Neighbors from outside the exclusion zone (mode recurrent).
    pub links: usize,
    /// Half width of that zone (mode recurrent).
    pub exclusion: usize,
    /// Connected components of the neighborhood graph; coordinates of different ones are not
    /// comparable.
    pub components: usize,
    /// Number of frames that were dropped because they repeat the previous one.
    pub repeated: usize,
    /// Number of windows with fewer than d directions.
    pub rank_deficient: usize,
    /// Applications of the inverse operator by the eigensolver.
    pub solves: usize,
    /// Row i is frame `first_frame + i * frame_step` of the clip.
    pub first_frame: usize,
    /// See `first_frame`; 1 for matrices.
    pub frame_step: usize,
    /// Largest ||B u - lambda u|| / k over the coordinates.
    pub residual: f64,
    /// Estimate of the largest principal angle to the exact embedding of these neighborhoods, in
    /// radians.
    pub error_estimate: f64,
    /// Smallest lambda_{d+2} / lambda_{d+1} of a component; near 1 the curve is ill-defined.
    pub gap: f64,
    /// |Rank correlation| of coordinate 1 with time; at 1 it only follows time.
    pub time_correlation: f64,
    /// Rows per second; `None` if unknown.
    pub fps: Option<f64>,
    /// Period in seconds from which an automatic k is derived.
    pub period: Option<f64>,
    /// Distance from the fitted frames, in units of the features, up to which a new frame counts as
    /// similar. `None`: the model kept no frames and cannot map.
    pub reach: Option<f64>,
}

impl Model {
    /// Fits a model to `frames` x features, one clip: finite, with at least k + 1 distinct frames.
    ///
    /// Options used: neighbors, window, dimension, mode, include_self, links, exclusion, threads,
    /// fps (for the automatic k), period_min, period_max, keep_frames, progress.
    ///
    /// # Errors
    /// [`Shape`](ErrorKind::Shape), [`NotFinite`](ErrorKind::NotFinite),
    /// [`TooFewFrames`](ErrorKind::TooFewFrames), [`Argument`](ErrorKind::Argument) (needs
    /// d + 2 <= k <= w + 1), [`Degenerate`](ErrorKind::Degenerate),
    /// [`NotConverged`](ErrorKind::NotConverged), [`Cancelled`](ErrorKind::Cancelled),
    /// [`NoMemory`](ErrorKind::NoMemory).
    pub fn fit<'a>(frames: impl Into<View<'a>>, options: &Options) -> Result<Self> {
        let frames = frames.into();
        Self::fit_several(frames, &[frames.rows()], options)
    }

    /// The same for several clips, one after another in `frames`, with their frame counts in
    /// `lengths`. Temporal neighbors never cross clips, so check the components.
    ///
    /// # Errors
    /// As [`Model::fit`]; [`Shape`](ErrorKind::Shape) unless `lengths` sum to the rows.
    pub fn fit_several<'a>(
        frames: impl Into<View<'a>>,
        lengths: &[usize],
        options: &Options,
    ) -> Result<Self> {
        let (frames, lengths) = (frames.into().raw()?, c_lengths(lengths)?);
        options.call(|options| {
            let lengths = list_in(&lengths)?;
            // SAFETY: arrays of the sizes they say, and a handle, live through the call.
            Self::made(|out| unsafe { sys::stltsa_fit(&frames, &lengths, options, out) })
        })
    }

    /// Fits a model to a clip: its features without a T-pose at the start, smoothed and decimated.
    /// Options used besides those of [`Model::fit`]: features, up_axis, keep_start, sample_rate,
    /// smoothing.
    ///
    /// # Errors
    /// As [`Model::fit`].
    pub fn fit_clip(clip: &Clip, options: &Options) -> Result<Self> {
        options.call(|options| {
            // SAFETY: live handles.
            Self::made(|out| unsafe { sys::stltsa_fit_clip(clip.raw(), options, out) })
        })
    }

    /// The same from several clips of one hierarchy, each prepared as by itself. In
    /// [`Model::facts`] the place of the rows has a value for each clip.
    ///
    /// # Errors
    /// As [`Model::fit`]; [`Shape`](ErrorKind::Shape) for clips that do not go together.
    pub fn fit_clips(clips: &[&Clip], options: &Options) -> Result<Self> {
        let clips: Vec<_> = clips.iter().map(|clip| clip.raw()).collect();
        let count = c_count(clips.len())?;
        options.call(|options| {
            // SAFETY: live handles, as many as it says.
            Self::made(|out| unsafe { sys::stltsa_fit_clips(clips.as_ptr(), count, options, out) })
        })
    }

    /// Reads a model written by [`Model::save`]; it gives the same bits as the saved one.
    ///
    /// # Errors
    /// [`Io`](ErrorKind::Io), [`Format`](ErrorKind::Format).
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        let path = c_path(path.as_ref())?;
        // SAFETY: a string that lives through the call.
        Self::made(|out| unsafe { sys::stltsa_model_load(path.as_ptr(), out) })
    }

    /// Writes the model to a file, completely or not at all.
    ///
    /// # Errors
    /// [`Io`](ErrorKind::Io).
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        let path = c_path(path.as_ref())?;
        // SAFETY: a live handle, and a string that lives through the call.
        check(unsafe { sys::stltsa_model_save(self.raw(), path.as_ptr()) })
    }

    /// Reads a model from the bytes of [`Model::serialize`]; untrusted bytes are safe.
    ///
    /// # Errors
    /// [`Format`](ErrorKind::Format) describes the problem.
    pub fn parse(bytes: &[u8]) -> Result<Self> {
        let (data, size) = (bytes.as_ptr().cast(), bytes.len());
        // SAFETY: `size` bytes from `data` live through the call.
        Self::made(|out| unsafe { sys::stltsa_model_parse(data, size, out) })
    }

    /// The model as bytes: versioned, checksummed, the same on every machine.
    ///
    /// # Errors
    /// [`NoMemory`](ErrorKind::NoMemory).
    pub fn serialize(&self) -> Result<Vec<u8>> {
        let (mut data, mut size) = (std::ptr::null_mut(), 0);
        // SAFETY: a live handle; then `size` bytes from `data`, which this side has to free.
        unsafe {
            check(sys::stltsa_model_serialize(self.raw(), &mut data, &mut size))?;
            let bytes = std::slice::from_raw_parts(data, size).to_vec();
            sys::stltsa_free(data.cast());
            Ok(bytes)
        }
    }

    /// Data, parameters and quality of the fit.
    pub fn info(&self) -> &ModelInfo {
        &self.info
    }

    /// The coordinates: frames x d, each column centered and of unit norm within a component.
    ///
    /// # Errors
    /// [`NoMemory`](ErrorKind::NoMemory).
    pub fn coords(&self) -> Result<Matrix> {
        Matrix::filled(self.info.frames, self.info.dimension, |out| {
            // SAFETY: a live handle, an array of the size it says.
            unsafe { sys::stltsa_model_coords(self.raw(), out) }
        })
    }

    /// components x (d + 2): lambda_1 = 0, lambda_2, ... of each, ascending; NaN if a component is
    /// too small to have as many.
    ///
    /// # Errors
    /// [`NoMemory`](ErrorKind::NoMemory).
    pub fn eigenvalues(&self) -> Result<Matrix> {
        Matrix::filled(self.info.components, self.info.dimension + 2, |out| {
            // SAFETY: a live handle, an array of the size it says.
            unsafe { sys::stltsa_model_eigenvalues(self.raw(), out) }
        })
    }

    /// Component of each row, counted from 0, numbered by first row.
    ///
    /// # Errors
    /// [`NoMemory`](ErrorKind::NoMemory).
    pub fn components(&self) -> Result<Vec<usize>> {
        let mut labels = vec![0; self.info.frames];
        let out = list_out(&mut labels)?;
        // SAFETY: a live handle, an array of the size it says.
        check(unsafe { sys::stltsa_model_components(self.raw(), &out) })?;
        labels.into_iter().map(count).collect()
    }

    /// Warnings: a coordinate that only follows time, disconnected graph, rank-deficient windows,
    /// small gap.
    pub fn warnings(&self) -> Vec<String> {
        // SAFETY: a live handle, to which the texts belong until they are copied.
        unsafe {
            let count = sys::stltsa_model_warning_count(self.raw());
            texts(count, |index| sys::stltsa_model_warning(self.raw(), index))
        }
    }

    /// One JSON object (schema: stltsa-model/1).
    ///
    /// # Errors
    /// [`NoMemory`](ErrorKind::NoMemory).
    pub fn json(&self) -> Result<String> {
        // SAFETY: a live handle.
        owned_text(|out| unsafe { sys::stltsa_model_json(self.raw(), out) })
    }

    pub(crate) fn raw(&self) -> *const sys::stltsa_model {
        self.handle.raw()
    }

    fn made(make: impl FnOnce(*mut *mut sys::stltsa_model) -> sys::stltsa_status) -> Result<Self> {
        let handle = Owned::make(make)?;
        let info = ModelInfo::of(&handle)?;
        Ok(Self { handle, info })
    }
}

impl ModelInfo {
    fn of(model: &Owned<sys::stltsa_model>) -> Result<Self> {
        // SAFETY: a live handle.
        let facts = unsafe { Facts::new(sys::stltsa_model_info(model.raw())) };
        let int = |key| count(facts.int(key, 0)?);
        let real = |key| facts.real(key, 0);
        let sum = |key| count(facts.ints(key)?.iter().sum());
        let largest = |key| Ok::<_, Error>(facts.reals(key)?.into_iter().fold(0.0, f64::max));
        let known = |key| Ok::<_, Error>(Some(real(key)?).filter(|value| *value != 0.0));
        Ok(Self {
            frames: int(Fact::Rows)?,
            features: int(Fact::FeatureCount)?,
            dimension: int(Fact::Dimension)?,
            neighbors: int(Fact::Neighbors)?,
            window: int(Fact::Window)?,
            mode: Mode::from_raw(int(Fact::Mode)? as i32),
            include_self: int(Fact::IncludeSelf)? != 0,
            links: int(Fact::Links)?,
            exclusion: int(Fact::Exclusion)?,
            components: int(Fact::Components)?,
            repeated: int(Fact::Repeated)?,
            rank_deficient: sum(Fact::RankDeficient)?,
            solves: sum(Fact::Solves)?,
            first_frame: int(Fact::FirstFrame)?,
            frame_step: int(Fact::FrameStep)?,
            residual: largest(Fact::Residual)?,
            error_estimate: largest(Fact::ErrorEstimate)?,
            gap: facts.reals(Fact::Gap)?.into_iter().fold(f64::INFINITY, f64::min),
            time_correlation: real(Fact::TimeCorrelation)?,
            fps: known(Fact::Fps)?,
            period: known(Fact::Period)?,
            reach: known(Fact::Reach)?,
        })
    }
}

/// The lengths of clips for C.
pub(crate) fn c_lengths(lengths: &[usize]) -> Result<Vec<i64>> {
    if lengths.is_empty() {
        return Err(Error::new(ErrorKind::Shape, "lengths is empty: give the clips' frames"));
    }
    lengths.iter().copied().map(c_count).collect()
}
