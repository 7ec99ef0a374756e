# SPDX-License-Identifier: BSD-3-Clause
"""For each leaf of a schema, the functions of the C interface that return it; lists are in the
JSON's order."""

import ctypes
import math
from ctypes import byref, c_char_p, c_double, c_int32, c_int64, c_void_p, sizeof
from math import isnan

from library import (
    FileEvent, Handle, Interval, Joint, Out, Part, Seam, Segment, Statistics, Summary, Travel, call, value)


class Missing:
    """Stands for everything below a null."""


def positive(number):
    return number if number > 0 else None


def chosen(number):
    return number if number >= 0 else None


def finite(numbers):
    return [number if math.isfinite(number) else None for number in numbers]


def number(found):
    return found if math.isfinite(found) else None


def text(found):
    return found or None


CLIP = {
    "path": lambda h: text(h["path"]),
    "format": lambda h: h.choice("format"),
    "frames": lambda h: h["clip_frames"],
    "fps": lambda h: positive(h["clip_fps"]),
    "duration_s": lambda h: h["clip_frames"] / h["clip_fps"],
    "features": lambda h: h.choice("features"),
    "dropped_start_frames": lambda h: h["first_frame"],
    "notes": lambda h: h.list("note"),
}
SAMPLES = {
    "count": lambda h: h["rows"],
    "first_frame": lambda h: h["first_frame"],
    "frame_step": lambda h: h["frame_step"],
    "fps": lambda h: positive(h["fps"]),
    "feature_count": lambda h: h["feature_count"],
    "up_axis": lambda h: h.choice("up_axis"),
    "smoothing_s": lambda h: h["smoothing"],
}
LENGTHS = {"samples.lengths": lambda h: h.list("length")}
SEARCH = {
    "period_min_s": lambda h: positive(h["period_min"]),
    "period_max_s": lambda h: positive(h["period_max"]),
}


def recurrent(name):
    return lambda h: h[name] if h.list("mode") and h.choice("mode") == "recurrent" else None


FIT = {
    "mode": lambda h: h.choice("mode") if h.list("mode") else None,
    "neighbors": lambda h: h.maybe("neighbors"),
    "window": lambda h: h.maybe("window"),
    "dimension": lambda h: h.maybe("dimension"),
    "include_self": lambda h: bool(h["include_self"]) if h.list("mode") else None,
    "links": recurrent("links"),
    "exclusion": recurrent("exclusion"),
}
PERIOD = {"period_s": lambda h: positive(h["period"])}
WARNINGS = {"warnings": lambda h: h.list("warning")}


def below(key, facts):
    return {f"{key}.{name}": fact for name, fact in facts.items()}


def channels(h):
    return value("clip_channels", c_int64, h.pointer)


def joints(field):
    def of(h):
        for joint in range(value("clip_joints", c_int64, h.pointer)):
            found = Joint(size=sizeof(Joint))
            call("clip_joint", h.pointer, c_int64(joint), byref(found))
            yield {"name": found.name.decode(), "parent": chosen(found.parent),
                   "end_site": bool(found.is_end_site)}[field]

    return lambda h: list(of(h))


def file_events(field):
    def of(h):
        for index in range(value("clip_event_count", c_int64, h.pointer)):
            found = FileEvent(size=sizeof(FileEvent))
            call("clip_event", h.pointer, c_int64(index), byref(found))
            told = getattr(found, field)
            yield told.decode() if isinstance(told, bytes) else told

    return lambda h: list(of(h))


def feature_count(h):
    count = c_int64()
    call("clip_feature_count", h.pointer, None, byref(count))
    return count.value


def intervals(function):
    def of(field):
        return lambda h: [getattr(i, field) for i in h.rows(function, Interval())]

    return {f"{function}s.{f}": of(f) for f in ("begin", "end", "begin_s", "end_s")}


def unit_kinds(h):
    return [value("unit_name", c_char_p, i.kind).decode() for i in h.rows("unit", Interval())]


def letters(label):
    return None if label < 0 else chr(ord("A") + label)


def segments(field, convert=lambda found: found):
    return lambda h: [convert(getattr(s, field)) for s in h.rows("segment", Segment())]


def of_segments(function, restype):
    """One value of each segment by a function that takes its index."""
    return lambda h: [value(function, restype, h.pointer, c_int64(i))
                      for i in range(len(list(h.rows("segment", Segment()))))]


def carriers(h):
    return [value("decomposition_carrier", c_char_p, h.pointer, c_int64(s), c_int64(i)).decode()
            for s, count in enumerate(of_segments("decomposition_carrier_count", c_int64)(h))
            for i in range(count)]


def parts(kind, field, convert=lambda found: found):
    def of(h):
        count = value("decomposition_part_count", c_int64, h.pointer, c_int32(kind))
        for index in range(count):
            found = Part()
            call("decomposition_part", h.pointer, c_int32(kind), c_int64(index), byref(found))
            yield convert(getattr(found, field))

    return lambda h: list(of(h))


def travels(kind, name):
    """Key and getter of each fact of the travel of the parts of a kind."""
    def of(field):
        def get(h):
            for index in range(len(parts(kind, "begin")(h))):
                found = Travel()
                call("decomposition_travel", h.pointer, c_int32(kind), c_int64(index), byref(found))
                yield Missing if isnan(found.way) else number(getattr(found, field))

        return lambda h: list(get(h))

    return {f"{name}.{key}": of(field) for key, field in
            (("way", "way"), ("stride", "stride"), ("speed", "speed"), ("turn_deg", "turn"))}


def found_statistics(h, label, kind, side, quantity):
    found = Statistics()
    call("decomposition_statistics", h.pointer, c_int32(kind), c_int32(label), c_int32(side),
         c_int32(quantity), byref(found))
    return found


def statistics(kinds, quantity, field, side=-1):
    """Of the first kind that each label has."""
    def of(h, label):
        for kind in kinds:
            found = found_statistics(h, label, kind, side, quantity)
            if found.count > 0:
                return number(getattr(found, field))
        return Missing

    return lambda h: [of(h, label) for label in summaries("label")(h)]


def cadence(h):
    found = [found_statistics(h, label, 2, -1, 1) for label in summaries("label")(h)]
    return [60 / steps.mean if steps.count > 0 else None for steps in found]


def both_sides(h):
    sides = [statistics((2,), 1, "mean", side)(h) for side in (0, 1)]
    return [mean for means in zip(*sides) for mean in (means if Missing not in means else [Missing])]


def labels_of_parts(kind):
    return lambda h: [letters(segments("label")(h)[s]) for s in parts(kind, "segment")(h)]


def summaries(field):
    def of(h):
        for index in range(value("decomposition_summary_count", c_int64, h.pointer)):
            found = Summary()
            call("decomposition_summary", h.pointer, c_int64(index), byref(found))
            yield getattr(found, field)

    return lambda h: list(of(h))


def first_step(which):
    def of(h):
        for index in range(value("decomposition_segment_count", c_int64, h.pointer)):
            found = [c_double(), c_double()]
            call("decomposition_first_step", h.pointer, c_int64(index), *map(byref, found))
            yield number(found[which].value)

    return lambda h: list(of(h))


def side_names(kind):
    def name(h, side):
        named = value("decomposition_side", c_int32, h.pointer, c_int32(side))
        return None if named < 0 else ("left", "right")[named]

    return lambda h: [name(h, side) for side in parts(kind, "side")(h)]


def label_likeness(h):
    labels = 1 + max(segments("label")(h), default=-1)
    found = c_double()
    for label in range(labels):
        for other in range(labels):
            call("decomposition_label_likeness", h.pointer, c_int32(label), c_int32(other),
                 byref(found))
            yield number(round(found.value, 3))


SPAN = ("begin", "end", "begin_s", "end_s")
SEGMENTS = {
    "kind": segments("kind", lambda kind: value("segment_name", c_char_p, kind).decode()),
    "label": segments("label", letters),
    "likeness": segments("likeness", number),
    **{field: segments(field) for field in (*SPAN, "count", "confidence")},
    "period_s": segments("period_s", positive),
    "candidate_period_s": segments("candidate_period_s", positive),
    "carried_by": carriers,
    "open_begin": segments("open_begin", bool),
    "open_end": segments("open_end", bool),
    "begin_confidence": segments("begin_confidence", number),
    "first_step_share": first_step(0),
    "first_step_margin": first_step(1),
    "steps_reason": lambda h: [text(reason.decode()) for reason in
                               of_segments("decomposition_steps_reason", c_char_p)(h)],
    "reason": lambda h: [text(reason.decode()) for reason in
                         of_segments("decomposition_segment_reason", c_char_p)(h)],
}
CYCLES = {
    **{field: parts(1, field) for field in (*SPAN, "segment", "confidence")},
    "side": parts(1, "side", chosen),
    "side_name": side_names(1),
    "likeness": parts(1, "likeness", number),
    **travels(1, "travel"),
}
STEPS = {
    **{field: parts(2, field) for field in (*SPAN, "segment", "side")},
    "cycle": parts(2, "parent"),
    "side_name": side_names(2),
    **travels(2, "travel"),
}
REPETITIONS = {
    **{field: parts(3, field) for field in (*SPAN, "segment", "confidence")},
    "label": labels_of_parts(3),
    "likeness": parts(3, "likeness", number),
    **travels(3, "travel"),
}
SUMMARY = {
    "label": lambda h: [letters(label) for label in summaries("label")(h)],
    "count": summaries("count"),
    "cycles_per_min": summaries("per_minute"),
    **{f"cycle_time_s.{name}": summaries(field) for name, field in
       (("mean", "mean_s"), ("sd", "sd_s"), ("cv", "cv"), ("trend", "trend"))},
    "steps_per_min": cadence,
    "step_time_s.side_means": both_sides,
    **{f"{name}.{field}": statistics(kinds, quantity, field)
       for name, kinds, quantity in (("step_time_s", (2,), 1), ("way", (1, 3), 2),
                                     ("stride", (1, 3), 3), ("speed", (1, 3), 4),
                                     ("turn_deg", (1, 3), 5))
       for field in ("mean", "sd", "cv", "trend")},
}
TIMED_WARNINGS = {
    "warnings.code": lambda h: h.list("warning_code"),
    "warnings.text": lambda h: h.list("warning"),
    "warnings.begin_s": lambda h: [number(at) for at in h.list("warning_begin")],
    "warnings.end_s": lambda h: [number(at) for at in h.list("warning_end")],
}


def cycle(name):
    def of(field):
        def fact(h):
            found = Interval()
            call("decomposition_cycle", h.pointer, c_int64(h[name]), byref(found))
            return getattr(found, field)

        return fact

    return {"index": lambda h: h[name],
            **{f: of(f) for f in ("begin", "end", "begin_s", "end_s")}}


def eigenvalues(h):
    shape = len(h.list("component_rows")), h["dimension"] + 2
    data = (c_double * (shape[0] * shape[1]))()
    out = Out(ctypes.cast(data, c_void_p), *shape, 0, 0, 2, 0)
    call("model_eigenvalues", h.pointer, byref(out))
    return finite(data)


def seams(field):
    return lambda h: [getattr(s, field) for s in h.rows("seam", Seam())]


def in_seconds(field):
    return lambda h: [getattr(s, field) / made(h)["clip_fps"] for s in h.rows("seam", Seam())]


class Made(Handle):
    """The clip that belongs to a synthesis."""

    def __init__(self, synthesis):
        self.kind = "clip"
        self.pointer = c_void_p(value("synthesis_clip", c_void_p, synthesis.pointer))
        self.info = c_void_p(value("clip_info", c_void_p, self.pointer))


def made(h):
    return Made(h)


FACTS = {
    "clip": {
        **below("clip", CLIP),
        "clip.unit": lambda h: text(h["unit"]),
        "clip.up_axis": lambda h: h.choice("file_up_axis"),
        **{f"clip.events.{f}": file_events(f) for f in ("frame", "seconds", "label", "context")},
        "channels.count": channels,
        "channels.names": lambda h: h.list("channel"),
        **{f"joints.{f}": joints(f) for f in ("name", "parent", "end_site")},
        "up_axis": lambda h: h.choice("up_axis"),
        "feature_count": feature_count,
    },
    "model": {
        **below("clip", CLIP),
        **below("samples", SAMPLES),
        **LENGTHS,
        **below("parameters", {**FIT, **SEARCH}),
        **PERIOD,
        "time_correlation": lambda h: h["time_correlation"],
        "repeated_frames": lambda h: h["repeated"],
        "components.frames": lambda h: h.list("component_rows"),
        "components.eigenvalues": eigenvalues,
        "components.residual": lambda h: h.list("residual"),
        "components.error_estimate_rad": lambda h: h.list("error_estimate"),
        "components.gap": lambda h: finite(h.list("gap")),
        "components.rank_deficient_windows": lambda h: h.list("rank_deficient"),
        "components.solves": lambda h: h.list("solves"),
        **WARNINGS,
    },
    "dimension": {
        **below("clip", CLIP),
        **below("samples", SAMPLES),
        **below("parameters", {**FIT, **SEARCH}),
        **PERIOD,
        "local_pca.dimension": lambda h: positive(h["local_pca"]),
        "local_pca.reason": lambda h: text(h["local_pca_reason"]),
        "local_pca.variance": lambda h: h["variance"],
        "local_pca.shares": lambda h: h.list("local_variance"),
        "eigengap.dimension": lambda h: positive(h["eigengap"]),
        "eigengap.reason": lambda h: text(h["eigengap_reason"]),
        "eigengap.threshold": lambda h: h["eigengap_threshold"],
        "eigengap.eigenvalues": lambda h: h.list("eigenvalue"),
    },
    "decomposition": {
        **below("clip", CLIP),
        **below("samples", SAMPLES),
        **below("parameters", {**FIT, **SEARCH}),
        "embedding.eigenvalues": lambda h: h.list("eigenvalue"),
        "embedding.tangent_dimension": lambda h: h.maybe("dimension"),
        "embedding.coordinate": lambda h: positive(h["coordinate"]),
        "embedding.cyclicity": lambda h: h["cyclicity"],
        **PERIOD,
        "lag_quality": lambda h: h["lag_quality"],
        **below("segments", SEGMENTS),
        "label_likeness": lambda h: list(label_likeness(h)),
        "units.kind": unit_kinds,
        "units.segment": lambda h: [i.segment for i in h.rows("unit", Interval())],
        **intervals("unit"),
        **below("cycles", CYCLES),
        **below("steps", STEPS),
        **below("repetitions", REPETITIONS),
        **below("summary", SUMMARY),
        **below("representative_cycle", cycle("representative")),
        **below("best_cycle", cycle("best")),
        "reason": lambda h: text(h["reason"]),
        **TIMED_WARNINGS,
    },
    "denoising": {
        **below("clip", CLIP),
        **below("samples", SAMPLES),
        **LENGTHS,
        **below("fit", FIT),
        "fit.period_min_s": lambda h: positive(h["fit_period_min"]),
        "fit.period_max_s": lambda h: positive(h["fit_period_max"]),
        **PERIOD,
        "parameters.gamma": lambda h: h.maybe("gamma_option"),
        "parameters.knot_rows": lambda h: h["knot_rows"],
        "parameters.knot_s": lambda h: h["knot_rows"] / h["fps"],
        "parameters.robust": lambda h: bool(h["robust"]),
        **below("parameters", SEARCH),
        "columns.gamma": lambda h: h.list("gamma"),
        "columns.shift": lambda h: h.list("shift"),
        "columns.noise": lambda h: h.list("noise"),
        "columns.noise_share": lambda h: h.list("noise_share"),
        "nothing_to_clean": lambda h: bool(h["nothing_to_clean"]),
        "columns.degrees_of_freedom": lambda h: h.list("degrees_of_freedom"),
        "columns.moved": lambda h: h.list("moved"),
        **WARNINGS,
    },
    "synthesis": {
        "clip.format": lambda h: made(h).choice("format"),
        "clip.frames": lambda h: made(h)["clip_frames"],
        "clip.fps": lambda h: made(h)["clip_fps"],
        "clip.duration_s": lambda h: made(h)["clip_frames"] / made(h)["clip_fps"],
        "pieces.path": lambda h: [text(path) for path in h.list("piece_path")],
        "pieces.begin": lambda h: h.list("piece_begin"),
        "pieces.end": lambda h: h.list("piece_end"),
        "pieces.repeat": lambda h: h.list("piece_repeat"),
        "parameters.crossfade_s": lambda h: h.maybe("crossfade"),
        "parameters.cut_range_s": lambda h: h.maybe("cut_range"),
        "parameters.posture_limit": lambda h: positive(h["posture_limit"]),
        "parameters.up_axis": lambda h: h.choice("up_axis"),
        **{f"seams.{f}": seams(f) for f, _ in Seam._fields_[1:]},
        "seams.time_s": in_seconds("frame"),
        "seams.crossfade_s": in_seconds("crossfade"),
        "seams.wrap": lambda h: [frame == made(h)["clip_frames"] for frame in seams("frame")(h)],
        "loop.in_place": lambda h: bool(h["in_place"]),
        "loop.travel": lambda h: h.list("travel"),
        "loop.distance": lambda h: math.hypot(*h.list("travel")),
        "loop.turn_deg": lambda h: h["turn"],
        "loop.coverage": lambda h: h["coverage"],
        "loop.cycles": lambda h: h.maybe("loop_cycles"),
        "loop.source_cycles": lambda h: h.maybe("source_cycles"),
        "loop.notes": lambda h: [text(note) for note in h.list("note")],
        **WARNINGS,
    },
}
