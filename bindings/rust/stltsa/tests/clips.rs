// SPDX-License-Identifier: BSD-3-Clause
//! Clips from arrays, and stretches of clips.

mod common;

use common::{bits, walker, walker_path};
use stltsa::{
    Clip, ErrorKind, Fact, Features, Format, Gaps, Options, Points, Rotations, UnitKind, View,
};

/// Three points that swing with a period of one second, 30 frames a second; one is missing at
/// first.
fn swing() -> Vec<[f64; 6]> {
    (0..240)
        .map(|i| {
            let t = std::f64::consts::TAU * f64::from(i) / 30.0;
            let first = if i < 3 { f64::NAN } else { t.sin() };
            [first, t.cos(), 2.0 * t.cos(), 3.0, 4.0 + t.sin(), 5.0 + t.cos()]
        })
        .collect()
}

fn points(positions: &[[f64; 6]]) -> Points<'_> {
    Points {
        positions: positions.into(),
        space: 2,
        names: &["a", "b", "c"],
        confidence: None,
        times: None,
        fps: Some(30.0),
    }
}

#[test]
fn points_make_a_clip() {
    let positions = swing();
    let mut clip = Clip::from_points(&points(&positions), &Options::new()).unwrap();
    clip.set_path("walk.trc").unwrap();
    assert!(clip.json().unwrap().contains(r#""path":"walk.trc""#));
    assert_eq!(clip.events(), []);
    assert_eq!((clip.format(), clip.frames(), clip.fps()), (Format::Points, 240, Some(30.0)));
    let found = clip.decompose(&Options::new()).unwrap();
    assert!((found.info().real(Fact::Period).unwrap() - 1.0).abs() < 0.05);
    let refused = clip.decompose(&Options::new().gaps(Gaps::Refuse)).unwrap_err();
    assert_eq!(refused.kind(), ErrorKind::NotFinite);
}

#[test]
fn times_and_confidence_of_points() {
    let (positions, times) = (swing(), (0..240).map(|i| [f64::from(i) / 50.0]).collect::<Vec<_>>());
    let confidence = vec![[0.0, 1.0, 1.0]; 240];
    let mut given = points(&positions);
    given.fps = None;
    given.times = Some(View::from(&times));
    given.confidence = Some(View::from(&confidence));
    let clip = Clip::from_points(&given, &Options::new()).unwrap();
    assert!((clip.fps().unwrap() - 50.0).abs() < 1e-9);
    let json = clip.decompose(&Options::new()).unwrap().json().unwrap();
    assert!(json.contains("missing") && json.contains("'a'"), "the first is never there: {json}");
    given.names = &["a"];
    let refused = Clip::from_points(&given, &Options::new()).unwrap_err();
    assert_eq!(refused.kind(), ErrorKind::Shape);
    let unknown = Points { times: None, names: &[], ..given };
    let refused = Clip::from_points(&unknown, &Options::new()).unwrap_err();
    assert_eq!(refused.kind(), ErrorKind::Argument);
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn a_skeleton_through_arrays_is_the_same_motion() {
    let clip = walker();
    let joints = clip.joints();
    let raw = clip.features(&Options::new().features(Features::Raw)).unwrap();
    let fps = clip.fps().unwrap();
    let channels = Rotations::Channels(View::from(&raw));
    let again = Clip::from_skeleton(&joints, channels, None, fps).unwrap();
    assert_eq!((again.format(), again.joints()), (Format::Skeleton, joints.clone()));
    let positions = clip.positions().unwrap();
    assert_eq!(again.positions().unwrap(), positions);
    let curve = |clip: &Clip| clip.decompose(&Options::new()).unwrap().curve();
    assert_eq!(bits(&curve(&again)), bits(&curve(&clip)));

    let root: Vec<[f64; 3]> =
        (0..clip.frames()).map(|i| positions.row(i)[..3].try_into().unwrap()).collect();
    let quaternions = clip.rotations().unwrap();
    let turned = Rotations::Quaternions(View::from(&quaternions));
    let turned = Clip::from_skeleton(&joints, turned, Some(View::from(&root)), fps).unwrap();
    let moved = turned.positions().unwrap();
    let error = (0..clip.frames())
        .flat_map(|i| moved.row(i).iter().zip(positions.row(i)).collect::<Vec<_>>())
        .fold(0.0, |most: f64, (one, other)| most.max((one - other).abs()));
    assert!(error < 1e-9, "{error}");
    let refused =
        Clip::from_skeleton(&joints[1..], Rotations::Channels(View::from(&raw)), None, fps);
    assert_eq!(refused.unwrap_err().kind(), ErrorKind::Argument);
}

#[test]
#[ignore = "needs STLTSA_TEST_CLIP"]
fn a_stretch_has_the_frames_that_are_found() {
    let (clip, options) = (walker(), Options::new());
    let units = clip.decompose(&options).unwrap();
    let cyclic = units.units().into_iter().find(|unit| unit.kind == UnitKind::Cyclic).unwrap();
    assert_eq!(clip.find("cyclic", &options).unwrap(), [cyclic.frames()]);
    assert_eq!(clip.stretch("cyclic", &options).unwrap().frames(), cyclic.frames().len());
    assert_eq!(clip.find("100-300", &options).unwrap(), [100..300]);
    let path = format!("{}:100-300", walker_path().display());
    assert_eq!(Clip::open(path).unwrap().frames(), 200);
    let missing = clip.stretch("Z", &options).unwrap_err();
    assert_eq!(missing.kind(), ErrorKind::NoSuchPart);
}
