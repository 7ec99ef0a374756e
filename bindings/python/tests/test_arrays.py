# SPDX-License-Identifier: BSD-3-Clause
"""Arrays of every kind reach the library with the right numbers."""

import numpy as np
import pytest

import stltsa
from stltsa._arrays import as_matrix, read_from
from stltsa._clips import group_lengths

K = {"neighbors": 100}


def strided(x):
    wide = np.full((2 * len(x), 3 * x.shape[1]), np.nan)
    wide[::2, ::3] = x
    return wide[::2, ::3]


LAYOUTS = {
    "fortran": np.asfortranarray,
    "every other": strided,
    "turned around": lambda x: np.ascontiguousarray(x[::-1, ::-1])[::-1, ::-1],
    "transposed": lambda x: np.ascontiguousarray(x.T).T,
    "big-endian": lambda x: x.astype(">f8"),
    "list": lambda x: x.tolist(),
    "read-only": lambda x: np.frombuffer(x.tobytes()).reshape(x.shape),
}


@pytest.mark.parametrize("layout", LAYOUTS.values(), ids=LAYOUTS.keys())
def test_layout_changes_no_bit(circle, layout):
    expected = stltsa.fit(circle, **K).coords
    assert np.array_equal(stltsa.fit(layout(circle), **K).coords, expected)


def test_float32_is_read_as_it_is(circle):
    single = circle.astype(np.float32)
    expected = stltsa.fit(single.astype(np.float64), **K).coords
    assert np.array_equal(stltsa.fit(single, **K).coords, expected)
    assert np.array_equal(stltsa.fit(strided(circle).astype("f4"), **K).coords, expected)


def test_integers(circle):
    whole = np.round(circle * 1000).astype(np.int32)
    assert np.array_equal(stltsa.fit(whole, **K).coords, stltsa.fit(whole * 1.0, **K).coords)
    assert as_matrix(np.asfortranarray(whole)).flags.c_contiguous  # else the library copies again


@pytest.mark.parametrize("layout", ["fortran", "every other", "turned around", "transposed"])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_floats_are_not_copied(circle, layout, dtype):
    array = LAYOUTS[layout](circle.astype(dtype)).astype(dtype, copy=False)
    seen = as_matrix(array)
    assert np.shares_memory(seen, array)
    view = read_from(seen)
    assert (view.rows, view.cols) == array.shape
    assert (view.row_stride, view.col_stride) == array.strides


def test_broadcast_array_is_not_taken_for_packed_rows():
    with pytest.raises(stltsa.DegenerateError, match="nothing moves"):
        stltsa.fit(np.broadcast_to(1.5, (50, 4)), neighbors=5)
    assert as_matrix(np.broadcast_to(1.5, (50, 4))).strides != (0, 0)


@pytest.mark.parametrize("values", [np.arange(100.0), np.zeros((4, 3, 2)), [1.0, 2.0]])
def test_other_than_two_dimensions_are_refused(values):
    with pytest.raises(ValueError, match=f"2-D.* it is a {type(values).__name__} of the shape"):
        stltsa.fit(values)


@pytest.mark.parametrize(
    "values",
    [
        [["1", "2"], ["3", "4"]],
        [[b"1"], [b"2"]],
        np.arange(6).astype("M8[s]").reshape(3, 2),
        np.zeros((3, 2), dtype=[("x", "f8"), ("y", "f8")]),
        [[1, "a"], [2, object()]],
        [[1, 10**400], [2, 3]],
    ],
    ids=["texts", "bytes", "dates", "records", "objects", "too large"],
)
def test_what_is_no_number_is_refused(values):
    with pytest.raises(ValueError, match="X must hold numbers"):
        stltsa.fit(values)


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.int16])
def test_masked_is_missing(circle, dtype):
    values = (1000 * circle).astype(dtype)
    whole = np.ma.masked_array(values)
    assert np.array_equal(stltsa.fit(whole, **K).coords, stltsa.fit(values, **K).coords)
    whole[17, 3] = np.ma.masked
    for motion in (whole, [values, whole]):
        with pytest.raises(stltsa.NotFiniteError, match="column 3 is NaN"):
            stltsa.fit(motion, **K)
    with pytest.raises(stltsa.NotFiniteError, match="row 17, column 3 is NaN"):
        stltsa.STLTSA(n_neighbors=100).fit(whole)


def test_unaligned_and_mapped_files(circle, tmp_path):
    expected = stltsa.fit(circle, **K).coords
    unaligned = np.ndarray(circle.shape, buffer=bytearray(circle.nbytes + 1), offset=1)
    unaligned[:] = circle
    assert np.array_equal(stltsa.fit(unaligned, **K).coords, expected)
    np.save(tmp_path / "x.npy", circle)
    mapped = np.load(tmp_path / "x.npy", mmap_mode="r")
    assert np.shares_memory(as_matrix(mapped), mapped)
    assert np.array_equal(stltsa.fit(mapped, **K).coords, expected)


def test_groups_and_lists_are_the_same(circle):
    groups = np.repeat(["a", "b"], 150)
    one = stltsa.fit(circle, groups=groups, neighbors=60)
    two = stltsa.fit([circle[:150], circle[150:]], neighbors=60)
    assert one.n_components == two.n_components == 2
    assert np.array_equal(one.coords, two.coords)
    assert np.array_equal(one.components, np.repeat([0, 1], 150))
    for rows in (slice(0, 150), slice(150, 300)):
        alone = stltsa.fit(circle[rows], neighbors=60)
        assert np.array_equal(one.coords[rows], alone.coords)


def test_rows_of_a_group_stand_together():
    with pytest.raises(ValueError, match="stand together"):
        group_lengths([0, 0, 1, 1, 0], 5)
    with pytest.raises(ValueError, match="label for each"):
        group_lengths([0, 0], 5)
    with pytest.raises(ValueError, match="some are NaN"):
        group_lengths([0.0, np.nan, np.nan], 3)


def test_labels_of_groups_may_be_anything():
    labels = np.array([None, None, "a", 1, 1], dtype=object)
    assert group_lengths(labels, 5).tolist() == [2, 1, 2]


def test_clips_of_other_columns_are_refused(circle):
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(circle, columns=list("abcde"))
    expected = stltsa.fit([circle[:150], circle[150:]], neighbors=60).coords
    named = stltsa.fit([frame[:150], frame[150:]], neighbors=60)
    assert np.array_equal(named.coords, expected)
    with pytest.raises(ValueError, match="another order"):
        stltsa.fit([frame[:150], frame[150:][list("bacde")]], neighbors=60)


def test_clips_of_other_widths_are_refused(circle):
    with pytest.raises(ValueError, match="different numbers of columns"):
        stltsa.fit([circle, circle[:, :3]])
