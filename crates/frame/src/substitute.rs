//! Forward and backward substitution with a sparse triangle, for several right sides beside each other: each number of the
//! triangle is read once for all of them.

use faer::sparse::linalg::cholesky::simplicial::SymbolicSimplicialCholesky;

/// So many right sides are beside each other: what a processor's cache line holds.
const BESIDE: usize = 8;

/// So many are as fast as fewer.
const FEW: usize = 4;

/// A lower triangle, column by column, each with its diagonal first.
pub(crate) struct Triangle<'a> {
    pub symbolic: &'a SymbolicSimplicialCholesky<usize>,
    pub values: &'a [f64],
    /// L Lᵀ; else L D Lᵀ with D on the diagonal and 1 in place of it.
    pub is_definite: bool,
}

impl Triangle<'_> {
    /// Solves in place; right sides follow each other.
    pub fn solve(&self, columns: &mut [f64]) {
        let rows = self.symbolic.nrows();
        let mut groups = columns.chunks_mut(rows * BESIDE);
        for group in &mut groups {
            match group.len() / rows {
                // One alone is the usual case.
                1 => self.solve_beside::<1>(group),
                2..=FEW => self.solve_beside::<FEW>(group),
                _ => self.solve_beside::<BESIDE>(group),
            }
        }
    }

    /// Solves up to N right sides that follow each other.
    fn solve_beside<const N: usize>(&self, columns: &mut [f64]) {
        let rows = self.symbolic.nrows();
        let mut x = vec![[0.0; N]; rows];
        for (k, column) in columns.chunks(rows).enumerate() {
            x.iter_mut().zip(column).for_each(|(x, value)| x[k] = *value);
        }
        self.forward(&mut x);
        self.backward(&mut x);
        for (k, column) in columns.chunks_mut(rows).enumerate() {
            column.iter_mut().zip(&x).for_each(|(value, x)| *value = x[k]);
        }
    }

    /// L x, and D where there is one.
    fn forward<const N: usize>(&self, x: &mut [[f64; N]]) {
        let (starts, rows) = (self.symbolic.col_ptr(), self.symbolic.row_idx());
        for column in 0..x.len() {
            let (from, to) = (starts[column], starts[column + 1]);
            let inverse = 1.0 / self.values[from];
            let divided = x[column].map(|value| value * inverse);
            let own = if self.is_definite { divided } else { x[column] };
            for (&value, &row) in self.values[from + 1..to].iter().zip(&rows[from + 1..to]) {
                let into = &mut x[row];
                for k in 0..N {
                    into[k] -= value * own[k];
                }
            }
            x[column] = divided;
        }
    }

    /// Lᵀ x.
    fn backward<const N: usize>(&self, x: &mut [[f64; N]]) {
        let (starts, rows) = (self.symbolic.col_ptr(), self.symbolic.row_idx());
        for column in (0..x.len()).rev() {
            let (from, to) = (starts[column], starts[column + 1]);
            let mut own = x[column];
            for (&value, &row) in self.values[from + 1..to].iter().zip(&rows[from + 1..to]) {
                let other = &x[row];
                for k in 0..N {
                    own[k] -= value * other[k];
                }
            }
            let inverse = if self.is_definite { 1.0 / self.values[from] } else { 1.0 };
            x[column] = own.map(|value| value * inverse);
        }
    }
}
