//! Directions that are orthogonal in the inner product of the mass.

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatMut, MatRef, Par};

use super::mass::Mass;

/// A direction that is shorter than this share of the longest of its block is rounding.
const DEPENDENT: f64 = 1e-11;

/// A direction of which more than this share of the longest is new has lost few digits. Half of all digits are enough for what is
/// computed with them (Simon 1984), and inner products in the mass lose some more where pieces are short.
const SHORT: f64 = 0.03;

/// Directions of modal mass 1, orthogonal to each other: first the rigid motions, then what was appended.
pub(super) struct Basis<'a> {
    mass: &'a Mass<'a>,
    rows: usize,
    rigid: usize,
    /// Columns behind each other.
    vectors: Vec<f64>,
}

/// Directions orthogonal to a basis and to each other.
pub(super) struct Block {
    vectors: Vec<f64>,
    /// M times each.
    pub mass_vectors: Vec<f64>,
    rows: usize,
    /// How the columns that it is made of lie along the appended part of the basis.
    pub along: Mat<f64>,
    /// How they lie along these directions.
    pub leads: Mat<f64>,
}

impl Block {
    /// How many directions.
    pub fn width(&self) -> usize {
        self.vectors.len() / self.rows
    }

    /// Drops what is more than so many.
    pub fn keep(&mut self, most: usize) {
        let length = self.vectors.len().min(most * self.rows);
        self.vectors.truncate(length);
        self.mass_vectors.truncate(length);
    }
}

impl<'a> Basis<'a> {
    pub fn new(mass: &'a Mass, rigid: &[Vec<f64>]) -> Self {
        Self { mass, rows: mass.rows(), rigid: rigid.len(), vectors: rigid.concat() }
    }

    pub fn mass(&self) -> &Mass<'a> {
        self.mass
    }

    pub fn rows(&self) -> usize {
        self.rows
    }

    /// How many were appended.
    pub fn len(&self) -> usize {
        self.vectors.len() / self.rows - self.rigid
    }

    /// Appends a block.
    pub fn append(&mut self, block: &Block) {
        self.vectors.extend_from_slice(&block.vectors);
    }

    /// A sum of the appended directions.
    pub fn combined(&self, shares: &[f64]) -> Vec<f64> {
        let mut sum = vec![0.0; self.rows];
        for (vector, share) in self.vectors.chunks(self.rows).skip(self.rigid).zip(shares) {
            sum.iter_mut().zip(vector).for_each(|(sum, value)| *sum += share * value);
        }
        sum
    }

    /// The directions of columns that are new. Where little is left of a column, all is done twice: what rounding leaves the first
    /// time is gone then (Parlett).
    pub fn orthogonal(&self, columns: Vec<f64>) -> Block {
        let (once, shortest) = self.once(columns);
        if shortest > SHORT {
            return once;
        }
        let (twice, _) = self.once(once.vectors);
        // c = V a + W l and W = V a' + W' l'.
        let along = once.along + &twice.along * &once.leads;
        let leads = &twice.leads * &once.leads;
        Block { along, leads, ..twice }
    }

    /// Also the share of the longest column that is left of the shortest.
    fn once(&self, mut columns: Vec<f64>) -> (Block, f64) {
        let rows = self.rows;
        let (width, count) = (columns.len() / rows, self.vectors.len() / rows);
        let mut along = Mat::<f64>::zeros(count, width);
        let mass_columns = self.mass.times(&columns);
        product(along.as_mut(), view(&self.vectors, rows).transpose(), view(&mass_columns, rows), 1.0);
        let rest = MatMut::from_column_major_slice_mut(&mut columns, rows, width);
        product(rest, view(&self.vectors, rows), along.as_ref(), -1.0);
        let mass_columns = self.mass.times(&columns);
        let along_appended = along.as_ref().subrows(self.rigid, count - self.rigid).to_owned();
        let mut block = Block {
            vectors: Vec::with_capacity(columns.len()),
            mass_vectors: Vec::with_capacity(columns.len()),
            rows,
            along: along_appended,
            leads: Mat::zeros(width, width),
        };
        let squared = |k: usize| {
            let part = k * rows..(k + 1) * rows;
            along.col(k).squared_norm_l2() + dot(&columns[part.clone()], &mass_columns[part])
        };
        let longest = (0..width).map(squared).fold(0.0, f64::max).sqrt();
        let mut shortest = f64::INFINITY;
        for (k, (column, mass_column)) in columns.chunks(rows).zip(mass_columns.chunks(rows)).enumerate() {
            shortest = shortest.min(block.push(k, column, mass_column, DEPENDENT * longest) / longest);
        }
        block.leads.resize_with(block.width(), width, |_, _| 0.0);
        (block, shortest)
    }
}

impl Block {
    /// Takes away from a column what lies along the directions that are there, and appends the rest if it is long enough. Its
    /// length.
    fn push(&mut self, number: usize, column: &[f64], mass_column: &[f64], shortest: f64) -> f64 {
        let (mut rest, mut mass_rest) = (column.to_vec(), mass_column.to_vec());
        for k in 0..self.width() {
            let part = k * self.rows..(k + 1) * self.rows;
            let share = dot(&rest, &self.mass_vectors[part.clone()]);
            self.leads[(k, number)] = share;
            subtract(&mut rest, share, &self.vectors[part.clone()]);
            subtract(&mut mass_rest, share, &self.mass_vectors[part]);
        }
        let length = dot(&rest, &mass_rest).max(0.0).sqrt();
        if length > shortest {
            let own = self.width();
            self.leads[(own, number)] = length;
            self.vectors.extend(rest.iter().map(|value| value / length));
            self.mass_vectors.extend(mass_rest.iter().map(|value| value / length));
        }
        length
    }
}

fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}

fn subtract(from: &mut [f64], share: f64, other: &[f64]) {
    from.iter_mut().zip(other).for_each(|(value, other)| *value -= share * other);
}

fn view(columns: &[f64], rows: usize) -> MatRef<'_, f64> {
    MatRef::from_column_major_slice(columns, rows, columns.len() / rows)
}

/// `into += factor a b`.
fn product(into: MatMut<f64>, a: MatRef<f64>, b: MatRef<f64>, factor: f64) {
    matmul(into, Accum::Add, a, b, factor, Par::Seq);
}
