# SPDX-License-Identifier: BSD-3-Clause
"""Writes C3D files for tests."""

import struct

BLOCK = 512
PROCESSORS = {"<": 84, "dec": 85, ">": 86}  # Intel, DEC, MIPS


def _pack(order, kinds, *values):
    """Numbers as the processor writes them."""
    if order != "dec":
        return struct.pack(order + kinds, *values)
    parts = []
    for kind, value in zip(kinds, values, strict=True):
        # Reals of DEC count the exponent from 2 more, and have the more significant half first.
        part = struct.pack("<" + kind, 4 * value if kind == "f" else value)
        parts.append(part[2:] + part[:2] if kind == "f" else part)
    return b"".join(parts)


def _entry(order, name, group, content):
    return struct.pack("bb", len(name), group) + name.encode() + _pack(
        order, "H", len(content) + 3) + content + b"\0"


def _content(order, values):
    """Texts, integers or real numbers, as a parameter holds them."""
    if isinstance(values[0], str):
        length = max(map(len, values))
        return struct.pack("bBBB", -1, 2, length, len(values)) + "".join(
            value.ljust(length) for value in values).encode()
    code, size = ("H", 2) if isinstance(values[0], int) else ("f", 4)
    return struct.pack("bBB", size, 1, len(values)) + _pack(order, code * len(values), *values)


def c3d(rows, names, rate=100.0, *, order="<", first=1, missing=(), parameters=None, analog=0,
        scale=None, residual=0.0):  # fmt: skip
    """Bytes of a file. `rows`: x, y, z of each point; `missing`: (frame, point); `parameters`: values by
    group and name, besides POINT:LABELS; `scale`: of integers, None: the file has real numbers."""
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
    head = struct.pack("BB", 2, 80) + _pack(
        order, "HHHHHfHHf", points, analog, first % 65536, last % 65536, 10, scale or -1.0,
        2 + len(section) // BLOCK, 0, rate)
    kind, unit = ("f", 1) if scale is None else ("h", scale)
    data = bytearray()
    for i, row in enumerate(rows):
        for p in range(points):
            last = -unit if (i, p) in missing else residual
            values = [value / unit for value in (*row[3 * p : 3 * p + 3], last)]
            data += _pack(order, 4 * kind, *(values if scale is None else map(round, values)))
        data += _pack(order, analog * kind, *[0] * analog)
    return head.ljust(BLOCK, b"\0") + section + bytes(data)
