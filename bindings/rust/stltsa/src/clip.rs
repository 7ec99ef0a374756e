// SPDX-License-Identifier: BSD-3-Clause
//! [`Clip`]: frames of one motion, with or without a skeleton.

use std::path::Path;

use stltsa_sys as sys;

use crate::array::{Matrix, View};
use crate::decomposition::Decomposition;
use crate::error::{c_path, check, count, owned_text, text, Result};
use crate::handle::Owned;
use crate::kinds::Format;
use crate::options::Options;

/// A motion-capture clip: BVH, ASF/AMC, plain numbers, or new motion made by the library.
///
/// Frames are counted from 0 in the source file. Lengths are in the file's unit.
#[derive(Debug)]
pub struct Clip {
    pub(crate) handle: Owned<sys::stltsa_clip>,
}

/// A joint or end site of a clip's skeleton.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Joint {
    /// Name in the file.
    pub name: String,
    /// Index of its parent; `None` for the root.
    pub parent: Option<usize>,
    /// Whether it ends a limb and so has no rotation.
    pub is_end_site: bool,
}

impl Clip {
    /// Reads a clip; the suffix determines the format, or else the content.
    ///
    /// ```no_run
    /// let clip = stltsa::Clip::open("walk.bvh")?;
    /// println!("{} frames of {} joints", clip.frames(), clip.joints()?.len());
    /// # Ok::<(), stltsa::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Io`](crate::ErrorKind::Io), [`Format`](crate::ErrorKind::Format) (the text has path and
    /// line), [`NotFinite`](crate::ErrorKind::NotFinite).
    pub fn open(path: impl AsRef<Path>) -> Result<Self> {
        Self::open_with(path, &Options::new())
    }

    /// The same with options. Used: fps, skeleton, progress.
    ///
    /// # Errors
    /// As [`Clip::open`]; [`Argument`](crate::ErrorKind::Argument),
    /// [`Cancelled`](crate::ErrorKind::Cancelled).
    pub fn open_with(path: impl AsRef<Path>, options: &Options) -> Result<Self> {
        let path = c_path(path.as_ref())?;
        options.call(|options| {
            // SAFETY: a string and a handle that live through the call.
            let open = |out| unsafe { sys::stltsa_clip_open(path.as_ptr(), options, out) };
            Ok(Self { handle: Owned::make(open)? })
        })
    }

    /// Reads a clip from memory; `format` `None`: determined by the content. Options used: fps,
    /// skeleton, progress.
    ///
    /// # Errors
    /// As [`Clip::open_with`].
    pub fn parse(bytes: &[u8], format: Option<Format>, options: &Options) -> Result<Self> {
        let (data, size) = (bytes.as_ptr().cast(), bytes.len());
        let format = format.map_or(0, Format::raw);
        options.call(|options| {
            // SAFETY: `size` bytes from `data` live through the call.
            let parse = |out| unsafe { sys::stltsa_clip_parse(data, size, format, options, out) };
            Ok(Self { handle: Owned::make(parse)? })
        })
    }

    /// A clip of plain features: one row per frame, `fps` (above 0) frames per second; copied.
    ///
    /// # Errors
    /// [`Shape`](crate::ErrorKind::Shape), [`NotFinite`](crate::ErrorKind::NotFinite),
    /// [`Argument`](crate::ErrorKind::Argument).
    pub fn from_matrix<'a>(frames: impl Into<View<'a>>, fps: f64) -> Result<Self> {
        let frames = frames.into().raw()?;
        // SAFETY: the array lives through the call.
        let make = |out| unsafe { sys::stltsa_clip_from_matrix(&frames, fps, out) };
        Ok(Self { handle: Owned::make(make)? })
    }

    /// Number of frames.
    pub fn frames(&self) -> usize {
        // SAFETY: a live handle.
        unsafe { sys::stltsa_clip_frames(self.raw()) as usize }
    }

    /// Frames per second; `None` if unknown.
    pub fn fps(&self) -> Option<f64> {
        // SAFETY: a live handle.
        let fps = unsafe { sys::stltsa_clip_fps(self.raw()) };
        (fps > 0.0).then_some(fps)
    }

    /// Source format of the clip.
    pub fn format(&self) -> Format {
        // SAFETY: a live handle.
        Format::from_raw(unsafe { sys::stltsa_clip_format(self.raw()) })
    }

    /// Number of values per frame in the file.
    pub fn channels(&self) -> usize {
        // SAFETY: a live handle.
        unsafe { sys::stltsa_clip_channels(self.raw()) as usize }
    }

    /// Number of joints and end sites; 0 for plain numbers.
    pub fn joint_count(&self) -> usize {
        // SAFETY: a live handle.
        unsafe { sys::stltsa_clip_joints(self.raw()) as usize }
    }

    /// Joints and end sites in file order, parents first; empty for plain numbers.
    ///
    /// # Errors
    /// None for a valid clip.
    pub fn joints(&self) -> Result<Vec<Joint>> {
        (0..self.joint_count()).map(|index| self.joint(index)).collect()
    }

    fn joint(&self, index: usize) -> Result<Joint> {
        let (mut name, mut parent, mut is_end_site) = (std::ptr::null(), -1, 0);
        // SAFETY: a live handle, to which the name belongs until it is copied.
        unsafe {
            check(sys::stltsa_clip_joint(
                self.raw(),
                index as i64,
                &mut name,
                &mut parent,
                &mut is_end_site,
            ))?;
            let parent = usize::try_from(parent).ok();
            Ok(Joint { name: text(name), parent, is_end_site: is_end_site != 0 })
        }
    }

    /// World positions from forward kinematics: frames x (3 * joints), x y z of joint 0, joint 1,
    /// ...
    ///
    /// # Errors
    /// [`Unsupported`](crate::ErrorKind::Unsupported) without a skeleton.
    pub fn positions(&self) -> Result<Matrix> {
        Matrix::filled(self.frames(), 3 * self.joint_count(), |out| {
            // SAFETY: a live handle, an array of the size it says.
            unsafe { sys::stltsa_clip_positions(self.raw(), out) }
        })
    }

    /// Local rotations as quaternions: frames x (4 * joints), w x y z, with signs continuous over
    /// time.
    ///
    /// # Errors
    /// [`Unsupported`](crate::ErrorKind::Unsupported) without a skeleton.
    pub fn rotations(&self) -> Result<Matrix> {
        Matrix::filled(self.frames(), 4 * self.joint_count(), |out| {
            // SAFETY: a live handle, an array of the size it says.
            unsafe { sys::stltsa_clip_rotations(self.raw(), out) }
        })
    }

    /// Features of every frame, unsmoothed: frames x features. Options used: features, up_axis.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument), [`Unsupported`](crate::ErrorKind::Unsupported) if
    /// the features need a skeleton and there is none.
    pub fn features(&self, options: &Options) -> Result<Matrix> {
        options.call(|options| {
            let mut features = 0;
            // SAFETY: live handles.
            check(unsafe { sys::stltsa_clip_feature_count(self.raw(), options, &mut features) })?;
            Matrix::filled(self.frames(), count(features)?, |out| {
                // SAFETY: live handles, an array of the size it says.
                unsafe { sys::stltsa_clip_features(self.raw(), options, out) }
            })
        })
    }

    /// One JSON object that describes the clip (schema: stltsa-clip/1).
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn json(&self) -> Result<String> {
        // SAFETY: a live handle.
        owned_text(|out| unsafe { sys::stltsa_clip_json(self.raw(), out) })
    }

    /// Writes the clip, completely or not at all. The suffix determines the format: `.bvh` (any
    /// skeleton), `.amc` (clips read from AMC; the ASF file does not change), `.csv`, `.npy` (the
    /// numbers of any clip). Numbers read back to the same bits.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) (other suffix),
    /// [`Unsupported`](crate::ErrorKind::Unsupported) (no skeleton, an unsuitable one, or no frame
    /// rate although the format needs one), [`Io`](crate::ErrorKind::Io).
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        let path = c_path(path.as_ref())?;
        // SAFETY: a live handle, and a string that lives through the call.
        check(unsafe { sys::stltsa_clip_save(self.raw(), path.as_ptr()) })
    }

    /// Cuts the clip into motion units and cycles (section 3.1 of the paper).
    ///
    /// A clip without trustworthy cycles is an answer, with a
    /// [reason](crate::Decomposition::reason), not an error. Options used: features, up_axis,
    /// keep_start, rate, smoothing, period_min, period_max, neighbors, window, dimension, mode,
    /// threads, progress.
    ///
    /// ```
    /// use stltsa::{Clip, Options, UnitKind};
    ///
    /// // Two seconds of standing, eight of swinging with a period of one second, then standing.
    /// let swing = |t: f64| match t {
    ///     t if (2.0..10.0).contains(&t) => (std::f64::consts::TAU * t).sin(),
    ///     _ => 0.0,
    /// };
    /// let frames: Vec<[f64; 2]> =
    ///     (0..360).map(|i| i as f64 / 30.0).map(|t| [swing(t), 0.5 * swing(t - 0.1)]).collect();
    /// let units = Clip::from_matrix(&frames, 30.0)?.decompose(&Options::new())?;
    ///
    /// assert!((units.info().period.unwrap() - 1.0).abs() < 0.05);
    /// for unit in units.units() {
    ///     println!("{} {:.2} s .. {:.2} s", unit.kind, unit.begin_s, unit.end_s);
    /// }
    /// assert!(units.units().iter().any(|unit| unit.kind == UnitKind::Cyclic));
    /// # Ok::<(), stltsa::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) for a clip of unknown frame rate (set option fps
    /// when opening it); others as [`Model::fit`](crate::Model::fit).
    pub fn decompose(&self, options: &Options) -> Result<Decomposition> {
        Decomposition::new(self, options)
    }

    pub(crate) fn raw(&self) -> *const sys::stltsa_clip {
        self.handle.raw()
    }
}
