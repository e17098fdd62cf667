//! A frame whose stiffness is factored: ready for any number of loads.

use crate::arc::EndStiffness;
use crate::assembly::Assembly;
use crate::equations::{Equations, NONE};
use crate::error::{SolveError, Unstable};
use crate::load::Load;
use crate::loads::Acting;
use crate::lower::Lower;
use crate::member_set::MemberSet;
use crate::model::NodeId;
use crate::parts;
use crate::response::{self, Response};

/// A pivot that is smaller than this share of its diagonal is rounding: the frame has no stiffness there. A chain of n struts
/// has pivots down to 1/n³ of slenderness 1/(L/d)².
const NO_STIFFNESS: f64 = 1e-13;

/// So many sizes of the model a node may move; more is a frame that hardly stands.
const TOO_FAR: f64 = 10.0;

/// So many right sides are solved together.
const TOGETHER: usize = 32;

/// The factored stiffness of some members of an assembly.
pub struct Factor<'a> {
    assembly: &'a Assembly,
    members: MemberSet,
    touched: Vec<bool>,
    /// The lower half of the stiffness.
    numbers: Vec<f64>,
    lower: Lower,
}

impl Assembly {
    /// Factors the stiffness of some of the members. Nodes that none of them touches take no part.
    ///
    /// # Errors
    /// A part that nothing holds, or that can move without bending anything.
    pub fn factor(&self, members: &MemberSet) -> Result<Factor<'_>, Unstable> {
        Factor::new(self, members, None)
    }

    /// The same with stiffnesses of the members' own, such as those of [`Arc`](crate::Arc)s, in the order of the model's members. A
    /// member without one has that of a straight beam. [`Factor::displacements`] is right for them; [`Factor::solve`] takes
    /// all members to be straight.
    ///
    /// # Errors
    /// A part that nothing holds, or that can move without bending anything.
    pub fn factor_with(
        &self,
        members: &MemberSet,
        stiffness: &[EndStiffness],
    ) -> Result<Factor<'_>, Unstable> {
        Factor::new(self, members, Some(stiffness))
    }
}

impl<'a> Factor<'a> {
    fn new(
        assembly: &'a Assembly,
        members: &MemberSet,
        own: Option<&[EndStiffness]>,
    ) -> Result<Self, Unstable> {
        parts::check(assembly, members)?;
        let equations = &assembly.equations;
        let touched = assembly.touched(members);
        let numbers = stiffness(assembly, members, &touched, own.unwrap_or_default());
        let mechanism = |equation: usize| {
            let node = equations.freedoms.get(equation).map_or(0, |freedom| freedom.node);
            Unstable::Mechanism { node: NodeId(node) }
        };
        let lower = Lower::new(equations, &numbers).map_err(mechanism)?;
        for equation in 0..equations.len() {
            let pivot = lower.diagonal(&equations.symbolic, equation).powi(2);
            if pivot.is_nan() || pivot <= NO_STIFFNESS * numbers[equations.diagonal(equation)] {
                return Err(mechanism(equation));
            }
        }
        Ok(Self { assembly, members: members.clone(), touched, numbers, lower })
    }

    /// The members that are there.
    #[must_use]
    pub fn members(&self) -> &MemberSet {
        &self.members
    }

    /// The assembly that it is a part of.
    #[must_use]
    pub fn assembly(&self) -> &'a Assembly {
        self.assembly
    }

    /// What the frame does under a load.
    ///
    /// # Errors
    /// A load on a member or node that is not there; a displacement beyond ten times the size of the model.
    pub fn solve(&self, load: &Load) -> Result<Response, SolveError> {
        let acting = Acting::new(self.assembly, &self.members, load)?;
        let forces = acting.nodal_forces(self.assembly, &self.members);
        let displacements = self.displacements(std::slice::from_ref(&forces)).swap_remove(0);
        let response = response::of(self.assembly, &self.members, &acting, &forces, displacements);
        let (node, displacement_mm) = response.max_displacement();
        let size_mm = self.assembly.size();
        let finite = response.displacements.iter().flatten().all(|value| value.is_finite());
        if !finite {
            return Err(Unstable::TooSoft { node, displacement_mm: f64::INFINITY, size_mm }.into());
        }
        if displacement_mm > TOO_FAR * size_mm {
            return Err(Unstable::TooSoft { node, displacement_mm, size_mm }.into());
        }
        Ok(response)
    }

    /// Displacements alone, for many cases of forces and moments at nodes at once: `forces[case][node]`, in the model's axes.
    /// What acts at a node that is held or not there is left out. Nothing is checked.
    #[must_use]
    pub fn displacements(&self, forces: &[Vec<[f64; 6]>]) -> Vec<Vec<[f64; 6]>> {
        let mut displacements = Vec::with_capacity(forces.len());
        for cases in forces.chunks(TOGETHER) {
            self.solve_together(cases, &mut displacements);
        }
        displacements
    }

    /// The rows of K⁻¹ of a node at some nodes, in the model's axes, each node six figures; not refined.
    pub(crate) fn inverse_rows(&self, node: usize, at: &[usize]) -> Vec<f64> {
        let equations = &self.assembly.equations;
        let n = equations.len();
        let unit = |axis: usize| if axis < 3 { 1.0 } else { self.assembly.rotation_unit };
        let mut columns = vec![0.0; 6 * n];
        for axis in 0..6 {
            let equation = equations.of_node[node][axis];
            if equation != NONE {
                columns[axis * n + equation] = 1.0 / unit(axis);
            }
        }
        self.lower.solver(&equations.symbolic, 6).solve(&mut columns);
        let mut rows = Vec::with_capacity(36 * at.len());
        for column in columns.chunks(n.max(1)) {
            for &node in at {
                let of_node = equations.of_node[node].iter().enumerate();
                rows.extend(of_node.map(|(axis, &k)| if k == NONE { 0.0 } else { column[k] / unit(axis) }));
            }
        }
        rows
    }

    fn solve_together(&self, cases: &[Vec<[f64; 6]>], into: &mut Vec<Vec<[f64; 6]>>) {
        let equations = &self.assembly.equations;
        let n = equations.len();
        let mut right = vec![0.0; n * cases.len()];
        for (column, forces) in right.chunks_mut(n.max(1)).zip(cases) {
            self.gather(forces, column);
        }
        let mut solution = right.clone();
        let mut solver = self.lower.solver(&equations.symbolic, cases.len());
        solver.solve(&mut solution);
        // One step of refinement, with what the solution leaves of the right side.
        for (x, rest) in solution.chunks(n.max(1)).zip(right.chunks_mut(n.max(1))) {
            let beside: Vec<[f64; 1]> = x.iter().map(|&value| [value]).collect();
            let product = equations.product(&self.numbers, &beside);
            rest.iter_mut().zip(product).for_each(|(rest, [value])| *rest -= value);
        }
        solver.solve(&mut right);
        for (k, _) in cases.iter().enumerate() {
            let part = k * n..(k + 1) * n;
            let column = solution[part.clone()].iter().zip(&right[part]).map(|(x, more)| x + more);
            into.push(self.scatter(column));
        }
    }

    /// The right side of forces at nodes.
    fn gather(&self, forces: &[[f64; 6]], column: &mut [f64]) {
        let unit = self.assembly.rotation_unit;
        for (value, freedom) in column.iter_mut().zip(&self.assembly.equations.freedoms) {
            if self.touched[freedom.node] {
                let force = forces[freedom.node][freedom.axis];
                *value = if freedom.axis < 3 { force } else { force / unit };
            }
        }
    }

    /// The displacements of nodes of a solution.
    fn scatter(&self, column: impl Iterator<Item = f64>) -> Vec<[f64; 6]> {
        let unit = self.assembly.rotation_unit;
        let mut displacements = vec![[0.0; 6]; self.assembly.model().nodes.len()];
        for (value, freedom) in column.zip(&self.assembly.equations.freedoms) {
            if self.touched[freedom.node] {
                displacements[freedom.node][freedom.axis] =
                    if freedom.axis < 3 { value } else { value / unit };
            }
        }
        displacements
    }
}

/// The lower half of the stiffness of some members, `own` where they have one. Nodes that none touches have a diagonal of its
/// mean.
fn stiffness(assembly: &Assembly, members: &MemberSet, touched: &[bool], own: &[EndStiffness]) -> Vec<f64> {
    let equations = &assembly.equations;
    let mut numbers = vec![0.0; equations.numbers()];
    for member in members.iter() {
        let unit = assembly.rotation_unit;
        let matrix = match own.get(member.0) {
            Some(own) => with_rotations_in(unit, own),
            None => assembly.elements[member.0].stiffness(unit),
        };
        equations.add(&mut numbers, member.0, &matrix);
    }
    fill_untouched(equations, &mut numbers, touched);
    numbers
}

/// A stiffness with rotations measured as `unit` times the angle.
fn with_rotations_in(unit: f64, stiffness: &EndStiffness) -> EndStiffness {
    let scale = |k: usize| if k % 6 < 3 { 1.0 } else { 1.0 / unit };
    EndStiffness::from_fn(|row, column| stiffness[(row, column)] * scale(row) * scale(column))
}

/// Gives nodes that no member touches a diagonal as large as the mean of the others.
pub(crate) fn fill_untouched(equations: &Equations, numbers: &mut [f64], touched: &[bool]) {
    let own = |equation: usize| touched[equations.freedoms[equation].node];
    let (mut sum, mut count) = (0.0, 0.0);
    for equation in (0..equations.len()).filter(|&equation| own(equation)) {
        sum += numbers[equations.diagonal(equation)];
        count += 1.0;
    }
    let mean = if count > 0.0 && sum > 0.0 { sum / count } else { 1.0 };
    for equation in (0..equations.len()).filter(|&equation| !own(equation)) {
        numbers[equations.diagonal(equation)] = mean;
    }
}
