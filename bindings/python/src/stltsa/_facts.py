# SPDX-License-Identifier: BSD-3-Clause
"""Facts about an object of the library, by name and as JSON."""

from __future__ import annotations

from typing import Any, ClassVar, NamedTuple

from ._call import check, json_text
from ._native import ffi, lib
from ._text import names, string

_HANDLES = {name: bit for bit, name in names("STLTSA_HANDLE_").items()}
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

    @classmethod
    def at(cls, index: int) -> _Key:
        row = ffi.new("stltsa_info_key *", {"size": ffi.sizeof("stltsa_info_key")})
        check(lib.stltsa_info_describe(index, row))
        named = string(row.choices).split() if row.choices else []
        choices = {int(value): name for name, value in (choice.split("=") for choice in named)}
        return cls(row.key, row.type, string(row.name), choices, bool(row.is_list), row.handles)

    def value(self, info: Any, index: int) -> Any:
        read, place, as_python = _READERS[self.type]
        out = ffi.new(place)
        check(read(info, self.key, index, out))
        value = as_python(out[0])
        return self.choices.get(value, value)


_KEYS = {key.name: key for key in map(_Key.at, range(lib.stltsa_info_key_count()))}


class Described:
    """An object of the library; `_kind` is the middle of ``stltsa_<kind>_info``."""

    _kind: ClassVar[str]
    _handle: Any

    @property
    def facts(self) -> dict[str, Any]:
        """All facts about the object, by name, in the library's terms.

        ``stltsa.h`` describes each (``STLTSA_INFO_*``). Lists are tuples; enum values are given by
        name, such as ``"positions"``. Facts that the object does not have are absent.
        """
        result: dict[str, Any] = {}
        for key in _KEYS.values():
            if not key.handles & _HANDLES[self._kind]:
                continue
            values = self._values(key)
            if key.is_list:
                result[key.name] = values
            elif values:
                result[key.name] = values[0]
        return result

    def _fact(self, name: str) -> tuple[Any, ...]:
        """Return the values of one fact, without working out the others."""
        return self._values(_KEYS[name])

    def _int(self, name: str) -> int:
        """Return an integer that the object has."""
        return int(self._fact(name)[0])

    def _real(self, name: str) -> float:
        """Return a real number that the object has."""
        return float(self._fact(name)[0])

    def _values(self, key: _Key) -> tuple[Any, ...]:
        handle = self._handle  # owns the facts, and may be replaced by another thread
        info = getattr(lib, f"stltsa_{self._kind}_info")(handle)
        count = lib.stltsa_info_count(info, key.key)
        return tuple(key.value(info, index) for index in range(count))

    def to_json(self) -> str:
        """Return all facts as one JSON object; its schema is ``stltsa-<kind>/1``."""
        return json_text(getattr(lib, f"stltsa_{self._kind}_json"), self._handle)
