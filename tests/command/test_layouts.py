# SPDX-License-Identifier: BSD-3-Clause
"""Every layout in the tables of docs/formats.md, sections Layouts and Time, gives the answer of the plain file."""

import functools
import json
import os
import pathlib
import re
import unittest

import layouts
import layouts_formats  # noqa: F401 (registers layouts)
import layouts_subjects  # noqa: F401
import layouts_times  # noqa: F401
from common import CommandTest, run

PAGE = pathlib.Path(os.environ["STLTSA_FORMATS"])


def rows_of_the_page():
    """The first cells of the tables."""
    page, found = PAGE.read_text(encoding="utf-8"), []
    for title in ("Layouts", "Time"):
        section = page.split(f"\n## {title}\n")[1].split("\n## ")[0]
        rows = [line for line in section.splitlines() if line.startswith("|")]
        found += [re.split(r"\s*\|\s*", row.strip("| "))[0] for row in rows[2:]]
    return found


class Layouts(CommandTest):
    def test_the_table_and_the_generators_are_the_same(self):
        self.assertEqual(sorted(rows_of_the_page()), sorted(layouts.LAYOUTS))

    def test_a_plain_file_is_read_rightly(self):
        clip = self.json("info", layouts.plain(self.folder, "space"))
        self.assertEqual(clip["clip"]["fps"], layouts.FPS)
        self.assertEqual(clip["channels"]["count"], 3 * len(layouts.JOINTS))
        for which in ("space", "plane", "missing"):
            found = self.json("decompose", layouts.plain(self.folder, which))
            self.assertEqual(len(found["cycles"]), 3)
            self.assertAlmostEqual(found["period_s"], 1.1, delta=0.01)

    def answer(self, path, *options):
        """What was found, with the names of the points: without paths, notes and prefixes of subjects."""
        found = self.json("decompose", path, *options)
        channels = self.json("info", path, *options)["channels"]
        found["points"] = [re.sub(r"[_. :-]?[xyz]$", "", name, flags=re.I) for name in channels["names"]]
        del found["clip"]["path"], found["clip"]["format"], found["clip"]["notes"]
        return json.loads(re.sub(r"\b((scene:)?(Anna|Pat|S|mouse1)[:_|.]|mouse1_)", "", json.dumps(found)))

    def check(self, case):
        if case.error:
            result = run("info", case.path, *case.options)
            self.assertNotEqual(result.returncode, 0)
            self.assertIn(case.error, result.stderr.decode())
        elif case.note:
            found = self.json("info", case.path, *case.options)["clip"]
            self.assertIn(case.note, " ".join([found["features"], *found["notes"]]))
        else:
            found = self.answer(case.path, *case.options)
            self.assertEqual(found, self.expected(case.like))

    @functools.cache
    def expected(self, which):
        return self.answer(layouts.plain(self.folder, which))


def test_of(name):
    def test(self):
        for number, case in enumerate(layouts.LAYOUTS[name](self.folder)):
            with self.subTest(layout=name, number=number, file=case.path.name, case=case):
                self.check(case)

    return test


for index, layout in enumerate(layouts.LAYOUTS):
    words = re.sub(r"\W+", "_", layout).strip("_")
    setattr(Layouts, f"test_{index:02}_{words}", test_of(layout))


if __name__ == "__main__":
    unittest.main()
