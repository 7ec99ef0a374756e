# SPDX-License-Identifier: BSD-3-Clause
"""Batches: the command's files, resumed, for any number of workers."""

import shutil
import subprocess

import numpy as np
import pytest

import stltsa


@pytest.fixture
def clips(walker, tmp_path):
    folder = tmp_path / "clips"
    (folder / "more").mkdir(parents=True)
    shutil.copy(walker, folder / "walk.bvh")
    t = np.arange(300) / 30
    columns = [np.sin(2 * np.pi * t + c) for c in range(60)]
    np.savetxt(folder / "more" / "swing, noisy.csv", np.column_stack(columns), delimiter=",")
    (folder / "notes.txt").write_text("no clip")
    return folder


def files(folder):
    return {p.relative_to(folder): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


def test_the_commands_files(clips, tmp_path, command):
    rows = stltsa.batch(clips, tmp_path / "python", fps=30.0, neighbors=36)
    flags = ["--fps", "30", "--neighbors", "36"]
    subprocess.run([command, "batch", clips, "--out", tmp_path / "command", *flags], check=True,
                   capture_output=True)  # fmt: skip
    assert files(tmp_path / "python") == files(tmp_path / "command")
    assert list(rows["clip"]) == ["more/swing, noisy.csv", "walk.bvh"]
    assert list(rows["status"]) == ["done", "done"]
    assert not any(rows["kept"])
    again = stltsa.batch(clips, tmp_path / "command", fps=30, neighbors=36)
    assert all(again["kept"])
    assert list(again["period_s"]) == list(rows["period_s"])
    assert not any(stltsa.batch(clips, tmp_path / "python", fps=30)["kept"])


def test_workers(clips, tmp_path):
    pytest.importorskip("joblib")
    stltsa.batch(clips, tmp_path / "one", fps=30)
    stltsa.batch([clips], tmp_path / "two", workers=2, fps=30)
    assert files(tmp_path / "one") == files(tmp_path / "two")
    for i in (1, 2):
        stltsa.batch(clips, tmp_path / "parts", shard=(i, 2), fps=30)
    parts = {name for name in files(tmp_path / "parts") if name.suffix == ".json"}
    assert parts == {name for name in files(tmp_path / "one") if name.suffix == ".json"}
    with pytest.raises(ValueError, match="shard"):
        stltsa.batch(clips, tmp_path / "parts", shard=(3, 2))


def test_a_cluster(clips, tmp_path):
    distributed = pytest.importorskip("distributed")
    stltsa.batch(clips, tmp_path / "one", fps=30)
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as two,
        distributed.Client(two) as client,
    ):
        stltsa.batch(clips, tmp_path / "two", client=client, fps=30)
    assert files(tmp_path / "one") == files(tmp_path / "two")


def test_bad_files_are_rows(clips, tmp_path):
    (clips / "bad.bvh").write_text("hello\n")
    rows = stltsa.batch([clips, tmp_path / "missing.bvh"], tmp_path / "out", fps=30)
    status = dict(zip(rows["clip"], rows["status"], strict=True))
    assert status["bad.bvh"] == "STLTSA_E_FORMAT"
    assert status["missing.bvh"] == "STLTSA_E_IO"
    assert status["walk.bvh"] == "done"
    with pytest.raises(ValueError, match="same result"):
        stltsa.batch([clips / "walk.bvh", str(clips / "walk.bvh"), clips], tmp_path / "out")
    seen = []
    stltsa.batch(clips / "walk.bvh", tmp_path / "out", progress=lambda *a: seen.append(a))
    assert seen == [("clips", 1.0)]
