// SPDX-License-Identifier: BSD-3-Clause
//! Each method of `Options` sets the option of its name, and the library checks the values.

mod common;

use common::circle;
use stltsa::{options_table, Axis, ErrorKind, Features, Mode, Model, Options};

/// One option of each type: its name, and options with it set.
fn one_each() -> [(&'static str, Options); 6] {
    [
        ("neighbors", Options::new().neighbors(40)),
        ("include_self", Options::new().include_self(false)),
        ("mode", Options::new().mode(Mode::Spatial)),
        ("up_axis", Options::new().up_axis(Axis::Z)),
        ("gamma", Options::new().gamma(0.5)),
        ("skeleton", Options::new().skeleton("a.asf")),
    ]
}

#[test]
fn each_method_sets_the_option_of_its_name() {
    for (name, options) in one_each() {
        let shown = format!("{options:?}");
        assert!(shown.starts_with(&format!("{{\"{name}\": ")), "{name} sets {shown}");
    }
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
        assert!(row.standard.map_or(true, |standard| range.contains(&standard)), "{row:?}");
        assert_eq!(row.standard.is_none(), row.text.contains("auto: "), "{row:?}");
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
        ("positions", Features::Positions),
        ("rotations6d", Features::Rotations6d),
        ("euler", Features::Euler),
        ("raw", Features::Raw),
        ("points", Features::Points),
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
