//! Struts that are too long or too short.

use wirebend_accuracy::{Closing, ClosingModel};

use super::truss::{DEPTH, DEPTH_OF_TEST, STRUT, Truss, axial_stiffness};
use super::{feeds, near};

/// P/(EA σ/L) and w/(D σ/L) of a truss.
fn normalised(truss: &Truss, model: &ClosingModel, closing: Closing) -> [f64; 2] {
    let expected = model.straight().unwrap().expected(closing, &feeds(1.0), &truss.faces()).unwrap();
    [expected.axial_rms * STRUT / axial_stiffness(), expected.surface_rms * STRUT / truss.diameter()]
}

/// The force is that of s redundant struts among m, √(s/m) with s = m - 3n + 6: closed formula, and a truss of pin-jointed bars with
/// initial strains in `OpenSees`. The surface is that of the independent program, the expectation over all errors.
#[test]
fn forces_and_surfaces_of_trusses_of_one_to_five_rings() {
    let surfaces = [(1, 0.3356), (2, 0.2610), (3, 0.2229), (4, 0.2008), (5, 0.1868)];
    for (rings, surface) in surfaces {
        let truss = Truss::new(rings, DEPTH);
        #[allow(clippy::cast_precision_loss)] // a few hundred
        let (struts, nodes) = (truss.struts.len() as f64, truss.points.len() as f64);
        let [force, found] = normalised(&truss, &truss.single_struts(), Closing::Coupled);
        near(force, ((struts - 3.0 * nodes + 6.0) / struts).sqrt(), 1e-4);
        near(found, surface, 1e-3);
    }
}

/// The truss of the authors' accuracy test as they route it, with its doubled struts.
#[test]
fn the_truss_of_the_accuracy_test() {
    let truss = Truss::new(1, DEPTH_OF_TEST);
    let [force, surface] = normalised(&truss, &truss.walked("accuracy-test"), Closing::Coupled);
    near(force, 0.5125, 1e-4);
    near(surface, 0.3168, 1e-3);
}

/// A straight strut that is too long only pushes: whether joints turn before they are locked makes no difference.
#[test]
fn lengths_close_alike_either_way() {
    let truss = Truss::new(1, DEPTH_OF_TEST);
    let model = truss.walked("accuracy-test");
    let [aligned, coupled] =
        [Closing::Aligned, Closing::Coupled].map(|closing| normalised(&truss, &model, closing));
    near(aligned[0], coupled[0], 1e-9);
    near(aligned[1], coupled[1], 1e-9);
}

/// Each strut on its own has nothing to resist it: pulled to its ends by the same force that it has then.
#[test]
fn a_lone_strut_is_pulled_by_its_own_stiffness() {
    let truss = Truss::new(1, DEPTH);
    let prepared = truss.single_struts();
    let expected =
        prepared.straight().unwrap().expected(Closing::Aligned, &feeds(0.2), &truss.faces()).unwrap();
    near(expected.largest_pull.unwrap(), 0.2 * axial_stiffness() / STRUT, 1e-6);
    // ½ E A L (σ/L)² in each.
    near(expected.energy, 78.0 / 2.0 * axial_stiffness() * 0.04 / STRUT, 1e-6);
}
