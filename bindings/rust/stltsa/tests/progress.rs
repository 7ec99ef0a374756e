// SPDX-License-Identifier: BSD-3-Clause
//! The progress closure receives reports, can cancel a call, and may panic.

mod common;

use std::ops::ControlFlow::{Break, Continue};
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::sync::{Arc, Mutex};

use common::{circle, circle_options, same_bits};
use stltsa::{ErrorKind, Model, Options, Phase, Stage};

type Reports = Arc<Mutex<Vec<(Stage, f64)>>>;

fn recording(reports: &Reports) -> Options {
    let reports = Arc::clone(reports);
    circle_options().progress(move |stage, fraction| {
        reports.lock().unwrap().push((stage, fraction));
        Continue(())
    })
}

#[test]
fn it_is_told_of_each_stage_from_0_to_1_on_the_callers_thread() {
    let reports = Reports::default();
    let here = std::thread::current().id();
    Model::fit(&circle(), &recording(&reports)).unwrap();
    let told = reports.lock().unwrap().clone();
    assert!(told.iter().any(|(stage, _)| *stage == Stage::Spectrum), "{told:?}");
    assert!(told.iter().all(|(_, fraction)| (0.0..=1.0).contains(fraction)), "{told:?}");
    for pair in told.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
        assert!(pair[0].1 <= pair[1].1, "{pair:?}");
    }
    let options = circle_options().progress(move |_, _| {
        assert_eq!(std::thread::current().id(), here);
        Continue(())
    });
    Model::fit(&circle(), &options).unwrap();
}

#[test]
fn it_cancels_at_every_report() {
    let reports = Reports::default();
    let whole = Model::fit(&circle(), &recording(&reports)).unwrap();
    let count = reports.lock().unwrap().len();
    // On a busy machine a fit takes longer and reports more often, so a later fit may end before it
    // is cancelled; once it is cancelled, it stops.
    for last in 1..=count {
        let told = Arc::new(AtomicUsize::new(0));
        let counter = Arc::clone(&told);
        let options = circle_options().progress(move |_, _| {
            if counter.fetch_add(1, Relaxed) + 1 == last {
                Break(())
            } else {
                Continue(())
            }
        });
        let failure = Model::fit(&circle(), &options).err().map(|error| error.kind());
        let asked = told.load(Relaxed) >= last;
        assert_eq!(failure, asked.then_some(ErrorKind::Cancelled));
        assert!(asked || last > 10, "told only {told:?} times");
    }
    let again = Model::fit(&circle(), &circle_options()).unwrap();
    assert!(same_bits(&again.coords(), &whole.coords()));
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn it_cancels_events_comparisons_and_files() {
    let clip = common::walker();
    let found = clip.decompose(&Options::new()).unwrap();
    let phase = Phase::find(&found, &Options::new()).unwrap();
    let options = Options::new().progress(|_, _| Break(()));
    let path = std::env::temp_dir().join(format!("stltsa-{}.csv", std::process::id()));
    let errors = [
        phase.events(&[250.0], None, &options).err(),
        phase.compare(&phase, None, None, 101, &options).err(),
        clip.save_with(&path, &options).err(),
    ];
    for error in errors {
        assert_eq!(error.unwrap().kind(), ErrorKind::Cancelled);
    }
    assert!(!path.exists());
}

#[test]
fn its_panic_goes_on_from_the_call_and_leaves_the_options_usable() {
    let reports = Arc::new(AtomicUsize::new(0));
    let counter = Arc::clone(&reports);
    let options = circle_options().progress(move |_, _| {
        assert_ne!(counter.fetch_add(1, Relaxed), 1, "enough");
        Continue(())
    });
    let fit = || Model::fit(&circle(), &options);
    let panic = catch_unwind(AssertUnwindSafe(fit)).unwrap_err();
    assert!(panic.downcast_ref::<String>().unwrap().contains("enough"));
    assert_eq!(reports.load(Relaxed), 2); // it ended there
    assert!(fit().is_ok());
    assert!(reports.load(Relaxed) > 10); // and receives reports of the next call
}

/// The closure makes another call with the options that it belongs to.
#[test]
fn it_may_call_the_library() {
    let shared: Arc<Mutex<Option<Options>>> = Arc::default();
    let inside = Arc::clone(&shared);
    let options = circle_options().progress(move |_, _| {
        let options = inside.lock().unwrap().take();
        if let Some(options) = options {
            assert!(Model::fit(&circle(), &options).is_ok());
        }
        Continue(())
    });
    *shared.lock().unwrap() = Some(options.clone());
    assert!(Model::fit(&circle(), &options).is_ok());
    assert!(shared.lock().unwrap().is_none());
}
