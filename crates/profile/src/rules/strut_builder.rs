//! What a complete strut-builder profile needs and what contradicts itself in one.

use super::{FIGURE, above, within};
use crate::Kind;
use crate::heading::heading;
use crate::profile::{Fault, Profile};
use crate::strut_builder::{HeadPoint, StrutBuilderProfile, ToolHead, Workspace};

const HEAD: &str =
    "{\"outline\": [{\"z_mm\": 0, \"r_mm\": number}, ...], \"source\": text, \"measured\": true or false}";
const REQUIRED: &[(&str, &str)] = &[
    ("name", "a name for people"),
    ("process", "\"extrude\", \"weld\" or \"place\""),
    ("default_material", "the id of a material profile"),
    ("head", HEAD),
    ("directions.step_deg", FIGURE),
    ("approach_deg.create", FIGURE),
    ("approach_deg.connect", FIGURE),
    ("position_tolerance_mm", FIGURE),
    ("clearance_mm", FIGURE),
    ("speed.strut_mm_per_s", FIGURE),
    ("speed.travel_mm_per_s", FIGURE),
    ("pause_per_joint_s", FIGURE),
    ("ground_first", "true or false"),
];

/// More points than the outline of any tool has.
const MAX_OUTLINE: usize = 1000;
/// Finer steps give so many directions that a search never ends.
const MIN_STEP_DEG: f64 = 1.0;

impl Profile for StrutBuilderProfile {
    const KIND: Kind = Kind::StrutBuilder;
    const WHOLE: &'static [&'static str] = &["head", "workspace"];
    heading!();

    fn required(&self) -> Vec<(&'static str, &'static str)> {
        REQUIRED.to_vec()
    }

    fn faults(&self) -> Vec<Fault> {
        let mut faults = Vec::new();
        above(&mut faults, "speed.strut_mm_per_s", &self.speed.strut_mm_per_s);
        above(&mut faults, "speed.travel_mm_per_s", &self.speed.travel_mm_per_s);
        within(&mut faults, "approach_deg.create", &self.approach_deg.create, 0.0, 180.0);
        within(&mut faults, "approach_deg.connect", &self.approach_deg.connect, 0.0, 180.0);
        within(&mut faults, "position_tolerance_mm", &self.position_tolerance_mm, 0.0, f64::MAX);
        within(&mut faults, "clearance_mm", &self.clearance_mm, 0.0, f64::MAX);
        within(&mut faults, "pause_per_joint_s", &self.pause_per_joint_s, 0.0, f64::MAX);
        self.step_faults(&mut faults);
        if let Some(head) = &self.head {
            head.faults(&mut faults);
        }
        if let Some(workspace) = &self.workspace {
            workspace.faults(&mut faults);
        }
        faults
    }

    fn references(&self) -> Vec<(&'static str, Kind, &str)> {
        self.default_material
            .iter()
            .map(|id| ("default_material", Kind::Material, id.value.as_str()))
            .collect()
    }
}

impl StrutBuilderProfile {
    /// The rings have to close and to lie alike above and below.
    fn step_faults(&self, faults: &mut Vec<Fault>) {
        let Some(step) = &self.directions.step_deg else { return };
        let rings = 180.0 / step.value;
        let divides = (rings - rings.round()).abs() < 1e-9;
        if !(step.value >= MIN_STEP_DEG && step.value <= 90.0 && divides) {
            let expected = format!("a divisor of 180 between {MIN_STEP_DEG} and 90");
            faults.push(Fault::new("directions.step_deg", step.value, expected));
        }
    }
}

impl ToolHead {
    fn faults(&self, faults: &mut Vec<Fault>) {
        let key = "head.outline";
        blank(faults, "head.source", &self.source);
        if !(2..=MAX_OUTLINE).contains(&self.outline.len()) {
            let found = format!("{} points", self.outline.len());
            faults.push(Fault::new(key, found, format!("2 to {MAX_OUTLINE} points")));
        }
        if let Some(tip) = self.outline.first().filter(|tip| tip.z_mm != 0.0) {
            faults.push(Fault::new(key, tip.z_mm, "z_mm of 0 at the first point, the tip"));
        }
        if let Some(point) = self.outline.iter().find(|point| point.r_mm < 0.0) {
            faults.push(Fault::new(key, point.r_mm, "r_mm of 0 or more"));
        }
        if self.outline.iter().all(|point| point.r_mm <= 0.0) {
            faults.push(Fault::new(key, "a head without a radius", "an r_mm above 0"));
        }
        if let Some([before, after]) = pairs(&self.outline).find(|[a, b]| b.z_mm <= a.z_mm) {
            let expected = format!("z_mm above that of the point before, {}", before.z_mm);
            faults.push(Fault::new(key, after.z_mm, expected));
            return;
        }
        let slopes = pairs(&self.outline).map(|[a, b]| (b.r_mm - a.r_mm) / (b.z_mm - a.z_mm));
        let slopes: Vec<f64> = slopes.collect();
        for (k, pair) in slopes.windows(2).enumerate() {
            // A straight side that is written as several pieces may be off by its last digit.
            if pair[1] > pair[0] + 1e-6 {
                let found = format!("hollow at z_mm {}", self.outline[k + 1].z_mm);
                faults.push(Fault::new(key, found, "a convex head: its sides never bend outwards"));
            }
        }
    }
}

impl Workspace {
    fn faults(&self, faults: &mut Vec<Fault>) {
        blank(faults, "workspace.source", &self.source);
        for (low, high) in self.min_mm.iter().zip(self.max_mm) {
            if *low >= high {
                let expected = format!("above the lower bound, {low}");
                faults.push(Fault::new("workspace.max_mm", high, expected).against("workspace.min_mm"));
            }
        }
    }
}

fn pairs(outline: &[HeadPoint]) -> impl Iterator<Item = [HeadPoint; 2]> + '_ {
    outline.windows(2).map(|pair| [pair[0], pair[1]])
}

fn blank(faults: &mut Vec<Fault>, key: &str, source: &str) {
    if source.trim().is_empty() {
        let expected = "where the dimensions come from, or why they are an estimate";
        faults.push(Fault::new(key, "an empty text", expected));
    }
}
