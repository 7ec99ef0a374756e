#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests the scores of recordings on answers made from the truth: a perfect one and wrong ones.

Usage: test_score.py WALKER
"""

import itertools
import sys
import unittest
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from recording import fake, synthetic  # noqa: E402
from recording.assignment import best_map  # noqa: E402
from recording.body import Body  # noqa: E402
from recording.compose import Cyclic, Rest, compose  # noqa: E402
from recording.score import phase_error, score  # noqa: E402

WALKER = sys.argv.pop(1)


class Scores(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.body = Body(WALKER)
        cls.mixture = synthetic.mixture(cls.body, 1, 180)

    def perfect(self, recording):
        found = score(recording, fake.answer(recording))
        self.assertEqual(found.problems, [])
        self.assertEqual(found.f1(0.5), 1)
        self.assertAlmostEqual(found.labels, 1, places=2)
        self.assertEqual((found.cycles_right, found.cycles_wrong), (found.cycles, 0))
        self.assertEqual(found.groups_exact, found.groups)
        self.assertTrue(all(right for pairs in found.said.values() for _, right in pairs))
        return found

    def test_perfect(self):
        self.assertGreater(self.perfect(self.mixture).groups, 2)
        walk = synthetic.treadmill(self.body, 1, 0.5)
        self.perfect(walk)
        self.assertLess(max(phase_error(walk, fake.answer(walk))), 1e-9)
        for recording in (synthetic.tempo_ramp(self.body, 1), synthetic.tempo_steps(self.body, 1),
                          synthetic.slowing(self.body, 1), synthetic.equal_strides(self.body, 20),
                          synthetic.one_part(self.body, 1, "clap"),
                          synthetic.repetitions(self.body, 1, "squat")):
            with self.subTest(recording.name):
                self.perfect(recording)

    def test_cycles_of_wrong_length(self):
        answer = fake.answer(self.mixture)
        for cycle in answer["cycles"][::7]:
            cycle["end_s"] = cycle["begin_s"] + 0.8 * (cycle["end_s"] - cycle["begin_s"])
        found = score(self.mixture, answer)
        self.assertEqual(found.wrong["length"], len(answer["cycles"][::7]))
        self.assertEqual(found.cycles_right + found.cycles_wrong, found.cycles)

    def test_half_the_period(self):
        answer = fake.answer(self.mixture)
        answer["cycles"] = [{**cycle, "begin_s": a, "end_s": b} for cycle in answer["cycles"]
                            for m in [(cycle["begin_s"] + cycle["end_s"]) / 2]
                            for a, b in ((cycle["begin_s"], m), (m, cycle["end_s"]))]
        self.assertEqual(score(self.mixture, answer).cycles_right, 0)

    def test_invented_cycles_and_cycles_across(self):
        answer = fake.answer(self.mixture)
        parts = self.mixture.parts
        action = next(part for part in parts if part.kind == "action")
        walk = next(part for part in parts if part.kind == "cyclic")
        for begin, end in ((action.begin, action.end), (walk.end - 0.6, walk.end + 0.5)):
            answer["cycles"].append({"segment": 0, "confidence": 0.9,
                                     **fake.interval(self.mixture, begin, end)})
        found = score(self.mixture, answer)
        self.assertEqual(found.wrong, {"invented": 1, "across": 1})
        self.assertTrue(found.problems)

    def test_missed_repetition(self):
        answer = fake.answer(self.mixture)
        answer["repetitions"].pop(1)
        found = score(self.mixture, answer)
        self.assertEqual(found.groups - found.groups_exact, 1)
        self.assertTrue(found.problems)

    def test_moved_borders(self):
        names = ("walk", "clap", "run", "twist")
        recording = compose("long parts", np.random.default_rng(1), self.body,
                            [Cyclic(name, 10) for name in names])
        for shift, half, one in ((0.4, 3, 3), (-0.7, 0, 3), (1.3, 0, 0)):
            answer = fake.answer(recording)
            for a, b in zip(answer["segments"][:-1], answer["segments"][1:]):
                a["end_s"] = b["begin_s"] = b["begin_s"] + shift
            found = score(recording, answer)
            self.assertEqual((found.within[0.5], found.within[1]), (half, one))
            self.assertEqual({right for _, right in found.said["border"]}, {bool(one)})

    def test_a_rest_is_one_border(self):
        recording = compose("with a rest", np.random.default_rng(1), self.body,
                            [Cyclic("walk", 10), Rest(3), Cyclic("walk", 10)])
        answer = fake.answer(recording)
        for at, half in ((11.5, 1), (9.7, 1), (13.7, 0)):
            first, _, last = (dict(segment) for segment in answer["segments"])
            first["end_s"] = last["begin_s"] = at
            found = score(recording, {**answer, "segments": [first, last]})
            self.assertEqual((found.borders, found.within[0.5], found.within[1]), (1, half, 1))

    def test_one_segment_for_all(self):
        answer = fake.answer(self.mixture)
        whole = {**answer["segments"][0], "kind": "cyclic", "label": "A", "begin_s": 0,
                 "begin": 0, "end": len(self.mixture.rows), "end_s": self.mixture.seconds}
        found = score(self.mixture, {**answer, "segments": [whole]})
        self.assertEqual(found.f1(1), 0)
        self.assertLess(found.labels, 0.5)
        self.assertEqual(found.said["segment"], [(0.97, False)])

    def test_two_labels_swapped_for_a_while(self):
        answer = fake.answer(self.mixture)
        changed = next(s for s in answer["segments"] if s["kind"] == "cyclic")
        others = {s["label"] for s in answer["segments"]} - {changed["label"], None}
        changed["label"] = min(others)
        found = score(self.mixture, answer)
        missing = changed["end_s"] - changed["begin_s"]
        self.assertAlmostEqual(found.judged_s - found.right_s, missing, delta=1)

    def test_sum(self):
        found = score(self.mixture, fake.answer(self.mixture))
        both = found + found
        self.assertEqual((both.cycles, both.f1(1), len(both.said["cycle"])),
                         (2 * found.cycles, 1, 2 * found.cycles))

    def test_best_map(self):
        rng = np.random.default_rng(1)
        for shape in ((1, 1), (3, 5), (5, 3), (4, 4), (0, 2)):
            gain = rng.uniform(size=shape)
            pairs = best_map(gain)
            self.assertEqual(len({j for _, j in pairs}), min(shape))
            wide = gain if shape[0] <= shape[1] else gain.T
            best = max(sum(wide[i, j] for i, j in enumerate(order))
                       for order in itertools.permutations(range(max(shape)), min(shape)))
            self.assertAlmostEqual(sum(gain[i, j] for i, j in pairs), best)


if __name__ == "__main__":
    unittest.main()
