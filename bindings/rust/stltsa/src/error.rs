// SPDX-License-Identifier: BSD-3-Clause
//! Errors.

use std::ffi::{CStr, CString};
use std::fmt;
use std::path::Path;

use stltsa_sys as sys;

pub use crate::kinds::ErrorKind;

/// `Result` with this crate's [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// A failure: its kind, and the library's text: what is wrong, where, and what to do.
#[derive(Clone, PartialEq, Eq)]
pub struct Error {
    kind: ErrorKind,
    message: String,
}

impl Error {
    pub(crate) fn new(kind: ErrorKind, message: impl Into<String>) -> Self {
        Self { kind, message: message.into() }
    }

    /// Kind of failure, for programs.
    pub fn kind(&self) -> ErrorKind {
        self.kind
    }

    /// Text for people: what is wrong, where, and what to do.
    pub fn message(&self) -> &str {
        &self.message
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

/// The text, as `main` and `unwrap` print it; `{:#?}` shows the kind, too.
impl fmt::Debug for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !f.alternate() {
            return f.write_str(&self.message);
        }
        f.debug_struct("Error").field("kind", &self.kind).field("message", &self.message).finish()
    }
}

impl std::error::Error for Error {}

/// `Err` with the text of this thread's last failure, unless `status` means success.
pub(crate) fn check(status: sys::stltsa_status) -> Result<()> {
    if status == sys::STLTSA_OK {
        return Ok(());
    }
    // SAFETY: never NULL, and valid until the next failure on this thread; copied at once.
    let message = unsafe { text(sys::stltsa_last_error()) };
    Err(Error::new(ErrorKind::from(i64::from(status)), message))
}

/// A copy of a text of the library; bytes that are not UTF-8 (names from files) are replaced. NULL,
/// as of a member that an older library does not know, is "".
///
/// # Safety
/// `raw` is NULL, or a string that ends with a zero byte.
pub(crate) unsafe fn text(raw: *const std::os::raw::c_char) -> String {
    if raw.is_null() {
        return String::new();
    }
    // SAFETY: as the caller promises.
    unsafe { CStr::from_ptr(raw) }.to_string_lossy().into_owned()
}

/// A name for C, which ends at the first NUL.
pub(crate) fn c_name(name: &str) -> Result<CString> {
    CString::new(name)
        .map_err(|_| Error::new(ErrorKind::Argument, format!("the name {name:?} contains NUL")))
}

/// The same of a text that may be left out.
pub(crate) fn c_optional(text: Option<&str>) -> Result<Option<CString>> {
    text.map(c_name).transpose()
}

/// NULL for none.
pub(crate) fn pointer(text: &Option<CString>) -> *const std::os::raw::c_char {
    text.as_ref().map_or(std::ptr::null(), |text| text.as_ptr())
}

/// The path for C.
pub(crate) fn c_path(path: &Path) -> Result<CString> {
    #[cfg(unix)]
    let bytes = Some(std::os::unix::ffi::OsStrExt::as_bytes(path.as_os_str()));
    #[cfg(not(unix))]
    let bytes = path.to_str().map(str::as_bytes);
    bytes.and_then(|bytes| CString::new(bytes).ok()).ok_or_else(|| {
        Error::new(ErrorKind::Argument, format!("{} is not a path that C can take", path.display()))
    })
}

/// A count returned by the library.
pub(crate) fn count(value: i64) -> usize {
    usize::try_from(value).expect("the library counts from 0")
}

/// A count for C.
pub(crate) fn c_count(value: usize) -> Result<i64> {
    i64::try_from(value)
        .map_err(|_| Error::new(ErrorKind::Shape, format!("{value} is too large a count")))
}

/// A value written by a call.
pub(crate) fn got<T>(mut value: T, get: impl FnOnce(&mut T) -> sys::stltsa_status) -> Result<T> {
    check(get(&mut value))?;
    Ok(value)
}
