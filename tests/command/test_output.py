# SPDX-License-Identifier: BSD-3-Clause
"""Results go to the right place, completely or not at all."""

import json
import os
import pathlib
import resource
import signal
import subprocess
import unittest

import numpy

from common import STLTSA, CommandTest, circle, plain_environment, run, still, walk


def let_files_be_small():
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))


class Streams(CommandTest):
    def test_standard_input_is_the_file(self):
        for clip in (walk(), circle()):
            for command in ("info", "fit"):
                from_file = self.json(command, clip)
                from_stdin = self.json(command, "-", input=clip.read_bytes())
                self.assertEqual(from_file["clip"].pop("path"), str(clip))
                self.assertIsNone(from_stdin["clip"].pop("path"))
                self.assertEqual(from_file, from_stdin)

    def test_a_stretch_of_standard_input(self):
        for arguments in (("info",), ("decompose",), ("synthesize", "-o", self.folder / "x.bvh")):
            from_file = self.json(arguments[0], f"{walk()}:cyclic", *arguments[1:])
            from_stdin = self.json(arguments[0], "-:cyclic", *arguments[1:], input=walk().read_bytes())
            for found, path in ((from_file, str(walk())), (from_stdin, None)):
                clips = found.get("pieces", [found["clip"]])
                self.assertEqual([clip.pop("path") for clip in clips], [path])
            self.assertEqual(from_file, from_stdin)
        text = self.done("info", "-:cyclic", input=walk().read_bytes()).decode()
        self.assertTrue(text.startswith("standard input:cyclic: BVH, "), text)
        message = self.fails(2, "map", "-", "-:cyclic", input=b"")
        self.assertIn("standard input", message)

    def test_outputs_whose_names_are_like_a_stretch_of_it(self):
        for line in (("decompose", "-o", "-:x.json", "--plot", "-:x.svg"),
                     ("fit", "-o", "-:x.stltsa"), ("batch", "--out", "-:out")):  # fmt: skip
            self.done(line[0], circle(), "--fps", "60", *line[1:], cwd=self.folder)
        names = ["-:out", "-:x.json", "-:x.stltsa", "-:x.svg"]
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), names)
        message = self.fails(2, "fit", circle(), "--period-min", "-:x")
        self.assertIn("-:x", message)
        self.assertNotIn("\x01", message)

    def test_a_folder_does_not_hide_a_stretch(self):
        clip = self.folder / "walk.bvh"
        clip.write_bytes(walk().read_bytes())
        (self.folder / "walk.bvh:cyclic").mkdir()
        found = self.json("info", f"{clip}:cyclic")
        self.assertLess(found["clip"]["frames"], self.json("info", clip)["clip"]["frames"])
        self.done("synthesize", f"{clip}:cyclic", "-o", self.folder / "x.bvh")
        (self.folder / "walk.bvh:best").write_bytes(walk(60).read_bytes())
        self.assertEqual(self.json("info", f"{clip}:best")["clip"]["fps"], 60)
        self.assertIn("'cyclé' is no stretch", self.fails(2, "info", f"{clip}:cyclé"))

    def test_errors_name_standard_input(self):
        for line, text in (
            (("info", "-"), "standard input:1: "),
            (("info", "-:cyclic"), "standard input:1: "),
            (("synthesize", "-:best", "-o", "x.bvh"), "standard input:1: "),
            (("map", "-", walk()), "standard input: this is not a model"),
        ):
            message = self.fails(3, *line, input=b"junk\n", cwd=self.folder)
            self.assertTrue(message.startswith(f"stltsa: {text}"), message)

    def test_full_disk(self):
        with open("/dev/full", "wb") as full:
            self.assertIn("No space", self.fails(1, "info", walk(), stdout=full))
            self.assertIn("No space", self.fails(1, "--help", stdout=full))

    def test_closed_pipe(self):
        reader, writer = os.pipe()
        os.close(reader)
        with os.fdopen(writer, "wb") as closed:
            self.assertIn("Broken pipe", self.fails(1, "info", walk(), stdout=closed))

    def test_closed_standard_output(self):
        """A file opened later must not become standard output."""
        figure = self.folder / "figure.svg"
        result = subprocess.run(
            ["sh", "-c", '"$@" >&-', "sh", STLTSA, "decompose", walk(), "--plot", figure],
            stderr=subprocess.PIPE,
            env=plain_environment(),
            check=False,
        )
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"standard output", result.stderr)
        self.assert_empty(self.folder)


class Files(CommandTest):
    def test_output(self):
        path = self.folder / "walk.txt"
        text = self.done("decompose", walk())
        self.assertEqual(self.done("decompose", walk(), "-o", path), b"")
        self.assertEqual(path.read_bytes(), text)

    def test_failed_writes_leave_nothing(self):
        places = ((full, full) for full in ("/dev/full", self.folder))
        for text, plot in (*places, ("/nonexistent/x.txt", "/nonexistent/x.svg")):
            with self.subTest(text):
                self.fails(1, "decompose", walk(), "-o", text)
                self.fails(1, "decompose", walk(), "-o", self.folder / "a.txt", "--plot", plot)
                self.assert_empty(self.folder)
        self.assertTrue(os.path.exists("/dev/full"))

    def test_full_disk_keeps_the_old_file(self):
        alone = ["unshare", "--mount", "--map-root-user"]  # a file system that only this test sees
        if subprocess.run([*alone, "true"], capture_output=True, check=False).returncode != 0:
            self.skipTest("no mount namespaces here")
        script = (
            'mount -t tmpfs -o size=4k none "$1" && echo old >"$1/a.json" || exit 99\n'
            '"$2" decompose "$3" --json -o "$1/a.json"; status=$?\n'
            'ls "$1" && cat "$1/a.json"; exit "$status"'
        )
        result = subprocess.run(
            [*alone, "sh", "-c", script, "sh", self.folder, STLTSA, walk()],
            capture_output=True,
            env=plain_environment(),
            check=False,
        )
        self.assertEqual(result.stdout, b"a.json\nold\n", result.stderr)
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"No space left", result.stderr)

    def test_one_file_has_one_use(self):
        clip = self.folder / "walk.svg"
        clip.write_bytes(walk().read_bytes())
        link = self.folder / "link.svg"
        link.symlink_to(clip)
        (self.folder / "sub").mkdir()
        for same in (clip, link, self.folder / "sub" / ".." / "walk.svg"):
            self.assertIn("input", self.fails(2, "decompose", clip, "--plot", same))
            self.assertIn("input", self.fails(2, "decompose", walk(), "--skeleton", clip, "--plot", same))
        text = self.folder / "walk.txt"
        text.write_bytes(walk().read_bytes())
        self.assertIn("input", self.fails(2, "dimension", "walk.txt", "-o", text, cwd=self.folder))
        self.assertEqual(clip.read_bytes(), walk().read_bytes())
        new = self.folder / "new.npy"
        message = self.fails(
            2, "denoise", walk(), "-o", "new.npy", "--curve-out", new, cwd=self.folder
        )
        self.assertIn("two outputs", message)
        self.assertFalse(new.exists())
        self.done("decompose", walk(), "-o", "/dev/null", "--plot", "/dev/null")

    def test_failed_run_leaves_the_old_file(self):
        path = self.folder / "old.csv"
        path.write_text("old", encoding="ascii")
        self.fails(4, "fit", still(), "--smoothing", "0", "--coords", path)
        self.assertEqual(path.read_text(encoding="ascii"), "old")

    def test_file_is_replaced_with_its_mode_and_through_links(self):
        path = self.folder / "walk.json"
        path.write_text("old", encoding="ascii")
        path.chmod(0o640)
        link = self.folder / "link.json"
        link.symlink_to(path)
        self.done("decompose", walk(), "--json", "-o", link)
        self.assertTrue(link.is_symlink())
        self.assertEqual(path.stat().st_mode & 0o777, 0o640)
        self.assertEqual(json.loads(path.read_text())["format"], "stltsa-decomposition/2")
        self.assertEqual(len(list(self.folder.iterdir())), 2)

    def test_link_to_nothing_yet_leads_to_the_new_file(self):
        links = self.folder / "links"
        links.mkdir()
        names = ("walk.stltsa", "walk.csv")
        for name in names:
            (links / name).symlink_to(pathlib.Path("..") / name)
        self.done(
            "fit", walk(), "-o", links / "walk.stltsa", "--coords", links / "walk.csv"
        )
        for name in names:
            self.assertTrue((links / name).is_symlink())
            self.assertGreater((self.folder / name).stat().st_size, 0)
            self.assertFalse((self.folder / name).is_symlink())

    def test_links_to_one_new_file_are_one_place(self):
        link, other = self.folder / "a.csv", self.folder / "b.csv"
        link.symlink_to("b.csv")
        message = self.fails(2, "denoise", walk(), "-o", link, "--curve-out", other)
        self.assertIn("two outputs", message)
        self.assertFalse(other.exists())

    def test_ring_of_links(self):
        ring = [self.folder / name for name in ("a.json", "b.json")]
        ring[0].symlink_to(ring[1])
        ring[1].symlink_to(ring[0])
        self.assertIn("links", self.fails(1, "decompose", walk(), "--json", "-o", ring[0]))
        self.assertTrue(all(link.is_symlink() for link in ring))

    def test_file_that_grows_too_large_is_named_as_given(self):
        for option, name in (("-o", "walk.stltsa"), ("--coords", "walk.csv")):
            for there in (False, True):
                with self.subTest(option, there=there):
                    path = self.folder / name
                    if there:
                        path.symlink_to("old")
                        (self.folder / "old").write_text("old", encoding="ascii")
                    message = self.fails(
                        1, "fit", walk(), option, path, preexec_fn=let_files_be_small
                    )
                    self.assertIn(f"{path}", message)
                    self.assertNotIn(".tmp", message)
                    self.assertIn("too large", message)
                    if there:
                        path.unlink()
                        (self.folder / "old").unlink()
                    self.assert_empty(self.folder)

    def test_new_file_obeys_the_umask(self):
        path = self.folder / "walk.txt"
        self.done("decompose", walk(), "-o", path, umask=0o027)
        self.assertEqual(path.stat().st_mode & 0o777, 0o640)

    def test_device(self):
        self.assertEqual(
            self.done("decompose", walk(), "-o", "/dev/stdout"), self.done("decompose", walk())
        )
        line = ("decompose", walk(), "-o", self.folder / "x.txt", "--plot")
        figure = self.done(*line, "/dev/stdout")  # the name does not say that it is a figure
        self.assertTrue(figure.startswith(b"<?xml"), figure[:80])
        self.assertEqual(figure, self.done(*line, "-"))


class StandardOutput(CommandTest):
    """"-" is standard output for every file that is written."""

    def test_it_gets_the_bytes_of_the_file(self):
        model, y = self.folder / "m.stltsa", self.folder / "y.csv"
        self.done("fit", walk(), "--dimension", "3", "-o", model)
        self.done("map", model, walk(), "-o", y)
        for suffix, *line in (
            (".svg", "decompose", walk(), "--plot"),
            (".csv", "decompose", walk(), "--phase"),
            (".csv", "fit", walk(), "--coords"),
            (".stltsa", "fit", walk(), "-o"),
            (".csv", "map", model, walk(), "-o"),
            (".bvh", "unmap", model, y, "-o"),
            (".csv", "denoise", walk(), "-o"),
            (".csv", "denoise", walk(), "--curve-out"),
            (".bvh", "synthesize", f"{walk()}:best", "-o"),
        ):
            with self.subTest(line):
                file = self.folder / f"file{suffix}"
                self.done(*line, file)
                result = run(*line, "-", cwd=self.folder)
                self.assertEqual((result.returncode, result.stderr), (0, b""))
                self.assertEqual(result.stdout, file.read_bytes())
                self.assertFalse((self.folder / "-").exists())

    def test_pipes(self):
        model = self.done("fit", walk(), "--dimension", "3", "-o", "-")
        y = self.done("map", "-", walk(), "-o", "-", input=model)
        self.assertEqual(y.count(b"\n"), self.json("info", walk())["clip"]["frames"] + 1)
        loop = self.done("synthesize", walk(), "--loop", "-o", "-")
        self.assertIn(b"standard input: BVH", self.done("info", "-", input=loop))

    def test_it_takes_one_result(self):
        for line in (
            ("decompose", walk(), "--json", "--plot", "-"),
            ("decompose", walk(), "-o", "-", "--plot", "-"),
            ("decompose", walk(), "--phase", "-", "--plot", "-"),
            ("fit", walk(), "--json", "--coords", "-"),
        ):
            self.assertIn("one result", self.fails(2, *line))
        path = self.folder / "x.json"
        self.assertIn(b"<svg", self.done("decompose", walk(), "-o", path, "--plot", "-"))
        self.assertEqual(json.loads(path.read_text())["format"], "stltsa-decomposition/2")

    def test_what_the_table_would_say_goes_to_standard_error(self):
        model, y = self.folder / "m.stltsa", self.folder / "y.npy"
        self.done("fit", walk(), "--dimension", "3", "-o", model)
        self.done("map", model, walk(), "-o", y)
        self.assertIn(b"note: the coordinates carry no rate", run("unmap", model, y, "-o", "-").stderr)
        self.assertEqual(run("unmap", model, y, "-o", "-", "-q").stderr, b"")

    def test_a_folder_for_temporary_files_is_needed_for_clips(self):
        environment = plain_environment(TMPDIR="/nonexistent")
        line = ("synthesize", f"{walk()}:best", "-o", "-")
        self.assertIn("set TMPDIR to a folder",
                      self.fails(1, *line, env=environment))

    def test_places_that_cannot_be_written(self):
        self.assertIn("No such file or directory: create the folder first",
                      self.fails(1, "decompose", walk(), "-o", self.folder / "missing" / "a.json"))
        self.assertIn("Is a directory: give a file in this folder",
                      self.fails(1, "decompose", walk(), "-o", self.folder))

    def test_a_closed_pipe_leaves_no_file(self):
        reader, writer = os.pipe()
        os.close(reader)
        with os.fdopen(writer, "wb") as closed:
            line = ("fit", walk(), "-o", self.folder / "m.stltsa", "--coords", "-")
            self.assertIn("standard output", self.fails(1, *line, stdout=closed))
        self.assert_empty(self.folder)


class Suffixes(CommandTest):
    def test_json_implies_json(self):
        for line in (("decompose", walk()), ("dimension", walk()),
                     ("events", walk(), "--mark", "300=strike")):
            path = self.folder / f"{line[0]}.json"
            self.assertEqual(self.done(*line, "-o", path), b"")
            self.assertEqual(path.read_bytes(), self.done(*line, "--json"))

    def test_others_are_refused(self):
        for suffix in ("", ".md"):
            for command in ("decompose", "dimension"):
                message = self.fails(2, command, walk(), "-o", self.folder / f"u{suffix}")
                self.assertIn("must end in", message)
        self.assertIn("must end in", self.fails(2, "dimension", walk(), "-o", self.folder / "u.csv"))
        self.assertIn("must end in", self.fails(2, "decompose", walk(), "--plot", self.folder / "u"))
        self.assert_empty(self.folder)


class Coordinates(CommandTest):
    def test_npy_and_csv(self):
        for dimension in (1, 3):
            npy, csv = self.folder / "y.npy", self.folder / "y.csv"
            options = ("--dimension", str(dimension), "--coords")
            found = self.json("fit", circle(), *options, npy)
            self.done("fit", circle(), *options, csv)
            array = numpy.load(npy)
            self.assertEqual(array.dtype, numpy.float64)
            self.assertEqual((npy.stat().st_size - array.nbytes) % 64, 0)
            self.assertEqual(array.shape, (found["samples"]["count"], dimension))
            self.assertFalse(numpy.isfortran(array) and dimension > 1)
            heading = csv.read_text(encoding="ascii").splitlines()[0]
            self.assertEqual(heading, ",".join(f"y{i + 1}" for i in range(dimension)))
            text = numpy.loadtxt(csv, delimiter=",", skiprows=1, ndmin=2)
            numpy.testing.assert_array_equal(array, text)
            # Properties of all coordinates: centered, of unit norm.
            numpy.testing.assert_allclose(array.sum(axis=0), 0, atol=1e-9)
            numpy.testing.assert_allclose((array**2).sum(axis=0), 1, rtol=1e-9)

    def test_the_command_reads_what_it_writes(self):
        for name in ("y.npy", "y.csv"):
            path = self.folder / name
            self.done("fit", walk(), "--dimension", "3", "--coords", path)
            found = self.json("info", path)
            self.assertEqual(found["channels"]["count"], 3)


class Quiet(CommandTest):
    def test_warnings_go_to_stderr_unless_seen(self):
        clock = ("fit", walk(), "--neighbors", "5", "--dimension", "1")
        with_json = run(*clock, "--json")
        warnings = json.loads(with_json.stdout)["warnings"]
        self.assertTrue(warnings)
        self.assertIn(b"stltsa: warning: " + warnings[0].encode(), with_json.stderr)
        self.assertEqual(run(*clock, "--json", "-q").stderr, b"")
        table = run(*clock)
        self.assertEqual(table.stderr, b"")
        self.assertIn(b"warning:", table.stdout)


if __name__ == "__main__":
    unittest.main()
