# SPDX-License-Identifier: BSD-3-Clause
"""Writes C3D files for tests."""

import struct

BLOCK = 512
PROCESSORS = {"<": 84, ">": 86}


def _entry(order, name, group, content):
    return struct.pack("bb", len(name), group) + name.encode() + struct.pack(
        order + "H", len(content) + 3) + content + b"\0"


def _content(order, values):
    """Texts, integers or real numbers, as a parameter holds them."""
    if isinstance(values[0], str):
        length = max(map(len, values))
        return struct.pack("bBBB", -1, 2, length, len(values)) + "".join(
            value.ljust(length) for value in values).encode()
    code, size = ("H", 2) if isinstance(values[0], int) else ("f", 4)
    return struct.pack(f"{order}bBB{len(values)}{code}", size, 1, len(values), *values)


def c3d(rows, names, rate=100.0, *, order="<", first=1, missing=(), parameters=None, analog=0):
    """Bytes of a file of real numbers. `rows`: x, y, z of each point; `missing`: (frame, point);
    `parameters`: values by group and name, besides POINT:LABELS."""
    groups = {"POINT": {}} | (parameters or {})
    if names:
        groups["POINT"] = {"LABELS": list(names)} | groups["POINT"]
    entries = b""
    for number, (group, values) in enumerate(groups.items(), 1):
        entries += _entry(order, group, -number, b"\0")
        for name, value in values.items():
            entries += _entry(order, name, number, _content(order, value))
    section = struct.pack("4B", 1, 80, 2, PROCESSORS[order]) + entries + b"\0\0"
    section = section.ljust(-(-len(section) // BLOCK) * BLOCK, b"\0")
    points, last = len(rows[0]) // 3, first + len(rows) - 1
    head = struct.pack("BB", 2, 80) + struct.pack(
        order + "HHHHHfHHf", points, analog, first % 65536, last % 65536, 10, -1.0,
        2 + len(section) // BLOCK, 0, rate)
    data = bytearray()
    for i, row in enumerate(rows):
        for p in range(points):
            residual = -1.0 if (i, p) in missing else 0.0
            data += struct.pack(order + "4f", *row[3 * p : 3 * p + 3], residual)
        data += struct.pack(f"{order}{analog}f", *[0.0] * analog)
    return head.ljust(BLOCK, b"\0") + section + bytes(data)
