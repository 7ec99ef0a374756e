// SPDX-License-Identifier: BSD-3-Clause
//! A clip with a skeleton, in every function that needs one.

mod common;

use common::{same_bits, scratch, walker, walker_path};
use stltsa::{
    Batch, Clip, ErrorKind, Fact, Format, Model, Options, Piece, Quantity, SegmentKind, Synthesis,
    UnitKind,
};

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn a_clip_says_what_is_in_it() {
    let clip = walker();
    assert_eq!((clip.format(), clip.fps()), (Format::Bvh, Some(120.0)));
    let joints = clip.joints();
    assert_eq!(joints.len(), clip.info().count(Fact::Joint));
    assert_eq!(joints[0].parent, None);
    assert!(joints[1..].iter().enumerate().all(|(i, joint)| joint.parent.unwrap() <= i));
    assert!(joints.iter().any(|joint| joint.is_end_site));
    let positions = clip.positions().unwrap();
    assert_eq!((positions.rows(), positions.cols()), (clip.frames(), 3 * joints.len()));
    let rotations = clip.rotations().unwrap();
    let w_x_y_z = &rotations.row(clip.frames() / 2)[..4];
    assert!((w_x_y_z.iter().map(|q| q * q).sum::<f64>() - 1.0).abs() < 1e-12);
    assert!(clip.info().int(Fact::Channels).unwrap() > 0);
    assert!(clip.json().unwrap().contains("stltsa-clip/1"));
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn a_recording_has_segments_steps_and_a_summary() {
    let found = walker().decompose(&Options::new()).unwrap();
    let segments = found.segments();
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
    assert_eq!((moving[0].letters.as_deref(), segments[0].letters.as_deref()), (Some("A"), None));
    let cycles = found.cycles();
    assert_eq!(cycles.len(), 3);
    assert_eq!((cycles[1].end, &*cycles[1].letters), (cycles[2].begin, "A"));
    let steps = found.steps();
    let sides: Vec<_> = steps.iter().map(|step| step.side).collect();
    assert_eq!(sides, [Some(0), Some(1)].repeat(3));
    assert_eq!(steps[5].cycle, Some(2));
    assert!(found.repetitions().is_empty());
    assert!((cycles[1].speed.unwrap() - 126.0).abs() < 1.5);
    assert!(cycles[1].turn_deg.unwrap().abs() < 0.5);
    let of = |side| found.statistics(Fact::Step, 0, side, Quantity::Time).unwrap();
    assert_eq!(of(None).count, of(Some(0)).count + of(Some(1)).count);
    assert!(found.statistics(Fact::Step, 0, Some(2), Quantity::Time).is_err());
    assert!(found.statistics(Fact::Unit, 0, None, Quantity::Time).is_err());
    let turn = found.statistics(Fact::Cycle, 0, None, Quantity::Turn).unwrap();
    assert_eq!((turn.count, turn.cv), (3, None));
    let none = found.statistics(Fact::Repetition, 0, None, Quantity::PathLength).unwrap();
    assert!(none.count == 0 && none.mean.is_nan());
    let likeness = found.label_likeness();
    assert!((likeness.rows(), likeness.cols()) == (1, 1) && likeness[(0, 0)].is_nan());
    let summary = found.summaries();
    assert_eq!((summary.len(), summary[0].label, summary[0].count), (1, 0, 3));
    let period = found.info().real(Fact::Period).unwrap();
    assert!((summary[0].cycle_time_s.mean - period).abs() < 0.1);
    assert_eq!(summary[0].step_time_s, of(None));
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
    let cyclic = found.units().into_iter().find(|unit| unit.kind == UnitKind::Cyclic).unwrap();
    let cycles = found.cycles();
    assert_eq!(cyclic.frames(), cycles[0].begin..cycles.last().unwrap().end);
    assert!(found.best().is_some() && found.representative().is_some());
    assert_eq!(found.reason(), None);
    let rows = found.info().int(Fact::Rows).unwrap() as usize;
    assert_eq!((found.curve().len(), found.coords().rows()), (rows, rows));
    assert!((found.info().real(Fact::Period).unwrap() - 1.1).abs() < 0.02);
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn standing_has_no_cycle_and_a_reason() {
    let standing = Clip::from_matrix(&walker().positions().unwrap(), 120.0).unwrap();
    let options = Options::new().period_min(2.5).period_max(6.0);
    let found = standing.decompose(&options).unwrap();
    assert!(found.cycles().is_empty() && found.best().is_none());
    assert!(!found.reason().unwrap().is_empty());
    let rest = walker().stretch("0-60", &Options::new()).unwrap();
    let rest = rest.decompose(&Options::new()).unwrap();
    assert!(rest.segments().iter().all(|segment| segment.label.is_none()));
    assert_eq!(rest.label_likeness().as_slice(), [0.0; 0]);
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn a_fitted_clip_maps_to_its_own_coordinates_and_back_to_poses() {
    let clip = walker();
    let model = Model::fit_clip(&clip, &Options::new().dimension(3)).unwrap();
    let (info, coords) = (model.info(), model.coords());
    let mapped = model.map_clip(&clip, &Options::new()).unwrap();
    assert_eq!(mapped.coords.rows(), clip.frames());
    let of = |key| info.int(key).unwrap() as usize;
    for row in 0..coords.rows() {
        let frame = of(Fact::FirstFrame) + row * of(Fact::FrameStep);
        assert_eq!(mapped.coords.row(frame), coords.row(row));
    }
    let hints: Vec<_> = (0..coords.rows()).map(Some).collect();
    for poses in [
        model.unmap_clip(&coords, None, &Options::new()).unwrap(),
        model.unmap_clip(&coords, Some(&hints), &Options::new()).unwrap(),
    ] {
        assert_eq!(poses.clip.frames(), coords.rows());
        assert_eq!(poses.clip.joints(), clip.joints());
        assert_eq!(poses.clip.fps(), info.real(Fact::Fps).ok());
        assert!(poses.distance.iter().all(|distance| *distance <= 1.0));
    }
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn clips_are_fitted_together() {
    let clip = walker();
    let options = Options::new().neighbors(36);
    let model = Model::fit_clips(&[&clip, &clip], &options).unwrap();
    let alone = Model::fit_clip(&clip, &options).unwrap();
    let rows = alone.coords().rows();
    assert_eq!(model.info().ints(Fact::Length).unwrap(), [rows as i64; 2]);
    assert_eq!(model.info().texts(Fact::Path).unwrap().len(), 2);
    assert_eq!(model.info().int(Fact::Rows), Ok(2 * rows as i64));
    let numbers = Clip::from_matrix(&[[1.0, 2.0], [3.0, 4.0]], 120.0).unwrap();
    let error = Model::fit_clips(&[&clip, &numbers], &options).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Shape);
    assert_eq!(Model::fit_clips(&[], &options).unwrap_err().kind(), ErrorKind::Argument);
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn the_best_cycle_goes_round_and_round() {
    let clip = walker();
    let best = clip.decompose(&Options::new()).unwrap().best().unwrap();
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
    let info = made.info();
    assert_eq!(info.int(Fact::LoopCycles), Ok(found.cycles().len() as i64));
    assert_eq!(info.real(Fact::Coverage), Ok(1.0));
    let wrap = made.seams().pop().unwrap();
    assert!(wrap.wrap && wrap.frame == made.clip().frames());
    // Where the first frame follows the last, the root moves no further than elsewhere.
    let travel = info.reals(Fact::Travel).unwrap()[2];
    let positions = made.clip().positions().unwrap();
    let (first, last) = (positions.row(0)[2], positions.row(made.clip().frames() - 1)[2]);
    assert!((last - first).abs() < 0.05 * travel.abs(), "{first} {last} {travel}");

    let best = found.best().unwrap();
    let looped = Options::new().r#loop(true);
    let one = Synthesis::new(&[Piece::new(&clip, best.frames())], &looped).unwrap();
    assert_eq!(one.seams().len(), 1);
    assert_eq!(one.info().int(Fact::Loop), Ok(1));
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

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn a_batch_writes_results_and_keeps_them() {
    let out = scratch("batch");
    let paths = [walker_path(), out.join("missing.bvh")];
    let options = Options::new();
    for again in [false, true] {
        let batch = Batch::new(&paths, &out, None, &options).unwrap();
        let count = batch.paths().len();
        let rows: Vec<_> = (0..count).map(|clip| batch.run(clip, &options).unwrap()).collect();
        assert_eq!(rows.iter().filter(|row| row.kept == again && row.error.is_none()).count(), 1);
        assert_eq!(rows.iter().filter(|row| row.error.is_some()).count(), 1);
        let table = std::fs::read_to_string(batch.finish(&rows).unwrap()).unwrap();
        assert_eq!(table.lines().count(), 3);
        assert_eq!(batch.run(count, &options).unwrap_err().kind(), ErrorKind::Argument);
    }
    let error = Batch::new(&paths, &out, Some("3/2"), &options).unwrap_err();
    assert!(error.message().contains("shard"));
}
