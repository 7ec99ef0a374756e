# SPDX-License-Identifier: BSD-3-Clause
"""The binding has the header's declarations and the library's names."""

import pathlib
import re
import typing

import numpy as np
import pytest

import stltsa
from stltsa import errors
from stltsa._native import lib

ROOT = pathlib.Path(__file__).resolve().parents[3]


@pytest.fixture(scope="module")
def header():
    path = ROOT / "include" / "stltsa.h"
    if not path.exists():
        pytest.skip(f"{path} is not there")
    return re.sub(r"/\*.*?\*/", "", path.read_text(), flags=re.DOTALL)


def test_every_function_and_constant_is_bound(header):
    functions = set(re.findall(r"STLTSA_API\b[^;(]*?\b(stltsa_\w+)\s*\(", header))
    constants = set(re.findall(r"\b(STLTSA_[A-Z0-9_]+)\s*=", header))
    assert len(functions) > 80
    assert len(constants) > 100
    assert functions | constants <= set(dir(lib))


def test_version_is_the_library_s():
    for build in (ROOT / "meson.build", ROOT / "bindings" / "python" / "meson.build"):
        assert f"version: '{stltsa.__version__}'" in build.read_text()


def test_every_build_has_all_modes(circle):
    for mode in ("temporal", "spatial", "recurrent"):
        stltsa.fit(circle, mode=mode, neighbors=12)
    with pytest.raises(ValueError, match="cholmod"):
        stltsa.has("cholmods")


def test_keywords_are_the_table():
    table = {option.name for option in stltsa.options()}
    assert set(stltsa.Options.__annotations__) == table | {"progress"}


def test_choices_are_the_table():
    hints = typing.get_type_hints(stltsa.Options)
    for option in stltsa.options():
        if option.choices:
            hint = hints[option.name]
            if option.default is None:  # names | "auto" | None
                hint, auto, none = typing.get_args(hint)
                assert (typing.get_args(auto), none) == (("auto",), type(None))
            assert set(typing.get_args(hint)) == set(option.choices)


def test_what_the_library_chooses_is_none_or_auto():
    automatic = {option.name for option in stltsa.options() if option.default is None}
    assert automatic > {"neighbors", "features", "skeleton", "gamma"}
    frames = np.random.default_rng(0).random((60, 3)).cumsum(axis=0)
    default = stltsa.fit(frames).coords
    for value in (None, "auto"):
        options = dict.fromkeys(automatic, value)
        assert np.array_equal(stltsa.fit(frames, **options).coords, default)
    with pytest.raises(ValueError, match="smoothing is 'auto', and must be a number"):
        stltsa.fit(frames, smoothing="auto")


def test_each_status_has_a_class():
    names = {n for n in dir(lib) if n.startswith("STLTSA_E_")}
    assert names == set(errors._CLASSES)
    assert set(errors._CLASSES.values()) | {errors.StltsaError, errors.QualityWarning} == {
        getattr(errors, n) for n in errors.__all__ if n != "error_for"
    }
