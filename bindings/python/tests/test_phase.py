# SPDX-License-Identifier: BSD-3-Clause
"""Phases, and signals on 0 to 100 % of the cycles."""

import numpy as np
import pytest

import stltsa


@pytest.fixture(scope="module")
def phase(result):
    return result.phase()


def test_frames_of_cycles_have_phases(result, phase):
    inside = np.zeros(len(result.clip), bool)
    for index, cycle in enumerate(result.cycle_list):
        assert (phase.cycle[cycle.begin : cycle.end] == index).all()
        inside[cycle.begin : cycle.end] = True
    assert (np.isnan(phase.values) == ~inside).all()
    assert (np.isnan(phase.residual) == ~inside).all()
    steps = np.diff(phase.values[inside]) % 1
    assert (steps > 0).all()
    assert (steps < 0.1).all()
    assert not phase.warnings
    assert f"{inside.sum()} in cycles" in repr(phase)


def test_the_same_place_in_both_feet_of_another_walk(clip, phase):
    """A stretch that begins half a cycle later has the same phases, counted from their zeros."""
    other = stltsa.decompose(clip.stretch("100-")).phase()
    both = ~np.isnan(phase.values[100:]) & ~np.isnan(other.values)
    off = phase.values[100:][both] - phase.zero() - other.values[both] + other.zero()
    off = (off + 0.5) % 1 - 0.5
    assert both.sum() > 100
    assert abs(off).max() < 0.02
    assert 0 <= phase.zero("A") < 1
    with pytest.raises(stltsa.ArgumentError, match="neither cycles"):
        phase.zero("Z")


def test_signals_are_resampled(result, phase):
    frames = np.arange(len(result.clip), dtype=np.float64)
    cycles = phase.resample(frames)
    assert len(cycles) == len(result.cycle_list)
    assert cycles.each.shape == (len(cycles), 101, 1)
    np.testing.assert_allclose(cycles.each[..., 0], cycles.frames)
    np.testing.assert_allclose(cycles.mean, np.nanmean(cycles.each, axis=0))
    np.testing.assert_allclose(cycles.sd, np.nanstd(cycles.each, axis=0, ddof=1))
    np.testing.assert_allclose(cycles.frames[:-1, -1], cycles.frames[1:, 0])
    assert np.nanmax(abs(cycles.warp)) < 0.1
    assert cycles.distance.shape == (len(cycles),)
    apart = np.sqrt(np.nanmean((cycles.each - cycles.mean)[:, :-1] ** 2, axis=1))
    np.testing.assert_allclose(cycles.column_distance, apart)
    features = phase.resample(result.clip.features(), samples=51)
    assert repr(features).endswith(f"of 51 samples x {result.clip.features().shape[1]}>")
    assert np.nanmax(features.distance) < 0.2


def test_a_missing_value_is_left_out(result, phase):
    frames = np.ones(len(result.clip))
    frames[result.cycle_list[1].begin + 3 :][:4] = np.nan
    cycles = phase.resample(frames)
    assert np.isnan(cycles.each[1]).any()
    np.testing.assert_array_equal(cycles.mean, 1)


def test_borders_may_be_given():
    signal = np.random.default_rng(3).random((90, 2))
    borders = [3.25, 30, 51.5, 88.75]
    cycles = stltsa.cycles_between(borders, signal, samples=33)
    for begin, end, values in zip(borders, borders[1:], cycles.each, strict=False):
        at = np.linspace(begin, end, 33)
        for column in range(2):
            expected = np.interp(at, np.arange(90), signal[:, column])
            np.testing.assert_allclose(values[:, column], expected, atol=1e-12)
    assert abs(cycles.warp).max() < 1e-12


def test_a_mark_is_found_in_every_cycle(result, phase):
    events = phase.events(250)
    assert events.likeness == 1
    (mark,) = (e for e in events if e.marked)
    assert mark.frame == 250
    later = [e for e in events if e.cycle > mark.cycle]
    assert len(later) == 2
    for number, event in enumerate(later, 1):
        assert event.frame == pytest.approx(250 + 132 * number, abs=0.25)
        assert event.seconds == pytest.approx(event.frame / result.clip.fps)
        assert event.confidence > 0.9
    assert len(phase.events([250, 382])) == len(events)


def test_marks_at_two_places_are_two_events(phase):
    events = phase.events([250, 316])
    assert [e.frame for e in events if e.marked] == [250, 316]
    assert "2 places in the cycle" in events.warnings[0]
    assert phase.events(250).warnings == ()


def test_without_a_rate_there_are_no_seconds(clip):
    events = stltsa.decompose(clip.features()).phase().events(250)
    assert len(events) >= 3
    assert all(np.isnan(e.seconds) for e in events)


def test_labels_of_a_file_are_marks(result, phase):
    labels = [
        stltsa.FileEvent("Foot Strike", "Left", 250, 250 / 120),
        stltsa.FileEvent("Foot Strike", "Right", 316, 316 / 120),
        stltsa.FileEvent("Start", "", 2, 2 / 120),
    ]
    with pytest.warns(stltsa.QualityWarning, match="Start is left out: none of its labels"):
        found = phase.events_like(labels)
    assert list(found) == ["Left Foot Strike", "Right Foot Strike"]
    for label, events in zip(labels, found.values(), strict=False):
        name = f"{label.context} {label.label}"
        assert events == phase.events(label.frame, name=name)
        assert events.side == label.context.lower()
    assert phase.events(250).side == ""


def test_labels_of_one_name_are_searched_once(result, phase, monkeypatch):
    calls, events = [], type(phase).events

    def counted(self, marks, other=None, **options):
        calls.append(marks)
        return events(self, marks, other, **options)

    monkeypatch.setattr(type(phase), "events", counted)
    labels = [stltsa.FileEvent("Foot Strike", "Left", at, at / 120) for at in (250, 382)]
    found = phase.events_like(labels)
    assert len(calls) == 1
    outside = stltsa.FileEvent("Foot Strike", "Left", 2, 2 / 120)
    with pytest.warns(stltsa.QualityWarning, match="1 of 3 labels are left out") as warned:
        assert phase.events_like([*labels, outside]) == found
    assert [each.filename for each in warned] == [__file__]


def test_labels_all_over_the_cycle_are_left_out(result, phase):
    labels = [stltsa.FileEvent("Frame", "", at, at / 120) for at in range(250, 382, 10)]
    labels.append(stltsa.FileEvent("Foot Strike", "Left", 250, 250 / 120))
    with pytest.warns(stltsa.QualityWarning, match="Frame is left out: 14 marks") as warned:
        found = phase.events_like(labels)
    assert [each.filename for each in warned] == [__file__]
    assert list(found) == ["Left Foot Strike"]
    assert found["Left Foot Strike"] == phase.events(250, name="left")


def test_labels_need_no_rate(clip):
    phase = stltsa.decompose(clip.features()).phase()
    assert phase.events_like([]) == {}
    label = stltsa.FileEvent("Foot Strike", "Left", 250, np.nan)
    assert phase.events_like([label])["Left Foot Strike"] == phase.events(250)


def test_joints_have_distances(clip, phase):
    cycles = phase.resample(clip.features())
    owners = phase.column_owners
    assert len(owners) == clip.features().shape[1]
    found = cycles.group_distance(owners)
    for name, distance in found.items():
        columns = [i for i, owner in enumerate(owners) if owner == name]
        expected = np.sqrt((cycles.column_distance[:, columns] ** 2).sum(axis=1))
        np.testing.assert_allclose(distance, expected, atol=1e-12)


def test_repetitions_have_a_mean():
    t = np.arange(600) % 200 / 30.0
    pulse = np.where(t < 2, np.sin(np.pi * t / 2) ** 2, 0)
    random = np.random.default_rng(5)
    signals = np.outer(pulse, random.normal(size=6)) + np.outer(
        np.roll(pulse, 9), random.normal(size=6)
    )
    result = stltsa.decompose(signals + random.normal(scale=1e-3, size=signals.shape), fps=30)
    assert len(result.repetitions) >= 2
    assert not result.cycle_list
    cycles = result.phase().resample(pulse)
    assert len(cycles) == len(result.repetitions)
    assert np.nanmax(cycles.mean) > 0.9


def test_a_mark_is_found_in_another_clip(clip, phase):
    other = stltsa.decompose(clip.stretch("170-600")).phase()
    events = phase.events(250, other)
    assert events.likeness > 0.99
    turns = [(e.frame + 170 - 250) / 132 for e in events if e.cycle >= 0]
    assert len(turns) >= 2
    np.testing.assert_allclose(turns, np.round(turns), atol=0.02)


def test_a_stream_has_the_phase_of_the_clip(clip, phase, tmp_path):
    model = stltsa.fit(clip)
    assert not model.has_cycle
    with pytest.raises(stltsa.UnsupportedError, match="keeps no mean cycle"):
        stltsa.Live(model)
    model.keep_cycle(phase, {"strike": 250, "off": 288})
    model.save(tmp_path / "walk.stltsa")
    loaded = stltsa.Model.load(tmp_path / "walk.stltsa")
    assert loaded.has_cycle
    one, two = stltsa.Live(model), stltsa.Live(loaded)
    assert one.marks == ("strike", "off")
    seen = []
    for i, row in enumerate(clip.features()):
        seen.append(one.push(row, i / clip.fps))
        assert seen[-1] == two.push(row, i / clip.fps)
    inside = ~np.isnan(phase.values)
    off = (np.array([f.phase for f in seen]) - phase.values + 0.5) % 1 - 0.5
    assert np.median(abs(off[inside])) < 0.005
    assert (
        sum("off" in f.events for f, cycle in zip(seen, phase.cycle, strict=True) if cycle >= 0)
        == 3
    )
    assert seen[400].kind == "cyclic"
    assert seen[-1].kind == "rest"
    missing = one.push(np.full(clip.features().shape[1], np.nan), 99.0)
    assert not missing.known
    assert np.isnan(missing.distance)


def test_poses_and_frames_are_pushed_as_they_come(clip, phase):
    model = stltsa.fit(clip)
    model.keep_cycle(phase)
    streams = [stltsa.Live(model) for _ in range(4)]
    turns, values = clip.rotations, clip.features(features="raw")
    for i in range(200, 300):
        w, x, y, z = turns[i].T
        matrices = np.stack(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
            ]
        ).transpose(2, 0, 1)
        seen = [
            streams[0].push_frame(clip, i),
            streams[1].push_pose(turns[i], i / clip.fps, root_position=[0, 90, 0]),
            streams[2].push_pose(matrices, i / clip.fps),
            streams[3].push_pose(values[i], i / clip.fps),
        ]
        np.testing.assert_allclose([f.phase for f in seen], seen[0].phase, atol=1e-5)
    assert abs(seen[0].phase - phase.values[299]) < 0.03
    with pytest.raises(ValueError, match="rotations must be of the shape"):
        streams[1].push_pose(np.zeros((2, 2, 2, 2)), 99)
    with pytest.raises(stltsa.UnsupportedError, match="without points"):
        streams[1].push_points(np.zeros((4, 3)), 99)
    with pytest.raises(stltsa.ArgumentError, match="frame 1000000 does not exist"):
        streams[0].push_frame(clip, 1000000, 99)


def test_points_are_pushed_as_they_come(clip):
    points = clip.positions.reshape(len(clip), -1, 3)
    markers = stltsa.Clip.from_points(points, clip.fps)
    phase = stltsa.decompose(markers).phase()
    model = stltsa.fit(markers)
    model.keep_cycle(phase)
    whole, lossy = stltsa.Live(model), stltsa.Live(model)
    for i in range(150, 400):
        sure = (np.arange(points.shape[1]) + i // 10) % 9 > 0
        a = whole.push_points(points[i], i / clip.fps)
        b = lossy.push_points(points[i] + [300, 0, 90], i / clip.fps, sure)
        if i > 200 and not np.isnan(phase.values[i]):
            assert abs((a.phase - b.phase + 0.5) % 1 - 0.5) < 0.01
            assert abs((a.phase - phase.values[i] + 0.5) % 1 - 0.5) < 0.03
    with pytest.raises(stltsa.ShapeError, match="points is"):
        whole.push_points(points[0, :3], 99)
    with pytest.raises(stltsa.UnsupportedError, match="without a skeleton"):
        whole.push_pose(clip.rotations[0], 99)


def test_errors_say_what_is_wrong(phase):
    with pytest.raises(stltsa.ArgumentError, match="no motion that repeats"):
        phase.events(2)
    with pytest.raises(stltsa.ArgumentError, match="label Z has neither cycles nor repetitions"):
        phase.resample(np.zeros(len(phase.values)), label="Z")
    with pytest.raises(ValueError, match="no motion has so many labels"):
        phase.resample(np.zeros(len(phase.values)), label=20 * "Z")
    with pytest.raises(ValueError, match="letters such as 'A'"):
        phase.resample(np.zeros(len(phase.values)), label=0)
    with pytest.raises(stltsa.ShapeError, match="signals has 3 rows"):
        phase.resample([1.0, 2.0, 3.0])
    with pytest.raises(stltsa.ArgumentError, match="border 1"):
        stltsa.cycles_between([5, 5], np.zeros(9))


def test_marks_are_found_on_the_other_side(clip, result):
    image = stltsa.decompose(clip.mirrored()).phase()
    found = result.phase().events(250, image)
    turns = [(event.frame - 250) / 132 for event in found if event.cycle is not None]
    assert len(turns) >= 2
    assert np.asarray(turns) % 1 == pytest.approx(0.5, abs=0.03)


def test_sides_of_signals_have_known_differences():
    turn = 2 * np.pi * np.arange(201) / 100
    knees = np.stack([np.sin(turn), 0.8 * np.sin(turn - 1.1 * np.pi) + 0.1], axis=1)
    cycles = stltsa.cycles_between([0, 100, 200], knees)
    compared = cycles.compare_left_right(["knee_l", "knee_r"], fps=50)
    (pair,) = compared.parts
    assert (pair.first, pair.second) == ("knee_l", "knee_r")
    assert pair.lag.difference == pytest.approx(0.05, abs=1e-3)
    assert pair.mean.difference == pytest.approx(0.1)
    assert pair.amplitude_ratio.value == pytest.approx(0.8, abs=1e-2)
    assert [motion.cycles for motion in compared.motions] == [2, 2]
    assert compared.whole.cycle_time_s.first == pytest.approx(2)
    assert np.isnan(cycles.compare_left_right(["knee_l", "knee_r"]).whole.cycle_time_s.first)
    with pytest.raises(stltsa.UnsupportedError, match="differ only in the side"):
        cycles.compare_left_right(["knee_l", "hip_r"])
    with pytest.raises(ValueError, match="names has 1"):
        cycles.compare_left_right(["knee_l"])
