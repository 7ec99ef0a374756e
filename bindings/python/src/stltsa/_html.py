# SPDX-License-Identifier: BSD-3-Clause
"""HTML for results in notebooks."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

from ._colors import UNIT_COLORS

if TYPE_CHECKING:
    from collections.abc import Iterable

    from .decomposition import Decomposition, Interval

_WIDTH, _HEIGHT = 600, 22


def _bar(interval: Interval, frames: int) -> str:
    x, width = (_WIDTH * v / frames for v in (interval.begin, interval.end - interval.begin))
    text = escape(f"{interval.kind} {interval.begin_s:.2f} s .. {interval.end_s:.2f} s")
    return (
        f'<rect x="{x:.1f}" width="{width:.1f}" height="{_HEIGHT}" '
        f'fill="{UNIT_COLORS[interval.kind]}"><title>{text}</title></rect>'
    )


def _margin(cycle: Interval, frames: int) -> str:
    x = _WIDTH * cycle.begin / frames
    return f'<path d="M{x:.1f} 0v{_HEIGHT}" stroke="#fff" stroke-width="1.5"/>'


def _timeline(result: Decomposition) -> str:
    frames = len(result.clip)
    bars = (_bar(u, frames) for u in result.unit_list)
    margins = (_margin(c, frames) for c in result.cycle_list)
    return (
        f'<svg viewBox="0 0 {_WIDTH} {_HEIGHT}" width="{_WIDTH}" height="{_HEIGHT}" '
        f'role="img" aria-label="units over time">{"".join((*bars, *margins))}</svg>'
    )


def _row(interval: Interval) -> str:
    color = f'<span style="color:{UNIT_COLORS[interval.kind]}">&#9632;</span>'
    cells = (
        f"{color} {escape(interval.kind)}",
        f"{interval.begin}",
        f"{interval.end}",
        f"{interval.begin_s:.2f}",
        f"{interval.end_s:.2f}",
    )
    return "<tr>" + "".join(f"<td>{c}</td>" for c in cells) + "</tr>"


def _paragraphs(texts: Iterable[str]) -> str:
    return "".join(f"<p>{escape(t)}</p>" for t in texts if t)


def decomposition(result: Decomposition) -> str:
    """Return a timeline of the units, their table, and the reason and warnings."""
    head = "".join(f"<th>{h}</th>" for h in ("unit", "begin", "end", "from s", "to s"))
    rows = "".join(map(_row, result.unit_list))
    facts = f"{len(result.cycle_list)} cycles"
    if result.period:
        facts += f", period {result.period:.3f} s, cyclicity {result.cyclicity:.2f}"
    return (
        f"<div>{_timeline(result)}<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody>"
        f"</table>{_paragraphs((facts, result.reason, *result.warnings))}</div>"
    )
