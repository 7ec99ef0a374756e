// SPDX-License-Identifier: BSD-3-Clause
//! Results can move to other threads, and several threads can read them at once.

mod common;

use std::thread;

use common::{circle, circle_model, circle_options, same_bits};
use stltsa::{
    Clip, Decomposition, Denoising, Error, Info, Matrix, Model, Options, Piece, Synthesis, View,
};

#[test]
fn all_types_are_send_and_sync() {
    fn check<T: Send + Sync>() {}
    check::<Clip>();
    check::<Model>();
    check::<Info<'_>>();
    check::<Decomposition>();
    check::<Denoising>();
    check::<Synthesis>();
    check::<Options>();
    check::<Piece<'_>>();
    check::<View<'_>>();
    check::<Matrix>();
    check::<Error>();
}

#[test]
fn fits_at_once_give_the_bits_of_one() {
    let alone = circle_model().coords();
    let fits: Vec<_> = (1..5)
        .map(|threads| {
            thread::spawn(move || Model::fit(&circle(), &circle_options().threads(threads)))
        })
        .collect();
    for fit in fits {
        let model = fit.join().unwrap().unwrap();
        assert!(same_bits(&model.coords(), &alone));
    }
}

#[test]
fn several_threads_ask_one_model() {
    let model = circle_model();
    let expected = model.coords();
    thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(|| {
                for _ in 0..5 {
                    let mapped = model.map(&circle(), None, &Options::new()).unwrap();
                    assert!(same_bits(&mapped.coords, &expected));
                }
            });
        }
    });
    thread::spawn(move || drop(model)).join().unwrap();
}
