//! Bends and rotations that are off.

use wirebend_accuracy::{Closing, Effects, Requirement, Surface, Vary, tolerance};
use wirebend_core::simulate::ErrorModel;

use super::truss::{DEPTH, DEPTH_OF_TEST, Truss};
use super::{angles, feeds, near};

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

/// Angles do to forces in the struts what lengths do only in second order: 0.017 N at 0.2°, where 0.2 mm make hundreds. The 0.39 to 0.46 N
/// of the authors are the rounding of their coordinates to 1 µm.
#[test]
fn angles_leave_struts_almost_without_force() {
    let truss = Truss::new(1, DEPTH);
    let model = truss.walked("ring-1");
    let expected =
        model.straight().unwrap().expected(Closing::Aligned, &angles(0.2), &truss.faces()).unwrap();
    near(expected.axial_rms, 0.017, 0.15);
}

/// With the deviations that are allowed the frame is as flat as required, by the expectation over both kinds of errors at once: also
/// where its faces are off by different shares of both.
#[test]
fn lengths_and_angles_together_are_as_flat_as_required() {
    let truss = Truss::new(1, DEPTH_OF_TEST);
    let model = truss.walked("accuracy-test");
    let prepared = model.straight().unwrap();
    let faces = Surface::faces(&truss.points, &[vec![0, 1, 2, 3, 4], (12..24).collect(), vec![5, 6, 9, 10]]);
    let expected = |errors: &ErrorModel| prepared.expected(Closing::Aligned, errors, &faces).unwrap();
    let effects = |errors: &ErrorModel| {
        let found = expected(errors);
        Effects { faces: found.faces_rms, force: found.axial_rms, stress: found.von_mises_rms }
    };
    let required = [(Requirement::Surface, 0.1)];
    let both = Vary::Both { feed_share: 0.5 };
    let found = tolerance(&effects(&feeds(1.0)), &effects(&angles(1.0)), &required, both).unwrap();
    let errors = ErrorModel {
        feed_mm: feeds(found.feed_sigma.unwrap()).feed_mm,
        ..angles(found.angle_sigma.unwrap())
    };
    let together = expected(&errors);
    near(together.surface_rms, 0.1, 1e-9);
    near(together.surface_rms, found.achieved.surface, 1e-9);
    near(together.axial_rms, found.achieved.force, 1e-9);
    near(together.von_mises_rms, found.achieved.stress, 1e-9);
}
