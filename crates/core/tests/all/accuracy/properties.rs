//! What holds for any closed frame, however it lies and whatever its vertices are called.

use nalgebra::{Point3, Rotation3, Vector3};
use proptest::prelude::*;
use wirebend_core::accuracy::{Closing, ClosingModel, Surface};
use wirebend_core::simulate::ErrorModel;

use super::truss::{DEPTH_OF_TEST, Truss, steel_wire, walk};
use super::{angles, feeds};

/// All figures of the truss of the accuracy test along a walk, closed either way: expected of all wires, and of one that is drawn.
fn figures(
    points: Vec<Point3<f64>>,
    vertices: &[usize],
    faces: &[Vec<usize>],
    errors: &ErrorModel,
) -> Vec<f64> {
    let truss = Truss { points, ..Truss::new(1, DEPTH_OF_TEST) };
    let model = ClosingModel::new(&truss.points, &[truss.wire(vertices)], &steel_wire()).unwrap();
    let (prepared, surface) = (model.straight().unwrap(), Surface::faces(&truss.points, faces));
    let draw = model.draw(errors, 5, 0).unwrap();
    let closings = [Closing::Aligned, Closing::Coupled].map(|closing| {
        let expected = prepared.expected(closing, errors, &surface).unwrap();
        let closed = prepared.close(closing, &draw);
        [
            expected.surface_rms,
            expected.axial_rms,
            expected.von_mises_rms,
            expected.energy,
            expected.largest_pull.unwrap_or(1.0),
            closed.surface_rms(&surface),
            closed.axial_rms(),
            closed.von_mises_rms(),
            closed.energy,
            closed.largest_pull().unwrap_or(1.0),
        ]
    });
    closings.concat()
}

fn faces() -> Vec<Vec<usize>> {
    vec![(0..12).collect(), (12..24).collect()]
}

fn both_errors() -> ErrorModel {
    ErrorModel { feed_mm: feeds(0.2).feed_mm, ..angles(0.2) }
}

fn same(found: &[f64], wanted: &[f64]) {
    for (k, (found, wanted)) in found.iter().zip(wanted).enumerate() {
        assert!((found - wanted).abs() <= 1e-9 * wanted, "figure {k}: {found} instead of {wanted}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]

    #[test]
    fn axes_do_not_matter(turn in prop::array::uniform3(-3.0..3.0_f64), shift in prop::array::uniform3(-50.0..50.0_f64)) {
        let points = Truss::new(1, DEPTH_OF_TEST).points;
        let turn = Rotation3::new(Vector3::from(turn));
        let moved = points.iter().map(|point| turn * point + Vector3::from(shift)).collect();
        let of = |points| figures(points, &walk("accuracy-test"), &faces(), &both_errors());
        same(&of(moved), &of(points));
    }

    #[test]
    fn names_do_not_matter(shuffle in Just((0..24).collect::<Vec<usize>>()).prop_shuffle()) {
        let points = Truss::new(1, DEPTH_OF_TEST).points;
        let mut named = points.clone();
        for (old, &new) in shuffle.iter().enumerate() {
            named[new] = points[old];
        }
        let name = |vertices: Vec<usize>| -> Vec<usize> { vertices.into_iter().map(|old| shuffle[old]).collect() };
        let found = figures(named, &name(walk("accuracy-test")), &faces().into_iter().map(name).collect::<Vec<_>>(), &both_errors());
        same(&found, &figures(points, &walk("accuracy-test"), &faces(), &both_errors()));
    }
}

/// A wire that is bent from its other end has the same lengths. Each of its expectations is the same; a drawn wire is another.
#[test]
fn lengths_do_not_care_where_the_wire_begins() {
    let points = Truss::new(1, DEPTH_OF_TEST).points;
    let expected = |vertices: &[usize]| {
        let all = figures(points.clone(), vertices, &faces(), &feeds(0.2));
        [&all[..5], &all[10..15]].concat()
    };
    let back: Vec<usize> = walk("accuracy-test").into_iter().rev().collect();
    same(&expected(&back), &expected(&walk("accuracy-test")));
}
