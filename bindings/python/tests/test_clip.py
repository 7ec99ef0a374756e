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
