# SPDX-License-Identifier: BSD-3-Clause
"""Exit status and messages."""

import math
import unittest

from common import COMMANDS, CommandTest, circle, cut, drift, run, still, walk, write_csv


class Usage(CommandTest):
    def test_wrong_command_lines(self):
        clip = walk()
        for line, hint in (
            ((), "info, fit, map"),
            (("frobnicate",), "frobnicate"),
            (("info",), "clip"),
            (("info", clip, "--bogus"), "--bogus"),
            (("info", clip, clip), f"info takes no further argument '{clip}'"),
            (("info", clip, "--neighbors", "5"), "--neighbors"),
            (("decompose", clip, "--links", "5"), "--links"),
            (("fit", clip, "--neighbors"), "--neighbors"),
            (("fit", clip, "--neighbors", "many"), "1.2s"),
            (("fit", clip, "--neighbors", "0"), "from 1"),
            (("fit", clip, "--smoothing", "auto"), "a number"),
            (("fit", clip, "--neighbors", "1.5"), "1.2s"),
            (("fit", clip, "--neighbors", "-1s"), "1.2s"),
            (("fit", clip, "--neighbors", "0s"), "1.2s"),
            (("fit", clip, "--neighbors", "infs"), "1.2s"),
            (("fit", clip, "--dimension", "2s"), "whole number"),
            (("fit", clip, "--mode", "1"), "temporal|spatial|recurrent"),
            (("fit", clip, "--sample-rate", "nan"), "sample-rate"),
            (("fit", clip, "--sample-rate", "1,5"), "number"),
            (("dimension", clip, "--variance", "2"), "from 0.01 to 1"),
            (("fit", clip, "--coords", "y.txt"), ".npy"),
            (("decompose", clip, "--curve"), "--json"),
            (("decompose", clip, "--plot", "y.png"), ".svg"),
            (("decompose", clip, "--plot", "./y.pdf"), ".svg"),
            (("fit", clip, "--plot", "y.svg"), "--plot"),
            (("decompose", clip, "--json", "-o", "y.csv"), ".json"),
            (("decompose", clip, "--period-min", "3", "--period-max", "1"), "--period-min is 3"),
            (("fit", clip, "--neighbors", "3", "--dimension", "2"), "neighbors"),
        ):
            with self.subTest(line=line):
                self.assertIn(hint, self.fails(2, *line, cwd=self.folder))
        self.assert_empty(self.folder)

    def test_one_end_of_the_range_of_periods_may_be_given(self):
        rows = [[math.sin(2 * math.pi * i / 12), math.cos(2 * math.pi * i / 12)] for i in range(30)]
        short = write_csv("short.csv", rows)
        self.done("fit", short, "--period-min", "20", "--neighbors", "8")
        self.done("fit", short, "--period-min", "20")
        for option, value in (("--period-min", 7), ("--period-max", 0.2)):
            found = self.json("fit", walk(), option, str(value))["parameters"]
            self.assertEqual((found["period_min_s"], found["period_max_s"]), (value, value))
            self.done("decompose", walk(), option, str(value))
        self.fails(2, "fit", short, "--period-min", "20", "--period-max", "19")

    def test_a_misspelled_flag_or_command_has_a_hint(self):
        for arguments, hint in (
            (("fit", walk(), "--neigbors", "36"), "Did you mean --neighbors?"),
            (("fit", walk(), "--neigbors=36"), "Did you mean --neighbors?"),
            (("fit", walk(), "--no-include-slf"), "Did you mean --no-include-self?"),
            (("fit", walk(), "--neigh", "36"), "Did you mean --neighbors?"),
            (("decompse", walk()), "Did you mean decompose?"),
            (("dec", walk()), "Did you mean decompose?"),
            (("--verison",), "Did you mean --version?"),
            (("-v",), "there are -h, --help, --version"),
            (("nosuch.bvh",), "neither a command nor a file"),
            (("-",), "try 'stltsa decompose -'"),
            ((walk().parent,), f"try 'stltsa batch {walk().parent} --out results'"),
            ((f"{walk()}:cyclic",), f"try 'stltsa decompose {walk()}:cyclic'"),
        ):
            with self.subTest(arguments):
                self.assertIn(hint, self.fails(2, *arguments))
        for arguments in (("fit", walk(), "--bogus"), ("frobnicate",), ("fit", walk(), "--foo", "1"), ("fit", walk(), walk())):
            with self.subTest(arguments):
                self.assertNotIn("Did you mean", self.fails(2, *arguments))

    def test_a_file_of_another_kind(self):
        for name, content in (("table.xlsx", b"PK\x03\x04\x00\x01"), ("walk.mp4", b"\x00\x00\x00\x18ftyp"),
                              ("README.md", b"# Clips\n\n1, 2\n1, 2, 3\n")):
            path = self.folder / name
            path.write_bytes(content)
            self.assertIn("known format: .bvh, .amc, .csv, .tsv, .npy", self.fails(3, "info", path))

    def test_rate_is_needed(self):
        self.assertIn("open it with --fps", self.fails(2, "decompose", circle()))
        self.assertIn("--fps", self.fails(2, "fit", circle(), "--neighbors", "1.2s"))

    def test_options_are_called_by_their_flags(self):
        """The library knows options; the user typed flags."""
        clock = write_csv("clock.csv", [[0, 1, 2], [10, 3, 1], [20, 1, 4]], "t,x,y\n")
        text = " ".join(self.done("info", clock).decode().split())
        self.assertIn("set --fps", text)
        self.assertIn("set --features to", " ".join(
            self.done("decompose", drift(), "--fps", "30").decode().split()))
        message = self.fails(2, "fit", clock, "--sample-rate", "-1")
        self.assertTrue(message.startswith("stltsa: --sample-rate is -1; "), message)
        self.assertIn("set --skeleton", self.fails(3, "info", self.amc_without_skeleton()))

    def amc_without_skeleton(self):
        clip = self.folder / "07_01.amc"
        clip.write_text(":FULLY-SPECIFIED\n:DEGREES\n1\nroot 0 0 0 0 0 0\n", encoding="ascii")
        return clip

    def test_help_and_version(self):
        for line in (("--help",), *((command, "--help") for command in COMMANDS)):
            text = self.done(*line).decode()
            self.assertLess(text.index("Examples:"), text.index("Usage:"))
            self.assertLessEqual(max(map(len, text.splitlines())), 80, line)
        self.assertRegex(
            self.done("--version").decode(), r"^stltsa \d+\.\d+\.\d+ \(libstltsa \d+\.\d+\.\d+\)\n$"
        )

    def test_every_command_has_examples_of_itself(self):
        for command in COMMANDS:
            text = self.done(command, "--help").decode()
            examples = text[text.index("Examples:") : text.index("Usage:")].split("\n")[1:]
            examples = [e for e in examples if e]
            self.assertTrue(all(e.startswith("  stltsa ") for e in examples))
            self.assertTrue(examples[-1].startswith(f"  stltsa {command} "))


class Unreadable(CommandTest):
    def test_input(self):
        broken = self.folder / "broken.bvh"
        broken.write_text("HIERARCHY\nROOT hips\n{\n  OFFSET 0 0\n", encoding="ascii")
        short = self.folder / "short.csv"
        short.write_text("1,2,3\n4,5\n", encoding="ascii")
        unfinite = write_csv("inf.csv", [[1, 2], [float("inf"), 4]])
        model = self.folder / "model.stltsa"
        self.done("fit", circle(), "-o", model)
        walking = self.folder / "walking.stltsa"
        self.done("fit", walk(), "-o", walking)
        for command in set(COMMANDS) - {"batch"}:  # there it is a row
            before = {"map": [model], "unmap": [model], "live": [walking]}.get(command, [])
            after = ["-o", self.folder / "out.npy"] if command in ("unmap", "synthesize") else []
            after += ["--mark", "1=step"] if command == "events" else []
            for path, hint in (
                (self.folder / "missing.bvh", "missing.bvh"),
                (self.folder, str(self.folder)),
                (broken, "broken.bvh:5"),
                (short, "short.csv:2"),
                (unfinite, "inf.csv"),
            ):
                with self.subTest(command, path=path.name):
                    self.assertIn(hint, self.fails(3, command, *before, path, *after))

    def test_standard_input(self):
        self.fails(3, "info", "-", input=b"")
        self.fails(3, "info", "-", input=b"\x00\x01\x02")

    def test_skeleton(self):
        self.fails(3, "info", walk().with_suffix(".amc"))
        clip = self.folder / "07_01.amc"
        clip.write_text(":FULLY-SPECIFIED\n:DEGREES\n1\nroot 0 0 0 0 0 0\n", encoding="ascii")
        self.assertIn("asf", self.fails(3, "info", clip).lower())


class Untrustworthy(CommandTest):
    def test_nothing_moves(self):
        self.assertIn("nothing moves", self.fails(4, "fit", still()))
        self.assertIn("nothing moves", self.fails(4, "dimension", still()))
        result = self.done("dimension", cut(), "--neighbors", "5", "--window", "8")
        self.assertIn(b"undetermined (eigengap)", result)
        self.assertIn(b"explain 95 %", result)
        self.assertIn(b"the neighborhood graph has 2 parts", result)

    def test_too_few_frames(self):
        few = write_csv("few.csv", [[0, 1], [1, 0], [2, 2]])
        for command in ("fit", "decompose"):
            with self.subTest(command):
                self.fails(4, command, few, "--fps", "30")

    def test_curve_in_pieces_is_given_and_told(self):
        coords = self.folder / "y.csv"
        result = run("fit", cut(), "--neighbors", "5", "--window", "8", "--coords", coords)
        self.assertEqual(result.returncode, 4)
        self.assertIn(b"2 pieces", result.stdout)
        self.assertIn(b"cut at frame 60;", b" ".join(result.stdout.split()))
        self.assertTrue(coords.exists())

    def test_no_cycle_is_an_answer(self):
        self.assertIn(b"no cycle", self.done("decompose", drift(), "--fps", "30"))

    def test_no_cycle_tells_what_may_hide_it(self):
        self.assertIn(
            "the pose jumps at frame 60 (2.00 s)", self.json("decompose", cut(), "--fps", "30")["reason"]
        )
        self.assertIn(
            "subtract the body's position", self.json("decompose", drift(), "--fps", "30")["reason"]
        )


if __name__ == "__main__":
    unittest.main()
