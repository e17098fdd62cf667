//! The figures of a strut builder and of what it builds with, as the search takes them.

use nalgebra::Point3;
use wirebend_core::units::{Angle, Length};
use wirebend_error::InputName;
use wirebend_frame::Section;
use wirebend_profile::{StrutBuilderFigures, StrutProcess};
use wirebend_sequence::{Head, HeadDirections, Pace, StrutBuilder};

use super::{GroupBy, SequenceRequest, material_choices};
use crate::design::Opened;
use crate::frame::FrameMaterial;
use crate::{Installation, PlanningError};

/// A strut builder with what it builds.
pub(super) struct BuilderSetup {
    pub machine: String,
    pub material: FrameMaterial,
    pub builder: StrutBuilder,
    pub section: Section,
    /// Half section of the head from its tip: z and radius, mm.
    pub outline: Vec<[f64; 2]>,
}

impl BuilderSetup {
    /// The machine that was asked for, with the material that was, else that of the design, else its own.
    pub fn new(
        app: &Installation,
        opened: &Opened,
        request: &SequenceRequest,
    ) -> Result<Self, PlanningError> {
        let resolved = app.library.strut_builder(&request.machine)?;
        let figures = resolved.figures()?;
        let own = request.material.is_none() && opened.document.material.is_none();
        let material = if own {
            app.material_of(resolved.profile.default_material.as_deref().map(String::as_str))?
        } else {
            app.frame_material(opened, &material_choices(request))?
        };
        let mut builder = builder(&request.machine, &figures, &material, request.epsilon_mm)?;
        // What was bent before is not drawn, be it a single strut.
        builder.places |= request.group_by == GroupBy::Wire;
        let section = *material.section();
        let outline = figures.head.iter().map(|point| [point.z_mm, point.r_mm]).collect();
        Ok(Self { machine: request.machine.clone(), material, builder, section, outline })
    }
}

fn builder(
    machine: &str,
    figures: &StrutBuilderFigures,
    material: &FrameMaterial,
    epsilon_mm: Option<f64>,
) -> Result<StrutBuilder, PlanningError> {
    let unusable = |reason: String| PlanningError::StrutBuilder { machine: machine.to_owned(), reason };
    let outline: Vec<[f64; 2]> = figures.head.iter().map(|point| [point.z_mm, point.r_mm]).collect();
    let deg = |value: f64| Angle::from_deg(value).map_err(|error| unusable(error.to_string()));
    let mm = |value: f64| Length::from_mm(value).map_err(|error| unusable(error.to_string()));
    let corner = |corner: [f64; 3]| Point3::from(corner);
    Ok(StrutBuilder {
        head: Head::new(&outline).map_err(|error| unusable(error.to_string()))?,
        places: figures.process != StrutProcess::Extrude,
        directions: HeadDirections::each(deg(figures.direction_step_deg)?)
            .map_err(|error| unusable(error.to_string()))?,
        max_create: deg(figures.create_approach_deg)?,
        max_connect: deg(figures.connect_approach_deg)?,
        touch: mm(figures.position_tolerance_mm)?,
        clearance: mm(figures.clearance_mm)?,
        ground_first: figures.ground_first,
        max_sag: epsilon(figures, material, epsilon_mm)?,
        workspace: figures.workspace.as_ref().map(|room| [corner(room.min_mm), corner(room.max_mm)]),
        pace: Pace {
            build_mm_s: figures.strut_mm_per_s,
            travel_mm_s: figures.travel_mm_per_s,
            pause_s: figures.pause_per_joint_s,
        },
    })
}

/// How far a joint may be from where it is drawn: a head that comes within its tolerance still meets the strut.
fn epsilon(
    figures: &StrutBuilderFigures,
    material: &FrameMaterial,
    asked: Option<f64>,
) -> Result<Length, PlanningError> {
    let epsilon = asked.unwrap_or(material.section().radius - figures.position_tolerance_mm);
    let wrong = || PlanningError::Value {
        input: Some(InputName::Epsilon),
        name: InputName::Epsilon.words(),
        value: format!("{epsilon:.3}"),
        expected: "a length in mm above 0; without one it is the radius of a strut less the machine's position tolerance",
    };
    Length::from_mm(epsilon).ok().filter(|epsilon| *epsilon > Length::ZERO).ok_or_else(wrong)
}
