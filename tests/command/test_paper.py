# SPDX-License-Identifier: BSD-3-Clause
"""The paper's rule for cycles, word for word, beside the cycles of decompose (docs/method.md, section 6)."""

import json
import subprocess
import unittest

import numpy

from common import WALKER, CommandTest

WALKS = {  # cycles, seconds per cycle, factor on the angles, and more
    "slow": (5, 1.4, 0.8),
    "usual": (6, 1.1, 1),
    "with long steps": (6, 1.1, 1.2),
    "along an arc": (6, 1.1, 1, "--turn", 20),
    "that speeds up": (8, 1.1, 1, "--ramp", 0.2),
    "in full walk": (6, 1, 1, "--stand", 0),
    "as fast as a run": (8, 0.7, 1.2),
}


def margins(curve):
    """Section 3.1: "With the first order difference being close to 0, we can find the valley and peak
    in the manifold curve. Between each pair of peak and valley, a point where the second order
    difference is closest to 0 will be picked out as a candidate of the margin of a cycle." Of several
    such points it is the steepest, and it may lie between two samples."""
    first = numpy.diff(curve)  # first[t]: from sample t to t + 1
    second = numpy.diff(first)  # second[t]: at sample t + 1
    turns = [t + 1 for t in range(len(second)) if first[t] * first[t + 1] <= 0]
    found = []
    for turn, next_turn in zip(turns, turns[1:]):
        steepest = turn + int(numpy.argmax(abs(first[turn:next_turn])))
        before, after = second[steepest - 1], second[steepest]
        found.append(steepest + before / (before - after))
    return numpy.array(found)


class Paper(CommandTest):
    def test_every_second_margin_is_a_border(self):
        for name, (cycles, period, stride, *more) in WALKS.items():
            with self.subTest("a walk " + name):
                path = self.folder / "walk.bvh"
                options = ["--cycles", cycles, "--period", period, "--stride", stride, *more]
                subprocess.run([WALKER, "--output", path, *map(str, options)], check=True)
                found = self.json("decompose", path, "--curve")
                (segment,) = [s for s in found["segments"] if s["kind"] == "cyclic"]
                self.assertEqual(segment["count"], cycles)
                curve = numpy.array(found["curve"]["values"])
                seconds = numpy.array(found["curve"]["frames"]) / found["clip"]["fps"]
                (known,) = numpy.nonzero(curve)
                of_paper = numpy.interp(margins(curve[known]), range(len(known)), seconds[known])
                borders = [c["begin_s"] for c in found["cycles"]] + [found["cycles"][-1]["end_s"]]
                first = int(numpy.argmin(abs(of_paper - borders[0])))
                of_cycles = of_paper[first::2][:len(borders)]  # "the first and third candidates"
                self.assertEqual(len(of_cycles), len(borders))
                apart = abs(of_cycles - borders) / found["period_s"]
                self.assertLess(apart.max(), 0.02)


if __name__ == "__main__":
    unittest.main()
