//! A jog, and what belongs to it in a dry run: the pin is taken in, the axis moves, and a bend comes back.
//!
//! Each part is sent once the machine rests: what a stop found in its buffer would still be run.

use std::collections::VecDeque;

use wirebend_driver_api::DriverError;

use super::displacement::{ReportedPosition, displaced};
use super::machine::Machine;
use crate::settings::Settings;

#[derive(Debug, Default)]
pub(super) struct JogRow {
    /// What is to be sent, and where the axes stand then, from where they began, in the machine's units.
    parts: VecDeque<(Vec<String>, [f64; 3])>,
    began: Option<ReportedPosition>,
    /// Where they stand once what was sent is done.
    end: [f64; 3],
    moves: u32,
    /// The last report had the axes elsewhere.
    pub displaced: bool,
    /// It was reported that the machine holds.
    pub held: bool,
}

impl JogRow {
    pub fn new(began: Option<ReportedPosition>) -> Self {
        Self { began, ..Self::default() }
    }

    pub fn push(&mut self, lines: Vec<String>, end: [f64; 3]) {
        if !lines.is_empty() {
            self.parts.push_back((lines, end));
        }
    }

    /// The lines of the next part.
    pub fn next(&mut self) -> Option<Vec<String>> {
        let (lines, end) = self.parts.pop_front()?;
        (self.end, self.displaced) = (end, false);
        self.moves += 1;
        Some(lines)
    }

    /// Refuses to go on if the axes are not where the lines that were sent end: a feed hold ends a jog, and the machine is idle then
    /// as after a whole one.
    pub fn arrived(&self, machine: &Machine, settings: &Settings) -> Result<(), DriverError> {
        let standing = machine.reported(settings);
        let (Some(began), Some(standing)) = (&self.began, standing) else { return Ok(()) };
        match displaced(began, &standing, self.end, self.moves) {
            None => Ok(()),
            Some(_) => Err(DriverError::new(
                "jog-ended",
                "the move was ended at the machine before the axis was where it was sent",
                "see whether its feed hold was pressed, then home it",
            )),
        }
    }
}
