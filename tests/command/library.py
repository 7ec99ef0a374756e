# SPDX-License-Identifier: BSD-3-Clause
"""The C interface through ctypes: structs, calls, and handles with what they say by name."""

import ctypes
import json
import os
import pathlib
import re
from ctypes import POINTER, Structure, byref, c_char_p, c_double, c_int32, c_int64, c_size_t, c_void_p, sizeof

lib = ctypes.CDLL(os.environ["STLTSA_LIBRARY"])
HEADER = pathlib.Path(os.environ["STLTSA_HEADER"]).read_text()

INT, REAL, TEXT, ROWS, ARRAY = range(1, 6)
TYPES = {"size_t ": c_size_t, "int32_t ": c_int32, "int64_t ": c_int64, "double ": c_double,
         "const char *": c_char_p, "const char *const *": POINTER(c_char_p)}


def structs():
    """The structs of the header whose members have these types, or are such structs."""
    text = re.sub(r"/\*.*?\*/", "", HEADER, flags=re.DOTALL)
    found = {}
    for name, body in re.findall(r"typedef struct stltsa_(\w+) \{(.*?)\}", text, re.DOTALL):
        members = re.findall(r"((?:const )?\w+ (?:\*(?:const \*)?)?)(\w[\w, \[\]]*);", body)
        types = {**TYPES, **{f"stltsa_{known} ": struct for known, struct in found.items()}}
        if all(kind in types for kind, _ in members):
            fields = [(member, types[kind] * int(size) if size else types[kind]) for kind, names in members
                      for member, size in re.findall(r"(\w+)(?:\[(\d+)\])?", names)]
            found[name] = type(name, (Structure,), {"_fields_": fields})
    return found


STRUCTS = structs()
LISTS = dict((key.lower(), STRUCTS[struct]) for key, struct in
             re.findall(r"\bSTLTSA_INFO_(\w+) = \d+,?\s*/\* rows\s+stltsa_(\w+)", HEADER))
OPTIONS, CONSTANTS = ({name: int(number) for name, number in re.findall(rf"\b{prefix}(\w+) = (-?\d+)", HEADER)}
                      for prefix in ("STLTSA_OPT_", "STLTSA_"))


class Piece(Structure):
    _fields_ = [("clip", c_void_p), ("begin", c_int64), ("end", c_int64), ("repeat", c_int64),
                ("reserved", c_int64)]


class Out(Structure):
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
    while True:
        row = STRUCTS["info_key"](size=sizeof(STRUCTS["info_key"]))
        if value("info_describe", c_int32, c_int64(len(keys)), byref(row)) != 0:
            return keys
        keys[row.name.decode()] = row


KEYS = described()


class Handle:
    """A handle of the library, with what it says by name."""

    def __init__(self, kind, make, *arguments):
        self.kind, self.pointer = kind, c_void_p()
        call(make, *arguments, byref(self.pointer))
        self.info = c_void_p(value(kind + "_info", c_void_p, self.pointer))

    def free(self):
        value(self.kind + "_free", None, self.pointer)

    def count(self, name):
        return value("info_count", c_int64, self.info, KEYS[name].key)

    def list(self, name):
        """The values of a key; of rows, structs."""
        key, count = KEYS[name], self.count(name)
        if key.type == ROWS:
            rows = (LISTS[name] * count)()
            if count:
                call("info_rows", self.info, key.key, c_int64(0), c_int64(count), rows, c_size_t(sizeof(rows[0])))
            return list(rows)
        type_, function = {INT: (c_int64, "info_int"), REAL: (c_double, "info_real"),
                           TEXT: (c_char_p, "info_text")}[key.type]
        found = []
        for index in range(count):
            out = type_()
            call(function, self.info, key.key, c_int64(index), byref(out))
            found.append(out.value.decode() if key.type == TEXT else out.value)
        return found

    def array(self, name):
        """The numbers of an array, row by row."""
        shape = c_int64(), c_int64()
        call("info_shape", self.info, KEYS[name].key, *map(byref, shape))
        rows, cols = (length.value for length in shape)
        data = (c_double * (rows * cols))()
        out = Out(ctypes.cast(data, c_void_p), rows, cols, 0, 0, CONSTANTS["F64"], 0)
        call("info_array", self.info, KEYS[name].key, c_int64(0), byref(out))
        return list(data)

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
        call("info_json", self.info, byref(out))
        try:
            return json.loads(ctypes.string_at(out).decode())
        finally:
            value("free", None, out)
