# SPDX-License-Identifier: BSD-3-Clause
"""The report: one HTML page with the data of the JSON, safe from hostile names, the same bytes every time."""

import base64
import csv
import json
import math
import re
import shlex
import shutil
import subprocess
import unittest
import zlib

from common import WALKER, CommandTest, circle, run, walk, walk_below_a_joint

HOSTILE = "</script><!--<script>\u2028'\"&\\"


def unpacked(of):
    """Rows of the numbers that src/report/packed.hpp describes."""
    planes, count = zlib.decompress(base64.b64decode(of["data"])), of["rows"] * of["cols"]
    assert len(planes) == 2 * count
    columns = []
    for c in range(of["cols"]):
        above, column = 0, []
        for at in range(c * of["rows"], (c + 1) * of["rows"]):
            above = (above + planes[at] + 256 * planes[count + at]) % 65536
            i = c % len(of["low"])
            column.append(math.nan if above == 65535 else of["low"][i] + of["unit"][i] * above)
        columns.append(column)
    return [list(row) for row in zip(*columns)]


class Pages(CommandTest):
    def data(self, page):
        (text,) = re.findall(r'<script type="application/json" id="data">\n(.*?)\n?</script>', page, re.S)
        return json.loads(text)


class Page(Pages):
    def page(self, *arguments):
        path = self.folder / "page.html"
        self.done("decompose", *arguments, "--report", path)
        return path.read_text(encoding="utf-8")

    def test_same_bytes_and_no_date(self):
        one, two = self.folder / "1.html", self.folder / "2.html"
        for threads, path in (("1", one), ("2", two)):
            self.done("decompose", walk(), "--threads", threads, "--report", path)
        texts = [path.read_text(encoding="utf-8") for path in (one, two)]
        datas = [self.data(text) for text in texts]
        commands = [data.pop("command") for data in datas]
        self.assertNotEqual(*commands)
        self.assertEqual(*datas)
        self.assertNotRegex(texts[0], r"20\d\d-\d\d-\d\d|\d\d:\d\d:\d\d")

    def test_decomposition_is_the_json(self):
        data = self.data(self.page(walk()))
        self.assertEqual(data["format"], "stltsa-report/1")
        self.assertEqual(data["decomposition"], self.json("decompose", walk()))
        self.assertTrue(data["command"].startswith("stltsa decompose "), data["command"])

    def test_positions_phase_and_mean_cycle(self):
        data = self.data(self.page(walk()))
        body, found = data["body"], data["decomposition"]
        self.assertEqual((body["kind"], body["step"], body["space"]), ("skeleton", 1, 3))
        places = unpacked(body["places"])
        self.assertEqual(len(places), found["clip"]["frames"])
        # The length of every bone is constant.
        for child, part in enumerate(body["parts"]):
            if part["parent"] < 0:
                continue
            lengths = [math.dist(row[3 * child : 3 * child + 3], row[3 * part["parent"] : 3 * part["parent"] + 3])
                       for row in places[::20]]
            self.assertLess(max(lengths) - min(lengths), 0.1)
        self.done("decompose", walk(), "--phase", self.folder / "phase.csv")
        with open(self.folder / "phase.csv", newline="", encoding="ascii") as file:
            phases = [row["phase"] for row in csv.DictReader(file)]
        values = data["phase"]["values"]
        for row, text in zip(unpacked(values), phases, strict=True):
            self.assertEqual(math.isnan(row[0]), text == "")
            if text:  # rounded to the nearest integer
                self.assertAlmostEqual(row[0], float(text), delta=0.51 * values["unit"][0])
        (motion,) = data["motions"]
        self.assertEqual({s["name"] for s in motion["sets"]}, {"position", "angle"})
        for signals in motion["sets"]:
            mean, single = unpacked(signals["mean"]), unpacked(signals["each"])
            self.assertEqual((len(mean), len(single)), (101, 51 * len(signals["shown"])))
            spread = 65534 * max(signals["mean"]["unit"])
            for r in range(51):  # the cycles of the walker are equal
                for c, value in enumerate(mean[2 * r]):
                    self.assertAlmostEqual(single[r][c], value, delta=0.05 * spread + 1e-6)
        self.assertGreater(len(motion["sides"]["pairs"]), 0)

    def test_of_a_very_long_clip_every_second_row(self):
        clip, rows = self.folder / "long.csv", 200_001
        clip.write_text("a,b\n" + "".join(
            f"{math.cos(i / 30):.2f},{math.sin(i / 30) + 0.3 * math.sin(i / 15):.2f}\n" for i in range(rows)))
        phase = self.data(self.page(clip, "--fps", "100", "--phase", self.folder / "phase.csv"))["phase"]
        self.assertEqual(phase["step"], 2)
        with open(self.folder / "phase.csv", newline="", encoding="ascii") as file:
            table = list(csv.DictReader(file))
        kept = unpacked(phase["values"])
        self.assertEqual((len(table), len(kept)), (rows, (rows + 1) // 2))
        self.assertGreater(sum(not math.isnan(row[1]) for row in kept), 99_000)
        for r in range(0, len(kept), 500):
            for value, unit, name in zip(kept[r], phase["values"]["unit"], ("phase", "residual")):
                text = table[2 * r][name]
                self.assertEqual(math.isnan(value), text == "", r)
                if text:
                    self.assertAlmostEqual(value, float(text), delta=0.51 * unit)

    def test_joints_above_the_body_have_no_places(self):
        here, below = (self.data(self.page(clip))["body"] for clip in (walk(), walk_below_a_joint()))
        self.assertEqual([part["name"] for part in below["parts"][1:]], [part["name"] for part in here["parts"]])
        for row, moved in zip(unpacked(here["places"])[::50], unpacked(below["places"])[::50], strict=True):
            self.assertTrue(all(map(math.isnan, moved[:3])))
            self.assertLess(math.dist(row, moved[3:]), 0.1)

    def test_sides_residuals_and_chosen_cycles_are_those_of_the_json(self):
        clip = self.folder / "long.bvh"
        subprocess.run([WALKER, "-o", clip, "--cycles", "30", "--fps", "30", "--noise", "1"], check=True,
                       stdout=subprocess.DEVNULL)
        found = self.json("decompose", clip, "--phase", self.folder / "phase.csv")
        data = self.data(self.page(clip))
        (motion,), (sides,) = data["motions"], found["sides"]
        pairs = {(pair["left"], pair["axis"]): pair for pair in sides["pairs"]}
        curves = [list(zip(*unpacked(motion["sides"][name]))) for name in ("left_curves", "right_curves")]
        for pair, left, right in zip(motion["sides"]["pairs"], *curves):
            expected = pairs[pair["left"], pair["axis"]]
            for name in ("left_range", "right_range"):
                self.assertEqual(pair[name], expected[name])
            self.assertEqual((pair["rms"], pair["chance"]),
                             (expected["rms_difference"], expected["rms_by_chance"]))
            for curve, name in ((left, "left_range"), (right, "right_range")):
                self.assertAlmostEqual(max(curve) - min(curve), pair[name], delta=1e-3 + 1e-3 * pair[name])
        with open(self.folder / "phase.csv", newline="", encoding="ascii") as file:
            residuals = [row["residual"] for row in csv.DictReader(file)]
        for row, text in zip(unpacked(data["phase"]["values"]), residuals, strict=True):
            if text:
                self.assertAlmostEqual(row[1], float(text), delta=1e-3)
        count = len(motion["times"])
        self.assertGreater(count, 24)
        self.assertEqual(count, len(found["cycles"]))
        for times, cycle in zip(motion["times"], found["cycles"], strict=True):  # hundredths of a frame
            self.assertAlmostEqual(times[0], 30 * cycle["begin_s"], delta=0.006)
            self.assertAlmostEqual(times[-1], 30 * cycle["end_s"], delta=0.006)
        for signals in motion["sets"]:
            self.assertEqual(signals["shown"], [i * count // 24 for i in range(24)])

    def test_sides_are_partners(self):
        parts = self.data(self.page(walk()))["body"]["parts"]
        paired = [part for part in parts if part["partner"] >= 0]
        self.assertGreater(len(paired), 3)
        for part in paired:
            self.assertEqual(parts[part["partner"]]["side"], 1 - part["side"])

    def events(self, source, frame):
        words = shlex.split(source["name"] + source["flags"]["events"])
        found = self.json("events", *words, "--mark", f"{frame}=here")
        return [event["frame"] for event in found["events"]]

    def test_commands_read_the_clip_as_it_was_read(self):
        """What the page shows as commands: the name, the flags, and the frames of the file."""
        label = f"{walk()}:A"
        data = self.data(self.page(label, "--fps", "90", "--keep-start", "--features", "euler",
                                   "--period-max", "2.5", "--segments", "1", "--threads", "1"))
        source = data["source"]
        self.assertEqual(source["name"], label)
        flags = " --features euler --keep-start --fps 90 --period-max 2.5 --segments 1"
        self.assertEqual(source["flags"]["events"], flags)
        self.events(source, data["decomposition"]["cycles"][0]["begin"] + 10)  # the command takes them
        self.assertEqual(sorted(source["flags"]["decompose"].split(" --")),
                         sorted(flags.split(" --")))
        self.assertEqual(source["flags"]["synthesize"], " --fps 90")
        ((begin, end),) = source["pieces"]
        data = self.data(self.page(label))
        self.assertEqual(data["body"]["places"]["rows"], data["source"]["pieces"][0][1] - data["source"]["pieces"][0][0])
        cycles = data["decomposition"]["cycles"]
        found = self.events(data["source"], cycles[1]["begin"] + 10)
        self.assertIn(cycles[1]["begin"] + 10, found)
        for cycle in cycles:
            self.assertLess(min(abs(frame - cycle["begin"] - 10) for frame in found), 3)
        # Of a stretch of a file, the frames of the file.
        first = unpacked(data["body"]["places"])[0][:3]
        begin = data["source"]["pieces"][0][0]
        there = unpacked(self.data(self.page(f"{walk()}:{begin}-"))["body"]["places"])[0][:3]
        for one, other in zip(first, there):
            self.assertAlmostEqual(one, other, delta=0.02)
        whole = self.data(self.page(walk()))["source"]
        self.assertEqual((whole["name"], whole["pieces"]), (str(walk()), []))
        self.assertEqual(set(whole["flags"].values()), {""})

    def test_hostile_names(self):
        clip = self.folder / ("a " + HOSTILE.replace("/", "") + ".csv")
        names = [HOSTILE + c for c in "abc"]
        with open(clip, "w", newline="", encoding="utf-8") as file:
            rows = csv.writer(file)
            rows.writerow(names)
            for i in range(300):
                rows.writerow([math.sin(i / 8 + k) + 0.2 * math.sin(i / 4 + k) for k in range(3)])
        page = self.page(clip, "--fps", "60")
        clean = self.page(walk())
        # As many elements as in any other report: no name became one.
        for tag in ("<script", "</script", "<!--", "-->"):
            self.assertEqual(page.count(tag), clean.count(tag), tag)
        data = self.data(page)
        self.assertEqual([part["name"] for part in data["body"]["parts"]], names)
        self.assertEqual(data["decomposition"]["clip"]["path"], str(clip))
        self.assertIn("'\\''", data["command"])  # quoted for a shell

    @unittest.skipUnless(shutil.which("node"), "node is not installed")
    def test_cells_of_tables_are_the_commands(self):
        """The rule of summary.csv, whose first column has names of files."""
        (script,) = re.findall(r"const isFormula.*?\nconst csvText[^\n]*\n", self.page(walk()), re.S)
        names = ["a;=1+1", "a\tb", "a\rb", 'a"b', "a,b", "=1+1", "'-1", "plain", "+a;b"]
        call = f"process.stdout.write(csvText({json.dumps(names)}.map(name => [name, -1.5])))"
        shown = subprocess.run(["node", "-e", script + call], stdout=subprocess.PIPE, check=True)
        run("batch", *names, "--out", "out", cwd=self.folder)
        summary = (self.folder / "out" / "summary.csv").read_bytes()
        cells = [line.removesuffix(b",-1.5") for line in shown.stdout.split(b"\n")[:-1]]
        self.assertEqual(len(cells), len(names))
        for cell in cells:
            self.assertIn(b"\n" + cell + b",STLTSA_E_IO,", summary)

    def test_points_and_matrices(self):
        self.assertEqual(self.data(self.page(circle(), "--fps", "30"))["body"]["kind"], "columns")
        clip = self.folder / "points.csv"
        with open(clip, "w", newline="", encoding="ascii") as file:
            rows = csv.writer(file)
            rows.writerow([f"{side}_{part}_{axis}" for side in "lr" for part in ("hip", "foot") for axis in "xyz"])
            for i in range(300):
                places = [(k, 10 - 9 * (k % 2), (k % 2) * math.sin(i / 8 + 3 * (k // 2))) for k in range(4)]
                rows.writerow(["" if k == 1 and 50 <= i < 55 else x for k, place in enumerate(places) for x in place])
        body = self.data(self.page(clip, "--fps", "60"))["body"]
        self.assertEqual((body["kind"], body["space"]), ("points", 3))
        self.assertEqual([part["side"] for part in body["parts"]], [0, 0, 1, 1])
        places = unpacked(body["places"])
        self.assertEqual([math.isnan(x) for x in places[52][:6]], [False] * 3 + [True] * 3)
        self.assertAlmostEqual(places[10][5], math.sin(10 / 8), delta=1e-4)

    def test_a_clip_in_which_nothing_repeats(self):
        data = self.data(self.page(f"{walk()}:0-30"))
        self.assertEqual(data["motions"], [])
        self.assertEqual(data["body"]["places"]["rows"], 30)

    def test_a_single_cycle_is_closed(self):
        clip = self.folder / "one.bvh"
        self.done("synthesize", f"{walk()}:best", "-o", clip)
        (motion,) = self.data(self.page(clip))["motions"]
        whole = self.data(self.page(walk()))["motions"][0]
        for one, all_cycles in zip(motion["sets"], whole["sets"], strict=True):
            for row, expected in zip(unpacked(one["mean"]), unpacked(all_cycles["mean"]), strict=True):
                for value, other, unit in zip(row, expected, all_cycles["mean"]["unit"], strict=True):
                    self.assertAlmostEqual(value, other, delta=0.08 * 65534 * unit + 1e-3)
        self.assertEqual(len(motion["sides"]["pairs"]), len(whole["sides"]["pairs"]))
        found = self.json("compare", clip, walk())
        self.assertEqual(found["first"]["cycles"], 1)
        self.assertGreater(found["alignment"]["likeness"], 0.999)

    def table(self, value):
        clip = self.folder / "table.csv"
        with open(clip, "w", newline="", encoding="ascii") as file:
            rows = csv.writer(file)
            rows.writerow("abcde")
            rows.writerows([value(i, k) for k in range(5)] for i in range(1500))
        return self.data(self.page(clip, "--fps", "100"))

    def test_gaps_are_left_open(self):
        def wave(i, k):  # the second column has a long gap and a short one; the third only its first 501 values
            missing = k == 1 and (300 <= i < 500 or 700 <= i < 710) or k == 2 and i > 500
            return "" if missing else round(math.sin(i / 16 + k), 4)

        (motion,) = self.table(wave)["motions"]
        (signals,) = motion["sets"]
        shown = [motion["times"][k] for k in signals["shown"]]
        each = unpacked(signals["each"])
        for k, times in enumerate(shown):
            for tenth, frame in enumerate(times):
                if frame is None:
                    continue
                row = each[51 * k + 5 * tenth]
                self.assertEqual(math.isnan(row[1]), 299 < frame < 500, frame)
                self.assertEqual([math.isnan(row[c]) for c in (0, 2, 3)], [False, True, False])
        self.assertFalse(any(math.isnan(row[1]) for row in unpacked(signals["mean"])))

    def test_nothing_is_drawn_where_nothing_was_fitted(self):
        data = self.table(lambda i, k: "" if 700 <= i < 900 else round(math.sin(i / 16 + k), 4))
        curve = data["curve"]
        rows = unpacked(curve["values"])
        known = [not math.isnan(row[0]) for row in rows]
        at = [known[(frame - curve["first"]) // curve["step"]] for frame in (300, 800, 1300)]
        self.assertEqual(at, [True, False, True])

    def test_trend_and_accuracy(self):
        clip = self.folder / "noisy.bvh"
        subprocess.run([WALKER, "-o", clip, "--cycles", "10", "--noise", "2"], check=True, stdout=subprocess.DEVNULL)
        data = self.data(self.page(clip))
        cycles = data["decomposition"]["cycles"]
        self.assertEqual(len(cycles), 10)
        middles = [(cycle["begin_s"] + cycle["end_s"]) / 2 for cycle in cycles]
        lengths = [cycle["end_s"] - cycle["begin_s"] for cycle in cycles]
        middle, mean = sum(middles) / 10, sum(lengths) / 10
        spread = sum((x - middle) ** 2 for x in middles)
        slope = sum((x - middle) * y for x, y in zip(middles, lengths)) / spread
        left = sum((y - mean - slope * (x - middle)) ** 2 for x, y in zip(middles, lengths))
        margin = 60 * 2.306004 * math.sqrt(left / 8 / spread) / mean  # of 8 degrees of freedom
        self.assertAlmostEqual(data["motions"][0]["trend_margin"], margin, delta=1e-4 * margin)
        for name in ("residual", "error_estimate"):
            self.assertTrue(0 < data["accuracy"][name] < 1e-9, data["accuracy"])

    def test_long_pages_stay_small(self):
        clip = self.folder / "long.bvh"
        subprocess.run([WALKER, "-o", clip, "--cycles", "60", "--noise", "8"], check=True, stdout=subprocess.DEVNULL)
        page = self.page(clip)
        frames = self.data(page)["decomposition"]["clip"]["frames"]
        self.assertGreater(frames, 5000)
        allowed = 2e6 * max(1, frames * 23 / (5000 * 31))
        self.assertLess(len(page), allowed)

    def test_needs_nothing_else(self):
        page = self.page(walk())
        self.assertIn("default-src 'none'", page)
        self.assertNotRegex(page, r"""(?:src|href)=["']?(?:https?:)?//""")
        code = page.replace(re.search(r'id="data">\n(.*?)</script>', page, re.S)[1], "")
        self.assertLess(len(code.encode()), 150_000)

    def test_suffix(self):
        self.assertIn("must end in", self.fails(2, "decompose", walk(), "--report", self.folder / "x.pdf"))


class ComparisonPage(Pages):
    """The page of a comparison, whose data are those of the JSON."""

    def page(self, *arguments):
        path = self.folder / "comparison.html"
        self.done("compare", *arguments, "--report", path)
        return path.read_text(encoding="utf-8")

    def test_comparison_is_the_json(self):
        line = (walk(), f"{walk()}:200-")
        data = self.data(self.page(*line))
        self.assertEqual(data["format"], "stltsa-comparison-report/1")
        path = self.folder / "comparison.html"
        self.assertEqual(shlex.split(data["command"]), ["stltsa", "compare", *map(str, line), "--report", str(path)])
        found = json.loads(zlib.decompress(base64.b64decode(data["comparison"])))
        self.assertEqual(found, self.json("compare", *line))

    def test_bones_join_the_parts(self):
        for line in ((walk(), f"{walk()}:200-"), (walk(),)):
            data = self.data(self.page(*line))
            found = json.loads(zlib.decompress(base64.b64decode(data["comparison"])))
            names = [part["first"] for part in found["parts"]]
            self.assertEqual(len(data["parents"]), len(names))
            self.assertTrue(data["skeleton"])
            self.assertEqual(data["up"], 1)
            parent = data["parents"][names.index("LeftFoot")]
            self.assertEqual(names[parent], "LeftLeg")
            hip = data["parents"][names.index("LeftUpLeg")]
            self.assertEqual(hip, names.index("Hips") if "Hips" in names else -1)

    def test_a_bone_skips_a_joint_that_the_other_clip_lacks(self):
        other = self.folder / "other.bvh"
        other.write_text(walk().read_text(encoding="ascii").replace("JOINT LeftLeg", "JOINT Knee"), encoding="ascii")
        data = self.data(self.page(walk(), other))
        found = json.loads(zlib.decompress(base64.b64decode(data["comparison"])))
        names = [part["first"] for part in found["parts"]]
        self.assertEqual(found["first"]["left_out"], ["LeftLeg"])
        self.assertEqual(names[data["parents"][names.index("LeftFoot")]], "LeftUpLeg")

    def test_matrices_have_no_places(self):
        data = self.data(self.page(circle(), circle(), "--fps", "30"))
        self.assertNotIn("parents", data)
        self.assertFalse(data["skeleton"])

    def test_needs_nothing_else(self):
        page = self.page(walk())
        self.assertIn("default-src 'none'", page)
        self.assertNotRegex(page, r"""(?:src|href)=["']?(?:https?:)?//""")
        self.assertIn("must end in", self.fails(2, "compare", walk(), "--report", self.folder / "x.pdf"))


if __name__ == "__main__":
    unittest.main()
