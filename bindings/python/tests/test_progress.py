# SPDX-License-Identifier: BSD-3-Clause
"""Progress is reported, and whatever is raised meanwhile stops the call."""

import os
import signal
import threading
import time

import numpy as np
import pytest

import stltsa


@pytest.fixture(scope="module")
def long_motion():
    """Frames that take a second or more to fit."""
    t = np.arange(40000) / 100
    return np.column_stack([np.sin(f * t + f) for f in range(1, 40)])


def test_stages_are_named_and_fractions_rise(circle):
    seen = []
    stltsa.fit(circle, neighbors=100, progress=lambda *report: seen.append(report))
    assert {"neighbors", "tangents", "spectrum"} <= {stage for stage, _ in seen}
    assert all(0 <= fraction <= 1 for _, fraction in seen)


def test_exception_in_the_callback_comes_out(circle):
    def stop(stage, fraction):
        raise LookupError(f"enough of {stage}")

    with pytest.raises(LookupError, match="enough of"):
        stltsa.fit(circle, neighbors=100, progress=stop)
    assert stltsa.fit(circle, neighbors=100).coords.shape == (300, 2)


def test_calls_may_nest(circle):
    inner = []

    def fit_again(stage, fraction):
        if not inner:
            inner.append(None)
            inner.append(stltsa.fit(circle[:100], neighbors=20, progress=lambda s, f: None))

    outer = stltsa.fit(circle, neighbors=100, progress=fit_again)
    assert len(inner[1]) == 100
    assert len(outer) == 300


def test_ctrl_c(long_motion):
    timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        stltsa.fit(long_motion, neighbors=400, threads=1)
    assert time.monotonic() - start < 2
    timer.join()


def test_other_threads_run_meanwhile(long_motion):
    """A thread counts while another fits; it could not if the fit held the interpreter's lock."""
    done, counts = threading.Event(), []

    def count():
        while not done.is_set():
            counts.append(time.monotonic())
            time.sleep(0.005)

    thread = threading.Thread(target=count)
    thread.start()
    start = time.monotonic()
    stltsa.fit(long_motion[:10000], neighbors=200, threads=1)
    took = time.monotonic() - start
    done.set()
    thread.join()
    assert np.diff(counts).max(initial=0) < 0.5 * took
    assert len(counts) > 0.2 * took / 0.005


def test_bar(circle, capsys):
    pytest.importorskip("tqdm")
    stltsa.fit(circle, neighbors=100, progress=True)
    assert "%|" in capsys.readouterr().err
