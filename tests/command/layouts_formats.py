# SPDX-License-Identifier: BSD-3-Clause
"""The walk of layouts.py as TRC, MOT, STO and C3D."""

from c3d_file import c3d
from layouts import (FPS, JOINTS, Case, coordinates, flat, layout, missing, single, single_missing, times, upright, write,
                     walk_points)  # fmt: skip

# ---- TRC ----


def trc(rows, rate=FPS, names=JOINTS, count="Frame#"):
    head = [["PathFileType", "4", "(X/Y/Z)", "walk.trc"],
            ["DataRate", "CameraRate", "NumFrames", "NumMarkers", "Units"],
            [rate, rate, len(rows), len(names), "mm"],
            [count, "Time", *(cell for name in names for cell in (name, "", ""))],
            ["", "", *(f"{axis}{i + 1}" for i in range(len(names)) for axis in "XYZ")],
            [""]]  # fmt: skip
    return head + [[i + 1, time, *row] for i, (time, row) in enumerate(zip(times(), flat(rows)))]


@layout("TRC: `PathFileType`, `DataRate`, `Frame#`, `Time`")
def trc_files(folder):
    lines = trc(upright())
    path = write(folder / "a.trc", lines, "\t")
    yield Case(path, "upright")
    yield Case(path, note="up axis: y, as OpenSim has it in TRC files")
    yield Case(write(folder / "b.trc", lines, "\t", "\r\n", "utf-8-sig"), "upright")
    commas = [[str(cell).replace(".", ",") if i > 5 else cell for cell in line] for i, line in enumerate(lines)]
    yield Case(write(folder / "c.trc", commas, "\t", "\t\n"), "upright")
    yield Case(write(folder / "d.trc", lines, ","), "upright")
    seven = [[*line, FPS, 1, len(upright())] if i == 2 else line for i, line in enumerate(lines)]
    seven[1] = [*lines[1], "OrigDataRate", "OrigDataStartFrame", "OrigNumFrames"]
    yield Case(write(folder / "e.trc", lines[:5] + lines[6:], "\t"), "upright")  # no empty line
    yield Case(write(folder / "f.trc", seven, "\t"), "upright")
    close = [[cell for cell in lines[3] if cell] if i == 3 else line for i, line in enumerate(lines)]
    yield Case(write(folder / "g.trc", close, "\t"), "upright")  # names one after another
    for form in ("{}", "{}_{}"):
        each = [*lines[3][:2], *(form.format(joint, axis) for joint in JOINTS for axis in "XYZ")]
        yield Case(write(folder / "h.trc", [*lines[:3], each, *lines[4:]], "\t"), "upright")
    untimed = lines[:6] + [[line[0], "", *line[2:]] for line in lines[6:]]
    yield Case(write(folder / "i.trc", untimed, "\t"), "upright")
    hand = 2 + 3 * JOINTS.index("LeftHand")
    absent = [[*line[:hand], *[-9999] * 3, *line[hand + 3 :]] if 106 <= i < 116 else line for i, line in enumerate(lines)]
    yield Case(write(folder / "j.trc", absent, "\t"), note="-9999 is far outside the other numbers, as where a value is "
               "missing: taken as missing, 30 times in 3 columns: 'LeftHand_x'")  # fmt: skip


@layout("TRC of several subjects: `Anna:heel`, `Ben:heel`")
def trc_subjects(folder):
    rows = [[*row, *([["1", "2", "3"]] * len(JOINTS))] for row in upright()]
    for prefixes, subjects in ((("Anna:", "Ben:"), ("Anna", "Ben")), (("Anna_", "Ben_"), ("Anna", "Ben")),
                               (("", ""), ("1", "2")), (("", "Ben:"), ("unnamed", "Ben"))):  # fmt: skip
        names = [prefix + joint for prefix in prefixes for joint in JOINTS]
        path = write(folder / "a.trc", trc(rows, names=names), "\t")
        yield Case(path, error=f"there are 2 subjects, '{subjects[0]}', '{subjects[1]}'")
        yield Case(path, "upright", ("--subject", subjects[0]))


# ---- MOT, STO ----


def mot(names, rows, *keys, separator="\t"):
    head = [["Coordinates"], ["version=1"], [f"nRows={len(rows)}"], [f"nColumns={len(names) + 1}"],
            *([key] for key in keys), ["endheader"]]  # fmt: skip
    return [*head, ["time", *names], *([time, *row] for time, row in zip(times(), rows))]


@layout("MOT, STO: `nRows=300`, `inDegrees=yes`, `endheader`")
def mot_files(folder):
    names, rows = coordinates()
    lines = mot(names, rows, "inDegrees=yes")
    path = write(folder / "a.mot", lines, "\t")
    yield Case(path, "coordinates")
    yield Case(path, note="angles are in degrees (inDegrees)")
    yield Case(write(folder / "b.sto", lines, "\t", "\r\n", "utf-8-sig"), "coordinates")
    yield Case(write(folder / "c.mot", lines, "   "), "coordinates")
    yield Case(write(folder / "d.sto", lines, ","), "coordinates")
    commas = [[str(cell).replace(".", ",") for cell in line] for line in lines]
    yield Case(write(folder / "e.mot", commas, "\t"), "coordinates")
    simm = [["name walk.mot"], [f"datacolumns {len(names) + 1}"], [f"datarows {len(rows)}"], ["range 0 5"],
            *lines[5:]]  # fmt: skip
    yield Case(write(folder / "f.mot", simm, "\t"), "coordinates")


@layout("STO with `DataType=Vec3`")
def sto_points(folder):
    rows = [[",".join(point) for point in row] for row in walk_points()]
    yield Case(write(folder / "a.sto", mot(JOINTS, rows, "DataType=Vec3"), "\t"))


# ---- C3D ----


def c3d_case(path, rows=None, names=JOINTS, like="single", options=(), **settings):
    numbers = [[float(x or 0) for x in row] for row in flat(rows or single())]
    path.write_bytes(c3d(numbers, names, FPS, **settings))
    return Case(path, like, options)


@layout("C3D: Intel, DEC, MIPS; integers, real numbers")
def processors(folder):
    for order in ("<", "dec", ">"):
        for scale in (None, 1 / 16):
            yield c3d_case(folder / "a.c3d", order=order, scale=scale)


@layout("C3D: names in LABELS, LABELS2; points without a name")
def c3d_names(folder):
    yield c3d_case(folder / "a.c3d", names=JOINTS[:4], parameters={"POINT": {"LABELS2": list(JOINTS[4:])}})
    case = c3d_case(folder / "b.c3d", names=JOINTS[:-1])
    yield Case(case.path, note="points without a name in the file are named by their places, 1 of 13: 'p13'")


@layout("C3D: residuals, a first frame of 704, analog channels")
def c3d_frames(folder):
    yield c3d_case(folder / "a.c3d", residual=1.5)
    hand = JOINTS.index("LeftHand")
    gaps = [(i, hand) for i, row in enumerate(missing()) if row[hand][0] == ""]
    yield c3d_case(folder / "b.c3d", missing=gaps, like="single missing")
    yield c3d_case(folder / "c.c3d", missing=gaps, like="single missing", scale=1 / 16, order=">")
    yield c3d_case(folder / "d.c3d", first=704, analog=3)
    coded = [[["-9999" if x == "" else x for x in point] for point in row] for row in single_missing()]
    yield c3d_case(folder / "e.c3d", coded, like="single missing")


@layout("C3D of several subjects: SUBJECTS:NAMES, LABEL_PREFIXES")
def c3d_subjects_group(folder):
    rows = [[*row, *([["1", "2", "3"]] * len(JOINTS)), ["4", "5", "6"]] for row in single()]
    for prefixes, stated in ((("S:", "B:"), ["S:", "B:"]), (("", "Ben:"), ["", "Ben:"]), (("S_", "B_"), ["S_", "B_"])):
        names = [*(prefix + joint for prefix in prefixes for joint in JOINTS), "*26"]
        group = {"NAMES": ["Anna", "Ben"], "LABEL_PREFIXES": stated, "USED": [2]}
        case = c3d_case(folder / "a.c3d", rows, names, options=("--subject", "Anna"), parameters={"SUBJECTS": group})
        yield case
        yield Case(case.path, error="there are 2 subjects, 'Anna', 'Ben'")
    one = {"NAMES": ["Plugin"], "LABEL_PREFIXES": [""], "USED": [1]}
    yield c3d_case(folder / "b.c3d", parameters={"SUBJECTS": one})
    yield c3d_case(folder / "c.c3d", options=("--subject", "Plugin"), parameters={"SUBJECTS": one})
    unclear = c3d_case(folder / "d.c3d", parameters={"SUBJECTS": {"NAMES": ["Anna", "Ben"], "USED": [2]}})
    yield Case(unclear.path, note="the file has 2 subjects, 'Anna', 'Ben', but does not say whose each point is")


@layout("C3D of several subjects; the axis that is up: POINT:Y_SCREEN")
def c3d_subjects(folder):
    names = [f"{who}:{joint}" for who in ("Anna", "Ben") for joint in JOINTS]
    rows = [[*row, *([["1", "2", "3"]] * len(JOINTS))] for row in single()]
    case = c3d_case(folder / "a.c3d", rows, names, options=("--subject", "Anna"))
    yield case
    yield Case(case.path, error="there are 2 subjects, 'Anna', 'Ben'")
    yield c3d_case(folder / "b.c3d", parameters={"POINT": {"Y_SCREEN": ["+Z"]}})
    case = c3d_case(folder / "c.c3d", parameters={"POINT": {"Y_SCREEN": ["-X"]}})
    yield Case(case.path, note="POINT:Y_SCREEN is -X: turned over, so that x points up")
    over = [[[x, repr(-float(y)), repr(-float(z))] for x, y, z in row] for row in single()]
    yield c3d_case(folder / "d.c3d", over, parameters={"POINT": {"Y_SCREEN": ["-Z"]}})
    case = c3d_case(folder / "e.c3d", parameters={"POINT": {"Y_SCREEN": ["up"]}})
    yield Case(case.path, note="POINT:Y_SCREEN is 'up': no axis")
