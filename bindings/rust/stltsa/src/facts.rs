// SPDX-License-Identifier: BSD-3-Clause
//! [`Facts`]: facts about an object by key.

use std::marker::PhantomData;

use stltsa_sys as sys;

use crate::error::{got, text, Result};
use crate::kinds::Fact;
use crate::{Clip, Decomposition, Denoising, Dimension, Model, Synthesis};

/// Facts about an object by key: all facts of its JSON outside arrays, intervals and seams.
///
/// ```
/// use stltsa::{Clip, Fact};
///
/// let clip = Clip::from_matrix(&[[1.0, 2.0], [3.0, 4.0]], 50.0)?;
/// assert_eq!(clip.facts().reals(Fact::ClipFps)?, [50.0]);
/// assert!(clip.facts().reals(Fact::Residual)?.is_empty());
/// # Ok::<(), stltsa::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Facts<'a> {
    raw: *const sys::stltsa_info,
    of: PhantomData<&'a ()>,
}

// SAFETY: a const handle, which any number of threads may use at once.
unsafe impl Send for Facts<'_> {}
unsafe impl Sync for Facts<'_> {}

impl Facts<'_> {
    /// # Safety
    /// The object that `raw` belongs to is alive and outlives the result.
    pub(crate) unsafe fn new(raw: *const sys::stltsa_info) -> Self {
        Facts { raw, of: PhantomData }
    }

    pub(crate) fn int(&self, key: Fact, index: i64) -> Result<i64> {
        // SAFETY: the info lives as long as the object.
        got(|out| unsafe { sys::stltsa_info_int(self.raw, key.raw(), index, out) })
    }

    pub(crate) fn real(&self, key: Fact, index: i64) -> Result<f64> {
        // SAFETY: the info lives as long as the object.
        got(|out| unsafe { sys::stltsa_info_real(self.raw, key.raw(), index, out) })
    }

    /// The integers of a key: empty if the object does not have that fact, one unless it is a list.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument): the key has another type.
    pub fn ints(&self, key: Fact) -> Result<Vec<i64>> {
        self.values(key, |index| self.int(key, index))
    }

    /// The real numbers of a key.
    ///
    /// # Errors
    /// As [`Facts::ints`].
    pub fn reals(&self, key: Fact) -> Result<Vec<f64>> {
        self.values(key, |index| self.real(key, index))
    }

    /// The texts of a key.
    ///
    /// # Errors
    /// As [`Facts::ints`].
    pub fn texts(&self, key: Fact) -> Result<Vec<String>> {
        self.values(key, |index| {
            let mut raw = std::ptr::null();
            // SAFETY: the info, and with it the text, lives as long as the object.
            unsafe {
                crate::error::check(sys::stltsa_info_text(self.raw, key.raw(), index, &mut raw))?;
                Ok(text(raw))
            }
        })
    }

    fn values<T>(&self, key: Fact, get: impl Fn(i64) -> Result<T>) -> Result<Vec<T>> {
        // SAFETY: the info lives as long as the object.
        let count = unsafe { sys::stltsa_info_count(self.raw, key.raw()) };
        (0..count).map(get).collect()
    }
}

macro_rules! facts {
    ($($name:ident: $info:ident)*) => {$(
        impl $name {
            /// What is known, by key.
            pub fn facts(&self) -> Facts<'_> {
                // SAFETY: a live handle, which the result borrows.
                unsafe { Facts::new(sys::$info(self.handle.raw())) }
            }
        }
    )*};
}
facts! {
    Clip: stltsa_clip_info
    Model: stltsa_model_info
    Dimension: stltsa_dimension_info
    Decomposition: stltsa_decomposition_info
    Denoising: stltsa_denoising_info
    Synthesis: stltsa_synthesis_info
}
