//! Load cases of conmech: forces at nodes, loads along elements, gravity.

use std::collections::BTreeMap;

use serde::Deserialize;
use wirebend_core::wireframe::{EdgeId, VertexId, Wireframe};
use wirebend_error::ErrorRemedy;

use super::super::error::{Location, ReadError};
use super::super::json;
use super::super::text::Source;
use super::{FrameFile, LineLoad, LoadCase, NodalLoad, Quantity, quantity};
use crate::encoding::utf8;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    loadcases: BTreeMap<String, Case>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    #[serde(default)]
    ploads: Vec<PointLoad>,
    #[serde(default)]
    eloads: Vec<ElementLoad>,
    #[serde(default)]
    gravity: Option<Gravity>,
    #[serde(default, rename = "lc_ind")]
    _number: Option<i64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PointLoad {
    force: [f64; 3],
    force_unit: String,
    moment: [f64; 3],
    moment_unit: String,
    node_ind: i64,
    #[serde(default, rename = "loadcase")]
    _case: Option<i64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ElementLoad {
    q: [f64; 3],
    q_unit: String,
    /// The same again.
    #[serde(default)]
    load: Option<[f64; 3]>,
    elem_tags: Vec<String>,
    #[serde(default, rename = "loadcase")]
    _case: Option<i64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Gravity {
    /// A multiple of standard gravity, whatever its unit says.
    force: [f64; 3],
    #[serde(default, rename = "force_unit")]
    _unit: Option<String>,
    #[serde(default, rename = "loadcase")]
    _case: Option<i64>,
}

/// Reads load cases for a frame, in the order of their names. Loads name nodes by the numbers of the frame's own file; without one, by the
/// ids of vertices. A load along elements without a tag is along all of them.
///
/// # Errors
/// [`ReadError`] with the load, for what is no such file, an unknown unit, node or tag.
pub fn read_loads(
    bytes: &[u8],
    name: &str,
    wireframe: &Wireframe,
    frame: Option<&FrameFile>,
) -> Result<Vec<LoadCase>, ReadError> {
    let source = Source { name };
    let file: File =
        json::parse(&utf8(bytes), source, "conmech load cases: {\"loadcases\": {\"0\": {...}}}")?;
    if file.loadcases.is_empty() {
        let but = String::new();
        return Err(ReadError::Empty { file: name.to_owned(), expected: "load cases", but });
    }
    let reader = Reader { source, wireframe, frame };
    file.loadcases.into_iter().map(|(name, case)| reader.case(&name, &case)).collect()
}

/// Whether two loads are not the same, beyond the rounding of what wrote them.
fn differ(a: [f64; 3], b: [f64; 3]) -> bool {
    a.iter().zip(b).any(|(a, b)| (a - b).abs() > 1e-9 * b.abs())
}

struct Reader<'a> {
    source: Source<'a>,
    wireframe: &'a Wireframe,
    frame: Option<&'a FrameFile>,
}

impl Reader<'_> {
    fn case(&self, name: &str, case: &Case) -> Result<LoadCase, ReadError> {
        let item = |what, index| Location::ItemOf { part: "load case", name: name.to_owned(), what, index };
        let mut read = LoadCase { name: name.to_owned(), ..LoadCase::default() };
        for (k, load) in case.ploads.iter().enumerate() {
            let place = item("node load", k);
            let force = quantity(self.source, &place, Quantity::Force, &load.force_unit)?;
            let moment = quantity(self.source, &place, Quantity::Moment, &load.moment_unit)?;
            read.nodal.push(NodalLoad {
                vertex: self.vertex(&place, load.node_ind)?,
                force_n: load.force.map(|part| part * force),
                moment_n_mm: load.moment.map(|part| part * moment),
            });
        }
        for (k, load) in case.eloads.iter().enumerate() {
            let place = item("element load", k);
            if load.load.is_some_and(|again| differ(again, load.q)) {
                let expected = "load equal to q, which says the same";
                return Err(self.source.syntax(
                    place,
                    "a load that is not q",
                    expected,
                    ErrorRemedy::CorrectFile,
                ));
            }
            let factor = quantity(self.source, &place, Quantity::LineForce, &load.q_unit)?;
            let n_per_mm = load.q.map(|part| part * factor);
            let edges = self.edges(&place, &load.elem_tags)?;
            read.line.extend(edges.into_iter().map(|edge| LineLoad { edge, n_per_mm }));
        }
        read.gravity = case.gravity.as_ref().map(|gravity| gravity.force);
        Ok(read)
    }

    fn vertex(&self, place: &Location, number: i64) -> Result<VertexId, ReadError> {
        let by_number = |frame: &FrameFile| frame.nodes.get(&number).copied();
        let by_id = || u32::try_from(number).ok().map(VertexId);
        let vertex = self.frame.map_or_else(by_id, by_number);
        vertex.filter(|id| self.wireframe.vertex(*id).is_some()).ok_or_else(|| ReadError::Index {
            file: self.source.name.to_owned(),
            place: place.clone(),
            found: number.to_string(),
            what: "node of the frame",
            have: format!("there are {}", self.wireframe.vertex_count()),
        })
    }

    /// The edges with one of the tags; all without any.
    fn edges(&self, place: &Location, tags: &[String]) -> Result<Vec<EdgeId>, ReadError> {
        let tag_of =
            |id: &EdgeId| self.frame.and_then(|frame| frame.members.get(id)).map_or("", |member| &member.tag);
        let all = self.wireframe.edges().map(|(id, _)| id);
        if tags.is_empty() {
            return Ok(all.collect());
        }
        let edges: Vec<(EdgeId, &str)> = all.map(|id| (id, tag_of(&id))).collect();
        if let Some(unknown) = tags.iter().find(|tag| !edges.iter().any(|(_, known)| known == tag)) {
            let expected = "elem_tags of elements that the frame has";
            let found = format!("the tag \"{unknown}\"");
            return Err(self.source.syntax(place.clone(), &found, expected, ErrorRemedy::CorrectFile));
        }
        Ok(edges
            .into_iter()
            .filter(|(_, tag)| tags.iter().any(|named| named == tag))
            .map(|(id, _)| id)
            .collect())
    }
}
