# SPDX-License-Identifier: BSD-3-Clause
"""The parts of measure/recordings: each makes recordings, decomposes them and checks the limits."""

import functools
import json
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from . import calibration, cost, invariance, motions, moves, real, synthetic
from .score import Score, checked, phase_error, score


@dataclass
class Run:
    stltsa: object
    table: object
    body: object
    command: Path  # the program stltsa
    data: Path
    folder: Path
    quick: bool
    seeds: list
    said: list = field(default_factory=list)  # scores whose confidences are pooled

    def answer(self, clip, **options):
        return checked(json.loads(self.stltsa.decompose(clip, **options).to_json()))

    def decompose(self, recording):
        return self.answer(recording.clip(self.stltsa, self.folder))

    def score(self, recording):
        answer = self.decompose(recording)
        result = score(recording, answer)
        self.said.append(result)
        return result, answer

    @functools.cached_property
    def styles(self):
        return moves.read_moves(self.stltsa, self.data)

    def calibration(self):
        if self.said:
            calibration.check(self.table, sum(self.said, Score()))


def percent(part, whole):
    return f"{100 * part / whole:.1f} %" if whole else "-"


def sound(result):
    """Checks that the answer does not contradict itself."""
    return [(problem, False) for problem in result.problems[:2]]


def lost_and_wrong(result, lost):
    missing = result.cycles - result.cycles_right
    return [(f"{result.cycles_right} of {result.cycles} cycles", missing <= lost),
            (f"{result.cycles_wrong} wrong", result.cycles_wrong == 0), *sound(result)]


def moving_segments(answer):
    return sum(segment["kind"] != "rest" for segment in answer["segments"])


# ---- One motion ----

def treadmill(run):
    run.table.title("Treadmill: all strides but two, none wrong, one segment, one phase")
    for minutes in (1, 3) if run.quick else (1, 3, 10, 60):
        for seed in run.seeds[:1 if minutes == 60 else None]:
            walk = synthetic.treadmill(run.body, seed, minutes)
            variants = [walk.angles(), walk.positions()] + ([walk] if minutes <= 10 else [])
            if run.data.is_dir():
                variants.append(moves.treadmill(run.styles, seed, minutes))
            for recording in variants:
                result, answer = run.score(recording)
                spread, drift = phase_error(recording, answer)
                count = moving_segments(answer)
                run.table.row(f"{recording.name}, seed {seed}", [
                    *lost_and_wrong(result, 2), (f"{count} moving segments", count == 1),
                    (f"phase SD {100 * spread:.2f} % drift {100 * drift:.2f} %",
                     spread <= 0.02 and drift <= 0.01)])


def equal(run):
    run.table.title("Equal strides: all but one")
    recording = synthetic.equal_strides(run.body, 200 if run.quick else 1200)
    result, _ = run.score(recording)
    count = result.cycles + 1
    run.table.row(recording.name, [
        (f"{result.cycles_right} cycles", result.cycles_right in (count - 1, count)),
        (f"{result.cycles_wrong} wrong", result.cycles_wrong == 0), *sound(result)])


def tempo(run):
    run.table.title("Tempo: a ramp loses one cycle, each step one, a stop two; none is wrong")
    for seed in run.seeds:
        for recording, lost in ((synthetic.tempo_ramp(run.body, seed), 1),
                                (synthetic.tempo_steps(run.body, seed), 4),
                                (synthetic.slowing(run.body, seed), 2)):
            result, answer = run.score(recording)
            standing = standing_while_moving(recording, answer)
            run.table.row(f"{recording.name}, seed {seed}", [
                *lost_and_wrong(result, lost),
                (f"stands {standing:.2f} s while it moves", standing <= 0.2)])


def standing_while_moving(recording, answer):
    """Seconds of the moving parts that a segment or unit calls standing."""
    rests = [s for s in answer["segments"] if s["kind"] == "rest"]
    rests += [u for u in answer["units"] if u["kind"] in ("preparing", "wind-up", "hold")]
    still = np.zeros(len(recording.rows), bool)
    for rest in rests:
        still[rest["begin"]:rest["end"]] = True
    for part in recording.parts:
        if not part.moving:
            still[round(part.begin * recording.fps):round(part.end * recording.fps)] = False
    return still.sum() / recording.fps


def hands(run):
    run.table.title("One hand or foot on a swaying body: 92 % of the cycles, none wrong, and its joints")
    for name, joints in synthetic.CARRIED.items():
        for seed in run.seeds:
            recording = synthetic.one_part(run.body, seed, name)
            result, answer = run.score(recording)
            by = sorted({joint for segment in answer["segments"] if segment["kind"] == "cyclic"
                         for joint in segment["carried_by"]})
            others = [joint for joint in by if not joint.startswith(joints)]
            run.table.row(f"{recording.name}, seed {seed}", [
                *lost_and_wrong(result, 0.08 * result.cycles),
                (f"by {' '.join(others or by) or 'none'}", bool(by) and not others)])


def repetitions(run):
    run.table.title("Repetitions with pauses: 98 % of the groups counted exactly, no cycle")
    total = Score()
    for name in sorted(motions.SINGLE):
        for seed in run.seeds:
            recording = synthetic.repetitions(run.body, seed, name)
            result, answer = run.score(recording)
            run.table.figure(f"{recording.name}, seed {seed}",
                             f"{len(answer['repetitions'])} repetitions  "
                             f"{len(answer['cycles'])} cycles")
            total += result
    run.table.row("all", [
        (f"{total.groups_exact} of {total.groups} exact", total.groups_exact >= 0.98 * total.groups),
        (f"{total.cycles_wrong} cycles", total.cycles_wrong == 0), *sound(total)])


def acyclic(run):
    run.table.title("Nothing repeats: no cycle, no repetition")
    for seed in run.seeds:
        for recording in synthetic.acyclic(run.body, seed, 1 if run.quick else 10):
            result, answer = run.score(recording)
            cycles, again = len(answer["cycles"]), len(answer["repetitions"])
            run.table.row(f"{recording.name}, seed {seed}", [
                (f"{cycles} cycles", cycles == 0), (f"{again} repetitions", again == 0),
                *sound(result)])


# ---- Mixtures ----

def mixtures(run):
    minutes = 2 if run.quick else 10
    check_mixtures(run, f"Mixtures of the synthetic body, {minutes} min",
                   [synthetic.mixture(run.body, seed, 60 * minutes) for seed in run.seeds])


def clips(run):
    if not run.data.is_dir():
        run.table.figure(f"no real clips in {run.data} (set STLTSA_DATA)", "skipped")
        return
    for minutes in (2,) if run.quick else (2, 10):
        check_mixtures(run, f"Mixtures of short moves, {minutes} min",
                       [moves.mixture(run.styles, seed, 60 * minutes) for seed in run.seeds])
    minutes = 2 if run.quick else 10
    check_mixtures(run, f"Mixtures of short moves with rests, {minutes} min", [
        moves.mixture_with_rests(run.styles, seed, 60 * minutes) for seed in run.seeds])


def check_mixtures(run, title, recordings):
    run.table.title(title)
    total, given = Score(), 0
    for recording in recordings:
        result, _ = run.score(recording)
        alone = given_borders(run, recording)
        run.table.figure(recording.name, summary(result, alone))
        total += result
        given += alone
    limits(run.table, total, given)


def given_borders(run, recording):
    """Right cycles if each cyclic part is decomposed alone."""
    right = 0
    for part in recording.parts:
        if part.kind == "cyclic" and part.cycles:
            alone, _ = recording.crop(part.begin, part.end)
            right += score(alone, run.decompose(alone)).cycles_right
    return right


def summary(result, given):
    wrong = " ".join(f"{count} {why}" for why, count in sorted(result.wrong.items()))
    return (f"F1 {result.f1(1):.2f} {result.f1(0.5):.2f}  labels {result.labels:.3f}  cycles "
            f"{result.cycles_right} (borders given {given}) of {result.cycles}  "
            f"wrong {wrong or 0}  groups {result.groups_exact} of {result.groups}")


def limits(table, total, given):
    claimed = total.cycles_right + total.cycles_wrong
    invented = total.wrong["invented"]
    table.row("borders", [
        (f"F1 within 1 s {total.f1(1):.3f} (0.95)", total.f1(1) >= 0.95),
        (f"0.5 s {total.f1(0.5):.3f} (0.85)", total.f1(0.5) >= 0.85)],
        f"{total.within[1]} of {total.borders}, {total.found_borders} found")
    table.row("labels", [(f"right {100 * total.labels:.1f} % of the time (95)",
                          total.labels >= 0.95), *sound(total)])
    table.row("cycles", [
        (f"{percent(total.cycles_right, total.cycles)} of all (92)",
         total.cycles_right >= 0.92 * total.cycles),
        (f"{percent(total.cycles_right, given)} of {given} with given borders (98)",
         total.cycles_right >= 0.98 * given),
        (f"{percent(total.cycles_wrong, claimed)} wrong (1)",
         total.cycles_wrong <= 0.01 * claimed),
        (f"{invented} invented (0)", invented == 0)], f"{total.undecided} not judged")
    if total.groups:
        table.row("repetitions", [(f"{total.groups_exact} of {total.groups} groups exact (98 %)",
                                   total.groups_exact >= 0.98 * total.groups)])


PARTS = {"treadmill": treadmill, "equal": equal, "tempo": tempo, "hands": hands,
         "repetitions": repetitions, "acyclic": acyclic, "mixtures": mixtures, "clips": clips,
         "real": real.run_all, "invariance": invariance.check, "cost": cost.check}
