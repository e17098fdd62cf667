//! Displacements, forces and stresses that other programs have computed.

use nalgebra::{Point3, Vector3};
use wirebend_frame::{
    Assembly, LineLoad, Load, Member, MemberId, Model, NodalLoad, NodeId, Response, Section, SectionId,
    Support,
};

use crate::frames::{ABS, PLA, assert_close, bunny, frame, framefab_weight};

fn solve(model: &Model, load: &Load) -> Response {
    let assembly = Assembly::new(model).expect("a model");
    assembly.factor(&assembly.all()).expect("it stands").solve(load).expect("a response")
}

/// conmech (`yijiangh/conmech`, `tests/test_data/uniform_load_analytical_model`, 9f24230): two beams at a right angle, clamped at
/// both far ends. The figures are those of PyNite 3.2.0 and pyconmech 0.6.0, which agree; the textbook's (-22.37 mm, 14.74 and
/// 5.25 kN, of which the example is) are rounded by hand.
#[test]
fn two_beams_under_a_line_load_and_a_force() {
    let section = |area: f64, i: f64, j: f64| Section {
        area,
        iy: i,
        iz: i,
        j,
        radius: 50.0,
        e: 200_000.0,
        g: 76_923.076_923_076_93,
        density: 0.0,
        yield_strength: 235.0,
    };
    let model = Model {
        nodes: vec![Point3::origin(), Point3::new(5000.0, 0.0, 0.0), Point3::new(5000.0, 8000.0, 0.0)],
        members: vec![
            Member::new(NodeId(0), NodeId(1), SectionId(0)),
            Member::new(NodeId(1), NodeId(2), SectionId(1)),
        ],
        sections: vec![section(4e3, 5e7, 1e5), section(6e3, 2e8, 3e5)],
        supports: vec![Support::clamped(NodeId(0)), Support::clamped(NodeId(2))],
    };
    let load = Load {
        nodal: vec![NodalLoad {
            node: NodeId(1),
            force: Vector3::new(0.0, 0.0, -5000.0),
            moment: Vector3::zeros(),
        }],
        line: vec![LineLoad { member: MemberId(0), force: Vector3::new(0.0, 0.0, -3.0) }],
        ..Load::default()
    };
    let response = solve(&model, &load);
    let [_, _, uz, rx, ry, _] = response.displacements[1];
    assert_close(uz, -22.384_518_491, 1e-9);
    assert_close(rx.abs(), 4.196_774_388e-3, 1e-9);
    assert_close(ry.abs(), 5.931_966_617e-3, 1e-9);
    let [at_0, at_2] = &response.reactions[..] else { panic!("{:?}", response.reactions) };
    assert_close(at_0.force.z, 14_752.417_871, 1e-9);
    assert_close(at_2.force.z, 5_247.582_129, 1e-9);
    assert_close(at_0.moment.y, -36.244_977_911e6, 1e-9);
    assert_close(at_2.moment.x, -41.974_200_459e6, 1e-9);
    assert!(response.residual < 1e-12, "{}", response.residual);
}

/// conmech, `tests/test_data/four-frame` (9f24230), under its own weight. PyNite 3.2.0; the 3.712e-5 mm of pyconmech 0.6.0 are
/// wrong, as it turns members along z wrongly.
#[test]
fn four_struts_with_pillars_along_z() {
    let nodes =
        [(0.0, -20.0, -10.0), (0.0, -20.0, 0.0), (0.0, 20.0, -10.0), (0.0, 20.0, 0.0), (0.0, 0.0, 20.0)];
    let members = [(0, 1), (2, 3), (1, 4), (3, 4)];
    let model = Model {
        nodes: nodes.map(|(x, y, z)| Point3::new(x, y, z)).to_vec(),
        members: members.map(|(a, b)| Member::new(NodeId(a), NodeId(b), SectionId(0))).to_vec(),
        sections: vec![Section::round(3.0, &PLA)],
        supports: vec![Support::clamped(NodeId(0)), Support::clamped(NodeId(2))],
    };
    assert_close(solve(&model, &Load::self_weight()).max_displacement().1, 1.0669e-5, 1e-4);
}

/// OpenSeesPy 3.7.1.2, PyNite 3.2.0, and pyconmech 0.6.0 on the model turned so that no member is along z. The 0.42093 mm that
/// pyconmech gives for the model as it stands are its error on vertical pillars.
#[test]
fn bunny_under_its_own_weight() {
    let model = bunny();
    let assembly = Assembly::new(&model).expect("a model");
    let factor = assembly.factor(&assembly.all()).expect("it stands");
    let response = factor.solve(&framefab_weight()).expect("a response");
    let (node, moved) = response.max_displacement();
    assert_eq!(node, NodeId(33));
    assert_close(moved, 0.427_186_657_557, 1e-9);
    let peak = response
        .member_forces
        .iter()
        .map(|forces| forces.peak_von_mises(&model.sections[0]))
        .fold(0.0, f64::max);
    assert_close(peak, 0.556_02, 1e-5);
    assert_close(assembly.mass(&assembly.all()) * 1e6, 13.759_716_948, 1e-9);
    assert!(response.residual < 1e-9, "{}", response.residual);
    let weight = assembly.mass(&assembly.all()) * 9806.33;
    assert_close(response.reactions.iter().map(|reaction| reaction.force.z).sum(), weight, 1e-9);
}

/// The same sources.
#[test]
fn bunny_on_feet_that_can_turn() {
    let mut model = bunny();
    for support in &mut model.supports {
        *support = Support::pinned(support.node);
    }
    assert_close(solve(&model, &framefab_weight()).max_displacement().1, 0.436_273, 2e-6);
}

/// Frames that a robot has printed, as drawn in ABS of radius 0.75 mm and in PLA of 1.5 mm. PyNite 3.2.0 and pyconmech 0.6.0 on the
/// turned models, which agree in these digits; `OpenSeesPy` in six.
#[test]
fn printed_frames_under_their_own_weight() {
    let cases = [
        ("C_shape", 0.223_261_461_5, 0.079_339_709_0),
        ("fertility", 0.004_449_728_925, 0.003_561_786_379),
        ("bunny_full_tri", 0.016_370_661_114, 0.010_384_697_362),
    ];
    for (name, abs, pla) in cases {
        let file = format!("tests/data/{name}.txt");
        let thin = frame(&file, Section::round(1.5, &ABS));
        assert_close(solve(&thin, &framefab_weight()).max_displacement().1, abs, 1e-8);
        let thick = frame(&file, Section::round(3.0, &PLA));
        assert_close(solve(&thick, &Load::self_weight()).max_displacement().1, pla, 1e-8);
    }
}
