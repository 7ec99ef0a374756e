// SPDX-License-Identifier: BSD-3-Clause
//! Arrays with any strides are read in place; wrong shapes are refused before C sees them.

use stltsa::{Clip, ErrorKind, Features, Matrix, Options, View};

/// The numbers of a view, as the library reads them.
fn read<'a>(view: impl Into<View<'a>>) -> Matrix {
    let clip = Clip::from_matrix(view, 30.0).expect("the view is read");
    clip.features(&Options::new().features(Features::Raw)).expect("it has features")
}

fn matrix(data: &[f64], rows: usize, cols: usize) -> Matrix {
    Matrix::from_vec(data.to_vec(), rows, cols).expect("data has rows x cols entries")
}

const NUMBERS: [f64; 6] = [1.0, 2.0, 3.0, 4.0, 5.0, 6.5];

#[test]
fn packed_numbers_of_either_kind_are_read() {
    let expected = matrix(&NUMBERS, 3, 2);
    let narrow = NUMBERS.map(|number| number as f32);
    assert_eq!(read(View::new(&NUMBERS, 3, 2).unwrap()), expected);
    assert_eq!(read(View::new(&narrow, 3, 2).unwrap()), expected);
    assert_eq!(read(&expected), expected);
    assert_eq!(read(&[[1.0, 2.0], [3.0, 4.0], [5.0, 6.5]]), expected);
    assert_eq!(read(&vec![[1.0_f32, 2.0], [3.0, 4.0], [5.0, 6.5]]), expected);
    assert_eq!(read(&[[1.0, 2.0], [3.0, 4.0], [5.0, 6.5]][1..]), matrix(&NUMBERS[2..], 2, 2));
}

#[test]
fn any_strides_are_read() {
    let strided =
        |start, shape, strides| read(View::strided(&NUMBERS, start, shape, strides).unwrap());
    let transposed = [1.0, 3.0, 5.0, 2.0, 4.0, 6.5];
    assert_eq!(strided(0, (2, 3), (1, 2)), matrix(&transposed, 2, 3));
    let reversed = [5.0, 6.5, 3.0, 4.0, 1.0, 2.0];
    assert_eq!(strided(4, (3, 2), (-2, 1)), matrix(&reversed, 3, 2));
    assert_eq!(strided(5, (1, 3), (0, -2)), matrix(&[6.5, 4.0, 2.0], 1, 3));
    assert_eq!(strided(1, (2, 2), (0, 2)), matrix(&[2.0, 4.0, 2.0, 4.0], 2, 2));
    assert_eq!(strided(1, (3, 1), (0, 0)), matrix(&[2.0; 3], 3, 1));
    assert_eq!(strided(1, (1, 3), (0, 0)), matrix(&[2.0; 3], 1, 3));
    assert_eq!(strided(2, (1, 1), (isize::MAX, isize::MIN)), matrix(&[3.0], 1, 1));
}

#[test]
fn what_reaches_outside_is_refused() {
    let refused = |start, shape, strides| {
        let error = View::strided(&NUMBERS, start, shape, strides).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::Shape, "{error}");
    };
    refused(0, (4, 2), (2, 1));
    refused(1, (3, 2), (2, 1));
    refused(0, (2, 2), (-1, 1));
    refused(6, (1, 1), (1, 1));
    refused(usize::MAX, (1, 1), (1, 1));
    refused(0, (3, 3), (isize::MAX, isize::MAX));
    refused(0, (usize::MAX, 2), (isize::MIN, 1));
    for (rows, cols) in [(3, 3), (2, 2), (0, 6), (usize::MAX, 2), (usize::MAX, usize::MAX)] {
        assert_eq!(View::new(&NUMBERS, rows, cols).unwrap_err().kind(), ErrorKind::Shape);
        assert!(Matrix::from_vec(NUMBERS.to_vec(), rows, cols).is_err());
    }
}

/// In C, both strides 0 mean "packed" and would read past the end.
#[test]
fn one_number_for_all_is_refused() {
    let view = View::strided(&NUMBERS, 0, (1000, 1000), (0, 0)).unwrap();
    assert_eq!(Clip::from_matrix(view, 30.0).unwrap_err().kind(), ErrorKind::Shape);
}

#[test]
fn nothing_is_too_few() {
    for (rows, cols) in [(0, 0), (0, 4), (4, 0)] {
        let none: [f64; 0] = [];
        let views = [
            View::new(&none, rows, cols).unwrap(),
            View::strided(&none, 7, (rows, cols), (isize::MAX, 0)).unwrap(),
        ];
        for view in views {
            assert_eq!(Clip::from_matrix(view, 30.0).unwrap_err().kind(), ErrorKind::Shape);
        }
    }
}

#[test]
fn a_matrix_gives_its_entries() {
    let matrix = matrix(&NUMBERS, 3, 2);
    assert_eq!(matrix[(2, 1)], 6.5);
    assert_eq!(matrix.row(1), [3.0, 4.0]);
    assert!(matrix.column(1).eq([2.0, 4.0, 6.5]));
    assert_eq!(matrix.into_vec(), NUMBERS);
    let empty = Matrix::from_vec(Vec::new(), 0, 2).unwrap();
    assert_eq!(empty.column(1).count(), 0);
}

#[cfg(feature = "ndarray")]
mod with_ndarray {
    use super::*;
    use ndarray::{arr2, s, Array2};

    #[test]
    fn its_arrays_go_both_ways() {
        let array = arr2(&[[1.0, 2.0], [3.0, 4.0], [5.0, 6.5]]);
        assert_eq!(read(&array), matrix(&NUMBERS, 3, 2));
        assert_eq!(read(array.t()), matrix(&[1.0, 3.0, 5.0, 2.0, 4.0, 6.5], 2, 3));
        assert_eq!(read(array.slice(s![..;-2, 1..])), matrix(&[6.5, 2.0], 2, 1));
        assert_eq!(read(&array.mapv(|number| number as f32)), matrix(&NUMBERS, 3, 2));
        assert_eq!(Array2::from(matrix(&NUMBERS, 3, 2)), array);
        let repeated = array.row(1);
        let repeated = repeated.broadcast((2, 2)).unwrap();
        assert_eq!(read(repeated), matrix(&[3.0, 4.0, 3.0, 4.0], 2, 2));
    }
}
