//! What holds for any closed frame, however it lies and whatever its vertices are called.

use nalgebra::{Point3, Rotation3, Vector3};
use proptest::prelude::*;
use wirebend_accuracy::{Closed, Closing, ClosingModel, FrameWire, Surface};
use wirebend_core::bend::program_of_path;
use wirebend_core::simulate::ErrorModel;
use wirebend_core::units::Angle;

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
        let whole = prepared.expected(closing, errors, &model.whole()).unwrap();
        assert!((whole.surface_rms - expected.vertices_rms).abs() <= 1e-12 * expected.vertices_rms);
        [
            expected.surface_rms,
            expected.vertices_rms,
            expected.axial_rms,
            expected.von_mises_rms,
            expected.energy,
            expected.largest_pull.unwrap_or(1.0),
            closed.surface_rms(&surface),
            closed.surface_rms(&model.whole()),
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
        [&all[..6], &all[12..18]].concat()
    };
    let back: Vec<usize> = walk("accuracy-test").into_iter().rev().collect();
    same(&expected(&back), &expected(&walk("accuracy-test")));
}

/// The truss of the accuracy test, wired by the program of its path and closed, expected and drawn.
fn closed(
    points: &[Point3<f64>],
    vertices: &[usize],
    closing: Closing,
    errors: &ErrorModel,
) -> (Vec<f64>, Closed) {
    let path: Vec<Point3<f64>> = vertices.iter().map(|&vertex| points[vertex]).collect();
    let (start, program) = program_of_path(&path, Angle::from_deg(1e-4).unwrap()).unwrap();
    let wire = FrameWire { vertices: vertices.to_vec(), start, program };
    let model = ClosingModel::new(points, &[wire], &steel_wire()).unwrap();
    let (prepared, surface) = (model.straight().unwrap(), Surface::faces(points, &faces()));
    let expected = prepared.expected(closing, errors, &surface).unwrap();
    let drawn = prepared.close(closing, &model.draw(errors, 5, 0).unwrap());
    (vec![expected.surface_rms, expected.energy, drawn.surface_rms(&surface), drawn.energy], drawn)
}

/// Passes of this walk whose strut to the next is walked once.
fn single_struts(walk: &[usize]) -> Vec<usize> {
    let strut = |k: usize| [walk[k].min(walk[k + 1]), walk[k].max(walk[k + 1])];
    let count = |of: [usize; 2]| (1..walk.len()).filter(|&k| strut(k - 1) == of).count();
    (1..walk.len()).map(|k| k - 1).filter(|&k| count(strut(k)) == 1).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    /// A vertex on a strut, where no joint is, changes nothing for the others: the wire is fed over it. Where passes are aligned first,
    /// a strut that begins at a wrong angle is pulled to that vertex too, and so it is only with lengths that this holds.
    #[test]
    fn a_vertex_on_a_strut_changes_nothing(place in any::<prop::sample::Index>(), share in 0.2..0.8_f64) {
        let points = Truss::new(1, DEPTH_OF_TEST).points;
        let walk = walk("accuracy-test");
        let singles = single_struts(&walk);
        let strut = singles[place.index(singles.len())];
        let [a, b] = [points[walk[strut]], points[walk[strut + 1]]];
        let (mut split, mut through) = (points.clone(), walk.clone());
        split.push(a + (b - a) * share);
        through.insert(strut + 1, points.len());
        for (closing, errors) in [
            (Closing::Coupled, feeds(0.2)),
            (Closing::Coupled, both_errors()),
            (Closing::Aligned, feeds(0.2)),
        ] {
            let (wanted, whole) = closed(&points, &walk, closing, &errors);
            let (found, cut) = closed(&split, &through, closing, &errors);
            same(&found, &wanted);
            let largest = whole.displacements.iter().map(Vector3::norm).fold(0.0, f64::max);
            for (found, wanted) in cut.displacements.iter().zip(&whole.displacements) {
                prop_assert!((found - wanted).norm() <= 1e-9 * largest, "{closing:?}: {found} instead of {wanted}");
            }
            let mut twice = whole.axial.clone();
            twice.insert(strut, whole.axial[strut]);
            for (k, (found, wanted)) in cut.axial.iter().zip(&twice).enumerate() {
                prop_assert!((found - wanted).abs() <= 1e-9 * whole.axial_rms(), "{closing:?}, strut {k}: {found} N instead of {wanted}");
            }
        }
    }
}
