// SPDX-License-Identifier: BSD-3-Clause
//! Arrays in and out: [`View`] borrows the caller's array, [`Matrix`] owns a result.

use std::marker::PhantomData;
use std::mem::size_of;
use std::ops::Index;
use std::os::raw::c_void;

use stltsa_sys as sys;

use crate::error::{c_count, check, Error, ErrorKind, Result};

mod sealed {
    pub trait Sealed {
        const DTYPE: i32;
    }
    impl Sealed for f32 {
        const DTYPE: i32 = stltsa_sys::STLTSA_F32;
    }
    impl Sealed for f64 {
        const DTYPE: i32 = stltsa_sys::STLTSA_F64;
    }
}

/// Types of numbers that the library reads: `f32` and `f64`.
pub trait Element: sealed::Sealed + Copy {}
impl Element for f32 {}
impl Element for f64 {}

/// A borrowed array of `f32` or `f64`, rows x columns, one frame per row.
///
/// Functions take anything that is `Into<View>`: `&Matrix`, slices and vectors of arrays (`&[[f64;
/// 6]]`), and with the feature `ndarray` its two-dimensional arrays and views. Packed `f64` is used
/// in place; anything else is copied once.
///
/// ```
/// use stltsa::View;
///
/// let numbers = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0_f32];
/// let view = View::new(&numbers, 3, 2)?;
/// assert_eq!((view.rows(), view.cols()), (3, 2));
///
/// // The same numbers, last row first, only the second column.
/// let reversed = View::strided(&numbers, 5, (3, 1), (-2, 1))?;
/// assert_eq!((reversed.rows(), reversed.cols()), (3, 1));
/// # Ok::<(), stltsa::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct View<'a> {
    data: *const c_void,
    rows: usize,
    cols: usize,
    /// In bytes.
    strides: (isize, isize),
    dtype: i32,
    borrowed: PhantomData<&'a [f64]>,
}

// SAFETY: as `&[f64]` and `&[f32]`, which this stands for.
unsafe impl Send for View<'_> {}
unsafe impl Sync for View<'_> {}

impl<'a> View<'a> {
    /// `data`, row by row.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless `data` has `rows * cols` entries.
    pub fn new<T: Element>(data: &'a [T], rows: usize, cols: usize) -> Result<Self> {
        if rows.checked_mul(cols) != Some(data.len()) {
            let n = data.len();
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{rows} x {cols} frames are not {n} entries"),
            ));
        }
        Ok(Self::packed(data, rows, cols))
    }

    /// Entry (r, c) is `data[start + r * strides.0 + c * strides.1]`: strides count entries and may
    /// be negative, or 0 to repeat.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] if an entry would lie outside `data`.
    pub fn strided<T: Element>(
        data: &'a [T],
        start: usize,
        shape: (usize, usize),
        strides: (isize, isize),
    ) -> Result<Self> {
        let is_empty = shape.0 == 0 || shape.1 == 0;
        if !is_empty && !reaches_only_inside(data.len(), start, shape, strides) {
            let n = data.len();
            return Err(Error::new(
                ErrorKind::Shape,
                format!(
                    "{} x {} frames from entry {start} with strides {strides:?} reach outside of \
                     {n} entries",
                    shape.0, shape.1
                ),
            ));
        }
        let first = if is_empty { data } else { &data[start..] };
        // SAFETY: checked above: every entry lies inside `data`.
        Ok(unsafe { Self::from_raw_parts(first.as_ptr(), shape, strides) })
    }

    /// Number of rows (frames).
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns (features or coordinates).
    pub fn cols(&self) -> usize {
        self.cols
    }

    /// `data` has `rows * cols` entries.
    fn packed<T: Element>(data: &'a [T], rows: usize, cols: usize) -> Self {
        // SAFETY: all entries lie inside `data`, whose size in bytes fits in an isize.
        unsafe { Self::from_raw_parts(data.as_ptr(), (rows, cols), (cols as isize, 1)) }
    }

    /// # Safety
    /// All entries are readable for 'a; strides count entries.
    pub(crate) unsafe fn from_raw_parts<T: Element>(
        data: *const T,
        (rows, cols): (usize, usize),
        strides: (isize, isize),
    ) -> Self {
        let entry = size_of::<T>();
        // A stride along a dimension of one entry is arbitrary and may not fit when in bytes.
        let is_empty = rows == 0 || cols == 0;
        let bytes = |count: usize, stride: isize| match count {
            _ if is_empty => entry as isize,
            1 => entry as isize,
            _ => stride * entry as isize,
        };
        Self {
            data: data.cast(),
            rows,
            cols,
            strides: (bytes(rows, strides.0), bytes(cols, strides.1)),
            dtype: T::DTYPE,
            borrowed: PhantomData,
        }
    }

    /// The C descriptor.
    pub(crate) fn raw(&self) -> Result<sys::stltsa_in> {
        // In C, both strides 0 mean "packed".
        if self.strides == (0, 0) {
            return Err(Error::new(
                ErrorKind::Shape,
                "both strides are 0: all frames are one number",
            ));
        }
        Ok(sys::stltsa_in {
            data: self.data,
            rows: c_count(self.rows)?,
            cols: c_count(self.cols)?,
            row_stride: self.strides.0 as i64,
            col_stride: self.strides.1 as i64,
            dtype: self.dtype,
            reserved: 0,
        })
    }
}

/// Whether the corners of the array, and therefore all entries, lie in a slice of `length`.
fn reaches_only_inside(
    length: usize,
    start: usize,
    shape: (usize, usize),
    strides: (isize, isize),
) -> bool {
    let reach = |count: usize, stride: isize| (count as i128 - 1) * stride as i128;
    let (down, right) = (reach(shape.0, strides.0), reach(shape.1, strides.1));
    let least = start as i128 + down.min(0) + right.min(0);
    let most = start as i128 + down.max(0) + right.max(0);
    least >= 0 && most < length as i128
}

impl<'a, T: Element, const N: usize> From<&'a [[T; N]]> for View<'a> {
    fn from(frames: &'a [[T; N]]) -> Self {
        // SAFETY: an array of arrays is packed, and lives for 'a.
        unsafe {
            Self::from_raw_parts(frames.as_ptr().cast::<T>(), (frames.len(), N), (N as isize, 1))
        }
    }
}

impl<'a, T: Element, const N: usize> From<&'a Vec<[T; N]>> for View<'a> {
    fn from(frames: &'a Vec<[T; N]>) -> Self {
        frames.as_slice().into()
    }
}

impl<'a, T: Element, const N: usize, const M: usize> From<&'a [[T; N]; M]> for View<'a> {
    fn from(frames: &'a [[T; N]; M]) -> Self {
        frames.as_slice().into()
    }
}

impl<'a> From<&'a Matrix> for View<'a> {
    fn from(matrix: &'a Matrix) -> Self {
        Self::packed(&matrix.data, matrix.rows, matrix.cols)
    }
}

/// An array of `f64`, row by row, returned by a function.
///
/// ```
/// use stltsa::Matrix;
///
/// let matrix = Matrix::from_vec(vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0], 3, 2)?;
/// assert_eq!(matrix[(2, 0)], 5.0);
/// assert_eq!(matrix.row(1), [3.0, 4.0]);
/// assert!(matrix.column(1).eq([2.0, 4.0, 6.0]));
/// # Ok::<(), stltsa::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Matrix {
    data: Vec<f64>,
    rows: usize,
    cols: usize,
}

impl Matrix {
    /// `data`, row by row.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless `data` has `rows * cols` entries.
    pub fn from_vec(data: Vec<f64>, rows: usize, cols: usize) -> Result<Self> {
        View::new(&data, rows, cols)?;
        Ok(Self { data, rows, cols })
    }

    /// Number of rows (frames, samples or points).
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns.
    pub fn cols(&self) -> usize {
        self.cols
    }

    /// Row `index`; panics if there is none.
    pub fn row(&self, index: usize) -> &[f64] {
        assert!(index < self.rows, "row {index} of {}", self.rows);
        &self.data[index * self.cols..(index + 1) * self.cols]
    }

    /// The entries of column `index`; panics if there is none.
    pub fn column(&self, index: usize) -> impl Iterator<Item = f64> + '_ {
        assert!(index < self.cols, "column {index} of {}", self.cols);
        self.data[index.min(self.data.len())..].iter().step_by(self.cols).copied()
    }

    /// All entries, row by row.
    pub fn as_slice(&self) -> &[f64] {
        &self.data
    }

    /// All entries, row by row, without a copy.
    pub fn into_vec(self) -> Vec<f64> {
        self.data
    }

    /// Lets `write` fill a new matrix.
    pub(crate) fn filled(
        rows: usize,
        cols: usize,
        write: impl FnOnce(&sys::stltsa_out) -> sys::stltsa_status,
    ) -> Result<Self> {
        let mut matrix = Self::zeros(rows, cols)?;
        check(write(&matrix.raw_out()?))?;
        Ok(matrix)
    }

    pub(crate) fn zeros(rows: usize, cols: usize) -> Result<Self> {
        let entries = rows.checked_mul(cols).ok_or_else(|| {
            Error::new(ErrorKind::NoMemory, format!("{rows} x {cols} entries are too many"))
        })?;
        Ok(Self { data: vec![0.0; entries], rows, cols })
    }

    /// The C descriptor to write to.
    pub(crate) fn raw_out(&mut self) -> Result<sys::stltsa_out> {
        Ok(sys::stltsa_out {
            data: self.data.as_mut_ptr().cast(),
            rows: c_count(self.rows)?,
            cols: c_count(self.cols)?,
            row_stride: 0,
            col_stride: 0,
            dtype: sys::STLTSA_F64,
            reserved: 0,
        })
    }
}

/// A list of integers, one a row, as C takes it.
pub(crate) fn list_in(list: &[i64]) -> Result<sys::stltsa_in> {
    Ok(sys::stltsa_in {
        data: list.as_ptr().cast(),
        rows: c_count(list.len())?,
        cols: 1,
        row_stride: 0,
        col_stride: 0,
        dtype: sys::STLTSA_I64,
        reserved: 0,
    })
}

/// The same to write to.
pub(crate) fn list_out(list: &mut [i64]) -> Result<sys::stltsa_out> {
    Ok(sys::stltsa_out {
        data: list.as_mut_ptr().cast(),
        rows: c_count(list.len())?,
        cols: 1,
        row_stride: 0,
        col_stride: 0,
        dtype: sys::STLTSA_I64,
        reserved: 0,
    })
}

impl Index<(usize, usize)> for Matrix {
    type Output = f64;

    /// Entry (row, column); panics if there is none.
    fn index(&self, (row, column): (usize, usize)) -> &f64 {
        &self.row(row)[column]
    }
}
