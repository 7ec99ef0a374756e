# SPDX-License-Identifier: BSD-3-Clause
"""C3D files, and files that only the Python package reads."""

import json
import math
import struct
import unittest

import jsonschema
from c3d_file import c3d
from common import SCHEMAS, CommandTest, plain_environment, run, walk

NAMES = ("hip", "knee", "toe")
STRIKE = {"LABELS": ["Foot Strike"], "CONTEXTS": ["Left"], "TIMES": [0.0, 2.1]}


def positions(frames=400):
    """Rows of three points of a swinging leg, as numbers of 32 bits hold them."""
    rows = []
    for i in range(frames):
        turn = 2 * math.pi * i / 100
        row = [math.sin(turn + k) / 3 + axis + 0.1 * k for k in range(3) for axis in (0, 1, 2)]
        rows.append(struct.unpack("9f", struct.pack("9f", *row)))
    return rows


class C3d(CommandTest):
    def file(self, name, *arguments, **settings):
        path = self.folder / name
        path.write_bytes(c3d(*arguments, **settings))
        return path

    def setUp(self):
        super().setUp()
        self.c3d = self.file("walk.c3d", positions(), NAMES, parameters={"EVENT": STRIKE})
        head = ",".join(f"{name}_{axis}" for name in NAMES for axis in "xyz")
        lines = [",".join(map(repr, row)) for row in positions()]
        self.table = self.folder / "walk.csv"
        self.table.write_text("\n".join([head, *lines, ""]))

    def told(self, *arguments):
        done = run(*arguments, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        found = json.loads(done.stdout)
        name = found["format"].replace("/", "-")
        jsonschema.validate(found, json.loads((SCHEMAS / f"{name}.schema.json").read_text()))
        return found

    def test_it_is_the_motion_of_the_same_points_as_csv(self):
        plain = self.file("plain.c3d", positions(), NAMES)
        for stretch in ("", ":1s-3s"):
            here = self.told("decompose", f"{self.table}{stretch}", "--fps", "100")
            there = self.told("decompose", f"{plain}{stretch}")
            self.assertEqual(there["clip"].pop("path"), str(plain))
            self.assertEqual(there["clip"].pop("format"), "c3d")
            self.assertEqual(here["clip"].pop("format"), "csv")
            del here["clip"]["path"]
            self.assertEqual(there, here)

    def test_info(self):
        screen = {"Y_SCREEN": ["+Z"], "UNITS": ["mm"]}
        path = self.file("up.c3d", positions(), NAMES, order=">",
                         parameters={"POINT": screen, "EVENT": STRIKE})  # fmt: skip
        found = self.told("info", path)
        self.assertEqual(found["up_axis"], "z")
        self.assertEqual((found["clip"]["up_axis"], found["clip"]["unit"]), ("z", "mm"))
        event = found["clip"]["events"][0]
        self.assertEqual((event["label"], event["context"]), ("Foot Strike", "Left"))
        self.assertAlmostEqual(event["seconds"], 2.1, 5)
        self.assertNotIn("guessed", str(self.told("decompose", path)))
        text = run("info", path).stdout.decode()
        self.assertIn("C3D, 400 frames", text)
        self.assertIn("none: the file has points", text)
        self.assertRegex(text, r"unit +mm")
        self.assertRegex(text, r"events +1 of Left Foot Strike")

    def test_many_points(self):
        names = [f"m{p}" for p in range(260)]
        rows = [[math.sin(i + p) for p in range(780)] for i in range(8)]
        path = self.file("many.c3d", rows, names[:255],
                         parameters={"POINT": {"LABELS2": names[255:]}})  # fmt: skip
        self.assertEqual(self.told("info", path)["channels"]["names"][-1], "m259_z")

    def test_files_that_are_no_motion_of_points(self):
        analog = {"ANALOG": {"USED": [2], "LABELS": ["Fx", "Fz"]}}
        whole = self.c3d.read_bytes()
        (self.folder / "cut.c3d").write_bytes(whole[: len(whole) * 6 // 10])
        (self.folder / "text.c3d").write_text("HIERARCHY\nROOT hip\n")
        self.file("analog.c3d", [[]] * 30, (), parameters=analog, analog=2)
        for name, sentence in (
            ("cut.c3d", "frames that it states: it was cut off"),
            ("text.c3d", "not a C3D file"),
            ("analog.c3d", "has no points; it holds 2 analog channels: 'Fx', 'Fz'"),
        ):
            text = self.fails(3, "info", self.folder / name)
            self.assertIn(f"{name}: ", text)
            self.assertIn(sentence, text)

    def test_no_program_of_the_folder_runs(self):
        marked = f"#!/bin/sh\ntouch {self.folder}/ran\n"
        for name in ("python3", "python"):
            (self.folder / name).write_text(marked)
            (self.folder / name).chmod(0o755)
        (self.folder / "numpy.py").write_text(f"open('{self.folder}/ran', 'w')")
        environment = plain_environment(
            STLTSA_PYTHON=str(self.folder / "python3"), PATH=str(self.folder)
        )
        done = run("info", "walk.c3d", cwd=self.folder, env=environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertFalse((self.folder / "ran").exists())

    def test_events_are_marks(self):
        marked = ("events", walk(), "--mark")
        there = run(*marked, self.c3d, "--json")
        here = run(*marked, "2.1s=Left Foot Strike", "--json")
        self.assertEqual(there.returncode, 0, there.stderr)
        first, second = (json.loads(done.stdout)["events"] for done in (there, here))
        self.assertEqual(len(first), len(second))
        for found, expected in zip(first, second, strict=True):
            self.assertEqual(found["side"], "left")
            self.assertAlmostEqual(found["seconds"], expected["seconds"], 3)

    def test_events_of_the_clip_count_from_its_stretch(self):
        def at(path, *more):
            found = self.told("events", path, "--mark", self.c3d, *more)["events"]
            return [event["seconds"] for event in found if event["marked"]]

        self.assertAlmostEqual(at(self.c3d)[0], 2.1, 5)
        self.assertAlmostEqual(at(f"{self.c3d}:1s-4s")[0], 1.1, 5)
        self.assertAlmostEqual(at(self.c3d, "--fps", "50")[0], 4.2, 5)
        self.assertIn("is a stretch of it", self.fails(
            2, "events", f"{walk()}:1s-4s", "--mark", self.c3d))  # fmt: skip

    def test_files_that_only_python_reads(self):
        for name in ("walk.npz", "walk.nc"):
            (self.folder / name).write_text("")
            self.assertIn("only the Python package reads", self.fails(3, "info", self.folder / name))


if __name__ == "__main__":
    unittest.main()
