# SPDX-License-Identifier: BSD-3-Clause
"""The figures agree with the results; scripts/make-figures is for a visual check."""

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
from matplotlib.offsetbox import AnnotationBbox
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from stltsa.plot._postures import FAR, SideView
from stltsa.plot._style import color_of


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


def smooth_paths(axes):
    return [p.get_path() for p in axes.patches if isinstance(p, PathPatch)]


def test_loop(result):
    axes = stltsa.plot.loop(result)
    paths = smooth_paths(axes)
    drawn = np.concatenate([p.vertices for p in paths])
    embedded = result.loop[np.any(result.loop != 0, axis=1)]  # the rest is outside the cycles
    assert {tuple(p) for p in embedded} <= {tuple(p) for p in drawn}
    assert all(Path.CURVE4 in p.codes for p in paths)
    numbers = [text for text in texts_of(axes) if text != "start"]  # which has no room here
    assert len(numbers) > 8
    assert set(map(int, numbers)) <= set(result.frames.tolist())
    colors = {line.get_color() for line in axes.lines if line.get_marker() == "o"}
    assert colors == {color_of(kind) for kind in ("initial", "cyclic", "final")}
    assert legend_of(axes) == list(result.units["kind"])
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
    drawn = {tuple(p) for path in smooth_paths(axes) for p in path.vertices}
    inside = (found.frames >= kept.begin) & (found.frames < kept.end)
    assert {tuple(p) for p in found.loop[inside] if p.any()} <= drawn
    assert not {tuple(p) for p in found.loop[~inside] if p.any()} & drawn


def test_no_loop_is_named_where_there_is_none(no_cycle):
    assert not no_cycle.cycle_list
    axes = stltsa.plot.loop(no_cycle)
    assert "loop" not in axes.get_xlabel() + axes.get_ylabel()
    with pytest.raises(ValueError, match="no cycles"):
        stltsa.plot.cycles(no_cycle)
    with pytest.raises(ValueError, match="no cycles"):
        stltsa.plot.cycle_times(no_cycle)


def test_numbers_do_not_cover_each_other_or_lines(result, many):
    for found in (result, many):
        axes = stltsa.plot.loop(found)
        boxes = boxes_of(axes)
        assert not any(a.overlaps(b) for a, b in itertools.combinations(boxes, 2))
        for path in smooth_paths(axes):
            line = axes.transData.transform_path(path.interpolated(20))
            for box in boxes:
                core = box.shrunk(0.8, 0.55)  # without the empty space above and below digits
                assert not core.count_contains(line.vertices)


def test_legends_have_no_repetitions(no_cycle, result, model):
    for axes in (
        stltsa.plot.units(no_cycle),
        stltsa.plot.units(result),
        stltsa.plot.cycles(result),
        stltsa.plot.denoising(stltsa.denoise(model))[0],
    ):
        names = legend_of(axes)
        assert names
        assert len(names) == len(set(names))


def test_denoising(model):
    done = stltsa.denoise(model)
    before, after, residuals = stltsa.plot.denoising(done, fps=model.fps)
    moved = done.moves[:, 0] != 0
    for panel, points, curve in (
        (before, done.points[:, 0], done.curve[:, 0]),
        (after, done.cleaned[:, 0], done.curve[:, 0]),
        (residuals, done.points[:, 0] - done.curve[:, 0], np.zeros(len(moved))),
    ):
        kept, fitted, shifted = (line.get_ydata() for line in panel.lines)
        assert np.array_equal(kept, points[~moved])
        assert np.array_equal(fitted, curve)
        assert np.array_equal(shifted, points[moved])
    gamma = done.facts["gamma"][0]
    assert abs(residuals.lines[0].get_ydata()).max() <= gamma * (1 + 1e-9)


def test_units(result):
    axes = stltsa.plot.units(result)
    boxes = [a for a in axes.artists if isinstance(a, AnnotationBbox)]
    assert len(boxes) == 11
    assert texts_of(axes) == ["cycle 1", "cycle 2", "cycle 3"]
    margins = [line.get_xdata()[0] for line in axes.lines if line.get_linestyle() == "--"]
    assert margins == pytest.approx([*result.cycles["begin_s"], result.cycle_list[-1].end_s])
    assert axes.get_xlim() == (0, pytest.approx(result.clip.duration))
    # Margins end where the postures begin.
    axes.figure.canvas.draw()
    lines = [line.get_window_extent() for line in axes.lines if line.get_linestyle() == "--"]
    for box in boxes:
        at = box.offsetbox.get_window_extent()
        assert not any(
            at.x0 < line.x0 < at.x1 and line.y0 < at.y1 and at.y0 < line.y1 for line in lines
        )


def test_many_cycles_are_an_envelope(many, result):
    assert len(many.cycle_list) > 40
    axes = stltsa.plot.units(many)
    assert texts_of(axes) == []
    assert not [line for line in axes.lines if line.get_linestyle() == "--"]
    (envelope,) = axes.collections
    low, high = np.sort(envelope.get_paths()[0].vertices[:, 1])[[0, -1]]
    inside = (many.frames >= many.cycle_list[0].begin) & (many.frames < many.cycle_list[-1].end)
    assert low == pytest.approx(many.curve[inside].min())
    assert high == pytest.approx(many.curve[inside].max())
    assert not stltsa.plot.units(result).collections


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


def test_cycle_times(result):
    axes = stltsa.plot.cycle_times(result)
    (marks,) = axes.collections
    numbers, lengths = marks.get_offsets().T
    filled = [color[:3].min() < 1 for color in marks.get_facecolors()]
    assert filled == [cycle == result.representative_cycle for cycle in result.cycle_list]
    low, high = axes.get_ylim()
    assert low < lengths.min()
    assert lengths.max() < high
    assert numbers.tolist() == [1, 2, 3]
    assert np.asarray(lengths) == pytest.approx(np.asarray(result.cycles["duration_s"]))


@pytest.mark.parametrize("count", [1, 2, 3])
def test_of_few_cycles_none_stands_out(count, tmp_path):
    result = stltsa.decompose(synthetic(tmp_path, "--cycles", f"{count}", "--noise", "1"))
    assert len(result.cycle_list) == count
    (marks,) = stltsa.plot.cycle_times(result).collections
    assert any(color[:3].min() < 1 for color in marks.get_facecolors()) == (count > 2)
    units = stltsa.plot.units(result, postures=0)
    rectangles = [p for p in units.patches if p.get_alpha() == 0.12]
    assert (len(rectangles) == 1) == (count > 2)
    widths = [p.get_linewidth() for p in stltsa.plot.loop(result).patches]
    assert (max(widths) > 2) == (count > 2)
    overlaid = stltsa.plot.cycles(result)
    assert len(overlaid.collections) == (count > 1)  # of one cycle there is no deviation


def test_at_most_60_cycles_are_overlaid(tmp_path):
    result = stltsa.decompose(synthetic(tmp_path, "--cycles", "70", "--fps", "30"))
    *each, mean = [line.get_ydata() for line in stltsa.plot.cycles(result).lines]
    assert (len(result.cycle_list), len(each)) == (70, 60)
    assert len(mean) == len(each[0])


def numbers_in(text):
    return np.array(re.findall(r"-?[\d.]+", text), dtype=float).reshape(-1, 2)


def test_postures_are_those_of_the_command(walker, result, command, tmp_path):
    """The same frames, bones, far limbs and heads."""
    subprocess.run([command, "decompose", walker, "--plot", tmp_path / "x.svg"], check=True)
    groups = [e for e in ET.parse(tmp_path / "x.svg").iter() if e.get("class") == "posture"]
    frames = [int(group.get("data-frame")) for group in groups]
    assert frames == sorted(result.facts["postures"][: len(frames)])
    view = SideView(result.clip)
    for group, frame in zip(groups, frames, strict=True):
        head = next(e for e in group if e.get("class") == "head")
        size = float(head.get("r")) / view.radius
        places = view.posture(frame) * size * [1, -1]
        center = np.array([float(head.get("cx")), float(head.get("cy"))])
        shift = center - view.middle_of_head(frame) * size * [1, -1]
        drawn = {e.get("stroke"): numbers_in(e.get("d")) for e in group if e.get("d")}
        far = [j for bone, d in zip(view.bones, view.depth, strict=True) if d == FAR for j in bone]
        assert drawn["#a0a0a0"] == pytest.approx(places[far] + shift, abs=0.5)


def test_given_axes_are_used(result):
    figure, (one, two) = plt.subplots(1, 2)
    assert stltsa.plot.loop(result, ax=one) is one
    assert stltsa.plot.units(result, ax=two) is two
    assert figure.axes == [one, two]


def test_joints_above_the_body_are_left_out(walker, tmp_path):
    hierarchy, motion = walker.read_text().split("MOTION\n")
    head, times, *rows = motion.splitlines()
    below = tmp_path / "below.bvh"
    below.write_text(
        "HIERARCHY\nROOT world\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\nJOINT"
        + hierarchy.removeprefix("HIERARCHY\nROOT") + "}\nMOTION\n"
        + "\n".join([head, times, *("0 0 0 " + row for row in rows)]) + "\n"
    )  # fmt: skip
    here, there = stltsa.read_clip(walker), stltsa.read_clip(below)
    assert (here.facts["body_root"], there.facts["body_root"]) == (0, 1)
    views = SideView(here), SideView(there)
    assert views[0].bones == views[1].bones
    assert views[0].depth == views[1].depth
    np.testing.assert_allclose(views[0].posture(300), views[1].posture(300), atol=1e-9)
    assert views[0].head == views[1].head


def test_bare_numbers_have_no_postures(clip):
    result = stltsa.decompose(clip.features(), fps=clip.fps)
    axes = stltsa.plot.units(result)
    assert not [a for a in axes.artists if isinstance(a, AnnotationBbox)]


def test_fits_a_column(result):
    draws = (stltsa.plot.loop, stltsa.plot.units, stltsa.plot.cycles, stltsa.plot.cycle_times)
    for draw in draws:
        figure = draw(result).figure
        assert figure.get_size_inches()[0] == pytest.approx(88 / 25.4)
        smallest = min(t.get_fontsize() for t in figure.findobj(plt.Text) if t.get_text())
        assert smallest >= 5.5


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
