# SPDX-License-Identifier: BSD-3-Clause
"""Kernel change-point detection of ruptures, given the number of borders."""

import importlib.util

import numpy as np

from .score import matches

RATE = 10  # frames per second, as is usual for behaviors


def installed():
    return importlib.util.find_spec("ruptures") is not None


def borders(recording, rows, count=None):
    """Its borders as pairs of equal seconds, so many or by a penalty of log n; without ruptures an
    ImportError."""
    import ruptures
    step = max(1, round(recording.fps / RATE))
    signal = rows[::step] - rows.mean(axis=0)
    signal = signal[:, np.ptp(signal, axis=0) > 0]
    fitted = ruptures.KernelCPD(kernel="rbf", min_size=RATE).fit(signal)
    found = fitted.predict(n_bkps=count) if count else fitted.predict(pen=np.log(len(signal)))
    return [(at * step / recording.fps,) * 2 for at in found[:-1]]


def f1(recording, rows, tolerance, count=None):
    true, found = recording.borders(), borders(recording, rows, count)
    right = sum(i is not None for i in matches(true, found, tolerance))
    return 2 * right / (len(true) + len(found))
