//! The flexibility of what stands: as a matrix, or as a factored stiffness.

use std::borrow::Cow;

use nalgebra::{Cholesky, Matrix6, Vector6};

use super::strut::{Place, Strut};
use crate::assembly::Assembly;
use crate::element::Vector12;
use crate::equations::NONE;
use crate::error::Unstable;
use crate::factor::Factor;
use crate::member_set::MemberSet;

/// A strut is not taken out of F when less than this share of F is left of the difference that decides: F is good to about twelve
/// digits, and five are wanted.
const LEFT: f64 = 1e-7;

/// F = K⁻¹ of the nodes that move: those that members that stand touch and that are not held altogether.
pub(super) struct Store<'a> {
    /// The nodes of F, in its order.
    nodes: Vec<usize>,
    /// Of each node of the model, its place among them.
    slot: Vec<usize>,
    matrix: Matrix<'a>,
}

enum Matrix<'a> {
    /// F, row by row, six to a node.
    Dense(Vec<f64>),
    /// Nothing stands, or the stiffness of what does.
    Factored(Option<Factor<'a>>),
}

impl<'a> Store<'a> {
    pub fn new(nodes: usize, dense: bool) -> Self {
        let matrix = if dense { Matrix::Dense(Vec::new()) } else { Matrix::Factored(None) };
        Self { nodes: Vec::new(), slot: vec![NONE; nodes], matrix }
    }

    pub fn is_dense(&self) -> bool {
        matches!(self.matrix, Matrix::Dense(_))
    }

    fn width(&self) -> usize {
        6 * self.nodes.len()
    }

    /// F of some members. Nothing is changed when they do not stand.
    pub fn fill(&mut self, assembly: &'a Assembly, members: &MemberSet) -> Result<(), Unstable> {
        let factor = if members.is_empty() { None } else { Some(assembly.factor(members)?) };
        let touched = assembly.touched(members);
        let moves = |node: &usize| touched[*node] && assembly.equations.of_node[*node] != [NONE; 6];
        self.nodes = (0..touched.len()).filter(moves).collect();
        self.slot.fill(NONE);
        for (slot, &node) in self.nodes.iter().enumerate() {
            self.slot[node] = slot;
        }
        match &mut self.matrix {
            Matrix::Factored(kept) => *kept = factor,
            Matrix::Dense(dense) => {
                dense.clear();
                if let Some(factor) = &factor {
                    for &node in &self.nodes {
                        dense.extend(factor.inverse_rows(node, &self.nodes));
                    }
                }
            }
        }
        Ok(())
    }

    /// The rows of F of a node; `None` of a node that does not move.
    fn rows(&self, node: usize) -> Option<Cow<'_, [f64]>> {
        let slot = self.slot[node];
        if slot == NONE {
            return None;
        }
        match &self.matrix {
            Matrix::Dense(dense) => {
                let length = 6 * self.width();
                Some(Cow::Borrowed(&dense[slot * length..(slot + 1) * length]))
            }
            Matrix::Factored(factor) => {
                factor.as_ref().map(|factor| Cow::Owned(factor.inverse_rows(node, &self.nodes)))
            }
        }
    }

    /// Six columns of some rows of F.
    fn block(&self, rows: Option<&[f64]>, node: usize) -> Matrix6<f64> {
        let slot = self.slot[node];
        match rows {
            Some(rows) if slot != NONE => {
                Matrix6::from_fn(|row, column| rows[row * self.width() + 6 * slot + column])
            }
            _ => Matrix6::zeros(),
        }
    }

    /// All displacements under forces at nodes.
    pub fn under(&self, forces: &[[f64; 6]]) -> Vec<[f64; 6]> {
        match &self.matrix {
            Matrix::Factored(Some(factor)) => factor.displacements(&[forces.to_vec()]).swap_remove(0),
            Matrix::Factored(None) => vec![[0.0; 6]; forces.len()],
            Matrix::Dense(_) => {
                let mut displacements = vec![[0.0; 6]; forces.len()];
                for &node in &self.nodes {
                    self.act(node, &Vector6::from(forces[node]), &mut displacements);
                }
                displacements
            }
        }
    }

    /// Adds what a force and moment at a node do.
    pub fn act(&self, node: usize, force: &Vector6<f64>, displacements: &mut [[f64; 6]]) {
        if let Matrix::Factored(Some(factor)) = &self.matrix {
            // One right side instead of six rows.
            let mut forces = vec![[0.0; 6]; displacements.len()];
            forces[node] = (*force).into();
            let more = factor.displacements(&[forces]).swap_remove(0);
            displacements
                .iter_mut()
                .flatten()
                .zip(more.iter().flatten())
                .for_each(|(sum, more)| *sum += more);
        } else if let Some(rows) = self.rows(node) {
            self.add_rows(&rows, force, displacements);
        }
    }

    fn add_rows(&self, rows: &[f64], force: &Vector6<f64>, displacements: &mut [[f64; 6]]) {
        let mut sum = vec![0.0; self.width()];
        for (row, share) in rows.chunks(self.width()).zip(force.iter()) {
            sum.iter_mut().zip(row).for_each(|(sum, value)| *sum += share * value);
        }
        for (&node, moved) in self.nodes.iter().zip(sum.chunks(6)) {
            displacements[node].iter_mut().zip(moved).for_each(|(u, more)| *u += more);
        }
    }

    /// Adds what a strut between two nodes of what stands does: its weight, then its stiffness.
    pub fn join(&self, strut: &Strut, displacements: &mut [[f64; 6]]) {
        let (base, tip) = (self.rows(strut.base), self.rows(strut.tip));
        let spans = self.spans(strut, base.as_deref(), tip.as_deref());
        let weight = strut.weight;
        let apart = spans.apart(strut, displacements, &weight);
        let gives = strut.gives + spans.deformed;
        // C is positive and F not negative, so that there always is a solution.
        let force = gives.cholesky().map_or_else(|| Vector6::repeat(f64::NAN), |factor| factor.solve(&apart));
        let at_base = weight.fixed_rows::<6>(0) + strut.carried_back(&force);
        let at_tip = weight.fixed_rows::<6>(6) - force;
        for (rows, force) in [(base, at_base), (tip, at_tip)] {
            if let Some(rows) = rows {
                self.add_rows(&rows, &force, displacements);
            }
        }
    }

    /// Adds what it does to take such a strut away; `None` where it holds up too much.
    pub fn part(&self, strut: &Strut, displacements: &mut [[f64; 6]]) -> Option<()> {
        let (base, tip) = (self.rows(strut.base), self.rows(strut.tip));
        let spans = self.spans(strut, base.as_deref(), tip.as_deref());
        let weight = -strut.weight;
        let apart = spans.apart(strut, displacements, &weight);
        let force = left(&strut.gives, &spans)?.solve(&apart);
        let at_base = weight.fixed_rows::<6>(0) - strut.carried_back(&force);
        let at_tip = weight.fixed_rows::<6>(6) + force;
        for (rows, force) in [(base, at_base), (tip, at_tip)] {
            if let Some(rows) = rows {
                self.add_rows(&rows, &force, displacements);
            }
        }
        Some(())
    }

    fn spans(&self, strut: &Strut, base: Option<&[f64]>, tip: Option<&[f64]>) -> Spans {
        let base_base = self.block(base, strut.base);
        let base_tip = self.block(base, strut.tip);
        let tip_tip = self.block(tip, strut.tip);
        // G F = [F_t* - H F_b*], G F Gᵀ = that at the tip less that at the base times Hᵀ.
        let at_base = base_tip.transpose() - strut.carried_all(&base_base);
        let at_tip = tip_tip - strut.carried_all(&base_tip);
        let deformed = at_tip - strut.carried_all(&at_base.transpose()).transpose();
        Spans {
            at_base,
            at_tip,
            deformed: (deformed + deformed.transpose()) / 2.0,
            base: base_base,
            tip: tip_tip,
        }
    }

    /// Puts a strut into F.
    pub fn add(&mut self, place: &Place) {
        match place {
            Place::Hangs(strut) => self.hang(strut),
            Place::Joins(strut) => {
                let gives = strut.gives + self.spans_of(strut).deformed;
                if let Some(factor) = gives.cholesky() {
                    self.update(strut, &factor, -1.0);
                }
            }
        }
    }

    /// Takes a strut out of F.
    pub fn remove(&mut self, place: &Place) {
        match place {
            Place::Hangs(strut) => self.drop_node(strut.tip),
            Place::Joins(strut) => {
                if let Some(factor) = left(&strut.gives, &self.spans_of(strut)) {
                    self.update(strut, &factor, 1.0);
                }
            }
        }
    }

    fn spans_of(&self, strut: &Strut) -> Spans {
        let (base, tip) = (self.rows(strut.base), self.rows(strut.tip));
        self.spans(strut, base.as_deref(), tip.as_deref())
    }

    /// F + sign · F Gᵀ S⁻¹ G F, with S factored.
    fn update(&mut self, strut: &Strut, factor: &Cholesky<f64, nalgebra::U6>, sign: f64) {
        let width = self.width();
        let (base, tip) = (self.rows(strut.base), self.rows(strut.tip));
        let at = |rows: &Option<Cow<'_, [f64]>>, column: usize| {
            rows.as_ref()
                .map_or_else(Vector6::zeros, |rows| Vector6::from_fn(|row, _| rows[row * width + column]))
        };
        // L⁻¹ G F by columns; F changes by its square.
        let root = factor.l();
        let halves: Vec<Vector6<f64>> = (0..width)
            .map(|column| {
                let apart = at(&tip, column) - strut.carried(&at(&base, column));
                root.solve_lower_triangular(&apart).unwrap_or(apart)
            })
            .collect();
        drop((base, tip));
        if let Matrix::Dense(dense) = &mut self.matrix {
            for (row, one) in dense.chunks_mut(width.max(1)).zip(&halves) {
                let one = one * sign;
                row.iter_mut().zip(&halves).for_each(|(value, other)| *value += one.dot(other));
            }
        }
    }

    /// Appends the node of a tip that hangs.
    fn hang(&mut self, strut: &Strut) {
        let width = self.width();
        let (base_rows, own) = {
            let rows = self.rows(strut.base);
            let base = self.block(rows.as_deref(), strut.base);
            let own = strut.gives + strut.carried_all(&strut.carried_all(&base).transpose());
            (rows.map_or_else(|| vec![0.0; 6 * width], Cow::into_owned), own)
        };
        let Matrix::Dense(dense) = &mut self.matrix else { return };
        let carried: Vec<Vector6<f64>> = (0..width)
            .map(|column| strut.carried(&Vector6::from_fn(|row, _| base_rows[row * width + column])))
            .collect();
        let wider = width + 6;
        let mut grown = Vec::with_capacity(wider * wider);
        for (row, carried) in dense.chunks(width.max(1)).zip(&carried) {
            grown.extend_from_slice(row);
            grown.extend(carried.iter());
        }
        for row in 0..6 {
            grown.extend(carried.iter().map(|carried| carried[row]));
            grown.extend(own.row(row).iter());
        }
        *dense = grown;
        self.slot[strut.tip] = self.nodes.len();
        self.nodes.push(strut.tip);
    }

    /// Drops a node on which nothing hangs any more.
    fn drop_node(&mut self, node: usize) {
        let (slot, width) = (self.slot[node], self.width());
        if slot == NONE {
            return;
        }
        if let Matrix::Dense(dense) = &mut self.matrix {
            let own = 6 * slot..6 * slot + 6;
            let stays = |place: usize| !own.contains(&(place / width)) && !own.contains(&(place % width));
            let mut place = 0;
            dense.retain(|_| {
                place += 1;
                stays(place - 1)
            });
        }
        self.nodes.remove(slot);
        self.slot[node] = NONE;
        for (slot, &node) in self.nodes.iter().enumerate().skip(slot) {
            self.slot[node] = slot;
        }
    }
}

/// What F makes of the strut's own deformation.
struct Spans {
    /// G F at the base.
    at_base: Matrix6<f64>,
    /// G F at the tip.
    at_tip: Matrix6<f64>,
    /// G F Gᵀ.
    deformed: Matrix6<f64>,
    /// F at the base.
    base: Matrix6<f64>,
    /// F at the tip.
    tip: Matrix6<f64>,
}

impl Spans {
    /// How far the tip is from where the base would carry it, with forces on both added.
    fn apart(&self, strut: &Strut, displacements: &[[f64; 6]], forces: &Vector12) -> Vector6<f64> {
        let (base, tip) = (displacements[strut.base].into(), Vector6::from(displacements[strut.tip]));
        tip - strut.carried(&base)
            + self.at_base * forces.fixed_rows::<6>(0)
            + self.at_tip * forces.fixed_rows::<6>(6)
    }
}

/// C - G F Gᵀ, factored, where rounding leaves enough digits of it.
fn left(gives: &Matrix6<f64>, spans: &Spans) -> Option<Cholesky<f64, nalgebra::U6>> {
    // In units in which C is 1: what is left of it, and how large the figures are of which it is the difference.
    let root = gives.cholesky()?.l();
    let in_units = |matrix: &Matrix6<f64>| {
        let half = root.solve_lower_triangular(matrix)?;
        root.solve_lower_triangular(&half.transpose())
    };
    let rest = gives - spans.deformed;
    let least = in_units(&rest)?.symmetric_eigenvalues().min();
    let large = 1.0 + in_units(&spans.base)?.trace() + in_units(&spans.tip)?.trace();
    if least > LEFT * large { rest.cholesky() } else { None }
}
