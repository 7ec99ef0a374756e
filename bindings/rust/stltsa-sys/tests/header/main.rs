// SPDX-License-Identifier: BSD-3-Clause
//! Holds the declarations of this crate against the header that is installed: every function with
//! the names and types of its parameters, every constant, every struct and its layout. What either
//! side has and the other lacks is an error.

mod layout;
mod parse;

use std::collections::BTreeMap;
use std::fmt::Debug;
use std::path::PathBuf;
use std::process::Command;

/// Output of pkg-config, which the build script has asked before.
fn pkg_config(argument: &str) -> String {
    let output =
        Command::new("pkg-config").args([argument, "stltsa"]).output().expect("pkg-config runs");
    assert!(output.status.success(), "{output:?}");
    String::from_utf8(output.stdout).expect("UTF-8").trim().to_owned()
}

fn header() -> parse::Header {
    let path = PathBuf::from(pkg_config("--variable=includedir")).join("stltsa.h");
    parse::header(&std::fs::read_to_string(path).expect("stltsa.h is read"))
}

/// Fails with a line for each name that is not the same on both sides.
fn assert_same<T: PartialEq + Debug>(header: &BTreeMap<String, T>, here: &BTreeMap<String, T>) {
    assert!(!header.is_empty(), "nothing was found in the header");
    let mut complaints = Vec::new();
    for (name, wanted) in header {
        match here.get(name) {
            Some(found) if found == wanted => {}
            found => complaints.push(format!("{name}\n  header {wanted:?}\n  here   {found:?}")),
        }
    }
    for name in here.keys().filter(|name| !header.contains_key(*name)) {
        complaints.push(format!("{name}: not in the header"));
    }
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

#[test]
fn functions_are_those_of_the_header() {
    let here = parse::rust_functions(include_str!("../../src/functions.rs"));
    assert_same(&header().functions, &here);
}

#[test]
fn types_are_those_of_the_header() {
    let here = parse::rust_types(include_str!("../../src/types.rs"));
    assert_same(&header().types, &here);
}

#[test]
fn constants_and_layouts_are_those_that_a_c_compiler_sees() {
    let header = header();
    let mut here = parse::rust_constants(include_str!("../../src/constants.rs"));
    here.extend(layout::of_rust());
    assert_same(&layout::of_c(&header), &here);
}
