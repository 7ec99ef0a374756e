// SPDX-License-Identifier: BSD-3-Clause
//! [`Decomposition`]: motion units and cycles of a clip (section 3.1 of the paper).

use std::path::Path;

use stltsa_sys as sys;

use crate::array::Matrix;
use crate::clip::Clip;
use crate::error::{c_count, c_optional, c_path, check, pointer, Result};
use crate::handle::Owned;
use crate::kinds::{Fact, Quantity};
use crate::options::Options;
use crate::rows::copied::Copied;
use crate::rows::{Part, Segment, Statistics, Summary, Unit};

/// Motion units and cycles of a clip, and the curve from which they were cut. Made by
/// [`Clip::decompose`].
#[derive(Debug)]
pub struct Decomposition {
    pub(crate) handle: Owned<sys::stltsa_decomposition>,
}

impl Decomposition {
    /// Segments in temporal order; they cover the clip without gap or overlap.
    pub fn segments(&self) -> Vec<Segment> {
        self.info().list(Fact::Segment)
    }

    /// Units in temporal order; they cover the clip without gap or overlap.
    pub fn units(&self) -> Vec<Unit> {
        self.info().list(Fact::Unit)
    }

    /// Cycles in temporal order, back to back within a segment.
    pub fn cycles(&self) -> Vec<Part> {
        self.info().list(Fact::Cycle)
    }

    /// Halves of cycles in which both sides of the body alternate; none if they do not.
    pub fn steps(&self) -> Vec<Part> {
        self.info().list(Fact::Step)
    }

    /// The actions of the segments that repeat with pauses.
    pub fn repetitions(&self) -> Vec<Part> {
        self.info().list(Fact::Repetition)
    }

    /// How often and how fast, for each label that repeats.
    pub fn summaries(&self) -> Vec<Summary> {
        self.info().list(Fact::Summary)
    }

    /// The paper's choice of a cycle: the first of the cyclic segment that lasts longest.
    pub fn representative(&self) -> Option<Part> {
        self.cycle_of(Fact::Representative)
    }

    /// The cycle that is most similar to the others.
    pub fn best(&self) -> Option<Part> {
        self.cycle_of(Fact::Best)
    }

    fn cycle_of(&self, key: Fact) -> Option<Part> {
        let index = usize::try_from(self.info().int(key).ok()?).ok()?;
        self.cycles().into_iter().nth(index)
    }

    /// Of a quantity of the parts of one kind ([`Fact::Cycle`], [`Fact::Step`] or
    /// [`Fact::Repetition`]) and label, see [`Segment::label`], and of one side, 0 or 1, or of both.
    /// Parts of which the quantity is unknown are left out.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument): another kind; `side` is neither 0 nor 1.
    pub fn statistics(
        &self,
        kind: Fact,
        label: usize,
        side: Option<usize>,
        quantity: Quantity,
    ) -> Result<Statistics> {
        let (kind, label, quantity) = (kind.raw(), c_count(label)?, quantity.raw());
        let side = side.map_or(-1, |side| i32::try_from(side).unwrap_or(i32::MAX));
        let mut raw = std::mem::MaybeUninit::zeroed();
        let (of, out) = (self.raw(), raw.as_mut_ptr());
        // SAFETY: a live handle; a struct of numbers, which the call fills.
        unsafe {
            check(sys::stltsa_decomposition_statistics(of, kind, label, side, quantity, out))?;
            Ok(Statistics::of(raw.assume_init()))
        }
    }

    /// How similar the segments of two labels are, labels x labels, 0 to 1: the mean over pairs of
    /// their segments. Moderate differences in size and tempo change it little. NaN for a label of
    /// one segment with itself.
    pub fn label_likeness(&self) -> Matrix {
        self.info().matrix(Fact::LabelLikeness)
    }

    /// The smoothed coordinate whose margins count, row by row; 0 outside cyclic segments.
    pub fn curve(&self) -> Vec<f64> {
        self.info().column(Fact::Curve)
    }

    /// The loop (Fig. 1 of the paper), rows x 2: the curve, and itself a quarter of a cycle behind.
    /// Each cyclic segment has coordinates of its own, so the loops of two segments cannot share
    /// axes.
    pub fn coords(&self) -> Matrix {
        self.info().matrix(Fact::Coords)
    }

    /// Why nothing repeats, with the numbers; `None` if anything does.
    pub fn reason(&self) -> Option<String> {
        self.info().text(Fact::Reason).ok().filter(|reason| !reason.is_empty())
    }

    /// Writes a report of the clip that was decomposed with these options: one HTML page that a
    /// browser shows without a network or, if the path ends in `.svg`, a figure. `command`: the
    /// command or call that makes it again.
    ///
    /// # Errors
    /// [`Io`](crate::ErrorKind::Io), [`Argument`](crate::ErrorKind::Argument) if the decomposition
    /// is of another clip, or `command` contains a NUL.
    pub fn report(
        &self,
        clip: &Clip,
        path: impl AsRef<Path>,
        command: Option<&str>,
        options: &Options,
    ) -> Result<()> {
        let (path, command) = (c_path(path.as_ref())?, c_optional(command)?);
        let (to, by) = (path.as_ptr(), pointer(&command));
        options.call(|options| {
            // SAFETY: live handles, and strings that live through the call.
            check(unsafe { sys::stltsa_report_save(clip.raw(), self.raw(), options, by, to) })
        })
    }
}
