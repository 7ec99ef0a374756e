# SPDX-License-Identifier: BSD-3-Clause
"""Objects that threads share. C calls run without the interpreter's lock."""

import threading
import time

import numpy as np
import pytest

import stltsa
from stltsa._native import lib


class Watched:
    """The library; notices if one frame is pushed while another is."""

    def __init__(self):
        self.inside = self.most = 0

    def __getattr__(self, name):
        return getattr(lib, name)

    def stltsa_live_push_frame(self, *arguments):
        self.inside += 1
        self.most = max(self.most, self.inside)
        time.sleep(0.005)  # as a wide frame
        status = lib.stltsa_live_push_frame(*arguments)
        self.inside -= 1
        return status


def test_threads_share_a_stream(clip, result, monkeypatch):
    """Pushes wait for each other."""
    model = stltsa.fit(clip)
    model.keep_cycle(result.phase())
    live, watched, answers = stltsa.Live(model), Watched(), []
    monkeypatch.setattr(stltsa.live, "lib", watched)

    def push(thread):
        for i in range(20):
            answers.append(live.push_frame(clip, 200 + 3 * i + thread))

    threads = [threading.Thread(target=push, args=(k,)) for k in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert (len(answers), watched.most) == (60, 1)
    assert all(0 <= answer.confidence <= 1.0001 for answer in answers)


def test_a_cycle_is_kept_while_the_model_is_used(clip, result):
    """The library forbids it of one handle, also within a progress function."""
    model = stltsa.fit(clip)
    before, phase, kept = model.to_bytes(), result.phase(), []

    def keep(*_):
        if not kept:
            handle = model._handle
            model.keep_cycle(phase, {"strike": 250})
            kept.append(model._handle != handle)

    mapped = model.map(clip, progress=keep)
    assert np.array_equal(mapped.values[model.frames], model.coords)
    assert kept == [True]
    assert stltsa.Live(model).marks == ("strike",)
    after = model.to_bytes()
    assert after != before
    with pytest.raises(stltsa.ArgumentError, match="lies in no cycle"):
        model.keep_cycle(phase, {"off": 300, "none": 2})
    assert model.to_bytes() == after
