// SPDX-License-Identifier: BSD-3-Clause
//! Mapping both ways between frames and curve (section 2.4 of the paper).

use stltsa_sys as sys;

use crate::array::{list_in, list_out, Matrix, View};
use crate::clip::Clip;
use crate::error::{c_count, check, count, Error, ErrorKind, Result};
use crate::kinds::Fact;
use crate::model::Model;
use crate::options::Options;

/// New frames mapped onto the curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Mapped {
    /// rows x d.
    pub coords: Matrix,
    /// Distance of each row from the fitted frames over [`Fact::Reach`]. Beyond
    /// 1 the frame is unlike the fitted ones and its coordinates are unreliable.
    pub distance: Vec<f64>,
    /// Nearest model row of each row, whose component gives the coordinates.
    pub nearest: Vec<usize>,
}

/// Frames mapped back from coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct Unmapped {
    /// rows x features of the model.
    pub frames: Matrix,
    /// Distance of each point from the curve, relative to the typical distance between neighboring
    /// rows of the model. Beyond 1 the frame is a guess.
    pub distance: Vec<f64>,
    /// Nearest model row of each point.
    pub nearest: Vec<usize>,
}

/// Poses mapped back from coordinates.
#[derive(Debug)]
pub struct Poses {
    /// One pose for each point, with the model's skeleton, at the rate of the option fps, or else
    /// of the model's rows.
    pub clip: Clip,
    /// As in [`Unmapped`].
    pub distance: Vec<f64>,
    /// As in [`Unmapped`].
    pub nearest: Vec<usize>,
}

/// What every mapping gives for its rows: numbers, distance, nearest.
type Rows = (Matrix, Vec<f64>, Vec<usize>);

/// For each row the model row near which it is searched, or `None` for everywhere.
pub type Hints<'a> = &'a [Option<usize>];

/// Hints as C expects them: a row number for each row, -1 for everywhere.
fn c_hints(hints: Option<Hints<'_>>, rows: usize) -> Result<Option<Vec<i64>>> {
    let of_row = |hint: &Option<usize>| hint.map_or(Ok(-1), c_count);
    match hints {
        Some(hints) if hints.len() != rows => Err(Error::new(
            ErrorKind::Shape,
            format!("there are {} hints for {rows} rows", hints.len()),
        )),
        Some(hints) => hints.iter().map(of_row).collect::<Result<_>>().map(Some),
        None => Ok(None),
    }
}

/// `stltsa_map` and `stltsa_unmap`.
type Map = unsafe extern "C" fn(
    *const sys::stltsa_model,
    *const sys::stltsa_in,
    *const sys::stltsa_in,
    *const sys::stltsa_options,
    *const sys::stltsa_out,
    *const sys::stltsa_out,
    *const sys::stltsa_out,
) -> sys::stltsa_status;

/// Lets `map` fill the results of so many rows, each of so many numbers.
fn filled(
    (rows, cols): (usize, usize),
    map: impl FnOnce(&sys::stltsa_out, &sys::stltsa_out, &sys::stltsa_out) -> Result<()>,
) -> Result<Rows> {
    let (mut numbers, mut distance) = (Matrix::zeros(rows, cols)?, Matrix::zeros(rows, 1)?);
    let mut nearest = vec![0; rows];
    map(&numbers.raw_out()?, &distance.raw_out()?, &list_out(&mut nearest)?)?;
    Ok((numbers, distance.into_vec(), nearest.into_iter().map(count).collect()))
}

impl Model {
    /// Maps new frames, rows x features of the model, onto the curve. A fitted frame gets its own
    /// coordinates, to the bit. If equal frames occur more than once, they get the coordinates of
    /// the first, unless a hint selects another: each row is searched near its hint (within option
    /// hint_window of the same clip). For a stream, pass the nearest row of the previous frame and a
    /// small hint_window, so that time never runs back. Options used: map_neighbors, map_blend,
    /// hint_window, threads, progress.
    ///
    /// # Errors
    /// [`Shape`](ErrorKind::Shape) (also unless there is one hint per row),
    /// [`NotFinite`](ErrorKind::NotFinite), [`Argument`](ErrorKind::Argument),
    /// [`Unsupported`](ErrorKind::Unsupported) (the model kept no frames),
    /// [`Cancelled`](ErrorKind::Cancelled).
    pub fn map<'a>(
        &self,
        frames: impl Into<View<'a>>,
        hints: Option<Hints<'_>>,
        options: &Options,
    ) -> Result<Mapped> {
        let (coords, distance, nearest) =
            self.rows(sys::stltsa_map, Fact::Dimension, frames.into(), hints, options)?;
        Ok(Mapped { coords, distance, nearest })
    }

    /// Maps every frame of a clip onto the curve of a model that was fitted to a clip, with the
    /// model's features, up axis and smoothing. Options used: map_neighbors, map_blend, threads,
    /// progress.
    ///
    /// # Errors
    /// As [`Model::map`]; [`Shape`](ErrorKind::Shape) if the features differ.
    pub fn map_clip(&self, clip: &Clip, options: &Options) -> Result<Mapped> {
        let shape = (clip.frames(), count(self.info().int(Fact::Dimension)?));
        let (model, clip) = (self.raw(), clip.raw());
        let (coords, distance, nearest) = filled(shape, |coords, distance, nearest| {
            options.call(|options| {
                // SAFETY: live handles, and arrays of as many rows as the clip has frames.
                check(unsafe {
                    sys::stltsa_map_clip(model, clip, options, coords, distance, nearest)
                })
            })
        })?;
        Ok(Mapped { coords, distance, nearest })
    }

    /// Maps coordinates, rows x d, back to frames; hints as in [`Model::map`].
    ///
    /// One coordinate cannot distinguish the forward from the backward swing: pass hints, or fit
    /// more dimensions. For a model of a clip with a skeleton, frames are the features of the poses
    /// of [`Model::unmap_clip`]. Options used: as [`Model::map`], and component.
    ///
    /// # Errors
    /// As [`Model::map`]; [`Disconnected`](ErrorKind::Disconnected): the model has several
    /// components, and the option component is missing.
    pub fn unmap<'a>(
        &self,
        coords: impl Into<View<'a>>,
        hints: Option<Hints<'_>>,
        options: &Options,
    ) -> Result<Unmapped> {
        let (frames, distance, nearest) =
            self.rows(sys::stltsa_unmap, Fact::FeatureCount, coords.into(), hints, options)?;
        Ok(Unmapped { frames, distance, nearest })
    }

    /// Maps coordinates, rows x d, back to poses: rotations of all joints, height and tilt; the
    /// body stays over the origin with a fixed heading. Options used: as [`Model::unmap`], and fps,
    /// the number of points per second: for the result of [`Model::map_clip`] the clip's rate;
    /// default: that of the model's rows.
    ///
    /// # Errors
    /// As [`Model::unmap`]; [`Unsupported`](ErrorKind::Unsupported) for a model of plain numbers.
    pub fn unmap_clip<'a>(
        &self,
        coords: impl Into<View<'a>>,
        hints: Option<Hints<'_>>,
        options: &Options,
    ) -> Result<Poses> {
        let coords = coords.into();
        let (raw, hints) = (coords.raw()?, c_hints(hints, coords.rows())?);
        let hints = hints.as_deref().map(list_in).transpose()?;
        let hints = hints.as_ref().map_or(std::ptr::null(), |hints| hints);
        let mut made = None;
        let (_, distance, nearest) = filled((coords.rows(), 0), |_, distance, nearest| {
            made = Some(options.make(|options, out| {
                // SAFETY: live handles, and arrays of as many rows as `raw` says.
                unsafe {
                    sys::stltsa_unmap_clip(self.raw(), &raw, hints, options, distance, nearest, out)
                }
            })?);
            Ok(())
        })?;
        let handle = made.expect("it was filled");
        Ok(Poses { clip: Clip { handle }, distance, nearest })
    }

    /// `columns`: the number of columns that the map makes.
    fn rows(
        &self,
        map: Map,
        columns: Fact,
        rows: View<'_>,
        hints: Option<Hints<'_>>,
        options: &Options,
    ) -> Result<Rows> {
        let (raw, hints) = (rows.raw()?, c_hints(hints, rows.rows())?);
        let hints = hints.as_deref().map(list_in).transpose()?;
        let hints = hints.as_ref().map_or(std::ptr::null(), |hints| hints);
        let shape = (rows.rows(), count(self.info().int(columns)?));
        filled(shape, |numbers, distance, nearest| {
            options.call(|options| {
                // SAFETY: live handles, and arrays of as many rows as `raw` says.
                check(unsafe { map(self.raw(), &raw, hints, options, numbers, distance, nearest) })
            })
        })
    }
}
