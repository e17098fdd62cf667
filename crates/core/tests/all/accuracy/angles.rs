//! Bends and rotations that are off.

use wirebend_core::accuracy::Closing;

use super::truss::{DEPTH, DEPTH_OF_TEST, Truss};
use super::{angles, near};

/// Root of the mean square von Mises stress over four points of the surface and 20 places of each strut, MPa, at 0.2° (2 %): the
/// authors' nonlinear runs have 5.0, 4.8 and 4.9 for 1, 3 and 5 rings.
#[test]
fn stresses_hardly_depend_on_the_size_of_the_truss() {
    for (rings, stress) in [(1, 4.95), (3, 4.90), (5, 4.93)] {
        let truss = Truss::new(rings, DEPTH);
        near(stress_at(&truss, &format!("ring-{rings}")), stress, 0.02);
    }
}

#[test]
fn stresses_of_the_truss_of_the_accuracy_test() {
    near(stress_at(&Truss::new(1, DEPTH_OF_TEST), "accuracy-test"), 4.47, 0.02);
}

fn stress_at(truss: &Truss, walk: &str) -> f64 {
    let model = truss.walked(walk);
    let expected = model.straight().unwrap().expected(Closing::Aligned, &angles(0.2), &truss.faces());
    expected.unwrap().von_mises_rms
}

/// Angles do to forces in the struts what lengths do only in second order: 0.017 N at 0.2°, where 0.2 mm make hundreds.
#[test]
fn angles_leave_struts_almost_without_force() {
    let truss = Truss::new(1, DEPTH);
    let model = truss.walked("ring-1");
    let expected =
        model.straight().unwrap().expected(Closing::Aligned, &angles(0.2), &truss.faces()).unwrap();
    near(expected.axial_rms, 0.017, 0.15);
}
