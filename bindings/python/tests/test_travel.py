# SPDX-License-Identifier: BSD-3-Clause
"""Travel of cycles, and statistics of parts."""

import numpy as np
import pytest

import stltsa


@pytest.fixture(scope="module")
def walk(walker):
    return stltsa.decompose(walker)


def rows(found, **wanted):
    table = found.statistics
    chosen = np.ones(len(table["kind"]), dtype=bool)
    for name, value in wanted.items():
        chosen &= np.asarray(table[name]) == value
    return {name: np.asarray(table[name])[chosen] for name in stltsa.PartStatistics._fields}


def test_cycles_of_the_walker_travel(walk):
    cycles = walk.cycles
    assert np.asarray(cycles["speed"]) == pytest.approx(126, abs=1.5)
    assert np.asarray(cycles["stride"]) == pytest.approx(126 * 1.1, abs=2)
    assert np.asarray(cycles["turn_deg"]) == pytest.approx(0, abs=0.5)


def test_statistics_are_those_of_the_parts(walk):
    found = rows(walk, kind="cycle", side=-1, quantity="speed")
    speed = np.asarray(walk.cycles["speed"])
    assert found["mean"][0] == pytest.approx(speed.mean())
    assert found["sd"][0] == pytest.approx(speed.std(ddof=1))
    assert found["cv"][0] == pytest.approx(speed.std(ddof=1) / speed.mean())
    steps = [rows(walk, kind="step", side=s, quantity="time") for s in (-1, 0, 1)]
    assert [one["number"][0] for one in steps] == [6, 3, 3]
    assert np.isnan(rows(walk, kind="cycle", side=-1, quantity="turn")["cv"]).all()


def test_without_a_rate_times_are_in_frames(clip, walk):
    found = stltsa.decompose(clip.features("raw"))
    time = rows(found, kind="cycle", side=-1, quantity="time")
    frames = np.asarray(found.cycles["end"]) - np.asarray(found.cycles["begin"])
    assert time["mean"][0] == pytest.approx(frames.mean(), abs=1)
    assert np.isnan(time["trend"]).all()
    assert not len(rows(found, quantity="path_length")["mean"])  # numbers have no ground


def test_rows_with_unknown_numbers_equal_each_other(clip):
    found = stltsa.decompose(clip.features("raw"), fps=clip.fps)
    assert np.isnan(found.best_cycle.speed)
    assert found.best_cycle in found.cycle_list
    assert found.segment_list == found.segment_list
