# SPDX-License-Identifier: BSD-3-Clause
"""Answers made from the truth, to test the scores."""

from .synthetic import CARRIED


def interval(recording, begin, end):
    return {"begin": round(begin * recording.fps), "end": round(end * recording.fps),
            "begin_s": begin, "end_s": end}


def answer(recording):
    """What a perfect library would say."""
    parts = recording.parts
    ends = [0, *[part.end for part in parts[:-1]], recording.seconds]
    labels = {}
    for part in parts:
        if part.moving:
            labels.setdefault(part.label, chr(ord("A") + len(labels)))
    result = {"format": "stltsa-decomposition/2", "segments": [], "units": [], "cycles": [],
              "repetitions": [], "steps": [], "summary": [], "warnings": [], "reason": None,
              "period_s": None}
    for i, (part, begin, end) in enumerate(zip(parts, ends[:-1], ends[1:])):
        kind = "action" if part.kind == "free" else part.kind
        where = interval(recording, begin, end)
        label = labels.get(part.label) if part.moving else None
        count = {"cyclic": len(part.cycles), "repetitions": len(part.repetitions),
                 "action": 1, "rest": 0}[kind]
        result["segments"].append({"kind": kind, "label": label, "count": count, **where,
                                   "confidence": 0.97, "begin_confidence": 0.97, "reason": None,
                                   "period_s": None, "candidate_period_s": None,
                                   "likeness": None, "carried_by": list(CARRIED.get(part.label, []))})
        result["units"].append({"kind": "cyclic" if kind == "cyclic" else "action", "segment": i,
                                **where})
        result["cycles"] += [{"segment": i, **interval(recording, a, b), "confidence": 0.97}
                             for a, b in part.cycles]
        result["repetitions"] += [{"segment": i, "label": label, **interval(recording, a, b),
                                   "confidence": 0.97} for a, b in part.repetitions]
    return result
