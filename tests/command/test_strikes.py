# SPDX-License-Identifier: BSD-3-Clause
"""Cycles and steps begin and end at the foot strikes that a file states."""

import functools
import json
import random
import re
import subprocess
import unittest

import jsonschema
from c3d_file import c3d
from common import CLIPS, SCHEMAS, WALKER, CommandTest
from layouts import FPS, JOINTS, walk_points

PERIOD, CYCLES = 1.1, 8
LANDED = 0.294  # of a cycle before the legs pass each other, see tests/walker/README.md


@functools.cache
def long_walk():
    """Rows of points, and the times of the strikes of both feet."""
    path = CLIPS / "long_walk.bvh"
    subprocess.run([WALKER, "-o", path, "--fps", str(FPS), "--cycles", str(CYCLES), "--period",
                    str(PERIOD), "--borders", path.with_suffix(".json")], check=True)  # fmt: skip
    first = json.loads(path.with_suffix(".json").read_text())["cycles"][0]["begin_s"]
    rows = [[float(x) for point in row for x in point] for row in walk_points(path)]
    left = [first + (k - LANDED) * PERIOD for k in range(CYCLES + 1)]
    right = [first + (k + 0.5 - LANDED) * PERIOD for k in range(CYCLES + 1)]
    return rows, left, right


def strikes(left=(), right=(), label="Foot Strike"):
    return [(t, label, "Left") for t in left] + [(t, label, "Right") for t in right]


class Strikes(CommandTest):
    def found(self, events, stretch="", names=JOINTS):
        parameters = {}
        if events:
            minutes = [x for time, _, _ in events for x in (0.0, time)]
            parameters = {"EVENT": {"LABELS": [e[1] for e in events], "TIMES": minutes,
                                    "CONTEXTS": [e[2] for e in events]}}  # fmt: skip
        path = self.folder / "walk.c3d"
        path.write_bytes(c3d(long_walk()[0], names, FPS, parameters=parameters))
        found = self.json("decompose", f"{path}{stretch}")
        schema = SCHEMAS / "stltsa-decomposition-2.schema.json"
        jsonschema.validate(found, json.loads(schema.read_text()))
        return found

    def notes(self, found):
        return [note for note in found["clip"]["notes"] if "strike" in note]

    def assert_at(self, times, expected, frames=1.0):
        for time in times:
            nearest = min(expected, key=lambda t: abs(t - time))
            self.assertLessEqual(abs(time - nearest) * FPS, frames)

    def assert_steps(self, found, left, right, frames=1.0):
        """Each step ends at the strike of its own foot, and begins at that of the other."""
        self.assertEqual(len(found["steps"]), 2 * len(found["cycles"]))
        for step in found["steps"]:
            begins, ends = (right, left) if step["side_name"] == "left" else (left, right)
            self.assert_at([step["begin_s"]], begins, frames)
            self.assert_at([step["end_s"]], ends, frames)

    def assert_unchanged(self, found):
        """The answer is that without events."""
        plain = self.found([])
        for answer in (found, plain):
            for key in ("notes", "events"):
                answer["clip"].pop(key, None)
        self.assertEqual(found, plain)

    def test_cycles_begin_at_strikes(self):
        _, left, right = long_walk()
        found = self.found(strikes(left, right))
        cycles = found["cycles"]
        self.assertGreaterEqual(len(cycles), CYCLES - 1)
        self.assertEqual({cycle["side_name"] for cycle in cycles}, {"left"})
        self.assert_at([t for c in cycles for t in (c["begin_s"], c["end_s"])], left, 0.01)
        self.assert_steps(found, left, right, 0.01)
        self.assertAlmostEqual(found["segments"][1]["first_step_share"], 0.5, 3)
        (unit,) = (unit for unit in found["units"] if unit["kind"] == "cyclic")
        self.assertEqual((unit["begin"], unit["end"]), (cycles[0]["begin"], cycles[-1]["end"]))
        (note,) = self.notes(found)
        self.assertEqual(note, "0 % of each cycle is at a left foot strike, as the events of the file say "
                               "(9 left, 9 right)")  # fmt: skip

    def test_steps_have_the_stated_times(self):
        _, left, right = long_walk()
        late = [t + 0.04 for t in right]
        found = self.found(strikes(left, late))
        self.assert_steps(found, left, late, 0.01)
        share = found["segments"][1]["first_step_share"]
        self.assertAlmostEqual(share, 0.5 + 0.04 / PERIOD, 3)

    def test_one_mark_of_each_foot(self):
        _, left, right = long_walk()
        found = self.found(strikes(left[3:4], right[5:6]))
        self.assertGreaterEqual(len(found["cycles"]), CYCLES - 1)
        self.assert_at([cycle["begin_s"] for cycle in found["cycles"]], left + right)
        self.assert_steps(found, left, right)
        self.assertIn("(1 left, 1 right); in cycles without such an event, where the motion is the same",
                      self.notes(found)[0])  # fmt: skip

    def test_one_foot(self):
        _, left, right = long_walk()
        found = self.found(strikes(right=right[2:5]))
        self.assertEqual({cycle["side_name"] for cycle in found["cycles"]}, {"right"})
        self.assert_at([cycle["begin_s"] for cycle in found["cycles"]], right)
        self.assert_steps(found, left, right, 2)
        self.assertIn("is at a right foot strike", self.notes(found)[0])

    def test_a_foot_without_a_side(self):
        _, left, right = long_walk()
        found = self.found([(t, "FS", "General") for t in left])
        self.assertEqual(len({cycle["side"] for cycle in found["cycles"]}), 1)
        self.assert_at([cycle["begin_s"] for cycle in found["cycles"]], left, 0.01)
        self.assert_at([step["end_s"] for step in found["steps"]], left + right, 2)

    def test_feet_without_a_side(self):
        _, left, right = long_walk()
        late = [t + 0.04 for t in right]
        found = self.found([(t, "FS", "General") for t in left + late])
        begins = [cycle["begin_s"] for cycle in found["cycles"]]
        self.assertGreaterEqual(len(begins), CYCLES - 1)
        self.assert_at(begins, left if abs(begins[0] - left[0]) < 0.1 else late, 0.01)
        self.assert_at([step["end_s"] for step in found["steps"]], left + late, 0.01)
        self.assertRegex(self.notes(found)[0], "is at a foot strike, .*of no stated side, .*of no stated")

    def test_feet_of_a_body_without_sides(self):
        _, left, right = long_walk()
        events = [(t, "FS", "General") for t in left + right]
        found = self.found(events, names=[f"m{i}" for i in range(len(JOINTS))])
        self.assertGreaterEqual(len(found["cycles"]), CYCLES - 1)
        self.assert_at([cycle["begin_s"] for cycle in found["cycles"]], left + right, 0.01)
        self.assertEqual({(cycle["side"], cycle["side_name"]) for cycle in found["cycles"]}, {(None, None)})
        self.assertEqual(found["steps"], [])

    def test_the_side_of_the_present_borders_comes_first(self):
        _, first, second = long_walk()
        swap = {"Left": "Right", "Right": "Left"}
        other_names = [re.sub("Left|Right", lambda side: swap[side[0]], name) for name in JOINTS]
        for names, left, right in ((JOINTS, first, second), (other_names, second, first)):
            plain = self.found([], names=names)["cycles"][0]["side_name"]
            for some in (strikes(left, right), strikes(left[2:4], right[2:7])):
                self.assertEqual(self.found(some, names=names)["cycles"][0]["side_name"], plain)
            one, many = (left[2:3], right) if plain == "left" else (left, right[2:3])
            other = self.found(strikes(one, many), names=names)["cycles"][0]["side_name"]
            self.assertNotEqual(other, plain)

    def test_marks_of_two_systems_are_one_strike(self):
        _, left, right = long_walk()
        twice = [t + by for t in left for by in (-0.02, 0.02)]
        found = self.found(strikes(twice, right))
        self.assert_at([cycle["begin_s"] for cycle in found["cycles"]], left, 0.01)
        self.assertIn("(9 left", self.notes(found)[0])

    def test_a_mark_at_another_place_is_said(self):
        _, left, right = long_walk()
        wrong = [*left[:4], left[4] + 0.15 * PERIOD, *left[5:]]
        found = self.found(strikes(wrong, right))
        self.assert_at([cycle["begin_s"] for cycle in found["cycles"]], left)
        self.assertIn("not used: 1 left; the other 8 are at another place", self.notes(found)[0])

    def test_strikes_that_contradict_the_cycles(self):
        _, left, right = long_walk()
        noise = random.Random(3)
        spread = [t + noise.uniform(-0.3, 0.3) * PERIOD for t in left]
        found = self.found(strikes(spread))
        (note,) = self.notes(found)
        self.assertRegex(note, r"not used: [89] left; they contradict the cycles, in which they scatter by \d+ %")
        self.assert_unchanged(found)
        good = self.found(strikes(spread, right))
        self.assertEqual({cycle["side_name"] for cycle in good["cycles"]}, {"right"})
        self.assert_at([cycle["begin_s"] for cycle in good["cycles"]], right, 0.01)

    def test_other_events_change_nothing(self):
        _, left, right = long_walk()
        found = self.found([(left[2] + 0.6, "Foot Off", "Left"), (2.0, "Event", "General"),
                            *strikes(right=right, label="Toe Off")])  # fmt: skip
        self.assertEqual(self.notes(found), [])
        self.assertEqual(found["clip"]["notes"], self.found([])["clip"]["notes"])
        self.assert_unchanged(found)

    def test_strikes_outside_the_cycles(self):
        found = self.found(strikes([0.1]))
        self.assertEqual(self.notes(found), ["foot strikes of the file that are not used: all 1; "
                                             "none lies in a cycle"])  # fmt: skip
        self.assert_unchanged(found)

    def test_a_stretch(self):
        _, left, right = long_walk()
        found = self.found(strikes(left, right), ":3s-9s")
        self.assert_at([cycle["begin_s"] + 3 for cycle in found["cycles"]], left + right, 0.01)
        self.assertGreaterEqual(len(found["cycles"]), 4)

    def test_the_phase_is_0_at_strikes(self):
        _, left, right = long_walk()
        self.found(strikes(left, right))
        self.done("decompose", self.folder / "walk.c3d", "--phase", self.folder / "phase.csv")
        head, *lines = (self.folder / "phase.csv").read_text().splitlines()
        column = head.split(",").index("phase")
        for time in left[1:-1]:
            phase = float(lines[round(time * FPS)].split(",")[column])
            self.assertLess(min(phase, 1 - phase), 0.02)


if __name__ == "__main__":
    unittest.main()
