# SPDX-License-Identifier: BSD-3-Clause
"""The body of the synthetic walker (tests/walker), posed by its channels: degrees and cm."""

import json
import subprocess
import tempfile
from pathlib import Path

import numpy as np

SAMPLES = 512  # of one stride


def about(axis, degrees):
    """Rotation matrices about one axis (0: x, 1: y, 2: z)."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    following, last = (axis + 1) % 3, (axis + 2) % 3
    r = np.zeros((len(degrees), 3, 3))
    r[:, axis, axis] = 1
    r[:, following, following] = r[:, last, last] = c
    r[:, last, following], r[:, following, last] = s, -s
    return r


class Body:
    """Joints, the standing pose, and one stride of the walker, from the program stltsa-walker.

    A channel is named by joint and axis, such as "LeftArm.Z"; those of the root's place begin with
    "place". At phase 0 of a stride the legs pass each other.
    """

    def __init__(self, walker):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "walk.bvh"
            subprocess.run([walker, "-o", path, "--fps", str(SAMPLES), "--period", "1", "--cycles",
                            "1"], check=True)
            lines = path.read_text().splitlines()
            true = json.loads(path.with_suffix(".json").read_text())
        motion = lines.index("MOTION")
        self.head = lines[:motion + 1]
        self._read_joints()
        rows = np.array([line.split() for line in lines[motion + 3:]], float)
        self._read_stride(rows, true["cycles"][0])

    def _read_joints(self):
        """Joints and end sites of the hierarchy, parents first."""
        self.names, self.parents, self.offsets, self.channels = [], [], [], []
        open_joints = []
        for words in map(str.split, self.head[1:]):
            if words[0] in ("ROOT", "JOINT", "End"):
                self.names.append(words[1] if words[0] != "End" else None)
                self.parents.append(open_joints[-1] if open_joints else -1)
            elif words[0] == "{":
                open_joints.append(len(self.names) - 1)
            elif words[0] == "}":
                open_joints.pop()
            elif words[0] == "OFFSET":
                self.offsets.append(np.array(words[1:], float))
            elif words[0] == "CHANNELS":
                self.channels += [("place" if word.endswith("position") else self.names[-1])
                                  + "." + word[0] for word in words[2:]]

    def _read_stride(self, rows, cycle):
        self.stand = rows[0].copy()
        stride = rows[cycle["begin"]:cycle["begin"] + SAMPLES + 1].copy()
        ahead = self.channels.index("place.Z")
        self.stride_length = stride[-1, ahead] - stride[0, ahead]
        stride[:, ahead] -= stride[0, ahead] + self.stride_length * np.linspace(0, 1, SAMPLES + 1)
        self.stand[ahead] = 0
        self.stand[self.channels.index("place.X")] = 0
        self._first = cycle["begin"] - cycle["begin_s"] * SAMPLES  # samples after the passing
        self._stride = stride[:SAMPLES] - self.stand

    def walking(self, phase):
        """Walking in place, as the difference from standing; phase in cycles."""
        at = (phase % 1) * SAMPLES - self._first
        below = np.floor(at).astype(int)
        share = (at - below)[:, None]
        return ((1 - share) * self._stride[below % SAMPLES]
                + share * self._stride[(below + 1) % SAMPLES])

    def column(self, channel):
        return self.channels.index(channel)

    def positions(self, rows):
        """World positions of all joints and end sites; (frames, points, 3)."""
        rotations, places, column = [], [], 3
        for name, parent, offset in zip(self.names, self.parents, self.offsets):
            turn = None
            if name:
                z, x, y = rows[:, column:column + 3].T
                turn = about(2, z) @ about(0, x) @ about(1, y)
                column += 3
            if parent < 0:
                places.append(rows[:, :3] + offset)
            else:
                places.append(places[parent] + rotations[parent] @ offset)
                turn = None if turn is None else rotations[parent] @ turn
            rotations.append(turn)
        return np.stack(places, 1)

    def write(self, path, rows, fps):
        with open(path, "w", encoding="ascii") as file:
            file.write("\n".join([*self.head, f"Frames: {len(rows)}", f"Frame Time: {1 / fps:.10f}"])
                       + "\n")
            np.savetxt(file, rows, "%.5f")
