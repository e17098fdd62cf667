//! Stencils as a window draws them: bytes, since numbers as text take ten times as long.

use wirebend_files::document::{StencilId, StencilSource};

use super::Workspace;

impl Workspace {
    /// The surface of a stencil as triangles, in its own frame, little-endian: the number of its corners and of its triangles (32-bit whole numbers),
    /// x, y and z of each corner in mm (32-bit floats), three corners of each triangle (32-bit whole numbers). Of none,
    /// no bytes. A face with more corners is fanned out from its first.
    #[must_use]
    pub fn stencil_mesh(&self, stencil: u32) -> Vec<u8> {
        let open = self.open();
        let surface = open.document().surfaces.get(&StencilId(stencil)).and_then(StencilSource::embedded);
        let Some(stencil) = surface.cloned() else { return Vec::new() };
        drop(open);
        let corners = stencil.vertices();
        let triangles: usize = stencil.faces().iter().map(|face| face.len().saturating_sub(2)).sum();
        let mut bytes = Vec::with_capacity(8 + corners.len() * 12 + triangles * 12);
        for count in [corners.len(), triangles] {
            bytes.extend(u32::try_from(count).unwrap_or(u32::MAX).to_le_bytes());
        }
        #[allow(
            clippy::cast_possible_truncation,
            reason = "a screen shows no more than 32 bits of a coordinate"
        )]
        let single = |mm: f64| (mm as f32).to_le_bytes();
        for corner in corners {
            bytes.extend([corner.x, corner.y, corner.z].into_iter().flat_map(single));
        }
        for face in stencil.faces() {
            let Some((first, rest)) = face.split_first() else { continue };
            for pair in rest.windows(2) {
                bytes.extend([*first, pair[0], pair[1]].into_iter().flat_map(u32::to_le_bytes));
            }
        }
        bytes
    }
}
