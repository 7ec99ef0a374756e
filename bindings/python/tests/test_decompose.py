# SPDX-License-Identifier: BSD-3-Clause
import json
import re
from xml.etree import ElementTree

import numpy as np
import pytest

import stltsa


def test_units_and_cycles(result):
    kinds = ["preparing", "initial", "cyclic", "final", "wind-up"]
    assert list(result.units["kind"]) == list(result.units.kind) == kinds
    assert list(result.units["end"])[:-1] == list(result.units["begin"])[1:]
    assert len(result.cycles) == 3
    assert result.period == pytest.approx(1.1, abs=0.02)
    assert result.reason == ""
    assert result.best_cycle in result.cycle_list
    assert result.representative_cycle == result.cycle_list[0]


def test_what_does_not_move_is_standing():
    result = stltsa.decompose(np.ones((500, 4)), fps=100)
    assert [unit.kind for unit in result.unit_list] == ["preparing"]
    assert result.cycle_list == ()
    assert result.reason


def test_the_foot_of_a_step_is_ahead_in_it(clip, result):
    left, right = (
        clip.positions[:, clip.joints.index(f"{side}Foot"), 2] for side in ("Left", "Right")
    )
    for step in json.loads(result.to_json())["steps"]:
        ahead = (left - right)[step["begin"] : step["end"]].mean()
        assert (ahead > 0) == (step["side_name"] == "left")


def test_likeness_of_labels():
    t = np.arange(1800) / 30
    one, other = (t % 20 < 9), (t % 20 >= 10) & (t % 20 < 19)
    columns = [take * f(2 * np.pi * t) for take in (one, other) for f in (np.sin, np.cos)]
    found = stltsa.decompose(np.column_stack(columns), fps=30).label_likeness
    assert found.shape == (2, 2)
    assert found.diagonal().min() > 0.65
    assert found[0, 1] == found[1, 0] < 0.4


def test_segments_cycles_and_steps(result):
    moving = [segment for segment in result.segment_list if segment.kind != "rest"]
    assert [segment.kind for segment in moving] == ["cyclic"]
    assert moving[0].label == "A"
    assert moving[0].number == 3
    assert moving[0].carried_by
    assert moving[0].reason == ""
    assert not moving[0].open_begin
    assert np.isnan(moving[0].likeness)
    assert list(result.cycles["begin"]) == [cycle.begin for cycle in result.cycle_list]
    assert list(result.steps["side"]) == [0, 1] * 3
    assert list(result.steps["cycle"]) == [0, 0, 1, 1, 2, 2]
    assert len(result.repetitions) == 0
    assert list(result.summary["label"]) == ["A"]
    assert result.summary["cycle_time_s_mean"][0] == pytest.approx(result.period, abs=0.1)
    assert list(result.segments["kind"]) == [segment.kind for segment in result.segment_list]


def test_the_same_motion_after_pauses():
    motion = 1 - np.cos(np.linspace(0, 2 * np.pi, 45))
    still = np.zeros(40)
    column = np.concatenate([still, *[motion, still] * 4])
    frames = np.stack([column, 0.5 * column**2, np.zeros_like(column)], axis=1)
    found = stltsa.decompose(frames, fps=30)
    assert [one.kind for one in found.segment_list] == ["rest", "repetitions", "rest"]
    assert len(found.repetitions) == 4
    assert found.summary["number"][0] == 4
    assert found.reason == ""


def test_a_body_that_comes_late_and_leaves_early():
    t = np.arange(840) / 100
    swing = np.sin(2 * np.pi * t / 1.05)
    points = np.stack(
        [
            np.stack(
                [
                    1.2 * t + (0.05 + 0.03 * p) * (-1) ** p * swing,
                    0.1 * (-1) ** p + 0.01 * p + 0 * t,
                    0.3 * p + 0 * t,
                ],
                axis=1,
            )
            for p in range(6)
        ],
        axis=1,
    )
    points[:320] = points[690:] = np.nan
    found = stltsa.decompose(stltsa.Clip.from_points(points, fps=100))
    assert [(one.kind, one.begin, one.end) for one in found.segment_list] == [
        ("rest", 0, 320),
        ("cyclic", 320, 690),
        ("rest", 690, 840),
    ]
    assert [one.reason for one in found.segment_list][::2] == ["nothing recorded"] * 2
    assert found.period == pytest.approx(1.05, abs=0.01)
    assert found.unit_list[0].begin == 0
    assert found.unit_list[-1].end == 840


def test_tables_are_frames(result):
    pandas = pytest.importorskip("pandas")
    for table in (result.units, result.cycles):
        assert isinstance(table, pandas.DataFrame)
        assert {"begin", "end", "begin_s", "end_s", "duration_s"} < set(table.columns)
        assert table["begin"].dtype == np.int64
        assert (table["duration_s"] == table["end_s"] - table["begin_s"]).all()
    assert result.cycle_list[result.cycles["best"].argmax()] == result.best_cycle
    assert result.cycles["best"].sum() == result.cycles["representative"].sum() == 1
    assert result.cycles["representative"][0]
    assert "duration_s" in result.segments


def test_curve(result):
    samples = len(result.frames)
    assert result.curve.shape == (samples,)
    assert result.coords.shape == (samples, 2)
    assert np.array_equal(result.coords[:, 0], result.curve)
    assert np.abs(result.curve).max() > 0
    assert result.frames[-1] < len(result.clip)
    assert result.fps == 30


def test_json_and_html(result):
    told = json.loads(result.to_json())
    assert told["format"] == "stltsa-decomposition/2"
    assert [u["begin"] for u in told["units"]] == list(result.units["begin"])
    html = result._repr_html_()
    assert html.count("<rect") == 5
    assert "wind-up" in html
    ElementTree.fromstring(html.replace("&#9632;", "x"))
    assert "preparing 0.." in repr(result)


def test_path_array_and_clip_are_the_same(result, walker, clip):
    assert stltsa.decompose(walker).unit_list == result.unit_list
    array = clip.features("positions")
    assert stltsa.decompose(array, fps=120).unit_list == result.unit_list


def test_array_without_rate_is_decomposed_in_frames(result, clip):
    found = stltsa.decompose(clip.features("positions")[::4])
    assert len(found.cycles) == len(result.cycles)
    assert 4 * found.period_frames == pytest.approx(result.period_frames, abs=1)
    assert result.period_frames == pytest.approx(result.period * 120)
    assert np.abs(4 * np.array(found.cycles["begin"]) - result.cycles["begin"]).max() <= 3
    for table in (found.units, found.cycles, found.segments):
        assert np.isnan(table[["begin_s", "end_s", "duration_s"]]).all(axis=None)
    assert np.isnan(found.period)
    assert np.isnan(found.summary["cycle_time_s_mean"]).all()
    assert (found.fps, found.clip.fps) == (0, 0)
    assert "frame rate is unknown" in found.warnings[0]
    assert "frames" in repr(found)
    assert not re.search(r"\d s\b", found._repr_html_().split("<p>the frame rate")[0])


def test_options_without_rate_are_in_frames(clip):
    frames = clip.features("positions")
    known = stltsa.decompose(frames, fps=30, period_min=1.5, period_max=2.1, smoothing=0.2)
    found = stltsa.decompose(frames, period_min=45, period_max=63, smoothing=6)
    assert list(found.units["end"]) == list(known.units["end"])
    assert found.period_frames == pytest.approx(30 * known.period)
    assert found.period_frames != pytest.approx(stltsa.decompose(frames).period_frames, abs=1)
    with pytest.raises(ValueError, match="period_max is '2s', and the frame rate is unknown"):
        stltsa.decompose(frames, period_max="2s")


def test_rate_is_the_clip_s(result, clip, tmp_path):
    assert stltsa.decompose(clip, fps=120).unit_list == result.unit_list
    np.save(tmp_path / "untold.npy", clip.features())
    untold = stltsa.read_clip(tmp_path / "untold.npy")
    for motion in (clip, untold):
        with pytest.raises(ValueError, match="a Clip has its own"):
            stltsa.decompose(motion, fps=60)
    with pytest.raises(stltsa.ArgumentError, match="open it with option fps"):
        stltsa.decompose(untold)
    assert stltsa.decompose(tmp_path / "untold.npy", fps=120).unit_list == result.unit_list


def test_no_cycle_is_an_answer():
    t = np.linspace(0, 4, 400)
    kick = np.exp(-(((t - 2) / 0.2) ** 2))
    result = stltsa.decompose(np.column_stack([kick, 2 * kick + 0.01 * t]), fps=100)
    assert len(result.cycles) == 0
    assert result.best_cycle is None
    assert result.reason
    assert result.reason in result._repr_html_().replace("&#x27;", "'")


def test_denoise_and_synthesize(clip, model, result):
    done = stltsa.denoise(model)
    assert done.points.shape == done.curve.shape == done.cleaned.shape == (211, 2)
    assert np.allclose(done.points + done.moves, done.cleaned)
    assert list(done.columns["moved"]) == (done.moves != 0).sum(axis=0).tolist()
    assert len(done.columns["gamma"]) == len(done.columns["degrees_of_freedom"]) == 2
    assert min(done.columns["noise"]) > 0
    alone = stltsa.denoise(model.coords, fps=model.fps)
    assert alone.curve.shape == (211, 2)
    assert json.loads(done.to_json())["format"] == "stltsa-denoising/1"

    units = stltsa.synthesize(stltsa.Piece.of(clip, unit) for unit in result.unit_list)
    assert np.allclose(units.clip.features("raw"), clip.features("raw"), atol=1e-6)
    assert len(units.seams) == 0
    best = result.best_cycle
    longer = stltsa.synthesize([(clip, best.begin, best.end, 4)])
    assert len(longer.seams) == 3
    assert longer.seams["posture"].max() < 3
    assert json.loads(longer.to_json())["format"] == "stltsa-synthesis/1"


def test_loops(clip, result):
    """Of a clip, of its decomposition, and of pieces; the last frame meets the first."""
    loop = stltsa.synthesize_loop(result, in_place=True)
    facts = loop.facts
    assert facts["loop"] == facts["in_place"] == 1
    assert facts["loop_cycles"] == facts["source_cycles"] == len(result.cycle_list)
    assert facts["coverage"] == 1
    assert facts["note"]
    assert loop.seam_list[-1].frame == len(loop.clip)
    positions = loop.clip.positions
    steps = np.linalg.norm(np.diff(positions, axis=0), axis=(1, 2))
    assert np.linalg.norm(positions[0] - positions[-1]) < 1.2 * np.percentile(steps, 95)
    going = stltsa.synthesize_loop(clip)
    assert len(going.clip) == len(loop.clip)
    way = (going.clip.positions[-1, 0] - going.clip.positions[0, 0])[[0, 2]]
    assert np.linalg.norm(way) > 0.9 * np.hypot(facts["travel"][0], facts["travel"][2]) > 1

    twice = stltsa.synthesize([stltsa.Piece.of(clip, result.best_cycle, 2)], loop=True)
    assert len(twice.seams) == 2
    with pytest.raises(stltsa.ArgumentError, match="loop"):
        stltsa.synthesize([(clip, 0, 200)], in_place=True)


def test_a_new_clip_outlives_its_synthesis(clip, result):
    new = stltsa.synthesize([(clip, 0, 200)]).clip
    import gc

    gc.collect()
    assert len(new) == 200
    assert np.isfinite(new.positions).all()
    assert stltsa.decompose(clip).unit_list == result.unit_list


def test_pieces_are_checked(clip):
    with pytest.raises(stltsa.ArgumentError):
        stltsa.synthesize([(clip, 200, 100)])
    with pytest.raises(stltsa.ArgumentError):
        stltsa.synthesize([])
    for piece in ("walk.bvh", ("walk.bvh", 0, 10), ()):
        with pytest.raises(TypeError, match=r"a piece is .*or a tuple"):
            stltsa.synthesize([piece])


def test_rows_without_order_are_named(clip):
    rows = clip.features()
    shuffled = rows[np.random.default_rng(0).permutation(len(rows))]
    for options in ({}, {"fps": 30}):
        with pytest.warns(stltsa.QualityWarning, match='order.*mode="spatial", include_self=False'):
            result = stltsa.decompose(shuffled, **options)
        assert sum("no order in time" in text for text in result.warnings) == 1
    stltsa.decompose(rows, fps=clip.fps)  # warnings are errors here
    stltsa.decompose(np.ones((300, 3)), fps=30)


def test_report(result, tmp_path):
    path = tmp_path / "walk.html"
    result.report(path, command="a </script> command")
    page = path.read_text(encoding="utf-8")
    assert page.startswith("<!doctype html>")
    assert "a \\u003c/script> command" in page
    again = tmp_path / "again.html"
    found = stltsa.report(result.clip, again)
    assert found.cycle_list == result.cycle_list
    assert again.read_text(encoding="utf-8").count("</script>") == page.count("</script>") == 2
    with pytest.raises(stltsa.FileError):
        result.report(tmp_path / "none" / "x.html")
    with pytest.raises(ValueError, match="give fps="):
        stltsa.report(result.clip.features(), again)
