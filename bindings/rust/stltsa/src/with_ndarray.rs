// SPDX-License-Identifier: BSD-3-Clause
//! The feature `ndarray`: reads its arrays in place, and converts results to its arrays.

use ndarray::{Array2, ArrayBase, ArrayView2, Data, Ix2};

use crate::array::{Element, Matrix, View};

impl<'a, T: Element, S: Data<Elem = T>> From<&'a ArrayBase<S, Ix2>> for View<'a> {
    /// Any strides, without a copy.
    fn from(array: &'a ArrayBase<S, Ix2>) -> Self {
        let strides = (array.strides()[0], array.strides()[1]);
        // SAFETY: ndarray's own pointer, shape and strides (in entries), borrowed for 'a.
        unsafe { View::from_raw_parts(array.as_ptr(), array.dim(), strides) }
    }
}

impl<'a, T: Element> From<ArrayView2<'a, T>> for View<'a> {
    /// Any strides, without a copy.
    fn from(array: ArrayView2<'a, T>) -> Self {
        let strides = (array.strides()[0], array.strides()[1]);
        // SAFETY: ndarray's own pointer, shape and strides (in entries), borrowed for 'a.
        unsafe { View::from_raw_parts(array.as_ptr(), array.dim(), strides) }
    }
}

impl From<Matrix> for Array2<f64> {
    /// Without a copy.
    fn from(matrix: Matrix) -> Self {
        let shape = (matrix.rows(), matrix.cols());
        Array2::from_shape_vec(shape, matrix.into_vec()).expect("a matrix has rows x cols entries")
    }
}
