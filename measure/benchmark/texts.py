# SPDX-License-Identifier: BSD-3-Clause
"""Tables of a result as rows of cells, for the terminal and the docs."""

import re

SPEAKING = {"temporal": "temporal, k = w", "spatial": "all frames, k"}


def seconds(row):
    def digits(value):
        return f"{value:.3f}" if value < 10 else f"{value:.1f}"

    spread = "" if row["runs"] == 1 else f" ({digits(row['least'])}–{digits(row['most'])})"
    return digits(row["seconds"]) + spread


def program(row):
    name = row["program"]
    if row["threads"] > 1:
        name += f", {row['threads']} threads"
    return name if row["check"] else f"{name}, unchecked"


def memory(row):
    return f"{row['memory'] / 1e6:.0f}" if row.get("memory") else "–"


def in_pieces(row):
    """The larger number of neighbors that tapkee takes if the graph is disconnected."""
    found = re.search(r"not connected.*neighbors (\d+)", row.get("note", ""))
    return found and found[1]


def outcome(row, pieces):
    """Note on a fit; `pieces`: the graph of 12 neighbors is known to be disconnected."""
    if "failed" in row:
        quoted = re.search(r"Error message: '([^']*)'", row["failed"])
        return "then fails: " + (quoted[1] if quoted else row["failed"])
    if in_pieces(row):
        return f"disconnected graph: takes k = {in_pieces(row)}"
    if not row["check"] and pieces:
        return "embeds a disconnected graph"
    return ""


def comparison(result):
    """The fits of the comparison, ours first; times relative to the first row."""
    rows = list(result["comparison"].values())
    base = rows[0]["seconds"]
    pieces = any(in_pieces(row) for row in rows)
    yield ["program", "neighbors", "seconds", "relative time", "memory beyond the frames, MB", "note"]
    for row in rows:
        times = row["seconds"] / base
        shown = "–" if "failed" in row else f"{times:.1f}" if times < 10 else f"{times:.0f}"
        yield [program(row), f"{SPEAKING[row['mode']]} = {row['k']}", seconds(row), shown,
               memory(row), outcome(row, pieces)]


def summary(result):
    """Sentences for the README: the task shared with the others, and a temporal fit."""
    fits = result["comparison"]
    ours, own = fits["all"], fits["temporal"]
    angle = {row["program"]: row["angle"] for row in result["angles"] if row["to"] == "stltsa"}
    peers = [f"{1e3 * ours['seconds']:.0f} ms"]
    for key in ("sklearn", "tapkee"):
        if key in fits and "failed" not in fits[key]:
            row = fits[key]
            peers.append(f"{row['program']} {row['seconds']:.1f} s "
                         f"({row['seconds'] / ours['seconds']:.0f} times as long; the angle between "
                         f"the embeddings is {angle[row['program']]:.0e})")
    return (f"For {ours['n']} frames of {ours['features']} features with {ours['k']} neighbors, one "
            f"thread, this takes {', '.join(peers)}. A temporal fit of the same frames with "
            f"{own['k']} neighbors takes {1e3 * own['seconds']:.0f} ms. `scripts/benchmark` measures "
            "this; [docs/benchmark.md](docs/benchmark.md) has the rest.")


def claims(result):
    yield ["claim", "measured", "limit", "result"]
    for claim in result["claims"]:
        small = claim["value"] < 1e-3
        spread = claim["spread"]
        text = f"{claim['value']:.1e}" if small else f"{claim['value']:.4g}"
        if spread:
            text += f" ({spread[0]:.3g}–{spread[1]:.3g})"
        limit = f"{'≥' if claim['at_least'] else '≤'} {claim['limit']:g}"
        unit = claim["unit"]
        yield [claim["claim"], f"{text} {unit}".strip(), f"{limit} {unit}".strip(),
               "holds" if claim["holds"] else "MISSED"]


def angles(result):
    yield ["program", "neighbors", "frames", "compared with", "angle, rad"]
    for row in result["angles"]:
        to = "exact embedding" if row["to"] == "exact" else row["to"]
        yield [row["program"], f"{SPEAKING[row['mode']]} = {row['k']}", f"{row['n']}", to,
               f"{row['angle']:.1e}"]


def growth(result):
    yield ["program", "neighbors", "frames", "seconds", "µs per frame", "frames, MB",
           "memory beyond the frames, MB"]
    rows = result["growth"]
    for row in rows + [row for row in result["neighbors"] if row not in rows]:
        each = "–" if "failed" in row else f"{1e6 * row['seconds'] / row['n']:.2f}"
        time = row["failed"] if "failed" in row else seconds(row)
        yield [program(row), f"{SPEAKING[row['mode']]} = {row['k']}", f"{row['n']}", time, each,
               f"{row['input'] / 1e6:.1f}", memory(row)]


def stages(result):
    """Time of each stage of a fit on one thread, by number of neighbors."""
    yield ["k = w", "stage", "µs per frame"]
    for fit in result["neighbors"]:
        if fit["threads"] == 1 and "failed" not in fit:
            for name, value in fit["stages"].items():
                yield [f"{fit['k']}", name, f"{1e6 * value / fit['n']:.3f}"]


def plain(rows):
    """Aligns the columns."""
    rows = [list(row) for row in rows]
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    for row in rows:
        yield "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()


def markdown(rows):
    rows = [list(row) for row in rows]
    yield "| " + " | ".join(rows[0]) + " |"
    yield "|" + "---|" * len(rows[0])
    for row in rows[1:]:
        yield "| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |"
