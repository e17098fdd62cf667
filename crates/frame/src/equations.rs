//! The equations of a model: their order, and where each number of a member goes in the matrix.
//!
//! Nodes are put in an order of approximate minimum degree, their free degrees of freedom behind each other. The pattern is
//! that of the whole model; members that are not there leave zeros in it, so that it is analysed once.

use faer::Side;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::linalg::amd;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholesky, SymmetricOrdering, factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMat, SymbolicSparseColMatRef};

use crate::element::Matrix12;
use crate::model::Model;

/// No equation, no place in the matrix.
pub(crate) const NONE: usize = usize::MAX;

/// A degree of freedom of a node.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Freedom {
    pub node: usize,
    pub axis: usize,
}

pub(crate) struct Equations {
    /// Of each node, the equation of each degree of freedom; [`NONE`] where it is held.
    pub of_node: Vec<[usize; 6]>,
    /// Of each equation, what it belongs to.
    pub freedoms: Vec<Freedom>,
    pattern: SymbolicSparseColMat<usize>,
    /// Of each member, where the lower half of its matrix goes, row by row.
    places: Vec<[usize; 78]>,
    pub symbolic: SymbolicCholesky<usize>,
}

impl Equations {
    /// The equations of a model that was checked; `None` when they are more than memory holds.
    pub fn new(model: &Model) -> Option<Self> {
        let held = held(model);
        let joined = neighbours(model, &held);
        let order = order(&joined)?;
        let mut rank = vec![0; order.len()];
        for (place, &node) in order.iter().enumerate() {
            rank[node] = place;
        }
        let mut of_node = vec![[NONE; 6]; model.nodes.len()];
        let mut freedoms = Vec::new();
        for &node in &order {
            for axis in (0..6).filter(|&axis| !held[node][axis]) {
                of_node[node][axis] = freedoms.len();
                freedoms.push(Freedom { node, axis });
            }
        }
        let blocks = Blocks::new(&joined, rank, &of_node);
        let pattern = blocks.pattern(&freedoms);
        let places = model.members.iter().map(|member| {
            let mut equations = [NONE; 12];
            equations[..6].copy_from_slice(&of_node[member.a.0]);
            equations[6..].copy_from_slice(&of_node[member.b.0]);
            blocks.places(&equations, &freedoms, pattern.col_ptr())
        });
        let places = places.collect();
        // In the order as it is faer wants the upper half here, and takes the lower one for the numbers.
        let upper = pattern.as_ref().transpose().to_col_major().ok()?;
        let symbolic = factorize_symbolic_cholesky(
            upper.as_ref(),
            Side::Upper,
            SymmetricOrdering::Identity,
            CholeskySymbolicParams::default(),
        )
        .ok()?;
        Some(Self { of_node, freedoms, pattern, places, symbolic })
    }

    /// How many.
    pub fn len(&self) -> usize {
        self.freedoms.len()
    }

    /// How many numbers the lower half of the matrix has.
    pub fn numbers(&self) -> usize {
        self.pattern.row_idx().len()
    }

    /// Adds the matrix of a member to the numbers.
    pub fn add(&self, numbers: &mut [f64], member: usize, matrix: &Matrix12) {
        let mut places = self.places[member].iter();
        for row in 0..12 {
            for column in 0..=row {
                if let Some(&place) = places.next()
                    && place != NONE
                {
                    numbers[place] += matrix[(row, column)];
                }
            }
        }
    }

    /// Where the diagonal of an equation is among the numbers.
    pub fn diagonal(&self, equation: usize) -> usize {
        self.pattern.col_ptr()[equation]
    }

    /// The lower half of the matrix with these numbers.
    pub fn matrix<'a>(&'a self, numbers: &'a [f64]) -> SparseColMatRef<'a, usize, f64> {
        SparseColMatRef::new(self.pattern.as_ref(), numbers)
    }

    /// K X for the lower half of K with these numbers, several columns beside each other.
    pub fn product<const N: usize>(&self, numbers: &[f64], x: &[[f64; N]]) -> Vec<[f64; N]> {
        let (starts, rows) = (self.pattern.col_ptr(), self.pattern.row_idx());
        let mut product = vec![[0.0; N]; self.len()];
        for column in 0..self.len() {
            let own = x[column];
            let mut sum = [0.0; N];
            let below = starts[column] + 1..starts[column + 1];
            for (&value, &row) in numbers[below.clone()].iter().zip(&rows[below]) {
                let (other, into) = (&x[row], &mut product[row]);
                for k in 0..N {
                    sum[k] += value * other[k];
                    into[k] += value * own[k];
                }
            }
            let diagonal = numbers[starts[column]];
            for k in 0..N {
                product[column][k] += sum[k] + diagonal * own[k];
            }
        }
        product
    }
}

/// Of each node, which degrees of freedom are held.
fn held(model: &Model) -> Vec<[bool; 6]> {
    let mut held = vec![[false; 6]; model.nodes.len()];
    for support in &model.supports {
        for (held, fixed) in held[support.node.0].iter_mut().zip(support.fixed) {
            *held |= fixed;
        }
    }
    held
}

/// Of each node that is not held altogether, those others that a member joins it to.
fn neighbours(model: &Model, held: &[[bool; 6]]) -> Vec<Vec<usize>> {
    let mut joined = vec![Vec::new(); model.nodes.len()];
    let free = |node: usize| held[node] != [true; 6];
    for member in &model.members {
        let (a, b) = (member.a.0, member.b.0);
        if free(a) && free(b) {
            joined[a].push(b);
            joined[b].push(a);
        }
    }
    for of_node in &mut joined {
        of_node.sort_unstable();
        of_node.dedup();
    }
    joined
}

/// The nodes in an order of approximate minimum degree (Amestoy, Davis, Duff 1996): fewest further numbers in the factor.
fn order(joined: &[Vec<usize>]) -> Option<Vec<usize>> {
    let mut starts = vec![0];
    let mut rows = Vec::new();
    for of_node in joined {
        rows.extend_from_slice(of_node);
        starts.push(rows.len());
    }
    let n = joined.len();
    let pattern = SymbolicSparseColMatRef::new_checked(n, n, &starts, None, &rows);
    let (mut order, mut rank) = (vec![0_usize; n], vec![0_usize; n]);
    let mut memory = MemBuffer::try_new(amd::order_scratch::<usize>(n, rows.len())).ok()?;
    amd::order(&mut order, &mut rank, pattern, amd::Control::default(), MemStack::new(&mut memory)).ok()?;
    Some(order)
}

/// The matrix by blocks of nodes: below the block of a node, those of its neighbours that come later.
struct Blocks {
    /// Of each node: its later neighbours by rising rank, with how many rows lie between their block and that of the node.
    later: Vec<Vec<(usize, usize)>>,
    /// Of each node, how many rows its later neighbours have.
    rows_below: Vec<usize>,
    /// Of each node, its first equation and how many it has.
    own: Vec<(usize, usize)>,
    rank: Vec<usize>,
}

impl Blocks {
    fn new(joined: &[Vec<usize>], rank: Vec<usize>, of_node: &[[usize; 6]]) -> Self {
        let own: Vec<(usize, usize)> = of_node.iter().map(own).collect();
        let mut rows_below = vec![0; joined.len()];
        let mut later = Vec::with_capacity(joined.len());
        for (node, others) in joined.iter().enumerate() {
            let mut after: Vec<(usize, usize)> =
                others.iter().filter(|&&other| rank[other] > rank[node]).map(|&other| (other, 0)).collect();
            after.sort_unstable_by_key(|&(other, _)| rank[other]);
            for (other, offset) in &mut after {
                *offset = rows_below[node];
                rows_below[node] += own[*other].1;
            }
            later.push(after);
        }
        Self { later, rows_below, own, rank }
    }

    /// The pattern of the lower half.
    fn pattern(&self, freedoms: &[Freedom]) -> SymbolicSparseColMat<usize> {
        let mut starts = vec![0];
        let mut rows = Vec::new();
        for (equation, freedom) in freedoms.iter().enumerate() {
            let (first, count) = self.own[freedom.node];
            rows.extend(equation..first + count);
            for &(other, _) in &self.later[freedom.node] {
                let (first, count) = self.own[other];
                rows.extend(first..first + count);
            }
            starts.push(rows.len());
        }
        SymbolicSparseColMat::new_checked(freedoms.len(), freedoms.len(), starts, None, rows)
    }

    /// Where the lower half of a member's matrix goes, by the equations of its ends.
    fn places(&self, equations: &[usize; 12], freedoms: &[Freedom], starts: &[usize]) -> [usize; 78] {
        let mut places = [NONE; 78];
        let mut next = places.iter_mut();
        for row in 0..12 {
            for column in 0..=row {
                let (p, q) = (equations[row], equations[column]);
                if let Some(place) = next.next()
                    && p != NONE
                    && q != NONE
                {
                    *place = self.place(p.max(q), p.min(q), freedoms, starts);
                }
            }
        }
        places
    }

    fn place(&self, row: usize, column: usize, freedoms: &[Freedom], starts: &[usize]) -> usize {
        let (over, under) = (freedoms[column].node, freedoms[row].node);
        if over == under {
            return starts[column] + row - column;
        }
        let later = &self.later[over];
        // Neighbours have each other; the member that asks makes them so.
        let offset = later
            .binary_search_by_key(&self.rank[under], |&(other, _)| self.rank[other])
            .map_or(0, |found| later[found].1);
        let end_of_own = starts[column + 1] - self.rows_below[over];
        end_of_own + offset + row - self.own[under].0
    }
}

/// The first equation of a node and how many it has.
fn own(equations: &[usize; 6]) -> (usize, usize) {
    let free = equations.iter().filter(|&&equation| equation != NONE);
    (free.clone().min().copied().unwrap_or(0), free.count())
}
