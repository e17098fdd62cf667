//! Frames of conmech (repository `yijiangh/conmech`): nodes, elements, supports, sections, materials.
//!
//! Lengths are in the file's unit, metres as a rule; forces in kN. An entry of sections or materials names the elements that it is for by
//! their tags: none is for every element that no other entry names, and the empty tag is that of elements without one.

use std::collections::{BTreeMap, HashMap};

use nalgebra::Point3;
use serde::Deserialize;
use serde_json::Value;
use wirebend_core::wireframe::{EdgeId, VertexId};
use wirebend_error::ErrorRemedy;

use super::super::drawing::Drawing;
use super::super::error::{Location, ReadError};
use super::super::format::Format;
use super::super::note::NoteKind;
use super::super::options::{LengthUnit, ReadOptions};
use super::super::text::Source;
use super::super::{Imported, json};
use super::{Fixities, FrameFile, FrameMaterial, FrameMember, FrameSection, Quantity, quantity};

#[derive(Deserialize)]
struct Model {
    unit: String,
    nodes: Vec<Node>,
    elements: Vec<Element>,
    supports: Vec<Support>,
    #[serde(default)]
    joints: Vec<Joint>,
    #[serde(default)]
    cross_secs: Vec<Section>,
    #[serde(default)]
    materials: Vec<Material>,
}

#[derive(Deserialize)]
struct Node {
    point: [f64; 3],
    #[serde(rename = "node_ind")]
    number: i64,
    #[serde(default)]
    is_grounded: bool,
}

#[derive(Deserialize)]
struct Element {
    end_node_inds: Vec<i64>,
    #[serde(default)]
    elem_tag: String,
    #[serde(default = "none")]
    layer_ind: i64,
    #[serde(default = "yes")]
    bending_stiff: bool,
}

const fn none() -> i64 {
    -1
}

const fn yes() -> bool {
    true
}

#[derive(Deserialize)]
struct Support {
    condition: Vec<bool>,
    node_ind: i64,
}

/// Releases at the ends of elements.
#[derive(Deserialize)]
struct Joint {
    #[serde(default)]
    c_conditions: Vec<Value>,
}

#[derive(Deserialize)]
#[serde(rename_all = "PascalCase")]
struct Section {
    #[serde(rename = "elem_tags")]
    tags: Vec<String>,
    a: f64,
    #[serde(rename = "A_unit")]
    a_unit: String,
    jx: f64,
    #[serde(rename = "Jx_unit")]
    jx_unit: String,
    iy: f64,
    #[serde(rename = "Iy_unit")]
    iy_unit: String,
    iz: f64,
    #[serde(rename = "Iz_unit")]
    iz_unit: String,
}

#[derive(Deserialize)]
struct Material {
    #[serde(default)]
    name: String,
    #[serde(rename = "elem_tags")]
    tags: Vec<String>,
    #[serde(rename = "E")]
    e: f64,
    #[serde(rename = "E_unit")]
    e_unit: String,
    #[serde(rename = "G12")]
    g: f64,
    #[serde(rename = "G12_unit")]
    g_unit: String,
    fy: Option<f64>,
    fy_unit: Option<String>,
    density: f64,
    density_unit: String,
}

/// Reads a frame. A node of `supports` is a support, held as all of its entries say together; one that is grounded and not in that list is
/// held in every direction.
pub(crate) fn read(bytes: &[u8], source: Source<'_>, options: &ReadOptions) -> Result<Imported, ReadError> {
    let model: Model = json::parse(bytes, source, "a conmech frame with unit, nodes, elements and supports")?;
    let unit_mm = LengthUnit::from_word(&model.unit).map(LengthUnit::mm);
    let mut drawing = Drawing { unit_mm, names: Some(["node", "element"]), ..Drawing::default() };
    if drawing.unit_mm.is_none() && options.units.is_none() {
        let expected = "a unit: meter, centimeter, millimeter or inch";
        return Err(source.syntax(Location::File, &model.unit, expected, ErrorRemedy::ChooseUnit));
    }
    let index_of = nodes(&model, source, &mut drawing)?;
    elements(&model, source, &index_of, &mut drawing)?;
    let supports = supports(&model, source, &index_of)?;
    drawing.supports = supports.iter().map(|(index, how)| (*index, *how)).collect();
    let sections = sections(&model, source)?;
    let materials = materials(&model, source)?;
    let described = usize::from(!(sections.is_empty() && materials.is_empty()));
    drawing.notes.add(NoteKind::MaterialIgnored, described);
    for (k, joint) in model.joints.iter().enumerate() {
        if joint.c_conditions.iter().any(|condition| !condition.is_null()) {
            let what = "a release at the end of an element (c_conditions)";
            return Err(unsupported(source, Location::Item("joint", k), what));
        }
    }
    let section_of =
        by_tag(source, "cross section", model.cross_secs.iter().map(|one| &one.tags), &sections)?;
    let material_of = by_tag(source, "material", model.materials.iter().map(|one| &one.tags), &materials)?;
    let members = model.elements.iter().map(|element| FrameMember {
        section: of_tag(&section_of, &element.elem_tag),
        material: of_tag(&material_of, &element.elem_tag),
        tag: element.elem_tag.clone(),
        layer: Some(element.layer_ind).filter(|layer| *layer >= 0),
    });
    let members: Vec<FrameMember> = members.collect();
    let layers = members.iter().filter(|member| member.layer.is_some()).count();
    drawing.notes.add(NoteKind::LayersIgnored, layers);
    let (mut imported, kept) = drawing.finish_kept(Format::Conmech, source, options)?;
    let vertex = |index: u32| kept.get(index as usize).map_or(VertexId(index), |kept| VertexId(*kept));
    let is_there = |id: EdgeId| imported.wireframe.edge(id).is_some();
    imported.frame = Some(Box::new(FrameFile {
        nodes: index_of.iter().map(|(number, index)| (*number, vertex(*index))).collect(),
        supports: merged(supports.into_iter().map(|(index, how)| (vertex(index), how))),
        sections,
        materials,
        members: (0..).map(EdgeId).zip(members).filter(|(id, _)| is_there(*id)).collect(),
    }));
    Ok(imported)
}

/// Supports by vertex: where two nodes became one, it is held as both were.
pub(in super::super) fn merged(
    supports: impl Iterator<Item = (VertexId, Fixities)>,
) -> BTreeMap<VertexId, Fixities> {
    let mut all: BTreeMap<VertexId, Fixities> = BTreeMap::new();
    for (id, how) in supports {
        let held = all.entry(id).or_default();
        *held = std::array::from_fn(|k| held[k] || how[k]);
    }
    all
}

fn nodes(model: &Model, source: Source<'_>, drawing: &mut Drawing) -> Result<BTreeMap<i64, u32>, ReadError> {
    let mut index_of = BTreeMap::new();
    for (k, node) in model.nodes.iter().enumerate() {
        let place = Location::Item("node", k);
        source.room(place.clone(), k, "nodes")?;
        if index_of.insert(node.number, u32::try_from(k).unwrap_or(u32::MAX)).is_some() {
            let found = format!("node_ind {} again", node.number);
            return Err(source.syntax(place, &found, "another node_ind", ErrorRemedy::CorrectFile));
        }
        drawing.points.push(Point3::from(node.point));
    }
    Ok(index_of)
}

fn elements(
    model: &Model,
    source: Source<'_>,
    index_of: &BTreeMap<i64, u32>,
    drawing: &mut Drawing,
) -> Result<(), ReadError> {
    for (k, element) in model.elements.iter().enumerate() {
        let place = Location::Item("element", k);
        source.room(place.clone(), k, "elements")?;
        let [a, b] = *element.end_node_inds.as_slice() else {
            let found = format!("{} ends", element.end_node_inds.len());
            return Err(source.syntax(place, &found, "two end_node_inds", ErrorRemedy::CorrectFile));
        };
        if !element.bending_stiff {
            return Err(unsupported(source, place, "an element that does not bend (bending_stiff false)"));
        }
        let edge = (node(source, &place, index_of, a)?, node(source, &place, index_of, b)?);
        drawing.edges.push(edge);
    }
    Ok(())
}

fn supports(
    model: &Model,
    source: Source<'_>,
    index_of: &BTreeMap<i64, u32>,
) -> Result<BTreeMap<u32, Fixities>, ReadError> {
    let mut supports: BTreeMap<u32, Fixities> = BTreeMap::new();
    for (k, support) in model.supports.iter().enumerate() {
        let place = Location::Item("support", k);
        let index = node(source, &place, index_of, support.node_ind)?;
        let Ok(condition) = Fixities::try_from(support.condition.as_slice()) else {
            let found =
                format!("{} entries in the condition of node {}", support.condition.len(), support.node_ind);
            let expected = "six: which displacements along x, y, z and rotations about them are held";
            return Err(source.syntax(place, &found, expected, ErrorRemedy::CorrectFile));
        };
        let held = supports.entry(index).or_default();
        *held = std::array::from_fn(|axis| held[axis] || condition[axis]);
    }
    for node in model.nodes.iter().filter(|node| node.is_grounded) {
        if let Some(index) = index_of.get(&node.number) {
            supports.entry(*index).or_insert([true; 6]);
        }
    }
    // A condition that holds nothing is no support.
    supports.retain(|_, held| held.contains(&true));
    Ok(supports)
}

fn node(
    source: Source<'_>,
    place: &Location,
    index_of: &BTreeMap<i64, u32>,
    number: i64,
) -> Result<u32, ReadError> {
    index_of.get(&number).copied().ok_or_else(|| ReadError::Index {
        file: source.name.to_owned(),
        place: place.clone(),
        found: number.to_string(),
        what: "node",
        have: format!("there are {}", index_of.len()),
    })
}

fn sections(model: &Model, source: Source<'_>) -> Result<Vec<FrameSection>, ReadError> {
    let section = |(k, section): (usize, &Section)| {
        let place = Location::Item("cross section", k);
        let moment = |value: f64, unit: &str| {
            let factor = quantity(source, &place, Quantity::SecondMoment, unit)?;
            positive(source, &place, value).map(|value| value * factor)
        };
        let area = quantity(source, &place, Quantity::Area, &section.a_unit)?;
        Ok(FrameSection {
            area_mm2: positive(source, &place, section.a)? * area,
            j_mm4: moment(section.jx, &section.jx_unit)?,
            iy_mm4: moment(section.iy, &section.iy_unit)?,
            iz_mm4: moment(section.iz, &section.iz_unit)?,
        })
    };
    model.cross_secs.iter().enumerate().map(section).collect()
}

fn materials(model: &Model, source: Source<'_>) -> Result<Vec<FrameMaterial>, ReadError> {
    let material = |(k, material): (usize, &Material)| {
        let place = Location::Item("material", k);
        let in_unit =
            |key, value: f64, wanted, unit: &str| with_unit(source, &place, key, value, Some(unit), wanted);
        let yields =
            |fy: f64| with_unit(source, &place, "fy", fy, material.fy_unit.as_deref(), Quantity::Stress);
        Ok(FrameMaterial {
            name: material.name.clone(),
            youngs_modulus_mpa: in_unit("E", material.e, Quantity::Stress, &material.e_unit)?,
            shear_modulus_mpa: in_unit("G12", material.g, Quantity::Stress, &material.g_unit)?,
            density_kg_per_m3: in_unit(
                "density",
                material.density,
                Quantity::Density,
                &material.density_unit,
            )?,
            yield_strength_mpa: material.fy.map(yields).transpose()?,
        })
    };
    model.materials.iter().enumerate().map(material).collect()
}

/// A figure above zero, in the wanted unit. Without its own it says nothing.
pub(in super::super) fn with_unit(
    source: Source<'_>,
    place: &Location,
    key: &str,
    value: f64,
    unit: Option<&str>,
    wanted: Quantity,
) -> Result<f64, ReadError> {
    let Some(unit) = unit else {
        let (found, expected) = (format!("{key} without a unit"), format!("{key}_unit beside it"));
        return Err(source.syntax(place.clone(), &found, &expected, ErrorRemedy::CorrectFile));
    };
    let factor = quantity(source, place, wanted, unit)?;
    positive(source, place, value).map(|value| value * factor)
}

/// A figure that must be above zero.
fn positive(source: Source<'_>, place: &Location, value: f64) -> Result<f64, ReadError> {
    if value > 0.0 {
        return Ok(value);
    }
    Err(source.syntax(place.clone(), &value.to_string(), "a figure above 0", ErrorRemedy::CorrectFile))
}

/// Which entry is for a tag; `None` is every element that no other entry names. Several may say the same of a tag, not different
/// things.
fn by_tag<'a, T: PartialEq>(
    source: Source<'_>,
    what: &'static str,
    tags: impl Iterator<Item = &'a Vec<String>>,
    entries: &[T],
) -> Result<HashMap<Option<&'a str>, usize>, ReadError> {
    let mut found: HashMap<Option<&str>, usize> = HashMap::new();
    for (k, tags) in tags.enumerate() {
        let named: Vec<Option<&str>> =
            if tags.is_empty() { vec![None] } else { tags.iter().map(|tag| Some(tag.as_str())).collect() };
        for tag in named {
            let earlier = *found.entry(tag).or_insert(k);
            if entries.get(earlier) != entries.get(k) {
                let of = tag.map_or_else(|| "all elements".to_owned(), |tag| format!("the tag \"{tag}\""));
                let found = format!("another {what} for {of}");
                let expected = format!("one {what} for each tag; {what} {earlier} is for it");
                return Err(source.syntax(
                    Location::Item(what, k),
                    &found,
                    expected,
                    ErrorRemedy::CorrectFile,
                ));
            }
        }
    }
    Ok(found)
}

fn of_tag(found: &HashMap<Option<&str>, usize>, tag: &str) -> Option<usize> {
    found.get(&Some(tag)).or_else(|| found.get(&None)).copied()
}

fn unsupported(source: Source<'_>, place: Location, what: &str) -> ReadError {
    let remedy = Box::new(ErrorRemedy::CorrectFile);
    ReadError::Unsupported { file: source.name.to_owned(), place, what: what.to_owned(), remedy }
}
