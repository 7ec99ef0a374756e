# SPDX-License-Identifier: BSD-3-Clause
"""Figures: well-formed, the same bytes every time, and drawn from the result."""

import shutil
import unittest
import xml.etree.ElementTree as ET

from common import CommandTest, bursts, circle, crowd, drift, walk

SVG = "{http://www.w3.org/2000/svg}"


class Figure(CommandTest):
    def figure(self, command, *arguments, name="figure.svg"):
        path = self.folder / name
        self.done(command, *arguments, "--plot", path)
        return ET.fromstring(path.read_bytes())

    def of_class(self, root, name):
        return [e for e in root.iter() if e.get("class") == name]

    def texts(self, root):
        return [e.text for e in root.iter(SVG + "text")]

    def test_same_bytes(self):
        one, two = self.folder / "1.svg", self.folder / "2.svg"
        self.done("decompose", walk(), "--threads", "1", "--plot", one)
        self.done("decompose", walk(), "--threads", "2", "--plot", two)
        self.assertEqual(one.read_bytes(), two.read_bytes())

    def test_bars_and_axis_are_the_times(self):
        found = self.json("decompose", walk())
        root = self.figure("decompose", walk())
        frame = next(e for e in root.iter(SVG + "rect") if e.get("class") == "frame")
        left, width = float(frame.get("x")), float(frame.get("width"))

        def place(frames):
            return left + width * frames / found["clip"]["frames"]

        for name, intervals, inset in (
            ("unit", found["units"], 0.02),
            ("band", found["units"], 0.02),
            ("cycle", found["cycles"], 1.02),
        ):
            bars = self.of_class(root, name)
            self.assertEqual(len(bars), len(intervals))
            for bar, interval in zip(bars, intervals):
                x, bar_width = float(bar.get("x")), float(bar.get("width"))
                self.assertAlmostEqual(x, place(interval["begin"]), delta=inset)
                self.assertAlmostEqual(x + bar_width, place(interval["end"]), delta=inset)
        ticks = self.of_class(root, "tick")
        self.assertGreater(len(ticks), 4)
        for tick in ticks:
            self.assertAlmostEqual(float(tick.get("x")), place(120 * float(tick.text)), delta=0.02)
        for kind in {unit["kind"] for unit in found["units"]}:
            self.assertIn(kind, self.texts(root))

    def test_postures(self):
        root = self.figure("decompose", walk())
        postures = self.of_class(root, "posture")
        frames = [int(posture.get("data-frame")) for posture in postures]
        self.assertTrue(5 <= len(frames) <= 14, frames)
        slot = self.json("info", walk())["clip"]["frames"] / len(frames)
        for i, frame in enumerate(frames):
            self.assertLess(abs(frame - (i + 0.5) * slot), 0.4 * slot)
        for frame in frames:
            self.assertIn(str(frame), self.texts(root))

    def test_bare_numbers_have_no_postures(self):
        root = self.figure("decompose", circle(), "--fps", "30")
        self.assertEqual(self.of_class(root, "posture"), [])
        self.assertTrue(self.of_class(root, "unit"))

    def test_segments_have_a_band(self):
        """One bar for each segment, none if only one moves."""
        found = self.json("decompose", bursts(), "--fps", "30")["segments"]
        root = self.figure("decompose", bursts(), "--fps", "30")
        bars = self.of_class(root, "segment")
        self.assertEqual(len(bars), len(found))
        widths = [float(bar.get("width")) for bar in bars]
        lengths = [segment["end"] - segment["begin"] for segment in found]
        for width, length in zip(widths, lengths):
            self.assertAlmostEqual(width / sum(widths), length / sum(lengths), delta=0.01)
        self.assertIn("A 4x", self.texts(root))
        self.assertEqual(self.of_class(self.figure("decompose", walk()), "segment"), [])

    def test_no_cycle_tells_why(self):
        reason = self.json("decompose", drift(), "--fps", "30")["reason"]
        reason = reason.replace("option features", "--features")
        told = " ".join(self.texts(self.figure("decompose", drift(), "--fps", "30")))
        self.assertIn(reason, told)

    def test_name_is_escaped(self):
        path = self.folder / 'a<b>&"c".bvh'
        shutil.copy(walk(), path)
        self.assertIn(path.name, self.texts(self.figure("decompose", path)))

    def test_seams(self):
        """One strip per kind of cut, with its postures across the seam, in order."""
        pieces = (f"{walk()}:best*4", f"{walk()}:120-500")
        made = self.folder / "made.bvh"
        options = ("--posture-limit", "0")
        seams = self.json("synthesize", *pieces, "-o", made, *options)["seams"]
        self.assertEqual(len(seams), 4)
        root = self.figure("synthesize", *pieces, "-o", made, *options)
        self.assertEqual(len(self.of_class(root, "seam")), 2)  # three are similar
        self.assertEqual(len(self.of_class(root, "crossfade")), 2)
        frames = [int(p.get("data-frame")) for p in self.of_class(root, "posture")]
        self.assertEqual(len(frames), 26)
        for seam, shown in zip((seams[0], seams[3]), (frames[:13], frames[13:])):
            self.assertEqual(shown[6], seam["frame"])
            steps = {b - a for a, b in zip(shown, shown[1:])}
            self.assertEqual(len(steps), 1)
            self.assertAlmostEqual(steps.pop() / 120, 0.1, delta=0.01)
        told = " ".join(self.texts(root))
        self.assertIn(f"seam at frame {seams[3]['frame']}", told)
        self.assertIn("walk120.bvh:120-500", told)
        self.assertNotIn(str(self.folder), told)

    def test_no_seam(self):
        made = self.folder / "made.bvh"
        root = self.figure("synthesize", f"{walk()}:100-620", "-o", made)
        self.assertEqual(self.of_class(root, "seam"), [])
        self.assertEqual(len(self.of_class(root, "posture")), 13)

    def test_fit(self):
        for options in (("--dimension", "1"), ("--dimension", "3")):
            root = self.figure("fit", walk(), *options)
            self.assertTrue(list(root.iter(SVG + "polyline")))
            self.assertEqual(self.of_class(root, "unit"), [])
        self.figure("fit", circle())

    def test_loop_numbers_do_not_overlap(self):
        root = self.figure("decompose", crowd(), "--fps", "50")
        numbers = self.of_class(root, "number")
        self.assertGreater(len(numbers), 2)
        boxes = [
            (float(n.get("x")), float(n.get("y")), 0.55 * 9.5 * len(n.text)) for n in numbers
        ]
        for i, (x, y, width) in enumerate(boxes):
            for other_x, other_y, other_width in boxes[:i]:
                apart = abs(x - other_x) >= (width + other_width) / 2 or abs(y - other_y) >= 7
                self.assertTrue(apart, (boxes[i], (other_x, other_y)))

    def test_numbers_stand_out(self):
        """Each is written twice at the same place, first wider and in white."""
        root = self.figure("decompose", walk())
        texts = list(root.iter(SVG + "text"))
        for name in ("number", "posture-number"):
            numbers = self.of_class(root, name)
            self.assertGreater(len(numbers), 5)
            for number in numbers:
                halo = texts[texts.index(number) - 1]
                self.assertEqual((halo.get("class"), halo.get("stroke")), ("halo", "#ffffff"))
                for key in ("x", "y", "font-size", "text-anchor"):
                    self.assertEqual(halo.get(key), number.get(key))
                self.assertEqual(halo.text, number.text)


if __name__ == "__main__":
    unittest.main()
