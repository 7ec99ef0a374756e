#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that every place that states the version agrees with meson.build, and that the lists of
functions agree: header, version script, Debian's symbols file, declarations for Rust, and CHANGELOG.md,
which names each function below the version that added it, unless that is the first.

Addresses must be those of packaging/metadata.

Usage: tests/checks/versions.py
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SYMBOLS = "packaging/debian/libstltsa0.symbols"

# Each file, and the expression that finds the version in it.
VERSIONS = [
    ("bindings/python/meson.build", r"^  version: '([^']+)'"),
    ("bindings/rust/stltsa-sys/Cargo.toml", r'^version = "([^"]+)"'),
    ("bindings/rust/stltsa/Cargo.toml", r'^version = "([^"]+)"'),
    ("bindings/rust/stltsa/Cargo.toml", r'^stltsa-sys = \{ version = "([^"]+)"'),
    ("bindings/rust/Cargo.lock", r'^name = "stltsa"\nversion = "([^"]+)"'),
    ("bindings/rust/Cargo.lock", r'^name = "stltsa-sys"\nversion = "([^"]+)"'),
    ("CITATION.cff", r"^version: (\S+)"),
    ("packaging/debian/changelog", r"\Alibstltsa \((.+)-\d+\)"),
]

# The same for the addresses of packaging/metadata.
ADDRESSES = [
    ("bindings/python/pyproject.toml", r'^Homepage = "([^"]+)"', "HOMEPAGE"),
    ("bindings/python/pyproject.toml", r'^Source = "([^"]+)"', "REPOSITORY"),
    ("bindings/python/pyproject.toml", r'^Issues = "([^"]+)"', "BUGS"),
    ("bindings/rust/stltsa-sys/Cargo.toml", r'^homepage = "([^"]+)"', "HOMEPAGE"),
    ("bindings/rust/stltsa-sys/Cargo.toml", r'^repository = "([^"]+)"', "REPOSITORY"),
    ("bindings/rust/stltsa/Cargo.toml", r'^homepage = "([^"]+)"', "HOMEPAGE"),
    ("bindings/rust/stltsa/Cargo.toml", r'^repository = "([^"]+)"', "REPOSITORY"),
    ("CITATION.cff", r'^url: "([^"]+)"', "HOMEPAGE"),
    ("CITATION.cff", r'^repository-code: "([^"]+)"', "REPOSITORY"),
]


def read(name):
    return (ROOT / name).read_text(encoding="utf-8")


def found(name, pattern, text=None):
    match = re.search(pattern, read(name) if text is None else text, re.MULTILINE)
    return match[1] if match else "none"


def header_version():
    text = read("include/stltsa.h")
    parts = [found("", rf"define STLTSA_VERSION_{part} (\d+)", text)
             for part in ("MAJOR", "MINOR", "PATCH")]
    return ".".join(parts)


def declared():
    """Return the functions of the header."""
    text = re.sub(r"/\*.*?\*/", "", read("include/stltsa.h"), flags=re.DOTALL)
    return set(re.findall(r"STLTSA_API\b[^;(]*?\b(stltsa_\w+)\s*\(", text))


def added_by_version():
    """Return the functions of each version, according to the symbols file."""
    added = {}
    for name, version in re.findall(r"^ (stltsa_\w+)@STLTSA_[\d.]+ (\S+)$", read(SYMBOLS), re.MULTILINE):
        added.setdefault(version, set()).add(name)
    return added


def sections():
    """Return the text of CHANGELOG.md by version; the next release is under Unreleased."""
    parts = re.split(r"^## \[([^\]]+)\].*$", read("CHANGELOG.md"), flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2]))


def version_complaints(version):
    places = [(name, found(name, pattern)) for name, pattern in VERSIONS]
    places.append(("include/stltsa.h", header_version()))
    return [f"{name} says {said}, meson.build {version}" for name, said in places if said != version]


def address_complaints():
    for name, pattern, key in ADDRESSES:
        said, wanted = found(name, pattern), found("packaging/metadata", rf"^{key}=(.+)$")
        if said != wanted:
            yield f"{name} says {said}, packaging/metadata {wanted} ({key})"


def list_complaints():
    header = declared()
    lists = {
        "src/capi/stltsa.map": set(re.findall(r"^\s+(stltsa_\w+);", read("src/capi/stltsa.map"),
                                              re.MULTILINE)),
        SYMBOLS: set().union(*added_by_version().values()),
        "bindings/rust/stltsa-sys/src/declarations.rs": set(
            re.findall(r"\bpub fn (stltsa_\w+)", read("bindings/rust/stltsa-sys/src/declarations.rs"))),
    }
    for name, functions in lists.items():
        for missing in sorted(header - functions):
            yield f"{name} lacks {missing}"
        for foreign in sorted(functions - header):
            yield f"{name} has {foreign}, which is not in include/stltsa.h"


def changelog_complaints(version):
    texts = sections()
    by_version = added_by_version()
    for added in sorted(by_version, key=lambda v: [int(part) for part in v.split(".")])[1:]:
        functions = by_version[added]
        text = texts.get(added, texts.get("Unreleased", "") if added == version else "")
        named = set(re.findall(r"\bstltsa_\w+", text))
        for missing in sorted(functions - named):
            yield f"CHANGELOG.md does not name {missing}, new in {added}"


def main():
    version = found("meson.build", r"^  version: '([^']+)'")
    complaints = [*version_complaints(version), *address_complaints(), *list_complaints(),
                  *changelog_complaints(version)]
    for text in complaints:
        print(text, file=sys.stderr)
    if not complaints:
        print(f"{version} everywhere; {len(declared())} functions in every list")
    return int(bool(complaints))


if __name__ == "__main__":
    sys.exit(main())
