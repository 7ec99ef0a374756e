# SPDX-License-Identifier: BSD-3-Clause
"""C3D, TRC and MOT: gaps are refused, or filled with a warning."""

import numpy as np
import pytest

import stltsa
from stltsa.markers import Gap, read_markers

pytest.importorskip("pandas")

NAMES = ("HEAD", "LTOE", "RTOE", "GONE")


def walk(frames=120):
    """Positions of four markers in mm, the second with gaps in the middle and at the end."""
    t = np.arange(frames)[:, None, None] / 100
    phase = np.arange(4)[None, :, None]
    values = 500 * np.sin(2 * np.pi * t + phase + np.arange(3)) + 1000 * phase
    values[40:54, 1] = np.nan
    values[-5:, 1] = np.nan
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


@pytest.fixture
def trc(tmp_path):
    return write_trc(tmp_path / "walk.trc", walk())


def test_trc(trc):
    markers = read_markers(trc)
    assert markers.names == NAMES
    assert markers.fps == 100
    assert np.array_equal(markers.values, walk(), equal_nan=True)
    assert markers.gaps == (Gap("LTOE", 40, 54), Gap("LTOE", 115, 120))


def test_gaps_are_refused(trc):
    text = r"walk\.trc: 2 gaps in 1 marker, the longest 14 frames \(LTOE, frames \[40, 54\)\)"
    with pytest.raises(stltsa.NotFiniteError, match=text):
        stltsa.read_clip(trc)


def test_gaps_are_filled_and_said(trc):
    with pytest.warns(stltsa.QualityWarning, match="filled linearly: 2 gaps"):
        clip = read_markers(trc).to_clip(gaps="fill", center=False)
    filled = clip.features().reshape(120, 4, 3)
    there = np.isfinite(walk())
    assert np.array_equal(filled[there], walk()[there])
    middle = walk()[39, 1] + (walk()[54, 1] - walk()[39, 1]) / 15
    assert filled[40, 1] == pytest.approx(middle)
    assert (filled[-5:, 1] == walk()[-6, 1]).all()


def test_markers_that_are_never_there_are_left_out(tmp_path):
    values = walk()
    values[:, 3] = np.nan
    path = write_trc(tmp_path / "walk.trc", values)
    with pytest.warns(stltsa.QualityWarning, match="left out, never there: GONE"):
        clip = stltsa.read_clip(path, gaps="fill")
    assert clip.channels == 9
    assert np.abs(clip.features().reshape(120, 3, 3).mean(axis=1)).max() < 1e-9


def test_mot(tmp_path):
    path = tmp_path / "walk.mot"
    rows = [f"{i / 50}\t{np.sin(i / 8)}\t{np.cos(i / 8)}" for i in range(100)]
    path.write_text("walk\nversion=1\nnRows=100\nnColumns=3\ninDegrees=yes\nendheader\n"
                    "time\thip\tknee\n" + "\n".join(rows) + "\n")  # fmt: skip
    markers = read_markers(path)
    assert markers.names == ("hip", "knee")
    assert markers.fps == pytest.approx(50)
    assert stltsa.read_clip(path).features() == pytest.approx(markers.values[:, :, 0])


def test_c3d(tmp_path):
    ezc3d = pytest.importorskip("ezc3d")
    values = walk()
    file = ezc3d.c3d()
    file["parameters"]["POINT"]["RATE"]["value"] = [100]
    file["parameters"]["POINT"]["LABELS"]["value"] = NAMES
    points = np.ones((4, 4, len(values)))
    points[:3] = np.nan_to_num(values).transpose(2, 1, 0)
    file["data"]["points"] = points
    missing = np.isnan(values).any(axis=2).T
    file["data"]["meta_points"]["residuals"] = np.where(missing, -1.0, 0.0)[np.newaxis]
    file["data"]["meta_points"]["camera_masks"] = np.zeros((7, 4, len(values)), dtype=bool)
    path = tmp_path / "walk.c3d"
    file.write(str(path))
    markers = read_markers(path)
    assert markers.names == NAMES
    assert markers.fps == 100
    assert markers.values == pytest.approx(values, rel=1e-6, nan_ok=True)
    assert markers.gaps == (Gap("LTOE", 40, 54), Gap("LTOE", 115, 120))
    with pytest.warns(stltsa.QualityWarning, match="2 gaps"):
        assert len(stltsa.read_clip(path, gaps="fill")) == 120


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("a.trc", "hello\n", "PathFileType"),
        ("a.mot", "hello\n", "endheader"),
        ("a.mot", "endheader\ntime\tx\n0\tone\n", "cannot be read"),
        ("a.mot", "endheader\ntime\tx\n1\t1\n1\t2\n", "does not rise"),
    ],
)
def test_files_that_are_something_else(tmp_path, name, text, said):
    (tmp_path / name).write_text(text)
    with pytest.raises(stltsa.FormatError, match=said):
        read_markers(tmp_path / name)
