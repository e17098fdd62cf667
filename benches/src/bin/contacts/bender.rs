//! A bender that pushes, turns and winds points, a little at a time, and looks how near they come: none of the code that is
//! measured but the distance of a point from a solid.

use anyhow::{Result, ensure};
use nalgebra::{Point3, Rotation3, Unit, Vector3};
use wirebend_core::bend::Step;
use wirebend_core::clearance::{Body, Contact, MovesWith, Obstacle, Phase};
use wirebend_core::plan::Machine;

/// How far things turn at a time, radians: 0.05°.
const TURN: f64 = 0.000_872_664_6;
/// How far the wire is fed at a time, mm.
const FEED: f64 = 0.05;
/// How far the points of the wire are apart, mm.
const SPACING: f64 = 0.5;

struct Bender<'a> {
    machine: &'a Machine,
    points: Vec<Point3<f64>>,
    head: f64,
    bend_before: f64,
}

/// What it sees: the phase, how far that has come, the rigid points, the head's angle.
type See<'s> = dyn FnMut(Phase, f64, &[Point3<f64>], f64) + 's;

impl Bender<'_> {
    fn run(&mut self, step: &Step, see: &mut See) {
        let radius = self.machine.bend_radius.mm();
        let size = step.bend.abs().rad();
        let corner = |bend: f64| radius * (bend / 2.0).tan();
        let fed = step.feed.mm() - corner(self.bend_before) - corner(size) + radius * size;
        let begin = self.points.clone();
        for part in parts(fed / FEED) {
            self.points = begin.iter().map(|at| at + Vector3::x() * (fed * part)).collect();
            see(Phase::Feed, part, &self.points, self.head);
        }
        let fresh = (1..).map(|k| fed - f64::from(k) * SPACING).take_while(|along| *along > 0.0);
        self.points.extend(fresh.map(|along| Point3::new(along, 0.0, 0.0)));
        let from = self.head;
        for part in parts(step.rotate.abs().rad() / TURN) {
            self.head = from - step.rotate.rad() * part;
            see(Phase::Rotate, part, &self.points, self.head);
        }
        if size > 0.0 {
            self.wind(step, size, see);
        }
        self.bend_before = size;
    }

    fn wind(&mut self, step: &Step, size: f64, see: &mut See) {
        let radius = self.machine.bend_radius.mm();
        let springback = self.machine.compensation.bend.springback.as_ref();
        let pressed = springback.map_or(step.bend, |model| model.bend_to(step.bend)).abs().rad();
        // What winds around the pin is not rigid any more.
        let straight = |at: &Point3<f64>| at.y.abs() < 1e-9 && at.z.abs() < 1e-9;
        self.points.retain(|at| !(straight(at) && at.x < radius * size));
        let mut bent = 0.0;
        for part in parts(pressed / TURN) {
            self.turn(step.bend.signum(), f64::midpoint(bent, pressed * part), pressed * part - bent);
            bent = pressed * part;
            see(Phase::Bend, part, &self.points, self.head);
        }
        for part in parts((pressed - size) / TURN) {
            let next = pressed - (pressed - size) * part;
            self.turn(step.bend.signum(), f64::midpoint(bent, next), next - bent);
            bent = next;
        }
    }

    /// Turns the points about where the wire leaves the pin.
    fn turn(&mut self, side: f64, bent: f64, by: f64) {
        let radius = self.machine.bend_radius.mm();
        let head = Rotation3::from_axis_angle(&Vector3::x_axis(), self.head);
        let across = head * Vector3::y() * side;
        let about =
            Point3::from(Vector3::x() * (radius * bent.sin()) + across * (radius * (1.0 - bent.cos())));
        let turn = Rotation3::from_axis_angle(&Unit::new_normalize(head * Vector3::z()), side * by);
        for at in &mut self.points {
            *at = about + turn * (*at - about);
        }
    }
}

/// 0 to 1 in so many parts.
fn parts(count: f64) -> impl Iterator<Item = f64> {
    let count = count.ceil();
    (0..)
        .map(f64::from)
        .take_while(move |k| *k <= count)
        .map(move |k| if count > 0.0 { k / count } else { 1.0 })
}

fn distance(body: &Body, at: &Point3<f64>, head: f64) -> f64 {
    let turned = if body.moves_with == MovesWith::Head { -head } else { 0.0 };
    let at = Rotation3::from_axis_angle(&Vector3::x_axis(), turned) * at;
    body.solid.distance(&(body.at.inverse() * at))
}

/// Of each step and body: the phase of the first contact and how far that had come, and the least distance.
type Seen = Vec<Vec<(Option<(Phase, f64)>, f64)>>;

fn look(machine: &Machine, bodies: &[&Body], steps: &[Step]) -> Seen {
    let mut bender = Bender { machine, points: vec![Point3::origin()], head: 0.0, bend_before: 0.0 };
    let radius = machine.wire.diameter.mm() / 2.0;
    let step = |step: &Step| {
        let mut seen = vec![(None, f64::INFINITY); bodies.len()];
        bender.run(step, &mut |phase, part, points, head| {
            for ((first, least), body) in seen.iter_mut().zip(bodies) {
                let near = points.iter().map(|at| distance(body, at, head)).fold(f64::INFINITY, f64::min);
                *least = f64::min(*least, near);
                if near < radius && first.is_none() {
                    *first = Some((phase, part));
                }
            }
        });
        seen
    };
    steps.iter().map(step).collect()
}

/// Compares random programs of up to 9 bends; what the peg meets and what may touch the wire is left out.
pub fn compare(machine: &Machine, programs: u64) -> Result<()> {
    let is_plain = |body: &Body| body.moves_with != MovesWith::Peg && body.contact_zone.mm() <= 0.0;
    let all = machine.bodies.all.iter().enumerate().filter(|(_, body)| is_plain(body));
    let (indices, bodies): (Vec<usize>, Vec<&Body>) = all.unzip();
    let threads = u64::try_from(std::thread::available_parallelism()?.get())?;
    let (mut contacts, mut apart) = (0, 0.0_f64);
    let (indices, bodies) = (&indices[..], &bodies[..]);
    let run = &|thread: u64| -> Result<Vec<(usize, f64)>> {
        let every = (thread..programs).step_by(usize::try_from(threads)?);
        every
            .map(|seed| {
                let steps = super::program(seed, usize::try_from(1 + seed % 9)?)?;
                compare_one(machine, &steps, &super::contacts(machine, &steps), (indices, bodies))
            })
            .collect()
    };
    std::thread::scope(|scope| -> Result<()> {
        let all: Vec<_> = (0..threads).map(|thread| scope.spawn(move || run(thread))).collect();
        for one in all {
            for (more, farthest) in one.join().map_err(|_| anyhow::anyhow!("a comparison panicked"))?? {
                contacts += more;
                apart = apart.max(farthest);
            }
        }
        Ok(())
    })?;
    println!(
        "{programs} random programs, {contacts} contacts: none missed, none too many; the first contact at most {apart:.4} of its motion apart"
    );
    Ok(())
}

fn compare_one(
    machine: &Machine,
    steps: &[Step],
    found: &[Contact],
    (indices, bodies): (&[usize], &[&Body]),
) -> Result<(usize, f64)> {
    let radius = machine.wire.diameter.mm() / 2.0;
    let (mut contacts, mut apart) = (0, 0.0_f64);
    let mut before = vec![false; bodies.len()];
    for (k, seen) in look(machine, bodies, steps).into_iter().enumerate() {
        for (which, (first, least)) in seen.into_iter().enumerate() {
            let obstacle = Obstacle::Body(indices[which]);
            let own = found.iter().find(|one| one.step == k && one.obstacle == obstacle);
            match (own, first) {
                (None, None) => {}
                // It goes on from the step before, and is reported there.
                (None, Some((Phase::Feed, part))) if before[which] && part < 1e-9 => {}
                // The points of the bender are as far apart as SPACING, so that it may miss what is hardly touched.
                (Some(own), None) => ensure!(least < radius + SPACING, "{own:?} is {least} away"),
                (None, Some(at)) => {
                    ensure!(
                        least > radius - 0.01,
                        "step {k} misses {} at {at:?}, {least}",
                        bodies[which].name
                    );
                }
                (Some(own), Some((phase, part))) => {
                    contacts += 1;
                    let size = machine.compensation.bend.springback.as_ref();
                    let pressed = size.map_or(steps[k].bend, |model| model.bend_to(steps[k].bend));
                    let at = if phase == Phase::Bend { own.bent.rad() / pressed.rad() } else { own.passed };
                    ensure!((own.phase, at) <= (phase, part + 0.01), "{own:?} after {phase:?} {part}");
                    if own.phase == phase && least < radius - SPACING {
                        apart = apart.max(part - at);
                    }
                }
            }
            before[which] = first.is_some();
        }
    }
    Ok((contacts, apart))
}
