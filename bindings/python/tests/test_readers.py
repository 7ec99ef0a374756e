# SPDX-License-Identifier: BSD-3-Clause
"""C3D, TRC, MOT, AMASS files and datasets of `movement`, as clips."""

import contextlib
import io
import json
import re
import zipfile

import numpy as np
import pytest

import stltsa

NAMES = ("HEAD", "LTOE", "RTOE", "LELB", "RELB")


def walk(frames=400):
    """Positions of five markers in mm, 100 a second, with a period of 1 s; the second has gaps."""
    t = np.arange(frames)[:, None, None] / 100
    phase = np.arange(5)[None, :, None]
    values = 300 * np.sin(2 * np.pi * t + phase + np.arange(3)) * [1, 0.5, 0.2]
    values += [[0, 0, 1700], [100, 200, 50], [-100, 0, 50], [300, 0, 1000], [-300, 0, 1000]]
    values[40:54, 1] = np.nan
    return values


def write_trc(path, values, names=NAMES):
    head = [
        f"PathFileType\t4\t(X/Y/Z)\t{path.name}",
        "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits",
        f"100.00\t100.00\t{len(values)}\t{len(names)}\tmm",
        "Frame#\tTime\t" + "\t\t\t".join(names) + "\t\t",
        "\t\t" + "\t".join(f"{a}{i}" for i in range(1, len(names) + 1) for a in "XYZ"),
        "",
    ]
    rows = []
    for i, row in enumerate(values.reshape(len(values), -1)):
        cells = ["" if np.isnan(v) else repr(float(v)) for v in row]
        rows.append("\t".join([str(i + 1), f"{i / 100:.4f}", *cells]))
    path.write_text("\n".join(head + rows) + "\n")
    return path


def write_c3d(path, values, names=NAMES, events=(), first=0):
    ezc3d = pytest.importorskip("ezc3d")
    file = ezc3d.c3d()
    file["header"]["points"]["first_frame"] = first
    file["parameters"]["POINT"]["RATE"]["value"] = [100]
    file["parameters"]["POINT"]["LABELS"]["value"] = names
    points = np.ones((4, values.shape[1], len(values)))
    points[:3] = np.nan_to_num(values).transpose(2, 1, 0)
    file["data"]["points"] = points
    missing = np.isnan(values).any(axis=2).T
    file["data"]["meta_points"]["residuals"] = np.where(missing, -1.0, 0.0)[np.newaxis]
    masks = np.zeros((7, values.shape[1], len(values)), dtype=bool)
    file["data"]["meta_points"]["camera_masks"] = masks
    for minutes, seconds, context, label in events:
        file.add_event(time=[minutes, seconds], context=context, label=label)
    file.write(str(path))
    return path


def gap_notes(result):
    return [n for n in json.loads(result.to_json())["clip"]["notes"] if "missing" in n]


def borders(result):
    return np.array([(c.begin, c.end) for c in result.cycle_list])


def test_points_csv_trc_and_c3d_are_the_same_motion(tmp_path):
    values = walk()
    points = stltsa.Clip.from_points(values, 100, names=NAMES)
    head = ",".join(f"{name}_{axis}" for name in NAMES for axis in "xyz")
    text = [",".join("" if np.isnan(v) else repr(float(v)) for v in row)
            for row in values.reshape(len(values), -1)]  # fmt: skip
    (tmp_path / "a.csv").write_text("\n".join([head, *text]) + "\n")
    clips = [
        points,
        stltsa.read_clip(tmp_path / "a.csv", fps=100),
        stltsa.read_clip(write_trc(tmp_path / "a.trc", values)),
        stltsa.read_clip(write_c3d(tmp_path / "a.c3d", values)),
    ]
    first = borders(stltsa.decompose(points, up_axis="z"))  # TRC files have y up
    assert len(first) == 3
    for clip in clips:
        assert len(clip) == 400
        assert clip.fps == 100
        found = stltsa.decompose(clip, up_axis="z")
        assert np.abs(borders(found) - first).max() <= 1
        assert gap_notes(found), clip


def test_gaps_can_be_refused(tmp_path):
    path = write_trc(tmp_path / "walk.trc", walk())
    with pytest.raises(stltsa.NotFiniteError, match="LTOE"):
        stltsa.decompose(path, gaps="refuse")


def test_events_of_c3d(tmp_path):
    events = [(0, 2.5, "Right", "Foot Strike"), (0, 1.0, "Left", "Foot Off")]
    path = write_c3d(tmp_path / "walk.c3d", walk(), events=events, first=50)
    clip = stltsa.read_clip(path)
    assert [event[:2] for event in clip.events] == [("Foot Off", "Left"), ("Foot Strike", "Right")]
    assert [event.seconds for event in clip.events] == pytest.approx([0.5, 2.0])
    part = stltsa.read_clip(f"{path}:1s-3s")
    assert [event.seconds for event in part.events] == pytest.approx([1.0])
    assert len(part) == 200


@pytest.mark.parametrize(("points", "frames"), [(5, 400), (300, 20), (1, 70000)])
def test_c3d_is_read_as_by_ezc3d(tmp_path, points, frames):
    ezc3d = pytest.importorskip("ezc3d")
    rng = np.random.default_rng(1)
    values = rng.normal(size=(frames, points, 3))
    values[frames // 2 :, 0][:3] = np.nan
    names = tuple(f"m{p}" for p in range(points))
    path = write_c3d(tmp_path / "a.c3d", values, names=names)
    clip = stltsa.read_clip(path)
    clip.save(tmp_path / "a.npy")
    file = ezc3d.c3d(str(path))
    expected = file["data"]["points"][:3].transpose(2, 1, 0)[:frames]
    np.testing.assert_array_equal(np.load(tmp_path / "a.npy")[: len(expected)], expected)
    assert len(clip) == frames
    assert clip.facts["channel"][::3] == tuple(f"{name}_x" for name in names)


def test_points_that_a_model_computed_are_left_out(tmp_path):
    ezc3d = pytest.importorskip("ezc3d")
    path = write_c3d(tmp_path / "walk.c3d", walk())
    file = ezc3d.c3d(str(path))
    file.add_parameter("POINT", "ANGLES", ["HEAD"])
    file.write(str(path))
    assert stltsa.read_clip(path).channels == 12


def test_points_that_are_named_as_results_of_a_model(tmp_path):
    names = ("LHipAngles", "Powerpoint", "LForceps", "LELB", "RELB")
    path = write_c3d(tmp_path / "walk.c3d", walk(), names=names)
    clip = stltsa.read_clip(path)
    assert clip.channels == 12
    assert any("left out" in n and n.endswith(": 'LHipAngles'") for n in clip.facts["note"])


def test_mot(tmp_path):
    path = tmp_path / "walk.mot"
    rows = [f"{i / 50}\t{np.sin(i / 8)}\t{np.cos(i / 8)}" for i in range(100)]
    path.write_text("walk\nversion=1\nnRows=100\nnColumns=3\ninDegrees=yes\nendheader\n"
                    "time\thip\tknee\n" + "\n".join(rows) + "\n")  # fmt: skip
    clip = stltsa.read_clip(path)
    assert clip.fps == 50
    assert clip.format == "mot"
    assert list(clip.facts["channel"]) == ["hip", "knee"]
    expected = np.column_stack([np.sin(np.arange(100) / 8), np.cos(np.arange(100) / 8)])
    assert clip.features() == pytest.approx(expected)


def test_amass(tmp_path):
    t = np.arange(240) / 60
    poses = np.zeros((240, 156))
    poses[:, 3] = 0.5 * np.sin(2 * np.pi * t)  # the left hip, about x
    trans = np.column_stack([0 * t, 0 * t, t])
    np.savez(tmp_path / "walk.npz", poses=poses, trans=trans, mocap_framerate=60.0)
    clip = stltsa.read_clip(tmp_path / "walk.npz")
    assert (len(clip), clip.fps, len(clip.joints)) == (240, 60, 22)
    knee, hip = (clip.joints.index(name) for name in ("left_knee", "left_hip"))
    bone = clip.positions[:, knee] - clip.positions[:, hip]
    assert np.linalg.norm(bone, axis=1) == pytest.approx(np.linalg.norm(clip.offsets[knee]))
    angle = poses[15, 3]
    y, z = clip.offsets[knee][1:]
    turned = (y * np.cos(angle) - z * np.sin(angle), y * np.sin(angle) + z * np.cos(angle))
    assert bone[15, 1:] == pytest.approx(turned)
    assert clip.positions[60, 0, 2] - clip.positions[0, 0, 2] == pytest.approx(1)
    parts = {"root_orient": poses[:, :3], "pose_body": poses[:, 3:66]}
    np.savez(tmp_path / "x.npz", **parts, trans=trans, mocap_frame_rate=60.0)
    again = stltsa.read_clip(tmp_path / "x.npz")
    assert np.array_equal(again.positions, clip.positions)
    np.savez(tmp_path / "other.npz", other=poses)
    with pytest.raises(stltsa.FormatError, match=r"has the arrays poses .*has other"):
        stltsa.read_clip(tmp_path / "other.npz")


AMASS = {"poses": np.ones((50, 66)), "trans": np.zeros((50, 3)), "mocap_framerate": 60.0}
NOT_FINITE = np.where(np.arange(50)[:, np.newaxis] == 7, np.nan, AMASS["poses"])


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"mocap_framerate": [60.0, 30.0]}, r"mocap_framerate is \[60. 30.\], and must be one"),
        ({"mocap_framerate": "60"}, "mocap_framerate is '60', and must be one number"),
        ({"mocap_framerate": np.nan}, "mocap_framerate is nan"),
        ({"mocap_framerate": 1e30}, "mocap_framerate is 1"),
        ({"poses": np.ones((50, 5))}, r"poses is 50 x 5, and must be 50 \(as trans\) x 3 n"),
        ({"poses": np.ones((49, 66))}, r"poses is 49 x 66, and must be 50 \(as trans\) x 3 n"),
        ({"poses": np.ones((50, 0))}, "poses is 50 x 0, and must be frames x n"),
        ({"poses": np.ones((0, 66))}, "poses is 0 x 66"),
        ({"poses": np.ones((50, 22, 3))}, "poses is 50 x 22 x 3, and must be frames x n"),
        ({"poses": np.array(1.0)}, "poses is one number"),
        ({"poses": AMASS["poses"] + 1j}, "poses holds complex128, and must hold real numbers"),
        ({"poses": [["a"] * 66] * 50}, "poses holds <U1, and must hold real numbers"),
        ({"poses": np.full((50, 66), None)}, "the file cannot be read: Object arrays"),
        ({"poses": NOT_FINITE}, "poses has a number in frame 7 that is NaN or beyond 1e[+]100"),
        ({"poses": np.full((50, 66), 1e300)}, "poses has a number in frame 0"),
        ({"trans": np.zeros((50, 2))}, "trans is 50 x 2, and must be frames x 3"),
        ({"poses": np.zeros((20000, 600))}, r"poses.npy would have 96000128 bytes, of which \d+"),
    ],
)
def test_amass_files_with_other_numbers(tmp_path, changes, said):
    path = tmp_path / "walk.npz"
    np.savez_compressed(path, **{**AMASS, **changes})
    with pytest.raises(stltsa.FormatError, match=f"^{re.escape(str(path))}: {said}"):
        stltsa.read_clip(path)


def test_broken_archives(tmp_path):
    """Whatever the parts of an archive raise; and sizes that are not true take no memory."""
    path = tmp_path / "walk.npz"
    poses = np.random.default_rng(0).normal(size=(50, 66))
    np.savez_compressed(path, **{**AMASS, "poses": poses})
    whole, random = path.read_bytes(), np.random.default_rng(1)
    for _ in range(300):
        changed = np.frombuffer(whole, np.uint8).copy()
        changed[random.integers(len(whole), size=2)] = random.integers(256, size=2)
        changed[random.integers(300)] ^= 1 << random.integers(8)
        path.write_bytes(changed)
        with contextlib.suppress(stltsa.FormatError):  # some bytes do not matter
            stltsa.read_clip(path)
    with zipfile.ZipFile(path, "w") as archive:
        for name, values in AMASS.items():
            data = io.BytesIO()
            np.save(data, values)
            text = data.getvalue().replace(b"(50, 66), }        ", b"(500000000000, 66), }")[:128]
            archive.writestr(f"{name}.npy", text + data.getvalue()[128:])
    with pytest.raises(stltsa.FormatError, match="the file cannot be read"):
        stltsa.read_clip(path)
    np.save(tmp_path / "a.npy", poses)
    (tmp_path / "a.npy").rename(path)
    with pytest.raises(stltsa.FormatError, match="it is no npz archive"):
        stltsa.read_clip(path)


def two_individuals(path):
    """Write a file of DeepLabCut: two individuals, the second twice as fast."""
    names = [
        (who, joint) for who in ("mouse1", "mouse2") for joint in ("nose", "hip", "tail", "ear")
    ]
    head = [
        ["scorer", *["net"] * 24],
        ["individuals", *(who for who, _ in names for _ in range(3))],
        ["bodyparts", *(joint for _, joint in names for _ in range(3))],
        ["coords", *["x", "y", "likelihood"] * 8],
    ]
    rows = []
    for i in range(300):
        row = [str(i)]
        for place, (who, _) in enumerate(names):
            turn = 2 * np.pi * i / (30 if who == "mouse1" else 15) + place
            row += [f"{place + np.sin(turn):.4f}", f"{place % 3 + np.cos(turn):.4f}", "1"]
        rows.append(row)
    path.write_text("".join(",".join(row) + "\n" for row in head + rows))
    return path


def test_individuals_of_files(tmp_path):
    path = two_individuals(tmp_path / "mice.csv")
    periods = [
        stltsa.decompose(path, fps=30, individual=name).period for name in ("mouse1", "mouse2")
    ]
    assert periods == pytest.approx([1.0, 0.5], abs=0.02)
    second = stltsa.decompose(path, fps=30, individual="mouse2").to_json()
    assert "subject 'mouse2' of 2: 'mouse1', 'mouse2'" in second
    with pytest.raises(
        stltsa.ArgumentError, match="'mouse1', 'mouse2': choose one with option indiv"
    ):
        stltsa.decompose(path, fps=30)
    with pytest.raises(stltsa.ArgumentError, match="'cat', but the subjects are"):
        stltsa.read_clip(path, individual="cat")


def dataset(individuals=("mouse1", "mouse2")):
    """Return a dataset as `movement` makes it: two individuals, the second twice as fast."""
    xarray = pytest.importorskip("xarray")
    t = np.arange(300) / 30
    keypoints = ("nose", "left", "right", "tail")
    position = np.empty((300, 2, 4, len(individuals)))
    for i in range(len(individuals)):
        for k in range(4):
            position[:, 0, k, i] = 10 * k + np.cos(2 * np.pi * (i + 1) * t + k)
            position[:, 1, k, i] = np.sin(2 * np.pi * (i + 1) * t + k)
    confidence = np.ones((300, 4, len(individuals)))
    confidence[100:103, 1] = 0.1
    return xarray.Dataset(
        {
            "position": (("time", "space", "keypoint", "individual"), position),
            "confidence": (("time", "keypoint", "individual"), confidence),
        },
        coords={"time": t, "space": ["x", "y"], "keypoint": list(keypoints),
                "individual": list(individuals)},
        attrs={"fps": 30.0, "time_unit": "seconds", "ds_type": "poses"},
    )  # fmt: skip


def test_movement():
    data = dataset()
    periods = [stltsa.decompose(data, individual=name).period for name in ("mouse1", "mouse2")]
    assert periods == pytest.approx([1.0, 0.5], abs=0.02)
    result = stltsa.decompose(dataset(("one",)))
    assert result.period == pytest.approx(1.0, abs=0.02)
    assert gap_notes(result)
    with pytest.raises(ValueError, match=r"2 individuals: give individual=, one of .*mouse2"):
        stltsa.decompose(data)
    with pytest.raises(ValueError, match="must be one of"):
        stltsa.decompose(data, individual="cat")
    with pytest.raises(TypeError, match="a path or a dataset if individual="):
        stltsa.decompose(np.ones((100, 3)), fps=30, individual="mouse1")


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda d: d.assign(position=d.position + 1j), "position holds complex128"),
        (lambda d: d.assign(position=d.position.astype(str)), "position holds <U"),
        (lambda d: d.assign(confidence=d.confidence + 1j), "confidence holds complex128"),
        (lambda d: d.isel(space=0, drop=True), r"position has the dimensions .*and must have"),
        (lambda d: d.rename(keypoint="part"), r"position has the dimensions .*and must have"),
        (lambda d: d.assign(confidence=d.confidence.isel(time=0)), "confidence has the dimensions"),
        (lambda d: d.isel(space=[0]), "position is 300 x 4 x 1, and must be"),
        (lambda d: d.isel(time=[]), "position is 0 x 4 x 2, and must be"),
        (lambda d: d.assign_attrs(fps="30 Hz"), "fps is '30 Hz', and must be"),
        (lambda d: d.assign_attrs(fps=[30, 25]), r"fps is \[30 25\], and must be"),
        (lambda d: d.assign_attrs(fps=-30), "fps is -30, and must be"),
        (lambda d: d.assign_attrs(fps=None).assign_coords(time=["a"] * 300), "time holds <U1"),
    ],
)
def test_datasets_with_other_numbers(change, said):
    changed = change(dataset(("one",)))
    with pytest.raises(stltsa.FormatError, match=f"^the dataset: {said}"):
        stltsa.decompose(changed)


def test_models_of_datasets_and_points():
    data = dataset()
    model = stltsa.fit(data, individual="mouse1")
    points = np.asarray(data.position.isel(individual=0).transpose("time", "keypoint", "space"))
    assert len(model.coords) == len(stltsa.fit(points, fps=30).coords)


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("a.trc", "hello\n", "PathFileType"),
        ("a.mot", "hello\n", "endheader"),
        ("a.mot", "endheader\ntime\tx\n0\tone\n", "'one' is not a number"),
        ("a.mot", "endheader\ntime\tx\n1\t1\n1\t2\n", "does not increase"),
        ("a.c3d", "", r"a\.c3d: not a C3D file"),
        ("a.c3d", "HIERARCHY\nROOT hip\n", r"a\.c3d: not a C3D file"),
        ("a.npz", "hello\n", r"a\.npz: the file cannot be read"),
        ("a.npz", "", r"a\.npz: the file cannot be read"),
    ],
)
def test_files_that_are_something_else(tmp_path, name, text, said):
    (tmp_path / name).write_text(text)
    with pytest.raises(stltsa.FormatError, match=said):
        stltsa.read_clip(tmp_path / name)
