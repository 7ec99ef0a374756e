# SPDX-License-Identifier: BSD-3-Clause
"""The manual page says what the command does."""

import re
import unittest

from common import COMMANDS, MANUAL, CommandTest

FLAG = re.compile(r"(?<![\w-])--[a-z][a-z-]*")


class Manual(CommandTest):
    def setUp(self):
        super().setUp()
        self.page = MANUAL.read_text(encoding="ascii").replace("\\-", "-")
        self.help = "".join(
            self.done(*line, "--help").decode() for line in ((), *((c,) for c in COMMANDS))
        )

    def test_flags_are_the_same(self):
        documented = set(FLAG.findall(self.page))
        self.assertIn("--neighbors", documented)
        self.assertEqual(documented, set(FLAG.findall(self.help)))

    def test_exit_statuses_are_the_same(self):
        section = self.page[self.page.index(".SH EXIT STATUS") :]
        documented = re.findall(r"^\.B (\d+)$", section, re.MULTILINE)
        told = self.help[self.help.index("Exit status:") :]
        told = told[: told.index("cancelled")]
        self.assertEqual(documented, re.findall(r"\b(\d+)\b", told))

    def test_version_is_the_same(self):
        version = self.done("--version").split()[1].decode()
        self.assertIn(f'"libstltsa {version}"', self.page)


if __name__ == "__main__":
    unittest.main()
