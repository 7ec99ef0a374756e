# SPDX-License-Identifier: BSD-3-Clause
"""stltsa live: a clip as a stream."""

import json
import math
import unittest

import jsonschema
import numpy

from common import SCHEMAS, CommandTest, cut, noisy_circle, run, walk

SCHEMA = jsonschema.Draft202012Validator(
    json.loads((SCHEMAS / "stltsa-live-1.schema.json").read_text()))


class Live(CommandTest):
    def model(self, *marks):
        path = self.folder / "walk.stltsa"
        line = [word for mark in marks for word in ("--mark", mark)]
        self.done("fit", walk(), "-o", path, *line)
        return path

    def lines(self, *arguments):
        text = self.done("live", *arguments, "--json").decode()
        lines = [json.loads(line) for line in text.splitlines()]
        for line in lines:
            SCHEMA.validate(line)
        return lines

    def test_phases_are_those_of_the_whole_clip(self):
        lines = self.lines(self.model(), walk())
        self.done("decompose", walk(), "--phase", self.folder / "phase.npy")
        offline = numpy.load(self.folder / "phase.npy")[:, 4]
        self.assertEqual([line["frame"] for line in lines], list(range(len(offline))))
        off = (numpy.array([line["phase"] for line in lines]) - offline + 0.5) % 1 - 0.5
        inside = ~numpy.isnan(offline)
        self.assertLess(numpy.median(abs(off[inside])), 0.005)
        self.assertTrue(all(line["known"] for line, cycle in zip(lines, inside) if cycle))
        kinds = [line["segment_kind"] for line in lines]
        self.assertEqual((kinds[60], kinds[400], kinds[-1]), ("rest", "cyclic", "rest"))
        rates = [line["rate_hz"] for line, cycle in zip(lines, inside) if cycle]
        self.assertAlmostEqual(numpy.median(rates), 120 / 132, delta=0.03)
        turns = lines[550]["cycles"] - lines[286]["cycles"]
        self.assertAlmostEqual(turns, 2, delta=0.02)

    def test_the_schema_is_closed(self):
        line = self.lines(self.model(), f"{walk()}:0-1")[0]
        self.assertFalse(SCHEMA.is_valid({**line, "unknown": 1}))
        self.assertFalse(SCHEMA.is_valid({key: line[key] for key in list(line)[1:]}))

    def test_marks_pass_once_a_cycle(self):
        model = self.model("250=strike", "2.4s=off")
        lines = self.lines(model, walk())
        for name, frame in (("strike", 250), ("off", 288)):
            passed = [line["frame"] for line in lines if name in line["events"]]
            for cycle in range(3):
                self.assertIn(1, [sum(abs(p - (frame + 132 * cycle)) <= 3 for p in passed)])
        table = self.done("live", model, walk()).decode().splitlines()
        self.assertEqual(len(table), len(lines) + 1)
        self.assertEqual(sum("strike" in line for line in table),
                         sum("strike" in line["events"] for line in lines))

    def test_no_line_depends_on_later_frames(self):
        model = self.model()
        whole = self.lines(model, walk())
        self.assertEqual(self.lines(model, f"{walk()}:0-1"), whole[:1])
        self.assertEqual(self.lines(model, f"{walk()}:0-180"), whole[:180])

    def test_no_line_of_points_depends_on_later_frames(self):
        points = self.folder / "points.csv"
        names = [f"p{p}_{axis}" for p in range(6) for axis in "xyz"]
        rows = [",".join(names)]
        for i in range(300):
            swing = [(math.sin(0.2 * i + p) + p % 2 + 0.02 * i, p + 0.3 * math.cos(0.2 * i + p),
                      math.sin(0.4 * i + p) + p % 3) for p in range(6)]
            cells = [f"{value:.6f}" for point in swing for value in point]
            if i % 7 == 0:
                cells[3 * (i % 6)] = ""
            rows.append(",".join(cells))
        points.write_text("\n".join(rows) + "\n")
        model = self.folder / "points.stltsa"
        self.done("fit", points, "--fps", "30", "-o", model)
        whole = self.lines(model, points, "--fps", "30")
        self.assertGreater(sum(line["known"] for line in whole[30:]), 260)
        points.write_text("\n".join(rows[:101]) + "\n")
        self.assertEqual(self.lines(model, points, "--fps", "30"), whole[:100])

    def test_a_model_of_columns_that_all_drift(self):
        path, model = self.folder / "drift.csv", self.folder / "drift.stltsa"
        rows = [[math.sin(2 * math.pi * 0.8 * i / 50 + c) + (c + 1) * i / 50 for c in range(4)]
                for i in range(1200)]
        path.write_text("\n".join(",".join(f"{v:.6f}" for v in row) for row in rows) + "\n")
        table = " ".join(self.done("fit", path, "--fps", "50", "-o", model).decode().split())
        self.assertIn("no mean cycle for stltsa live: ", table)
        self.assertIn("all columns only drift", table)
        quiet = run("fit", path, "--fps", "50", "-o", model, "--json")
        self.assertIn(b"no mean cycle for stltsa live: ", quiet.stderr)
        self.assertIn("no mean cycle", self.fails(4, "live", model, path, "--fps", "50"))
        self.assertIn("only drift", self.fails(4, "fit", path, "--fps", "50", "-o", model,
                                               "--mark", "600=a"))

    def test_a_model_whose_phases_are_linear(self):
        model = self.folder / "noisy.stltsa"
        warnings = self.json("fit", noisy_circle(), "-o", model)["warnings"]
        self.assertIn("linear in time", " ".join(warnings))
        streamed = run("live", model, noisy_circle(), "--json")
        self.assertEqual(streamed.returncode, 0)
        self.assertIn(b"linear in time", streamed.stderr)

    def test_a_model_without_cycles(self):
        path = self.folder / "cut.stltsa"
        self.done("fit", f"{walk()}:150-240", "-o", path)
        self.assertIn("no mean cycle", self.fails(4, "live", path, walk()))
        self.assertIn("no cycles", self.fails(4, "fit", f"{walk()}:150-240", "-o", path, "--mark",
                                              "5=a"))
        self.assertIn("-o", self.fails(2, "fit", walk(), "--mark", "250=a"))
        self.fails(2, "fit", walk(), "-o", path, "--mark", "2=a")
        self.assertIn("a skeleton", self.fails(1, "live", self.model(), cut(), "--fps", "30"))


if __name__ == "__main__":
    unittest.main()
