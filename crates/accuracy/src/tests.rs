//! Misfits against the motions that they stand for.

use nalgebra::{Point3, Vector3};
use proptest::prelude::*;
use wirebend_core::bend::program_of_path;
use wirebend_core::simulate::{ErrorModel, ErrorTerm};
use wirebend_frame::{
    Assembly, EndMotion, Load, Material, Member, MemberId, Model, NodeId, Section, SectionId, Support,
};

use super::draw::{gap, made};
use super::{Closing, ClosingModel, FrameWire, Surface};
use crate::testing::deg;

fn steel() -> Section {
    let e = 200_000.0;
    Section::round(1.0, &Material { e, g: e / 2.6, density: 7.8e-9, yield_strength: 500.0 })
}

fn wire(path: &[Point3<f64>], vertices: Vec<usize>) -> FrameWire {
    let (start, program) = program_of_path(path, deg(1e-3)).unwrap();
    FrameWire { vertices, start, program }
}

/// Errors so small that their squares do not count.
fn small() -> ErrorModel {
    let angle = ErrorTerm { bias: 2e-6, sigma: 1e-5 };
    let feed_mm = ErrorTerm { bias: 1e-6, sigma: 1e-5 };
    ErrorModel { feed_mm, rotate_deg: angle, bend_deg: angle, ..ErrorModel::default() }
}

/// Where the passes of a wire go that is held at its first one and is free otherwise: it has no stress, and only its misfits.
fn moved_by_misfits(model: &ClosingModel, draw: &super::Draw) -> Vec<Vector3<f64>> {
    let prepared = model.straight().unwrap();
    let own = prepared.own_ends(model.sources.iter().zip(draw.amounts.iter().copied()));
    let open = Model {
        nodes: model.passes.iter().map(|&vertex| model.vertices[vertex]).collect(),
        members: (1..model.passes.len())
            .map(|k| Member::new(NodeId(k - 1), NodeId(k), SectionId(0)))
            .collect(),
        sections: vec![model.section],
        supports: vec![Support::clamped(NodeId(0))],
    };
    let assembly = Assembly::new(&open).unwrap();
    let motions = own.iter().enumerate().map(|(k, &ends)| EndMotion { member: MemberId(k), ends });
    let load = Load { end_motions: motions.collect(), ..Load::default() };
    let response = assembly.factor(&assembly.all()).unwrap().solve(&load).unwrap();
    response.displacements.iter().map(|u| Vector3::new(u[0], u[1], u[2])).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// An open wire that nothing holds together lies where its motions leave it: signs and axes of every misfit are those of the
    /// machine's motion.
    #[test]
    fn misfits_are_the_motions_that_are_off(
        ways in prop::collection::vec(prop::array::uniform3(-30.0..30.0_f64), 3..8),
        seed in 0_u64..1000,
    ) {
        let mut path = vec![Point3::origin()];
        for way in ways {
            let next = path[path.len() - 1] + Vector3::from(way);
            path.push(next);
        }
        prop_assume!(path.windows(2).all(|pair| (pair[1] - pair[0]).norm() > 5.0));
        let wire = wire(&path, (0..path.len()).collect());
        // A small plane angle turns a small error of a rotation into a large one of the plane, which is not linear.
        prop_assume!(wire.program.steps.iter().rev().skip(1).all(|step| step.bend.deg() > 5.0 && step.bend.deg() < 175.0));
        let model = ClosingModel::new(&path, std::slice::from_ref(&wire), &steel()).unwrap();
        let draw = model.draw(&small(), seed, 0).unwrap();
        let kinematic = made(&wire, 0, &path, &model.sources, &draw);
        for ((linear, made), drawn) in moved_by_misfits(&model, &draw).iter().zip(&kinematic).zip(&path) {
            prop_assert!((linear - (made - drawn)).norm() < 1e-9, "{linear} and {}", made - drawn);
        }
    }
}

/// Three struts around a triangle of one wire that is fed too long all along are a larger triangle, without force.
#[test]
fn a_triangle_that_is_larger_all_round_has_no_force() {
    let path: Vec<Point3<f64>> = [[0.0, 0.0], [40.0, 0.0], [20.0, 34.641_016_151_377_54], [0.0, 0.0]]
        .map(|[x, y]| Point3::new(x, y, 0.0))
        .to_vec();
    let wire = wire(&path, vec![0, 1, 2, 0]);
    let model = ClosingModel::new(&path[..3], &[wire], &steel()).unwrap();
    let longer = ErrorModel { feed_mm: ErrorTerm { bias: 0.4, sigma: 0.0 }, ..ErrorModel::default() };
    let draw = model.draw(&longer, 1, 0).unwrap();
    let prepared = model.straight().unwrap();
    for closing in [Closing::Aligned, Closing::Coupled] {
        let closed = prepared.close(closing, &draw);
        assert!(closed.axial_rms() < 1e-7, "{closing:?}: {} N", closed.axial_rms());
        let side = (closed.displacements[1] - closed.displacements[0]).x;
        assert!((side - 0.4).abs() < 1e-9, "{closing:?}: {side} mm longer");
        // Each vertex goes out by 0.4 mm over √3.
        let off = closed.surface_rms(&Surface::whole(&path[..3], &[0, 1, 2]));
        assert!((off - 0.4 / 3.0_f64.sqrt()).abs() < 1e-9, "{closing:?}: {off} mm");
    }
}

#[test]
fn wires_that_are_none_are_refused_by_name() {
    let path: Vec<Point3<f64>> =
        [[0.0, 0.0], [40.0, 0.0], [40.0, 30.0]].map(|[x, y]| Point3::new(x, y, 0.0)).to_vec();
    let refused = |vertices: Vec<usize>, points: &[Point3<f64>]| {
        let wire = wire(&path, vertices);
        ClosingModel::new(points, &[wire], &steel()).map(|_| ()).unwrap_err().to_string()
    };
    assert_eq!(refused(vec![0, 1, 7], &path), "wire 0 passes vertex 7 of 3");
    assert_eq!(refused(vec![0, 1], &path), "wire 0 has 1 struts and a program of 2");
    let together = [path[0], path[0], path[2]];
    assert!(refused(vec![0, 1, 2], &together).contains("member 0 has no length"));
    let apart = [path.clone(), path.iter().map(|at| at + Vector3::z() * 99.0).collect()].concat();
    let wires = [wire(&apart[..3], vec![0, 1, 2]), wire(&apart[3..], vec![3, 4, 5])];
    let parts = ClosingModel::new(&apart, &wires, &steel()).map(|_| ());
    assert_eq!(parts, Err(super::ClosingError::SeveralParts { parts: 2 }));
    let bad = ErrorModel { feed_mm: ErrorTerm { bias: 0.0, sigma: -1.0 }, ..ErrorModel::default() };
    let model = ClosingModel::new(&path, &[wire(&path, vec![0, 1, 2])], &steel()).unwrap();
    assert!(model.draw(&bad, 1, 0).is_err());
    let bowed = ErrorModel { curvature: ErrorTerm { bias: 0.03, sigma: 0.0 }, ..ErrorModel::default() };
    let whole = Surface::whole(&path, &[0, 1, 2]);
    assert_eq!(
        model.straight().unwrap().expected(Closing::Aligned, &bowed, &whole),
        Err(super::ClosingError::Bowed)
    );
}

/// Two wires meet at vertices that neither passes twice: what their motions leave between them is a gap as well.
#[test]
fn passes_of_several_wires_are_apart_where_they_meet() {
    let corners = [[0.0, 0.0], [100.0, 0.0], [100.0, 100.0], [0.0, 100.0]];
    let corners = corners.map(|[x, y]| Point3::new(x, y, 0.0));
    let path = |vertices: &[usize]| {
        let points: Vec<_> = vertices.iter().map(|&vertex| corners[vertex]).collect();
        wire(&points, vertices.to_vec())
    };
    let around = [0, 1, 2, 3];
    let longer = ErrorTerm { bias: 1.0, sigma: 0.0 };
    let errors = ErrorModel { feed_mm: longer, ..ErrorModel::default() };
    let gap_of = |wires: Vec<FrameWire>| {
        let model = ClosingModel::new(&corners, &wires, &steel()).unwrap();
        let draw = model.draw(&errors, 1, 0).unwrap();
        model.straight().unwrap().gap(&draw)
    };
    assert_eq!(gap_of(vec![path(&around)]), None, "nothing is passed twice");
    // The first one, whose edges are all a mm too long, misses the corner where the second one begins.
    let apart = gap_of(vec![path(&around), path(&[3, 0, 2])]).unwrap();
    assert!(apart >= 1.0 - 1e-9, "{apart}");
    assert_eq!(gap(vec![(1, corners[0]), (0, corners[1]), (1, corners[1]), (2, corners[3])]), Some(100.0));
}
