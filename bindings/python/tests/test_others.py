# SPDX-License-Identifier: BSD-3-Clause
"""Files that other programs write and check: `movement`'s writers, and the validator of BIDS.

scripts/test-python --pypi has these; elsewhere the tests are skipped.
"""

import json
import pathlib
import shutil
import subprocess
import sys

import numpy as np
import pytest

import stltsa

# movement's dependencies warn of their own use.
pytestmark = [
    pytest.mark.filterwarnings("ignore::DeprecationWarning"),
    pytest.mark.filterwarnings("ignore::FutureWarning"),
]
KEYPOINTS = ("nose", "left_ear", "right_ear", "back", "tail_base", "tail_tip")
FPS = 30


def mouse(cycles=10):
    """Key points of an animal that is seen from above; a stride of 0.8 s, sure but for a few."""
    frames = round(0.8 * FPS * cycles)
    phase = 2 * np.pi * np.arange(frames)[:, None] / (0.8 * FPS) + np.arange(len(KEYPOINTS))
    along = 30.0 * np.arange(len(KEYPOINTS)) + 4 * np.cos(phase)
    across = 8 * np.sin(phase) + 3 * np.sin(2 * phase)
    position = np.stack([300 + along, 200 + across], axis=1)[..., None]
    confidence = np.full((frames, len(KEYPOINTS), 1), 0.95)
    confidence[100:103, 1] = 0.1
    return position, confidence


def dataset():
    load = pytest.importorskip("movement.io.load_poses")
    return load.from_numpy(*mouse(), ["mouse"], list(KEYPOINTS), fps=FPS)


def borders(result):
    return [(cycle.begin, cycle.end) for cycle in result.cycle_list]


def dlc(data, folder, suffix):
    from movement.io import load_poses, save_poses

    path = folder / f"mouse{suffix}"
    save_poses.to_dlc_file(data, path, split_individuals=False)
    return path, load_poses.from_dlc_file(path, fps=FPS)


def lightning_pose(data, folder):
    from movement.io import load_poses, save_poses

    save_poses.to_lp_file(data, folder / "lp.csv")
    (path,) = folder.glob("lp*.csv")  # the name has that of the individual
    return path, load_poses.from_lp_file(path, fps=FPS)


def sleap(data, folder):
    from movement.io import load_poses, save_poses

    path = folder / "sleap.h5"
    save_poses.to_sleap_analysis_file(data, path)
    return path, load_poses.from_sleap_file(path, fps=FPS)


WRITERS = {
    "DeepLabCut h5": lambda data, folder: dlc(data, folder, ".h5"),
    "DeepLabCut csv": lambda data, folder: dlc(data, folder, ".csv"),
    "LightningPose": lightning_pose,
    "SLEAP": sleap,
}


@pytest.mark.parametrize("write", WRITERS.values(), ids=WRITERS.keys())
def test_what_movement_writes_is_decomposed(write, tmp_path):
    data = dataset()
    expected = borders(stltsa.decompose(data))
    assert len(expected) >= 9
    path, again = write(data, tmp_path)
    result = stltsa.decompose(again)
    assert borders(result) == expected
    assert result.period == pytest.approx(0.8, abs=0.02)
    if path.suffix == ".csv":  # the library reads it itself
        own = stltsa.decompose(path, fps=FPS)
        assert borders(own) == expected
    answer = result.to_xarray(again)
    answer.to_netcdf(tmp_path / "answer.nc", engine="h5netcdf")
    xarray = pytest.importorskip("xarray")
    with xarray.open_dataset(tmp_path / "answer.nc", engine="h5netcdf") as kept:
        assert kept.drop_attrs().load().identical(answer.drop_attrs())


def validator():
    beside = pathlib.Path(sys.executable).parent / "bids-validator-deno"
    found = beside if beside.exists() else shutil.which("bids-validator-deno")
    return found or pytest.skip("bids-validator-deno is not installed")


def found_in(root):
    run = subprocess.run([validator(), "--json", root], capture_output=True, text=True, check=False)
    return [
        (issue["code"], issue["severity"]) for issue in json.loads(run.stdout)["issues"]["issues"]
    ]


def test_events_are_valid_bids(result, tmp_path):
    root = tmp_path / "walks"
    folder = root / "sub-01" / "beh"
    folder.mkdir(parents=True)
    about = {"Name": "Walks", "BIDSVersion": "1.10.0", "DatasetType": "raw", "License": "CC0",
             "Authors": ["Nobody", "Nobody Else"]}  # fmt: skip
    (root / "dataset_description.json").write_text(json.dumps(about))
    (root / "README.md").write_text("A synthetic walk, made to check a table of events.\n" * 5)
    path = folder / "sub-01_task-walk_events.tsv"
    result.save_events(path)
    sidecar = path.with_suffix(".json")
    columns = json.loads(sidecar.read_text())
    assert [issue for issue in found_in(root) if "events" in str(issue).lower()] == []
    assert [issue for issue in found_in(root) if issue[1] == "error"] == []
    # The validator looks: without a duration it complains.
    path.write_text(path.read_text().replace("duration", "length", 1))
    sidecar.write_text(json.dumps({n.replace("duration", "length"): c for n, c in columns.items()}))
    assert [issue for issue in found_in(root) if issue[1] == "error"]
