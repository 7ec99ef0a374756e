# SPDX-License-Identifier: BSD-3-Clause
"""stltsa batch: results, summary, resuming, shards, failures."""

import csv
import json
import math
import os
import random
import re
import shutil
import unittest

from c3d_file import c3d
from common import CommandTest, plain_environment, run, two_motions, walk


ASF = """:version 1.10
:name two bones
:units
  mass 1.0
  length 1.0
  angle deg
:root
  order TX TY TZ RX RY RZ
  axis XYZ
  position 0 90 0
  orientation 0 0 0
:bonedata
  begin
    id 1
    name leg
    direction 0 -1 0
    length 40
    axis 0 0 0 XYZ
    dof rx ry rz
  end
:hierarchy
  begin
    root leg
  end
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
        line = ("decompose", "clips/walk.bvh", "--threads", "1")  # its own rate, not that of --fps
        alone = self.json(*line, cwd=self.folder)
        self.assertEqual(result, alone)
        self.assertEqual(int(rows[2]["cycles"]), len(alone["cycles"]))
        self.assertEqual([float(row["fps"]) for row in rows], [30, 60, 120])
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
        (self.clips / "dangling").symlink_to("nothing")  # names no clip
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

    def test_a_recording_of_bids(self):
        """What describes it is no clip, and if it changes, the result is made anew."""
        folder = self.clips / "sub-1" / "motion"
        folder.mkdir(parents=True)
        stem = "sub-1_task-a_tracksys-b"
        axes = [(point, axis) for point in ("hip", "knee", "heel", "toe") for axis in "xyz"]
        (folder / f"{stem}_channels.tsv").write_text("name\ttype\tcomponent\ttracked_point\n" + "".join(
            f"{point}{axis}\tPOS\t{axis}\t{point}\n" for point, axis in axes))  # fmt: skip
        (folder / f"{stem}_motion.tsv").write_text("".join(
            "\t".join(f"{c + math.sin(i / 10 + c):.4f}" for c in range(len(axes))) + "\n"
            for i in range(300)))  # fmt: skip
        (self.clips / "participants.tsv").write_text("participant_id\tage\nsub-1\t30\n")
        rate = self.clips / "task-a_motion.json"  # above the folder of the subject
        for fps, counts in (("60", "4 decomposed, 0"), ("60", "0 decomposed, 4"), ("50", "1 decomposed, 3")):
            rate.write_text('{"SamplingFrequency": ' + fps + "}")
            self.assertIn(f"4 clips: {counts} kept from before, 0 failed", self.batch())
            self.assertEqual(self.summary()[2]["fps"], fps)

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

    def test_what_has_the_name_of_a_clip_has_a_row(self):
        (self.clips / "dangling.bvh").symlink_to("nothing")
        os.mkfifo(self.clips / "pipe.csv")
        (self.clips / ".hidden.bvh").write_text("being written")
        self.batch(status=5)
        rows = {row["path"]: row for row in self.summary()}
        self.assertEqual(len(rows), 5)
        for name, why in (("dangling.bvh", "No such file"), ("pipe.csv", "not a file")):
            self.assertEqual(rows[f"clips/{name}"]["status"], "STLTSA_E_IO")
            self.assertIn(why, rows[f"clips/{name}"]["error"])

    @unittest.skipUnless(os.geteuid(), "root may list every folder")
    def test_a_folder_that_cannot_be_listed_has_a_row(self):
        (self.clips / "more").chmod(0o300)
        self.addCleanup((self.clips / "more").chmod, 0o700)
        self.batch(status=5)
        status = {row["path"]: row["status"] for row in self.summary()}
        self.assertEqual(status, {"clips/more": "STLTSA_E_IO", "clips/walk.bvh": "done"})

    def test_fps_is_for_files_without_a_usable_rate(self):
        text = walk().read_text()
        path = self.clips / "walk.bvh"
        path.write_text(re.sub("Frame Time: .*", "Frame Time: 30", text))
        result = run("batch", path, "--out", self.out)
        self.assertEqual(result.returncode, 5)
        self.assertIn(b"set --fps", result.stdout)
        self.batch()
        self.assertEqual([row["fps"] for row in self.summary()], ["30", "60", "30"])
        stretch = ("batch", "clips/more/swing, noisy.csv:0s-9s", "clips/more/walk.bvh:0s-99s")
        result = run(*stretch, "--out", self.out, "--fps", "30", cwd=self.folder)
        self.assertEqual(result.returncode, 5)  # at its own rate the walk has fewer seconds
        self.assertEqual([row["frames"] for row in self.summary()], ["270", ""])

    def test_damaged_results_are_made_anew(self):
        self.batch()
        before, path = self.files(), self.out / "clips__walk.bvh.json"
        whole = path.read_bytes()
        frames = re.search(rb'"frames":\d+', whole)[0]
        for damaged in (
            b"",
            b"{}",
            whole[:-1],
            whole[200:],
            whole.replace(b'"segments"', b'\0\0segments"', 1),
            whole.replace(frames, b'"frames":9', 1),
            whole.replace(b'"cycles":', b'"Cycles":', 1),
            whole.replace(b'"options":{', b'"options":[', 1),
            whole.replace(b'"source":"', b'"source":"\xff', 1),
            whole.replace(b'"source":"../clips/walk.bvh"', b'"source":7', 1),
            whole.replace(b'"source":"../clips/walk.bvh"', b'"source":"../clips/wall.bvh"', 1),
            b'{"batch":1,"batch":' + 100000 * b"[" + b"}\n",
        ):
            path.write_bytes(damaged)
            self.assertIn("1 decomposed, 2 kept", self.batch(), damaged[-300:])
            self.assertEqual(self.files(), before)

    def test_what_is_no_result_is_in_its_place(self):
        """Only this clip fails."""
        place, name = self.out / "clips__walk.bvh.json", "clips/walk.bvh"
        self.out.mkdir()
        for make, said in (
            (place.mkdir, "is not a file"),
            (lambda: os.mkfifo(place), "is not a file"),
            (lambda: place.symlink_to(self.clips), "is not a file"),
            (lambda: place.symlink_to(place), "cannot write"),
            (lambda: place.symlink_to("missing/folder"), "cannot write"),
        ):
            make()
            self.assertIn("1 failed", self.batch(status=5))
            self.assertIn(said, self.summary()[-1]["error"])
            rows = {row["path"]: row for row in self.summary()}
            self.assertEqual(rows.pop(name)["status"], "STLTSA_E_IO")
            self.assertEqual([row["status"] for row in rows.values()], ["done", "done"])
            (place.rmdir if place.is_dir() and not place.is_symlink() else place.unlink)()

    def test_a_summary_that_cannot_be_written(self):
        """Said at once, before hours of work."""
        (self.out / "summary.csv").mkdir(parents=True)
        line = ("batch", "clips", "--out", self.out, "--fps", "30")
        self.assertIn("cannot write", self.fails(1, *line, cwd=self.folder))
        self.assertEqual(self.files(), {})

    def test_one_path_from_two_folders(self):
        """The result of another clip stays; it may be replaced when that clip is gone."""
        for place in ("here", "there"):
            (self.folder / place).mkdir()
            shutil.copy(walk(120 if place == "here" else 60), self.folder / place / "walk.bvh")

        def batch(place, *flags):
            line = ("batch", "walk.bvh", "--out", self.out, "--json", *flags)
            told = json.loads(run(*line, cwd=self.folder / place).stdout)
            return told["kept"], told["failed"]

        self.assertEqual(batch("here"), (0, 0))
        before = (self.out / "walk.bvh.json").read_bytes()
        self.assertEqual(batch("there"), (0, 1))
        (row,) = self.summary()
        self.assertEqual(row["status"], "STLTSA_E_IO")
        self.assertIn(f"is that of another clip, {self.folder}/here/walk.bvh", row["error"])
        self.assertEqual((self.out / "walk.bvh.json").read_bytes(), before)
        self.assertEqual(batch("here"), (1, 0))
        self.assertEqual(batch("here", "--segments", "1"), (0, 0))
        (self.folder / "here" / "walk.bvh").rename(self.folder / "here" / "old.bvh")
        self.assertEqual(batch("there"), (0, 0))
        self.assertEqual(batch("there"), (1, 0))
        (self.folder / "there").rename(self.folder / "moved")
        self.assertEqual(batch("moved"), (1, 0))

    def test_confidence_of_the_longest_segment(self):
        clips = [f"{two_motions()}:250-720", f"{two_motions()}:0-500"]
        self.done("batch", *clips, "--out", self.out, "--fps", "30")
        for row in self.summary():
            segments = self.json("decompose", row["path"], "--fps", "30")["segments"]
            segments.sort(key=lambda segment: segment["end_s"] - segment["begin_s"])
            self.assertNotEqual(segments[0]["confidence"], segments[-1]["confidence"])
            self.assertEqual(float(row["confidence"]), segments[-1]["confidence"])

    def test_cells_that_a_spreadsheet_would_split(self):
        """Semicolons and tabs separate cells in some countries and programs."""
        for name in ("a\rb", "a;=1+1", "a\tb", 'a"b', "a,b"):
            (self.folder / f"{name}.bvh").write_text("hello\n")
            self.batch(f"{name}.bvh", status=5)
            quoted = name.replace('"', '""')
            begin = f'"{quoted}.bvh",STLTSA_E_FORMAT,'.encode()
            self.assertIn(b"\n" + begin, (self.out / "summary.csv").read_bytes())

    def test_cells_that_a_spreadsheet_would_evaluate(self):
        (self.folder / "=1+1.bvh").write_text("hello\n")
        self.batch("=1+1.bvh", status=5)
        row = next(row for row in self.summary() if "1+1" in row["path"])
        self.assertEqual(row["path"], "'=1+1.bvh")
        self.assertTrue(row["error"].startswith("'=1+1.bvh:1: "))

    def test_a_result_whose_name_is_too_long_is_a_row(self):
        """At most 255 bytes, as long as the file systems of Linux have it."""
        for length, status in ((137, "done"), (138, "STLTSA_E_IO")):
            clip = f"{'m' * 100}/{'n' * length}.bvh"
            path = self.clips / clip
            path.parent.mkdir(exist_ok=True)
            shutil.copy(walk(), path)
            self.batch(status=0 if status == "done" else 5)
            rows = {row["path"]: row for row in self.summary()}
            self.assertEqual(rows[f"clips/{clip}"]["status"], status)
            self.assertEqual(rows["clips/walk.bvh"]["status"], "done")
        self.assertIn("would have 256 bytes", rows[f"clips/{clip}"]["error"])
        self.assertEqual(max(len(str(name)) for name in self.files()), 255)

    def test_results_among_the_clips(self):
        """Summaries are no clips, wherever they are and whatever their name is."""
        before = self.files(self.clips)
        for out in ("more/results", ".", "other"):
            for part in ((), ("--shard", "1/1"), ()):
                result = json.loads(self.batch("--json", *part, out=self.clips / out))
                self.assertEqual((result["clips"], result["failed"]), (3, 0))
        (self.clips / "summary.csv").rename(self.clips / "monday.csv")
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
            self.assertIn(f"the shard is '{wrong}'", self.fails(2, "batch", self.clips, "--out", self.out,
                                                         "--shard", wrong))  # fmt: skip

    def test_wrong_command_lines(self):
        for line, hint in (
            (("a__b.bvh", "a/b.bvh"), "same result"),
            (("-",), "stltsa decompose -"),
            ((self.folder / "empty",), "no .bvh"),
            ((self.clips, "--neighbors", "x"), "--neighbors"),
            ((self.clips, "--jobs", "0"), "--jobs"),
            ((self.clips, "--period-min", "3", "--period-max", "2"), "--period-min"),
        ):
            (self.folder / "empty").mkdir(exist_ok=True)
            self.assertIn(hint, self.fails(2, "batch", *line, "--out", self.out))
        self.assertFalse(self.out.exists())


class Skeletons(CommandTest):
    """AMC files, whose skeletons are other files."""

    def setUp(self):
        super().setUp()
        self.clips = self.folder / "clips"
        self.clips.mkdir()
        self.asf = self.clips / "02.asf"
        self.asf.write_text(ASF)
        rows = [f"{i + 1}\nroot 0 0 0 0 0 0\nleg {20 * math.sin(i / 8):.4f} 0 0\n" for i in range(300)]
        text = ":FULLY-SPECIFIED\n:DEGREES\n" + "".join(rows)
        (self.clips / "02_01.amc").write_text(text)
        (self.clips / "02_02.amc").write_text(text)

    def batch(self, *arguments):
        line = ("batch", "clips", "--out", "out", "--fps", "60", "--json", *arguments)
        result = run(*line, cwd=self.folder)
        with (self.folder / "out" / "summary.csv").open(newline="") as file:
            status = [row["status"] for row in csv.DictReader(file)]
        return json.loads(result.stdout)["kept"], status

    def test_what_lies_beside_a_clip(self):
        os.mkfifo(self.clips / "pipe.asf")
        (self.clips / "folder.ASF").mkdir()
        (self.clips / "dangling.asf").symlink_to("nothing")
        (self.clips / "loop.asf").symlink_to("loop.asf")
        (self.clips / ".hidden.asf").write_text("being written")
        self.assertEqual(self.batch(), (0, ["done", "done"]))
        (self.clips / ".hidden.asf").unlink()
        self.assertEqual(self.batch(), (2, ["done", "done"]))

    def test_a_changed_skeleton_is_noticed(self):
        self.assertEqual(self.batch(), (0, ["done", "done"]))
        self.asf.write_text(ASF.replace("length 40", "length 50"))
        self.assertEqual(self.batch(), (0, ["done", "done"]))
        self.assertEqual(self.batch(), (2, ["done", "done"]))
        result = json.loads((self.folder / "out" / "clips__02_01.amc.json").read_text())
        self.assertEqual(result["batch"]["bytes"],
                         self.asf.stat().st_size + (self.clips / "02_01.amc").stat().st_size)

    def test_a_skeleton_by_option(self):
        other = self.folder / "other.asf"
        other.write_text(ASF)
        self.asf.unlink()
        option = ("--skeleton", other)
        self.assertEqual(self.batch(*option), (0, ["done", "done"]))
        self.assertEqual(self.batch(*option), (2, ["done", "done"]))
        other.write_text(ASF.replace("length 40", "length 50"))
        self.assertEqual(self.batch(*option), (0, ["done", "done"]))
        other.unlink()
        os.mkfifo(other)
        self.assertEqual(self.batch(*option), (0, ["STLTSA_E_IO"] * 2))


class OtherFormats(CommandTest):
    """C3D files, and those that only the Python package reads."""

    def setUp(self):
        super().setUp()
        (self.folder / "clips").mkdir()
        turns = [2 * math.pi * i / 100 for i in range(800)]
        rows = [[math.sin(t + k) for k in range(9)] for t in turns]
        (self.folder / "clips" / "a.c3d").write_bytes(c3d(rows, ("hip", "knee", "toe")))
        for name in ("b.npz", "c.NC"):
            (self.folder / "clips" / name).write_text(name)

    def test_c3d_files_are_clips_and_the_others_have_a_row(self):
        result = run("batch", "clips", "--out", "out", cwd=self.folder)
        self.assertEqual(result.returncode, 5, result.stderr)
        with (self.folder / "out" / "summary.csv").open(newline="") as file:
            rows = {row["path"]: row for row in csv.DictReader(file)}
        self.assertEqual(list(rows), ["clips/a.c3d", "clips/b.npz", "clips/c.NC"])
        self.assertIn(int(rows["clips/a.c3d"]["cycles"]), (7, 8))
        for name in ("b.npz", "c.NC"):
            self.assertEqual(rows[f"clips/{name}"]["status"], "STLTSA_E_FORMAT")
            self.assertIn("only the Python package reads", rows[f"clips/{name}"]["error"])

    def test_clips_of_all_formats_are_found(self):
        """The library lists the suffixes that it reads: batch takes the same."""
        text = self.folder / "hello.txt"
        text.write_text("hello\n")
        suffixes = re.findall(r"\.\w+", self.fails(3, "info", text).split("a known format: ")[1])
        self.assertIn(".sto", suffixes)
        for suffix in suffixes:
            (self.folder / "clips" / f"all{suffix}").write_text("hello\n")
        run("batch", "clips", "--out", "out", cwd=self.folder)
        with (self.folder / "out" / "summary.csv").open(newline="") as file:
            paths = {row["path"] for row in csv.DictReader(file)}
        others = {"clips/a.c3d", "clips/b.npz", "clips/c.NC"}
        self.assertEqual(paths, {*others, *(f"clips/all{suffix}" for suffix in suffixes)})


if __name__ == "__main__":
    unittest.main()
