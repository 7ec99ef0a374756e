#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the seeds of tests/fuzz/corpus: small files of each kind, made of synthetic motion.

Usage: make_corpus.py STLTSA (the command, which writes a model)
"""

import math
import pathlib
import random
import struct
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "command"))
from c3d_file import c3d  # noqa: E402

CORPUS = pathlib.Path(__file__).parent / "corpus"


def put(kind, name, content):
    folder = CORPUS / kind
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())


def angles(frames, channels):
    return [[round(20 * math.sin(2 * math.pi * i / 15 + c), 2) for c in range(channels)]
            for i in range(frames)]


def lines(rows, separator=" "):
    return "\n".join(separator.join(map(str, row)) for row in rows) + "\n"


def bvh(frames=60):
    return f"""HIERARCHY
ROOT hips
{{
 OFFSET 0 0 0
 CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
 JOINT LeftLeg
 {{
  OFFSET 1 -1 0
  CHANNELS 3 Zrotation Xrotation Yrotation
  End Site
  {{
   OFFSET 0 -8 0
  }}
 }}
 JOINT RightLeg
 {{
  OFFSET -1 -1 0
  CHANNELS 3 Zrotation Xrotation Yrotation
  End Site
  {{
   OFFSET 0 -8 0
  }}
 }}
}}
MOTION
Frames: {frames}
Frame Time: 0.0333333
{lines(angles(frames, 12))}"""


ASF = """:version 1.10
:units
  mass 1.0
  length 0.45
  angle deg
:root
  order TX TY TZ RX RY RZ
  axis XYZ
  position 0 0 0
  orientation 0 0 0
:bonedata
  begin
    id 1
    name lfemur
    direction 0.3 -0.9 0
    length 7
    axis 0 0 20 XYZ
    dof rx ry rz
  end
  begin
    id 2
    name rfemur
    direction -0.3 -0.9 0
    length 7
    axis 0 0 -20 XYZ
    dof rx
  end
:hierarchy
  begin
    root lfemur rfemur
  end
"""


def amc(frames=60):
    text = ":FULLY-SPECIFIED\n:DEGREES\n:SAMPLES-PER-SECOND 30\n"
    for i, row in enumerate(angles(frames, 10), 1):
        text += f"{i}\nroot {' '.join(map(str, row[:6]))}\n"
        text += f"lfemur {' '.join(map(str, row[6:9]))}\nrfemur {row[9]}\n"
    return text


def npy(rows, shape, descr="<f8", order="False"):
    header = f"{{'descr': '{descr}', 'fortran_order': {order}, 'shape': {shape}, }}"
    header += " " * (63 - (10 + len(header)) % 64) + "\n"
    code = {"<f8": "<d", "<f4": "<f", ">f8": ">d"}[descr]
    return (b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode()
            + b"".join(struct.pack(code, value) for row in rows for value in row))


def trc(times, rows, separator="\t"):
    text = ("PathFileType|4|(X/Y/Z)|walk.trc\nDataRate|CameraRate|NumFrames|NumMarkers|Units\n"
            f"30|30|{len(rows)}|2|mm\nFrame#|Time|heel|||toe||\n||X1|Y1|Z1|X2|Y2|Z2\n\n")
    return text.replace("|", separator) + lines(
        ([i, time, *row] for i, (time, row) in enumerate(zip(times, rows, strict=True), 1)),
        separator)


def mot(times, rows, more="inDegrees=yes\n"):
    return (f"Coordinates\nversion=1\nnRows={len(rows)}\nnColumns={len(rows[0]) + 1}\n{more}"
            "endheader\ntime\t" + "\t".join(f"angle{i}" for i in range(len(rows[0]))) + "\n"
            + lines(([time, *row] for time, row in zip(times, rows, strict=True)), "\t"))


def opensim(rows):
    even = [round(i / 30, 3) for i in range(len(rows))]
    uneven = [round(0.03 * i + 0.01 * math.sin(i), 4) for i in range(len(rows))]
    lost = [time + (0.5 if i > 30 else 0) for i, time in enumerate(even)]
    put("trc", "walk", trc(even, rows))
    put("trc", "lost", trc(lost, rows, ","))
    put("trc", "gaps", trc(even, rows).replace("\t20.0", "\t"))
    put("mot", "walk", mot(even, rows))
    put("mot", "uneven", mot(uneven, rows))
    put("mot", "vectors", mot(even, [[",".join(map(str, row[:3]))] for row in rows],
                              "DataType=Vec3\n"))
    put("csv", "dates", "timestamp,a,b\n" + lines(
        ([f"2024-01-01 12:00:{time:06.3f}", *row[:2]]
         for time, row in zip(even, rows, strict=True)), ","))
    put("csv", "packets", "packet counter,a,b\n" + lines(
        ([(200 + i + (3 if i > 30 else 0)) % 256, *row[:2]] for i, row in enumerate(rows)), ","))


def main():
    put("bvh", "walk", bvh())
    put("bvh", "few", bvh(3))
    put("acclaim", "walk", f"{ASF}\0{amc()}")
    rows = angles(60, 6)
    put("csv", "numbers", lines(rows, ","))
    put("csv", "points", "time,heel_x,heel_y,heel_z,toe_x,toe_y,toe_z\n"
        + lines(([i / 30, *row] for i, row in enumerate(rows)), ","))
    put("csv", "gaps", "a_x;a_y;a_z;b_x;b_y;b_z\n" + lines(rows, ";").replace("20.0", ""))
    put("csv", "two-lines", "scorer,m,m,m\nbodyparts,nose,nose,nose\ncoords,x,y,likelihood\n"
        + lines(([i, *row[:3]] for i, row in enumerate(rows)), ","))
    opensim(rows)
    put("npy", "rows", npy(rows, "(60, 6)"))
    put("npy", "points", npy(rows, "(60, 2, 3)", "<f4"))
    put("npy", "fortran", npy(rows, "(60, 6)", ">f8", "True"))
    few = angles(20, 9)
    events = {"LABELS": ["Foot Strike", "Foot Off"], "CONTEXTS": ["Left", "Right"],
              "TIMES": [0.0, 0.1, 0.0, 0.2]}  # fmt: skip
    point = {"Y_SCREEN": ["+Z"], "UNITS": ["mm"], "RATE": [30.0], "LABELS2": ["TOE"]}
    put("c3d", "points", c3d(few, ("HIP", "KNEE", "TOE"), 30, missing={(3, 1)},
                             parameters={"EVENT": events, "POINT": point}))  # fmt: skip
    put("c3d", "mips", c3d(few, ("HIP", "KneeAngles"), order=">", first=704, analog=3,
                           parameters={"ANALOG": {"USED": [3], "LABELS": ["Fx"]}}))  # fmt: skip
    put("c3d", "refused-analog", c3d([[]] * 4, (), analog=2, parameters={"ANALOG": {"USED": [2]}}))
    put("c3d", "refused-cut", c3d(few, ("HIP",))[:1400])
    with tempfile.TemporaryDirectory() as folder:
        clip = pathlib.Path(folder) / "walk.bvh"
        clip.write_text(bvh(90))
        for name, more in (("plain", ["--features", "euler"]), ("positions", []),
                           ("live", ["--mark", "37=heel"])):
            model = pathlib.Path(folder) / f"{name}.stltsa"
            subprocess.run([sys.argv[1], "fit", clip, "-o", model, "-q", *more], check=True)
            put("model", name, model.read_bytes())
    numbers = random.Random(4)
    for what in range(8):
        cycles = [int(124 + 60 * math.sin(2 * math.pi * i / 20)) for i in range(300)]
        put("api", f"call{what}", bytes([what, 0, 59, 3, *cycles]))
        put("api", f"random{what}", bytes([what, 3, *numbers.randbytes(400)]))


if __name__ == "__main__":
    main()
