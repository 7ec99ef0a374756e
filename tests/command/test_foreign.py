# SPDX-License-Identifier: BSD-3-Clause
"""Files that the Python package reads for the command."""

import unittest

from common import CommandTest, plain_environment, run, walk

READER = """#!/bin/sh
[ "$1 $2" = "-m stltsa.readers" ] || exit 9
case $3 in
*walk.c3d) printf 'fps %s\\n' "${4:-120.0}"; cat WALKER ;;
*silent.c3d) exit 3 ;;
*garbage.c3d) echo nothing ;;
*) printf '%s: has no points' "$3"; exit 3 ;;
esac
"""


class Foreign(CommandTest):
    def setUp(self):
        super().setUp()
        self.reader = self.folder / "python3"
        self.reader.write_text(READER.replace("WALKER", str(walk())))
        self.reader.chmod(0o755)
        (self.folder / "walk.c3d").touch()

    def run_with(self, reader, *arguments):
        return run(*arguments, env=plain_environment(STLTSA_PYTHON=str(reader)))

    def test_the_clip_is_that_of_the_reader(self):
        there = self.run_with(self.reader, "decompose", self.folder / "walk.c3d", "--json")
        here = run("decompose", walk(), "--json")
        self.assertEqual(there.returncode, 0, there.stderr)
        path = str(self.folder / "walk.c3d").encode()
        self.assertEqual(there.stdout.replace(path, str(walk()).encode()), here.stdout)

    def test_a_stretch_may_follow(self):
        there = self.run_with(self.reader, "info", f"{self.folder}/walk.c3d:1s-3s", "--json")
        here = run("info", f"{walk()}:1s-3s", "--json")
        self.assertEqual(there.returncode, 0, there.stderr)
        path = str(self.folder / "walk.c3d").encode()
        self.assertEqual(there.stdout.replace(path, str(walk()).encode()), here.stdout)

    def test_the_rate_is_passed_on(self):
        there = self.run_with(self.reader, "info", self.folder / "walk.c3d", "--fps", "60")
        self.assertIn(b"60", there.stdout)
        self.assertNotIn(b"120 ", there.stdout)

    def test_errors_are_those_of_the_reader(self):
        for name, sentence in (("other.trc", b"other.trc: has no points"),
                               ("silent.c3d", b"silent.c3d: the Python package failed"),
                               ("garbage.c3d", b"gave no clip")):
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
