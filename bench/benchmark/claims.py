# SPDX-License-Identifier: BSD-3-Clause
"""What is claimed, what was measured of it, and whether that holds."""

# Sine of the angle between embeddings that are called the same.
SAME = 1e-8


def _claim(text, value, limit, at_least, spread=None, unit=""):
    holds = value >= limit if at_least else value <= limit
    return {"claim": text, "value": value, "limit": limit, "at_least": at_least, "unit": unit,
            "spread": spread, "holds": holds}


def _faster(text, ours, theirs, limit):
    """How many times as fast; the spread pairs the least of the one with the most of the other."""
    # A fit that ran out of time took at least that long, one that ended with an error says nothing.
    if "failed" in theirs and not theirs["failed"].startswith("not done"):
        return []
    bound = "at least " if "failed" in theirs else ""
    spread = [theirs["least"] / ours["most"], theirs["most"] / ours["least"]]
    return [_claim(f"{text}: {bound}times as fast", theirs["seconds"] / ours["seconds"], limit,
                   True, spread)]


def _found(rows, **wanted):
    for row in rows:
        if all(row[key] == value for key, value in wanted.items()):
            return row
    return None


def _peers(result):
    fits = result["comparison"]
    claims = []
    # Where the graph of so few neighbors is in pieces, tapkee takes more by itself, and
    # scikit-learn ends with an error.
    for name, text in (("tapkee_few", "neighbors in time, k = 12, against tapkee asked for k = 12"),
                       ("sklearn", "neighbors in time, k = 12, against scikit-learn, k = 24")):
        if name in fits:
            claims += _faster(text, fits["temporal"], fits[name], 100)
    if "tapkee" in fits:
        claims += _faster("the identical job, k = 24 of all frames, against tapkee", fits["all"],
                          fits["tapkee"], 5)
    for row in result["angles"]:
        if row["to"] == "stltsa":
            claims.append(_claim(f"the identical job, angle from {row['program']} to stltsa",
                                 row["angle"], SAME, False))
    return claims


def _growth(result):
    rows = [row for row in result["growth"] if row["mode"] == "temporal"]
    many = _found(rows, n=100_000, threads=1)
    two = _found(rows, n=100_000, threads=2)
    long = _found(result["neighbors"], k=140, threads=1)
    claims = [_claim("k = 12, 100 000 frames: two threads, times as fast",
                     many["seconds"] / two["seconds"], 1.7, True,
                     [many["least"] / two["most"], many["most"] / two["least"]]),
              _claim("k = 140: time a frame", 1e6 * long["seconds"] / long["n"], 40, False,
                     [1e6 * long[key] / long["n"] for key in ("least", "most")], "us")]
    million = _found(rows, n=1_000_000, threads=1)
    if million:
        claims += [_claim("k = 12, a million frames: time a frame", million["seconds"], 5, False,
                          [million["least"], million["most"]], "us"),
                   _claim("k = 12: time of a million over time of 100 000",
                          million["seconds"] / many["seconds"], 11.5, False,
                          [million["least"] / many["most"], million["most"] / many["least"]])]
    if million and "memory" in million:
        claims += [_claim("k = 12, a million frames: memory beyond the frames",
                          million["memory"] / 1e9, 1.0, False, unit="GB")]
    return claims


def claims_of(result):
    return _peers(result) + _growth(result)
