//! The factors of a stiffness: L Lᵀ where it is positive definite, L D Lᵀ where it is not.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::ldlt::factor::LdltRegularization;
use faer::linalg::cholesky::llt::factor::{LltError, LltRegularization};
use faer::sparse::linalg::cholesky::{LdltRef, LltRef, SymbolicCholesky, SymbolicCholeskyRaw};
use faer::{Conj, MatMut, Par, Side, Spec};

use crate::equations::Equations;
use crate::substitute::Triangle;

/// The lower triangle L, with D on its diagonal where there is one.
pub(crate) struct Lower {
    values: Vec<f64>,
    is_definite: bool,
}

impl Lower {
    /// Factors a matrix by its lower half. The error is the equation at which it is not positive definite.
    pub fn new(equations: &Equations, numbers: &[f64]) -> Result<Self, usize> {
        let symbolic = &equations.symbolic;
        let mut values = vec![0.0; symbolic.len_val()];
        let need = symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Spec::default());
        symbolic
            .factorize_numeric_llt(
                &mut values,
                equations.matrix(numbers),
                Side::Lower,
                LltRegularization::default(),
                Par::Seq,
                MemStack::new(&mut MemBuffer::new(need)),
                Spec::default(),
            )
            .map_err(|LltError::NonPositivePivot { index }| index)?;
        Ok(Self { values, is_definite: true })
    }

    /// Factors a matrix that need not be positive definite, without pivoting; `None` where a pivot is zero. Also how many values of
    /// the matrix are below zero: as many as pivots (Sylvester).
    pub fn indefinite(equations: &Equations, numbers: &[f64]) -> Option<(Self, usize)> {
        let symbolic = &equations.symbolic;
        let mut values = vec![0.0; symbolic.len_val()];
        let need = symbolic.factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Spec::default());
        symbolic
            .factorize_numeric_ldlt(
                &mut values,
                equations.matrix(numbers),
                Side::Lower,
                LdltRegularization::default(),
                Par::Seq,
                MemStack::new(&mut MemBuffer::new(need)),
                Spec::default(),
            )
            .ok()?;
        let lower = Self { values, is_definite: false };
        let below = (0..equations.len()).filter(|&equation| lower.diagonal(symbolic, equation) < 0.0).count();
        Some((lower, below))
    }

    /// The diagonal of L, or of D.
    pub fn diagonal(&self, symbolic: &SymbolicCholesky<usize>, equation: usize) -> f64 {
        match symbolic.raw() {
            SymbolicCholeskyRaw::Simplicial(simplicial) => self.values[simplicial.col_ptr()[equation]],
            SymbolicCholeskyRaw::Supernodal(supernodal) => {
                let begins = supernodal.supernode_begin();
                let s = begins.partition_point(|&begin| begin <= equation) - 1;
                let within = equation - begins[s];
                let rows =
                    supernodal.supernode_end()[s] - begins[s] + supernodal.supernode(s).pattern().len();
                self.values[supernodal.col_ptr_for_val()[s] + within * (rows + 1)]
            }
        }
    }

    /// With memory for so many right sides at once, one at least.
    pub fn solver<'s>(&'s self, symbolic: &'s SymbolicCholesky<usize>, columns: usize) -> Solver<'s> {
        let memory = MemBuffer::new(symbolic.solve_in_place_scratch::<f64>(columns, Par::Seq));
        Solver { lower: self, symbolic, memory, columns }
    }
}

/// Solves several right sides at once, again and again.
pub(crate) struct Solver<'s> {
    lower: &'s Lower,
    symbolic: &'s SymbolicCholesky<usize>,
    memory: MemBuffer,
    columns: usize,
}

impl Solver<'_> {
    /// Solves in place; columns follow each other.
    pub fn solve(&mut self, columns: &mut [f64]) {
        let rows = self.symbolic.nrows();
        if rows > 0 {
            columns.chunks_mut(rows * self.columns).for_each(|columns| self.solve_together(columns));
        }
    }

    fn solve_together(&mut self, columns: &mut [f64]) {
        let rows = self.symbolic.nrows();
        let (symbolic, values, is_definite) = (self.symbolic, &self.lower.values[..], self.lower.is_definite);
        if let SymbolicCholeskyRaw::Simplicial(symbolic) = symbolic.raw() {
            return Triangle { symbolic, values, is_definite }.solve(columns);
        }
        let right = MatMut::from_column_major_slice_mut(columns, rows, columns.len() / rows);
        let memory = MemStack::new(&mut self.memory);
        if is_definite {
            LltRef::new(symbolic, values).solve_in_place_with_conj(Conj::No, right, Par::Seq, memory);
        } else {
            LdltRef::new(symbolic, values).solve_in_place_with_conj(Conj::No, right, Par::Seq, memory);
        }
    }
}
