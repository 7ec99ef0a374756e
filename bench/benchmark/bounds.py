# SPDX-License-Identifier: BSD-3-Clause
"""What a stage of a temporal fit cannot do without, and how long the machine needs for that.

n frames of m features, k neighbors of w frames to each side, d coordinates; s applications of the
inverse operator, as many as ARPACK asked for. docs/benchmark.md says where the terms come from.
"""

import dataclasses

from tasks import DIMENSION

SPARE_VECTORS = 5  # that ARPACK keeps beyond twice the wanted ones
SPARE_COLUMNS = 2  # of the block that finds the tangents, beyond d
LEAST_PRODUCTS = 5  # with that block, before it may stop
LEAST_PRODUCTS_FOLLOWING = 3  # where it starts from what the frame before ended with
PASSES = 2  # through all patches, for the certificate
MANY, LONGEST = 1 << 18, 1 << 17  # frames, entries of ARPACK's vectors: as in src/ltsa/embed.cpp
WIDE = 64  # as in src/ltsa/alignment_difference.cpp: from there on from one end only


@dataclasses.dataclass(frozen=True)
class Size:
    n: int
    m: int
    k: int
    w: int
    d: int
    s: int


@dataclasses.dataclass(frozen=True)
class Work:
    """Of one frame."""

    operations: float  # additions and multiplications
    moved: float  # bytes into and out of the core
    resident: float  # bytes that are gone through, maybe more than once
    steps: float = 0  # of triangular solves, each waiting for the one before
    additions: float = 0  # likewise


def neighbors_and_tangents(size):
    m, k, d = size.m, size.k, size.d
    columns = d + SPARE_COLUMNS
    side = min(k, m)
    apart = 2 * size.w if k <= m else size.w  # frames whose distance is needed
    form = 3 * m * apart + (2 * k * k if k <= m else 2 * m * (m + 1) + 2 * k * m * d)
    products = LEAST_PRODUCTS if k <= m else LEAST_PRODUCTS_FOLLOWING
    find = products * 2 * side * columns * (side + columns)
    data = 8 * m + 4 * k + 8 * k * d
    return Work(form + find, data, data)


def alignment(size):
    k, d = size.k, size.d
    assemble, factor = d * k * (k - 1), k * (k - 1)
    patches, matrix = 4 * k + 8 * k * d, 8 * k
    return Work(assemble + factor, patches + 3 * matrix, patches + matrix)


def spectrum(size):
    k, d, s = size.k, size.d, size.s
    pairs = d + 1
    vectors = min(s, 2 * pairs + SPARE_VECTORS) * (LONGEST / size.n if size.n > MANY else 1)
    steps = (2 * s + 4) / (2 if k - 1 < WIDE else 1)
    iterate = 4 * k * s + 2 * vectors * s
    certify = 8 * k * pairs + PASSES * pairs * k * (8 * d + 6)
    patches, matrix = 4 * k + 8 * k * d, 8 * k
    moved = (2 * matrix + 8 * vectors) * s + 4 * matrix + PASSES * patches
    return Work(iterate + certify, moved, matrix + 8 * vectors + patches, steps, 4 * s)


# What the library calls a stage, and what a temporal fit does in it.
STAGES = {"tangents": ("neighbors and tangents", neighbors_and_tangents),
          "alignment": ("alignment", alignment), "spectrum": ("spectrum", spectrum)}


def stream_rate(peaks, resident):
    """Of the largest stream that is no longer: what is nearer to the core is no slower."""
    first, *longer = peaks["streams"]
    fitting = [stream for stream in longer if stream["size"] <= resident]
    return [first, *fitting][-1]["rate"]


def limits(work, n, peaks):
    """Seconds that each of the three takes at least."""
    return {"arithmetic": n * work.operations / peaks["fused"],
            "memory": n * work.moved / stream_rate(peaks, n * work.resident),
            "latency": n * (work.steps * peaks["step"] + work.additions * peaks["addition"])}


def stage_bounds(fit, peaks):
    """For each stage of a fit: measured seconds, the three limits, and the largest of them."""
    n, k = fit["n"], fit["k"]
    size = Size(n, fit["features"], k, k, DIMENSION, fit["solves"])
    rows = []
    for stage, (name, work_of) in STAGES.items():
        work = work_of(size)
        seconds = limits(work, n, peaks)
        kind = max(seconds, key=seconds.get)
        rows.append({"stage": name, "n": n, "k": k, "seconds": fit["stages"][stage],
                     "limits": seconds, "kind": kind, "bound": seconds[kind],
                     "operations": n * work.operations, "bytes": n * work.moved})
    return rows
