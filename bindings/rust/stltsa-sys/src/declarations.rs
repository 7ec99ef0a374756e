// SPDX-License-Identifier: BSD-3-Clause
// Made by scripts/generate-bindings: do not edit.
pub const STLTSA_VERSION_MAJOR: i32 = 0;
pub const STLTSA_VERSION_MINOR: i32 = 2;
pub const STLTSA_VERSION_PATCH: i32 = 0;
pub const STLTSA_VERSION_NUMBER: i32 = 200;
pub type stltsa_status = i32;
pub const STLTSA_OK: i32 = 0;
pub const STLTSA_E_ARGUMENT: i32 = -1;
pub const STLTSA_E_SHAPE: i32 = -2;
pub const STLTSA_E_NOT_FINITE: i32 = -3;
pub const STLTSA_E_TOO_FEW_FRAMES: i32 = -4;
pub const STLTSA_E_NO_MEMORY: i32 = -5;
pub const STLTSA_E_IO: i32 = -6;
pub const STLTSA_E_FORMAT: i32 = -7;
pub const STLTSA_E_DISCONNECTED: i32 = -8;
pub const STLTSA_E_DEGENERATE: i32 = -9;
pub const STLTSA_E_NOT_CONVERGED: i32 = -10;
pub const STLTSA_E_CANCELLED: i32 = -11;
pub const STLTSA_E_UNSUPPORTED: i32 = -12;
pub const STLTSA_E_INTERNAL: i32 = -13;
pub const STLTSA_E_NO_COMMON_POSTURE: i32 = -14;
pub const STLTSA_E_NO_SUCH_PART: i32 = -15;
extern "C" {
    pub fn stltsa_status_name(status: stltsa_status) -> *const ::std::os::raw::c_char;
}
extern "C" {
    pub fn stltsa_last_error() -> *const ::std::os::raw::c_char;
}
extern "C" {
    pub fn stltsa_version() -> *const ::std::os::raw::c_char;
}
pub const STLTSA_HAS_CHOLMOD: i32 = 1;
pub const STLTSA_HAS_OPENBLAS: i32 = 2;
extern "C" {
    pub fn stltsa_has(part: i32) -> i32;
}
extern "C" {
    pub fn stltsa_free(memory: *mut ::std::os::raw::c_void);
}
pub const STLTSA_F32: i32 = 1;
pub const STLTSA_F64: i32 = 2;
pub const STLTSA_I64: i32 = 3;
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_in {
    pub data: *const ::std::os::raw::c_void,
    pub rows: i64,
    pub cols: i64,
    pub row_stride: i64,
    pub col_stride: i64,
    pub dtype: i32,
    pub reserved: i32,
}
#[test]
fn bindgen_test_layout_stltsa_in() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_in>(),
        48usize,
        concat!("Size of: ", stringify!(stltsa_in))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_in>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_in))
    );
    fn test_field_data() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_in>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).data) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_in), "::", stringify!(data))
        );
    }
    test_field_data();
    fn test_field_rows() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_in>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).rows) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_in), "::", stringify!(rows))
        );
    }
    test_field_rows();
    fn test_field_cols() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_in>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).cols) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_in), "::", stringify!(cols))
        );
    }
    test_field_cols();
    fn test_field_row_stride() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_in>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).row_stride) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_in), "::", stringify!(row_stride))
        );
    }
    test_field_row_stride();
    fn test_field_col_stride() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_in>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).col_stride) as usize - ptr as usize
            },
            32usize,
            concat!("Offset of field: ", stringify!(stltsa_in), "::", stringify!(col_stride))
        );
    }
    test_field_col_stride();
    fn test_field_dtype() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_in>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).dtype) as usize - ptr as usize
            },
            40usize,
            concat!("Offset of field: ", stringify!(stltsa_in), "::", stringify!(dtype))
        );
    }
    test_field_dtype();
    fn test_field_reserved() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_in>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).reserved) as usize - ptr as usize
            },
            44usize,
            concat!("Offset of field: ", stringify!(stltsa_in), "::", stringify!(reserved))
        );
    }
    test_field_reserved();
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_out {
    pub data: *mut ::std::os::raw::c_void,
    pub rows: i64,
    pub cols: i64,
    pub row_stride: i64,
    pub col_stride: i64,
    pub dtype: i32,
    pub reserved: i32,
}
#[test]
fn bindgen_test_layout_stltsa_out() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_out>(),
        48usize,
        concat!("Size of: ", stringify!(stltsa_out))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_out>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_out))
    );
    fn test_field_data() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_out>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).data) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_out), "::", stringify!(data))
        );
    }
    test_field_data();
    fn test_field_rows() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_out>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).rows) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_out), "::", stringify!(rows))
        );
    }
    test_field_rows();
    fn test_field_cols() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_out>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).cols) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_out), "::", stringify!(cols))
        );
    }
    test_field_cols();
    fn test_field_row_stride() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_out>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).row_stride) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_out), "::", stringify!(row_stride))
        );
    }
    test_field_row_stride();
    fn test_field_col_stride() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_out>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).col_stride) as usize - ptr as usize
            },
            32usize,
            concat!("Offset of field: ", stringify!(stltsa_out), "::", stringify!(col_stride))
        );
    }
    test_field_col_stride();
    fn test_field_dtype() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_out>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).dtype) as usize - ptr as usize
            },
            40usize,
            concat!("Offset of field: ", stringify!(stltsa_out), "::", stringify!(dtype))
        );
    }
    test_field_dtype();
    fn test_field_reserved() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_out>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).reserved) as usize - ptr as usize
            },
            44usize,
            concat!("Offset of field: ", stringify!(stltsa_out), "::", stringify!(reserved))
        );
    }
    test_field_reserved();
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_options {
    _unused: [u8; 0],
}
pub const STLTSA_OPT_NEIGHBORS: i32 = 1;
pub const STLTSA_OPT_WINDOW: i32 = 2;
pub const STLTSA_OPT_DIMENSION: i32 = 3;
pub const STLTSA_OPT_MODE: i32 = 4;
pub const STLTSA_OPT_INCLUDE_SELF: i32 = 5;
pub const STLTSA_OPT_LINKS: i32 = 6;
pub const STLTSA_OPT_EXCLUSION: i32 = 7;
pub const STLTSA_OPT_THREADS: i32 = 8;
pub const STLTSA_OPT_FEATURES: i32 = 9;
pub const STLTSA_OPT_UP_AXIS: i32 = 10;
pub const STLTSA_OPT_KEEP_START: i32 = 11;
pub const STLTSA_OPT_FPS: i32 = 12;
pub const STLTSA_OPT_SAMPLE_RATE: i32 = 13;
pub const STLTSA_OPT_SMOOTHING: i32 = 14;
pub const STLTSA_OPT_PERIOD_MIN: i32 = 15;
pub const STLTSA_OPT_PERIOD_MAX: i32 = 16;
pub const STLTSA_OPT_EIGENGAP: i32 = 17;
pub const STLTSA_OPT_VARIANCE: i32 = 18;
pub const STLTSA_OPT_SKELETON: i32 = 19;
pub const STLTSA_OPT_KEEP_FRAMES: i32 = 20;
pub const STLTSA_OPT_MAP_NEIGHBORS: i32 = 21;
pub const STLTSA_OPT_MAP_BLEND: i32 = 22;
pub const STLTSA_OPT_HINT_WINDOW: i32 = 23;
pub const STLTSA_OPT_COMPONENT: i32 = 24;
pub const STLTSA_OPT_GAMMA: i32 = 25;
pub const STLTSA_OPT_KNOT_SPACING: i32 = 26;
pub const STLTSA_OPT_ROBUST: i32 = 27;
pub const STLTSA_OPT_CROSSFADE: i32 = 28;
pub const STLTSA_OPT_CUT_RANGE: i32 = 29;
pub const STLTSA_OPT_POSTURE_LIMIT: i32 = 30;
pub const STLTSA_OPT_SEGMENTS: i32 = 32;
pub const STLTSA_OPT_GAPS: i32 = 33;
pub const STLTSA_OPT_MIN_CONFIDENCE: i32 = 34;
pub const STLTSA_OPT_LOOP: i32 = 35;
pub const STLTSA_OPT_IN_PLACE: i32 = 36;
pub const STLTSA_OPT_INTRINSIC: i32 = 38;
pub const STLTSA_OPT_SUBJECT: i32 = 37;
pub const STLTSA_GAPS_FILL: i32 = 1;
pub const STLTSA_GAPS_REFUSE: i32 = 2;
pub const STLTSA_GAPS_SKIP: i32 = 3;
pub const STLTSA_MODE_TEMPORAL: i32 = 1;
pub const STLTSA_MODE_SPATIAL: i32 = 2;
pub const STLTSA_MODE_RECURRENT: i32 = 3;
pub const STLTSA_FEATURES_POSITIONS: i32 = 1;
pub const STLTSA_FEATURES_ROTATIONS6D: i32 = 2;
pub const STLTSA_FEATURES_EULER: i32 = 3;
pub const STLTSA_FEATURES_RAW: i32 = 4;
pub const STLTSA_FEATURES_POINTS: i32 = 5;
pub const STLTSA_TYPE_INT: i32 = 1;
pub const STLTSA_TYPE_REAL: i32 = 2;
pub const STLTSA_TYPE_TEXT: i32 = 3;
pub const STLTSA_TYPE_ROWS: i32 = 4;
pub const STLTSA_TYPE_ARRAY: i32 = 5;
pub const STLTSA_CALL_OPEN: i32 = 1;
pub const STLTSA_CALL_FEATURES: i32 = 2;
pub const STLTSA_CALL_FIT: i32 = 4;
pub const STLTSA_CALL_MAP: i32 = 16;
pub const STLTSA_CALL_UNMAP: i32 = 32;
pub const STLTSA_CALL_DECOMPOSE: i32 = 64;
pub const STLTSA_CALL_DENOISE: i32 = 128;
pub const STLTSA_CALL_SYNTHESIZE: i32 = 256;
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_option_info {
    pub size: usize,
    pub key: i32,
    pub type_: i32,
    pub name: *const ::std::os::raw::c_char,
    pub text: *const ::std::os::raw::c_char,
    pub choices: *const ::std::os::raw::c_char,
    pub minimum: f64,
    pub maximum: f64,
    pub standard: f64,
    pub automatic: i32,
    pub calls: i32,
}
#[test]
fn bindgen_test_layout_stltsa_option_info() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_option_info>(),
        72usize,
        concat!("Size of: ", stringify!(stltsa_option_info))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_option_info>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_option_info))
    );
    fn test_field_size() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_option_info>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).size) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_option_info), "::", stringify!(size))
        );
    }
    test_field_size();
    fn test_field_key() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_option_info>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).key) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_option_info), "::", stringify!(key))
        );
    }
    test_field_key();
    fn test_field_type() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_option_info>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).type_) as usize - ptr as usize
            },
            12usize,
            concat!("Offset of field: ", stringify!(stltsa_option_info), "::", stringify!(type_))
        );
    }
    test_field_type();
    fn test_field_name() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_option_info>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).name) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_option_info), "::", stringify!(name))
        );
    }
    test_field_name();
    fn test_field_text() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_option_info>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).text) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_option_info), "::", stringify!(text))
        );
    }
    test_field_text();
    fn test_field_choices() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_option_info>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).choices) as usize - ptr as usize
            },
            32usize,
            concat!("Offset of field: ", stringify!(stltsa_option_info), "::", stringify!(choices))
        );
    }
    test_field_choices();
    fn test_field_minimum() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_option_info>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).minimum) as usize - ptr as usize
            },
            40usize,
            concat!("Offset of field: ", stringify!(stltsa_option_info), "::", stringify!(minimum))
        );
    }
    test_field_minimum();
    fn test_field_maximum() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_option_info>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).maximum) as usize - ptr as usize
            },
            48usize,
            concat!("Offset of field: ", stringify!(stltsa_option_info), "::", stringify!(maximum))
        );
    }
    test_field_maximum();
    fn test_field_standard() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_option_info>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).standard) as usize - ptr as usize
            },
            56usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_option_info),
                "::",
                stringify!(standard)
            )
        );
    }
    test_field_standard();
    fn test_field_automatic() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_option_info>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).automatic) as usize - ptr as usize
            },
            64usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_option_info),
                "::",
                stringify!(automatic)
            )
        );
    }
    test_field_automatic();
    fn test_field_calls() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_option_info>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).calls) as usize - ptr as usize
            },
            68usize,
            concat!("Offset of field: ", stringify!(stltsa_option_info), "::", stringify!(calls))
        );
    }
    test_field_calls();
}
extern "C" {
    pub fn stltsa_option_describe(index: i64, info: *mut stltsa_option_info) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_options_new(options: *mut *mut stltsa_options) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_options_free(options: *mut stltsa_options);
}
extern "C" {
    pub fn stltsa_options_set_int(
        options: *mut stltsa_options,
        key: i32,
        value: i64,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_options_set_real(
        options: *mut stltsa_options,
        key: i32,
        value: f64,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_options_set_text(
        options: *mut stltsa_options,
        key: i32,
        value: *const ::std::os::raw::c_char,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_options_unset(options: *mut stltsa_options, key: i32) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_options_is_set(options: *const stltsa_options, key: i32) -> i32;
}
extern "C" {
    pub fn stltsa_options_get_int(
        options: *const stltsa_options,
        key: i32,
        value: *mut i64,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_options_get_real(
        options: *const stltsa_options,
        key: i32,
        value: *mut f64,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_options_get_text(
        options: *const stltsa_options,
        key: i32,
        value: *mut *const ::std::os::raw::c_char,
    ) -> stltsa_status;
}
pub const STLTSA_STAGE_READ: i32 = 0;
pub const STLTSA_STAGE_FEATURES: i32 = 1;
pub const STLTSA_STAGE_NEIGHBORS: i32 = 2;
pub const STLTSA_STAGE_TANGENTS: i32 = 3;
pub const STLTSA_STAGE_ALIGNMENT: i32 = 4;
pub const STLTSA_STAGE_SPECTRUM: i32 = 5;
pub const STLTSA_STAGE_UNITS: i32 = 6;
pub const STLTSA_STAGE_MAP: i32 = 7;
pub const STLTSA_STAGE_DENOISE: i32 = 8;
pub const STLTSA_STAGE_SYNTHESIS: i32 = 9;
pub const STLTSA_STAGE_WRITE: i32 = 10;
pub type stltsa_progress_fn = ::std::option::Option<
    unsafe extern "C" fn(user: *mut ::std::os::raw::c_void, stage: i32, fraction: f64) -> i32,
>;
extern "C" {
    pub fn stltsa_options_set_progress(
        options: *mut stltsa_options,
        progress: stltsa_progress_fn,
        user: *mut ::std::os::raw::c_void,
    ) -> stltsa_status;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_info {
    _unused: [u8; 0],
}
pub const STLTSA_INFO_PATH: i32 = 1;
pub const STLTSA_INFO_FORMAT: i32 = 2;
pub const STLTSA_INFO_CLIP_FRAMES: i32 = 3;
pub const STLTSA_INFO_CLIP_FPS: i32 = 4;
pub const STLTSA_INFO_NOTE: i32 = 5;
pub const STLTSA_INFO_CHANNEL: i32 = 6;
pub const STLTSA_INFO_FEATURES: i32 = 7;
pub const STLTSA_INFO_FEATURE_COUNT: i32 = 8;
pub const STLTSA_INFO_UP_AXIS: i32 = 9;
pub const STLTSA_INFO_SMOOTHING: i32 = 10;
pub const STLTSA_INFO_ROWS: i32 = 11;
pub const STLTSA_INFO_LENGTH: i32 = 12;
pub const STLTSA_INFO_FIRST_FRAME: i32 = 13;
pub const STLTSA_INFO_FRAME_STEP: i32 = 14;
pub const STLTSA_INFO_FPS: i32 = 15;
pub const STLTSA_INFO_BODY_ROOT: i32 = 16;
pub const STLTSA_INFO_MODE: i32 = 20;
pub const STLTSA_INFO_NEIGHBORS: i32 = 21;
pub const STLTSA_INFO_WINDOW: i32 = 22;
pub const STLTSA_INFO_DIMENSION: i32 = 23;
pub const STLTSA_INFO_INCLUDE_SELF: i32 = 24;
pub const STLTSA_INFO_LINKS: i32 = 25;
pub const STLTSA_INFO_EXCLUSION: i32 = 26;
pub const STLTSA_INFO_PERIOD: i32 = 30;
pub const STLTSA_INFO_LAG_QUALITY: i32 = 31;
pub const STLTSA_INFO_PERIOD_MIN: i32 = 32;
pub const STLTSA_INFO_PERIOD_MAX: i32 = 33;
pub const STLTSA_INFO_PERIOD_ROWS: i32 = 34;
pub const STLTSA_INFO_REPEATED: i32 = 40;
pub const STLTSA_INFO_TIME_CORRELATION: i32 = 41;
pub const STLTSA_INFO_REACH: i32 = 42;
pub const STLTSA_INFO_COMPONENT: i32 = 43;
pub const STLTSA_INFO_HAS_CYCLE: i32 = 44;
pub const STLTSA_INFO_COORDS: i32 = 45;
pub const STLTSA_INFO_EIGENVALUES: i32 = 46;
pub const STLTSA_INFO_COMPONENT_OF: i32 = 47;
pub const STLTSA_INFO_COORDINATE: i32 = 60;
pub const STLTSA_INFO_CYCLICITY: i32 = 61;
pub const STLTSA_INFO_REPRESENTATIVE: i32 = 62;
pub const STLTSA_INFO_BEST: i32 = 63;
pub const STLTSA_INFO_REASON: i32 = 64;
pub const STLTSA_INFO_EIGENVALUE: i32 = 65;
pub const STLTSA_INFO_POSTURES: i32 = 68;
pub const STLTSA_INFO_SEGMENT: i32 = 50;
pub const STLTSA_INFO_UNIT: i32 = 51;
pub const STLTSA_INFO_CYCLE: i32 = 52;
pub const STLTSA_INFO_STEP: i32 = 53;
pub const STLTSA_INFO_REPETITION: i32 = 54;
pub const STLTSA_INFO_SUMMARY: i32 = 55;
pub const STLTSA_INFO_SIDE: i32 = 56;
pub const STLTSA_INFO_CURVE: i32 = 57;
pub const STLTSA_INFO_LABEL_LIKENESS: i32 = 58;
pub const STLTSA_INFO_LOCAL_PCA: i32 = 66;
pub const STLTSA_INFO_EIGENGAP: i32 = 67;
pub const STLTSA_INFO_LOCAL_PCA_REASON: i32 = 70;
pub const STLTSA_INFO_EIGENGAP_REASON: i32 = 71;
pub const STLTSA_INFO_VARIANCE: i32 = 72;
pub const STLTSA_INFO_EIGENGAP_THRESHOLD: i32 = 73;
pub const STLTSA_INFO_LOCAL_VARIANCE: i32 = 74;
pub const STLTSA_INFO_COLUMN: i32 = 80;
pub const STLTSA_INFO_CLEANED: i32 = 81;
pub const STLTSA_INFO_MOVES: i32 = 82;
pub const STLTSA_INFO_GAMMA_OPTION: i32 = 85;
pub const STLTSA_INFO_KNOT_ROWS: i32 = 86;
pub const STLTSA_INFO_ROBUST: i32 = 87;
pub const STLTSA_INFO_FIT_PERIOD_MIN: i32 = 88;
pub const STLTSA_INFO_FIT_PERIOD_MAX: i32 = 89;
pub const STLTSA_INFO_NOTHING_TO_CLEAN: i32 = 92;
pub const STLTSA_INFO_CROSSFADE: i32 = 100;
pub const STLTSA_INFO_CUT_RANGE: i32 = 101;
pub const STLTSA_INFO_POSTURE_LIMIT: i32 = 102;
pub const STLTSA_INFO_PIECE: i32 = 103;
pub const STLTSA_INFO_SEAM: i32 = 104;
pub const STLTSA_INFO_LOOP: i32 = 107;
pub const STLTSA_INFO_IN_PLACE: i32 = 108;
pub const STLTSA_INFO_TRAVEL: i32 = 109;
pub const STLTSA_INFO_TURN: i32 = 110;
pub const STLTSA_INFO_COVERAGE: i32 = 111;
pub const STLTSA_INFO_LOOP_CYCLES: i32 = 112;
pub const STLTSA_INFO_SOURCE_CYCLES: i32 = 113;
pub const STLTSA_INFO_WARNING: i32 = 120;
pub const STLTSA_INFO_LENGTH_UNIT: i32 = 130;
pub const STLTSA_INFO_FILE_UP_AXIS: i32 = 131;
pub const STLTSA_INFO_JOINT: i32 = 132;
pub const STLTSA_INFO_FILE_EVENT: i32 = 133;
pub const STLTSA_INFO_CHANNELS: i32 = 134;
pub const STLTSA_INFO_POSITIONS: i32 = 135;
pub const STLTSA_INFO_ROTATIONS: i32 = 136;
pub const STLTSA_INFO_PHASE: i32 = 140;
pub const STLTSA_INFO_PHASE_RESIDUAL: i32 = 141;
pub const STLTSA_INFO_PHASE_CYCLE: i32 = 142;
pub const STLTSA_INFO_PHASE_ZERO: i32 = 143;
pub const STLTSA_INFO_OWNER: i32 = 144;
pub const STLTSA_INFO_VALUES: i32 = 150;
pub const STLTSA_INFO_MEAN: i32 = 151;
pub const STLTSA_INFO_DEVIATION: i32 = 152;
pub const STLTSA_INFO_SAMPLE_FRAMES: i32 = 153;
pub const STLTSA_INFO_WARP: i32 = 154;
pub const STLTSA_INFO_DISTANCE: i32 = 155;
pub const STLTSA_INFO_COLUMN_DISTANCE: i32 = 156;
pub const STLTSA_INFO_EVENT: i32 = 160;
pub const STLTSA_INFO_LIKENESS: i32 = 161;
pub const STLTSA_INFO_COMPARISON: i32 = 170;
pub const STLTSA_INFO_MOTION: i32 = 171;
pub const STLTSA_INFO_PART: i32 = 172;
pub const STLTSA_INFO_PART_CHANNEL: i32 = 173;
pub const STLTSA_INFO_DIFFERENCE: i32 = 174;
pub const STLTSA_INFO_STANDARD_ERROR: i32 = 175;
pub const STLTSA_INFO_MARGIN: i32 = 176;
pub const STLTSA_INFO_MARK: i32 = 180;
pub const STLTSA_WARNING_FOLLOWS_TIME: i32 = 1;
pub const STLTSA_WARNING_RANK_DEFICIENT: i32 = 2;
pub const STLTSA_WARNING_SMALL_GAP: i32 = 3;
pub const STLTSA_WARNING_UNSCALED: i32 = 4;
pub const STLTSA_WARNING_INACCURATE: i32 = 5;
pub const STLTSA_WARNING_DISCONNECTED: i32 = 6;
pub const STLTSA_WARNING_JUMP: i32 = 7;
pub const STLTSA_WARNING_SEPARATE_MOTION: i32 = 8;
pub const STLTSA_WARNING_OFFSETS_DIFFER: i32 = 9;
pub const STLTSA_WARNING_RESAMPLED: i32 = 10;
pub const STLTSA_WARNING_SEAM_POSTURE: i32 = 11;
pub const STLTSA_WARNING_SEAM_SPEED: i32 = 12;
pub const STLTSA_WARNING_SEAM_ACCELERATION: i32 = 13;
pub const STLTSA_WARNING_NOT_BLENDED: i32 = 14;
pub const STLTSA_WARNING_NO_ORDER: i32 = 15;
pub const STLTSA_WARNING_LINEAR_PHASE: i32 = 16;
pub const STLTSA_WARNING_SEVERAL_PLACES: i32 = 17;
pub const STLTSA_WARNING_NOT_FOUND: i32 = 18;
pub const STLTSA_WARNING_FEW_CYCLES: i32 = 19;
pub const STLTSA_WARNING_NOT_ALIKE: i32 = 20;
pub const STLTSA_WARNING_UNCERTAIN_SHIFT: i32 = 21;
pub const STLTSA_WARNING_SIZES_DIFFER: i32 = 22;
extern "C" {
    pub fn stltsa_info_count(info: *const stltsa_info, key: i32) -> i64;
}
extern "C" {
    pub fn stltsa_info_int(
        info: *const stltsa_info,
        key: i32,
        index: i64,
        value: *mut i64,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_info_real(
        info: *const stltsa_info,
        key: i32,
        index: i64,
        value: *mut f64,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_info_text(
        info: *const stltsa_info,
        key: i32,
        index: i64,
        value: *mut *const ::std::os::raw::c_char,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_info_rows(
        info: *const stltsa_info,
        key: i32,
        begin: i64,
        count: i64,
        rows: *mut ::std::os::raw::c_void,
        row_size: usize,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_info_array(
        info: *const stltsa_info,
        key: i32,
        index: i64,
        array: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_info_shape(
        info: *const stltsa_info,
        key: i32,
        rows: *mut i64,
        cols: *mut i64,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_info_json(
        info: *const stltsa_info,
        json: *mut *mut ::std::os::raw::c_char,
    ) -> stltsa_status;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_warning {
    pub code: i64,
    pub text: *const ::std::os::raw::c_char,
    pub begin_s: f64,
    pub end_s: f64,
}
#[test]
fn bindgen_test_layout_stltsa_warning() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_warning>(),
        32usize,
        concat!("Size of: ", stringify!(stltsa_warning))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_warning>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_warning))
    );
    fn test_field_code() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_warning>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).code) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_warning), "::", stringify!(code))
        );
    }
    test_field_code();
    fn test_field_text() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_warning>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).text) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_warning), "::", stringify!(text))
        );
    }
    test_field_text();
    fn test_field_begin_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_warning>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).begin_s) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_warning), "::", stringify!(begin_s))
        );
    }
    test_field_begin_s();
    fn test_field_end_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_warning>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).end_s) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_warning), "::", stringify!(end_s))
        );
    }
    test_field_end_s();
}
pub const STLTSA_HANDLE_CLIP: i32 = 1;
pub const STLTSA_HANDLE_MODEL: i32 = 2;
pub const STLTSA_HANDLE_PHASE: i32 = 4;
pub const STLTSA_HANDLE_DECOMPOSITION: i32 = 8;
pub const STLTSA_HANDLE_DENOISING: i32 = 16;
pub const STLTSA_HANDLE_SYNTHESIS: i32 = 32;
pub const STLTSA_HANDLE_CYCLES: i32 = 64;
pub const STLTSA_HANDLE_EVENTS: i32 = 128;
pub const STLTSA_HANDLE_COMPARISON: i32 = 256;
pub const STLTSA_HANDLE_LIVE: i32 = 512;
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_info_key {
    pub size: usize,
    pub key: i32,
    pub type_: i32,
    pub name: *const ::std::os::raw::c_char,
    pub text: *const ::std::os::raw::c_char,
    pub choices: *const ::std::os::raw::c_char,
    pub is_list: i32,
    pub handles: i32,
}
#[test]
fn bindgen_test_layout_stltsa_info_key() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_info_key>(),
        48usize,
        concat!("Size of: ", stringify!(stltsa_info_key))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_info_key>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_info_key))
    );
    fn test_field_size() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_info_key>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).size) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_info_key), "::", stringify!(size))
        );
    }
    test_field_size();
    fn test_field_key() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_info_key>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).key) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_info_key), "::", stringify!(key))
        );
    }
    test_field_key();
    fn test_field_type() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_info_key>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).type_) as usize - ptr as usize
            },
            12usize,
            concat!("Offset of field: ", stringify!(stltsa_info_key), "::", stringify!(type_))
        );
    }
    test_field_type();
    fn test_field_name() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_info_key>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).name) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_info_key), "::", stringify!(name))
        );
    }
    test_field_name();
    fn test_field_text() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_info_key>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).text) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_info_key), "::", stringify!(text))
        );
    }
    test_field_text();
    fn test_field_choices() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_info_key>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).choices) as usize - ptr as usize
            },
            32usize,
            concat!("Offset of field: ", stringify!(stltsa_info_key), "::", stringify!(choices))
        );
    }
    test_field_choices();
    fn test_field_is_list() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_info_key>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).is_list) as usize - ptr as usize
            },
            40usize,
            concat!("Offset of field: ", stringify!(stltsa_info_key), "::", stringify!(is_list))
        );
    }
    test_field_is_list();
    fn test_field_handles() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_info_key>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).handles) as usize - ptr as usize
            },
            44usize,
            concat!("Offset of field: ", stringify!(stltsa_info_key), "::", stringify!(handles))
        );
    }
    test_field_handles();
}
extern "C" {
    pub fn stltsa_info_describe(index: i64, key: *mut stltsa_info_key) -> stltsa_status;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_clip {
    _unused: [u8; 0],
}
pub const STLTSA_FORMAT_BVH: i32 = 1;
pub const STLTSA_FORMAT_AMC: i32 = 2;
pub const STLTSA_FORMAT_CSV: i32 = 3;
pub const STLTSA_FORMAT_NPY: i32 = 4;
pub const STLTSA_FORMAT_MATRIX: i32 = 5;
pub const STLTSA_FORMAT_POINTS: i32 = 6;
pub const STLTSA_FORMAT_SKELETON: i32 = 7;
pub const STLTSA_FORMAT_GLB: i32 = 8;
pub const STLTSA_FORMAT_C3D: i32 = 9;
pub const STLTSA_FORMAT_TRC: i32 = 10;
pub const STLTSA_FORMAT_MOT: i32 = 11;
extern "C" {
    pub fn stltsa_clip_open(
        path: *const ::std::os::raw::c_char,
        options: *const stltsa_options,
        clip: *mut *mut stltsa_clip,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_clip_open_stretch(
        text: *const ::std::os::raw::c_char,
        options: *const stltsa_options,
        clip: *mut *mut stltsa_clip,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_clip_parse(
        bytes: *const ::std::os::raw::c_void,
        size: usize,
        format: i32,
        name: *const ::std::os::raw::c_char,
        options: *const stltsa_options,
        clip: *mut *mut stltsa_clip,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_clip_from_matrix(
        frames: *const stltsa_in,
        fps: f64,
        clip: *mut *mut stltsa_clip,
    ) -> stltsa_status;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_points {
    pub size: usize,
    pub space: i32,
    pub reserved: i32,
    pub positions: stltsa_in,
    pub names: *const *const ::std::os::raw::c_char,
    pub confidence: stltsa_in,
    pub times: stltsa_in,
    pub fps: f64,
}
#[test]
fn bindgen_test_layout_stltsa_points() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_points>(),
        176usize,
        concat!("Size of: ", stringify!(stltsa_points))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_points>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_points))
    );
    fn test_field_size() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_points>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).size) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_points), "::", stringify!(size))
        );
    }
    test_field_size();
    fn test_field_space() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_points>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).space) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_points), "::", stringify!(space))
        );
    }
    test_field_space();
    fn test_field_reserved() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_points>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).reserved) as usize - ptr as usize
            },
            12usize,
            concat!("Offset of field: ", stringify!(stltsa_points), "::", stringify!(reserved))
        );
    }
    test_field_reserved();
    fn test_field_positions() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_points>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).positions) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_points), "::", stringify!(positions))
        );
    }
    test_field_positions();
    fn test_field_names() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_points>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).names) as usize - ptr as usize
            },
            64usize,
            concat!("Offset of field: ", stringify!(stltsa_points), "::", stringify!(names))
        );
    }
    test_field_names();
    fn test_field_confidence() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_points>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).confidence) as usize - ptr as usize
            },
            72usize,
            concat!("Offset of field: ", stringify!(stltsa_points), "::", stringify!(confidence))
        );
    }
    test_field_confidence();
    fn test_field_times() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_points>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).times) as usize - ptr as usize
            },
            120usize,
            concat!("Offset of field: ", stringify!(stltsa_points), "::", stringify!(times))
        );
    }
    test_field_times();
    fn test_field_fps() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_points>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).fps) as usize - ptr as usize
            },
            168usize,
            concat!("Offset of field: ", stringify!(stltsa_points), "::", stringify!(fps))
        );
    }
    test_field_fps();
}
extern "C" {
    pub fn stltsa_clip_from_points(
        points: *const stltsa_points,
        options: *const stltsa_options,
        clip: *mut *mut stltsa_clip,
    ) -> stltsa_status;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_joint {
    pub name: *const ::std::os::raw::c_char,
    pub parent: i64,
    pub offset: [f64; 3usize],
    pub channels: *const ::std::os::raw::c_char,
    pub is_end_site: i64,
}
#[test]
fn bindgen_test_layout_stltsa_joint() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_joint>(),
        56usize,
        concat!("Size of: ", stringify!(stltsa_joint))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_joint>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_joint))
    );
    fn test_field_name() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_joint>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).name) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_joint), "::", stringify!(name))
        );
    }
    test_field_name();
    fn test_field_parent() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_joint>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).parent) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_joint), "::", stringify!(parent))
        );
    }
    test_field_parent();
    fn test_field_offset() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_joint>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).offset) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_joint), "::", stringify!(offset))
        );
    }
    test_field_offset();
    fn test_field_channels() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_joint>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).channels) as usize - ptr as usize
            },
            40usize,
            concat!("Offset of field: ", stringify!(stltsa_joint), "::", stringify!(channels))
        );
    }
    test_field_channels();
    fn test_field_is_end_site() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_joint>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).is_end_site) as usize - ptr as usize
            },
            48usize,
            concat!("Offset of field: ", stringify!(stltsa_joint), "::", stringify!(is_end_site))
        );
    }
    test_field_is_end_site();
}
pub const STLTSA_ROTATIONS_QUATERNION: i32 = 1;
pub const STLTSA_ROTATIONS_MATRIX: i32 = 2;
pub const STLTSA_ROTATIONS_CHANNELS: i32 = 3;
extern "C" {
    pub fn stltsa_clip_from_skeleton(
        joints: *const stltsa_joint,
        joint_size: usize,
        count: i64,
        form: i32,
        rotations: *const stltsa_in,
        root_positions: *const stltsa_in,
        fps: f64,
        clip: *mut *mut stltsa_clip,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_clip_set_path(
        clip: *mut stltsa_clip,
        path: *const ::std::os::raw::c_char,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_clip_stretch(
        clip: *const stltsa_clip,
        what: *const ::std::os::raw::c_char,
        options: *const stltsa_options,
        stretch: *mut *mut stltsa_clip,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_clip_mirror(
        clip: *const stltsa_clip,
        options: *const stltsa_options,
        mirrored: *mut *mut stltsa_clip,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_clip_free(clip: *mut stltsa_clip);
}
extern "C" {
    pub fn stltsa_clip_info(clip: *const stltsa_clip) -> *const stltsa_info;
}
extern "C" {
    pub fn stltsa_clip_frames(clip: *const stltsa_clip) -> i64;
}
extern "C" {
    pub fn stltsa_clip_fps(clip: *const stltsa_clip) -> f64;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_file_event {
    pub label: *const ::std::os::raw::c_char,
    pub context: *const ::std::os::raw::c_char,
    pub frame: f64,
    pub seconds: f64,
}
#[test]
fn bindgen_test_layout_stltsa_file_event() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_file_event>(),
        32usize,
        concat!("Size of: ", stringify!(stltsa_file_event))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_file_event>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_file_event))
    );
    fn test_field_label() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_file_event>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).label) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_file_event), "::", stringify!(label))
        );
    }
    test_field_label();
    fn test_field_context() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_file_event>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).context) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_file_event), "::", stringify!(context))
        );
    }
    test_field_context();
    fn test_field_frame() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_file_event>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).frame) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_file_event), "::", stringify!(frame))
        );
    }
    test_field_frame();
    fn test_field_seconds() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_file_event>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).seconds) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_file_event), "::", stringify!(seconds))
        );
    }
    test_field_seconds();
}
extern "C" {
    pub fn stltsa_clip_feature_count(
        clip: *const stltsa_clip,
        options: *const stltsa_options,
        count: *mut i64,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_clip_features(
        clip: *const stltsa_clip,
        options: *const stltsa_options,
        features: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_clip_save(
        clip: *const stltsa_clip,
        path: *const ::std::os::raw::c_char,
        options: *const stltsa_options,
    ) -> stltsa_status;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_model {
    _unused: [u8; 0],
}
extern "C" {
    pub fn stltsa_fit(
        frames: *const stltsa_in,
        lengths: *const stltsa_in,
        options: *const stltsa_options,
        model: *mut *mut stltsa_model,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_fit_clips(
        clips: *const *const stltsa_clip,
        count: i64,
        options: *const stltsa_options,
        model: *mut *mut stltsa_model,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_model_free(model: *mut stltsa_model);
}
extern "C" {
    pub fn stltsa_model_info(model: *const stltsa_model) -> *const stltsa_info;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_component {
    pub frames: i64,
    pub residual: f64,
    pub error_estimate_rad: f64,
    pub gap: f64,
    pub rank_deficient_windows: i64,
    pub solves: i64,
}
#[test]
fn bindgen_test_layout_stltsa_component() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_component>(),
        48usize,
        concat!("Size of: ", stringify!(stltsa_component))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_component>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_component))
    );
    fn test_field_frames() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_component>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).frames) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_component), "::", stringify!(frames))
        );
    }
    test_field_frames();
    fn test_field_residual() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_component>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).residual) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_component), "::", stringify!(residual))
        );
    }
    test_field_residual();
    fn test_field_error_estimate_rad() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_component>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).error_estimate_rad) as usize - ptr as usize
            },
            16usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_component),
                "::",
                stringify!(error_estimate_rad)
            )
        );
    }
    test_field_error_estimate_rad();
    fn test_field_gap() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_component>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).gap) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_component), "::", stringify!(gap))
        );
    }
    test_field_gap();
    fn test_field_rank_deficient_windows() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_component>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).rank_deficient_windows) as usize - ptr as usize
            },
            32usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_component),
                "::",
                stringify!(rank_deficient_windows)
            )
        );
    }
    test_field_rank_deficient_windows();
    fn test_field_solves() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_component>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).solves) as usize - ptr as usize
            },
            40usize,
            concat!("Offset of field: ", stringify!(stltsa_component), "::", stringify!(solves))
        );
    }
    test_field_solves();
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_decomposition {
    _unused: [u8; 0],
}
pub const STLTSA_UNIT_PREPARING: i32 = 1;
pub const STLTSA_UNIT_INITIAL: i32 = 2;
pub const STLTSA_UNIT_CYCLIC: i32 = 3;
pub const STLTSA_UNIT_FINAL: i32 = 4;
pub const STLTSA_UNIT_WIND_UP: i32 = 5;
pub const STLTSA_UNIT_ACTION: i32 = 6;
pub const STLTSA_UNIT_HOLD: i32 = 8;
extern "C" {
    pub fn stltsa_unit_name(kind: i64) -> *const ::std::os::raw::c_char;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_interval {
    pub begin: i64,
    pub end: i64,
    pub begin_s: f64,
    pub end_s: f64,
}
#[test]
fn bindgen_test_layout_stltsa_interval() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_interval>(),
        32usize,
        concat!("Size of: ", stringify!(stltsa_interval))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_interval>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_interval))
    );
    fn test_field_begin() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_interval>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).begin) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_interval), "::", stringify!(begin))
        );
    }
    test_field_begin();
    fn test_field_end() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_interval>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).end) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_interval), "::", stringify!(end))
        );
    }
    test_field_end();
    fn test_field_begin_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_interval>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).begin_s) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_interval), "::", stringify!(begin_s))
        );
    }
    test_field_begin_s();
    fn test_field_end_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_interval>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).end_s) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_interval), "::", stringify!(end_s))
        );
    }
    test_field_end_s();
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_unit {
    pub kind: i64,
    pub segment: i64,
    pub begin: i64,
    pub end: i64,
    pub begin_s: f64,
    pub end_s: f64,
}
#[test]
fn bindgen_test_layout_stltsa_unit() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_unit>(),
        48usize,
        concat!("Size of: ", stringify!(stltsa_unit))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_unit>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_unit))
    );
    fn test_field_kind() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_unit>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).kind) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_unit), "::", stringify!(kind))
        );
    }
    test_field_kind();
    fn test_field_segment() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_unit>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).segment) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_unit), "::", stringify!(segment))
        );
    }
    test_field_segment();
    fn test_field_begin() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_unit>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).begin) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_unit), "::", stringify!(begin))
        );
    }
    test_field_begin();
    fn test_field_end() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_unit>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).end) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_unit), "::", stringify!(end))
        );
    }
    test_field_end();
    fn test_field_begin_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_unit>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).begin_s) as usize - ptr as usize
            },
            32usize,
            concat!("Offset of field: ", stringify!(stltsa_unit), "::", stringify!(begin_s))
        );
    }
    test_field_begin_s();
    fn test_field_end_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_unit>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).end_s) as usize - ptr as usize
            },
            40usize,
            concat!("Offset of field: ", stringify!(stltsa_unit), "::", stringify!(end_s))
        );
    }
    test_field_end_s();
}
extern "C" {
    pub fn stltsa_clip_find(
        clip: *const stltsa_clip,
        what: *const ::std::os::raw::c_char,
        options: *const stltsa_options,
        capacity: i64,
        intervals: *mut stltsa_interval,
        count: *mut i64,
    ) -> stltsa_status;
}
pub const STLTSA_SEGMENT_CYCLIC: i32 = 1;
pub const STLTSA_SEGMENT_REPETITIONS: i32 = 2;
pub const STLTSA_SEGMENT_ACTION: i32 = 3;
pub const STLTSA_SEGMENT_REST: i32 = 4;
extern "C" {
    pub fn stltsa_segment_name(kind: i64) -> *const ::std::os::raw::c_char;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_segment {
    pub kind: i64,
    pub label: i64,
    pub letters: *const ::std::os::raw::c_char,
    pub likeness: f64,
    pub begin: i64,
    pub end: i64,
    pub begin_s: f64,
    pub end_s: f64,
    pub period_s: f64,
    pub candidate_period_s: f64,
    pub count: i64,
    pub carried_by: *const *const ::std::os::raw::c_char,
    pub open_begin: i64,
    pub open_end: i64,
    pub confidence: f64,
    pub begin_confidence: f64,
    pub reason: *const ::std::os::raw::c_char,
    pub first_step_share: f64,
    pub first_step_margin: f64,
    pub steps_reason: *const ::std::os::raw::c_char,
}
#[test]
fn bindgen_test_layout_stltsa_segment() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_segment>(),
        160usize,
        concat!("Size of: ", stringify!(stltsa_segment))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_segment>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_segment))
    );
    fn test_field_kind() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).kind) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_segment), "::", stringify!(kind))
        );
    }
    test_field_kind();
    fn test_field_label() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).label) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_segment), "::", stringify!(label))
        );
    }
    test_field_label();
    fn test_field_letters() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).letters) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_segment), "::", stringify!(letters))
        );
    }
    test_field_letters();
    fn test_field_likeness() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).likeness) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_segment), "::", stringify!(likeness))
        );
    }
    test_field_likeness();
    fn test_field_begin() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).begin) as usize - ptr as usize
            },
            32usize,
            concat!("Offset of field: ", stringify!(stltsa_segment), "::", stringify!(begin))
        );
    }
    test_field_begin();
    fn test_field_end() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).end) as usize - ptr as usize
            },
            40usize,
            concat!("Offset of field: ", stringify!(stltsa_segment), "::", stringify!(end))
        );
    }
    test_field_end();
    fn test_field_begin_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).begin_s) as usize - ptr as usize
            },
            48usize,
            concat!("Offset of field: ", stringify!(stltsa_segment), "::", stringify!(begin_s))
        );
    }
    test_field_begin_s();
    fn test_field_end_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).end_s) as usize - ptr as usize
            },
            56usize,
            concat!("Offset of field: ", stringify!(stltsa_segment), "::", stringify!(end_s))
        );
    }
    test_field_end_s();
    fn test_field_period_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).period_s) as usize - ptr as usize
            },
            64usize,
            concat!("Offset of field: ", stringify!(stltsa_segment), "::", stringify!(period_s))
        );
    }
    test_field_period_s();
    fn test_field_candidate_period_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).candidate_period_s) as usize - ptr as usize
            },
            72usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_segment),
                "::",
                stringify!(candidate_period_s)
            )
        );
    }
    test_field_candidate_period_s();
    fn test_field_count() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).count) as usize - ptr as usize
            },
            80usize,
            concat!("Offset of field: ", stringify!(stltsa_segment), "::", stringify!(count))
        );
    }
    test_field_count();
    fn test_field_carried_by() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).carried_by) as usize - ptr as usize
            },
            88usize,
            concat!("Offset of field: ", stringify!(stltsa_segment), "::", stringify!(carried_by))
        );
    }
    test_field_carried_by();
    fn test_field_open_begin() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).open_begin) as usize - ptr as usize
            },
            96usize,
            concat!("Offset of field: ", stringify!(stltsa_segment), "::", stringify!(open_begin))
        );
    }
    test_field_open_begin();
    fn test_field_open_end() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).open_end) as usize - ptr as usize
            },
            104usize,
            concat!("Offset of field: ", stringify!(stltsa_segment), "::", stringify!(open_end))
        );
    }
    test_field_open_end();
    fn test_field_confidence() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).confidence) as usize - ptr as usize
            },
            112usize,
            concat!("Offset of field: ", stringify!(stltsa_segment), "::", stringify!(confidence))
        );
    }
    test_field_confidence();
    fn test_field_begin_confidence() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).begin_confidence) as usize - ptr as usize
            },
            120usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_segment),
                "::",
                stringify!(begin_confidence)
            )
        );
    }
    test_field_begin_confidence();
    fn test_field_reason() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).reason) as usize - ptr as usize
            },
            128usize,
            concat!("Offset of field: ", stringify!(stltsa_segment), "::", stringify!(reason))
        );
    }
    test_field_reason();
    fn test_field_first_step_share() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).first_step_share) as usize - ptr as usize
            },
            136usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_segment),
                "::",
                stringify!(first_step_share)
            )
        );
    }
    test_field_first_step_share();
    fn test_field_first_step_margin() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).first_step_margin) as usize - ptr as usize
            },
            144usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_segment),
                "::",
                stringify!(first_step_margin)
            )
        );
    }
    test_field_first_step_margin();
    fn test_field_steps_reason() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).steps_reason) as usize - ptr as usize
            },
            152usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_segment),
                "::",
                stringify!(steps_reason)
            )
        );
    }
    test_field_steps_reason();
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_part {
    pub segment: i64,
    pub cycle: i64,
    pub label: i64,
    pub letters: *const ::std::os::raw::c_char,
    pub begin: i64,
    pub end: i64,
    pub begin_s: f64,
    pub end_s: f64,
    pub side: i64,
    pub side_name: *const ::std::os::raw::c_char,
    pub likeness: f64,
    pub confidence: f64,
    pub path_length: f64,
    pub stride: f64,
    pub speed: f64,
    pub turn_deg: f64,
}
#[test]
fn bindgen_test_layout_stltsa_part() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_part>(),
        128usize,
        concat!("Size of: ", stringify!(stltsa_part))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_part>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_part))
    );
    fn test_field_segment() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).segment) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(segment))
        );
    }
    test_field_segment();
    fn test_field_cycle() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).cycle) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(cycle))
        );
    }
    test_field_cycle();
    fn test_field_label() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).label) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(label))
        );
    }
    test_field_label();
    fn test_field_letters() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).letters) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(letters))
        );
    }
    test_field_letters();
    fn test_field_begin() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).begin) as usize - ptr as usize
            },
            32usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(begin))
        );
    }
    test_field_begin();
    fn test_field_end() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).end) as usize - ptr as usize
            },
            40usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(end))
        );
    }
    test_field_end();
    fn test_field_begin_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).begin_s) as usize - ptr as usize
            },
            48usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(begin_s))
        );
    }
    test_field_begin_s();
    fn test_field_end_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).end_s) as usize - ptr as usize
            },
            56usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(end_s))
        );
    }
    test_field_end_s();
    fn test_field_side() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).side) as usize - ptr as usize
            },
            64usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(side))
        );
    }
    test_field_side();
    fn test_field_side_name() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).side_name) as usize - ptr as usize
            },
            72usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(side_name))
        );
    }
    test_field_side_name();
    fn test_field_likeness() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).likeness) as usize - ptr as usize
            },
            80usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(likeness))
        );
    }
    test_field_likeness();
    fn test_field_confidence() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).confidence) as usize - ptr as usize
            },
            88usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(confidence))
        );
    }
    test_field_confidence();
    fn test_field_path_length() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).path_length) as usize - ptr as usize
            },
            96usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(path_length))
        );
    }
    test_field_path_length();
    fn test_field_stride() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).stride) as usize - ptr as usize
            },
            104usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(stride))
        );
    }
    test_field_stride();
    fn test_field_speed() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).speed) as usize - ptr as usize
            },
            112usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(speed))
        );
    }
    test_field_speed();
    fn test_field_turn_deg() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).turn_deg) as usize - ptr as usize
            },
            120usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(turn_deg))
        );
    }
    test_field_turn_deg();
}
pub const STLTSA_QUANTITY_TIME: i32 = 1;
pub const STLTSA_QUANTITY_PATH_LENGTH: i32 = 2;
pub const STLTSA_QUANTITY_STRIDE: i32 = 3;
pub const STLTSA_QUANTITY_SPEED: i32 = 4;
pub const STLTSA_QUANTITY_TURN: i32 = 5;
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_statistics {
    pub count: i64,
    pub mean: f64,
    pub sd: f64,
    pub cv: f64,
    pub trend: f64,
}
#[test]
fn bindgen_test_layout_stltsa_statistics() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_statistics>(),
        40usize,
        concat!("Size of: ", stringify!(stltsa_statistics))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_statistics>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_statistics))
    );
    fn test_field_count() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_statistics>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).count) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_statistics), "::", stringify!(count))
        );
    }
    test_field_count();
    fn test_field_mean() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_statistics>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).mean) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_statistics), "::", stringify!(mean))
        );
    }
    test_field_mean();
    fn test_field_sd() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_statistics>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).sd) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_statistics), "::", stringify!(sd))
        );
    }
    test_field_sd();
    fn test_field_cv() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_statistics>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).cv) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_statistics), "::", stringify!(cv))
        );
    }
    test_field_cv();
    fn test_field_trend() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_statistics>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).trend) as usize - ptr as usize
            },
            32usize,
            concat!("Offset of field: ", stringify!(stltsa_statistics), "::", stringify!(trend))
        );
    }
    test_field_trend();
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_summary {
    pub label: i64,
    pub letters: *const ::std::os::raw::c_char,
    pub count: i64,
    pub cycles_per_min: f64,
    pub cycle_time_s: stltsa_statistics,
    pub steps_per_min: f64,
    pub step_time_s: stltsa_statistics,
    pub step_time_side_0_s: f64,
    pub step_time_side_1_s: f64,
    pub path_length: stltsa_statistics,
    pub stride: stltsa_statistics,
    pub speed: stltsa_statistics,
    pub turn_deg: stltsa_statistics,
}
#[test]
fn bindgen_test_layout_stltsa_summary() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_summary>(),
        296usize,
        concat!("Size of: ", stringify!(stltsa_summary))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_summary>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_summary))
    );
    fn test_field_label() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).label) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_summary), "::", stringify!(label))
        );
    }
    test_field_label();
    fn test_field_letters() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).letters) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_summary), "::", stringify!(letters))
        );
    }
    test_field_letters();
    fn test_field_count() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).count) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_summary), "::", stringify!(count))
        );
    }
    test_field_count();
    fn test_field_cycles_per_min() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).cycles_per_min) as usize - ptr as usize
            },
            24usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_summary),
                "::",
                stringify!(cycles_per_min)
            )
        );
    }
    test_field_cycles_per_min();
    fn test_field_cycle_time_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).cycle_time_s) as usize - ptr as usize
            },
            32usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_summary),
                "::",
                stringify!(cycle_time_s)
            )
        );
    }
    test_field_cycle_time_s();
    fn test_field_steps_per_min() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).steps_per_min) as usize - ptr as usize
            },
            72usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_summary),
                "::",
                stringify!(steps_per_min)
            )
        );
    }
    test_field_steps_per_min();
    fn test_field_step_time_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).step_time_s) as usize - ptr as usize
            },
            80usize,
            concat!("Offset of field: ", stringify!(stltsa_summary), "::", stringify!(step_time_s))
        );
    }
    test_field_step_time_s();
    fn test_field_step_time_side_0_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).step_time_side_0_s) as usize - ptr as usize
            },
            120usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_summary),
                "::",
                stringify!(step_time_side_0_s)
            )
        );
    }
    test_field_step_time_side_0_s();
    fn test_field_step_time_side_1_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).step_time_side_1_s) as usize - ptr as usize
            },
            128usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_summary),
                "::",
                stringify!(step_time_side_1_s)
            )
        );
    }
    test_field_step_time_side_1_s();
    fn test_field_path_length() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).path_length) as usize - ptr as usize
            },
            136usize,
            concat!("Offset of field: ", stringify!(stltsa_summary), "::", stringify!(path_length))
        );
    }
    test_field_path_length();
    fn test_field_stride() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).stride) as usize - ptr as usize
            },
            176usize,
            concat!("Offset of field: ", stringify!(stltsa_summary), "::", stringify!(stride))
        );
    }
    test_field_stride();
    fn test_field_speed() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).speed) as usize - ptr as usize
            },
            216usize,
            concat!("Offset of field: ", stringify!(stltsa_summary), "::", stringify!(speed))
        );
    }
    test_field_speed();
    fn test_field_turn_deg() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).turn_deg) as usize - ptr as usize
            },
            256usize,
            concat!("Offset of field: ", stringify!(stltsa_summary), "::", stringify!(turn_deg))
        );
    }
    test_field_turn_deg();
}
extern "C" {
    pub fn stltsa_decompose(
        clip: *const stltsa_clip,
        options: *const stltsa_options,
        decomposition: *mut *mut stltsa_decomposition,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_decomposition_free(decomposition: *mut stltsa_decomposition);
}
extern "C" {
    pub fn stltsa_decomposition_info(
        decomposition: *const stltsa_decomposition,
    ) -> *const stltsa_info;
}
extern "C" {
    pub fn stltsa_decomposition_statistics(
        decomposition: *const stltsa_decomposition,
        kind: i32,
        label: i64,
        side: i32,
        quantity: i32,
        statistics: *mut stltsa_statistics,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_map(
        model: *const stltsa_model,
        frames: *const stltsa_in,
        hints: *const stltsa_in,
        options: *const stltsa_options,
        coords: *const stltsa_out,
        distance: *const stltsa_out,
        nearest: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_map_clip(
        model: *const stltsa_model,
        clip: *const stltsa_clip,
        options: *const stltsa_options,
        coords: *const stltsa_out,
        distance: *const stltsa_out,
        nearest: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_unmap(
        model: *const stltsa_model,
        coords: *const stltsa_in,
        hints: *const stltsa_in,
        options: *const stltsa_options,
        frames: *const stltsa_out,
        distance: *const stltsa_out,
        nearest: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_unmap_clip(
        model: *const stltsa_model,
        coords: *const stltsa_in,
        hints: *const stltsa_in,
        options: *const stltsa_options,
        distance: *const stltsa_out,
        nearest: *const stltsa_out,
        poses: *mut *mut stltsa_clip,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_model_serialize(
        model: *const stltsa_model,
        bytes: *mut *mut ::std::os::raw::c_uchar,
        size: *mut usize,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_model_parse(
        bytes: *const ::std::os::raw::c_void,
        size: usize,
        model: *mut *mut stltsa_model,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_model_save(
        model: *const stltsa_model,
        path: *const ::std::os::raw::c_char,
        options: *const stltsa_options,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_model_load(
        path: *const ::std::os::raw::c_char,
        options: *const stltsa_options,
        model: *mut *mut stltsa_model,
    ) -> stltsa_status;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_phase {
    _unused: [u8; 0],
}
extern "C" {
    pub fn stltsa_phase_find(
        decomposition: *const stltsa_decomposition,
        options: *const stltsa_options,
        phase: *mut *mut stltsa_phase,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_phase_free(phase: *mut stltsa_phase);
}
extern "C" {
    pub fn stltsa_phase_info(phase: *const stltsa_phase) -> *const stltsa_info;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_cycles {
    _unused: [u8; 0],
}
extern "C" {
    pub fn stltsa_cycles_resample(
        phase: *const stltsa_phase,
        label: i64,
        signals: *const stltsa_in,
        samples: i64,
        options: *const stltsa_options,
        cycles: *mut *mut stltsa_cycles,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_cycles_between(
        borders: *const stltsa_in,
        signals: *const stltsa_in,
        samples: i64,
        options: *const stltsa_options,
        cycles: *mut *mut stltsa_cycles,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_cycles_free(cycles: *mut stltsa_cycles);
}
extern "C" {
    pub fn stltsa_cycles_info(cycles: *const stltsa_cycles) -> *const stltsa_info;
}
extern "C" {
    pub fn stltsa_cycles_group_distance(
        cycles: *const stltsa_cycles,
        groups: *const stltsa_in,
        distance: *const stltsa_out,
    ) -> stltsa_status;
}
pub const STLTSA_SIDE_NONE: i32 = -1;
pub const STLTSA_SIDE_LEFT: i32 = 0;
pub const STLTSA_SIDE_RIGHT: i32 = 1;
extern "C" {
    pub fn stltsa_side_of_name(name: *const ::std::os::raw::c_char) -> i32;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_events {
    _unused: [u8; 0],
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_event {
    pub frame: f64,
    pub seconds: f64,
    pub cycle: i64,
    pub confidence: f64,
    pub marked: i64,
}
#[test]
fn bindgen_test_layout_stltsa_event() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_event>(),
        40usize,
        concat!("Size of: ", stringify!(stltsa_event))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_event>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_event))
    );
    fn test_field_frame() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_event>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).frame) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_event), "::", stringify!(frame))
        );
    }
    test_field_frame();
    fn test_field_seconds() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_event>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).seconds) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_event), "::", stringify!(seconds))
        );
    }
    test_field_seconds();
    fn test_field_cycle() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_event>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).cycle) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_event), "::", stringify!(cycle))
        );
    }
    test_field_cycle();
    fn test_field_confidence() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_event>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).confidence) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_event), "::", stringify!(confidence))
        );
    }
    test_field_confidence();
    fn test_field_marked() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_event>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).marked) as usize - ptr as usize
            },
            32usize,
            concat!("Offset of field: ", stringify!(stltsa_event), "::", stringify!(marked))
        );
    }
    test_field_marked();
}
extern "C" {
    pub fn stltsa_events_find(
        from: *const stltsa_phase,
        marks: *const stltsa_in,
        in_: *const stltsa_phase,
        options: *const stltsa_options,
        events: *mut *mut stltsa_events,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_events_free(events: *mut stltsa_events);
}
extern "C" {
    pub fn stltsa_events_info(events: *const stltsa_events) -> *const stltsa_info;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_comparison {
    _unused: [u8; 0],
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_estimate {
    pub first: f64,
    pub first_sd: f64,
    pub second: f64,
    pub second_sd: f64,
    pub difference: f64,
    pub standard_error: f64,
    pub low: f64,
    pub high: f64,
    pub significant: i64,
}
#[test]
fn bindgen_test_layout_stltsa_estimate() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_estimate>(),
        72usize,
        concat!("Size of: ", stringify!(stltsa_estimate))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_estimate>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_estimate))
    );
    fn test_field_first() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_estimate>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).first) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_estimate), "::", stringify!(first))
        );
    }
    test_field_first();
    fn test_field_first_sd() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_estimate>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).first_sd) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_estimate), "::", stringify!(first_sd))
        );
    }
    test_field_first_sd();
    fn test_field_second() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_estimate>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).second) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_estimate), "::", stringify!(second))
        );
    }
    test_field_second();
    fn test_field_second_sd() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_estimate>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).second_sd) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_estimate), "::", stringify!(second_sd))
        );
    }
    test_field_second_sd();
    fn test_field_difference() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_estimate>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).difference) as usize - ptr as usize
            },
            32usize,
            concat!("Offset of field: ", stringify!(stltsa_estimate), "::", stringify!(difference))
        );
    }
    test_field_difference();
    fn test_field_standard_error() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_estimate>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).standard_error) as usize - ptr as usize
            },
            40usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_estimate),
                "::",
                stringify!(standard_error)
            )
        );
    }
    test_field_standard_error();
    fn test_field_low() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_estimate>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).low) as usize - ptr as usize
            },
            48usize,
            concat!("Offset of field: ", stringify!(stltsa_estimate), "::", stringify!(low))
        );
    }
    test_field_low();
    fn test_field_high() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_estimate>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).high) as usize - ptr as usize
            },
            56usize,
            concat!("Offset of field: ", stringify!(stltsa_estimate), "::", stringify!(high))
        );
    }
    test_field_high();
    fn test_field_significant() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_estimate>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).significant) as usize - ptr as usize
            },
            64usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_estimate),
                "::",
                stringify!(significant)
            )
        );
    }
    test_field_significant();
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_bounded {
    pub value: f64,
    pub low: f64,
    pub high: f64,
}
#[test]
fn bindgen_test_layout_stltsa_bounded() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_bounded>(),
        24usize,
        concat!("Size of: ", stringify!(stltsa_bounded))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_bounded>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_bounded))
    );
    fn test_field_value() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_bounded>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).value) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_bounded), "::", stringify!(value))
        );
    }
    test_field_value();
    fn test_field_low() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_bounded>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).low) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_bounded), "::", stringify!(low))
        );
    }
    test_field_low();
    fn test_field_high() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_bounded>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).high) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_bounded), "::", stringify!(high))
        );
    }
    test_field_high();
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_compared {
    pub sides: i64,
    pub features: i64,
    pub samples: i64,
    pub shift: f64,
    pub shift_error: f64,
    pub shift_low: f64,
    pub shift_high: f64,
    pub likeness: f64,
    pub runner_up: f64,
    pub turn_deg: f64,
    pub size_ratio: f64,
    pub cycle_time_s: stltsa_estimate,
    pub judged: i64,
    pub significant: i64,
    pub expected_by_chance: f64,
}
#[test]
fn bindgen_test_layout_stltsa_compared() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_compared>(),
        184usize,
        concat!("Size of: ", stringify!(stltsa_compared))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_compared>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_compared))
    );
    fn test_field_sides() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).sides) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_compared), "::", stringify!(sides))
        );
    }
    test_field_sides();
    fn test_field_features() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).features) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_compared), "::", stringify!(features))
        );
    }
    test_field_features();
    fn test_field_samples() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).samples) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_compared), "::", stringify!(samples))
        );
    }
    test_field_samples();
    fn test_field_shift() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).shift) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_compared), "::", stringify!(shift))
        );
    }
    test_field_shift();
    fn test_field_shift_error() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).shift_error) as usize - ptr as usize
            },
            32usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared),
                "::",
                stringify!(shift_error)
            )
        );
    }
    test_field_shift_error();
    fn test_field_shift_low() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).shift_low) as usize - ptr as usize
            },
            40usize,
            concat!("Offset of field: ", stringify!(stltsa_compared), "::", stringify!(shift_low))
        );
    }
    test_field_shift_low();
    fn test_field_shift_high() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).shift_high) as usize - ptr as usize
            },
            48usize,
            concat!("Offset of field: ", stringify!(stltsa_compared), "::", stringify!(shift_high))
        );
    }
    test_field_shift_high();
    fn test_field_likeness() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).likeness) as usize - ptr as usize
            },
            56usize,
            concat!("Offset of field: ", stringify!(stltsa_compared), "::", stringify!(likeness))
        );
    }
    test_field_likeness();
    fn test_field_runner_up() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).runner_up) as usize - ptr as usize
            },
            64usize,
            concat!("Offset of field: ", stringify!(stltsa_compared), "::", stringify!(runner_up))
        );
    }
    test_field_runner_up();
    fn test_field_turn_deg() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).turn_deg) as usize - ptr as usize
            },
            72usize,
            concat!("Offset of field: ", stringify!(stltsa_compared), "::", stringify!(turn_deg))
        );
    }
    test_field_turn_deg();
    fn test_field_size_ratio() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).size_ratio) as usize - ptr as usize
            },
            80usize,
            concat!("Offset of field: ", stringify!(stltsa_compared), "::", stringify!(size_ratio))
        );
    }
    test_field_size_ratio();
    fn test_field_cycle_time_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).cycle_time_s) as usize - ptr as usize
            },
            88usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared),
                "::",
                stringify!(cycle_time_s)
            )
        );
    }
    test_field_cycle_time_s();
    fn test_field_judged() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).judged) as usize - ptr as usize
            },
            160usize,
            concat!("Offset of field: ", stringify!(stltsa_compared), "::", stringify!(judged))
        );
    }
    test_field_judged();
    fn test_field_significant() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).significant) as usize - ptr as usize
            },
            168usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared),
                "::",
                stringify!(significant)
            )
        );
    }
    test_field_significant();
    fn test_field_expected_by_chance() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).expected_by_chance) as usize - ptr as usize
            },
            176usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared),
                "::",
                stringify!(expected_by_chance)
            )
        );
    }
    test_field_expected_by_chance();
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_compared_motion {
    pub path: *const ::std::os::raw::c_char,
    pub frames: i64,
    pub fps: f64,
    pub label: i64,
    pub letters: *const ::std::os::raw::c_char,
    pub cycles: i64,
    pub cycles_per_min: f64,
    pub left_out: *const *const ::std::os::raw::c_char,
}
#[test]
fn bindgen_test_layout_stltsa_compared_motion() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_compared_motion>(),
        64usize,
        concat!("Size of: ", stringify!(stltsa_compared_motion))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_compared_motion>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_compared_motion))
    );
    fn test_field_path() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_motion>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).path) as usize - ptr as usize
            },
            0usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_motion),
                "::",
                stringify!(path)
            )
        );
    }
    test_field_path();
    fn test_field_frames() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_motion>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).frames) as usize - ptr as usize
            },
            8usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_motion),
                "::",
                stringify!(frames)
            )
        );
    }
    test_field_frames();
    fn test_field_fps() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_motion>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).fps) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_compared_motion), "::", stringify!(fps))
        );
    }
    test_field_fps();
    fn test_field_label() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_motion>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).label) as usize - ptr as usize
            },
            24usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_motion),
                "::",
                stringify!(label)
            )
        );
    }
    test_field_label();
    fn test_field_letters() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_motion>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).letters) as usize - ptr as usize
            },
            32usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_motion),
                "::",
                stringify!(letters)
            )
        );
    }
    test_field_letters();
    fn test_field_cycles() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_motion>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).cycles) as usize - ptr as usize
            },
            40usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_motion),
                "::",
                stringify!(cycles)
            )
        );
    }
    test_field_cycles();
    fn test_field_cycles_per_min() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_motion>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).cycles_per_min) as usize - ptr as usize
            },
            48usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_motion),
                "::",
                stringify!(cycles_per_min)
            )
        );
    }
    test_field_cycles_per_min();
    fn test_field_left_out() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_motion>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).left_out) as usize - ptr as usize
            },
            56usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_motion),
                "::",
                stringify!(left_out)
            )
        );
    }
    test_field_left_out();
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_compared_part {
    pub part: i64,
    pub first: *const ::std::os::raw::c_char,
    pub second: *const ::std::os::raw::c_char,
    pub axis: *const ::std::os::raw::c_char,
    pub mean: stltsa_estimate,
    pub lag: stltsa_estimate,
    pub lag_s: stltsa_bounded,
    pub amplitude: stltsa_estimate,
    pub amplitude_ratio: stltsa_bounded,
    pub rms_difference: f64,
    pub rms_by_chance: f64,
    pub correlation: f64,
}
#[test]
fn bindgen_test_layout_stltsa_compared_part() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_compared_part>(),
        320usize,
        concat!("Size of: ", stringify!(stltsa_compared_part))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_compared_part>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_compared_part))
    );
    fn test_field_part() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).part) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_compared_part), "::", stringify!(part))
        );
    }
    test_field_part();
    fn test_field_first() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).first) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_compared_part), "::", stringify!(first))
        );
    }
    test_field_first();
    fn test_field_second() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).second) as usize - ptr as usize
            },
            16usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_part),
                "::",
                stringify!(second)
            )
        );
    }
    test_field_second();
    fn test_field_axis() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).axis) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_compared_part), "::", stringify!(axis))
        );
    }
    test_field_axis();
    fn test_field_mean() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).mean) as usize - ptr as usize
            },
            32usize,
            concat!("Offset of field: ", stringify!(stltsa_compared_part), "::", stringify!(mean))
        );
    }
    test_field_mean();
    fn test_field_lag() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).lag) as usize - ptr as usize
            },
            104usize,
            concat!("Offset of field: ", stringify!(stltsa_compared_part), "::", stringify!(lag))
        );
    }
    test_field_lag();
    fn test_field_lag_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).lag_s) as usize - ptr as usize
            },
            176usize,
            concat!("Offset of field: ", stringify!(stltsa_compared_part), "::", stringify!(lag_s))
        );
    }
    test_field_lag_s();
    fn test_field_amplitude() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).amplitude) as usize - ptr as usize
            },
            200usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_part),
                "::",
                stringify!(amplitude)
            )
        );
    }
    test_field_amplitude();
    fn test_field_amplitude_ratio() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).amplitude_ratio) as usize - ptr as usize
            },
            272usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_part),
                "::",
                stringify!(amplitude_ratio)
            )
        );
    }
    test_field_amplitude_ratio();
    fn test_field_rms_difference() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).rms_difference) as usize - ptr as usize
            },
            296usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_part),
                "::",
                stringify!(rms_difference)
            )
        );
    }
    test_field_rms_difference();
    fn test_field_rms_by_chance() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).rms_by_chance) as usize - ptr as usize
            },
            304usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_part),
                "::",
                stringify!(rms_by_chance)
            )
        );
    }
    test_field_rms_by_chance();
    fn test_field_correlation() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).correlation) as usize - ptr as usize
            },
            312usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_part),
                "::",
                stringify!(correlation)
            )
        );
    }
    test_field_correlation();
}
extern "C" {
    pub fn stltsa_compare(
        first: *const stltsa_phase,
        first_label: i64,
        second: *const stltsa_phase,
        second_label: i64,
        samples: i64,
        options: *const stltsa_options,
        comparison: *mut *mut stltsa_comparison,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_compare_left_right(
        clip: *const stltsa_clip,
        phase: *const stltsa_phase,
        label: i64,
        samples: i64,
        options: *const stltsa_options,
        comparison: *mut *mut stltsa_comparison,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_cycles_compare_left_right(
        cycles: *const stltsa_cycles,
        names: *const *const ::std::os::raw::c_char,
        fps: f64,
        options: *const stltsa_options,
        comparison: *mut *mut stltsa_comparison,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_comparison_free(comparison: *mut stltsa_comparison);
}
extern "C" {
    pub fn stltsa_comparison_info(comparison: *const stltsa_comparison) -> *const stltsa_info;
}
extern "C" {
    pub fn stltsa_model_keep_cycle(
        model: *mut stltsa_model,
        phase: *const stltsa_phase,
        options: *const stltsa_options,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_model_keep_mark(
        model: *mut stltsa_model,
        phase: *const stltsa_phase,
        frame: f64,
        name: *const ::std::os::raw::c_char,
    ) -> stltsa_status;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_live {
    _unused: [u8; 0],
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_live_frame {
    pub size: usize,
    pub passed: i64,
    pub phase: f64,
    pub rate_hz: f64,
    pub cycles: f64,
    pub distance: f64,
    pub confidence: f64,
    pub known: i32,
    pub kind: i32,
}
#[test]
fn bindgen_test_layout_stltsa_live_frame() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_live_frame>(),
        64usize,
        concat!("Size of: ", stringify!(stltsa_live_frame))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_live_frame>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_live_frame))
    );
    fn test_field_size() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_live_frame>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).size) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_live_frame), "::", stringify!(size))
        );
    }
    test_field_size();
    fn test_field_passed() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_live_frame>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).passed) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_live_frame), "::", stringify!(passed))
        );
    }
    test_field_passed();
    fn test_field_phase() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_live_frame>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).phase) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_live_frame), "::", stringify!(phase))
        );
    }
    test_field_phase();
    fn test_field_rate_hz() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_live_frame>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).rate_hz) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_live_frame), "::", stringify!(rate_hz))
        );
    }
    test_field_rate_hz();
    fn test_field_cycles() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_live_frame>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).cycles) as usize - ptr as usize
            },
            32usize,
            concat!("Offset of field: ", stringify!(stltsa_live_frame), "::", stringify!(cycles))
        );
    }
    test_field_cycles();
    fn test_field_distance() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_live_frame>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).distance) as usize - ptr as usize
            },
            40usize,
            concat!("Offset of field: ", stringify!(stltsa_live_frame), "::", stringify!(distance))
        );
    }
    test_field_distance();
    fn test_field_confidence() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_live_frame>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).confidence) as usize - ptr as usize
            },
            48usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_live_frame),
                "::",
                stringify!(confidence)
            )
        );
    }
    test_field_confidence();
    fn test_field_known() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_live_frame>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).known) as usize - ptr as usize
            },
            56usize,
            concat!("Offset of field: ", stringify!(stltsa_live_frame), "::", stringify!(known))
        );
    }
    test_field_known();
    fn test_field_kind() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_live_frame>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).kind) as usize - ptr as usize
            },
            60usize,
            concat!("Offset of field: ", stringify!(stltsa_live_frame), "::", stringify!(kind))
        );
    }
    test_field_kind();
}
extern "C" {
    pub fn stltsa_live_new(
        model: *const stltsa_model,
        live: *mut *mut stltsa_live,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_live_free(live: *mut stltsa_live);
}
extern "C" {
    pub fn stltsa_live_info(live: *const stltsa_live) -> *const stltsa_info;
}
extern "C" {
    pub fn stltsa_live_push_points(
        live: *mut stltsa_live,
        seconds: f64,
        points: *const stltsa_in,
        confidence: *const stltsa_in,
        frame: *mut stltsa_live_frame,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_live_push_pose(
        live: *mut stltsa_live,
        seconds: f64,
        form: i32,
        rotations: *const stltsa_in,
        root: *const stltsa_in,
        frame: *mut stltsa_live_frame,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_live_push_frame(
        live: *mut stltsa_live,
        seconds: f64,
        clip: *const stltsa_clip,
        index: i64,
        frame: *mut stltsa_live_frame,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_live_push(
        live: *mut stltsa_live,
        seconds: f64,
        features: *const stltsa_in,
        frame: *mut stltsa_live_frame,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_report_save(
        clip: *const stltsa_clip,
        decomposition: *const stltsa_decomposition,
        options: *const stltsa_options,
        command: *const ::std::os::raw::c_char,
        path: *const ::std::os::raw::c_char,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_comparison_report_save(
        comparison: *const stltsa_comparison,
        options: *const stltsa_options,
        command: *const ::std::os::raw::c_char,
        path: *const ::std::os::raw::c_char,
    ) -> stltsa_status;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_denoising {
    _unused: [u8; 0],
}
extern "C" {
    pub fn stltsa_denoise(
        coords: *const stltsa_in,
        lengths: *const stltsa_in,
        options: *const stltsa_options,
        denoising: *mut *mut stltsa_denoising,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_denoise_model(
        model: *const stltsa_model,
        options: *const stltsa_options,
        denoising: *mut *mut stltsa_denoising,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_denoising_free(denoising: *mut stltsa_denoising);
}
extern "C" {
    pub fn stltsa_denoising_info(denoising: *const stltsa_denoising) -> *const stltsa_info;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_denoised_column {
    pub gamma: f64,
    pub shift: f64,
    pub noise: f64,
    pub noise_share: f64,
    pub degrees_of_freedom: f64,
    pub moved: i64,
}
#[test]
fn bindgen_test_layout_stltsa_denoised_column() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_denoised_column>(),
        48usize,
        concat!("Size of: ", stringify!(stltsa_denoised_column))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_denoised_column>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_denoised_column))
    );
    fn test_field_gamma() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_denoised_column>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).gamma) as usize - ptr as usize
            },
            0usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_denoised_column),
                "::",
                stringify!(gamma)
            )
        );
    }
    test_field_gamma();
    fn test_field_shift() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_denoised_column>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).shift) as usize - ptr as usize
            },
            8usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_denoised_column),
                "::",
                stringify!(shift)
            )
        );
    }
    test_field_shift();
    fn test_field_noise() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_denoised_column>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).noise) as usize - ptr as usize
            },
            16usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_denoised_column),
                "::",
                stringify!(noise)
            )
        );
    }
    test_field_noise();
    fn test_field_noise_share() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_denoised_column>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).noise_share) as usize - ptr as usize
            },
            24usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_denoised_column),
                "::",
                stringify!(noise_share)
            )
        );
    }
    test_field_noise_share();
    fn test_field_degrees_of_freedom() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_denoised_column>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).degrees_of_freedom) as usize - ptr as usize
            },
            32usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_denoised_column),
                "::",
                stringify!(degrees_of_freedom)
            )
        );
    }
    test_field_degrees_of_freedom();
    fn test_field_moved() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_denoised_column>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).moved) as usize - ptr as usize
            },
            40usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_denoised_column),
                "::",
                stringify!(moved)
            )
        );
    }
    test_field_moved();
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_piece {
    pub clip: *const stltsa_clip,
    pub begin: i64,
    pub end: i64,
    pub repeat: i64,
    pub reserved: i64,
}
#[test]
fn bindgen_test_layout_stltsa_piece() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_piece>(),
        40usize,
        concat!("Size of: ", stringify!(stltsa_piece))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_piece>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_piece))
    );
    fn test_field_clip() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_piece>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).clip) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_piece), "::", stringify!(clip))
        );
    }
    test_field_clip();
    fn test_field_begin() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_piece>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).begin) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_piece), "::", stringify!(begin))
        );
    }
    test_field_begin();
    fn test_field_end() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_piece>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).end) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_piece), "::", stringify!(end))
        );
    }
    test_field_end();
    fn test_field_repeat() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_piece>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).repeat) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_piece), "::", stringify!(repeat))
        );
    }
    test_field_repeat();
    fn test_field_reserved() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_piece>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).reserved) as usize - ptr as usize
            },
            32usize,
            concat!("Offset of field: ", stringify!(stltsa_piece), "::", stringify!(reserved))
        );
    }
    test_field_reserved();
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_synthesis {
    _unused: [u8; 0],
}
extern "C" {
    pub fn stltsa_synthesize(
        pieces: *const stltsa_piece,
        count: i64,
        options: *const stltsa_options,
        synthesis: *mut *mut stltsa_synthesis,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_synthesize_loop(
        clip: *const stltsa_clip,
        decomposition: *const stltsa_decomposition,
        options: *const stltsa_options,
        synthesis: *mut *mut stltsa_synthesis,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_synthesis_free(synthesis: *mut stltsa_synthesis);
}
extern "C" {
    pub fn stltsa_synthesis_info(synthesis: *const stltsa_synthesis) -> *const stltsa_info;
}
extern "C" {
    pub fn stltsa_synthesis_clip(synthesis: *const stltsa_synthesis) -> *const stltsa_clip;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_seam {
    pub frame: i64,
    pub time_s: f64,
    pub piece: i64,
    pub next: i64,
    pub cut_end: i64,
    pub cut_begin: i64,
    pub crossfade: i64,
    pub crossfade_s: f64,
    pub posture: f64,
    pub step: f64,
    pub acceleration: f64,
    pub wrap: i64,
}
#[test]
fn bindgen_test_layout_stltsa_seam() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_seam>(),
        96usize,
        concat!("Size of: ", stringify!(stltsa_seam))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_seam>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_seam))
    );
    fn test_field_frame() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_seam>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).frame) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_seam), "::", stringify!(frame))
        );
    }
    test_field_frame();
    fn test_field_time_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_seam>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).time_s) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_seam), "::", stringify!(time_s))
        );
    }
    test_field_time_s();
    fn test_field_piece() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_seam>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).piece) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_seam), "::", stringify!(piece))
        );
    }
    test_field_piece();
    fn test_field_next() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_seam>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).next) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_seam), "::", stringify!(next))
        );
    }
    test_field_next();
    fn test_field_cut_end() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_seam>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).cut_end) as usize - ptr as usize
            },
            32usize,
            concat!("Offset of field: ", stringify!(stltsa_seam), "::", stringify!(cut_end))
        );
    }
    test_field_cut_end();
    fn test_field_cut_begin() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_seam>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).cut_begin) as usize - ptr as usize
            },
            40usize,
            concat!("Offset of field: ", stringify!(stltsa_seam), "::", stringify!(cut_begin))
        );
    }
    test_field_cut_begin();
    fn test_field_crossfade() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_seam>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).crossfade) as usize - ptr as usize
            },
            48usize,
            concat!("Offset of field: ", stringify!(stltsa_seam), "::", stringify!(crossfade))
        );
    }
    test_field_crossfade();
    fn test_field_crossfade_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_seam>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).crossfade_s) as usize - ptr as usize
            },
            56usize,
            concat!("Offset of field: ", stringify!(stltsa_seam), "::", stringify!(crossfade_s))
        );
    }
    test_field_crossfade_s();
    fn test_field_posture() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_seam>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).posture) as usize - ptr as usize
            },
            64usize,
            concat!("Offset of field: ", stringify!(stltsa_seam), "::", stringify!(posture))
        );
    }
    test_field_posture();
    fn test_field_step() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_seam>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).step) as usize - ptr as usize
            },
            72usize,
            concat!("Offset of field: ", stringify!(stltsa_seam), "::", stringify!(step))
        );
    }
    test_field_step();
    fn test_field_acceleration() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_seam>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).acceleration) as usize - ptr as usize
            },
            80usize,
            concat!("Offset of field: ", stringify!(stltsa_seam), "::", stringify!(acceleration))
        );
    }
    test_field_acceleration();
    fn test_field_wrap() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_seam>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).wrap) as usize - ptr as usize
            },
            88usize,
            concat!("Offset of field: ", stringify!(stltsa_seam), "::", stringify!(wrap))
        );
    }
    test_field_wrap();
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_piece_fact {
    pub path: *const ::std::os::raw::c_char,
    pub begin: i64,
    pub end: i64,
    pub repeat: i64,
}
#[test]
fn bindgen_test_layout_stltsa_piece_fact() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_piece_fact>(),
        32usize,
        concat!("Size of: ", stringify!(stltsa_piece_fact))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_piece_fact>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_piece_fact))
    );
    fn test_field_path() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_piece_fact>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).path) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_piece_fact), "::", stringify!(path))
        );
    }
    test_field_path();
    fn test_field_begin() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_piece_fact>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).begin) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_piece_fact), "::", stringify!(begin))
        );
    }
    test_field_begin();
    fn test_field_end() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_piece_fact>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).end) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_piece_fact), "::", stringify!(end))
        );
    }
    test_field_end();
    fn test_field_repeat() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_piece_fact>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).repeat) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_piece_fact), "::", stringify!(repeat))
        );
    }
    test_field_repeat();
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_batch {
    _unused: [u8; 0],
}
extern "C" {
    pub fn stltsa_batch_new(
        paths: *const *const ::std::os::raw::c_char,
        count: i64,
        folder: *const ::std::os::raw::c_char,
        shard: *const ::std::os::raw::c_char,
        options: *const stltsa_options,
        batch: *mut *mut stltsa_batch,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_batch_free(batch: *mut stltsa_batch);
}
extern "C" {
    pub fn stltsa_batch_path(
        batch: *const stltsa_batch,
        index: i64,
    ) -> *const ::std::os::raw::c_char;
}
extern "C" {
    pub fn stltsa_batch_run(
        batch: *const stltsa_batch,
        index: i64,
        clip: *const stltsa_clip,
        options: *const stltsa_options,
        kept: *mut i32,
        row: *mut *mut ::std::os::raw::c_char,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_batch_finish(
        batch: *const stltsa_batch,
        rows: *const *const ::std::os::raw::c_char,
        count: i64,
        summary: *mut *const ::std::os::raw::c_char,
    ) -> stltsa_status;
}
