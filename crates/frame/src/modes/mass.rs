//! The mass of some members as a matrix.

use crate::assembly::Assembly;
use crate::equations::Equations;
use crate::member_set::MemberSet;

/// The consistent mass of some members. Nodes that none touches have none.
pub(super) struct Mass<'a> {
    equations: &'a Equations,
    pub numbers: Vec<f64>,
}

impl<'a> Mass<'a> {
    pub fn new(assembly: &'a Assembly, members: &MemberSet) -> Self {
        let equations = &assembly.equations;
        let mut numbers = vec![0.0; equations.numbers()];
        for member in members.iter() {
            let element = &assembly.elements[member.0];
            let matrix = element.mass(assembly.section(member), assembly.rotation_unit);
            equations.add(&mut numbers, member.0, &matrix);
        }
        Self { equations, numbers }
    }

    /// How many rows it has.
    pub fn rows(&self) -> usize {
        self.equations.len()
    }

    /// M times columns that follow each other.
    pub fn times(&self, columns: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; columns.len()];
        let rows = self.rows();
        for (x, into) in columns.chunks(rows).zip(product.chunks_mut(rows)) {
            self.equations.subtract_product(&self.numbers, x, into);
        }
        for value in &mut product {
            *value = -*value;
        }
        product
    }
}
