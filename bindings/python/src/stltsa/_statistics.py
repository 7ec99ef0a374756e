# SPDX-License-Identifier: BSD-3-Clause
"""Statistics of the parts of a decomposition."""

from __future__ import annotations

import itertools
from typing import Any, NamedTuple

from ._call import check
from ._facts import row_of
from ._native import ffi, lib
from ._rows import Statistics
from ._text import names

_KINDS = {
    "cycle": lib.STLTSA_INFO_CYCLE,
    "step": lib.STLTSA_INFO_STEP,
    "repetition": lib.STLTSA_INFO_REPETITION,
}
_QUANTITIES = names("STLTSA_QUANTITY_")


class PartStatistics(NamedTuple):
    """Mean, standard deviation and trend of one quantity of the parts of one label.

    `kind` is ``"cycle"``, ``"step"`` or ``"repetition"``; `side` 0 or 1, or -1 for both; `quantity`
    ``"time"`` (seconds), ``"path_length"``, ``"stride"``, ``"speed"`` or ``"turn"`` (see
    :class:`Part`). `cv` is ``sd / mean``, `trend` the relative change per minute; both are NaN of
    turns.
    """

    label: str
    kind: str
    side: int
    quantity: str
    number: int
    mean: float
    sd: float
    cv: float
    trend: float


def statistics_of(handle: Any, labels: list[str]) -> list[PartStatistics]:
    """Return a row for each label, kind, quantity and side that is known."""
    rows, raw = [], ffi.new("stltsa_statistics *")
    for number, kind, key, side in itertools.product(
        range(len(labels)), _KINDS, _QUANTITIES, (-1, 0, 1)
    ):
        given = _KINDS[kind], number, side, key
        check(lib.stltsa_decomposition_statistics(handle, *given, raw))
        if raw.count > 0:
            of = row_of(Statistics, raw)
            rows.append(PartStatistics(labels[number], kind, side, _QUANTITIES[key], *of))
    return rows


def in_frames(row: PartStatistics, rate: float) -> PartStatistics:
    """Return the row with frames instead of seconds; its trend, which is per minute, is NaN."""
    scale = {"time": rate, "speed": 1 / rate}.get(row.quantity, 1.0)
    return row._replace(mean=scale * row.mean, sd=scale * row.sd, trend=float("nan"))
