// SPDX-License-Identifier: BSD-3-Clause
//! Ownership of objects that the library allocates.

use std::fmt;
use std::ptr::NonNull;

use stltsa_sys as sys;

use crate::error::{check, Result};
use crate::info::Info;
use crate::kinds::Fact;
use crate::rows::Warning;
use crate::{
    Clip, Comparison, Cycles, Decomposition, Denoising, Events, Live, Model, Phase, Synthesis,
};

/// An opaque type of the library, with the function that frees it.
pub(crate) trait Handle {
    /// # Safety
    /// `raw` comes from the library and is not used again.
    unsafe fn free(raw: *mut Self);
}

macro_rules! handles {
    ($($name:ident: $free:ident)*) => {$(
        impl Handle for sys::$name {
            unsafe fn free(raw: *mut Self) {
                unsafe { sys::$free(raw) }
            }
        }
    )*};
}
handles! {
    stltsa_options: stltsa_options_free
    stltsa_batch: stltsa_batch_free
    stltsa_clip: stltsa_clip_free
    stltsa_model: stltsa_model_free
    stltsa_decomposition: stltsa_decomposition_free
    stltsa_denoising: stltsa_denoising_free
    stltsa_phase: stltsa_phase_free
    stltsa_comparison: stltsa_comparison_free
    stltsa_events: stltsa_events_free
    stltsa_live: stltsa_live_free
    stltsa_cycles: stltsa_cycles_free
    stltsa_synthesis: stltsa_synthesis_free
}

macro_rules! objects {
    ($($name:ident: $raw:ident, $info:ident)*) => {$(
        impl $name {
            /// Everything that it says, by key.
            pub fn info(&self) -> Info<'_> {
                // SAFETY: a live handle, which the result borrows.
                unsafe { Info::new(sys::$info(self.raw())) }
            }

            /// One JSON object: see [`Info::json`].
            ///
            /// # Errors
            /// As [`Info::json`].
            pub fn json(&self) -> Result<String> {
                self.info().json()
            }

            /// What a user should know about it.
            pub fn warnings(&self) -> Vec<Warning> {
                self.info().list(Fact::Warning)
            }

            pub(crate) fn raw(&self) -> *const sys::$raw {
                self.handle.raw()
            }
        }
    )*};
}
objects! {
    Clip: stltsa_clip, stltsa_clip_info
    Model: stltsa_model, stltsa_model_info
    Decomposition: stltsa_decomposition, stltsa_decomposition_info
    Denoising: stltsa_denoising, stltsa_denoising_info
    Phase: stltsa_phase, stltsa_phase_info
    Comparison: stltsa_comparison, stltsa_comparison_info
    Events: stltsa_events, stltsa_events_info
    Live: stltsa_live, stltsa_live_info
    Cycles: stltsa_cycles, stltsa_cycles_info
    Synthesis: stltsa_synthesis, stltsa_synthesis_info
}

/// A handle that this crate owns and frees.
pub(crate) struct Owned<T: Handle>(NonNull<T>);

impl<T: Handle> Owned<T> {
    /// Lets `make` write the new handle.
    pub fn make(make: impl FnOnce(*mut *mut T) -> sys::stltsa_status) -> Result<Self> {
        let mut raw = std::ptr::null_mut();
        check(make(&mut raw))?;
        Ok(Self(NonNull::new(raw).expect("a call that succeeds gives a handle")))
    }

    /// # Safety
    /// `raw` is not NULL, and nothing else frees it while the result lives.
    pub unsafe fn from_raw(raw: *const T) -> Self {
        // SAFETY: not NULL, says the caller.
        Self(unsafe { NonNull::new_unchecked(raw as *mut T) })
    }

    pub fn raw(&self) -> *const T {
        self.0.as_ptr()
    }

    pub fn raw_mut(&mut self) -> *mut T {
        self.0.as_ptr()
    }
}

impl<T: Handle> Drop for Owned<T> {
    fn drop(&mut self) {
        // SAFETY: made by the library, and this is its last use.
        unsafe { T::free(self.0.as_ptr()) }
    }
}

// SAFETY: the header lets a handle move between threads, any number of which may use it where it is
// const at once. `raw` gives const ones; `raw_mut` asks for `&mut`.
unsafe impl<T: Handle> Send for Owned<T> {}
unsafe impl<T: Handle> Sync for Owned<T> {}

impl<T: Handle> fmt::Debug for Owned<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
