// SPDX-License-Identifier: BSD-3-Clause
//! The rows of lists, copied from C. The structs and the meaning of their members are the header's.

use std::os::raw::c_char;

use stltsa_sys as sys;

use crate::error::{count, text};
use crate::kinds::{Fact, Features, SegmentKind, UnitKind, WarningKind};

pub(crate) mod copied {
    use crate::kinds::Fact;

    pub trait Copied: Sized {
        type Raw: Copy;
        const KEYS: &'static [Fact];

        /// # Safety
        /// The texts in `raw` are valid.
        unsafe fn of(raw: Self::Raw) -> Self;
    }
}
use copied::Copied;

/// A row of a list: see [`Info::rows`](crate::Info::rows).
pub trait Row: Copied {}

macro_rules! rows {
    ($($(#[$text:meta])* $name:ident: $raw:ident [$($key:ident),*] {
        $($(#[$what:meta])* $member:ident: $type:ty = $convert:path,)*
    })*) => {$(
        $(#[$text])*
        #[allow(clippy::derive_partial_eq_without_eq)] // a real number may be added
        #[derive(Clone, Debug, PartialEq)]
        pub struct $name {
            $($(#[$what])* pub $member: $type,)*
        }

        impl Row for $name {}

        impl Copied for $name {
            type Raw = sys::$raw;
            const KEYS: &'static [Fact] = &[$(Fact::$key),*];

            #[allow(unused_unsafe)] // some have no texts
            unsafe fn of(raw: Self::Raw) -> Self {
                // SAFETY: as the caller promises.
                unsafe { Self { $($member: $convert(raw.$member),)* } }
            }
        }
    )*};
}

mod generated;

pub use generated::*;

macro_rules! intervals {
    ($($name:ident)*) => {$(
        impl $name {
            /// `begin..end`, as [`Piece::new`](crate::Piece::new) takes it.
            pub fn frames(&self) -> std::ops::Range<usize> {
                self.begin..self.end
            }
        }
    )*};
}
intervals! { Unit Segment Part PieceFact }

fn flag(value: i64) -> bool {
    value != 0
}

/// -1 is none.
fn index(value: i64) -> Option<usize> {
    usize::try_from(value).ok()
}

/// NaN is none.
fn number(value: f64) -> Option<f64> {
    Some(value).filter(|value| !value.is_nan())
}

/// NULL is none.
///
/// # Safety
/// As for [`text`].
unsafe fn nullable(raw: *const c_char) -> Option<String> {
    // SAFETY: as the caller promises.
    (!raw.is_null()).then(|| unsafe { text(raw) })
}

/// "" is none.
///
/// # Safety
/// As for [`text`].
unsafe fn filled(raw: *const c_char) -> Option<String> {
    // SAFETY: as the caller promises.
    Some(unsafe { text(raw) }).filter(|text| !text.is_empty())
}

/// Those before NULL.
///
/// # Safety
/// `raw` is NULL, or has texts, and NULL after the last.
unsafe fn texts(raw: *const *const c_char) -> Vec<String> {
    // SAFETY: as the caller promises.
    let at = |index| unsafe { nullable(*raw.add(index)) };
    (0..).take_while(|_| !raw.is_null()).map_while(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An older library does not write the members that it does not know.
    #[test]
    fn texts_that_are_not_there_are_empty() {
        // SAFETY: NULL is allowed.
        unsafe {
            assert_eq!((text(std::ptr::null()), nullable(std::ptr::null())), (String::new(), None));
            assert_eq!((filled(std::ptr::null()), texts(std::ptr::null())), (None, vec![]));
        }
    }
}
