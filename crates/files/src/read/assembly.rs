//! Assembly-instances JSON (repository `yijiangh/assembly_instances`): nodes, elements, supports, and one material for all.

use std::collections::BTreeMap;

use nalgebra::Point3;
use serde::Deserialize;
use wirebend_core::wireframe::{EdgeId, VertexId};
use wirebend_error::ErrorRemedy;

use super::drawing::Drawing;
use super::error::{Location, ReadError};
use super::format::Format;
use super::frame::{
    Fixities, FrameFile, FrameMaterial, FrameMember, FrameSection, Quantity, merged, with_unit,
};
use super::note::NoteKind;
use super::options::{LengthUnit, ReadOptions};
use super::text::Source;
use super::{Imported, json};

#[derive(Deserialize)]
struct Assembly {
    unit: Option<String>,
    node_list: Vec<Node>,
    element_list: Vec<Element>,
    material_properties: Option<Properties>,
}

#[derive(Deserialize)]
struct Node {
    point: Coordinates,
    #[serde(rename = "node_id")]
    id: Option<i64>,
    #[serde(default)]
    is_grounded: Flag,
    #[serde(default)]
    fixities: Option<Vec<Flag>>,
}

#[derive(Deserialize)]
#[serde(rename_all = "UPPERCASE")]
struct Coordinates {
    x: f64,
    y: f64,
    z: f64,
}

#[derive(Deserialize)]
struct Element {
    end_node_ids: Vec<i64>,
    layer_id: Option<i64>,
}

/// One material and one section for all elements. The shear modulus is the stated one: the Poisson's ratio beside it is that of no
/// plastic in the published files.
#[derive(Deserialize)]
struct Properties {
    #[serde(default)]
    material_name: String,
    youngs_modulus: Option<f64>,
    youngs_modulus_unit: Option<String>,
    shear_modulus: Option<f64>,
    shear_modulus_unit: Option<String>,
    #[serde(alias = "tensile_yield_stress")]
    tensile_yeild_stress: Option<f64>,
    #[serde(alias = "tensile_yield_stress_unit")]
    tensile_yeild_stress_unit: Option<String>,
    density: Option<f64>,
    density_unit: Option<String>,
    cross_sec_area: Option<f64>,
    cross_sec_area_unit: Option<String>,
    #[serde(rename = "Jx")]
    jx: Option<f64>,
    #[serde(rename = "Jx_unit")]
    jx_unit: Option<String>,
    #[serde(rename = "Iy")]
    iy: Option<f64>,
    #[serde(rename = "Iy_unit")]
    iy_unit: Option<String>,
    #[serde(rename = "Iz")]
    iz: Option<f64>,
    #[serde(rename = "Iz_unit")]
    iz_unit: Option<String>,
}

/// 0, 1, false or true.
#[derive(Deserialize, Default)]
#[serde(untagged)]
enum Flag {
    #[default]
    Missing,
    Bool(bool),
    Number(f64),
}

impl Flag {
    fn is_set(&self) -> bool {
        matches!(self, Self::Bool(true)) || matches!(self, Self::Number(value) if *value != 0.0)
    }
}

impl Node {
    /// How it holds; a node that is grounded and says no more holds in every direction, and one whose fixities are all off holds nothing.
    fn fixities(&self, source: Source<'_>, place: Location) -> Result<Option<Fixities>, ReadError> {
        let stated = self.fixities.as_deref().unwrap_or_default();
        let held: Vec<bool> = stated.iter().map(Flag::is_set).collect();
        match Fixities::try_from(held) {
            Ok(held) => Ok(Some(held).filter(|held| held.contains(&true))),
            Err(held) if held.is_empty() => Ok(self.is_grounded.is_set().then_some([true; 6])),
            Err(held) => {
                let found = format!("{} fixities", held.len());
                let expected = "six fixities, or none";
                Err(source.syntax(place, &found, expected, ErrorRemedy::CorrectFile))
            }
        }
    }
}

/// Reads a frame. A node that has any fixity is a support, and so is one that is grounded and says none; `unit` is honoured.
pub(super) fn read(bytes: &[u8], source: Source<'_>, options: &ReadOptions) -> Result<Imported, ReadError> {
    let assembly: Assembly = json::parse(bytes, source, "an object with node_list and element_list")?;
    let mut drawing = Drawing { names: Some(["node", "element"]), ..Drawing::default() };
    if let Some(word) = &assembly.unit {
        drawing.unit_mm = LengthUnit::from_word(word).map(LengthUnit::mm);
        if drawing.unit_mm.is_none() && options.units.is_none() {
            let expected = "a unit: millimeter, centimeter, meter or inch";
            return Err(source.syntax(Location::File, word, expected, ErrorRemedy::ChooseUnit));
        }
    }
    let mut index_of = BTreeMap::new();
    let mut supports: Vec<(u32, Fixities)> = Vec::new();
    for (k, node) in assembly.node_list.iter().enumerate() {
        let place = Location::Item("node", k);
        source.room(place.clone(), k, "nodes")?;
        let id = node.id.unwrap_or(i64::try_from(k).unwrap_or(i64::MAX));
        let index = u32::try_from(k).unwrap_or(u32::MAX);
        if index_of.insert(id, index).is_some() {
            let remedy = ErrorRemedy::CorrectFile;
            return Err(source.syntax(place, &format!("node_id {id} again"), "another node_id", remedy));
        }
        let Coordinates { x, y, z } = node.point;
        drawing.points.push(Point3::new(x, y, z));
        supports.extend(node.fixities(source, place)?.map(|held| (index, held)));
    }
    drawing.supports.clone_from(&supports);
    let members = elements(&assembly, source, &index_of, &mut drawing)?;
    let described = assembly.material_properties.as_ref();
    drawing.notes.add(NoteKind::MaterialIgnored, usize::from(described.is_some()));
    let material = described.map(|stated| stated.material(source)).transpose()?.flatten();
    let section = described.map(|stated| stated.section(source)).transpose()?.flatten();
    let member = |layer| FrameMember {
        section: section.map(|_| 0),
        material: material.as_ref().map(|_| 0),
        tag: String::new(),
        layer,
    };
    let members: Vec<FrameMember> = members.into_iter().map(member).collect();
    let (mut imported, kept) = drawing.finish_kept(Format::Assembly, source, options)?;
    let vertex = |index: u32| kept.get(index as usize).map_or(VertexId(index), |kept| VertexId(*kept));
    let is_there = |id: EdgeId| imported.wireframe.edge(id).is_some();
    imported.frame = Some(Box::new(FrameFile {
        nodes: index_of.iter().map(|(number, index)| (*number, vertex(*index))).collect(),
        supports: merged(supports.into_iter().map(|(index, how)| (vertex(index), how))),
        sections: section.into_iter().collect(),
        materials: material.into_iter().collect(),
        members: (0..).map(EdgeId).zip(members).filter(|(id, _)| is_there(*id)).collect(),
    }));
    Ok(imported)
}

/// Adds the elements, and gives the layer of each.
fn elements(
    assembly: &Assembly,
    source: Source<'_>,
    index_of: &BTreeMap<i64, u32>,
    drawing: &mut Drawing,
) -> Result<Vec<Option<i64>>, ReadError> {
    let mut layers = Vec::with_capacity(assembly.element_list.len());
    for (k, element) in assembly.element_list.iter().enumerate() {
        let place = Location::Item("element", k);
        source.room(place.clone(), k, "elements")?;
        let [a, b] = *element.end_node_ids.as_slice() else {
            let found = format!("{} ends", element.end_node_ids.len());
            return Err(source.syntax(place, &found, "two end_node_ids", ErrorRemedy::CorrectFile));
        };
        let end = |id: i64| {
            index_of.get(&id).copied().ok_or_else(|| ReadError::Index {
                file: source.name.to_owned(),
                place: place.clone(),
                found: id.to_string(),
                what: "node",
                have: format!("there are {}", drawing.points.len()),
            })
        };
        let edge = (end(a)?, end(b)?);
        drawing.edges.push(edge);
        drawing.notes.add(NoteKind::LayersIgnored, usize::from(element.layer_id.is_some()));
        layers.push(element.layer_id);
    }
    Ok(layers)
}

impl Properties {
    /// The material, where both of its moduli and its density are stated.
    fn material(&self, source: Source<'_>) -> Result<Option<FrameMaterial>, ReadError> {
        let figure = |key, value: Option<f64>, unit: &Option<String>, wanted| {
            figure(source, key, value, unit.as_deref(), wanted)
        };
        let stress = Quantity::Stress;
        let youngs = figure("youngs_modulus", self.youngs_modulus, &self.youngs_modulus_unit, stress)?;
        let shear = figure("shear_modulus", self.shear_modulus, &self.shear_modulus_unit, stress)?;
        let density = figure("density", self.density, &self.density_unit, Quantity::Density)?;
        let (value, unit) = (self.tensile_yeild_stress, &self.tensile_yeild_stress_unit);
        let yields = figure("tensile_yeild_stress", value, unit, stress)?;
        let (Some(youngs_modulus_mpa), Some(shear_modulus_mpa), Some(density_kg_per_m3)) =
            (youngs, shear, density)
        else {
            return Ok(None);
        };
        Ok(Some(FrameMaterial {
            name: self.material_name.clone(),
            youngs_modulus_mpa,
            shear_modulus_mpa,
            density_kg_per_m3,
            yield_strength_mpa: yields,
        }))
    }

    /// The section, where all of it is stated.
    fn section(&self, source: Source<'_>) -> Result<Option<FrameSection>, ReadError> {
        let moment = |key, value, unit: &Option<String>| {
            figure(source, key, value, unit.as_deref(), Quantity::SecondMoment)
        };
        let unit = self.cross_sec_area_unit.as_deref();
        let area = figure(source, "cross_sec_area", self.cross_sec_area, unit, Quantity::Area)?;
        let moments = (
            moment("Jx", self.jx, &self.jx_unit)?,
            moment("Iy", self.iy, &self.iy_unit)?,
            moment("Iz", self.iz, &self.iz_unit)?,
        );
        let (Some(area_mm2), (Some(j_mm4), Some(iy_mm4), Some(iz_mm4))) = (area, moments) else {
            return Ok(None);
        };
        Ok(Some(FrameSection { area_mm2, j_mm4, iy_mm4, iz_mm4 }))
    }
}

/// A figure with its unit in the wanted one; none where it is not stated.
fn figure(
    source: Source<'_>,
    key: &str,
    value: Option<f64>,
    unit: Option<&str>,
    wanted: Quantity,
) -> Result<Option<f64>, ReadError> {
    let place = Location::Item("material_properties", 0);
    value.map(|value| with_unit(source, &place, key, value, unit, wanted)).transpose()
}
