# SPDX-License-Identifier: BSD-3-Clause
"""The C interface through ctypes: structs, calls, and handles with their facts by name."""

import ctypes
import json
import os
from ctypes import (
    byref, c_char_p, c_double, c_int32, c_int64, c_size_t, c_void_p)

lib = ctypes.CDLL(os.environ["STLTSA_LIBRARY"])


class InfoKey(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("key", c_int32), ("type", c_int32), ("name", c_char_p),
                ("text", c_char_p), ("choices", c_char_p), ("is_list", c_int32),
                ("handles", c_int32)]


class Interval(ctypes.Structure):
    _fields_ = [("begin", c_int64), ("end", c_int64), ("begin_s", c_double), ("end_s", c_double),
                ("kind", c_int32), ("segment", c_int32)]


class Joint(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("name", c_char_p), ("parent", c_int64),
                ("offset", c_double * 3), ("channels", c_char_p), ("is_end_site", c_int32),
                ("reserved", c_int32)]


class FileEvent(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("label", c_char_p), ("context", c_char_p), ("frame", c_double),
                ("seconds", c_double)]


class Segment(ctypes.Structure):
    _fields_ = [("begin", c_int64), ("end", c_int64), ("begin_s", c_double), ("end_s", c_double),
                ("count", c_int64), ("likeness", c_double), ("period_s", c_double),
                ("candidate_period_s", c_double), ("confidence", c_double),
                ("begin_confidence", c_double), ("kind", c_int32), ("label", c_int32),
                ("open_begin", c_int32), ("open_end", c_int32)]


class Part(ctypes.Structure):
    _fields_ = [("begin", c_int64), ("end", c_int64), ("begin_s", c_double), ("end_s", c_double),
                ("segment", c_int64), ("parent", c_int64), ("likeness", c_double),
                ("confidence", c_double), ("side", c_int32), ("reserved", c_int32)]


class Travel(ctypes.Structure):
    _fields_ = [("way", c_double), ("stride", c_double), ("speed", c_double), ("turn", c_double)]


class Statistics(ctypes.Structure):
    _fields_ = [("count", c_int64), ("mean", c_double), ("sd", c_double), ("cv", c_double),
                ("trend", c_double)]


class Summary(ctypes.Structure):
    _fields_ = [("count", c_int64), ("per_minute", c_double), ("mean_s", c_double),
                ("sd_s", c_double), ("cv", c_double), ("trend", c_double), ("label", c_int32),
                ("reserved", c_int32)]


class Piece(ctypes.Structure):
    _fields_ = [("clip", c_void_p), ("begin", c_int64), ("end", c_int64), ("repeat", c_int64),
                ("reserved", c_int64)]


class Seam(ctypes.Structure):
    _fields_ = [("size", c_size_t), *((name, c_int64) for name in (
        "frame", "piece", "next", "cut_end", "cut_begin", "crossfade")),
        ("posture", c_double), ("step", c_double), ("acceleration", c_double)]


class Out(ctypes.Structure):
    _fields_ = [("data", c_void_p), ("rows", c_int64), ("cols", c_int64),
                ("row_stride", c_int64), ("col_stride", c_int64), ("dtype", c_int32),
                ("reserved", c_int32)]


def call(name, *arguments):
    function = lib["stltsa_" + name]
    function.restype = c_int32
    status = function(*arguments)
    if status != 0:
        lib.stltsa_last_error.restype = c_char_p
        raise ValueError(f"{name}: {lib.stltsa_last_error().decode()}")


def value(name, restype, *arguments):
    function = lib["stltsa_" + name]
    function.restype = restype
    return function(*arguments)


def described():
    keys = {}
    for index in range(value("info_key_count", c_int64)):
        row = InfoKey(size=ctypes.sizeof(InfoKey))
        call("info_describe", c_int64(index), byref(row))
        keys[row.name.decode()] = row
    return keys


KEYS = described()


class Handle:
    """A handle of the library, with its facts by name."""

    def __init__(self, kind, make, *arguments):
        self.kind, out = kind, c_void_p()
        call(make, *arguments, byref(out))
        self.pointer = out
        self.info = c_void_p(value(kind + "_info", c_void_p, out))

    def free(self):
        value(self.kind + "_free", None, self.pointer)

    def list(self, name):
        key = KEYS[name]
        type_, function = {1: (c_int64, "info_int"), 2: (c_double, "info_real"),
                           3: (c_char_p, "info_text")}[key.type]
        found = []
        for index in range(value("info_count", c_int64, self.info, key.key)):
            out = type_()
            call(function, self.info, key.key, c_int64(index), byref(out))
            found.append(out.value.decode() if key.type == 3 else out.value)
        return found

    def __getitem__(self, name):
        (found,) = self.list(name)
        return found

    def maybe(self, name):
        return next(iter(self.list(name)), None)

    def choice(self, name):
        """The name of an enumerated value; None if the value 0 means "none"."""
        names = dict(pair.split("=")[::-1] for pair in KEYS[name].choices.decode().split())
        found = names[str(self[name])]
        return None if found == "none" else found

    def json(self):
        out = c_void_p()
        call(self.kind + "_json", self.pointer, byref(out))
        try:
            return json.loads(ctypes.string_at(out).decode())
        finally:
            value("free", None, out)

    def rows(self, function, item):
        for index in range(value(f"{self.kind}_{function}_count", c_int64, self.pointer)):
            if hasattr(item, "size"):
                item.size = ctypes.sizeof(item)
            call(f"{self.kind}_{function}", self.pointer, c_int64(index), byref(item))
            yield item
