// SPDX-License-Identifier: BSD-3-Clause
//! [`Side`] of the body, as names state it.

use std::ffi::CString;

use stltsa_sys as sys;

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
        Self::from_raw(unsafe { sys::stltsa_side_of_name(name.as_ptr()) })
    }

    pub(crate) fn from_raw(side: i32) -> Option<Self> {
        match side {
            sys::STLTSA_SIDE_LEFT => Some(Self::Left),
            sys::STLTSA_SIDE_RIGHT => Some(Self::Right),
            _ => None,
        }
    }
}
