#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the Matplotlib figures of docs/figures.md; scripts/make-figures runs it.

Usage: make_figures.py OUTPUT DATA CLIPS

CLIPS: the folder that contains walk.bvh and noisy.bvh.
"""

import pathlib
import sys

import matplotlib.pyplot as plt

import stltsa

# Fig. 2 needs noise: the file's angles, unsmoothed, at 60 frames per second.
ROUGH = {"features": "euler", "smoothing": 0.0, "sample_rate": 60.0, "dimension": 1}


def save(axes, path):
    axes.figure.savefig(path, dpi=200, metadata={"Software": None})
    plt.close(axes.figure)
    print(path)


def draw(clip, rough, prefix):
    """Write the figures of a clip; `rough` is the clip to denoise."""
    result = stltsa.decompose(clip)
    print(result)
    save(stltsa.plot.loop(result), f"{prefix}-loop.png")
    save(stltsa.plot.units(result), f"{prefix}-units.png")
    save(stltsa.plot.cycles(result), f"{prefix}-cycles.png")
    save(stltsa.plot.cycle_times(result), f"{prefix}-cycle-times.png")
    done = stltsa.denoise(stltsa.fit(rough, **ROUGH))
    save(stltsa.plot.denoising(done)[0], f"{prefix}-denoising.png")


def main(output, data, clips):
    output, clips = pathlib.Path(output), pathlib.Path(clips)
    draw(clips / "walk.bvh", clips / "noisy.bvh", output / "synthetic")
    real = pathlib.Path(data) / "cmu" / "35_01.amc"
    if not real.exists():
        print(f"{real} is not there: no figures of a real walk")
        return
    draw(real, real, output / "real")


if __name__ == "__main__":
    main(*sys.argv[1:])
