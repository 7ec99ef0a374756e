# SPDX-License-Identifier: BSD-3-Clause
"""Many clips: the library's batch, in threads of this process or on the workers of a cluster."""

from __future__ import annotations

import csv
import io
import os
import threading
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

from ._call import Call, check, owned
from ._native import ffi, lib
from ._progress import reporter
from ._tables import table
from ._text import c_path, csv_text
from .clip import read_clip
from .errors import FormatError, StltsaError
from .readers import READERS

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping

    from pandas import DataFrame
    from typing_extensions import Unpack

    from ._options import Options

# Frames per second for texts in seconds: decompose has no lengths in frames.
_ANY_RATE = 100.0


class BatchRow(NamedTuple):
    """One clip of a batch: numbers are NaN, and counts 0, if it failed.

    `status` is ``"done"`` or the name of the failure, and `error` its text; `confidence` is that of
    the longest segment in motion; `reason` says why nothing repeats; `kept` tells whether the
    result is from an earlier run.
    """

    path: str
    status: str
    error: str
    frames: int
    segments: int
    cycles: int
    repetitions: int
    period_s: float
    fps: float
    duration_s: float
    confidence: float
    reason: str
    kept: bool


def batch(
    paths: str | os.PathLike[str] | Iterable[str | os.PathLike[str]],
    out: str | os.PathLike[str],
    *,
    jobs: int = 1,
    client: Any = None,
    shard: tuple[int, int] | str | None = None,
    **options: Unpack[Options],
) -> DataFrame:
    """Decompose many clips into a folder: a JSON file for each, and ``summary.csv``.

    The result of ``a/b.bvh`` is ``a__b.bvh.json``. The files have the same bytes for any number of
    jobs. If a run was stopped, the next one goes on from there: a result is kept if it is
    undamaged, and the content of the clip, the options and the library's version are the same. If a
    clip fails, or its result is that of another clip, its row has the error.

    Parameters
    ----------
    paths : path or paths
        Clips, and folders of clips, which are searched for files of readable formats.
    out : path
        The folder of the results.
    jobs : int
        Clips at the same time, each in a thread of its own.
    client : dask.distributed.Client, optional
        Runs the clips on a cluster, whose workers see the same files, in place of `jobs`.
    shard : (int, int) or str, optional
        ``(i, n)`` or ``"i/n"``: every n-th clip from the i-th on, counted from 1; the summary is
        ``summary-i-n.csv``.
    **options
        As for :func:`stltsa.decompose`; `fps` is for clips that cannot be read without it, or have
        no rate.

    Returns
    -------
    DataFrame
        A row for each clip (a NumPy record array without pandas): see :class:`BatchRow`.

    Examples
    --------
    >>> import stltsa
    >>> rows = stltsa.batch(["walker.bvh"], "results")
    >>> list(rows["status"])
    ['done']
    """
    report = reporter(options.pop("progress", None))
    given = [paths] if isinstance(paths, str | os.PathLike) else list(paths)
    part = "/".join(map(str, shard)) if isinstance(shard, tuple) else shard
    plan = _plan(given, out, part, options)
    clips: list[str] = []
    while path := lib.stltsa_batch_path(plan, len(clips)):
        clips.append(os.fsdecode(ffi.string(path)))
    one = partial(_one, out=os.fspath(out), options=dict(options))
    try:
        if client is not None:
            done = client.gather(client.map(one, clips, pure=False)) if clips else []
        else:
            done = _in_threads(one, clips, jobs, report.report)
    finally:
        report.close()
    rows = [ffi.new("char[]", row) for row, _ in done]
    check(lib.stltsa_batch_finish(plan, ffi.new("char *[]", rows), len(rows), ffi.NULL))
    found = [_row(clip, row, kept=k) for clip, (row, k) in zip(clips, done, strict=True)]
    return table(found, BatchRow)


def _plan(paths: Any, out: Any, shard: str | None, options: Mapping[str, Any]) -> Any:
    names = [ffi.new("char[]", c_path(path)) for path in paths]
    part = ffi.NULL if shard is None else shard.encode()
    made = ffi.new("stltsa_batch **")
    with Call(options, rate=_ANY_RATE) as call:
        listed = ffi.new("char *[]", names)
        call.check(lib.stltsa_batch_new(listed, len(names), c_path(out), part, call.options, made))
    return owned("batch", made)


def _in_threads(
    one: Callable[..., Any], clips: list[str], jobs: int, tell: Callable[[str, float], None]
) -> list[tuple[bytes, bool]]:
    """Return what became of each clip; after Ctrl-C or an exception of `tell`, end at once."""
    stopped = threading.Event()

    def stop_if_asked(_stage: str, _fraction: float) -> None:
        if stopped.is_set():
            raise KeyboardInterrupt

    done = []
    with ThreadPoolExecutor(jobs) as pool:
        futures = [pool.submit(one, clip, progress=stop_if_asked) for clip in clips]
        try:
            for future in futures:
                done.append(future.result())
                tell("clips", len(done) / len(clips))
        except BaseException:
            stopped.set()
            pool.shutdown(cancel_futures=True)
            raise
    return done


def _one(path: str, out: str, options: Mapping[str, Any], progress: Any = None) -> Any:
    """Return the row of one clip and whether its result was kept; workers of a cluster call it."""
    plan = _plan([path], out, None, options)
    row, kept, good = _run(plan, ffi.NULL, progress)
    if not good and any(suffix in path.lower() for suffix in READERS):
        try:
            row, kept, good = _run(plan, _read(path, options)._handle, progress)
        except (StltsaError, ImportError, OSError, ValueError, TypeError) as error:
            name = error.name if isinstance(error, StltsaError) else type(error).__name__
            cells = [path, name, str(error), *[""] * (len(BatchRow._fields) - 4)]
            row = os.fsencode(csv_text(cells, []))
    return row, kept


def _run(plan: Any, clip: Any, progress: Any) -> tuple[bytes, bool, bool]:
    """Return the row, whether the result was kept, and whether there is one."""
    row, kept = ffi.new("char **"), ffi.new("int32_t *")
    with Call({"progress": progress}) as call:
        status = lib.stltsa_batch_run(plan, 0, clip, call.options, kept, row)
        if not row[0]:
            call.check(status)
    owner = ffi.gc(row[0], lib.stltsa_free)
    return ffi.string(owner), bool(kept[0]), status == lib.STLTSA_OK


def _read(path: str, options: Mapping[str, Any]) -> Any:
    """Return a clip that the library cannot open; `fps` is for those that have no rate."""
    try:
        return read_clip(path)
    except FormatError:
        if options.get("fps") in (None, "auto"):
            raise
        return read_clip(path, fps=options["fps"])


def _row(path: str, line: bytes, *, kept: bool) -> BatchRow:
    (cells,) = csv.reader(io.StringIO(os.fsdecode(line), newline=""))
    _, status, error, *numbers, reason = cells
    counts = [int(number or 0) for number in numbers[:4]]
    reals = [float(number or "nan") for number in numbers[4:]]
    return BatchRow._make([path, status, error, *counts, *reals, reason, kept])
