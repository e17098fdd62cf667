//! The wire that a frame is made of.

use std::collections::{BTreeMap, BTreeSet};

use wirebend_core::estimate::WireModel;
use wirebend_core::units::Length;
use wirebend_core::wireframe::EdgeId;
use wirebend_files::read::frame::FrameFile;
use wirebend_frame::{Material, Section, SectionId};
use wirebend_profile::{MaterialFigures, Resolved};

use crate::choices::PlanChoices;
use crate::design::Opened;
use crate::machine::Setup;
use crate::{Installation, PlanningError};

/// The yield strength of a material whose own is not known, MPa.
pub(super) const UNKNOWN_YIELD: f64 = 1.0e300;

/// The wire of a frame as its parts need it, or what the file of a frame says that its struts are.
pub(crate) struct FrameMaterial {
    pub id: String,
    /// Of a wire one.
    pub sections: Vec<Section>,
    /// Where struts have not all the first section.
    sections_of: BTreeMap<EdgeId, SectionId>,
    /// Sections of a file that are no solid round: how far their outermost fibre is from the middle is not known, and so no stress.
    not_round: BTreeSet<SectionId>,
    pub wire: WireModel,
    /// Energy that forming a gram takes, kJ, where its profile says so.
    pub energy_kj_per_g: Option<f64>,
    /// Whether it is what the file of the frame says.
    pub of_file: bool,
    /// Where its yield strength comes from.
    pub yield_source: wirebend_core::checks::Source,
}

impl Installation {
    /// The wire that was chosen, else that of the design, else that of its machine.
    pub(crate) fn frame_material(
        &self,
        opened: &Opened,
        choices: &PlanChoices,
    ) -> Result<FrameMaterial, PlanningError> {
        let document = &opened.document;
        let own = choices.material.clone().or_else(|| document.material.as_ref().map(|own| own.id.clone()));
        let machine = choices.machine.clone().or_else(|| document.machine.as_ref().map(|own| own.id.clone()));
        if own.is_none()
            && let Some(file) = &opened.frame
            && let Some(stated) = FrameMaterial::of_file(opened, file)
        {
            return Ok(stated);
        }
        match (own, machine) {
            (None, Some(machine)) => {
                let own = self.library.machine(&machine)?.profile.default_material;
                self.material_of(own.as_deref().map(String::as_str))
            }
            (own, _) => self.material_of(own.as_deref()),
        }
    }

    /// A wire by its id.
    pub(crate) fn material_of(&self, id: Option<&str>) -> Result<FrameMaterial, PlanningError> {
        let known = || {
            let concrete = self.library.materials().into_iter().filter(|listing| !listing.is_abstract);
            concrete.map(|listing| listing.id).collect()
        };
        let id = id.ok_or_else(|| PlanningError::NoMaterial { known: known() })?.to_owned();
        let material = self.library.material(&id)?;
        FrameMaterial::new(id, &material, &material.figures()?)
    }
}

impl FrameMaterial {
    /// The section of an edge.
    pub fn section_of(&self, edge: EdgeId) -> SectionId {
        self.sections_of.get(&edge).copied().unwrap_or(SectionId(0))
    }

    /// The wire in a machine.
    pub fn planned(setup: &Setup) -> Result<Self, PlanningError> {
        Self::new(setup.material_id().to_owned(), &setup.material, &setup.material.figures()?)
    }

    /// Whether the stresses in a strut of a section are known.
    pub fn knows_stress(&self, section: SectionId) -> bool {
        !self.not_round.contains(&section)
    }

    /// The section of its only wire.
    pub fn section(&self) -> &Section {
        &self.sections[0]
    }

    /// What the file of a frame says of its struts; `None` where it does not say it of each.
    fn of_file(opened: &Opened, file: &FrameFile) -> Option<Self> {
        let (mut sections, mut sections_of) = (Vec::new(), BTreeMap::new());
        let mut not_round = BTreeSet::new();
        let mut known: BTreeMap<(usize, usize), SectionId> = BTreeMap::new();
        for (edge, _) in opened.document.wireframe.edges() {
            let member = file.members.get(&edge)?;
            let pair = (member.section?, member.material?);
            let (shape, material) = (file.sections.get(pair.0)?, file.materials.get(pair.1)?);
            let section = *known.entry(pair).or_insert_with(|| {
                let id = SectionId(sections.len());
                let radius = shape.round_radius_mm().unwrap_or_else(|| {
                    not_round.insert(id);
                    (shape.area_mm2 / std::f64::consts::PI).sqrt()
                });
                sections.push(Section {
                    area: shape.area_mm2,
                    iy: shape.iy_mm4,
                    iz: shape.iz_mm4,
                    j: shape.j_mm4,
                    radius,
                    e: material.youngs_modulus_mpa,
                    g: material.shear_modulus_mpa,
                    density: material.density_kg_per_m3 * 1.0e-12,
                    yield_strength: material.yield_strength_mpa.unwrap_or(UNKNOWN_YIELD),
                });
                id
            });
            sections_of.insert(edge, section);
        }
        let material = file.materials.first()?;
        let diameter = Length::from_mm(2.0 * sections.first()?.radius).unwrap_or_default();
        Some(Self {
            id: material.name.clone(),
            sections,
            sections_of,
            not_round,
            wire: WireModel {
                diameter,
                density_kg_per_m3: material.density_kg_per_m3,
                youngs_modulus_gpa: material.youngs_modulus_mpa * 1.0e-3,
                price_per_mm: None,
            },
            energy_kj_per_g: None,
            of_file: true,
            yield_source: wirebend_core::checks::Source { reason: None, entry: opened.name.clone() },
        })
    }

    fn new(
        id: String,
        material: &Resolved<wirebend_profile::MaterialProfile>,
        figures: &MaterialFigures,
    ) -> Result<Self, PlanningError> {
        let Some(shear_gpa) = figures.shear_modulus_gpa else {
            return Err(PlanningError::NoShearModulus { material: id });
        };
        let elastic = Material {
            e: figures.youngs_modulus_gpa * 1.0e3,
            g: shear_gpa * 1.0e3,
            // kg/m³ is 1e-12 t/mm³.
            density: figures.density_kg_per_m3 * 1.0e-12,
            yield_strength: figures.yield_strength_mpa,
        };
        let stated = material.profile.yield_strength_mpa.as_ref();
        Ok(Self {
            sections: vec![Section::round(figures.diameter_mm, &elastic)],
            sections_of: BTreeMap::new(),
            not_round: BTreeSet::new(),
            wire: WireModel {
                diameter: Length::from_mm(figures.diameter_mm).unwrap_or_default(),
                density_kg_per_m3: figures.density_kg_per_m3,
                youngs_modulus_gpa: figures.youngs_modulus_gpa,
                price_per_mm: figures.price_per_mm,
            },
            energy_kj_per_g: figures.process_energy_mj_per_kg,
            of_file: false,
            yield_source: crate::machine::source(
                material,
                "yield_strength_mpa",
                stated.map(|figure| figure.source.as_str()),
            ),
            id,
        })
    }
}
