# SPDX-License-Identifier: BSD-3-Clause
"""TRC, MOT and STO files, and the time of text files."""

import math
import unittest

from common import CommandTest

NAMES = ("knee_angle_r", "knee_angle_l", "hip_flexion_r")
POINTS = ("hip", "knee", "toe")


def angles(time):
    """A period of 1.1 s."""
    turn = 2 * math.pi * time / 1.1
    return [30 + 20 * math.sin(turn), 30 - 20 * math.sin(turn), 10 * math.cos(turn)]


def mot(times, written="{:.3f}"):
    head = (f"Coordinates\nversion=1\nnRows={len(times)}\nnColumns=4\ninDegrees=yes\nendheader\n"
            "time\t" + "\t".join(NAMES) + "\n")  # fmt: skip
    return head + "".join(
        "\t".join([written.format(t), *(f"{x:.5f}" for x in angles(t))]) + "\n" for t in times
    )


def trc(times, rate):
    head = ("PathFileType\t4\t(X/Y/Z)\tx.trc\nDataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\n"
            f"{rate}\t{rate}\t{len(times)}\t3\tmm\nFrame#\tTime\t" + "\t\t\t".join(POINTS) +
            "\n\t\tX1\tY1\tZ1\tX2\tY2\tZ2\tX3\tY3\tZ3\n\n")  # fmt: skip
    rows = []
    for i, t in enumerate(times, 1):
        swing = [math.sin(2 * math.pi * t / 1.1 + k) for k in range(3)]
        cells = [f"{x:.4f}" for k in range(3) for x in (100 * swing[k], 900 - 400 * k, 50 * k)]
        rows.append("\t".join([str(i), f"{t:.5f}", *cells]))
    return head + "\n".join(rows) + "\n"


class OpenSim(CommandTest):
    def put(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def notes(self, found):
        return "\n".join(found["clip"]["notes"])

    def test_coordinates(self):
        for name in ("walk.mot", "walk.STO"):
            path = self.put(name, mot([i / 60 for i in range(330)]))
            found = self.json("decompose", path)
            self.assertEqual(found["clip"]["format"], "mot")
            self.assertEqual((found["clip"]["fps"], found["clip"]["duration_s"]), (60, 5.5))
            self.assertAlmostEqual(found["period_s"], 1.1, delta=0.002)
            self.assertIn("angles are in degrees", self.notes(found))
            self.assertEqual(self.json("info", path)["channels"]["names"], list(NAMES))
            self.assertRegex(self.done("decompose", path).decode(), "knee_angle_[rl]")

    def test_variable_steps(self):
        times = [0.0]
        while times[-1] < 12:
            times.append(times[-1] + 0.012 * (1 + 0.9 * math.sin(2 * math.pi * times[-1] / 12)))
        found = self.json("decompose", self.put("walk.sto", mot(times, "{!r}")))
        self.assertAlmostEqual(found["clip"]["duration_s"], 12, delta=0.1)
        self.assertIn("resampled to", self.notes(found))
        for cycle in found["cycles"]:
            self.assertAlmostEqual(cycle["end_s"] - cycle["begin_s"], 1.1, delta=0.03)
        self.assertGreater(len(found["cycles"]), 8)

    def test_time_goes_back(self):
        times = [i / 60 for i in range(100)] + [i / 60 for i in range(50)]
        said = self.fails(3, "info", self.put("walk.mot", mot(times)))
        self.assertIn("walk.mot:108: column 'time' is time, but does not increase", said)
        self.assertIn("--fps", said)

    def test_markers(self):
        found = self.json("decompose", self.put("walk.trc", trc([i / 30 for i in range(198)], 100)))
        self.assertEqual((found["clip"]["format"], found["clip"]["fps"]), ("trc", 30))
        self.assertAlmostEqual(found["period_s"], 1.1, delta=0.01)
        self.assertEqual(found["samples"]["up_axis"], "y")
        self.assertIn("say 100 frames a second, but the times 30", self.notes(found))
        self.assertIn("up axis: y", self.notes(found))
        shown = self.json("info", self.folder / "walk.trc")
        self.assertEqual(shown["channels"]["names"][:3], ["hip_x", "hip_y", "hip_z"])

    def test_lost_rows_of_markers(self):
        times = [i / 100 for i in range(600) if not 200 <= i < 250]
        found = self.json("info", self.put("walk.trc", trc(times, 100)))
        self.assertEqual((found["clip"]["frames"], found["clip"]["duration_s"]), (600, 6))
        self.assertIn("50 of 600 frames have no value", self.notes(found))

    def test_fps(self):
        path = self.put("walk.mot", mot([i / 60 for i in range(120)]))
        found = self.json("info", path, "--fps", "30")
        self.assertEqual(found["clip"]["fps"], 30)
        self.assertIn("30 frames a second instead of the file's 60", self.notes(found))


if __name__ == "__main__":
    unittest.main()
