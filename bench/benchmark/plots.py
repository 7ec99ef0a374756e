# SPDX-License-Identifier: BSD-3-Clause
"""The two figures: time against frames with the peers, and time of each stage against its bound."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.lines import Line2D

# Okabe and Ito's colors, which the color-blind can tell apart; markers differ as well.
ORANGE, SKY, GREEN, BLUE, RED, GRAY = ("#E69F00", "#56B4E9", "#009E73", "#0072B2", "#D55E00",
                                       "#555555")
STYLE = {
    "font.size": 11, "font.family": "sans-serif", "axes.spines.top": False,
    "axes.spines.right": False, "axes.edgecolor": GRAY, "axes.labelcolor": "#222222",
    "xtick.color": GRAY, "ytick.color": GRAY, "axes.grid": True, "grid.color": "#E4E4E4",
    "grid.linewidth": 0.8, "axes.axisbelow": True, "svg.fonttype": "path",
    "svg.hashsalt": "libstltsa", "figure.facecolor": "white", "savefig.facecolor": "white",
}
# program, mode, threads: label at the first point, color, marker, line, where the last time goes
LINES = {
    ("scikit-learn", "spatial", 1): ("scikit-learn", RED, "s", "-", (-8, 11)),
    ("tapkee", "spatial", 1): ("tapkee", ORANGE, "^", "-", (10, 5)),
    ("stltsa", "spatial", 1): ("stltsa,\nall frames", GREEN, "D", "-", (10, -6)),
    ("stltsa", "temporal", 1): ("stltsa,\nin time", BLUE, "o", "-", (10, 7)),
    ("stltsa", "temporal", 2): ("", BLUE, "o", ":", (10, -8)),
}
BOUNDS = {"arithmetic": (GREEN, "^"), "memory": (ORANGE, "s"), "latency": (SKY, "D")}


def readable(seconds):
    """Say, 5 ms or 1.3 s."""
    size, unit = (1, "s") if seconds >= 0.9995 else (1e-3, "ms")
    value = seconds / size
    return f"{value:.0f} {unit}" if value >= 10 else f"{value:.2g} {unit}"


def spaced(number):
    return f"{number:,.0f}".replace(",", "\N{THIN SPACE}")


def draw_line(axes, rows, label, color, marker, line, end):
    """One program's times, and how the first fit that took too long was given up."""
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
    axes.text(0, 1.02, "in time: the 12 nearest of 12 frames to each side; the others: the 24 "
              "nearest of all frames", transform=axes.transAxes, color=GRAY, fontsize=9.5)
    return figure


def stages_figure(result):
    """A row of panels, one for each number of neighbors: from the bound to what was measured."""
    rows = result["stages"]
    sizes = sorted({row["k"] for row in rows})
    stages = list(dict.fromkeys(row["stage"] for row in rows))
    figure, panels = plt.subplots(1, len(sizes), figsize=(10, 3.4), sharex=True, sharey=True,
                                  squeeze=False, layout="constrained")
    panels = panels[0]
    for k, axes in zip(sizes, panels, strict=True):
        for row in (row for row in rows if row["k"] == k):
            y = stages.index(row["stage"])
            bound, time = (1e6 * row[key] / row["n"] for key in ("bound", "seconds"))
            color, marker = BOUNDS[row["kind"]]
            axes.plot([bound, time], [y, y], color="#BBBBBB", linewidth=2, zorder=2)
            axes.plot(bound, y, color=color, marker=marker, markersize=9, zorder=3)
            axes.plot(time, y, color="black", marker="o", markersize=7, zorder=3)
            axes.annotate(f"{100 * bound / time:.0f} %", (max(bound, time), y), xytext=(7, 0),
                          textcoords="offset points", va="center", fontsize=9, color=GRAY)
        axes.set(xscale="log", title=f"k = w = {k}", ylim=(len(stages) - 0.5, -0.5))
        axes.set_yticks(range(len(stages)), stages)
        axes.tick_params(axis="y", length=0, labelcolor="#222222")
    low, high = panels[0].get_xlim()
    panels[0].set_xlim(low / 1.5, high * 6)
    panels[0].xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    figure.supxlabel("microseconds a frame, one thread", fontsize=11)
    marks = [Line2D([], [], color="black", marker="o", linestyle="", label="measured")]
    found = {row["kind"] for row in rows}
    marks += [Line2D([], [], color=color, marker=marker, linestyle="", markersize=8,
                     label=f"least possible: {kind}")
              for kind, (color, marker) in BOUNDS.items() if kind in found]
    figure.legend(handles=marks, loc="outside upper left", ncols=4, frameon=False)
    return figure


def save_figures(result, folder):
    """Returns the SVG files; PNG files are beside them."""
    paths = []
    with plt.rc_context(STYLE):
        for name, draw in (("time", time_figure), ("stages", stages_figure)):
            figure = draw(result)
            paths.append(folder / f"benchmark-{name}.svg")
            figure.savefig(paths[-1], metadata={"Date": None})
            figure.savefig(paths[-1].with_suffix(".png"), dpi=150)
            plt.close(figure)
    return paths
