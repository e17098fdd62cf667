//! How far what stands sags, as a frame of nothing else.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet, HashMap, VecDeque};

use crate::Task;
use crate::beam::Beam;
use crate::skyline::Skyline;

/// What is left of a stiffness is rounding below this share of it: rounding is some 1e-16 of it a strut, and the free end of a hundred
/// struts in a row, each twenty times as long as thick, keeps 1e-10.
const NO_STIFFNESS: f64 = 1e-13;

/// A degree of freedom's place in the equations; none where the ground holds it.
type Place = Option<usize>;

/// The vertex that sags most, and how far, mm; none where it does not stand.
type Sag = Option<(u32, f64)>;

/// The struts of a design as beams, of which some stand.
pub(crate) struct Standing<'a> {
    task: &'a Task,
    beams: BTreeMap<u32, Beam>,
    /// The vertices in rings around the supports, so that a strut joins vertices that are near each other in it.
    rings: Vec<u32>,
    /// What was found of parts that hang together, by their edges: the others stand as they stood.
    parts: RefCell<HashMap<Vec<u32>, Sag>>,
}

impl<'a> Standing<'a> {
    pub fn new(task: &'a Task) -> Self {
        let beam = |(&edge, ends): (&u32, &[u32; 2])| {
            (edge, Beam::new(ends.map(|end| task.at(end)), &task.section, &task.gravity))
        };
        Self {
            task,
            beams: task.edges.iter().map(beam).collect(),
            rings: rings(task),
            parts: RefCell::default(),
        }
    }

    /// How far these struts sag, where they alone stand.
    pub fn sag(&self, edges: &[u32]) -> Sag {
        let mut most: Sag = None;
        for part in self.parts_of(edges) {
            let known = self.parts.borrow().get(&part).copied();
            let found = known.unwrap_or_else(|| self.sag_of_part(&part));
            self.parts.borrow_mut().insert(part, found);
            let found = found?;
            if most.is_none_or(|most| found.1 > most.1) {
                most = Some(found);
            }
        }
        most
    }

    /// The edges of each part that hangs together, rising.
    fn parts_of(&self, edges: &[u32]) -> Vec<Vec<u32>> {
        let mut around: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for &edge in edges {
            self.task.edges[&edge].iter().for_each(|&end| around.entry(end).or_default().push(edge));
        }
        let mut seen = BTreeSet::new();
        let mut parts = Vec::new();
        for &vertex in around.keys() {
            let mut part = BTreeSet::new();
            let mut open = vec![vertex];
            while let Some(vertex) = open.pop() {
                if seen.insert(vertex) {
                    part.extend(&around[&vertex]);
                    open.extend(around[&vertex].iter().flat_map(|edge| self.task.edges[edge]));
                }
            }
            parts.extend((!part.is_empty()).then(|| part.into_iter().collect()));
        }
        parts
    }

    fn sag_of_part(&self, edges: &[u32]) -> Sag {
        let places = self.places(edges);
        let count = places.values().flatten().flatten().count();
        let of_ends = |edge: &u32| {
            let [a, b] = self.task.edges[edge];
            [places[&a], places[&b]].concat()
        };
        let mut first: Vec<usize> = (0..count).collect();
        for edge in edges {
            let ends = of_ends(edge);
            let least = ends.iter().copied().flatten().min();
            for place in ends.into_iter().flatten() {
                first[place] = first[place].min(least.unwrap_or(place));
            }
        }
        let (mut stiffness, mut load) = (Skyline::new(&first), vec![0.0; count]);
        for edge in edges {
            let (ends, beam) = (of_ends(edge), &self.beams[edge]);
            for (row, place) in ends.iter().enumerate() {
                let Some(place) = *place else { continue };
                load[place] += beam.weight[row];
                for (column, beside) in ends.iter().enumerate() {
                    if let Some(beside) = beside.filter(|&beside| beside <= place) {
                        stiffness.add(place, beside, beam.stiffness[(row, column)]);
                    }
                }
            }
        }
        for (vertex, places) in &places {
            // A gram is 1e-6 t.
            let weight = self.task.gravity * self.task.vertices[vertex].joint_g * 1e-6;
            for (place, force) in places.iter().zip(&weight) {
                if let Some(place) = *place {
                    load[place] += force;
                }
            }
        }
        let moved = solved(&stiffness, &load)?;
        let sag = |places: &[Place; 6]| {
            places[..3].iter().flatten().map(|&place| moved[place].powi(2)).sum::<f64>().sqrt()
        };
        let mut most = places.keys().next().map(|&vertex| (vertex, 0.0))?;
        for (&vertex, places) in &places {
            if sag(places) > most.1 {
                most = (vertex, sag(places));
            }
        }
        Some(most)
    }

    /// The places of the degrees of freedom of each vertex of these edges.
    fn places(&self, edges: &[u32]) -> BTreeMap<u32, [Place; 6]> {
        let used: BTreeSet<u32> = edges.iter().flat_map(|edge| self.task.edges[edge]).collect();
        let mut free = 0..;
        let places = self.rings.iter().filter(|vertex| used.contains(vertex)).map(|vertex| {
            let there = &self.task.vertices[vertex];
            let mut places = [None; 6];
            // Displacements after rotations: what is left at last, of a mechanism rounding, is that of a displacement, which is measured
            // against those of the others, and not of a rotation, which takes a lever.
            for axis in [3, 4, 5, 0, 1, 2] {
                let held = there.support && there.fixed[axis];
                places[axis] = if held { None } else { free.next() };
            }
            (*vertex, places)
        });
        places.collect()
    }
}

/// K⁻¹ f, made better once by what it leaves of f; none where K is that of a mechanism.
fn solved(stiffness: &Skyline, load: &[f64]) -> Option<Vec<f64>> {
    let lower = stiffness.clone().factor(NO_STIFFNESS)?;
    let mut moved = lower.solve(load);
    let left: Vec<f64> = load.iter().zip(stiffness.times(&moved)).map(|(load, held)| load - held).collect();
    moved.iter_mut().zip(lower.solve(&left)).for_each(|(moved, more)| *moved += more);
    moved.iter().all(|way| way.is_finite()).then_some(moved)
}

fn rings(task: &Task) -> Vec<u32> {
    let mut beside: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for &[a, b] in task.edges.values() {
        beside.entry(a).or_default().push(b);
        beside.entry(b).or_default().push(a);
    }
    let (supports, others): (Vec<u32>, Vec<u32>) =
        beside.keys().partition(|vertex| task.vertices[*vertex].support);
    let mut seen: BTreeSet<u32> = supports.iter().copied().collect();
    let (mut open, mut others) = (VecDeque::from(supports), others.into_iter());
    let mut rings = Vec::new();
    loop {
        while let Some(vertex) = open.pop_front() {
            rings.push(vertex);
            open.extend(beside[&vertex].iter().copied().filter(|next| seen.insert(*next)));
        }
        // What hangs on no support comes last, part by part.
        let Some(next) = others.find(|vertex| seen.insert(*vertex)) else { return rings };
        open.push_back(next);
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use nalgebra::{Point3, Vector3};

    use super::*;
    use crate::{Machine, Section, Vertex};

    const SECTION: Section =
        Section { radius_mm: 0.75, e_mpa: 3457.0, g_mpa: 1294.0, density_t_mm3: 1210e-12 };

    /// The first vertex is held so, the others not at all.
    fn task(points: &[[f64; 3]], edges: &[[u32; 2]], fixed: [bool; 6]) -> Task {
        let vertex = |(k, at): (u32, &[f64; 3])| {
            (k, Vertex { at: Point3::from(*at), support: k == 0, fixed, joint_g: f64::from(k) })
        };
        let machine = Machine {
            outline: vec![[0.0, 1.0], [1.0, 1.0]],
            places: false,
            max_create_deg: 90.0,
            max_connect_deg: 90.0,
            touch_mm: 0.0,
            clearance_mm: 0.0,
            ground_first: false,
            max_sag_mm: 1.0,
            workspace: None,
        };
        Task {
            vertices: (0..).zip(points).map(vertex).collect(),
            edges: (0..).zip(edges.iter().copied()).collect(),
            section: SECTION,
            gravity: Vector3::new(0.0, 0.0, -9806.65),
            machine,
        }
    }

    /// q L⁴ / 8EI + F L³ / 3EI across, (q L / 2 + F) L / EA along.
    #[test]
    fn a_slanted_cantilever_sags_as_the_textbook_says() {
        let tip = Vector3::new(30.0, -20.0, 45.0);
        let task = task(&[[0.0; 3], tip.into()], &[[1, 0]], [true; 6]);
        let length = tip.norm();
        let area = PI * 0.75 * 0.75;
        let (stretch, bend) = (3457.0 * area, 3457.0 * area * 0.75 * 0.75 / 4.0);
        let (weight, joint) = (task.gravity * 1210e-12 * area * length, task.gravity * 1e-6);
        let along = |force: &Vector3<f64>| force.dot(&tip) / length;
        let across = |force: &Vector3<f64>| force.cross(&tip).norm() / length;
        let shorter = (along(&weight) / 2.0 + along(&joint)) * length / stretch;
        let bent = (across(&weight) / 8.0 + across(&joint) / 3.0) * length.powi(3) / bend;
        let (vertex, mm) = Standing::new(&task).sag(&[0]).unwrap();
        assert_eq!(vertex, 1);
        assert!((mm - bent.hypot(shorter)).abs() < 1e-9 * mm, "{mm} {bent} {shorter}");
    }

    #[test]
    fn what_moves_freely_does_not_stand() {
        let points = [[0.0; 3], [30.0, -20.0, 45.0], [7.0, 31.0, 52.0], [-13.0, 5.0, 80.0]];
        let edges = [[0, 1], [1, 2], [2, 3], [3, 1]];
        let mut held = task(&points, &edges, [true; 6]);
        assert!(Standing::new(&held).sag(&[0, 1, 2, 3]).is_some());
        assert_eq!(Standing::new(&held).sag(&[1, 2, 3]), None, "three struts that hang on nothing");
        assert_eq!(Standing::new(&held).sag(&[0, 2]), None, "one of the two parts");
        for hinge in 3..6 {
            held.vertices.get_mut(&0).unwrap().fixed[hinge] = false;
            assert_eq!(Standing::new(&held).sag(&[0, 1, 2, 3]), None, "it turns about its foot");
        }
    }
}
