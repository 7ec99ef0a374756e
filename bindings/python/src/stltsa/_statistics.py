# SPDX-License-Identifier: BSD-3-Clause
"""Statistics of the parts of a decomposition."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING, Any

from ._call import check
from ._native import ffi, lib
from ._rows import Statistics, number_of

if TYPE_CHECKING:
    from collections.abc import Iterable

_KINDS = {
    "cycle": lib.STLTSA_PART_CYCLE,
    "step": lib.STLTSA_PART_STEP,
    "repetition": lib.STLTSA_PART_REPETITION,
}
_QUANTITIES = {
    "time": lib.STLTSA_QUANTITY_TIME,
    "way": lib.STLTSA_QUANTITY_WAY,
    "stride": lib.STLTSA_QUANTITY_STRIDE,
    "speed": lib.STLTSA_QUANTITY_SPEED,
    "turn": lib.STLTSA_QUANTITY_TURN,
}


def statistics_of(handle: Any, labels: Iterable[str]) -> list[Statistics]:
    """Return a row for each label, kind, quantity and side that is known."""
    rows, raw = [], ffi.new("stltsa_statistics *")
    for label, kind, quantity, side in itertools.product(labels, _KINDS, _QUANTITIES, (-1, 0, 1)):
        keys = (_KINDS[kind], number_of(label), side, _QUANTITIES[quantity])
        check(lib.stltsa_decomposition_statistics(handle, *keys, raw))
        if raw.count > 0:
            numbers = (raw.count, raw.mean, raw.sd, raw.cv, raw.trend)
            rows.append(Statistics(label, kind, side, quantity, *numbers))
    return rows


def in_frames(row: Statistics, rate: float) -> Statistics:
    """Return the row with frames instead of seconds; its trend, which is per minute, is NaN."""
    scale = {"time": rate, "speed": 1 / rate}.get(row.quantity, 1.0)
    return row._replace(mean=scale * row.mean, sd=scale * row.sd, trend=float("nan"))
