# SPDX-License-Identifier: BSD-3-Clause
"""Fits by another library: prints time and memory as one line of JSON.

    peer.py tapkee|scikit-learn FILE FRAMES FEATURES NEIGHBORS CHECK COORDS

It fits twice, like measure/programs/fit_frames.c: the first fit measures memory, the second one time. CHECK 0
turns off tapkee's check that the neighborhood graph is connected. If a library raises an exception,
the result is the time until then and the reason.
"""

import ctypes
import json
import re
import sys
import time
from pathlib import Path

import numpy as np


def peak_memory():
    """Peak memory in bytes, as in measure/programs/memory.h; 0 if it is unknown."""
    try:
        found = re.search(r"VmHWM:\s*(\d+)", Path("/proc/self/status").read_text())
    except OSError:
        return 0
    return 1024 * int(found[1])


def keep_memory(size):
    """Reserves memory, as in measure/programs/memory.h."""
    mallopt = getattr(ctypes.CDLL(None), "mallopt", None)
    if mallopt:
        mallopt(-4, 0)  # M_MMAP_MAX
        mallopt(-1, -1)  # M_TRIM_THRESHOLD
        mallopt(-8, 1)  # M_ARENA_MAX
    needed = b"\1" * size
    del needed


def tapkee_fit(x, neighbors, check):
    import tapkee

    features_by_frames = np.asfortranarray(x.T)
    return lambda: tapkee.embed(features_by_frames, method="ltsa", neighbors_method="covertree",
                                eigen_method="arpack", num_neighbors=neighbors,
                                target_dimension=2, check_connectivity=check)


def sklearn_fit(x, neighbors, _):
    from sklearn.manifold import LocallyLinearEmbedding

    ltsa = LocallyLinearEmbedding(method="ltsa", eigen_solver="arpack", n_neighbors=neighbors,
                                  n_components=2, random_state=0)
    return lambda: ltsa.fit_transform(x)


def timed(fit):
    """Returns the time, with a failure if there was one, and the coordinates."""
    result, coords = {}, None
    processor, begin = time.process_time(), time.perf_counter()
    try:
        coords = fit()
    except (ValueError, RuntimeError) as error:
        result["failed"] = re.sub(r"\s+", " ", str(error))
    return result | {"seconds": time.perf_counter() - begin,
                     "processor": time.process_time() - processor}, coords


def main(library, path, frames, features, neighbors, check, coords_path):
    rows, cols = int(frames), int(features)
    x = np.fromfile(path, count=rows * cols).reshape(rows, cols)
    prepare = {"tapkee": tapkee_fit, "scikit-learn": sklearn_fit}[library]
    fit = prepare(x, int(neighbors), check == "1")
    before = peak_memory()
    said, _ = timed(fit)
    memory = peak_memory() - before
    if "failed" not in said:
        keep_memory(memory + memory // 4)
        said, coords = timed(fit)
        if coords is not None:
            np.ascontiguousarray(coords).tofile(coords_path)
    print(json.dumps(said | {"memory": memory}))


if __name__ == "__main__":
    main(*sys.argv[1:])
