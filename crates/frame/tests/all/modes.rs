//! Frequencies: theory, other programs, and trusses that others have published.

use std::f64::consts::{PI, TAU};

use nalgebra::{Point3, Vector3};
use wirebend_frame::{
    Assembly, Member, MemberId, MemberSet, Mode, ModeKind, ModeSearch, Model, NodeId, NodeMass, Pieces,
    Section, SectionId, Support, Unstable,
};

use crate::frames::{ABS, STEEL, assert_close, beam, bunny, frame, framefab_weight};
use crate::trusses::{accuracy_test_wire, truss};

fn modes(model: &Model, pieces: usize, count: usize) -> Vec<Mode> {
    let cut = Pieces::new(model, pieces);
    let assembly = Assembly::new(&cut.model).expect("a model");
    let search = ModeSearch { count, shift_hz: 100.0, struts: cut.struts, masses: Vec::new() };
    assembly.modes(&assembly.all(), &search).expect("modes")
}

/// Without those in which nothing bends.
fn bending(modes: &[Mode]) -> Vec<f64> {
    modes.iter().filter(|mode| mode.kind != ModeKind::Rigid).map(|mode| mode.frequency_hz).collect()
}

fn assert_frequencies(found: &[f64], expected: &[f64], share: f64) {
    assert!(found.len() >= expected.len(), "{found:?}");
    for (found, expected) in found.iter().zip(expected) {
        assert_close(*found, *expected, share);
    }
}

/// (β L)² / 2π L² · √(E I / ρ A) of a steel wire of diameter 0.9 mm, Hz.
fn beam_theory(beta_length: f64, length: f64) -> f64 {
    let section = Section::round(0.9, &STEEL);
    let stiff = section.e * section.iy / (section.density * section.area);
    beta_length.powi(2) / (TAU * length * length) * stiff.sqrt()
}

/// Bernoulli's β L of clamped-free beams is 1.875104068711961. Four cubic elements are too stiff by 3.3e-5 in the first mode
/// (Archer 1963 has the matrix), as OpenSees finds.
#[test]
fn a_cantilever_of_four_pieces_is_three_in_a_hundred_thousand_above_theory() {
    let mut model = beam(Vector3::new(30.0, -40.0, 120.0));
    model.supports = vec![Support::clamped(NodeId(0))];
    let found = bending(&modes(&model, 4, 2));
    let theory = beam_theory(1.875_104_068_711_961, 130.0);
    for frequency in found {
        let above = frequency / theory - 1.0;
        assert_close(above, 3.3e-5, 0.05);
    }
}

/// A mass at the tip of a clamped beam, as large as that of the beam, a fifth of it, and ten times as large: β L solves
/// 1 + cos cosh = m/(ρ A L) β L (sin cosh - cos sinh) (Rao, Mechanical Vibrations, 8.5); of a large mass the beam is a spring 3 E I/L³.
#[test]
fn a_cantilever_with_a_mass_at_its_tip_is_that_of_theory() {
    let mut model = beam(Vector3::new(0.0, 60.0, 80.0));
    model.supports = vec![Support::clamped(NodeId(0))];
    let section = Section::round(0.9, &STEEL);
    for (share, known) in [(0.0, 1.875_104), (0.2, 1.616_4), (1.0, 1.247_917), (10.0, 0.735_78)] {
        let missed =
            |x: f64| 1.0 + x.cos() * x.cosh() - share * x * (x.sin() * x.cosh() - x.cos() * x.sinh());
        let (mut low, mut high) = (0.1, 2.0);
        for _ in 0..60 {
            let middle = f64::midpoint(low, high);
            if missed(middle) > 0.0 { low = middle } else { high = middle }
        }
        assert_close(low, known, 1e-4);
        let mass = share * section.density * section.area * 100.0;
        let masses = vec![NodeMass { node: NodeId(1), mass }];
        let cut = Pieces::new(&model, 4);
        let assembly = Assembly::new(&cut.model).expect("a model");
        let search = ModeSearch { count: 2, shift_hz: 10.0, struts: cut.struts, masses };
        let found = bending(&assembly.modes(&assembly.all(), &search).expect("modes"));
        assert_frequencies(&found, &[beam_theory(low, 100.0); 2], 5e-5);
    }
}

/// What floats keeps its six rigid motions; a mass at a node to which no strut that is there goes does not vibrate.
#[test]
fn masses_leave_rigid_motions_as_they_are_and_need_a_strut() {
    let mut model = beam(Vector3::new(0.0, 0.0, 100.0));
    model.nodes.push(Point3::new(0.0, 0.0, 200.0));
    model.members.push(Member { a: NodeId(1), b: NodeId(2), ..model.members[0] });
    let assembly = Assembly::new(&model).expect("a model");
    let mut first = MemberSet::empty(2);
    first.insert(MemberId(0));
    let of = |node: usize, mass: f64| {
        let masses = vec![NodeMass { node: NodeId(node), mass }];
        let search = ModeSearch { count: 1, shift_hz: 100.0, struts: Vec::new(), masses };
        assembly.modes(&first, &search).expect("modes")
    };
    let (without, heavy, elsewhere) = (of(1, 0.0), of(1, 3e-6), of(2, 3e-6));
    for found in [&without, &heavy, &elsewhere] {
        assert_eq!(found.iter().filter(|mode| mode.kind == ModeKind::Rigid).count(), 6);
    }
    assert!(bending(&heavy)[0] < 0.99 * bending(&without)[0]);
    assert_close(bending(&elsewhere)[0], bending(&without)[0], 1e-12);
}

/// β L of free-free beams is 4.730040744862704; four elements are 1.1e-3 above.
#[test]
fn a_free_beam_of_four_pieces_is_one_in_a_thousand_above_theory() {
    let found = modes(&beam(Vector3::new(0.0, 0.0, 100.0)), 4, 2);
    let rigid: Vec<&Mode> = found.iter().filter(|mode| mode.kind == ModeKind::Rigid).collect();
    assert_eq!(rigid.len(), 6);
    assert!(rigid.iter().all(|mode| mode.frequency_hz < 1e-3), "{rigid:?}");
    let theory = beam_theory(4.730_040_744_862_704, 100.0);
    for frequency in bending(&found) {
        assert_close(frequency / theory - 1.0, 1.1e-3, 0.05);
    }
}

/// Forty equal cantilevers beside each other have eighty equal lowest modes, two each. Bernoulli's second β L of a clamped-free beam is
/// 4.694091132974175.
#[test]
fn none_of_many_equal_modes_is_left_out() {
    let mut model = Model { sections: vec![Section::round(0.9, &STEEL)], ..Model::default() };
    for k in 0..40_u8 {
        let foot = NodeId(model.nodes.len());
        let at = Point3::new(10.0 * f64::from(k), 0.0, 0.0);
        model.nodes.extend([at, at + 100.0 * Vector3::z()]);
        model.members.push(Member::new(foot, NodeId(foot.0 + 1), SectionId(0)));
        model.supports.push(Support::clamped(foot));
    }
    let found = bending(&modes(&model, 6, 90));
    let (first, second) =
        (beam_theory(1.875_104_068_711_961, 100.0), beam_theory(4.694_091_132_974_175, 100.0));
    assert_frequencies(&found, &[vec![first; 80], vec![second; 10]].concat(), 1e-3);
}

/// A clamped rod that is twisted and stretched: 1/4L of the speed of either wave. Elements of a rod are too stiff by (π/4n)²/6.
#[test]
fn a_rod_twists_and_stretches_at_the_speed_of_waves() {
    let mut model = beam(Vector3::new(2.0, 0.0, 0.0));
    model.supports = vec![Support::clamped(NodeId(0))];
    let found = bending(&modes(&model, 40, 30));
    for stiffness in [STEEL.g, STEEL.e] {
        let theory = (stiffness / STEEL.density).sqrt() / (4.0 * 2.0);
        let above = 1.0 + (PI / 160.0).powi(2) / 6.0;
        let nearest = found.iter().map(|f| (f / (theory * above) - 1.0).abs()).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-6, "{theory} Hz is not among {found:?}");
    }
}

/// OpenSeesPy 3.7.1.2, one element a strut, feet clamped.
#[test]
fn printed_frames_vibrate_as_other_programs_say() {
    let expected = [18.1481, 23.1528, 26.5428];
    assert_frequencies(&bending(&modes(&bunny(), 1, 3)), &expected, 1e-5);
    let c_shape = frame("tests/data/C_shape.txt", Section::round(1.5, &ABS));
    assert_frequencies(&bending(&modes(&c_shape, 1, 3)), &[31.372, 39.653, 46.206], 2e-5);
}

/// The tetrahedral trusses of Bend-Forming with 1 and 3 rings, each strut once: an independent program of the textbook's matrices with
/// `SciPy`'s `eigsh`, and N 1 by OpenSees too.
#[test]
fn free_trusses() {
    for (rings, expected) in [(1, 596.635), (3, 598.175)] {
        let found = modes(&truss(rings), 4, 3);
        assert_eq!(found.iter().filter(|mode| mode.kind == ModeKind::Rigid).count(), 6);
        assert_close(bending(&found)[0], expected, 1e-6);
    }
}

/// The same with 5 rings, by the same program: 17,172 equations, the lowest modes those of the whole truss.
#[test]
fn a_free_truss_of_five_rings() {
    let found = modes(&truss(5), 4, 3);
    assert_close(bending(&found)[0], 439.158, 2e-6);
    assert_eq!(found[6].kind, ModeKind::Global);
}

/// The wire of Bend-Forming's accuracy test, struts that it takes twice being two members, by the same program.
#[test]
fn a_truss_as_its_wire_runs() {
    let model = accuracy_test_wire();
    assert_close(bending(&modes(&model, 4, 1))[0], 564.80, 1e-5);
    assert_close(bending(&modes(&model, 8, 1))[0], 564.60, 1e-5);
}

/// A part that nothing holds beside one that stands, and one that can spin about its own axis.
#[test]
fn rigid_motions_are_those_that_supports_leave() {
    let mut model = beam(Vector3::new(100.0, 0.0, 0.0));
    model.supports = vec![Support::clamped(NodeId(0))];
    assert!(modes(&model, 4, 1).iter().all(|mode| mode.kind != ModeKind::Rigid));
    model.supports = vec![Support::pinned(NodeId(0)), Support::pinned(NodeId(1))];
    let found = modes(&model, 4, 1);
    assert_eq!(found[0].kind, ModeKind::Rigid);
    let spin = found[0].shape[0][3].abs();
    assert!(found[0].shape.iter().all(|u| (u[3].abs() - spin).abs() < 1e-9 * spin), "{:?}", found[0].shape);
    assert!(bending(&found)[0] > 1.0);

    let mut two = bunny();
    let loose = NodeId(two.nodes.len());
    two.nodes.extend([nalgebra::Point3::new(500.0, 0.0, 0.0), nalgebra::Point3::new(600.0, 0.0, 0.0)]);
    two.members.push(wirebend_frame::Member::new(loose, NodeId(loose.0 + 1), wirebend_frame::SectionId(0)));
    let found = modes(&two, 1, 3);
    assert_eq!(found.iter().filter(|mode| mode.kind == ModeKind::Rigid).count(), 6);
    assert_frequencies(&bending(&found), &[18.1481, 23.1528, 26.5428], 1e-5);
}

/// A long thin strut on a stiff frame vibrates alone, and is told so.
#[test]
fn a_mode_of_one_strut_names_it() {
    let mut model = beam(Vector3::new(10.0, 0.0, 0.0));
    let wire = model.members[0];
    model.nodes.extend([(0.0, 10.0, 0.0), (200.0, 0.0, 0.0)].map(|(x, y, z)| nalgebra::Point3::new(x, y, z)));
    model.members.push(wirebend_frame::Member { a: NodeId(0), b: NodeId(2), ..wire });
    model.members.push(wirebend_frame::Member { a: NodeId(1), b: NodeId(3), ..wire });
    model.supports = [0, 2, 3].map(|node| Support::clamped(NodeId(node))).to_vec();
    assert_eq!(modes(&model, 4, 1)[0].kind, ModeKind::Local { strut: 2 });
}

/// As many modes as a model has, each but once: of a clamped beam of one element the two roots of 35 μ² - 102 μ + 3 = 0, with
/// 420 μ = ρ A L⁴ ω² / E I, in both planes (Leckie, Lindberg 1963), and 3 c² / L² of either wave.
#[test]
fn all_modes_of_a_single_element() {
    let mut model = beam(Vector3::new(100.0, 0.0, 0.0));
    model.supports = vec![Support::clamped(NodeId(0))];
    let found = modes(&model, 1, 100);
    let bend = [-1.0, 1.0].map(|sign| {
        let root = (102.0 + sign * (102.0_f64.powi(2) - 420.0).sqrt()) / 70.0;
        beam_theory((420.0 * root).powf(0.25), 100.0)
    });
    let rod = |stiffness: f64| (3.0 * stiffness / STEEL.density).sqrt() / 100.0 / TAU;
    let mut expected = [bend[0], bend[0], bend[1], bend[1], rod(STEEL.g), rod(STEEL.e)];
    expected.sort_by(f64::total_cmp);
    assert_eq!(found.len(), 6);
    assert_frequencies(&bending(&found), &expected, 1e-9);
}

/// The bunny as a few members of a model in which every node is joined with every other: its matrix is full, and factored in blocks.
#[test]
fn a_frame_within_a_full_matrix() {
    let mut model = bunny();
    let struts = model.members.len();
    for b in 0..model.nodes.len() {
        let joined =
            (0..b).map(|a| wirebend_frame::Member { a: NodeId(a), b: NodeId(b), ..model.members[0] });
        model.members.extend(joined.collect::<Vec<_>>());
    }
    let assembly = Assembly::new(&model).expect("a model");
    let mut members = MemberSet::empty(model.members.len());
    for member in 0..struts {
        members.insert(MemberId(member));
    }
    let response =
        assembly.factor(&members).expect("it stands").solve(&framefab_weight()).expect("a response");
    assert_close(response.max_displacement().1, 0.427_187, 2e-6);
    let search = ModeSearch { count: 3, shift_hz: 4.0, struts: Vec::new(), masses: Vec::new() };
    let found = assembly.modes(&members, &search).expect("modes");
    assert_frequencies(&bending(&found), &[18.1481, 23.1528, 26.5428], 1e-5);

    // On hinges alone it is found to move in blocks, too.
    let hinged = Model { supports: vec![Support::pinned(model.supports[0].node)], ..model };
    let assembly = Assembly::new(&hinged).expect("a model");
    let refused = assembly.factor(&members).err();
    assert!(matches!(refused, Some(Unstable::Mechanism { .. })), "{refused:?}");
}
