# SPDX-License-Identifier: BSD-3-Clause
"""The estimator, with the conventions of scikit-learn."""

from __future__ import annotations

import warnings
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Literal

from ._clips import is_sequence_of_clips
from ._estimator_base import Base
from .clip import Clip
from .errors import NotFiniteError, QualityWarning
from .model import Model, fitted

if TYPE_CHECKING:
    from collections.abc import Iterator

    from ._arrays import FloatArray
    from ._given import Labels, Matrix, Motions
    from ._keywords import Auto, Mode, Seconds
    from ._progress import Progress


@contextmanager
def _in_the_words_of_sklearn() -> Iterator[None]:
    """Put "NaN or infinity", which scikit-learn's users look for, before the library's text."""
    try:
        yield
    except NotFiniteError as error:
        text = f"Input X contains NaN or infinity: {error}"
        raise NotFiniteError(text, error.status, error.name) from None


class STLTSA(Base):
    """Spatio-temporal local tangent space alignment: motion as a low-dimensional curve.

    Unlike in other scikit-learn transformers, the order of rows matters: it is time. Rows without
    order need ``neighbors="spatial", include_self=False``: scikit-learn's
    ``LocallyLinearEmbedding(method="ltsa")``, only faster.

    Parameters
    ----------
    n_neighbors : int, str such as "1.2s", or "auto", default="auto"
        Neighbors of each frame, including itself; a text is in seconds, and needs `fps`.
        ``"auto"``: 1.2 periods if a period is found, otherwise 1.2 seconds, or 12 frames if `fps`
        is not given. Without `fps` the period is looked for in frames, unless `neighbors` is
        ``"spatial"``. If there are few neighbors relative to a cycle, the first coordinate only
        follows time.
    n_components : int, default=2
        Number of coordinates.
    neighbors : {"temporal", "recurrent", "spatial"}, default="temporal"
        Candidates for neighbors: frames within the window; frames within the window and, as links,
        frames outside the exclusion zone, which connect one cycle to the next; all frames.
    window : int or "auto", default="auto"
        Frames to each side that can be temporal neighbors; ``"auto"``: as `n_neighbors`.
    include_self : bool, default=True
        Count a frame among its own neighbors, as in Zhang and Zha; scikit-learn's
        LocallyLinearEmbedding does not.
    links : int, default=4
        For ``"recurrent"``: number of neighbors from outside the exclusion zone.
    exclusion : int or "auto", default="auto"
        For ``"recurrent"``: frames to each side that cannot be links; ``"auto"``: as `window`.
    fps : float, optional
        Frames per second, for ``n_neighbors="auto"``; a :class:`stltsa.Clip` has its own.
    map_neighbors : int or "auto", default="auto"
        Rows for each local map in `transform` and `inverse_transform`.
    map_blend : int, default=3
        Number of local maps to blend there.
    n_jobs : int, optional
        Number of threads: None is one, -1 all cores. The result has the same bits for any number.
    progress : bool or callable, default=False
        True shows a bar if tqdm is installed. A function is called with the stage and the finished
        fraction of it; an exception that it raises cancels the fit.

    Attributes
    ----------
    embedding_ : ndarray of shape (n_samples, n_components)
        The curve. Columns are centered and of norm 1 in each connected component; the sign makes
        the entry with the largest magnitude positive.
    eigenvalues_ : ndarray of shape (n_components + 2,)
        Smallest eigenvalues of the alignment matrix, ascending, starting with zero. With several
        connected components, those of the first; ``model_.eigenvalues`` has all.
    model_ : Model
        The fitted model, which also maps with distances and hints, and can be saved.
    n_features_in_ : int
        Number of fitted columns.
    n_neighbors_, window_ : int
        The values used.

    Notes
    -----
    Each clip is a separate component with its own embedding: compare coordinates of different clips
    only with ``neighbors="recurrent"`` or ``"spatial"``, and only if ``model_.n_components`` is 1.

    H. Li, J. Niu, L. Zhang, B. Hu: "Spatio-temporal LTSA and Its Application to Motion
    Decomposition". ICONIP 2012.

    Examples
    --------
    >>> import numpy as np
    >>> from stltsa import STLTSA
    >>> t = np.linspace(0, 6 * np.pi, 300)
    >>> X = np.column_stack([np.cos(t), np.sin(t), np.sin(t + 1)])
    >>> ltsa = STLTSA(n_neighbors=110).fit(X)
    >>> ltsa.embedding_.shape
    (300, 2)
    >>> bool((ltsa.transform(X) == ltsa.embedding_).all())
    True
    """

    def __init__(
        self,
        n_neighbors: int | Seconds | Auto = "auto",
        n_components: int = 2,
        *,
        neighbors: Mode = "temporal",
        window: int | Seconds | Auto = "auto",
        include_self: bool = True,
        links: int = 4,
        exclusion: int | Seconds | Auto = "auto",
        fps: float | None = None,
        map_neighbors: int | Auto = "auto",
        map_blend: int = 3,
        n_jobs: int | None = None,
        progress: Progress = False,
    ) -> None:
        self.n_neighbors = n_neighbors
        self.n_components = n_components
        self.neighbors = neighbors
        self.window = window
        self.include_self = include_self
        self.links = links
        self.exclusion = exclusion
        self.fps = fps
        self.map_neighbors = map_neighbors
        self.map_blend = map_blend
        self.n_jobs = n_jobs
        self.progress = progress

    def _threads(self) -> int | Literal["auto"]:
        if self.n_jobs is None:
            return 1
        return "auto" if self.n_jobs < 0 else self.n_jobs

    def _fit_options(self) -> dict[str, Any]:
        return {
            "neighbors": self.n_neighbors,
            "dimension": self.n_components,
            "mode": self.neighbors,
            "window": self.window,
            "include_self": self.include_self,
            "links": self.links,
            "exclusion": self.exclusion,
            "fps": self.fps,
            "threads": self._threads(),
            "progress": self.progress,
        }

    def _map_options(self) -> dict[str, Any]:
        return {
            "map_neighbors": self.map_neighbors,
            "map_blend": self.map_blend,
            "threads": self._threads(),
            "progress": self.progress,
        }

    def fit(self, X: Motions, y: object = None, *, groups: Labels | None = None) -> STLTSA:  # noqa: ARG002
        """Fit the curve.

        Parameters
        ----------
        X : array-like of shape (n_samples, n_features), list of such arrays, or Clip
            Rows are frames in temporal order; a list has one array per clip. A C-contiguous float64
            array is not copied; others are copied once (a list is copied into one array).
        y : ignored
            For scikit-learn's conventions.
        groups : array-like of shape (n_samples,), optional
            A label for each row of an array with several clips; the rows of a clip are contiguous.

        Returns
        -------
        STLTSA

        Raises
        ------
        ValueError
            The frames or the parameters are invalid; the text says what to do.

        Warns
        -----
        QualityWarning
            Warnings of the library about the result: rows without order in time, a coordinate that
            only follows time, a disconnected graph, a small gap.
        """
        self.model_ = self._fit_model(X, groups)
        self.embedding_ = self.model_.coords
        self.eigenvalues_ = self.model_.eigenvalues[0]
        self.n_neighbors_ = self.model_.neighbors
        self.window_ = self.model_.window
        self._n_features_out = self.embedding_.shape[1]
        for text in self.model_.warnings:
            warnings.warn(text.replace("mode=", "neighbors="), QualityWarning, stacklevel=2)
        return self

    def _fit_model(self, X: Any, groups: Any) -> Model:
        with _in_the_words_of_sklearn():
            options: Any = self._fit_options()
            model = fitted(self._motion(X, reset=True), groups, options)
        if isinstance(X, Clip):
            self.n_features_in_ = model.n_features
            vars(self).pop("feature_names_in_", None)  # from an array fitted before
        return model

    def _motion(self, X: Any, *, reset: bool) -> Any:
        """Return a Clip unchanged, and arrays after scikit-learn's checks."""
        if isinstance(X, Clip):
            return X
        if is_sequence_of_clips(X):
            return [self._validated(clip, reset=reset and i == 0) for i, clip in enumerate(X)]
        return self._validated(X, reset=reset)

    def fit_transform(
        self,
        X: Motions,
        y: object = None,  # noqa: ARG002
        *,
        groups: Labels | None = None,
    ) -> FloatArray:
        """Fit the curve and return `embedding_`; parameters as in :meth:`fit`."""
        return self.fit(X, groups=groups).embedding_

    def transform(self, X: Motions) -> FloatArray:
        """Map frames onto the curve; fitted rows get their own coordinates, to the bit.

        Equal rows that occur more than once all get the coordinates of the first; ``model_.map(X,
        hints=...)`` distinguishes them.

        Parameters
        ----------
        X : array-like of shape (n_samples, n_features), list of such arrays, or Clip
            Of a clip, every frame is mapped.

        Returns
        -------
        ndarray of shape (n_samples, n_components)
            Coordinates. ``model_.map(X).distance`` gives the distance of each row from the fitted
            ones.
        """
        self._check_fitted()
        with _in_the_words_of_sklearn():
            return self.model_.map(self._motion(X, reset=False), **self._map_options()).values

    def inverse_transform(self, X: Matrix) -> FloatArray:
        """Map coordinates back to frames.

        Parameters
        ----------
        X : array-like of shape (n_samples, n_components)
            Points on the curve or near it.

        Returns
        -------
        ndarray of shape (n_samples, n_features)
            Frames. ``model_.poses(X)`` returns a clip with a skeleton.
        """
        self._check_fitted()
        return self.model_.unmap(X, **self._map_options()).values
