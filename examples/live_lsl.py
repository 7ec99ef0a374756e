#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Replays a clip over the Lab Streaming Layer, and prints the phase of what arrives.

    pip install stltsa pylsl
    python3 live_lsl.py walk.bvh [SPEED]

One thread sends the features of the clip, frame by frame, SPEED times as fast as they were recorded
(default: 1). The main thread knows only the model and the stream: it reads samples with their time
stamps, and prints every tenth answer, and the mark "middle" when it passes.
"""

import sys
import threading
import time

import stltsa

try:
    import pylsl
except ImportError:
    sys.exit("live_lsl.py needs pylsl: pip install pylsl")
except RuntimeError as error:  # pylsl is there, but not the library of the Lab Streaming Layer
    sys.exit(f"live_lsl.py: {error}")


def send(frames, fps, speed, ready):
    """Play the frames to a new stream as soon as somebody listens."""
    info = pylsl.StreamInfo("walk", "MoCap", frames.shape[1], fps, "double64", "stltsa-live-lsl")
    outlet = pylsl.StreamOutlet(info)
    ready.set()
    outlet.wait_for_consumers(10)
    start = pylsl.local_clock()
    for i, row in enumerate(frames):
        outlet.push_sample(row, start + i / fps)
        time.sleep(1 / fps / speed)
    time.sleep(1)  # the last samples are on their way


def main():
    """Learn the clip, replay it, follow it."""
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    speed = float(sys.argv[2]) if len(sys.argv) == 3 else 1.0
    result = stltsa.decompose(sys.argv[1])
    clip = result.clip
    model = stltsa.fit(clip)
    cycle = result.best_cycle
    if cycle is None:
        sys.exit(f"{sys.argv[1]}: no cycle: {result.reason}")
    model.keep_cycle(result.phase(), {"middle": (cycle.begin + cycle.end) / 2})

    ready = threading.Event()
    arguments = (clip.features(), clip.fps, speed, ready)
    threading.Thread(target=send, args=arguments, daemon=True).start()
    ready.wait()
    streams = pylsl.resolve_byprop("source_id", "stltsa-live-lsl", timeout=10)
    if not streams:
        sys.exit("the stream was not found: does the network allow multicast?")
    inlet = pylsl.StreamInlet(streams[0])
    live = stltsa.Live(model)
    for number in range(len(clip)):
        sample, stamp = inlet.pull_sample(timeout=5)
        if sample is None:
            sys.exit(f"no sample after {number} of {len(clip)}")
        now = live.push(sample, stamp)
        if number % 10 == 0 or now.events:
            print(
                f"{number:5d}  {now.kind:7s} phase {now.phase:.3f}  {now.rate_hz:.2f} Hz  "
                f"{now.cycles:5.2f} cycles  {' '.join(now.events)}"
            )


if __name__ == "__main__":
    main()
