//! The tetrahedral trusses of Bend-Forming, and the walks of their authors.

use nalgebra::Point3;
use wirebend_accuracy::{ClosingModel, FrameWire, Surface};
use wirebend_core::bend::{NominalProgram, Step, program_of_path};
use wirebend_core::units::{Angle, Length};
use wirebend_frame::{Material, Member, Model, NodeId, Section, SectionId};

/// Depth of the trusses, mm.
pub const DEPTH: f64 = 50.0;
/// Strut of their faces, mm: all struts are as long where the depth is [`DEPTH`].
pub const STRUT: f64 = 61.237_243_569_579_45;
/// Depth of the truss of the accuracy test, mm.
pub const DEPTH_OF_TEST: f64 = 53.033_009;

const WALKS: &str = include_str!("../data/bend-forming/walks.txt");

/// A truss: its vertices, the top face first, and its struts, each once.
pub struct Truss {
    pub rings: i32,
    pub points: Vec<Point3<f64>>,
    pub struts: Vec<[usize; 2]>,
}

impl Truss {
    /// A lattice point has three whole coordinates of sum 1 along directions 120° apart; the bottom face is the top one turned by half a
    /// turn.
    pub fn new(rings: i32, depth: f64) -> Self {
        let range = -rings..=rings + 1;
        let pairs = range.clone().flat_map(|a| range.clone().map(move |b| [a, b, 1 - a - b]));
        let layer: Vec<[i32; 3]> = pairs.filter(|[_, _, c]| range.contains(c)).collect();
        let place = |at: [i32; 3], side: f64, z: f64| {
            let [a, b, c] = at.map(f64::from);
            let y = STRUT / 3.0_f64.sqrt() * (a - f64::midpoint(b, c));
            Point3::new(side * STRUT / 2.0 * (c - b), side * y, z)
        };
        let top = layer.iter().map(|&at| place(at, 1.0, depth));
        let points: Vec<_> = top.chain(layer.iter().map(|&at| place(at, -1.0, 0.0))).collect();
        let (count, mut struts) = (layer.len(), Vec::new());
        for (i, a) in layer.iter().enumerate() {
            for (j, b) in layer.iter().enumerate() {
                if i < j && (0..3).all(|k| (a[k] - b[k]).abs() <= 1) {
                    struts.extend([[i, j], [count + i, count + j]]);
                }
                if (0..3).all(|k| (0..=1).contains(&(a[k] + b[k]))) {
                    struts.push([i, count + j]);
                }
            }
        }
        Self { rings, points, struts }
    }

    /// Across it: 2N + 1 struts, mm.
    pub fn diameter(&self) -> f64 {
        f64::from(2 * self.rings + 1) * STRUT
    }

    /// Its two faces.
    pub fn faces(&self) -> Surface {
        let half = self.points.len() / 2;
        Surface::faces(&self.points, &[(0..half).collect(), (half..2 * half).collect()])
    }

    /// Each strut a wire of its own.
    pub fn single_struts(&self) -> ClosingModel {
        let wires: Vec<FrameWire> = self.struts.iter().map(|ends| self.wire(ends)).collect();
        ClosingModel::new(&self.points, &wires, &steel_wire()).unwrap()
    }

    /// One wire along a walk of the authors; some struts are doubled.
    pub fn walked(&self, name: &str) -> ClosingModel {
        ClosingModel::new(&self.points, &[self.wire(&walk(name))], &steel_wire()).unwrap()
    }

    /// The frame that such a walk makes once it is locked, held nowhere: a doubled strut is two members.
    pub fn locked(&self, name: &str) -> Model {
        let walk = walk(name);
        let member = |ends: &[usize]| Member::new(NodeId(ends[0]), NodeId(ends[1]), SectionId(0));
        Model {
            nodes: self.points.clone(),
            members: walk.windows(2).map(member).collect(),
            sections: vec![steel_wire()],
            supports: Vec::new(),
        }
    }

    /// A wire that is fed strut by strut, also where it goes straight on, and bent to either side, as the authors' programs are: half a
    /// turn of the head is a bend to the other side.
    pub fn wire(&self, vertices: &[usize]) -> FrameWire {
        let path: Vec<Point3<f64>> = vertices.iter().map(|&k| self.points[k]).collect();
        let (start, program) = program_of_path(&path, Angle::from_deg(1e-4).unwrap()).unwrap();
        let (mut steps, mut flipped) = (Vec::new(), false);
        for (step, span) in program.steps.iter().zip(&program.spans) {
            let half_a_turn = step.rotate.deg().abs() > 180.0 - 1e-6;
            flipped ^= half_a_turn;
            let step = Step {
                rotate: if half_a_turn { Angle::ZERO } else { step.rotate },
                bend: if flipped { -step.bend } else { step.bend },
                ..*step
            };
            let feed = |k: usize| Length::from_mm((path[k + 1] - path[k]).norm()).unwrap();
            steps.extend(span.clone().map(|k| Step { feed: feed(k), ..Step::default() }));
            if let Some(last) = steps.last_mut() {
                *last = Step { feed: last.feed, ..step };
            }
        }
        FrameWire { vertices: vertices.to_vec(), start, program: NominalProgram::from_steps(steps) }
    }
}

/// A walk by its name.
pub fn walk(name: &str) -> Vec<usize> {
    let lines = WALKS.lines().skip_while(|line| line.strip_suffix(':') != Some(name)).skip(1);
    let numbers = lines.take_while(|line| line.starts_with(' ')).flat_map(str::split_whitespace);
    numbers.map(|number| number.parse().unwrap()).collect()
}

/// The wire of the authors' computations: steel of 0.9 mm, E 200,000 MPa, ν 0.29, 7800 kg/m³.
pub fn steel_wire() -> Section {
    let e = 200_000.0;
    Section::round(0.9, &Material { e, g: e / 2.58, density: 7.8e-9, yield_strength: 305.0 })
}

/// E A of it, N.
pub fn axial_stiffness() -> f64 {
    let section = steel_wire();
    section.e * section.area
}

/// The truss is the authors', by their own counts, and their walks go along each of its struts.
#[test]
fn the_walks_go_along_every_strut() {
    for (rings, nodes, struts, passes) in [
        (1, 24, 78, 91),
        (2, 54, 198, 223),
        (3, 96, 372, 416),
        (4, 150, 600, 670),
        (5, 216, 882, 983),
        (10, 726, 3102, 3468),
    ] {
        let truss = Truss::new(rings, DEPTH);
        assert_eq!((truss.points.len(), truss.struts.len()), (nodes, struts));
        let walk = walk(&format!("ring-{rings}"));
        assert_eq!(walk.len(), passes);
        let sorted = |a: usize, b: usize| [a.min(b), a.max(b)];
        let mut walked: Vec<_> = walk.windows(2).map(|pair| sorted(pair[0], pair[1])).collect();
        walked.sort_unstable();
        walked.dedup();
        let mut all = truss.struts.clone();
        for [a, b] in &mut all {
            [*a, *b] = sorted(*a, *b);
        }
        all.sort_unstable();
        assert_eq!(walked, all);
    }
    assert_eq!(walk("accuracy-test").len(), 91);
}
