// SPDX-License-Identifier: BSD-3-Clause
//! [`Comparison`]: the cycles of two motions, aligned by phase.

use std::path::Path;
use std::sync::Arc;

use stltsa_sys as sys;

use crate::array::Matrix;
use crate::clip::Clip;
use crate::error::{c_count, c_name, c_path, check, count, text, texts, Error, ErrorKind, Result};
use crate::handle::Owned;
use crate::options::Options;
use crate::phase::{Cycles, Phase};

/// A quantity of both mean cycles and its difference, second minus first. NaN: unknown.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Difference {
    /// Value for the first motion.
    pub first: f64,
    /// Its standard deviation between cycles.
    pub first_sd: f64,
    /// Value for the second motion.
    pub second: f64,
    /// Its standard deviation between cycles.
    pub second_sd: f64,
    /// Second minus first.
    pub difference: f64,
    /// Standard error of the difference.
    pub standard_error: f64,
    /// Lower end of the 95 % confidence interval of the difference.
    pub low: f64,
    /// Upper end of the interval.
    pub high: f64,
    /// The interval excludes 0. Of 20 differences that are really zero, about one is significant by
    /// chance.
    pub significant: bool,
}

/// A joint, a point or a column of the file, or one of its coordinates. NaN: unknown.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ComparedPart {
    /// Name in the first motion.
    pub name: String,
    /// Name in the second motion; it differs only for left and right.
    pub second_name: String,
    /// Such as `"x"` or `"rz"`; empty for a whole part, and for the only channel of a part.
    pub axis: String,
    /// Root mean square, over the cycle, of second minus first.
    pub rms: f64,
    /// `rms` expected from the spread between cycles alone.
    pub chance: f64,
    /// Correlation of the mean curves after the lag is removed.
    pub correlation: f64,
    /// How much later in its cycle the second motion does the same, relative to the whole body
    /// (left and right: to half a cycle), as a share of the cycle.
    pub lag: Difference,
    /// Largest distance between two points of the mean curve; of one channel, its range.
    pub amplitude: Difference,
    /// Amplitude of the second motion divided by that of the first, and its interval.
    pub ratio: [f64; 3],
    /// Lag in seconds, and its interval.
    pub lag_s: [f64; 3],
    /// Mean over the cycle, for a part with one channel.
    pub mean: Difference,
}

/// The differences between the cycles of two motions, and how precisely they are known. Pairs are
/// of the first and the second motion.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Comparison {
    /// Joints, points or columns.
    pub parts: Vec<ComparedPart>,
    /// Their coordinates, part by part.
    pub channels: Vec<ComparedPart>,
    /// Number of cycles.
    pub counts: [usize; 2],
    /// Labels of their segments, 0 for A.
    pub labels: [usize; 2],
    /// Cycle time in seconds.
    pub cycle_time: Difference,
    /// Cycles per minute.
    pub per_minute: [f64; 2],
    /// Phase of the second motion at phase 0 of the first, in cycles.
    pub shift: f64,
    /// Its standard error; NaN for left and right, whose shift is half a cycle by definition.
    pub shift_error: f64,
    /// Its 95 % confidence interval.
    pub shift_interval: [f64; 2],
    /// Correlation of the mean cycles.
    pub likeness: f64,
    /// The same at the next best shift; NaN: there is none.
    pub runner_up: f64,
    /// Degrees by which the second body was turned about the up axis to face as the first does.
    pub turn: f64,
    /// Size of the second body divided by that of the first; NaN: unknown.
    pub size_ratio: f64,
    /// Number of lags and amplitudes of parts that have an interval.
    pub judged: usize,
    /// How many of them are significant; by chance, a twentieth would be.
    pub significant: usize,
    /// Whether left and right of one clip are compared.
    pub sides: bool,
    /// Mean cycles, samples x channels.
    pub mean: [Matrix; 2],
    /// Standard deviations between cycles, samples x channels.
    pub deviation: [Matrix; 2],
    /// Second minus first, samples x channels.
    pub difference: Matrix,
    /// Standard error of the difference, samples x channels.
    pub standard_error: Matrix,
    /// Half the width of the interval at each sample.
    pub margin: Matrix,
    /// Names in each clip that the other one lacks.
    pub left_out: [Vec<String>; 2],
    /// What a user should know about the result.
    pub warnings: Vec<String>,
    /// The object of schema stltsa-comparison/1.
    pub json: String,
    handle: Arc<Found>,
}

impl Phase {
    /// Compares the cycles of a motion with those of a motion of another clip. Labels count from 0
    /// for A; `None`: the motion with the most frames in cycles, and the one most like it in the
    /// second clip.
    ///
    /// ```no_run
    /// use stltsa::{Clip, Options, Phase};
    ///
    /// let options = Options::new();
    /// let phase = |path: &str| {
    ///     let clip = Clip::open(path)?;
    ///     Phase::find(&clip.decompose(&options)?, &options)
    /// };
    /// let compared = phase("before.bvh")?.compare(&phase("after.bvh")?, None, None, 101)?;
    /// for part in &compared.parts {
    ///     println!("{}: {:+.1} % later", part.name, 100.0 * part.lag.difference);
    /// }
    /// # Ok::<(), stltsa::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`NoSuchPart`](crate::ErrorKind::NoSuchPart) if a clip has no cycles,
    /// [`Argument`](crate::ErrorKind::Argument) if a label has no cycles,
    /// [`Shape`](crate::ErrorKind::Shape) if the clips have nothing in common.
    pub fn compare(
        &self,
        second: &Phase,
        label: Option<usize>,
        second_label: Option<usize>,
        samples: usize,
    ) -> Result<Comparison> {
        self.compare_with(second, label, second_label, samples, &Options::new())
    }

    /// The same with options. Used: progress.
    ///
    /// # Errors
    /// As [`compare`](Self::compare), and [`Cancelled`](crate::ErrorKind::Cancelled).
    pub fn compare_with(
        &self,
        second: &Phase,
        label: Option<usize>,
        second_label: Option<usize>,
        samples: usize,
        options: &Options,
    ) -> Result<Comparison> {
        let (one, other) = ((self.raw(), number(label)?), (second.raw(), number(second_label)?));
        let wanted = c_count(samples)?;
        let found = options.call(|options| {
            // SAFETY: live handles.
            Owned::make(|out| unsafe {
                sys::stltsa_compare_with(one.0, one.1, other.0, other.1, wanted, options, out)
            })
        })?;
        Comparison::read(found)
    }

    /// Compares the left side of the body with the mirror image of the right side half a cycle
    /// later. `clip` is the clip that the phase was found in.
    ///
    /// # Errors
    /// As [`compare`](Self::compare); [`Unsupported`](crate::ErrorKind::Unsupported) if the sides
    /// cannot be compared.
    pub fn compare_left_right(
        &self,
        clip: &Clip,
        label: Option<usize>,
        samples: usize,
        options: &Options,
    ) -> Result<Comparison> {
        let (label, wanted) = (number(label)?, c_count(samples)?);
        let found = options.call(|options| {
            // SAFETY: live handles.
            Owned::make(|out| unsafe {
                sys::stltsa_compare_left_right(clip.raw(), self.raw(), label, wanted, options, out)
            })
        })?;
        Comparison::read(found)
    }
}

impl Cycles {
    /// Compares left with right half a cycle later: signals whose names differ only in the side, such
    /// as `knee_l` and `knee_r`; one name for each column. Both signals must have the same sign
    /// convention, as flexion has. `fps`: frames per second; 0: unknown, so that times are NaN.
    ///
    /// # Errors
    /// [`Shape`](crate::ErrorKind::Shape) unless there is one name for each column,
    /// [`Unsupported`](crate::ErrorKind::Unsupported) if no two of them differ only in the side, or
    /// the halves of the cycles are not known to be alike.
    pub fn compare_left_right(&self, names: &[&str], fps: f64) -> Result<Comparison> {
        if names.len() != self.columns() {
            let text = format!("there are {} names and {} columns", names.len(), self.columns());
            return Err(Error::new(ErrorKind::Shape, text));
        }
        let texts = names.iter().map(|name| c_name(name)).collect::<Result<Vec<_>>>()?;
        let raw: Vec<_> = texts.iter().map(|text| text.as_ptr()).collect();
        let options = std::ptr::null();
        // SAFETY: a live handle, a text for each column.
        Comparison::read(Owned::make(|out| unsafe {
            sys::stltsa_cycles_compare_left_right(self.raw(), raw.as_ptr(), fps, options, out)
        })?)
    }
}

fn number(label: Option<usize>) -> Result<i32> {
    label.map_or(Ok(-1), |label| {
        i32::try_from(label)
            .map_err(|_| Error::new(ErrorKind::Argument, format!("there is no label {label}")))
    })
}

type Found = Owned<sys::stltsa_comparison>;

impl Comparison {
    /// Writes a report: one HTML page that a browser shows without a network. `command`: which
    /// repeats it.
    ///
    /// # Errors
    /// [`Io`](crate::ErrorKind::Io), [`Argument`](crate::ErrorKind::Argument) if `command` contains
    /// a NUL.
    pub fn report(&self, path: impl AsRef<Path>, command: Option<&str>) -> Result<()> {
        let path = c_path(path.as_ref())?;
        let command = command.map(c_name).transpose()?;
        let text = command.as_ref().map_or(std::ptr::null(), |text| text.as_ptr());
        // SAFETY: a live handle, and strings that live through the call.
        check(unsafe { sys::stltsa_comparison_report_save(self.handle.raw(), text, path.as_ptr()) })
    }

    fn read(handle: Found) -> Result<Self> {
        let found = &handle;
        // SAFETY: a struct of numbers, for which zeros are valid.
        let mut raw: sys::stltsa_compared_cycles = unsafe { std::mem::zeroed() };
        raw.size = std::mem::size_of::<sys::stltsa_compared_cycles>();
        // SAFETY: a live handle, a struct of the size it says.
        check(unsafe { sys::stltsa_comparison_cycles(found.raw(), &mut raw) })?;
        let channels = channels(found)?;
        let size = (count(raw.samples)?, channels.len());
        let curves = |which, output| curves(found, which, output, size);
        let differences = |output| differences(found, output, size);
        Ok(Self {
            parts: parts(found)?,
            counts: [count(raw.first_count)?, count(raw.second_count)?],
            labels: [count(raw.first_label.into())?, count(raw.second_label.into())?],
            cycle_time: difference(&raw.cycle_time),
            per_minute: [raw.first_per_minute, raw.second_per_minute],
            shift: raw.shift,
            shift_error: raw.shift_error,
            shift_interval: [raw.shift_low, raw.shift_high],
            likeness: raw.likeness,
            runner_up: raw.runner_up,
            turn: raw.turn,
            size_ratio: raw.size_ratio,
            judged: count(raw.judged)?,
            significant: count(raw.significant)?,
            sides: raw.sides == 1,
            mean: [curves(0, 0)?, curves(1, 0)?],
            deviation: [curves(0, 1)?, curves(1, 1)?],
            difference: differences(0)?,
            standard_error: differences(1)?,
            margin: differences(2)?,
            left_out: [left_out(found, 0), left_out(found, 1)],
            // SAFETY: a live handle.
            warnings: unsafe {
                texts(sys::stltsa_comparison_warning_count(found.raw()), |index| {
                    sys::stltsa_comparison_warning(found.raw(), index)
                })
            },
            json: json(found)?,
            channels,
            handle: Arc::new(handle),
        })
    }
}

fn json(found: &Found) -> Result<String> {
    let mut raw = std::ptr::null_mut();
    // SAFETY: a live handle; the text is the caller's, who frees it.
    unsafe {
        check(sys::stltsa_comparison_json(found.raw(), &mut raw))?;
        let json = text(raw);
        sys::stltsa_free(raw.cast());
        Ok(json)
    }
}

fn curves(found: &Found, which: i32, output: usize, size: (usize, usize)) -> Result<Matrix> {
    Matrix::filled(size.0, size.1, |out| {
        let mut outputs = [std::ptr::null(); 2];
        outputs[output] = out;
        // SAFETY: a live handle, an array of the size it says.
        unsafe { sys::stltsa_comparison_curves(found.raw(), which, outputs[0], outputs[1]) }
    })
}

fn differences(found: &Found, output: usize, size: (usize, usize)) -> Result<Matrix> {
    Matrix::filled(size.0, size.1, |out| {
        let mut outputs = [std::ptr::null(); 3];
        outputs[output] = out;
        // SAFETY: a live handle, an array of the size it says.
        unsafe {
            sys::stltsa_comparison_difference(found.raw(), outputs[0], outputs[1], outputs[2])
        }
    })
}

fn left_out(found: &Found, which: i32) -> Vec<String> {
    // SAFETY: a live handle.
    unsafe {
        texts(sys::stltsa_comparison_left_out_count(found.raw(), which), |index| {
            sys::stltsa_comparison_left_out(found.raw(), which, index)
        })
    }
}

fn empty() -> sys::stltsa_compared_part {
    // SAFETY: a struct of numbers, for which zeros are valid.
    let mut raw: sys::stltsa_compared_part = unsafe { std::mem::zeroed() };
    raw.size = std::mem::size_of::<sys::stltsa_compared_part>();
    raw
}

fn parts(found: &Found) -> Result<Vec<ComparedPart>> {
    // SAFETY: a live handle.
    let parts = unsafe { sys::stltsa_comparison_part_count(found.raw()) };
    let read = |index| {
        let mut raw = empty();
        // SAFETY: a live handle, a struct of the size it says.
        check(unsafe { sys::stltsa_comparison_part(found.raw(), index, &mut raw) })?;
        Ok(part(found, &raw, String::new()))
    };
    (0..parts).map(read).collect()
}

fn channels(found: &Found) -> Result<Vec<ComparedPart>> {
    // SAFETY: a live handle.
    let channels = unsafe { sys::stltsa_comparison_channel_count(found.raw()) };
    let read = |index| {
        let mut raw = empty();
        // SAFETY: a live handle, a struct of the size it says.
        check(unsafe { sys::stltsa_comparison_channel(found.raw(), index, &mut raw) })?;
        // SAFETY: a live handle.
        let axis = unsafe { text(sys::stltsa_comparison_channel_axis(found.raw(), index)) };
        Ok(part(found, &raw, axis))
    };
    (0..channels).map(read).collect()
}

fn part(found: &Found, raw: &sys::stltsa_compared_part, axis: String) -> ComparedPart {
    let name = |which| {
        // SAFETY: a live handle.
        unsafe { text(sys::stltsa_comparison_part_name(found.raw(), which, raw.part)) }
    };
    ComparedPart {
        name: name(0),
        second_name: name(1),
        axis,
        rms: raw.rms,
        chance: raw.chance,
        correlation: raw.correlation,
        lag: difference(&raw.lag),
        amplitude: difference(&raw.amplitude),
        ratio: [raw.ratio, raw.ratio_low, raw.ratio_high],
        lag_s: [raw.lag_s, raw.lag_low_s, raw.lag_high_s],
        mean: difference(&raw.mean),
    }
}

fn difference(raw: &sys::stltsa_estimate) -> Difference {
    Difference {
        first: raw.first,
        first_sd: raw.first_sd,
        second: raw.second,
        second_sd: raw.second_sd,
        difference: raw.difference,
        standard_error: raw.standard_error,
        low: raw.low,
        high: raw.high,
        significant: raw.significant == 1,
    }
}
