//! The moves of a wire in the air: no wire is in the machine, the peg stays in, and every axis is slow.

use crate::OperationError;
use crate::live::Connection;
use crate::order::Move;
use crate::run::Task;

/// Less than any machine moves, mm or degrees.
const NOTHING: f64 = 1e-3;

/// A wire of a job whose moves are made in the air.
#[derive(Clone, Copy)]
pub struct DryRun<'a> {
    task: &'a Task<'a>,
    wire: usize,
}

impl<'a> DryRun<'a> {
    /// Refuses a wire that is interrupted: what is in the machine has to be seen to first.
    pub fn of(task: &'a Task<'a>, wire: usize) -> Result<Self, OperationError> {
        task.require_clear(wire)?;
        Ok(Self { task, wire })
    }

    /// The moves, in order: those that move nothing are left out.
    pub fn moves(self) -> Result<Vec<Move>, OperationError> {
        let steps = &self.task.wire(self.wire)?.compensated;
        let moves = steps.iter().flat_map(|step| {
            [
                (step.feed_mm, Move::Feed { mm: step.feed_mm }),
                (step.rotate_deg, Move::Rotate { deg: step.rotate_deg }),
                (step.bend_deg, Move::Bend { deg: step.bend_deg }),
            ]
        });
        Ok(moves.filter(|(by, _)| by.abs() >= NOTHING).map(|(_, one)| one).collect())
    }

    /// What a person has to see to.
    pub fn lines(self) -> Vec<String> {
        vec![
            format!("a dry run of wire {}: no wire may be in the machine", self.wire + 1),
            "the peg stays in, and every axis moves at a quarter of its speed".to_owned(),
        ]
    }

    /// Refuses a wire that the machine could not finish, and a machine that is not set as its profile says.
    pub fn require_within(self, connection: &Connection) -> Result<(), OperationError> {
        connection.require_settings(self.task.setup.machine_id(), self.task.request.accept_settings)?;
        self.task.require_within(connection, self.wire, 1)
    }
}
