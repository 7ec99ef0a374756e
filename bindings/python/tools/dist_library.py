#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Replaces the symbolic link to this repository by its source in a source distribution.

Meson runs this when it makes a source distribution, so that the distribution builds on its own.
"""

import os
import pathlib
import shutil

PARTS = (
    "CHANGELOG.md",
    "LICENSE",
    "README.md",
    "docs/man",
    "docs/schema",
    "include",
    "measure",
    "meson.build",
    "meson_options.txt",
    "packaging/metadata",
    "pkgconfig",
    "src",
    "tools",
)


def main() -> None:
    source = pathlib.Path(os.environ["MESON_PROJECT_SOURCE_ROOT"]) / "subprojects" / "stltsa"
    target = pathlib.Path(os.environ["MESON_PROJECT_DIST_ROOT"]) / "subprojects" / "stltsa"
    if target.is_symlink():
        target.unlink()
    target.mkdir(parents=True, exist_ok=True)
    for name in PARTS:
        part = source / name
        (target / name).parent.mkdir(parents=True, exist_ok=True)
        if part.is_dir():
            shutil.copytree(part, target / name, dirs_exist_ok=True)
        else:
            shutil.copy2(part, target / name)


if __name__ == "__main__":
    main()
