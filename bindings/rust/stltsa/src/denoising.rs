// SPDX-License-Identifier: BSD-3-Clause
//! [`Denoising`]: coordinates without their noise (section 3.2 of the paper).

use stltsa_sys as sys;

use crate::array::{list_in, Matrix, View};
use crate::error::{count, owned_text, Result};
use crate::facts::Facts;
use crate::handle::Owned;
use crate::kinds::Fact;
use crate::model::{c_lengths, Model};
use crate::options::Options;

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
/// let cleaned = denoising.cleaned()?;
/// assert!(cleaned[(50, 0)] < points[50][0]);
/// # Ok::<(), stltsa::Error>(())
/// ```
#[derive(Debug)]
pub struct Denoising {
    pub(crate) handle: Owned<sys::stltsa_denoising>,
    columns: Vec<DenoisedColumn>,
    rows: usize,
}

/// Result for one column, over all clips.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct DenoisedColumn {
    /// Number of moved points.
    pub moved: usize,
    /// Threshold, in units of the coordinate.
    pub gamma: f64,
    /// Mean distance of the points beyond gamma from the curve (d_t).
    pub shift: f64,
    /// Robust standard deviation of the residuals.
    pub noise: f64,
    /// Effective degrees of freedom of the curve.
    pub degrees_of_freedom: f64,
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
        options.call(|options| {
            let lengths = list_in(&lengths)?;
            // SAFETY: arrays of the sizes they say, and a handle, live through the call.
            Self::made(|out| unsafe { sys::stltsa_denoise(&coords, &lengths, options, out) })
        })
    }

    /// Cleans the coordinates of a model, component by component, with the model's rate and period.
    /// Options used: gamma, knot_spacing, robust, progress.
    ///
    /// # Errors
    /// As [`Denoising::new`].
    pub fn of_model(model: &Model, options: &Options) -> Result<Self> {
        options.call(|options| {
            // SAFETY: live handles.
            Self::made(|out| unsafe { sys::stltsa_denoise_model(model.raw(), options, out) })
        })
    }

    /// Results by column.
    pub fn columns(&self) -> &[DenoisedColumn] {
        &self.columns
    }

    /// The fitted curve, rows x columns.
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn curve(&self) -> Result<Matrix> {
        // SAFETY: a live handle, an array of the size it says; as in the next two.
        self.filled(|out| unsafe { sys::stltsa_denoising_curve(self.raw(), out) })
    }

    /// The points after equation (1), rows x columns.
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn cleaned(&self) -> Result<Matrix> {
        self.filled(|out| unsafe { sys::stltsa_denoising_cleaned(self.raw(), out) })
    }

    /// Displacement of each point, rows x columns; 0 if it was not moved.
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn moves(&self) -> Result<Matrix> {
        self.filled(|out| unsafe { sys::stltsa_denoising_moves(self.raw(), out) })
    }

    /// One JSON object (schema: stltsa-denoising/1).
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn json(&self) -> Result<String> {
        // SAFETY: a live handle.
        owned_text(|out| unsafe { sys::stltsa_denoising_json(self.raw(), out) })
    }

    fn filled(&self, write: impl FnOnce(&sys::stltsa_out) -> sys::stltsa_status) -> Result<Matrix> {
        Matrix::filled(self.rows, self.columns.len(), write)
    }

    fn raw(&self) -> *const sys::stltsa_denoising {
        self.handle.raw()
    }

    fn made(
        make: impl FnOnce(*mut *mut sys::stltsa_denoising) -> sys::stltsa_status,
    ) -> Result<Self> {
        let handle = Owned::make(make)?;
        // SAFETY: a live handle.
        let facts = unsafe { Facts::new(sys::stltsa_denoising_info(handle.raw())) };
        let rows = count(facts.int(Fact::Rows, 0)?)?;
        let columns = 0..facts.int(Fact::Columns, 0)?;
        let columns = columns.map(|column| DenoisedColumn::of(&facts, column));
        Ok(Self { columns: columns.collect::<Result<_>>()?, rows, handle })
    }
}

impl DenoisedColumn {
    fn of(facts: &Facts, column: i64) -> Result<Self> {
        Ok(Self {
            moved: count(facts.int(Fact::Moved, column)?)?,
            gamma: facts.real(Fact::Gamma, column)?,
            shift: facts.real(Fact::Shift, column)?,
            noise: facts.real(Fact::Noise, column)?,
            degrees_of_freedom: facts.real(Fact::DegreesOfFreedom, column)?,
        })
    }
}
