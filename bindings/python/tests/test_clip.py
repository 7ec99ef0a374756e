# SPDX-License-Identifier: BSD-3-Clause
import json

import numpy as np
import pytest

import stltsa


def test_walker(clip, walker):
    assert (len(clip), clip.fps, clip.format, clip.path) == (844, 120.0, "bvh", str(walker))
    assert clip.duration == pytest.approx(844 / 120)
    assert clip.joints[0] == "Hips"
    assert clip.parents[0] == -1
    assert (clip.parents[1:] < np.arange(1, len(clip.joints))).all()
    assert clip.end_sites.sum() == 5
    assert json.loads(clip.to_json())["clip"]["frames"] == 844


def test_positions_keep_the_lengths_of_bones(clip):
    bones = clip.positions[:, 1:] - clip.positions[:, clip.parents[1:]]
    lengths = np.linalg.norm(bones, axis=2)
    assert lengths.shape == (844, len(clip.joints) - 1)
    assert np.ptp(lengths, axis=0).max() < 1e-9
    assert not clip.positions.flags.writeable


def test_rotations_are_unit_quaternions(clip):
    norms = np.linalg.norm(clip.rotations, axis=2)
    assert norms == pytest.approx(np.ones_like(norms))


def test_features(clip):
    assert np.array_equal(clip.features(), clip.features("positions"))
    assert clip.features("rotations6d").shape == (844, 6 * int((~clip.end_sites).sum()))
    with pytest.raises(ValueError, match="features is 'colors'"):
        clip.features("colors")


@pytest.mark.parametrize("suffix", ["bvh", "csv", "npy"])
def test_saved_clip_reads_back(clip, tmp_path, suffix):
    path = tmp_path / f"copy.{suffix}"
    clip.save(path)
    again = stltsa.read_clip(path, **({"fps": 120} if suffix == "npy" else {}))
    assert np.array_equal(again.features("raw"), clip.features("raw"))


def test_numbers_have_no_skeleton(circle):
    clip = stltsa.Clip.from_array(circle, 100)
    assert clip.joints == ()
    assert np.array_equal(clip.features(), circle)
    with pytest.raises(NotImplementedError):
        clip.positions  # noqa: B018


def test_path_of_other_bytes(walker, tmp_path):
    path = tmp_path / "été.bvh"
    path.write_bytes(walker.read_bytes())
    assert len(stltsa.read_clip(path)) == 844


def again_from_arrays(clip, rotations=None):
    return stltsa.Clip.from_skeleton(
        clip.joints,
        clip.parents,
        clip.offsets,
        clip.features("raw") if rotations is None else rotations,
        clip.fps,
        channels=clip.joint_channels,
        end_sites=clip.end_sites,
        root_positions=None if rotations is None else clip.positions[:, 0],
    )


def test_a_skeleton_through_arrays_is_the_same_motion(clip, walker, tmp_path):
    again = again_from_arrays(clip)
    assert again.format == "skeleton"
    assert np.array_equal(again.positions, clip.positions)
    assert stltsa.decompose(again).curve.tobytes() == stltsa.decompose(clip).curve.tobytes()
    again.save(tmp_path / "again.bvh")
    clip.save(tmp_path / "clip.bvh")
    assert (tmp_path / "again.bvh").read_bytes() == (tmp_path / "clip.bvh").read_bytes()
    turned = again_from_arrays(clip, clip.rotations)
    assert np.abs(turned.positions - clip.positions).max() < 1e-9
    with pytest.raises(ValueError, match=r"expected \(\d+, 3\)"):
        stltsa.Clip.from_skeleton(["a"], [-1], np.zeros((2, 3)), np.zeros((9, 1, 4)), 30)


def test_joints_in_any_order_are_written(tmp_path):
    """Breadth-first, as body models list them: hip, two knees, two ankles."""
    t = np.arange(60) / 30
    turns = np.zeros((60, 5, 4))
    turns[:, :, 0] = 1
    for joint, side in ((1, 1), (2, -1), (3, 0.5), (4, -0.3)):
        angle = side * np.sin(2 * np.pi * t)
        turns[:, joint, 0], turns[:, joint, 1] = np.cos(angle / 2), np.sin(angle / 2)
    names = ["hip", "left_knee", "right_knee", "left_ankle", "right_ankle"]
    offsets = [[0, 90, 0], [10, -5, 0], [-10, -5, 0], [1, -40, 0], [-1, -40, 3]]
    made = stltsa.Clip.from_skeleton(names, [-1, 0, 0, 1, 2], offsets, turns, 30)
    made.save(tmp_path / "made.bvh")
    again = stltsa.read_clip(tmp_path / "made.bvh")
    assert again.joints[:3] == ("hip", "left_knee", "left_ankle")
    order = [again.joints.index(name) for name in names]
    assert np.abs(again.positions[:, order] - made.positions).max() < 1e-9


def test_points_of_a_skeleton(clip):
    points = stltsa.Clip.from_points(clip.positions, clip.fps, names=clip.joints)
    assert (points.format, points.channels) == ("points", 3 * len(clip.joints))
    found, expected = stltsa.decompose(points), stltsa.decompose(clip)
    assert len(found.cycle_list) == len(expected.cycle_list)
    for one, other in zip(found.cycle_list, expected.cycle_list, strict=True):
        assert abs(one.begin_s - other.begin_s) <= 0.05
        assert abs(one.end_s - other.end_s) <= 0.05


def test_times_of_points(circle):
    points = circle[:, :4].reshape(300, 2, 2)
    times = np.arange(300) / 50
    assert stltsa.Clip.from_points(points, times=times).fps == pytest.approx(50)
    with pytest.raises(stltsa.ArgumentError):
        stltsa.Clip.from_points(points)


def test_stretches(clip, walker, result):
    cyclic = next(u for u in result.unit_list if u.kind == "cyclic")
    longest = clip.stretch("cyclic")
    assert len(longest) == cyclic.end - cyclic.begin
    raw = clip.features("raw")[cyclic.begin : cyclic.end]
    assert np.array_equal(longest.features("raw"), raw)
    for what in ("100-300", "cyclic", "1s-2.5s"):
        one, other = clip.stretch(what), stltsa.read_clip(f"{walker}:{what}")
        assert np.array_equal(one.features("raw"), other.features("raw"))
    assert len(stltsa.decompose(f"{walker}:100-500").curve) == 100
    with pytest.raises(stltsa.NoSuchPartError):
        clip.stretch("Z")


@pytest.mark.parametrize("space", [2, 3])
@pytest.mark.parametrize(
    "names", [None, ("", "b", "c"), ("left\nheel", "b", "c"), ("a", 'the "b"', "")]
)
def test_points_are_read_back_as_points(tmp_path, space, names):
    values = np.random.default_rng(0).normal(size=(50, 3, space))
    values[4, 1] = np.nan
    clip = stltsa.Clip.from_points(values, 50, names=names)
    for suffix, rate in ((".csv", {}), (".npy", {"fps": 50})):
        clip.save(tmp_path / f"walk{suffix}")
        again = stltsa.read_clip(tmp_path / f"walk{suffix}", **rate)
        assert np.array_equal(again.features("raw"), clip.features("raw"))
        assert np.array_equal(again.features(), clip.features())
    assert np.load(tmp_path / "walk.npy").shape == values.shape


@pytest.mark.parametrize("count", [1, 2])
def test_few_points_are_points_from_any_door(tmp_path, count):
    values = np.random.default_rng(0).normal(size=(50, count, 3)).cumsum(axis=0)
    clip = stltsa.Clip.from_points(values, 50)
    clip.save(tmp_path / "few.csv")
    notes = [stltsa.decompose(each).to_json() for each in (clip, tmp_path / "few.csv")]
    assert all('"features":"points"' in text.replace(" ", "") for text in notes)


def test_times_and_rate_agree():
    values = np.random.default_rng(0).normal(size=(100, 4, 3)).cumsum(axis=0)
    times = np.arange(100) / 50
    with pytest.raises(stltsa.ArgumentError, match="fps is 25, but the times are 50 a second"):
        stltsa.Clip.from_points(values, 25, times=times)
    times[60:] += 0.2
    for fps in (None, 50):
        clip = stltsa.Clip.from_points(values, fps, times=times)
        assert (clip.fps, len(clip)) == (50, 110)
