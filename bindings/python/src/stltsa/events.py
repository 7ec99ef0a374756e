# SPDX-License-Identifier: BSD-3-Clause
"""Events of a recording, such as heel strikes."""

from __future__ import annotations

from typing import NamedTuple


class Event(NamedTuple):
    """Something that happens at one moment.

    `label` is its name, such as ``"Foot Strike"``; `context` what it happens to, such as
    ``"Left"``, or an empty text; `seconds` count from the first frame of the clip.
    """

    label: str
    context: str
    seconds: float
