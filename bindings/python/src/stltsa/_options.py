# SPDX-License-Identifier: BSD-3-Clause
"""The library's options as keywords; the library has the table itself (`options`)."""

from __future__ import annotations

import itertools
import math
import operator
import re
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy as np

from ._keywords import Keywords
from ._native import ffi, lib
from ._progress import Progress  # noqa: TC001 (the keywords' types can be asked for)
from ._tables import aligned, html_table
from ._text import c_path, names, string

if TYPE_CHECKING:
    from collections.abc import Mapping


# Lengths in frames of the working rate, which "1.2s" gives in seconds, as in the command.
_IN_FRAMES = frozenset({"neighbors", "window", "exclusion"})


class Options(Keywords, total=False):
    """Keywords of the functions of this package.

    ``None`` leaves an option unset, and so does ``"auto"`` if the library can choose the value.
    :func:`stltsa.options` gives meaning, range and default of each. Functions ignore options that
    they do not use, except that all of them use `progress`. Lengths in frames and in seconds may be
    texts in seconds: ``neighbors="1.2s"``.
    """

    progress: Progress


class Option(NamedTuple):
    """One row of the library's table of options.

    `default` is None if the library chooses, by the rule that the text gives after "auto".
    """

    name: str
    text: str
    type: Literal["int", "real", "text"]
    choices: dict[str, int]
    minimum: float
    maximum: float
    default: int | float | None
    key: int

    @property
    def in_frames(self) -> bool:
        """Whether the value is a length in frames, or a text in seconds."""
        return self.name in _IN_FRAMES

    @property
    def in_seconds(self) -> bool:
        """Whether the value is a length in seconds."""
        return self.type == "real" and bool(re.search(r"\bseconds\b", self.text, re.IGNORECASE))

    @property
    def values(self) -> str:
        """The values that it takes, in words."""
        if self.choices:
            shown = " | ".join(self.choices)
        elif self.type == "text":
            shown = "name" if self.name == "individual" else "path"
        elif self.type == "int" and (self.minimum, self.maximum) == (0, 1):
            shown = "True | False"
        else:
            most = f" to {self.maximum:.10g}" if self.maximum < 2**31 - 1 else ""
            shown = f"{self.type} from {self.minimum:g}{most}"
            if self.in_frames or self.in_seconds:
                shown += ', or "1.2s"'
        return f"auto | {shown}" if self.default is None else shown

    @property
    def standard(self) -> str:
        """The default in words."""
        for name, value in self.choices.items():
            if value == self.default:
                return name
        if self.type == "int" and (self.minimum, self.maximum) == (0, 1):
            return str(bool(self.default))
        return "auto" if self.default is None else f"{self.default:g}"

    @property
    def wanted(self) -> str:
        """What a text must be, for an error."""
        if self.choices:
            return "one of: " + ", ".join([*self.choices, *(["auto"] * (self.default is None))])
        if self.in_frames:
            return 'a number of frames (36) or of seconds ("1.2s")'
        return 'a number of seconds (1.2 or "1.2s")' if self.in_seconds else "a number"


_TYPES: dict[int, Any] = names("STLTSA_TYPE_")


def _read_option(index: int) -> Option | None:
    """Return an option; None past the last one."""
    info = ffi.new("stltsa_option_info *", {"size": ffi.sizeof("stltsa_option_info")})
    if lib.stltsa_option_describe(index, info) != lib.STLTSA_OK:
        return None
    kind = _TYPES[info.type]
    named = string(info.choices).split() if info.choices else []
    choices = {name: int(value) for name, value in (choice.split("=") for choice in named)}
    default = (
        None if info.automatic else int(info.standard) if kind == "int" else float(info.standard)
    )
    name = string(info.name)
    return Option(
        "individual" if name == "subject" else name,  # as in datasets of `movement`
        string(info.text),
        kind,
        choices,
        info.minimum,
        info.maximum,
        default,
        info.key,
    )


_TABLE = {o.name: o for o in iter(map(_read_option, itertools.count()).__next__, None)}


def option_named(name: str) -> Option:
    """Return the option of that name; raise TypeError if there is none."""
    if name not in _TABLE:
        raise TypeError(f"there is no option {name!r}; stltsa.options() lists them")
    return _TABLE[name]


class OptionTable(tuple[Option, ...]):
    """The options as a tuple of rows, which shows itself as a table."""

    __slots__ = ()

    def _cells(self) -> list[tuple[str, str, str, str]]:
        head = ("option", "values", "default", "meaning")
        return [head, *((o.name, o.values, o.standard, o.text) for o in self)]

    def __repr__(self) -> str:
        return aligned(self._cells())

    def _repr_html_(self) -> str:
        return html_table(self._cells())


def options() -> OptionTable:
    """Return the table of all options: name, text, type, choices, range and default.

    Examples
    --------
    >>> import stltsa
    >>> neighbors = stltsa.options()[0]
    >>> neighbors.name, neighbors.type, neighbors.default
    ('neighbors', 'int', None)
    """
    return OptionTable(_TABLE.values())


def _number_of_text(option: Option, value: str, rate: float) -> float:
    """Return the value of a choice, or of a length such as "1.2s"."""
    if value in option.choices:
        return option.choices[value]
    takes_seconds = option.in_frames or option.in_seconds
    try:
        seconds = float(value[:-1]) if takes_seconds and value.endswith("s") else math.nan
    except ValueError:
        seconds = math.nan
    if not (math.isfinite(seconds) and (seconds > 0 or option.in_seconds)):
        raise ValueError(f"{option.name} is {value!r}, and must be {option.wanted}")
    if not rate and (option.in_frames or "rate is unknown" in option.text):
        raise ValueError(
            f"{option.name} is {value!r}, in seconds, and the frame rate is unknown: give it with "
            "fps=, or the length in frames"
        )
    if option.in_seconds:
        return seconds
    return min(max(1, math.floor(seconds * rate + 0.5)), int(option.maximum))


def _set(handle: Any, option: Option, value: Any, rate: float) -> int:
    if option.type == "text":
        return int(lib.stltsa_options_set_text(handle, option.key, c_path(value)))
    if isinstance(value, str):
        value = _number_of_text(option, value, rate)
    try:
        if option.type == "int":
            # Values too large for C are out of range, too.
            whole = min(max(operator.index(value), -(2**63)), 2**63 - 1)
            return int(lib.stltsa_options_set_int(handle, option.key, whole))
        return int(lib.stltsa_options_set_real(handle, option.key, float(value)))
    except (TypeError, OverflowError):
        wanted = "an integer" if option.type == "int" else "a number"
        raise TypeError(f"{option.name} is {value!r}, and must be {wanted}") from None


def working_rate(fps: float, values: Mapping[str, Any]) -> float:
    """Return the rate of a clip's working samples, to which `sample_rate` decimates; 0: unknown."""
    wanted = values.get("sample_rate")
    rate = _TABLE["sample_rate"].default if wanted is None else wanted
    return fps / max(1, math.floor(fps / rate + 0.5)) if fps and rate else fps


def rate_given(values: Mapping[str, Any]) -> float:
    """Return the rate of an array's rows from the option `fps`; 0: unknown."""
    fps = values.get("fps")
    return float(fps) if isinstance(fps, int | float | np.number) else 0.0


def set_options(handle: Any, values: Mapping[str, Any], rate: float = 0.0) -> int:
    """Set options by name; return the first status that is not OK, or 0.

    `rate`: frames per second, for lengths in seconds; 0: unknown.
    """
    for name, value in values.items():
        option = _TABLE.get(name)
        if option is None:
            raise TypeError(f"there is no option {name!r}; stltsa.options() lists them")
        if value is None or (option.default is None and isinstance(value, str) and value == "auto"):
            continue
        status = _set(handle, option, value, rate)
        if status != 0:
            return status
    return 0
