//! A symmetric matrix of which each row is stored from its first number to the diagonal, and its factor L Lᵀ, which has no numbers
//! elsewhere (George and Liu, Computer Solution of Large Sparse Positive Definite Systems, 1981, chapter 4).

use nalgebra::DVectorView;

/// A row up to the diagonal.
#[derive(Clone)]
struct Row {
    first: usize,
    beside: Vec<f64>,
    diagonal: f64,
}

#[derive(Clone)]
pub(crate) struct Skyline(Vec<Row>);

/// L of L Lᵀ.
pub(crate) struct Lower(Skyline);

impl Skyline {
    /// Zeros. `first` are the columns at which the rows begin.
    pub fn new(first: &[usize]) -> Self {
        let row =
            |(row, &first): (usize, &usize)| Row { first, beside: vec![0.0; row - first], diagonal: 0.0 };
        Self(first.iter().enumerate().map(row).collect())
    }

    /// Adds to a place on the diagonal or below.
    pub fn add(&mut self, row: usize, column: usize, value: f64) {
        let of = &mut self.0[row];
        if column == row {
            of.diagonal += value;
        } else {
            of.beside[column - of.first] += value;
        }
    }

    pub fn times(&self, x: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; x.len()];
        for (k, row) in self.0.iter().enumerate() {
            product[k] += row.diagonal * x[k] + dot(&row.beside, &x[row.first..k]);
            product[row.first..k].iter_mut().zip(&row.beside).for_each(|(sum, value)| *sum += value * x[k]);
        }
        product
    }

    /// None where what is left of a diagonal is no more than this share of it: it is not positive definite, or only by rounding.
    pub fn factor(mut self, share: f64) -> Option<Lower> {
        for k in 0..self.0.len() {
            let (above, below) = self.0.split_at_mut(k);
            let row = &mut below[0];
            for (column, other) in above.iter().enumerate().skip(row.first) {
                let from = row.first.max(other.first);
                let place = column - row.first;
                let sum = dot(&row.beside[from - row.first..place], &other.beside[from - other.first..]);
                row.beside[place] = (row.beside[place] - sum) / other.diagonal;
            }
            let left = row.diagonal - dot(&row.beside, &row.beside);
            if left.is_nan() || left <= share * row.diagonal {
                return None;
            }
            row.diagonal = left.sqrt();
        }
        Some(Lower(self))
    }
}

impl Lower {
    pub fn solve(&self, right: &[f64]) -> Vec<f64> {
        let mut x = right.to_vec();
        for (k, row) in self.0.0.iter().enumerate() {
            x[k] = (x[k] - dot(&row.beside, &x[row.first..k])) / row.diagonal;
        }
        for (k, row) in self.0.0.iter().enumerate().rev() {
            x[k] /= row.diagonal;
            let own = x[k];
            x[row.first..k].iter_mut().zip(&row.beside).for_each(|(x, value)| *x -= value * own);
        }
        x
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    DVectorView::from_slice(a, a.len()).dot(&DVectorView::from_slice(b, b.len()))
}
