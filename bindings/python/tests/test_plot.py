# SPDX-License-Identifier: BSD-3-Clause
"""The figures agree with the results; scripts/make-figures is for a visual check."""

import itertools

import numpy as np
import pytest

import stltsa

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.offsetbox import AnnotationBbox


@pytest.fixture(autouse=True)
def close_figures():
    yield
    plt.close("all")


def texts_of(axes):
    return [text.get_text() for text in axes.texts if text.get_text()]


def boxes_of(axes):
    axes.figure.canvas.draw()
    return [t.get_window_extent() for t in axes.texts if t.get_text()]


def test_loop(result):
    axes = stltsa.plot.loop(result)
    drawn = np.concatenate([line.get_xydata() for line in axes.lines if len(line.get_xdata()) > 1])
    assert {tuple(p) for p in result.loop} == {tuple(p) for p in drawn}
    numbers = [int(text) for text in texts_of(axes)]
    assert len(numbers) > 8
    assert set(numbers) <= set(result.frames.tolist())
    labels = [text.get_text() for text in axes.get_legend().get_texts()]
    assert labels == list(result.units["kind"])


def test_numbers_do_not_cover_each_other(result):
    boxes = boxes_of(stltsa.plot.loop(result))
    assert not any(a.overlaps(b) for a, b in itertools.combinations(boxes, 2))


def test_denoising(model):
    done = stltsa.denoise(model)
    before, after = stltsa.plot.denoising(done, fps=model.fps)
    assert np.array_equal(before.lines[0].get_ydata(), done.points[:, 0])
    assert np.array_equal(after.lines[0].get_ydata(), done.cleaned[:, 0])
    assert np.array_equal(after.lines[1].get_ydata(), done.curve[:, 0])


def test_units(result):
    axes = stltsa.plot.units(result)
    boxes = [a for a in axes.artists if isinstance(a, AnnotationBbox)]
    assert len(boxes) == 11
    assert texts_of(axes) == ["cycle 1", "cycle 2", "cycle 3"]
    margins = [line.get_xdata()[0] for line in axes.lines if line.get_linestyle() == "--"]
    assert margins == pytest.approx([*result.cycles["begin_s"], result.cycle_list[-1].end_s])
    assert axes.get_xlim() == (0, pytest.approx(result.clip.duration))


def test_given_axes_are_used(result):
    figure, (one, two) = plt.subplots(1, 2)
    assert stltsa.plot.loop(result, ax=one) is one
    assert stltsa.plot.units(result, ax=two) is two
    assert figure.axes == [one, two]


def test_bare_numbers_have_no_postures(clip):
    result = stltsa.decompose(clip.features(), fps=clip.fps)
    axes = stltsa.plot.units(result)
    assert not [a for a in axes.artists if isinstance(a, AnnotationBbox)]


def test_fits_a_column(result):
    for draw in (stltsa.plot.loop, stltsa.plot.units):
        figure = draw(result).figure
        assert figure.get_size_inches()[0] == pytest.approx(88 / 25.4)
        smallest = min(t.get_fontsize() for t in figure.findobj(plt.Text) if t.get_text())
        assert smallest >= 5.5
