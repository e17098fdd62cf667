//! The largest values of an operator by Lanczos in blocks.
//!
//! The operator (K - μ M)⁻¹ M is symmetric in the inner product of M, and its largest values belong to the lowest modes. What it
//! makes of a block is made orthogonal to all that is there, and is the next block; the operator between all blocks is a small matrix,
//! whose values become those of the operator.

use faer::{Mat, MatRef, Side};

use super::basis::{Basis, Block};
use super::mass::{self, Mass};
use crate::error::ModesError;
use crate::lower::Solver;

/// So many vectors at once are the fastest; as many equal frequencies are found together, more by luck.
pub(super) const BLOCK: usize = mass::TOGETHER;

/// A mode has converged when what is left of its value is below this share of it. The share bounds the error of the value, the
/// square of it over the distance to the next value is the usual error, and a frequency errs by half as much.
const CONVERGED: f64 = 1e-6;

/// Beyond so many vectors, and ten more for each mode wanted, a search has failed.
const MOST_VECTORS: usize = 1000;

/// What a search is for. `free` is how many rows are those of nodes that are there; no more than `free` less the rigid motions
/// are wanted.
#[derive(Clone, Copy)]
pub(super) struct Goal<'a> {
    pub mass: &'a Mass<'a>,
    pub rigid: &'a [Vec<f64>],
    pub free: usize,
    pub wanted: usize,
    /// So many vectors at once.
    pub block: usize,
    /// Where the lowest mode may be known within this share of its value, the search ends early; 0 for never.
    pub near: f64,
}

/// What a search has come to.
pub(super) enum Found {
    /// What the operator makes of each mode wanted, and its vector, lowest mode first; without the rigid ones.
    Modes(Vec<(f64, Vec<f64>)>),
    /// About what the operator makes of the lowest mode, and no less than that.
    Near(f64),
}

/// Looks for the largest values of an operator.
pub(super) fn lowest(goal: &Goal, solver: &mut Solver) -> Result<Found, ModesError> {
    let (wanted, all) = (goal.wanted, goal.free - goal.rigid.len());
    if wanted == 0 {
        return Ok(Found::Modes(Vec::new()));
    }
    let most = all.min(MOST_VECTORS + 10 * wanted);
    let mut basis = Basis::new(goal.mass, goal.rigid);
    let mut random = Random(0x2545_F491_4F6C_DD1D);
    let mut operator = Vec::<Mat<f64>>::new();
    let mut look_at = wanted.max(2 * goal.block);
    let mut block = begin(&basis, solver, &mut random, goal.block);
    // A block without directions would be a positive mass with fewer of them than rows.
    while basis.len() < most && block.width() > 0 {
        block.keep(most - basis.len());
        basis.append(&block);
        let mut next = block.mass_vectors;
        solver.solve(&mut next);
        block = basis.orthogonal(next);
        operator.push(block.along.clone());
        let (end, complete) = (basis.len(), basis.len() == all);
        if end >= look_at || end == most {
            let ritz = Ritz::new(&operator)?;
            let converged = if complete { all } else { ritz.converged(&block.leads) };
            if converged >= wanted {
                let mode = |k: usize| (ritz.values[k], basis.combined(&ritz.vector(k)));
                return Ok(Found::Modes((0..wanted).map(mode).collect()));
            }
            if end == most {
                return Err(ModesError::NotConverged { found: converged, wanted, vectors: end });
            }
            if ritz.left_of_first(&block.leads) < goal.near {
                return Ok(Found::Near(ritz.values[0]));
            }
            // The small problem costs its size cubed, and so is looked at but now and then.
            look_at = end + (end / 6).max(2 * goal.block);
        }
        if block.width() == 0 {
            // What the search began with holds no other mode; equal ones may be left.
            block = begin(&basis, solver, &mut random, goal.block);
        }
    }
    Err(ModesError::NotConverged { found: 0, wanted, vectors: basis.len() })
}

/// A block of random directions, in which the lowest modes are already the strongest.
fn begin(basis: &Basis, solver: &mut Solver, random: &mut Random, width: usize) -> Block {
    let mut columns: Vec<f64> = (0..basis.rows() * width).map(|_| random.next()).collect();
    columns = basis.mass().times(&columns);
    solver.solve(&mut columns);
    basis.orthogonal(columns)
}

/// The values and vectors of the operator between the blocks, largest value first.
struct Ritz {
    values: Vec<f64>,
    vectors: Mat<f64>,
}

impl Ritz {
    /// Each column block of the operator down to its diagonal block.
    fn new(operator: &[Mat<f64>]) -> Result<Self, ModesError> {
        let size = operator.iter().map(Mat::ncols).sum();
        let mut upper = Mat::<f64>::zeros(size, size);
        let mut from = 0;
        for block in operator {
            upper.as_mut().submatrix_mut(0, from, block.nrows(), block.ncols()).copy_from(block);
            from += block.ncols();
        }
        let eigen = upper.self_adjoint_eigen(Side::Upper).map_err(|_| ModesError::NotFinite)?;
        let values = eigen.S().column_vector().iter().rev().copied().collect();
        let vectors = eigen.U().reverse_cols().to_owned();
        Ok(Self { values, vectors })
    }

    fn vector(&self, k: usize) -> Vec<f64> {
        self.vectors.col(k).iter().copied().collect()
    }

    /// How many of the largest have converged, up to the first that has not. `leads` goes from the last block to the next.
    fn converged(&self, leads: &Mat<f64>) -> usize {
        let left = self.left(leads);
        (0..self.values.len()).take_while(|&k| left.col(k).norm_l2() <= CONVERGED * self.values[k]).count()
    }

    /// How much is left of the largest value, as a share of it.
    fn left_of_first(&self, leads: &Mat<f64>) -> f64 {
        self.left(leads).col(0).norm_l2() / self.values[0]
    }

    fn left(&self, leads: &Mat<f64>) -> Mat<f64> {
        let width = leads.ncols();
        let last: MatRef<f64> = self.vectors.as_ref().subrows(self.values.len() - width, width);
        leads * last
    }
}

/// The same numbers at every run (Marsaglia's xorshift, 2003).
struct Random(u64);

impl Random {
    /// From -1 to 1.
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        #[allow(clippy::cast_precision_loss, reason = "53 bits are what a number holds")]
        let share = (self.0 >> 11) as f64 / (1_u64 << 53) as f64;
        2.0 * share - 1.0
    }
}
