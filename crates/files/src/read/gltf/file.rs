//! What a glTF file is made of: JSON, and bytes within it or behind it.

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use serde::Deserialize;
use wirebend_error::ErrorRemedy;

use super::super::error::{Location, ReadError};
use super::super::text::{Source, utf8};

const DAMAGED: ErrorRemedy = ErrorRemedy::ExportAgain;

/// The parts of the JSON that say where geometry is.
#[derive(Debug, Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Root {
    pub(super) asset: Asset,
    pub(super) extensions_required: Vec<String>,
    pub(super) scene: Option<usize>,
    pub(super) scenes: Vec<Scene>,
    pub(super) nodes: Vec<Node>,
    pub(super) meshes: Vec<Mesh>,
    pub(super) accessors: Vec<Accessor>,
    pub(super) buffer_views: Vec<View>,
    pub(super) buffers: Vec<Buffer>,
    pub(super) animations: Vec<serde::de::IgnoredAny>,
    pub(super) cameras: Vec<serde::de::IgnoredAny>,
    pub(super) images: Vec<serde::de::IgnoredAny>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Asset {
    pub(super) version: String,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Scene {
    pub(super) nodes: Vec<usize>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Node {
    pub(super) children: Vec<usize>,
    pub(super) mesh: Option<usize>,
    pub(super) skin: Option<usize>,
    pub(super) matrix: Option<[f64; 16]>,
    pub(super) translation: Option<[f64; 3]>,
    pub(super) rotation: Option<[f64; 4]>,
    pub(super) scale: Option<[f64; 3]>,
    pub(super) extensions: NodeExtensions,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct NodeExtensions {
    /// Copies of its mesh in other places.
    #[serde(rename = "EXT_mesh_gpu_instancing")]
    pub(super) copies: Option<serde::de::IgnoredAny>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Mesh {
    pub(super) primitives: Vec<Primitive>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Primitive {
    pub(super) attributes: std::collections::BTreeMap<String, usize>,
    pub(super) indices: Option<usize>,
    pub(super) mode: Option<u32>,
    /// Other shapes, into which it morphs.
    pub(super) targets: Vec<serde::de::IgnoredAny>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Accessor {
    pub(super) buffer_view: Option<usize>,
    #[serde(default)]
    pub(super) byte_offset: usize,
    pub(super) component_type: u32,
    #[serde(default)]
    pub(super) normalized: bool,
    pub(super) count: usize,
    #[serde(rename = "type")]
    pub(super) shape: String,
    pub(super) sparse: Option<Sparse>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Sparse {
    pub(super) count: usize,
    pub(super) indices: SparseView,
    pub(super) values: SparseView,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct SparseView {
    pub(super) buffer_view: usize,
    #[serde(default)]
    pub(super) byte_offset: usize,
    /// Of indices; values have the one of their accessor.
    pub(super) component_type: Option<u32>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct View {
    pub(super) buffer: usize,
    #[serde(default)]
    pub(super) byte_offset: usize,
    pub(super) byte_length: usize,
    pub(super) byte_stride: Option<usize>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Buffer {
    pub(super) uri: Option<String>,
}

/// The JSON, and the bytes behind it in a binary file.
pub(super) fn open<'a>(bytes: &'a [u8], source: Source<'_>) -> Result<(Root, Option<&'a [u8]>), ReadError> {
    let (json, binary) = if bytes.starts_with(b"glTF") { chunks(bytes, source)? } else { (bytes, None) };
    let root = serde_json::from_slice(&utf8(json)).map_err(|error| {
        source.refused(Location::Line(error.line()), &error, "a glTF object as JSON", DAMAGED)
    })?;
    Ok((root, binary))
}

fn word(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_le_bytes(bytes.get(at..at.checked_add(4)?)?.try_into().ok()?))
}

/// A head of 12 bytes, then chunks with a length and a kind each: JSON first, then perhaps bytes.
fn chunks<'a>(bytes: &'a [u8], source: Source<'_>) -> Result<(&'a [u8], Option<&'a [u8]>), ReadError> {
    let version = word(bytes, 4).unwrap_or_default();
    if bytes.len() >= 12 && version != 2 {
        let remedy = ErrorRemedy::ExportAs { form: "glTF 2.0".to_owned() };
        return Err(source.syntax(
            Location::Byte(4),
            &version.to_string(),
            "version 2 of binary glTF",
            remedy,
        ));
    }
    let (mut at, mut json, mut binary) = (12, None, None);
    while json.is_none() || at < bytes.len() {
        let (Some(length), Some(kind)) = (word(bytes, at), word(bytes, at + 4)) else {
            let announced = "a chunk has 8 bytes and what they announce".to_owned();
            let left = format!("there are {}", bytes.len().saturating_sub(at));
            return Err(source.truncated(Location::Byte(at.min(bytes.len())), announced, left));
        };
        let begin = at + 8;
        let end = begin.saturating_add(length as usize);
        let Some(chunk) = bytes.get(begin..end) else {
            let left = format!("there are {}", bytes.len() - begin);
            return Err(source.truncated(Location::Byte(at), format!("a chunk of {length} bytes"), left));
        };
        match (&kind.to_le_bytes(), json, binary) {
            (b"JSON", None, _) => json = Some(chunk),
            (b"BIN\0", Some(_), None) => binary = Some(chunk),
            (_, None, _) => {
                return Err(source.syntax(
                    Location::Byte(at),
                    "another chunk",
                    "JSON in the first chunk",
                    DAMAGED,
                ));
            }
            // Chunks of other kinds may be left out, says the format.
            _ => {}
        }
        at = end;
    }
    Ok((json.unwrap_or_default(), binary))
}

/// What the address of bytes begins with that are written into the JSON.
pub(super) const EMBEDDED: &str = "data:";

/// The bytes of a buffer that are written into the JSON, as they stand behind [`EMBEDDED`].
pub(super) fn embedded(data: &str, buffer: usize, source: Source<'_>) -> Result<Vec<u8>, ReadError> {
    let place = Location::Item("buffer", buffer);
    let decoded = data.split_once(";base64,").and_then(|(_, text)| BASE64_STANDARD.decode(text.trim()).ok());
    decoded.ok_or_else(|| source.syntax(place, data, "a data address with base64", DAMAGED))
}
