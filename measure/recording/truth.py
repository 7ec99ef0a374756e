# SPDX-License-Identifier: BSD-3-Clause
"""What is true of a recording."""

from dataclasses import dataclass, field, replace

import numpy as np


@dataclass
class Part:
    """A stretch of one behavior. A part with cycles has pieces: each a pair of rising times and the
    phases (in cycles) at these times. Between two pieces the phase jumps."""

    kind: str  # cyclic, repetitions, action, rest, or free: motion without a claim
    label: str  # empty for a rest
    begin: float  # seconds
    end: float
    pieces: list = field(default_factory=list)
    repetitions: list = field(default_factory=list)  # pairs of seconds
    still: list = field(default_factory=list)  # where the body rests within the part, pairs

    @property
    def moving(self):
        return self.kind != "rest"

    def crop(self, begin, end):
        """What is left of the part between two seconds, counted from the first."""
        def inside(pairs):
            return [(a - begin, b - begin) for a, b in pairs if a >= begin and b <= end]
        kept = [(times, phase, (times >= begin) & (times <= end)) for times, phase in self.pieces]
        return Part(self.kind, self.label, max(self.begin, begin) - begin,
                    min(self.end, end) - begin,
                    [(times[keep] - begin, phase[keep]) for times, phase, keep in kept
                     if keep.sum() > 1], inside(self.repetitions), inside(self.still))

    @property
    def marks(self):
        """The times at which the phase is a whole number, piece by piece."""
        return [np.interp(np.arange(np.ceil(phase[0] - 1e-9), np.floor(phase[-1] + 1e-9) + 1),
                          phase, times) for times, phase in self.pieces]

    @property
    def cycles(self):
        """Whole cycles by the true phase, as pairs of seconds."""
        return [pair for marks in self.marks for pair in zip(marks[:-1], marks[1:])]


@dataclass
class Recording:
    """Frames with their truth; either channels of a body or plain numbers."""

    name: str
    fps: float
    rows: np.ndarray
    parts: list
    body: object = None  # None: plain numbers
    blends: list = field(default_factory=list)  # pairs of seconds in which one motion becomes another
    border_at: str = "middle"  # where in a blend the border lies

    @property
    def seconds(self):
        return len(self.rows) / self.fps

    @property
    def cycles(self):
        return [pair for part in self.parts for pair in part.cycles]

    def borders(self):
        """Pairs (earliest, latest) between one moving part and the next; a rest is one border."""
        moving = [part for part in self.parts if part.moving]
        return [(a.end, b.begin) for a, b in zip(moving[:-1], moving[1:])]

    def crop(self, begin, end):
        """The recording from one second to another, and the seconds where it begins exactly."""
        first, last = (round(at * self.fps) for at in (begin, end))
        shift, stop = first / self.fps, last / self.fps
        parts = [part.crop(shift, stop) for part in self.parts
                 if part.begin < stop and part.end > shift]
        blends = [(a - shift, b - shift) for a, b in self.blends]
        return replace(self, rows=self.rows[first:last], parts=parts, blends=blends), shift

    def angles(self):
        """The joint angles as plain numbers, in radians."""
        return self._plain("angles", np.radians(self.rows[:, 3:]))

    def positions(self):
        """The positions of all joints as plain numbers, in cm."""
        chunks = [self.body.positions(self.rows[at:at + 20000]).reshape(-1, 3 * len(self.body.names))
                  for at in range(0, len(self.rows), 20000)]
        return self._plain("positions", np.concatenate(chunks))

    def _plain(self, what, rows):
        return Recording(f"{self.name}, {what}", self.fps, rows, self.parts, None, self.blends,
                         self.border_at)

    def clip(self, stltsa, folder):
        if self.body is None:
            return stltsa.Clip.from_array(self.rows, self.fps)
        path = folder / "recording.bvh"
        self.body.write(path, self.rows, self.fps)
        return stltsa.read_clip(str(path))
