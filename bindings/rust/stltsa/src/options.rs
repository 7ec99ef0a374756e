// SPDX-License-Identifier: BSD-3-Clause
//! [`Options`]: deviations from a call's defaults.

use std::collections::BTreeMap;
use std::fmt;
use std::mem::size_of;
use std::ops::{ControlFlow, RangeInclusive};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use stltsa_sys as sys;

use crate::error::{c_path, check, text, Result};
use crate::handle::{Handle, Owned};
use crate::kinds::{Axis, Features, Gaps, Mode, OptionKey, Stage};
use crate::progress::{watched, Callback};

mod generated; // a method for each option

#[derive(Clone, Debug, PartialEq)]
enum Value {
    Int(i64),
    Real(f64),
    Text(PathBuf), // bytes, as a path may have any
}

/// Options of a call; unset options have the library's defaults, which suit most clips.
///
/// The call checks the values: a value out of range is
/// [`ErrorKind::Argument`](crate::ErrorKind::Argument), with the range in the text. A call ignores
/// options that it does not use. [`options_table`] lists all with ranges and defaults.
///
/// ```
/// use stltsa::{Mode, Options};
///
/// let options = Options::new().dimension(3).neighbors(40).mode(Mode::Temporal);
/// # let _ = options;
/// ```
#[derive(Clone, Default)]
pub struct Options {
    values: BTreeMap<i32, Value>,
    progress: Option<Callback>,
}

impl Options {
    /// The defaults.
    pub fn new() -> Self {
        Self::default()
    }

    /// Calls `report` during the work, with the stage and the finished fraction of it, from 0 to 1;
    /// `Break` cancels, and the call returns [`ErrorKind::Cancelled`](crate::ErrorKind::Cancelled).
    ///
    /// It runs on the thread of the call. A panic in it also cancels, and continues from the call.
    /// Clones of these options share it; while it runs, reports of other calls are dropped.
    ///
    /// ```
    /// use std::ops::ControlFlow;
    /// use stltsa::{ErrorKind, Model, Options};
    ///
    /// let frames: Vec<[f64; 3]> =
    ///     (0..300).map(|t| t as f64 / 16.0).map(|a| [a.cos(), a.sin(), (2.0 * a).sin()]).collect();
    /// let mut reports = 0;
    /// let options = Options::new().neighbors(120).progress(move |_stage, _fraction| {
    ///     reports += 1;
    ///     if reports < 3 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    /// });
    /// let error = Model::fit(&frames, &options).unwrap_err();
    /// assert_eq!(error.kind(), ErrorKind::Cancelled);
    /// ```
    #[must_use]
    pub fn progress(
        mut self,
        report: impl FnMut(Stage, f64) -> ControlFlow<()> + Send + 'static,
    ) -> Self {
        self.progress = Some(Arc::new(Mutex::new(report)));
        self
    }

    /// Back to the default or, for an option without one, to what the library chooses.
    ///
    /// ```
    /// use stltsa::{OptionKey, Options};
    ///
    /// let mine = Options::new().neighbors(40).dimension(3);
    /// let options = mine.clone().unset(OptionKey::Neighbors);
    /// assert!(mine.is_set(OptionKey::Neighbors) && !options.is_set(OptionKey::Neighbors));
    /// ```
    #[must_use]
    pub fn unset(mut self, key: OptionKey) -> Self {
        self.values.remove(&key.raw());
        self
    }

    /// Whether the option was set.
    pub fn is_set(&self, key: OptionKey) -> bool {
        self.values.contains_key(&key.raw())
    }

    fn with(mut self, key: i32, value: Value) -> Self {
        self.values.insert(key, value);
        self
    }

    /// The handle that a call with these options makes.
    pub(crate) fn make<T: Handle>(
        &self,
        make: impl FnOnce(*const sys::stltsa_options, *mut *mut T) -> sys::stltsa_status,
    ) -> Result<Owned<T>> {
        self.call(|options| Owned::make(|out| make(options, out)))
    }

    /// Runs `body`, one call of the library, with these options in C's form.
    pub(crate) fn call<T>(
        &self,
        body: impl FnOnce(*const sys::stltsa_options) -> Result<T>,
    ) -> Result<T> {
        let mut raw = self.raw()?;
        match &self.progress {
            Some(callback) => watched(&mut raw, callback, body),
            None => body(raw.raw()),
        }
    }

    fn raw(&self) -> Result<Owned<sys::stltsa_options>> {
        // SAFETY: handles and strings live through each call.
        unsafe {
            let mut options = Owned::make(|out| sys::stltsa_options_new(out))?;
            let raw = options.raw_mut();
            for (&key, value) in &self.values {
                check(match value {
                    Value::Int(value) => sys::stltsa_options_set_int(raw, key, *value),
                    Value::Real(value) => sys::stltsa_options_set_real(raw, key, *value),
                    Value::Text(path) => {
                        let path = c_path(path)?;
                        sys::stltsa_options_set_text(raw, key, path.as_ptr())
                    }
                })?;
            }
            Ok(options)
        }
    }
}

impl fmt::Debug for Options {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = |key: &i32| {
            let row = options_table().into_iter().find(|row| row.key == *key);
            row.map_or_else(|| key.to_string(), |row| row.name)
        };
        let mut map = f.debug_map();
        map.entries(self.values.iter().map(|(key, value)| (name(key), value)));
        map.entries(self.progress.iter().map(|_| ("progress", "..."))).finish()
    }
}

/// Values too large for C are out of range, too.
fn int(value: usize) -> Value {
    Value::Int(i64::try_from(value).unwrap_or(i64::MAX))
}

/// One row of the library's table of options.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct OptionInfo {
    key: i32,
    /// Name as in the command `stltsa`, `--name`; the method of [`Options`] has `_` for `-`.
    pub name: String,
    /// One sentence.
    pub text: String,
    /// Named values, for example `temporal=1 spatial=2`.
    pub choices: Option<String>,
    /// Smallest and largest number; `None` for texts.
    pub range: Option<RangeInclusive<f64>>,
    /// The default of a number; `None` if the library chooses, by the rule that the text gives
    /// after "auto".
    pub standard: Option<f64>,
}

/// Every option of the library at run time, in the order of its keys.
///
/// ```
/// let table = stltsa::options_table();
/// let links = table.iter().find(|row| row.name == "links").unwrap();
/// assert_eq!(links.standard, Some(4.0));
/// ```
pub fn options_table() -> Vec<OptionInfo> {
    (0..).map_while(describe).collect()
}

fn describe(index: i64) -> Option<OptionInfo> {
    let none = std::ptr::null();
    let mut row = sys::stltsa_option_info {
        size: size_of::<sys::stltsa_option_info>(),
        key: 0,
        type_: 0,
        name: none,
        text: none,
        choices: none,
        minimum: 0.0,
        maximum: 0.0,
        standard: 0.0,
        automatic: 0,
        calls: 0,
    };
    // SAFETY: the struct says its size, and the texts that come back are static.
    unsafe {
        check(sys::stltsa_option_describe(index, &mut row)).ok()?;
        Some(OptionInfo {
            key: row.key,
            name: text(row.name),
            text: text(row.text),
            choices: if row.choices.is_null() { None } else { Some(text(row.choices)) },
            range: (row.type_ != sys::STLTSA_TYPE_TEXT).then_some(row.minimum..=row.maximum),
            standard: (row.automatic == 0).then_some(row.standard),
        })
    }
}
