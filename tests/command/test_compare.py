# SPDX-License-Identifier: BSD-3-Clause
"""stltsa compare: two motions, or left and right, aligned by phase."""

import csv
import io
import math
import unittest

from common import CommandTest, circle, still, walk, write_csv


def swings(name, late=0.0, gain=1.0, period=1.0, rate=100):
    """Columns that swing once per period; the amplitude differs from cycle to cycle."""
    rows = []
    for i in range(10 * rate):
        turns = i / rate / period
        own = 1 + 0.05 * math.sin(12.9898 * (math.floor(turns) + 1))
        at = 2 * math.pi * turns
        rows.append([math.sin(at) * own, gain * own * math.cos(at),
                     2 * math.sin(at - 2 * math.pi * late) * own, math.cos(at + 1) * own])
    return write_csv(name, rows, "hip,knee,ankle,toe\n")


class Compare(CommandTest):
    def test_json_csv_and_table_agree(self):
        line = ("compare", swings("first.csv"), swings("second.csv", 0.03, 1.5, 1.2, 60))
        line += ("--fps", "100")
        found = self.json(*line)
        parts = {part["first"]: part for part in found["parts"]}
        aligned = found["alignment"]
        self.assertLess(aligned["low"], aligned["shift"])
        self.assertLess(aligned["shift"], aligned["high"])
        self.assertEqual(list(parts), ["hip", "knee", "ankle", "toe"])
        knee = parts["knee"]["differences"]
        self.assertAlmostEqual(knee["amplitude_ratio"]["value"], 1.5, delta=0.05)
        self.assertTrue(knee["amplitude"]["significant"])
        # Relative to the whole body, of which the ankle is the largest part.
        late = parts["ankle"]["differences"]["lag"]["difference"]
        self.assertGreater(late - parts["hip"]["differences"]["lag"]["difference"], 0.025)
        self.assertLess(late - parts["hip"]["differences"]["lag"]["difference"], 0.035)
        channel = parts["ankle"]["channels"][0]
        curves = [channel["first"]["mean"], channel["second"]["mean"],
                  channel["difference"]["mean"]]
        self.assertEqual({len(curve) for curve in curves}, {101})
        for first, second, difference in zip(*curves):
            self.assertEqual(difference, second - first)

        self.done(*line, "-o", self.folder / "parts.csv")
        rows = list(csv.DictReader(io.StringIO((self.folder / "parts.csv").read_text())))
        self.assertEqual([row["level"] for row in rows], ["part", "channel"] * 4)
        row = next(row for row in rows if row["part"] == "knee")
        self.assertEqual(float(row["ratio"]), knee["amplitude_ratio"]["value"])
        self.assertEqual(float(row["lag_low"]), knee["lag"]["low"])
        self.assertEqual(row["amplitude_significant"], "1")
        table = self.done(*line).decode()
        self.assertIn("8 cycles of A", table)
        knees = next(line for line in table.splitlines() if line.strip().startswith("knee"))
        self.assertIn(f"{100 * (knee['amplitude_ratio']['value'] - 1):+.1f} *", knees)

    def test_halves_of_one_walk_are_alike(self):
        found = self.json("compare", f"{walk()}:-400", f"{walk()}:200-")
        self.assertEqual(found["kind"], "two_motions")
        self.assertGreater(found["alignment"]["likeness"], 0.99)
        self.assertLess(abs(found["alignment"]["shift"]), 0.02)
        self.assertEqual(found["first"]["path"], str(walk()))
        names = [part["first"] for part in found["parts"]]
        self.assertIn("LeftFoot", names)
        self.assertEqual([c["axis"] for c in found["parts"][0]["channels"]], ["x", "y", "z"])

    def test_no_difference_is_positive_zero(self):
        table = self.done("compare", walk(), walk()).decode()
        self.assertIn("+0.0", table)
        self.assertNotRegex(table, r"-0\.0*(?![\d])")

    def test_one_clip_is_left_against_right(self):
        found = self.json("compare", walk())
        self.assertEqual(found["kind"], "left_right")
        self.assertEqual(found["alignment"]["shift"], 0.5)
        self.assertIsNone(found["alignment"]["standard_error"])
        for part in found["parts"]:
            self.assertEqual(part["first"].replace("Left", "Right"), part["second"])
            self.assertLess(part["differences"]["rms_difference"], 0.1)
        self.assertIn("left and right", self.done("compare", walk()).decode())
        cycles = len(self.json("decompose", walk())["cycles"])
        self.assertEqual([found[side]["cycles"] for side in ("first", "second")], 2 * [cycles])
        self.assertEqual(found["warnings"], [])

    def test_what_cannot_be_compared(self):
        self.assertIn("no cycles to compare", self.fails(4, "compare", walk(), f"{walk()}:0-100"))
        self.assertIn("different features", self.fails(4, "compare", walk(), circle(), "--fps", "30"))
        self.assertIn("may not mirror the first", self.fails(4, "compare", circle(), "--fps", "30"))
        others = write_csv("others.csv", [[math.sin(i / 8), math.cos(i / 8)] for i in range(400)], "u,v\n")
        self.assertIn("no joint, point or column of the same name",
                      self.fails(4, "compare", others, swings("named.csv"), "--fps", "60"))
        self.fails(4, "compare", still(), "--fps", "30")
        self.assertIn(f"frame rate of {circle()} is unknown", self.fails(2, "compare", walk(), circle()))
        self.assertIn("takes one or two clips", self.fails(2, "compare", walk(), walk(), walk()))
        self.assertIn("no option '--plot'", self.fails(2, "compare", walk(), walk(), "--plot", "x.svg"))
        self.fails(2, "compare")
        self.fails(2, "compare", walk(), walk(), "-o", self.folder / "parts.png")

    def test_nothing_is_judged_by_single_cycles(self):
        found = self.json("compare", walk(), walk(), "--period-max", "3")
        self.assertGreater(found["judged"], 0)
        one = swings("one.csv")
        first = one.read_text().splitlines()
        short = self.folder / "short.csv"
        short.write_text("\n".join(first[:170]) + "\n")
        found = self.json("compare", short, short, "--fps", "100")
        self.assertEqual((found["first"]["cycles"], found["judged"], found["significant"]), (1, 0, 0))

    def test_names_do_not_break_the_table(self):
        odd = self.folder / "new\nline.csv"
        rows = [[math.sin(i / 8), math.cos(i / 8)] for i in range(400)]
        name = 10 * "\u00e9" + 2000 * "x" + "end"
        text = f"{name},other\n" + "".join(f"{a},{b}\n" for a, b in rows)
        odd.write_text(text, encoding="utf-8")
        table = self.done("compare", odd, odd, "--fps", "60").decode()
        self.assertIn("new\ufffdline.csv:", table)
        self.assertIn(10 * "\u00e9" + "xxxxx...", table)
        self.assertLess(max(map(len, table.splitlines())), 140)
        self.assertIn(name, self.done("compare", odd, odd, "--fps", "60", "--json").decode())
        both = self.done("compare", "-", "-", input=walk().read_bytes()).decode()
        self.assertEqual(both.count("standard input:"), 2)

    def test_the_same_bits_again(self):
        line = ("compare", walk(), f"{walk()}:200-", "--json")
        self.assertEqual(self.done(*line), self.done(*line))


if __name__ == "__main__":
    unittest.main()
