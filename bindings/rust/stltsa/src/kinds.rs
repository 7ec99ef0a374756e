// SPDX-License-Identifier: BSD-3-Clause
//! The library's enumerations. Values that this crate does not know are `Other`.

use std::fmt;

use stltsa_sys as sys;

macro_rules! kinds {
    ($($(#[$text:meta])* $name:ident { $($(#[$what:meta])* $variant:ident = $value:ident,)* })*) => {$(
        $(#[$text])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum $name {
            $($(#[$what])* $variant,)*
            /// A value unknown to this version of the crate.
            Other(i32),
        }

        impl From<i64> for $name {
            /// The kind of a number of the library, such as [`Info::int`](crate::Info::int) gives.
            fn from(value: i64) -> Self {
                match i32::try_from(value).unwrap_or(i32::MAX) {
                    $(stltsa_sys::$value => Self::$variant,)*
                    other => Self::Other(other),
                }
            }
        }

        impl $name {
            #[allow(dead_code)] // some are only results
            pub(crate) fn raw(self) -> i32 {
                match self {
                    $(Self::$variant => stltsa_sys::$value,)*
                    Self::Other(other) => other,
                }
            }
        }
    )*};
}

mod generated;

pub use generated::*;

impl fmt::Display for UnitKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // SAFETY: a static text for any number.
        f.pad(&unsafe { crate::error::text(sys::stltsa_unit_name(self.raw().into())) })
    }
}

impl fmt::Display for SegmentKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // SAFETY: a static text for any number.
        f.pad(&unsafe { crate::error::text(sys::stltsa_segment_name(self.raw().into())) })
    }
}

/// An axis of the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// x.
    X = 1,
    /// y.
    Y = 2,
    /// z.
    Z = 3,
}

impl Axis {
    pub(crate) fn raw(self) -> i32 {
        self as i32
    }
}
