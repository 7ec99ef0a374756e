# SPDX-License-Identifier: BSD-3-Clause
"""Terminal output: progress, colors, Ctrl-C."""

import contextlib
import json
import math
import os
import pty
import re
import select
import shutil
import signal
import subprocess
import time
import unicodedata
import unittest

from common import STLTSA, CommandTest, default_signals, long_clip, plain_environment, run, walk

COLOR = re.compile(rb"\x1b\[\d")  # not the bar's \x1b[K, which clears a line


class Terminal:
    """The command with a pseudo-terminal as standard output, standard error or both."""

    def __init__(self, *arguments, on=("stdout", "stderr"), **environment):
        try:
            self.master, slave = pty.openpty()
        except OSError as error:
            raise unittest.SkipTest(f"no terminal to be had: {error}")
        streams = {
            name: slave if name in on else subprocess.PIPE for name in ("stdout", "stderr")
        }
        self.process = subprocess.Popen(
            [STLTSA, *map(os.fspath, arguments)],
            stdin=subprocess.DEVNULL,
            env=plain_environment(**{"TERM": "xterm", **environment}),
            preexec_fn=default_signals,
            **streams,
        )
        os.close(slave)
        self.seen = b""

    def read(self, seconds):
        """Reads more of the terminal's output; False at the end."""
        if not select.select([self.master], [], [], seconds)[0]:
            return True
        try:
            block = os.read(self.master, 65536)
        except OSError:  # Linux reports a closed other side this way
            block = b""
        self.seen += block
        return bool(block)

    def wait_for(self, text, seconds=60):
        end = time.monotonic() + seconds
        while text not in self.seen and time.monotonic() < end and self.read(0.1):
            pass
        return text in self.seen

    def finish(self):
        """Returns exit status, terminal output, and pipe output."""
        while self.read(60):
            pass
        os.close(self.master)
        out, err = self.process.communicate(timeout=60)
        return self.process.returncode, self.seen, (out or b"") + (err or b"")


class Progress(CommandTest):
    def test_bar_on_a_terminal_only(self):
        long = ("fit", long_clip(), "--neighbors", "300", "--sample-rate", "0")
        status, seen, piped = Terminal(*long, on=("stderr",)).finish()
        self.assertEqual(status, 0)
        self.assertIn(b"spectrum", seen)
        self.assertRegex(seen, rb"\[#*\.*\]")
        self.assertTrue(seen.endswith(b"\r\x1b[K"), seen[-20:])
        self.assertEqual(piped.count(b"\x1b"), 0)
        status, seen, piped = Terminal(*long, on=("stdout",)).finish()
        self.assertEqual((status, piped), (0, b""))
        status, seen, piped = Terminal(*long, on=("stderr",), TERM="dumb").finish()
        self.assertEqual((status, seen), (0, b""))

    def test_no_bar_if_it_is_quick(self):
        status, seen, _ = Terminal("info", walk(), on=("stderr",)).finish()
        self.assertEqual((status, seen), (0, b""))

    def test_quiet(self):
        long = ("fit", long_clip(), "--neighbors", "300", "--sample-rate", "0")
        status, seen, _ = Terminal(*long, "-q", on=("stderr",)).finish()
        self.assertEqual((status, seen), (0, b""))


class Colors(CommandTest):
    def shown(self, *arguments, **environment):
        status, seen, _ = Terminal("info", walk(), *arguments, on=("stdout",), **environment).finish()
        self.assertEqual(status, 0)
        return seen

    def test_colors(self):
        self.assertRegex(self.shown(), COLOR)
        self.assertRegex(self.shown(NO_COLOR=""), COLOR)
        for plain in (
            self.shown("--no-color"),
            self.shown(NO_COLOR="1"),
            self.shown(TERM="dumb"),
            self.shown(TERM=""),
            self.done("info", walk(), env=plain_environment(TERM="xterm")),
        ):
            self.assertNotRegex(plain, COLOR)

    def test_errors(self):
        missing = ("info", self.folder / "missing.bvh")
        self.assertRegex(Terminal(*missing, on=("stderr",)).finish()[1], COLOR)
        self.assertNotRegex(Terminal(*missing, on=("stderr",), NO_COLOR="1").finish()[1], COLOR)


class HostileNames(CommandTest):
    """Names of files, joints and events must not control the terminal: no control characters of one or
    two bytes, none that turn the direction of the text, and no bytes that are not UTF-8. Letters of any
    script stay."""

    NAME = b"a\x1b]0;title\x07\x7f\xc2\x9b31m\xff\xc3\xa4\xe2\x80\xae"
    SHOWN = "a?]0;title???31m?\u00e4?"

    def setUp(self):
        super().setUp()
        self.clip = os.path.join(os.fsencode(self.folder), self.NAME + b".bvh")
        shutil.copy(walk(), self.clip)
        self.missing = os.path.join(os.fsencode(self.folder), self.NAME)

    def assert_no_controls(self, output):
        text = output.decode()  # UTF-8, or an error
        controls = [c for c in text if c != "\n" and unicodedata.category(c) == "Cc"]
        self.assertEqual(controls, [], text)

    def assert_clean(self, output):
        self.assert_no_controls(output)
        self.assertIn(self.SHOWN, output.decode())

    def test_of_results(self):
        model = self.folder / "walk.stltsa"
        new = self.folder / "new.bvh"
        self.done("fit", walk(), "-o", model)
        for arguments in (
            ["info", self.clip],
            ["fit", self.clip],
            ["dimension", self.clip],
            ["decompose", self.clip],
            ["denoise", self.clip],
            ["map", model, self.clip],
            ["compare", self.clip],
            ["compare", self.clip, walk()],
            ["events", self.clip, "--mark", "400=step"],
            ["synthesize", self.clip + b":cycle2*2", "-o", new],
        ):
            with self.subTest(arguments[0]):
                self.assert_clean(self.done(*arguments))

    def test_line_breaks(self):
        broken = self.folder / "a\nb.bvh"
        broken.write_text("x")
        said = self.fails(3, "info", broken)
        self.assertIn("a\ufffdb.bvh:1: a BVH file", said)
        listed = run("batch", self.folder, "--out", self.folder / "out").stdout.decode()
        self.assertRegex(listed, "a\ufffdb.bvh  line 1: a BVH file")

    def test_of_json(self):
        clip = self.folder / "walk.bvh"
        clip.write_bytes(walk().read_bytes().replace(b"Hips", self.NAME))
        for command in ("info", "fit", "decompose", "compare"):
            with self.subTest(command):
                self.assert_no_controls(self.done(command, clip, "--json"))
        names = json.loads(self.done("info", clip, "--json"))["channels"]["names"]
        self.assertEqual(names[0], self.NAME.decode(errors="replace") + ".tx")

    def test_of_joints_and_events(self):
        """Checks everything printed; not every command prints the name."""
        folder = self.folder / "recordings"
        folder.mkdir()
        clip = folder / "walk.bvh"
        clip.write_bytes(walk().read_bytes().replace(b"Hips", self.NAME))
        table = folder / "table.csv"
        rows = [f"{math.sin(i / 8)},{math.cos(i / 8)}" for i in range(400)]
        table.write_bytes(self.NAME + b",b\n" + "\n".join(rows).encode() + b"\n")
        model = self.folder / "walk.stltsa"
        self.done("fit", clip, "-o", model)
        named = 0
        for arguments in (
            ["info", clip],
            ["decompose", clip],
            ["decompose", table, "--fps", "30"],
            ["compare", clip],
            ["compare", clip, walk()],
            ["events", clip, "--mark", b"400=" + self.NAME],
            ["live", model, clip],
            ["batch", folder, "--fps", "30", "--out", self.folder / "results"],
        ):
            with self.subTest(arguments):
                result = run(*arguments)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assert_no_controls(result.stdout + result.stderr)
                named += self.SHOWN in (result.stdout + result.stderr).decode()
        self.assertGreater(named, 1)

    def test_of_errors(self):
        for arguments in (
            ["info", self.missing],
            ["decompose", self.missing],
            ["info", walk(), self.missing],
            [self.missing],
            ["info", walk(), b"--" + self.NAME],
            ["fit", walk(), "--neighbors", self.NAME],
            ["fit", walk(), "-o", self.missing + b".txt"],
            ["decompose", walk(), "-o", self.missing + b"/result.txt"],
            ["synthesize", self.clip + b":nothing", "-o", "new.bvh"],
        ):
            with self.subTest(arguments):
                result = run(*arguments)
                self.assertNotEqual(result.returncode, 0)
                self.assert_clean(result.stderr)

    def test_of_clips_on_a_terminal(self):
        """Shown there, names are harmless; in a pipe they are as in a file."""
        clip = self.folder / "walk.bvh"
        clip.write_bytes(walk().read_bytes().replace(b"Hips", self.NAME))
        arguments = ("synthesize", f"{clip}:cycle2*2", "-o", "-")
        status, seen, _ = Terminal(*arguments, on=("stdout",)).finish()
        self.assertEqual(status, 0)
        self.assertIn("ROOT a_]0;title_??31m?\u00e4?\r\n{\r\n\tOFFSET ", seen.decode())
        self.assertIn(b"\xc2\x9b31m", self.done(*arguments))

    def test_colors_stay(self):
        output = Terminal("info", self.clip).finish()[1]
        self.assertRegex(output, COLOR)
        self.assertNotIn(b"\x1b]0;", output)


@contextlib.contextmanager
def started(*arguments, **settings):
    """A running command; killed if the test does not end it."""
    with subprocess.Popen(
        [STLTSA, *arguments], stderr=subprocess.PIPE, preexec_fn=default_signals, **settings
    ) as process:
        try:
            yield process
        finally:
            process.kill()


class Interrupt(CommandTest):
    def test_while_it_works(self):
        files = [self.folder / name for name in ("y.npy", "y.stltsa")]
        terminal = Terminal(
            *("fit", long_clip(), "--neighbors", "600", "--sample-rate", "0", "--json"),
            *("--coords", files[0], "-o", files[1]),
        )
        self.assertTrue(terminal.wait_for(b" %"), terminal.seen)
        start = time.monotonic()
        terminal.process.send_signal(signal.SIGINT)
        status, seen, _ = terminal.finish()
        self.assertEqual(status, 130)
        self.assertTrue(seen.endswith(b" cancelled\r\n"), seen[-80:])
        self.assertNotIn(b"stltsa-model/1", seen)
        self.assertLess(time.monotonic() - start, 10)
        self.assert_empty(self.folder)

    def test_while_it_reads(self):
        with started("info", "-", stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
            process.stdin.write(b"1,2,3\n" * 50000)  # more than a pipe holds: it is reading
            process.stdin.flush()
            time.sleep(0.5)  # the command waits for more
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(60), 130)
            self.assertEqual(process.stdout.read(), b"")
            self.assertEqual(process.stderr.read(), b"stltsa: cancelled\n")

    def test_while_it_waits_for_a_pipe(self):
        pipe = self.folder / "clip.csv"
        os.mkfifo(pipe)
        with started("info", pipe) as process:
            time.sleep(0.5)  # nobody writes
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(60), 130)
            self.assertEqual(process.stderr.read(), b"stltsa: cancelled\n")

    def assert_stops(self, *arguments, stdout=subprocess.DEVNULL):
        with started(*arguments, stdout=stdout) as process:
            time.sleep(1)
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(60), 130)
            self.assertEqual(process.stderr.read(), b"stltsa: cancelled\n")

    def test_while_nobody_reads(self):
        pipe = self.folder / "pipe.bvh"
        os.mkfifo(pipe)
        clip = f"{walk()}:cycle2*100"  # more than a pipe holds
        with self.subTest("a pipe that nobody opened"):
            self.assert_stops("synthesize", clip, "-o", pipe)
            self.assert_stops("decompose", walk(), "-o", pipe)
        with self.subTest("a pipe that nobody empties"):
            reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
            self.assert_stops("synthesize", clip, "-o", pipe)
            os.close(reader)
        with self.subTest("standard output"):
            reader, writer = os.pipe()
            self.assert_stops("synthesize", clip, "-o", "-", stdout=writer)
            os.close(reader)
            os.close(writer)

    def test_ignored_where_the_caller_ignores_it(self):
        with subprocess.Popen(
            [STLTSA, "info", "-"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN),
        ) as process:
            process.stdin.write(b"1,2,3\n" * 50000)
            process.stdin.flush()
            process.send_signal(signal.SIGINT)
            out, _ = process.communicate(timeout=60)
            self.assertEqual(process.returncode, 0)
            self.assertIn(b"50000 frames", out)


if __name__ == "__main__":
    unittest.main()
