# SPDX-License-Identifier: BSD-3-Clause
"""Batches: the library's (tests/command/test_batch.py), in threads and on a cluster."""

import os
import re
import shutil
import subprocess

import numpy as np
import pytest
from conftest import ROOT

import stltsa

DOCS = ROOT / "docs" / "batch.md"


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


@pytest.mark.parametrize("jobs", [1, 2])
def test_the_commands_files(clips, tmp_path, command, jobs):
    (clips / "bad.bvh").write_text("hello\n")
    (clips / "=1+1.bvh").symlink_to(clips / "walk.bvh")
    options = {"fps": 30.0, "segments": 1, "features": "raw", "individual": None}
    rows = stltsa.batch([clips], tmp_path / "python", jobs=jobs, **options)
    flags = ["--fps", "30", "--segments", "1", "--features", "raw"]
    line = [command, "batch", clips, "--out", tmp_path / "command", *flags]
    assert subprocess.run(line, capture_output=True, check=False).returncode == 5
    assert files(tmp_path / "python") == files(tmp_path / "command")
    names = ["=1+1.bvh", "bad.bvh", "more/swing, noisy.csv", "walk.bvh"]
    assert list(rows["path"]) == [str(clips / name) for name in names]
    assert list(rows["status"]) == ["done", "STLTSA_E_FORMAT", "done", "done"]
    assert "must begin with HIERARCHY" in rows["error"][1]
    assert list(rows["frames"])[1:3] == [0, 300]
    assert np.isnan(rows["period_s"][1])
    again = stltsa.batch(clips, tmp_path / "command", **options)
    assert list(again["kept"]) == [True, False, True, True]
    assert list(again["period_s"])[2:] == list(rows["period_s"])[2:]
    assert not any(stltsa.batch(clips, tmp_path / "python", fps=30)["kept"])


def test_files_that_only_python_reads(tmp_path):
    folder = tmp_path / "clips"
    folder.mkdir()
    t = np.arange(600) / 60
    poses = np.zeros((len(t), 66))
    poses[:, 3:6] = 0.5 * np.sin(2 * np.pi * t)[:, np.newaxis] * [1, 0.2, 0.1]
    poses[:, 6:9] = -poses[:, 3:6]
    way = np.column_stack([0.1 * np.sin(2 * np.pi * t), 1 / 3 + 0 * t, 1.3 * t])
    np.savez(folder / "walk.npz", poses=poses, trans=way, mocap_framerate=60.0)
    np.savez(folder / "other.npz", poses=poses)
    for kept in (False, True):
        rows = stltsa.batch(folder, tmp_path / "out", jobs=2)
        assert list(rows["status"]) == ["STLTSA_E_FORMAT", "done"]
        assert "this one has poses" in rows["error"][0]
        assert rows["cycles"][1] > 0
        assert list(rows["kept"]) == [False, kept]
    assert "this one has poses" in (tmp_path / "out" / "summary.csv").read_text()
    np.savez(folder / "other.npz", poses=poses, trans=way)  # without a rate
    assert list(stltsa.batch(folder, tmp_path / "out", fps=60)["status"]) == ["done", "done"]


@pytest.mark.parametrize(
    ("error", "options"),
    [
        (TypeError, {"neighbours": 3}),
        (TypeError, {"neighbors": 1.5}),
        (ValueError, {"neighbors": "many"}),
        (ValueError, {"gaps": "mend"}),
        (stltsa.ArgumentError, {"neighbors": -3}),
    ],
)
def test_wrong_options_fail_before_the_first_clip(clips, tmp_path, error, options):
    with pytest.raises(error, match=next(iter(options))):
        stltsa.batch(clips, tmp_path / "out", **options)
    assert not (tmp_path / "out").exists()
    stltsa.batch(clips / "walk.bvh", tmp_path / "out", period_max="4s")


def test_wrong_arguments(clips, tmp_path):
    for shard in ((3, 2), "1", (1.5, 2)):
        with pytest.raises(ValueError, match="shard"):
            stltsa.batch(clips, tmp_path / "out", shard=shard)
    with pytest.raises(ValueError, match="same result"):
        stltsa.batch(["a__b.bvh", "a/b.bvh"], tmp_path / "out")
    with pytest.raises(OSError, match="/proc/"):
        stltsa.batch(clips, "/proc/self", fps=30)
    rows = stltsa.batch(clips, tmp_path / "out", shard=(2, 2), fps=30)
    assert len(rows) == 1
    assert (tmp_path / "out" / "summary-2-2.csv").exists()


def test_progress_can_end_the_batch(clips, tmp_path):
    seen = []
    stltsa.batch(clips, tmp_path / "all", fps=30, progress=lambda *a: seen.append(a))
    assert seen == [("clips", 0.5), ("clips", 1.0)]

    def stop(*_):
        raise KeyboardInterrupt

    paths = [clips / "walk.bvh"]
    for i in range(20):
        shutil.copy(clips / "walk.bvh", clips / f"walk{i}.bvh")
        paths.append(clips / f"walk{i}.bvh")
    with pytest.raises(KeyboardInterrupt):
        stltsa.batch(paths, tmp_path / "some", progress=stop)
    assert 1 <= len(files(tmp_path / "some")) < len(paths)


def test_a_cluster(clips, tmp_path):
    distributed = pytest.importorskip("distributed", minversion="2023.1")
    stltsa.batch(clips, tmp_path / "one", fps=30)
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as two,
        distributed.Client(two) as client,
    ):
        stltsa.batch(clips, tmp_path / "two", client=client, fps=30)
    assert files(tmp_path / "one") == files(tmp_path / "two")


def block_of_docs(language, word):
    """A program in the documentation."""
    if not DOCS.exists():
        pytest.skip(f"{DOCS} is not there")
    blocks = re.findall(rf"```{language}\n(.*?)```", DOCS.read_text(), re.DOTALL)
    return next(block for block in blocks if word in block)


def environment(command, **more):
    path = f"{command.parent}{os.pathsep}{os.environ['PATH']}"
    return {**os.environ, "PATH": path, **more}


def test_the_slurm_array(clips, tmp_path, command):
    script = tmp_path / "array.sh"
    script.write_text(block_of_docs("bash", "SBATCH").replace('--out "', '--fps 30 --out "'))
    for task in ("1", "2"):
        variables = {
            "SLURM_ARRAY_TASK_ID": task,
            "SLURM_ARRAY_TASK_COUNT": "2",
            "SLURM_CPUS_PER_TASK": "2",
            "RECORDINGS": str(clips),
            "RESULTS": str(tmp_path / "results"),
        }
        subprocess.run(["bash", "-eu", script], check=True, env=environment(command, **variables))
    stltsa.batch(clips, tmp_path / "whole", fps=30)
    names = {name for name in files(tmp_path / "results") if name.suffix == ".json"}
    assert names == {name for name in files(tmp_path / "whole") if name.suffix == ".json"}


def test_the_snakemake_rule(walker, tmp_path, command):
    snakemake = shutil.which("snakemake") or pytest.skip("snakemake is not installed")
    (tmp_path / "recordings").mkdir()
    shutil.copy(walker, tmp_path / "recordings" / "walk.bvh")
    (tmp_path / "Snakefile").write_text(block_of_docs("python", "rule decompose"))
    run = [snakemake, "--cores", "1", "--quiet"]
    for _ in range(2):  # the second run has nothing to do
        subprocess.run(run, check=True, cwd=tmp_path, env=environment(command, HOME=str(tmp_path)))
    result = (tmp_path / "results" / "walk.json").read_text()
    assert '"stltsa-decomposition/2"' in result
