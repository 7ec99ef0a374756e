// SPDX-License-Identifier: BSD-3-Clause
//! A clip with a skeleton, in every function that needs one.

mod common;

use common::{same_bits, scratch, walker, walker_path};
use stltsa::{
    Clip, Dimension, ErrorKind, Fact, Format, Model, Options, PartKind, Piece, Quantity,
    SegmentKind, Synthesis, UnitKind,
};

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn a_clip_says_what_is_in_it() {
    let clip = walker();
    assert_eq!((clip.format(), clip.fps()), (Format::Bvh, Some(120.0)));
    let joints = clip.joints().unwrap();
    assert_eq!(joints.len(), clip.joint_count());
    assert_eq!(joints[0].parent, None);
    assert!(joints[1..].iter().enumerate().all(|(i, joint)| joint.parent.unwrap() <= i));
    assert!(joints.iter().any(|joint| joint.is_end_site));
    let positions = clip.positions().unwrap();
    assert_eq!((positions.rows(), positions.cols()), (clip.frames(), 3 * joints.len()));
    let rotations = clip.rotations().unwrap();
    let w_x_y_z = &rotations.row(clip.frames() / 2)[..4];
    assert!((w_x_y_z.iter().map(|q| q * q).sum::<f64>() - 1.0).abs() < 1e-12);
    assert!(clip.channels() > 0 && clip.json().unwrap().contains("stltsa-clip/1"));
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn a_recording_has_segments_steps_and_a_summary() {
    let found = walker().decompose(&Options::new()).unwrap();
    let segments = found.segments().unwrap();
    assert_eq!(segments.first().unwrap().begin, 0);
    assert_eq!(segments.last().unwrap().end, walker().frames());
    let moving: Vec<_> =
        segments.iter().filter(|segment| segment.kind != SegmentKind::Rest).collect();
    assert_eq!(moving.len(), 1);
    assert_eq!(
        (moving[0].kind, moving[0].label, moving[0].count),
        (SegmentKind::Cyclic, Some(0), 3)
    );
    assert_eq!(moving[0].kind.to_string(), "cyclic");
    assert!(!moving[0].carried_by.is_empty());
    assert_eq!((moving[0].reason.as_deref(), moving[0].likeness), (None, None));
    let facts = found.cycle_facts().unwrap();
    assert_eq!(facts.len(), 3);
    assert_eq!(facts[2].begin, found.cycles()[2].begin);
    let steps = found.steps().unwrap();
    let sides: Vec<_> = steps.iter().map(|step| step.side).collect();
    assert_eq!(sides, [Some(0), Some(1)].repeat(3));
    assert_eq!(steps[5].cycle, Some(2));
    assert!(found.repetitions().unwrap().is_empty());
    let travel = found.cycle_facts().unwrap()[1].travel.unwrap();
    assert!((travel.speed - 126.0).abs() < 1.5 && travel.turn.unwrap().abs() < 0.5);
    let of = |side| found.statistics(PartKind::Step, 0, side, Quantity::Time).unwrap();
    assert_eq!(of(None).unwrap().count, of(Some(0)).unwrap().count + of(Some(1)).unwrap().count);
    assert!(found.statistics(PartKind::Step, 0, Some(2), Quantity::Time).is_err());
    let turn = found.statistics(PartKind::Cycle, 0, None, Quantity::Turn).unwrap().unwrap();
    assert_eq!((turn.count, turn.cv), (3, None));
    assert_eq!(found.statistics(PartKind::Repetition, 0, None, Quantity::Way).unwrap(), None);
    assert_eq!(found.label_likeness(0, 0).unwrap(), None);
    assert!(found.label_likeness(0, 9).is_err());
    let summary = found.summary().unwrap();
    assert_eq!((summary.len(), summary[0].label, summary[0].count), (1, 0, 3));
    assert!((summary[0].mean - found.info().period.unwrap()).abs() < 0.1);
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn bytes_and_saved_files_are_the_same_clip() {
    let clip = walker();
    let bytes = std::fs::read(walker_path()).unwrap();
    let parsed = Clip::parse(&bytes, Some(Format::Bvh), &Options::new()).unwrap();
    let path = scratch("saved.bvh");
    clip.save(&path).unwrap();
    for same in [parsed, Clip::open(&path).unwrap()] {
        assert!(same_bits(&same.positions().unwrap(), &clip.positions().unwrap()));
    }
    assert_eq!(clip.save(scratch("clip.odd")).unwrap_err().kind(), ErrorKind::Argument);
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn units_cover_the_clip_and_cycles_the_cyclic_one() {
    let clip = walker();
    let found = clip.decompose(&Options::new()).unwrap();
    let kinds: Vec<String> = found.units().iter().map(|unit| unit.kind.to_string()).collect();
    assert_eq!(kinds, ["preparing", "initial", "cyclic", "final", "wind-up"]);
    assert_eq!(found.units()[0].begin, 0);
    assert_eq!(found.units()[4].end, clip.frames());
    assert!(found.units().windows(2).all(|pair| pair[0].end == pair[1].begin));
    let cyclic = found.units().iter().find(|unit| unit.kind == UnitKind::Cyclic).unwrap();
    let (first, last) = (&found.cycles()[0], found.cycles().last().unwrap());
    assert_eq!(cyclic.frames(), first.begin..last.end);
    assert!(found.best().is_some() && found.representative().is_some());
    assert_eq!(found.reason(), None);
    let info = found.info();
    assert_eq!(found.curve().unwrap().len(), info.samples);
    assert_eq!(found.loop_coords().unwrap().rows(), info.samples);
    assert!((info.period.unwrap() - 1.1).abs() < 0.02, "{info:?}");
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn standing_has_no_cycle_and_a_reason() {
    let standing = Clip::from_matrix(&walker().positions().unwrap(), 120.0).unwrap();
    let options = Options::new().period_min(2.5).period_max(6.0);
    let found = standing.decompose(&options).unwrap();
    assert!(found.cycles().is_empty() && found.best().is_none());
    assert!(!found.reason().unwrap().is_empty());
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn a_fitted_clip_maps_to_its_own_coordinates_and_back_to_poses() {
    let clip = walker();
    let model = Model::fit_clip(&clip, &Options::new().dimension(3)).unwrap();
    let (info, coords) = (model.info(), model.coords().unwrap());
    let mapped = model.map_clip(&clip, &Options::new()).unwrap();
    assert_eq!(mapped.coords.rows(), clip.frames());
    for row in 0..info.frames {
        let frame = info.first_frame + row * info.frame_step;
        assert_eq!(mapped.coords.row(frame), coords.row(row));
    }
    let hints: Vec<_> = (0..info.frames).map(Some).collect();
    for poses in [
        model.unmap_clip(&coords, &Options::new()).unwrap(),
        model.unmap_clip_near(&coords, &hints, &Options::new()).unwrap(),
    ] {
        assert_eq!(poses.clip.frames(), info.frames);
        assert_eq!(poses.clip.joint_count(), clip.joint_count());
        assert_eq!(poses.clip.fps(), info.fps);
        assert!(poses.distance.iter().all(|distance| *distance <= 1.0));
    }
    let estimate = Dimension::estimate_clip(&clip, &Options::new()).unwrap();
    assert!(!estimate.eigenvalues().unwrap().is_empty());
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn clips_are_fitted_together() {
    let clip = walker();
    let options = Options::new().neighbors(36);
    let model = Model::fit_clips(&[&clip, &clip], &options).unwrap();
    let alone = Model::fit_clip(&clip, &options).unwrap();
    let rows = alone.info().frames;
    assert_eq!(model.facts().ints(Fact::Length).unwrap(), [rows as i64; 2]);
    assert_eq!(model.facts().texts(Fact::Path).unwrap().len(), 2);
    let estimate = Dimension::estimate_clips(&[&clip, &clip], &options).unwrap();
    assert_eq!(estimate.facts().ints(Fact::Rows).unwrap(), [2 * rows as i64]);
    let numbers = Clip::from_matrix(&[[1.0, 2.0], [3.0, 4.0]], 120.0).unwrap();
    let error = Model::fit_clips(&[&clip, &numbers], &options).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Shape);
    assert_eq!(Model::fit_clips(&[], &options).unwrap_err().kind(), ErrorKind::Argument);
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn the_best_cycle_goes_round_and_round() {
    let clip = walker();
    let best = *clip.decompose(&Options::new()).unwrap().best().unwrap();
    let pieces = [Piece::new(&clip, best.frames()).repeat(4)];
    let synthesis = Synthesis::new(&pieces, &Options::new()).unwrap();
    drop(clip); // the new clip does not depend on it
    assert_eq!(synthesis.seams().len(), 3);
    for seam in synthesis.seams() {
        assert_eq!((seam.piece, seam.next), (0, 0));
        assert!(seam.posture < 1.0 && seam.crossfade > 0, "{seam:?}");
    }
    assert!(synthesis.warnings().is_empty());
    assert!(synthesis.clip().frames() > 3 * (best.end - best.begin));
    let path = scratch("loop.bvh");
    synthesis.clip().save(&path).unwrap();
    let saved = Clip::open(&path).unwrap().positions().unwrap();
    assert!(same_bits(&saved, &synthesis.clip().positions().unwrap()));
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn a_loop_has_all_cycles_and_stays_in_place() {
    let clip = walker();
    let found = clip.decompose(&Options::new()).unwrap();
    let made = Synthesis::of_cycles(&clip, &found, &Options::new().in_place(true)).unwrap();
    let facts = made.facts();
    assert_eq!(facts.ints(Fact::LoopCycles).unwrap(), [found.cycles().len() as i64]);
    assert_eq!(facts.reals(Fact::Coverage).unwrap(), [1.0]);
    assert_eq!(made.seams().last().unwrap().frame, made.clip().frames());
    // Where the first frame follows the last, the root moves no further than elsewhere.
    let travel = facts.reals(Fact::Travel).unwrap()[2];
    let positions = made.clip().positions().unwrap();
    let (first, last) = (positions.row(0)[2], positions.row(made.clip().frames() - 1)[2]);
    assert!((last - first).abs() < 0.05 * travel.abs(), "{first} {last} {travel}");

    let best = found.best().unwrap();
    let looped = Options::new().r#loop(true);
    let one = Synthesis::new(&[Piece::new(&clip, best.frames())], &looped).unwrap();
    assert_eq!(one.seams().len(), 1);
    assert_eq!(one.facts().ints(Fact::Loop).unwrap(), [1]);
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn pieces_that_follow_each_other_give_the_clip_back() {
    let clip = walker();
    let found = clip.decompose(&Options::new()).unwrap();
    let pieces: Vec<_> = found.units().iter().map(|u| Piece::new(&clip, u.frames())).collect();
    let whole = Synthesis::new(&pieces, &Options::new()).unwrap();
    assert!(same_bits(&whole.clip().positions().unwrap(), &clip.positions().unwrap()));
    let outside = [Piece::new(&clip, 0..clip.frames() + 1)];
    let error = Synthesis::new(&outside, &Options::new()).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Argument);
    assert_eq!(Synthesis::new(&[], &Options::new()).unwrap_err().kind(), ErrorKind::Argument);
}
