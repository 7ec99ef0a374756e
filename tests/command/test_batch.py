# SPDX-License-Identifier: BSD-3-Clause
"""stltsa batch: results, summary, resuming, shards, failures."""

import csv
import json
import math
import os
import random
import shutil
import unittest

from common import CommandTest, plain_environment, run, walk


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
        line = ("batch", self.clips, "--out", out or self.out, "--fps", "30", *arguments)
        result = run(*line, **settings)
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
        names = ["more/swing, noisy.csv", "more/walk.bvh", "walk.bvh"]
        rows = self.summary()
        self.assertEqual([row["clip"] for row in rows], names)
        self.assertEqual(sorted(map(str, self.files())), [*(f"{n}.json" for n in names[:2]),
                                                          "summary.csv", "walk.bvh.json"])  # fmt: skip
        result = json.loads((self.out / "walk.bvh.json").read_text())
        origin = result.pop("batch")
        self.assertEqual(origin["bytes"], (self.clips / "walk.bvh").stat().st_size)
        self.assertEqual(origin["options"], {"fps": "30"})
        alone = self.json("decompose", self.clips / "walk.bvh", "--fps", "30", "--threads", "1")
        self.assertEqual(result, alone)
        self.assertEqual(int(rows[2]["cycles"]), len(alone["cycles"]))
        self.assertEqual(float(rows[2]["period_s"]), alone["period_s"])
        self.assertEqual((rows[2]["status"], rows[2]["message"]), ("done", ""))

    def test_same_bytes_for_any_number_of_workers(self):
        self.batch()
        for workers, blas in ((2, 1), (3, 2)):
            other = self.folder / f"out{workers}"
            environment = plain_environment(OPENBLAS_NUM_THREADS=str(blas))
            self.batch("--workers", str(workers), out=other, env=environment)
            self.assertEqual(self.files(other), self.files())

    def test_only_what_changed_is_done_again(self):
        self.batch()
        before = self.files()
        self.assertIn("0 decomposed, 3 kept", self.batch())
        self.assertEqual(self.files(), before)
        (self.out / "walk.bvh.json").unlink()
        self.assertIn("1 decomposed, 2 kept", self.batch())
        self.assertEqual(self.files(), before)
        with (self.out / "walk.bvh.json").open("r+b") as file:  # a write that was cut off
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
        line = ("batch", self.clips, self.folder / "missing.csv", "--out", self.out, "--json")
        result = run(*line, "--fps", "30")
        self.assertEqual(result.returncode, 5)
        told = json.loads(result.stdout)
        self.assertEqual((told["clips"], told["failed"]), (5, 2))
        rows = {row["clip"]: row for row in self.summary()}
        self.assertEqual(rows["bad.bvh"]["status"], "STLTSA_E_FORMAT")
        self.assertIn("must begin with HIERARCHY", rows["bad.bvh"]["message"])
        self.assertEqual(rows["missing.csv"]["status"], "STLTSA_E_IO")
        self.assertEqual(rows["walk.bvh"]["status"], "done")
        self.assertFalse((self.out / "bad.bvh.json").exists())
        text = self.batch(status=5)
        self.assertIn("0 decomposed, 3 kept from before, 1 failed", text)
        self.assertIn("\n  bad.bvh  line 1: a BVH file must begin", text)

    def test_a_long_name_has_its_line(self):
        name = 150 * "n" + ".bvh"
        (self.clips / name).write_text("hello\n")
        (self.clips / "bad.bvh").write_text("hello\n")
        text = self.batch(status=5)
        self.assertEqual(text.count(name), 1)
        self.assertIn("\n  bad.bvh  line 1: ", text)
        self.assertIn(f"\n  {name}\n           line 1: ", text)

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
            ((self.clips, self.clips), "same result"),
            ((self.folder / "empty",), "no .bvh"),
            ((self.clips, "--neighbors", "x"), "--neighbors"),
            ((self.clips, "--workers", "0"), "--workers"),
        ):
            (self.folder / "empty").mkdir(exist_ok=True)
            self.assertIn(hint, self.fails(2, "batch", *line, "--out", self.out))
        self.assertFalse(self.out.exists())


if __name__ == "__main__":
    unittest.main()
