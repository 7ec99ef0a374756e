# SPDX-License-Identifier: BSD-3-Clause
"""decompose --phase: the phase of each frame as a table."""

import csv
import unittest

import numpy

from common import CommandTest, noisy_circle, walk


class Phase(CommandTest):
    def test_csv_and_npy_hold_the_same(self):
        found = self.json("decompose", walk(), "--phase", self.folder / "phase.csv")
        self.done("decompose", walk(), "--phase", self.folder / "phase.npy")
        table = numpy.load(self.folder / "phase.npy")
        with open(self.folder / "phase.csv", encoding="ascii") as file:
            rows = list(csv.reader(file))
        self.assertEqual(rows[0], ["frame", "seconds", "segment", "cycle", "phase", "residual"])
        read = [[float(cell or "nan") for cell in row] for row in rows[1:]]
        numpy.testing.assert_array_equal(read, table)
        self.assertEqual(table.shape, (found["clip"]["frames"], 6))
        numpy.testing.assert_array_equal(table[:, 0], numpy.arange(len(table)))
        numpy.testing.assert_allclose(table[:, 1], table[:, 0] / found["clip"]["fps"])
        cycle = numpy.full(len(table), numpy.nan)
        for index, part in enumerate(found["cycles"]):
            cycle[part["begin"]:part["end"]] = index
        numpy.testing.assert_array_equal(table[:, 3], cycle)
        numpy.testing.assert_array_equal(numpy.isnan(table[:, 4]), numpy.isnan(cycle))
        inside = table[~numpy.isnan(cycle), 4]
        self.assertTrue((inside >= 0).all() and (inside < 1).all())
        self.assertTrue((numpy.diff(inside) % 1 > 0).all())

    def test_json_has_the_warnings_of_the_phase(self):
        found = self.json("decompose", walk(), "--phase", self.folder / "phase.npy")
        self.assertEqual(found["phase_warnings"], [])
        self.assertNotIn("phase_warnings", self.json("decompose", walk()))
        noisy = self.json("decompose", noisy_circle(), "--phase", self.folder / "phase.npy")
        self.assertGreater(len(noisy["cycles"]), 20)
        (warning,) = noisy["phase_warnings"]
        self.assertIn("is linear in time, because its mean cycle leaves 0.7", warning)

    def test_sides_of_a_symmetric_walk_differ_by_nothing(self):
        found = self.json("decompose", walk(), "--phase", self.folder / "phase.npy")
        self.assertNotIn("sides", self.json("decompose", walk()))
        (sides,) = found["sides"]
        self.assertEqual((sides["label"], sides["reason"]), ("A", None))
        pairs = {(pair["left"], pair["axis"]): pair for pair in sides["pairs"]}
        foot = pairs["LeftFoot", "z"]
        self.assertEqual(foot["right"], "RightFoot")
        self.assertGreater(foot["left_range"], 50)
        self.assertAlmostEqual(foot["range_difference"],
                               foot["left_range"] - foot["right_range"], delta=1e-9)
        self.assertEqual(len(foot["difference"]), 101)
        for pair in pairs.values():
            self.assertLess(pair["rms_difference"], 0.1)
            self.assertLess(abs(pair["mean_difference"]), 0.1)
        text = self.done("decompose", walk(), "--phase", self.folder / "phase.npy").decode()
        self.assertIn("left - right", text)
        self.assertNotIn("left - right", self.done("decompose", walk()).decode())

    def test_without_sides_there_is_a_reason(self):
        found = self.json("decompose", noisy_circle(), "--phase", self.folder / "phase.npy")
        (sides,) = found["sides"]
        self.assertEqual(sides["pairs"], [])
        self.assertIn("second half of a cycle of motion A may not mirror the first", sides["reason"])

    def test_sides_that_cannot_move_alike_have_a_reason(self):
        hierarchy, motion = walk().read_text().split("Frame Time")
        before, after = hierarchy.split("JOINT RightUpLeg")
        after = after.replace("CHANNELS 3 Zrotation Xrotation Yrotation", "CHANNELS 1 Xrotation", 1)
        head, *rows = motion.strip().splitlines()
        rows = [row.split() for row in rows]
        rows = [" ".join(row[:45] + row[46:47] + row[48:]) for row in rows]
        clip = self.folder / "hinge.bvh"
        clip.write_text("\n".join([f"{before}JOINT RightUpLeg{after}Frame Time{head}", *rows]) + "\n")
        found = self.json("decompose", clip, "--phase", self.folder / "phase.npy",
                          "--report", self.folder / "page.html")
        self.assertEqual(len(found["cycles"]), 3)
        (sides,) = found["sides"]
        self.assertEqual(sides["pairs"], [])
        self.assertIn("joint 'RightUpLeg' cannot move as its other side 'LeftUpLeg' does, because "
                      "their channels or axes differ (rx; rz rx ry)", sides["reason"])
        self.assertIn("cannot move as its other side", (self.folder / "page.html").read_text())
        self.assertIn("cannot move as its other side", self.fails(4, "compare", clip))

    def test_a_clip_without_cycles_has_no_phase(self):
        self.done("decompose", f"{walk()}:0-25", "--phase", self.folder / "none.npy")
        self.assertTrue(numpy.isnan(numpy.load(self.folder / "none.npy")[:, 3:]).all())

    def test_another_suffix_is_refused(self):
        self.fails(2, "decompose", walk(), "--phase", self.folder / "phase.txt")


if __name__ == "__main__":
    unittest.main()
