# SPDX-License-Identifier: BSD-3-Clause
"""Writes one synthetic walk in every layout that docs/formats.md lists; here are those of CSV and TSV files.

A layout is a function with the decorator `layout` and its name in the table. It yields cases: a file, options of the
command, and what must come out: the answer of a plain file of the same points (`like`), or a sentence in the error or
in the notes. To add a format, add its row to the table and such a function here.
"""

import functools
import math
from typing import NamedTuple

import numpy as np
from common import walk

FPS = 60
JOINTS = ("Hips", "Neck", "Head", "LeftForeArm", "LeftHand", "RightForeArm", "RightHand", "LeftLeg", "LeftFoot",
          "LeftToeBase", "RightLeg", "RightFoot", "RightToeBase")  # fmt: skip
LAYOUTS = {}


class Case(NamedTuple):
    path: object
    like: str = "space"  # the name of a plain file, see `plain`
    options: tuple = ()
    error: str = ""  # a part of the text of an error with which reading must fail
    note: str = ""  # a part of a note; nothing is compared


def layout(name):
    def register(function):
        assert name not in LAYOUTS, name
        LAYOUTS[name] = function
        return function
    return register


def _turn(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    a, b = (axis + 1) % 3, (axis + 2) % 3
    turn = np.eye(3)
    turn[a, a] = turn[b, b] = c
    turn[a, b], turn[b, a] = -s, s
    return turn


@functools.cache
def walk_points(path=None):
    """Positions in space of joints of the synthetic walker: frames x joints x 3, as texts."""
    hierarchy, motion = (path or walk(FPS)).read_text().split("MOTION\n")
    joints, stack = [], [-1]
    for words in map(str.split, hierarchy.splitlines()):
        if words and words[0] in ("ROOT", "JOINT", "End"):
            joints.append({"name": words[1], "parent": stack[-1], "channels": []})
            stack.append(len(joints) - 1)
        elif words and words[0] == "OFFSET":
            joints[-1]["offset"] = np.array([float(w) for w in words[1:]])
        elif words and words[0] == "CHANNELS":
            joints[-1]["channels"] = words[2:]
        elif words == ["}"]:
            stack.pop()
    rows = []
    for line in motion.splitlines()[2:]:
        values, turns, places = iter(map(float, line.split())), [], []
        for joint in joints:
            above = joint["parent"]
            turn = turns[above] if above >= 0 else np.eye(3)
            place = places[above] + turn @ joint["offset"] if above >= 0 else joint["offset"].copy()
            for channel in joint["channels"]:
                value, axis = next(values), "XYZ".index(channel[0])
                if channel.endswith("position"):
                    place[axis] += value
                else:
                    turn = turn @ _turn(axis, value)
            turns.append(turn)
            places.append(place)
        named = {joint["name"]: place for joint, place in zip(joints, places)}
        # Up is z, as in most laboratories.
        rows.append([[f"{named[name][a]:.3f}" for a in (2, 0, 1)] for name in JOINTS])
    return rows


def plane():
    """The same from the side, as a camera sees it."""
    return [[[x, z] for x, _, z in row] for row in walk_points()]


def missing():
    """A hand is covered for a while."""
    rows = [list(row) for row in walk_points()]
    for row in rows[100:110]:
        row[JOINTS.index("LeftHand")] = ["", "", ""]
    return rows


def write(path, lines, separator=",", ending="\n", encoding="utf-8"):
    path.write_bytes("".join(separator.join(map(str, line)) + ending for line in lines).encode(encoding))
    return path


def times():
    return [f"{i / FPS:.6f}" for i in range(len(walk_points()))]


def flat(rows):
    return [[value for point in row for value in point] for row in rows]


def table(rows, name, axes="xyz", first="time"):
    """Lines of a file with one header line; `name` makes a column's name of a joint and an axis."""
    order = ["xyz".index(axis) for axis in axes]
    head = [first, *(name(joint, axis) for joint in JOINTS for axis in axes)]
    return [head, *([time, *(point[a] for point in row for a in order)] for time, row in zip(times(), rows))]


def with_underscore(joint, axis):
    return f"{joint}_{axis}"


def upright():
    """In space, with y up."""
    return [[[y, z, x] for x, y, z in row] for row in walk_points()]


def single():
    """In space, with numbers that reals of 32 bits and integers times 1/16 hold."""
    return [[[repr(round(float(x) * 16) / 16) for x in point] for point in row] for row in walk_points()]


def single_missing():
    return [[["" if missing_x == "" else x for x, missing_x in zip(*points)] for points in zip(*rows)]
            for rows in zip(single(), missing())]  # fmt: skip


def missing_rows():
    """Nothing is seen for a while."""
    rows = list(walk_points())
    rows[100:110] = [[["", "", ""]] * len(JOINTS)] * 10
    return rows


def coordinates():
    """Names and rows of numbers that are no points: how much higher each joint is than the hips."""
    return [f"{joint}_rise" for joint in JOINTS], [
        [f"{float(point[2]) - float(row[0][2]):.3f}" for point in row] for row in walk_points()]  # fmt: skip


def plain(folder, which):
    """The files that the others are compared with."""
    if which == "coordinates":
        names, rows = coordinates()
        return write(folder / "coordinates.csv", [["time", *names], *([time, *row] for time, row in zip(times(), rows))])
    rows = {"space": walk_points, "plane": plane, "missing": missing, "missing rows": missing_rows,
            "upright": upright, "single": single, "single missing": single_missing}[which]()  # fmt: skip
    return write(folder / f"{which}.csv", table(rows, with_underscore, "xyz"[: len(rows[0][0])]))


# ---- Names of columns ----


@layout("`heel_x`, `heel.x`, `heel x`, `heelX`, `heel:x`, `heel-x`")
def suffixes(folder):
    for number, between in enumerate("_. :-"):
        yield Case(write(folder / f"{number}.csv", table(walk_points(), lambda j, a: j + between + a)))
        yield Case(write(folder / f"{number}.csv", table(walk_points(), lambda j, a: j + between + a.upper())))
    yield Case(write(folder / "capital.csv", table(walk_points(), lambda j, a: j + a.upper())))


@layout("`x_heel`, `X.heel`, `xHeel`")
def prefixes(folder):
    yield Case(write(folder / "a.csv", table(walk_points(), lambda j, a: f"{a}_{j}")))
    yield Case(write(folder / "b.csv", table(walk_points(), lambda j, a: f"{a.upper()}.{j}", "yzx")))
    yield Case(write(folder / "c.csv", table(walk_points(), lambda j, a: a + j)))
    for word in ("pos", "Position"):
        yield Case(write(folder / "d.csv", table(walk_points(), lambda j, a: f"{word}_{a}_{j}")))
        yield Case(write(folder / "e.csv", table(walk_points(), lambda j, a: f"{word}{a}.{j}")))


@layout("axes that may be none: `heel_0` or `heel_1`; `v_x_heel`")
def unclear_axes(folder):
    for name, example in ((lambda j, a: f"{j}_{'xyz'.index(a)}", "Hips_0"),
                          (lambda j, a: f"{j}_{'xyz'.index(a) + 1}", "Hips_1"),
                          (lambda j, a: f"v_{a}_{j}", "v_x_Hips")):  # fmt: skip
        named = "v_Hips_x" if example[0] == "v" else "Hips_x"
        yield Case(write(folder / "a.csv", table(walk_points(), name)), note=f"{3 * len(JOINTS)} columns such as "
                   f"'{example}' are not taken as coordinates of points: if they are, name them as in '{named}'")  # fmt: skip


@layout("`heel[0]` or `heel[1]`, `heel (x)`")
def brackets(folder):
    yield Case(write(folder / "a.csv", table(walk_points(), lambda j, a: f"{j}[{'xyz'.index(a)}]")))
    yield Case(write(folder / "b.csv", table(walk_points(), lambda j, a: f"{j} ({a})")))
    yield Case(write(folder / "c.csv", table(walk_points(), lambda j, a: f"{j}[{'xyz'.index(a) + 1}]")))


@layout("axes in any order: z, x, y; all x, then all y, then all z")
def orders(folder):
    for axes in ("zxy", "xzy", "yxz", "zyx", "yzx"):
        yield Case(write(folder / f"{axes}.csv", table(walk_points(), with_underscore, axes)))
    head = ["time", *(f"{joint}_{axis}" for axis in "xyz" for joint in JOINTS)]
    rows = [[time, *(point[a] for a in range(3) for point in row)] for time, row in zip(times(), walk_points())]
    yield Case(write(folder / "by axis.csv", [head, *rows]))


@layout("`heel_x (mm)`, `heel_x [m]`, `heel_x_mm`")
def units(folder):
    for name in ("{}_{} (mm)", "{}_{} [m]", "{}.{}[cm]", "{}_{}_mm"):
        yield Case(write(folder / "a.csv", table(walk_points(), name.format)))
    path = write(folder / "noted.csv", table(walk_points(), "{}_{} (mm)".format))
    yield Case(path, note="unit of the positions, by the names of the columns: mm")


@layout("points of two axes: `heel_x`, `heel_y`")
def planes(folder):
    yield Case(write(folder / "a.csv", table(plane(), lambda j, a: f"{j}.{a}", "yx")), "plane")


@layout("angles: `Hips_x (deg)`, or a file named `walk_rot.csv`")
def angles(folder):
    for name, shown in (("a.csv", "{}_{} (deg)"), ("walk01_rot.csv", "{}.{}"), ("Angles2.csv", "{}.{}")):
        path = write(folder / name, table(walk_points(), shown.format, "zxy"))
        yield Case(path, note="raw column 'time' is time")
    yield Case(folder / "a.csv", note="of other quantities than positions, by their names or units: 'Hips'")
    yield Case(path, note="not taken as those of points: the name of the file is that of angles")


# ---- Header lines ----


def two_lines(names, rows):
    return [["", *names], ["", *("xyz" * len(JOINTS))], *([i, *row] for i, row in enumerate(flat(rows)))]


@layout("two header lines: names, then axes")
def levels(folder):
    fps = ("--fps", str(FPS))
    repeated = [joint for joint in JOINTS for _ in range(3)]
    once = [name for joint in JOINTS for name in (joint, "", "")]
    yield Case(write(folder / "repeated.csv", two_lines(repeated, walk_points())), options=fps)
    yield Case(write(folder / "once.csv", two_lines(once, walk_points())), options=fps)
    rows = [[time, *row] for time, row in zip(times(), flat(walk_points()))]
    numbered = [f"{axis}{i + 1}" for i in range(len(JOINTS)) for axis in "XYZ"]
    for first, second in ((repeated, numbered), (once, ["X", "Y", "Z"] * len(JOINTS)),
                          (["X", "Y", "Z"] * len(JOINTS), repeated)):  # fmt: skip
        yield Case(write(folder / "time.csv", [["Time", *first], ["", *second], *rows]))
    lost = [["Time", *once], ["", *"XYZ" * len(JOINTS)], *rows[:100], *rows[110:]]
    yield Case(write(folder / "lost.csv", lost), "missing rows")
    lines = table(walk_points(), with_underscore)
    yield Case(write(folder / "units.csv", [lines[0], ["s", *["mm"] * (3 * len(JOINTS))], *lines[1:]]))


def dlc(individuals, folder, name):
    """A file of DeepLabCut; the second individual is the walk with a fixed shift."""
    keys = [(who, joint, coord) for who in individuals or [""] for joint in JOINTS
            for coord in ("x", "y", "likelihood")]  # fmt: skip
    head = [["scorer", *["net"] * len(keys)]]
    if individuals:
        head.append(["individuals", *(who for who, _, _ in keys)])
    head += [["bodyparts", *(joint for _, joint, _ in keys)], ["coords", *(coord for _, _, coord in keys)]]
    rows = []
    for i, row in enumerate(plane()):
        cells = [cell for x, y in row for cell in (x, y, "0.99")]
        others = [cell for x, y in row for cell in (f"{float(x) + 200:.3f}", "7.5", "0.99")]
        rows.append([i, *cells, *(others if len(individuals) > 1 else [])])
    return write(folder / name, head + rows)


@layout("three header lines: scorer, bodyparts, coords")
def deeplabcut(folder):
    yield Case(dlc([], folder, "a.csv"), "plane", ("--fps", str(FPS)))


@layout("four header lines: scorer, individuals, bodyparts, coords")
def deeplabcut_individuals(folder):
    path = dlc(["mouse1", "mouse2"], folder, "a.csv")
    yield Case(path, error="there are 2 subjects, 'mouse1', 'mouse2': choose one with --subject")
    yield Case(path, error="but the subjects are 'mouse1', 'mouse2'", options=("--subject", "cat"))
    yield Case(path, "plane", ("--fps", str(FPS), "--subject", "mouse1"))
    yield Case(dlc(["mouse1"], folder, "one.csv"), "plane", ("--fps", str(FPS)))


@layout("`heel_x`, `heel_y`, `heel_likelihood` or `heel_visibility`")
def confidence(folder):
    for word in ("likelihood", "visibility", "score"):
        head = ["time", *(f"{joint}_{what}" for joint in JOINTS for what in ("x", "y", word))]
        rows = [[time, *(cell for point in row for cell in (*point, "0.9"))] for time, row in zip(times(), plane())]
        yield Case(write(folder / "a.csv", [head, *rows]), "plane")
        rows[50][3] = "0.2"
        yield Case(write(folder / "b.csv", [head, *rows]), note=f"1 of {len(rows) * len(JOINTS)} positions are below")


@layout("a row for each point of a frame: `frame`, `bodypart`, `x`, `y`")
def tidy(folder):
    rows = [[i, joint, *point] for i, row in enumerate(plane()) for joint, point in zip(JOINTS, row)]
    path = write(folder / "a.csv", [["frame", "bodypart", "x", "y"], *rows])
    yield Case(path, error="several rows, each with the x and y of one point, are of frame 0", options=("--fps", "60"))


@layout("a row for each frame of each track: `track`, `frame_idx`, `instance.score`")
def sleap(folder):
    head = ["track", "frame_idx", "instance.score",
            *(f"{joint}.{what}" for joint in JOINTS for what in ("x", "y", "score"))]  # fmt: skip
    fps = ("--fps", str(FPS))
    first = [["track_0", i, "0.9", *(cell for x, y in row for cell in (x, y, "0.9"))]
             for i, row in enumerate(plane())]  # fmt: skip
    second = [["track_1", i, "0.9", *["3", "4", "0.9"] * len(JOINTS)] for i in range(50, 250)]
    yield Case(write(folder / "one.csv", [head, *first]), "plane", fps)
    yield Case(write(folder / "none.csv", [head, *(["", *row[1:]] for row in first)]), "plane", fps)
    both = write(folder / "two.csv", [head, *sorted(first + second, key=lambda row: row[1])])
    yield Case(both, error="there are 2 subjects, 'track_0', 'track_1'")
    yield Case(both, "plane", (*fps, "--subject", "track_0"))
    named = [["frame", "id", *head[3:]], *([row[1], 1 + (row[0] == "track_1"), *row[3:]] for row in first + second)]
    yield Case(write(folder / "id.csv", named), "plane", (*fps, "--subject", "1"))
    holes = write(folder / "holes.csv", [head, *(row for row in first if not 100 <= row[1] < 110)])
    yield Case(holes, options=fps, note="rows are missing by the count of frames: 10 of")


# ---- Exporters ----


def motive(parent, subject="S"):
    count = 3 * len(JOINTS)
    names = [f"{subject}:{joint}" for joint in JOINTS for _ in range(3)]
    lines = [["Format Version", "1.23", "Take Name", "walk", "Capture Frame Rate", "120", "Export Frame Rate",
              str(FPS), "Length Units", "Meters"],
             [""],
             ["", "Type", *["Marker"] * count], ["", "Name", *names], ["", "ID", *range(count)]]  # fmt: skip
    if parent is not None:
        lines.append(["", "Parent", *[parent] * count])
    lines += [["", "", *["Position"] * count], ["Frame", "Time (Seconds)", *"XYZ" * len(JOINTS)]]
    return lines + [[i, time, *row] for i, (time, row) in enumerate(zip(times(), flat(walk_points())))]


@layout("Motive: Type, Name, ID, Parent")
def optitrack(folder):
    for parent in (None, "", "Body", "S"):
        yield Case(write(folder / "a.csv", motive(parent)))
    above = motive("S")
    above[4:6] = reversed(above[4:6])
    yield Case(write(folder / "a.csv", above))
    yield Case(write(folder / "a.csv", motive("")), note="unit of length in the lines before the numbers: Meters")


@layout("Nexus: sections with titles, Trajectories")
def vicon(folder):
    names = [cell for joint in JOINTS for cell in (f"Pat:{joint}", "", "")]
    lines = [["Model Outputs"], ["100"], ["", "", "Pat:LHipAngles", "", ""],
             ["Frame", "Sub Frame", "X", "Y", "Z"], ["", "", "deg", "deg", "deg"],
             *([i + 1, 0, 1, 2, 3] for i in range(5)), [""],
             ["Trajectories"], [FPS], ["", "", *names], ["Frame", "Sub Frame", *"XYZ" * len(JOINTS)],
             ["", "", *["mm"] * len(names)],
             *([i + 1, 0, *row] for i, row in enumerate(flat(walk_points())))]  # fmt: skip
    yield Case(write(folder / "a.csv", lines))
    yield Case(write(folder / "b.csv", lines[11:]))


@layout("Qualisys TSV: MARKER_NAMES, with or without a line of columns")
def qualisys(folder):
    head = [["NO_OF_FRAMES", len(walk_points())], ["NO_OF_CAMERAS", 8], ["NO_OF_MARKERS", len(JOINTS)],
            ["FREQUENCY", FPS], ["NO_OF_ANALOG", 0], ["ANALOG_FREQUENCY", 1000],
            ["DESCRIPTION", "--"], ["TIME_STAMP", "2024-01-01, 10:00:00.000", "1.0"], ["DATA_INCLUDED", "3D"],
            ["MARKER_NAMES", *JOINTS]]  # fmt: skip
    rows = flat(walk_points())
    timed = [[i + 1, time, *row] for i, (time, row) in enumerate(zip(times(), rows))]
    types = ["TRAJECTORY_TYPES", *["Measured"] * len(JOINTS)]
    columns = ["Frame", "Time", *(f"{joint} {axis}" for joint in JOINTS for axis in "XYZ")]
    for lines in ([*head, *rows], [*head, types, *rows], [*head, *timed], [*head, types, columns, *timed]):
        yield Case(write(folder / "a.tsv", lines, "\t"))
    yield Case(write(folder / "a.tsv", [*head, *([i + 1, *row] for i, row in enumerate(rows))], "\t"))
    yield Case(write(folder / "a.tsv", [*head, *rows], "\t", "\t\n"))
    wrong = write(folder / "wrong.tsv", [*head, *(row[:-1] for row in rows)], "\t")
    yield Case(wrong, error=f"MARKER_NAMES has {len(JOINTS)} names, but the rows have {3 * len(JOINTS) - 1} columns")


def bids(folder, name, latency=False):
    folder.mkdir(parents=True, exist_ok=True)
    stem = folder / f"sub-01_task-walk_tracksys-omc{name}"
    channels = [[f"c{k}", "xyz"[k % 3], "POS", JOINTS[k // 3], "mm"] for k in range(3 * len(JOINTS))]
    channels += [[f"q{k}", f"quat_{k}", "ORNT", "Hips", "n/a"] for k in "xyzw"]
    channels += [[f"g{k}", k, "GYRO", "Hips", "rad/s"] for k in "xyz"]
    rows = [[*row, "0", "0", "0", "1", "n/a", "0", "0"] for row in flat(walk_points())]
    if latency:
        channels.insert(0, ["t", "n/a", "LATENCY", "n/a", "s"])
        rows = [[time, *row] for time, row in zip(times(), rows)]
    write(stem.with_name(stem.name + "_channels.tsv"),
          [["name", "component", "type", "tracked_point", "units"], *channels], "\t")  # fmt: skip
    rate = "" if latency else f'"SamplingFrequency": {FPS}, '
    stem.with_name(stem.name + "_motion.json").write_text(
        '{"TaskName": "a \\"SamplingFrequency\\": 9", "More": {"SamplingFrequency": 7}, ' + rate + '"X": [1]}')
    return write(stem.with_name(stem.name + "_motion.tsv"), rows, "\t")


@layout("Motion-BIDS: `*_motion.tsv`, `*_channels.tsv`, `*_motion.json`; or their folder")
def motion_bids(folder):
    data = folder / "data"
    path = bids(data / "sub-01" / "motion", "")
    yield Case(path)
    yield Case(data)
    yield Case(data / "sub-01" / "motion")
    yield Case(bids(folder / "late" / "motion", "", latency=True))
    # Files above the folder apply to all recordings below it.
    for ending in ("_motion.json", "_channels.tsv"):
        path.with_name(path.name.replace("_motion.tsv", ending)).rename(data / f"task-walk{ending}")
    yield Case(path)
    bids(data / "sub-01" / "motion", "2")
    yield Case(data, error="this folder holds 2 motion files: give one of")
    other = bids(folder / "other", "")
    other.write_text("1\t2\n1\t2\n")
    yield Case(other, error=f"2 cells, but {other.with_name(other.name.replace('motion', 'channels'))} describes")


# ---- Texts ----


@layout("separators: comma, semicolon, tab, blanks; decimal commas")
def separators(folder):
    lines = table(walk_points(), with_underscore)
    commas = [[cell.replace(".", ",") for cell in line] for line in lines]
    for name, separator in (("comma", ","), ("semicolon", ";"), ("tab", "\t"), ("blanks", "  "), ("both", ", ")):
        yield Case(write(folder / f"{name}.csv", lines, separator))
        if "," not in separator:
            yield Case(write(folder / f"{name} decimal.csv", commas, separator))
    yield Case(write(folder / "a.tsv", lines, "\t"))
    yield Case(write(folder / "a.txt", lines, ";"))


@layout("a header without the column of row names")
def row_names(folder):
    lines = table(walk_points(), with_underscore)
    for separator in (",", " "):
        named = [lines[0], *([f'"{i}"', *line] for i, line in enumerate(lines) if i > 0)]
        yield Case(write(folder / "a.csv", named, separator))


@layout("byte order mark, lines that end with CR LF or with a separator")
def endings(folder):
    lines = table(walk_points(), with_underscore)
    yield Case(write(folder / "bom.csv", lines, encoding="utf-8-sig"))
    yield Case(write(folder / "crlf.csv", lines, ending="\r\n", encoding="utf-8-sig"))
    yield Case(write(folder / "ends.csv", lines, ending=",\n"))
    yield Case(write(folder / "motive.csv", motive(""), ending="\r\n", encoding="utf-8-sig"))
    yield Case(write(folder / "utf16.csv", lines, encoding="utf-16"), error="the text is UTF-16")


@layout("missing values: empty cells, NaN, NA, null")
def gaps(folder):
    lines = table(missing(), with_underscore)
    for word in ("NaN", "NA", "#N/A", "null", "-"):
        filled = [[cell if cell else word for cell in line] for line in lines]
        yield Case(write(folder / "word.csv", filled), "missing")
    yield Case(write(folder / "semicolon.csv", lines, ";"), "missing")


@layout("numbers for missing values: -9999, 999, 9999999")
def codes(folder):
    for code in ("-9999", "999", "999.99", "9999999.000", "1e10", "3.40282e38", "-9.999e6"):
        filled = [[cell if cell else code for cell in line] for line in table(missing(), with_underscore)]
        yield Case(write(folder / "a.csv", filled), "missing")
    yield Case(folder / "a.csv", note="-9999000 is far outside the other numbers, as where a value is missing: taken "
               "as missing, 30 times in 3 columns: 'LeftHand_x', 'LeftHand_y', 'LeftHand_z'")  # fmt: skip
    bare = [["-9999" if cell == "" else cell for cell in line[1:]] for line in table(missing(), with_underscore)[1:]]
    yield Case(write(folder / "b.csv", bare), note="taken as missing, 30 times in 3 columns")


@layout("columns beside the points: text, other quantities")
def others(folder):
    lines = table(walk_points(), with_underscore)
    beside = [[*line, *("foot,acc_x,acc_y,acc_z,side".split(",") if i == 0 else ("1", "2", "3", "4", "left"))]
              for i, line in enumerate(lines)]  # fmt: skip
    path = write(folder / "a.csv", beside)
    yield Case(path)
    yield Case(path, note="columns of text, left out: 'side'")
    for letter, axes in (("v", "xyz"), ("a", "xyz"), ("q", "xyzw")):
        names = [f"{joint}_{letter}{axis}" for joint in JOINTS for axis in axes]
        beside = [[*line, *(names if i == 0 else ["1"] * len(names))] for i, line in enumerate(lines)]
        yield Case(write(folder / "b.csv", beside))
