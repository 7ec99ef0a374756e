# SPDX-License-Identifier: BSD-3-Clause
"""stltsa batch: results, summary, resuming, shards, failures."""

import csv
import json
import math
import os
import random
import shutil
import struct
import unittest

from common import CommandTest, plain_environment, run, walk

READER = """#!/bin/sh
case $3 in
*.c3d) cat ARRAYS ;;
*) printf '%s: has no points' "$3"; exit 3 ;;
esac
"""


class Batch(CommandTest):
    def setUp(self):
        super().setUp()
        self.clips = self.folder / "clips"
        (self.clips / "more").mkdir(parents=True)
        shutil.copy(walk(), self.clips / "walk.bvh")
        shutil.copy(walk(60), self.clips / "more" / "walk.bvh")
        self.swinging(self.clips / "more" / "swing, noisy.csv")
        (self.clips / "notes.txt").write_text("no clip")
        self.out = self.folder / "out"

    @staticmethod
    def swinging(path):
        """60 columns, in which the sums of BLAS depend on its number of threads."""
        noise = random.Random(3)
        names = ",".join(f"c{c}" for c in range(60))
        rows = [",".join(f"{math.sin(i / 5 + c) + 0.1 * noise.random():.5f}" for c in range(60))
                for i in range(300)]  # fmt: skip
        path.write_text("\n".join([names, *rows]) + "\n")

    def batch(self, *arguments, status=0, out=None, **settings):
        line = ("batch", "clips", "--out", out or self.out, "--fps", "30", *arguments)
        result = run(*line, cwd=self.folder, **settings)
        self.assertEqual(result.returncode, status, result.stderr.decode())
        return result.stdout.decode()

    def summary(self, name="summary.csv"):
        with (self.out / name).open(newline="") as file:
            return list(csv.DictReader(file))

    def files(self, folder=None):
        folder = folder or self.out
        return {p.relative_to(folder): p.read_bytes() for p in folder.rglob("*") if p.is_file()}

    def test_results_and_summary(self):
        self.assertIn("3 clips: 3 decomposed, 0 kept from before, 0 failed", self.batch())
        names = ["clips/more/swing, noisy.csv", "clips/more/walk.bvh", "clips/walk.bvh"]
        rows = self.summary()
        columns = ["path", "status", "error", "frames", "segments", "cycles", "repetitions", "period_s"]
        self.assertEqual(list(rows[0])[:8], columns)
        self.assertEqual([row["path"] for row in rows], names)
        self.assertEqual(sorted(map(str, self.files())), [
            *(n.replace("/", "__") + ".json" for n in names), "summary.csv"])  # fmt: skip
        result = json.loads((self.out / "clips__walk.bvh.json").read_text())
        origin = result.pop("batch")
        self.assertEqual(origin["bytes"], (self.clips / "walk.bvh").stat().st_size)
        self.assertEqual(origin["options"], {"fps": "30"})
        line = ("decompose", "clips/walk.bvh", "--fps", "30", "--threads", "1")
        alone = self.json(*line, cwd=self.folder)
        self.assertEqual(result, alone)
        self.assertEqual(int(rows[2]["cycles"]), len(alone["cycles"]))
        self.assertEqual(float(rows[2]["period_s"]), alone["period_s"])
        self.assertEqual([rows[2][name] for name in ("status", "error", "reason")], ["done", "", ""])

    def test_the_path_as_given_names_the_result(self):
        line = ("./walk.bvh", "more//../walk.bvh", "../clips/more/walk.bvh", ".")
        self.done("batch", *line, "--out", self.out, "--fps", "30", cwd=self.clips)
        paths = ["../clips/more/walk.bvh", "more/../walk.bvh", "more/swing, noisy.csv",
                 "more/walk.bvh", "walk.bvh"]  # fmt: skip
        self.assertEqual([row["path"] for row in self.summary()], paths)
        for path in paths:
            name = path.removeprefix("../").replace("/", "__")
            self.assertTrue((self.out / f"{name}.json").exists(), path)

    def test_a_path_given_twice_counts_once(self):
        """Another path to the same file has a result of its own, which it names."""
        line = ("clips/walk.bvh", "./clips/walk.bvh", "clips", "clips/")
        text = self.done("batch", *line, "--out", self.out, "--fps", "30", cwd=self.folder)
        self.assertIn(b"3 clips: 3 decomposed", text)
        line = (*line, self.clips / "walk.bvh")
        text = self.done("batch", *line, "--out", self.out, "--fps", "30", cwd=self.folder)
        self.assertIn(b"4 clips: 1 decomposed, 3 kept", text)

    def test_links_that_lead_back(self):
        (self.clips / "loop").symlink_to(".")
        (self.clips / "more" / "up").symlink_to("..")
        elsewhere = self.folder / "elsewhere"
        elsewhere.mkdir()
        shutil.copy(walk(), elsewhere / "other.bvh")
        (self.clips / "link").symlink_to(elsewhere)
        (self.clips / "dangling").symlink_to("nothing")
        self.assertIn("4 clips: 4 decomposed", self.batch())
        self.assertTrue((self.out / "clips__link__other.bvh.json").exists())

    def test_same_bytes_for_any_number_of_jobs(self):
        self.batch()
        for jobs, blas in ((2, 1), (3, 2)):
            other = self.folder / f"out{jobs}"
            environment = plain_environment(OPENBLAS_NUM_THREADS=str(blas))
            self.batch("--jobs", str(jobs), out=other, env=environment)
            self.assertEqual(self.files(other), self.files())

    def test_only_what_changed_is_done_again(self):
        self.batch()
        before = self.files()
        self.assertIn("0 decomposed, 3 kept", self.batch())
        self.assertEqual(self.files(), before)
        (self.out / "clips__walk.bvh.json").unlink()
        self.assertIn("1 decomposed, 2 kept", self.batch())
        self.assertEqual(self.files(), before)
        with (self.out / "clips__walk.bvh.json").open("r+b") as file:  # a write that was cut off
            file.truncate(1000)
        self.assertIn("1 decomposed, 2 kept", self.batch())
        with (self.clips / "walk.bvh").open("a") as file:
            file.write("\n")
        self.assertIn("1 decomposed, 2 kept", self.batch())
        self.assertIn("3 decomposed, 0 kept", self.batch("--period-max", "5"))
        os.utime(self.clips / "walk.bvh", (0, 0))
        self.assertIn("0 decomposed, 3 kept", self.batch("--period-max", "5"))

    def test_bad_files_are_rows(self):
        (self.clips / "bad.bvh").write_text("hello\n")
        line = ("batch", "clips", "missing.csv", "--out", self.out, "--json")
        result = run(*line, "--fps", "30", cwd=self.folder)
        self.assertEqual(result.returncode, 5)
        told = json.loads(result.stdout)
        self.assertEqual((told["clips"], told["failed"]), (5, 2))
        rows = {row["path"]: row for row in self.summary()}
        self.assertEqual(rows["clips/bad.bvh"]["status"], "STLTSA_E_FORMAT")
        self.assertIn("must begin with HIERARCHY", rows["clips/bad.bvh"]["error"])
        self.assertEqual(rows["missing.csv"]["status"], "STLTSA_E_IO")
        self.assertEqual(rows["clips/walk.bvh"]["status"], "done")
        self.assertFalse((self.out / "clips__bad.bvh.json").exists())
        text = self.batch(status=5)
        self.assertIn("0 decomposed, 3 kept from before, 1 failed", text)
        self.assertIn("\n  clips/bad.bvh  line 1: a BVH file must begin", text)

    def test_a_folder_of_results_that_cannot_be_written(self):
        full = self.folder / "out"
        full.mkdir()
        (full / "clips__walk.bvh.json").mkdir()
        line = ("batch", "clips", "--out", full, "--fps", "30")
        self.assertIn("cannot write", self.fails(1, *line, cwd=self.folder))

    def test_a_result_whose_name_is_too_long_is_a_row(self):
        """At most 255 bytes, as long as the file systems of Linux have it."""
        for length, status in ((137, "done"), (138, "STLTSA_E_IO")):
            clip = f"{'m' * 100}/{'n' * length}.bvh"
            path = self.clips / clip
            path.parent.mkdir(exist_ok=True)
            shutil.copy(walk(), path)
            text = self.batch(status=0 if status == "done" else 5)
            rows = {row["path"]: row for row in self.summary()}
            self.assertEqual(rows[f"clips/{clip}"]["status"], status)
            self.assertEqual(rows["clips/walk.bvh"]["status"], "done")
        self.assertIn("would have 256 bytes", text)
        self.assertEqual(max(len(str(name)) for name in self.files()), 255)

    def test_results_among_the_clips(self):
        """The summaries there are no clips."""
        before = self.files(self.clips)
        for out in ("more/results", "."):
            for part in ((), ("--shard", "1/1"), ()):
                result = json.loads(self.batch("--json", *part, out=self.clips / out))
                self.assertEqual((result["clips"], result["failed"]), (3, 0))
            shutil.rmtree(self.clips / "more" / "results", ignore_errors=True)
        self.assertLess(before.items(), self.files(self.clips).items())
        (self.clips / "summary-walk.csv").write_bytes(
            (self.clips / "more" / "swing, noisy.csv").read_bytes())  # fmt: skip
        self.assertIn("4 clips: 1 decomposed, 3 kept", self.batch(out=self.clips))

    def test_a_long_name_has_its_line(self):
        name = 150 * "n" + ".bvh"
        (self.clips / name).write_text("hello\n")
        (self.clips / "bad.bvh").write_text("hello\n")
        text = self.batch(status=5)
        self.assertEqual(text.count(name), 1)
        self.assertIn("\n  clips/bad.bvh  line 1: ", text)
        self.assertIn(f"\n  clips/{name}\n                 line 1: ", text)

    def test_shards(self):
        whole = self.folder / "whole"
        self.batch(out=whole)
        for i in (1, 2):
            self.batch("--shard", f"{i}/2")
        results = {name: data for name, data in self.files(whole).items() if name.suffix == ".json"}
        parts = {name: data for name, data in self.files().items() if name.suffix == ".json"}
        self.assertEqual(parts, results)
        rows = self.summary("summary-1-2.csv") + self.summary("summary-2-2.csv")
        self.assertEqual(len(rows), 3)
        for wrong in ("0/2", "3/2", "2", "a/b", "1/2x"):
            self.assertIn("--shard", self.fails(2, "batch", self.clips, "--out", self.out,
                                                "--shard", wrong))  # fmt: skip

    def test_wrong_command_lines(self):
        for line, hint in (
            (("a__b.bvh", "a/b.bvh"), "same result"),
            (("-",), "stltsa decompose -"),
            ((self.folder / "empty",), "no .bvh"),
            ((self.clips, "--neighbors", "x"), "--neighbors"),
            ((self.clips, "--jobs", "0"), "--jobs"),
        ):
            (self.folder / "empty").mkdir(exist_ok=True)
            self.assertIn(hint, self.fails(2, "batch", *line, "--out", self.out))
        self.assertFalse(self.out.exists())


class PythonReaders(CommandTest):
    """Files that the Python package reads for the command."""

    def setUp(self):
        super().setUp()
        (self.folder / "clips").mkdir()
        shutil.copy(walk(), self.folder / "clips" / "walk.bvh")
        for name in ("a.c3d", "b.TRC"):
            (self.folder / "clips" / name).write_text(name)
        reader = self.folder / "python3"
        turns = [2 * math.pi * i / 100 for i in range(800)]
        values = b"".join(struct.pack("3d", *(math.sin(t + k) for k in range(3))) for t in turns)
        (self.folder / "arrays").write_bytes(b"matrix 0 0 3 800 100.0\n" + values)
        reader.write_text(READER.replace("ARRAYS", str(self.folder / "arrays")))
        reader.chmod(0o755)
        self.reader = str(reader)

    def test_they_are_clips(self):
        line = ("batch", "clips", "--out", "out", "--jobs", "3", "--json")
        environment = plain_environment(STLTSA_PYTHON=self.reader)
        result = run(*line, cwd=self.folder, env=environment)
        self.assertEqual(result.returncode, 5, result.stderr)
        told = json.loads(result.stdout)
        self.assertEqual((told["clips"], told["failed"]), (3, 1))
        with (self.folder / "out" / "summary.csv").open(newline="") as file:
            rows = {row["path"]: row for row in csv.DictReader(file)}
        self.assertIn(int(rows["clips/a.c3d"]["cycles"]), (7, 8))
        self.assertEqual(rows["clips/b.TRC"]["status"], "STLTSA_E_FORMAT")
        self.assertIn("has no points", rows["clips/b.TRC"]["error"])
        again = run(*line, cwd=self.folder, env=environment)
        self.assertEqual(json.loads(again.stdout)["kept"], 2)

    def test_without_the_package_they_are_mentioned(self):
        line = ("batch", "clips", "--out", "out")
        result = run(*line, cwd=self.folder)
        self.assertEqual(result.returncode, 0)
        self.assertIn(b"warning: 2 files left out, such as C3D", result.stderr)
        (self.folder / "clips" / "walk.bvh").unlink()
        self.assertIn("2 files left out", self.fails(2, *line, cwd=self.folder))


if __name__ == "__main__":
    unittest.main()
