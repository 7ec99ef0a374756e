# SPDX-License-Identifier: BSD-3-Clause
"""Files that the Python package reads for the command."""

import json
import math
import struct
import unittest

import jsonschema
from common import SCHEMAS, CommandTest, plain_environment, run, walk

READER = """#!/bin/sh
[ "$1 $2" = "-m stltsa.readers" ] || exit 9
case $3 in
--events)
    echo "$4 $5" >"$(dirname "$0")/asked"
    printf 'onset\\ttrial_type\\n2.1\\tLeft Foot Strike\\n' ;;
*silent.c3d) exit 3 ;;
*garbage.c3d) echo nothing ;;
*short.c3d) printf 'matrix 0 0 2 3 120.0\\n12345678' ;;
*walk.c3d|*walk.npz|*walk.mot) sed "1s/RATE/${4:-100.0}/" "$3" ;;
*) printf '%s: has no points' "$3"; exit 3 ;;
esac
"""
NAMES = ("hip", "knee", "toe")


def positions():
    """Rows of three points of a swinging leg."""
    for i in range(400):
        turn = 2 * math.pi * i / 100
        yield [math.sin(turn + k) / 3 + axis + 0.1 * k for k in range(3) for axis in (0, 1, 2)]


def skeleton():
    """The lines of the joints, and the rows of channels."""
    lines = ["-1\t0\t0.0\t0.9\t0.0\ttx ty tz rz rx ry\tHips", "0\t0\t0.1\t-0.4\t0.0\trx\tKnee",
             "1\t1\t0.0\t-0.45\t0.0\t\tend"]  # fmt: skip
    rows = [[0, 0.9, 0, 0, 30 * math.sin(i / 16), 0, 20 * math.cos(i / 16)] for i in range(400)]
    return lines, rows


def written(head, lines, rows):
    text = "\n".join([f"{head} {len(lines)} {len(rows[0])} {len(rows)} RATE", *lines, ""])
    return text.encode() + b"".join(struct.pack(f"{len(row)}d", *row) for row in rows)


class Foreign(CommandTest):
    def setUp(self):
        super().setUp()
        self.reader = self.folder / "python3"
        self.reader.write_text(READER)
        self.reader.chmod(0o755)
        rows = list(positions())
        (self.folder / "walk.c3d").write_bytes(written("points 3", NAMES, rows))
        (self.folder / "walk.mot").write_bytes(written("matrix 0", (), rows))
        (self.folder / "walk.npz").write_bytes(written("skeleton 0", *skeleton()))
        head = ",".join(f"{name}_{axis}" for name in NAMES for axis in "xyz")
        lines = [",".join(map(repr, row)) for row in rows]
        self.table = self.folder / "walk.csv"
        self.table.write_text("\n".join([head, *lines, ""]))

    def run_with(self, reader, *arguments):
        return run(*arguments, env=plain_environment(STLTSA_PYTHON=str(reader)))

    def same(self, there, here):
        """The results are equal apart from the path of the clip."""
        self.assertEqual((there.returncode, here.returncode), (0, 0), there.stderr + here.stderr)
        found, expected = json.loads(there.stdout), json.loads(here.stdout)
        name = found["format"].replace("/", "-")
        jsonschema.validate(found, json.loads((SCHEMAS / f"{name}.schema.json").read_text()))
        self.assertEqual(found["clip"].pop("path"), str(self.folder / "walk.c3d"))
        self.assertEqual(found["clip"].pop("format"), "points")
        self.assertEqual(expected["clip"].pop("format"), "csv")
        del expected["clip"]["path"]
        self.assertEqual(found, expected)

    def test_points_have_the_bits_of_the_reader(self):
        there = self.run_with(self.reader, "decompose", self.folder / "walk.c3d", "--json")
        self.same(there, run("decompose", self.table, "--fps", "100", "--json"))

    def test_labels_of_c3d_are_marks(self):
        c3d = self.folder / "walk.c3d"
        there = self.run_with(self.reader, "events", walk(), "--mark", c3d, "--json")
        here = run("events", walk(), "--mark", "2.1s=Left Foot Strike", "--json")
        self.assertEqual(there.returncode, 0, there.stderr)
        self.assertEqual(there.stdout, here.stdout)
        self.assertIn(b'"side":"left"', there.stdout.replace(b" ", b""))

    def test_labels_are_those_of_the_stretch_and_its_rate(self):
        c3d = self.folder / "walk.c3d"
        there = self.run_with(self.reader, "events", f"{c3d}:1s-3s", "--mark", c3d, "--fps", "50.5")
        self.assertNotEqual(there.returncode, 9)
        self.assertEqual((self.folder / "asked").read_text(), f"{c3d}:1s-3s 50.5\n")

    def test_a_stretch_may_follow(self):
        there = self.run_with(self.reader, "info", f"{self.folder}/walk.c3d:1s-3s", "--json")
        self.same(there, run("info", f"{self.table}:1s-3s", "--fps", "100", "--json"))

    def test_skeletons_and_matrices(self):
        found = json.loads(self.run_with(self.reader, "info", self.folder / "walk.npz",
                                         "--json").stdout)  # fmt: skip
        self.assertEqual((found["clip"]["format"], found["clip"]["frames"]), ("skeleton", 400))
        self.assertEqual(found["channels"]["count"], 7)
        found = json.loads(self.run_with(self.reader, "info", self.folder / "walk.mot",
                                         "--json").stdout)  # fmt: skip
        self.assertEqual((found["clip"]["format"], found["channels"]["count"]), ("matrix", 9))

    def test_the_rate_is_passed_on(self):
        there = self.run_with(self.reader, "info", self.folder / "walk.c3d", "--fps", "60")
        self.assertIn(b"at 60 per second", there.stdout)

    def test_errors_are_those_of_the_reader(self):
        for name, sentence in (("other.trc", b"other.trc: has no points"),
                               ("silent.c3d", b"silent.c3d: the Python package failed"),
                               ("garbage.c3d", b"returned no clip"),
                               ("short.c3d", b"returned no clip")):
            done = self.run_with(self.reader, "info", self.folder / name)
            self.assertEqual(done.returncode, 3)
            self.assertIn(sentence, done.stderr)

    def test_no_interpreter(self):
        done = self.run_with(self.folder / "absent", "info", "walk.c3d")
        self.assertEqual(done.returncode, 3)
        self.assertIn(b"cannot run the Python interpreter", done.stderr)
        done = run("info", self.folder / "walk.c3d")
        self.assertEqual(done.returncode, 3)
        self.assertIn(b"pip install 'stltsa[c3d]'", done.stderr)


if __name__ == "__main__":
    unittest.main()
