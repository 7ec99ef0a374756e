#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the paper's figures 1 to 3; scripts/make-figures runs it.

Usage: make_figures.py OUTPUT DATA
"""

import os
import pathlib
import subprocess
import sys
import tempfile

import matplotlib.pyplot as plt

import stltsa

# Fig. 2 needs noise: the file's angles, unsmoothed, at 60 frames per second.
ROUGH = {"features": "euler", "smoothing": 0.0, "sample_rate": 60.0, "dimension": 1}


def synthetic(folder, *settings):
    path = pathlib.Path(folder) / "walk.bvh"
    subprocess.run([os.environ["STLTSA_WALKER"], "--output", path, *settings], check=True)
    return path


def save(axes, path):
    axes.figure.savefig(path, dpi=200, metadata={"Software": None})
    plt.close(axes.figure)
    print(path)


def draw(clip, rough, prefix):
    """Write the three figures of a clip; `rough` is the clip to denoise."""
    result = stltsa.decompose(clip)
    print(result)
    save(stltsa.plot.loop(result), f"{prefix}-loop.png")
    save(stltsa.plot.units(result), f"{prefix}-units.png")
    model = stltsa.fit(rough, **ROUGH)
    save(stltsa.plot.denoising(stltsa.denoise(model), fps=model.fps)[0], f"{prefix}-denoising.png")


def main(output, data):
    output, real = pathlib.Path(output), pathlib.Path(data) / "cmu" / "35_01.amc"
    output.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        clip = stltsa.read_clip(synthetic(folder))
        rough = stltsa.read_clip(synthetic(folder, "--noise", "3", "--stand", "0"))
    draw(clip, rough, output / "synthetic")
    if not real.exists():
        print(f"{real} is not there: no figures of a real walk")
        return
    clip = stltsa.read_clip(real)
    draw(clip, clip, output / "real")


if __name__ == "__main__":
    main(*sys.argv[1:])
