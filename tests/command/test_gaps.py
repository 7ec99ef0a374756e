# SPDX-License-Identifier: BSD-3-Clause
"""Recordings in which points are missing, or the whole body is."""

import csv
import math
import unittest

from common import CommandTest

POINTS = 12


def body(t):
    """Points of a body that walks at one stride a second."""
    places = []
    for p in range(POINTS):
        side, level = 2 * (p % 2) - 1, p // 2
        ahead = 1.3 * t + 0.1 * (level - 3) * side * math.sin(2 * math.pi * t)
        places.append((ahead, 0.15 * side + 0.02 * level,
                       0.1 + 0.3 * level + 0.02 * math.cos(4 * math.pi * t)))
    return places


class Presence(CommandTest):
    def recording(self, seconds, is_seen, fps=100):
        """A file; is_seen(t, point) says whether a value is there."""
        path = self.folder / "recording.csv"
        with path.open("w", newline="") as file:
            table = csv.writer(file)
            table.writerow(["time", *(f"m{p}_{axis}" for p in range(POINTS) for axis in "xyz")])
            for i in range(round(seconds * fps)):
                t = i / fps
                cells = [f"{v:.5f}" if is_seen(t, p) else "" for p, place in enumerate(body(t))
                         for v in place]
                table.writerow([f"{t:.3f}", *cells])
        return path

    def check_covered(self, found):
        frames = found["clip"]["frames"]
        for level in ("segments", "units"):
            ends = [0, *(each["end"] for each in found[level])]
            self.assertEqual([each["begin"] for each in found[level]], ends[:-1])
            self.assertEqual(ends[-1], frames)

    def test_cycles_beside_a_hole_are_as_long_as_others(self):
        """What lies in a hole is no posture of rest, in which cycles begin and end."""
        for tenths in range(20, 31):
            begin = tenths / 10
            path = self.recording(6, lambda t, p: not begin <= t < begin + 0.4)
            cycles = self.json("decompose", path)["cycles"]
            self.assertGreater(len(cycles), 1)
            for cycle in cycles:
                self.assertAlmostEqual(cycle["end_s"] - cycle["begin_s"], 1, delta=0.05, msg=(begin, cycle))

    def test_a_body_that_comes_late_and_leaves_early(self):
        path = self.recording(8.4, lambda t, p: 3.2 <= t < 6.9)
        found = self.json("decompose", path)
        self.check_covered(found)
        before, walk, after = found["segments"]
        self.assertEqual([before["kind"], walk["kind"], after["kind"]], ["rest", "cyclic", "rest"])
        self.assertEqual((walk["begin"], walk["end"]), (320, 690))
        self.assertTrue(walk["open_end"])
        self.assertAlmostEqual(walk["period_s"], 1, delta=0.01)
        self.assertEqual(walk["count"], 3)
        for absent in (before, after):
            self.assertEqual(absent["reason"], "nothing recorded")
            self.assertIsNone(absent["label"])
        self.assertEqual([s["begin_confidence"] for s in found["segments"]], [None, 1, 1])
        self.assertEqual({cycle["segment"] for cycle in found["cycles"]}, {1})
        self.assertEqual([u["segment"] for u in found["units"]][::len(found["units"]) - 1], [0, 2])
        # Everything is as in the stretch alone.
        alone = self.json("decompose", f"{path}:320-690")
        self.assertEqual(len(alone["cycles"]), len(found["cycles"]))
        for one, other in zip(found["cycles"], alone["cycles"]):
            self.assertAlmostEqual(one["begin_s"], other["begin_s"] + 3.2, places=9)
            self.assertAlmostEqual(one["end_s"], other["end_s"] + 3.2, places=9)
        table = self.done("decompose", path).decode()
        self.assertEqual(table.count("nothing recorded"), 4)  # segments and units
        self.assertNotIn("T-pose", table)
        phases = self.folder / "phase.csv"
        self.done("decompose", path, "--phase", phases)
        rows = list(csv.DictReader(phases.open()))
        self.assertEqual(len(rows), 840)
        self.assertEqual({row["phase"] for row in rows[:320] + rows[690:]}, {""})
        self.assertNotEqual(rows[500]["phase"], "")

    def test_a_mouse_that_crosses_the_picture(self):
        # It is seen in 40 % of the file; one point is misread all the time.
        path = self.recording(10, lambda t, p: p == 0 or 5 <= t < 9)
        found = self.json("decompose", path)
        self.check_covered(found)
        self.assertEqual([s["kind"] for s in found["segments"]], ["rest", "cyclic", "rest"])
        self.assertEqual([s["begin"] for s in found["segments"]], [0, 500, 900])
        self.assertAlmostEqual(found["period_s"], 1, delta=0.01)
        self.assertFalse(any("left out" in note for note in found["clip"]["notes"]))

    def test_a_body_that_is_gone_for_a_while(self):
        found = self.json("decompose", self.recording(12, lambda t, p: not 5.21 <= t < 7.4))
        self.check_covered(found)
        absent = [s for s in found["segments"] if s["reason"] == "nothing recorded"]
        self.assertEqual([(s["kind"], s["begin"], s["end"]) for s in absent], [("rest", 521, 740)])
        self.assertEqual([s["label"] for s in found["segments"]], ["A", None, "A"])
        for cycle in found["cycles"]:
            self.assertTrue(cycle["end"] <= 521 or cycle["begin"] >= 740)

    def test_markers_that_flicker(self):
        found = self.json("decompose", self.recording(10, lambda t, p: (round(100 * t) // 9 + p) % 4))
        self.assertEqual([s["kind"] for s in found["segments"]], ["cyclic"])
        self.assertAlmostEqual(found["period_s"], 1, delta=0.01)

    def test_nothing_at_all(self):
        message = self.fails(3, "decompose", self.recording(3, lambda t, p: False))
        self.assertIn("all", message)


if __name__ == "__main__":
    unittest.main()
