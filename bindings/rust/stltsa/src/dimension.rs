// SPDX-License-Identifier: BSD-3-Clause
//! [`Dimension`]: the intrinsic dimension of a motion.

use stltsa_sys as sys;

use crate::array::View;
use crate::clip::Clip;
use crate::error::{count, owned_text, text, Result};
use crate::handle::Owned;
use crate::model::c_lengths;
use crate::options::Options;

/// Two estimates of the dimension of the manifold (section 2.3 of the paper).
///
/// ```
/// use stltsa::{Dimension, Estimate, Options};
///
/// A circle, bent into three dimensions, is a curve.
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

type Count =
    unsafe extern "C" fn(*const sys::stltsa_dimension, *mut *const std::os::raw::c_char) -> i64;
type Copy = unsafe extern "C" fn(*const sys::stltsa_dimension, *mut f64, i64) -> i64;

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
            let (clips, lengths) = (lengths.len() as i64, lengths.as_ptr());
            // SAFETY: arrays of the sizes they say, and a handle, live through the call.
            let make = |out| unsafe {
                sys::stltsa_estimate_dimension(&frames, lengths, clips, options, out)
            };
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
    pub fn eigenvalues(&self) -> Vec<f64> {
        self.numbers(sys::stltsa_dimension_eigenvalues)
    }

    /// Mean share of a neighborhood's variance along its principal direction 1, 2, ...
    pub fn local_variances(&self) -> Vec<f64> {
        self.numbers(sys::stltsa_dimension_local_variances)
    }

    /// One JSON object (schema: stltsa-dimension/1).
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn json(&self) -> Result<String> {
        // SAFETY: a live handle.
        owned_text(|out| unsafe { sys::stltsa_dimension_json(self.handle.raw(), out) })
    }

    fn estimated(&self, ask: Count) -> Estimate {
        let mut reason = std::ptr::null();
        // SAFETY: a live handle, to which the reason belongs until it is copied.
        unsafe {
            match count(ask(self.handle.raw(), &mut reason)) {
                Ok(dimension) if dimension > 0 => Estimate::Dimension(dimension),
                _ => Estimate::CannotTell(text(reason)),
            }
        }
    }

    fn numbers(&self, copy: Copy) -> Vec<f64> {
        // SAFETY: a live handle; no more numbers are written than there is place for.
        unsafe {
            let count = copy(self.handle.raw(), std::ptr::null_mut(), 0);
            let mut numbers = vec![0.0; count as usize];
            copy(self.handle.raw(), numbers.as_mut_ptr(), count);
            numbers
        }
    }
}
