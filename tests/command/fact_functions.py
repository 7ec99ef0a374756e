# SPDX-License-Identifier: BSD-3-Clause
"""For each leaf of a schema, what the C interface says; lists are in the JSON's order."""

import math
from ctypes import byref, c_char_p, c_int64, c_void_p

from library import Handle, call, value


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


def below(key, facts):
    return {f"{key}.{name}": fact for name, fact in facts.items()}


def feature_count(h):
    count = c_int64()
    call("clip_feature_count", h.pointer, None, byref(count))
    return count.value


def plain(found):
    """A member of a row as in JSON: null for NaN."""
    if isinstance(found, bytes):
        return found.decode()
    return None if isinstance(found, float) and math.isnan(found) else found


def known(found):
    """An index, null for -1; a text, null for ""."""
    return text(found.decode()) if isinstance(found, bytes) else chosen(found)


def rows(name, member, convert=plain):
    return lambda h: [convert(getattr(row, member)) for row in h.list(name)]


def members(name, *plain_ones, **converted):
    """Facts of the members of a list's rows, by their names."""
    return {**{member: rows(name, member) for member in plain_ones},
            **{member: rows(name, member, convert) for member, convert in converted.items()}}


WARNINGS = {"warnings": rows("warning", "text")}


def carriers(h):
    found = []
    for names in rows("segment", "carried_by", lambda names: names)(h):
        index = 0
        while names[index] is not None:
            found.append(names[index].decode())
            index += 1
    return found


def named(function):
    """The name of a kind."""
    return lambda kind: value(function, c_char_p, c_int64(kind)).decode()


def travels(name):
    """Key and getter of each fact of the travel of the parts of a kind."""
    def of(member):
        return lambda h: [Missing if math.isnan(part.path_length) else plain(getattr(part, member))
                          for part in h.list(name)]

    return {f"travel.{member}": of(member) for member in ("path_length", "stride", "speed", "turn_deg")}


def statistics(name):
    """Of a quantity of each label; it is missing if no part has it."""
    def of(member):
        return lambda h: [plain(getattr(found, member)) if found.count > 0 else Missing
                          for found in rows("summary", name, lambda found: found)(h)]

    return {f"{name}.{member}": of(member) for member in ("mean", "sd", "cv", "trend")}


def both_sides(h):
    return [mean for found in h.list("summary")
            for mean in ((found.step_time_side_0_s, found.step_time_side_1_s) if found.step_time_s.count > 0
                         else (Missing,))]


def label_likeness(h):
    return [plain(round(found, 3)) for found in h.array("label_likeness")]


SPAN = ("begin", "end", "begin_s", "end_s")
SEGMENTS = {
    **members("segment", *SPAN, "likeness", "count", "confidence", "period_s", "candidate_period_s",
              "begin_confidence", "first_step_share", "first_step_margin", kind=named("segment_name"),
              open_begin=bool, open_end=bool, steps_reason=known, reason=known),
    "label": rows("segment", "letters", known),
    "carried_by": carriers,
}
CYCLES = {
    **members("cycle", *SPAN, "segment", "confidence", "likeness", side=chosen, side_name=known),
    **travels("cycle"),
}
STEPS = {
    **members("step", *SPAN, "segment", "cycle", "side", side_name=known),
    **travels("step"),
}
REPETITIONS = {
    **members("repetition", *SPAN, "segment", "confidence", "likeness"),
    "label": rows("repetition", "letters", known),
    **travels("repetition"),
}
SUMMARY = {
    **members("summary", "count", "cycles_per_min", "steps_per_min"),
    "label": rows("summary", "letters", known),
    "step_time_s.side_means": both_sides,
    **{key: fact for name in ("cycle_time_s", "step_time_s", "path_length", "stride", "speed", "turn_deg")
       for key, fact in statistics(name).items()},
}


def cycle(name):
    return {"index": lambda h: h[name],
            **{member: lambda h, member=member: getattr(h.list("cycle")[h[name]], member) for member in SPAN}}


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
        "clip.unit": lambda h: text(h["length_unit"]),
        "clip.up_axis": lambda h: h.choice("file_up_axis"),
        **below("clip.events", members("file_event", "frame", "seconds", "label", "context")),
        "channels.count": lambda h: h["channels"],
        "channels.names": lambda h: h.list("channel"),
        **below("joints", members("joint", "name", parent=chosen)),
        "joints.end_site": rows("joint", "is_end_site", bool),
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
        **below("components", members("component", "frames", "residual", "error_estimate_rad",
                                      "rank_deficient_windows", "solves")),
        "components.eigenvalues": lambda h: finite(h.array("eigenvalues")),
        "components.gap": lambda h: finite(rows("component", "gap")(h)),
        "local_pca.dimension": lambda h: positive(h["local_pca"]),
        "local_pca.reason": lambda h: text(h["local_pca_reason"]),
        "local_pca.variance": lambda h: h["variance"],
        "local_pca.shares": lambda h: h.list("local_variance"),
        "eigengap.dimension": lambda h: positive(h["eigengap"]),
        "eigengap.reason": lambda h: text(h["eigengap_reason"]),
        "eigengap.threshold": lambda h: h["eigengap_threshold"],
        "eigengap.eigenvalues": lambda h: h.list("eigenvalue"),
        **WARNINGS,
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
        "label_likeness": label_likeness,
        **below("units", members("unit", *SPAN, "segment", kind=named("unit_name"))),
        **below("cycles", CYCLES),
        **below("steps", STEPS),
        **below("repetitions", REPETITIONS),
        **below("summary", SUMMARY),
        **below("representative_cycle", cycle("representative")),
        **below("best_cycle", cycle("best")),
        "reason": lambda h: text(h["reason"]),
        **below("warnings", members("warning", "code", "text", "begin_s", "end_s")),
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
        **below("columns", members("column", "gamma", "shift", "noise", "noise_share", "degrees_of_freedom",
                                   "moved")),
        "nothing_to_clean": lambda h: bool(h["nothing_to_clean"]),
        **WARNINGS,
    },
    "synthesis": {
        "clip.format": lambda h: made(h).choice("format"),
        "clip.frames": lambda h: made(h)["clip_frames"],
        "clip.fps": lambda h: made(h)["clip_fps"],
        "clip.duration_s": lambda h: made(h)["clip_frames"] / made(h)["clip_fps"],
        **below("pieces", members("piece", "begin", "end", "repeat", path=known)),
        "parameters.crossfade_s": lambda h: h.maybe("crossfade"),
        "parameters.cut_range_s": lambda h: h.maybe("cut_range"),
        "parameters.posture_limit": lambda h: positive(h["posture_limit"]),
        "parameters.up_axis": lambda h: h.choice("up_axis"),
        **below("seams", members("seam", "frame", "time_s", "piece", "next", "cut_end", "cut_begin", "crossfade",
                                 "crossfade_s", "posture", "step", "acceleration", wrap=bool)),
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
