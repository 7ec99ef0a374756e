// SPDX-License-Identifier: BSD-3-Clause
//! Values of constants, sizes of structs and offsets of fields: as a C compiler sees them, and as
//! the Rust compiler does.

use std::collections::BTreeMap;
use std::mem::{align_of, size_of, MaybeUninit};
use std::path::Path;
use std::process::Command;
use std::ptr::addr_of;

use stltsa_sys::*;

use crate::parse::{Header, Type};
use crate::pkg_config;

/// A program that prints a line "NAME NUMBER" for each.
fn program(header: &Header) -> String {
    let mut lines = Vec::new();
    let mut print = |name: &str, value: &str| {
        lines.push(format!("    printf(\"{name} %lld\\n\", (long long)({value}));\n"));
    };
    for name in &header.constants {
        print(name, name);
    }
    for (name, kind) in &header.types {
        let fields = match kind {
            Type::Struct(fields) => fields,
            _ => continue,
        };
        print(&format!("{name} size"), &format!("sizeof({name})"));
        print(&format!("{name} alignment"), &format!("_Alignof({name})"));
        for (field, _) in fields {
            print(&format!("{name}.{field}"), &format!("offsetof({name}, {field})"));
        }
    }
    let lines = lines.concat();
    format!(
        "#include <stdio.h>\n#include <stltsa.h>\nint main(void) {{\n{lines}    return 0;\n}}\n"
    )
}

fn run(command: &mut Command) -> String {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    assert!(output.status.success(), "{command:?}: {output:?}");
    String::from_utf8(output.stdout).expect("UTF-8")
}

pub fn of_c(header: &Header) -> BTreeMap<String, i64> {
    let scratch = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let (source, binary) = (scratch.join("layout.c"), scratch.join("layout"));
    std::fs::write(&source, program(header)).expect("the program is written");
    let compiler = std::env::var_os("CC").unwrap_or_else(|| "cc".into());
    let flags = pkg_config("--cflags");
    run(Command::new(compiler)
        .args(["-std=c11", "-o"])
        .args([&binary, &source])
        .args(flags.split_whitespace()));
    let numbers = run(&mut Command::new(binary));
    let named = |line: &str| {
        let (name, value) = line.rsplit_once(' ').expect("a name and a number");
        (name.to_owned(), value.parse().expect("a number"))
    };
    numbers.lines().map(named).collect()
}

macro_rules! layout {
    ($($name:ident { $($field:ident)* })*) => {{
        let mut numbers = BTreeMap::new();
        $(
            let name = stringify!($name);
            numbers.insert(format!("{name} size"), size_of::<$name>() as i64);
            numbers.insert(format!("{name} alignment"), align_of::<$name>() as i64);
            let place = MaybeUninit::<$name>::uninit();
            let start = place.as_ptr();
            $(
                // SAFETY: the address of a field inside `place`; nothing is read.
                let field = unsafe { addr_of!((*start).$field) };
                let offset = field as usize - start as usize;
                let field = stringify!($field).trim_start_matches("r#");
                numbers.insert(format!("{name}.{field}"), offset as i64);
            )*
        )*
        numbers
    }};
}

pub fn of_rust() -> BTreeMap<String, i64> {
    layout! {
        stltsa_in { data rows cols row_stride col_stride dtype reserved }
        stltsa_out { data rows cols row_stride col_stride dtype reserved }
        stltsa_option_info { size key r#type name text choices minimum maximum standard }
        stltsa_interval { begin end begin_s end_s kind reserved }
        stltsa_piece { clip begin end repeat reserved }
        stltsa_seam {
            size frame piece next cut_end cut_begin crossfade posture step acceleration
        }
    }
}
