// SPDX-License-Identifier: BSD-3-Clause
//! Mapping both ways between frames and curve (section 2.4 of the paper).

use stltsa_sys as sys;

use crate::array::{list_in, list_out, Matrix, View};
use crate::clip::Clip;
use crate::error::{c_count, check, count, Error, ErrorKind, Result};
use crate::handle::Owned;
use crate::model::Model;
use crate::options::Options;

/// New frames mapped onto the curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Mapped {
    /// rows x d.
    pub coords: Matrix,
    /// Distance of each row from the fitted frames over [`reach`](crate::ModelInfo::reach). Beyond
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

/// Per-row results of every mapping.
struct Place {
    distance: Matrix,
    nearest: Vec<i64>,
}

impl Place {
    fn of(rows: usize) -> Result<Self> {
        Ok(Self { distance: Matrix::zeros(rows, 1)?, nearest: vec![0; rows] })
    }

    fn into_parts(self) -> Result<(Vec<f64>, Vec<usize>)> {
        let nearest = self.nearest.into_iter().map(count).collect::<Result<_>>()?;
        Ok((self.distance.into_vec(), nearest))
    }
}

/// Hints as C expects them: a row number for each row, -1 for everywhere.
fn c_hints(hints: Option<&[Option<usize>]>, rows: usize) -> Result<Option<Vec<i64>>> {
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

/// Null for none.
fn pointer(hints: &Option<sys::stltsa_in>) -> *const sys::stltsa_in {
    hints.as_ref().map_or(std::ptr::null(), |hints| hints)
}

impl Model {
    /// Maps new frames, rows x features of the model, onto the curve. A fitted frame gets its own
    /// coordinates, to the bit. If equal frames occur more than once, they get the coordinates of
    /// the first, unless a hint selects another ([`Model::map_near`]). Options used: map_neighbors,
    /// map_blend, threads, progress.
    ///
    /// # Errors
    /// [`Shape`](ErrorKind::Shape), [`NotFinite`](ErrorKind::NotFinite),
    /// [`Argument`](ErrorKind::Argument), [`Unsupported`](ErrorKind::Unsupported) (the model kept no
    /// frames), [`Cancelled`](ErrorKind::Cancelled).
    pub fn map<'a>(&self, frames: impl Into<View<'a>>, options: &Options) -> Result<Mapped> {
        self.map_rows(frames.into(), None, options)
    }

    /// The same, searching for each row near a model row (within option hint_window of the same
    /// clip), or everywhere for `None`. For a stream, pass the nearest row of the previous frame
    /// and a small hint_window, so that time never runs back.
    ///
    /// # Errors
    /// As [`Model::map`]; [`Shape`](ErrorKind::Shape) unless there is one hint per row.
    pub fn map_near<'a>(
        &self,
        frames: impl Into<View<'a>>,
        hints: &[Option<usize>],
        options: &Options,
    ) -> Result<Mapped> {
        self.map_rows(frames.into(), Some(hints), options)
    }

    fn map_rows(
        &self,
        frames: View<'_>,
        hints: Option<&[Option<usize>]>,
        options: &Options,
    ) -> Result<Mapped> {
        let (raw, hints) = (frames.raw()?, c_hints(hints, frames.rows())?);
        let hints = hints.as_deref().map(list_in).transpose()?;
        self.mapped(frames.rows(), options, |options, coords, distance, nearest| {
            let hints = pointer(&hints);
            // SAFETY: live handles, and arrays of as many rows as `raw` says.
            unsafe { sys::stltsa_map(self.raw(), &raw, hints, options, coords, distance, nearest) }
        })
    }

    /// Maps every frame of a clip onto the curve of a model that was fitted to a clip, with the
    /// model's features, up axis and smoothing. Options used: map_neighbors, map_blend, threads,
    /// progress.
    ///
    /// # Errors
    /// As [`Model::map`]; [`Shape`](ErrorKind::Shape) if the features differ.
    pub fn map_clip(&self, clip: &Clip, options: &Options) -> Result<Mapped> {
        self.mapped(clip.frames(), options, |options, coords, distance, nearest| {
            // SAFETY: live handles, and arrays of as many rows as the clip has frames.
            unsafe {
                sys::stltsa_map_clip(self.raw(), clip.raw(), options, coords, distance, nearest)
            }
        })
    }

    fn mapped(
        &self,
        rows: usize,
        options: &Options,
        map: impl FnOnce(
            *const sys::stltsa_options,
            &sys::stltsa_out,
            &sys::stltsa_out,
            &sys::stltsa_out,
        ) -> sys::stltsa_status,
    ) -> Result<Mapped> {
        let (mut coords, mut place) =
            (Matrix::zeros(rows, self.info().dimension)?, Place::of(rows)?);
        options.call(|options| {
            let (coords, distance) = (coords.raw_out()?, place.distance.raw_out()?);
            check(map(options, &coords, &distance, &list_out(&mut place.nearest)?))
        })?;
        let (distance, nearest) = place.into_parts()?;
        Ok(Mapped { coords, distance, nearest })
    }

    /// Maps coordinates, rows x d, back to frames.
    ///
    /// One coordinate cannot distinguish the forward from the backward swing: pass hints
    /// ([`Model::unmap_near`]), or fit more dimensions. For a model of a clip with a skeleton,
    /// frames are the features of the poses of [`Model::unmap_clip`]. Options used: map_neighbors,
    /// map_blend, component, threads, progress.
    ///
    /// # Errors
    /// As [`Model::map`]; [`Disconnected`](ErrorKind::Disconnected): the model has several
    /// components, and the option component is missing.
    pub fn unmap<'a>(&self, coords: impl Into<View<'a>>, options: &Options) -> Result<Unmapped> {
        self.unmap_rows(coords.into(), None, options)
    }

    /// The same, searching for each point near a model row; hints as in [`Model::map_near`].
    ///
    /// # Errors
    /// As [`Model::unmap`]; [`Shape`](ErrorKind::Shape) unless there is one hint per row.
    pub fn unmap_near<'a>(
        &self,
        coords: impl Into<View<'a>>,
        hints: &[Option<usize>],
        options: &Options,
    ) -> Result<Unmapped> {
        self.unmap_rows(coords.into(), Some(hints), options)
    }

    fn unmap_rows(
        &self,
        coords: View<'_>,
        hints: Option<&[Option<usize>]>,
        options: &Options,
    ) -> Result<Unmapped> {
        let rows = coords.rows();
        let (raw, hints) = (coords.raw()?, c_hints(hints, rows)?);
        let hints = hints.as_deref().map(list_in).transpose()?;
        let (mut frames, mut place) =
            (Matrix::zeros(rows, self.info().features)?, Place::of(rows)?);
        options.call(|options| {
            let (frames, distance) = (frames.raw_out()?, place.distance.raw_out()?);
            let (hints, nearest) = (pointer(&hints), list_out(&mut place.nearest)?);
            // SAFETY: live handles, and arrays of as many rows as `raw` says.
            check(unsafe {
                sys::stltsa_unmap(self.raw(), &raw, hints, options, &frames, &distance, &nearest)
            })
        })?;
        let (distance, nearest) = place.into_parts()?;
        Ok(Unmapped { frames, distance, nearest })
    }

    /// Maps coordinates, rows x d, back to poses: rotations of all joints, height and tilt; the
    /// body stays over the origin with a fixed heading. Options used: as [`Model::unmap`], and fps,
    /// the number of points per second: for the result of [`Model::map_clip`] the clip's rate;
    /// default: that of the model's rows.
    ///
    /// # Errors
    /// As [`Model::unmap`]; [`Unsupported`](ErrorKind::Unsupported) for a model of plain numbers.
    pub fn unmap_clip<'a>(&self, coords: impl Into<View<'a>>, options: &Options) -> Result<Poses> {
        self.unmap_poses(coords.into(), None, options)
    }

    /// The same, searching for each point near a model row; hints as in [`Model::map_near`].
    ///
    /// # Errors
    /// As [`Model::unmap_clip`]; [`Shape`](ErrorKind::Shape) unless there is one hint per row.
    pub fn unmap_clip_near<'a>(
        &self,
        coords: impl Into<View<'a>>,
        hints: &[Option<usize>],
        options: &Options,
    ) -> Result<Poses> {
        self.unmap_poses(coords.into(), Some(hints), options)
    }

    fn unmap_poses(
        &self,
        coords: View<'_>,
        hints: Option<&[Option<usize>]>,
        options: &Options,
    ) -> Result<Poses> {
        let (raw, hints) = (coords.raw()?, c_hints(hints, coords.rows())?);
        let hints = hints.as_deref().map(list_in).transpose()?;
        let mut place = Place::of(coords.rows())?;
        let handle = options.call(|options| {
            let distance = place.distance.raw_out()?;
            let (hints, nearest) = (pointer(&hints), list_out(&mut place.nearest)?);
            // SAFETY: live handles, and arrays of as many rows as `raw` says.
            Owned::make(|out| unsafe {
                sys::stltsa_unmap_clip(self.raw(), &raw, hints, options, &distance, &nearest, out)
            })
        })?;
        let (distance, nearest) = place.into_parts()?;
        Ok(Poses { clip: Clip { handle }, distance, nearest })
    }
}
