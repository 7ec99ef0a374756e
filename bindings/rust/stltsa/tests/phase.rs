// SPDX-License-Identifier: BSD-3-Clause
//! Phases, and signals on 0 to 100 % of cycles.

mod common;

use stltsa::{Cycles, ErrorKind, Live, Model, Options, Phase, Rotations, SegmentKind, View};

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn frames_of_cycles_have_phases() {
    let clip = common::walker();
    let options = Options::new();
    let found = clip.decompose(&options).unwrap();
    let phase = Phase::find(&found, &options).unwrap();
    let (values, cycles, parts) = (phase.values(), phase.cycles(), found.cycles());
    let residuals = phase.residuals();
    assert_eq!(values.len(), clip.frames());
    for (frame, cycle) in cycles.iter().enumerate() {
        let part = cycle.map(|index| &parts[index]);
        assert_eq!(part.is_some(), !values[frame].is_nan());
        assert!(part.map_or(true, |part| part.frames().contains(&frame)));
        assert!(values[frame].is_nan() || residuals[frame] < 0.5);
    }
    assert!(phase.warnings().is_empty());
    assert!(matches!(phase.zeros()[..], [zero] if (0.0..1.0).contains(&zero)));
    assert_eq!(phase.json().unwrap_err().kind(), ErrorKind::Unsupported);

    let ramp: Vec<[f64; 1]> = (0..clip.frames()).map(|frame| [frame as f64]).collect();
    let cycles = phase.resample(0, &ramp, 11, &options).unwrap();
    assert_eq!(cycles.len(), found.cycles().len());
    let (frames, first) = (cycles.frames(), cycles.cycle(1).unwrap());
    assert!((0..11).all(|s| (frames[(1, s)] - first[(s, 0)]).abs() < 1e-9));
    assert!(cycles.mean()[(5, 0)] > first[(0, 0)]);
    assert!(cycles.deviation()[(5, 0)] > 0.0);
    assert!(cycles.warp()[(1, 5)].abs() < 0.1);
    assert_eq!(cycles.distance().len(), cycles.len());
    let of_column = cycles.column_distance();
    assert_eq!(of_column.cols(), 1);
    let of_group = cycles.group_distance(&[Some(0)]).unwrap();
    assert_eq!(of_group[(1, 0)], of_column[(1, 0)]);
    assert_eq!(cycles.group_distance(&[None]).unwrap_err().kind(), ErrorKind::Argument);
    assert!(phase.column_owners().len() > 9);
    let error = phase.resample(7, &ramp, 11, &options).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Argument);
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn motions_are_compared() {
    let clip = common::walker();
    let options = Options::new();
    let phase =
        |clip: &stltsa::Clip| Phase::find(&clip.decompose(&options).unwrap(), &options).unwrap();
    let (whole, part) = (phase(&clip), phase(&clip.stretch("200-", &options).unwrap()));
    let found = whole.compare(&part, Some(0), None, 51, &options).unwrap();
    let about = found.whole();
    assert!(about.likeness > 0.99 && about.shift.abs() < 0.02);
    let (parts, channels) = (found.parts(), found.channels());
    assert_eq!(channels.len(), 3 * parts.len());
    assert_eq!((channels[1].axis.as_deref(), parts[1].axis.as_deref()), (Some("y"), None));
    let margin = found.margin();
    assert_eq!((margin.rows(), margin.cols()), (51, channels.len()));
    let mean = |which| found.mean(which).unwrap()[(7, 4)];
    assert_eq!(found.difference()[(7, 4)], mean(1) - mean(0));
    assert_eq!(found.mean(2).unwrap_err().kind(), ErrorKind::Argument);
    assert!(found.motions()[0].left_out.is_empty() && !about.sides);
    assert!(found.json().unwrap().starts_with("{\"format\":\"stltsa-comparison/1\""));

    let path = std::env::temp_dir().join(format!("stltsa-compare-{}.html", std::process::id()));
    found.report(&path, Some("a </script> command"), &options).unwrap();
    let page = std::fs::read_to_string(&path).unwrap();
    std::fs::remove_file(&path).unwrap();
    assert!(page.contains("a \\u003c/script> command"));
    let wrong = found.report(&path, Some("a\0b"), &options).unwrap_err();
    assert_eq!(wrong.kind(), ErrorKind::Argument);

    let sides = whole.compare_left_right(&clip, None, 101, &options).unwrap();
    let about = sides.whole();
    assert!(about.sides && about.shift == 0.5 && about.shift_error.is_none());
    assert!(sides.parts().iter().all(|part| part.second.starts_with("Right")));
    let error = whole.compare(&part, Some(7), None, 51, &options).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Argument);
}

#[test]
fn borders_may_be_given() {
    let ramp: Vec<[f64; 1]> = (0..9).map(|frame| [frame as f64]).collect();
    let cycles = Cycles::between(&[0.0, 4.0, 8.0], &ramp, 5, &Options::new()).unwrap();
    assert_eq!(cycles.mean()[(1, 0)], 3.0);
    assert!(Cycles::between(&[4.0, 4.0], &ramp, 5, &Options::new()).is_err());
}

#[test]
fn sides_of_signals_are_compared() {
    let turn = std::f64::consts::TAU;
    let knees: Vec<[f64; 2]> = (0..201)
        .map(|frame| turn * f64::from(frame) / 100.0)
        .map(|at| [at.sin(), 0.8 * (at - turn * 0.55).sin() + 0.1])
        .collect();
    let options = Options::new();
    let cycles = Cycles::between(&[0.0, 100.0, 200.0], &knees, 101, &options).unwrap();
    let compared = cycles.compare_left_right(&["knee_l", "knee_r"], 50.0, &options).unwrap();
    let counts: Vec<_> = compared.motions().iter().map(|motion| motion.cycles).collect();
    assert_eq!((compared.parts().len(), &counts[..]), (1, &[2, 2][..]));
    let pair = &compared.parts()[0];
    assert_eq!((&*pair.first, &*pair.second), ("knee_l", "knee_r"));
    assert!((pair.lag.difference - 0.05).abs() < 1e-3 && (pair.mean.difference - 0.1).abs() < 1e-9);
    assert!((pair.amplitude_ratio.value - 0.8).abs() < 1e-2);
    assert!(pair.rms_by_chance < 1e-9 && pair.correlation > 0.999);
    assert!((compared.whole().cycle_time_s.first - 2.0).abs() < 1e-9);
    let unlike = cycles.compare_left_right(&["knee_l", "hip_r"], 0.0, &options).unwrap_err();
    assert_eq!(unlike.kind(), ErrorKind::Unsupported);
    let few = cycles.compare_left_right(&["knee_l"], 0.0, &options).unwrap_err();
    assert_eq!(few.kind(), ErrorKind::Shape);
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn a_mark_is_found_in_every_cycle() {
    let clip = common::walker();
    let options = Options::new();
    let found = clip.decompose(&options).unwrap();
    let phase = Phase::find(&found, &options).unwrap();
    let middle = |cycle: usize| {
        let part = &found.cycles()[cycle];
        (part.begin_s + part.end_s) / 2.0 * clip.fps().unwrap()
    };
    let events = phase.events(&[middle(1)], None, &options).unwrap();
    assert_eq!(events.likeness(), 1.0);
    assert!(events.warnings().is_empty());
    for cycle in 0..found.cycles().len() {
        let event = *events.all().iter().find(|event| event.cycle == Some(cycle)).unwrap();
        assert!((event.frame - middle(cycle)).abs() < 3.0);
        assert_eq!(event.marked, cycle == 1);
        assert!((event.seconds * clip.fps().unwrap() - event.frame).abs() < 1e-9);
        assert!((0.0..=1.0).contains(&event.confidence));
    }
    let same = phase.events(&[middle(1)], Some(&phase), &options).unwrap();
    assert_eq!(same.all(), events.all());
    let image = clip.mirrored(&options).unwrap();
    let image = Phase::find(&image.decompose(&options).unwrap(), &options).unwrap();
    let other_side = phase.events(&[middle(1)], Some(&image), &options).unwrap();
    assert!(other_side.likeness() > 0.9 && !other_side.all().is_empty());
    assert_eq!(phase.events(&[2.0], None, &options).unwrap_err().kind(), ErrorKind::Argument);
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn a_stream_has_the_phase_of_the_clip() {
    let clip = common::walker();
    let options = Options::new();
    let found = clip.decompose(&options).unwrap();
    let phase = Phase::find(&found, &options).unwrap();
    let mut model = Model::fit_clip(&clip, &options).unwrap();
    assert!(!model.has_cycle());
    assert_eq!(Live::new(&model).unwrap_err().kind(), ErrorKind::Unsupported);
    model.keep_cycle(&phase, &options).unwrap();
    let marked = found.cycles()[1].begin + 40;
    model.keep_mark(&phase, marked as f64, "strike").unwrap();
    assert!(model.keep_mark(&phase, 2.0, "standing").is_err());
    assert!(model.keep_mark(&phase, marked as f64, "").is_err());

    let model = Model::parse(&model.serialize().unwrap()).unwrap();
    let mut live = Live::new(&model).unwrap();
    assert_eq!(live.marks(), ["strike"]);
    let (frames, phases) = (clip.features(&options).unwrap(), phase.values());
    let mut passed = Vec::new();
    for (row, phase) in phases.iter().enumerate() {
        let now = live.push(row as f64 / clip.fps().unwrap(), frames.row(row)).unwrap();
        if now.passed(0) {
            passed.push(row);
        }
        if (found.cycles()[1].begin..found.cycles()[2].end).contains(&row) {
            let apart = (now.phase - phase).rem_euclid(1.0);
            assert!(apart.min(1.0 - apart) < 0.02);
            assert!(now.known && now.kind == SegmentKind::Cyclic);
            assert!((now.rate_hz - 1.0 / 1.1).abs() < 0.05);
        }
    }
    assert!(passed.iter().any(|&row| (row as f64 - marked as f64).abs() <= 2.0));
    assert_eq!(live.push(9.0, &[1.0]).unwrap_err().kind(), ErrorKind::Shape);
    let (mut of_frames, mut of_poses) = (Live::new(&model).unwrap(), Live::new(&model).unwrap());
    let turns = clip.rotations().unwrap();
    for row in marked - 30..marked {
        let seconds = row as f64 / clip.fps().unwrap();
        let now = of_frames.push_frame(seconds, &clip, row).unwrap();
        let pose = View::new(turns.row(row), turns.cols() / 4, 4).unwrap();
        let root = (row % 2 == 0).then_some([0.0, 90.0, 0.0]);
        let pose = of_poses.push_pose(seconds, Rotations::Quaternions(pose), root).unwrap();
        assert!((now.phase - pose.phase).abs() < 1e-6);
    }
    let points = View::new(&[0.0, 1.0, 2.0], 1, 3).unwrap();
    for sure in [&[][..], &[1.0]] {
        let error = of_poses.push_points(9.0, points, sure).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::Unsupported);
    }
    let beyond = of_frames.push_frame(9.0, &clip, clip.frames()).unwrap_err();
    assert_eq!(beyond.kind(), ErrorKind::Argument);
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn a_report_is_one_page() {
    let clip = common::walker();
    let options = Options::new();
    let found = clip.decompose(&options).unwrap();
    let path = std::env::temp_dir().join(format!("stltsa-report-{}.html", std::process::id()));
    found.report(&clip, &path, Some("a </script> command"), &options).unwrap();
    let page = std::fs::read_to_string(&path).unwrap();
    std::fs::remove_file(&path).unwrap();
    assert!(page.starts_with("<!doctype html>"));
    assert!(page.contains("a \\u003c/script> command"));
    let wrong = found.report(&clip, &path, Some("a\0b"), &options).unwrap_err();
    assert_eq!(wrong.kind(), ErrorKind::Argument);
}
