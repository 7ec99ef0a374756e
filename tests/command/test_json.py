# SPDX-License-Identifier: BSD-3-Clause
"""JSON: schemas, and numbers."""

import copy
import csv
import json
import math
import os
import re
import shutil
import unittest

import jsonschema
import numpy

from common import CLIPS, SCHEMAS, CommandTest, circle, cut, drift, limbs, markers, run, walk, write_csv

KINDS = {"info": "clip", "fit": "model", "dimension": "model", "decompose": "decomposition",
         "denoise": "denoising"}


def validator(kind):
    schema = json.loads(next(SCHEMAS.glob(f"stltsa-{kind}-*.schema.json")).read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def npy_clip():
    path = CLIPS / "circle.npy"
    numpy.save(path, numpy.loadtxt(circle(), delimiter=",").astype(numpy.float32))
    return path


def arm_that_swings(name, channels, twist):
    """A trunk, an arm, and a hand with these channels; twist(t) sets the last ones of the hand."""
    joints = [("JOINT arm", "20 50 0", "Zrotation Xrotation Yrotation"), ("JOINT hand", "30 0 0", channels)]
    head = "HIERARCHY\nROOT trunk\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\n"
    for joint, offset, own in joints:
        head += f"{joint}\n{{\nOFFSET {offset}\nCHANNELS {len(own.split())} {own}\n"
    head += "End Site\n{\nOFFSET 10 0 0\n}\n" + "}\n" * 3
    rows = [[0, 100, 0, 30 * math.sin(turn), 20 * math.cos(turn), 0, *twist(i / 30)]
            for i, turn in enumerate(2 * math.pi * k / 30 for k in range(1800))]
    path = CLIPS / name
    path.write_text(head + f"MOTION\nFrames: {len(rows)}\nFrame Time: 0.0333333\n"
                    + "".join(" ".join(f"{value:.4f}" for value in row) + "\n" for row in rows))
    return path


class Behaviors(CommandTest):
    def test_rotations_that_move_no_joint_tell_behaviors_apart(self):
        def hand(t):
            return (90 * math.sin(math.pi * t) if t >= 30 else 0,)

        found = self.json("decompose", arm_that_swings("twist.bvh", "Xrotation", hand))
        self.assertEqual([s["label"] for s in found["segments"]], ["A", "B"])
        self.assertAlmostEqual(found["segments"][1]["begin_s"], 30, delta=0.5)
        (one, between), (_, other) = found["label_likeness"]
        self.assertEqual((one, other), (None, None))
        self.assertLess(between, 0.65)

    def test_joints_that_only_move(self):
        path = arm_that_swings("moved.bvh", "Xposition Yposition Zposition", lambda t: (30, 0, 0))
        lines = path.read_text().replace("Zrotation Xrotation Yrotation", "Xposition Yposition Zposition")
        path.write_text(lines)
        self.assertEqual(len(self.json("decompose", path)["segments"]), 1)


class Schemas(CommandTest):
    def check(self, command, *arguments, status=0):
        result = run(command, *arguments, "--json")
        self.assertEqual(result.returncode, status, result.stderr)
        self.assertEqual(result.stdout.count(b"\n"), 1)
        found = json.loads(result.stdout)
        version = 2 if command == "decompose" else 1
        self.assertEqual(found["format"], f"stltsa-{KINDS[command]}/{version}")
        errors = list(validator(KINDS[command]).iter_errors(found))
        self.assertEqual([e.message for e in errors], [])
        return found

    def test_walk(self):
        for command in KINDS:
            with self.subTest(command):
                self.check(command, walk())

    def test_bare_numbers(self):
        for command in KINDS:
            with self.subTest(command):
                self.check(command, circle(), "--fps", "30")
                self.check(command, npy_clip(), "--fps", "30")

    def test_unknown_frame_rate(self):
        for command in ("info", "fit", "dimension"):
            with self.subTest(command):
                self.assertIsNone(self.check(command, circle())["clip"]["fps"])

    def test_auto_is_the_default(self):
        line = ("fit", walk(), "--json")
        words = ("neighbors", "window", "dimension", "threads", "features", "up-axis", "fps",
                 "skeleton")
        autos = [word for name in words for word in (f"--{name}", "auto")]
        self.assertEqual(self.done(*line, *autos), self.done(*line))

    def test_options(self):
        self.check("fit", walk(), "--mode", "recurrent", "--links", "3", "--no-include-self")
        self.check("fit", circle(), "--mode", "spatial", "--neighbors", "10")
        self.check("fit", cut(), "--neighbors", "5", "--window", "8", status=4)
        self.check("dimension", walk(), "--variance", "0.9", "--eigengap", "0.2")
        self.check("decompose", walk(), "--features", "euler", "--sample-rate", "0")
        self.check("decompose", walk(), "--curve")
        self.check("decompose", drift(), "--fps", "30")
        self.check("denoise", walk(), "--curve", "--gamma", "0.01", "--knot-spacing", "0.2", "--no-robust")
        self.check("denoise", circle(), "--coordinates")
        self.check("denoise", cut(), "--neighbors", "5", "--window", "8")

    def test_refuse_what_they_do_not_know(self):
        """Schemas are strict: an unknown member in any object is refused."""

        def objects(value, path=()):
            if isinstance(value, dict):
                yield path
            for key, member in (
                value.items()
                if isinstance(value, dict)
                else enumerate(value)
                if isinstance(value, list)
                else ()
            ):
                yield from objects(member, (*path, key))

        for found in self.one_of_each():
            kind = found["format"].removeprefix("stltsa-").partition("/")[0]
            self.assertEqual([e.message for e in validator(kind).iter_errors(found)], [])
            for path in objects(found):
                changed = copy.deepcopy(found)
                target = changed
                for key in path:
                    target = target[key]
                target["unknown"] = 1
                with self.subTest(kind, path=path):
                    self.assertFalse(validator(kind).is_valid(changed))

    def one_of_each(self):
        """One object for every schema."""
        model = self.folder / "walk.stltsa"
        self.done("fit", walk(), "-o", model)
        found = [self.check(command, walk()) for command in KINDS]
        found.append(self.json("map", model, walk(), "--curve"))
        found.append(self.json("synthesize", f"{walk()}:best*2", "-o", self.folder / "loop.bvh"))
        found.append(self.json("events", walk(), "--mark", "250=strike"))
        # Few columns, because every object of it is tried.
        found.append(self.json("compare", circle(), circle(), "--fps", "30"))
        schemas = {f"{o['format'].replace('/', '-')}.schema.json" for o in found}
        schemas.add("stltsa-live-1.schema.json")  # of each line: test_live.py
        self.assertEqual(schemas, {path.name for path in SCHEMAS.iterdir()})
        return found


class Content(CommandTest):
    def test_info(self):
        lines = walk().read_text().splitlines()
        motion = lines.index("MOTION")
        frames = int(lines[motion + 1].split()[1])
        found = self.json("info", walk())
        self.assertEqual(found["clip"]["frames"], frames)
        self.assertEqual(found["clip"]["fps"], 120)
        self.assertAlmostEqual(found["clip"]["duration_s"], frames / 120)
        joints = sum(line.split()[0] in ("ROOT", "JOINT", "End") for line in lines if line.strip())
        self.assertEqual(len(found["joints"]), joints)
        self.assertEqual(found["channels"]["count"], len(lines[motion + 3].split()))
        self.assertEqual(found["up_axis"], "y")

    def test_fps_over_the_files(self):
        self.assertEqual(self.json("info", walk(), "--fps", "60")["clip"]["fps"], 60)

    def test_units_cover_the_clip(self):
        found = self.json("decompose", walk())
        units = found["units"]
        self.assertEqual(units[0]["begin"], 0)
        self.assertEqual(units[-1]["end"], found["clip"]["frames"])
        for before, after in zip(units, units[1:]):
            self.assertEqual(before["end"], after["begin"])
            self.assertEqual(before["end_s"], after["begin_s"])
        for unit in units:
            self.assertLess(unit["begin"], unit["end"])
            self.assertAlmostEqual(unit["begin_s"] * 120, unit["begin"], delta=0.51)

    def test_units_lie_in_their_segments(self):
        """Also where a unit between the last cycle and the end of the segment has no frame."""
        rows = []
        for columns, seconds, period in ((0, 8.8, 1.1), (3, 16.8, 1.2)):
            for i in range(round(30 * seconds)):
                turn, row = 2 * math.pi * i / 30 / period, [0] * 6
                row[columns:columns + 3] = [1 - math.cos(turn), math.sin(turn),
                                            0.3 * math.sin(2 * turn + 1) - 0.25]
                rows.append(row)
        found = self.json("decompose", write_csv("after another.csv", rows), "--fps", "30")
        self.assertEqual(len(found["segments"]), 2)
        for unit in found["units"]:
            segment = found["segments"][unit["segment"]]
            self.assertGreaterEqual(unit["begin_s"], segment["begin_s"])
            self.assertLessEqual(unit["end_s"], segment["end_s"])

    def test_cycles_of_the_walk(self):
        found = self.json("decompose", walk())
        cycles = found["cycles"]
        self.assertEqual(len(cycles), 3)
        for before, after in zip(cycles, cycles[1:]):
            self.assertEqual(before["end"], after["begin"])
        for name in ("representative_cycle", "best_cycle"):
            chosen = dict(found[name])
            self.assertEqual(chosen, {"index": chosen["index"], **{
                key: cycles[chosen["index"]][key] for key in ("begin", "end", "begin_s", "end_s")}})
        self.assertIsNone(found["reason"])
        self.assertAlmostEqual(found["period_s"], 1.1, delta=0.05)

    def test_no_cycle_has_a_reason(self):
        found = self.json("decompose", drift(), "--fps", "30")
        self.assertEqual(found["cycles"], [])
        self.assertIsNone(found["representative_cycle"])
        self.assertTrue(found["reason"])

    def test_curve(self):
        found = self.json("decompose", walk(), "--curve")
        samples, curve = found["samples"], found["curve"]
        self.assertEqual(
            curve["frames"],
            [samples["first_frame"] + i * samples["frame_step"] for i in range(samples["count"])],
        )
        self.assertEqual(len(curve["values"]), samples["count"])
        self.assertEqual(len(curve["loop"]), samples["count"])
        without = self.json("decompose", walk())
        del found["curve"]
        self.assertEqual(found, without)

    def test_lengths_in_seconds(self):
        for rate in ("0", "20", "30", "45", "50", "120", "1000"):
            with self.subTest(rate=rate):
                found = self.json(
                    "fit", walk(), "--sample-rate", rate, "--neighbors", "0.5s", "--window", "0.8s"
                )
                fps = found["samples"]["fps"]
                self.assertEqual(found["parameters"]["neighbors"], round(0.5 * fps))
                self.assertEqual(found["parameters"]["window"], round(0.8 * fps))

    def test_lengths_in_samples(self):
        found = self.json("fit", walk(), "--neighbors", "17", "--window", "20")
        self.assertEqual(found["parameters"]["neighbors"], 17)
        self.assertEqual(found["parameters"]["window"], 20)

    def test_options_reach_the_library(self):
        found = self.json(
            *("fit", walk(), "--mode", "recurrent", "--links", "3", "--exclusion", "99"),
            *("--dimension", "3", "--no-include-self", "--features", "rotations6d"),
            *("--smoothing", "0", "--sample-rate", "60", "--up-axis", "z"),
        )
        parameters = found["parameters"]
        self.assertEqual(parameters["mode"], "recurrent")
        self.assertEqual(parameters["links"], 3)
        self.assertEqual(parameters["exclusion"], 99)
        self.assertEqual(parameters["dimension"], 3)
        self.assertFalse(parameters["include_self"])
        self.assertEqual(found["clip"]["features"], "rotations6d")
        self.assertEqual(found["samples"]["smoothing_s"], 0)
        self.assertEqual(found["samples"]["frame_step"], 2)
        self.assertEqual(found["samples"]["up_axis"], "z")

    def test_table_for_spreadsheets(self):
        path = self.folder / "units.csv"
        self.done("decompose", walk(), "-o", path)
        with path.open(encoding="ascii", newline="") as file:
            rows = list(csv.DictReader(file))
        found = self.json("decompose", walk())
        for level, listed in (
            ("segment", found["segments"]),
            ("unit", found["units"]),
            ("cycle", found["cycles"]),
            ("repetition", found["repetitions"]),
        ):
            own = [row for row in rows if row["level"] == level]
            self.assertEqual(len(own), len(listed), level)
            for row, one in zip(own, listed, strict=True):
                self.assertEqual(row["kind"], one.get("kind", level))
                self.assertEqual((int(row["begin"]), int(row["end"])), (one["begin"], one["end"]))
                self.assertEqual(float(row["begin_s"]), one["begin_s"])
                self.assertAlmostEqual(float(row["duration_s"]), one["end_s"] - one["begin_s"])
                travel = one.get("travel") or {}
                for key in ("path_length", "stride", "speed", "turn_deg"):
                    self.assertEqual(float(row[key]) if row[key] else None, travel.get(key))
                self.assertEqual(level == "cycle", bool(row["path_length"]))
                for key in ("likeness", "confidence"):
                    self.assertEqual(float(row[key]) if row[key] else None, one.get(key))
                segment = found["segments"][one.get("segment", 0)] if level != "segment" else one
                self.assertEqual(row["label"] or None, segment["label"])
        self.assertIn(".csv", self.fails(2, "decompose", walk(), "-o", self.folder / "units.xls"))
        self.assertIn(".json", self.fails(2, "decompose", walk(), "--json", "-o", path))
        table = self.done("decompose", walk())
        travels = [line.split() for line in table.decode().splitlines()
                   if line.startswith(("  cycle ", "  step ")) and line.split()[1].isdigit()]
        self.assertEqual(len(travels), len(found["cycles"]) + len(found["steps"]))
        for line, part in zip(travels, found["cycles"] + found["steps"], strict=True):
            self.assertEqual(line[2], part["side_name"])
            self.assertEqual(line[3], f"{part['travel']['path_length']:.4g}")
        self.assertEqual(self.done("decompose", walk(), "-o", "-"), table)

    def test_steps_name_the_side_in_every_form_of_names(self):
        text = walk().read_text()
        self.assertIn("JOINT LeftFoot\n", text)
        usual = [step["side_name"] for step in self.json("decompose", walk())["steps"]]
        self.assertEqual(set(usual), {"left", "right"})
        path = self.folder / "renamed.bvh"
        for left, right in ((r"l\1", r"r\1"), (r"\1.L", r"\1.R"), (r"\1L", r"\1R"), (r"Bip01 L \1", r"Bip01 R \1"),
                            (r"mixamorig:Left\1", r"mixamorig:Right\1")):
            renamed = re.sub(r"JOINT Left(\w+)", "JOINT " + left, text)
            path.write_text(re.sub(r"JOINT Right(\w+)", "JOINT " + right, renamed))
            self.assertEqual([step["side_name"] for step in self.json("decompose", path)["steps"]], usual)
        output = self.done("decompose", path).decode()
        self.assertRegex(output, r"a minute; (left: [\d.]+ s,\s+right|right: [\d.]+ s,\s+left): [\d.]+ s")

    def test_legs_alone_have_steps_of_the_right_sides(self):
        for style in (lambda s, n: s[0].upper() + n, lambda s, n: f"{s}_{n.lower()}",
                      lambda s, n: f"{n.lower()}_{s[0]}", lambda s, n: f"{n}.{s[0].upper()}",
                      lambda s, n: s.capitalize() + n):
            for names in (("Hip", "Knee", "Ankle", "Heel", "Toe"), ("Ankle", "Heel", "Toe"), ("Heel", "Toe")):
                found = self.json("decompose", limbs(names, style, legs=0.45))
                self.assertGreater(len(found["steps"]), 13)
                for step in found["steps"]:
                    left = step["side_name"] == "left"
                    self.assertLess(abs(step["end_s"] - step["begin_s"] - (0.57 if left else 0.53)), 0.005)
                    forward = (step["begin_s"] - (0 if left else 0.57)) / 1.1  # where the leg is fastest
                    self.assertLess(abs(forward - round(forward)), 0.1)

    def test_arms_that_swing_in_turn_are_no_steps(self):
        names = ("Hip", "Knee", "Ankle", "Heel", "Toe", "Shoulder", "Elbow", "Wrist")
        for arms in (0.3, 0.6, 1.2):
            found = self.json("decompose", limbs(names, lambda s, n: f"{s}_{n}", arms=arms))
            self.assertGreater(len(found["cycles"]), 5)
            self.assertEqual(found["steps"], [])
            self.assertIn("do not swing in turn", found["segments"][0]["steps_reason"])

    def test_markers(self):
        found = self.json("decompose", markers())
        self.assertEqual(found["clip"]["features"], "points")
        self.assertEqual(found["samples"]["up_axis"], "z")
        self.assertIn(len(found["cycles"]), (8, 9))
        notes = " ".join(found["clip"]["notes"])
        for part in ("'m3' (10 in all)", "up axis guessed: z", "removed the horizontal path"):
            self.assertIn(part, notes)
        raw = self.json("decompose", markers(), "--features", "raw")
        self.assertIn("only drift", " ".join(raw["clip"]["notes"]))
        self.assertEqual(self.json("info", markers())["up_axis"], "z")
        self.json("decompose", markers(), "--features", "points", "--up-axis", "z")
        message = self.fails(1, "decompose", walk(), "--features", "points")
        self.assertIn("use positions", message)

    def test_same_text_for_any_number_of_threads(self):
        for command in KINDS:
            if command == "info":
                continue
            texts = {self.done(command, walk(), "--json", "--threads", n) for n in ("1", "2")}
            self.assertEqual(len(texts), 1, command)

    def test_path_that_is_not_utf8(self):
        path = os.fsencode(self.folder) + b"/walk\xff.bvh"
        shutil.copy(walk(), path)
        for command in KINDS:
            with self.subTest(command):
                self.assertTrue(self.json(command, path)["clip"]["path"].endswith("walk\ufffd.bvh"))


if __name__ == "__main__":
    unittest.main()
