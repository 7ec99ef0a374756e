// SPDX-License-Identifier: BSD-3-Clause
//! [`Batch`]: many clips, decomposed into files of a folder.

use std::os::raw::c_char;
use std::path::{Path, PathBuf};
use std::ptr::{null, null_mut};

use stltsa_sys as sys;

use crate::error::{c_count, c_name, c_path, check, text, Error, Result};
use crate::handle::Owned;
use crate::options::Options;

/// Which clips are decomposed into which files of a folder.
///
/// ```no_run
/// use stltsa::{Batch, Options};
///
/// let batch = Batch::new(&["recordings"], "results", None, &Options::new())?;
/// let rows = (0..batch.paths().len())
///     .map(|clip| batch.run(clip, &Options::new()))
///     .collect::<Result<Vec<_>, _>>()?;
/// println!("{}", batch.finish(&rows)?.display());
/// # Ok::<(), stltsa::Error>(())
/// ```
#[derive(Debug)]
pub struct Batch {
    handle: Owned<sys::stltsa_batch>,
}

/// What became of a clip of a batch.
#[derive(Clone, Debug)]
pub struct BatchRow {
    text: Vec<u8>,
    /// Whether the result is of an earlier run.
    pub kept: bool,
    /// Why the clip failed.
    pub error: Option<Error>,
}

impl Batch {
    /// Finds the clips among files and in folders, and creates the folder of the results. `shard`:
    /// "2/8" is every 8th clip from the 2nd on. Options used: those of
    /// [`Clip::open_with`](crate::Clip::open_with) and [`Clip::decompose`](crate::Clip::decompose)
    /// but threads and progress; fps is only for clips that cannot be read without it, or have no
    /// rate.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) (no clip, two with one result, a wrong option or
    /// shard), [`Io`](crate::ErrorKind::Io) (nothing can be written into the folder).
    pub fn new(
        paths: &[impl AsRef<Path>],
        folder: impl AsRef<Path>,
        shard: Option<&str>,
        options: &Options,
    ) -> Result<Self> {
        let paths = paths.iter().map(|path| c_path(path.as_ref())).collect::<Result<Vec<_>>>()?;
        let raw: Vec<*const c_char> = paths.iter().map(|path| path.as_ptr()).collect();
        let (folder, shard) = (c_path(folder.as_ref())?, shard.map(c_name).transpose()?);
        let part = shard.as_ref().map_or(null(), |part| part.as_ptr());
        let count = c_count(raw.len())?;
        let handle = options.call(|options| {
            // SAFETY: as many strings, which live through the call, as do the others.
            Owned::make(|out| unsafe {
                sys::stltsa_batch_new(raw.as_ptr(), count, folder.as_ptr(), part, options, out)
            })
        })?;
        Ok(Self { handle })
    }

    /// The paths of the clips.
    pub fn paths(&self) -> Vec<PathBuf> {
        // SAFETY: a live handle, to which the texts belong until they are copied.
        let path = |index| unsafe {
            let raw = sys::stltsa_batch_path(self.handle.raw(), index);
            (!raw.is_null()).then(|| PathBuf::from(text(raw)))
        };
        (0..).map_while(path).collect()
    }

    /// Decomposes one clip, or keeps its result of an earlier run. Options used: progress.
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) (no such clip),
    /// [`Cancelled`](crate::ErrorKind::Cancelled), [`NoMemory`](crate::ErrorKind::NoMemory). The
    /// error of the clip itself is in the row.
    pub fn run(&self, clip: usize, options: &Options) -> Result<BatchRow> {
        let index = c_count(clip)?;
        let (mut kept, mut raw) = (0, null_mut());
        options.call(|options| {
            // SAFETY: live handles; no clip is given.
            let done = check(unsafe {
                sys::stltsa_batch_run(
                    self.handle.raw(),
                    index,
                    null(),
                    options,
                    &mut kept,
                    &mut raw,
                )
            });
            if raw.is_null() {
                done?;
                unreachable!("a call that succeeds gives a row");
            }
            // SAFETY: a string that this side has to free.
            let text = unsafe {
                let copy = std::ffi::CStr::from_ptr(raw).to_bytes().to_vec();
                sys::stltsa_free(raw.cast());
                copy
            };
            Ok(BatchRow { text, kept: kept != 0, error: done.err() })
        })
    }

    /// Writes the table of the rows; returns its path.
    ///
    /// # Errors
    /// [`Io`](crate::ErrorKind::Io).
    pub fn finish(&self, rows: &[BatchRow]) -> Result<PathBuf> {
        let texts: Vec<Vec<u8>> = rows.iter().map(|row| [&row.text[..], b"\0"].concat()).collect();
        let raw: Vec<*const c_char> = texts.iter().map(|text| text.as_ptr().cast()).collect();
        let count = c_count(raw.len())?;
        let mut place = null();
        // SAFETY: a live handle and as many strings; the path belongs to the handle.
        unsafe {
            check(sys::stltsa_batch_finish(self.handle.raw(), raw.as_ptr(), count, &mut place))?;
            Ok(PathBuf::from(text(place)))
        }
    }
}
