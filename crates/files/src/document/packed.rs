//! A mesh inside a document, packed.

use std::io::{Read, Write};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::read::DeflateDecoder;
use flate2::write::DeflateEncoder;
use nalgebra::Point3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::mesh::Stencil;

use super::error::DocumentError;
use crate::limit::LIMIT;

/// A mesh: little-endian numbers, deflated (RFC 1951), in base64.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "PackedStencil")]
pub(crate) struct Packed {
    /// What it is called, where the document has no other place for it.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub(crate) name: String,
    /// How many vertices there are.
    #[schemars(range(max = 5_000_000))]
    vertices: usize,
    /// How many faces there are.
    #[schemars(range(max = 5_000_000))]
    faces: usize,
    /// How many corners the faces have together.
    #[schemars(range(max = 40_000_000))]
    corners: usize,
    /// x, y and z of each vertex in mm, 64-bit floats.
    positions: String,
    /// Of each face the number of its corners, then their vertices, 32-bit whole numbers.
    indices: String,
}

impl Packed {
    pub(crate) fn pack(stencil: &Stencil) -> Result<Self, DocumentError> {
        let positions = stencil.vertices().iter().flat_map(|p| [p.x, p.y, p.z]).flat_map(f64::to_le_bytes);
        let indices = stencil.faces().iter().flat_map(|face| {
            let count = u32::try_from(face.len()).unwrap_or(u32::MAX);
            std::iter::once(count).chain(face.iter().copied()).flat_map(u32::to_le_bytes)
        });
        Ok(Self {
            name: String::new(),
            vertices: stencil.vertices().len(),
            faces: stencil.faces().len(),
            corners: stencil.faces().iter().map(Vec::len).sum(),
            positions: deflate(&positions.collect::<Vec<u8>>())?,
            indices: deflate(&indices.collect::<Vec<u8>>())?,
        })
    }

    pub(crate) fn unpack(self, file: &str) -> Result<Stencil, DocumentError> {
        let damaged = |message: String| DocumentError::StencilDamaged { file: file.to_owned(), message };
        if self.vertices > LIMIT || self.faces > LIMIT || self.corners > 8 * LIMIT {
            return Err(damaged(format!("it announces more than {LIMIT} vertices or faces")));
        }
        let positions = inflate(&self.positions, self.vertices * 24).map_err(damaged)?;
        let (numbers, _) = positions.as_chunks::<8>();
        let numbers: Vec<f64> = numbers.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect();
        let vertices = numbers.as_chunks::<3>().0.iter().map(|&xyz| Point3::from(xyz)).collect();

        let indices = inflate(&self.indices, (self.faces + self.corners) * 4).map_err(damaged)?;
        let mut numbers = indices.as_chunks::<4>().0.iter().map(|bytes| u32::from_le_bytes(*bytes));
        let mut faces = Vec::new();
        while let Some(count) = numbers.next() {
            let face: Vec<u32> = numbers.by_ref().take(count as usize).collect();
            if face.len() != count as usize {
                return Err(damaged(format!("face {} has {} of {count} corners", faces.len(), face.len())));
            }
            faces.push(face);
        }
        if faces.len() != self.faces {
            return Err(damaged(format!("it has {} of {} faces", faces.len(), self.faces)));
        }
        Stencil::new(vertices, faces).map_err(|error| DocumentError::Stencil { file: file.to_owned(), error })
    }
}

fn deflate(bytes: &[u8]) -> Result<String, DocumentError> {
    let write = |error| DocumentError::Write(serde_json::Error::io(error));
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes).map_err(write)?;
    Ok(STANDARD.encode(encoder.finish().map_err(write)?))
}

/// Exactly `expected` bytes, or what is wrong. No more than one byte beyond them is ever unpacked.
fn inflate(text: &str, expected: usize) -> Result<Vec<u8>, String> {
    let packed = STANDARD.decode(text).map_err(|error| error.to_string())?;
    let mut bytes = Vec::new();
    let limit = expected as u64 + 1;
    DeflateDecoder::new(packed.as_slice())
        .take(limit)
        .read_to_end(&mut bytes)
        .map_err(|error| error.to_string())?;
    if bytes.len() == expected {
        return Ok(bytes);
    }
    if bytes.len() > expected {
        return Err(format!("it has more than the {expected} bytes that it announces"));
    }
    Err(format!("it has {} of the {expected} bytes that it announces", bytes.len()))
}
