#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every fact of the library's JSON agrees with what the handle says.

The schemas drive the test: a new key in a schema fails until fact_functions.py says where to read it.
Calls go through ctypes (library.py); keys are found by name in the library's table.
"""

import json
import math
import os
import random
import re
import unittest
from ctypes import byref, c_char_p, c_double, c_int64, c_void_p

from c3d_file import c3d
from common import CLIPS, SCHEMAS, bursts, circle, cut, still, walk, write_csv
from fact_functions import FACTS, Missing
from library import ARRAY, CONSTANTS, HEADER, KEYS, OPTIONS, STRUCTS, Handle, Piece, call, value


def leaves(schema, path=""):
    """Paths of the values of a schema, without those that only the command adds."""
    if "properties" in schema:
        for key, member in schema["properties"].items():
            if (path, key) not in (("", "format"), ("", "curve"), ("", "phase_warnings"), ("", "sides")):
                yield from leaves(member, f"{path}.{key}".lstrip("."))
    elif "items" in schema:
        yield from leaves(schema["items"], path)
    else:
        yield path


def values(node, keys):
    """The leaf values at a path; Missing if there is null or nothing on the way."""
    if isinstance(node, list):
        found = [values(item, keys) for item in node]
        return [v for each in found for v in (each if isinstance(each, list) else [each])]
    if not keys:
        return node
    return Missing if node in (None, Missing) else values(node.get(keys[0], Missing), keys[1:])


class Facts(unittest.TestCase):
    def handle(self, *arguments):
        made_one = Handle(*arguments)
        self.addCleanup(made_one.free)
        return made_one

    def options(self, **given):
        out = c_void_p()
        call("options_new", byref(out))
        self.addCleanup(value, "options_free", None, out)
        for name, number in given.items():
            kind = c_double if isinstance(number, float) else c_int64
            setter = "options_set_real" if kind is c_double else "options_set_int"
            call(setter, out, OPTIONS[name.upper()], kind(number))
        return out

    def opened(self, path, **options):
        return self.handle("clip", "clip_open", os.fsencode(path), self.options(**options))

    def fitted(self, clip, options):
        return self.handle("model", "fit_clips", byref(clip.pointer), c_int64(1), options)

    def examples(self):
        clip = self.opened(walk())
        none = self.options()
        # Moves on without repeating; the reader notes that the first column is not a channel.
        noted = self.opened(write_csv("noted.csv", [[i, 0.1 * i, (0.02 * i) ** 2]
                                                    for i in range(200)], "Frame,x,y\n"), fps=30.0)
        parted = self.fitted(self.opened(cut(), fps=30.0), self.options(neighbors=5, window=8, smoothing=0.0))
        recurrent_ = self.fitted(clip, self.options(mode=3, links=3))
        rows = [[math.sin(0.1 * i + c) for c in range(3)] for i in range(200)]
        random.Random(3).shuffle(rows)
        noise = random.Random(1)
        mixed = self.opened(write_csv("mixed.csv", rows), fps=30.0)
        of_notes = self.fitted(noted, none)
        units = self.handle("decomposition", "decompose", clip.pointer,
                            none)
        cycles = [(i.begin, i.end) for i in units.list("cycle")]
        pieces = (Piece * 2)(*(Piece(clip.pointer, begin, end, 2, 0) for begin, end in cycles[:2]))
        short = Piece(clip.pointer, cycles[0][0], cycles[0][1] - 20, 2, 0)
        recorded = CLIPS / "recorded.c3d"
        recorded.write_bytes(c3d([[math.sin(i + c) for c in range(9)] for i in range(50)],
                                 ("HEAD", "LTOE", "RTOE"), parameters={
            "POINT": {"UNITS": ["mm"], "Y_SCREEN": ["+Z"]},
            "EVENT": {"LABELS": ["Strike"], "CONTEXTS": ["Left"], "TIMES": [0.0, 0.2]}}))  # fmt: skip
        return [
            clip, self.opened(recorded), noted, parted, recurrent_, of_notes, units,
            self.handle("decomposition", "decompose", noted.pointer, none),
            self.handle("decomposition", "decompose", mixed.pointer, none),
            self.handle("decomposition", "decompose",
                        self.opened(bursts(), fps=30.0).pointer, none),
            self.handle("decomposition", "decompose", self.opened(circle(), fps=50.0).pointer, none),
            self.fitted(clip, self.options(intrinsic=1)),
            self.fitted(self.opened(cut(), fps=30.0), self.options(intrinsic=1, neighbors=5, window=8)),
            # Its eigenvalues are those of noise.
            self.fitted(self.opened(write_csv("noise.csv", [
                [noise.random() for _ in range(6)] for _ in range(120)]), fps=30.0),
                        self.options(mode=2, dimension=1, neighbors=8)),
            self.handle("denoising", "denoise_model", parted.pointer, none),
            self.handle("denoising", "denoise_model", recurrent_.pointer,
                        self.options(gamma=0.01, robust=0)),
            self.handle("denoising", "denoise_model", of_notes.pointer, none),
            self.handle("synthesis", "synthesize", pieces, c_int64(2), none),
            self.handle("synthesis", "synthesize", byref(short), c_int64(1),
                        self.options(crossfade=0.05, cut_range=0.0, posture_limit=0.0)),
            self.handle("synthesis", "synthesize", pieces, c_int64(2), self.options(loop=1)),
            self.handle("synthesis", "synthesize_loop", clip.pointer, units.pointer,
                        self.options(in_place=1)),
        ]

    def test_every_leaf_of_a_schema_is_read(self):
        for kind, facts in FACTS.items():
            schema = json.loads(next(SCHEMAS.glob(f"stltsa-{kind}-*.schema.json")).read_text())
            with self.subTest(kind):
                self.assertEqual(sorted(facts), sorted({*leaves(schema)} - {"library"}))

    def test_handles_say_what_the_json_says(self):
        seen = set()
        for example in self.examples():
            said = example.json()
            self.assertEqual(said["library"], value("version", c_char_p).decode())
            for path, fact in FACTS[example.kind].items():
                wanted = values(said, path.split("."))
                if wanted is Missing:
                    continue
                with self.subTest(example.kind, path=path):
                    self.assertEqual(fact(example), wanted)
                if wanted not in ([], None):
                    seen.add((example.kind, path))
        # If no neighborhood varies, nothing is fitted.
        seen.add(("model", "local_pca.reason"))
        # Decompositions embed in temporal mode alone.
        seen |= {("decomposition", f"parameters.{name}") for name in ("links", "exclusion")}
        unseen = {(kind, path) for kind, facts in FACTS.items() for path in facts} - seen
        self.assertEqual(unseen, set())

    def test_warnings_have_codes_and_times(self):
        codes = {code: name for name, code in CONSTANTS.items() if name.startswith("WARNING_")}
        parts = {}
        for example in self.examples():
            for warning in example.list("warning"):
                parts.setdefault(codes[warning.code], (example, warning))
        # Cut at frame 60 of 30 per second; a fit with 5 neighbors, and its denoising.
        cut_ = parts["WARNING_DISCONNECTED"][1]
        self.assertEqual((cut_.begin_s, cut_.end_s), (2, 2))
        self.assertIn("cut at frame 60", cut_.text.decode())
        self.assertTrue(math.isnan(parts["WARNING_SMALL_GAP"][1].begin_s))
        made, warning = parts["WARNING_SEAM_SPEED"]
        self.assertEqual((warning.begin_s, warning.end_s), (made.list("seam")[0].time_s,) * 2)

    def test_statistics_are_those_of_the_summary(self):
        units = self.handle("decomposition", "decompose", self.opened(walk()).pointer, None)
        (summary,) = units.list("summary")
        found = STRUCTS["statistics"]()
        for kind, quantity, member in (
                ("CYCLE", "TIME", "cycle_time_s"), ("STEP", "TIME", "step_time_s"),
                ("CYCLE", "PATH_LENGTH", "path_length"), ("CYCLE", "STRIDE", "stride"),
                ("CYCLE", "SPEED", "speed"), ("CYCLE", "TURN", "turn_deg")):  # fmt: skip
            call("decomposition_statistics", units.pointer, CONSTANTS[f"INFO_{kind}"], c_int64(0), -1,
                 CONSTANTS[f"QUANTITY_{quantity}"], byref(found))
            self.assertEqual(bytes(found), bytes(getattr(summary, member)), member)

    def test_every_key_is_described(self):
        in_header = dict(re.findall(r"STLTSA_INFO_(\w+) = (\d+)", HEADER))
        self.assertEqual({name.upper(): str(row.key) for name, row in KEYS.items()}, in_header)
        for name, row in KEYS.items():
            with self.subTest(name):
                self.assertTrue(row.text.decode().endswith("."))
                self.assertGreater(row.handles, 0)

    def test_handles_have_what_their_keys_say(self):
        bits = {kind: int(bit) for kind, bit in
                re.findall(r"STLTSA_HANDLE_(\w+) = (\d+)", HEADER)}
        for example in self.examples():
            for name, row in KEYS.items():
                with self.subTest(example.kind, key=name):
                    count = example.count(name)
                    if not row.handles & bits[example.kind.upper()]:
                        self.assertEqual(count, 0)
                    elif not row.is_list and row.type != ARRAY:
                        self.assertLessEqual(count, 1)


if __name__ == "__main__":
    unittest.main()
