# SPDX-License-Identifier: BSD-3-Clause
"""synthesize: the syntax of pieces, and the new clips."""

import json
import math
import unittest

import jsonschema

from common import SCHEMAS, CommandTest, circle, drift, walk


SKELETON = """:version 1.10
:name small
:units
  length 0.45
  angle deg
:root
  order TX TY TZ RX RY RZ
  axis XYZ
  position 0 0 0
  orientation 0 0 0
:bonedata
  begin
    id 1
    name thigh
    direction 0.6 -0.8 0
    length 10
    axis 0 0 20 XYZ
    dof rx ry rz
  end
  begin
    id 2
    name shank
    direction 0 -1 0
    length 5
    axis 0 90 0 XYZ
    dof rx
  end
:hierarchy
  begin
    root thigh
    thigh shank
  end
"""


def swings(frames):
    """An AMC clip of a leg that swings once in a hundred frames."""
    lines = [":FULLY-SPECIFIED", ":DEGREES"]
    for i in range(frames):
        s, c = (round(f(math.tau * i / 100), 6) for f in (math.sin, math.cos))
        lines += [str(i + 1), f"root {0.1 * i} 15 0 0 0 0", f"thigh {30 * s} {5 * c} 0"]
        lines.append(f"shank {20 - 20 * c}")
    return "\n".join(lines) + "\n"


class Synthesize(CommandTest):
    def made(self, *pieces):
        """The JSON about a new clip, and that of the clip itself."""
        path = self.folder / "made.bvh"
        found = self.json("synthesize", *pieces, "-o", path)
        schema = json.loads((SCHEMAS / "stltsa-synthesis-1.schema.json").read_text())
        errors = jsonschema.Draft202012Validator(schema).iter_errors(found)
        self.assertEqual([error.message for error in errors], [])
        info = self.json("info", path)["clip"]
        self.assertEqual(info["frames"], found["clip"]["frames"])
        self.assertEqual(info["fps"], 120)
        return found, info

    def units(self):
        return self.json("decompose", walk())

    def test_units_give_the_clip_back(self):
        pieces = [f"{walk()}:{unit['kind']}" for unit in self.units()["units"]]
        found, _ = self.made(*pieces)
        self.assertEqual(found["seams"], [])
        made = (self.folder / "made.bvh").read_text().split("MOTION")[1].split()
        source = walk().read_text().split("MOTION")[1].split()
        self.assertEqual([float(x) for x in made[5:]], [float(x) for x in source[5:]])

    def test_the_hierarchy_is_the_sources(self):
        """Joints, offsets, channel order and frame time are as in the file, digit for digit."""
        source = self.folder / "source.bvh"
        text = walk().read_text()
        frame_time = next(line for line in text.splitlines() if line.startswith("Frame Time"))
        source.write_text(text.replace(frame_time, "Frame Time: 0.0083333"))
        made = self.folder / "made.bvh"
        self.done("synthesize", f"{source}:best*2", "-o", made)

        def header(path):
            hierarchy, motion = path.read_text().split("MOTION")
            words = hierarchy.split()
            return [float(w) if w.lstrip("-")[:1].isdigit() else w for w in words], motion.split()

        self.assertEqual(header(made)[0], header(source)[0])
        self.assertEqual(header(made)[1][4], "0.0083333")

    def test_amc_from_amc(self):
        (self.folder / "7.asf").write_text(SKELETON)
        source = self.folder / "7_01.amc"
        source.write_text(swings(300))
        made = self.folder / "7_02.amc"
        found = self.json("synthesize", f"{source}:100-200*3", "-o", made)
        self.assertEqual(found["clip"]["format"], "amc")
        for seam in found["seams"]:
            self.assertLess(seam["step"], 1.05)
        self.assertEqual(self.json("info", made)["clip"]["frames"], found["clip"]["frames"])
        self.done("synthesize", f"{source}:0-120", f"{source}:120-300", "-o", made)

        def numbers(path):
            return [float(w) for w in path.read_text().split() if w[-1].isdigit()]

        self.assertEqual(numbers(made), numbers(source))

    def test_amc_has_its_skeleton_beside_it(self):
        skeleton, source = self.folder / "7.asf", self.folder / "7_01.amc"
        skeleton.write_text(SKELETON)
        source.write_text(swings(300))
        model, coords = self.folder / "m.stltsa", self.folder / "c.csv"
        self.done("fit", source, "-o", model)
        self.done("map", model, source, "-o", coords)
        out = self.folder / "out"
        out.mkdir()
        made, poses = out / "made.amc", out / "poses.amc"
        for _ in range(2):  # the second time, the same skeleton is there
            self.done("synthesize", f"{source}:0-150", f"{source}:150-300", "-o", made)
            self.done("unmap", model, coords, "-o", poses)
        names = ["made.amc", "made.asf", "poses.amc", "poses.asf"]
        self.assertEqual(sorted(p.name for p in out.iterdir()), names)
        for clip in (made, poses):
            self.assertEqual(clip.with_suffix(".asf").read_text(), SKELETON)
            self.json("info", clip)
        answers = [self.json("decompose", clip) for clip in (made, source)]
        for answer in answers:
            del answer["clip"]
        self.assertEqual(*answers)

        made.unlink()
        made.with_suffix(".asf").write_text("another")
        message = self.fails(1, "synthesize", f"{source}:0-150", "-o", made)
        self.assertIn("made.asf: exists and is another skeleton", message)
        self.assertEqual(made.with_suffix(".asf").read_text(), "another")
        self.assertEqual(sorted(p.name for p in out.iterdir()), names[1:])

    def test_a_cycle_again_and_again(self):
        cycle = self.units()["best_cycle"]
        length = cycle["end"] - cycle["begin"]
        found, _ = self.made(f"{walk()}:best*4")
        self.assertEqual(len(found["seams"]), 3)
        self.assertAlmostEqual(found["clip"]["frames"], 4 * length, delta=0.4 * length)
        for seam in found["seams"]:
            self.assertLess(seam["step"], 1.4)

    def test_a_loop_of_all_cycles(self):
        """In the JSON, the table and the picture; with and without travel."""
        cycles = self.units()["cycles"]
        found, _ = self.made(walk(), "--loop")
        self.assertEqual([seam["wrap"] for seam in found["seams"]], [True])
        self.assertEqual(found["seams"][0]["frame"], found["clip"]["frames"])
        loop = found["loop"]
        self.assertEqual((loop["cycles"], loop["source_cycles"]), (len(cycles), len(cycles)))
        self.assertEqual((loop["coverage"], loop["in_place"]), (1, False))
        self.assertAlmostEqual(loop["distance"], math.hypot(*loop["travel"]), delta=1e-9)
        self.assertGreater(loop["distance"], 100)

        def way():
            motion = (self.folder / "made.bvh").read_text().split("MOTION")[1].splitlines()[3:]
            first, last = ([float(x) for x in line.split()[:3]] for line in (motion[0], motion[-1]))
            return math.hypot(last[0] - first[0], last[2] - first[2])

        going = way()
        self.assertGreater(going, 0.9 * loop["distance"])
        standing, _ = self.made(walk(), "--loop", "--in-place")
        self.assertTrue(standing["loop"]["in_place"])
        self.assertEqual(standing["loop"]["travel"], loop["travel"])
        self.assertLess(way(), 0.05 * going)

        text = self.done("synthesize", walk(), "--loop", "-o", self.folder / "x.bvh").decode()
        self.assertIn("wrap", text)
        self.assertIn(f"loop: {len(cycles)} of {len(cycles)} cycles (100 %); travel", text)

    def test_loops_of_pieces(self):
        found, _ = self.made(f"{walk()}:best*3", "--loop")
        self.assertEqual([seam["wrap"] for seam in found["seams"]], [False, False, True])
        self.assertIsNone(found["loop"]["cycles"])
        self.assertIsNone(self.made(f"{walk()}:best*3")[0]["loop"])
        out = self.folder / "y.bvh"
        message = self.fails(2, "synthesize", f"{walk()}:best", "-o", out, "--in-place")
        self.assertIn("--loop", message)

    def test_pieces_by_frames_and_seconds(self):
        frames, _ = self.made(f"{walk()}:120-480")
        self.assertEqual(frames["clip"]["frames"], 360)
        seconds, _ = self.made(f"{walk()}:1.0s-4.0s")
        self.assertEqual(seconds["clip"]["frames"], 360)
        self.assertEqual(seconds["pieces"][0]["begin"], 120)

    def test_cycles_by_number(self):
        found, _ = self.made(f"{walk()}:cycle1", f"{walk()}:cycle3")
        self.assertEqual(len(found["pieces"]), 2)
        out = self.folder / "x.bvh"
        self.assertIn("there are 3 cycles", self.fails(4, "synthesize", f"{walk()}:cycle9", "-o", out))

    def test_the_table_names_the_pieces(self):
        piece = f"{walk()}:best*2"
        text = self.done("synthesize", piece, "-o", self.folder / "x.bvh").decode()
        self.assertIn("1 seam", text)
        self.assertIn("best*2", text)

    def test_a_long_name_is_shown_once(self):
        name = 150 * "n" + ".bvh"
        clip = self.folder / name
        clip.symlink_to(walk())
        pieces = [f"{clip}:{what}" for what in ("initial", "cycle1*5", "final")]
        text = self.done("synthesize", *pieces, "-o", self.folder / "x.bvh").decode()
        self.assertEqual(text.count(name), 1)
        self.assertIn("1  " + name + ":initial\n", text)
        self.assertIn("\n  2  :cycle1*5\n  3  :final\n", text)
        self.assertEqual([line.split()[2:4] for line in text.splitlines()[9:13]],
                         [["2", "2"], ["more", "like"], ["2", "2"], ["2", "3"]])

    def test_equal_seams_are_folded(self):
        text = self.done("synthesize", f"{walk()}:best*300", "-o", self.folder / "x.bvh").decode()
        self.assertIn("  ... 297 more like these\n", text)
        self.assertLess(text.count("\n"), 15)
        self.assertLessEqual(max(map(len, text.splitlines())), 80)
        short = self.done("synthesize", f"{walk()}:best*4", "-o", self.folder / "x.bvh").decode()
        self.assertNotIn("more like", short)

    def test_what_cannot_be_written_is_told_first(self):
        """Fails before any result; fails() checks that nothing was printed."""
        message = self.fails(1, "synthesize", f"{walk()}:0-100", "-o", self.folder / "o.amc")
        self.assertIn("AMC", message)
        self.assert_empty(self.folder)

    def test_files_keep_their_mode_and_links(self):
        path, link = self.folder / "o.dat", self.folder / "o.bvh"
        path.write_text("old", encoding="ascii")
        path.chmod(0o640)
        link.symlink_to(path)
        self.done("synthesize", f"{walk()}:0-100", "-o", link)
        self.assertTrue(link.is_symlink())
        self.assertEqual(path.stat().st_mode & 0o777, 0o640)
        self.assertTrue(path.read_text(encoding="ascii").startswith("HIERARCHY"))

    def test_no_common_posture(self):
        out = self.folder / "x.bvh"
        message = self.fails(
            4, "synthesize", f"{walk()}:0-150", f"{walk()}:330-400", "-o", out, "--cut-range", "0",
            "--posture-limit", "0.001"
        )
        self.assertIn("raise --cut-range or --posture-limit", " ".join(message.split()))
        self.assert_empty(self.folder)

    def test_wrong_use(self):
        out = self.folder / "x.bvh"
        self.fails(2, "synthesize", walk())
        self.fails(2, "synthesize", walk(), "-o", self.folder / "x.svg")
        self.assertIn("'bset'", self.fails(2, "synthesize", f"{walk()}:bset", "-o", out))
        self.assertIn("at least 1", self.fails(2, "synthesize", f"{walk()}*0", "-o", out))
        self.fails(2, "synthesize", f"{walk()}:500-400", "-o", out)
        for beyond in ("0-100000", "0s-999999999s", "844-", "400-400"):
            message = self.fails(2, "synthesize", f"{walk()}:{beyond}", "-o", out)
            self.assertIn("must have at least one frame, all within the", message)
        for nothing in ("cycle0", "0s-nans", "0s-1e300s", "-", "infs-infs", "cycle+1"):
            message = self.fails(2, "synthesize", f"{walk()}:{nothing}", "-o", out)
            self.assertIn(f"'{nothing}'", message)
        self.fails(3, "synthesize", "absent.bvh", "-o", out)
        message = self.fails(1, "synthesize", circle(), "-o", self.folder / "x.csv", "--fps", "30")
        self.assertIn("skeleton", message)
        reason = self.fails(4, "synthesize", f"{drift()}:best", "-o", out, "--fps", "30")
        self.assertIn("does not repeat at any lag", reason)
        self.assertFalse(out.exists())


if __name__ == "__main__":
    unittest.main()
