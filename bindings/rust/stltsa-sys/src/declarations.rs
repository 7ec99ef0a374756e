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
extern "C" {
    pub fn stltsa_version_number() -> i32;
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
pub const STLTSA_OPT_LEAST_CONFIDENCE: i32 = 34;
pub const STLTSA_OPT_LOOP: i32 = 35;
pub const STLTSA_OPT_IN_PLACE: i32 = 36;
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
pub const STLTSA_CALL_OPEN: i32 = 1;
pub const STLTSA_CALL_FEATURES: i32 = 2;
pub const STLTSA_CALL_FIT: i32 = 4;
pub const STLTSA_CALL_DIMENSION: i32 = 8;
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
    pub fn stltsa_option_count() -> i64;
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
pub const STLTSA_INFO_COMPONENT_ROWS: i32 = 43;
pub const STLTSA_INFO_RANK_DEFICIENT: i32 = 44;
pub const STLTSA_INFO_SOLVES: i32 = 45;
pub const STLTSA_INFO_RESIDUAL: i32 = 46;
pub const STLTSA_INFO_ERROR_ESTIMATE: i32 = 47;
pub const STLTSA_INFO_GAP: i32 = 48;
pub const STLTSA_INFO_COMPONENTS: i32 = 49;
pub const STLTSA_INFO_COORDINATE: i32 = 60;
pub const STLTSA_INFO_CYCLICITY: i32 = 61;
pub const STLTSA_INFO_REPRESENTATIVE: i32 = 62;
pub const STLTSA_INFO_BEST: i32 = 63;
pub const STLTSA_INFO_REASON: i32 = 64;
pub const STLTSA_INFO_EIGENVALUE: i32 = 65;
pub const STLTSA_INFO_POSTURES: i32 = 68;
pub const STLTSA_INFO_LOCAL_PCA: i32 = 66;
pub const STLTSA_INFO_EIGENGAP: i32 = 67;
pub const STLTSA_INFO_LOCAL_PCA_REASON: i32 = 70;
pub const STLTSA_INFO_EIGENGAP_REASON: i32 = 71;
pub const STLTSA_INFO_VARIANCE: i32 = 72;
pub const STLTSA_INFO_EIGENGAP_THRESHOLD: i32 = 73;
pub const STLTSA_INFO_LOCAL_VARIANCE: i32 = 74;
pub const STLTSA_INFO_GAMMA: i32 = 80;
pub const STLTSA_INFO_SHIFT: i32 = 81;
pub const STLTSA_INFO_NOISE: i32 = 82;
pub const STLTSA_INFO_DEGREES_OF_FREEDOM: i32 = 83;
pub const STLTSA_INFO_MOVED: i32 = 84;
pub const STLTSA_INFO_GAMMA_OPTION: i32 = 85;
pub const STLTSA_INFO_KNOT_ROWS: i32 = 86;
pub const STLTSA_INFO_ROBUST: i32 = 87;
pub const STLTSA_INFO_FIT_PERIOD_MIN: i32 = 88;
pub const STLTSA_INFO_FIT_PERIOD_MAX: i32 = 89;
pub const STLTSA_INFO_COLUMNS: i32 = 90;
pub const STLTSA_INFO_NOISE_SHARE: i32 = 91;
pub const STLTSA_INFO_NOTHING_TO_CLEAN: i32 = 92;
pub const STLTSA_INFO_CROSSFADE: i32 = 100;
pub const STLTSA_INFO_CUT_RANGE: i32 = 101;
pub const STLTSA_INFO_POSTURE_LIMIT: i32 = 102;
pub const STLTSA_INFO_PIECE_PATH: i32 = 103;
pub const STLTSA_INFO_PIECE_BEGIN: i32 = 104;
pub const STLTSA_INFO_PIECE_END: i32 = 105;
pub const STLTSA_INFO_PIECE_REPEAT: i32 = 106;
pub const STLTSA_INFO_LOOP: i32 = 107;
pub const STLTSA_INFO_IN_PLACE: i32 = 108;
pub const STLTSA_INFO_TRAVEL: i32 = 109;
pub const STLTSA_INFO_TURN: i32 = 110;
pub const STLTSA_INFO_COVERAGE: i32 = 111;
pub const STLTSA_INFO_LOOP_CYCLES: i32 = 112;
pub const STLTSA_INFO_SOURCE_CYCLES: i32 = 113;
pub const STLTSA_INFO_WARNING: i32 = 120;
pub const STLTSA_INFO_WARNING_CODE: i32 = 121;
pub const STLTSA_INFO_WARNING_BEGIN: i32 = 122;
pub const STLTSA_INFO_WARNING_END: i32 = 123;
pub const STLTSA_INFO_UNIT: i32 = 130;
pub const STLTSA_INFO_FILE_UP_AXIS: i32 = 131;
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
pub const STLTSA_HANDLE_CLIP: i32 = 1;
pub const STLTSA_HANDLE_MODEL: i32 = 2;
pub const STLTSA_HANDLE_DIMENSION: i32 = 4;
pub const STLTSA_HANDLE_DECOMPOSITION: i32 = 8;
pub const STLTSA_HANDLE_DENOISING: i32 = 16;
pub const STLTSA_HANDLE_SYNTHESIS: i32 = 32;
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
    pub fn stltsa_info_key_count() -> i64;
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
    pub size: usize,
    pub name: *const ::std::os::raw::c_char,
    pub parent: i64,
    pub offset: [f64; 3usize],
    pub channels: *const ::std::os::raw::c_char,
    pub is_end_site: i32,
    pub reserved: i32,
}
#[test]
fn bindgen_test_layout_stltsa_joint() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_joint>(),
        64usize,
        concat!("Size of: ", stringify!(stltsa_joint))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_joint>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_joint))
    );
    fn test_field_size() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_joint>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).size) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_joint), "::", stringify!(size))
        );
    }
    test_field_size();
    fn test_field_name() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_joint>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).name) as usize - ptr as usize
            },
            8usize,
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
            16usize,
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
            24usize,
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
            48usize,
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
            56usize,
            concat!("Offset of field: ", stringify!(stltsa_joint), "::", stringify!(is_end_site))
        );
    }
    test_field_is_end_site();
    fn test_field_reserved() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_joint>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).reserved) as usize - ptr as usize
            },
            60usize,
            concat!("Offset of field: ", stringify!(stltsa_joint), "::", stringify!(reserved))
        );
    }
    test_field_reserved();
}
pub const STLTSA_ROTATIONS_QUATERNION: i32 = 1;
pub const STLTSA_ROTATIONS_MATRIX: i32 = 2;
pub const STLTSA_ROTATIONS_CHANNELS: i32 = 3;
extern "C" {
    pub fn stltsa_clip_from_skeleton(
        joints: *const stltsa_joint,
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
extern "C" {
    pub fn stltsa_clip_format(clip: *const stltsa_clip) -> i32;
}
extern "C" {
    pub fn stltsa_clip_channels(clip: *const stltsa_clip) -> i64;
}
extern "C" {
    pub fn stltsa_clip_joints(clip: *const stltsa_clip) -> i64;
}
extern "C" {
    pub fn stltsa_clip_joint(
        clip: *const stltsa_clip,
        index: i64,
        joint: *mut stltsa_joint,
    ) -> stltsa_status;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_file_event {
    pub size: usize,
    pub label: *const ::std::os::raw::c_char,
    pub context: *const ::std::os::raw::c_char,
    pub frame: f64,
    pub seconds: f64,
}
#[test]
fn bindgen_test_layout_stltsa_file_event() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_file_event>(),
        40usize,
        concat!("Size of: ", stringify!(stltsa_file_event))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_file_event>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_file_event))
    );
    fn test_field_size() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_file_event>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).size) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_file_event), "::", stringify!(size))
        );
    }
    test_field_size();
    fn test_field_label() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_file_event>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).label) as usize - ptr as usize
            },
            8usize,
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
            16usize,
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
            24usize,
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
            32usize,
            concat!("Offset of field: ", stringify!(stltsa_file_event), "::", stringify!(seconds))
        );
    }
    test_field_seconds();
}
extern "C" {
    pub fn stltsa_clip_event_count(clip: *const stltsa_clip) -> i64;
}
extern "C" {
    pub fn stltsa_clip_event(
        clip: *const stltsa_clip,
        index: i64,
        event: *mut stltsa_file_event,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_clip_positions(
        clip: *const stltsa_clip,
        positions: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_clip_rotations(
        clip: *const stltsa_clip,
        rotations: *const stltsa_out,
    ) -> stltsa_status;
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
    pub fn stltsa_clip_json(
        clip: *const stltsa_clip,
        json: *mut *mut ::std::os::raw::c_char,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_clip_save(
        clip: *const stltsa_clip,
        path: *const ::std::os::raw::c_char,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_clip_save_with(
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
    pub fn stltsa_fit_clip(
        clip: *const stltsa_clip,
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
extern "C" {
    pub fn stltsa_model_coords(
        model: *const stltsa_model,
        coords: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_model_eigenvalues(
        model: *const stltsa_model,
        values: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_model_components(
        model: *const stltsa_model,
        labels: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_model_warning_count(model: *const stltsa_model) -> i64;
}
extern "C" {
    pub fn stltsa_model_warning(
        model: *const stltsa_model,
        index: i64,
    ) -> *const ::std::os::raw::c_char;
}
extern "C" {
    pub fn stltsa_model_json(
        model: *const stltsa_model,
        json: *mut *mut ::std::os::raw::c_char,
    ) -> stltsa_status;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_dimension {
    _unused: [u8; 0],
}
extern "C" {
    pub fn stltsa_estimate_dimension(
        frames: *const stltsa_in,
        lengths: *const stltsa_in,
        options: *const stltsa_options,
        dimension: *mut *mut stltsa_dimension,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_estimate_dimension_clip(
        clip: *const stltsa_clip,
        options: *const stltsa_options,
        dimension: *mut *mut stltsa_dimension,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_estimate_dimension_clips(
        clips: *const *const stltsa_clip,
        count: i64,
        options: *const stltsa_options,
        dimension: *mut *mut stltsa_dimension,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_dimension_free(dimension: *mut stltsa_dimension);
}
extern "C" {
    pub fn stltsa_dimension_info(dimension: *const stltsa_dimension) -> *const stltsa_info;
}
extern "C" {
    pub fn stltsa_dimension_eigengap(
        dimension: *const stltsa_dimension,
        reason: *mut *const ::std::os::raw::c_char,
    ) -> i64;
}
extern "C" {
    pub fn stltsa_dimension_local_pca(
        dimension: *const stltsa_dimension,
        reason: *mut *const ::std::os::raw::c_char,
    ) -> i64;
}
extern "C" {
    pub fn stltsa_dimension_eigenvalues(
        dimension: *const stltsa_dimension,
        values: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_dimension_local_variances(
        dimension: *const stltsa_dimension,
        shares: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_dimension_json(
        dimension: *const stltsa_dimension,
        json: *mut *mut ::std::os::raw::c_char,
    ) -> stltsa_status;
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
pub const STLTSA_UNIT_CYCLE: i32 = 7;
pub const STLTSA_UNIT_HOLD: i32 = 8;
extern "C" {
    pub fn stltsa_unit_name(kind: i32) -> *const ::std::os::raw::c_char;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_interval {
    pub begin: i64,
    pub end: i64,
    pub begin_s: f64,
    pub end_s: f64,
    pub kind: i32,
    pub segment: i32,
}
#[test]
fn bindgen_test_layout_stltsa_interval() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_interval>(),
        40usize,
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
    fn test_field_kind() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_interval>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).kind) as usize - ptr as usize
            },
            32usize,
            concat!("Offset of field: ", stringify!(stltsa_interval), "::", stringify!(kind))
        );
    }
    test_field_kind();
    fn test_field_segment() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_interval>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).segment) as usize - ptr as usize
            },
            36usize,
            concat!("Offset of field: ", stringify!(stltsa_interval), "::", stringify!(segment))
        );
    }
    test_field_segment();
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
    pub fn stltsa_segment_name(kind: i32) -> *const ::std::os::raw::c_char;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_segment {
    pub begin: i64,
    pub end: i64,
    pub begin_s: f64,
    pub end_s: f64,
    pub count: i64,
    pub likeness: f64,
    pub period_s: f64,
    pub candidate_period_s: f64,
    pub confidence: f64,
    pub begin_confidence: f64,
    pub kind: i32,
    pub label: i32,
    pub open_begin: i32,
    pub open_end: i32,
}
#[test]
fn bindgen_test_layout_stltsa_segment() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_segment>(),
        96usize,
        concat!("Size of: ", stringify!(stltsa_segment))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_segment>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_segment))
    );
    fn test_field_begin() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).begin) as usize - ptr as usize
            },
            0usize,
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
            8usize,
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
            16usize,
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
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_segment), "::", stringify!(end_s))
        );
    }
    test_field_end_s();
    fn test_field_count() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).count) as usize - ptr as usize
            },
            32usize,
            concat!("Offset of field: ", stringify!(stltsa_segment), "::", stringify!(count))
        );
    }
    test_field_count();
    fn test_field_likeness() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).likeness) as usize - ptr as usize
            },
            40usize,
            concat!("Offset of field: ", stringify!(stltsa_segment), "::", stringify!(likeness))
        );
    }
    test_field_likeness();
    fn test_field_period_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).period_s) as usize - ptr as usize
            },
            48usize,
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
            56usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_segment),
                "::",
                stringify!(candidate_period_s)
            )
        );
    }
    test_field_candidate_period_s();
    fn test_field_confidence() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).confidence) as usize - ptr as usize
            },
            64usize,
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
            72usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_segment),
                "::",
                stringify!(begin_confidence)
            )
        );
    }
    test_field_begin_confidence();
    fn test_field_kind() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).kind) as usize - ptr as usize
            },
            80usize,
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
            84usize,
            concat!("Offset of field: ", stringify!(stltsa_segment), "::", stringify!(label))
        );
    }
    test_field_label();
    fn test_field_open_begin() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_segment>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).open_begin) as usize - ptr as usize
            },
            88usize,
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
            92usize,
            concat!("Offset of field: ", stringify!(stltsa_segment), "::", stringify!(open_end))
        );
    }
    test_field_open_end();
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_part {
    pub begin: i64,
    pub end: i64,
    pub begin_s: f64,
    pub end_s: f64,
    pub segment: i64,
    pub parent: i64,
    pub likeness: f64,
    pub confidence: f64,
    pub side: i32,
    pub reserved: i32,
}
#[test]
fn bindgen_test_layout_stltsa_part() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_part>(),
        72usize,
        concat!("Size of: ", stringify!(stltsa_part))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_part>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_part))
    );
    fn test_field_begin() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).begin) as usize - ptr as usize
            },
            0usize,
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
            8usize,
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
            16usize,
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
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(end_s))
        );
    }
    test_field_end_s();
    fn test_field_segment() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).segment) as usize - ptr as usize
            },
            32usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(segment))
        );
    }
    test_field_segment();
    fn test_field_parent() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).parent) as usize - ptr as usize
            },
            40usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(parent))
        );
    }
    test_field_parent();
    fn test_field_likeness() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).likeness) as usize - ptr as usize
            },
            48usize,
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
            56usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(confidence))
        );
    }
    test_field_confidence();
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
    fn test_field_reserved() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).reserved) as usize - ptr as usize
            },
            68usize,
            concat!("Offset of field: ", stringify!(stltsa_part), "::", stringify!(reserved))
        );
    }
    test_field_reserved();
}
pub const STLTSA_PART_CYCLE: i32 = 1;
pub const STLTSA_PART_STEP: i32 = 2;
pub const STLTSA_PART_REPETITION: i32 = 3;
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_travel {
    pub way: f64,
    pub stride: f64,
    pub speed: f64,
    pub turn: f64,
}
#[test]
fn bindgen_test_layout_stltsa_travel() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_travel>(),
        32usize,
        concat!("Size of: ", stringify!(stltsa_travel))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_travel>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_travel))
    );
    fn test_field_way() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_travel>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).way) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_travel), "::", stringify!(way))
        );
    }
    test_field_way();
    fn test_field_stride() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_travel>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).stride) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_travel), "::", stringify!(stride))
        );
    }
    test_field_stride();
    fn test_field_speed() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_travel>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).speed) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_travel), "::", stringify!(speed))
        );
    }
    test_field_speed();
    fn test_field_turn() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_travel>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).turn) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_travel), "::", stringify!(turn))
        );
    }
    test_field_turn();
}
pub const STLTSA_QUANTITY_TIME: i32 = 1;
pub const STLTSA_QUANTITY_WAY: i32 = 2;
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
    pub count: i64,
    pub per_minute: f64,
    pub mean_s: f64,
    pub sd_s: f64,
    pub cv: f64,
    pub trend: f64,
    pub label: i32,
    pub reserved: i32,
}
#[test]
fn bindgen_test_layout_stltsa_summary() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_summary>(),
        56usize,
        concat!("Size of: ", stringify!(stltsa_summary))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_summary>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_summary))
    );
    fn test_field_count() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).count) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_summary), "::", stringify!(count))
        );
    }
    test_field_count();
    fn test_field_per_minute() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).per_minute) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_summary), "::", stringify!(per_minute))
        );
    }
    test_field_per_minute();
    fn test_field_mean_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).mean_s) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_summary), "::", stringify!(mean_s))
        );
    }
    test_field_mean_s();
    fn test_field_sd_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).sd_s) as usize - ptr as usize
            },
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_summary), "::", stringify!(sd_s))
        );
    }
    test_field_sd_s();
    fn test_field_cv() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).cv) as usize - ptr as usize
            },
            32usize,
            concat!("Offset of field: ", stringify!(stltsa_summary), "::", stringify!(cv))
        );
    }
    test_field_cv();
    fn test_field_trend() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).trend) as usize - ptr as usize
            },
            40usize,
            concat!("Offset of field: ", stringify!(stltsa_summary), "::", stringify!(trend))
        );
    }
    test_field_trend();
    fn test_field_label() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).label) as usize - ptr as usize
            },
            48usize,
            concat!("Offset of field: ", stringify!(stltsa_summary), "::", stringify!(label))
        );
    }
    test_field_label();
    fn test_field_reserved() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_summary>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).reserved) as usize - ptr as usize
            },
            52usize,
            concat!("Offset of field: ", stringify!(stltsa_summary), "::", stringify!(reserved))
        );
    }
    test_field_reserved();
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
    pub fn stltsa_decomposition_segment_count(decomposition: *const stltsa_decomposition) -> i64;
}
extern "C" {
    pub fn stltsa_decomposition_segment(
        decomposition: *const stltsa_decomposition,
        index: i64,
        segment: *mut stltsa_segment,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_decomposition_segment_reason(
        decomposition: *const stltsa_decomposition,
        index: i64,
    ) -> *const ::std::os::raw::c_char;
}
extern "C" {
    pub fn stltsa_decomposition_label_likeness(
        decomposition: *const stltsa_decomposition,
        label: i32,
        other: i32,
        likeness: *mut f64,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_decomposition_first_step(
        decomposition: *const stltsa_decomposition,
        segment: i64,
        share: *mut f64,
        margin: *mut f64,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_decomposition_steps_reason(
        decomposition: *const stltsa_decomposition,
        segment: i64,
    ) -> *const ::std::os::raw::c_char;
}
extern "C" {
    pub fn stltsa_decomposition_side(decomposition: *const stltsa_decomposition, side: i32) -> i32;
}
extern "C" {
    pub fn stltsa_decomposition_carrier_count(
        decomposition: *const stltsa_decomposition,
        segment: i64,
    ) -> i64;
}
extern "C" {
    pub fn stltsa_decomposition_carrier(
        decomposition: *const stltsa_decomposition,
        segment: i64,
        index: i64,
    ) -> *const ::std::os::raw::c_char;
}
extern "C" {
    pub fn stltsa_decomposition_part_count(
        decomposition: *const stltsa_decomposition,
        kind: i32,
    ) -> i64;
}
extern "C" {
    pub fn stltsa_decomposition_part(
        decomposition: *const stltsa_decomposition,
        kind: i32,
        index: i64,
        part: *mut stltsa_part,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_decomposition_travel(
        decomposition: *const stltsa_decomposition,
        kind: i32,
        index: i64,
        travel: *mut stltsa_travel,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_decomposition_statistics(
        decomposition: *const stltsa_decomposition,
        kind: i32,
        label: i32,
        side: i32,
        quantity: i32,
        statistics: *mut stltsa_statistics,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_decomposition_summary_count(decomposition: *const stltsa_decomposition) -> i64;
}
extern "C" {
    pub fn stltsa_decomposition_summary(
        decomposition: *const stltsa_decomposition,
        index: i64,
        summary: *mut stltsa_summary,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_decomposition_unit_count(decomposition: *const stltsa_decomposition) -> i64;
}
extern "C" {
    pub fn stltsa_decomposition_unit(
        decomposition: *const stltsa_decomposition,
        index: i64,
        unit: *mut stltsa_interval,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_decomposition_cycle_count(decomposition: *const stltsa_decomposition) -> i64;
}
extern "C" {
    pub fn stltsa_decomposition_cycle(
        decomposition: *const stltsa_decomposition,
        index: i64,
        cycle: *mut stltsa_interval,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_decomposition_curve(
        decomposition: *const stltsa_decomposition,
        curve: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_decomposition_coords(
        decomposition: *const stltsa_decomposition,
        coords: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_decomposition_loop(
        decomposition: *const stltsa_decomposition,
        loop_: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_decomposition_reason(
        decomposition: *const stltsa_decomposition,
    ) -> *const ::std::os::raw::c_char;
}
extern "C" {
    pub fn stltsa_decomposition_warning_count(decomposition: *const stltsa_decomposition) -> i64;
}
extern "C" {
    pub fn stltsa_decomposition_warning(
        decomposition: *const stltsa_decomposition,
        index: i64,
    ) -> *const ::std::os::raw::c_char;
}
extern "C" {
    pub fn stltsa_decomposition_json(
        decomposition: *const stltsa_decomposition,
        json: *mut *mut ::std::os::raw::c_char,
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
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_model_load(
        path: *const ::std::os::raw::c_char,
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
    pub fn stltsa_phase_values(
        phase: *const stltsa_phase,
        values: *const stltsa_out,
        residual: *const stltsa_out,
        cycle: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_phase_zero(
        phase: *const stltsa_phase,
        label: i32,
        zero: *mut f64,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_phase_warning_count(phase: *const stltsa_phase) -> i64;
}
extern "C" {
    pub fn stltsa_phase_warning(
        phase: *const stltsa_phase,
        index: i64,
    ) -> *const ::std::os::raw::c_char;
}
extern "C" {
    pub fn stltsa_phase_column_count(phase: *const stltsa_phase) -> i64;
}
extern "C" {
    pub fn stltsa_phase_column_owner(
        phase: *const stltsa_phase,
        index: i64,
    ) -> *const ::std::os::raw::c_char;
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_cycles {
    _unused: [u8; 0],
}
extern "C" {
    pub fn stltsa_cycles_resample(
        phase: *const stltsa_phase,
        label: i32,
        signals: *const stltsa_in,
        samples: i64,
        cycles: *mut *mut stltsa_cycles,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_cycles_between(
        borders: *const stltsa_in,
        signals: *const stltsa_in,
        samples: i64,
        cycles: *mut *mut stltsa_cycles,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_cycles_free(cycles: *mut stltsa_cycles);
}
extern "C" {
    pub fn stltsa_cycles_count(cycles: *const stltsa_cycles) -> i64;
}
extern "C" {
    pub fn stltsa_cycles_mean(
        cycles: *const stltsa_cycles,
        mean: *const stltsa_out,
        deviation: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_cycles_cycle(
        cycles: *const stltsa_cycles,
        index: i64,
        values: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_cycles_times(
        cycles: *const stltsa_cycles,
        frames: *const stltsa_out,
        warp: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_cycles_distance(
        cycles: *const stltsa_cycles,
        total: *const stltsa_out,
        columns: *const stltsa_out,
    ) -> stltsa_status;
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
    pub size: usize,
    pub cycle: i64,
    pub frame: f64,
    pub seconds: f64,
    pub confidence: f64,
    pub marked: i32,
    pub reserved: i32,
}
#[test]
fn bindgen_test_layout_stltsa_event() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_event>(),
        48usize,
        concat!("Size of: ", stringify!(stltsa_event))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_event>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_event))
    );
    fn test_field_size() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_event>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).size) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_event), "::", stringify!(size))
        );
    }
    test_field_size();
    fn test_field_cycle() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_event>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).cycle) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_event), "::", stringify!(cycle))
        );
    }
    test_field_cycle();
    fn test_field_frame() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_event>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).frame) as usize - ptr as usize
            },
            16usize,
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
            24usize,
            concat!("Offset of field: ", stringify!(stltsa_event), "::", stringify!(seconds))
        );
    }
    test_field_seconds();
    fn test_field_confidence() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_event>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).confidence) as usize - ptr as usize
            },
            32usize,
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
            40usize,
            concat!("Offset of field: ", stringify!(stltsa_event), "::", stringify!(marked))
        );
    }
    test_field_marked();
    fn test_field_reserved() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_event>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).reserved) as usize - ptr as usize
            },
            44usize,
            concat!("Offset of field: ", stringify!(stltsa_event), "::", stringify!(reserved))
        );
    }
    test_field_reserved();
}
extern "C" {
    pub fn stltsa_events_find(
        from: *const stltsa_phase,
        marks: *const stltsa_in,
        in_: *const stltsa_phase,
        events: *mut *mut stltsa_events,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_events_find_with(
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
    pub fn stltsa_events_count(events: *const stltsa_events) -> i64;
}
extern "C" {
    pub fn stltsa_events_event(
        events: *const stltsa_events,
        index: i64,
        event: *mut stltsa_event,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_events_likeness(events: *const stltsa_events) -> f64;
}
extern "C" {
    pub fn stltsa_events_warning_count(events: *const stltsa_events) -> i64;
}
extern "C" {
    pub fn stltsa_events_warning(
        events: *const stltsa_events,
        index: i64,
    ) -> *const ::std::os::raw::c_char;
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
    pub significant: i32,
    pub reserved: i32,
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
    fn test_field_reserved() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_estimate>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).reserved) as usize - ptr as usize
            },
            68usize,
            concat!("Offset of field: ", stringify!(stltsa_estimate), "::", stringify!(reserved))
        );
    }
    test_field_reserved();
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_compared_cycles {
    pub size: usize,
    pub first_count: i64,
    pub second_count: i64,
    pub first_label: i32,
    pub second_label: i32,
    pub samples: i64,
    pub cycle_time: stltsa_estimate,
    pub first_per_minute: f64,
    pub second_per_minute: f64,
    pub shift: f64,
    pub shift_error: f64,
    pub shift_low: f64,
    pub shift_high: f64,
    pub likeness: f64,
    pub runner_up: f64,
    pub turn: f64,
    pub size_ratio: f64,
    pub judged: i64,
    pub significant: i64,
    pub sides: i32,
    pub reserved: i32,
}
#[test]
fn bindgen_test_layout_stltsa_compared_cycles() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_compared_cycles>(),
        216usize,
        concat!("Size of: ", stringify!(stltsa_compared_cycles))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_compared_cycles>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_compared_cycles))
    );
    fn test_field_size() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).size) as usize - ptr as usize
            },
            0usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(size)
            )
        );
    }
    test_field_size();
    fn test_field_first_count() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).first_count) as usize - ptr as usize
            },
            8usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(first_count)
            )
        );
    }
    test_field_first_count();
    fn test_field_second_count() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).second_count) as usize - ptr as usize
            },
            16usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(second_count)
            )
        );
    }
    test_field_second_count();
    fn test_field_first_label() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).first_label) as usize - ptr as usize
            },
            24usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(first_label)
            )
        );
    }
    test_field_first_label();
    fn test_field_second_label() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).second_label) as usize - ptr as usize
            },
            28usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(second_label)
            )
        );
    }
    test_field_second_label();
    fn test_field_samples() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).samples) as usize - ptr as usize
            },
            32usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(samples)
            )
        );
    }
    test_field_samples();
    fn test_field_cycle_time() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).cycle_time) as usize - ptr as usize
            },
            40usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(cycle_time)
            )
        );
    }
    test_field_cycle_time();
    fn test_field_first_per_minute() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).first_per_minute) as usize - ptr as usize
            },
            112usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(first_per_minute)
            )
        );
    }
    test_field_first_per_minute();
    fn test_field_second_per_minute() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).second_per_minute) as usize - ptr as usize
            },
            120usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(second_per_minute)
            )
        );
    }
    test_field_second_per_minute();
    fn test_field_shift() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).shift) as usize - ptr as usize
            },
            128usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(shift)
            )
        );
    }
    test_field_shift();
    fn test_field_shift_error() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).shift_error) as usize - ptr as usize
            },
            136usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(shift_error)
            )
        );
    }
    test_field_shift_error();
    fn test_field_shift_low() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).shift_low) as usize - ptr as usize
            },
            144usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(shift_low)
            )
        );
    }
    test_field_shift_low();
    fn test_field_shift_high() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).shift_high) as usize - ptr as usize
            },
            152usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(shift_high)
            )
        );
    }
    test_field_shift_high();
    fn test_field_likeness() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).likeness) as usize - ptr as usize
            },
            160usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(likeness)
            )
        );
    }
    test_field_likeness();
    fn test_field_runner_up() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).runner_up) as usize - ptr as usize
            },
            168usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(runner_up)
            )
        );
    }
    test_field_runner_up();
    fn test_field_turn() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).turn) as usize - ptr as usize
            },
            176usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(turn)
            )
        );
    }
    test_field_turn();
    fn test_field_size_ratio() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).size_ratio) as usize - ptr as usize
            },
            184usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(size_ratio)
            )
        );
    }
    test_field_size_ratio();
    fn test_field_judged() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).judged) as usize - ptr as usize
            },
            192usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(judged)
            )
        );
    }
    test_field_judged();
    fn test_field_significant() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).significant) as usize - ptr as usize
            },
            200usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(significant)
            )
        );
    }
    test_field_significant();
    fn test_field_sides() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).sides) as usize - ptr as usize
            },
            208usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(sides)
            )
        );
    }
    test_field_sides();
    fn test_field_reserved() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_cycles>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).reserved) as usize - ptr as usize
            },
            212usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_cycles),
                "::",
                stringify!(reserved)
            )
        );
    }
    test_field_reserved();
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct stltsa_compared_part {
    pub size: usize,
    pub part: i64,
    pub rms: f64,
    pub chance: f64,
    pub correlation: f64,
    pub lag: stltsa_estimate,
    pub amplitude: stltsa_estimate,
    pub ratio: f64,
    pub ratio_low: f64,
    pub ratio_high: f64,
    pub lag_s: f64,
    pub lag_low_s: f64,
    pub lag_high_s: f64,
    pub mean: stltsa_estimate,
}
#[test]
fn bindgen_test_layout_stltsa_compared_part() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_compared_part>(),
        304usize,
        concat!("Size of: ", stringify!(stltsa_compared_part))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_compared_part>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_compared_part))
    );
    fn test_field_size() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).size) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_compared_part), "::", stringify!(size))
        );
    }
    test_field_size();
    fn test_field_part() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).part) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_compared_part), "::", stringify!(part))
        );
    }
    test_field_part();
    fn test_field_rms() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).rms) as usize - ptr as usize
            },
            16usize,
            concat!("Offset of field: ", stringify!(stltsa_compared_part), "::", stringify!(rms))
        );
    }
    test_field_rms();
    fn test_field_chance() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).chance) as usize - ptr as usize
            },
            24usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_part),
                "::",
                stringify!(chance)
            )
        );
    }
    test_field_chance();
    fn test_field_correlation() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).correlation) as usize - ptr as usize
            },
            32usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_part),
                "::",
                stringify!(correlation)
            )
        );
    }
    test_field_correlation();
    fn test_field_lag() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).lag) as usize - ptr as usize
            },
            40usize,
            concat!("Offset of field: ", stringify!(stltsa_compared_part), "::", stringify!(lag))
        );
    }
    test_field_lag();
    fn test_field_amplitude() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).amplitude) as usize - ptr as usize
            },
            112usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_part),
                "::",
                stringify!(amplitude)
            )
        );
    }
    test_field_amplitude();
    fn test_field_ratio() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).ratio) as usize - ptr as usize
            },
            184usize,
            concat!("Offset of field: ", stringify!(stltsa_compared_part), "::", stringify!(ratio))
        );
    }
    test_field_ratio();
    fn test_field_ratio_low() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).ratio_low) as usize - ptr as usize
            },
            192usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_part),
                "::",
                stringify!(ratio_low)
            )
        );
    }
    test_field_ratio_low();
    fn test_field_ratio_high() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).ratio_high) as usize - ptr as usize
            },
            200usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_part),
                "::",
                stringify!(ratio_high)
            )
        );
    }
    test_field_ratio_high();
    fn test_field_lag_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).lag_s) as usize - ptr as usize
            },
            208usize,
            concat!("Offset of field: ", stringify!(stltsa_compared_part), "::", stringify!(lag_s))
        );
    }
    test_field_lag_s();
    fn test_field_lag_low_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).lag_low_s) as usize - ptr as usize
            },
            216usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_part),
                "::",
                stringify!(lag_low_s)
            )
        );
    }
    test_field_lag_low_s();
    fn test_field_lag_high_s() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).lag_high_s) as usize - ptr as usize
            },
            224usize,
            concat!(
                "Offset of field: ",
                stringify!(stltsa_compared_part),
                "::",
                stringify!(lag_high_s)
            )
        );
    }
    test_field_lag_high_s();
    fn test_field_mean() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_compared_part>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).mean) as usize - ptr as usize
            },
            232usize,
            concat!("Offset of field: ", stringify!(stltsa_compared_part), "::", stringify!(mean))
        );
    }
    test_field_mean();
}
extern "C" {
    pub fn stltsa_compare(
        first: *const stltsa_phase,
        first_label: i32,
        second: *const stltsa_phase,
        second_label: i32,
        samples: i64,
        comparison: *mut *mut stltsa_comparison,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_compare_with(
        first: *const stltsa_phase,
        first_label: i32,
        second: *const stltsa_phase,
        second_label: i32,
        samples: i64,
        options: *const stltsa_options,
        comparison: *mut *mut stltsa_comparison,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_compare_left_right(
        clip: *const stltsa_clip,
        phase: *const stltsa_phase,
        label: i32,
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
    pub fn stltsa_comparison_cycles(
        comparison: *const stltsa_comparison,
        cycles: *mut stltsa_compared_cycles,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_comparison_part_count(comparison: *const stltsa_comparison) -> i64;
}
extern "C" {
    pub fn stltsa_comparison_part(
        comparison: *const stltsa_comparison,
        index: i64,
        part: *mut stltsa_compared_part,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_comparison_part_name(
        comparison: *const stltsa_comparison,
        which: i32,
        index: i64,
    ) -> *const ::std::os::raw::c_char;
}
extern "C" {
    pub fn stltsa_comparison_channel_count(comparison: *const stltsa_comparison) -> i64;
}
extern "C" {
    pub fn stltsa_comparison_channel(
        comparison: *const stltsa_comparison,
        index: i64,
        channel: *mut stltsa_compared_part,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_comparison_channel_axis(
        comparison: *const stltsa_comparison,
        index: i64,
    ) -> *const ::std::os::raw::c_char;
}
extern "C" {
    pub fn stltsa_comparison_curves(
        comparison: *const stltsa_comparison,
        which: i32,
        mean: *const stltsa_out,
        deviation: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_comparison_difference(
        comparison: *const stltsa_comparison,
        difference: *const stltsa_out,
        standard_error: *const stltsa_out,
        margin: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_comparison_left_out_count(
        comparison: *const stltsa_comparison,
        which: i32,
    ) -> i64;
}
extern "C" {
    pub fn stltsa_comparison_left_out(
        comparison: *const stltsa_comparison,
        which: i32,
        index: i64,
    ) -> *const ::std::os::raw::c_char;
}
extern "C" {
    pub fn stltsa_comparison_warning_count(comparison: *const stltsa_comparison) -> i64;
}
extern "C" {
    pub fn stltsa_comparison_warning(
        comparison: *const stltsa_comparison,
        index: i64,
    ) -> *const ::std::os::raw::c_char;
}
extern "C" {
    pub fn stltsa_comparison_json(
        comparison: *const stltsa_comparison,
        json: *mut *mut ::std::os::raw::c_char,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_model_keep_cycle(
        model: *mut stltsa_model,
        phase: *const stltsa_phase,
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
extern "C" {
    pub fn stltsa_model_has_cycle(model: *const stltsa_model) -> i32;
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
    pub fn stltsa_live_mark_count(live: *const stltsa_live) -> i64;
}
extern "C" {
    pub fn stltsa_live_mark_name(
        live: *const stltsa_live,
        index: i64,
    ) -> *const ::std::os::raw::c_char;
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
extern "C" {
    pub fn stltsa_denoising_curve(
        denoising: *const stltsa_denoising,
        curve: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_denoising_cleaned(
        denoising: *const stltsa_denoising,
        cleaned: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_denoising_moves(
        denoising: *const stltsa_denoising,
        moves: *const stltsa_out,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_denoising_json(
        denoising: *const stltsa_denoising,
        json: *mut *mut ::std::os::raw::c_char,
    ) -> stltsa_status;
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
#[test]
fn bindgen_test_layout_stltsa_seam() {
    assert_eq!(
        ::std::mem::size_of::<stltsa_seam>(),
        80usize,
        concat!("Size of: ", stringify!(stltsa_seam))
    );
    assert_eq!(
        ::std::mem::align_of::<stltsa_seam>(),
        8usize,
        concat!("Alignment of ", stringify!(stltsa_seam))
    );
    fn test_field_size() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_seam>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).size) as usize - ptr as usize
            },
            0usize,
            concat!("Offset of field: ", stringify!(stltsa_seam), "::", stringify!(size))
        );
    }
    test_field_size();
    fn test_field_frame() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_seam>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).frame) as usize - ptr as usize
            },
            8usize,
            concat!("Offset of field: ", stringify!(stltsa_seam), "::", stringify!(frame))
        );
    }
    test_field_frame();
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
    fn test_field_posture() {
        assert_eq!(
            unsafe {
                let uninit = ::std::mem::MaybeUninit::<stltsa_seam>::uninit();
                let ptr = uninit.as_ptr();
                ::std::ptr::addr_of!((*ptr).posture) as usize - ptr as usize
            },
            56usize,
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
            64usize,
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
            72usize,
            concat!("Offset of field: ", stringify!(stltsa_seam), "::", stringify!(acceleration))
        );
    }
    test_field_acceleration();
}
extern "C" {
    pub fn stltsa_synthesis_seam_count(synthesis: *const stltsa_synthesis) -> i64;
}
extern "C" {
    pub fn stltsa_synthesis_seam(
        synthesis: *const stltsa_synthesis,
        index: i64,
        seam: *mut stltsa_seam,
    ) -> stltsa_status;
}
extern "C" {
    pub fn stltsa_synthesis_warning_count(synthesis: *const stltsa_synthesis) -> i64;
}
extern "C" {
    pub fn stltsa_synthesis_warning(
        synthesis: *const stltsa_synthesis,
        index: i64,
    ) -> *const ::std::os::raw::c_char;
}
extern "C" {
    pub fn stltsa_synthesis_json(
        synthesis: *const stltsa_synthesis,
        json: *mut *mut ::std::os::raw::c_char,
    ) -> stltsa_status;
}
