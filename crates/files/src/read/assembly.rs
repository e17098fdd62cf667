//! Assembly-instances JSON (repository `yijiangh/assembly_instances`): nodes, elements, supports.

use std::collections::HashMap;

use nalgebra::Point3;
use serde::Deserialize;
use wirebend_error::ErrorRemedy;

use super::Imported;
use super::drawing::Drawing;
use super::error::{Location, ReadError};
use super::format::Format;
use super::note::NoteKind;
use super::options::{LengthUnit, ReadOptions};
use super::text::Source;
use crate::document::without_place;

#[derive(Deserialize)]
struct Assembly {
    unit: Option<String>,
    node_list: Vec<Node>,
    element_list: Vec<Element>,
    material_properties: Option<serde::de::IgnoredAny>,
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
    layer_id: Option<serde::de::IgnoredAny>,
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

/// Reads a frame. A node that is grounded or has any fixity is a support; `unit` is honoured.
pub(super) fn read(bytes: &[u8], source: Source<'_>, options: &ReadOptions) -> Result<Imported, ReadError> {
    let assembly: Assembly = serde_json::from_slice(bytes).map_err(|error| {
        let expected = "an object with node_list and element_list".into();
        let remedy = ErrorRemedy::CorrectFile;
        let found = without_place(&error);
        let (file, place) = (source.name.to_owned(), Location::Line(error.line()));
        ReadError::Syntax { file, place, found, expected, remedy: Box::new(remedy) }
    })?;
    let mut drawing = Drawing::default();
    if let Some(word) = &assembly.unit {
        drawing.unit_mm = LengthUnit::from_word(word).map(LengthUnit::mm);
        if drawing.unit_mm.is_none() && options.units.is_none() {
            let remedy = ErrorRemedy::ChooseUnit;
            return Err(source.syntax(
                Location::File,
                word,
                "a unit: millimeter, centimeter, meter or inch",
                remedy,
            ));
        }
    }
    let mut index_of = HashMap::new();
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
        if node.is_grounded.is_set() || node.fixities.iter().flatten().any(Flag::is_set) {
            drawing.supports.push(index);
        }
    }
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
    }
    drawing.notes.add(NoteKind::MaterialIgnored, usize::from(assembly.material_properties.is_some()));
    drawing.finish(Format::Assembly, source, options)
}
