# SPDX-License-Identifier: BSD-3-Clause
"""Many clips: one result each, and a summary; the files of the command ``stltsa batch``."""

from __future__ import annotations

import csv
import io
import json
import math
import os
import zlib
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from ._exports import write_text
from ._native import lib
from ._options import option_named
from ._progress import reporter
from ._tables import table
from ._text import string
from .decomposition import decompose
from .errors import StltsaError
from .readers import READERS, extra

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

    from pandas import DataFrame
    from typing_extensions import Unpack

    from ._options import Options

_SUFFIXES = (".bvh", ".amc", ".csv", ".tsv", ".npy", *READERS)


class BatchRow(NamedTuple):
    """One clip of a batch: numbers are NaN, and counts 0, if it failed.

    `status` is ``"done"`` or the name of the failure; `message` the error, or why nothing repeats;
    `kept` tells that the result is of an earlier run.
    """

    clip: str
    status: str
    frames: int
    fps: float
    duration_s: float
    segments: int
    cycles: int
    repetitions: int
    period_s: float
    confidence: float
    message: str
    kept: bool


def batch(
    paths: str | os.PathLike[str] | Iterable[str | os.PathLike[str]],
    out: str | os.PathLike[str],
    *,
    workers: int = 1,
    client: Any = None,
    shard: tuple[int, int] = (1, 1),
    **options: Unpack[Options],
) -> DataFrame:
    """Decompose many clips into a folder: a JSON file for each, and ``summary.csv``.

    The files have the same bytes for any number of workers. A run that was stopped goes on where
    it was: a result is kept if the content of the clip, the options and the library's version are
    the same. A clip that fails is a row with its error.

    Parameters
    ----------
    paths : path or paths
        Clips, and folders of clips, which are searched for files of readable formats.
    out : path
        The folder of the results.
    workers : int
        Processes; more than 1 need joblib.
    client : dask.distributed.Client, optional
        Runs the clips on a cluster, whose workers see the same files, in place of `workers`.
    shard : (int, int)
        ``(i, n)``: every n-th clip from the i-th on, counted from 1; the summary is
        ``summary-i-n.csv``.
    **options
        As for :func:`stltsa.decompose`.

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
    index, count = shard
    if not 1 <= index <= count:
        raise ValueError(f"shard is {shard!r}, and must be (i, n) with 1 <= i <= n")
    chosen = list(_clips(paths))[index - 1 :: count]
    report = reporter(options.pop("progress", None))
    jobs = [(path, name, str(Path(out)), dict(options)) for path, name in chosen]
    rows = []
    try:
        for row in _run(jobs, workers, client):
            rows.append(row)
            report.report("clips", len(rows) / len(jobs))
    finally:
        report.close()
    name = "summary.csv" if count == 1 else f"summary-{index}-{count}.csv"
    Path(out).mkdir(parents=True, exist_ok=True)
    write_text(Path(out) / name, _summary(rows))
    return table(rows, BatchRow)


def _run(jobs: list[tuple[Any, ...]], workers: int, client: Any) -> Iterator[BatchRow]:
    if client is not None:
        futures = client.map(_one, *zip(*jobs, strict=True), pure=False) if jobs else []
        return iter(client.gather(futures))
    if workers == 1:
        return (_one(*job) for job in jobs)
    joblib = extra("joblib", "batch")
    parallel = joblib.Parallel(n_jobs=workers, return_as="generator")
    return iter(parallel(joblib.delayed(_one)(*job) for job in jobs))


def _clips(paths: Any) -> Iterator[tuple[str, str]]:
    """Return path and name of each clip, by name; the name is relative to the folder given."""
    found: dict[str, str] = {}
    for path in [paths] if isinstance(paths, str | os.PathLike) else paths:
        given = Path(path)
        files = sorted(given.rglob("*")) if given.is_dir() else [given]
        for file in files:
            name = file.name if file == given else file.relative_to(given).as_posix()
            if file != given and (file.suffix.lower() not in _SUFFIXES or not file.is_file()):
                continue
            if name in found:
                raise ValueError(
                    f"{found[name]} and {file} would have the same result, {name}.json: give "
                    "their common folder"
                )
            found[name] = str(file)
    if not found:
        raise ValueError(f"there are no {', '.join(_SUFFIXES)} files")
    return ((found[name], name) for name in sorted(found))


def _one(path: str, name: str, out: str, options: Mapping[str, Any]) -> BatchRow:
    """Decompose one clip unless its result is there; the processes of `workers` call this."""
    place = Path(out) / f"{name}.json"
    try:
        end = f',"batch":{_origin(path, options)}}}\n'
        before = place.read_text(encoding="utf-8") if place.exists() else ""
        if before.endswith(end):
            return _row(name, json.loads(before), kept=True)
        used: Any = {**options, "threads": 1}
        text = decompose(path, **used).to_json()
        place.parent.mkdir(parents=True, exist_ok=True)
        write_text(place, text[:-1] + end)
        return _row(name, json.loads(text), kept=False)
    except StltsaError as error:
        return _failed(name, error.name, error)
    except (OSError, ImportError, ValueError, TypeError) as error:
        status = "STLTSA_E_IO" if isinstance(error, OSError) else type(error).__name__
        return _failed(name, status, error)


def _origin(path: str, options: Mapping[str, Any]) -> str:
    """Return what the result depends on, as the command writes it."""
    file = path if Path(path).exists() else path.rpartition(":")[0]
    content = Path(file).read_bytes()
    skeleton = options.get("skeleton")
    beside = [Path(skeleton)] if skeleton else []
    if not skeleton and file.lower().endswith(".amc"):
        beside = sorted(p for p in Path(file).parent.iterdir() if p.suffix.lower() == ".asf")
    for other in beside:
        content += other.read_bytes()
    named = sorted((option_named(n).key, n, v) for n, v in options.items() if n != "threads")
    origin = {
        "bytes": len(content),
        "crc32": f"{zlib.crc32(content):08x}",
        "options": {name.replace("_", "-"): _typed(value) for _, name, value in named},
        "library": string(lib.stltsa_version()),
    }
    return json.dumps(origin, separators=(",", ":"), ensure_ascii=False)


def _typed(value: Any) -> str:
    """Return a value as it would be typed in the command."""
    if isinstance(value, bool):
        return str(int(value))
    if isinstance(value, float) and value.is_integer():
        return str(int(value))
    return str(value)


def _number(value: Any) -> float:
    return float("nan") if value is None else float(value)


def _row(name: str, result: Any, *, kept: bool) -> BatchRow:
    clip, segments = result["clip"], result["segments"]
    moving = [s for s in segments if s["kind"] != "rest"]
    longest = max(moving, key=lambda s: s["end_s"] - s["begin_s"], default={"confidence": None})
    return BatchRow(
        clip=name,
        status="done",
        frames=clip["frames"],
        fps=_number(clip["fps"]),
        duration_s=_number(clip["duration_s"]),
        segments=len(segments),
        cycles=len(result["cycles"]),
        repetitions=len(result["repetitions"]),
        period_s=_number(result["period_s"]),
        confidence=_number(longest["confidence"]),
        message=result["reason"] or "",
        kept=kept,
    )


def _failed(name: str, status: str, error: Exception) -> BatchRow:
    nan = float("nan")
    return BatchRow(name, status, 0, nan, nan, 0, 0, 0, nan, nan, str(error), kept=False)


def _cells(row: BatchRow) -> list[str]:
    """Return the row as the command writes it: without `kept`, and without unknown numbers."""
    if row.status != "done":
        return [row.clip, row.status, *[""] * (len(row) - 4), row.message]
    unknown = [isinstance(value, float) and math.isnan(value) for value in row]
    return ["" if nan else _typed(value) for nan, value in zip(unknown, row[:-1], strict=False)]


def _summary(rows: list[BatchRow]) -> str:
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(BatchRow._fields[:-1])
    writer.writerows(map(_cells, rows))
    return out.getvalue()
