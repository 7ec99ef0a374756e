// SPDX-License-Identifier: BSD-3-Clause
//! Finds libstltsa with pkg-config, or builds it, and tells Cargo what to link.

use std::env;
use std::path::{Path, PathBuf};
use std::process::{exit, Command};

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-env-changed=DOCS_RS");
    // Documentation builds have no libstltsa and link nothing.
    if env::var_os("DOCS_RS").is_some() {
        return;
    }
    let vendored = env::var_os("CARGO_FEATURE_VENDORED").is_some();
    if vendored {
        // Only this process: its own library is found before an installed one.
        env::set_var("PKG_CONFIG_PATH", search_path(&build_library()));
    }
    let mut config = pkg_config::Config::new();
    config.atleast_version("0.2.0");
    // Otherwise the crate pkg-config reads STLTSA_STATIC and PKG_CONFIG_ALL_STATIC itself.
    if vendored || env::var_os("CARGO_FEATURE_STATIC").is_some() {
        config.statik(true);
    }
    match config.probe("stltsa") {
        // For build scripts of crates that depend on this one: DEP_STLTSA_INCLUDE.
        Ok(library) => {
            if let Ok(paths) = env::join_paths(&library.include_paths) {
                println!("cargo:include={}", paths.to_string_lossy());
            }
        }
        Err(error) => stop(&format!(
            "libstltsa was not found: {error}\n\
             Install it with its header; if it is not in a standard place, set PKG_CONFIG_PATH to \
             the folder that contains stltsa.pc. Or build it with the feature `vendored`."
        )),
    }
}

fn stop(reason: &str) -> ! {
    eprintln!("{reason}");
    exit(1);
}

/// The folder, then those of PKG_CONFIG_PATH.
fn search_path(first: &Path) -> std::ffi::OsString {
    let others = env::var_os("PKG_CONFIG_PATH").unwrap_or_default();
    env::join_paths(std::iter::once(first.to_owned()).chain(env::split_paths(&others)))
        .unwrap_or_else(|error| stop(&format!("{}: {error}", first.display())))
}

fn variable(name: &str) -> String {
    env::var(name).unwrap_or_else(|error| stop(&format!("{name}: {error}")))
}

/// Builds the sources in libstltsa/ as a static library, without CHOLMOD, which is partly GPL, and
/// returns the folder of its stltsa.pc.
fn build_library() -> PathBuf {
    println!("cargo:rerun-if-changed=libstltsa");
    if variable("HOST") != variable("TARGET") {
        stop(
            "The feature `vendored` does not cross-compile: install libstltsa for the target, and let \
             pkg-config find it.",
        );
    }
    let source = Path::new(&variable("CARGO_MANIFEST_DIR")).join("libstltsa");
    let out = PathBuf::from(variable("OUT_DIR"));
    let (build, prefix) = (out.join("build"), out.join("libstltsa"));
    if !build.join("build.ninja").exists() {
        meson(Command::new("meson").arg("setup").arg(&build).arg(source).args([
            "-Dtools=false",
            "-Dtests=false",
            "-Ddocs=false",
            "-Dsparse=ldl",
            "-Ddefault_library=static",
            "-Dbuildtype=release",
            "-Dlibdir=lib",
            &format!("-Dprefix={}", prefix.display()),
        ]));
    }
    meson(Command::new("meson").args(["compile", "-j", &variable("NUM_JOBS"), "-C"]).arg(&build));
    meson(Command::new("meson").args(["install", "--no-rebuild", "--quiet", "-C"]).arg(&build));
    prefix.join("lib").join("pkgconfig")
}

/// Runs Meson. Its output goes to the error stream, because Cargo reads the standard output.
fn meson(command: &mut Command) {
    let output = command.output().unwrap_or_else(|error| {
        stop(&format!(
            "The feature `vendored` needs Meson, Ninja and a C++20 compiler; cannot run meson: {error}"
        ))
    });
    eprint!("{}", String::from_utf8_lossy(&output.stdout));
    eprint!("{}", String::from_utf8_lossy(&output.stderr));
    if !output.status.success() {
        stop(
            "libstltsa was not built; the output of Meson above names the reason. The build needs \
             these Debian packages: \
             g++ meson ninja-build pkg-config libarpack2-dev libfmt-dev liblapacke-dev \
             libopenblas-dev libsuitesparse-dev zlib1g-dev.",
        );
    }
}
