//! What a front end hears of a machine, and what it is asked about a step.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::units::Mm;
use wirebend_driver_host::api::PausedBy;
use wirebend_error::ProblemReport;

use wirebend_planning::report::shown_deg;
use wirebend_planning::{JobStep, PartOfStep};

/// Something that happened on a machine, or is about to.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(tag = "news", rename_all = "kebab-case")]
#[schemars(rename = "News")] // as the window knows it
pub enum MachineEvent {
    /// What will happen once a person says yes: lines to read.
    About { lines: Vec<String> },
    /// The machine homes: it moves.
    Homing,
    /// How far a wire is.
    Wire {
        /// Index of the wire, from 0.
        wire: usize,
        /// The last step that is done.
        made: u32,
        /// The last that the machine has taken.
        sent: u32,
        /// How many there are.
        of: u32,
        /// How far the machine is in the step after the last that is done, in part of the step's time, from where it reports
        /// its axes; 0 where it reports none.
        in_step: f64,
        /// How long the machine was at work on the wire, in all of its parts, without pauses, s.
        elapsed_s: f64,
        /// What is estimated to be left, s.
        remaining_s: f64,
    },
    /// Where the axes are, in canonical signs.
    Position(JobStep),
    /// A line to the machine, or from it.
    Console {
        /// Whether it went to the machine.
        to_machine: bool,
        /// The line.
        text: String,
    },
    /// Something that a person should know and that ends nothing.
    Warning(ProblemReport),
    /// The machine holds.
    Paused { by: PausedBy },
    /// The machine resumes.
    Resumed,
}

/// A step in doubt: it is not known whether it was done.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Doubt {
    /// Index of the wire, from 0.
    pub wire: usize,
    /// The step, from 1.
    pub step: u32,
    /// How many there are.
    pub of: u32,
    /// The last step that was sent: when this one was done, the next ones up to it are in doubt, too.
    pub last: u32,
    /// What it was to do to the wire: feed, then rotate, then bend, as designed.
    pub designed: JobStep,
    /// What the machine is told of the whole of it, with its feed in mm of wire.
    #[serde(rename = "told")]
    pub commanded: JobStep,
    /// How much of it was in the wire before it was sent last.
    pub before: PartOfStep,
    /// How much of it is in the wire as the machine has counted; null where it cannot tell.
    pub counted: Option<PartOfStep>,
    /// How far that is in part of the step's time; 0 where it cannot tell.
    pub in_step: f64,
}

/// What a person says of a step in doubt.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Decision {
    /// It is done.
    Made,
    /// Nothing was done of what was sent of it.
    NotMade,
    /// As much is in the wire as the machine has counted: the rest is bent.
    AsCounted,
    /// So much is in the wire, as they have measured: the rest is bent.
    Part(PartOfStep),
}

/// What a person says of one step. It counts for that step alone, however often it is said.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Decided {
    /// The step, from 1.
    pub step: u32,
    /// What became of it.
    pub what: Decision,
}

impl std::fmt::Display for Doubt {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { wire, step, of, designed, commanded, counted, .. } = self;
        let JobStep { feed_mm, rotate_deg, bend_deg, .. } = designed;
        let (rotate_deg, bend_deg) = (shown_deg(*rotate_deg), shown_deg(*bend_deg));
        write!(
            f,
            "it is not known whether step {step} of {of} of wire {} was done: {:.1} of wire, turned {rotate_deg:.1}°, \
             bent {bend_deg:.1}°",
            wire + 1,
            Mm(*feed_mm)
        )?;
        let Some(part) = counted else {
            // The user measures what the machine does for it.
            let (feed, rotate_deg) = (Mm(commanded.feed_mm), shown_deg(commanded.rotate_deg));
            return write!(f, "; the machine feeds {feed:.1} and turns {rotate_deg:.1}° for it");
        };
        write!(
            f,
            "; it was stopped on its way: the machine counts {:.1} of {:.1} fed and {:.1}° of {:.1}° turned, and may have lost steps as it stopped",
            Mm(part.feed_mm),
            Mm(commanded.feed_mm),
            shown_deg(part.rotate_deg),
            shown_deg(commanded.rotate_deg)
        )
    }
}
