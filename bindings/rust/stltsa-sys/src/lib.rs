// SPDX-License-Identifier: BSD-3-Clause
//! Declarations of libstltsa's C interface, as bindgen reads them from `stltsa.h`, names unchanged.
//!
//! The header's comments are the reference manual: arguments, ownership, errors, threads. The crate
//! `stltsa` is the safe interface to these functions.
//!
//! Enum values are `i32` constants, the type that the functions take, because a newer library may
//! return values that these declarations do not know.
#![allow(non_camel_case_types)]

mod declarations;

pub use declarations::*;
