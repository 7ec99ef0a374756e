// SPDX-License-Identifier: BSD-3-Clause
//! The command `stltsa` and this crate give the same bits for the same clip.

mod common;

use std::path::Path;
use std::process::Command;

use common::{after, bits, scratch, walker, walker_path};
use stltsa::{Denoising, Matrix, Model, Options, Piece, Synthesis};

/// Standard output of the command.
fn stltsa(arguments: &[&str]) -> String {
    let command = std::env::var_os("STLTSA_COMMAND").expect("STLTSA_COMMAND names the command");
    let output = Command::new(command).args(arguments).output().expect("the command runs");
    assert!(output.status.success(), "{output:?}");
    String::from_utf8(output.stdout).expect("UTF-8")
}

fn text(path: &Path) -> &str {
    path.to_str().expect("UTF-8")
}

/// The text after `"key":[` up to the matching `]`.
fn list<'a>(json: &'a str, key: &str) -> &'a str {
    let inside = after(json, key).strip_prefix('[').expect("a list");
    let mut depth = 1;
    let ends = |c: char| {
        depth += i32::from(c == '[') - i32::from(c == ']');
        depth == 0
    };
    &inside[..inside.find(ends).expect("the list ends")]
}

/// Every number of a list, including nested lists.
fn numbers(json: &str, key: &str) -> Vec<f64> {
    let words = list(json, key).split(|c| "[],".contains(c));
    words.filter(|word| !word.is_empty()).map(|word| word.parse().expect("a number")).collect()
}

/// The intervals of a list in the command's format.
fn intervals(json: &str, key: &str) -> Vec<(Option<String>, usize, usize, u64, u64)> {
    let of_object = |object: &str| {
        let value = |name: &str| {
            let mut pairs = object.split(',').filter_map(|pair| pair.split_once(':'));
            pairs.find(|pair| pair.0.trim_matches('"') == name).map(|pair| pair.1)
        };
        let frame = |name| value(name).expect("a frame").parse().expect("a number");
        let second =
            |name| value(name).expect("a time").parse::<f64>().expect("a number").to_bits();
        let kind = value("kind").map(|kind| kind.trim_matches('"').to_owned());
        (kind, frame("begin"), frame("end"), second("begin_s"), second("end_s"))
    };
    list(json, key)
        .split("},{")
        .map(|object| of_object(object.trim_matches(&['{', '}'][..])))
        .collect()
}

/// The entries of a packed float64 NPY file.
fn npy(path: &Path) -> Matrix {
    let bytes = std::fs::read(path).expect("the file is read");
    assert_eq!(bytes[..8], *b"\x93NUMPY\x01\x00");
    let (header, data) =
        bytes[10..].split_at(usize::from(u16::from_le_bytes([bytes[8], bytes[9]])));
    let header = std::str::from_utf8(header).expect("ASCII");
    assert!(header.contains("'<f8'") && header.contains("'fortran_order': False"), "{header}");
    let (_, shape) = header.split_once("'shape': (").expect("a shape");
    let sides = shape.split(')').next().expect("a shape").split(',').map(str::trim);
    let sides: Vec<usize> =
        sides.filter(|side| !side.is_empty()).map(|side| side.parse().expect("a side")).collect();
    let number = |eight: &[u8]| f64::from_le_bytes(eight.try_into().expect("eight bytes"));
    let data = data.chunks_exact(8).map(number).collect();
    Matrix::from_vec(data, sides[0], sides.get(1).copied().unwrap_or(1)).expect("as many entries")
}

fn assert_same_bits(ours: &Matrix, theirs: &Matrix) {
    assert_eq!((ours.rows(), ours.cols()), (theirs.rows(), theirs.cols()));
    assert!(ours.as_slice().iter().any(|number| *number != 0.0));
    assert_eq!(bits(ours.as_slice()), bits(theirs.as_slice()));
}

#[test]
#[ignore = "needs STLTSA_COMMAND and STLTSA_TEST_CLIP"]
fn units_cycles_and_curve_are_the_same() {
    let path = walker_path();
    let json = stltsa(&["decompose", text(&path), "--json", "--curve"]);
    let ours = walker().decompose(&Options::new()).unwrap();
    let theirs = intervals(&json, "units");
    assert_eq!(theirs.len(), ours.units().len());
    for (unit, (kind, begin, end, begin_s, end_s)) in ours.units().iter().zip(theirs) {
        assert_eq!(kind.unwrap(), unit.kind.to_string());
        assert_eq!(unit.frames(), begin..end);
        assert_eq!((unit.begin_s.to_bits(), unit.end_s.to_bits()), (begin_s, end_s));
    }
    let theirs = intervals(&json, "cycles");
    assert_eq!(theirs.len(), ours.cycles().len());
    for (cycle, (_, begin, end, begin_s, end_s)) in ours.cycles().iter().zip(theirs) {
        assert_eq!(cycle.frames(), begin..end);
        assert_eq!((cycle.begin_s.to_bits(), cycle.end_s.to_bits()), (begin_s, end_s));
    }
    let curve = after(&json, "curve");
    assert_eq!(bits(&ours.curve()), bits(&numbers(curve, "values")));
    let coords = ours.coords();
    assert_eq!((coords.rows(), coords.cols()), (ours.curve().len(), 2));
    assert_eq!(bits(coords.as_slice()), bits(&numbers(curve, "loop")));
}

#[test]
#[ignore = "needs STLTSA_COMMAND and STLTSA_TEST_CLIP"]
fn the_json_is_the_same_text() {
    let path = walker_path();
    let clip = walker();
    let ours = clip.decompose(&Options::new()).unwrap().json().unwrap();
    assert_eq!(stltsa(&["decompose", text(&path), "--json"]).trim_end(), ours);
    assert_eq!(stltsa(&["info", text(&path), "--json"]).trim_end(), clip.json().unwrap());
    let model = Model::fit_clip(&clip, &Options::new()).unwrap();
    assert_eq!(stltsa(&["fit", text(&path), "--json"]).trim_end(), model.json().unwrap());
    let ours = Denoising::of_model(&model, &Options::new()).unwrap().json().unwrap();
    assert_eq!(stltsa(&["denoise", text(&path), "--json"]).trim_end(), ours);
}

#[test]
#[ignore = "needs STLTSA_COMMAND and STLTSA_TEST_CLIP"]
fn coordinates_models_and_mappings_are_the_same() {
    let path = walker_path();
    let (clip, options) = (walker(), Options::new().dimension(3));
    let (coords, saved) = (scratch("fit.npy"), scratch("fit.stltsa"));
    stltsa(&[
        "fit",
        text(&path),
        "--dimension",
        "3",
        "--coords",
        text(&coords),
        "-o",
        text(&saved),
    ]);
    let model = Model::fit_clip(&clip, &options).unwrap();
    assert_same_bits(&model.coords(), &npy(&coords));
    // The command also keeps a mean cycle.
    let loaded = Model::load(&saved, &Options::new()).unwrap();
    assert_same_bits(&model.coords(), &loaded.coords());

    let (mapped, poses) = (scratch("map.npy"), scratch("poses.bvh"));
    stltsa(&["map", text(&saved), text(&path), "-o", text(&mapped)]);
    assert_same_bits(&model.map_clip(&clip, &Options::new()).unwrap().coords, &npy(&mapped));

    stltsa(&["unmap", text(&saved), text(&coords), "-o", text(&poses)]);
    let ours = scratch("poses-of-rust.bvh");
    let unmapped = model.unmap_clip(&model.coords(), None, &Options::new()).unwrap();
    unmapped.clip.save(&ours).unwrap();
    assert_eq!(std::fs::read(&ours).unwrap(), std::fs::read(&poses).unwrap());
}

#[test]
#[ignore = "needs STLTSA_COMMAND and STLTSA_TEST_CLIP"]
fn cleaned_curves_and_new_motion_are_the_same() {
    let path = walker_path();
    let clip = walker();
    let (coords, cleaned, curve) =
        (scratch("noisy.npy"), scratch("cleaned.npy"), scratch("curve.npy"));
    stltsa(&["fit", text(&path), "--coords", text(&coords)]);
    let arguments =
        ["denoise", text(&coords), "--coordinates", "--fps", "30", "-o", text(&cleaned)];
    stltsa(&[&arguments[..], &["--curve-out", text(&curve)]].concat());
    let ours = Denoising::new(&npy(&coords), &Options::new().fps(30.0)).unwrap();
    assert_same_bits(&ours.cleaned(), &npy(&cleaned));
    assert_same_bits(&ours.curve(), &npy(&curve));

    let theirs = scratch("loop-of-command.bvh");
    stltsa(&["synthesize", &format!("{}:best*3", text(&path)), "-o", text(&theirs)]);
    let best = clip.decompose(&Options::new()).unwrap().best().unwrap();
    let pieces = [Piece::new(&clip, best.frames()).repeat(3)];
    let ours = scratch("loop-of-rust.bvh");
    Synthesis::new(&pieces, &Options::new()).unwrap().clip().save(&ours).unwrap();
    assert_eq!(std::fs::read(&ours).unwrap(), std::fs::read(&theirs).unwrap());
}
