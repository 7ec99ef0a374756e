# SPDX-License-Identifier: BSD-3-Clause
"""stltsa events: a mark is found in every cycle and in other clips."""

import csv
import json
import io
import time
import unittest

from common import CommandTest, cut, walk


class Events(CommandTest):
    def test_json_csv_and_table_agree(self):
        line = ("events", walk(), "--mark", "250=strike", "--mark", "2.5s=off, left")
        found = self.json(*line)
        self.assertEqual({e["name"] for e in found["events"]}, {"strike", "off, left"})
        frames = [e["frame"] for e in found["events"]]
        self.assertEqual(frames, sorted(frames))
        marked = {e["name"]: e["frame"] for e in found["events"] if e["marked"]}
        self.assertEqual(marked, {"strike": 250, "off, left": 300})
        self.done(*line, "-o", self.folder / "events.csv")
        rows = list(csv.DictReader(io.StringIO((self.folder / "events.csv").read_text())))
        self.assertEqual([float(row["frame"]) for row in rows], frames)
        self.assertEqual([row["name"] for row in rows], [e["name"] for e in found["events"]])
        self.assertEqual([row["cycle"] or None for row in rows],
                         [None if e["cycle"] is None else str(e["cycle"]) for e in found["events"]])
        self.assertEqual({e["name"]: e["side"] for e in found["events"]},
                         {"strike": None, "off, left": "left"})
        self.assertEqual([row["side"] or None for row in rows],
                         [e["side"] for e in found["events"]])
        table = self.done(*line).decode()
        self.assertEqual(table.count("strike"), sum(e["name"] == "strike" for e in found["events"]))

    def test_cycles_are_those_of_decompose(self):
        cycles = self.json("decompose", walk())["cycles"]
        for event in self.json("events", walk(), "--mark", "250=strike")["events"]:
            inside = [i for i, c in enumerate(cycles) if c["begin"] <= event["frame"] < c["end"]]
            self.assertEqual(event["cycle"], inside[0] if inside else None)

    def test_other_clips(self):
        other = f"{walk()}:170-600"
        found = self.json("events", walk(), other, "--mark", "250=strike")
        self.assertEqual([s["clip"] for s in found["searches"]], [str(walk()), other])
        there = [e for e in found["events"] if e["clip"] == other and e["cycle"] is not None]
        self.assertGreaterEqual(len(there), 2)
        for event in there:
            turns = (event["frame"] + 170 - 250) / 132
            self.assertAlmostEqual(turns, round(turns), delta=0.02)
            self.assertFalse(event["marked"])

    def test_a_clip_without_the_motion_has_no_events(self):
        still = f"{walk()}:0-40"
        found = self.json("events", walk(), still, "--mark", "250=strike")
        self.assertEqual([e for e in found["events"] if e["clip"] == still], [])
        self.assertIn("no motion like the marked one", found["warnings"][0])

    def test_what_is_written_is_read_as_labels(self):
        table = self.folder / "events.csv"
        line = ("events", walk(), "--mark", "250=strike", "--mark", "300=off, left")
        self.done(*line, f"{walk()}:170-600", "-o", table)
        found = [e for e in self.json(*line)["events"] if e["cycle"] is not None]
        again = self.json("events", walk(), "--mark", table)
        inside = [e for e in again["events"] if e["cycle"] is not None]
        self.assertEqual([e["name"] for e in inside], [e["name"] for e in found])
        for one, other in zip(inside, found, strict=True):
            self.assertTrue(one["marked"])
            self.assertAlmostEqual(one["frame"], other["frame"], delta=1e-6)

    def test_labels_of_bids_and_boris(self):
        tables = {"a_events.tsv": "onset\tduration\ttrial_type\n2.1\t0\tstrike\n0.1\t0\trest\n",
                  "b.csv": "Observation id,Behavior,Behavior type,Time\r\n"
                           "w,strike,START,2.1\r\nw,strike,STOP,2.5\r\nw,rest,POINT,0.1\r\n",
                  "excel.csv": "\ufeffonset,trial_type\n2.1,strike\n0.1,rest\n"}
        typed = self.json("events", walk(), "--mark", "2.1s=strike")["events"]
        for name, text in tables.items():
            path = self.folder / name
            path.write_text(text)
            found = self.json("events", walk(), "--mark", path)
            self.assertEqual(found["events"], typed)
            self.assertIn("rest is left out: none of its labels is in a motion that repeats",
                          found["warnings"][0])

    def test_a_label_file_with_an_equals_sign_in_its_name(self):
        path = self.folder / "a=b.csv"
        path.write_text("onset,trial_type\n2.1,strike\n")
        for given in (path, path.name):
            line = ("events", walk(), "--mark", given, "--json")
            found = json.loads(self.done(*line, cwd=self.folder))
            self.assertEqual({event["name"] for event in found["events"]}, {"strike"})
        found = self.json("events", walk(), "--mark", "250=b.csv")["events"]
        self.assertEqual({event["name"] for event in found}, {"b.csv"})

    def test_a_name_that_looks_like_a_formula(self):
        path = self.folder / "events.csv"
        self.done("events", walk(), "--mark", "250==SUM(1)", "-o", path)
        self.assertIn(",'=SUM(1),", path.read_text())
        again = self.json("events", walk(), "--mark", path)["events"]
        self.assertEqual({e["name"] for e in again}, {"=SUM(1)"})

    def test_seconds_of_a_recording_do_not_fit_a_stretch(self):
        path = self.folder / "labels.tsv"
        path.write_text("onset\ttrial_type\n2.1\tstrike\n")
        stretch = f"{walk()}:1.5s-5s"
        self.assertIn("is a stretch of it", self.fails(2, "events", stretch, "--mark", path))
        path.write_text(f"clip\tname\tseconds\n{stretch}\tstrike\t0.6\n")
        self.json("events", stretch, "--mark", path)

    def test_labels_in_a_rest_are_left_out_of_many(self):
        rows = [f"{0.1 if i == 0 else 2.1 + 0.001 * i}\tstrike" for i in range(300)]
        path = self.folder / "many.tsv"
        path.write_text("\n".join(["onset\ttrial_type", *rows, ""]))
        began = time.monotonic()
        found = self.json("events", walk(), "--mark", path)
        many = time.monotonic() - began
        self.assertEqual(sum(event["marked"] for event in found["events"]), 299)
        self.assertIn("strike: 1 of 300 labels are left out", " ".join(found["warnings"]))
        began = time.monotonic()
        self.json("events", walk(), "--mark", "2.1s=strike")
        self.assertLess(many, 60 * (time.monotonic() - began))  # 299 searches take longer

    def test_files_that_hold_no_labels(self):
        path = self.folder / "other.csv"
        path.write_text("x,y\n1,2\n")
        self.assertIn("a column of seconds", self.fails(3, "events", walk(), "--mark", path))
        path.write_text("clip,name,seconds\nanother.bvh,strike,2.1\n")
        self.assertIn("no labels for the clip", self.fails(3, "events", walk(), "--mark", path))
        absent = self.folder / "absent.tsv"
        self.assertIn("cannot read", self.fails(3, "events", walk(), "--mark", absent))
        self.assertIn("cannot open", self.fails(3, "events", walk(), "--mark", "walk.c3d"))
        (self.folder / "tables.csv").mkdir()
        self.assertIn("a folder",
                      self.fails(3, "events", walk(), "--mark", self.folder / "tables.csv"))

    def test_a_name_without_a_side_keeps_none(self):
        found = self.json("events", walk(), "--mark", "250=upright", "--both-sides")["events"]
        self.assertEqual({(e["name"], e["side"]) for e in found},
                         {("upright", None), ("upright (other side)", None)})

    def test_the_other_side_is_half_a_cycle_later(self):
        found = self.json("events", walk(), "--mark", "250=left_strike", "--both-sides")["events"]
        sides = {side: [e for e in found if e["name"] == side + "_strike" and e["cycle"] is not None]
                 for side in ("left", "right")}
        self.assertGreaterEqual(len(sides["right"]), 2)
        self.assertEqual({(e["name"], e["side"]) for e in found},
                         {("left_strike", "left"), ("right_strike", "right")})
        for event in sides["right"]:
            self.assertFalse(event["marked"])
            turns = (event["frame"] - 250) / 132
            self.assertAlmostEqual(turns % 1, 0.5, delta=0.03)
        cycles = self.json("decompose", walk())["cycles"]
        for event in sides["right"]:
            cycle = cycles[event["cycle"]]
            self.assertTrue(cycle["begin"] <= event["frame"] < cycle["end"])
        names = {e["name"] for e in
                 self.json("events", walk(), "--mark", "250=landing", "--both-sides")["events"]}
        self.assertEqual(names, {"landing", "landing (other side)"})

    def test_marks_of_both_sides_are_not_mirrored(self):
        marks = ("--mark", "250=left_strike", "--mark", "316=right_strike")
        alone, both = (self.json("events", walk(), *marks, *more)["events"]
                       for more in ((), ("--both-sides",)))
        self.assertEqual(both, alone)

    def test_what_is_not_found_on_the_other_side_is_said(self):
        still = f"{walk()}:0-40"
        found = self.json("events", walk(), still, "--mark", "250=left_strike", "--both-sides")
        self.assertEqual([s["count"] for s in found["searches"] if s["clip"] == still], [0, 0])
        for name in ("left_strike", "right_strike"):
            self.assertTrue(any(f"so no {name}" in text for text in found["warnings"]))

    def test_marks_at_two_places_are_said(self):
        found = self.json("events", walk(), "--mark", "250=strike", "--mark", "316=strike")
        self.assertEqual([e["frame"] for e in found["events"] if e["marked"]], [250, 316])
        self.assertIn("strike: the marks lie at 2 places", found["warnings"][0])

    def test_wrong_marks(self):
        for mark in ("250", "=a", "x=a", "250=", "nans=a", "inf=a"):
            self.assertIn("FRAME=NAME", self.fails(2, "events", walk(), "--mark", mark))
        self.assertIn("--mark", self.fails(2, "events", walk()))
        self.assertIn("no motion that repeats", self.fails(2, "events", walk(), "--mark", "2=a"))
        self.fails(2, "events", cut(), "--mark", "2=a", "-o", self.folder / "events.png")


if __name__ == "__main__":
    unittest.main()
