//! A wire to write: three dimensions, both signs of both turns, nothing that rounds to zero.

use crate::{DesignStep, Job, MachineRef, MaterialRef, Step, Wire};

/// A job of one wire of four straight parts, with whole numbers, so that no format has to round.
#[must_use]
pub fn job() -> Job {
    of(&[(60.0, 90.0, 90.0), (40.0, -90.0, 90.0), (50.0, 45.0, -60.0), (70.0, 0.0, 0.0)])
}

/// The mirror image of [`job`]: every rotation with the other sign.
#[must_use]
pub fn mirrored() -> Job {
    of(&[(60.0, -90.0, 90.0), (40.0, 90.0, 90.0), (50.0, -45.0, -60.0), (70.0, 0.0, 0.0)])
}

fn of(steps: &[(f64, f64, f64)]) -> Job {
    let radius = 3.0;
    let corner = |bend_deg: f64| radius * (bend_deg.abs().to_radians() / 2.0).tan();
    let mut before = 0.0;
    let mut design = Vec::with_capacity(steps.len());
    for &(feed_mm, rotate_deg, bend_deg) in steps {
        let straight_mm = Some(feed_mm - before - corner(bend_deg));
        before = corner(bend_deg);
        design.push(DesignStep { feed_mm, rotate_deg, bend_deg, straight_mm });
    }
    let machine = steps.iter().map(|&(feed_mm, rotate_deg, bend_deg)| Step {
        feed_mm,
        rotate_deg,
        bend_deg,
        approach_deg: None,
    });
    Job {
        name: "sample".to_owned(),
        job_hash: Some("5a".repeat(32)),
        design_hash: "a5".repeat(32),
        machine: MachineRef { id: "sample-bender".to_owned(), name: "Sample bender".to_owned() },
        material: MaterialRef { id: "steel-2mm".to_owned(), name: "Steel 2 mm".to_owned(), diameter_mm: 2.0 },
        bend_radius_mm: radius,
        wires: vec![Wire {
            path_mm: path(steps),
            design,
            machine: Some(machine.collect()),
            stock_mm: Some(420.0),
            time_s: Some(30.0),
        }],
    }
}

type Vector = [f64; 3];

/// The corners: the turtle of [`Step`], feed, then rotate b about t, then bend t about b.
fn path(steps: &[(f64, f64, f64)]) -> Vec<Vector> {
    let (mut at, mut t, mut b) = ([0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    let mut points = vec![at];
    for &(feed, rotate, bend) in steps {
        at = [at[0] + feed * t[0], at[1] + feed * t[1], at[2] + feed * t[2]];
        points.push(at);
        b = turned(b, t, rotate);
        t = turned(t, b, bend);
    }
    points
}

/// `v`, which is at a right angle to `axis`, turned about it.
fn turned(v: Vector, axis: Vector, degrees: f64) -> Vector {
    let side =
        [axis[1] * v[2] - axis[2] * v[1], axis[2] * v[0] - axis[0] * v[2], axis[0] * v[1] - axis[1] * v[0]];
    let (sin, cos) = degrees.to_radians().sin_cos();
    std::array::from_fn(|k| v[k] * cos + side[k] * sin)
}
