# SPDX-License-Identifier: BSD-3-Clause
"""The command gives the right answer to recordings that earlier versions answered wrongly (cases.py)."""

import unittest

import cases
from common import CommandTest, run


class Cases(CommandTest):
    pass


def test_of(write, right):
    def test(self):
        path = write(self.folder)
        if right.error is None:
            cases.check(right, self.json("decompose", path), self.json("info", path))
        else:
            result = run("decompose", path)
            self.assertIn(right.error, result.stderr.decode())
            self.assertNotEqual(result.returncode, 0)

    return test


for name, entry in cases.CASES.items():
    setattr(Cases, f"test_{name}", test_of(*entry))


if __name__ == "__main__":
    unittest.main()
