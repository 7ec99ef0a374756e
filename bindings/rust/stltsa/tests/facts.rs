// SPDX-License-Identifier: BSD-3-Clause
//! The fields of a result agree with its JSON; distinct values reveal a mix-up.

mod common;

use common::{after, circle, scratch, value, walker};
use stltsa::{
    Clip, Denoising, Dimension, ErrorKind, Fact, Interval, Mode, Model, Options, Piece, Seam,
    Synthesis,
};

fn count(json: &str, key: &str) -> usize {
    value(json, key).parse().expect("a count")
}

fn real(json: &str, key: &str) -> f64 {
    value(json, key).parse().expect("a number")
}

#[test]
fn of_a_model() {
    let mut frames = circle();
    frames[200] = frames[199];
    let options = Options::new().mode(Mode::Recurrent).dimension(3).fps(50.0);
    let options = options.neighbors(110).window(130).links(5).exclusion(140).include_self(false);
    let model = Model::fit(&frames, &options).unwrap();
    let (info, json) = (model.info(), model.json().unwrap());
    assert_eq!(info.mode, Mode::Recurrent);
    assert_eq!(info.frames, 300);
    assert_eq!((info.neighbors, info.window, info.dimension), (110, 130, 3));
    assert_eq!((info.links, info.exclusion, info.include_self), (5, 140, false));
    assert_eq!(info.features, count(&json, "feature_count"));
    assert_eq!(info.repeated, 1);
    assert_eq!(info.components, model.eigenvalues().unwrap().rows());
    assert_eq!(info.time_correlation, real(&json, "time_correlation"));
    let component = after(&json, "components");
    assert_eq!(info.residual, real(component, "residual"));
    assert_eq!(info.error_estimate, real(component, "error_estimate_rad"));
    assert_eq!(info.gap, real(component, "gap"));
    assert_eq!(info.rank_deficient, count(component, "rank_deficient_windows"));
    assert_eq!(info.solves, count(component, "solves"));
    assert_eq!(info.fps, Some(50.0));
}

/// Ten swings, the first two of them larger, between standing; nine frames are cut off.
fn swings() -> Clip {
    let swing = |t: f64| match t {
        t if !(2.0..12.0).contains(&t) => 0.0,
        t if t < 4.0 => 1.2 * (std::f64::consts::TAU * t).sin(),
        t => (std::f64::consts::TAU * t).sin(),
    };
    let frame = |i: i32| f64::from(i) / 60.0;
    let frames: Vec<[f64; 2]> =
        (9..840).map(frame).map(|t| [swing(t), 0.5 * swing(t - 0.1)]).collect();
    Clip::from_matrix(&frames, 60.0).unwrap()
}

#[test]
fn of_a_decomposition() {
    let found = swings().decompose(&Options::new()).unwrap();
    let (info, json) = (found.info(), found.json().unwrap());
    let (samples, parameters) = (after(&json, "samples"), after(&json, "parameters"));
    assert_eq!(info.samples, count(samples, "count"));
    assert_eq!(info.first_frame, count(samples, "first_frame"));
    assert_eq!((info.frame_step, info.fps), (2, 30.0));
    assert_eq!(info.neighbors, count(parameters, "neighbors"));
    assert_eq!(info.window, count(parameters, "window"));
    assert_eq!(info.dimension, count(&json, "tangent_dimension"));
    assert_eq!(info.coordinate, Some(count(&json, "coordinate")));
    assert_eq!(info.period, Some(real(&json, "period_s")));
    assert_eq!(info.cyclicity, real(&json, "cyclicity"));
    assert_eq!(info.lag_quality, real(&json, "lag_quality"));
    assert_eq!(format!("{:?}", info.features).to_lowercase(), value(&json, "features"));

    let (first, best) = (found.representative().unwrap(), found.best().unwrap());
    let begins = |key| real(after(&json, key), "begin_s");
    assert_ne!(first, best);
    assert_eq!(first.begin_s, begins("representative_cycle"));
    assert_eq!(best.begin_s, begins("best_cycle"));
}

#[test]
fn by_key() {
    let clip = swings();
    assert_eq!(clip.facts().reals(Fact::ClipFps), Ok(vec![60.0]));
    assert_eq!(clip.facts().ints(Fact::ClipFrames), Ok(vec![831]));
    assert_eq!(clip.facts().texts(Fact::Path), Ok(vec![String::new()]));
    assert_eq!(clip.facts().ints(Fact::Neighbors), Ok(vec![]), "a clip has no neighbors");
    let error = clip.facts().reals(Fact::ClipFrames).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Argument);
    assert!(error.message().contains("clip_frames"), "{error}");

    let found = clip.decompose(&Options::new()).unwrap();
    assert_eq!(found.facts().ints(Fact::Neighbors), Ok(vec![found.info().neighbors as i64]));
    assert_eq!(found.facts().texts(Fact::Warning), Ok(found.warnings()));

    let model = Model::fit(&circle(), &Options::new().neighbors(110)).unwrap();
    assert_eq!(model.facts().reals(Fact::Residual), Ok(vec![model.info().residual]));
    assert_eq!(model.facts().ints(Fact::ComponentRows), Ok(vec![300]));

    let denoised = Denoising::of_model(&model, &Options::new()).unwrap();
    assert_eq!(denoised.facts().reals(Fact::Gamma).unwrap().len(), model.info().dimension);
    let dimension = Dimension::estimate(&circle(), &Options::new().neighbors(110)).unwrap();
    assert_eq!(dimension.facts().reals(Fact::Eigenvalue), dimension.eigenvalues());
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn of_a_seam() {
    let clip = walker();
    let cycles = clip.decompose(&Options::new()).unwrap().cycles().to_vec();
    let frames = |cycle: &Interval| cycle.begin..cycle.end - 20;
    let pieces = [&cycles[0], &cycles[2]].map(|cycle| Piece::new(&clip, frames(cycle)));
    let made = Synthesis::new(&pieces, &Options::new().posture_limit(0.0)).unwrap();
    let json = made.json().unwrap();
    let json = after(&json, "seams");
    let Seam {
        frame, piece, next, cut_end, cut_begin, crossfade, posture, step, acceleration, ..
    } = made.seams()[0].clone();
    assert_eq!((piece, next), (0, 1));
    assert_eq!((frame, crossfade), (count(json, "frame"), count(json, "crossfade")));
    assert_eq!((cut_end, cut_begin), (count(json, "cut_end"), count(json, "cut_begin")));
    assert_eq!((posture, step), (real(json, "posture"), real(json, "step")));
    assert_eq!(acceleration, real(json, "acceleration"));
    assert_ne!(cut_end, cut_begin);
    assert_eq!(made.facts().ints(Fact::PieceBegin).unwrap().len(), 2);
    made.clip().save(scratch("joined.bvh")).unwrap();
}
