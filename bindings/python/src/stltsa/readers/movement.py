# SPDX-License-Identifier: BSD-3-Clause
"""Datasets of `movement` (xarray), which reads SLEAP, DeepLabCut, LightningPose, Anipose and NWB.

Such a dataset has `position` (time, space, keypoint, individual) and `confidence`, and the
attributes `fps` and `time_unit`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from ..clip import Clip
from . import bad, rate_of

if TYPE_CHECKING:
    from .._arrays import FloatArray

Dataset: TypeAlias = Any  # xarray.Dataset; xarray may be missing


def _dimension(dataset: Any, name: str) -> str | None:
    """Return the name of a dimension, which older versions write in the plural."""
    return next((d for d in (name, f"{name}s") if d in dataset.position.dims), None)


def _one(dataset: Any, individual: str | None) -> Any:
    dimension = _dimension(dataset, "individual")
    if dimension is None:
        return dataset
    names = [str(name) for name in dataset[dimension].values]
    if individual == "auto":
        individual = None
    if individual is None and len(names) > 1:
        raise ValueError(f"there are {len(names)} individuals: give individual=, one of {names}")
    if individual is not None and individual not in names:
        raise ValueError(f"individual is {individual!r}, and must be one of {names}")
    return dataset.isel({dimension: names.index(individual) if individual else 0})


def _numbers(dataset: Any, name: str, dimensions: tuple[str, ...]) -> FloatArray:
    """Return an array of the dataset with its dimensions in this order."""
    array = dataset[name]
    if set(array.dims) != set(dimensions):
        text = f"{name} has the dimensions {array.dims}, and must have {dimensions}"
        raise bad("the dataset", text)
    if array.dtype.kind not in "fiu":
        raise bad("the dataset", f"{name} holds {array.dtype}, and must hold real numbers")
    return np.asarray(array.transpose(*dimensions), dtype=np.float64)


def from_dataset(dataset: Any, individual: str | None = None, **options: Any) -> Clip:
    """Return the points of one individual as a clip; `options`: fps, min_confidence."""
    one = _one(dataset, individual)
    points = _dimension(one, "keypoint") or "keypoint"
    positions = _numbers(one, "position", ("time", points, "space"))
    if positions.shape[2] not in (2, 3) or not positions.size:
        shape = " x ".join(map(str, positions.shape))
        raise bad("the dataset", f"position is {shape}, and must be frames x keypoints x 2 or 3")
    confidence = None
    if "confidence" in one.data_vars:
        confidence = _numbers(one, "confidence", ("time", points))
        confidence = None if np.isnan(confidence).all() else np.nan_to_num(confidence)
    fps = options.pop("fps", None)
    if not fps and dataset.attrs.get("fps") is not None:
        fps = rate_of("the dataset", "fps", dataset.attrs["fps"])
    in_seconds = dataset.attrs.get("time_unit") == "seconds"
    times = _numbers(one, "time", ("time",)) if in_seconds and not fps else None
    if times is None and not fps:
        raise ValueError("the dataset has no frame rate: give fps=")
    names = [str(name) for name in one[points].values]
    return Clip.from_points(
        positions, fps, names=names, confidence=confidence, times=times, **options
    )
