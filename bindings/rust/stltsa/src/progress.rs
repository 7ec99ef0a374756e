// SPDX-License-Identifier: BSD-3-Clause
//! The progress closure, called from C: passes its answer back, and holds a panic until C has
//! returned.

use std::any::Any;
use std::ops::ControlFlow;
use std::os::raw::c_void;
use std::panic::{catch_unwind, resume_unwind, AssertUnwindSafe};
use std::sync::{Arc, Mutex};

use stltsa_sys as sys;

use crate::error::{check, Result};
use crate::handle::Owned;
use crate::kinds::Stage;

/// Shared by the clones of an [`Options`](crate::Options).
pub(crate) type Callback = Arc<Mutex<dyn FnMut(Stage, f64) -> ControlFlow<()> + Send>>;

/// One call of the library, as seen by its reports.
struct Watch<'a> {
    callback: &'a Callback,
    panic: Option<Box<dyn Any + Send>>,
}

impl Watch<'_> {
    fn report(&mut self, stage: Stage, fraction: f64) -> ControlFlow<()> {
        let mut callback = match self.callback.try_lock() {
            Ok(callback) => callback,
            // The callback is running on another thread, or further up this one: wait for the next
            // report.
            Err(_) => return ControlFlow::Continue(()),
        };
        match catch_unwind(AssertUnwindSafe(|| callback(stage, fraction))) {
            Ok(answer) => answer,
            Err(panic) => {
                self.panic = Some(panic);
                ControlFlow::Break(())
            }
        }
    }
}

/// The callback for the library.
unsafe extern "C" fn report(user: *mut c_void, stage: i32, fraction: f64) -> i32 {
    // SAFETY: `watched` gives the address of its `Watch`, and the library calls on its thread.
    let watch = unsafe { &mut *user.cast::<Watch<'_>>() };
    i32::from(watch.report(Stage::from(i64::from(stage)), fraction).is_break())
}

/// Runs `body`, one call of the library with `options`, and reports it to `callback`. A panic of
/// the closure continues from here.
pub(crate) fn watched<T>(
    options: &mut Owned<sys::stltsa_options>,
    callback: &Callback,
    body: impl FnOnce(*const sys::stltsa_options) -> Result<T>,
) -> Result<T> {
    let mut watch = Watch { callback, panic: None };
    let user: *mut Watch<'_> = &mut watch;
    // SAFETY: `report` gets what it expects, and `watch` outlives the only call with `options`.
    check(unsafe {
        sys::stltsa_options_set_progress(options.raw_mut(), Some(report), user.cast())
    })?;
    let result = body(options.raw());
    // SAFETY: the library has returned, so nobody else has the address.
    if let Some(panic) = unsafe { (*user).panic.take() } {
        drop(result);
        resume_unwind(panic);
    }
    result
}
