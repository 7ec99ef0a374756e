# SPDX-License-Identifier: BSD-3-Clause
"""Batches: the command's files, resumed, for any number of jobs."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT
from test_readers import walk, write_c3d

import stltsa

ASF = """:version 1.10
:units
  length 1
  angle deg
:root
  order TX TY TZ RX RY RZ
  axis XYZ
  position 0 0 0
  orientation 0 0 0
:bonedata
  begin
    id 1
    name leg
    direction 0 -1 0
    length 40
    axis 0 0 0 XYZ
  end
:hierarchy
  begin
    root leg
  end
"""
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


def test_the_commands_files(clips, tmp_path, command):
    rows = stltsa.batch(clips, tmp_path / "python", fps=30.0, segments=1)
    flags = ["--fps", "30", "--segments", "1"]
    subprocess.run([command, "batch", clips, "--out", tmp_path / "command", *flags], check=True,
                   capture_output=True)  # fmt: skip
    assert files(tmp_path / "python") == files(tmp_path / "command")
    names = [str(clips / "more" / "swing, noisy.csv"), str(clips / "walk.bvh")]
    assert list(rows["path"]) == names
    results = {name.replace("/", "__") + ".json" for name in names}
    assert {str(name) for name in files(tmp_path / "python")} == results | {"summary.csv"}
    assert list(rows["status"]) == ["done", "done"]
    assert not any(rows["kept"])
    again = stltsa.batch(clips, tmp_path / "command", fps=30, segments=1)
    assert all(again["kept"])
    assert list(again["period_s"]) == list(rows["period_s"])
    assert not any(stltsa.batch(clips, tmp_path / "python", fps=30)["kept"])


def test_names_that_a_spreadsheet_would_evaluate(walker, tmp_path, command, monkeypatch):
    """Or split, where semicolons or tabs separate cells."""
    monkeypatch.chdir(tmp_path)
    names = ["=1+1.bvh", "a;=1+1.bvh", "a\rb.bvh", "a\tb.bvh", 'a"b.bvh']
    for name in names:
        Path(name).symlink_to(walker)
    stltsa.batch(names, "python")
    subprocess.run([command, "batch", *names, "--out", "command"], check=True,
                   capture_output=True)  # fmt: skip
    assert files(tmp_path / "python") == files(tmp_path / "command")
    summary = (tmp_path / "python" / "summary.csv").read_bytes()
    for cell in (b"'=1+1.bvh", b'"a;=1+1.bvh"', b'"a\rb.bvh"', b'"a\tb.bvh"', b'"a""b.bvh"'):
        assert b"\n" + cell + b",done," in summary


def test_the_commands_files_of_c3d(tmp_path, command):
    pytest.importorskip("ezc3d")
    folder = tmp_path / "clips"
    folder.mkdir()
    values = walk()
    values[70:80, 0] = values[150:180] = np.nan  # a gap, and a hole
    write_c3d(folder / "walk.c3d", values)
    stltsa.batch(folder, tmp_path / "python")
    subprocess.run([command, "batch", folder, "--out", tmp_path / "command"], check=True,
                   capture_output=True)  # fmt: skip
    assert files(tmp_path / "python") == files(tmp_path / "command")


def test_files_that_only_python_reads(tmp_path):
    folder = tmp_path / "clips"
    folder.mkdir()
    t = np.arange(600) / 60
    poses = np.zeros((len(t), 66))
    poses[:, 3:6] = 0.5 * np.sin(2 * np.pi * t)[:, np.newaxis] * [1, 0.2, 0.1]
    poses[:, 6:9] = -poses[:, 3:6]
    way = np.column_stack([0.1 * np.sin(2 * np.pi * t), 1 / 3 + 0 * t, 1.3 * t])
    np.savez(folder / "walk.npz", poses=poses, trans=way, mocap_framerate=60.0)
    rows = stltsa.batch(folder, tmp_path / "python")
    assert list(rows["status"]) == ["done"]
    assert min(rows["cycles"]) > 0


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


def test_jobs(clips, tmp_path):
    pytest.importorskip("joblib")
    stltsa.batch(clips, tmp_path / "one", fps=30)
    stltsa.batch([clips], tmp_path / "two", jobs=2, fps=30)
    assert files(tmp_path / "one") == files(tmp_path / "two")
    for i in (1, 2):
        stltsa.batch(clips, tmp_path / "parts", shard=f"{i}/2", fps=30)
    parts = {name for name in files(tmp_path / "parts") if name.suffix == ".json"}
    assert parts == {name for name in files(tmp_path / "one") if name.suffix == ".json"}
    with pytest.raises(ValueError, match="shard"):
        stltsa.batch(clips, tmp_path / "parts", shard=(3, 2))
    with pytest.raises(ValueError, match="shard"):
        stltsa.batch(clips, tmp_path / "parts", shard="1")
    with pytest.raises(ValueError, match="shard"):
        stltsa.batch(clips, tmp_path / "parts", shard=(1.5, 2))


def test_a_cluster(clips, tmp_path):
    distributed = pytest.importorskip("distributed")
    stltsa.batch(clips, tmp_path / "one", fps=30)
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as two,
        distributed.Client(two) as client,
    ):
        stltsa.batch(clips, tmp_path / "two", client=client, fps=30)
    assert files(tmp_path / "one") == files(tmp_path / "two")


def test_paths_as_the_command_takes_them(clips, tmp_path, command, monkeypatch):
    """Clips given twice, links that lead back, names with dots."""
    (clips / "loop").symlink_to(".")
    (clips / "more" / "up").symlink_to("..")
    (tmp_path / "elsewhere").mkdir()
    shutil.copy(clips / "walk.bvh", tmp_path / "elsewhere" / "other.bvh")
    (clips / "link").symlink_to(tmp_path / "elsewhere")
    (clips / "bad.bvh").write_text("hello\n")
    monkeypatch.chdir(clips)
    paths = [
        "./walk.bvh",
        ".",
        "more//",
        "../elsewhere/other.bvh",
        "more/../walk.bvh",
        "absent.bvh",
    ]
    stltsa.batch(paths, tmp_path / "python", fps=30)
    line = [command, "batch", *paths, "--out", tmp_path / "command", "--fps", "30"]
    assert subprocess.run(line, capture_output=True, check=False).returncode == 5
    found = files(tmp_path / "command")
    assert files(tmp_path / "python") == found
    assert len(found) == 8
    assert "elsewhere__other.bvh.json" in {str(name) for name in found}


def test_results_among_the_clips(clips):
    """The summaries there are no clips."""
    (clips / "link").symlink_to(clips / "more" / "results")
    for out in ("more/results", "."):
        for shard, count in (((1, 1), 2), ((1, 2), 1), ((1, 1), 2)):
            rows = stltsa.batch(clips, clips / out, shard=shard, fps=30)
            assert list(rows["status"]) == ["done"] * count
        shutil.rmtree(clips / "more" / "results", ignore_errors=True)


def test_a_result_whose_name_is_too_long_is_a_row(clips, tmp_path, command, monkeypatch):
    monkeypatch.chdir(clips)
    folder = clips / ("m" * 120)
    folder.mkdir()
    for length in (124, 125):
        shutil.copy(clips / "walk.bvh", folder / f"{'n' * length}.bvh")
    rows = stltsa.batch(".", tmp_path / "python", fps=30)
    assert list(rows["status"]) == ["done", "STLTSA_E_IO", "done", "done"]
    assert "would have 256 bytes" in rows["error"][1]
    line = [command, "batch", ".", "--out", tmp_path / "command", "--fps", "30"]
    assert subprocess.run(line, capture_output=True, check=False).returncode == 5
    assert files(tmp_path / "python") == files(tmp_path / "command")


def test_bad_files_are_rows(clips, tmp_path):
    (clips / "bad.bvh").write_text("hello\n")
    rows = stltsa.batch([clips, tmp_path / "missing.bvh"], tmp_path / "out", fps=30)
    status = dict(zip(rows["path"], rows["status"], strict=True))
    assert status[str(clips / "bad.bvh")] == "STLTSA_E_FORMAT"
    assert status[str(tmp_path / "missing.bvh")] == "STLTSA_E_IO"
    assert status[str(clips / "walk.bvh")] == "done"
    with pytest.raises(ValueError, match="same result"):
        stltsa.batch(["a__b.bvh", "a/b.bvh"], tmp_path / "out")
    with pytest.raises(ValueError, match="standard input"):
        stltsa.batch("-", tmp_path / "out")
    with pytest.raises(TypeError, match="workers"):
        stltsa.batch(clips, tmp_path / "out", workers=2)
    seen = []
    stltsa.batch(clips / "walk.bvh", tmp_path / "out", progress=lambda *a: seen.append(a))
    assert seen == [("clips", 1.0)]


def test_damaged_results_are_made_anew(walker, tmp_path):
    shutil.copy(walker, tmp_path / "walk.bvh")
    path, out = tmp_path / "walk.bvh", tmp_path / "out"

    def kept():
        rows = stltsa.batch(path, out)
        assert list(rows["status"]) == ["done"]
        return bool(rows["kept"][0])

    assert not kept()
    result = next(out.glob("*.json"))
    whole = result.read_bytes()
    for damaged in (
        b"",
        whole[:-1],
        whole.replace(b'"segments"', b'\0\0segments"', 1),
        whole.replace(b'"cycles":', b'"Cycles":', 1),
        whole.replace(b'"source":"', b'"source":"\xff', 1),
        b'{"batch":1,"batch":' + 100000 * b"[" + b"}\n",
    ):
        result.write_bytes(damaged)
        assert not kept()
        assert result.read_bytes() == whole
        assert kept()


def test_what_is_in_the_way_does_not_stop_the_others(clips, tmp_path):
    out = tmp_path / "out"
    stltsa.batch(clips, out, fps=30)
    place = out / f"{str(clips / 'walk.bvh').replace('/', '__')}.json"
    place.unlink()
    for make in (place.mkdir, lambda: os.mkfifo(place), lambda: place.symlink_to("none/folder")):
        make()
        rows = stltsa.batch(clips, out, fps=30)
        assert list(rows["status"]) == ["done", "STLTSA_E_IO"]
        assert list(rows["kept"]) == [True, False]
        (place.rmdir if place.is_dir() else place.unlink)()
    place.symlink_to(tmp_path / "elsewhere.json")
    assert list(stltsa.batch(clips, out, fps=30)["status"]) == ["done", "done"]
    assert place.is_symlink()
    assert list(stltsa.batch(clips, out, fps=30)["kept"]) == [True, True]
    seen = []  # no clip is decomposed if nothing can be written
    with pytest.raises(OSError, match="/proc/"):
        stltsa.batch(clips, "/proc/self", fps=30, progress=lambda *a: seen.append(a))
    assert not seen


def test_skeletons_as_the_command_takes_them(tmp_path, command, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("clips").mkdir()
    turns = 20 * np.sin(np.arange(300) / 8)
    rows = [f"{i + 1}\nroot 0 0 0 {turn:.4f} 0 0\n" for i, turn in enumerate(turns)]
    Path("clips/walk.amc").write_text(":FULLY-SPECIFIED\n:DEGREES\n" + "".join(rows))
    skeleton = Path("clips/walk.asf")
    skeleton.write_text(ASF)
    os.mkfifo("clips/pipe.asf")
    Path("clips/folder.asf").mkdir()
    Path("clips/dangling.asf").symlink_to("nothing")
    Path("clips/.hidden.asf").write_text("being written")
    for options in ({}, {"skeleton": str(skeleton)}):
        for change in ("", "# changed\n"):
            skeleton.write_text(change + skeleton.read_text())
            rows = stltsa.batch("clips", "python", fps=60, **options)
            assert (list(rows["status"]), list(rows["kept"])) == (["done"], [False])
            flags = ["--fps", "60", *(["--skeleton", skeleton] if options else [])]
            subprocess.run([command, "batch", "clips", "--out", "command", *flags], check=True,
                           capture_output=True)  # fmt: skip
            assert files(Path("python")) == files(Path("command"))
            assert list(stltsa.batch("clips", "command", fps=60, **options)["kept"]) == [True]
    rows = stltsa.batch("clips", "python", skeleton="clips/pipe.asf")
    assert list(rows["status"]) == ["STLTSA_E_IO"]


def test_one_path_from_two_folders(walker, clip, tmp_path, monkeypatch):
    """The result of another clip stays; it may be replaced when that clip is gone."""
    for place in ("here", "there"):
        (tmp_path / place).mkdir()
    shutil.copy(walker, tmp_path / "here" / "walk.bvh")
    clip.stretch("100-600").save(tmp_path / "there" / "walk.bvh")

    def batch(place):
        monkeypatch.chdir(tmp_path / place)
        (row,) = stltsa.batch("walk.bvh", tmp_path / "out").itertuples()
        return row.status, row.kept, row.error

    assert batch("here")[:2] == ("done", False)
    before = (tmp_path / "out" / "walk.bvh.json").read_bytes()
    status, kept, error = batch("there")
    assert (status, kept) == ("STLTSA_E_IO", False)
    assert f"is that of another clip, {tmp_path}/here/walk.bvh: give another --out" in error
    assert (tmp_path / "out" / "walk.bvh.json").read_bytes() == before
    assert batch("here")[:2] == ("done", True)
    (tmp_path / "here" / "walk.bvh").unlink()
    assert batch("there")[:2] == ("done", False)
    (tmp_path / "there").rename(tmp_path / "moved")
    assert batch("moved")[:2] == ("done", True)


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
