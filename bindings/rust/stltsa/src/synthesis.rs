// SPDX-License-Identifier: BSD-3-Clause
//! [`Synthesis`]: new motion from pieces of clips (section 4 of the paper).

use std::mem::ManuallyDrop;
use std::ops::Range;

use stltsa_sys as sys;

use crate::clip::Clip;
use crate::decomposition::Decomposition;
use crate::error::{c_count, Result};
use crate::handle::Owned;
use crate::kinds::Fact;
use crate::options::Options;
use crate::rows::Seam;

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
        let (pieces, count) = (raw.as_ptr(), raw.len() as i64);
        let handle = options.make(|options, out| {
            // SAFETY: as many pieces, and live handles.
            unsafe { sys::stltsa_synthesize(pieces, count, options, out) }
        })?;
        Ok(Self::of(handle))
    }

    /// The loop of a clip: of the ranges of consecutive cycles in its decomposition, the longest
    /// whose ends meet; without cycles, the whole clip. [`Fact::Note`](crate::Fact::Note) says
    /// which. Options used: those of [`Synthesis::new`].
    ///
    /// # Errors
    /// As for [`Synthesis::new`]; [`Argument`](crate::ErrorKind::Argument) if the decomposition is
    /// of a longer clip.
    pub fn of_cycles(clip: &Clip, found: &Decomposition, options: &Options) -> Result<Self> {
        let (clip, found) = (clip.raw(), found.raw());
        let handle = options.make(|options, out| {
            // SAFETY: live handles.
            unsafe { sys::stltsa_synthesize_loop(clip, found, options, out) }
        })?;
        Ok(Self::of(handle))
    }

    fn of(handle: Owned<sys::stltsa_synthesis>) -> Self {
        // SAFETY: it lives as long as `handle`, and is never dropped here.
        let clip = unsafe { Owned::from_raw(sys::stltsa_synthesis_clip(handle.raw())) };
        Self { clip: ManuallyDrop::new(Clip { handle: clip }), handle }
    }

    /// The new clip.
    pub fn clip(&self) -> &Clip {
        &self.clip
    }

    /// The seams in temporal order.
    pub fn seams(&self) -> Vec<Seam> {
        self.info().list(Fact::Seam)
    }
}
