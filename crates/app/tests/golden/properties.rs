//! What holds for every case, whatever its numbers are.

use std::collections::BTreeMap;

use nalgebra::{Matrix3, Point3, Vector3};
use wirebend_app::{Input, Request, Response, SimulateRequest};
use wirebend_core::bend::{Convention, Frame, Step, replay};
use wirebend_core::units::Length;
use wirebend_files::document::Job;
use wirebend_files::read::{Format, ReadOptions, read};

use crate::case::{Case, run};

pub fn assert_all(case: &Case) {
    for machine in ["wirebend-kit", "pensa-diwire-pro", "howtomechatronics", "grbl-bender"] {
        routes_use_every_edge(case, machine);
        what_cannot_be_made_says_why(case, machine);
        if let Some(bytes) = case.job(machine) {
            jobs_bend_into_the_design(case, machine, &bytes);
        }
    }
    exports_read_back_to_the_same_wire(case);
}

/// A wire that cannot be made has an error to mend.
fn what_cannot_be_made_says_why(case: &Case, machine: &str) {
    for wire in case.plan(machine).wires() {
        let errors =
            wire.diagnostics.iter().filter(|d| d.severity == wirebend_app::SeverityName::Error).count();
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
        // A bend below what the axis resolves is not made: that is what may be missing.
        let missing = misfit(&corners, &replay(Frame::default(), &steps));
        assert!(missing <= 1e-9 * total + 1e-6, "{} on {machine}: replay is {missing} mm off", case.about);
    }
    let request = SimulateRequest {
        job: Input::Bytes { name: "job.wbjob".into(), bytes: bytes.to_vec() },
        noise: None,
        runs: 1,
        seed: 1,
        svg: None,
        png: None,
    };
    let Ok(Response::Simulate(found)) = run(&Request::Simulate(request)) else {
        panic!("{}: the job cannot be simulated", case.about)
    };
    for (wire, planned) in found.wires.iter().zip(&job.contents().wires) {
        let total: f64 = planned.nominal.iter().map(|step| step.feed_mm).sum();
        let off = wire.worst_systematic_mm;
        assert!(
            off <= 1e-9 * total + 1e-6,
            "{} on {machine}: the compensated wire is {off} mm off",
            case.about
        );
    }
}

/// Tables and scripts, read by our readers, give the same wire within what their digits hold, with
/// the same handedness.
fn exports_read_back_to_the_same_wire(case: &Case) {
    let machine = "pensa-diwire-pro";
    for (format, name, decimals) in
        [("pensa-script", Format::Pensa, 5), ("lra-csv", Format::Lra, 3), ("xyz-csv", Format::Xyz, 3)]
    {
        let Ok(texts) = case.export(machine, format) else {
            continue;
        };
        let job = case.job(machine).expect("what can be exported can be planned");
        let job = Job::open(&job, "job").unwrap();
        for (text, wire) in texts.iter().zip(&job.contents().wires) {
            let design: Vec<Point3<f64>> = wire.path_mm.iter().copied().map(Point3::from).collect();
            let corners: Vec<Point3<f64>> =
                std::iter::once(design[0]).chain(wire.spans.iter().map(|span| design[span[1]])).collect();
            let radius = Length::from_mm(1.0 + 0.45).unwrap();
            let options = ReadOptions {
                clr: Some(radius),
                convention: Convention::default(),
                ..ReadOptions::default()
            };
            let found = read(text.as_bytes(), format, Some(name), &options).unwrap();
            let path = match &found.program {
                Some(program) => replay(Frame::default(), &program.program.steps),
                None => found.wireframe.vertices().map(|(_, vertex)| vertex.position).collect(),
            };
            let tolerance = rounding(decimals, &corners);
            // A polyline of points that the wire passes twice is welded: compare the set of points.
            if name == Format::Xyz {
                let nearest = |p: &Point3<f64>| path.iter().map(|q| (p - q).norm()).fold(f64::MAX, f64::min);
                assert!(design.iter().all(|p| nearest(p) < tolerance), "{}: {format}", case.about);
                continue;
            }
            assert_eq!(path.len(), corners.len(), "{}: {format}", case.about);
            let off = misfit(&corners, &path);
            assert!(off < tolerance, "{}: {format} reads back {off} mm off", case.about);
        }
    }
}

/// What rounding to so many decimals does to a wire: each step is off by half a digit in its length
/// and in its two angles, which swing the rest about its corner; such errors add up like a random
/// walk, of which twice the deviation is allowed.
fn rounding(decimals: i32, corners: &[Point3<f64>]) -> f64 {
    let half = 0.5 * 10f64.powi(-decimals);
    let far = corners.iter().map(|p| (p - corners[0]).norm()).fold(0.0, f64::max);
    #[allow(clippy::cast_precision_loss)]
    let steps = corners.len() as f64;
    2.0 * steps.sqrt() * (half + 2.0 * half.to_radians() * 2.0 * far)
}

/// The largest distance between two paths after the best rotation and shift; a mirror image stays one.
fn misfit(a: &[Point3<f64>], b: &[Point3<f64>]) -> f64 {
    assert_eq!(a.len(), b.len());
    #[allow(clippy::cast_precision_loss)]
    let mean =
        |points: &[Point3<f64>]| points.iter().map(|p| p.coords).sum::<Vector3<f64>>() / points.len() as f64;
    let (ma, mb) = (mean(a), mean(b));
    let covariance: Matrix3<f64> =
        a.iter().zip(b).map(|(p, q)| (q.coords - mb) * (p.coords - ma).transpose()).sum();
    let svd = covariance.svd(true, true);
    let (u, v_t) = (svd.u.unwrap(), svd.v_t.unwrap());
    let sign = (v_t.transpose() * u.transpose()).determinant().signum();
    // The least singular direction is flipped where the best fit would mirror.
    let least = svd.singular_values.imin();
    let mut diagonal = Vector3::repeat(1.0);
    diagonal[least] = sign;
    let rotation = v_t.transpose() * Matrix3::from_diagonal(&diagonal) * u.transpose();
    let distance =
        |(p, q): (&Point3<f64>, &Point3<f64>)| ((p.coords - ma) - rotation * (q.coords - mb)).norm();
    a.iter().zip(b).map(distance).fold(0.0, f64::max)
}
