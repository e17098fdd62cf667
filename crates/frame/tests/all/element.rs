//! The stiffness of a member against the textbook's matrix in local axes, in every direction.

use nalgebra::{Matrix3, Point3, SMatrix, SVector, Vector3};
use proptest::prelude::*;
use wirebend_frame::{Assembly, Member, MemberForces, MemberId, Model, NodeId, Section, SectionId};

use crate::frames::STEEL;

type Matrix12 = SMatrix<f64, 12, 12>;

/// Przemieniecki, Theory of Matrix Structural Analysis (1968), eq. 5.116 without shear deformation.
fn textbook(section: &Section, l: f64) -> Matrix12 {
    let (e, g) = (section.e, section.g);
    let mut k = Matrix12::zeros();
    let mut put = |row: usize, column: usize, value: f64| {
        k[(row, column)] = value;
        k[(column, row)] = value;
    };
    let (axial, twist) = (e * section.area / l, g * section.j / l);
    for (at, value) in [(0, axial), (3, twist)] {
        put(at, at, value);
        put(at + 6, at + 6, value);
        put(at + 6, at, -value);
    }
    // Displacements along y with rotations about z; along z with those about y, which turn the other way.
    for (shift, turn, i, sign) in [(1, 5, section.iz, 1.0), (2, 4, section.iy, -1.0)] {
        let (shear, lever) = (12.0 * e * i / l.powi(3), sign * 6.0 * e * i / l.powi(2));
        put(shift, shift, shear);
        put(shift + 6, shift + 6, shear);
        put(shift + 6, shift, -shear);
        put(turn, shift, lever);
        put(turn + 6, shift, lever);
        put(shift + 6, turn, -lever);
        put(turn + 6, shift + 6, -lever);
        put(turn, turn, 4.0 * e * i / l);
        put(turn + 6, turn + 6, 4.0 * e * i / l);
        put(turn + 6, turn, 2.0 * e * i / l);
    }
    k
}

fn assert_textbook(span: Vector3<f64>, section: Section, up: Option<Vector3<f64>>) {
    let model = Model {
        nodes: vec![Point3::origin(), Point3::from(span)],
        members: vec![Member { up, ..Member::new(NodeId(0), NodeId(1), SectionId(0)) }],
        sections: vec![section],
        supports: Vec::new(),
    };
    let assembly = Assembly::new(&model).expect("a model");
    let axes: Matrix3<f64> = assembly.axes(MemberId(0));
    assert!(
        (axes.determinant() - 1.0).abs() < 1e-12
            && (axes * axes.transpose() - Matrix3::identity()).norm() < 1e-12
    );
    assert!((axes.row(0).transpose() - span.normalize()).norm() < 1e-12);
    let mut turn = Matrix12::zeros();
    for block in [0, 3, 6, 9] {
        turn.fixed_view_mut::<3, 3>(block, block).copy_from(&axes);
    }
    let expected = turn.transpose() * textbook(&section, span.norm()) * turn;
    for k in 0..12 {
        let mut ends = [0.0; 12];
        ends[k] = 1.0;
        let found = SVector::<f64, 12>::from(assembly.end_forces(MemberId(0), &ends));
        let differs = (found - expected.column(k)).norm();
        assert!(differs <= 1e-14 * expected.norm(), "{span:?}, column {k}: {differs}");
    }
}

fn flat() -> Section {
    let round = Section::round(0.9, &STEEL);
    Section { iy: 3.0 * round.iy, iz: round.iz / 2.0, j: 0.7 * round.j, ..round }
}

proptest! {
    #[test]
    fn any_direction(span in prop::array::uniform3(-80.0..80.0_f64), up in prop::array::uniform3(-1.0..1.0_f64)) {
        let (span, up) = (Vector3::from(span), Vector3::from(up));
        prop_assume!(span.norm() > 1.0 && up.cross(&span).norm() > 0.1 * span.norm());
        assert_textbook(span, Section::round(0.9, &STEEL), None);
        assert_textbook(span, flat(), None);
        assert_textbook(span, flat(), Some(up));
    }
}

/// Along the axes, where local axes have to be chosen.
#[test]
fn along_the_axes() {
    for axis in [Vector3::x(), Vector3::y(), Vector3::z(), -Vector3::z()] {
        assert_textbook(axis * 50.0, Section::round(0.9, &STEEL), None);
        assert_textbook(axis * 50.0, flat(), None);
    }
}

/// A beam on two pins under a line load, with a moment at one end: q s (L - s)/2 + M s/L is largest where q (L/2 - s) + M/L is zero,
/// here at five eighths of its length, and 25 q L²/128 there. At its ends and quarters it is 24 q L²/128 at most.
#[test]
fn the_largest_moment_is_found_between_the_quarters() {
    let (length, q, m) = (8.0, 2.0, 16.0);
    let (start, end) = (q * length / 2.0 + m / length, q * length / 2.0 - m / length);
    for swap in [false, true] {
        let mut forces = MemberForces { member: MemberId(0), length, local: [0.0; 12], line: [0.0, 0.0, -q] };
        (forces.local[2], forces.local[8], forces.local[10]) = (start, end, m);
        if swap {
            (forces.line, forces.local) = ([0.0, -q, 0.0], [0.0; 12]);
            (forces.local[1], forces.local[7], forces.local[11]) = (start, end, -m);
        }
        assert!((forces.peak_moment() - 25.0).abs() < 1e-12, "{}", forces.peak_moment());
    }
}

/// Local y is up × x, z unless told otherwise, and y for a member along z.
#[test]
fn local_axes() {
    let axes = |span: Vector3<f64>| {
        let model = crate::frames::beam(span);
        Assembly::new(&model).expect("a model").axes(MemberId(0))
    };
    assert_eq!(axes(Vector3::x()), Matrix3::identity());
    assert_eq!(axes(Vector3::z()).row(1).transpose(), Vector3::x());
}
