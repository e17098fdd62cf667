//! glTF 2.0, as text or binary (`.glb`), with buffers in the file or in files beside it: triangles are a stencil, lines
//! a wireframe.
//!
//! The format measures in metres and has y up; here are millimetres and z up, so the model is turned by 90° about x.
//! The JSON is read here and not by a crate, since the one that there is panics on damaged buffers. Normals,
//! textures, materials, skins, morphs and animations are not read: a model has the shape that it is stored in.

mod accessor;
mod file;

use nalgebra::{Affine3, Matrix4, Quaternion, UnitQuaternion, Vector3};

use self::accessor::Data;
use self::file::{Node, Primitive, open};
use super::Imported;
use super::beside::Beside;
use super::drawing::Drawing;
use super::error::{Location, ReadError};
use super::format::Format;
use super::note::NoteKind;
use super::options::ReadOptions;
use super::text::{Source, excerpt};
use wirebend_error::ErrorRemedy;

/// How deep nodes may hold nodes.
const MAX_DEPTH: usize = 256;
const METRE_MM: f64 = 1e3;

/// Extensions that change no position, by how their names begin, and the one that only makes numbers smaller.
const HARMLESS: &[&str] = &[
    "KHR_mesh_quantization",
    "KHR_materials_",
    "KHR_texture_",
    "EXT_texture_",
    "KHR_lights_",
    "EXT_lights_",
    "KHR_xmp",
];

/// Reads the scene that the file opens with; where there is none, all nodes.
pub(super) fn read(bytes: &[u8], source: Source<'_>, options: &ReadOptions) -> Result<Imported, ReadError> {
    let (root, binary) = open(bytes, source)?;
    if root.asset.version.split('.').next() != Some("2") {
        let remedy = ErrorRemedy::ExportAs { form: "glTF 2.0".to_owned() };
        return Err(source.syntax(Location::File, &root.asset.version, "asset version 2.0", remedy));
    }
    let harmless = |name: &&String| HARMLESS.iter().any(|begin| name.starts_with(begin));
    if let Some(name) = root.extensions_required.iter().find(|name| !harmless(name)) {
        let what = format!("a model that requires {}", excerpt(name));
        let remedy = ErrorRemedy::ExportWithout { part: "compression and extensions".to_owned() };
        return Err(ReadError::Unsupported {
            file: source.name.to_owned(),
            place: Location::File,
            what,
            remedy: Box::new(remedy),
        });
    }
    let mut drawing = Drawing { unit_mm: Some(METRE_MM), ..Drawing::default() };
    drawing.notes.add(NoteKind::AxisUp, 1);
    drawing.notes.add(NoteKind::ElementsIgnored, root.animations.len() + root.cameras.len());
    drawing.notes.add(NoteKind::ImagesIgnored, root.images.len());
    let data = Data::new(source, &root, binary, Beside::new(options.folder.as_deref()));
    let seen = vec![false; root.nodes.len()];
    let mut walk = Walk { data, drawing, open: Vec::new(), seen, met: 0, corners: 0 };
    let upright = Affine3::from_matrix_unchecked(Matrix4::new(
        1.0, 0.0, 0.0, 0.0, //
        0.0, 0.0, -1.0, 0.0, //
        0.0, 1.0, 0.0, 0.0, //
        0.0, 0.0, 0.0, 1.0,
    ));
    let scene = match root.scene {
        Some(index) => Some(walk.data.get(&root.scenes, index, "scene")?),
        None => root.scenes.first(),
    };
    let nodes = scene.map_or_else(|| tops(&root.nodes), |scene| scene.nodes.clone());
    for node in nodes {
        walk.node(node, &upright)?;
    }
    // Those of other scenes.
    let left =
        root.nodes.iter().zip(&walk.seen).filter(|(node, seen)| node.mesh.is_some() && !**seen).count();
    walk.drawing.notes.add(NoteKind::ElementsIgnored, left);
    walk.drawing.finish(Format::Gltf, source, options)
}

/// The nodes that no other holds.
fn tops(nodes: &[Node]) -> Vec<usize> {
    let mut tops: Vec<bool> = nodes.iter().map(|_| true).collect();
    for &child in nodes.iter().flat_map(|node| &node.children) {
        if let Some(top) = tops.get_mut(child) {
            *top = false;
        }
    }
    (0..nodes.len()).filter(|&node| tops[node]).collect()
}

struct Walk<'a> {
    data: Data<'a>,
    drawing: Drawing,
    /// The nodes that are open.
    open: Vec<usize>,
    /// The nodes that were met.
    seen: Vec<bool>,
    /// Nodes and primitives met: a damaged file may hold one many times.
    met: usize,
    /// Corners of all primitives, drawn or not: reading them takes its time, too.
    corners: usize,
}

impl Walk<'_> {
    fn node(&mut self, index: usize, map: &Affine3<f64>) -> Result<(), ReadError> {
        let (source, root, place) = (self.data.source, self.data.root, Location::Item("node", index));
        source.room_within(place.clone(), self.met, "nodes, with those within")?;
        self.met += 1;
        let node = self.data.get(&root.nodes, index, "node")?;
        let file = source.name.to_owned();
        if self.open.contains(&index) {
            return Err(ReadError::Loop { file, place, what: "node", name: index.to_string() });
        }
        if self.open.len() == MAX_DEPTH {
            return Err(ReadError::TooDeep { file, place, what: "nodes in nodes are", limit: MAX_DEPTH });
        }
        if let Some(seen) = self.seen.get_mut(index) {
            *seen = true;
        }
        let map = map * own_map(node);
        if let Some(mesh) = node.mesh {
            let has = [node.skin.is_some(), node.extensions.copies.is_some()];
            let more = has.into_iter().filter(|has| *has).count();
            self.drawing.notes.add(NoteKind::ElementsIgnored, more);
            for primitive in &self.data.get(&root.meshes, mesh, "mesh")?.primitives {
                source.room_within(place.clone(), self.met, "nodes and primitives, with those within")?;
                self.met += 1;
                self.primitive(primitive, &map, &Location::Item("mesh", mesh))?;
            }
        }
        self.open.push(index);
        node.children.iter().try_for_each(|&child| self.node(child, &map))?;
        self.open.pop();
        Ok(())
    }

    fn primitive(
        &mut self,
        primitive: &Primitive,
        map: &Affine3<f64>,
        place: &Location,
    ) -> Result<(), ReadError> {
        let source = self.data.source;
        let Some(&positions) = primitive.attributes.get("POSITION") else {
            // Nothing to draw, says the format.
            self.drawing.notes.add(NoteKind::ElementsIgnored, 1);
            return Ok(());
        };
        let count = self.data.count(positions)?;
        source.room(place.clone(), self.drawing.points.len().saturating_add(count), "vertices")?;
        let points = self.data.points(positions)?;
        let order = match primitive.indices {
            Some(indices) => {
                let more = self.data.count(indices)?;
                self.corners = self.corners.saturating_add(more);
                source.room(place.clone(), self.corners, "corners of faces")?;
                self.data.indices(indices, points.len())?
            }
            None => (0..).take(points.len()).collect(),
        };
        self.ignored(primitive, points.len());
        let first = u32::try_from(self.drawing.points.len()).unwrap_or(u32::MAX);
        self.drawing.points.extend(points.iter().map(|point| map * point));
        let order: Vec<u32> = order.into_iter().map(|index| first + index).collect();
        let mirrored = map.matrix().fixed_view::<3, 3>(0, 0).determinant() < 0.0;
        self.shapes(primitive.mode.unwrap_or(4), &order, mirrored, place)
    }

    /// What the corners are in order of, by the format's codes.
    fn shapes(
        &mut self,
        mode: u32,
        order: &[u32],
        mirrored: bool,
        place: &Location,
    ) -> Result<(), ReadError> {
        let edges = &mut self.drawing.edges;
        let left_over = match mode {
            0 => {
                self.drawing.notes.add(NoteKind::PointsIgnored, order.len());
                return Ok(());
            }
            1 => {
                edges.extend(order.chunks_exact(2).map(|pair| (pair[0], pair[1])));
                order.len() % 2
            }
            2 | 3 => {
                edges.extend(order.windows(2).map(|pair| (pair[0], pair[1])));
                if let (2, [begin, .., end]) = (mode, order) {
                    edges.push((*end, *begin));
                }
                usize::from(order.len() == 1)
            }
            4 => {
                let corners = order.chunks_exact(3).map(|three| [three[0], three[1], three[2]]);
                self.faces(corners, mirrored);
                order.len() % 3
            }
            5 => {
                // Every other triangle of a strip is turned over.
                let corners = order.windows(3).enumerate();
                let corners = corners.map(|(k, three)| [three[0], three[1 + k % 2], three[2 - k % 2]]);
                self.faces(corners, mirrored);
                0
            }
            6 => {
                let hub = order.first().copied().unwrap_or_default();
                let corners = order.get(1..).unwrap_or_default().windows(2).map(|two| [hub, two[0], two[1]]);
                self.faces(corners, mirrored);
                0
            }
            _ => {
                let found = mode.to_string();
                let expected = "a mode from 0 to 6";
                return Err(self.data.source.syntax(
                    place.clone(),
                    &found,
                    expected,
                    ErrorRemedy::ExportAgain,
                ));
            }
        };
        self.drawing.notes.add(NoteKind::StatementsIgnored, left_over);
        Ok(())
    }

    /// Strips hold triangles without area where they turn a corner.
    fn faces(&mut self, corners: impl Iterator<Item = [u32; 3]>, mirrored: bool) {
        for [a, b, c] in corners {
            if a == b || b == c || c == a {
                self.drawing.notes.add(NoteKind::FacesCollapsed, 1);
            } else {
                self.drawing.faces.push(if mirrored { vec![a, c, b] } else { vec![a, b, c] });
            }
        }
    }

    fn ignored(&mut self, primitive: &Primitive, count: usize) {
        for name in primitive.attributes.keys().filter(|name| *name != "POSITION") {
            let kind = match name.as_str() {
                "NORMAL" => NoteKind::NormalsIgnored,
                name if name.starts_with("TEXCOORD") => NoteKind::TextureIgnored,
                _ => NoteKind::AttributesIgnored,
            };
            self.drawing.notes.add(kind, count);
        }
        self.drawing.notes.add(NoteKind::ElementsIgnored, primitive.targets.len());
    }
}

/// From a node to the one that holds it: its matrix, or translation, rotation and scale.
fn own_map(node: &Node) -> Affine3<f64> {
    if let Some(columns) = node.matrix {
        // The last row says nothing of a map that keeps parallels.
        let mut matrix = Matrix4::from_column_slice(&columns);
        matrix.set_row(3, &nalgebra::RowVector4::new(0.0, 0.0, 0.0, 1.0));
        return Affine3::from_matrix_unchecked(matrix);
    }
    let [x, y, z, w] = node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]);
    let turn = UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z)).to_homogeneous();
    let scale = Matrix4::new_nonuniform_scaling(&Vector3::from(node.scale.unwrap_or([1.0; 3])));
    let shift = Matrix4::new_translation(&Vector3::from(node.translation.unwrap_or_default()));
    Affine3::from_matrix_unchecked(shift * turn * scale)
}
