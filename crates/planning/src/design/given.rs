//! What was given to read a design by, beside the file.

use std::path::PathBuf;

use wirebend_error::InputName;
use wirebend_files::read::Format;

use super::DesignInput;

impl DesignInput {
    /// Whether no option asks to read other than as the file says.
    pub fn reads_plainly(&self) -> bool {
        let plain = Self::file(PathBuf::new());
        *self == Self { input: self.input.clone(), format: self.format, ..plain }
    }

    /// What was given to read other than as the file says.
    pub fn read_otherwise(&self) -> Vec<InputName> {
        use InputName::{
            CentrelineRadius, FaceEdges, Handedness, Layers, Program, Scale, ShortestEdge, Tolerance, Units,
            Weld,
        };
        let plain = Self::file(PathBuf::new());
        #[allow(clippy::float_cmp, reason = "a number that was not given is the very same one")]
        let given = [
            (Scale, self.scale != plain.scale),
            (Units, self.units != plain.units),
            (Weld, self.weld_mm != plain.weld_mm),
            (FaceEdges, self.face_edges != plain.face_edges),
            (CentrelineRadius, self.clr_mm != plain.clr_mm),
            (Tolerance, self.tolerance_mm != plain.tolerance_mm),
            (ShortestEdge, self.shortest_edge != plain.shortest_edge),
            (Layers, self.layers != plain.layers),
            (Handedness, self.handedness != plain.handedness),
            (Program, self.program != plain.program),
        ];
        given.into_iter().filter_map(|(input, given)| given.then_some(input)).collect()
    }

    /// What was given that says nothing of a file of this format. Of a project nothing of it does, and its error says more.
    pub(super) fn without_effect(&self, format: Format) -> Vec<InputName> {
        let says = |input: &InputName| match input {
            InputName::CentrelineRadius | InputName::Handedness => format == Format::Lra,
            InputName::Program => {
                matches!(format, Format::Kit | Format::Pensa | Format::Lra | Format::Moves)
            }
            InputName::Tolerance | InputName::ShortestEdge => matches!(format, Format::Dxf | Format::Svg),
            InputName::FaceEdges => {
                use Format::{Dxf, Gltf, Obj, Ply, Stl, ThreeMf};
                matches!(format, Obj | Stl | Ply | ThreeMf | Gltf | Dxf)
            }
            _ => true,
        };
        if format == Format::Wirebend {
            return Vec::new();
        }
        self.read_otherwise().into_iter().filter(|input| !says(input)).collect()
    }
}
