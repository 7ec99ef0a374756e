// SPDX-License-Identifier: BSD-3-Clause
//! [`Denoising`]: coordinates without their noise (section 3.2 of the paper).

use stltsa_sys as sys;

use crate::array::{list_in, Matrix, View};
use crate::error::Result;
use crate::handle::Owned;
use crate::kinds::Fact;
use crate::model::{c_lengths, Model};
use crate::options::Options;
use crate::rows::DenoisedColumn;

/// Cleaned coordinates: a smooth curve, and the points after equation (1).
///
/// Find extrema and margins on the curve, never on the moved points.
///
/// ```
/// use stltsa::{Denoising, Options};
///
/// // A swing with a spike.
/// let mut points: Vec<[f64; 1]> = (0..200).map(|t| [(t as f64 / 10.0).sin()]).collect();
/// points[50][0] += 5.0;
/// let denoising = Denoising::new(&points, &Options::new())?;
/// let cleaned = denoising.cleaned();
/// assert!(cleaned[(50, 0)] < points[50][0]);
/// # Ok::<(), stltsa::Error>(())
/// ```
#[derive(Debug)]
pub struct Denoising {
    pub(crate) handle: Owned<sys::stltsa_denoising>,
}

impl Denoising {
    /// Cleans coordinates, rows x columns of one clip, each column separately: a penalized spline
    /// over time with smoothing chosen by generalized cross-validation. Options used: gamma,
    /// knot_spacing, robust, fps, period_min, period_max, progress.
    ///
    /// # Errors
    /// [`Shape`](crate::ErrorKind::Shape), [`NotFinite`](crate::ErrorKind::NotFinite),
    /// [`TooFewFrames`](crate::ErrorKind::TooFewFrames) (fewer than 8 rows),
    /// [`Argument`](crate::ErrorKind::Argument), [`Cancelled`](crate::ErrorKind::Cancelled).
    pub fn new<'a>(coords: impl Into<View<'a>>, options: &Options) -> Result<Self> {
        let coords = coords.into();
        Self::new_several(coords, &[coords.rows()], options)
    }

    /// The same for several clips, one after another in `coords`, with their numbers of rows in
    /// `lengths`. Each clip has its own spline.
    ///
    /// # Errors
    /// As [`Denoising::new`]; [`Shape`](crate::ErrorKind::Shape) unless `lengths` sum to the rows.
    pub fn new_several<'a>(
        coords: impl Into<View<'a>>,
        lengths: &[usize],
        options: &Options,
    ) -> Result<Self> {
        let (coords, lengths) = (coords.into().raw()?, c_lengths(lengths)?);
        let lengths = list_in(&lengths)?;
        let handle = options.make(|options, out| {
            // SAFETY: arrays of the sizes they say, and a handle, live through the call.
            unsafe { sys::stltsa_denoise(&coords, &lengths, options, out) }
        })?;
        Ok(Self { handle })
    }

    /// Cleans the coordinates of a model, component by component, with the model's rate and period.
    /// Options used: gamma, knot_spacing, robust, progress.
    ///
    /// # Errors
    /// As [`Denoising::new`].
    pub fn of_model(model: &Model, options: &Options) -> Result<Self> {
        let handle = options.make(|options, out| {
            // SAFETY: live handles.
            unsafe { sys::stltsa_denoise_model(model.raw(), options, out) }
        })?;
        Ok(Self { handle })
    }

    /// Results by column, over all clips.
    pub fn columns(&self) -> Vec<DenoisedColumn> {
        self.info().list(Fact::Column)
    }

    /// The fitted curve, rows x columns.
    pub fn curve(&self) -> Matrix {
        self.info().matrix(Fact::Curve)
    }

    /// The points after equation (1), rows x columns.
    pub fn cleaned(&self) -> Matrix {
        self.info().matrix(Fact::Cleaned)
    }

    /// Displacement of each point, rows x columns; 0 if it was not moved.
    pub fn moves(&self) -> Matrix {
        self.info().matrix(Fact::Moves)
    }
}
