# SPDX-License-Identifier: BSD-3-Clause
"""Whether an answer stays the same when the same motion is seen otherwise."""

from dataclasses import replace

import numpy as np

from . import synthetic, variations
from .score import found_borders, matches, score

CROP = (20, 15)  # seconds cut off at the beginning and at the end
RATES = (15, 60, 120)
NOISES = (1, 3, 5)


def check(run):
    run.table.title("The same motion seen otherwise: the same kinds, labels and counts (within one), "
                    "borders within 50 ms at the median; 5 degrees of noise: nothing wrong")
    for seed in run.seeds[:1 if run.quick else 3]:
        usual = synthetic.mixture(run.body, seed, 60)
        base = run.decompose(usual)
        for recording in (variations.mirrored(usual), variations.turned(usual, 130),
                          variations.scaled(usual, 0.01)):
            compare(run, recording, seed, base, run.decompose(recording))
        for fps in RATES:
            other = synthetic.mixture(run.body, seed, 60, fps=fps)
            compare(run, replace(other, name=f"{fps} fps"), seed, base, run.decompose(other))
        for degrees in NOISES:
            noise(run, usual, seed, base, degrees)
        crop(run, usual, seed, base)


def shape(answer):
    """Kinds and labels of the moving segments, labels by order of appearance."""
    moving = [s for s in answer["segments"] if s["kind"] != "rest"]
    order = list(dict.fromkeys(s["label"] for s in moving))
    return [(s["kind"], order.index(s["label"])) for s in moving]


def border_shift(base, answer):
    """Median distance of borders between moving segments that both answers have."""
    true = [border[:2] for border in found_borders(base)]
    found = found_borders(answer)
    off = [abs(np.subtract(true[i], found[j][:2])).max()
           for i, j in enumerate(matches(true, found, 1)) if j is not None]
    return float(np.median(off)) if off else 0.0


def agreement(base, answer):
    same = shape(base) == shape(answer)
    counts = [[s["count"] for s in one["segments"] if s["kind"] != "rest"]
              for one in (base, answer)]
    off = max((abs(a - b) for a, b in zip(*counts)), default=0) if same else None
    shift = border_shift(base, answer)
    return [("same kinds and labels" if same else
             f"{len(shape(answer))} segments instead of {len(shape(base))}, or other kinds or labels",
             same),
            (f"counts within {off}", off is not None and off <= 1),
            (f"borders {1000 * shift:.0f} ms", shift <= 0.05)]


def compare(run, recording, seed, base, answer):
    run.table.row(f"{recording.name}, seed {seed}", agreement(base, answer))


def noise(run, usual, seed, base, degrees):
    recording = variations.noisy(usual, degrees, seed)
    answer = run.decompose(recording)
    if degrees <= 3:
        compare(run, recording, seed, base, answer)
        return
    result = score(recording, answer)
    gaits = [part for part in recording.parts if part.label in ("walk", "run") and part.cycles]
    lost = sum(not any(part.begin < (c["begin_s"] + c["end_s"]) / 2 < part.end
                       for c in answer["cycles"]) for part in gaits)
    run.table.row(f"{recording.name}, seed {seed}", [
        (f"{lost} of {len(gaits)} gaits lost", lost == 0),
        (f"{result.cycles_wrong} cycles wrong", result.cycles_wrong == 0)])


def crop(run, usual, seed, base):
    """The cycles of the crop are those of the whole, but the outermost of each cut segment."""
    part, begin = usual.crop(CROP[0], usual.seconds - CROP[1])
    answer = variations.shifted(run.decompose(part), begin)
    end = begin + part.seconds
    inside = [c for c in base["cycles"] if c["begin_s"] >= begin and c["end_s"] <= end]
    edges = {c["segment"] for c in base["cycles"] if not (c["begin_s"] >= begin + 2
                                                          and c["end_s"] <= end - 2)}
    missing = [c for c in inside if not any(
        abs(c["begin_s"] - d["begin_s"]) <= 0.05 and abs(c["end_s"] - d["end_s"]) <= 0.05
        for d in answer["cycles"])]
    allowed = 2 * len(edges)
    run.table.row(f"cropped, seed {seed}", [
        (f"{len(inside) - len(missing)} of {len(inside)} cycles the same", len(missing) <= allowed),
        (f"borders {1000 * border_shift(base, answer):.0f} ms",
         border_shift(base, answer) <= 0.05)])
