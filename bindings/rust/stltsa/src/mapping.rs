// SPDX-License-Identifier: BSD-3-Clause
//! Mapping both ways between frames and curve (section 2.4 of the paper).

use stltsa_sys as sys;

use crate::array::{Matrix, View};
use crate::clip::Clip;
use crate::error::{c_count, check, count, Error, ErrorKind, Result};
use crate::handle::Owned;
use crate::model::Model;
use crate::options::Options;

/// New frames on the curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Mapped {
    /// rows x d.
    pub coords: Matrix,
    /// Distance of each row from the fitted frames over [`reach`](crate::ModelInfo::reach).
    /// Beyond 1 the frame is unlike what was learned, and its coordinates mean little.
    pub distance: Vec<f64>,
    /// Nearest model row of each row, whose component the coordinates belong to.
    pub nearest: Vec<usize>,
}

/// Frames of points of the curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Unmapped {
    /// rows x features of the model.
    pub frames: Matrix,
    /// Distance of each point from the curve, over what is common between neighboring rows of the
    /// model. Beyond 1 the frame is a guess.
    pub distance: Vec<f64>,
    /// Nearest model row of each point.
    pub nearest: Vec<usize>,
}

/// Poses of points of the curve.
#[derive(Debug)]
pub struct Poses {
    /// A pose for each point, with the skeleton that was fitted; at the rate of the option fps, else
    /// of the model's rows.
    pub clip: Clip,
    /// As in [`Unmapped`].
    pub distance: Vec<f64>,
    /// As in [`Unmapped`].
    pub nearest: Vec<usize>,
}

/// What every mapping says of each row.
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

/// Rows near which to look, as C takes them: a number for each row, -1 for everywhere.
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

fn pointer(hints: &Option<Vec<i64>>) -> *const i64 {
    hints.as_ref().map_or(std::ptr::null(), |hints| hints.as_ptr())
}

impl Model {
    /// Places new frames, rows x features of the model, on the curve. A frame that was fitted gets
    /// its own coordinates, to the bit; of equal frames that come back after others the first's,
    /// unless a hint says which is meant ([`Model::map_near`]). Options used: map_neighbors,
    /// map_blend, threads, progress.
    ///
    /// # Errors
    /// [`Shape`](ErrorKind::Shape), [`NotFinite`](ErrorKind::NotFinite),
    /// [`Argument`](ErrorKind::Argument), [`Unsupported`](ErrorKind::Unsupported) (the model kept no
    /// frames), [`Cancelled`](ErrorKind::Cancelled).
    pub fn map<'a>(&self, frames: impl Into<View<'a>>, options: &Options) -> Result<Mapped> {
        self.map_rows(frames.into(), None, options)
    }

    /// The same, each row being looked for near a model row (within option hint_window of the same
    /// clip), `None`: everywhere. For a stream: the nearest row of the frame before, plus a small
    /// hint_window, so that time never runs back.
    ///
    /// # Errors
    /// As [`Model::map`]; [`Shape`](ErrorKind::Shape) unless there is a hint for each row.
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
        self.mapped(frames.rows(), options, |options, coords, distance, nearest| {
            let hints = pointer(&hints);
            // SAFETY: live handles, and arrays of as many rows as `raw` says.
            unsafe { sys::stltsa_map(self.raw(), &raw, hints, options, coords, distance, nearest) }
        })
    }

    /// Places every frame of a clip on the curve; features, up axis and smoothing are the model's.
    /// The model was fitted to a clip. Options used: map_neighbors, map_blend, threads, progress.
    ///
    /// # Errors
    /// As [`Model::map`]; [`Shape`](ErrorKind::Shape) where the two have other features.
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
            *mut i64,
        ) -> sys::stltsa_status,
    ) -> Result<Mapped> {
        let (mut coords, mut place) =
            (Matrix::zeros(rows, self.info().dimension)?, Place::of(rows)?);
        options.call(|options| {
            let (coords, distance) = (coords.raw_out()?, place.distance.raw_out()?);
            check(map(options, &coords, &distance, place.nearest.as_mut_ptr()))
        })?;
        let (distance, nearest) = place.into_parts()?;
        Ok(Mapped { coords, distance, nearest })
    }

    /// The way back: frames from points of the curve, rows x d.
    ///
    /// One coordinate alone cannot tell a swing to from the swing fro: give hints
    /// ([`Model::unmap_near`]), or fit more. For a model of a clip with a skeleton, frames are the
    /// features of the poses of [`Model::unmap_clip`]. Options used: map_neighbors, map_blend,
    /// component, threads, progress.
    ///
    /// # Errors
    /// As [`Model::map`]; [`Disconnected`](ErrorKind::Disconnected): the model has several
    /// components, and the option component does not say which.
    pub fn unmap<'a>(&self, coords: impl Into<View<'a>>, options: &Options) -> Result<Unmapped> {
        self.unmap_rows(coords.into(), None, options)
    }

    /// The same, each point being looked for near a model row; hints as in [`Model::map_near`].
    ///
    /// # Errors
    /// As [`Model::unmap`]; [`Shape`](ErrorKind::Shape) unless there is a hint for each row.
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
        let (mut frames, mut place) =
            (Matrix::zeros(rows, self.info().features)?, Place::of(rows)?);
        options.call(|options| {
            let (frames, distance) = (frames.raw_out()?, place.distance.raw_out()?);
            let (hints, nearest) = (pointer(&hints), place.nearest.as_mut_ptr());
            // SAFETY: live handles, and arrays of as many rows as `raw` says.
            check(unsafe {
                sys::stltsa_unmap(self.raw(), &raw, hints, options, &frames, &distance, nearest)
            })
        })?;
        let (distance, nearest) = place.into_parts()?;
        Ok(Unmapped { frames, distance, nearest })
    }

    /// Poses from points of the curve, rows x d: rotations of all joints, height and tilt; the body
    /// stays over the origin and faces one way. Options used: as [`Model::unmap`], and fps, points
    /// a second: of what [`Model::map_clip`] gave, the clip's; else that of the model's rows.
    ///
    /// # Errors
    /// As [`Model::unmap`]; [`Unsupported`](ErrorKind::Unsupported) for a model of bare numbers.
    pub fn unmap_clip<'a>(&self, coords: impl Into<View<'a>>, options: &Options) -> Result<Poses> {
        self.unmap_poses(coords.into(), None, options)
    }

    /// The same, each point being looked for near a model row; hints as in [`Model::map_near`].
    ///
    /// # Errors
    /// As [`Model::unmap_clip`]; [`Shape`](ErrorKind::Shape) unless there is a hint for each row.
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
        let mut place = Place::of(coords.rows())?;
        let handle = options.call(|options| {
            let distance = place.distance.raw_out()?;
            let (hints, nearest) = (pointer(&hints), place.nearest.as_mut_ptr());
            // SAFETY: live handles, and arrays of as many rows as `raw` says.
            Owned::make(|out| unsafe {
                sys::stltsa_unmap_clip(self.raw(), &raw, hints, options, &distance, nearest, out)
            })
        })?;
        let (distance, nearest) = place.into_parts()?;
        Ok(Poses { clip: Clip { handle }, distance, nearest })
    }
}
