//! The stencils of a document: surfaces to trace on, packed into it or in files beside it, and how they lie.

use std::collections::BTreeMap;
use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::mesh::{Placement, PlacementError, Stencil};

use super::error::DocumentError;
use super::ids::StencilId;
use super::look::Look;
use super::packed::Packed;

/// A stencil but for its surface, which is `Document::surfaces` of its id.
#[derive(Debug, Clone, PartialEq)]
pub struct PlacedStencil {
    pub id: StencilId,
    pub look: Look,
    /// How it lies in the design.
    pub placement: Placement,
}

/// Where a document has the surface of a stencil.
#[derive(Debug, Clone)]
pub enum StencilSource {
    /// In the document itself.
    Embedded(Arc<Stencil>),
    /// In a file of its own.
    File {
        /// Its path, relative to the document.
        path: String,
        /// Its SHA-256 in hexadecimal, to see whether it has changed.
        sha256: String,
    },
}

/// A surface to trace on, and how it lies.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "PlacedStencil")]
pub(crate) struct StencilFile {
    /// No two stencils have the same.
    id: StencilId,
    #[serde(default, skip_serializing_if = "is_plain")]
    look: Look,
    /// How it lies in the design; absent where it lies as in its file.
    #[serde(default, skip_serializing_if = "PlacementFile::is_default")]
    placement: PlacementFile,
    surface: SurfaceFile,
}

/// How a stencil lies in the design. It is scaled and turned about the middle of its box, and that is moved.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Placement")]
pub struct PlacementFile {
    /// How far it is moved along x, y and z, mm.
    #[serde(default)]
    pub shift_mm: [f64; 3],
    /// How far it is turned about the x axis, then about the y axis, then about the z axis of the design, degrees.
    #[serde(default)]
    pub turn_deg: [f64; 3],
    /// How much larger than in its file it is.
    #[serde(default = "one")]
    pub scale: f64,
}

#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(rename = "Stencil")]
pub(crate) enum SurfaceFile {
    /// In this document.
    Embedded(Packed),
    /// In another file.
    File(Reference),
}

/// A file beside the document.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "StencilReference")]
pub(crate) struct Reference {
    /// Its path, relative to the document.
    path: String,
    /// Its SHA-256.
    #[schemars(regex(pattern = "^[0-9a-f]{64}$"))]
    sha256: String,
}

const fn one() -> f64 {
    1.0
}

fn is_plain(look: &Look) -> bool {
    *look == Look::default()
}

impl PlacedStencil {
    /// A stencil that lies as in its file.
    #[must_use]
    pub fn new(id: StencilId, name: String) -> Self {
        let look = Look { name, ..Look::default() }.with_tidy_name();
        Self { id, look, placement: Placement::default() }
    }

    /// What it is called; what is in a file and has no name is called after that.
    #[must_use]
    pub fn name<'a>(&'a self, surface: &'a StencilSource) -> &'a str {
        match surface {
            StencilSource::File { path, .. } if self.look.name.is_empty() => path,
            _ => &self.look.name,
        }
    }
}

impl PartialEq for StencilSource {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            // Copies of a document share the surface, which is large.
            (Self::Embedded(one), Self::Embedded(other)) => Arc::ptr_eq(one, other) || one == other,
            (Self::File { path, sha256 }, Self::File { path: other_path, sha256: other_sha256 }) => {
                (path, sha256) == (other_path, other_sha256)
            }
            _ => false,
        }
    }
}

impl StencilSource {
    /// The surface, where it is in the document itself.
    #[must_use]
    pub fn embedded(&self) -> Option<&Arc<Stencil>> {
        match self {
            Self::Embedded(surface) => Some(surface),
            Self::File { .. } => None,
        }
    }
}

impl Default for PlacementFile {
    fn default() -> Self {
        Self { shift_mm: [0.0; 3], turn_deg: [0.0; 3], scale: 1.0 }
    }
}

impl PlacementFile {
    #[allow(clippy::trivially_copy_pass_by_ref, reason = "as serde asks")]
    fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

impl TryFrom<PlacementFile> for Placement {
    type Error = PlacementError;

    fn try_from(file: PlacementFile) -> Result<Self, PlacementError> {
        Self::new(file.shift_mm, file.turn_deg, file.scale)
    }
}

impl From<&Placement> for PlacementFile {
    fn from(placement: &Placement) -> Self {
        Self { shift_mm: placement.shift_mm(), turn_deg: placement.turn_deg(), scale: placement.scale() }
    }
}

impl StencilFile {
    pub(crate) fn pack(stencil: &PlacedStencil, surface: &StencilSource) -> Result<Self, DocumentError> {
        Ok(Self {
            id: stencil.id,
            look: stencil.look.clone(),
            placement: (&stencil.placement).into(),
            surface: SurfaceFile::pack(surface)?,
        })
    }

    fn unpack(self, file: &str) -> Result<(PlacedStencil, StencilSource), DocumentError> {
        let (id, look) = (self.id, self.look);
        let placement = self.placement.try_into();
        let placement = placement.map_err(|error| DocumentError::StencilPlacement {
            file: file.to_owned(),
            stencil: id,
            error,
        })?;
        Ok((PlacedStencil { id, look, placement }, self.surface.unpack(file)?))
    }

    /// The id of the only stencil of a document that has no list of them.
    pub(crate) const ONLY: StencilId = StencilId(0);

    fn only(surface: SurfaceFile) -> Self {
        let (id, look, placement) = Self::lie_of_only(&surface);
        Self { id, look, placement, surface }
    }

    /// The same without its surface.
    pub(crate) fn lie_of_only(surface: &SurfaceFile) -> (StencilId, Look, PlacementFile) {
        let name = match surface {
            SurfaceFile::Embedded(packed) => packed.name.clone(),
            SurfaceFile::File(_) => String::new(),
        };
        (Self::ONLY, Look { name, ..Look::default() }, PlacementFile::default())
    }
}

impl SurfaceFile {
    pub(crate) fn pack(source: &StencilSource) -> Result<Self, DocumentError> {
        Ok(match source {
            StencilSource::Embedded(surface) => Self::Embedded(Packed::pack(surface)?),
            StencilSource::File { path, sha256 } => {
                Self::File(Reference { path: path.clone(), sha256: sha256.clone() })
            }
        })
    }

    pub(crate) fn unpack(self, file: &str) -> Result<StencilSource, DocumentError> {
        Ok(match self {
            Self::File(Reference { path, sha256 }) => StencilSource::File { path, sha256 },
            Self::Embedded(packed) => StencilSource::Embedded(Arc::new(packed.unpack(file)?)),
        })
    }
}

/// The stencils of a file, which may have only one, and not in its list.
pub(crate) fn unpacked(
    mut list: Vec<StencilFile>,
    only: Option<SurfaceFile>,
    file: &str,
) -> Result<(Vec<PlacedStencil>, BTreeMap<StencilId, StencilSource>), DocumentError> {
    let (mut stencils, mut surfaces) = (Vec::new(), BTreeMap::new());
    if let Some(only) = only {
        if !list.is_empty() {
            return Err(DocumentError::TwoStencilKeys { file: file.to_owned() });
        }
        list.push(StencilFile::only(only));
    }
    for stencil in list {
        let (stencil, surface) = stencil.unpack(file)?;
        let id = stencil.id;
        stencils.push(stencil);
        if surfaces.insert(id, surface).is_some() {
            return Err(DocumentError::SameStencil { file: file.to_owned(), stencil: id });
        }
    }
    Ok((stencils, surfaces))
}
