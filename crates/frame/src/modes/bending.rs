//! The lowest modes that bend something: first about where they are, then what they are.
//!
//! K + σ M with σ above zero is positive definite even for a frame that floats, but far from the modes, which crowd there: from near
//! them they are told apart with a third of the work. What the first search says of the lowest mode is no less than it is, and
//! whether a shift is below all modes, the signs of the pivots of K - μ M prove: there are as many below zero as rigid motions.

use std::f64::consts::TAU;

use super::lanczos::{self, Found, Goal};
use super::mass::Mass;
use super::{ModeSearch, shape, twice_energy};
use crate::assembly::Assembly;
use crate::error::ModesError;
use crate::factor::fill_untouched;
use crate::lower::Lower;
use crate::member_set::MemberSet;

/// The first search ends when the value of the lowest mode is known within this share.
const NEAR: f64 = 0.05;

/// Shifts that are tried, as shares of the lowest frequency so far.
const SHARES: [f64; 3] = [0.9, 0.75, 0.5];

/// What the second search says of a mode and what bends in it agree within this share, unless pivots were bad.
const SAME: f64 = 1e-6;

/// The vectors of the lowest modes that bend something, lowest first.
pub(super) fn find(
    assembly: &Assembly,
    members: &MemberSet,
    search: &ModeSearch,
    mass: &Mass,
    rigid: &[Vec<f64>],
) -> Result<Vec<Vec<f64>>, ModesError> {
    let equations = &assembly.equations;
    let touched = assembly.touched(members);
    let free = equations.freedoms.iter().filter(|freedom| touched[freedom.node]).count();
    let wanted = search.count.min(free - rigid.len());
    let mut stiffness = vec![0.0; equations.numbers()];
    for member in members.iter() {
        let matrix = assembly.elements[member.0].stiffness(assembly.rotation_unit);
        equations.add(&mut stiffness, member.0, &matrix);
    }
    let shifted = |squared: f64| {
        let mut numbers: Vec<f64> =
            stiffness.iter().zip(&mass.numbers).map(|(k, m)| k - squared * m).collect();
        fill_untouched(equations, &mut numbers, &touched);
        numbers
    };

    let begin = -(TAU * search.shift_hz).powi(2);
    let goal = Goal { mass, rigid, free, wanted, near: NEAR };
    let lower = Lower::new(equations, &shifted(begin))
        .map_err(|_| ModesError::Shift { shift_hz: search.shift_hz })?;
    let mut solver = lower.solver(&equations.symbolic, lanczos::BLOCK);
    let value = match lanczos::lowest(&goal, &mut solver)? {
        Found::Modes(modes) => return Ok(vectors(modes)),
        Found::Near(value) => value,
    };
    let goal = Goal { near: 0.0, ..goal };
    let is_mode = |squared: f64, vector: &[f64]| {
        let bent = twice_energy(assembly, members, &shape(assembly, vector));
        (bent / squared - 1.0).abs() < SAME
    };
    for share in SHARES {
        let squared = share * share * (begin + 1.0 / value);
        let Some((lower, below)) = Lower::indefinite(equations, &shifted(squared)) else { continue };
        if squared > 0.0 && below == rigid.len() {
            let mut solver = lower.solver(&equations.symbolic, lanczos::BLOCK);
            if let Ok(Found::Modes(modes)) = lanczos::lowest(&goal, &mut solver)
                && modes.iter().all(|mode| is_mode(squared + 1.0 / mode.0, &mode.1))
            {
                return Ok(vectors(modes));
            }
        }
    }
    // Without a better shift all is found from where the search began.
    match lanczos::lowest(&goal, &mut solver)? {
        Found::Modes(modes) => Ok(vectors(modes)),
        Found::Near(_) => Err(ModesError::NotConverged { found: 0, wanted, vectors: 0 }),
    }
}

fn vectors(modes: Vec<(f64, Vec<f64>)>) -> Vec<Vec<f64>> {
    modes.into_iter().map(|(_, vector)| vector).collect()
}
