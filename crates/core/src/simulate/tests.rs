use nalgebra::{Matrix3, Vector3};

use super::*;
use crate::bend::replay;
use crate::plan::{DoublingChoice, PlanOptions, WirePlan, plan_wires};
use crate::testing::{chain, deg, mm, published_machine, wireframe};
use crate::wireframe::Wireframe;

mod senses;

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

fn on(_: &ImperfectWire) -> ControlFlow<()> {
    ControlFlow::Continue(())
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
    let report = with_input(&plan, &[], |input| simulate(input, &errors, 4000, 7, on).unwrap());
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
    let report = with_input(&planned(&w), &[], |input| simulate(input, &errors, 1, 1, on).unwrap());
    // 100 mm swung by 2° is 3.49 mm; the corner itself moves by what a larger arc takes.
    assert!((report.deviations[2].mean.mm() - 3.49).abs() < 0.1, "{}", report.deviations[2].mean);
    assert!(report.deviations[1].mean < mm(0.1));
}

#[test]
fn a_bowed_strut_is_shorter_from_end_to_end() {
    let w = chain(&[[0., 0., 0.], [100., 0., 0.]]);
    for (bow, lost) in [(0.5, 100.0 - 200.0 / std::f64::consts::PI), (0.02, 0.1066), (0.0, 0.0)] {
        let errors = ErrorModel { curvature: ErrorTerm { bias: bow, sigma: 0.0 }, ..ErrorModel::default() };
        let report = with_input(&planned(&w), &[], |input| simulate(input, &errors, 1, 1, on).unwrap());
        // Half a circle rises by half its diameter; a slight bow f takes 8/3·f².
        assert!((report.deviations[1].mean.mm() - lost).abs() < 1e-3, "{}", report.deviations[1].mean);
    }
}

/// A vertex within a bowed strut lies where one comes to that walks along the arc, to whichever side it goes.
#[test]
fn a_vertex_within_a_bowed_strut_lies_on_its_arc() {
    const PIECES: u32 = 200_000;
    let plan = planned(&chain(&[[0., 0., 0.], [30., 0., 0.], [100., 0., 0.]]));
    let bow: f64 = 0.1;
    let errors = ErrorModel { curvature: ErrorTerm { bias: bow, sigma: 0.0 }, ..ErrorModel::default() };
    let (turn, piece) = (4.0 * (2.0 * bow).atan(), 100.0 / f64::from(PIECES));
    let (mut at, mut walked) = ([0.0, 0.0], Vec::new());
    for k in 0..PIECES {
        let along = turn * ((f64::from(k) + 0.5) / f64::from(PIECES) - 0.5);
        at = [at[0] + piece * along.cos(), at[1] - piece * along.sin()];
        walked.push(at);
    }
    let mut sum = Vector3::zeros();
    let mut wires = 0;
    with_input(&plan, &[], |input| {
        simulate(input, &errors, 400, 1, |wire| {
            for (vertex, k) in [(1, PIECES * 3 / 10 - 1), (2, PIECES - 1)] {
                let made = wire.points[vertex] - wire.points[0];
                let [along, aside] = walked[k as usize];
                assert!((made.x - along).abs() < 1e-6, "{vertex}: {made} {along}");
                assert!((made.yz().norm() - aside.abs()).abs() < 1e-6, "{vertex}: {made} {aside}");
            }
            sum += wire.points[1].coords;
            wires += 1;
            ControlFlow::Continue(())
        })
        .unwrap();
    });
    // To all sides alike: the mean of so many lies near the line.
    let mean = sum / f64::from(wires);
    assert!(mean.yz().norm() < 4.0 * walked[(PIECES * 3 / 10) as usize][1].abs() / 400f64.sqrt(), "{mean}");
}

/// What is off in a wire depends on its number: more wires are those of before and others.
#[test]
fn more_wires_begin_with_the_same_ones() {
    let plan = planned(&twisted());
    let errors = ErrorModel { bend_deg: off(0.5), curvature: off(0.01), ..ErrorModel::default() };
    let drawn = |runs| {
        let mut wires = Vec::new();
        with_input(&plan, &[], |input| {
            simulate(input, &errors, runs, 4, |wire| {
                wires.push(wire.clone());
                ControlFlow::Continue(())
            })
        })
        .unwrap();
        wires
    };
    let (few, many) = (drawn(7), drawn(STEPS_AT_ONCE / 4));
    assert_eq!((few.as_slice(), many.len()), (&many[..7], (STEPS_AT_ONCE / 4) as usize));
    assert!(many.windows(2).all(|pair| pair[0] != pair[1]));
    // And each is the one that is bent alone.
    for (run, wire) in (0..).zip(&few) {
        let alone = with_input(&plan, &[], |input| wire_of_run(input, &errors, 4, run)).unwrap();
        assert_eq!(&alone, wire, "wire {run}");
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
        |seed| with_input(&plan, &[vec![0, 4]], |input| simulate(input, &errors, 50, seed, on).unwrap());
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
        let refused = with_input(&plan, &[], |input| simulate(input, &errors, 1, 1, on));
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
                assert!((told.step.bend - step.bend - wrong).rad().abs() < 1e-12);
            }
            ControlFlow::Continue(())
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

const fn off(sigma: f64) -> ErrorTerm {
    ErrorTerm { bias: 0.0, sigma }
}

/// A small error that is the same everywhere moves every vertex as the first order says.
#[test]
fn single_errors_move_the_wire_as_the_first_order_says() {
    let plan = planned(&twisted());
    for (of, bias) in [(ErrorSource::Feed, 1e-3), (ErrorSource::Rotation, 1e-3), (ErrorSource::Bend, 1e-3)] {
        let errors = ErrorModel::default().with(of, ErrorTerm { bias, sigma: 0.0 });
        with_input(&plan, &[], |input| {
            let linear = first_order(input, &errors).unwrap();
            let perfect = perfect_wire(input);
            let mut made = Vec::new();
            simulate(input, &errors, 1, 1, |wire| {
                made.clone_from(&wire.points);
                ControlFlow::Continue(())
            })
            .unwrap();
            for ((made, perfect), mean) in made.iter().zip(&perfect).zip(&linear.mean) {
                let left = (made - perfect - mean).norm();
                assert!(left < 1e-6, "{of:?}: {left} of {mean}");
            }
            assert!(linear.mean.last().unwrap().norm() > 1e-3, "{of:?}");
        });
    }
}

/// Drawn many times, the vertices of a wire scatter as the first order says: as far as so many draws tell.
#[test]
fn small_errors_scatter_as_the_first_order_says() {
    let plan = planned(&twisted());
    let errors = ErrorModel {
        feed_mm: off(0.1),
        rotate_deg: off(0.2),
        bend_deg: off(0.2),
        curvature: ErrorTerm { bias: 0.01, sigma: 0.02 },
    };
    with_input(&plan, &[], |input| {
        let linear = first_order(input, &errors).unwrap();
        let perfect = perfect_wire(input);
        let (mut sum, mut squares) =
            (vec![Vector3::zeros(); perfect.len()], vec![Matrix3::zeros(); perfect.len()]);
        let runs = 20_000;
        simulate(input, &errors, runs, 5, |wire| {
            for (k, (made, perfect)) in wire.points.iter().zip(&perfect).enumerate() {
                let way = made - perfect;
                sum[k] += way;
                squares[k] += way * way.transpose();
            }
            ControlFlow::Continue(())
        })
        .unwrap();
        let n = f64::from(runs);
        for k in 1..perfect.len() {
            let mean = sum[k] / n;
            let covariance = squares[k] / n - mean * mean.transpose();
            let spread = linear.covariance[k].trace().sqrt();
            assert!((mean - linear.mean[k]).norm() < 0.03 * spread, "{k}: {mean} {}", linear.mean[k]);
            let left = (covariance - linear.covariance[k]).norm() / linear.covariance[k].norm();
            assert!(left < 0.03, "{k}: {left}");
        }
    });
}

/// A bow takes 8/3·f² of a strut: of normal bows that are even to both sides the mean is 8/3·σ², and the deviation √2 times that.
#[test]
fn bows_shorten_a_wire_by_their_mean_square() {
    let plan = planned(&chain(&[[0., 0., 0.], [100., 0., 0.]]));
    let errors = ErrorModel { curvature: off(0.01), ..ErrorModel::default() };
    let found = with_input(&plan, &[], |input| first_order(input, &errors).unwrap());
    let shorter = 100.0 * 8.0 / 3.0 * 1e-4;
    assert!((found.mean[1].norm() - shorter).abs() < 2e-3 * shorter, "{}", found.mean[1]);
    let deviation = found.covariance[1].trace().sqrt();
    assert!((deviation - 2f64.sqrt() * shorter).abs() < 5e-3 * shorter, "{deviation}");
}

/// Every source alone, and every step alone: what they are of the whole.
#[test]
fn sources_and_steps_add_up_to_the_whole() {
    let plan = planned(&twisted());
    let errors =
        ErrorModel { feed_mm: off(0.3), rotate_deg: off(0.5), bend_deg: off(0.7), ..ErrorModel::default() };
    let found = with_input(&plan, &[], |input| first_order(input, &errors).unwrap());
    let vertices = f64::from(u32::try_from(found.covariance.len()).unwrap());
    let whole = found.covariance.iter().map(Matrix3::trace).sum::<f64>() / vertices;
    let by_source: f64 = found.sources.iter().map(|effect| effect.rms_mm.powi(2)).sum();
    let by_step: f64 = found
        .steps
        .iter()
        .map(|step| step.feed_mm.powi(2) + step.rotate_mm.powi(2) + step.bend_mm.powi(2))
        .sum();
    assert!((by_source - whole).abs() < 1e-9 * whole && (by_step - whole).abs() < 1e-9 * whole);
    // The first bends swing the most of the wire.
    let bends: Vec<f64> = found.steps.iter().map(|step| step.bend_mm).filter(|bend| *bend > 0.0).collect();
    assert!(bends[0] > *bends.last().unwrap());
    for of in ErrorSource::ALL {
        let alone = ErrorModel::default().with(of, errors.term(of));
        let alone = with_input(&plan, &[], |input| first_order(input, &alone).unwrap());
        let k = ErrorSource::ALL.iter().position(|source| *source == of).unwrap();
        assert_eq!(alone.sources[k], found.sources[k]);
    }
}

#[test]
fn a_simulation_ends_when_it_need_not_go_on() {
    let plan = planned(&twisted());
    let errors = ErrorModel { feed_mm: off(0.3), ..ErrorModel::default() };
    let mut runs = 0;
    with_input(&plan, &[], |input| {
        simulate(input, &errors, 1000, 1, |_| {
            runs += 1;
            if runs < 10 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        })
    })
    .unwrap();
    assert_eq!(runs, 10);
}
