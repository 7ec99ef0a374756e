// SPDX-License-Identifier: BSD-3-Clause
//! [`Phase`]: where each frame lies on the mean cycle of its motion, and [`Cycles`]: signals on 0 to
//! 100 % of each cycle.

use stltsa_sys as sys;

use crate::array::{list_in, list_out, Matrix, View};
use crate::decomposition::Decomposition;
use crate::error::{c_count, check, count, texts, Error, ErrorKind, Result};
use crate::handle::Owned;
use crate::kinds::Fact;
use crate::options::Options;

/// A phase for every frame of the cycles of a clip, in turns.
///
/// It rises strictly. Cycle k of the decomposition goes from phase 0 to 1: borders lie at phase 0 on
/// average, and within about 1 % of it.
///
/// ```no_run
/// use stltsa::{Clip, Options, Phase};
///
/// let walk = Clip::open("walk.bvh")?;
/// let options = Options::new();
/// let phase = Phase::find(&walk.decompose(&options)?, &options)?;
/// let knee = walk.features(&options)?;
/// let cycles = phase.resample(0, &knee, 101)?;
/// println!("{} cycles, first value of the mean {}", cycles.len(), cycles.mean()?[(0, 0)]);
/// # Ok::<(), stltsa::Error>(())
/// ```
#[derive(Debug)]
pub struct Phase {
    handle: Owned<sys::stltsa_phase>,
    frames: usize,
}

impl Phase {
    /// The phase of a clip that was decomposed: found by the first call, and kept by the
    /// decomposition. Used of the options: progress.
    ///
    /// # Errors
    /// [`Cancelled`](crate::ErrorKind::Cancelled).
    pub fn find(found: &Decomposition, options: &Options) -> Result<Self> {
        let handle = options.call(|options| {
            // SAFETY: a live handle.
            Owned::make(|out| unsafe { sys::stltsa_phase_find(found.raw(), options, out) })
        })?;
        let frames = found.facts().ints(Fact::ClipFrames)?;
        Ok(Self { handle, frames: frames.first().map_or(Ok(0), |&frames| count(frames))? })
    }

    /// The phase at which the body is at the same place in every clip, wherever its cycles begin;
    /// `label`: 0 for A.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) if the label has neither cycles nor repetitions.
    pub fn zero(&self, label: usize) -> Result<f64> {
        let label = i32::try_from(label)
            .map_err(|_| Error::new(ErrorKind::Argument, format!("there is no label {label}")))?;
        let mut zero = f64::NAN;
        // SAFETY: a live handle.
        check(unsafe { sys::stltsa_phase_zero(self.handle.raw(), label, &mut zero) })?;
        Ok(zero)
    }

    pub(crate) fn raw(&self) -> *const sys::stltsa_phase {
        self.handle.raw()
    }

    /// Phase of each frame in [0, 1); NaN outside cycles.
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn values(&self) -> Result<Vec<f64>> {
        let values = Matrix::filled(self.frames, 1, |out| {
            // SAFETY: a live handle, an array of the size it says.
            unsafe {
                sys::stltsa_phase_values(self.handle.raw(), out, std::ptr::null(), std::ptr::null())
            }
        })?;
        Ok(values.into_vec())
    }

    /// Distance of each frame from the mean cycle, as a share of the deviation of the motion; NaN
    /// outside cycles.
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn residuals(&self) -> Result<Vec<f64>> {
        let values = Matrix::filled(self.frames, 1, |out| {
            // SAFETY: as above.
            unsafe {
                sys::stltsa_phase_values(self.handle.raw(), std::ptr::null(), out, std::ptr::null())
            }
        })?;
        Ok(values.into_vec())
    }

    /// Index of the cycle of each frame.
    ///
    /// # Errors
    /// None in practice.
    pub fn cycles(&self) -> Result<Vec<Option<usize>>> {
        let mut cycles = vec![0; self.frames];
        let out = list_out(&mut cycles)?;
        // SAFETY: a live handle, an array of the size it says.
        check(unsafe {
            sys::stltsa_phase_values(self.handle.raw(), std::ptr::null(), std::ptr::null(), &out)
        })?;
        Ok(cycles.into_iter().map(|cycle| usize::try_from(cycle).ok()).collect())
    }

    /// About motions whose phase is linear in time, because the mean cycle explains too little.
    pub fn warnings(&self) -> Vec<String> {
        // SAFETY: a live handle.
        unsafe {
            texts(sys::stltsa_phase_warning_count(self.handle.raw()), |index| {
                sys::stltsa_phase_warning(self.handle.raw(), index)
            })
        }
    }

    /// The joint, point or column of the file that each column of the features belongs to.
    #[must_use]
    pub fn column_owners(&self) -> Vec<String> {
        // SAFETY: a live handle.
        unsafe {
            texts(sys::stltsa_phase_column_count(self.handle.raw()), |index| {
                sys::stltsa_phase_column_owner(self.handle.raw(), index)
            })
        }
    }

    /// Resamples signals, a row for each frame of the clip, on 0 to 100 % of the cycles of a label
    /// (0 for A). NaN is a missing value.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) if the label has neither cycles nor repetitions,
    /// [`Shape`](crate::ErrorKind::Shape).
    pub fn resample<'a>(
        &self,
        label: usize,
        signals: impl Into<View<'a>>,
        samples: usize,
    ) -> Result<Cycles> {
        let signals = signals.into();
        let label = i32::try_from(label)
            .map_err(|_| Error::new(ErrorKind::Argument, format!("there is no label {label}")))?;
        Cycles::made(&signals, samples, |input, samples, out| {
            // SAFETY: live handles, an array of the size it says.
            unsafe { sys::stltsa_cycles_resample(self.handle.raw(), label, input, samples, out) }
        })
    }
}

/// Signals on 0 to 100 % of each cycle, with mean and spread.
#[derive(Debug)]
pub struct Cycles {
    handle: Owned<sys::stltsa_cycles>,
    samples: usize,
    columns: usize,
}

impl Cycles {
    /// Resamples signals between given borders, frames that need not be whole, linearly in time.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) for borders that do not rise or lie outside.
    pub fn between<'a>(
        borders: &[f64],
        signals: impl Into<View<'a>>,
        samples: usize,
    ) -> Result<Self> {
        let borders = View::new(borders, borders.len(), 1)?.raw()?;
        Self::made(&signals.into(), samples, |input, samples, out| {
            // SAFETY: arrays of the size they say.
            unsafe { sys::stltsa_cycles_between(&borders, input, samples, out) }
        })
    }

    fn made(
        signals: &View<'_>,
        samples: usize,
        make: impl FnOnce(&sys::stltsa_in, i64, *mut *mut sys::stltsa_cycles) -> sys::stltsa_status,
    ) -> Result<Self> {
        let input = signals.raw()?;
        let wanted = c_count(samples)?;
        let handle = Owned::make(|out| make(&input, wanted, out))?;
        Ok(Self { handle, samples, columns: signals.cols() })
    }

    pub(crate) fn raw(&self) -> *const sys::stltsa_cycles {
        self.handle.raw()
    }

    pub(crate) fn columns(&self) -> usize {
        self.columns
    }

    /// Number of cycles.
    #[allow(clippy::len_without_is_empty)] // there is at least one
    pub fn len(&self) -> usize {
        // SAFETY: a live handle.
        count(unsafe { sys::stltsa_cycles_count(self.handle.raw()) }).unwrap_or(0)
    }

    /// Mean over the cycles: samples x columns.
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn mean(&self) -> Result<Matrix> {
        Matrix::filled(self.samples, self.columns, |out| {
            // SAFETY: a live handle, an array of the size it says.
            unsafe { sys::stltsa_cycles_mean(self.handle.raw(), out, std::ptr::null()) }
        })
    }

    /// Standard deviation over the cycles; NaN of a single one.
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn deviation(&self) -> Result<Matrix> {
        Matrix::filled(self.samples, self.columns, |out| {
            // SAFETY: as above.
            unsafe { sys::stltsa_cycles_mean(self.handle.raw(), std::ptr::null(), out) }
        })
    }

    /// One cycle: samples x columns.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) if there is no such cycle.
    pub fn cycle(&self, index: usize) -> Result<Matrix> {
        let index = c_count(index)?;
        Matrix::filled(self.samples, self.columns, |out| {
            // SAFETY: as above.
            unsafe { sys::stltsa_cycles_cycle(self.handle.raw(), index, out) }
        })
    }

    /// The frame of each sample, not rounded: cycles x samples.
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn frames(&self) -> Result<Matrix> {
        Matrix::filled(self.len(), self.samples, |out| {
            // SAFETY: as above.
            unsafe { sys::stltsa_cycles_times(self.handle.raw(), out, std::ptr::null()) }
        })
    }

    /// How much later each sample is than in linear time, as a share of the cycle.
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn warp(&self) -> Result<Matrix> {
        Matrix::filled(self.len(), self.samples, |out| {
            // SAFETY: as above.
            unsafe { sys::stltsa_cycles_times(self.handle.raw(), std::ptr::null(), out) }
        })
    }

    /// Distance of each cycle from the mean, as a share of the deviation along the mean cycle.
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn distance(&self) -> Result<Vec<f64>> {
        let total = Matrix::filled(self.len(), 1, |out| {
            // SAFETY: as above.
            unsafe { sys::stltsa_cycles_distance(self.handle.raw(), out, std::ptr::null()) }
        })?;
        Ok(total.into_vec())
    }

    /// The same for groups of columns, such as those of each joint: cycles x groups. `groups` has
    /// the group of each column, `None` for none.
    ///
    /// # Errors
    /// [`Shape`](crate::ErrorKind::Shape) unless there is one group for each column,
    /// [`Argument`](crate::ErrorKind::Argument) if no column is in a group.
    pub fn group_distance(&self, groups: &[Option<usize>]) -> Result<Matrix> {
        let of_column = |group: &Option<usize>| group.map_or(Ok(-1), c_count);
        let list = groups.iter().map(of_column).collect::<Result<Vec<_>>>()?;
        let input = list_in(&list)?;
        let count = groups.iter().flatten().max().map_or(0, |most| most + 1);
        Matrix::filled(self.len(), count, |out| {
            // SAFETY: a live handle, arrays of the size they say.
            unsafe { sys::stltsa_cycles_group_distance(self.handle.raw(), &input, out) }
        })
    }

    /// The same for each column, in its unit: cycles x columns.
    ///
    /// # Errors
    /// [`NoMemory`](crate::ErrorKind::NoMemory).
    pub fn column_distance(&self) -> Result<Matrix> {
        Matrix::filled(self.len(), self.columns, |out| {
            // SAFETY: as above.
            unsafe { sys::stltsa_cycles_distance(self.handle.raw(), std::ptr::null(), out) }
        })
    }
}
