// SPDX-License-Identifier: BSD-3-Clause
//! [`Synthesis`]: new motion from pieces of clips (section 4 of the paper).

use std::mem::{size_of, ManuallyDrop};
use std::ops::Range;

use stltsa_sys as sys;

use crate::clip::Clip;
use crate::decomposition::Decomposition;
use crate::error::{c_count, check, count, owned_text, texts, Result};
use crate::handle::Owned;
use crate::options::Options;

/// Frames of a clip, once or several times.
#[derive(Clone, Debug)]
pub struct Piece<'a> {
    clip: &'a Clip,
    frames: Range<usize>,
    repeat: usize,
}

impl<'a> Piece<'a> {
    /// Frames `frames` of `clip`, once.
    pub fn new(clip: &'a Clip, frames: Range<usize>) -> Self {
        Self { clip, frames, repeat: 1 }
    }

    /// The same, `times` times.
    #[must_use]
    pub fn repeat(self, times: usize) -> Self {
        Self { repeat: times, ..self }
    }

    fn raw(&self) -> Result<sys::stltsa_piece> {
        Ok(sys::stltsa_piece {
            clip: self.clip.raw(),
            begin: c_count(self.frames.start)?,
            end: c_count(self.frames.end)?,
            repeat: c_count(self.repeat)?,
            reserved: 0,
        })
    }
}

/// Pieces joined into one clip, and measures of each seam.
///
/// ```no_run
/// use stltsa::{Clip, Options, Piece, Synthesis};
///
/// let walk = Clip::open("walk.bvh")?;
/// let units = walk.decompose(&Options::new())?;
/// if let Some(best) = units.best() {
///     let pieces = [Piece::new(&walk, best.frames()).repeat(4)];
///     let walking = Synthesis::new(&pieces, &Options::new())?;
///     walking.clip().save("loop.bvh")?;
/// }
/// # Ok::<(), stltsa::Error>(())
/// ```
#[derive(Debug)]
pub struct Synthesis {
    /// Owned by `handle`, which frees it.
    clip: ManuallyDrop<Clip>,
    pub(crate) handle: Owned<sys::stltsa_synthesis>,
    seams: Vec<Seam>,
}

/// A join of two pieces, or of a piece and its own repetition.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Seam {
    /// First frame of the new clip from the later piece; of a loop's wrap, from its last frame to
    /// its first, the number of frames.
    pub frame: usize,
    /// Index of the earlier piece.
    pub piece: usize,
    /// Index of the later piece.
    pub next: usize,
    /// The earlier piece ends before this frame of its clip (after resampling).
    pub cut_end: usize,
    /// The later piece begins at this frame of its clip (after resampling).
    pub cut_begin: usize,
    /// Frames to blend on each side; 0: joined without blending.
    pub crossfade: usize,
    /// Distance of postures and velocities at the cuts, relative to the typical distance between
    /// repetitions of the same motion; at 1 they are equally similar.
    pub posture: f64,
    /// Largest step of the pose near the seam over the 95th percentile of the pieces'; up to 1 the
    /// seam is invisible.
    pub step: f64,
    /// The same for second differences.
    pub acceleration: f64,
}

impl Synthesis {
    /// Joins pieces, in order, into one clip.
    ///
    /// If a piece does not continue the previous one, the cuts move (option cut_range) to the most
    /// similar postures and velocities, and the two are crossfaded; the body continues from its
    /// position and heading. Pieces that are consecutive in their clip are joined unchanged. All
    /// clips need the same hierarchy; the first one gives channels, units and frame rate. Options
    /// used: crossfade, cut_range, posture_limit, loop, in_place, up_axis, progress.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument), [`Unsupported`](crate::ErrorKind::Unsupported)
    /// (plain numbers, different hierarchies, no frame rate),
    /// [`NoCommonPosture`](crate::ErrorKind::NoCommonPosture) (above posture_limit; the text says
    /// at which seam and by how much), [`Cancelled`](crate::ErrorKind::Cancelled).
    pub fn new(pieces: &[Piece<'_>], options: &Options) -> Result<Self> {
        let raw = pieces.iter().map(Piece::raw).collect::<Result<Vec<_>>>()?;
        let handle = options.call(|options| {
            let count = raw.len() as i64;
            // SAFETY: as many pieces, and live handles.
            Owned::make(|out| unsafe { sys::stltsa_synthesize(raw.as_ptr(), count, options, out) })
        })?;
        Self::of(handle)
    }

    /// The loop of a clip: of the ranges of consecutive cycles in its decomposition, the longest
    /// whose ends meet; without cycles, the whole clip. [`Fact::Note`](crate::Fact::Note) says
    /// which. Options used: those of [`Synthesis::new`].
    ///
    /// # Errors
    /// As for [`Synthesis::new`]; [`Argument`](crate::ErrorKind::Argument) if the decomposition is
    /// of a longer clip.
    pub fn of_cycles(clip: &Clip, found: &Decomposition, options: &Options) -> Result<Self> {
        let handle = options.call(|options| {
            // SAFETY: live handles.
            Owned::make(|out| unsafe {
                sys::stltsa_synthesize_loop(clip.raw(), found.raw(), options, out)
            })
        })?;
        Self::of(handle)
    }

    fn of(handle: Owned<sys::stltsa_synthesis>) -> Result<Self> {
        let seams = seams(&handle)?;
        // SAFETY: it lives as long as `handle`, and is never dropped here.
        let clip = unsafe { Owned::from_raw(sys::stltsa_synthesis_clip(handle.raw())) };
        Ok(Self { clip: ManuallyDrop::new(Clip { handle: clip }), handle, seams })
    }

    /// The new clip.
    pub fn clip(&self) -> &Clip {
        &self.clip
    }

    /// The seams in temporal order.
    pub fn seams(&self) -> &[Seam] {
        &self.seams
    }

    /// Warnings about the result.
    pub fn warnings(&self) -> Vec<String> {
        // SAFETY: a live handle, to which the texts belong until they are copied.
        unsafe {
            let count = sys::stltsa_synthesis_warning_count(self.handle.raw());
            texts(count, |index| sys::stltsa_synthesis_warning(self.handle.raw(), index))
        }
    }

    /// One JSON object (schema: stltsa-synthesis/1).
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn json(&self) -> Result<String> {
        // SAFETY: a live handle.
        owned_text(|out| unsafe { sys::stltsa_synthesis_json(self.handle.raw(), out) })
    }
}

fn seams(handle: &Owned<sys::stltsa_synthesis>) -> Result<Vec<Seam>> {
    // SAFETY: a live handle.
    let count = unsafe { sys::stltsa_synthesis_seam_count(handle.raw()) };
    (0..count).map(|index| seam(handle, index)).collect()
}

fn seam(handle: &Owned<sys::stltsa_synthesis>, index: i64) -> Result<Seam> {
    let mut raw = sys::stltsa_seam {
        size: size_of::<sys::stltsa_seam>(),
        frame: 0,
        piece: 0,
        next: 0,
        cut_end: 0,
        cut_begin: 0,
        crossfade: 0,
        posture: 0.0,
        step: 0.0,
        acceleration: 0.0,
    };
    // SAFETY: a live handle, and a struct that says its size.
    check(unsafe { sys::stltsa_synthesis_seam(handle.raw(), index, &mut raw) })?;
    Ok(Seam {
        frame: count(raw.frame)?,
        piece: count(raw.piece)?,
        next: count(raw.next)?,
        cut_end: count(raw.cut_end)?,
        cut_begin: count(raw.cut_begin)?,
        crossfade: count(raw.crossfade)?,
        posture: raw.posture,
        step: raw.step,
        acceleration: raw.acceleration,
    })
}
