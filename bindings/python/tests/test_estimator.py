# SPDX-License-Identifier: BSD-3-Clause
"""The conventions of scikit-learn."""

import pickle

import numpy as np
import pytest

import stltsa
from stltsa import STLTSA

pytest.importorskip("sklearn")

from sklearn.base import clone
from sklearn.pipeline import make_pipeline
from sklearn.preprocessing import StandardScaler
from sklearn.utils.estimator_checks import parametrize_with_checks


# The checks fit random points, which give many warnings. Checks that shuffle rows, or pass some of
# them, hold although the order of rows is time, because mapping works row by row.
@pytest.mark.filterwarnings("ignore::stltsa.QualityWarning")
@pytest.mark.filterwarnings("ignore:Can't check dok sparse matrix:UserWarning")
@parametrize_with_checks(
    [
        STLTSA(n_neighbors=5),
        STLTSA(n_neighbors=5, n_components=1, neighbors="spatial"),
        STLTSA(n_neighbors=3, n_components=1, neighbors="recurrent", links=1),
    ]
)
def test_checks_of_sklearn(estimator, check):
    check(estimator)


@pytest.fixture
def fitted(circle):
    return STLTSA(n_neighbors=100).fit(circle)


def test_attributes(fitted, circle):
    assert fitted.embedding_.shape == (300, 2)
    assert fitted.eigenvalues_.shape == (4,)
    assert (fitted.n_features_in_, fitted.n_neighbors_, fitted.window_) == (5, 100, 100)
    assert np.array_equal(fitted.embedding_, stltsa.fit(circle, neighbors=100).coords)


def test_transform_of_what_was_fitted_is_the_embedding(fitted, circle):
    assert np.array_equal(fitted.transform(circle), fitted.embedding_)
    assert np.array_equal(fitted.transform(circle[[7, 3]]), fitted.embedding_[[7, 3]])
    assert np.array_equal(STLTSA(n_neighbors=100).fit_transform(circle), fitted.embedding_)


def test_inverse(fitted, circle):
    back = fitted.inverse_transform(fitted.embedding_)
    assert np.abs(back - circle).max() < 0.1 * np.abs(circle).max()


def test_pickle_and_clone(fitted, circle):
    again = pickle.loads(pickle.dumps(fitted))
    assert np.array_equal(again.transform(circle + 0.01), fitted.transform(circle + 0.01))
    fresh = clone(fitted)
    assert fresh.get_params() == fitted.get_params()
    assert not hasattr(fresh, "embedding_")


def test_names_and_output(fitted, circle):
    pandas = pytest.importorskip("pandas")
    assert list(fitted.get_feature_names_out()) == ["stltsa0", "stltsa1"]
    frame = pandas.DataFrame(circle, columns=list("abcde"))
    out = STLTSA(n_neighbors=100).set_output(transform="pandas").fit_transform(frame)
    assert list(out.columns) == ["stltsa0", "stltsa1"]
    assert np.array_equal(out.to_numpy(), fitted.embedding_)


def test_pipeline(circle):
    pipeline = make_pipeline(StandardScaler(), STLTSA(n_neighbors=100))
    coords = pipeline.fit_transform(circle)
    assert np.array_equal(pipeline.transform(circle), coords)


@pytest.mark.filterwarnings("ignore::stltsa.QualityWarning")
def test_several_clips(circle):
    halves = [circle[:150], circle[150:]]
    one = STLTSA(n_neighbors=60).fit(circle, groups=np.repeat([0, 1], 150))
    two = STLTSA(n_neighbors=60).fit(halves)
    assert np.array_equal(one.embedding_, two.embedding_)
    assert np.array_equal(two.transform(halves), two.embedding_)
    assert one.model_.n_components == 2


@pytest.mark.filterwarnings("ignore::stltsa.QualityWarning")
def test_names_of_several_clips(circle):
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(circle, columns=list("abcde"))
    ltsa = STLTSA(n_neighbors=60).fit([frame[:150], frame[150:]])
    assert list(ltsa.feature_names_in_) == list("abcde")
    assert np.array_equal(ltsa.transform(frame), ltsa.embedding_)  # without a warning
    turned = frame[list("bacde")]
    for bad in (lambda: ltsa.fit([frame, turned]), lambda: ltsa.transform([frame, turned])):
        with pytest.raises(ValueError, match="feature names should match"):
            bad()


def test_names_of_an_earlier_fit_are_forgotten(circle, clip):
    pandas = pytest.importorskip("pandas")
    ltsa = STLTSA(n_neighbors=100).fit(pandas.DataFrame(circle, columns=list("abcde")))
    ltsa.set_params(n_neighbors="auto").fit(clip)
    assert ltsa.n_features_in_ == 69
    assert not hasattr(ltsa, "feature_names_in_")
    assert ltsa.transform(clip.features()).shape == (844, 2)


def test_clip(clip, model):
    ltsa = STLTSA().fit(clip)
    assert np.array_equal(ltsa.embedding_, model.coords)
    assert ltsa.transform(clip).shape == (len(clip), 2)


def test_threads_change_no_bit(circle):
    one, all_ = (STLTSA(n_neighbors=100, n_jobs=n).fit(circle) for n in (None, -1))
    assert np.array_equal(one.embedding_, all_.embedding_)


def test_warnings_are_warned(circle):
    with pytest.warns(stltsa.QualityWarning):
        STLTSA(n_neighbors=5).fit(circle)


def test_not_finite_says_where(fitted, circle):
    spoiled = circle.copy()
    spoiled[17, 3] = np.nan
    with pytest.raises(ValueError, match=r"NaN or infinity: frames: row 17, column 3"):
        fitted.transform(spoiled)


@pytest.mark.filterwarnings("ignore::stltsa.QualityWarning")
@pytest.mark.parametrize(
    ("params", "options"),
    [
        ({"n_components": 1}, {"dimension": 1}),
        ({"window": 90}, {"window": 90}),
        ({"include_self": False}, {"include_self": False}),
        ({"neighbors": "recurrent", "links": 7}, {"mode": "recurrent", "links": 7}),
        ({"neighbors": "recurrent", "exclusion": 120}, {"mode": "recurrent", "exclusion": 120}),
        ({"n_neighbors": "auto", "fps": 100}, {"neighbors": "auto", "fps": 100}),
    ],
    ids=str,
)
def test_parameters_reach_the_library(circle, params, options):
    ltsa = STLTSA(**{"n_neighbors": 60, **params}).fit(circle)
    assert np.array_equal(
        ltsa.embedding_, stltsa.fit(circle, **{"neighbors": 60, **options}).coords
    )
    plain = stltsa.fit(circle, neighbors=60, mode=options.get("mode", "temporal"))
    assert not np.array_equal(ltsa.embedding_, plain.coords)


def test_map_parameters_reach_the_library(circle):
    ltsa = STLTSA(n_neighbors=100, map_neighbors=30, map_blend=7).fit(circle)
    between = 0.5 * (circle[1:] + circle[:-1])
    mapped = ltsa.model_.map(between, map_neighbors=30, map_blend=7).values
    assert np.array_equal(ltsa.transform(between), mapped)
    assert not np.array_equal(ltsa.model_.map(between).values, mapped)
    frames = ltsa.model_.unmap(mapped, map_neighbors=30, map_blend=7).values
    assert np.array_equal(ltsa.inverse_transform(mapped), frames)


def swiss_roll(rows=1000):
    random = np.random.default_rng(0)
    turn = 1.5 * np.pi * (1 + 2 * random.random(rows))
    return np.column_stack([turn * np.cos(turn), 21 * random.random(rows), turn * np.sin(turn)])


def test_rows_without_order_are_told_what_to_call(clip):
    roll = swiss_roll()
    with pytest.warns(
        stltsa.QualityWarning, match='no order in time.*neighbors="spatial", include_self=False'
    ) as caught:
        stltsa.STLTSA(12).fit(roll)
    assert not any("only follows time" in str(warning.message) for warning in caught)
    for motion, options in ((clip, {}), (clip.features(), {"fps": 120}), (clip.features(), {})):
        said = stltsa.fit(motion, **options).warnings
        assert not any("no order" in text for text in said)
    assert not any("no order" in t for t in stltsa.fit(roll, mode="spatial", neighbors=12).warnings)


def test_rows_without_order_as_scikit_learn_embeds_them():
    manifold = pytest.importorskip("sklearn.manifold")
    roll = swiss_roll()
    ours = stltsa.STLTSA(12, 2, neighbors="spatial", include_self=False).fit_transform(roll)
    theirs = manifold.LocallyLinearEmbedding(
        n_neighbors=12, n_components=2, method="ltsa", eigen_solver="dense"
    ).fit_transform(roll)
    cosines = np.linalg.svd(np.linalg.qr(ours)[0].T @ np.linalg.qr(theirs)[0])[1]
    assert cosines.min() > 1 - 1e-9
