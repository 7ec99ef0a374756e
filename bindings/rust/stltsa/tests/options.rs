// SPDX-License-Identifier: BSD-3-Clause
//! There is a method for each option of the library, and it sets that one.

mod common;

use std::collections::BTreeSet;

use common::circle;
use stltsa::{options_table, Axis, ErrorKind, Features, Mode, Model, Options};

/// (name of the method, options with that one set)
macro_rules! each {
    ($($name:ident($value:expr))*) => {
        [$((stringify!($name).replace('_', "-"), Options::new().$name($value)),)*]
    };
}

fn one_each() -> impl IntoIterator<Item = (String, Options)> {
    each! {
        neighbors(40) window(40) dimension(2) mode(Mode::Temporal) include_self(true) links(4)
        exclusion(40) threads(1) features(Features::Raw) up_axis(Axis::Z) keep_start(true) fps(60.0)
        rate(30.0) smoothing(0.1) period_min(0.3) period_max(6.0) eigengap(0.1) variance(0.9)
        skeleton("a.asf") keep_frames(true) map_neighbors(12) map_blend(3) hint_window(5)
        component(0) gamma(0.5) knots(0.1) robust(true) crossfade(0.1) search(0.1)
        posture_limit(3.0) memory_map(false)
    }
}

#[test]
fn each_method_sets_the_option_of_its_name() {
    for (name, options) in one_each() {
        let shown = format!("{options:?}").replace('_', "-");
        assert!(shown.starts_with(&format!("{{\"{name}\": ")), "{name} sets {shown}");
    }
}

#[test]
fn every_option_of_the_library_has_a_method() {
    let methods: BTreeSet<String> = one_each().into_iter().map(|(name, _)| name).collect();
    let table = options_table().into_iter().map(|row| row.name.replace('_', "-")).collect();
    assert_eq!(methods, table);
}

#[test]
fn all_values_reach_the_library() {
    for (name, options) in one_each() {
        let clip = stltsa::Clip::parse(b"1,2\n3,4\n", None, &options);
        assert!(clip.is_ok(), "{name}: {clip:?}");
    }
}

#[test]
fn what_is_out_of_range_is_refused_by_the_call() {
    for row in options_table().iter().filter(|row| row.range.is_some()) {
        let range = row.range.clone().unwrap();
        assert!(range.contains(&row.standard), "{row:?}");
    }
    for options in [
        Options::new().dimension(usize::MAX),
        Options::new().variance(1.5),
        Options::new().smoothing(f64::NAN),
        Options::new().mode(Mode::Other(77)),
    ] {
        let error = Model::fit(&circle(), &options).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::Argument);
        assert!(error.message().contains("must be from"), "{error}");
    }
}

#[test]
fn names_of_values_are_the_librarys() {
    let modes =
        [("temporal", Mode::Temporal), ("spatial", Mode::Spatial), ("recurrent", Mode::Recurrent)];
    let features = [
        ("auto", Features::Auto),
        ("positions", Features::Positions),
        ("rotations6d", Features::Rotations6d),
        ("euler", Features::Euler),
        ("raw", Features::Raw),
    ];
    let axes = [("x", Axis::X), ("y", Axis::Y), ("z", Axis::Z)];
    let shown = modes.map(|(name, mode)| ("mode", name, Options::new().mode(mode)));
    let shown = shown.into_iter();
    let shown =
        shown.chain(features.map(|(name, f)| ("features", name, Options::new().features(f))));
    let shown =
        shown.chain(axes.map(|(name, axis)| ("up-axis", name, Options::new().up_axis(axis))));
    for (option, name, options) in shown {
        let table = options_table();
        let row = table.iter().find(|row| row.name.replace('_', "-") == option).unwrap();
        let choices = row.choices.clone().unwrap();
        let pairs = choices.split(' ').filter_map(|choice| choice.split_once('='));
        let (_, number) = pairs.into_iter().find(|(found, _)| *found == name).unwrap();
        assert!(format!("{options:?}").contains(&format!("Int({number})")), "{name}: {choices}");
    }
}
