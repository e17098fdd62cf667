//! Where the wire of a job meets the machine or itself: a job has what was planned, and the profile that it was planned with.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use nalgebra::Point3;
use wirebend_core::bend::program_of_path;
use wirebend_core::checks::{Diagnostic, Meeting};
use wirebend_core::clearance::Passage;
use wirebend_core::plan::{ContactOptions, ScheduledWire};
use wirebend_core::simulate::scheduled_start;
use wirebend_core::units::Length;
use wirebend_core::wireframe::{EdgeId, VertexId};
use wirebend_files::document::JobWire;

use crate::contacts::{PATIENCE, collision_margin, first_contacts, not_searched_text};
use crate::machine::{Setup, kept_steps, told_steps};
use crate::text;

/// So many are named.
const MAX_NAMED: usize = 3;

/// What is known of where the wire of a job meets the machine or itself.
pub enum JobCollisions {
    /// It was looked at to its end.
    Checked {
        /// What the checks say of each contact.
        findings: Vec<Diagnostic>,
        /// How many bodies the machine's profile has.
        bodies: usize,
        /// How many of them have dimensions that were not measured.
        estimates: usize,
        /// How it was looked at.
        options: ContactOptions,
    },
    /// It takes longer than a person waits.
    Unfinished {
        /// How many steps were looked at, of how many.
        steps: [usize; 2],
        /// What the checks say of the contacts that were found by then.
        findings: Vec<Diagnostic>,
    },
    /// It could not be looked at.
    Unknown {
        /// Why: a clause.
        why: String,
    },
}

impl JobCollisions {
    /// Of a wire on the machine of its job.
    pub fn of(wire: &JobWire, setup: &Setup) -> Self {
        Self::within(PATIENCE, wire, setup)
    }

    fn within(patience: Duration, wire: &JobWire, setup: &Setup) -> Self {
        let wire = match scheduled(wire, setup) {
            Ok(wire) => wire,
            Err(why) => return Self::Unknown { why },
        };
        let until = Instant::now() + patience;
        let clearance = wire.clearance(&setup.model);
        let mut reached = 0;
        let searched = first_contacts(&clearance, |done| {
            reached = done;
            Instant::now() < until
        });
        let findings = wire.check(&setup.model, searched.contacts);
        if !searched.whole {
            return Self::Unfinished { steps: [reached, clearance.steps()], findings };
        }
        let bodies = &setup.model.bodies.all;
        let estimates = bodies.iter().filter(|body| !body.measured).count();
        Self::Checked { findings, bodies: bodies.len(), estimates, options: wire.options }
    }

    /// Whether it is known that there are some.
    pub fn some(&self) -> bool {
        !self.findings().is_empty()
    }

    /// What the checks say of the contacts that are known.
    pub fn findings(&self) -> &[Diagnostic] {
        match self {
            Self::Checked { findings, .. } | Self::Unfinished { findings, .. } => findings,
            Self::Unknown { .. } => &[],
        }
    }

    /// What to say of it besides what was found.
    pub fn otherwise(&self) -> Vec<String> {
        match self {
            Self::Unfinished { steps: [done, of], .. } => vec![not_searched_text(*done, *of)],
            Self::Checked { findings, .. } if findings.iter().any(hits) => Vec::new(),
            Self::Checked { findings, bodies, estimates, options } => {
                let near = if findings.is_empty() { looked_for(options) } else { String::new() };
                vec![none_found(*bodies, *estimates) + &near]
            }
            Self::Unknown { why } => vec![format!("collisions are not checked: {why}")],
        }
    }

    /// What to say of it: lines that begin in lower case, without a full stop. At most three places are named, errors first, and what is
    /// hit before what only comes near.
    pub fn lines(&self) -> Vec<String> {
        let named = named(self.findings());
        let otherwise = self.otherwise();
        match self {
            Self::Unfinished { .. } => named.into_iter().chain(otherwise).collect(),
            Self::Checked { .. } | Self::Unknown { .. } => otherwise.into_iter().chain(named).collect(),
        }
    }
}

/// Whether something is hit, rather than only near.
fn hits(finding: &Diagnostic) -> bool {
    finding.fact.meeting().is_some_and(Meeting::hits)
}

/// At most three, errors first, then what is hit.
fn named(findings: &[Diagnostic]) -> Vec<String> {
    let mut worst: Vec<&Diagnostic> = findings.iter().collect();
    worst.sort_by_key(|finding| (finding.severity, !hits(finding)));
    let mut lines: Vec<String> = worst.into_iter().take(MAX_NAMED).map(text::message).collect();
    let more = findings.len().saturating_sub(MAX_NAMED);
    if more > 0 {
        lines.push(format!("and {more} more"));
    }
    lines
}

/// How it was looked for, where that is not as usual.
fn looked_for(options: &ContactOptions) -> String {
    let near = (options.margin > Length::ZERO).then(|| format!("nothing nearer than {}", options.margin));
    let hangs = options.sag.then(|| "the part as it sags under its own weight".to_owned());
    let all: Vec<String> = near.into_iter().chain(hangs).collect();
    if all.is_empty() { String::new() } else { format!("; {}", all.join(", ")) }
}

fn none_found(bodies: usize, estimates: usize) -> String {
    match (bodies, estimates) {
        (0, _) => "no collision of the wire with itself found; the machine's profile has no bodies to check"
            .to_owned(),
        (_, 0) => "no collision found with the machine's bodies".to_owned(),
        _ => {
            let noun = if bodies == 1 { "body is an estimate" } else { "bodies are estimates" };
            format!("no collision found with the machine's bodies ({estimates} of {bodies} {noun})")
        }
    }
}

/// The wire as the search for contacts wants it; otherwise why that cannot be.
pub(crate) fn scheduled(wire: &JobWire, setup: &Setup) -> Result<ScheduledWire, String> {
    let damaged = |error: crate::PlanningError| error.to_string();
    let (steps, told) =
        (kept_steps(&wire.scheduled).map_err(damaged)?, told_steps(&wire.compensated).map_err(damaged)?);
    let path: Vec<Point3<f64>> = wire.path_mm.iter().copied().map(Point3::from).collect();
    let (start, _) = program_of_path(&path, setup.model.straight).map_err(|error| error.to_string())?;
    if wire.spans.len() != steps.len() || told.len() != steps.len() || path.len() != wire.vertices.len() {
        return Err("the job does not say along what each step runs".to_owned());
    }
    // A job has no edges: those that join the same two vertices lie beside each other.
    let mut edges: BTreeMap<[u32; 2], EdgeId> = BTreeMap::new();
    let mut passage = |k: usize| {
        let (from, to) = (*wire.vertices.get(k)?, *wire.vertices.get(k + 1)?);
        let next = EdgeId(u32::try_from(edges.len()).unwrap_or(u32::MAX));
        let edge = *edges.entry([from.min(to), from.max(to)]).or_insert(next);
        let length = Length::from_mm((path.get(k + 1)? - path.get(k)?).norm()).ok()?;
        Some((Passage { edge, from: VertexId(from), to: VertexId(to) }, length))
    };
    let passages = wire.spans.iter().map(|&[from, to]| (from..to).filter_map(&mut passage).collect());
    let options = contact_options(wire).map_err(damaged)?;
    Ok(ScheduledWire {
        start: scheduled_start(start, &steps),
        passages: passages.collect(),
        steps,
        told,
        options,
    })
}

/// How contacts of a wire were looked for when it was planned.
pub(crate) fn contact_options(wire: &JobWire) -> Result<ContactOptions, crate::PlanningError> {
    Ok(ContactOptions {
        margin: collision_margin(wire.clearance_mm.unwrap_or_default())?.length(),
        sag: wire.sag,
    })
}

#[cfg(test)]
mod tests {
    use wirebend_core::checks::{Fact, Severity};

    use super::*;
    use crate::design::DesignInput;
    use crate::machine::restored;
    use crate::plan::Planned;
    use crate::{Installation, NoProgress, PlanChoices};

    fn planned_with_the_kit(app: &Installation, name: &str) -> Planned {
        let example = format!("{}/../../examples/{name}.obj", env!("CARGO_MANIFEST_DIR"));
        let opened = DesignInput::file(example.into()).open(&NoProgress).unwrap();
        let choices = PlanChoices { machine: Some("wirebend-kit".into()), ..PlanChoices::default() };
        app.plan_design(opened, &choices, &NoProgress).unwrap()
    }

    /// A person who arms a machine would be told something else than the window says of the design.
    #[test]
    fn a_job_collides_where_its_design_does() {
        let app = Installation::new(&[]).unwrap();
        for (name, collide) in [("house", true), ("cube-8-edges", true), ("u-sample", false)] {
            let mut planned = planned_with_the_kit(&app, name);
            let job = planned.job().unwrap().unwrap();
            let setup = restored(name, job.contents()).unwrap();
            let found = JobCollisions::of(&job.contents().wires[0], &setup);
            let of_design = planned.find_collisions(&mut |_, _| true);
            let JobCollisions::Checked { findings, bodies, estimates, .. } = &found else { panic!("{name}") };
            assert_eq!((*bodies, *estimates), (of_design.bodies, of_design.estimates));
            let steps = |all: &[Diagnostic]| all.iter().map(|one| one.location.step).collect::<Vec<_>>();
            let wanted: Vec<_> = of_design.contacts.iter().map(|contact| Some(contact.step)).collect();
            assert_eq!(steps(findings), wanted, "{name}");
            assert_eq!((found.some(), of_design.contacts.is_empty()), (collide, !collide), "{name}");
        }
    }

    /// What is only near must not stand where what is hit should, and is no collision.
    #[test]
    fn errors_are_named_first_then_what_is_hit_and_what_is_only_near_last() {
        let planned = planned_with_the_kit(&Installation::new(&[]).unwrap(), "house");
        let wire = planned.job().unwrap().unwrap().contents().wires[0].clone();
        let one = JobCollisions::of(&wire, &planned.setup).findings()[0].clone();
        let finding = |severity, depth: f64| {
            let mut finding = Diagnostic { severity, ..one.clone() };
            let Fact::MeetsMachine { meeting, .. } = &mut finding.fact else { panic!("{:?}", one.fact) };
            meeting.depth = Length::from_mm(depth).unwrap();
            finding
        };
        let lines = |findings: &[Diagnostic]| {
            let findings = findings.to_vec();
            JobCollisions::Checked { findings, bodies: 6, estimates: 5, options: ContactOptions::default() }
                .lines()
        };
        let near = finding(Severity::Warning, -1.0);
        let hit = finding(Severity::Warning, 2.0);
        let error = finding(Severity::Error, 3.0);

        let mixed = lines(&[near.clone(), near.clone(), near.clone(), hit, error]);
        let [first, second, third, more] = &mixed[..] else { panic!("{mixed:?}") };
        assert!(first.contains("goes 3.0 mm into it"), "{first}");
        assert!(second.contains("goes 2.0 mm into it"), "{second}");
        assert!(third.contains("comes within 1.0 mm of it"), "{third}");
        assert_eq!(more, "and 2 more");

        let only_near = lines(&[near]);
        let [none, place] = &only_near[..] else { panic!("{only_near:?}") };
        assert_eq!(none, "no collision found with the machine's bodies (5 of 6 bodies are estimates)");
        assert!(place.contains("comes within 1.0 mm of it"), "{place}");
    }

    #[test]
    fn at_most_three_collisions_are_named_and_without_any_it_says_what_is_only_an_estimate() {
        let app = Installation::new(&[]).unwrap();
        let planned = planned_with_the_kit(&app, "house");
        let mut wire = planned.job().unwrap().unwrap().contents().wires[0].clone();
        let JobCollisions::Checked { findings, .. } = JobCollisions::of(&wire, &planned.setup) else {
            panic!()
        };
        let lines = |count: usize, bodies, estimates| {
            let findings = findings.iter().cycle().take(count).cloned().collect();
            JobCollisions::Checked { findings, bodies, estimates, options: ContactOptions::default() }.lines()
        };
        assert_eq!(
            lines(0, 6, 5),
            ["no collision found with the machine's bodies (5 of 6 bodies are estimates)"]
        );
        assert_eq!(lines(0, 6, 0), ["no collision found with the machine's bodies"]);
        assert!(lines(0, 0, 0)[0].contains("has no bodies"));
        assert_eq!(lines(3, 6, 6).len(), 3);
        assert!(lines(1, 6, 6)[0].starts_with("the wire hits the "), "{:?}", lines(1, 6, 6));
        assert_eq!(lines(4, 6, 6)[3], "and 1 more");
        assert_eq!(lines(5, 6, 6)[3], "and 2 more");
        let said = JobCollisions::within(Duration::ZERO, &wire, &planned.setup).lines();
        assert!(said[0].starts_with("collisions not fully searched: "), "{said:?}");
        wire.spans.pop();
        let said = JobCollisions::of(&wire, &planned.setup).lines();
        assert_eq!(said, ["collisions are not checked: the job does not say along what each step runs"]);
    }
}
