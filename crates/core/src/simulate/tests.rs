use super::*;
use crate::bend::replay;
use crate::plan::{DoublingChoice, PlanOptions, WirePlan, plan_wires};
use crate::testing::{chain, deg, mm, published_machine, wireframe};
use crate::wireframe::Wireframe;

fn planned(w: &Wireframe) -> WirePlan {
    let options = PlanOptions { doubling: DoublingChoice::Cheapest, ..PlanOptions::default() };
    plan_wires(w, &w.components()[0], &published_machine(), &options, |_| ()).remove(0)
}

fn with_input<T>(plan: &WirePlan, passes: &[Vec<usize>], then: impl FnOnce(&SimulationInput) -> T) -> T {
    let machine = published_machine();
    let spans = plan.nominal.as_ref().unwrap().spans.iter().cloned();
    then(&SimulationInput {
        start: scheduled_start(plan.start, &plan.scheduled.as_ref().unwrap().steps),
        design: &plan.path,
        fractions: &fractions(&plan.path, spans),
        passes,
        program: plan.compensated.as_ref().unwrap(),
        compensation: &machine.compensation,
    })
}

/// A twisted wire with straight joints, bends to both sides and no two planes alike.
fn twisted() -> Wireframe {
    chain(&[
        [0., 0., 0.],
        [40., 0., 0.],
        [80., 0., 0.],
        [80., 50., 0.],
        [80., 50., 60.],
        [20., 60., 80.],
        [20., 0., 120.],
        [90., 10., 100.],
    ])
}

#[test]
fn without_errors_the_compensated_program_makes_the_design() {
    let plan = planned(&twisted());
    let made = with_input(&plan, &[], perfect_wire);
    for (design, made) in plan.path.iter().zip(&made) {
        assert!((design - made).norm() < 1e-8, "{design} became {made}");
    }
}

#[test]
fn without_compensation_the_same_machine_misses() {
    // The design's own figures sent as commands: the springback alone opens every bend.
    let mut plan = planned(&twisted());
    let bare = Compensation::default();
    plan.compensated = crate::compensate::compensate(plan.scheduled.as_ref().unwrap(), &bare).ok();
    let made = with_input(&plan, &[], perfect_wire);
    let worst = plan.path.iter().zip(&made).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
    assert!(worst > 20.0, "{worst}");
}

#[test]
fn feed_errors_add_up_along_a_straight_wire_as_statistics_say() {
    // Four struts with slight bends: the end is off by the sum of four normal errors along it.
    let w = chain(&[[0., 0., 0.], [60., 0., 0.], [120., 1., 0.], [180., 0., 0.], [240., 1., 0.]]);
    let plan = planned(&w);
    let errors = ErrorModel { feed_mm: ErrorTerm { bias: 0.0, sigma: 0.5 }, ..ErrorModel::default() };
    let report = with_input(&plan, &[], |input| simulate(input, &errors, 4000, 7, |_| ()).unwrap());
    // Half-normal with sigma 0.5·√4 = 1: mean √(2/π) = 0.798, 95 % within 1.960.
    let end = report.deviations[4];
    assert!((end.mean.mm() - 0.798).abs() < 0.03, "{}", end.mean);
    assert!((end.radius_95.mm() - 1.960).abs() < 0.08, "{}", end.radius_95);
    assert_eq!(report.deviations[0].mean, Length::ZERO);
}

#[test]
fn a_constant_bend_error_swings_the_rest_of_the_wire() {
    let w = chain(&[[0., 0., 0.], [100., 0., 0.], [100., 100., 0.]]);
    let errors = ErrorModel { bend_deg: ErrorTerm { bias: 2.0, sigma: 0.0 }, ..ErrorModel::default() };
    let report = with_input(&planned(&w), &[], |input| simulate(input, &errors, 1, 1, |_| ()).unwrap());
    // 100 mm swung by 2° is 3.49 mm; the corner itself moves by what a larger arc takes.
    assert!((report.deviations[2].mean.mm() - 3.49).abs() < 0.1, "{}", report.deviations[2].mean);
    assert!(report.deviations[1].mean < mm(0.1));
}

#[test]
fn a_bowed_strut_is_shorter_from_end_to_end() {
    let w = chain(&[[0., 0., 0.], [100., 0., 0.]]);
    for (bow, lost) in [(0.5, 100.0 - 200.0 / std::f64::consts::PI), (0.02, 0.1066), (0.0, 0.0)] {
        let errors = ErrorModel { curvature: ErrorTerm { bias: bow, sigma: 0.0 }, ..ErrorModel::default() };
        let report = with_input(&planned(&w), &[], |input| simulate(input, &errors, 1, 1, |_| ()).unwrap());
        // Half a circle rises by half its diameter; a slight bow f takes 8/3·f².
        assert!((report.deviations[1].mean.mm() - lost).abs() < 1e-3, "{}", report.deviations[1].mean);
    }
}

#[test]
fn a_seed_gives_the_same_runs_and_another_one_others() {
    let w = wireframe(
        &[[0., 0., 0.], [60., 0., 0.], [60., 60., 0.], [0., 60., 0.]],
        &[(0, 1), (1, 2), (2, 3), (3, 0)],
    );
    let plan = planned(&w);
    let errors = ErrorModel { bend_deg: ErrorTerm { bias: 0.0, sigma: 0.75 }, ..ErrorModel::default() };
    let run =
        |seed| with_input(&plan, &[vec![0, 4]], |input| simulate(input, &errors, 50, seed, |_| ()).unwrap());
    assert_eq!(run(1), run(1));
    assert_ne!(run(1), run(2));
    // The square ends where it starts: the gap between the two passes is the deviation of its end.
    assert_eq!(run(1).gaps[0], run(1).deviations[4]);
}

#[test]
fn commands_leave_what_they_were_compensated_for() {
    let plan = planned(&twisted());
    let formed = formed_steps(plan.compensated.as_ref().unwrap(), &published_machine().compensation);
    for (formed, wanted) in formed.iter().zip(&plan.scheduled.as_ref().unwrap().steps) {
        assert!((formed.bend - wanted.bend).abs() < deg(1e-7));
        assert!((formed.feed - wanted.feed).abs() < mm(1e-7));
    }
}

#[test]
fn errors_that_are_no_numbers_are_refused() {
    let plan = planned(&twisted());
    for term in [ErrorTerm { bias: f64::NAN, sigma: 1.0 }, ErrorTerm { bias: 0.0, sigma: -1.0 }] {
        let errors = ErrorModel { rotate_deg: term, ..ErrorModel::default() };
        let refused = with_input(&plan, &[], |input| simulate(input, &errors, 1, 1, |_| ()));
        assert_eq!(refused.unwrap_err().of, ErrorSource::Rotation);
    }
}

/// What collides is looked for along these steps: were they not those of the wire, it would be looked for elsewhere.
#[test]
fn the_steps_of_a_wire_with_errors_lead_along_it() {
    let plan = planned(&twisted());
    let errors = ErrorModel {
        feed_mm: ErrorTerm { bias: 0.1, sigma: 0.4 },
        rotate_deg: ErrorTerm { bias: -0.5, sigma: 2.0 },
        bend_deg: ErrorTerm { bias: 1.0, sigma: 2.0 },
        curvature: ErrorTerm { bias: 0.0, sigma: 0.02 },
    };
    let scheduled = &plan.scheduled.as_ref().unwrap().steps;
    let start = scheduled_start(plan.start, scheduled);
    let told = plan.compensated.as_ref().unwrap().steps();
    with_input(&plan, &[], |input| {
        simulate(input, &errors, 20, 3, |wire| {
            let corners = replay(start, &wire.steps);
            // Vertex 1 lies on a straight.
            let bent: Vec<_> = (0..wire.points.len()).filter(|&k| k != 1).map(|k| wire.points[k]).collect();
            assert_eq!(corners.len(), bent.len());
            for (corner, point) in corners.iter().zip(&bent) {
                assert!((corner - point).norm() < 1e-9, "{corner} {point}");
            }
            let (begin, steps) = steps_of_corners(&corners, &start, scheduled).unwrap();
            assert!((begin.position - start.position).norm() < 1e-12);
            for (k, (one, other)) in steps.iter().zip(&wire.steps).enumerate() {
                let turned = one.rotate - other.rotate;
                let off = (one.feed - other.feed).mm().abs()
                    + turned.rad().abs()
                    + (one.bend - other.bend).rad().abs();
                assert!(off < 1e-7, "{k}: {one:?} {other:?}");
            }
            for ((made, told), step) in wire.steps.iter().zip(&wire.told).zip(told) {
                let wrong = made.bend - published_machine().compensation.bend.result(step.bend);
                assert!((told.bend - step.bend - wrong).rad().abs() < 1e-12);
            }
        })
        .unwrap()
    });
}

#[test]
fn corners_that_are_not_those_of_the_steps_are_no_wire() {
    let plan = planned(&twisted());
    let scheduled = &plan.scheduled.as_ref().unwrap().steps;
    let corners = replay(scheduled_start(plan.start, scheduled), scheduled);
    let start = scheduled_start(plan.start, scheduled);
    assert!(steps_of_corners(&corners, &start, scheduled).is_some());
    assert!(steps_of_corners(&corners[1..], &start, scheduled).is_none());
    let mut same = corners.clone();
    same[2] = same[1];
    assert!(steps_of_corners(&same, &start, scheduled).is_none());
    assert!(steps_of_corners(&[], &start, &[]).is_none());
}
