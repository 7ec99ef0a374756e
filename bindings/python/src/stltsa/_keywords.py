# SPDX-License-Identifier: BSD-3-Clause
# Made by scripts/generate-bindings: do not edit.
"""The library's options as keywords with types."""

from __future__ import annotations

import os  # noqa: TC003 (the keywords' types can be asked for)
from typing import Literal, TypeAlias, TypedDict

Auto: TypeAlias = Literal["auto"]
Seconds: TypeAlias = str  # such as "1.2s"
Mode: TypeAlias = Literal["temporal", "spatial", "recurrent"]
Features: TypeAlias = Literal["positions", "rotations6d", "euler", "raw", "points"]
UpAxis: TypeAlias = Literal["x", "y", "z"]
Gaps: TypeAlias = Literal["fill", "refuse", "skip"]


class Keywords(TypedDict, total=False):
    """Every option of the library."""

    neighbors: int | Seconds | Auto | None
    window: int | Seconds | Auto | None
    dimension: int | Auto | None
    mode: Mode
    include_self: bool
    links: int
    exclusion: int | Seconds | Auto | None
    threads: int | Auto | None
    features: Features | Auto | None
    up_axis: UpAxis | Auto | None
    keep_start: bool
    fps: float | Auto | None
    sample_rate: float
    smoothing: float | Seconds
    period_min: float | Seconds
    period_max: float | Seconds
    eigengap: float
    variance: float
    intrinsic: bool
    skeleton: str | os.PathLike[str] | Auto | None
    keep_frames: bool
    map_neighbors: int | Auto | None
    map_blend: int
    hint_window: int | Auto | None
    component: int | Auto | None
    gamma: float | Auto | None
    knot_spacing: float | Seconds | Auto | None
    robust: bool
    crossfade: float | Seconds | Auto | None
    cut_range: float | Seconds | Auto | None
    posture_limit: float
    segments: int | Auto | None
    gaps: Gaps
    min_confidence: float
    loop: bool
    in_place: bool
    individual: str | Auto | None
