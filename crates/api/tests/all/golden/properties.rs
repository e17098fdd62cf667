//! What holds for every case, whatever its numbers are. What holds of exported files is in `tests/exports`.

use std::collections::BTreeMap;

use nalgebra::Point3;
use wirebend_api::{Command, DiagnosticCode, Input, Response, SimulateRequest};
use wirebend_core::bend::{Frame, Step, replay};
use wirebend_files::document::Job;

use crate::cases::{Case, proper_misfits, run};

pub fn assert_all(case: &Case) {
    for machine in ["wirebend-kit", "pensa-diwire-pro", "howtomechatronics", "grbl-bender"] {
        routes_use_every_edge(case, machine);
        what_cannot_be_made_says_why(case, machine);
        if let Some(bytes) = case.job(machine) {
            jobs_bend_into_the_design(case, machine, &bytes);
        }
    }
}

/// A wire that cannot be made has an error to fix.
fn what_cannot_be_made_says_why(case: &Case, machine: &str) {
    for wire in case.plan(machine).wires() {
        let errors =
            wire.diagnostics.iter().filter(|d| d.severity == wirebend_api::SeverityName::Error).count();
        assert_eq!(wire.feasible, errors == 0, "{} on {machine}", case.about);
    }
}

/// The route is the drawn edges plus the doubled ones, no more and no less.
fn routes_use_every_edge(case: &Case, machine: &str) {
    for wire in case.plan(machine).wires() {
        let Some(route) = &wire.route else { continue };
        let mut times: BTreeMap<u32, usize> = BTreeMap::new();
        for &edge in &route.edges {
            *times.entry(edge).or_default() += 1;
        }
        assert_eq!(times.len(), wire.wireframe.edges, "{}: an edge is left out", case.about);
        for &edge in &route.doubled {
            *times.get_mut(&edge).unwrap() -= 1;
        }
        assert!(times.values().all(|&count| count == 1), "{}: an edge is made too often", case.about);
        assert_eq!(route.feeds, wire.wireframe.edges + route.doubled_edges);
        assert_eq!(route.vertices.len(), route.feeds + 1);
        assert!(route.optimal, "{}", case.about);
    }
}

/// Bent by a machine without errors, the compensated program gives the design back, and so does
/// replaying the nominal one.
fn jobs_bend_into_the_design(case: &Case, machine: &str, bytes: &[u8]) {
    let job = Job::open(bytes, "job").unwrap();
    for wire in &job.contents().wires {
        let path: Vec<Point3<f64>> = wire.path_mm.iter().copied().map(Point3::from).collect();
        let steps: Vec<Step> = wire.nominal.iter().map(|&step| Step::try_from(step).unwrap()).collect();
        let corners: Vec<Point3<f64>> =
            std::iter::once(path[0]).chain(wire.spans.iter().map(|span| path[span[1]])).collect();
        let total: f64 = steps.iter().map(|step| step.feed.mm()).sum();
        // A bend below what the axis resolves is not bent: that is what may be missing.
        let missing = misfit(&corners, &replay(Frame::default(), &steps));
        assert!(missing <= 1e-9 * total + 1e-6, "{} on {machine}: replay is {missing} mm off", case.about);
    }
    let sealed = Input::Bytes { name: "job.wbjob".into(), bytes: bytes.to_vec() };
    let Ok(Response::Simulate(found)) = run(&Command::Simulate(SimulateRequest::of(sealed))) else {
        panic!("{}: the job cannot be simulated", case.about)
    };
    let plan = case.plan(machine);
    let unpressed = |code| {
        use DiagnosticCode::{CornerTooNear, FeedTooShort, LeadTooShort};
        matches!(code, CornerTooNear | FeedTooShort | LeadTooShort)
    };
    for ((wire, planned), report) in found.wires.iter().zip(&job.contents().wires).zip(plan.wires()) {
        let total: f64 = planned.nominal.iter().map(|step| step.feed_mm).sum();
        let off = wire.worst_systematic_mm;
        // Such a bend is commanded as on a straight leg, and the checks say that it comes out otherwise.
        if off > 1.0 && report.diagnostics.iter().any(|found| unpressed(found.code)) {
            continue;
        }
        assert!(
            off <= 1e-9 * total + 1e-6,
            "{} on {machine}: the compensated wire is {off} mm off",
            case.about
        );
    }
}

/// The largest distance between two paths after the best rotation and shift.
fn misfit(a: &[Point3<f64>], b: &[Point3<f64>]) -> f64 {
    proper_misfits(a, b).into_iter().fold(0.0, f64::max)
}
