// SPDX-License-Identifier: BSD-3-Clause
//! [`Comparison`]: the cycles of two motions, aligned by phase.

use std::path::Path;

use stltsa_sys as sys;

use crate::array::Matrix;
use crate::clip::Clip;
use crate::error::{c_count, c_name, c_optional, c_path, check, pointer, Error, ErrorKind, Result};
use crate::handle::Owned;
use crate::kinds::Fact;
use crate::options::Options;
use crate::phase::{Cycles, Phase};
use crate::rows::{Compared, ComparedMotion, ComparedPart};

/// The differences between the cycles of two motions, and how precisely they are known.
#[derive(Debug)]
pub struct Comparison {
    pub(crate) handle: Owned<sys::stltsa_comparison>,
}

/// -1 for none.
fn c_label(label: Option<usize>) -> Result<i64> {
    label.map_or(Ok(-1), c_count)
}

impl Phase {
    /// Compares the cycles of a motion with those of a motion of another clip. Labels count from 0
    /// for A; `None`: the motion with the most frames in cycles, and the one most like it in the
    /// second clip. Option used: progress.
    ///
    /// ```no_run
    /// use stltsa::{Clip, Options, Phase};
    ///
    /// let options = Options::new();
    /// let phase = |path: &str| {
    ///     let clip = Clip::open(path)?;
    ///     Phase::find(&clip.decompose(&options)?, &options)
    /// };
    /// let (before, after) = (phase("before.bvh")?, phase("after.bvh")?);
    /// for part in before.compare(&after, None, None, 101, &options)?.parts() {
    ///     println!("{}: {:+.1} % later", part.first, 100.0 * part.lag.difference);
    /// }
    /// # Ok::<(), stltsa::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`NoSuchPart`](ErrorKind::NoSuchPart) if a clip has no cycles,
    /// [`Argument`](ErrorKind::Argument) if a label has no cycles, [`Shape`](ErrorKind::Shape) if
    /// the clips have nothing in common, [`Cancelled`](ErrorKind::Cancelled).
    pub fn compare(
        &self,
        second: &Phase,
        label: Option<usize>,
        second_label: Option<usize>,
        samples: usize,
        options: &Options,
    ) -> Result<Comparison> {
        let (one, other) = (c_label(label)?, c_label(second_label)?);
        let (first, second, samples) = (self.raw(), second.raw(), c_count(samples)?);
        let handle = options.make(|options, out| {
            // SAFETY: live handles.
            unsafe { sys::stltsa_compare(first, one, second, other, samples, options, out) }
        })?;
        Ok(Comparison { handle })
    }

    /// Compares the left side of the body with the mirror image of the right side half a cycle
    /// later. `clip` is the clip that the phase was found in.
    ///
    /// # Errors
    /// As [`compare`](Self::compare); [`Unsupported`](ErrorKind::Unsupported) if the sides cannot be
    /// compared.
    pub fn compare_left_right(
        &self,
        clip: &Clip,
        label: Option<usize>,
        samples: usize,
        options: &Options,
    ) -> Result<Comparison> {
        let (label, samples) = (c_label(label)?, c_count(samples)?);
        let (clip, phase) = (clip.raw(), self.raw());
        let handle = options.make(|options, out| {
            // SAFETY: live handles.
            unsafe { sys::stltsa_compare_left_right(clip, phase, label, samples, options, out) }
        })?;
        Ok(Comparison { handle })
    }
}

impl Cycles {
    /// Compares left with right half a cycle later: signals whose names differ only in the side, such
    /// as `knee_l` and `knee_r`; one name for each column. Both signals must have the same sign
    /// convention, as flexion has. `fps`: frames per second; 0: unknown, so that times are NaN.
    ///
    /// # Errors
    /// [`Shape`](ErrorKind::Shape) unless there is one name for each column,
    /// [`Unsupported`](ErrorKind::Unsupported) if no two of them differ only in the side, or the
    /// halves of the cycles are not known to be alike.
    pub fn compare_left_right(
        &self,
        names: &[&str],
        fps: f64,
        options: &Options,
    ) -> Result<Comparison> {
        let columns = self.info().shape(Fact::Mean)?.1;
        if names.len() != columns {
            let text = format!("there are {} names and {columns} columns", names.len());
            return Err(Error::new(ErrorKind::Shape, text));
        }
        let texts = names.iter().map(|name| c_name(name)).collect::<Result<Vec<_>>>()?;
        let raw: Vec<_> = texts.iter().map(|text| text.as_ptr()).collect();
        let (cycles, names) = (self.raw(), raw.as_ptr());
        let handle = options.make(|options, out| {
            // SAFETY: live handles, a text for each column.
            unsafe { sys::stltsa_cycles_compare_left_right(cycles, names, fps, options, out) }
        })?;
        Ok(Comparison { handle })
    }
}

impl Comparison {
    /// About the whole.
    pub fn whole(&self) -> Compared {
        self.info().list(Fact::Comparison)[0]
    }

    /// The first and the second motion.
    pub fn motions(&self) -> Vec<ComparedMotion> {
        self.info().list(Fact::Motion)
    }

    /// Joints, points or columns.
    pub fn parts(&self) -> Vec<ComparedPart> {
        self.info().list(Fact::Part)
    }

    /// Their coordinates, part by part.
    pub fn channels(&self) -> Vec<ComparedPart> {
        self.info().list(Fact::PartChannel)
    }

    /// Mean cycle of the first (0) or second (1) motion, samples x channels.
    ///
    /// # Errors
    /// [`Argument`](ErrorKind::Argument): there is no third motion.
    pub fn mean(&self, which: usize) -> Result<Matrix> {
        self.info().array(Fact::Mean, which)
    }

    /// Standard deviation between its cycles, samples x channels.
    ///
    /// # Errors
    /// As [`mean`](Self::mean).
    pub fn deviation(&self, which: usize) -> Result<Matrix> {
        self.info().array(Fact::Deviation, which)
    }

    /// Second minus first, samples x channels.
    pub fn difference(&self) -> Matrix {
        self.info().matrix(Fact::Difference)
    }

    /// Standard error of the difference, samples x channels.
    pub fn standard_error(&self) -> Matrix {
        self.info().matrix(Fact::StandardError)
    }

    /// Half the width of the interval at each sample.
    pub fn margin(&self) -> Matrix {
        self.info().matrix(Fact::Margin)
    }

    /// Writes a report: one HTML page that a browser shows without a network. `command`: which
    /// repeats it.
    ///
    /// # Errors
    /// [`Io`](ErrorKind::Io), [`Argument`](ErrorKind::Argument) if `command` contains a NUL,
    /// [`Cancelled`](ErrorKind::Cancelled).
    pub fn report(
        &self,
        path: impl AsRef<Path>,
        command: Option<&str>,
        options: &Options,
    ) -> Result<()> {
        let (path, command) = (c_path(path.as_ref())?, c_optional(command)?);
        let (to, by) = (path.as_ptr(), pointer(&command));
        options.call(|options| {
            // SAFETY: live handles, and strings that live through the call.
            check(unsafe { sys::stltsa_comparison_report_save(self.raw(), options, by, to) })
        })
    }
}
