//! The wire beside its design.

use nalgebra::{Rotation3, Vector3};
use wirebend_driver_wirebend_kit::bench::{CompareError, Made};

use super::compensation::{ALL, Step, replay};
use super::hand::{Hand, published};

const PROGRAM: [Step; 4] = [
    Step { feed_mm: 40.0, rotate_deg: 0.0, bend_deg: 80.0 },
    Step { feed_mm: 45.0, rotate_deg: 70.0, bend_deg: 60.0 },
    Step { feed_mm: 50.0, rotate_deg: -40.0, bend_deg: -100.0 },
    Step { feed_mm: 55.0, rotate_deg: 0.0, bend_deg: 0.0 },
];

fn made() -> Made {
    let mut hand = Hand::new(published());
    ALL.run(&PROGRAM, &mut hand);
    hand.bench.made()
}

fn moved(path: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let turn = Rotation3::from_euler_angles(0.3, -1.1, 2.0);
    path.iter().map(|&p| (turn * Vector3::from(p) + Vector3::new(100.0, -20.0, 7.0)).into()).collect()
}

#[test]
fn a_design_may_lie_anywhere() {
    let design = replay(&PROGRAM);
    let (here, there) = (made().deviations(&design).unwrap(), made().deviations(&moved(&design)).unwrap());
    assert_eq!(here.vertices, [0, 1, 2, 3, 4]);
    assert!(here.worst_from_start_mm() < 1.5, "{here:?}");
    for (here, there) in here.from_start_mm.iter().zip(&there.from_start_mm) {
        assert!((here - there).abs() < 1e-9);
    }
    for (here, there) in here.fitted_mm.iter().zip(&there.fitted_mm) {
        assert!((here - there).abs() < 1e-9);
    }
}

#[test]
fn a_wire_is_not_off_from_itself() {
    let deviations = made().deviations(&moved(&made().corners())).unwrap();
    assert!(deviations.worst_from_start_mm() < 1e-9 && deviations.worst_fitted_mm() < 1e-9);
    assert!(deviations.angle_deg.iter().chain(&deviations.edge_mm).all(|error| error.abs() < 1e-6));
}

#[test]
fn a_mirror_image_does_not_fit() {
    let mirrored: Vec<[f64; 3]> = made().corners().iter().map(|p| [p[0], p[1], -p[2]]).collect();
    let deviations = made().deviations(&mirrored).unwrap();
    assert!(deviations.worst_from_start_mm() > 20.0 && deviations.worst_fitted_mm() > 5.0, "{deviations:?}");
    // Lengths and angles do not distinguish a shape from its mirror image.
    assert!(deviations.angle_deg.iter().chain(&deviations.edge_mm).all(|error| error.abs() < 1e-6));
}

#[test]
fn angles_and_lengths_are_made_minus_designed() {
    let mut corners = made().corners();
    // The last edge a millimetre shorter in the design.
    let (from, to) = (Vector3::from(corners[3]), Vector3::from(corners[4]));
    corners[4] = (to - (to - from).normalize()).into();
    let deviations = made().deviations(&corners).unwrap();
    assert!((deviations.edge_mm[3] - 1.0).abs() < 1e-9 && deviations.edge_mm[2].abs() < 1e-9);
    assert!((deviations.from_start_mm[4] - 1.0).abs() < 1e-9);
    // The best fit shares the millimetre out.
    assert!(deviations.worst_fitted_mm() < 1.0 && deviations.fitted_mm[0] > 1e-3);
}

#[test]
fn vertices_on_a_straight_are_left_out() {
    let mut design = replay(&PROGRAM);
    design.insert(2, [0, 1, 2].map(|i| f64::midpoint(design[1][i], design[2][i])));
    assert_eq!(made().deviations(&design).unwrap().vertices, [0, 1, 3, 4, 5]);
}

#[test]
fn another_number_of_bends_is_told() {
    let mut design = replay(&PROGRAM);
    design.pop();
    assert_eq!(made().deviations(&design).unwrap_err(), CompareError::Count { designed: 4, made: 5 });
    assert_eq!(made().deviations(&[]).unwrap_err(), CompareError::Count { designed: 0, made: 5 });
    design.push([0.0, f64::NAN, 0.0]);
    assert_eq!(made().deviations(&design).unwrap_err(), CompareError::NotFinite { vertex: 4 });
}

/// A straight wire has no plane; neither way round of it breaks the comparison.
#[test]
fn a_straight_wire_is_compared_as_well() {
    let mut hand = Hand::new(published());
    hand.feed(50.0);
    for end in [[50.0, 0.0, 0.0], [-50.0, 0.0, 0.0], [0.0, 0.0, 50.0]] {
        let deviations = hand.bench.made().deviations(&[[0.0; 3], end]).unwrap();
        assert!(deviations.worst_from_start_mm() < 0.02 && deviations.worst_fitted_mm() < 0.02);
    }
}
