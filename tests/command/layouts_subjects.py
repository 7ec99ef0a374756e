# SPDX-License-Identifier: BSD-3-Clause
"""The walk of layouts.py in CSV files with another subject."""

from layouts import JOINTS, Case, flat, layout, table, times, walk_points, write


def both(path, first, second):
    """The walk, beside points of which nothing is like it, in a CSV file: names of both."""
    points = [row + [["1", "2", f"{i % 7}"] for _ in second] for i, row in enumerate(walk_points())]
    names = [f"{point}_{axis}" for point in (*first, *second) for axis in "xyz"]
    return write(path, [["time", *names], *([time, *row] for time, row in zip(times(), flat(points)))])


def named(prefix):
    return [prefix + joint for joint in JOINTS]


@layout("several subjects: `Anna:heel_x`, `Ben:heel_x`")
def prefixes_of_subjects(folder):
    path = both(folder / "a.csv", named("Anna:"), named("Ben:"))
    yield Case(path, error="there are 2 subjects, 'Anna', 'Ben'")
    yield Case(path, options=("--subject", "Anna"))
    yield Case(path, note="subject 'Anna' of 2: 'Anna', 'Ben'", options=("--subject", "Anna"))
    one = write(folder / "one.csv", table(walk_points(), lambda j, a: f"Anna:{j}_{a}"))
    yield Case(one)
    yield Case(one, options=("--subject", "Anna"))


@layout("several subjects: `scene:Anna:heel_x`, `Anna_heel_x`, `mouse1_heel_x`, `heel_mouse1_x`")
def other_prefixes_of_subjects(folder):
    for form in ("scene:{}:{}", "{}_{}", "{}.{}", "{}|{}", "{}-{}", "{} {}"):
        first, second = ([form.format(who, joint) for joint in JOINTS] for who in ("Anna", "Ben"))
        path = both(folder / "a.csv", first, second)
        yield Case(path, error="there are 2 subjects, 'Anna', 'Ben'")
        if form[2] not in "- ":
            yield Case(path, options=("--subject", "Anna"))
    path = both(folder / "b.csv", named("mouse1_"), named("mouse2_"))
    yield Case(path, error="there are 2 subjects, 'mouse1', 'mouse2'")
    yield Case(path, options=("--subject", "mouse1"))
    path = both(folder / "c.csv", *([f"{joint}_{who}" for joint in JOINTS] for who in ("mouse1", "mouse2")))
    yield Case(path, error="there are 2 subjects, 'mouse1', 'mouse2'")
    # Parts of one body.
    path = both(folder / "d.csv", [f"LeftFoot_{i}" for i in range(13)], [f"RightFoot_{i}" for i in range(13)])
    yield Case(path, note="points")


@layout("several subjects without prefixes: `heel_x` twice, or `heel_x` and `Ben:heel_x`")
def subjects_without_prefixes(folder):
    path = both(folder / "a.csv", JOINTS, JOINTS)
    yield Case(path, error="there are 2 subjects, '1', '2'")
    yield Case(path, options=("--subject", "1"))
    for prefix in ("Ben:", "Ben_"):
        path = both(folder / "b.csv", JOINTS, named(prefix))
        yield Case(path, error="there are 2 subjects, 'unnamed', 'Ben'")
        yield Case(path, options=("--subject", "unnamed"))
