# SPDX-License-Identifier: BSD-3-Clause
"""HTML for results in notebooks."""

from __future__ import annotations

from html import escape
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING

from ._colors import UNIT_COLORS
from ._tables import html_table

if TYPE_CHECKING:
    from collections.abc import Iterable

    from ._rows import Part, Unit
    from .clip import Clip
    from .decomposition import Decomposition
    from .model import Model

_WIDTH, _HEIGHT = 600, 22


def _bar(unit: Unit, frames: int) -> str:
    x, width = (_WIDTH * v / frames for v in (unit.begin, unit.end - unit.begin))
    place = f"{unit.begin} .. {unit.end}"
    if isfinite(unit.begin_s):
        place = f"{unit.begin_s:.2f} s .. {unit.end_s:.2f} s"
    text = escape(f"{unit.kind} {place}")
    return (
        f'<rect x="{x:.1f}" width="{width:.1f}" height="{_HEIGHT}" '
        f'fill="{UNIT_COLORS[unit.kind]}"><title>{text}</title></rect>'
    )


def _margin(cycle: Part, frames: int) -> str:
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


def _row(unit: Unit) -> str:
    color = f'<span style="color:{UNIT_COLORS[unit.kind]}">&#9632;</span>'
    cells = (
        f"{color} {escape(unit.kind)}",
        f"{unit.begin}",
        f"{unit.end}",
        *map(_seconds, (unit.begin_s, unit.end_s, unit.duration_s)),
    )
    return "<tr>" + "".join(f"<td>{c}</td>" for c in cells) + "</tr>"


def _seconds(value: float) -> str:
    return f"{value:.2f}" if isfinite(value) else "?"


def _paragraphs(texts: Iterable[str]) -> str:
    return "".join(f"<p>{escape(t)}</p>" for t in texts if t)


def decomposition(result: Decomposition) -> str:
    """Return a timeline of the units, their table, and the reason and warnings."""
    titles = ("unit", "begin", "end", "from s", "to s", "length s")
    head = "".join(f"<th>{h}</th>" for h in titles)
    rows = "".join(map(_row, result.unit_list))
    facts = f"{len(result.cycle_list)} cycles"
    if result.period_frames:
        known = isfinite(result.period)
        period = f"{result.period:.3f} s" if known else f"{result.period_frames:.1f} frames"
        facts += f", period {period}, cyclicity {result.cyclicity:.2f}"
    return (
        f"<div>{_timeline(result)}<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody>"
        f"</table>{_paragraphs((facts, result.reason, *result.warnings))}</div>"
    )


def _facts(title: str, rows: Iterable[tuple[str, str]], texts: Iterable[str] = ()) -> str:
    table = html_table([(title, ""), *rows])
    return f"<div>{table}{_paragraphs(texts)}</div>"


def clip(motion: Clip) -> str:
    """Return the facts about a clip as a table, and the library's notes."""
    rows = [("frames", f"{len(motion)}")]
    if motion.fps:
        rows += [("duration", f"{motion.duration:.2f} s"), ("rate", f"{motion.fps:g} fps")]
    if motion.joints:
        rows += [("joints", f"{len(motion.joints)}")]
    rows += [("channels", f"{motion.channels}"), ("format", motion.format)]
    name = Path(motion.path).name if motion.path else "Clip"
    return _facts(name, rows, motion.facts.get("note", ()))


def model(fitted: Model) -> str:
    """Return the facts about a model as a table, and its warnings."""
    rate = fitted.fps

    def length(samples: int) -> str:
        return f"{samples} ({samples / rate:.2f} s)" if rate else f"{samples}"

    rows = [
        ("rows", length(len(fitted))),
        ("features", f"{fitted.n_features}"),
        ("coordinates", f"{fitted.dimension}"),
        ("mode", fitted.mode),
        ("neighbors", length(fitted.neighbors)),
        ("window", length(fitted.window)),
        ("components", f"{fitted.n_components}"),
    ]
    if fitted.period:
        rows.append(("period", f"{fitted.period:.3f} s"))
    return _facts("Model", rows, fitted.warnings)
