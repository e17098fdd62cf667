//! `.wbjob`: what is sent to a machine. It is hashed when it is written and never changes.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::bend::Step;
use wirebend_core::compensate::ToldStep;
use wirebend_core::units::{Angle, Length, NotFinite};

use super::error::DocumentError;
use super::hash::canonical_sha256;
use super::layout;
use super::pause::{JobPause, pause_note};
use super::project::SourceFile;
use super::snapshot::ProfileSnapshot;
use super::version::History;

const HISTORY: History = History { format: "wbjob", title: "a WireBend job", migrations: &[] };

/// A job as it was sealed: its contents and the hash that proves them.
#[derive(Debug, Clone, PartialEq)]
pub struct Job {
    contents: JobContents,
    hash: String,
}

/// What a job is made of.
#[derive(Debug, Clone, PartialEq)]
pub struct JobContents {
    /// The hash of the design that it was planned from.
    pub design_hash: String,
    /// The machine that it was planned for.
    pub machine: ProfileSnapshot,
    /// The wire that it was planned for.
    pub material: ProfileSnapshot,
    /// The wires, in the order in which they are bent.
    pub wires: Vec<JobWire>,
    /// What the checks objected to when a person had the job written anyway.
    pub objections: Vec<String>,
    /// The program that it runs as it stands, without compensation; none of a design that was planned.
    pub program: Option<SourceFile>,
}

/// One wire, in every stage of its planning.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JobWire {
    /// The vertices of the design that it runs through, by id, in order.
    pub vertices: Vec<u32>,
    /// The points that it runs through, in mm.
    pub path_mm: Vec<[f64; 3]>,
    /// The program of the design.
    pub nominal: Vec<JobStep>,
    /// Of each nominal step the segments of the path that its feed runs along: first, and one past
    /// the last.
    pub spans: Vec<[usize; 2]>,
    /// The program with the signs and head turns that were chosen.
    pub scheduled: Vec<JobStep>,
    /// The program that the machine is told.
    pub compensated: Vec<JobStep>,
    /// The wire that has to be put in, with what cannot be fed.
    pub stock_mm: f64,
    /// How long it takes, estimated.
    pub time_s: f64,
    /// Whether it was found by a search for a wire that hits nothing, and relies on the signs and head turns that were chosen.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub avoids_collisions: bool,
    /// How far it has to stay from what it could hit, besides, mm: what a search for collisions was told, and is told again before it is
    /// bent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub clearance_mm: Option<f64>,
    /// Whether collisions are looked for with the part as it hangs under its own weight.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub sag: bool,
    /// Steps after which the machine waits for a person, in order.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub pauses: Vec<JobPause>,
}

// Two other types have the same three values: core's `Step`, with units in its types, and the driver's, whose signs are the
// machine's. As types they cannot be taken for each other, so signs are applied once.
/// Feed, then rotate, then bend, in canonical signs.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JobStep {
    /// How far the wire is fed.
    pub feed_mm: f64,
    /// How far it is turned about itself.
    pub rotate_deg: f64,
    /// How far it is bent.
    pub bend_deg: f64,
    /// What a machine is told of a bend whose axis stops at zero or before it: where the axis stands when the peg comes out. The bend
    /// is to the other side, whatever the sign of `bend_deg`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub approach_deg: Option<f64>,
}

impl From<Step> for JobStep {
    fn from(step: Step) -> Self {
        Self::from(ToldStep::from(step))
    }
}

impl From<ToldStep> for JobStep {
    fn from(ToldStep { step, approach }: ToldStep) -> Self {
        Self {
            feed_mm: step.feed.mm(),
            rotate_deg: step.rotate.deg(),
            bend_deg: step.bend.deg(),
            approach_deg: approach.map(Angle::deg),
        }
    }
}

impl TryFrom<JobStep> for ToldStep {
    type Error = NotFinite;

    fn try_from(step: JobStep) -> Result<Self, NotFinite> {
        let approach = step.approach_deg.map(Angle::from_deg).transpose()?;
        Ok(Self { step: Step::try_from(step)?, approach })
    }
}

impl TryFrom<JobStep> for Step {
    type Error = NotFinite;

    fn try_from(step: JobStep) -> Result<Self, NotFinite> {
        Ok(Self {
            feed: Length::from_mm(step.feed_mm)?,
            rotate: Angle::from_deg(step.rotate_deg)?,
            bend: Angle::from_deg(step.bend_deg)?,
        })
    }
}

/// A sealed WireBend job.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "WireBend job")]
pub(crate) struct JobFile {
    /// Which kind of file this is.
    #[schemars(extend("const" = "wbjob"))]
    format: String,
    /// The version of this format.
    #[schemars(extend("const" = 1))]
    version: u64,
    /// SHA-256 over the canonical form (RFC 8785) of this file without this key.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "String", regex(pattern = "^[0-9a-f]{64}$"))]
    hash: Option<String>,
    /// The hash of the design that the job was planned from.
    #[schemars(regex(pattern = "^[0-9a-f]{64}$"))]
    design_hash: String,
    machine: ProfileSnapshot,
    material: ProfileSnapshot,
    wires: Vec<JobWire>,
    /// What the checks objected to when a person had the job written anyway.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    objections: Vec<String>,
    /// The program that the job runs as it stands, without compensation; absent of a design that was planned.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    program: Option<SourceFile>,
}

impl Job {
    /// Seals contents into a job.
    ///
    /// # Errors
    /// [`DocumentError::NotFinite`] for a number that is NaN or infinite, [`DocumentError::Inconsistent`]
    /// for a wire whose stages do not fit each other.
    pub fn seal(contents: JobContents) -> Result<Self, DocumentError> {
        contents.check()?;
        let hash = canonical_sha256(&JobFile::of(&contents, None))?;
        Ok(Self { contents, hash })
    }

    /// Opens the bytes of a `.wbjob` file.
    ///
    /// # Errors
    /// [`DocumentError::Changed`] when the hash does not fit; else as for every document.
    pub fn open(bytes: &[u8], file: &str) -> Result<Self, DocumentError> {
        let mut content: JobFile = HISTORY.open(bytes, file)?;
        let hash = content.hash.take().unwrap_or_default();
        if canonical_sha256(&content)? != hash {
            return Err(DocumentError::Changed { file: file.to_owned() });
        }
        let JobFile { design_hash, machine, material, wires, objections, program, .. } = content;
        let contents = JobContents { design_hash, machine, material, wires, objections, program };
        contents.check()?;
        Ok(Self { contents, hash })
    }

    /// The bytes of the `.wbjob` file; the same job gives the same bytes.
    ///
    /// # Errors
    /// [`DocumentError::Write`].
    pub fn to_bytes(&self) -> Result<Vec<u8>, DocumentError> {
        layout::to_bytes(&JobFile::of(&self.contents, Some(self.hash.clone())))
    }

    #[must_use]
    pub const fn contents(&self) -> &JobContents {
        &self.contents
    }

    /// The hash over all of it, in hexadecimal.
    #[must_use]
    pub fn hash(&self) -> &str {
        &self.hash
    }
}

impl JobStep {
    /// Whether its peg, where it is told a place, comes out to one side of zero, and before its bend.
    fn has_room_for_its_peg(&self) -> bool {
        self.approach_deg
            .is_none_or(|comes_out| comes_out != 0.0 && comes_out.signum() * self.bend_deg < comes_out.abs())
    }
}

impl JobFile {
    fn of(contents: &JobContents, hash: Option<String>) -> Self {
        let JobContents { design_hash, machine, material, wires, objections, program } = contents.clone();
        let (format, version) = (HISTORY.format.to_owned(), HISTORY.current());
        Self { format, version, hash, design_hash, machine, material, wires, objections, program }
    }
}

impl JobContents {
    /// Numbers are finite and the stages of each wire fit each other.
    fn check(&self) -> Result<(), DocumentError> {
        for (wire, kept) in self.wires.iter().enumerate() {
            let refuse = |what| Err(DocumentError::Inconsistent { wire, what });
            let (path, steps) = (kept.path_mm.len(), kept.nominal.len());
            if path < 2 || kept.vertices.len() != path {
                return refuse("a path has at least two points, and a vertex for each");
            }
            if steps == 0 || [&kept.scheduled, &kept.compensated].iter().any(|stage| stage.len() != steps) {
                return refuse("all stages have the same number of steps, at least one");
            }
            let ends = kept.spans.iter().map(|span| span[1]);
            let starts = std::iter::once(0).chain(ends);
            let joined =
                kept.spans.iter().zip(starts).all(|(span, start)| span[0] == start && span[1] > start);
            let covers = kept.spans.last().is_some_and(|span| span[1] == path - 1);
            if kept.spans.len() != steps || !joined || !covers {
                return refuse("the steps run along all segments of the path, one after the other");
            }
            // None before the first step or after the last: a person is asked there in any case.
            let inside = |pause: &JobPause| (1..steps).contains(&(pause.after as usize));
            let ascending = kept.pauses.is_sorted_by(|one, next| one.after < next.after);
            if !ascending || !kept.pauses.iter().all(inside) {
                return refuse(
                    "each pause point comes after another step of the wire, in order, and before its last",
                );
            }
            let designed = kept.nominal.iter().chain(&kept.scheduled);
            if designed.into_iter().any(|step| step.approach_deg.is_some())
                || !kept.compensated.iter().all(JobStep::has_room_for_its_peg)
            {
                return refuse(
                    "the peg comes out farther from zero than its bend goes before it, and only where the machine is told so",
                );
            }
            if kept.pauses.iter().any(|pause| pause_note(&pause.note).is_none()) {
                return refuse("each pause point says what to do");
            }
        }
        self.check_finite()
    }

    fn check_finite(&self) -> Result<(), DocumentError> {
        let refuse = |key, value: f64| {
            if value.is_finite() { Ok(()) } else { Err(DocumentError::NotFinite { key, value }) }
        };
        for wire in &self.wires {
            refuse("stock_mm", wire.stock_mm)?;
            refuse("time_s", wire.time_s)?;
            wire.path_mm.iter().flatten().try_for_each(|&c| refuse("path_mm", c))?;
            for step in wire.nominal.iter().chain(&wire.scheduled).chain(&wire.compensated) {
                refuse("feed_mm", step.feed_mm)?;
                refuse("rotate_deg", step.rotate_deg)?;
                refuse("bend_deg", step.bend_deg)?;
                refuse("approach_deg", step.approach_deg.unwrap_or_default())?;
            }
        }
        Ok(())
    }
}
