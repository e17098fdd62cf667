//! Time, mass, cost, and what errors do.

use std::ops::ControlFlow;

use nalgebra::Point3;
use wirebend_core::bend::{Frame, Step, program_of_path};
use wirebend_core::checks::{BendTorque, Source, Sourced};
use wirebend_core::compensate::{
    BendModel, CompensatedProgram, Compensation, FeedModel, MotionModel, PegGeometry, Springback, compensate,
};
use wirebend_core::estimate::{TimeModel, WireModel};
use wirebend_core::sag::max_sag;
use wirebend_core::schedule::ScheduledProgram;
use wirebend_core::simulate::{ErrorModel, ErrorReport, ErrorTerm, SimulationInput, fractions, simulate};

use crate::physics::document::Document;
use crate::physics::{deg, mm};

pub fn claims(page: &mut Document) {
    times(page);
    wire(page);
    torque(page);
    bend_radius(page);
    sag(page);
    errors(page);
}

/// The published bender with its wire.
fn published() -> Compensation {
    Compensation {
        feed: Some(FeedModel::new(mm(1.5), mm(3.0), 0.3)),
        bend: BendModel {
            springback: Some(Springback::Constant(deg(10.23))),
            setback: Some(PegGeometry::new(mm(20.4), mm(12.0), mm(3.0), mm(4.675)).unwrap()),
            axis_limit: None,
            before_zero: false,
        },
        motion: MotionModel::default(),
    }
}

fn times(page: &mut Document) {
    let [feed, rotate, bend] = page.sentence("The published rates are {} mm/s, {}°/s and {}°/s.");
    let [fixed, edges, angle, one, minutes, seconds] = page.sentence(
        "t_bend is {} s, fitted on the published cube of {} edges: a bend of {}° takes {} s, the cube {}:{}, as published.",
    );
    let model = TimeModel {
        feed_mm_per_s: feed.value,
        rotate_deg_per_s: rotate.value,
        bend_deg_per_s: bend.value,
        fixed_per_bend_s: fixed.value,
        fixed_per_feed_s: 0.0,
        fixed_per_turn_s: 0.0,
    };
    let right_angle = published().bend.command(deg(angle.value)).unwrap();
    one.is(model.bend_seconds(right_angle));
    // Its sides are 30 mm; the plane changes twice, by a right angle each time.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a few edges
    let edges = edges.value as usize;
    let bends = (0..edges - 1).map(|k| Step {
        feed: mm(30.0),
        rotate: deg(if k == 2 || k == 4 { 90.0 } else { 0.0 }),
        bend: deg(angle.value),
    });
    let steps: Vec<Step> = bends.chain([Step { feed: mm(30.0), ..Step::default() }]).collect();
    let program = compensate(&ScheduledProgram { steps, head: Vec::new() }, &published()).unwrap();
    let took = model.seconds(&program);
    // In whole seconds.
    assert!((took - (60.0 * minutes.value + seconds.value)).abs() < 0.5, "{took} s");
}

fn wire(page: &mut Document) {
    let [diameter, density, mass, cost, price] = page
        .sentence("A metre of aluminium wire of {} mm ({} kg/m³) weighs {} g and costs {} USD at {} USD/mm.");
    let wire = WireModel {
        diameter: mm(diameter.value),
        density_kg_per_m3: density.value,
        youngs_modulus_gpa: 68.03,
        price_per_mm: Some(price.value),
    };
    mass.is(wire.mass_g(mm(1000.0)));
    cost.is(wire.cost(mm(1000.0)).unwrap());
}

fn torque(page: &mut Document) {
    let [] = page.sentence("at the plastic moment σ·d³ / 6.");
    let [strength, diameter, moment] = page.sentence("At {} MPa a wire of {} mm takes {} N·m.");
    let [available, times, thicker_times, thicker] = page.sentence(
        "The bend axis of the paper has {} N·m, {} times as much [SCF25], and {} times what {} mm of the same alloy take.",
    );
    let needed = |diameter: f64, strength: f64| {
        let source = Source { reason: None, entry: String::new() };
        BendTorque::beside(Sourced { value: available.value, source }, mm(diameter), strength).needed_n_m
    };
    moment.is(needed(diameter.value, strength.value));
    times.is(available.value / needed(diameter.value, strength.value));
    thicker_times.is(available.value / needed(thicker.value, strength.value));
    let [steel_times, steel, spring, soft, soft_times] = page.sentence(
        "The {} times that it states for {} mm of steel are those of {} MPa, hard-drawn wire: the low-carbon steel that ships has {} MPa, and {} times.",
    );
    steel_times.is(available.value / needed(steel.value, spring.value));
    soft_times.is(available.value / needed(steel.value, soft.value));
    // That it warns there is a test of the check.
    let [_margin] = page.sentence("There is a warning below {} times:");
}

fn bend_radius(page: &mut Document) {
    let [] =
        page.sentence("The outside of a bend is stretched by d / (2·(r + d / 2)) at an inner radius of r.");
    let [diameter, pin, stretched] =
        page.sentence("A wire of {} mm round a pin of {} mm is stretched by {} %,");
    stretched.is(100.0 * diameter.value / (2.0 * (pin.value + diameter.value / 2.0)));
    // Published, and computed by nobody.
    let [_breaks] = page.sentence("and a test bar of that alloy breaks at {} % [SCF25];");
    // A pin of the wire's own diameter has half of it for a radius; the others are read off data sheets.
    let [steel] = page.sentence(
        "Cold-drawn low-carbon steel has to go round a pin of its own diameter [A82], which is {} diameters;",
    );
    steel.is(1.0 / 2.0);
    let [_copper, _brass] =
        page.sentence("half-hard copper strip holds at {} [KME], quarter-hard brass strip at {} [Olin].");
}

fn sag(page: &mut Document) {
    let [diameter, modulus, density, deflection, length] =
        page.sentence("A straight aluminium wire of {} mm with {} GPa and {} kg/m³ sags by {} mm at {} mm.");
    let wire = WireModel {
        diameter: mm(diameter.value),
        density_kg_per_m3: density.value,
        youngs_modulus_gpa: modulus.value,
        price_per_mm: None,
    };
    let straight = Step { feed: mm(length.value), ..Step::default() };
    let found = max_sag(Frame::default(), &[straight], &wire).unwrap();
    deflection.is(found.deflection.mm());
}

/// A wire through points, bent with errors on a machine that compensates nothing.
fn bent(points: &[[f64; 3]], errors: &ErrorModel, runs: u32) -> ErrorReport {
    let path: Vec<_> = points.iter().map(|&point| Point3::from(point)).collect();
    let (start, program) = program_of_path(&path, deg(0.001)).unwrap();
    let none = Compensation::default();
    let trial = SimulationInput {
        start,
        design: &path,
        fractions: &fractions(&path, program.spans.clone()),
        passes: &[],
        program: &CompensatedProgram::from_job_steps(program.steps, &none),
        compensation: &none,
    };
    simulate(&trial, errors, runs, 7, |_| ControlFlow::Continue(())).unwrap()
}

fn errors(page: &mut Document) {
    let [percent] = page.sentence("the radius that holds {} % of all runs");
    let [sigma, mean, radius, of_runs] = page.sentence(
        "Four feeds in a row with σ = {} mm: the end is off by {} mm on average, and by less than {} mm in {} % of all runs.",
    );
    assert!((percent.value - of_runs.value).abs() < f64::EPSILON);
    // A normal distribution with the standard deviation of four feeds: its mean distance, and what 95 % of it lies within.
    let deviation = sigma.value * 4_f64.sqrt();
    mean.is(deviation * (2.0 / std::f64::consts::PI).sqrt());
    radius.is(1.959_964 * deviation);
    let along = [[0., 0., 0.], [60., 0., 0.], [120., 1., 0.], [180., 0., 0.], [240., 1., 0.]];
    let term = |bias, sigma| ErrorTerm { bias, sigma };
    let report =
        bent(&along, &ErrorModel { feed_mm: term(0.0, sigma.value), ..ErrorModel::default() }, 20_000);
    let end = report.deviations.last().unwrap();
    assert!(
        (end.mean.mm() - mean.value).abs() < 0.02 && (end.radius_95.mm() - radius.value).abs() < 0.05,
        "{end:?}"
    );

    let [bend, too_large, leg, swung] =
        page.sentence("A bend of {}° that comes out {}° too large swings a leg of {} mm by {} mm.");
    assert!((bend.value - 90.0).abs() < f64::EPSILON);
    let corner = [[0., 0., 0.], [100., 0., 0.], [100., leg.value, 0.]];
    let report =
        bent(&corner, &ErrorModel { bend_deg: term(too_large.value, 0.0), ..ErrorModel::default() }, 1);
    swung.is(report.deviations.last().unwrap().mean.mm());

    let [length, bow, shorter] =
        page.sentence("A straight part of {} mm with a bow of {} (rise over length) is {} mm shorter.");
    let straight = [[0., 0., 0.], [length.value, 0., 0.]];
    let report = bent(&straight, &ErrorModel { curvature: term(bow.value, 0.0), ..ErrorModel::default() }, 1);
    shorter.is(report.deviations.last().unwrap().mean.mm());

    let [length, bow, aside] = page
        .sentence("A vertex in the middle of a straight part of {} mm with a bow of {} goes {} mm aside.");
    let halved = [[0., 0., 0.], [length.value / 2.0, 0., 0.], [length.value, 0., 0.]];
    let report = bent(&halved, &ErrorModel { curvature: term(bow.value, 0.0), ..ErrorModel::default() }, 1);
    aside.is(report.deviations[1].mean.mm());
    aside.is(bow.value * length.value);

    let [sigma, percent] =
        page.sentence("Bows of σ = {} to either side make straight parts shorter by {} % on average.");
    // A bow f takes 8/3·f² of a straight part, nearly.
    percent.is(100.0 * 8.0 / 3.0 * sigma.value * sigma.value);
    let report =
        bent(&straight, &ErrorModel { curvature: term(0.0, sigma.value), ..ErrorModel::default() }, 20_000);
    let shorter = 100.0 * report.deviations.last().unwrap().mean.mm() / length.value;
    assert!((shorter - percent.value).abs() < 0.01, "{shorter}");
}

#[test]
fn times_and_errors_are_what_the_page_says() {
    claims(&mut Document::read());
}
