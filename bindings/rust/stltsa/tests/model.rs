// SPDX-License-Identifier: BSD-3-Clause
//! Models: fitting, saving, mapping both ways, and uses of their coordinates.

mod common;

use common::{bits, circle, circle_model, circle_options, same_bits, scratch, PERIOD};
use stltsa::{Denoising, Fact, Mode, Model, Options, WarningKind};

#[test]
fn a_model_says_what_was_fitted() {
    let model = circle_model();
    for (key, value) in [
        (Fact::Rows, 3 * PERIOD as i64),
        (Fact::FeatureCount, 4),
        (Fact::Dimension, 2),
        (Fact::Neighbors, 120),
        (Fact::IncludeSelf, 1),
        (Fact::FirstFrame, 0),
        (Fact::FrameStep, 1),
    ] {
        assert_eq!(model.info().int(key), Ok(value), "{key:?}");
    }
    assert_eq!(model.info().int(Fact::Mode).map(Mode::from), Ok(Mode::Temporal));
    let real = |key| model.info().real(key).unwrap();
    assert_eq!((real(Fact::Fps), real(Fact::Period)), (0.0, 0.0));
    assert!(real(Fact::Reach) > 0.0);
    let components = model.components();
    assert!(components.len() == 1 && components[0].residual < 1e-9, "{components:?}");
    let eigenvalues = model.eigenvalues();
    assert_eq!((eigenvalues.rows(), eigenvalues.cols()), (1, 4));
    assert!(eigenvalues.row(0).windows(2).all(|pair| pair[0] <= pair[1]));
    assert_eq!(model.component_of(), vec![0; 3 * PERIOD]);
    assert!(model.json().unwrap().starts_with("{\"format\":\"stltsa-model/1\""));
}

#[test]
fn a_coordinate_that_only_follows_time_is_warned_of() {
    let arc = Model::fit(&circle(), &Options::new().neighbors(12).dimension(1)).unwrap();
    assert!(arc.info().real(Fact::TimeCorrelation).unwrap() > 0.99);
    let warnings = arc.warnings();
    let of_time = warnings.iter().find(|warning| warning.code == WarningKind::FollowsTime).unwrap();
    assert!(of_time.text.contains("time") && of_time.begin_s.is_none(), "{warnings:?}");
}

#[test]
fn coordinates_are_centered_and_of_unit_norm() {
    let coords = circle_model().coords();
    for column in 0..2 {
        assert!(coords.column(column).sum::<f64>().abs() < 1e-10);
        let norm: f64 = coords.column(column).map(|y| y * y).sum();
        assert!((norm - 1.0).abs() < 1e-10);
    }
}

#[test]
fn clips_are_components_of_their_own() {
    let lengths = [160, 140];
    let model = Model::fit_several(&circle(), &lengths, &circle_options()).unwrap();
    assert_eq!(model.components().len(), 2);
    let labels = model.component_of();
    assert!(labels.iter().enumerate().all(|(row, label)| *label == usize::from(row >= 160)));
    let first = Model::fit(&circle()[..160], &circle_options()).unwrap();
    let (all, first) = (model.coords(), first.coords());
    assert_eq!(bits(&all.as_slice()[..2 * 160]), bits(first.as_slice()));
}

#[test]
fn a_model_comes_back_from_bytes_and_files_with_the_same_bits() {
    let model = circle_model();
    let bytes = model.serialize().unwrap();
    let path = scratch("circle.stltsa");
    model.save(&path, &Options::new()).unwrap();
    assert_eq!(std::fs::read(&path).unwrap(), bytes);
    for back in [Model::parse(&bytes).unwrap(), Model::load(&path, &Options::new()).unwrap()] {
        assert_eq!(back.json(), model.json());
        assert!(same_bits(&back.coords(), &model.coords()));
        assert_eq!(back.serialize().unwrap(), bytes);
    }
}

#[test]
fn fitted_frames_go_both_ways_to_the_bit() {
    let (model, frames) = (circle_model(), circle());
    let mapped = model.map(&frames, None, &Options::new()).unwrap();
    assert!(same_bits(&mapped.coords, &model.coords()));
    assert!(mapped.distance.iter().all(|distance| *distance == 0.0));
    assert!(mapped.nearest.iter().copied().eq(0..frames.len()));
    let back = model.unmap(&mapped.coords, None, &Options::new()).unwrap();
    assert_eq!(bits(back.frames.as_slice()), bits(&frames.concat()));
}

#[test]
fn a_hint_says_which_round_a_frame_is_of() {
    let (model, frames) = (circle_model(), circle());
    let options = Options::new().hint_window(10);
    for round in 0..3 {
        let row = 40 + round * PERIOD;
        let mapped = model.map(&frames[40..41], Some(&[Some(row)]), &options).unwrap();
        assert!(mapped.nearest[0].abs_diff(row) <= 10, "{:?} for {row}", mapped.nearest);
        let back = model.unmap(&mapped.coords, Some(&[Some(row)]), &options).unwrap();
        assert!(back.nearest[0].abs_diff(row) <= 10, "{:?} for {row}", back.nearest);
    }
}

#[test]
fn a_frame_of_another_kind_is_far() {
    let far = circle_model().map(&[[9.0, 9.0, 9.0, 9.0_f32]], None, &Options::new()).unwrap();
    assert!(far.distance[0] > 1.0);
}

#[test]
fn dimensions_are_estimated() {
    let options = Options::new().neighbors(12).intrinsic(true);
    let model = Model::fit(&circle(), &options).unwrap();
    assert_eq!(model.info().int(Fact::LocalPca), Ok(1));
    let eigenvalues = model.info().reals(Fact::Eigenvalue).unwrap();
    assert!(eigenvalues.len() > 2 && eigenvalues.windows(2).all(|pair| pair[0] <= pair[1]));
    let shares = model.info().reals(Fact::LocalVariance).unwrap();
    assert!(shares[0] > 0.9 && shares.iter().sum::<f64>() < 1.0 + 1e-9, "{shares:?}");
    assert!(circle_model().info().int(Fact::LocalPca).is_err(), "it was not asked for");

    let options = circle_options().intrinsic(true);
    let parts = Model::fit_several(&circle(), &[150, 150], &options).unwrap();
    assert_eq!(parts.info().int(Fact::Eigengap), Ok(0), "of a graph that falls apart");
    assert!(!parts.info().text(Fact::EigengapReason).unwrap().is_empty());
}

#[test]
fn coordinates_are_cleaned() {
    let model = circle_model();
    let mut noisy = model.coords().into_vec();
    noisy[2 * 70] += 0.1;
    let noisy = stltsa::Matrix::from_vec(noisy, 3 * PERIOD, 2).unwrap();
    let denoising = Denoising::new(&noisy, &Options::new()).unwrap();
    let (curve, cleaned) = (denoising.curve(), denoising.cleaned());
    let moves = denoising.moves();
    assert_eq!(denoising.columns().len(), 2);
    assert!(moves[(70, 0)] < 0.0 && cleaned[(70, 0)] < noisy[(70, 0)]);
    assert!((curve[(70, 0)] - model.coords()[(70, 0)]).abs() < 0.01);
    let moved = moves.column(0).filter(|by| *by != 0.0).count();
    assert_eq!(denoising.columns()[0].moved, moved);
    assert_eq!(denoising.info().count(Fact::Column), 2);
    assert!(denoising.json().unwrap().contains("stltsa-denoising/1"));

    let of_model = Denoising::of_model(&model, &Options::new().gamma(0.25)).unwrap();
    assert_eq!(of_model.columns()[0].gamma, 0.25);
    let several = Denoising::new_several(&noisy, &[100, 200], &Options::new()).unwrap();
    assert_eq!(several.curve().rows(), 3 * PERIOD);
}
