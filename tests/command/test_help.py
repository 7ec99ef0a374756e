# SPDX-License-Identifier: BSD-3-Clause
"""Help, advice for what is typed, and completions."""

import shutil
import subprocess
import unittest

from common import COMMANDS, CommandTest, plain_environment, walk


class Help(CommandTest):
    def test_help_of_a_command(self):
        self.assertEqual(self.done("help"), self.done("--help"))
        for command in COMMANDS:
            self.assertEqual(self.done("help", command), self.done(command, "--help"))
        self.assertIn("Did you mean fit?", self.fails(2, "help", "fti"))

    def test_groups_begin_with_the_output(self):
        for command in COMMANDS:
            lines = self.done(command, "--help").decode().splitlines()
            groups = [line for line in lines if line in
                      ("Output:", "Input:", "Method:", "Messages:")]
            self.assertEqual((groups[0], groups[-1]), ("Output:", "Messages:"), command)
            self.assertNotIn("Options:", lines)

    def test_width(self):
        for columns in (80, 100, 120):
            environment = plain_environment(COLUMNS=str(columns))
            lines = self.done("fit", "--help", env=environment).decode().splitlines()
            described = [line for line in lines if line.startswith(" " * 32)]
            longest = max(map(len, described))
            self.assertLessEqual(longest, columns)
            self.assertGreater(longest, columns - 12)

    def test_narrow_terminals(self):
        for columns in (40, 50, 63):
            environment = plain_environment(COLUMNS=str(columns))
            for words in (("--help",), *((command, "--help") for command in COMMANDS)):
                lines = self.done(*words, env=environment).decode().splitlines()
                long = [line for line in lines if len(line) > columns]
                # Commands to copy are not wrapped.
                self.assertEqual([x for x in long if not x.startswith("  stltsa ")], [], words)
                self.assertFalse(any("  " in x.strip() for x in long), long)

    def test_a_clip_in_place_of_a_command(self):
        self.assertIn(f"try 'stltsa decompose {walk()}'", self.fails(2, walk()))

    def test_formats_of_the_python_package(self):
        for name in ("a.npz", "a.NC"):
            path = self.folder / name
            path.write_bytes(b"\x02P\0")
            self.assertIn("only the Python package reads", self.fails(3, "info", path))


class Completions(CommandTest):
    def completed(self, *words):
        """What bash offers for the last of these words."""
        script = self.folder / "completions"
        script.write_bytes(self.done("completions", "bash"))
        typed = " ".join(f"'{word}'" for word in ("stltsa", *words))
        lines = (f"source '{script}'", f"COMP_WORDS=({typed})", f"COMP_CWORD={len(words)}",
                 "_stltsa", 'printf "%s\\n" "${COMPREPLY[@]}"')  # fmt: skip
        shown = subprocess.run(["bash", "-euc", "\n".join(lines)], stdout=subprocess.PIPE,
                               cwd=self.folder, check=True)  # fmt: skip
        return shown.stdout.decode().split()

    def test_bash(self):
        self.assertEqual(self.completed("de"), ["decompose", "denoise"])
        self.assertEqual(self.completed("help", "ma"), ["map"])
        self.assertEqual(self.completed("fit", "--mode", "s"), ["spatial"])
        self.assertEqual(self.completed("fit", "--neigh"), ["--neighbors"])
        self.assertEqual(self.completed("info", "--neigh"), [])
        self.assertIn("completions", self.completed("info", "comp"))
        self.assertIn("completions", self.completed("decompose", "x.bvh", "-o", "comp"))
        self.assertIn("completions", self.completed("decompose", "--json", "comp"))

    def test_every_flag_is_offered(self):
        for command in COMMANDS:
            text = self.done(command, "--help").decode()
            for flag in self.completed(command, "--"):
                self.assertIn(flag, text)
            self.assertIn("--json", self.completed(command, "--"))

    def test_other_shells_accept_theirs(self):
        for shell in ("bash", "zsh", "fish"):
            script = self.folder / shell
            script.write_bytes(self.done("completions", shell))
            if shutil.which(shell):
                subprocess.run([shell, "-n", script], check=True)
        self.assertIn("bash, zsh, fish", self.fails(2, "completions", "csh"))


if __name__ == "__main__":
    unittest.main()
