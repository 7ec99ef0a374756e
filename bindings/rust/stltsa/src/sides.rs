// SPDX-License-Identifier: BSD-3-Clause
//! [`Sides`]: comparison of left and right over a cycle.

use std::ffi::CString;

use stltsa_sys as sys;

use crate::array::Matrix;
use crate::clip::Clip;
use crate::error::{c_count, c_name, check, count, text, Error, ErrorKind, Result};
use crate::handle::Owned;
use crate::options::Options;
use crate::phase::{Cycles, Phase};

/// A side of the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(clippy::exhaustive_enums)] // bodies have two
pub enum Side {
    /// The left one.
    Left,
    /// The right one.
    Right,
}

impl Side {
    /// The side that the name of an event, a joint or a signal states; `None` if neither or both.
    ///
    /// ```
    /// use stltsa::Side;
    ///
    /// assert_eq!(Side::of_name("left heel strike"), Some(Side::Left));
    /// assert_eq!(Side::of_name("RTO"), Some(Side::Right));
    /// assert_eq!(Side::of_name("upright"), None);
    /// ```
    pub fn of_name(name: &str) -> Option<Self> {
        let name = CString::new(name).ok()?;
        // SAFETY: a text that lives during the call.
        match unsafe { sys::stltsa_side_of_name(name.as_ptr()) } {
            sys::STLTSA_SIDE_LEFT => Some(Self::Left),
            sys::STLTSA_SIDE_RIGHT => Some(Self::Right),
            _ => None,
        }
    }
}

/// A signal of the left side and the same one of the right side half a cycle later. NaN: unknown.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SidePair {
    /// Name of the left joint, point or signal.
    pub left: String,
    /// Name of the right one.
    pub right: String,
    /// Column of the left signal.
    pub left_column: usize,
    /// Column of the right signal.
    pub right_column: usize,
    /// Root mean square of left minus right.
    pub rms: f64,
    /// `rms` expected from the spread between cycles alone.
    pub chance: f64,
    /// Mean of left minus mean of right.
    pub mean: f64,
    /// Highest minus lowest value of left.
    pub left_range: f64,
    /// Highest minus lowest value of right.
    pub right_range: f64,
    /// Delay of right beyond half a cycle after left, as a share of the cycle, -0.25 to 0.25; NaN if
    /// the curves are not alike.
    pub shift: f64,
    /// Correlation of the curves after the shift is removed.
    pub correlation: f64,
}

/// A comparison of left and right, with mean curves over the cycle, samples x pairs; the right curves
/// are shifted by half a cycle.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Sides {
    /// The pairs, in the order of the left columns.
    pub pairs: Vec<SidePair>,
    /// Curves of the left side.
    pub left: Matrix,
    /// Curves of the right side.
    pub right: Matrix,
    /// Left minus right.
    pub difference: Matrix,
    /// The reason if there are no pairs; empty if there are pairs.
    pub reason: String,
}

impl Phase {
    /// Compares the features of one label (0 for A), such as positions of joints: left with the
    /// mirror image of right. `clip` is the clip that the phase was found in.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) if the label has neither cycles nor repetitions.
    pub fn sides(
        &self,
        clip: &Clip,
        label: usize,
        samples: usize,
        options: &Options,
    ) -> Result<Sides> {
        let label = i32::try_from(label)
            .map_err(|_| Error::new(ErrorKind::Argument, format!("there is no label {label}")))?;
        let wanted = c_count(samples)?;
        let found = options.call(|options| {
            // SAFETY: live handles.
            Owned::make(|out| unsafe {
                sys::stltsa_sides_find(clip.raw(), self.raw(), label, wanted, options, out)
            })
        })?;
        Sides::read(&found, samples)
    }
}

impl Cycles {
    /// Compares signals whose names differ only in the side, such as `knee_l` and `knee_r`; one name
    /// for each column. Both signals must have the same sign convention, as flexion has.
    ///
    /// # Errors
    /// [`Shape`](crate::ErrorKind::Shape) unless there is one name for each column.
    pub fn sides(&self, names: &[&str]) -> Result<Sides> {
        if names.len() != self.columns() {
            let text = format!("there are {} names and {} columns", names.len(), self.columns());
            return Err(Error::new(ErrorKind::Shape, text));
        }
        let texts = names.iter().map(|name| c_name(name)).collect::<Result<Vec<_>>>()?;
        let raw: Vec<_> = texts.iter().map(|text| text.as_ptr()).collect();
        // SAFETY: a live handle, a text for each column.
        let found =
            Owned::make(|out| unsafe { sys::stltsa_sides_compare(self.raw(), raw.as_ptr(), out) })?;
        Sides::read(&found, self.samples())
    }
}

impl Sides {
    fn read(found: &Owned<sys::stltsa_sides>, samples: usize) -> Result<Self> {
        // SAFETY: a live handle.
        let pairs = count(unsafe { sys::stltsa_sides_count(found.raw()) })?;
        let curves = |which: usize| {
            if pairs == 0 {
                return Matrix::zeros(samples, 0);
            }
            Matrix::filled(samples, pairs, |out| {
                let mut outputs = [std::ptr::null(); 3];
                outputs[which] = out;
                // SAFETY: a live handle, an array of the size it says.
                unsafe { sys::stltsa_sides_curves(found.raw(), outputs[0], outputs[1], outputs[2]) }
            })
        };
        Ok(Self {
            pairs: (0..pairs).map(|index| pair(found, index)).collect::<Result<_>>()?,
            left: curves(0)?,
            right: curves(1)?,
            difference: curves(2)?,
            // SAFETY: a live handle.
            reason: unsafe { text(sys::stltsa_sides_reason(found.raw())) },
        })
    }
}

fn pair(found: &Owned<sys::stltsa_sides>, index: usize) -> Result<SidePair> {
    let index = c_count(index)?;
    // SAFETY: a struct of numbers, for which zeros are valid.
    let mut raw: sys::stltsa_side_pair = unsafe { std::mem::zeroed() };
    raw.size = std::mem::size_of::<sys::stltsa_side_pair>();
    // SAFETY: a live handle, a struct of the size it says.
    check(unsafe { sys::stltsa_sides_pair(found.raw(), index, &mut raw) })?;
    Ok(SidePair {
        // SAFETY: a live handle.
        left: unsafe { text(sys::stltsa_sides_left_name(found.raw(), index)) },
        // SAFETY: as above.
        right: unsafe { text(sys::stltsa_sides_right_name(found.raw(), index)) },
        left_column: count(raw.left)?,
        right_column: count(raw.right)?,
        rms: raw.rms,
        chance: raw.chance,
        mean: raw.mean,
        left_range: raw.left_range,
        right_range: raw.right_range,
        shift: raw.shift,
        correlation: raw.correlation,
    })
}
