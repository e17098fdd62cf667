//! How the parts of a frame can move without bending.

use nalgebra::{Matrix6, SMatrix, SymmetricEigen, Vector3, Vector6};

use super::mass::Mass;
use crate::assembly::Assembly;
use crate::equations::NONE;
use crate::member_set::MemberSet;
use crate::parts::Parts;

/// A motion against which supports do less than this share of what they do against the one that they hold best is free.
const FREE: f64 = 1e-12;

/// A basis of the rigid motions that supports leave, over the equations, each of modal mass 1 and orthogonal to the others.
pub(super) fn motions(assembly: &Assembly, members: &MemberSet, mass: &Mass) -> Vec<Vec<f64>> {
    let mut parts = Parts::new(assembly, members);
    let touched = assembly.touched(members);
    let mut nodes_of = std::collections::BTreeMap::<usize, Vec<usize>>::new();
    for node in (0..touched.len()).filter(|&node| touched[node]) {
        nodes_of.entry(parts.root(node)).or_default().push(node);
    }
    let mut motions: Vec<Vec<f64>> = Vec::new();
    for nodes in nodes_of.values() {
        let first = motions.len();
        for motion in free_motions(assembly, nodes) {
            let mut vector = motion;
            // Twice is enough (Parlett): the second pass takes away what rounding has left.
            for _ in 0..2 {
                for before in &motions[first..] {
                    let share = dot(before, &mass.times(&vector));
                    vector.iter_mut().zip(before).for_each(|(value, other)| *value -= share * other);
                }
            }
            let norm = dot(&vector, &mass.times(&vector)).sqrt();
            for value in &mut vector {
                *value /= norm;
            }
            motions.push(vector);
        }
    }
    motions
}

fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}

/// The motions of a part that move none of what is held, over the equations.
fn free_motions(assembly: &Assembly, nodes: &[usize]) -> Vec<Vec<f64>> {
    let model = assembly.model();
    #[allow(clippy::cast_precision_loss, reason = "nodes are fewer than 2⁵²")]
    let centre =
        nodes.iter().map(|&node| model.nodes[node].coords).sum::<Vector3<f64>>() / nodes.len() as f64;
    let unit = assembly.rotation_unit;
    // What the six motions do at a node, each as large as the others.
    let at = |node: usize| {
        let arm = (model.nodes[node].coords - centre) / unit;
        let mut moved = Matrix6::identity();
        let turned: SMatrix<f64, 3, 3> = -arm.cross_matrix();
        moved.fixed_view_mut::<3, 3>(0, 3).copy_from(&turned);
        moved
    };
    let mut held = Matrix6::zeros();
    for &node in nodes {
        let moved = at(node);
        for axis in (0..6).filter(|&axis| assembly.equations.of_node[node][axis] == NONE) {
            held += moved.row(axis).transpose() * moved.row(axis);
        }
    }
    let eigen = SymmetricEigen::new(held);
    let most = eigen.eigenvalues.max();
    let free = (0..6).filter(|&k| most <= 0.0 || eigen.eigenvalues[k] < FREE * most);
    let vector = |motion: Vector6<f64>| {
        let mut vector = vec![0.0; assembly.equations.len()];
        for &node in nodes {
            let moved = at(node) * motion;
            for (axis, &equation) in assembly.equations.of_node[node].iter().enumerate() {
                if equation != NONE {
                    vector[equation] = moved[axis];
                }
            }
        }
        vector
    };
    free.map(|k| vector(eigen.eigenvectors.column(k).into_owned())).collect()
}
