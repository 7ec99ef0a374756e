// SPDX-License-Identifier: BSD-3-Clause
//! [`Dimension`]: the intrinsic dimension of a motion.

use stltsa_sys as sys;

use crate::array::{list_in, Matrix, View};
use crate::clip::Clip;
use crate::error::{c_count, count, owned_text, text, Result};
use crate::handle::Owned;
use crate::model::c_lengths;
use crate::options::Options;

/// Two estimates of the dimension of the manifold (section 2.3 of the paper).
///
/// ```
/// use stltsa::{Dimension, Estimate, Options};
///
/// // A circle, bent into three dimensions, is a curve.
/// let frames: Vec<[f64; 3]> = (0..300)
///     .map(|t| std::f64::consts::TAU * t as f64 / 100.0)
///     .map(|a| [a.cos(), a.sin(), 0.3 * (2.0 * a).sin()])
///     .collect();
/// let dimension = Dimension::estimate(&frames, &Options::new().neighbors(12))?;
/// assert_eq!(dimension.local_pca(), Estimate::Dimension(1));
/// # Ok::<(), stltsa::Error>(())
/// ```
#[derive(Debug)]
pub struct Dimension {
    pub(crate) handle: Owned<sys::stltsa_dimension>,
}

/// An estimate, or the reason why there is none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Estimate {
    /// Number of coordinates.
    Dimension(usize),
    /// There is no estimate, for this reason.
    CannotTell(String),
}

type Ask =
    unsafe extern "C" fn(*const sys::stltsa_dimension, *mut *const std::os::raw::c_char) -> i64;
type Copy = unsafe extern "C" fn(
    *const sys::stltsa_dimension,
    *const sys::stltsa_out,
) -> sys::stltsa_status;

impl Dimension {
    /// Estimates the dimension of `frames` x features, one clip. A disconnected or degenerate graph
    /// gives [`Estimate::CannotTell`], not an error.
    ///
    /// The alignment matrix is built with tangent dimension `dimension` (0: 2). Options used:
    /// neighbors, window, dimension, mode, include_self, links, exclusion, eigengap, variance,
    /// threads, fps, period_min, period_max, progress.
    ///
    /// # Errors
    /// As [`Model::fit`](crate::Model::fit).
    pub fn estimate<'a>(frames: impl Into<View<'a>>, options: &Options) -> Result<Self> {
        let frames = frames.into();
        Self::estimate_several(frames, &[frames.rows()], options)
    }

    /// The same for several clips, one after another in `frames`, with their frame counts in
    /// `lengths`.
    ///
    /// # Errors
    /// As [`Model::fit_several`](crate::Model::fit_several).
    pub fn estimate_several<'a>(
        frames: impl Into<View<'a>>,
        lengths: &[usize],
        options: &Options,
    ) -> Result<Self> {
        let (frames, lengths) = (frames.into().raw()?, c_lengths(lengths)?);
        options.call(|options| {
            let lengths = list_in(&lengths)?;
            // SAFETY: arrays of the sizes they say, and a handle, live through the call.
            let make =
                |out| unsafe { sys::stltsa_estimate_dimension(&frames, &lengths, options, out) };
            Ok(Self { handle: Owned::make(make)? })
        })
    }

    /// The same for a clip, prepared as in [`Model::fit_clip`](crate::Model::fit_clip).
    ///
    /// # Errors
    /// As [`Model::fit`](crate::Model::fit).
    pub fn estimate_clip(clip: &Clip, options: &Options) -> Result<Self> {
        options.call(|options| {
            // SAFETY: live handles.
            let make =
                |out| unsafe { sys::stltsa_estimate_dimension_clip(clip.raw(), options, out) };
            Ok(Self { handle: Owned::make(make)? })
        })
    }

    /// The same for several clips, as [`Model::fit_clips`](crate::Model::fit_clips) takes them.
    ///
    /// # Errors
    /// As [`Model::fit_clips`](crate::Model::fit_clips).
    pub fn estimate_clips(clips: &[&Clip], options: &Options) -> Result<Self> {
        let clips: Vec<_> = clips.iter().map(|clip| clip.raw()).collect();
        let count = c_count(clips.len())?;
        options.call(|options| {
            // SAFETY: live handles, as many as it says.
            let make = |out| unsafe {
                sys::stltsa_estimate_dimension_clips(clips.as_ptr(), count, options, out)
            };
            Ok(Self { handle: Owned::make(make)? })
        })
    }

    /// The paper's estimate: the first gap of the eigenvalues above tau. It counts the eigenvalue
    /// zero. By construction one more eigenvalue than the tangent dimension is small, so the
    /// estimate depends on the option `dimension`: compare it with [`Dimension::local_pca`].
    pub fn eigengap(&self) -> Estimate {
        self.estimated(sys::stltsa_dimension_eigengap)
    }

    /// The median number of local principal directions that explain the share `variance` of a
    /// neighborhood.
    pub fn local_pca(&self) -> Estimate {
        self.estimated(sys::stltsa_dimension_local_pca)
    }

    /// Eigenvalues of B / k, ascending, starting with zero.
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn eigenvalues(&self) -> Result<Vec<f64>> {
        self.numbers(sys::STLTSA_INFO_EIGENVALUE, sys::stltsa_dimension_eigenvalues)
    }

    /// Mean share of a neighborhood's variance along its principal direction 1, 2, ...
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn local_variances(&self) -> Result<Vec<f64>> {
        self.numbers(sys::STLTSA_INFO_LOCAL_VARIANCE, sys::stltsa_dimension_local_variances)
    }

    /// One JSON object (schema: stltsa-dimension/1).
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn json(&self) -> Result<String> {
        // SAFETY: a live handle.
        owned_text(|out| unsafe { sys::stltsa_dimension_json(self.handle.raw(), out) })
    }

    fn estimated(&self, ask: Ask) -> Estimate {
        let mut reason = std::ptr::null();
        // SAFETY: a live handle, to which the reason belongs until it is copied.
        unsafe {
            match count(ask(self.handle.raw(), &mut reason)) {
                Ok(dimension) if dimension > 0 => Estimate::Dimension(dimension),
                _ => Estimate::CannotTell(text(reason)),
            }
        }
    }

    fn numbers(&self, key: i32, copy: Copy) -> Result<Vec<f64>> {
        let handle = self.handle.raw();
        // SAFETY: a live handle, and an array of the size it says.
        let rows = unsafe { sys::stltsa_info_count(sys::stltsa_dimension_info(handle), key) };
        let numbers = Matrix::filled(count(rows)?, 1, |out| unsafe { copy(handle, out) })?;
        Ok(numbers.into_vec())
    }
}
