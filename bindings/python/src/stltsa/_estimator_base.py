# SPDX-License-Identifier: BSD-3-Clause
"""Base classes of the estimator: scikit-learn's own if it is installed.

Otherwise the few methods below replace them, so that the estimator can still fit and map.
"""

from __future__ import annotations

import inspect
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ._arrays import as_matrix, unmasked

if TYPE_CHECKING:
    from typing_extensions import Self


class OwnBase:
    """Parameters, their representation, and checks of arrays, as in scikit-learn."""

    def get_params(self, deep: bool = True) -> dict[str, Any]:  # noqa: ARG002
        """Return the parameters of the constructor.

        Parameters
        ----------
        deep : bool
            Has no effect: no parameter is an estimator.
        """
        names = list(inspect.signature(type(self).__init__).parameters)[1:]
        return {name: getattr(self, name) for name in names}

    def set_params(self, **params: object) -> Self:
        """Set parameters of the constructor, and return the estimator."""
        known = self.get_params()
        for name, value in params.items():
            if name not in known:
                raise ValueError(f"Invalid parameter {name!r}; valid ones are {list(known)}")
            setattr(self, name, value)
        return self

    def set_output(self, *, transform: str | None = None) -> Self:  # noqa: ARG002
        """Choose the container for the output of `transform`; needs scikit-learn."""
        raise ImportError("set_output needs scikit-learn")

    def get_feature_names_out(self, input_features: Any = None) -> npt.NDArray[Any]:  # noqa: ARG002
        """Return the names of the coordinates: stltsa0, stltsa1, ..."""
        count: int = self._n_features_out  # type: ignore[attr-defined]
        return np.array([f"stltsa{i}" for i in range(count)], dtype=object)

    def _check_fitted(self) -> None:
        if not hasattr(self, "embedding_"):
            raise AttributeError(f"this {type(self).__name__} is not fitted yet; call fit first")

    def _validated(self, X: Any, *, reset: bool) -> npt.NDArray[Any]:
        frames = as_matrix(X)
        if reset:
            self.n_features_in_ = frames.shape[1]
        elif frames.shape[1] != self.n_features_in_:
            raise ValueError(
                f"X has {frames.shape[1]} features, but {type(self).__name__} is expecting "
                f"{self.n_features_in_} features as input"
            )
        return frames

    def __repr__(self) -> str:
        values = ", ".join(f"{k}={v!r}" for k, v in self.get_params().items())
        return f"{type(self).__name__}({values})"


def _of_sklearn() -> type:
    """Return a base class with the methods of scikit-learn."""
    from sklearn import base
    from sklearn.utils import validation

    mixins: Any = (base.ClassNamePrefixFeaturesOutMixin, base.TransformerMixin)

    class SklearnBase(*mixins, base.BaseEstimator):  # type: ignore[misc]
        """scikit-learn's methods; NaN is left to the library, whose text gives its position."""

        def _check_fitted(self) -> None:
            validation.check_is_fitted(self)

        def _validated(self, X: Any, *, reset: bool) -> npt.NDArray[Any]:
            checks: dict[str, Any] = {"reset": reset, "dtype": [np.float64, np.float32]}
            if reset:
                checks["ensure_min_samples"] = 2
            X = unmasked(X)  # scikit-learn would read the masked values
            if hasattr(validation, "validate_data"):  # since 1.6
                checked = validation.validate_data(self, X, ensure_all_finite=False, **checks)
            else:
                checked = self._validate_data(X, force_all_finite=False, **checks)
            return as_matrix(checked)

    return SklearnBase


if TYPE_CHECKING:
    Base = OwnBase
else:
    try:
        Base = _of_sklearn()
    except ImportError:
        Base = OwnBase
