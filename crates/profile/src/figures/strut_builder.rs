//! A complete strut builder's figures without their sources: what the search for a sequence takes.

use serde::{Deserialize, Serialize};

use crate::figures::{Complete, v};
use crate::strut_builder::{HeadPoint, StrutBuilderProfile, StrutProcess};

/// A box that the tip stays in.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct WorkspaceFigures {
    /// Its lowest corner, millimetres.
    pub min_mm: [f64; 3],
    /// Its highest corner, millimetres.
    pub max_mm: [f64; 3],
}

/// Figures of a complete strut builder. Units as in the names.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StrutBuilderFigures {
    /// How a strut comes to be.
    pub process: StrutProcess,
    /// Half section of the tool from its tip: z rising from 0, convex, two points or more.
    pub head: Vec<HeadPoint>,
    /// Step of the directions that are tried, degrees; a divisor of 180.
    pub direction_step_deg: f64,
    /// Largest angle of axis to motion from a built joint to a new one, degrees.
    pub create_approach_deg: f64,
    /// Largest angle of axis to motion between two built joints, degrees.
    pub connect_approach_deg: f64,
    /// How exactly the tool finds a joint, millimetres.
    pub position_tolerance_mm: f64,
    /// How far the tool stays from other struts, surface to surface, millimetres.
    pub clearance_mm: f64,
    /// Speed while a strut is built, millimetres a second.
    pub strut_mm_per_s: f64,
    /// Speed between struts, millimetres a second.
    pub travel_mm_per_s: f64,
    /// Wait at each joint, seconds.
    pub pause_per_joint_s: f64,
    /// Where the tip can be; `None`: everywhere.
    pub workspace: Option<WorkspaceFigures>,
    /// Whether struts on the ground are built before all others.
    pub ground_first: bool,
}

impl Complete for StrutBuilderProfile {
    type Figures = StrutBuilderFigures;

    fn complete(&self) -> Option<StrutBuilderFigures> {
        let workspace = self.workspace.as_ref();
        Some(StrutBuilderFigures {
            process: self.process.as_ref()?.value,
            head: self.head.as_ref()?.outline.clone(),
            direction_step_deg: v(&self.directions.step_deg)?,
            create_approach_deg: v(&self.approach_deg.create)?,
            connect_approach_deg: v(&self.approach_deg.connect)?,
            position_tolerance_mm: v(&self.position_tolerance_mm)?,
            clearance_mm: v(&self.clearance_mm)?,
            strut_mm_per_s: v(&self.speed.strut_mm_per_s)?,
            travel_mm_per_s: v(&self.speed.travel_mm_per_s)?,
            pause_per_joint_s: v(&self.pause_per_joint_s)?,
            workspace: workspace.map(|it| WorkspaceFigures { min_mm: it.min_mm, max_mm: it.max_mm }),
            ground_first: self.ground_first.as_ref()?.value,
        })
    }
}
