# SPDX-License-Identifier: BSD-3-Clause
"""fit -o, map and unmap: both ways."""

import json
import math
import re
import unittest

import jsonschema
import numpy

from common import SCHEMAS, CommandTest, circle, cut, markers, run, walk, write_csv


class Mapping(CommandTest):
    def model(self, clip, *options):
        path = self.folder / "model.stltsa"
        self.done("fit", clip, "-o", path, *options)
        return path

    def coords(self, name):
        path = self.folder / name
        if name.endswith(".npy"):
            return numpy.load(path)
        rows = numpy.loadtxt(path, delimiter=",", skiprows=1)
        return rows[:, 1:] if path.read_text(encoding="ascii").startswith("time,") else rows

    def check_schema(self, found):
        schema = json.loads((SCHEMAS / "stltsa-mapping-1.schema.json").read_text())
        errors = jsonschema.Draft202012Validator(schema).iter_errors(found)
        self.assertEqual([error.message for error in errors], [])

    def test_a_fitted_clip_gets_its_own_coordinates(self):
        model = self.model(walk(), "--coords", self.folder / "fit.npy", "--dimension", "3")
        found = self.json("map", model, walk(), "-o", self.folder / "map.npy")
        self.check_schema(found)
        fitted, mapped = self.coords("fit.npy"), self.coords("map.npy")
        step = 4  # 120 frames per second, 30 samples
        numpy.testing.assert_array_equal(mapped[::step][: len(fitted)], fitted)
        self.assertEqual(found["rows"], len(mapped))
        self.assertLess(found["beyond"]["share"], 0.05)

    def test_another_motion_is_told(self):
        model = self.model(circle(), "--fps", "30")
        far = write_csv("far.csv", [[50 + math.cos(t), 50.0, 0.0] for t in range(40)])
        found = self.json("map", model, far, "--fps", "30")
        self.assertEqual(found["beyond"]["stretches"], [{"begin": 0, "end": 40}])
        self.assertEqual(found["beyond"]["verdict"], "another motion")
        self.assertIsNone(self.json("map", model, circle(), "--fps", "30")["beyond"]["verdict"])
        told = self.done("map", model, far, "--fps", "30").decode()
        self.assertIn("40 outside", told)
        self.assertRegex(told, r"how far +\d+\.\d times the model's range at the median, as another")
        self.assertNotIn("how far", self.done("map", model, circle(), "--fps", "30").decode())

    def test_markers_in_another_direction_are_near(self):
        model = self.model(markers())
        for path in (markers(), markers(2.0)):
            self.assertLess(self.json("map", model, path)["beyond"]["share"], 0.05)
        self.assertIn("skeleton", self.fails(1, "map", model, walk()))

    def test_rows_in_the_json(self):
        model = self.model(circle(), "--fps", "30")
        found = self.json("map", model, circle(), "--fps", "30", "--curve")
        self.check_schema(found)
        self.assertEqual(len(found["curve"]["coords"]), found["rows"])
        self.assertEqual(found["curve"]["nearest"], list(range(180)))

    def test_poses_come_back(self):
        model = self.model(walk(), "--coords", self.folder / "y.csv", "--dimension", "3")
        poses = self.folder / "poses.bvh"
        found = self.json("unmap", model, self.folder / "y.csv", "-o", poses)
        self.check_schema(found)
        source, made = self.json("info", walk()), self.json("info", poses)
        self.assertEqual(made["clip"]["frames"], found["rows"])
        self.assertEqual(made["clip"]["fps"], 30)
        self.assertEqual(made["joints"], source["joints"])
        self.done("map", model, poses, "-o", self.folder / "again.csv")
        fitted, again = self.coords("y.csv"), self.coords("again.csv")
        error = numpy.sqrt(((fitted - again) ** 2).mean(axis=0)) / fitted.std(axis=0)
        self.assertLess(error.max(), 0.2)  # poses are smoothed once more

    def test_poses_take_as_long_as_the_points(self):
        """The points of a clip have its rate, not that of the model's samples."""
        model = self.model(walk(), "--dimension", "3")
        points, poses = self.folder / "y.npy", self.folder / "poses.bvh"
        mapped = self.json("map", model, walk(), "-o", points)
        self.assertEqual(mapped["fps"], 120)
        seconds = f"{mapped['rows']}, 120 per second ({mapped['rows'] / 120:.2f} s)"
        self.assertIn(seconds, self.done("map", model, walk()).decode())
        text = self.done("unmap", model, points, "--fps", "120", "-o", poses).decode()
        self.assertIn(seconds, text)
        made, source = self.json("info", poses)["clip"], self.json("info", walk())["clip"]
        self.assertEqual((made["frames"], made["fps"]), (source["frames"], 120))
        for product, flags, rate in (
            ("poses.bvh", (), 30),  # the rate of the samples, because the file has none
            ("x.csv", (), 30),
            ("x.csv", ("--fps", "120"), 120),
        ):
            found = self.json("unmap", model, points, "-o", self.folder / product, *flags)
            self.assertEqual(found["fps"], rate)
            self.assertEqual(["taken as 30 per second" in note for note in found["notes"]],
                             [] if flags else [True])
            self.check_schema(found)

    def test_points_with_a_time(self):
        model = self.model(walk(), "--dimension", "3")
        self.done("map", model, walk(), "-o", self.folder / "y.npy")
        rows = [[i / 60, *row] for i, row in enumerate(self.coords("y.npy")[::2])]
        timed = self.folder / "timed.csv"
        numpy.savetxt(timed, rows, delimiter=",", header="time,y1,y2,y3", comments="")
        found = self.json("unmap", model, timed, "-o", self.folder / "poses.bvh")
        self.assertAlmostEqual(found["fps"], 60, delta=1e-6)

    def test_coordinates_keep_their_rate(self):
        model = self.model(walk(), "--dimension", "3")
        points, poses = self.folder / "mapped.csv", self.folder / "again.bvh"
        self.done("map", model, walk(), "-o", points)
        self.done("unmap", model, points, "-o", poses)
        made, source = self.json("info", poses)["clip"], self.json("info", walk())["clip"]
        self.assertEqual(made["frames"], source["frames"])
        self.assertAlmostEqual(made["fps"], source["fps"], delta=1e-3)

    def test_a_clip_without_a_rate(self):
        clip = self.folder / "still.bvh"
        text = walk().read_text(encoding="ascii")
        clip.write_text(re.sub("Frame Time: .*", "Frame Time: 0", text), encoding="ascii")
        points, poses = self.folder / "y.npy", self.folder / "poses.bvh"
        model = self.model(clip, "--dimension", "3", "--neighbors", "40", "--coords", points)
        self.assertIn("rate unknown", self.done("map", model, clip).decode())
        self.assertIn("--fps", self.fails(1, "unmap", model, points, "-o", poses))
        self.done("unmap", model, points, "--fps", "120", "-o", poses)
        self.assertEqual(self.json("info", poses)["clip"]["fps"], 120)

    def test_a_clip_without_the_rate_that_the_model_has(self):
        model = self.model(circle(), "--fps", "30")
        self.assertEqual(self.json("map", model, circle(), "--fps", "30")["warnings"], [])
        [warning] = self.json("map", model, circle())["warnings"]
        self.assertIn("not smoothed", warning)
        self.assertIn("--fps", warning)
        self.assertIn("not smoothed", " ".join(self.done("map", model, circle()).decode().split()))

    def test_frames_come_back(self):
        model = self.model(circle(), "--fps", "30", "--coords", self.folder / "y.npy")
        self.done("unmap", model, self.folder / "y.npy", "-o", self.folder / "x.csv")
        numbers = numpy.loadtxt(circle(), delimiter=",")
        self.assertLess(numpy.abs(self.coords("x.csv") - numbers).max(), 0.1)

    def test_one_coordinate_needs_to_follow(self):
        """Forward and backward swings look the same in one coordinate; following the last row
        helps."""
        model = self.model(
            circle(), "--fps", "30", "--dimension", "1", "--coords", self.folder / "y.npy"
        )
        numbers = numpy.loadtxt(circle(), delimiter=",")
        between = (self.coords("y.npy")[1:] + self.coords("y.npy")[:-1]) / 2
        numpy.save(self.folder / "between.npy", between)
        errors = []
        for flags in ((), ("--follow",)):
            path = self.folder / "x.csv"
            self.done("unmap", model, self.folder / "between.npy", "-o", path, *flags)
            wrong = self.coords("x.csv") - (numbers[1:] + numbers[:-1]) / 2
            errors.append(numpy.sqrt((wrong**2).mean()))
        self.assertLess(errors[1], 0.5 * errors[0])

    def test_a_model_from_standard_input(self):
        model = self.model(circle(), "--fps", "30")
        found = self.json("map", "-", circle(), input=model.read_bytes())
        self.check_schema(found)
        self.assertIsNone(found["model"]["path"])
        self.assertEqual(found["distance"], self.json("map", model, circle())["distance"])
        text = self.done("map", "-", circle(), input=model.read_bytes()).decode()
        self.assertIn("on standard input", text)
        self.assertIn("one file", self.fails(2, "map", "-", "-", input=model.read_bytes()))

    def test_columns_say_what_they_are(self):
        model = self.model(circle(), "--fps", "30", "--coords", self.folder / "y.csv")
        self.done("unmap", model, self.folder / "y.csv", "-o", self.folder / "x.csv")
        self.done("map", model, circle(), "-o", self.folder / "again.csv")
        for name, heading in (("x.csv", "feature1,feature2,feature3"), ("again.csv", "y1,y2")):
            text = (self.folder / name).read_text(encoding="ascii")
            self.assertEqual(text.splitlines()[0], heading)

    def test_capitals_in_suffixes(self):
        model = self.model(walk(), "--dimension", "3", "--coords", self.folder / "y.NPY")
        self.assertEqual(numpy.load(self.folder / "y.NPY").shape[1], 3)
        self.done("unmap", model, self.folder / "y.NPY", "-o", self.folder / "poses.BVH")
        self.assertTrue((self.folder / "poses.BVH").read_bytes().startswith(b"HIERARCHY"))

    def test_numbers_beyond_measure(self):
        model = self.model(circle(), "--fps", "30")
        far = write_csv("beyond.csv", [[1e200, 0.0, 0.0]] * 3)
        self.assertIn("column 0", self.fails(3, "map", model, far))

    def test_wrong_use(self):
        model = self.model(circle(), "--fps", "30")
        self.assertIn("not a model", self.fails(3, "map", circle(), circle()))
        self.assertIn("absent", self.fails(3, "map", "absent.stltsa", circle()))
        self.fails(2, "map", model, circle(), "-o", self.folder / "y.txt")
        self.fails(2, "unmap", model, circle())
        self.fails(2, "unmap", model, circle(), "-o", self.folder / "x.png")
        self.assertIn("columns", self.fails(1, "unmap", model, circle(), "-o", self.folder / "x.csv"))
        self.assertIn("skeleton", self.fails(2, "unmap", model, walk(), "-o", self.folder / "x.csv"))
        self.done("fit", circle(), "--fps", "30", "--coords", self.folder / "y.csv")
        message = self.fails(1, "unmap", model, self.folder / "y.csv", "-o", self.folder / "x.bvh")
        self.assertIn("without a skeleton", message)
        self.assertIn(".csv or .npy", message)
        self.assertNotIn("stltsa_", message)
        self.assertIn("--follow", self.fails(2, "unmap", model, self.folder / "y.csv", "-o",
                                             self.folder / "x.csv", "--hint-window", "3"))
        for name in ("m.bvh", "m"):
            self.assertIn(".stltsa", self.fails(2, "fit", circle(), "-o", name, cwd=self.folder))
        two = write_csv("two.csv", [[0.0, float(i)] for i in range(40)])
        self.assertIn("features", self.fails(1, "map", model, two, "--fps", "30"))

    def test_pieces_need_a_choice(self):
        path = self.folder / "model.stltsa"
        options = ("--neighbors", "5", "--window", "8")
        self.assertEqual(run("fit", cut(), "-o", path, *options).returncode, 4)
        points = write_csv("points.csv", [[0.01, 0.01]])
        message = self.fails(4, "unmap", path, points, "-o", self.folder / "x.csv")
        self.assertIn("component", message)
        self.done("unmap", path, points, "-o", self.folder / "x.csv", "--component", "1")
        self.assertGreater(self.coords("x.csv")[0], 500)


if __name__ == "__main__":
    unittest.main()
