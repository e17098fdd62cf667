//! A dry run: all moves of a wire, with no wire loaded, the peg in and every axis slow.

use wirebend_error::RunTarget;

use crate::live::Connection;
use crate::order::Move;
use crate::run::Task;
use crate::runs::StoredRun;
use crate::{LiveProblem, OperationError};

/// Less is rounding: the compensated steps of a wire have the head turn by sums of angles, mm or degrees.
const NOTHING: f64 = 1e-3;

/// A wire of a job whose moves are made without wire.
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
            format!("a dry run of wire {}: remove the wire from the machine", self.wire + 1),
            "the peg stays in, and every axis moves at a quarter of its speed".to_owned(),
        ]
    }

    /// Refuses a wire that the machine could not finish, a machine that is not set as its profile says, and one in which a wire is
    /// interrupted, of whichever job: it may still be in it.
    pub fn require_within(self, connection: &Connection) -> Result<(), OperationError> {
        let machine = self.task.setup.machine_id();
        if let Some(StoredRun { read: Ok(written), .. }) =
            self.task.folder.last_at(machine, &connection.port)?
            && !written.state.is_over()
            && !written.state.is_blank()
        {
            let heading = &written.state.heading;
            return Err(LiveProblem::WireInMachine {
                name: heading.name.clone(),
                wire: heading.wire,
                started: written.entries.first().map(|entry| entry.at.clone()).unwrap_or_default(),
                run: RunTarget {
                    job: None,
                    wire: Some(heading.wire),
                    port: Some(heading.port.clone()),
                    machine: None,
                    material: None,
                },
            }
            .into());
        }
        connection.require_settings(machine, self.task.request.accept_settings)?;
        self.task.require_within(connection, self.wire, 1)
    }
}
