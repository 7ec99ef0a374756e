# SPDX-License-Identifier: BSD-3-Clause
"""Datasets of `movement` (xarray), which reads SLEAP, DeepLabCut, LightningPose, Anipose and NWB.

Such a dataset has `position` (time, space, keypoint, individual) and `confidence`, and the
attributes `fps` and `time_unit`.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from ..clip import Clip

Dataset: TypeAlias = Any  # xarray.Dataset; xarray may be missing


def _dimension(dataset: Any, name: str) -> str | None:
    """Return the name of a dimension, which older versions write in the plural."""
    return next((d for d in (name, f"{name}s") if d in dataset.position.dims), None)


def _one(dataset: Any, individual: str | None) -> Any:
    dimension = _dimension(dataset, "individual")
    if dimension is None:
        return dataset
    names = [str(name) for name in dataset[dimension].values]
    if individual is None and len(names) > 1:
        raise ValueError(f"there are {len(names)} individuals: give individual=, one of {names}")
    if individual is not None and individual not in names:
        raise ValueError(f"individual is {individual!r}, and must be one of {names}")
    return dataset.isel({dimension: names.index(individual) if individual else 0})


def from_dataset(dataset: Any, individual: str | None = None, **options: Any) -> Clip:
    """Return the points of one individual as a clip; `options`: fps, least_confidence."""
    one = _one(dataset, individual)
    points = _dimension(one, "keypoint")
    if points is None:
        raise ValueError(f"position has the dimensions {one.position.dims}, and no keypoints")
    positions = np.asarray(one.position.transpose("time", points, "space"), dtype=np.float64)
    confidence = None
    if "confidence" in one.data_vars:
        confidence = np.asarray(one.confidence.transpose("time", points), dtype=np.float64)
        confidence = None if np.isnan(confidence).all() else np.nan_to_num(confidence)
    fps = options.pop("fps", None) or dataset.attrs.get("fps")
    in_seconds = dataset.attrs.get("time_unit") == "seconds"
    times = one.time.values if in_seconds and not fps else None
    if times is None and not fps:
        raise ValueError("the dataset has no frame rate: give fps=")
    names = [str(name) for name in one[points].values]
    return Clip.from_points(
        positions, fps, names=names, confidence=confidence, times=times, **options
    )
