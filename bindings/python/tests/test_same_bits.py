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


def test_command_tells_the_same(path, command):
    """The JSON of every kind of result is the same, to the last digit."""
    clip = stltsa.read_clip(path)
    results = {
        "info": clip,
        "fit": stltsa.fit(clip),
        "dimension": stltsa.dimension(clip).model,
        "decompose": stltsa.decompose(clip),
        "denoise": stltsa.denoise(stltsa.fit(clip)),
    }
    for name, result in results.items():
        done = subprocess.run([command, name, path, "--json"], capture_output=True, check=True)
        assert done.stdout.decode().strip() == result.to_json(), name


def test_command_maps_and_makes_the_same(path, command, tmp_path):
    def run(*arguments):
        subprocess.run([command, *arguments], check=True, capture_output=True)

    clip, model, coords = stltsa.read_clip(path), tmp_path / "m.stltsa", tmp_path / "y.npy"
    fitted = stltsa.fit(clip)
    fitted.save(model)
    mapped = fitted.map(clip).values
    run("map", model, path, "-o", coords)
    assert np.load(coords).tobytes() == mapped.tobytes()

    run("unmap", model, coords, "-o", tmp_path / "theirs.npy")
    assert np.load(tmp_path / "theirs.npy").tobytes() == fitted.unmap(mapped).values.tobytes()

    run("denoise", path, "-o", tmp_path / "cleaned.npy")
    cleaned = stltsa.denoise(fitted).cleaned
    assert np.load(tmp_path / "cleaned.npy").tobytes() == cleaned.tobytes()

    kind = f".{clip.format}"
    run("synthesize", f"{path}:best*3", "-o", tmp_path / f"theirs{kind}")
    best = stltsa.decompose(clip).best_cycle
    stltsa.synthesize([stltsa.Piece.of(clip, best, repeat=3)]).clip.save(tmp_path / f"ours{kind}")
    assert (tmp_path / f"theirs{kind}").read_bytes() == (tmp_path / f"ours{kind}").read_bytes()


def test_command_coordinates(path, command, tmp_path):
    out = tmp_path / "y.npy"
    subprocess.run([command, "fit", path, "--coords", out], check=True, capture_output=True)
    coords = stltsa.fit(stltsa.read_clip(path)).coords
    written = np.load(out)
    assert written.shape == coords.shape
    assert written.tobytes() == coords.tobytes()


def test_command_model_file(path, command, tmp_path):
    out = tmp_path / "walk.stltsa"
    subprocess.run([command, "fit", path, "-o", out], check=True, capture_output=True)
    model = stltsa.fit(stltsa.read_clip(path))
    result = stltsa.decompose(path)
    if result.cycle_list:  # the command keeps them for streams
        model.keep_cycle(result.phase())
    assert out.read_bytes() == model.to_bytes()
