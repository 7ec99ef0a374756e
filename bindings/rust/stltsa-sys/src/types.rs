// SPDX-License-Identifier: BSD-3-Clause
//! The types of `stltsa.h`.

use std::marker::{PhantomData, PhantomPinned};
use std::os::raw::{c_char, c_void};

pub type stltsa_status = i32;

/// `NULL` is `None`. A panic must not leave it.
pub type stltsa_progress =
    Option<unsafe extern "C" fn(user: *mut c_void, stage: i32, fraction: f64) -> i32>;

/// A type that only the library knows: neither made, moved, nor sent to another thread from here.
macro_rules! opaque {
    ($($name:ident)*) => {$(
        #[repr(C)]
        pub struct $name {
            _data: [u8; 0],
            _marker: PhantomData<(*mut u8, PhantomPinned)>,
        }
    )*};
}
opaque! {
    stltsa_options
    stltsa_clip
    stltsa_model
    stltsa_dimension_result
    stltsa_decomposition
    stltsa_denoising
    stltsa_synthesis
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct stltsa_in {
    pub data: *const c_void,
    pub rows: i64,
    pub cols: i64,
    pub row_stride: i64,
    pub col_stride: i64,
    pub dtype: i32,
    pub reserved: i32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct stltsa_out {
    pub data: *mut c_void,
    pub rows: i64,
    pub cols: i64,
    pub row_stride: i64,
    pub col_stride: i64,
    pub dtype: i32,
    pub reserved: i32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct stltsa_option_info {
    pub size: usize,
    pub key: i32,
    pub r#type: i32,
    pub name: *const c_char,
    pub text: *const c_char,
    pub choices: *const c_char,
    pub minimum: f64,
    pub maximum: f64,
    pub standard: f64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct stltsa_interval {
    pub begin: i64,
    pub end: i64,
    pub begin_s: f64,
    pub end_s: f64,
    pub kind: i32,
    pub reserved: i32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct stltsa_piece {
    pub clip: *const stltsa_clip,
    pub begin: i64,
    pub end: i64,
    pub repeat: i64,
    pub reserved: i64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct stltsa_seam {
    pub size: usize,
    pub frame: i64,
    pub piece: i64,
    pub next: i64,
    pub cut_end: i64,
    pub cut_begin: i64,
    pub crossfade: i64,
    pub posture: f64,
    pub step: f64,
    pub acceleration: f64,
}
