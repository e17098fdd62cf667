//! `FrameFab` PWF, as its authors' `WireFrame::LoadFromPWF` reads it (repository yijiangh/choreo).
//!
//! `v x y z` is a vertex; `l a b …` struts; `p base foot` a pillar, a strut from a vertex of the
//! design to a foot that stands on the ground; `c a b` marks a strut as ceiling, the last layer that is built; `g a b layer` gives
//! it a layer. `c` and `g` add the strut if it is not there. Indices count from 1.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::Point3;
use wirebend_core::wireframe::{EdgeId, VertexId};
use wirebend_error::ErrorRemedy;

use super::Imported;
use super::drawing::Drawing;
use super::error::{Location, ReadError};
use super::format::Format;
use super::frame::{FrameFile, FrameMember};
use super::note::NoteKind;
use super::options::ReadOptions;
use super::text::{Source, decode, lines};

/// Reads a frame. The feet of the pillars become supports.
pub(super) fn read(bytes: &[u8], source: Source<'_>, options: &ReadOptions) -> Result<Imported, ReadError> {
    let text = decode(bytes);
    let mut drawing = Drawing::default();
    for (line, text) in lines(&text) {
        let words: Vec<&str> = text.split_whitespace().collect();
        if let ["v", coordinates @ ..] = words.as_slice() {
            source.room(Location::Line(line), drawing.points.len(), "vertices")?;
            let [x, y, z] = coordinates else {
                let remedy = ErrorRemedy::CorrectFile;
                return Err(source.syntax(Location::Line(line), text, "v and three numbers", remedy));
            };
            let point = [source.number(line, x)?, source.number(line, y)?, source.number(line, z)?];
            drawing.points.push(Point3::from(point));
            drawing.point_lines.push(line);
        }
    }
    // Struts may come before their vertices, and marks before their struts.
    let (mut marked, mut ceilings) = (Vec::new(), Vec::new());
    let mut layers = BTreeMap::new();
    for (line, text) in lines(&text) {
        let words: Vec<&str> = text.split_whitespace().collect();
        let Some((&kind, rest)) = words.split_first() else {
            continue;
        };
        source.room(Location::Line(line), drawing.edges.len(), "edges")?;
        let have = drawing.points.len();
        let index = |word: &str| source.index(line, word, "vertex", have, false);
        match (kind, rest) {
            ("v", _) => {}
            ("l", [_, _, ..]) => {
                for pair in rest.windows(2) {
                    drawing.edges.push((index(pair[0])?, index(pair[1])?));
                    drawing.edge_lines.push(line);
                }
            }
            ("p", [base, foot]) => {
                let foot = index(foot)?;
                drawing.edges.push((index(base)?, foot));
                drawing.edge_lines.push(line);
                drawing.supports.push((foot, [true; 6]));
            }
            ("c", [a, b]) => {
                let ceiling = (index(a)?, index(b)?);
                marked.push((line, ceiling));
                ceilings.push(ceiling);
            }
            ("g", [a, b, layer]) => {
                let strut = (index(a)?, index(b)?);
                drawing.notes.add_at(NoteKind::LayersIgnored, Some(Location::Line(line)));
                layers.insert(ends(strut), source.whole(line, layer)?);
                marked.push((line, strut));
            }
            (comment, _) if comment.starts_with('#') => drawing.notes.add(NoteKind::CommentsIgnored, 1),
            _ => {
                let remedy = ErrorRemedy::CorrectFile;
                return Err(source.syntax(
                    Location::Line(line),
                    text,
                    "v x y z, l a b, p base foot, c a b or g a b layer",
                    remedy,
                ));
            }
        }
    }
    let mut known: BTreeSet<(u32, u32)> = drawing.edges.iter().copied().map(ends).collect();
    for (line, edge) in marked.into_iter().filter(|(_, edge)| known.insert(ends(*edge))) {
        drawing.edges.push(edge);
        drawing.edge_lines.push(line);
    }
    let ceilings: BTreeSet<(u32, u32)> = ceilings.into_iter().map(ends).collect();
    drawing.ceilings = (0..)
        .zip(&drawing.edges)
        .filter(|(_, edge)| ceilings.contains(&ends(**edge)))
        .map(|(k, _)| k)
        .collect();
    let (edges, feet, count) = (drawing.edges.clone(), drawing.supports.clone(), drawing.points.len());
    let (mut imported, kept) = drawing.finish_kept(Format::Pwf, source, options)?;
    let vertex = |index: u32| kept.get(index as usize).map_or(VertexId(index), |kept| VertexId(*kept));
    let member = |edge| FrameMember { layer: layers.get(&ends(edge)).copied(), ..FrameMember::default() };
    let is_there = |id: EdgeId| imported.wireframe.edge(id).is_some();
    let members =
        (0..).map(EdgeId).zip(edges.into_iter().map(member)).filter(|(id, _)| is_there(*id)).collect();
    imported.frame = Some(Box::new(FrameFile {
        nodes: (1..).zip((0..).take(count).map(vertex)).collect(),
        supports: feet.iter().map(|(foot, how)| (vertex(*foot), *how)).collect(),
        members,
        ..FrameFile::default()
    }));
    Ok(imported)
}

/// The same for both directions of a strut.
fn ends((a, b): (u32, u32)) -> (u32, u32) {
    (a.min(b), a.max(b))
}
