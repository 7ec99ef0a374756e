# SPDX-License-Identifier: BSD-3-Clause
"""Tables agree with the JSON."""

import re
import unittest

from common import CommandTest, circle, plain_environment, walk


class Reports(CommandTest):
    def rows(self, text, first):
        """Cells of the rows below the heading that starts with `first`."""
        lines = text.splitlines()
        start = next(i for i, line in enumerate(lines) if line.split()[:1] == [first])
        for line in lines[start + 1 :]:
            if not line.strip():
                return
            yield line.split()

    def test_decompose(self):
        found = self.json("decompose", walk())
        text = self.done("decompose", walk()).decode("ascii")
        self.assertTrue(text.startswith("walk120.bvh: 3 cycles, period "), text)
        units = [(r[0], int(r[1]), int(r[3])) for r in self.rows(text, "unit")]
        self.assertEqual(units, [(u["kind"], u["begin"], u["end"]) for u in found["units"]])
        cycles = [(int(r[1]), int(r[3])) for r in self.rows(text, "cycle")]
        self.assertEqual(cycles, [(c["begin"], c["end"]) for c in found["cycles"]])
        chosen = [i for i, r in enumerate(self.rows(text, "cycle")) if "representative" in r[-1] + r[-2]]
        self.assertEqual(chosen, [found["representative_cycle"]["index"]])
        seconds = [(float(r[4]), float(r[6]), float(r[7])) for r in self.rows(text, "unit")]
        for (begin, end, length), unit in zip(seconds, found["units"]):
            self.assertAlmostEqual(begin, unit["begin_s"], delta=0.0006)
            self.assertAlmostEqual(end, unit["end_s"], delta=0.0006)
            self.assertAlmostEqual(length, unit["end_s"] - unit["begin_s"], delta=0.0006)

    def test_remarks_fit_into_the_terminal(self):
        for columns in (60, 80, 120):
            environment = plain_environment(COLUMNS=str(columns))
            text = self.done("decompose", walk(), env=environment).decode("ascii")
            self.assertLessEqual(max(map(len, text.splitlines())), columns)
            beside = [line for line in text.splitlines() if re.match("  cyclic +A .*confidence", line)]
            self.assertEqual(len(beside), columns // 120)
            self.assertEqual(len(re.findall(r"^ {6}3 cycles of ", text, re.M)), 1 - columns // 120)

    def test_fit(self):
        found = self.json("fit", walk())
        wide = plain_environment(COLUMNS="120")
        text = self.done("fit", walk(), env=wide).decode("ascii")
        (row,) = list(self.rows(text, "piece"))[:1]
        eigenvalues = [float(cell) for cell in row[6:]]
        expected = found["components"][0]["eigenvalues"]
        self.assertEqual(len(eigenvalues), len(expected))
        for shown, value in zip(eigenvalues, expected):
            self.assertAlmostEqual(shown, value, delta=0.006 * abs(value))
        self.assertIn(f"k = {found['parameters']['neighbors']} ", text)
        narrow = self.done("fit", walk(), env=plain_environment(COLUMNS="80")).decode("ascii")
        self.assertIn("\n      " + " ".join(row[6:]) + "\n", narrow)

    def test_dimension(self):
        found = self.json("dimension", walk())
        text = self.done("dimension", walk()).decode("ascii")
        told = re.search(r"dimension (\d+|undetermined) \(local PCA\), (\d+|undetermined) \(eigengap\)", text)
        for shown, name in zip(told.groups(), ("local_pca", "eigengap")):
            expected = found[name]["dimension"]
            self.assertEqual(shown, "undetermined" if expected is None else str(expected))
        shares = [r for r in self.rows(text, "direction")]
        for row, share in zip(shares, found["local_pca"]["shares"]):
            self.assertAlmostEqual(float(row[1]), share, delta=0.0001)
            bar = row[2] if len(row) > 2 else ""
            self.assertEqual(len(bar), round(40 * share))

    def test_info(self):
        text = self.done("info", walk()).decode("ascii")
        found = self.json("info", walk())
        self.assertTrue(
            text.startswith(f"walk120.bvh: BVH, {found['clip']['frames']} frames at 120 per second")
        )
        self.assertIn(f"{len(found['joints'])} (with ", text)
        self.assertIn("frame rate unknown", self.done("info", circle()).decode("ascii"))


if __name__ == "__main__":
    unittest.main()
