//! Which motions are off, and to which side.

use super::*;

/// The head turns once in a wire of three planes that has its first bend in the first of them: only what is after that turn moves. Two legs
/// and a flat wire have no rotation that could be off.
#[test]
fn a_rotation_that_is_not_made_is_not_off() {
    let errors = ErrorModel { rotate_deg: ErrorTerm { bias: 5.0, sigma: 3.0 }, ..ErrorModel::default() };
    let moved = |points: &[[f64; 3]]| {
        let plan = planned(&chain(points));
        with_input(&plan, &[], |input| {
            let linear = first_order(input, &errors).unwrap();
            let report = simulate(input, &errors, 20, 1, on).unwrap();
            let said = linear.steps.iter().map(|step| step.rotate_mm > 0.0).collect::<Vec<_>>();
            (report.deviations.iter().map(|of| of.mean.mm() > 0.1).collect::<Vec<_>>(), said)
        })
    };
    let flat = [[0., 0., 0.], [100., 0., 0.], [100., 80., 0.], [180., 80., 0.]];
    assert_eq!(moved(&flat[..3]), (vec![false; 3], vec![false; 2]));
    assert_eq!(moved(&flat), (vec![false; 4], vec![false; 3]));
    let solid = [[0., 0., 0.], [100., 0., 0.], [100., 80., 0.], [100., 80., 60.]];
    assert_eq!(moved(&solid), (vec![false, false, false, true], vec![false, true, false]));
}

/// A machine that bends 2 degrees too far does so to either side.
#[test]
fn a_constant_bend_error_is_in_the_sense_of_each_bend() {
    let zigzag = chain(&[[0., 0., 0.], [80., 0., 0.], [110., 60., 0.], [190., 60., 0.], [230., 10., 0.]]);
    let plan = planned(&zigzag);
    let sides: Vec<f64> =
        plan.scheduled.as_ref().unwrap().steps.iter().map(|step| step.bend.signum()).collect();
    assert!(sides.contains(&1.0) && sides.contains(&-1.0), "{sides:?}");
    let errors = ErrorModel { bend_deg: ErrorTerm { bias: 2.0, sigma: 0.0 }, ..ErrorModel::default() };
    with_input(&plan, &[], |input| {
        let bent = |points: &[Point3<f64>]| -> Vec<f64> {
            let ways: Vec<Vector3<f64>> = points.windows(2).map(|pair| pair[1] - pair[0]).collect();
            ways.windows(2).map(|pair| pair[0].angle(&pair[1]).to_degrees()).collect()
        };
        let linear = first_order(input, &errors).unwrap();
        let (wanted, wire) = (bent(input.design), wire_of_run(input, &errors, 1, 0).unwrap());
        for (wanted, made) in wanted.iter().zip(bent(&wire.points)) {
            assert!((made - wanted - 2.0).abs() < 1e-6, "{made} instead of {wanted}");
        }
        for ((made, design), mean) in wire.points.iter().zip(input.design).zip(&linear.mean) {
            assert!(
                (made - design - mean).norm() < 0.05 * mean.norm() + 0.05,
                "{mean} instead of {}",
                made - design
            );
        }
    });
}
