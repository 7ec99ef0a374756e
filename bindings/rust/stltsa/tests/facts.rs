// SPDX-License-Identifier: BSD-3-Clause
//! The fields of a result agree with its JSON; distinct values reveal a mix-up.

mod common;

use common::{after, circle, scratch, value, walker};
use stltsa::{
    Clip, ErrorKind, Fact, Joint, Mode, Model, Options, Part, Piece, PieceFact, Seam, Synthesis,
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
    for (key, value) in [
        (Fact::Rows, 300),
        (Fact::Neighbors, 110),
        (Fact::Window, 130),
        (Fact::Dimension, 3),
        (Fact::Links, 5),
        (Fact::Exclusion, 140),
        (Fact::IncludeSelf, 0),
        (Fact::FeatureCount, count(&json, "feature_count") as i64),
        (Fact::Repeated, 1),
    ] {
        assert_eq!(info.int(key), Ok(value), "{key:?}");
    }
    assert_eq!(info.int(Fact::Mode).map(Mode::from), Ok(Mode::Recurrent));
    assert_eq!(info.real(Fact::TimeCorrelation), Ok(real(&json, "time_correlation")));
    assert_eq!(info.real(Fact::Fps), Ok(50.0));
    let (components, json) = (model.components(), after(&json, "components"));
    assert_eq!(components.len(), model.eigenvalues().rows());
    let component = components[0];
    assert_eq!(component.frames, count(json, "frames"));
    assert_eq!(component.residual, real(json, "residual"));
    assert_eq!(component.error_estimate_rad, real(json, "error_estimate_rad"));
    assert_eq!(component.gap, real(json, "gap"));
    assert_eq!(component.rank_deficient_windows, count(json, "rank_deficient_windows"));
    assert_eq!(component.solves, count(json, "solves"));
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
    let int = |key| info.int(key).unwrap() as usize;
    assert_eq!(int(Fact::Rows), count(samples, "count"));
    assert_eq!(int(Fact::FirstFrame), count(samples, "first_frame"));
    assert_eq!((int(Fact::FrameStep), info.real(Fact::Fps)), (2, Ok(30.0)));
    assert_eq!(int(Fact::Neighbors), count(parameters, "neighbors"));
    assert_eq!(int(Fact::Window), count(parameters, "window"));
    assert_eq!(int(Fact::Dimension), count(&json, "tangent_dimension"));
    assert_eq!(int(Fact::Coordinate), count(&json, "coordinate"));
    assert_eq!(info.real(Fact::Period), Ok(real(&json, "period_s")));
    assert_eq!(info.real(Fact::Cyclicity), Ok(real(&json, "cyclicity")));
    assert_eq!(info.real(Fact::LagQuality), Ok(real(&json, "lag_quality")));

    let (first, best) = (found.representative().unwrap(), found.best().unwrap());
    let begins = |key| real(after(&json, key), "begin_s");
    assert_ne!(first, best);
    assert_eq!(first.begin_s, begins("representative_cycle"));
    assert_eq!(best.begin_s, begins("best_cycle"));
}

#[test]
fn by_key() {
    let clip = swings();
    let info = clip.info();
    assert_eq!((info.real(Fact::ClipFps), info.reals(Fact::ClipFps)), (Ok(60.0), Ok(vec![60.0])));
    assert_eq!((info.int(Fact::ClipFrames), info.ints(Fact::ClipFrames)), (Ok(831), Ok(vec![831])));
    assert_eq!(info.text(Fact::Path), Ok(String::new()));
    assert_eq!(info.texts(Fact::Path), Ok(vec![String::new()]));
    assert_eq!(info.ints(Fact::Neighbors), Ok(vec![]), "a clip has no neighbors");
    assert_eq!(info.rows::<Joint>(Fact::Joint), Ok(vec![]), "nor a skeleton");
    assert_eq!((info.count(Fact::Joint), info.count(Fact::ClipFps)), (0, 1));
    for error in [
        info.real(Fact::ClipFrames).unwrap_err(),
        info.int(Fact::Neighbors).unwrap_err(),
        info.shape(Fact::Positions).unwrap_err(),
        info.rows::<Part>(Fact::Joint).unwrap_err(),
    ] {
        assert_eq!(error.kind(), ErrorKind::Argument, "{error}");
    }

    let found = clip.decompose(&Options::new()).unwrap();
    let info = found.info();
    assert_eq!(info.rows::<Part>(Fact::Cycle), Ok(found.cycles()));
    assert_eq!(info.count(Fact::Cycle), found.cycles().len());
    assert_eq!((info.shape(Fact::Coords), info.count(Fact::Coords)), (Ok((416, 2)), 1));
    assert_eq!(info.array(Fact::Coords, 0).as_ref(), Ok(&found.coords()));
    assert_eq!(info.array(Fact::Coords, 1).unwrap_err().kind(), ErrorKind::Argument);
    let travels = |part: &Part| part.path_length.is_some() || part.turn_deg.is_some();
    assert!(!found.cycles().iter().any(travels), "unknown of a matrix of bare numbers");
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn of_a_seam() {
    let clip = walker();
    let cycles = clip.decompose(&Options::new()).unwrap().cycles();
    let frames = |cycle: &Part| cycle.begin..cycle.end - 20;
    let pieces = [&cycles[0], &cycles[2]].map(|cycle| Piece::new(&clip, frames(cycle)));
    let made = Synthesis::new(&pieces, &Options::new().posture_limit(0.0)).unwrap();
    let json = made.json().unwrap();
    let json = after(&json, "seams");
    let Seam {
        frame, piece, next, cut_end, cut_begin, crossfade, posture, step, acceleration, ..
    } = made.seams()[0];
    assert_eq!((piece, next), (0, 1));
    assert_eq!((frame, crossfade), (count(json, "frame"), count(json, "crossfade")));
    assert_eq!((cut_end, cut_begin), (count(json, "cut_end"), count(json, "cut_begin")));
    assert_eq!((posture, step), (real(json, "posture"), real(json, "step")));
    assert_eq!(acceleration, real(json, "acceleration"));
    assert_ne!(cut_end, cut_begin);
    let made_of = made.info().rows::<PieceFact>(Fact::Piece).unwrap();
    assert_eq!((made_of.len(), made_of[1].frames()), (2, frames(&cycles[2])));
    made.clip().save(scratch("joined.bvh")).unwrap();
}
