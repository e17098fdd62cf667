//! What can be done about what the checks say: edits that were tried, with what they change.
//!
//! A file for each kind of trouble proposes edits. Every one is made on a copy of the design and planned; a person is
//! offered only what fixes it.

mod all;
mod avoid;
mod bends;
mod cuts;
mod drawing;
mod joins;
mod lengths;
mod preview;
mod reach;
mod scale;
mod search;
mod shares;
mod starts;
mod sums;
mod trials;
mod verdict;
mod wires;

use std::collections::BTreeSet;
use std::rc::Rc;

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_core::checks::{Code, Diagnostic, Severity};
use wirebend_core::plan::WirePlan;
use wirebend_core::units::Mm;
use wirebend_files::document::Document;
use wirebend_planning::text::shown;

use super::{EditRequest, Editor};
use crate::EditorError;
pub use all::FixAll;
pub use avoid::{AvoidedCollisions, HelpFix, SearchSettings};
pub use preview::FixPreview;
use sums::sum;
pub use sums::{FixChange, FixTotals};
use trials::{Trial, Trials};
use wirebend_planning::Installation;
use wirebend_planning::machine::Setup;
use wirebend_planning::report::DiagnosticReport;

/// The most fixes for one diagnostic.
const MAX_FOR_ONE: usize = 3;
/// The most for odd vertices: one wire, and up to five more.
const MAX_FOR_ODD: usize = 6;
/// The most fixes for a design.
const MAX_FIXES: usize = 60;

/// Something that fixes what a check says. Lengths in mm.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Fix {
    /// What it fixes, as [`Editor::check`] says it.
    pub mends: DiagnosticReport,
    /// For a button: "Run the wire along 13 edges twice (+102.0 mm)", "Move vertex 41 by 3.2 mm".
    pub title: String,
    pub edit: EditRequest,
    pub change: FixChange,
    pub after: FixTotals,
    /// How many errors there are afterwards.
    pub errors_after: usize,
    /// Whether the machine can make the design afterwards.
    pub feasible_after: bool,
    /// What to draw before it is done.
    pub preview: FixPreview,
}

/// An edit that may fix something.
#[derive(Debug, Clone, PartialEq)]
struct Candidate {
    title: String,
    edit: EditRequest,
}

/// What a check said, of one wire or of the design as a whole.
#[derive(Clone, Copy)]
struct Finding<'a> {
    diagnostic: &'a Diagnostic,
    wire: Option<&'a WirePlan>,
}

impl Editor {
    /// What can be done about the errors and warnings of the design on its machine, in the order of
    /// [`Editor::check`]: up to 3 fixes each, 6 for odd vertices, and 60 in all, with fewer for each where there are many. For each, those
    /// come first that leave the fewest errors, then those with the fewest wires, then those that add the least wire. Nothing is changed.
    ///
    /// A fix corrects what it is for, at its place, brings no more errors than there were, those aside that could
    /// not be seen before for want of a route, and moves no vertex farther than the shortest edge at it or twice the
    /// machine's; scaling the whole, no farther than a metre. At most 200 edits are tried, fewer of a design that takes long to plan.
    /// Where there is much to fix, what is said last may be left without a fix.
    ///
    /// # Errors
    /// [`EditorError::Planning`] where none is chosen.
    pub fn fixes(&mut self, app: &Installation) -> Result<Vec<Fix>, EditorError> {
        self.fix_search(app)?.fixes(app)
    }

    /// What [`Editor::fixes`] needs of the design, so that the design is free while it searches.
    pub fn fix_search(&mut self, app: &Installation) -> Result<FixSearch, EditorError> {
        let (names, setup) = self.take_setup(app)?;
        // What the wire was drawn along goes with it where the whole is scaled.
        let document = Document {
            stencils: self.document.stencils.clone(),
            construction: self.document.construction.clone(),
            ..self.planned_part()
        };
        let found = FixSearch { document, setup: setup.clone() };
        self.setup = Some((names, setup));
        Ok(found)
    }
}

/// A design that is searched for what would fix it.
pub struct FixSearch {
    document: Document,
    setup: Setup,
}

impl FixSearch {
    pub fn fixes(self, app: &Installation) -> Result<Vec<Fix>, EditorError> {
        let (base, mut trials) = Trials::begin(self.document, app, &self.setup)?;
        Ok(fixes(&base, &mut trials, |code| !is_collision(code)))
    }

    /// What can be done about collisions alone, likewise: each edit is tried with a check for them. `goes_on` is asked again and again;
    /// where it does not there are none.
    pub fn collision_fixes(
        self,
        app: &Installation,
        goes_on: &dyn Fn() -> bool,
    ) -> Result<Vec<Fix>, EditorError> {
        let (base, mut trials) = Trials::with_collisions(self.document, app, &self.setup, goes_on)?;
        let fixes = fixes(&base, &mut trials, is_collision);
        Ok(if goes_on() { fixes } else { Vec::new() })
    }
}

/// Whether only a check for collisions says it.
fn is_collision(code: Code) -> bool {
    matches!(code, Code::MeetsMachine | Code::MeetsStock)
}

/// An edit that fixes something, with the design after it.
type TriedFix = (Candidate, Rc<Trial>);

fn fixes(base: &Trial, trials: &mut Trials, wanted: fn(Code) -> bool) -> Vec<Fix> {
    let findings = base.findings();
    let mut to_fix = to_fix(&findings);
    to_fix.retain(|&k| wanted(findings[k].diagnostic.code()));
    let neediest = scale::neediest(&findings, &to_fix, &trials.document().wireframe);
    // Where there are more than can be tried, what fixes most is not to be left out.
    to_fix.sort_by_key(|&k| neediest.is_none_or(|(neediest, _)| k != neediest));
    let mut tried: Vec<(usize, Vec<TriedFix>)> = Vec::new();
    for (done, &k) in to_fix.iter().enumerate() {
        trials.share(to_fix.len() - done);
        let factor = neediest.filter(|(neediest, _)| k == *neediest);
        let scaled = factor.and_then(|(_, factor)| scale::up(factor, trials));
        let others = candidates(findings[k], &findings, trials);
        let all = scaled.into_iter().chain(others);
        tried.push((k, fixes_for(findings[k].diagnostic, all, base, trials)));
    }
    // Where there is no room for three each, there is one for as many as can be.
    let most = |k: usize| match findings[k].diagnostic.code() {
        Code::NoEulerPath => MAX_FOR_ODD,
        _ => MAX_FOR_ONE,
    };
    let taken = |k: usize, rank: usize| if rank == MAX_FOR_ONE { most(k) } else { rank };
    let room = |rank: usize| {
        tried.iter().map(|(k, some)| some.len().min(taken(*k, rank))).sum::<usize>() <= MAX_FIXES
    };
    let each = (1..=MAX_FOR_ONE).rev().find(|&rank| room(rank)).unwrap_or(1);
    let ranked = tried
        .into_iter()
        .flat_map(|(k, some)| some.into_iter().take(taken(k, each)).map(move |one| (k, one)));
    let mut chosen: Vec<(usize, TriedFix)> = ranked.take(MAX_FIXES).collect();
    chosen.sort_by_key(|(k, _)| *k);
    let mends = |k: usize| base.check.diagnostics[k].clone();
    let made =
        chosen.into_iter().map(|(k, (candidate, trial))| Fix::new(mends(k), candidate, base, trials, &trial));
    made.collect()
}

/// The findings that are worth a fix. Of an edge that is travelled twice some are said twice, and count once.
fn to_fix(findings: &[Finding]) -> Vec<usize> {
    let mut said = BTreeSet::new();
    let new = |finding: &Finding| {
        let location = &finding.diagnostic.location;
        location.edges.is_empty() || said.insert((finding.diagnostic.code(), location.edges.clone()))
    };
    let is_new: Vec<bool> = findings.iter().map(new).collect();
    let worth = |&k: &usize| findings[k].diagnostic.severity != Severity::Info && is_new[k];
    (0..findings.len()).filter(worth).collect()
}

/// What fixes a finding, best first.
fn fixes_for(
    diagnostic: &Diagnostic,
    candidates: impl Iterator<Item = Candidate>,
    base: &Trial,
    trials: &mut Trials,
) -> Vec<TriedFix> {
    let mut offered: Vec<TriedFix> = Vec::new();
    for candidate in candidates {
        let tried = trials.of(&candidate.edit);
        let good = tried.filter(|trial| {
            verdict::is_fixed(base, trial, diagnostic) && reach::is_near(&candidate.edit, trial, trials)
        });
        if let Some(trial) = good.filter(|_| offered.iter().all(|(other, _)| *other != candidate)) {
            offered.push((candidate, trial));
        }
    }
    let length = |trial: &Trial| sum(&trial.check, |wire| wire.length_mm).unwrap_or(f64::INFINITY);
    let effort = |trial: &Trial| (trial.errors(), trial.wires.len());
    offered.sort_by(|(_, a), (_, b)| effort(a).cmp(&effort(b)).then_with(|| length(a).total_cmp(&length(b))));
    offered
}

/// What may fix a finding, most natural first.
fn candidates(finding: Finding, all: &[Finding], trials: &mut Trials) -> Vec<Candidate> {
    let mut found = Vec::new();
    match finding.diagnostic.code() {
        Code::ZeroLengthEdge | Code::ParallelEdges | Code::CoincidentVertices | Code::IsolatedVertex => {
            found.extend(drawing::candidates(finding, all, trials.document()));
        }
        Code::EdgesMeet => found.extend(joins::candidates(finding, trials.document())),
        Code::RouteRefused => found.extend(starts::anywhere(finding, trials.document())),
        Code::NoEulerPath => found.extend(wires::candidates(finding, trials)),
        Code::EdgeTooShort
        | Code::EdgeNearLimit
        | Code::FeedTooShort
        | Code::FeedNearLimit
        | Code::LeadTooShort
        | Code::ArcsOverlap => found.extend(lengths::candidates(finding, trials)),
        Code::BendNearLimit | Code::BendInScatter | Code::CornerNotMade => {
            found.extend(bends::moves(finding, trials));
        }
        Code::BendTooSharp | Code::BendOutOfReach | Code::BendTooSmall => {
            found.extend(starts::there(finding, trials));
            found.extend(wires::detour(finding, trials));
            found.extend(bends::moves(finding, trials));
            found.extend(cuts::at_step(finding, trials.document()));
            found.extend(starts::elsewhere(finding, trials));
        }
        Code::FoldBack if finding.diagnostic.is_error() => {
            found.extend(starts::elsewhere(finding, trials));
            found.extend(cuts::at_step(finding, trials.document()));
            found.extend(bends::moves(finding, trials));
            found.extend(wires::none_doubled(trials));
        }
        Code::RotationOutOfRange | Code::NoClearProgram | Code::CornerTooNear => {
            found.extend(starts::elsewhere(finding, trials));
            found.extend(cuts::at_step(finding, trials.document()));
        }
        Code::MeetsMachine | Code::MeetsStock => {
            found.extend(trials.clear_walks());
            found.push(starts::reversed(trials.document()));
            found.extend(starts::elsewhere(finding, trials));
            found.extend(cuts::at_step(finding, trials.document()));
        }
        Code::StockTooLong => {
            found.extend(cuts::into_equal_parts(finding, trials));
            found.extend(scale::down(finding, trials));
        }
        Code::FeedTooLong => {
            found.extend(cuts::within_step(finding, trials.document()));
            found.extend(scale::down(finding, trials));
        }
        Code::FoldBack
        | Code::SeveralWires
        | Code::NoEdges
        | Code::DoubledEdge
        | Code::WireDoesNotFit
        | Code::BendTorqueLow
        | Code::BendRadiusSmall
        | Code::PartSags
        | Code::CornerWithinReach
        | Code::HeadNotMeasured
        | Code::FrameUnsupported
        | Code::FrameMechanism
        | Code::StrutOverstressed
        | Code::StrutNearBuckling
        | Code::FrameTooSoft
        | Code::StrutFloating
        | Code::NoHeadDirection
        | Code::OutOfWorkspace
        | Code::SequenceNotFound
        | Code::SequenceWrong => {}
    }
    found
}

impl Fix {
    fn new(
        mends: DiagnosticReport,
        candidate: Candidate,
        before: &Trial,
        trials: &Trials,
        after: &Trial,
    ) -> Self {
        Self {
            mends,
            preview: FixPreview::of(trials.document(), &candidate.edit, after),
            title: candidate.title,
            edit: candidate.edit,
            change: FixChange::between(before, after),
            after: FixTotals::of(after),
            errors_after: after.errors(),
            feasible_after: after.check.feasible,
        }
    }
}

/// A length for a button.
fn shown_mm(length: f64) -> String {
    let digits = if length < 0.95 { 2 } else { 1 };
    shown(|| format!("{:.digits$}", Mm(length)))
}
