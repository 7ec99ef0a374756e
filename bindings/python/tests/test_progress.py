# SPDX-License-Identifier: BSD-3-Clause
"""Progress is reported, and any exception raised meanwhile stops the call."""

import contextlib
import gc
import os
import signal
import threading
import time
import weakref

import numpy as np
import pytest

import stltsa


@pytest.fixture(scope="module")
def long_motion():
    """Frames that take at least a second to fit."""
    t = np.arange(40000) / 100
    return np.column_stack([np.sin(f * t + f) for f in range(1, 40)])


def test_stages_are_named_and_fractions_rise(circle):
    seen = []
    stltsa.fit(circle, neighbors=100, progress=lambda *report: seen.append(report))
    assert {"tangents", "alignment", "spectrum"} <= {stage for stage, _ in seen}
    assert all(0 <= fraction <= 1 for _, fraction in seen)
    stltsa.fit(circle, mode="spatial", neighbors=20, progress=lambda *report: seen.append(report))
    assert "neighbors" in {stage for stage, _ in seen}


def test_exception_in_the_callback_comes_out(circle):
    def stop(stage, fraction):
        raise LookupError(f"enough of {stage}")

    with pytest.raises(LookupError, match="enough of"):
        stltsa.fit(circle, neighbors=100, progress=stop)
    assert stltsa.fit(circle, neighbors=100).coords.shape == (300, 2)


def test_finding_comparing_and_saving_can_be_stopped(walker, tmp_path):
    def stop(stage, fraction):
        raise LookupError(f"enough of {stage}")

    clip = stltsa.read_clip(walker)
    phase = stltsa.decompose(clip).phase()
    with pytest.raises(LookupError, match="enough of units"):
        phase.events(250, progress=stop)
    with pytest.raises(LookupError, match="enough of units"):
        phase.events_like([stltsa.FileEvent("Foot Strike", "Left", 300, 2.5)], progress=stop)
    with pytest.raises(LookupError, match="enough of units"):
        phase.compare(phase, progress=stop)
    reported = []
    watched = stltsa.decompose(clip, progress=lambda stage, _: reported.append(stage))
    reported.clear()
    watched.compare(watched)
    assert reported[-1] == "units"
    with pytest.raises(LookupError, match="enough of write"):
        clip.save(tmp_path / "clip.csv", progress=stop)
    assert not list(tmp_path.iterdir())
    stages = []
    clip.save(tmp_path / "clip.csv", progress=lambda *report: stages.append(report))
    assert stages == [("write", 0), ("write", 0)]


def test_what_the_callback_returns_is_no_matter(circle):
    expected = stltsa.fit(circle, neighbors=100).coords
    for answer in (True, 1, "stop", 2**80, NotImplemented):
        model = stltsa.fit(circle, neighbors=100, progress=lambda *_, answer=answer: answer)
        assert np.array_equal(model.coords, expected)


class Told:
    """A callback that supports weak references."""

    def __init__(self, error=None):
        self.error = error

    def __call__(self, stage, fraction):
        if self.error:
            raise self.error


@pytest.fixture
def no_collector():
    """Only unreferenced objects are freed: a reference cycle would stay."""
    gc.collect()
    gc.disable()
    yield
    gc.enable()


@pytest.mark.usefixtures("no_collector")
@pytest.mark.parametrize("error", [None, LookupError])
def test_nothing_is_kept_after_the_call(circle, error):
    class Frames(np.ndarray):
        pass

    frames, callback = circle.copy().view(Frames), Told(error)
    watched = weakref.ref(frames), weakref.ref(callback)
    with pytest.raises(error) if error else contextlib.nullcontext():
        stltsa.fit(frames, neighbors=100, progress=callback)
    del frames, callback
    assert [reference() for reference in watched] == [None, None]


def test_calls_may_nest(circle):
    inner = []

    def fit_again(stage, fraction):
        if not inner:
            inner.append(None)
            inner.append(stltsa.fit(circle[:100], neighbors=20, progress=lambda s, f: None))

    outer = stltsa.fit(circle, neighbors=100, progress=fit_again)
    assert len(inner[1]) == 100
    assert len(outer) == 300


@pytest.fixture
def heeded_interrupts():
    """Python handles Ctrl-C unless it was started with it ignored, as shells start jobs with
    "&"."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.usefixtures("heeded_interrupts")
def test_ctrl_c(long_motion):
    timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    start = time.process_time()  # what other processes use does not count
    with pytest.raises(KeyboardInterrupt):
        stltsa.fit(long_motion, neighbors=400, threads=1)
    assert time.process_time() - start < 2
    timer.join()


def test_other_threads_run_meanwhile(long_motion):
    """A thread counts while another one fits, so the fit does not hold the interpreter's lock."""
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
