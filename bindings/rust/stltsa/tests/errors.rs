// SPDX-License-Identifier: BSD-3-Clause
//! Errors have their kind and the library's text, from the thread of the failure.

mod common;

use common::{circle, circle_model, circle_options};
use stltsa::{has, BuildPart, Clip, Denoising, ErrorKind, Fact, Mode, Model, Options};

#[test]
fn the_words_are_the_librarys() {
    let error = Clip::open("no/such/clip.bvh").unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Io);
    assert!(error.message().contains("no/such/clip.bvh"), "{error}");
    assert_eq!(error.to_string(), error.message());
    assert_eq!(format!("{error:?}"), error.message());
    assert!(format!("{error:#?}").contains("kind: Io"), "{error:#?}");

    let error = Clip::parse(b"HIERARCHY\nnonsense\n", None, &Options::new()).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Format);
    assert!(error.message().contains("nonsense"), "{error}");
}

#[test]
fn each_kind_is_told_from_the_others() {
    let kind = |result: stltsa::Result<Model>| result.unwrap_err().kind();
    let fit = |frames: &[[f64; 4]]| kind(Model::fit(frames, &circle_options()));
    let mut gap = circle();
    gap[7][2] = f64::NAN;
    assert_eq!(fit(&gap), ErrorKind::NotFinite);
    assert_eq!(fit(&circle()[..20]), ErrorKind::TooFewFrames);
    assert_eq!(fit(&[[1.0; 4]; 200]), ErrorKind::Degenerate);
    assert_eq!(kind(Model::parse(b"not a model")), ErrorKind::Format);
    assert_eq!(kind(Model::load("no/such/model", &Options::new())), ErrorKind::Io);
    let several = |lengths: &[usize]| Model::fit_several(&circle(), lengths, &circle_options());
    for lengths in [&[150, 149][..], &[300, 1], &[], &[usize::MAX, 301]] {
        assert_eq!(kind(several(lengths)), ErrorKind::Shape);
    }
    let few = Denoising::new(&circle()[..7], &Options::new()).unwrap_err();
    assert_eq!(few.kind(), ErrorKind::TooFewFrames);
}

#[test]
fn a_model_without_frames_cannot_map() {
    let model = Model::fit(&circle(), &circle_options().keep_frames(false)).unwrap();
    assert_eq!(model.info().real(Fact::Reach), Ok(0.0));
    let error = model.map(&circle(), None, &Options::new()).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Unsupported);
    let poses = circle_model().unmap_clip(&[[0.0, 0.0]], None, &Options::new()).unwrap_err();
    assert_eq!(poses.kind(), ErrorKind::Unsupported);
}

#[test]
fn there_is_a_hint_for_each_row() {
    let (model, frames) = (circle_model(), circle());
    for hints in [vec![None; 299], vec![None; 301], vec![]] {
        let error = model.map(&frames, Some(&hints), &Options::new()).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::Shape);
    }
    let hints = vec![Some(300); 300];
    let error = model.map(&frames, Some(&hints), &Options::new()).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Argument);
}

#[test]
fn a_path_with_a_zero_in_it_is_refused() {
    assert_eq!(Clip::open("walk\0.bvh").unwrap_err().kind(), ErrorKind::Argument);
    let options = Options::new().skeleton("35\0.asf");
    assert_eq!(Clip::open_with("walk.bvh", &options).unwrap_err().kind(), ErrorKind::Argument);
}

#[test]
fn each_thread_has_its_own_words() {
    let fail = |name: String| Clip::open(&name).unwrap_err().message().contains(&name);
    std::thread::scope(|scope| {
        for t in 0..4 {
            scope.spawn(move || assert!((0..200).all(|i| fail(format!("absent-{t}-{i}.bvh")))));
        }
    });
}

#[test]
fn every_build_has_all_modes() {
    Model::fit(&circle(), &circle_options().mode(Mode::Spatial)).unwrap();
    assert!(!has(BuildPart::Other(12345)));
}
