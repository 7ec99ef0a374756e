// SPDX-License-Identifier: BSD-3-Clause
//! [`Events`]: a moment that is marked once, found in every cycle.

use stltsa_sys as sys;

use crate::array::View;
use crate::error::Result;
use crate::handle::Owned;
use crate::kinds::Fact;
use crate::options::Options;
use crate::phase::Phase;
use crate::rows::Event;

/// The events at one or several marks.
#[derive(Debug)]
pub struct Events {
    pub(crate) handle: Owned<sys::stltsa_events>,
}

impl Events {
    /// In order of time.
    pub fn all(&self) -> Vec<Event> {
        self.info().list(Fact::Event)
    }

    /// Correlation of the mean cycles of both clips; 1 within a clip. Below 0.95 trust events of
    /// another person less; below 0.6 it is another motion, and there are none.
    pub fn likeness(&self) -> f64 {
        self.info().real(Fact::Likeness).unwrap_or(f64::NAN)
    }
}

impl Phase {
    /// Finds the event at the marked frames, which need not be whole, in every cycle or repetition
    /// of `other`, another clip with the same features, or of this clip. Option used: progress.
    ///
    /// ```no_run
    /// use stltsa::{Clip, Options, Phase};
    ///
    /// let walk = Clip::open("walk.bvh")?;
    /// let options = Options::new();
    /// let phase = Phase::find(&walk.decompose(&options)?, &options)?;
    /// for strike in phase.events(&[131.5], None, &options)?.all() {
    ///     println!("{:.3} s, confidence {:.2}", strike.seconds, strike.confidence);
    /// }
    /// # Ok::<(), stltsa::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) if a mark lies in no motion that repeats,
    /// [`Shape`](crate::ErrorKind::Shape) if the features of the clips differ,
    /// [`Cancelled`](crate::ErrorKind::Cancelled).
    pub fn events(
        &self,
        marks: &[f64],
        other: Option<&Phase>,
        options: &Options,
    ) -> Result<Events> {
        let marks = View::new(marks, marks.len(), 1)?.raw()?;
        let other = other.map_or(std::ptr::null(), Phase::raw);
        let handle = options.make(|options, out| {
            // SAFETY: live handles, an array of the size it says.
            unsafe { sys::stltsa_events_find(self.raw(), &marks, other, options, out) }
        })?;
        Ok(Events { handle })
    }
}
