# SPDX-License-Identifier: BSD-3-Clause
"""The library's options as keywords; the library has the table itself (`options`)."""

from __future__ import annotations

import operator
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from ._keywords import Keywords
from ._native import ffi, lib
from ._progress import Progress  # noqa: TC001 (the keywords' types can be asked for)
from ._text import c_path, names, string

if TYPE_CHECKING:
    from collections.abc import Mapping


class Options(Keywords, total=False):
    """Keywords of the functions of this package.

    ``None`` leaves an option unset, and so does ``"auto"`` if the library can choose the value.
    :func:`stltsa.options` gives meaning, range and default of each. Functions ignore options that
    they do not use, except that all of them use `progress`.
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


_TYPES: dict[int, Any] = names("STLTSA_TYPE_")


def _read_option(index: int) -> Option:
    info = ffi.new("stltsa_option_info *", {"size": ffi.sizeof("stltsa_option_info")})
    if lib.stltsa_option_describe(index, info) != 0:
        raise RuntimeError(string(lib.stltsa_last_error()))
    kind = _TYPES[info.type]
    named = string(info.choices).split() if info.choices else []
    choices = {name: int(value) for name, value in (choice.split("=") for choice in named)}
    default = (
        None if info.automatic else int(info.standard) if kind == "int" else float(info.standard)
    )
    return Option(
        string(info.name),
        string(info.text),
        kind,
        choices,
        info.minimum,
        info.maximum,
        default,
        info.key,
    )


_TABLE = {o.name: o for o in map(_read_option, range(lib.stltsa_option_count()))}


def options() -> tuple[Option, ...]:
    """Return the table of all options: name, text, type, choices, range and default.

    Examples
    --------
    >>> import stltsa
    >>> neighbors = stltsa.options()[0]
    >>> neighbors.name, neighbors.type, neighbors.default
    ('neighbors', 'int', None)
    """
    return tuple(_TABLE.values())


def _number_of_choice(option: Option, value: str) -> int:
    if value in option.choices:
        return option.choices[value]
    choices = [*option.choices, *(["auto"] if option.default is None else [])]
    wanted = f"one of: {', '.join(choices)}" if option.choices else "a number"
    raise ValueError(f"{option.name} is {value!r}, and must be {wanted}")


def _set(handle: Any, option: Option, value: Any) -> int:
    if option.type == "text":
        return int(lib.stltsa_options_set_text(handle, option.key, c_path(value)))
    if isinstance(value, str):
        value = _number_of_choice(option, value)
    try:
        if option.type == "int":
            # Values too large for C are out of range, too.
            whole = min(max(operator.index(value), -(2**63)), 2**63 - 1)
            return int(lib.stltsa_options_set_int(handle, option.key, whole))
        return int(lib.stltsa_options_set_real(handle, option.key, float(value)))
    except (TypeError, OverflowError):
        wanted = "an integer" if option.type == "int" else "a number"
        raise TypeError(f"{option.name} is {value!r}, and must be {wanted}") from None


def set_options(handle: Any, values: Mapping[str, Any]) -> int:
    """Set options by name; return the first status that is not OK, or 0."""
    for name, value in values.items():
        option = _TABLE.get(name)
        if option is None:
            raise TypeError(f"there is no option {name!r}; stltsa.options() lists them")
        if value is None or (option.default is None and isinstance(value, str) and value == "auto"):
            continue
        status = _set(handle, option, value)
        if status != 0:
            return status
    return 0
