# SPDX-License-Identifier: BSD-3-Clause
"""Two motions, or left and right, aligned by phase."""

import json
import pickle

import numpy as np
import pytest

import stltsa


@pytest.fixture(scope="module")
def halves(clip):
    return [stltsa.decompose(clip.stretch(part)) for part in ("0-", "150-")]


@pytest.fixture(scope="module")
def compared(halves):
    return halves[0].compare(halves[1])


def test_one_walk_is_like_itself(compared):
    assert compared.whole.likeness > 0.99
    assert abs(compared.whole.shift) < 0.02
    assert compared.whole.shift_low <= compared.whole.shift <= compared.whole.shift_high
    assert min(motion.cycles for motion in compared.motions) >= 1
    assert [motion.label for motion in compared.motions] == ["A", "A"]
    assert compared.whole.size_ratio == pytest.approx(1, abs=0.01)
    assert [motion.left_out for motion in compared.motions] == [(), ()]
    foot = compared["LeftFoot"]
    assert foot.second == "LeftFoot"
    assert abs(foot.lag.difference) < 0.02
    assert foot.amplitude_ratio.value == pytest.approx(1, abs=0.05)
    with pytest.raises(KeyError):
        compared["tail"]
    assert "parts" in repr(compared)


def test_curves_and_channels_belong_together(compared):
    assert len(compared.channels) == 3 * len(compared.parts)
    assert [each.axis for each in compared.channels[:3]] == ["x", "y", "z"]
    assert compared.mean[0].shape == compared.margin.shape == (101, len(compared.channels))
    np.testing.assert_array_equal(compared.difference, compared.mean[1] - compared.mean[0])
    for column, channel in enumerate(compared.channels):
        rms = np.sqrt(np.mean(compared.difference[:-1, column] ** 2))
        assert channel.rms_difference == pytest.approx(rms, abs=1e-12)
        middle = compared.difference[:-1, column].mean()
        assert channel.mean.difference == pytest.approx(middle, abs=1e-9)


def test_json_is_that_of_the_command(compared):
    found = json.loads(compared.to_json())
    assert found["format"] == "stltsa-comparison/1"
    foot = next(part for part in found["parts"] if part["first"] == "LeftFoot")
    assert foot["differences"]["rms_difference"] == compared["LeftFoot"].rms_difference


def test_left_and_right(result):
    sides = result.compare()
    assert sides.whole.sides
    assert sides.whole.shift == 0.5
    assert np.isnan(sides.whole.shift_error)
    assert all(part.second == part.first.replace("Left", "Right") for part in sides.parts)
    assert max(part.rms_difference for part in sides.parts) < 0.1


def test_errors(result, halves):
    with pytest.raises(stltsa.ArgumentError):
        halves[0].compare(halves[1], "Z")
    with pytest.raises(stltsa.ArgumentError):
        halves[0].compare(halves[1], samples=2)
    still = stltsa.decompose(result.clip.stretch("0-100"))
    with pytest.raises(stltsa.NoSuchPartError, match="no cycles"):
        halves[0].compare(still)


def test_a_comparison_is_pickled(compared):
    again = pickle.loads(pickle.dumps(compared))
    assert again.parts[1].first == compared.parts[1].first
    np.testing.assert_array_equal(again.margin, compared.margin)
    with pytest.raises(ValueError, match="compare again"):
        again.report("never.html")


def test_a_report_is_one_page(compared, tmp_path):
    path = tmp_path / "comparison.html"
    compared.report(path, command="a </script> command")
    page = path.read_text(encoding="utf-8")
    assert page.startswith("<!doctype html>")
    assert "a \\u003c/script> command" in page
    with pytest.raises(stltsa.FileError):
        compared.report(tmp_path / "none" / "x.html")


def test_a_table_has_a_row_for_each_part_and_channel(compared):
    pytest.importorskip("pandas")
    table = compared.to_frame()
    assert len(table) == len(compared.parts) + len(compared.channels)
    assert table.lag_difference[0] == compared.parts[0].lag.difference or np.isnan(
        compared.parts[0].lag.difference
    )
    assert table.amplitude_ratio_low[1] <= table.amplitude_ratio[1] or np.isnan(
        table.amplitude_ratio[1]
    )


def test_without_a_rate_there_are_no_times(tmp_path):
    turns = np.arange(400)[:, None] / 40 + np.arange(3) / 7
    result = stltsa.decompose(np.sin(2 * np.pi * turns))
    with pytest.raises(stltsa.StltsaError, match="may not mirror"):
        result.compare()
    compared = result.compare(result)
    assert compared.whole.likeness == pytest.approx(1)
    assert np.isnan([motion.cycles_per_min for motion in compared.motions]).all()
    assert np.isnan(compared.whole.cycle_time_s.first)
    assert np.isnan([part.lag_s for part in (*compared.parts, *compared.channels)]).all()
    assert "frame rate is unknown" in compared.warnings[0]
    with pytest.raises(ValueError, match="give fps="):
        compared.report(tmp_path / "page.html")
