//! Contacts against a bender that is looked at again and again.

use anyhow::{Result, anyhow, ensure};
use nalgebra::Point3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use wirebend_benches::bender::{Bender, Moment};
use wirebend_core::bend::{Frame, Step, program_of_path};
use wirebend_core::clearance::{Clearance, Contact, MovesWith, Obstacle, Passage, Phase, StockWire};
use wirebend_core::plan::Machine;
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::{EdgeId, VertexId};

/// The first contact is this exact, mm.
const EXACT: f64 = 0.01;

/// So many vertices have the wires that run along the edges between a few.
const VERTICES: u32 = 6;

/// What is seen of an obstacle in a step.
#[derive(Clone, Copy)]
struct Seen {
    first: Option<Moment>,
    least: f64,
    /// At the contact that the check reports.
    at_contact: f64,
}

/// What comes of comparisons.
#[derive(Default, Clone, Copy)]
struct Compared {
    contacts: usize,
    /// How far from touching wire and obstacle are at most at the first contact, mm: of the peg, and of all others.
    apart: [f64; 2],
}

impl Compared {
    fn with(self, other: Self) -> Self {
        let apart = [0, 1].map(|k| self.apart[k].max(other.apart[k]));
        Self { contacts: self.contacts + other.contacts, apart }
    }
}

/// Compares random programs of up to 9 bends.
pub fn compare(machine: &Machine, programs: u64) -> Result<()> {
    let threads = u64::try_from(std::thread::available_parallelism()?.get())?;
    let run = &|thread: u64| -> Result<Compared> {
        let every = (thread..programs).step_by(usize::try_from(threads)?);
        every
            .map(|seed| compare_one(machine, seed))
            .try_fold(Compared::default(), |all, one| Ok(all.with(one?)))
    };
    let all = std::thread::scope(|scope| -> Result<Compared> {
        let all: Vec<_> = (0..threads).map(|thread| scope.spawn(move || run(thread))).collect();
        all.into_iter().try_fold(Compared::default(), |all, one| {
            Ok(all.with(one.join().map_err(|_| anyhow!("a comparison panicked"))??))
        })
    })?;
    println!(
        "{programs} random programs, a quarter each plain, with a margin, along shared vertices (half of them real, half in name only) and with a bend axis of its own, seen at every 0.05 degrees and mm: {} contacts, none missed, none too many; at the first contact \
         at most {:.4} mm from touching ({:.4} mm where the peg is what is met)",
        all.contacts, all.apart[1], all.apart[0]
    );
    Ok(())
}

/// A program, and how it is run.
struct Case {
    steps: Vec<Step>,
    passages: Vec<Vec<(Passage, Length)>>,
    /// mm.
    margin: f64,
    /// Where the peg comes out and where the bend axis ends, radians.
    goes: Vec<Option<[f64; 2]>>,
}

impl Case {
    /// One after the other: plain, with a margin, along the edges of a few vertices or as if, and with a bend axis that goes elsewhere than beside
    /// straight wire.
    fn of(machine: &Machine, seed: u64) -> Result<Self> {
        let steps = super::program(seed, usize::try_from(1 + seed % 9)?)?;
        let mut random = ChaCha8Rng::seed_from_u64(!seed);
        let mut case = Self { passages: super::passages(&steps), steps, margin: 0.0, goes: Vec::new() };
        match seed % 4 {
            1 => case.margin = random.random_range(0.1..5.0),
            // Vertices where wire meets, or such in name only.
            2 if seed % 8 == 2 => case = Self::along_frame(&mut random, case.steps.len())?,
            2 => {
                let mut from = 0;
                for (passage, _) in case.passages.iter_mut().flatten() {
                    let to = (from + random.random_range(1..VERTICES)) % VERTICES;
                    let edge = EdgeId(from.min(to) * VERTICES + from.max(to));
                    *passage = Passage { edge, from: VertexId(from), to: VertexId(to) };
                    from = to;
                }
            }
            3 => {
                let bender = Bender::new(machine, &case.steps, case.passages.clone(), 1.0);
                let goes = case.steps.iter().enumerate().map(|(k, step)| {
                    let side = step.bend.signum();
                    let earlier = random.random_range(0.0..0.4);
                    let farther = random.random_range(-0.1..0.15);
                    let [begin, _, end] = bender.axes(k, step).filter(|_| step.bend != Angle::ZERO)?;
                    Some([begin - side * earlier, end + side * farther])
                });
                case.goes = goes.collect();
            }
            _ => {}
        }
        Ok(case)
    }

    /// A wire along so many edges between a few points.
    fn along_frame(random: &mut ChaCha8Rng, edges: usize) -> Result<Self> {
        loop {
            let points: Vec<Point3<f64>> = (0..VERTICES)
                .map(|_| Point3::from([0; 3].map(|_| f64::from(random.random_range(-8..=8_i32)) * 10.0)))
                .collect();
            let mut route = vec![random.random_range(0..points.len())];
            while route.len() <= edges {
                route.push(random.random_range(0..points.len()));
            }
            let path: Vec<Point3<f64>> = route.iter().map(|&vertex| points[vertex]).collect();
            let Ok((_, program)) = program_of_path(&path, Angle::from_deg(1e-6)?) else { continue };
            if program.steps.iter().any(|step| step.feed.mm() < 40.0 || step.bend.abs().deg() > 120.0) {
                continue;
            }
            let passage = |at: usize| -> Result<(Passage, Length)> {
                let [from, to] = [route[at], route[at + 1]];
                let vertex = |of: usize| u32::try_from(of).map(VertexId);
                let edge = EdgeId(u32::try_from(from.min(to))? * VERTICES + u32::try_from(from.max(to))?);
                let length = Length::from_mm((path[at + 1] - path[at]).norm())?;
                Ok((Passage { edge, from: vertex(from)?, to: vertex(to)? }, length))
            };
            let passages = program.spans.iter().map(|span| span.clone().map(passage).collect());
            let passages = passages.collect::<Result<_>>()?;
            return Ok(Self { steps: program.steps, passages, margin: 0.0, goes: Vec::new() });
        }
    }

    /// All contacts that the check finds.
    fn contacts(&self, machine: &Machine) -> Result<Vec<Contact>> {
        let told = |(k, step): (usize, &Step)| -> Result<Step> {
            let goes = self.goes.get(k).copied().flatten();
            let bend = goes.map_or(Ok(step.bend), |[_, end]| Angle::from_deg(end.to_degrees()))?;
            Ok(Step { bend, ..*step })
        };
        let told = self.steps.iter().enumerate().map(told).collect::<Result<Vec<_>>>()?;
        let approach =
            |goes: &Option<[f64; 2]>| goes.map(|[begin, _]| Angle::from_deg(begin.to_degrees())).transpose();
        let approaches = self.goes.iter().map(approach).collect::<Result<Vec<_>, _>>()?;
        let wire = StockWire { margin: Length::from_mm(self.margin)?, ..super::stock(machine) };
        let told = (!self.goes.is_empty()).then_some(told.as_slice());
        let bend = &machine.compensation.bend;
        let start = (Frame::default(), self.steps.as_slice());
        let clearance = Clearance::new(start, told, self.passages.clone(), wire, &machine.bodies, bend);
        Ok(super::contacts(clearance.with_approaches(approaches)))
    }
}

fn compare_one(machine: &Machine, seed: u64) -> Result<Compared> {
    let case = Case::of(machine, seed)?;
    let (found, steps) = (case.contacts(machine)?, &case.steps);
    let obstacles: Vec<Obstacle> =
        (0..machine.bodies.all.len()).map(Obstacle::Body).chain([Obstacle::Stock]).collect();
    let radius = machine.wire.diameter.mm() / 2.0 + case.margin;
    let bender = Bender::new(machine, steps, case.passages.clone(), 1.0).with_axes(case.goes.clone());
    let mut bender = bender.with_margin(case.margin);
    let mut all = Compared::default();
    let mut before = vec![false; obstacles.len()];
    for (k, step) in steps.iter().enumerate() {
        let own = |obstacle: Obstacle| found.iter().find(|one| one.step == k && one.obstacle == obstacle);
        let moments: Vec<Option<Moment>> = obstacles
            .iter()
            .map(|&one| own(one).map(|contact| moment(&bender, machine, (k, step), contact)))
            .collect();
        let also: Vec<Moment> = moments.iter().flatten().copied().collect();
        let mut seen =
            vec![Seen { first: None, least: f64::INFINITY, at_contact: f64::NAN }; obstacles.len()];
        bender.run(step, &also, &mut |now, bender| {
            for ((seen, &obstacle), at) in seen.iter_mut().zip(&obstacles).zip(&moments) {
                look(seen, radius, obstacle, (now, *at == Some(now)), bender);
            }
        });
        for (((seen, &obstacle), at), before) in seen.iter().zip(&obstacles).zip(&moments).zip(&mut before) {
            let peg = matches!(obstacle, Obstacle::Body(index) if machine.bodies.all[index].moves_with == MovesWith::Peg);
            let what = || {
                format!(
                    "program {seed}, step {k}, {obstacle:?}: {:?} {at:?}, least {}, at contact {}",
                    seen.first, seen.least, seen.at_contact
                )
            };
            match (*at, seen.first) {
                (None, None) => {}
                // It goes on from the step before, and is reported there.
                (None, Some((Phase::Feed, part))) if *before && part < 1e-9 => {}
                (None, Some(_)) => ensure!(seen.least > radius - EXACT, "missed: {}", what()),
                (Some((phase, part)), first) => {
                    // What the peg does before it bends moves nothing past anything else.
                    let least = if peg { -1.0 } else { 0.0 };
                    let first =
                        first.map(|(of, at)| (of, if of == Phase::Bend { at.max(least) } else { at }));
                    all.contacts += 1;
                    ensure!(seen.at_contact < radius + EXACT, "not a contact: {}", what());
                    let is_late = first.is_some_and(|first| (phase, part) > (first.0, first.1 + 1e-6));
                    ensure!(!is_late || seen.at_contact > radius - EXACT, "late: {}", what());
                    // What has met before the motion begins is met at its begin.
                    let begins = part <= if phase == Phase::Bend { least + 1e-9 } else { 1e-9 };
                    if !begins {
                        let apart = &mut all.apart[usize::from(!peg)];
                        *apart = apart.max((seen.at_contact - radius).abs());
                        ensure!(*apart < EXACT, "not the first: {}", what());
                    }
                }
            }
            *before = seen.first.is_some();
        }
    }
    Ok(all)
}

fn look(seen: &mut Seen, reach: f64, obstacle: Obstacle, (now, is_contact): (Moment, bool), bender: &Bender) {
    let Some(distance) = bender.distance_of(obstacle, now.0) else { return };
    if is_contact {
        seen.at_contact = distance;
    }
    seen.least = seen.least.min(distance);
    if distance < reach && seen.first.is_none() {
        seen.first = Some(now);
    }
}

/// When the bender is where the check reports a contact.
fn moment(bender: &Bender, machine: &Machine, (index, step): (usize, &Step), contact: &Contact) -> Moment {
    if contact.phase != Phase::Bend {
        return (contact.phase, contact.passed);
    }
    let bent = contact.bent.abs().rad() / Bender::pressed(machine, step.bend);
    let part = match bender.axes(index, step) {
        Some([begin, touch, end]) if bent <= 0.0 => contact.passed * (end - begin) / (touch - begin) - 1.0,
        _ => bent,
    };
    (Phase::Bend, part)
}
