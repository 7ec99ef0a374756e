# SPDX-License-Identifier: BSD-3-Clause
"""A synthetic walk for all tests; its generator is built with the library.

The environment gives the programs: STLTSA_WALKER, the generator, and STLTSA_COMMAND, the command
`stltsa`. Real clips are read from STLTSA_DATA, by default next to the repository.
"""

import os
import pathlib
import subprocess

import numpy as np
import pytest

import stltsa

ROOT = pathlib.Path(__file__).resolve().parents[3]


def program(variable, default):
    path = pathlib.Path(os.environ.get(variable, ROOT / "build" / default))
    if not path.exists():
        pytest.skip(f"{path} is not there: build the library, or set {variable}")
    return path


@pytest.fixture(scope="session")
def command():
    return program("STLTSA_COMMAND", "tools/stltsa")


@pytest.fixture(scope="session")
def walker(tmp_path_factory):
    """Path of a walk with known units and cycles."""
    path = tmp_path_factory.mktemp("clips") / "walker.bvh"
    generator = program("STLTSA_WALKER", "tests/walker/stltsa-walker")
    subprocess.run([generator, "--output", path], check=True)
    return path


@pytest.fixture(scope="session")
def clip(walker):
    return stltsa.read_clip(walker)


@pytest.fixture(scope="session")
def result(clip):
    return stltsa.decompose(clip)


@pytest.fixture(scope="session")
def model(clip):
    return stltsa.fit(clip)


@pytest.fixture(scope="session")
def circle():
    """Three turns of a circle in five dimensions, 300 frames, with a little noise."""
    t = np.linspace(0, 6 * np.pi, 300)
    random = np.random.default_rng(7)
    plane = np.column_stack([np.cos(t), np.sin(t)])
    return plane @ random.normal(size=(2, 5)) + random.normal(scale=1e-3, size=(300, 5))


@pytest.fixture(scope="session")
def real_data():
    path = pathlib.Path(os.environ.get("STLTSA_DATA", ROOT.parent / "shared" / "data"))
    if not path.exists():
        pytest.skip(f"real clips are not in {path}")
    return path
