# SPDX-License-Identifier: BSD-3-Clause
"""How often an answer is right that claims a confidence."""

import numpy as np

BINS = 5
ENOUGH = 20  # answers in a bin, below which its share says little


def check(table, total):
    """One table for cycles, segments and borders: pairs (confidence, right)."""
    table.title("Confidence: share of right answers within 10 points of it; of the right ones 60 % "
                "above 0.9, and 95 % right there")
    for kind, pairs in total.said.items():
        if not pairs:
            table.figure(kind, "no confidence was given")
            continue
        said, right = np.array(pairs, float).T
        bins = np.minimum((said * BINS).astype(int), BINS - 1)
        for b in range(BINS):
            inside = bins == b
            if inside.any():
                _bin(table, f"{kind}, {b / BINS:.1f} to {(b + 1) / BINS:.1f}", said[inside],
                     right[inside])
        high = said > 0.9
        table.row(f"{kind}, above 0.9", [
            (f"{100 * right[high].sum() / max(right.sum(), 1):.1f} % of the right ones (60)",
             right[high].sum() >= 0.6 * right.sum()),
            (f"{100 * right[high].mean() if high.any() else 0:.1f} % right (95)",
             high.any() and right[high].mean() >= 0.95)])


def _bin(table, name, said, right):
    off = abs(right.mean() - said.mean()) <= 0.10
    text = f"n {len(said):5d}  said {said.mean():.3f}  right {right.mean():.3f}"
    table.figure(name, text, bool(off) if len(said) >= ENOUGH else None)
