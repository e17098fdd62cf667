//! Contacts against a bender that is looked at again and again.

use anyhow::{Result, anyhow, ensure};
use wirebend_benches::bender::{Bender, Moment};
use wirebend_core::bend::Step;
use wirebend_core::clearance::{Contact, MovesWith, Obstacle, Phase};
use wirebend_core::plan::Machine;

/// The first contact is this exact, mm. The peg of the bender follows the wire exactly, that of the check in straight parts.
const EXACT: f64 = 0.01;
const EXACT_OF_PEG: f64 = 0.05;

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
        "{programs} random programs seen at every 0.05 degrees and mm: {} contacts, none missed, none too many; at the first contact \
         at most {:.4} mm from touching ({:.4} mm where the peg is what is met)",
        all.contacts, all.apart[1], all.apart[0]
    );
    Ok(())
}

fn compare_one(machine: &Machine, seed: u64) -> Result<Compared> {
    let steps = super::program(seed, usize::try_from(1 + seed % 9)?)?;
    let found = super::contacts(machine, &steps);
    let obstacles: Vec<Obstacle> =
        (0..machine.bodies.all.len()).map(Obstacle::Body).chain([Obstacle::Stock]).collect();
    let radius = machine.wire.diameter.mm() / 2.0;
    let mut bender = Bender::new(machine, &steps, super::passages(&steps), 1.0);
    let mut all = Compared::default();
    let mut before = vec![false; obstacles.len()];
    for (k, step) in steps.iter().enumerate() {
        let own = |obstacle: Obstacle| found.iter().find(|one| one.step == k && one.obstacle == obstacle);
        let moments: Vec<Option<Moment>> =
            obstacles.iter().map(|&one| own(one).map(|contact| moment(machine, step, contact))).collect();
        let also: Vec<Moment> = moments.iter().flatten().copied().collect();
        let mut seen =
            vec![Seen { first: None, least: f64::INFINITY, at_contact: f64::NAN }; obstacles.len()];
        bender.run(step, &also, &mut |now, bender| {
            for ((seen, &obstacle), at) in seen.iter_mut().zip(&obstacles).zip(&moments) {
                look(seen, machine, obstacle, now, *at == Some(now), bender);
            }
        });
        for (((seen, &obstacle), at), before) in seen.iter().zip(&obstacles).zip(&moments).zip(&mut before) {
            let peg = matches!(obstacle, Obstacle::Body(index) if machine.bodies.all[index].moves_with == MovesWith::Peg);
            let exact = if peg { EXACT_OF_PEG } else { EXACT };
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
                (None, Some(_)) => ensure!(seen.least > radius - exact, "missed: {}", what()),
                (Some((phase, part)), first) => {
                    all.contacts += 1;
                    ensure!(seen.at_contact < radius + exact, "not a contact: {}", what());
                    let is_late = first.is_some_and(|first| (phase, part) > (first.0, first.1 + 1e-6));
                    ensure!(!is_late || seen.at_contact > radius - exact, "late: {}", what());
                    // What has met before the motion begins is met at its begin.
                    let begins = part <= if phase == Phase::Bend { -1.0 + 1e-9 } else { 1e-9 };
                    if !begins {
                        let apart = &mut all.apart[usize::from(!peg)];
                        *apart = apart.max((seen.at_contact - radius).abs());
                        ensure!(*apart < exact, "not the first: {}", what());
                    }
                }
            }
            *before = seen.first.is_some();
        }
    }
    Ok(all)
}

fn look(
    seen: &mut Seen,
    machine: &Machine,
    obstacle: Obstacle,
    now: Moment,
    is_contact: bool,
    bender: &Bender,
) {
    let Some(distance) = bender.distance_of(obstacle, now.0) else { return };
    if is_contact {
        seen.at_contact = distance;
    }
    seen.least = seen.least.min(distance);
    if distance < machine.wire.diameter.mm() / 2.0 && seen.first.is_none() {
        seen.first = Some(now);
    }
}

/// When the bender is where the check reports a contact.
fn moment(machine: &Machine, step: &Step, contact: &Contact) -> Moment {
    if contact.phase != Phase::Bend {
        return (contact.phase, contact.passed);
    }
    let bent = contact.bent.abs().rad() / Bender::pressed(machine, step.bend);
    let part = match Bender::axes(machine, step) {
        Some([begin, touch, end]) if bent <= 0.0 => contact.passed * (end - begin) / (touch - begin) - 1.0,
        _ => bent,
    };
    (Phase::Bend, part)
}
