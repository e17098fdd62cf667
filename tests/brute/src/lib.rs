//! Sequences of struts, checked by brute force: motions and struts are sampled, and each frame that stands is solved from nothing.
//!
//! It shares no code with the search for sequences, with its check and with what solves frames for them, and takes plain figures, so that
//! every room can have its sequences confirmed: mm, degrees, and the numbers that vertices and edges have in the design. Steps count
//! from 1.

#![allow(clippy::expect_used, clippy::panic)] // a test may stop at what cannot be

mod beam;
mod building;
mod fault;
mod head;
mod printed;
mod skyline;
mod standing;

use std::collections::BTreeMap;

use nalgebra::{Point3, Vector3};

pub use fault::Fault;

/// A point where struts meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vertex {
    /// Where it is, mm.
    pub at: Point3<f64>,
    /// Whether it is a support.
    pub support: bool,
    /// Which of its displacements along x, y, z and rotations about them a support holds.
    pub fixed: [bool; 6],
    /// What joins the struts there, g.
    pub joint_g: f64,
}

/// A round section, and what it is made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// mm.
    pub radius_mm: f64,
    /// Young's modulus, MPa.
    pub e_mpa: f64,
    /// Shear modulus, MPa.
    pub g_mpa: f64,
    /// `t/mm³`: 1210 `kg/m³` are 1.21e-9.
    pub density_t_mm3: f64,
}

/// A frame as it is drawn and what builds it.
#[derive(Debug, Clone, PartialEq)]
pub struct Task {
    /// Its vertices.
    pub vertices: BTreeMap<u32, Vertex>,
    /// Its edges by their ends.
    pub edges: BTreeMap<u32, [u32; 2]>,
    /// The section of every strut.
    pub section: Section,
    /// What pulls at them, mm/s².
    pub gravity: Vector3<f64>,
    /// The machine.
    pub machine: Machine,
}

/// A strut builder.
#[derive(Debug, Clone, PartialEq)]
pub struct Machine {
    /// The outline of its head from the tip upwards: `[z, radius]` of each corner, mm; convex.
    pub outline: Vec<[f64; 2]>,
    /// Whether it stands at the joints of a single strut, too, and does not draw it.
    pub places: bool,
    /// The angle between its axis and its way stays below this for a strut with one end in the open.
    pub max_create_deg: f64,
    /// The same for a strut between vertices that are built.
    pub max_connect_deg: f64,
    /// How deep a strut that ends at a vertex of the one that is built may be in the head, mm.
    pub touch_mm: f64,
    /// How far the head stays from the surface of the others, mm.
    pub clearance_mm: f64,
    /// Whether struts on the ground come before all others.
    pub ground_first: bool,
    /// How far a vertex may sag, mm.
    pub max_sag_mm: f64,
    /// The lowest and the highest corner of where the tip gets to.
    pub workspace: Option<[Point3<f64>; 2]>,
}

impl Machine {
    /// Whether so many edges at once are placed whole.
    pub(crate) const fn is_placed(&self, edges: usize) -> bool {
        self.places || edges > 1
    }
}

/// What is placed at once.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// Its edges; one, unless a wire or rod is placed.
    pub edges: Vec<u32>,
    /// What it is said to be, where it is.
    pub kind: Option<Kind>,
    /// The vertices at which the head stands, for a strut that is drawn the one from which it goes to the other end, each with directions
    /// of its axis, of which one has to be free.
    pub joints: Vec<(u32, Vec<Vector3<f64>>)>,
}

/// What a step adds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Struts on the ground.
    Ground,
    /// An end in the open.
    Create,
    /// Struts between what is built.
    Connect,
}

impl Task {
    /// All that is wrong with a sequence. What cannot be built is taken as built by the steps after it.
    #[must_use]
    pub fn faults(&self, steps: &[Step]) -> Vec<Fault> {
        building::faults(self, steps)
    }

    /// The largest sag after each step, mm; infinite where it does not stand.
    ///
    /// # Panics
    /// Where the design has no such edge.
    #[must_use]
    pub fn sags(&self, steps: &[Step]) -> Vec<f64> {
        let (standing, mut edges) = (standing::Standing::new(self), Vec::new());
        let sags = steps.iter().map(|step| {
            edges.extend(&step.edges);
            standing.sag(&edges).map_or(f64::INFINITY, |(_, mm)| mm)
        });
        sags.collect()
    }

    fn at(&self, vertex: u32) -> Point3<f64> {
        self.vertices[&vertex].at
    }
}
