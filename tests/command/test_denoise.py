# SPDX-License-Identifier: BSD-3-Clause
"""denoise of clips, models and plain coordinates: output, messages and figures."""

import subprocess
import unittest

import numpy

from common import CLIPS, WALKER, CommandTest, circle, cut, run, walk, write_csv



def noisy_walk():
    path = CLIPS / "noisy.bvh"
    if not path.exists():
        subprocess.run([WALKER, "-o", path, "--noise", "3", "--seed", "4"], check=True)
    return path


def table(path):
    return numpy.loadtxt(path, delimiter=",", skiprows=1, ndmin=2)


class Denoise(CommandTest):
    def denoised(self, *arguments):
        """Returns (JSON, points, curve, cleaned) of a run."""
        found = self.json("denoise", *arguments, "--curve")
        curve = found.pop("curve")
        return found, *(numpy.array(curve[name]) for name in ("points", "fitted", "cleaned"))

    def test_equation_1(self):
        for options in ((), ("--gamma", "0.004"), ("--gamma", "0", "--no-robust")):
            found, points, curve, cleaned = self.denoised(noisy_walk(), "--smoothing", "0", *options)
            for c, column in enumerate(found["columns"]):
                away = points[:, c] - curve[:, c]
                noisy = abs(away) > column["gamma"]
                self.assertEqual(column["moved"], noisy.sum())
                self.assertAlmostEqual(column["shift"], abs(away[noisy]).mean())
                left = numpy.maximum(abs(away) - column["shift"], 0) * numpy.sign(away)
                expected = numpy.where(noisy, curve[:, c] + left, points[:, c])
                numpy.testing.assert_allclose(cleaned[:, c], expected, atol=1e-12)
            self.assertEqual(found["parameters"]["robust"], "--no-robust" not in options)

    def test_a_clean_clip_has_nothing_to_clean(self):
        path = self.folder / "noisy.bvh"
        subprocess.run([WALKER, "-o", path, "--fps", "30", "--noise", "6"], check=True)
        clean, noisy = (self.done("denoise", clip).decode() for clip in (walk(), path))
        self.assertRegex(clean, r"nothing to clean: the noise is 0\.\d+ % of the range")
        self.assertNotIn("nothing to clean", noisy)
        self.assertRegex(" ".join(noisy.split()), r"; the noise is \d\.\d+ % of the range")
        for clip, verdict in ((walk(), True), (path, False)):
            found, _, curve, _ = self.denoised(clip)
            self.assertEqual(found["nothing_to_clean"], verdict)
            for column, values in zip(found["columns"], curve.T):
                share = column["noise"] / (values.max() - values.min())
                self.assertAlmostEqual(column["noise_share"], share)

    def test_the_curve_is_nearer_the_truth(self):
        options = ("--dimension", "1", "--smoothing", "0", "--neighbors", "40")
        _, truth, _, _ = self.denoised(walk(), *options)
        _, points, curve, cleaned = self.denoised(noisy_walk(), *options)

        def away(y):
            return numpy.sqrt(((y - truth) ** 2).mean())

        points, curve, cleaned = (y * numpy.sign((points * truth).sum())
                                  for y in (points, curve, cleaned))
        self.assertLess(away(curve), 0.95 * away(points))
        self.assertLess(away(cleaned), 0.98 * away(points))

    def test_files_are_what_json_says(self):
        _, _, curve, cleaned = self.denoised(noisy_walk())
        for suffix, load in ((".csv", table), (".npy", numpy.load)):
            out, curve_out = self.folder / f"a{suffix}", self.folder / f"b{suffix}"
            text = self.done("denoise", noisy_walk(), "-o", out, "--curve-out", curve_out)
            self.assertIn(b"moved", text)
            numpy.testing.assert_array_equal(load(out), cleaned)
            numpy.testing.assert_array_equal(load(curve_out), curve)

    def test_model_coordinates_and_clip_agree(self):
        model, coords = self.folder / "m.stltsa", self.folder / "y.npy"
        options = ("--dimension", "3")
        self.done("fit", noisy_walk(), "-o", model, "--coords", coords, *options)
        of_clip, points, curve, _ = self.denoised(noisy_walk(), *options)
        of_model, _, same_curve, _ = self.denoised(model)
        self.assertEqual(of_clip, of_model)
        numpy.testing.assert_array_equal(curve, same_curve)
        knots = str(of_clip["parameters"]["knot_s"])
        of_coords, same_points, close_curve, _ = self.denoised(
            coords, "--coordinates", "--fps", "30", "--knot-spacing", knots
        )
        numpy.testing.assert_array_equal(points, same_points)
        numpy.testing.assert_allclose(curve, close_curve, atol=1e-9)
        self.assertIsNone(of_coords["fit"])
        self.assertEqual(of_coords["clip"]["path"], str(coords))

    def test_period_sets_the_knots(self):
        found, *_ = self.denoised(circle(), "--coordinates", "--fps", "50")
        self.assertAlmostEqual(found["period_s"], 60 / 50, delta=0.03)
        self.assertAlmostEqual(found["parameters"]["knot_rows"], 6, delta=0.2)
        unknown, *_ = self.denoised(circle(), "--coordinates")
        self.assertIsNone(unknown["period_s"])  # but it is looked for in rows
        self.assertAlmostEqual(unknown["parameters"]["knot_rows"], 6, delta=0.2)

    def test_the_period_is_the_fits(self):
        """The period is the model's, not one found again in the coordinates."""
        self.assertEqual(
            self.json("denoise", walk())["period_s"], self.json("fit", walk())["period_s"]
        )

    def test_pieces_have_curves_of_their_own(self):
        found = self.json("denoise", cut(), "--neighbors", "5", "--window", "8")
        self.assertEqual(found["samples"]["lengths"], [60, 60])

    def test_frames_of_the_source(self):
        found = self.json("denoise", noisy_walk(), "--curve")
        self.assertEqual(found["curve"]["frames"][:3], [0, 4, 8])

    def test_table_says_what_the_json_says(self):
        found = self.json("denoise", noisy_walk())
        text = self.done("denoise", noisy_walk()).decode("ascii")
        moved = sum(column["moved"] for column in found["columns"])
        points = 2 * found["samples"]["count"]
        self.assertIn(f"{moved} of {points} points moved", " ".join(text.split()))
        for c, column in enumerate(found["columns"]):
            row = next(l.split() for l in text.splitlines() if l.split()[:1] == [str(c + 1)])
            self.assertEqual(int(row[3]), column["moved"])
            for shown, name in ((row[1], "noise"), (row[2], "gamma"), (row[4], "shift")):
                self.assertAlmostEqual(float(shown) / column[name], 1, delta=1e-3)

    def test_a_model_from_standard_input(self):
        model = self.folder / "m.stltsa"
        self.done("fit", walk(), "-o", model)
        self.assertEqual(
            self.json("denoise", "-", input=model.read_bytes()), self.json("denoise", model)
        )
        self.fails(3, "denoise", "-", input=b"\x89STLTSA\nand nothing")

    def test_options_that_would_change_nothing(self):
        model = self.folder / "m.stltsa"
        self.done("fit", circle(), "--fps", "30", "-o", model)
        for flag, value in (("--dimension", "1"), ("--neighbors", "5"), ("--fps", "30")):
            self.assertIn(flag, self.fails(2, "denoise", model, flag, value))
        self.assertIn("--coordinates", self.fails(2, "denoise", model, "--coordinates"))
        self.assertIn(
            "--dimension", self.fails(2, "denoise", circle(), "--coordinates", "--dimension", "1")
        )
        self.done("denoise", model, "--gamma", "0.1", "--knot-spacing", "0.2", "--no-robust")

    def test_refusals(self):
        self.assertIn(".npy, .csv", self.fails(2, "denoise", walk(), "-o", "y.txt"))
        self.assertIn(".npy, .csv", self.fails(2, "denoise", walk(), "--curve-out", "y.svg"))
        self.assertIn("--coordinates", self.fails(2, "denoise", walk(), "--coordinates"))
        self.assertIn("gamma", self.fails(2, "denoise", walk(), "--gamma", "-3"))
        self.assertIn("from 0 to", self.fails(2, "denoise", walk(), "--gamma", "-0.5"))
        short = write_csv("short.csv", [[1.0, 2.0]] * 7)
        self.assertIn("8", self.fails(4, "denoise", short, "--coordinates"))
        missing = self.folder / "missing.stltsa"
        self.fails(3, "denoise", missing)
        garbage = self.folder / "garbage.stltsa"
        garbage.write_bytes(b"no model")
        self.assertIn("garbage.stltsa", self.fails(3, "denoise", garbage))

    def test_warnings_of_the_fit(self):
        result = run("denoise", walk(), "--neighbors", "5", "--dimension", "1", "--json")
        self.assertIn(b"follows time", result.stderr)


if __name__ == "__main__":
    unittest.main()
