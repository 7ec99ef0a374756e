// SPDX-License-Identifier: BSD-3-Clause
//! [`Clip`]: frames of one motion, with or without a skeleton.

use std::ops::Range;
use std::path::Path;

use stltsa_sys as sys;

use crate::array::{Matrix, View};
use crate::decomposition::Decomposition;
use crate::error::{c_name, c_optional, c_path, check, count, got, pointer};
use crate::error::{Error, ErrorKind, Result};
use crate::handle::Owned;
use crate::kinds::{Fact, Format};
use crate::options::Options;
use crate::rows::{FileEvent, Joint};

/// A motion-capture clip: BVH, ASF/AMC, plain numbers, or new motion made by the library.
///
/// Frames are counted from 0 in the source file. Lengths are in the file's unit.
#[derive(Debug)]
pub struct Clip {
    pub(crate) handle: Owned<sys::stltsa_clip>,
}

/// Local rotations of a skeleton, a row for each frame.
#[derive(Clone, Copy, Debug)]
pub enum Rotations<'a> {
    /// 4 columns a joint: w x y z, child axes to parent axes.
    Quaternions(View<'a>),
    /// 9 columns a joint: the rows of its rotation matrix.
    Matrices(View<'a>),
    /// A column for each channel of each joint.
    Channels(View<'a>),
}

impl<'a> Rotations<'a> {
    /// The value of `STLTSA_ROTATIONS_*`, and the numbers.
    pub(crate) fn parts(self) -> (i32, View<'a>) {
        match self {
            Rotations::Quaternions(view) => (sys::STLTSA_ROTATIONS_QUATERNION, view),
            Rotations::Matrices(view) => (sys::STLTSA_ROTATIONS_MATRIX, view),
            Rotations::Channels(view) => (sys::STLTSA_ROTATIONS_CHANNELS, view),
        }
    }
}

/// Points in space or in a plane, such as markers: see [`Clip::from_points`].
#[derive(Clone, Copy, Debug)]
pub struct Points<'a> {
    /// frames x (space * points): x y z of point 0, point 1, ...; NaN is a missing point.
    pub positions: View<'a>,
    /// Coordinates of a point: 2 or 3.
    pub space: usize,
    /// One for each point, or none.
    pub names: &'a [&'a str],
    /// frames x points; 0: missing.
    pub confidence: Option<View<'a>>,
    /// frames x 1, seconds, increasing.
    pub times: Option<View<'a>>,
    /// Frames per second; `None`: given by the times.
    pub fps: Option<f64>,
}

fn optional(view: Option<View<'_>>) -> Result<sys::stltsa_in> {
    match view {
        Some(view) => view.raw(),
        None => View::new::<f64>(&[], 0, 0)?
            .raw()
            .map(|none| sys::stltsa_in { data: std::ptr::null(), ..none }),
    }
}

impl Clip {
    /// Reads a clip; the suffix determines the format, or else the content. A [stretch](Clip::stretch)
    /// may follow the path: `"walk.bvh:cyclic"`.
    ///
    /// ```no_run
    /// let clip = stltsa::Clip::open("walk.bvh")?;
    /// println!("{} frames of {} joints", clip.frames(), clip.joints().len());
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
        let handle = options.make(|options, out| {
            // SAFETY: a string and a handle that live through the call.
            unsafe { sys::stltsa_clip_open_stretch(path.as_ptr(), options, out) }
        })?;
        Ok(Self { handle })
    }

    /// Reads a clip from memory; `format` `None`: determined by the content. Options used: fps,
    /// skeleton, progress.
    ///
    /// # Errors
    /// As [`Clip::open_with`].
    pub fn parse(bytes: &[u8], format: Option<Format>, options: &Options) -> Result<Self> {
        let (data, size) = (bytes.as_ptr().cast(), bytes.len());
        let format = format.map_or(0, Format::raw);
        let handle = options.make(|options, out| {
            let name = std::ptr::null();
            // SAFETY: `size` bytes from `data` live through the call.
            unsafe { sys::stltsa_clip_parse(data, size, format, name, options, out) }
        })?;
        Ok(Self { handle })
    }

    /// A clip of plain features: one row per frame, `fps` (1e-9 to 1e6) frames per second; copied.
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

    /// A clip of points, which are copied. Frames at uneven times are resampled to the rate of the
    /// median step, which a note says. Option used: min_confidence.
    ///
    /// # Errors
    /// [`Shape`](crate::ErrorKind::Shape), [`Argument`](crate::ErrorKind::Argument) (times that do
    /// not increase, no rate), [`Format`](crate::ErrorKind::Format) (most frames are missing),
    /// [`NotFinite`](crate::ErrorKind::NotFinite).
    pub fn from_points(points: &Points<'_>, options: &Options) -> Result<Self> {
        let names = points.names.iter().map(|name| c_name(name)).collect::<Result<Vec<_>>>()?;
        let names: Vec<_> = names.iter().map(|name| name.as_ptr()).collect();
        if !names.is_empty() && names.len() * points.space != points.positions.cols() {
            let text = format!("{} names for {} columns", names.len(), points.positions.cols());
            return Err(Error::new(ErrorKind::Shape, text));
        }
        let given = sys::stltsa_points {
            size: std::mem::size_of::<sys::stltsa_points>(),
            space: i32::try_from(points.space).unwrap_or(0),
            reserved: 0,
            positions: points.positions.raw()?,
            names: if names.is_empty() { std::ptr::null() } else { names.as_ptr() },
            confidence: optional(points.confidence)?,
            times: optional(points.times)?,
            fps: points.fps.unwrap_or(0.0),
        };
        let handle = options.make(|options, out| {
            // SAFETY: arrays and names live through the call; there is a name for each point.
            unsafe { sys::stltsa_clip_from_points(&given, options, out) }
        })?;
        Ok(Self { handle })
    }

    /// A clip of a skeleton: its joints, their rotations, and the positions of the root (frames x
    /// 3; `None`: it stays at its offset, or the channels say where it is). All is copied.
    ///
    /// # Errors
    /// [`Shape`](crate::ErrorKind::Shape), [`Argument`](crate::ErrorKind::Argument) (a parent
    /// after its child, unknown channels, no rotation),
    /// [`NotFinite`](crate::ErrorKind::NotFinite).
    pub fn from_skeleton(
        joints: &[Joint],
        rotations: Rotations<'_>,
        root_positions: Option<View<'_>>,
        fps: f64,
    ) -> Result<Self> {
        let names = joints.iter().map(|joint| c_name(&joint.name)).collect::<Result<Vec<_>>>()?;
        let channels = joints
            .iter()
            .map(|joint| c_optional(joint.channels.as_deref()))
            .collect::<Result<Vec<_>>>()?;
        let list: Vec<_> = (0..joints.len())
            .map(|j| sys::stltsa_joint {
                name: names[j].as_ptr(),
                parent: joints[j].parent.map_or(-1, |parent| parent as i64),
                offset: joints[j].offset,
                channels: pointer(&channels[j]),
                is_end_site: joints[j].is_end_site.into(),
            })
            .collect();
        let (form, frames) = rotations.parts();
        let (frames, root) = (frames.raw()?, optional(root_positions)?);
        let (data, count) = (list.as_ptr(), list.len() as i64);
        let size = std::mem::size_of::<sys::stltsa_joint>();
        // SAFETY: `count` joints from `data`, their texts and the arrays live through the call.
        let make = |out| unsafe {
            sys::stltsa_clip_from_skeleton(data, size, count, form, &frames, &root, fps, out)
        };
        Ok(Self { handle: Owned::make(make)? })
    }

    /// A stretch of the clip, whose frames count from 0 again: `"300-900"` (frames), `"2.5s-9s"`,
    /// `"cyclic"` and other kinds of units (the longest), `"cycle3"`, `"segment2"`,
    /// `"repetition1"` (counted from 1), `"best"`, `"representative"`, or a label such as `"A"`
    /// (all its segments, in order). A path may end in the same: `Clip::open("walk.bvh:cyclic")`.
    /// Options as for [`Clip::decompose`].
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) for another text,
    /// [`NoSuchPart`](crate::ErrorKind::NoSuchPart) if the clip lacks it.
    pub fn stretch(&self, what: &str, options: &Options) -> Result<Self> {
        let what = c_name(what)?;
        let handle = options.make(|options, out| {
            // SAFETY: a live handle, and a string that lives through the call.
            unsafe { sys::stltsa_clip_stretch(self.raw(), what.as_ptr(), options, out) }
        })?;
        Ok(Self { handle })
    }

    /// Sets the path that messages and results give for a clip made from arrays.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) if the path contains a NUL.
    pub fn set_path(&mut self, path: &str) -> Result<()> {
        let path = c_name(path)?;
        // SAFETY: a live handle that nothing else uses, and a string that lives through the call.
        check(unsafe { sys::stltsa_clip_set_path(self.handle.raw_mut(), path.as_ptr()) })
    }

    /// The mirror image: what the left side did, the right one does. Joints or points whose names
    /// differ in the side only change places. Events that are marked on one side are found on the
    /// other in the [`Phase`](crate::Phase) of the mirror image.
    ///
    /// # Errors
    /// [`Unsupported`](ErrorKind::Unsupported) if no two names differ in the side only, if the sides
    /// of the skeleton differ, and for a matrix.
    pub fn mirrored(&self, options: &Options) -> Result<Self> {
        let handle = options.make(|options, out| {
            // SAFETY: a live handle.
            unsafe { sys::stltsa_clip_mirror(self.raw(), options, out) }
        })?;
        Ok(Self { handle })
    }

    /// The frames of a stretch, as [`Clip::stretch`] names it: one range, or those of a label.
    ///
    /// # Errors
    /// As [`Clip::stretch`].
    pub fn find(&self, what: &str, options: &Options) -> Result<Vec<Range<usize>>> {
        let what = c_name(what)?;
        options.call(|options| {
            let find = |room: &mut [sys::stltsa_interval]| {
                let (capacity, mut count) = (room.len() as i64, 0);
                // SAFETY: a live handle, a string and `capacity` intervals that live through the
                // call.
                check(unsafe {
                    sys::stltsa_clip_find(
                        self.raw(),
                        what.as_ptr(),
                        options,
                        capacity,
                        room.as_mut_ptr(),
                        &mut count,
                    )
                })?;
                Ok(count as usize)
            };
            let none = sys::stltsa_interval { begin: 0, end: 0, begin_s: 0.0, end_s: 0.0 };
            let mut found = vec![none; find(&mut [])?];
            find(&mut found)?;
            Ok(found.iter().map(|one| one.begin as usize..one.end as usize).collect())
        })
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
        self.info().int(Fact::Format).expect("a clip has a format").into()
    }

    /// Joints and end sites in file order, parents first; empty for plain numbers.
    pub fn joints(&self) -> Vec<Joint> {
        self.info().list(Fact::Joint)
    }

    /// Events that the file states, in order of time.
    pub fn events(&self) -> Vec<FileEvent> {
        self.info().list(Fact::FileEvent)
    }

    /// World positions from forward kinematics: frames x (3 * joints), x y z of joint 0, joint 1,
    /// ...
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) without a skeleton.
    pub fn positions(&self) -> Result<Matrix> {
        self.info().array(Fact::Positions, 0)
    }

    /// Local rotations as quaternions: frames x (4 * joints), w x y z, with signs continuous over
    /// time.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) without a skeleton.
    pub fn rotations(&self) -> Result<Matrix> {
        self.info().array(Fact::Rotations, 0)
    }

    /// Features of every frame, unsmoothed: frames x features. Options used: features, up_axis.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument), [`Unsupported`](crate::ErrorKind::Unsupported) if
    /// the features need a skeleton and there is none.
    pub fn features(&self, options: &Options) -> Result<Matrix> {
        options.call(|options| {
            // SAFETY: live handles.
            let features = got(0, |features| unsafe {
                sys::stltsa_clip_feature_count(self.raw(), options, features)
            })?;
            Matrix::filled(self.frames(), count(features), |out| {
                // SAFETY: live handles, an array of the size it says.
                unsafe { sys::stltsa_clip_features(self.raw(), options, out) }
            })
        })
    }

    /// Writes the clip, completely or not at all. The suffix determines the format: `.bvh` (any
    /// skeleton), `.amc` (clips read from AMC; their ASF file is written beside it), `.csv`, `.npy`
    /// (the numbers of any clip). Numbers read back to the same bits. `.glb`: glTF binary, skeleton
    /// and animation or moving points, for other programs.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) (other suffix),
    /// [`Unsupported`](crate::ErrorKind::Unsupported) (no skeleton, an unsuitable one, or no frame
    /// rate although the format needs one), [`Io`](crate::ErrorKind::Io).
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        self.save_with(path, &Options::new())
    }

    /// The same with options. Used: progress, which can cancel until the file is complete.
    ///
    /// # Errors
    /// As [`save`](Self::save), and [`Cancelled`](crate::ErrorKind::Cancelled).
    pub fn save_with(&self, path: impl AsRef<Path>, options: &Options) -> Result<()> {
        let path = c_path(path.as_ref())?;
        options.call(|options| {
            // SAFETY: a live handle, and a string that lives through the call.
            check(unsafe { sys::stltsa_clip_save(self.raw(), path.as_ptr(), options) })
        })
    }

    /// Cuts the clip into motion units and cycles (section 3.1 of the paper).
    ///
    /// A clip without trustworthy cycles is an answer, with a
    /// [reason](crate::Decomposition::reason), not an error. Options used: features, up_axis,
    /// keep_start, rate, smoothing, period_min, period_max, segments, threads, progress.
    ///
    /// ```
    /// use stltsa::{Clip, Fact, Options, UnitKind};
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
    /// assert!((units.info().real(Fact::Period)? - 1.0).abs() < 0.05);
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
        let handle = options.make(|options, out| {
            // SAFETY: live handles.
            unsafe { sys::stltsa_decompose(self.raw(), options, out) }
        })?;
        Ok(Decomposition { handle })
    }
}
