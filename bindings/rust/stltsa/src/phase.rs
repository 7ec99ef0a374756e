// SPDX-License-Identifier: BSD-3-Clause
//! [`Phase`]: where each frame lies on the mean cycle of its motion, and [`Cycles`]: signals on 0 to
//! 100 % of each cycle.

use stltsa_sys as sys;

use crate::array::{list_in, Matrix, View};
use crate::decomposition::Decomposition;
use crate::error::{c_count, Result};
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
/// let cycles = phase.resample(0, &knee, 101, &options)?;
/// println!("{} cycles, first value of the mean {}", cycles.len(), cycles.mean()[(0, 0)]);
/// # Ok::<(), stltsa::Error>(())
/// ```
#[derive(Debug)]
pub struct Phase {
    pub(crate) handle: Owned<sys::stltsa_phase>,
}

impl Phase {
    /// The phase of a clip that was decomposed: found by the first call, and kept by the
    /// decomposition. Used of the options: progress.
    ///
    /// # Errors
    /// [`Cancelled`](crate::ErrorKind::Cancelled).
    pub fn find(found: &Decomposition, options: &Options) -> Result<Self> {
        let handle = options.make(|options, out| {
            // SAFETY: a live handle.
            unsafe { sys::stltsa_phase_find(found.raw(), options, out) }
        })?;
        Ok(Self { handle })
    }

    /// Of each label, the phase at which the body is at the same place in every clip, wherever its
    /// cycles begin; NaN for one that does not repeat.
    pub fn zeros(&self) -> Vec<f64> {
        self.info().reals(Fact::PhaseZero).unwrap_or_default()
    }

    /// Phase of each frame in [0, 1); NaN outside cycles.
    pub fn values(&self) -> Vec<f64> {
        self.info().column(Fact::Phase)
    }

    /// Distance of each frame from the mean cycle, as a share of the deviation of the motion; NaN
    /// outside cycles.
    pub fn residuals(&self) -> Vec<f64> {
        self.info().column(Fact::PhaseResidual)
    }

    /// Index of the cycle of each frame.
    pub fn cycles(&self) -> Vec<Option<usize>> {
        let cycles = self.info().column(Fact::PhaseCycle).into_iter();
        cycles.map(|cycle| (cycle >= 0.0).then_some(cycle as usize)).collect()
    }

    /// The joint, point or column of the file that each column of the features belongs to.
    pub fn column_owners(&self) -> Vec<String> {
        self.info().texts(Fact::Owner).unwrap_or_default()
    }

    /// Resamples signals, a row for each frame of the clip, on 0 to 100 % of the cycles of a label
    /// (0 for A). NaN is a missing value. Option used: progress.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) if the label has neither cycles nor repetitions,
    /// [`Shape`](crate::ErrorKind::Shape), [`Cancelled`](crate::ErrorKind::Cancelled).
    pub fn resample<'a>(
        &self,
        label: usize,
        signals: impl Into<View<'a>>,
        samples: usize,
        options: &Options,
    ) -> Result<Cycles> {
        let (label, signals, samples) = (c_count(label)?, signals.into().raw()?, c_count(samples)?);
        let handle = options.make(|options, out| {
            // SAFETY: live handles, an array of the size it says.
            unsafe {
                sys::stltsa_cycles_resample(self.raw(), label, &signals, samples, options, out)
            }
        })?;
        Ok(Cycles { handle })
    }
}

/// Signals on 0 to 100 % of each cycle, with mean and spread.
#[derive(Debug)]
pub struct Cycles {
    pub(crate) handle: Owned<sys::stltsa_cycles>,
}

impl Cycles {
    /// Resamples signals between given borders, frames that need not be whole, linearly in time.
    /// Option used: progress.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) for borders that do not rise or lie outside,
    /// [`Cancelled`](crate::ErrorKind::Cancelled).
    pub fn between<'a>(
        borders: &[f64],
        signals: impl Into<View<'a>>,
        samples: usize,
        options: &Options,
    ) -> Result<Self> {
        let borders = View::new(borders, borders.len(), 1)?.raw()?;
        let (signals, samples) = (signals.into().raw()?, c_count(samples)?);
        let handle = options.make(|options, out| {
            // SAFETY: arrays of the size they say.
            unsafe { sys::stltsa_cycles_between(&borders, &signals, samples, options, out) }
        })?;
        Ok(Self { handle })
    }

    /// Number of cycles.
    #[allow(clippy::len_without_is_empty)] // there is at least one
    pub fn len(&self) -> usize {
        self.info().count(Fact::Values)
    }

    /// Mean over the cycles: samples x columns.
    pub fn mean(&self) -> Matrix {
        self.info().matrix(Fact::Mean)
    }

    /// Standard deviation over the cycles; NaN of a single one.
    pub fn deviation(&self) -> Matrix {
        self.info().matrix(Fact::Deviation)
    }

    /// One cycle: samples x columns.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) if there is no such cycle.
    pub fn cycle(&self, index: usize) -> Result<Matrix> {
        self.info().array(Fact::Values, index)
    }

    /// The frame of each sample, not rounded: cycles x samples.
    pub fn frames(&self) -> Matrix {
        self.info().matrix(Fact::SampleFrames)
    }

    /// How much later each sample is than in linear time, as a share of the cycle.
    pub fn warp(&self) -> Matrix {
        self.info().matrix(Fact::Warp)
    }

    /// Distance of each cycle from the mean, as a share of the deviation along the mean cycle.
    pub fn distance(&self) -> Vec<f64> {
        self.info().column(Fact::Distance)
    }

    /// The same for each column, in its unit: cycles x columns.
    pub fn column_distance(&self) -> Matrix {
        self.info().matrix(Fact::ColumnDistance)
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
            unsafe { sys::stltsa_cycles_group_distance(self.raw(), &input, out) }
        })
    }
}
