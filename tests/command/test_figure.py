# SPDX-License-Identifier: BSD-3-Clause
"""Figures: well-formed, the same bytes every time, and drawn from the result."""

import functools
import math
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ET

from common import (WALKER, CommandTest, bursts, circle, crowd, drift, run, two_motions, walk,
                    walk_below_a_joint, write_csv)

SVG = "{http://www.w3.org/2000/svg}"

_folder = tempfile.TemporaryDirectory(prefix="stltsa-figures-")


@functools.cache
def synthetic(*settings):
    """A synthetic walk."""
    path = pathlib.Path(_folder.name) / ("walk" + "".join(settings) + ".bvh")
    subprocess.run([WALKER, "--output", path, *settings], check=True)
    return path


def many_cycles():
    return synthetic("--cycles", "45", "--fps", "30", "--noise", "1")


def path_points(path):
    """The points through which a path goes."""
    pieces = re.findall(r"[MLC][^MLC]*", path.get("d"))
    return [tuple(map(float, piece[1:].split()[-2:])) for piece in pieces]


def box_of(text, size=9.5):
    """The box of a text anchored at its middle, no wider than any viewer draws it."""
    x, y, width = float(text.get("x")), float(text.get("y")), 0.5 * size * len(text.text)
    return x - width / 2, y - 0.7 * size, x + width / 2, y


def crosses(box, a, b):
    """Whether the line from a to b crosses the box."""
    steps = 1 + int(max(abs(a[0] - b[0]), abs(a[1] - b[1])))
    for i in range(steps + 1):
        x, y = (p + i / steps * (q - p) for p, q in zip(a, b))
        if box[0] < x < box[2] and box[1] < y < box[3]:
            return True
    return False


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
        below = float(frame.get("y")) + float(frame.get("height")) + 15
        ticks = [t for t in self.of_class(root, "tick") if abs(float(t.get("y")) - below) < 0.02]
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
        self.assertEqual(frames, sorted(set(frames)))
        for frame in frames:
            self.assertIn(str(frame), self.texts(root))

    def test_joints_above_the_body_are_left_out(self):
        drawn = [[ET.tostring(posture) for posture in self.of_class(self.figure("decompose", clip), "posture")]
                 for clip in (walk(), walk_below_a_joint())]
        self.assertGreater(len(drawn[0]), 4)
        self.assertEqual(*drawn)

    def test_postures_differ(self):
        """A body that stands for most of the time is shown while it moves."""
        clip = synthetic("--stand", "8", "--cycles", "3")
        cyclic = next(u for u in self.json("decompose", clip)["units"] if u["kind"] == "cyclic")
        frames = [
            int(posture.get("data-frame"))
            for posture in self.of_class(self.figure("decompose", clip), "posture")
        ]
        inside = [f for f in frames if cyclic["begin"] <= f < cyclic["end"]]
        evenly = len(frames) * (cyclic["end"] - cyclic["begin"])
        evenly /= self.json("info", clip)["clip"]["frames"]
        self.assertGreaterEqual(len(inside), evenly + 2)

    def test_heads(self):
        root = self.figure("decompose", walk())
        heads = self.of_class(root, "head")
        self.assertEqual(len(heads), len(self.of_class(root, "posture")))
        self.assertEqual(len({head.get("r") for head in heads}), 1)

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
        self.assertIn("A · 4 repetitions", self.texts(root))
        self.assertEqual(self.of_class(self.figure("decompose", walk()), "segment"), [])

    def test_no_cycle_tells_why(self):
        reason = self.json("decompose", drift(), "--fps", "30")["reason"]
        told = " ".join(self.texts(self.figure("decompose", drift(), "--fps", "30")))
        self.assertIn(reason, told)

    def test_name_is_escaped(self):
        path = self.folder / 'a<b>&"c".bvh'
        shutil.copy(walk(), path)
        self.assertIn(path.name, self.texts(self.figure("decompose", path)))

    def test_hostile_names(self):
        """Markup is text, and control characters are neither in the figure nor on the terminal."""
        names = (
            "<script>alert(1)</script>",
            "\"'&quot; onload='x'",
            "]]><!--",
            "a\x1b[31mred\x07\x7f",
            "\u009b31m\uffff",
            "line\nbreak\ttab",
        )
        for name in names:
            clip = self.folder / (name.replace("/", "|") + ".bvh")
            shutil.copy(walk(), clip)
            path = self.folder / "hostile.svg"
            result = run("decompose", clip, "--plot", path)
            self.assertEqual(result.returncode, 0, result.stderr)
            control = "[\x00-\x08\x0b-\x1f\x7f-\x9f]"
            self.assertNotRegex(path.read_text(), control + "|[\ufffe\uffff]", name)
            self.assertNotRegex(result.stdout.decode(), control, name)
            self.assertNotIn("line\n", result.stdout.decode())
            root = ET.fromstring(path.read_bytes())
            self.assertEqual({e.tag for e in root.iter()} & {SVG + "script"}, set())
            self.assertFalse([key for e in root.iter() for key in e.keys() if key[:2] == "on"])
            title = root.find(SVG + "title").text
            self.assertEqual(
                title, re.sub("[\x00-\x1f\x7f-\x9f\ufffe\uffff]", "\ufffd", clip.name), name
            )
            errors = run("decompose", clip, "--period-max", "0.001").stderr.decode()
            self.assertNotRegex(errors, control, name)
            clip.write_text("no motion")
            errors = run("decompose", clip).stderr.decode()
            self.assertNotRegex(errors, control, name)

    def test_of_few_cycles_none_stands_out(self):
        for count in (1, 2, 3):
            root = self.figure("decompose", synthetic("--cycles", str(count)))
            self.assertEqual(len(self.of_class(root, "cycle")), count)
            wide = [curve for curve in self.of_class(root, "representative") if curve.get("d")]
            filled = [bar for bar in self.of_class(root, "cycle") if bar.get("fill") != "#ffffff"]
            self.assertEqual((len(wide), len(filled)), (int(count > 2),) * 2)

    def test_loop_is_smooth_with_start_and_direction(self):
        root = self.figure("decompose", walk())
        curves = self.of_class(root, "loop")
        self.assertTrue(all("C" in curve.get("d") for curve in curves))
        (start,) = self.of_class(root, "start")
        at = float(start.get("x")) + 3, float(start.get("y")) + 3
        for a, b in zip(at, path_points(curves[0])[0]):
            self.assertAlmostEqual(a, b, delta=0.02)
        # The arrowheads point in the direction of the representative cycle.
        (cycle,) = self.of_class(root, "representative")
        points = path_points(cycle)
        arrows = self.of_class(root, "direction")
        self.assertEqual(len(arrows), 3)
        for arrow in arrows:
            x, y, turn = map(float, re.findall(r"-?[\d.]+", arrow.get("transform")))
            i = min(
                range(len(points) - 1),
                key=lambda i: sum(abs(a + b - 2 * c) for a, b, c in zip(*points[i : i + 2], (x, y))),
            )
            (ax, ay), (bx, by) = points[i : i + 2]
            angle = math.degrees(math.atan2(by - ay, bx - ax))
            self.assertLess(abs((turn - angle + 180) % 360 - 180), 40)

    def test_the_start_of_a_loop_is_named_where_there_is_room(self):
        self.assertIn("start", self.texts(self.figure("decompose", circle(), "--fps", "30")))

    def test_labels_do_not_lie_on_lines(self):
        for clip in (walk(), synthetic("--cycles", "12"), many_cycles()):
            root = self.figure("decompose", clip)
            curves = [path_points(curve) for curve in self.of_class(root, "loop")]
            numbers = self.of_class(root, "number") + self.of_class(root, "start-text")
            self.assertTrue(numbers)
            for number in numbers:
                box = box_of(number)
                for curve in curves:
                    hits = [p for p in zip(curve, curve[1:]) if crosses(box, *p)]
                    self.assertFalse(hits, number.text)
            lines = [
                tuple((float(e.get(f"x{i}")), float(e.get(f"y{i}"))) for i in "12")
                for name in ("margin", "tie")
                for e in self.of_class(root, name)
            ]
            self.assertTrue(lines)
            for number in self.of_class(root, "posture-number"):
                self.assertFalse([l for l in lines if crosses(box_of(number), *l)], number.text)

    def test_names_of_parameters_are_not_in_titles(self):
        for text in self.texts(self.figure("decompose", walk())):
            self.assertNotRegex(text, r"\b(k|w|mode|gamma|cyclicity|lag quality)\b")

    def test_no_entry_of_the_key_is_repeated(self):
        for arguments in ((walk(),), (bursts(), "--fps", "30"), (drift(), "--fps", "30")):
            root = self.figure("decompose", *arguments)
            elements = list(root.iter())
            names = []
            for mark in self.of_class(root, "key"):
                after = elements[elements.index(mark) + 1 :]
                names.append(next(e.text for e in after if e.tag == SVG + "text"))
            self.assertTrue(names)
            self.assertEqual(len(names), len(set(names)), names)

    def test_many_cycles(self):
        found = self.json("decompose", many_cycles())
        self.assertGreater(len(found["cycles"]), 40)
        root = self.figure("decompose", many_cycles())
        thin, wide = (float(self.of_class(figure, "curve")[1].get("stroke-width"))
                      for figure in (root, self.figure("decompose", walk())))
        self.assertLess(thin, wide / 2)
        self.assertEqual(self.of_class(root, "cycle"), [])
        self.assertEqual(self.of_class(root, "margin"), [])

    def test_long_curves_keep_what_can_be_seen(self):
        """Many samples in a third of a unit of x: their lowest and highest points are drawn."""
        rows = [[math.sin(i / 4), math.cos(i / 4), math.sin(i / 4 + 1)] for i in range(30000)]
        path = write_csv("fast.csv", rows, "a,b,c\n")
        root = self.figure("decompose", path, "--fps", "30")
        drawn = [p for curve in self.of_class(root, "curve") for p in path_points(curve)]
        self.assertLess(len(drawn), 2 * 3 * 652 + 20)
        heights = [y for _, y in drawn]
        middle = (min(heights) + max(heights)) / 2
        most = 0.4 * (max(heights) - min(heights))
        for begin in range(100, 600):
            unit = [y for x, y in drawn if begin <= x < begin + 1]  # nearly two cycles
            self.assertLess(min(unit), middle - most)
            self.assertGreater(max(unit), middle + most)

    def test_cycles_are_overlaid(self):
        """On 0 to 100 %, with the mean of what is drawn; the band is there if they differ."""
        for clip, fewest in ((walk(), 3), (synthetic("--cycles", "1"), 1), (many_cycles(), 41)):
            cycles = self.json("decompose", clip)["cycles"]
            self.assertGreaterEqual(len(cycles), fewest)
            root = self.figure("decompose", clip)
            each = [path_points(line) for line in self.of_class(root, "overlaid")]
            (mean,) = map(path_points, self.of_class(root, "mean"))
            self.assertEqual(len(each), len(cycles))
            frame = self.of_class(root, "frame")[-1]
            left, width = float(frame.get("x")), float(frame.get("width"))
            self.assertAlmostEqual(mean[0][0], left, delta=0.02)
            self.assertAlmostEqual(mean[-1][0], left + width, delta=0.02)
            middle = [[y for x, y in line if abs(x - left - width / 2) < 0.5][0] for line in each]
            at = [y for x, y in mean if abs(x - left - width / 2) < 0.5][0]
            self.assertAlmostEqual(at, sum(middle) / len(middle), delta=0.02)
            self.assertEqual(len(self.of_class(root, "deviation")), int(len(cycles) > 1))

    def test_the_mean_of_the_cycle_times_is_told(self):
        found = self.json("decompose", walk())["cycles"]
        mean = sum(cycle["end_s"] - cycle["begin_s"] for cycle in found) / len(found)
        self.assertIn(f"3 cycles of {mean:.3f} s, standard deviation 0.000 s",
                      self.texts(self.figure("decompose", walk())))

    def test_cycles_beyond_a_gap_are_not_overlaid(self):
        def row(i):
            at = 2 * math.pi * i / 66
            return [math.sin(at) + 0.2 * math.sin(2 * at), math.cos(at), math.sin(at + 1)]

        rows = [row(i) for i in range(1650)]
        other = [[rows[-1][0], rows[-1][1] + 1.5 * math.sin(math.pi * k / 24),
                  rows[-1][2] + math.sin(2 * math.pi * k / 24)] for k in range(24)]
        line = ("decompose", write_csv("gap.csv", rows + other + rows, "a,b,c\n"), "--fps", "60")
        found = self.json(*line)
        cycles = found["cycles"]
        gaps = [i for i in range(1, len(cycles)) if cycles[i]["begin"] > cycles[i - 1]["end"]]
        self.assertEqual((len(found["segments"]), len(gaps)), (1, 1))
        before = found["representative_cycle"]["begin"] < cycles[gaps[0]]["begin"]
        run = gaps[0] if before else len(cycles) - gaps[0]
        self.assertEqual(len(self.of_class(self.figure(*line), "overlaid")), run)

    def test_long_loops_go_one_way(self):
        """The angle around the middle of the loop grows by one turn per cycle."""
        found = self.json("decompose", many_cycles(), "--curve")
        loop = found["curve"]["loop"]
        cycles = found["cycles"]
        first, last = cycles[0]["begin"], cycles[-1]["end"]
        step = found["curve"]["frames"][1] - found["curve"]["frames"][0]
        points = [p for f, p in zip(found["curve"]["frames"], loop) if first <= f < last]
        middle = [sum(p[i] for p in points) / len(points) for i in (0, 1)]
        angles = [math.atan2(p[1] - middle[1], p[0] - middle[0]) for p in points]
        turned = sum(
            (b - a + math.pi) % (2 * math.pi) - math.pi for a, b in zip(angles, angles[1:])
        )
        self.assertGreater(step, 0)
        self.assertAlmostEqual(abs(turned) / (2 * math.pi), len(cycles), delta=1.5)

    def test_each_cyclic_segment_has_its_own_loop(self):
        found = self.json("decompose", two_motions(), "--fps", "30")
        first, second = found["segments"]
        self.assertEqual((first["kind"], second["kind"]), ("cyclic", "cyclic"))
        told = self.done("decompose", two_motions(), "--fps", "30").decode()
        self.assertIn(f"{len(found['cycles'])} cycles of 2 motions\n", told)
        chosen = found["cycles"][found["representative_cycle"]["index"]]
        kept = found["segments"][chosen["segment"]]
        root = self.figure("decompose", two_motions(), "--fps", "30")
        numbers = [int(number.text) for number in self.of_class(root, "number")]
        self.assertGreater(len(numbers), 3)
        self.assertTrue(all(kept["begin"] <= number < kept["end"] for number in numbers), numbers)
        begin, end = kept["begin_s"], kept["end_s"]
        told = f"The loop of {kept['label']}, {begin:.1f} to {end:.1f} s; every cyclic segment"
        self.assertIn(told, " ".join(text for text in self.texts(root) if text))

    def test_neither_of_two_cycles_is_the_best(self):
        self.assertNotIn("best", self.done("decompose", synthetic("--cycles", "2")).decode())
        self.assertIn("best", self.done("decompose", walk()).decode())

    def test_no_curve_where_nothing_was_fitted(self):
        root = self.figure("decompose", many_cycles())  # it stands before and after
        self.assertEqual(len(self.of_class(root, "no-curve")), 2)
        # It moves all the time; the curve ends with a whole 24th of a turn.
        moving = self.figure("decompose", circle(), "--fps", "30")
        width = float(moving.get("viewBox").split()[2])
        for line in self.of_class(moving, "no-curve"):
            self.assertLess(float(line.get("x2")) - float(line.get("x1")), width / 3 / 24)

    def test_loop_numbers_do_not_overlap(self):
        self.apart(self.of_class(self.figure("decompose", crowd(), "--fps", "50"), "number"))
        numbers = self.of_class(self.figure("decompose", walk()), "number")
        self.assertGreater(len(numbers), 4)
        self.apart(numbers)

    def apart(self, numbers):
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
