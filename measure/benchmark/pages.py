# SPDX-License-Identifier: BSD-3-Clause
"""Puts tables and figures into README.md, docs/benchmark.md and its log, between their markers."""

import re
import shutil
import textwrap

import texts

QUIET = 0.95  # least share of a processor that a fit gets on an idle machine


def between_markers(text, name, content):
    """`text` with the part between the two markers of that name replaced."""
    pattern = rf"(<!-- benchmark: {name} -->\n).*?(<!-- end -->)"
    replaced, count = re.subn(pattern, lambda found: f"{found[1]}\n{content}\n\n{found[2]}", text,
                              flags=re.DOTALL)
    if count != 1:
        raise ValueError(f"one pair of markers <!-- benchmark: {name} --> .. <!-- end --> expected")
    return replaced


def busy(result):
    """A warning if fits had to wait for a processor."""
    rows = [row for row in result["comparison"].values()
            if "failed" not in row and row["threads"] == 1]
    share = sum(row["processor"] for row in rows) / sum(row["seconds"] for row in rows)
    if share > QUIET:
        return ""
    return (f" The machine was busy: fits had {100 * share:.0f} % of a processor, so the seconds "
            "are too high.")


def where(result):
    """A sentence on the machine and the versions."""
    frames = result["comparison"]["temporal"]
    versions = ", ".join(f"{name} {version}" for name, version in result["versions"].items())
    text = (f"{frames['n']} {frames['frames']} frames of {frames['features']} features "
            f"({frames['input'] / 1e6:.1f} MB), two coordinates; {result['machine']}; one thread "
            f"unless the row says otherwise; {versions}. Seconds: median (minimum–maximum) of "
            "runs in separate processes; a value without a range is a single run.")
    return textwrap.fill(text + busy(result), 100)


def update(root, result, figure):
    table = {name: "\n".join(texts.markdown(getattr(texts, name)(result)))
             for name in ("comparison", "claims", "angles", "growth", "stages")}
    parts = {
        root / "README.md": {"summary": textwrap.fill(texts.summary(result), 100)},
        root / "docs/benchmark.md": {
            "comparison": f"{where(result)}\n\n{table['comparison']}", "claims": table["claims"],
            "angles": table["angles"]},
        root / "docs/logs/benchmark.md": {"growth": table["growth"], "stages": table["stages"]},
    }
    for path, contents in parts.items():
        text = path.read_text(encoding="utf-8")
        for name, content in contents.items():
            text = between_markers(text, name, content)
        path.write_text(text, encoding="utf-8")
    shutil.copy(figure, root / "docs")
