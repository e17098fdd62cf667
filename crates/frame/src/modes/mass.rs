//! The mass of some members as a matrix.

use crate::assembly::Assembly;
use crate::equations::{Equations, NONE};
use crate::load::NodeMass;
use crate::member_set::MemberSet;

/// So many columns are multiplied, and solved for, at once: the matrix, which is larger than they are, is read but once for them.
pub(super) const TOGETHER: usize = 4;

/// The consistent mass of some members, and masses at nodes. Nodes that no member touches have none.
pub(super) struct Mass<'a> {
    equations: &'a Equations,
    pub numbers: Vec<f64>,
}

impl<'a> Mass<'a> {
    pub fn new(assembly: &'a Assembly, members: &MemberSet, masses: &[NodeMass]) -> Self {
        let equations = &assembly.equations;
        let mut numbers = vec![0.0; equations.numbers()];
        for member in members.iter() {
            let element = &assembly.elements[member.0];
            let matrix = element.mass(assembly.section(member), assembly.rotation_unit);
            equations.add(&mut numbers, member.0, &matrix);
        }
        let touched = assembly.touched(members);
        for of in masses.iter().filter(|of| touched[of.node.0]) {
            let along = &equations.of_node[of.node.0][..3];
            for &equation in along.iter().filter(|&&equation| equation != NONE) {
                numbers[equations.diagonal(equation)] += of.mass;
            }
        }
        Self { equations, numbers }
    }

    /// How many rows it has.
    pub fn rows(&self) -> usize {
        self.equations.len()
    }

    /// M times columns that follow each other.
    pub fn times(&self, columns: &[f64]) -> Vec<f64> {
        let rows = self.rows();
        let mut product = vec![0.0; columns.len()];
        for (x, into) in columns.chunks(rows * TOGETHER).zip(product.chunks_mut(rows * TOGETHER)) {
            let mut beside = vec![[0.0; TOGETHER]; rows];
            for (k, column) in x.chunks(rows).enumerate() {
                beside.iter_mut().zip(column).for_each(|(beside, value)| beside[k] = *value);
            }
            let sums = self.equations.product(&self.numbers, &beside);
            for (k, column) in into.chunks_mut(rows).enumerate() {
                column.iter_mut().zip(&sums).for_each(|(value, sums)| *value = sums[k]);
            }
        }
        product
    }
}
