// SPDX-License-Identifier: BSD-3-Clause
//! Finds libstltsa with pkg-config and tells Cargo what to link.

use std::env;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-env-changed=DOCS_RS");
    // Documentation builds have no libstltsa and link nothing.
    if env::var_os("DOCS_RS").is_some() {
        return;
    }
    let mut config = pkg_config::Config::new();
    config.atleast_version("0.1.0");
    // Otherwise the crate pkg-config reads STLTSA_STATIC and PKG_CONFIG_ALL_STATIC itself.
    if env::var_os("CARGO_FEATURE_STATIC").is_some() {
        config.statik(true);
    }
    match config.probe("stltsa") {
        // For build scripts of crates that depend on this one: DEP_STLTSA_INCLUDE.
        Ok(library) => {
            if let Ok(paths) = env::join_paths(&library.include_paths) {
                println!("cargo:include={}", paths.to_string_lossy());
            }
        }
        Err(error) => {
            eprintln!("libstltsa is not found: {error}");
            eprintln!(
                "Install it with its header; if it is in a place of its own, set PKG_CONFIG_PATH \
                 to the folder that holds stltsa.pc."
            );
            std::process::exit(1);
        }
    }
}
