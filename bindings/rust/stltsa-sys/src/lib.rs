// SPDX-License-Identifier: BSD-3-Clause
//! Declarations of libstltsa's C interface, as bindgen reads them from `stltsa.h`, names unchanged.
//!
//! The header's comments are the reference manual: what each function takes, who owns what, which
//! errors there are, what threads may do. The crate `stltsa` is the safe interface above this one.
//!
//! Enum values are `i32` constants, as the functions take them: a library newer than these
//! declarations may return values that they do not know.
#![allow(non_camel_case_types)]

mod declarations;

pub use declarations::*;
