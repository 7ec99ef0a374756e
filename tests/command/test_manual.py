# SPDX-License-Identifier: BSD-3-Clause
"""The manual page agrees with the command."""

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

    def test_options_are_of_the_commands_named(self):
        """Commands are named by the section's title or in the entry; "Not of" excludes one."""
        takes = {}
        for command in COMMANDS:
            lines = self.done(command, "--help").decode().splitlines()
            defined = [line.split("  ")[1] for line in lines if re.match("  -", line)]
            takes[command] = set(FLAG.findall(" ".join(defined)))
        options = self.page[self.page.index(".SH OPTIONS") : self.page.index(".SH OUTPUT")]
        for section in options.split(".SS ")[1:]:
            title, *entries = section.split("\n.TP\n")
            for entry in entries:
                head, text = entry.split("\n", 1)
                for flag in FLAG.findall(head):
                    if flag.startswith("--no-") or flag == "--version":
                        continue
                    named = {c for c in COMMANDS if re.search(rf"\b{c}\b", title)}
                    if "all commands" in title:
                        excepted = re.search(r"Not of (\w+)", text)
                        named = set(COMMANDS) - {excepted and excepted[1]}
                    elif "single" in title:
                        named = {c for c in COMMANDS if re.search(rf"\b{c}\b[,:]", text)}
                    else:
                        for more in re.findall(r"Of (\w+)(?: and (\w+))? too", text):
                            named |= set(more) & set(COMMANDS)
                    self.assertEqual(named, {c for c in COMMANDS if flag in takes[c]}, flag)

    def test_help_speaks_of_its_own_command(self):
        """Options of several commands say only what they do in this one."""
        for command in COMMANDS:
            text = " ".join(self.done(command, "--help").decode().split())
            for other in set(COMMANDS) - {command}:
                self.assertNotRegex(text, rf"auto: {other} |; {other}[: ]|, {other} the ", command)

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
