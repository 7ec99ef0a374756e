# SPDX-License-Identifier: BSD-3-Clause
"""C, the command and Python get the same bits for the same clip."""

import pathlib
import shutil
import subprocess

import numpy as np
import pytest

import stltsa


@pytest.fixture(scope="module", params=["walker", "35_01.amc", "walk_from_standing_1.bvh"])
def path(request):
    if request.param == "walker":
        return request.getfixturevalue("walker")
    return request.getfixturevalue("real_data") / "cmu" / request.param


@pytest.fixture(scope="module")
def c_program(tmp_path_factory):
    flags = subprocess.run(
        ["pkg-config", "--cflags", "--libs", "stltsa"], capture_output=True, text=True, check=False
    )
    if flags.returncode != 0 or not shutil.which("cc"):
        pytest.skip("no installed libstltsa that pkg-config knows, or no C compiler")
    program = tmp_path_factory.mktemp("c") / "same_bits"
    source = pathlib.Path(__file__).with_name("same_bits.c")
    subprocess.run(["cc", source, *flags.stdout.split(), "-o", program], check=True)
    return program


def test_c(path, c_program):
    done = subprocess.run([c_program, path], capture_output=True, check=True)
    coords = stltsa.fit(stltsa.read_clip(path)).coords
    assert done.stdout == coords.tobytes()


def test_command_coordinates(path, command, tmp_path):
    out = tmp_path / "y.npy"
    subprocess.run([command, "fit", path, "--coords", out], check=True, capture_output=True)
    coords = stltsa.fit(stltsa.read_clip(path)).coords
    written = np.load(out)
    assert written.shape == coords.shape
    assert written.tobytes() == coords.tobytes()


def test_command_decomposition(path, command):
    done = subprocess.run([command, "decompose", path, "--json"], capture_output=True, check=True)
    assert done.stdout.decode().strip() == stltsa.decompose(path).to_json().strip()


def test_command_model_file(path, command, tmp_path):
    out = tmp_path / "walk.stltsa"
    subprocess.run([command, "fit", path, "-o", out], check=True, capture_output=True)
    assert out.read_bytes() == stltsa.fit(stltsa.read_clip(path)).to_bytes()
