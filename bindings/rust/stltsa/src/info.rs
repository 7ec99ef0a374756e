// SPDX-License-Identifier: BSD-3-Clause
//! [`Info`]: everything that an object says, by key.

use std::marker::PhantomData;
use std::mem::size_of;

use stltsa_sys as sys;

use crate::array::Matrix;
use crate::error::{c_count, check, count, got, text, Error, ErrorKind, Result};
use crate::kinds::Fact;
use crate::rows::Row;

/// What an object says, by key: facts, lists of values and of rows, and arrays.
///
/// ```
/// use stltsa::{Clip, Fact};
///
/// let clip = Clip::from_matrix(&[[1.0, 2.0], [3.0, 4.0]], 50.0)?;
/// assert_eq!(clip.info().real(Fact::ClipFps)?, 50.0);
/// assert_eq!(clip.info().count(Fact::Joint), 0);
/// # Ok::<(), stltsa::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Info<'a> {
    raw: *const sys::stltsa_info,
    of: PhantomData<&'a ()>,
}

// SAFETY: a const handle, which any number of threads may use at once.
unsafe impl Send for Info<'_> {}
unsafe impl Sync for Info<'_> {}

// SAFETY of all calls: the info, and with it its texts, lives as long as the object.
impl Info<'_> {
    /// # Safety
    /// The object that `raw` belongs to is alive and outlives the result.
    pub(crate) unsafe fn new(raw: *const sys::stltsa_info) -> Self {
        Info { raw, of: PhantomData }
    }

    /// The number of values, rows or arrays of a key; 0 if the object has none.
    pub fn count(&self, key: Fact) -> usize {
        count(unsafe { sys::stltsa_info_count(self.raw, key.raw()) })
    }

    /// A fact that is an integer.
    ///
    /// # Errors
    /// [`Argument`](ErrorKind::Argument): the object lacks it, or the key has another type; of all
    /// functions here.
    pub fn int(&self, key: Fact) -> Result<i64> {
        self.int_at(key, 0)
    }

    /// A fact that is a real number.
    ///
    /// # Errors
    /// As [`Info::int`].
    pub fn real(&self, key: Fact) -> Result<f64> {
        self.real_at(key, 0)
    }

    /// A fact that is a text.
    ///
    /// # Errors
    /// As [`Info::int`].
    pub fn text(&self, key: Fact) -> Result<String> {
        self.text_at(key, 0)
    }

    /// The integers of a key; empty if the object has none.
    ///
    /// # Errors
    /// [`Argument`](ErrorKind::Argument): the key has another type.
    pub fn ints(&self, key: Fact) -> Result<Vec<i64>> {
        (0..self.count(key)).map(|index| self.int_at(key, index as i64)).collect()
    }

    /// The real numbers of a key.
    ///
    /// # Errors
    /// As [`Info::ints`].
    pub fn reals(&self, key: Fact) -> Result<Vec<f64>> {
        (0..self.count(key)).map(|index| self.real_at(key, index as i64)).collect()
    }

    /// The texts of a key.
    ///
    /// # Errors
    /// As [`Info::ints`].
    pub fn texts(&self, key: Fact) -> Result<Vec<String>> {
        (0..self.count(key)).map(|index| self.text_at(key, index as i64)).collect()
    }

    /// The rows of a list, as the struct that the key names; empty if the object has none.
    ///
    /// ```
    /// # use stltsa::{Clip, Fact, Joint};
    /// # let clip = Clip::from_matrix(&[[1.0, 2.0], [3.0, 4.0]], 50.0)?;
    /// assert_eq!(clip.info().rows::<Joint>(Fact::Joint)?, []);
    /// # Ok::<(), stltsa::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Argument`](ErrorKind::Argument): the key names another struct.
    pub fn rows<T: Row>(&self, key: Fact) -> Result<Vec<T>> {
        if !T::KEYS.contains(&key) {
            let text = format!("{key:?} is not a list of these rows, but {:?} are", T::KEYS);
            return Err(Error::new(ErrorKind::Argument, text));
        }
        let count = self.count(key);
        let mut rows = Vec::<T::Raw>::with_capacity(count);
        if count > 0 {
            let (all, size) = (c_count(count)?, size_of::<T::Raw>());
            let room = rows.as_mut_ptr().cast();
            // SAFETY: also, there is room for `count` rows of the key's struct, which are written.
            unsafe {
                check(sys::stltsa_info_rows(self.raw, key.raw(), 0, all, room, size))?;
                rows.set_len(count);
            }
        }
        Ok(rows.into_iter().map(|row| unsafe { T::of(row) }).collect())
    }

    /// The rows of a key that names them.
    pub(crate) fn list<T: Row>(&self, key: Fact) -> Vec<T> {
        self.rows(key).expect("a live handle gives its rows")
    }

    /// Rows and columns of an array.
    ///
    /// # Errors
    /// As [`Info::int`].
    pub fn shape(&self, key: Fact) -> Result<(usize, usize)> {
        let (mut rows, mut cols) = (0, 0);
        check(unsafe { sys::stltsa_info_shape(self.raw, key.raw(), &mut rows, &mut cols) })?;
        Ok((count(rows), count(cols)))
    }

    /// An array; `index`: which of several, otherwise 0.
    ///
    /// # Errors
    /// As [`Info::int`].
    pub fn array(&self, key: Fact, index: usize) -> Result<Matrix> {
        let ((rows, cols), index) = (self.shape(key)?, c_count(index)?);
        Matrix::filled(rows, cols, |out| unsafe {
            sys::stltsa_info_array(self.raw, key.raw(), index, out)
        })
    }

    /// The array of a key that every object of its kind has.
    pub(crate) fn matrix(&self, key: Fact) -> Matrix {
        self.array(key, 0).expect("a live handle gives its arrays")
    }

    /// The same of a single column.
    pub(crate) fn column(&self, key: Fact) -> Vec<f64> {
        self.matrix(key).into_vec()
    }

    /// One JSON object.
    ///
    /// # Errors
    /// [`Unsupported`](ErrorKind::Unsupported): a phase, cycles, events or a stream.
    pub fn json(&self) -> Result<String> {
        let mut raw = std::ptr::null_mut();
        // SAFETY: also, the call gives a text that this side has to free.
        unsafe {
            check(sys::stltsa_info_json(self.raw, &mut raw))?;
            let copy = text(raw);
            sys::stltsa_free(raw.cast());
            Ok(copy)
        }
    }

    fn int_at(&self, key: Fact, index: i64) -> Result<i64> {
        got(0, |out| unsafe { sys::stltsa_info_int(self.raw, key.raw(), index, out) })
    }

    fn real_at(&self, key: Fact, index: i64) -> Result<f64> {
        got(0.0, |out| unsafe { sys::stltsa_info_real(self.raw, key.raw(), index, out) })
    }

    fn text_at(&self, key: Fact, index: i64) -> Result<String> {
        let raw = got(std::ptr::null(), |out| unsafe {
            sys::stltsa_info_text(self.raw, key.raw(), index, out)
        })?;
        Ok(unsafe { text(raw) })
    }
}
