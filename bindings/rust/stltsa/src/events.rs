// SPDX-License-Identifier: BSD-3-Clause
//! [`Events`]: a moment that is marked once, found in every cycle.

use stltsa_sys as sys;

use crate::array::View;
use crate::error::{check, count, texts, Result};
use crate::handle::Owned;
use crate::options::Options;
use crate::phase::Phase;

/// A moment that was found, or a mark of the caller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Event {
    /// Index of its cycle; `None` outside cycles.
    pub cycle: Option<usize>,
    /// Frame of the clip, not rounded.
    pub frame: f64,
    /// Time of the frame.
    pub seconds: f64,
    /// 0 to 1: ranks the events by the size of their likely errors.
    pub confidence: f64,
    /// A mark of the caller, as it was given.
    pub marked: bool,
}

/// The events at one or several marks, in order of time.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Events {
    /// In order of time.
    pub events: Vec<Event>,
    /// Correlation of the mean cycles of both clips; 1 within a clip. Below 0.95 trust events of
    /// another person less; below 0.6 it is another motion, and there are none.
    pub likeness: f64,
    /// About marks at several places in the cycle, repetitions without the event, and phases that
    /// are linear in time.
    pub warnings: Vec<String>,
}

impl Phase {
    /// Finds the event at the marked frames, which need not be whole, in every cycle or repetition
    /// of `other`, another clip with the same features, or of this clip.
    ///
    /// ```no_run
    /// use stltsa::{Clip, Options, Phase};
    ///
    /// let walk = Clip::open("walk.bvh")?;
    /// let options = Options::new();
    /// let phase = Phase::find(&walk.decompose(&options)?, &options)?;
    /// for strike in phase.events(&[131.5], None)?.events {
    ///     println!("{:.3} s, confidence {:.2}", strike.seconds, strike.confidence);
    /// }
    /// # Ok::<(), stltsa::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Argument`](crate::ErrorKind::Argument) if a mark lies in no motion that repeats,
    /// [`Shape`](crate::ErrorKind::Shape) if the features of the clips differ.
    pub fn events(&self, marks: &[f64], other: Option<&Phase>) -> Result<Events> {
        self.events_with(marks, other, &Options::new())
    }

    /// The same with options. Used: progress.
    ///
    /// # Errors
    /// As [`events`](Self::events), and [`Cancelled`](crate::ErrorKind::Cancelled).
    pub fn events_with(
        &self,
        marks: &[f64],
        other: Option<&Phase>,
        options: &Options,
    ) -> Result<Events> {
        let marks = View::new(marks, marks.len(), 1)?.raw()?;
        let other = other.map_or(std::ptr::null(), Phase::raw);
        let found: Owned<sys::stltsa_events> = options.call(|options| {
            // SAFETY: live handles, an array of the size it says.
            Owned::make(|out| unsafe {
                sys::stltsa_events_find_with(self.raw(), &marks, other, options, out)
            })
        })?;
        // SAFETY: a live handle.
        let events = unsafe { sys::stltsa_events_count(found.raw()) };
        Ok(Events {
            events: (0..events).map(|index| event(&found, index)).collect::<Result<_>>()?,
            // SAFETY: a live handle.
            likeness: unsafe { sys::stltsa_events_likeness(found.raw()) },
            warnings: warnings(&found),
        })
    }
}

fn warnings(found: &Owned<sys::stltsa_events>) -> Vec<String> {
    // SAFETY: a live handle.
    unsafe {
        texts(sys::stltsa_events_warning_count(found.raw()), |index| {
            sys::stltsa_events_warning(found.raw(), index)
        })
    }
}

fn event(found: &Owned<sys::stltsa_events>, index: i64) -> Result<Event> {
    // SAFETY: a struct of numbers, for which zeros are valid.
    let mut raw: sys::stltsa_event = unsafe { std::mem::zeroed() };
    raw.size = std::mem::size_of::<sys::stltsa_event>();
    // SAFETY: a live handle, a struct of the size it says.
    check(unsafe { sys::stltsa_events_event(found.raw(), index, &mut raw) })?;
    Ok(Event {
        cycle: if raw.cycle < 0 { None } else { Some(count(raw.cycle)?) },
        frame: raw.frame,
        seconds: raw.seconds,
        confidence: raw.confidence,
        marked: raw.marked == 1,
    })
}
