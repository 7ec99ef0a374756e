# SPDX-License-Identifier: BSD-3-Clause
"""Failures are exceptions of the right class, with the library's text."""

import pickle

import numpy as np
import pytest

import stltsa


def test_file_that_is_not_there():
    with pytest.raises(OSError, match=r"nowhere\.bvh: cannot open") as caught:
        stltsa.read_clip("nowhere.bvh")
    assert isinstance(caught.value, stltsa.FileError)
    assert caught.value.name == "STLTSA_E_IO"


def test_file_that_is_something_else(tmp_path):
    path = tmp_path / "bad.bvh"
    path.write_text("HIERARCHY\nROOT hips\n{\n OFFSET 1 2\n")
    with pytest.raises(stltsa.FormatError, match=r"bad\.bvh"):
        stltsa.read_clip(path)


def test_path_with_a_zero_in_it(circle, tmp_path):
    """C would end the path there, and read or write another file."""
    path = str(tmp_path / "model") + "\0.stltsa"
    model = stltsa.fit(circle)
    for call in (model.save, stltsa.Model.load, stltsa.read_clip):
        with pytest.raises(ValueError, match="zero"):
            call(path)
    assert not list(tmp_path.iterdir())


def test_not_finite(circle):
    spoiled = circle.copy()
    spoiled[17, 3] = np.nan
    with pytest.raises(stltsa.NotFiniteError, match="frames: row 17, column 3 is NaN"):
        stltsa.fit(spoiled)


def test_too_few_frames(circle):
    with pytest.raises(stltsa.TooFewFramesError, match="use fewer neighbors"):
        stltsa.fit(circle[:10], neighbors=20)


def test_nothing_moves():
    with pytest.raises(stltsa.DegenerateError, match="nothing moves"):
        stltsa.fit(np.ones((100, 3)), neighbors=5)


@pytest.mark.parametrize(
    ("option", "error", "text"),
    [
        ({"neighbours": 5}, TypeError, "there is no option 'neighbours'"),
        ({"neighbors": 2.5}, TypeError, "neighbors is 2.5, and must be an integer"),
        ({"neighbors": "many"}, ValueError, "neighbors is 'many'"),
        ({"mode": "spectral"}, ValueError, "must be one of: temporal, spatial, recurrent"),
        ({"variance": 7.0}, stltsa.ArgumentError, "variance"),
        ({"neighbors": -1}, ValueError, "neighbors"),
        ({"neighbors": 2**70}, stltsa.ArgumentError, "neighbors is .*; it must be from 1 to"),
        ({"neighbors": "50"}, ValueError, "neighbors is '50', and must be a number"),
        ({"fps": np.array([30.0, 60.0])}, TypeError, "fps is .*, and must be a number"),
    ],
)
def test_bad_options(circle, option, error, text):
    with pytest.raises(error, match=text):
        stltsa.fit(circle, **option)


def test_errors_can_be_pickled():
    error = stltsa.FileError("text", -6, "STLTSA_E_IO")
    again = pickle.loads(pickle.dumps(error))
    assert (type(again), str(again), again.status, again.name) == (
        stltsa.FileError,
        "text",
        -6,
        "STLTSA_E_IO",
    )


def test_unknown_status_is_an_error():
    assert type(stltsa.errors.error_for(-99, "STLTSA_E_UNKNOWN", "x")) is stltsa.StltsaError


def test_objects_of_the_wrong_type(clip, result):
    """The error names what is wrong and says what to give."""
    phase = result.phase()
    cycles = phase.resample(np.zeros((len(phase.values), 2)))
    for call, text in (
        (lambda: stltsa.Clip("walk.bvh"), "call read_clip"),
        (lambda: stltsa.side_of_name(None), "name is None, and must be a string"),
        (lambda: phase.events(250, name=None), "name is None, and must be a string"),
        (lambda: phase.events(250, result), "other is a Decomposition .*must be a Phase"),
        (lambda: phase.events_like([3]), "a label is the number 3, and must be a stltsa.FileEvent"),
        (lambda: cycles.compare_left_right([1, 2]), "an entry of names is the number 1, and"),
        (lambda: cycles.compare_left_right("ab"), "names is the string 'ab', and must"),
        (lambda: clip.stretch(3), "what is the number 3, and must be a string"),
        (
            lambda: stltsa.decompose([np.zeros((9, 2)), np.zeros((8, 2))]),
            "X is a list of 2 ndarray, and must be one array: call it for each of them",
        ),
    ):
        with pytest.raises(TypeError, match=text):
            call()


def test_results_that_are_tuples_are_pickled(result):
    phase = result.phase()
    events = phase.events(250)
    copy = pickle.loads(pickle.dumps(events))
    assert type(copy) is type(events)
    assert (copy, copy.likeness, copy.warnings) == (events, events.likeness, events.warnings)
