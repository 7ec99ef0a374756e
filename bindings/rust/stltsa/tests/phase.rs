// SPDX-License-Identifier: BSD-3-Clause
//! Phases, and signals on 0 to 100 % of cycles.

mod common;

use stltsa::{Cycles, ErrorKind, Options, Phase};

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn frames_of_cycles_have_phases() {
    let clip = common::walker();
    let options = Options::new();
    let found = clip.decompose(&options).unwrap();
    let phase = Phase::find(&clip, &found, &options).unwrap();
    let (values, cycles) = (phase.values().unwrap(), phase.cycles().unwrap());
    let residuals = phase.residuals().unwrap();
    assert_eq!(values.len(), clip.frames());
    for (frame, cycle) in cycles.iter().enumerate() {
        let part = cycle.map(|index| found.cycles()[index]);
        assert_eq!(part.is_some(), !values[frame].is_nan());
        assert!(part.map_or(true, |part| part.frames().contains(&frame)));
        assert!(values[frame].is_nan() || residuals[frame] < 0.5);
    }
    assert!(phase.warnings().is_empty());

    let ramp: Vec<[f64; 1]> = (0..clip.frames()).map(|frame| [frame as f64]).collect();
    let cycles = phase.resample(0, &ramp, 11).unwrap();
    assert_eq!(cycles.len(), found.cycles().len());
    let (frames, first) = (cycles.frames().unwrap(), cycles.cycle(1).unwrap());
    assert!((0..11).all(|s| (frames[(1, s)] - first[(s, 0)]).abs() < 1e-9));
    assert!(cycles.mean().unwrap()[(5, 0)] > first[(0, 0)]);
    assert!(cycles.deviation().unwrap()[(5, 0)] > 0.0);
    assert!(cycles.warp().unwrap()[(1, 5)].abs() < 0.1);
    assert_eq!(cycles.distance().unwrap().len(), cycles.len());
    assert_eq!(cycles.column_distance().unwrap().cols(), 1);
    let error = phase.resample(7, &ramp, 11).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Argument);
}

#[test]
fn borders_may_be_given() {
    let ramp: Vec<[f64; 1]> = (0..9).map(|frame| [frame as f64]).collect();
    let cycles = Cycles::between(&[0.0, 4.0, 8.0], &ramp, 5).unwrap();
    assert_eq!(cycles.mean().unwrap()[(1, 0)], 3.0);
    assert!(Cycles::between(&[4.0, 4.0], &ramp, 5).is_err());
}
