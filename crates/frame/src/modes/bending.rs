//! The lowest modes that bend something: first about where they are, then what they are, then whether any was left out.
//!
//! K + σ M with σ above zero is positive definite even for a frame that floats, but far from the modes, which crowd there: from near
//! them they are told apart with a third of the work. What the first search says of the lowest mode is no less than it is, and
//! whether a shift is below all modes, the signs of the pivots of K - μ M prove: there are as many below zero as modes below μ.
//! They prove, too, that no mode was left out, where there are more equal ones than vectors in a block.

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

/// Modes are counted so far below the highest that was found, as shares of ω², and no closer than [`SAME`] to another.
const BELOW: [f64; 3] = [3e-6, 2e-5, 1e-4];

/// Blocks that are tried: where as many modes are equal a smaller one may leave some out.
const BLOCKS: [usize; 4] = [lanczos::BLOCK, 4 * lanczos::BLOCK, 16 * lanczos::BLOCK, 64 * lanczos::BLOCK];

/// A mode that bends something: ω² and its vector.
type Bending = (f64, Vec<f64>);

/// The vectors of the lowest modes that bend something, lowest first.
pub(super) fn find(
    assembly: &Assembly,
    members: &MemberSet,
    search: &ModeSearch,
    mass: &Mass,
    rigid: &[Vec<f64>],
) -> Result<Vec<Vec<f64>>, ModesError> {
    let touched = assembly.touched(members);
    let free = assembly.equations.freedoms.iter().filter(|freedom| touched[freedom.node]).count();
    let mut stiffness = vec![0.0; assembly.equations.numbers()];
    for member in members.iter() {
        let matrix = assembly.elements[member.0].stiffness(assembly.rotation_unit);
        assembly.equations.add(&mut stiffness, member.0, &matrix);
    }
    let wanted = search.count.min(free - rigid.len());
    let goal = Goal { mass, rigid, free, wanted, block: lanczos::BLOCK, near: NEAR };
    let frame = Frame { assembly, members, touched, stiffness, goal };
    let mut missed = ModesError::NotConverged { found: 0, wanted, vectors: 0 };
    for block in BLOCKS {
        let modes = frame.lowest(search.shift_hz, block)?;
        match frame.left_out(&modes) {
            None => return Ok(modes.into_iter().map(|(_, vector)| vector).collect()),
            Some(error) => missed = error,
        }
    }
    Err(missed)
}

/// What vibrates, and what of it is wanted.
struct Frame<'a> {
    assembly: &'a Assembly,
    members: &'a MemberSet,
    touched: Vec<bool>,
    stiffness: Vec<f64>,
    goal: Goal<'a>,
}

impl Frame<'_> {
    /// K - μ M.
    fn shifted(&self, squared: f64) -> Vec<f64> {
        let less = |(k, m): (&f64, &f64)| k - squared * m;
        let mut numbers: Vec<f64> = self.stiffness.iter().zip(&self.goal.mass.numbers).map(less).collect();
        fill_untouched(&self.assembly.equations, &mut numbers, &self.touched);
        numbers
    }

    /// What a search in blocks of so many vectors finds.
    fn lowest(&self, shift_hz: f64, block: usize) -> Result<Vec<Bending>, ModesError> {
        let equations = &self.assembly.equations;
        let bending = |from: f64, modes: Vec<(f64, Vec<f64>)>| {
            modes.into_iter().map(|(value, vector)| (from + 1.0 / value, vector)).collect::<Vec<Bending>>()
        };
        let begin = -(TAU * shift_hz).powi(2);
        let goal = Goal { block, ..self.goal };
        let lower =
            Lower::new(equations, &self.shifted(begin)).map_err(|_| ModesError::Shift { shift_hz })?;
        let mut solver = lower.solver(&equations.symbolic, block);
        let value = match lanczos::lowest(&goal, &mut solver)? {
            Found::Modes(modes) => return Ok(bending(begin, modes)),
            Found::Near(value) => value,
        };
        let goal = Goal { near: 0.0, ..goal };
        for share in SHARES {
            let squared = share * share * (begin + 1.0 / value);
            let Some((lower, below)) = Lower::indefinite(equations, &self.shifted(squared)) else { continue };
            if squared > 0.0 && below == goal.rigid.len() {
                let mut solver = lower.solver(&equations.symbolic, block);
                if let Ok(Found::Modes(modes)) = lanczos::lowest(&goal, &mut solver) {
                    let modes = bending(squared, modes);
                    if modes.iter().all(|mode| self.is_mode(mode)) {
                        return Ok(modes);
                    }
                }
            }
        }
        // Without a better shift all is found from where the search began.
        match lanczos::lowest(&goal, &mut solver)? {
            Found::Modes(modes) => Ok(bending(begin, modes)),
            Found::Near(_) => Err(ModesError::NotConverged { found: 0, wanted: goal.wanted, vectors: 0 }),
        }
    }

    fn is_mode(&self, (squared, vector): &Bending) -> bool {
        let bent = twice_energy(self.assembly, self.members, &shape(self.assembly, vector));
        (bent / squared - 1.0).abs() < SAME
    }

    /// Whether there are more modes than were found, in the words of an error. One place where as many lie below is enough: pivots
    /// may be bad where a mode is near. Nothing is told where they can be counted nowhere.
    fn left_out(&self, modes: &[Bending]) -> Option<ModesError> {
        let top = modes.iter().map(|(squared, _)| *squared).fold(0.0, f64::max);
        let mut left_out = None;
        for below in BELOW {
            let squared = top * (1.0 - below);
            if modes.iter().any(|mode| (mode.0 / squared - 1.0).abs() < SAME) {
                continue;
            }
            let found = modes.iter().filter(|mode| mode.0 < squared).count();
            let Some((_, there)) = Lower::indefinite(&self.assembly.equations, &self.shifted(squared)) else {
                continue;
            };
            if there == self.goal.rigid.len() + found {
                return None;
            }
            let there = there.saturating_sub(self.goal.rigid.len());
            left_out.get_or_insert(ModesError::LeftOut { found, there, below_hz: squared.sqrt() / TAU });
        }
        left_out
    }
}
