# SPDX-License-Identifier: BSD-3-Clause
"""What an object of the library says, by key: facts, rows, arrays, JSON."""

from __future__ import annotations

import itertools
from functools import cache, partial
from math import isnan
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, NamedTuple, get_origin, get_type_hints

import numpy as np

from ._arrays import FloatArray, IntArray, write_to
from ._call import check
from ._native import ffi, lib
from ._rows import IN_C, LISTS
from ._text import names, string
from .errors import in_keywords

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    import numpy.typing as npt

_NAN = float("nan")  # a single one, so that rows with it equal each other
_HANDLES = {name: bit for bit, name in names("STLTSA_HANDLE_").items()}


def _number(value: float) -> float:
    return _NAN if isnan(value) else value


def _texts(values: Any) -> tuple[str, ...]:
    """Return the texts before NULL."""
    of = itertools.takewhile(bool, map(values.__getitem__, itertools.count() if values else ()))
    return tuple(map(string, of))


_FROM_C: dict[Any, Callable[[Any], Any]] = {
    int: int,
    float: _number,
    bool: bool,
    str: string,
    str | None: lambda text: string(text) if text else None,
    tuple[str, ...]: _texts,
    tuple[float, float, float]: tuple,
}


def _converter(hint: Any) -> Callable[[Any], Any]:
    if get_origin(hint) is Annotated:  # a kind
        kinds = {value: name.replace("_", "-") for value, name in names(*hint.__metadata__).items()}
        return lambda value: kinds.get(value, "unknown")
    return partial(row_of, hint) if hasattr(hint, "_fields") else _FROM_C[hint]


@cache
def _converters(kind: Any) -> dict[str, Callable[[Any], Any]]:
    return {n: _converter(h) for n, h in get_type_hints(kind, include_extras=True).items()}


def row_of(kind: Any, raw: Any, **more: Any) -> Any:
    """Return a struct of the library as a NamedTuple; its fields are members, and `more`."""
    c_names = {name: IN_C[name] for name in IN_C if hasattr(raw, IN_C[name])}
    fields = {name: of for name, of in _converters(kind).items() if name not in more}
    return kind(**{n: of(getattr(raw, c_names.get(n, n))) for n, of in fields.items()}, **more)


def without_seconds(row: Any, *, all_of_it: bool = False) -> Any:
    """Return the row of a motion whose rate is unknown: what depends on the rate is NaN."""

    def values() -> Iterator[Any]:
        for name, value in zip(row._fields, row, strict=True):
            of_rate = name in ("seconds", "fps", "trend", "speed")
            timed = all_of_it or of_rate or name.endswith(("_s", "_per_min"))
            if hasattr(value, "_fields"):
                yield without_seconds(value, all_of_it=timed)
            elif timed and isinstance(value, float | bool):
                yield _NAN if isinstance(value, float) else False
            else:
                yield value

    return row._make(values())


_READERS: dict[int, tuple[Any, str, Any]] = {
    lib.STLTSA_TYPE_INT: (lib.stltsa_info_int, "int64_t *", int),
    lib.STLTSA_TYPE_REAL: (lib.stltsa_info_real, "double *", float),
    lib.STLTSA_TYPE_TEXT: (lib.stltsa_info_text, "char const **", string),
}


class _Key(NamedTuple):
    key: int
    type: int
    name: str
    choices: dict[int, str]
    is_list: bool
    handles: int

    def values(self, info: Any) -> tuple[Any, ...]:
        count = lib.stltsa_info_count(info, self.key)
        if self.type == lib.STLTSA_TYPE_ROWS:
            struct, kind = LISTS[self.name]
            raw = ffi.new(f"{struct}[]", count)
            if count:
                size = ffi.sizeof(struct)
                check(lib.stltsa_info_rows(info, self.key, 0, count, raw, size))
            return tuple(row_of(kind, each) for each in raw)
        return tuple(self._value(info, index) for index in range(count))

    def _value(self, info: Any, index: int) -> Any:
        read, place, as_python = _READERS[self.type]
        out = ffi.new(place)
        check(read(info, self.key, index, out))
        value = as_python(out[0])
        return self.choices.get(value, value)


def _keys() -> Iterator[_Key]:
    row = ffi.new("stltsa_info_key *", {"size": ffi.sizeof("stltsa_info_key")})
    for index in itertools.count():
        if lib.stltsa_info_describe(index, row) != lib.STLTSA_OK:
            return
        choices = (choice.split("=") for choice in string(row.choices).split())
        named = {int(value): name for name, value in choices}
        yield _Key(row.key, row.type, string(row.name), named, bool(row.is_list), row.handles)


_KEYS = {key.name: key for key in _keys()}


class Described:
    """An object of the library; `_kind` is the middle of ``stltsa_<kind>_info``."""

    _kind: ClassVar[str]

    def __init__(self, handle: Any, *, timed: bool = True) -> None:
        self._handle = handle
        self._timed = timed  # False: the rate is unknown, so what depends on it is NaN

    @property
    def facts(self) -> dict[str, Any]:
        """All facts and lists of the object, by name, in the library's terms.

        ``stltsa.h`` describes each (``STLTSA_INFO_*``). Lists are tuples; enum values are given by
        name, such as ``"positions"``. Facts that the object does not have are absent.
        """
        result: dict[str, Any] = {}
        for key in _KEYS.values():
            if not key.handles & _HANDLES[self._kind] or key.type == lib.STLTSA_TYPE_ARRAY:
                continue
            values = self._list(key.name)
            if key.is_list:
                result[key.name] = values
            elif values:
                result[key.name] = values[0]
        return result

    @property
    def warnings(self) -> tuple[str, ...]:
        """What a user should know about the result; their times are among the :attr:`facts`."""
        return in_keywords(warning.text for warning in self._list("warning"))

    def to_json(self) -> str:
        """Return all facts as one JSON object; its schema is ``stltsa-<kind>/<version>``."""
        handle, out = self._handle, ffi.new("char **")
        check(lib.stltsa_info_json(self._info(handle), out))
        try:
            return string(out[0])
        finally:
            lib.stltsa_free(out[0])

    def _info(self, handle: Any) -> Any:
        """Return what a handle says; the handle must be kept as long."""
        return getattr(lib, f"stltsa_{self._kind}_info")(handle)

    def _list(self, name: str) -> tuple[Any, ...]:
        """Return the values or rows of a key; none if the object lacks it."""
        handle = self._handle  # owns what is read, and may be replaced by another thread
        key = _KEYS[name]
        rows = key.values(self._info(handle))
        if key.type == lib.STLTSA_TYPE_ROWS and not self._timed:
            return tuple(map(without_seconds, rows))
        return rows

    def _int(self, name: str) -> int:
        """Return an integer that the object has."""
        return int(self._list(name)[0])

    def _real(self, name: str) -> float:
        """Return a real number that the object has."""
        return float(self._list(name)[0])

    def _text(self, name: str) -> str:
        """Return a text, or the name of a value, that the object has."""
        return str(self._list(name)[0])

    def _filled(self, name: str, index: int, dtype: type[Any]) -> npt.NDArray[Any]:
        handle, key = self._handle, _KEYS[name].key
        shape = ffi.new("int64_t[2]")
        check(lib.stltsa_info_shape(self._info(handle), key, shape, shape + 1))
        result = np.empty((shape[0], shape[1]), dtype)
        check(lib.stltsa_info_array(self._info(handle), key, index, write_to(result)))
        return result

    def _array(self, name: str, index: int = 0) -> FloatArray:
        """Return a matrix of real numbers; `index`: which, if there are several."""
        return self._filled(name, index, np.float64)

    def _integers(self, name: str) -> IntArray:
        """Return an array of a single column of integers."""
        return self._filled(name, 0, np.int64)[:, 0]
