# SPDX-License-Identifier: BSD-3-Clause
"""Many clips: one result each, and a summary; the files of the command ``stltsa batch``."""

from __future__ import annotations

import json
import math
import operator
import os
import re
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

from ._batch_files import check_place, kept, origin_of, typed, with_origin
from ._call import Call
from ._exports import write_text
from ._options import option_named
from ._progress import reporter
from ._tables import table
from ._text import csv_text
from .clip import read_clip
from .decomposition import decompose
from .errors import StltsaError
from .readers import READERS, extra

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

    from pandas import DataFrame
    from typing_extensions import Unpack

    from ._options import Options

# Tables of BIDS datasets that describe recordings.
_DESCRIPTIONS = (
    "_channels.tsv",
    "_events.tsv",
    "_scans.tsv",
    "_sessions.tsv",
    "_participants.tsv",
)
_SUFFIXES = (
    *(".bvh", ".amc", ".csv", ".tsv", ".npy", ".c3d", ".trc", ".mot", ".sto"),
    *READERS,
)
# Frames per second that convert lengths in seconds into frames.
_ANY_RATE = 100.0
_SUMMARY = re.compile(r"summary[-0-9]*\.csv")


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


class Client(Protocol):
    """What a batch asks of a ``dask.distributed.Client``."""

    def map(self, func: Any, *iterables: Any, pure: bool) -> Any:
        """Run the function for each item."""

    def gather(self, futures: Any) -> Any:
        """Return the results."""


def _shard(shard: Any) -> tuple[int, int]:
    try:
        given = map(int, shard.split("/")) if isinstance(shard, str) else map(operator.index, shard)
        index, count = given
    except (TypeError, ValueError):
        index, count = 0, 0
    if not 1 <= index <= count:
        raise ValueError(f"shard is {shard!r}, and must be (i, n) or 'i/n' with 1 <= i <= n")
    return index, count


def batch(
    paths: str | os.PathLike[str] | Iterable[str | os.PathLike[str]],
    out: str | os.PathLike[str],
    *,
    jobs: int = 1,
    client: Client | None = None,
    shard: tuple[int, int] | str = (1, 1),
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
        The folder of the results. It is not searched for clips unless it is among `paths`, and then
        without its summaries.
    jobs : int
        Clips at the same time, each in a process of its own; more than one needs joblib.
    client : dask.distributed.Client, optional
        Runs the clips on a cluster, whose workers see the same files, in place of `jobs`.
    shard : (int, int) or str
        ``(i, n)`` or ``"i/n"``: every n-th clip from the i-th on, counted from 1; the summary is
        ``summary-i-n.csv``.
    **options
        As for :func:`stltsa.decompose`; `fps` is for clips whose files have no rate.

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
    index, count = _shard(shard)
    chosen = list(_clips(paths, Path(out).resolve()))[index - 1 :: count]
    report = reporter(options.pop("progress", None))
    _check(options)
    work = [(path, str(Path(out) / result), dict(options)) for path, result in chosen]
    name = "summary.csv" if count == 1 else f"summary-{index}-{count}.csv"
    Path(out).mkdir(parents=True, exist_ok=True)
    tempfile.TemporaryFile(dir=out).close()  # if nothing can be written, each clip would fail
    rows = []
    try:
        for row in _run(work, jobs, client):
            rows.append(row)
            report.report("clips", len(rows) / len(work))
    finally:
        report.close()
    write_text(Path(out) / name, _summary(rows))
    return table(rows, BatchRow)


def _check(options: Mapping[str, Any]) -> None:
    """Raise if an option is invalid, once and not for each clip."""
    for name in options:
        option_named(name)
    with Call(options, rate=_ANY_RATE):
        pass


def _run(work: list[tuple[Any, ...]], jobs: int, client: Client | None) -> Iterator[BatchRow]:
    if client is not None:
        futures = client.map(_one, *zip(*work, strict=True), pure=False) if work else []
        return iter(client.gather(futures))
    if jobs == 1:
        return (_one(*each) for each in work)
    joblib = extra("joblib", "batch")
    parallel = joblib.Parallel(n_jobs=jobs, return_as="generator")
    return iter(parallel(joblib.delayed(_one)(*each) for each in work))


def _clips(paths: Any, out: Path) -> Iterator[tuple[str, str]]:
    """Return the path of each clip and the file name of its result, sorted by path."""
    found: set[str] = set()
    for path in [paths] if isinstance(paths, str | os.PathLike) else paths:
        given = Path(path)
        if str(given) == "-":
            raise ValueError("batch takes files and folders, not standard input")
        found.update(_in_given_folder(given, out) if given.is_dir() else [str(given)])
    if not found:
        raise ValueError(f"there are no {', '.join(_SUFFIXES)} files")
    taken: dict[str, str] = {}
    for path in sorted(found):
        name = _result_name(path)
        if name in taken:
            raise ValueError(
                f"{taken[name]} and {path} would have the same result, {name}: decompose them into "
                "two folders"
            )
        taken[name] = path
    return ((path, name) for name, path in taken.items())


def _in_given_folder(folder: Path, out: Path) -> Iterator[str]:
    """Return the clips below a folder, of which the summaries of earlier runs are none.

    The folder of results is left out, or if it is the given one, only its summaries are.
    """
    if folder.resolve() != out:
        return _in_folder(folder, {out})
    summaries = {str(p) for p in folder.glob("summary*.csv") if _SUMMARY.fullmatch(p.name)}
    return (path for path in _in_folder(folder, set()) if path not in summaries)


def _in_folder(folder: Path, seen: set[Path]) -> Iterator[str]:
    """Return the clips below a folder. Links are followed, but each folder is visited once."""
    real = folder.resolve()
    if real in seen:
        return
    seen.add(real)
    try:
        entries = sorted(folder.iterdir())
    except OSError:  # what cannot be listed is left out
        return
    for entry in entries:
        if entry.is_dir():
            yield from _in_folder(entry, seen)
        elif f"_{entry.name}".lower().endswith(_DESCRIPTIONS):
            continue
        elif entry.suffix.lower() in _SUFFIXES and entry.is_file():
            yield str(entry)


def _result_name(path: str) -> str:
    """Return the path with ``__`` for ``/``, without leading dots, which would hide the file."""
    while path.startswith("../"):
        path = path[3:]
    return path.replace("/", "__") + ".json"


def _one(path: str, result: str, options: Mapping[str, Any]) -> BatchRow:
    """Decompose one clip unless its result is there; the processes of `jobs` call this."""
    place = Path(result)
    try:
        check_place(path, place)
        origin = origin_of(path, place.parent, options)
        before = kept(place, origin)
        if before is not None:
            return _row(path, before, is_kept=True)
        text = _decomposed(path, {**options, "threads": 1})
        write_text(place, with_origin(text[:-1], origin))
        return _row(path, json.loads(text), is_kept=False)
    except StltsaError as error:
        return _failed(path, error.name, error)
    except OSError as error:
        return _failed(path, "STLTSA_E_IO", f"{error.filename or path}: {error.strerror}")
    except (ImportError, ValueError, TypeError) as error:
        return _failed(path, type(error).__name__, error)


def _decomposed(path: str, options: dict[str, Any]) -> str:
    """Return the JSON of a decomposition; `fps` is for files that have no rate."""
    fps = options.pop("fps", None)
    used = ("skeleton", "individual", "least_confidence")
    reading: Any = {k: v for k, v in options.items() if k in used}
    clip = read_clip(path, **reading)
    if fps not in (None, "auto") and not clip.fps:
        clip = read_clip(path, fps=fps, **reading)
    options.pop("individual", None)
    return decompose(clip, **options).to_json()


def _number(value: Any) -> float:
    return float("nan") if value is None else float(value)


def _row(path: str, result: Any, *, is_kept: bool) -> BatchRow:
    clip, segments = result["clip"], result["segments"]
    moving = [s for s in segments if s["kind"] != "rest"]
    longest = max(moving, key=lambda s: s["end_s"] - s["begin_s"], default={"confidence": None})
    return BatchRow(
        path=path,
        status="done",
        error="",
        frames=clip["frames"],
        segments=len(segments),
        cycles=len(result["cycles"]),
        repetitions=len(result["repetitions"]),
        period_s=_number(result["period_s"]),
        fps=_number(clip["fps"]),
        duration_s=_number(clip["duration_s"]),
        confidence=_number(longest["confidence"]),
        reason=result["reason"] or "",
        kept=is_kept,
    )


def _failed(path: str, status: str, error: object) -> BatchRow:
    nan = float("nan")
    return BatchRow(path, status, str(error), 0, 0, 0, 0, nan, nan, nan, nan, "", kept=False)


def _cells(row: BatchRow) -> list[Any]:
    """Return the row as the command writes it: without `kept`, and without unknown numbers."""
    if row.error:
        return [row.path, row.status, row.error, *[""] * (len(row) - 4)]

    def cell(value: Any) -> Any:
        if not isinstance(value, float):
            return value
        return "" if math.isnan(value) else typed(value)

    return [cell(value) for value in row[:-1]]


def _summary(rows: list[BatchRow]) -> str:
    return csv_text(BatchRow._fields[:-1], map(_cells, rows))
