# SPDX-License-Identifier: BSD-3-Clause
import json
import pickle

import numpy as np
import pytest

import stltsa


def test_known_curve(circle):
    model = stltsa.fit(circle, neighbors=100)
    assert model.coords.shape == (300, 2)
    assert model.coords.T @ model.coords == pytest.approx(np.eye(2), abs=1e-9)
    assert model.eigenvalues.shape == (1, 4)
    assert (np.diff(model.eigenvalues[0]) > 0).all()
    assert (model.mode, model.neighbors, model.window, len(model)) == ("temporal", 100, 100, 300)
    assert model.n_features == 5


def test_map_gives_back_what_was_fitted(circle):
    model = stltsa.fit(circle, neighbors=100)
    mapped = model.map(circle)
    assert np.array_equal(mapped.values, model.coords)
    assert np.array_equal(mapped.nearest, np.arange(300))
    assert (mapped.distance == 0).all()
    assert model.map(circle + 100).distance.min() > 1


def test_unmap_comes_near_the_frames(circle):
    model = stltsa.fit(circle, neighbors=100)
    back = model.unmap(model.coords, hints=np.arange(300))
    assert np.abs(back.values - circle).max() < 0.05 * np.abs(circle).max()


def test_hints_say_where_to_look(circle):
    model = stltsa.fit(circle, neighbors=100)
    hints = np.full(300, 200, dtype=np.int32)
    for mapped in (
        model.map(circle, hints=hints, hint_window=20),
        model.unmap(model.coords, hints=hints, hint_window=20),
    ):
        assert mapped.nearest.min() >= 180
        assert mapped.nearest.max() <= 220


def test_hints_are_checked(circle):
    model = stltsa.fit(circle, neighbors=100)
    for hints in (np.arange(10), np.zeros(300), [[0]] * 300):
        with pytest.raises(ValueError, match="300 integers"):
            model.map(circle, hints=hints)


def test_clip_is_mapped_frame_by_frame(clip, model):
    mapped = model.map(clip)
    assert mapped.values.shape == (len(clip), 2)
    assert np.array_equal(mapped.values[model.frames], model.coords)


def test_paths_and_lists_are_taken(circle, walker, clip, model):
    assert np.array_equal(stltsa.fit(walker).coords, model.coords)
    assert np.array_equal(model.map(str(walker)).values, model.map(clip).values)
    assert stltsa.dimension(walker).model.to_json() == stltsa.dimension(clip).model.to_json()
    halves = [circle[:150], circle[150:]]
    two = stltsa.fit(halves, neighbors=60)
    assert np.array_equal(two.map(halves).values, two.coords)


def test_poses(clip, model):
    poses = model.poses(model.coords[:50], hints=np.arange(50))
    assert (len(poses), poses.joints) == (50, clip.joints)
    assert poses.fps == model.fps


def test_bytes_files_and_pickles(model, tmp_path):
    model.save(tmp_path / "walk.stltsa")
    for again in (
        stltsa.Model.from_bytes(model.to_bytes()),
        stltsa.Model.load(tmp_path / "walk.stltsa"),
        pickle.loads(pickle.dumps(model)),
    ):
        assert np.array_equal(again.coords, model.coords)
        assert again.to_json() == model.to_json()
    with pytest.raises(stltsa.FormatError):
        stltsa.Model.from_bytes(model.to_bytes()[:-9])
    with pytest.raises(stltsa.FormatError):
        stltsa.Model.from_bytes(b"")


def test_models_are_shared_between_threads(circle):
    from concurrent.futures import ThreadPoolExecutor

    model = stltsa.fit(circle, neighbors=100)
    with ThreadPoolExecutor(4) as pool:
        results = list(pool.map(lambda _: model.map(circle).values, range(8)))
        fits = list(pool.map(lambda _: stltsa.fit(circle, neighbors=100).coords, range(8)))
    assert all(np.array_equal(r, model.coords) for r in results + fits)


def test_json(model):
    assert json.loads(model.to_json())["format"] == "stltsa-model/1"
    assert "211 rows, 69 features -> 2" in repr(model)


def test_correlation_with_time_is_said(circle):
    model = stltsa.fit(circle, neighbors=5)
    assert any("time" in text for text in model.warnings)
    assert model.time_correlation > 0.9


def test_dimension(circle, clip):
    found = stltsa.dimension(circle, neighbors=100)
    assert found.local_pca == 2
    assert found.eigenvalues[0] == 0
    assert found.local_variances[:2].sum() > 0.99
    told = json.loads(found.model.to_json())
    assert told["local_pca"]["dimension"] == 2
    assert told["eigengap"]["eigenvalues"] == list(found.eigenvalues)
    assert stltsa.dimension(clip).local_pca in (1, 2, 3)
    apart = stltsa.dimension([circle[:150], circle[150:]], neighbors=20)
    assert apart.eigengap is None
    assert apart.reasons


def test_several_clips_are_fitted_together(clip, walker):
    both = stltsa.fit([clip, walker], neighbors=36)
    alone = stltsa.fit(clip, neighbors=36)
    rows = len(alone)
    assert both.facts["length"] == (rows, rows)
    assert both.n_components == 2
    assert both.coords[:rows] == pytest.approx(alone.coords, abs=1e-8)
    assert np.array_equal(both.frames, np.tile(alone.frames, 2))
    assert np.array_equal(both.map(clip).values[alone.frames], both.coords[:rows])
    assert len(stltsa.dimension([clip, clip], neighbors=36).model) == 2 * rows
    with pytest.raises(stltsa.ShapeError, match="only one has a skeleton"):
        stltsa.fit([clip, stltsa.Clip.from_array(alone.coords, 120)])
    with pytest.raises(ValueError, match="a clip of its own"):
        stltsa.fit([clip, clip], groups=[0, 1])


def rows_of_cycles(period=50, rows=500):
    t = 2 * np.pi * np.arange(rows) / period
    noise = np.random.default_rng(3).normal(scale=0.02, size=(rows, 3))
    return np.column_stack([np.cos(t), np.sin(t), np.sin(2 * t)]) + noise


def test_the_period_of_rows_without_a_rate_is_looked_for_in_rows():
    rows = rows_of_cycles()
    model, timed = stltsa.fit(rows), stltsa.fit(rows, fps=50)
    assert model.neighbors == timed.neighbors == 60
    assert model.period == 0
    assert model.period_frames == pytest.approx(timed.period_frames, abs=0.1)
    assert timed.period_frames == pytest.approx(50 * timed.period)
    assert json.loads(model.to_json())["period_s"] is None
    assert json.loads(model.to_json())["parameters"]["period_max_s"] is None
    again = pickle.loads(pickle.dumps(model))
    assert again.period_frames == model.period_frames
    assert stltsa.dimension(rows).model.neighbors == 60
    # Nor is the period of a shorter range found.
    assert stltsa.fit(rows, period_max=40).neighbors == 12
    with pytest.raises(stltsa.ArgumentError, match=r"300 frames, longer than .* 250 frames"):
        stltsa.fit(rows, period_min=300, period_max=250)
    with pytest.raises(ValueError, match="rate is unknown"):
        stltsa.fit(rows, period_max="1s")


def test_rows_in_no_order_have_no_period():
    random = np.random.default_rng(0)
    for rows in (100, 300, 1000):
        with pytest.warns(stltsa.QualityWarning, match='mode="spatial", include_self=False'):
            assert stltsa.fit(random.normal(size=(rows, 5))).neighbors == 12
    assert stltsa.fit(rows_of_cycles(), mode="spatial").neighbors == 12


def test_knots_follow_the_period_of_rows():
    cleaned = stltsa.denoise(rows_of_cycles(100))
    assert cleaned.facts["knot_rows"] == pytest.approx(10, abs=0.1)
