# SPDX-License-Identifier: BSD-3-Clause
"""The figure: time against frames, for this library and the others."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

# Okabe and Ito's colors, which color-blind readers can tell apart; markers differ as well.
ORANGE, GREEN, BLUE, RED, GRAY = "#E69F00", "#009E73", "#0072B2", "#D55E00", "#555555"
STYLE = {
    "font.size": 11, "font.family": "sans-serif", "axes.spines.top": False,
    "axes.spines.right": False, "axes.edgecolor": GRAY, "axes.labelcolor": "#222222",
    "xtick.color": GRAY, "ytick.color": GRAY, "axes.grid": True, "grid.color": "#E4E4E4",
    "grid.linewidth": 0.8, "axes.axisbelow": True, "svg.fonttype": "path",
    "svg.hashsalt": "libstltsa", "figure.facecolor": "white", "savefig.facecolor": "white",
}
# program, mode, threads: label at the first point, color, marker, line, position of the last time
LINES = {
    ("scikit-learn", "spatial", 1): ("scikit-learn", RED, "s", "-", (-8, 11)),
    ("tapkee", "spatial", 1): ("tapkee", ORANGE, "^", "-", (10, 5)),
    ("stltsa", "spatial", 1): ("stltsa,\nall frames", GREEN, "D", "-", (10, -6)),
    ("stltsa", "temporal", 1): ("stltsa,\ntemporal", BLUE, "o", "-", (10, 7)),
    ("stltsa", "temporal", 2): ("", BLUE, "o", ":", (10, -8)),
}


def readable(seconds):
    """For example: 5 ms, 1.3 s."""
    size, unit = (1, "s") if seconds >= 0.9995 else (1e-3, "ms")
    value = seconds / size
    return f"{value:.0f} {unit}" if value >= 10 else f"{value:.2g} {unit}"


def spaced(number):
    return f"{number:,.0f}".replace(",", "\N{THIN SPACE}")


def draw_line(axes, rows, label, color, marker, line, end):
    """Draws one program's times, and marks the first fit that was given up."""
    done = [row for row in rows if "failed" not in row]
    if not done:
        return
    n, time = [row["n"] for row in done], [row["seconds"] for row in done]
    spread = [[row["seconds"] - row["least"] for row in done],
              [row["most"] - row["seconds"] for row in done]]
    fill = "white" if line == ":" else color
    axes.errorbar(n, time, yerr=spread, color=color, marker=marker, linestyle=line, markersize=6,
                  linewidth=2, elinewidth=1, capsize=2, markerfacecolor=fill, zorder=3)
    text = {"textcoords": "offset points", "color": color, "va": "center"}
    axes.annotate(label, (n[0], time[0]), xytext=(-10, 0), ha="right", fontweight="bold", **text)
    note = "2 threads: " if line == ":" else ""
    axes.annotate(note + readable(time[-1]), (n[-1], time[-1]), xytext=end, ha="left",
                  fontsize=9.5, **text)
    for row in rows[len(done):]:
        if row["failed"].startswith("not done"):
            axes.plot([n[-1], row["n"]], [time[-1], row["seconds"]], color=color, linewidth=1,
                      linestyle=":")
            axes.annotate(f"> {readable(row['seconds'])}", (row["n"], row["seconds"]),
                          xytext=(0, 9), ha="center", fontsize=9.5, **text)


def time_figure(result):
    figure, axes = plt.subplots(figsize=(8.6, 5), layout="constrained")
    axes.set(xscale="log", yscale="log", xlabel="frames (56 features)", ylabel="one fit")
    for (program, mode, threads), style in LINES.items():
        draw_line(axes, [row for row in result["growth"] if row["program"] == program
                         and row["mode"] == mode and row["threads"] == threads], *style)
    low, high = axes.get_xlim()
    axes.set_xlim(low / (high / low) ** 0.21, high * (high / low) ** 0.19)  # room for labels
    bottom, top = axes.get_ylim()
    axes.set_ylim(bottom / 1.3, top * 1.5)
    axes.xaxis.set_major_formatter(lambda value, _: spaced(value))
    axes.yaxis.set_major_formatter(lambda value, _: readable(value))
    axes.set_title("LTSA of a long motion, two coordinates, one thread (dotted: two)\n", loc="left",
                   fontweight="bold", fontsize=12)
    axes.text(0, 1.02, "temporal: the 12 nearest among the 12 frames to each side; others: the 24 "
              "nearest of all frames", transform=axes.transAxes, color=GRAY, fontsize=9.5)
    return figure


def save_figure(result, folder):
    """Writes an SVG file and a PNG file next to it; returns the SVG file."""
    path = folder / "benchmark-time.svg"
    with plt.rc_context(STYLE):
        figure = time_figure(result)
        figure.savefig(path, metadata={"Date": None})
        figure.savefig(path.with_suffix(".png"), dpi=150)
        plt.close(figure)
    return path
