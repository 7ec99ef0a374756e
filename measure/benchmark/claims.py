# SPDX-License-Identifier: BSD-3-Clause
"""Claims with their measurements and whether they hold."""

# Largest sine of the angle between embeddings that count as the same.
SAME = 1e-8


def _claim(text, value, limit, *, at_least=False, fits=(), spread=None, unit=""):
    """One claim; it does not hold if one of the library's `fits` was given up."""
    given_up = any("failed" in fit for fit in fits)
    holds = not given_up and (value >= limit if at_least else value <= limit)
    return {"claim": text + (", given up" if given_up else ""), "value": value, "limit": limit,
            "at_least": at_least, "unit": unit, "spread": spread, "holds": holds}


def _spread(above, below):
    return [above["least"] / below["most"], above["most"] / below["least"]]


def _faster(text, ours, theirs, limit):
    """Claim of a speed-up; its range is from least over most to most over least time."""
    # A fit that ran out of time took at least that long; a fit that failed proves nothing.
    if "failed" in theirs and not theirs["failed"].startswith("not done"):
        return []
    bound = "at least " if "failed" in theirs else ""
    return [_claim(f"{text}: {bound}times as fast", theirs["seconds"] / ours["seconds"], limit,
                   at_least=True, fits=[ours], spread=_spread(theirs, ours))]


def _found(rows, **wanted):
    for row in rows:
        if all(row[key] == value for key, value in wanted.items()):
            return row
    return None


def _peers(result):
    fits = result["comparison"]
    claims = []
    # If the graph of so few neighbors is disconnected, tapkee takes more neighbors automatically,
    # and scikit-learn fails.
    for name, text in (("tapkee_few", "temporal, k = 12, against tapkee asked for k = 12"),
                       ("sklearn", "temporal, k = 12, against scikit-learn, k = 24")):
        if name in fits:
            claims += _faster(text, fits["temporal"], fits[name], 100)
    if "tapkee" in fits:
        claims += _faster("the identical task, k = 24 of all frames, against tapkee", fits["all"],
                          fits["tapkee"], 5)
    for row in result["angles"]:
        if row["to"] == "stltsa":
            claims.append(_claim(f"the identical task, angle from {row['program']} to stltsa",
                                 row["angle"], SAME))
    return claims


def _neighbors(result):
    long = _found(result["neighbors"], k=140, threads=1)
    return [_claim("k = 140: time per frame", 1e6 * long["seconds"] / long["n"], 100, fits=[long],
                   spread=[1e6 * long[key] / long["n"] for key in ("least", "most")], unit="µs")]


def _million(result):
    rows = [row for row in result["growth"] if row["mode"] == "temporal"]
    many = _found(rows, n=100_000, threads=1)
    million = _found(rows, n=1_000_000, threads=1)
    if not million:
        return []
    fits = [many, million]
    return [_claim("k = 12, a million frames: time per frame", million["seconds"], 5, fits=fits,
                   spread=[million["least"], million["most"]], unit="µs"),
            _claim("k = 12: time of a million over time of 100 000",
                   million["seconds"] / many["seconds"], 11.5, fits=fits,
                   spread=_spread(million, many)),
            _claim("k = 12, a million frames: memory beyond the frames",
                   million.get("memory", 0) / 1e9, 1.0, fits=fits, unit="GB")]


def claims_of(result):
    return _peers(result) + _neighbors(result) + _million(result)
