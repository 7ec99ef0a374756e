# SPDX-License-Identifier: BSD-3-Clause
"""Real recordings whose behaviors, periods or heel strikes a person or a device has set."""

import csv

import measuring
import numpy as np

from . import peer
from .score import problems, score
from .truth import Part, Recording

LABELED = {"86_01": None, "13_29": "86.asf", "13_30": "86.asf"}
PASSES = 1  # seconds within which a border counts
NUMBER_OF_SEGMENTS = ("segments", "behaviors")  # names of the option, of which one is expected


def run_all(run):
    if not run.data.is_dir():
        run.table.figure(f"no real clips in {run.data} (set STLTSA_DATA)", "skipped")
        return
    labeled(run)
    moves(run)
    markers(run)


# ---- Behaviors ----

def parts_of(path, fps):
    """The behaviors of a table; ends only, or begins and ends, in frames."""
    rows = list(csv.DictReader(path.read_text().splitlines()))
    ends = [int(row.get("end_typical") or row["end"]) for row in rows]
    return [Part("cyclic", row["behaviour"], begin / fps, end / fps)
            for row, begin, end in zip(rows, [0, *ends[:-1]], ends)]


def labeled(run):
    run.table.title("Behaviors set by a person: F1 within 1 s not below that of kernel change-point "
                    "detection (ruptures) on the same features and on the pose")
    for name, skeleton in LABELED.items():
        options = {"skeleton": str(run.data / "cmu" / skeleton)} if skeleton else {}
        clip = run.stltsa.read_clip(str(run.data / "cmu" / f"{name}.amc"), **options)
        parts = parts_of(run.data / "labels" / f"{name}.csv", clip.fps)
        recording = Recording(name, clip.fps, np.empty((len(clip), 0)), parts)
        automatic = run.answer(clip)
        compare(run, f"{name}, automatic", recording, clip, automatic, None)
        option = next((o.name for o in run.stltsa.options() if o.name in NUMBER_OF_SEGMENTS), None)
        if option:
            given = run.answer(clip, **{option: len(parts)})
            compare(run, f"{name}, number given", recording, clip, given, len(parts) - 1)
        else:
            run.table.row(f"{name}, number given", [("no option for it", False)])
        if name == "86_01":
            walks(run, parts, automatic)


def compare(run, name, recording, clip, answer, count):
    """Beside ruptures with the same number of borders, or with its penalty."""
    result, others = score(recording, answer), {}
    if peer.installed():
        others = {what: peer.f1(recording, rows, PASSES, count)
                  for what, rows in (("features", clip.features()), ("pose", clip.features("raw")))}
    text = "  ".join(f"ruptures, {what} {value:.2f}" for what, value in others.items())
    run.table.row(name, [
        (f"F1 {result.f1(PASSES):.2f} (0.5 s: {result.f1(0.5):.2f})",
         result.f1(PASSES) >= max(others.values(), default=0)),
        *[(problem, False) for problem in result.problems]],
        f"labels right {100 * result.labels:.0f} % of the time; "
        f"{text or 'not compared: no ruptures (--peers installs it)'}")


def walks(run, parts, answer):
    """Each walk of 86_01 has cycles of like length."""
    for part in (part for part in parts if part.label == "walk"):
        lengths = [c["end_s"] - c["begin_s"] for c in answer["cycles"]
                   if part.begin <= (c["begin_s"] + c["end_s"]) / 2 < part.end]
        like = all(abs(length / np.median(lengths) - 1) <= 0.15 for length in lengths)
        run.table.row(f"86_01, walk at {part.begin:.1f} s", [
            (f"cycles of {' '.join(f'{length:.2f}' for length in lengths) or 'none'} s",
             len(lengths) >= 2 and like)])


# ---- Short moves ----

def moves(run):
    run.table.title("Short moves: periods within 5 %; bows and raises have no cycle; kicks, punches "
                    "and slashes are counted")
    table = (run.data / "labels" / "moves.csv").read_text().splitlines()
    for row in csv.DictReader(table):
        clip = run.stltsa.read_clip(str(run.data / "moves" / row["file"]))
        answer = run.answer(clip)
        cycles = len(answer["cycles"])
        checks = [(problem, False) for problem in problems(answer, len(clip))]
        if row["period_s"]:
            error = (answer["period_s"] or np.inf) / float(row["period_s"]) - 1
            checks.append((f"period off by {100 * error:+.1f} %", abs(error) <= 0.05))
        elif row["kind"] in ("bow", "raise-up-right-hand"):
            checks.append((f"{cycles} cycles", cycles == 0))
        elif row["kind"] in ("kick", "punch", "slash"):
            count = len(answer["repetitions"])
            checks.append((f"{count} repetitions", count >= 2))
        elif "walk-back" in row["file"]:
            checks.append((f"{cycles} cycle", cycles == 1))
        name = row["file"].removesuffix(".bvh")
        kinds = ", ".join(f"{s['kind']} {s['count']}" for s in answer["segments"])
        if checks:
            run.table.row(name, checks, kinds)
        else:
            run.table.figure(name, kinds)


# ---- Markers ----

def markers(run):
    run.table.title("Markers: all annotated strides but one at each end; no standing between heel "
                    "strikes")
    for path in sorted((run.data / "markers").glob("*.c3d")):
        clip = run.stltsa.read_clip(path)
        answer = run.answer(measuring.without_events(run.stltsa, clip))
        strikes = heel_strikes(clip.events)
        checks = [strides(side, times, answer) for side, times in strikes.items()]
        begin, end = (f(t for times in strikes.values() for t in times) for f in (min, max))
        standing = sum(max(0, min(end, u["end_s"]) - max(begin, u["begin_s"]))
                       for u in answer["units"] if u["kind"] in ("preparing", "wind-up", "hold"))
        checks.append((f"stands {standing:.2f} s between", standing <= 0.1))
        run.table.row(path.stem, checks)


def heel_strikes(events):
    """{side: seconds}; the label or the context of an event is LHS or RHS."""
    return {side: [e.seconds for e in events if side in (e.label, e.context)]
            for side in ("LHS", "RHS")}


def strides(side, strikes, answer):
    """Strides from strike to strike that lie within cycles, of which one is as long."""
    held = []
    for a, b in zip(strikes[:-1], strikes[1:]):
        inside = [c for c in answer["cycles"] if c["begin_s"] < b and c["end_s"] > a]
        covered = sum(min(b, c["end_s"]) - max(a, c["begin_s"]) for c in inside)
        alike = any(abs((c["end_s"] - c["begin_s"]) / (b - a) - 1) <= 0.15 for c in inside)
        held.append(alike and covered >= 0.95 * (b - a))
    return f"{sum(held)} of {len(held)} {side}", all(held[1:-1])
