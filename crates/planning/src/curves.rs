//! Curves of a drawing on a machine: how short their edges may be, and what was made of them.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::compensate::PegGeometry;
use wirebend_core::plan::Machine;
use wirebend_core::units::{Length, Mm};
use wirebend_core::wireframe::{ChordLimits, Component, Wireframe};
use wirebend_error::{ErrorRemedy, InputName};
use wirebend_files::read::CurveFacts;

use crate::machine::{Setup, mm};
use crate::report::NoteReport;
use crate::text::shown;
use crate::{Installation, PlanChoices, PlanningError};

/// How short edges may be that are made of the curves of a drawing.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ShortestEdge {
    /// What the machine can make.
    Machine,
    /// In mm.
    Mm(f64),
}

/// No machine makes edges as short as this, mm, and a curve has room for any number of shorter ones.
const MIN_SHORTEST_MM: f64 = 0.1;

/// What of edges a machine can make with its wire.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct MachineEdges {
    /// The shortest edge between two bends of up to 90°, mm.
    pub shortest_edge_mm: f64,
    /// Centreline radius of its bends, mm.
    pub bend_radius_mm: f64,
}

impl MachineEdges {
    #[must_use]
    pub fn of(machine: &Machine) -> Self {
        Self {
            shortest_edge_mm: chord_limits(machine).between_right_angles().mm(),
            bend_radius_mm: machine.bend_radius.mm(),
        }
    }
}

/// What of chords and of the edges of shapes a machine can make.
#[must_use]
pub fn chord_limits(machine: &Machine) -> ChordLimits {
    let feed = machine.compensation.feed;
    ChordLimits {
        min_edge: machine.limits.min_edge.value,
        min_feed: machine.limits.min_feed.value,
        bend_radius: feed.map_or(Length::ZERO, |feed| feed.bend_radius),
        neutral_radius: feed.map_or(Length::ZERO, |feed| feed.neutral_radius),
        lead: machine.compensation.bend.setback.as_ref().map_or(Length::ZERO, PegGeometry::meets),
    }
}

/// How short edges of curves may be, in numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct EdgeChoice {
    pub shortest: Length,
    /// Of the machine that is known; zero without one.
    pub bend_radius: Length,
}

impl ShortestEdge {
    /// In numbers, for a machine if there is one.
    pub(crate) fn chosen(self, machine: Option<&Machine>) -> Result<EdgeChoice, PlanningError> {
        let name = InputName::ShortestEdge;
        let refused = |value: String, expected: &'static str| PlanningError::Value {
            input: Some(name),
            name: name.words(),
            value,
            expected,
        };
        let shortest = match (self, machine.map(MachineEdges::of)) {
            (Self::Mm(given), _) => {
                let length = Length::from_mm(given).ok().filter(|length| length.mm() >= MIN_SHORTEST_MM);
                length.ok_or_else(|| refused(given.to_string(), "a length of 0.1 mm or more"))?
            }
            (Self::Machine, Some(edges)) => mm(edges.shortest_edge_mm)?,
            (Self::Machine, None) => {
                let expected = "a length in mm: no machine is chosen to take it from";
                return Err(refused("machine".to_owned(), expected));
            }
        };
        Ok(EdgeChoice { shortest, bend_radius: machine.map_or(Length::ZERO, |machine| machine.bend_radius) })
    }
}

impl Installation {
    /// The machine of choices; none where none is chosen.
    pub(crate) fn chosen_setup(&self, choices: &PlanChoices) -> Result<Option<Setup>, PlanningError> {
        let machine = choices.machine.as_deref();
        machine.map(|machine| self.setup(machine, choices.material.as_deref())).transpose()
    }
}

/// What was made of the curves of a drawing.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct CurvesReport {
    /// How many curves there are.
    pub curves: usize,
    /// The largest distance between the drawing and its edges, mm.
    pub deviation_mm: f64,
    /// Where that is, mm.
    pub at_mm: [f64; 3],
    /// How many curves are farther off than the tolerance, since closer edges would be too short.
    pub coarser: usize,
    /// How many edges are too short all the same: their curves have no room for longer ones.
    pub too_short: usize,
    /// How many curves are tighter than the machine bends; 0 where it is not known.
    pub tight: usize,
    /// The radius of the tightest of these, mm.
    pub tightest_mm: Option<f64>,
    /// Where that is, mm.
    pub tightest_at_mm: Option<[f64; 3]>,
}

impl CurvesReport {
    pub(crate) fn new(facts: &CurveFacts, edges: &EdgeChoice) -> Self {
        // What is bent about the very pin is not tighter.
        let bent = edges.bend_radius.mm() * (1.0 - 1e-3);
        let tight: Vec<_> = facts.radii.iter().filter(|radius| radius.radius_mm < bent).collect();
        let tightest = tight.iter().min_by(|one, other| one.radius_mm.total_cmp(&other.radius_mm));
        Self {
            curves: facts.radii.len(),
            deviation_mm: facts.deviation_mm,
            at_mm: facts.at.coords.into(),
            coarser: facts.coarser,
            too_short: facts.too_short,
            tight: tight.len(),
            tightest_mm: tightest.map(|radius| radius.radius_mm),
            tightest_at_mm: tightest.map(|radius| radius.at.coords.into()),
        }
    }

    /// What a person has to know of it.
    pub(crate) fn notes(&self, edges: &EdgeChoice) -> Vec<NoteReport> {
        let note = |code: &'static str, count: usize, remedies: &[ErrorRemedy], message: String| {
            (count > 0).then(|| NoteReport { code: code.into(), count, message, remedies: remedies.to_vec() })
        };
        let counted = |count: usize, one: &str, many: &str| {
            if count == 1 { format!("1 {one}") } else { format!("{count} {many}") }
        };
        let at = |[x, y, z]: [f64; 3]| format!("({:.1}, {:.1}, {:.1})", Mm(x), Mm(y), Mm(z));
        let shorter = [ErrorRemedy::CorrectInput { input: InputName::ShortestEdge }, ErrorRemedy::CheckScale];
        shown(|| {
            let shortest = Mm(edges.shortest.mm());
            let coarser = note(
                "curves-coarser",
                self.coarser,
                &[],
                format!(
                    "{} from the drawing by up to {:.2}, at {}: edges nearer to it would be shorter than {shortest:.1}",
                    counted(self.coarser, "curve differs", "curves differ"),
                    Mm(self.deviation_mm),
                    at(self.at_mm),
                ),
            );
            let short = note(
                "curves-too-short",
                self.too_short,
                &shorter,
                format!(
                    "{} shorter than {shortest:.1}: the curve has no room for longer ones",
                    counted(self.too_short, "edge of a curve is", "edges of curves are"),
                ),
            );
            let tight = self.tightest_mm.zip(self.tightest_at_mm).and_then(|(radius, place)| {
                let (count, bent) = (self.tight, Mm(edges.bend_radius.mm()));
                let message = format!(
                    "{} tighter than bends of the machine, whose radius is {bent:.1}: down to {:.1}, at {}",
                    counted(count, "curve is", "curves are"),
                    Mm(radius),
                    at(place),
                );
                note("curves-tight", count, &[], message)
            });
            [coarser, short, tight].into_iter().flatten().collect()
        })
    }
}

/// How many vertices of two edges turn the wire by more than a machine leaves straight; by anything without one. A ring is
/// not bent where it begins and ends.
#[must_use]
pub fn bend_count(wireframe: &Wireframe, straight_deg: f64) -> usize {
    let turns = |id| {
        let edges = wireframe.incident(id);
        let [one, other] = edges[..] else { return false };
        let ways = wireframe.direction(one, id).zip(wireframe.direction(other, id));
        ways.is_some_and(|(one, other)| 180.0 - one.angle(&other).to_degrees() > straight_deg.max(1e-3))
    };
    let is_ring = |part: &Component| {
        !part.edges.is_empty() && part.vertices.iter().all(|&id| wireframe.incident(id).len() == 2)
    };
    let rings = wireframe.components().iter().filter(|part| is_ring(part)).count();
    wireframe.vertices().filter(|&(id, _)| turns(id)).count().saturating_sub(rings)
}

#[cfg(test)]
mod tests {
    use nalgebra::{Point3, Vector3};
    use wirebend_core::plan::{PlanOptions, WirePlan, plan_wires};
    use wirebend_core::units::Angle;
    use wirebend_core::wireframe::{Edit, Outcome, PolygonSize, ShapePlane};

    use super::*;

    /// Two corners of 90° take a tangent of the bend radius each, and the arc of one is fed for it: 25 mm are left of
    /// 25 + 2·3 - 2.4·π/2.
    #[test]
    fn what_the_kit_can_make_leaves_its_shortest_feed() {
        let setup = Installation::new(&[]).unwrap().setup("wirebend-kit", None).unwrap();
        let edges = MachineEdges::of(&setup.model);
        assert!((edges.bend_radius_mm - 3.0).abs() < 1e-9);
        let neutral = setup.model.compensation.feed.unwrap().neutral_radius.mm();
        let needed = 25.0 + (6.0 - neutral * std::f64::consts::FRAC_PI_2).max(3.0);
        assert!((edges.shortest_edge_mm - needed).abs() < 1e-9, "{edges:?}");
    }

    #[test]
    fn a_shortest_edge_needs_a_length_or_a_machine() {
        let setup = Installation::new(&[]).unwrap().setup("wirebend-kit", None).unwrap();
        let chosen = ShortestEdge::Machine.chosen(Some(&setup.model)).unwrap();
        assert!((chosen.shortest.mm() - MachineEdges::of(&setup.model).shortest_edge_mm).abs() < 1e-9);
        for (asked, expected) in [
            (ShortestEdge::Machine, "no machine is chosen"),
            (ShortestEdge::Mm(0.0), "0.1 mm or more"),
            (ShortestEdge::Mm(1e-9), "0.1 mm or more"),
            (ShortestEdge::Mm(f64::NAN), "0.1 mm or more"),
        ] {
            let error = asked.chosen(None).unwrap_err().to_string();
            assert!(error.contains(expected), "{error}");
        }
    }

    /// What a shape says of its edges is what the checks say of the wire: also of the first one, which has to reach the peg.
    #[test]
    fn shapes_that_fit_are_those_that_the_checks_let_pass() {
        let app = Installation::new(&[]).unwrap();
        let plane = ShapePlane { centre: Point3::origin(), u: Vector3::x_axis(), v: Vector3::y_axis() };
        let mm = |mm: f64| Length::from_mm(mm).unwrap();
        let mut passed = [0, 0];
        for machine in ["wirebend-kit", "grbl-bender"] {
            let setup = app.setup(machine, None).unwrap();
            let limits = chord_limits(&setup.model);
            for sides in [6, 9, 12, 18] {
                for side in 18..36 {
                    // Between whole millimetres, where no limit is.
                    let size = PolygonSize::Side(mm(f64::from(side) + 0.37));
                    let edit = Edit::AddPolygon { plane, sides, size, turn: Angle::ZERO };
                    let mut wireframe = Wireframe::new();
                    let Ok(Some(Outcome::Shape(shape))) = edit.outcome(&wireframe, &limits) else { panic!() };
                    wireframe.apply(&edit).unwrap();
                    let component = &wireframe.components()[0];
                    let options = PlanOptions::default();
                    let plans = plan_wires(&wireframe, component, &setup.model, &options, |_| ());
                    let feasible = plans.iter().all(WirePlan::is_feasible);
                    assert_eq!(shape.fits, feasible, "{machine}: {sides} sides of {side}.37 mm: {shape:?}");
                    passed[usize::from(feasible)] += 1;
                }
            }
        }
        assert!(passed.iter().all(|&count| count > 20), "{passed:?}");
    }
}
