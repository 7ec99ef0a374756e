# SPDX-License-Identifier: BSD-3-Clause
"""How well an answer (JSON, stltsa-decomposition/2) agrees with a recording's truth."""

from collections import Counter
from dataclasses import dataclass, field

import numpy as np

from .assignment import best_map

FORMAT = "stltsa-decomposition/2"
LENGTH_OFF = 0.15  # a cycle is wrong if its length is off by more


@dataclass
class Score:
    """Counts that add up over recordings."""

    seconds: float = 0
    borders: int = 0
    found_borders: int = 0
    within: Counter = field(default_factory=Counter)  # tolerance -> borders found
    judged_s: float = 0  # time with a label
    right_s: float = 0
    cycles: int = 0
    cycles_right: int = 0
    wrong: Counter = field(default_factory=Counter)  # length, across, invented -> cycles
    undecided: int = 0  # cycles over a jump of the true phase, or in motion without a claim
    groups: int = 0
    groups_exact: int = 0
    said: dict = field(default_factory=lambda: {"cycle": [], "segment": [], "border": []})
    problems: list = field(default_factory=list)  # where the answer contradicts itself

    def __add__(self, other):
        return Score(**{name: value if name == "said" else value + getattr(other, name)
                        for name, value in vars(self).items() if name != "said"},
                     said={kind: self.said[kind] + other.said[kind] for kind in self.said})

    @property
    def cycles_wrong(self):
        return sum(self.wrong.values())

    def f1(self, tolerance):
        count = self.borders + self.found_borders
        return 2 * self.within[tolerance] / count if count else 1.0

    @property
    def labels(self):
        return self.right_s / self.judged_s if self.judged_s else 1.0


def score(recording, answer, tolerances=(1, 0.5)):
    """Compares; `said` gets pairs (confidence, right)."""
    result = Score(seconds=recording.seconds, problems=problems(answer, len(recording.rows)))
    score_borders(recording, answer, result, tolerances)
    mapped = score_labels(recording, answer, result)
    score_segments(recording, answer, result, mapped)
    score_cycles(recording, answer, result)
    score_repetitions(recording, answer, result)
    return result


# ---- The answer by itself ----

def checked(answer):
    """The answer, if its format is the one that is scored here."""
    if answer["format"] != FORMAT:
        raise SystemExit(f"this build prints {answer['format']}, and {FORMAT} is needed")
    return answer


def problems(answer, frames):
    """Contradictions of an answer: gaps, overlaps, counts that disagree."""
    found = []
    for name in ("segments", "units"):
        ends = [0] + [part["end"] for part in answer[name]]
        begins = [part["begin"] for part in answer[name]] + [frames]
        if ends != begins:
            found.append(f"{name} do not cover the clip once")
    cycles = sorted(answer["cycles"], key=lambda cycle: cycle["begin_s"])
    if any(b["begin_s"] < a["end_s"] - 1e-6 for a, b in zip(cycles[:-1], cycles[1:])):
        found.append("cycles overlap")
    for i, segment in enumerate(answer["segments"]):
        kind = segment["kind"]
        if kind in ("cyclic", "repetitions"):
            listed = answer["cycles" if kind == "cyclic" else "repetitions"]
            count = sum(one["segment"] == i for one in listed)
            if count != segment["count"]:
                found.append(f"segment {i} counts {segment['count']}, but {count} are listed")
        if (segment["label"] is None) != (kind == "rest"):
            found.append(f"segment {i}, {kind}, has the label {segment['label']}")
    return found


# ---- Borders ----

def found_borders(answer):
    """(earliest, latest, confidence) between moving segments; a rest between is one border."""
    moving = [segment for segment in answer["segments"] if segment["kind"] != "rest"]
    return [(a["end_s"], b["begin_s"], b["begin_confidence"])
            for a, b in zip(moving[:-1], moving[1:])]


def true_borders(recording, at):
    """Pairs; a border within a blend is put at its middle or beginning."""
    shift = {round(sum(blend) / 2, 6): (blend[1] - blend[0]) / 2 for blend in recording.blends}
    if at == "middle":
        return recording.borders()
    return [tuple(t - shift.get(round(t, 6), 0) for t in border)
            for border in recording.borders()]


def matches(true, found, tolerance):
    """Index of the found border of each true one, or None; one to one, in temporal order."""
    used, result = set(), []
    for begin, end in true:
        near = [i for i, (lo, hi, *_) in enumerate(found)
                if i not in used and max(lo - end, begin - hi) <= tolerance + 1e-9]
        result.append(min(near, key=lambda i: found[i][1]) if near else None)
        used.add(result[-1])
    return result


def score_borders(recording, answer, result, tolerances):
    true, found = true_borders(recording, recording.border_at), found_borders(answer)
    result.borders, result.found_borders = len(true), len(found)
    for tolerance in tolerances:
        matched = matches(true, found, tolerance)
        result.within[tolerance] = sum(i is not None for i in matched)
        if tolerance == 1:
            result.said["border"] += [(confidence, i in matched)
                                      for i, (*_, confidence) in enumerate(found)
                                      if confidence is not None]


# ---- Labels ----

def frames_of(recording, begin, end):
    return slice(*(int(np.clip(round(at * recording.fps), 0, len(recording.rows)))
                   for at in (begin, end)))


def score_labels(recording, answer, result):
    """Time with the right label under the best one-to-one map, which is returned. Blends are left
    out, and rests within a part if the answer calls them a rest."""
    n = len(recording.rows)
    true, found = np.zeros(n, int), np.zeros(n, int)  # 0: rest
    judged = np.ones(n, bool)
    names = {part.label: 0 for part in recording.parts if part.moving}
    names = {name: i + 1 for i, name in enumerate(names)}
    said = {s["label"]: 0 for s in answer["segments"] if s["label"] is not None}
    said = {label: i + 1 for i, label in enumerate(said)}
    for segment in answer["segments"]:
        found[segment["begin"]:segment["end"]] = said.get(segment["label"], 0)
    for part in recording.parts:
        frames = frames_of(recording, part.begin, part.end)
        true[frames] = names[part.label] if part.moving else 0
        if part.kind == "free":
            judged[frames] = False
    for part in recording.parts:
        for pause in part.still:
            judged[frames_of(recording, *pause)] &= found[frames_of(recording, *pause)] != 0
    for blend in recording.blends:
        judged[frames_of(recording, *blend)] = False
    table = np.zeros((len(names) + 1, len(said) + 1))
    np.add.at(table, (true[judged], found[judged]), 1 / recording.fps)
    pairs = best_map(table[1:, 1:])
    result.judged_s = table.sum()
    result.right_s = table[0, 0] + sum(table[i + 1, j + 1] for i, j in pairs)
    true_names, said_names = list(names), list(said)
    return {said_names[j]: true_names[i] for i, j in pairs if table[i + 1, j + 1] > 0}


def score_segments(recording, answer, result, mapped):
    """A segment is right if its kind and label are those of the part that fills most of it, and
    that part fills at least three quarters."""
    for segment in answer["segments"]:
        if segment["confidence"] is None or segment["end_s"] <= segment["begin_s"]:
            continue
        share, part = max(((overlap(part.begin, part.end, segment), part)
                           for part in recording.parts), key=lambda pair: pair[0])
        if part.kind == "free":
            continue
        right = (share >= 0.75 * (segment["end_s"] - segment["begin_s"])
                 and segment["kind"] == part.kind
                 and mapped.get(segment["label"], "") == part.label)
        result.said["segment"].append((segment["confidence"], right))


def overlap(begin, end, interval):
    return max(0.0, min(end, interval["end_s"]) - max(begin, interval["begin_s"]))


# ---- Cycles ----

def phase_at(piece, seconds):
    """The phase of a piece, continued at both ends with the rate there."""
    times, phase = piece
    k = min(len(times) - 1, 10)
    if seconds < times[0]:
        return phase[0] + (seconds - times[0]) * (phase[k] - phase[0]) / (times[k] - times[0])
    if seconds > times[-1]:
        return phase[-1] + ((seconds - times[-1]) * (phase[-1] - phase[-1 - k])
                            / (times[-1] - times[-1 - k]))
    return float(np.interp(seconds, times, phase))


def judge(recording, cycle):
    """right, length, across, invented, or undecided."""
    begin, end = cycle["begin_s"], cycle["end_s"]
    middle = (begin + end) / 2
    part = next((p for p in recording.parts if p.begin <= middle < p.end), recording.parts[-1])
    if part.kind != "cyclic":
        return "invented"
    if not part.pieces:
        return "undecided"
    slack = LENGTH_OFF * (end - begin)
    if begin < part.begin - slack or end > part.end + slack:
        return "across"
    piece = next((p for p in part.pieces if p[0][0] <= middle <= p[0][-1]), None)
    jumps = len(part.pieces) > 1 and (piece is None or begin < piece[0][0] - slack
                                      or end > piece[0][-1] + slack)
    if jumps:
        return "undecided"
    advance = phase_at(piece or part.pieces[0], end) - phase_at(piece or part.pieces[0], begin)
    return "right" if abs(advance - 1) <= LENGTH_OFF else "length"


def score_cycles(recording, answer, result):
    result.cycles = len(recording.cycles)
    for cycle in answer["cycles"]:
        verdict = judge(recording, cycle)
        if verdict == "undecided":
            result.undecided += 1
            continue
        result.cycles_right += verdict == "right"
        if verdict != "right":
            result.wrong[verdict] += 1
        if cycle["confidence"] is not None:
            result.said["cycle"].append((cycle["confidence"], verdict == "right"))


def phase_error(recording, answer):
    """Deviation of the true phase at which the cycles begin, and its drift from the first 20 to the
    last 20; of a recording with one piece."""
    piece, = (piece for part in recording.parts for piece in part.pieces)
    begins = np.array([phase_at(piece, cycle["begin_s"]) for cycle in answer["cycles"]])
    if len(begins) < 2:
        return np.inf, np.inf
    around = np.exp(2j * np.pi * begins)
    off = np.angle(around / around.mean()) / (2 * np.pi)
    return float(off.std()), float(abs(off[-20:].mean() - off[:20].mean()))


# ---- Repetitions ----

def score_repetitions(recording, answer, result):
    """A group is exact if each of its repetitions holds the middle of one that was found, of one
    label, and no other begins within the part."""
    for part in recording.parts:
        if part.kind != "repetitions":
            continue
        middles = [((one["begin_s"] + one["end_s"]) / 2, one["label"])
                   for one in answer["repetitions"]]
        inside = [(at, label) for at, label in middles if part.begin <= at < part.end]
        held = [sum(a <= at < b for at, _ in inside) for a, b in part.repetitions]
        result.groups += 1
        result.groups_exact += (held == [1] * len(held) and len(inside) == len(held)
                                and len({label for _, label in inside}) == 1)
