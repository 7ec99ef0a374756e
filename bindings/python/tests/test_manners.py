# SPDX-License-Identifier: BSD-3-Clause
"""Units of options, errors for the wrong object, what objects show, names and types."""

import re
import subprocess
import sys
import textwrap
from xml.etree import ElementTree

import numpy as np
import pytest

import stltsa


def test_lengths_in_seconds_are_those_of_the_command(clip, walker, command, tmp_path):
    out = tmp_path / "walk.stltsa"
    flags = ["--neighbors", "1.21s", "--window", "1.5s", "--sample-rate", "40"]
    subprocess.run([command, "fit", walker, *flags, "-o", out], check=True, capture_output=True)
    model = stltsa.fit(clip, neighbors="1.21s", window="1.5s", sample_rate=40)
    assert (model.neighbors, model.window) == (48, 60)
    model.keep_cycle(stltsa.decompose(clip).phase())
    assert model.to_bytes() == out.read_bytes()


def test_lengths_in_seconds_elsewhere(clip, circle):
    assert stltsa.fit(circle, neighbors="1.1s", fps=100).neighbors == 110
    assert stltsa.fit(circle, neighbors=8, window="0.001s", fps=1e4).window == 10
    assert stltsa.STLTSA(n_neighbors="1.1s", fps=100).fit(circle).n_neighbors_ == 110
    assert stltsa.fit(clip, neighbors="1.5s").neighbors == 45
    one, other = (stltsa.fit(clip, smoothing=s) for s in (0.1, "0.1s"))
    assert one.to_bytes() == other.to_bytes()
    model = stltsa.fit(clip)
    one, other = (stltsa.denoise(model, knot_spacing=s) for s in (0.2, "0.2s"))
    assert one.curve.tobytes() == other.curve.tobytes()


@pytest.mark.parametrize(
    ("option", "text"),
    [
        ({"neighbors": "1.2s"}, "neighbors is '1.2s', in seconds, and the frame rate is unknown"),
        ({"neighbors": "1.2x"}, "neighbors is '1.2x', and must be a number of frames"),
        ({"neighbors": "-1s", "fps": 30}, "neighbors is '-1s', and must be a number of frames"),
        ({"neighbors": "nans", "fps": 30}, "neighbors is 'nans', and must be a number of frames"),
        ({"smoothing": "soon"}, "smoothing is 'soon', and must be a number of seconds"),
        ({"variance": "0.9s"}, "variance is '0.9s', and must be a number"),
    ],
)
def test_wrong_lengths(circle, option, text):
    with pytest.raises(ValueError, match=text):
        stltsa.fit(circle, **option)


def test_knots_in_seconds_need_a_rate(circle):
    with pytest.raises(ValueError, match="the frame rate is unknown"):
        stltsa.denoise(circle, knot_spacing="0.2s")


def test_denoise_takes_clips_as_the_command_does(clip, walker, model, command, tmp_path):
    out = tmp_path / "clean.csv"
    subprocess.run([command, "denoise", walker, "-o", out], check=True, capture_output=True)
    cleaned = np.loadtxt(out, delimiter=",", skiprows=1, ndmin=2)
    expected = stltsa.denoise(model).cleaned
    for motion in (walker, str(walker), clip, [clip]):
        done = stltsa.denoise(motion)
        assert done.cleaned.tobytes() == expected.tobytes()
    assert np.array_equal(cleaned[:, -2:], expected)
    poses = done.poses()
    assert (len(poses), poses.fps, poses.joints) == (len(model), model.fps, clip.joints)
    assert stltsa.denoise(clip, neighbors=50, gamma=0.01).model.neighbors == 50
    with pytest.raises(ValueError, match="an array has no poses: give denoise the Clip"):
        stltsa.denoise(model.coords).poses()


@pytest.mark.parametrize("values", [3.0, None, {"a": 1}, np.float64(3)])
def test_no_array(values):
    for function in (stltsa.fit, stltsa.decompose, stltsa.denoise, stltsa.dimension):
        with pytest.raises(TypeError, match=r"must be a 2-D array .*, a Clip or a path"):
            function(values)


def test_the_wrong_object_is_named(clip, model, result):
    cases = [
        (lambda: stltsa.decompose(3), "X is the number 3"),
        (lambda: stltsa.decompose(model), r"X is a Model \(its coordinates are \.coords\)"),
        (lambda: stltsa.fit(result), r"X is a Decomposition \(its clip is \.clip"),
        (lambda: stltsa.decompose([clip, clip]), "X is a list of 2 Clip.*: call it for each"),
        (lambda: stltsa.Piece.of("walk.bvh", result.best_cycle), "the path 'walk.bvh'.*read_clip"),
        (lambda: stltsa.Piece.of(clip, None), "interval is None.*best_cycle"),
        (lambda: stltsa.synthesize([clip]), "a piece is a Clip, and must be a Piece"),
        (lambda: clip.features("raw", features="raw"), "multiple values"),
    ]
    for call, text in cases:
        with pytest.raises(TypeError, match=text):
            call()


def test_figures_of_the_wrong_object(model):
    pytest.importorskip("matplotlib")
    cases = [
        (stltsa.plot.units, model, "Decomposition.*given a Model: call .*decompose\\(clip\\)"),
        (stltsa.plot.loop, "w.bvh", "given the path 'w.bvh'.*decompose\\('w.bvh'\\)"),
    ]
    for draw, value, text in cases:
        with pytest.raises(TypeError, match=text):
            draw(value)


def test_wrong_columns_say_what_to_call(clip, circle):
    model = stltsa.fit(circle, neighbors=110)
    cases = [
        (model.map, circle[:, :4], "4 columns; the model has 5 features: .*the columns that were"),
        (model.map, model.coords, "call unmap"),
        (model.unmap, circle, "5 columns; the model has 2 coordinates: .*call map"),
    ]
    for function, values, text in cases:
        with pytest.raises(stltsa.ShapeError, match=text):
            function(values)
    with pytest.raises(stltsa.UnsupportedError, match=r"map\(clip.features\(\)\)"):
        model.map(clip)


def test_features_by_keyword(clip):
    assert np.array_equal(clip.features(features="euler"), clip.features("euler"))
    assert np.array_equal(clip.features(), clip.features("positions"))


def test_table_of_options(monkeypatch):
    monkeypatch.setenv("COLUMNS", "120")
    table = stltsa.options()
    assert isinstance(table, tuple)
    assert table[0].name == "neighbors"
    lines = repr(table).splitlines()
    assert max(map(len, lines)) <= 120
    column = lines[0].index("default")
    named = {line.split()[0]: line for line in lines if not line.startswith(" ")}
    assert set(named) == {"option", *(option.name for option in table)}
    assert named["mode"][column:].startswith("temporal ")
    assert named["keep_start"][column:].startswith("False ")
    timed = {option.name for option in table if '"1.2s"' in option.values}
    assert timed == {
        "neighbors",
        "window",
        "exclusion",
        "smoothing",
        "period_min",
        "period_max",
        "knot_spacing",
        "crossfade",
        "cut_range",
    }
    html = ElementTree.fromstring(table._repr_html_())
    assert len(html.findall("tbody/tr")) == len(table)


def test_html_of_clip_and_model(clip, model):
    def facts(shown):
        rows = ElementTree.fromstring(shown._repr_html_()).findall(".//tr")
        return dict(tuple(cell.text for cell in row) for row in rows)

    assert facts(clip)["frames"] == "844"
    assert facts(clip)["duration"] == "7.03 s"
    assert facts(model)["neighbors"] == f"{model.neighbors} ({model.neighbors / 30:.2f} s)"
    odd = stltsa.Clip.from_array(np.zeros((9, 2)), fps=30)
    odd.path = "<b>.npy"
    assert "<b>" not in odd._repr_html_()
    assert "only a clock" not in model._repr_html_()


def test_names():
    names = dir(stltsa)
    assert {"decompose", "STLTSA", "plot", "__version__"} <= set(names)
    assert not {"Any", "TYPE_CHECKING", "annotations", "importlib", "denoising"} & set(names)
    assert all(hasattr(stltsa, name) for name in names)


def test_types(tmp_path):
    """A checker accepts what runs, and refuses what does not."""
    pytest.importorskip("mypy.version", minversion="1.7")
    program = """\
        import numpy as np
        import stltsa
        clip = stltsa.read_clip("walk.bvh")
        frames = np.zeros((3, 3))
        result = stltsa.decompose("walk.bvh", period_max="4s", segments=1)
        stltsa.decompose(frames, fps=30)
        stltsa.decompose([[0.0, 1.0], [1.0, 2.0]], fps=30)
        stltsa.fit([clip, clip])
        stltsa.fit([frames, frames], groups=None)
        stltsa.fit(frames, groups=["a", "a", "b"])
        stltsa.denoise(stltsa.fit(clip))
        stltsa.synthesize([(clip, 0, 5), stltsa.Piece(clip, 0, 5)])
        stltsa.plot.units(result).set_title("x")
        result.units.to_csv()
        stltsa.decompose(3)  # refused
        stltsa.fit(result)  # refused
        stltsa.plot.units(clip)  # refused
        stltsa.decompose(clip, neighbours=3)  # refused
        clip.features("position")  # refused
        """
    path = tmp_path / "program.py"
    path.write_text(textwrap.dedent(program))
    ran = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", "--cache-dir", tmp_path / "cache", path],
        capture_output=True,
        text=True,
        check=False,
    )
    lines = enumerate(path.read_text().splitlines(), 1)
    expected = {number for number, line in lines if "# refused" in line}
    refused = {int(n) for n in re.findall(r"program\.py:(\d+): error", ran.stdout)}
    assert refused == expected, ran.stdout + ran.stderr
