# SPDX-License-Identifier: BSD-3-Clause
"""The axes agree with the results."""

import itertools
import re
import subprocess
import xml.etree.ElementTree as ET

import numpy as np
import pytest
from conftest import program

import stltsa

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
import matplotlib.pyplot as plt

from stltsa._colors import UNIT_COLORS


@pytest.fixture(autouse=True)
def close_figures():
    yield
    plt.close("all")


def synthetic(folder, *settings):
    path = folder / "walk.bvh"
    subprocess.run(
        [program("STLTSA_WALKER", "tests/walker/stltsa-walker"), "--output", path, *settings],
        check=True,
    )
    return path


@pytest.fixture(scope="module")
def many(tmp_path_factory):
    """A walk of more than 40 cycles."""
    settings = ("--cycles", "45", "--fps", "30", "--noise", "1")
    return stltsa.decompose(synthetic(tmp_path_factory.mktemp("many"), *settings))


@pytest.fixture(scope="module")
def no_cycle():
    t = np.linspace(0, 2, 400)
    return stltsa.decompose(np.column_stack([np.sin(t), np.cos(t), t]), fps=30)


def texts_of(axes):
    return [text.get_text() for text in axes.texts if text.get_text()]


def boxes_of(axes):
    axes.figure.canvas.draw()
    return [t.get_window_extent() for t in axes.texts if t.get_text()]


def legend_of(axes):
    return [text.get_text() for text in axes.get_legend().get_texts()]


def drawn_lines(axes):
    """Return the points of each line."""
    return [line.get_xydata() for line in axes.lines if len(line.get_xydata()) > 2]


def test_loop(result):
    axes = stltsa.plot.loop(result)
    drawn = {tuple(p) for p in np.concatenate(drawn_lines(axes))}
    embedded = result.coords[np.any(result.coords != 0, axis=1)]  # the rest is outside the cycles
    assert {tuple(p) for p in embedded} <= drawn
    assert len(drawn) > 4 * len(embedded)  # a smooth line
    numbers = [text for text in texts_of(axes) if text != "start"]  # which has no room here
    assert len(numbers) > 8
    assert set(map(int, numbers)) <= set(result.frames.tolist())
    colors = {line.get_color() for line in axes.lines if line.get_marker() == "o"}
    assert colors == {UNIT_COLORS[kind] for kind in ("initial", "cyclic", "final")}
    assert legend_of(axes) == ["initial", "cyclic", "final"]
    assert axes.get_xlabel() == "first coordinate of the loop"


def test_each_cyclic_segment_has_its_own_loop():
    rows = []
    for i in range(720):
        period, sizes = ((36, (3, 1, 2, 0.2, 0.1, 0.3)), (57, (0.2, 0.3, 0.1, 3, 2, 1)))[i >= 360]
        angles = 2 * np.pi * i / period + np.arange(6)
        rows.append(sizes * (np.sin(angles) + 0.3 * np.cos(2 * angles)))
    found = stltsa.decompose(np.array(rows), fps=30)
    assert [segment.kind for segment in found.segment_list] == ["cyclic", "cyclic"]
    begin = found.representative_cycle.begin
    (kept,) = (s for s in found.segment_list if s.begin <= begin < s.end)
    axes = stltsa.plot.loop(found)
    assert axes.get_xlabel() == f"first coordinate of the loop of {kept.label}"
    drawn = {tuple(p) for line in drawn_lines(axes) for p in line}
    inside = (found.frames >= kept.begin) & (found.frames < kept.end)
    assert {tuple(p) for p in found.coords[inside] if p.any()} <= drawn
    assert not {tuple(p) for p in found.coords[found.frames > kept.end] if p.any()} & drawn


def test_no_cycles(no_cycle):
    assert not no_cycle.cycle_list
    for draw in (stltsa.plot.cycles, stltsa.plot.loop):
        with pytest.raises(ValueError, match="no cycles"):
            draw(no_cycle)
    assert not np.isfinite(stltsa.plot.units(no_cycle).lines[0].get_ydata()).any()


def test_frames_where_the_rate_is_unknown():
    turns = 2 * np.pi * np.arange(400) / 40
    found = stltsa.decompose(np.column_stack([np.sin(turns), np.cos(turns), np.sin(turns + 1)]))
    axes = stltsa.plot.units(found)
    assert axes.get_xlabel() == "frame"
    assert axes.get_xlim() == (0, 400)
    edges = {line.get_xdata()[0] for line in axes.lines if line.get_linestyle() == "--"}
    assert edges == {edge for cycle in found.cycle_list for edge in (cycle.begin, cycle.end)}


def test_numbers_do_not_cover_each_other_or_lines(result, many):
    for found in (result, many):
        axes = stltsa.plot.loop(found)
        boxes = boxes_of(axes)
        assert len(boxes) > 3
        assert not any(a.overlaps(b) for a, b in itertools.combinations(boxes, 2))
        for line in drawn_lines(axes):
            on_line = axes.transData.transform(line)
            for box in boxes:
                core = box.shrunk(0.8, 0.55)  # without the empty space above and below digits
                assert not core.count_contains(on_line)


def test_legends_have_no_repetitions(no_cycle, result):
    for axes in (
        stltsa.plot.units(no_cycle),
        stltsa.plot.units(result),
        stltsa.plot.cycles(result),
    ):
        names = legend_of(axes)
        assert names
        assert len(names) == len(set(names))


def test_units(result):
    axes = stltsa.plot.units(result)
    assert texts_of(axes) == ["cycle 1", "cycle 2", "cycle 3"]
    edges = [line.get_xdata()[0] for line in axes.lines if line.get_linestyle() == "--"]
    assert edges == pytest.approx([*result.cycles["begin_s"], result.cycle_list[-1].end_s])
    assert axes.get_xlim() == (0, pytest.approx(result.clip.duration))
    for unit, line in zip(result.unit_list, drawn_lines(axes), strict=True):
        times = line[:, 0] * result.clip.fps
        assert times.min() >= unit.begin
        assert (times >= unit.end).sum() <= 1
    drawn = np.concatenate(drawn_lines(axes))[:, 1]
    assert set(drawn[np.isfinite(drawn)]) == set(result.curve[result.curve != 0])


def test_of_many_cycles_lines_are_thin(many, result):
    assert len(many.cycle_list) > 40
    axes = stltsa.plot.units(many)
    assert texts_of(axes) == []
    assert not [line for line in axes.lines if line.get_linestyle() == "--"]
    widths = [stltsa.plot.units(found).lines[0].get_linewidth() for found in (many, result)]
    assert widths[0] < widths[1] / 2


@pytest.mark.parametrize("count", [1, 2, 3])
def test_of_few_cycles_none_stands_out(count, tmp_path):
    result = stltsa.decompose(synthetic(tmp_path, "--cycles", f"{count}", "--noise", "1"))
    assert len(result.cycle_list) == count
    units = stltsa.plot.units(result)
    rectangles = [p for p in units.patches if p.get_alpha() == 0.12]
    assert (len(rectangles) == 1) == (count > 2)
    widths = [line.get_linewidth() for line in stltsa.plot.loop(result).lines]
    assert (max(widths) > 2) == (count > 2)
    overlaid = stltsa.plot.cycles(result)
    assert len(overlaid.collections) == (count > 1)  # of one cycle there is no deviation


def test_fits_a_column(result):
    for draw in (stltsa.plot.loop, stltsa.plot.units, stltsa.plot.cycles):
        figure = draw(result).figure
        assert figure.get_size_inches()[0] == pytest.approx(88 / 25.4)
        smallest = min(t.get_fontsize() for t in figure.findobj(plt.Text) if t.get_text())
        assert smallest >= 5.5


def test_cycles(result, many):
    axes = stltsa.plot.cycles(result)
    *each, mean = [line.get_ydata() for line in axes.lines]
    assert len(each) == len(result.cycle_list)
    assert mean == pytest.approx(np.mean(each, axis=0))
    (band,) = axes.collections
    drawn = band.get_paths()[0].vertices[:, 1]
    deviation = np.std(each, axis=0, ddof=1)
    assert drawn.max() == pytest.approx((mean + deviation).max())
    assert drawn.min() == pytest.approx((mean - deviation).min())
    for line, cycle in zip(each, result.cycle_list, strict=True):
        ends = np.interp([cycle.begin, cycle.end], result.frames, result.curve)
        assert [line[0], line[-1]] == pytest.approx(ends)
    assert len(stltsa.plot.cycles(many).lines) == len(many.cycle_list) + 1


def test_cycles_on_both_sides_of_a_gap():
    turns = 2 * np.pi * np.arange(900) / 66
    cycle = np.stack([np.sin(turns) + 0.2 * np.sin(2 * turns), np.cos(turns), np.sin(turns + 1)], 1)
    along = np.linspace(0, 1, 32)[:, None]
    other = cycle[-1] + [0, 1.5, 1] * np.sin(np.pi * along * [0, 1, 2])
    result = stltsa.decompose(np.concatenate([cycle, other, cycle]), fps=60)
    found = result.cycle_list
    gaps = [i for i in range(1, len(found)) if found[i].begin > found[i - 1].end]
    assert len(gaps) == 1
    assert len(result.segments) == 1
    before = result.facts["representative"] < gaps[0]
    run = found[: gaps[0]] if before else found[gaps[0] :]
    *each, _ = [line.get_ydata() for line in stltsa.plot.cycles(result).lines]
    assert len(each) == len(run)
    for line, shown in zip(each, run, strict=True):
        ends = np.interp([shown.begin, shown.end], result.frames, result.curve)
        assert [line[0], line[-1]] == pytest.approx(ends)


def test_at_most_60_cycles_are_overlaid(tmp_path):
    result = stltsa.decompose(synthetic(tmp_path, "--cycles", "70", "--fps", "30"))
    *each, mean = [line.get_ydata() for line in stltsa.plot.cycles(result).lines]
    assert (len(result.cycle_list), len(each)) == (70, 60)
    assert len(mean) == len(each[0])


def test_far_limbs_of_the_figure_are_left(result, tmp_path):
    """A walk is seen from its right: the gray foot is in front where the left one is."""
    result.report(tmp_path / "x.svg")
    groups = [e for e in ET.parse(tmp_path / "x.svg").iter() if e.get("class") == "posture"]
    positions = result.clip.positions
    left, right = (result.clip.joints.index(side + "Foot") for side in ("Left", "Right"))
    way = positions[-1, 0] - positions[0, 0]
    seen = 0
    for group in groups:
        frame = positions[int(group.get("data-frame"))]
        ahead = (frame[left] - frame[right]) @ way / np.linalg.norm(way)
        if abs(ahead) < 0.2 * np.ptp(frame[:, 1]):
            continue
        feet = {}
        for path in group:
            if path.get("d"):
                points = re.findall(r"[ML]([-\d.]+) ([-\d.]+)", path.get("d"))
                feet[path.get("stroke")] = max((float(y), float(x)) for x, y in points)[1]
        assert (feet["#a0a0a0"] - feet["#222222"]) * ahead > 0
        seen += 1
    assert seen > 2


def test_given_axes_are_used(result):
    figure, (one, two) = plt.subplots(1, 2)
    assert stltsa.plot.loop(result, ax=one) is one
    assert stltsa.plot.units(result, ax=two) is two
    assert figure.axes == [one, two]


def test_same_bytes(result, tmp_path):
    for draw in (stltsa.plot.loop, stltsa.plot.units):
        for name in ("1.png", "2.png"):
            draw(result).figure.savefig(tmp_path / name)
        assert (tmp_path / "1.png").read_bytes() == (tmp_path / "2.png").read_bytes()


def test_names_are_text(clip):
    """A name in a table of a notebook cannot be markup."""
    shown = stltsa.Clip.from_points(
        np.random.default_rng(1).normal(size=(50, 3, 3)), fps=30, names=["<script>", "b", "c"]
    )
    shown.path = "/x/<script>alert(1)<b>.csv"
    assert "<script>" not in shown._repr_html_()
