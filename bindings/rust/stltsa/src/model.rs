// SPDX-License-Identifier: BSD-3-Clause
//! [`Model`]: the manifold curve of one or several clips.

use std::path::Path;

use stltsa_sys as sys;

use crate::array::{list_in, Matrix, View};
use crate::clip::Clip;
use crate::error::{c_count, c_path, check, Error, ErrorKind, Result};
use crate::handle::Owned;
use crate::kinds::Fact;
use crate::options::Options;
use crate::rows::Component;

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
/// let coords = model.coords();
/// assert_eq!((coords.rows(), coords.cols()), (300, 2));
/// assert!(model.components()[0].residual < 1e-9);
///
/// // A fitted frame gets its own coordinates, to the bit.
/// let mapped = model.map(&frames[..10], None, &Options::new())?;
/// assert_eq!(mapped.coords.row(3), coords.row(3));
/// # Ok::<(), stltsa::Error>(())
/// ```
#[derive(Debug)]
pub struct Model {
    pub(crate) handle: Owned<sys::stltsa_model>,
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
        let lengths = list_in(&lengths)?;
        let handle = options.make(|options, out| {
            // SAFETY: arrays of the sizes they say, and a handle, live through the call.
            unsafe { sys::stltsa_fit(&frames, &lengths, options, out) }
        })?;
        Ok(Self { handle })
    }

    /// Fits a model to a clip: its features without a T-pose at the start, smoothed and decimated.
    /// Options used besides those of [`Model::fit`]: features, up_axis, keep_start, sample_rate,
    /// smoothing.
    ///
    /// # Errors
    /// As [`Model::fit`].
    pub fn fit_clip(clip: &Clip, options: &Options) -> Result<Self> {
        Self::fit_clips(&[clip], options)
    }

    /// The same from several clips of one hierarchy, each prepared as by itself. In
    /// [`Model::info`] the place of the rows has a value for each clip.
    ///
    /// # Errors
    /// As [`Model::fit`]; [`Shape`](ErrorKind::Shape) for clips that do not go together.
    pub fn fit_clips(clips: &[&Clip], options: &Options) -> Result<Self> {
        let clips: Vec<_> = clips.iter().map(|clip| clip.raw()).collect();
        let (clips, count) = (clips.as_ptr(), c_count(clips.len())?);
        let handle = options.make(|options, out| {
            // SAFETY: live handles, as many as it says.
            unsafe { sys::stltsa_fit_clips(clips, count, options, out) }
        })?;
        Ok(Self { handle })
    }

    /// Reads a model written by [`Model::save`]; it gives the same bits as the saved one. Option
    /// used: progress.
    ///
    /// # Errors
    /// [`Io`](ErrorKind::Io), [`Format`](ErrorKind::Format), [`Cancelled`](ErrorKind::Cancelled).
    pub fn load(path: impl AsRef<Path>, options: &Options) -> Result<Self> {
        let path = c_path(path.as_ref())?;
        let handle = options.make(|options, out| {
            // SAFETY: a string and a handle that live through the call.
            unsafe { sys::stltsa_model_load(path.as_ptr(), options, out) }
        })?;
        Ok(Self { handle })
    }

    /// Writes the model to a file, completely or not at all. Option used: progress.
    ///
    /// # Errors
    /// [`Io`](ErrorKind::Io), [`Cancelled`](ErrorKind::Cancelled).
    pub fn save(&self, path: impl AsRef<Path>, options: &Options) -> Result<()> {
        let path = c_path(path.as_ref())?;
        options.call(|options| {
            // SAFETY: live handles, and a string that lives through the call.
            check(unsafe { sys::stltsa_model_save(self.raw(), path.as_ptr(), options) })
        })
    }

    /// Reads a model from the bytes of [`Model::serialize`]; untrusted bytes are safe.
    ///
    /// # Errors
    /// [`Format`](ErrorKind::Format) describes the problem.
    pub fn parse(bytes: &[u8]) -> Result<Self> {
        let (data, size) = (bytes.as_ptr().cast(), bytes.len());
        // SAFETY: `size` bytes from `data` live through the call.
        let parse = |out| unsafe { sys::stltsa_model_parse(data, size, out) };
        Ok(Self { handle: Owned::make(parse)? })
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

    /// The coordinates: rows x d, each column centered and of unit norm within a component.
    pub fn coords(&self) -> Matrix {
        self.info().matrix(Fact::Coords)
    }

    /// components x (d + 2): lambda_1 = 0, lambda_2, ... of each, ascending; NaN if a component is
    /// too small to have as many.
    pub fn eigenvalues(&self) -> Matrix {
        self.info().matrix(Fact::Eigenvalues)
    }

    /// Component of each row, counted from 0, numbered by first row.
    pub fn component_of(&self) -> Vec<usize> {
        let components = self.info().column(Fact::ComponentOf).into_iter();
        components.map(|component| component as usize).collect()
    }

    /// Connected components of the neighborhood graph; coordinates of different ones are not
    /// comparable.
    pub fn components(&self) -> Vec<Component> {
        self.info().list(Fact::Component)
    }
}

/// The lengths of clips for C.
pub(crate) fn c_lengths(lengths: &[usize]) -> Result<Vec<i64>> {
    if lengths.is_empty() {
        return Err(Error::new(ErrorKind::Shape, "lengths is empty: give the clips' frames"));
    }
    lengths.iter().copied().map(c_count).collect()
}
