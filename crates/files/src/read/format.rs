//! The formats that can be read.

use std::fmt;
use std::str::FromStr;

/// A format that can be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Format {
    /// Wavefront OBJ: `l` lines are a wireframe, faces a stencil.
    Obj,
    /// STL, ASCII or binary: a stencil.
    Stl,
    /// PLY, ASCII or binary: faces are a stencil, edges a wireframe.
    Ply,
    /// 3MF: a stencil.
    ThreeMf,
    /// glTF, as text or binary (`.glb`): triangles are a stencil, lines a wireframe.
    Gltf,
    /// DXF, ASCII or binary: the lines and curves of a drawing.
    Dxf,
    /// SVG: the outlines of a drawing, in the plane z = 0.
    Svg,
    /// A table of points: one polyline.
    Xyz,
    /// Assembly-instances JSON: a frame with supports.
    Assembly,
    /// conmech JSON: a frame with supports, sections and materials.
    Conmech,
    /// `FrameFab` PWF: a frame with pillars.
    Pwf,
    /// WireBend-kit text: a program.
    Kit,
    /// Pensa D.I.Wire script: a program.
    Pensa,
    /// LRA/YBC table, or one of distances from the start: a program.
    Lra,
    /// Recorded moves (`.wbmoves`): a program.
    Moves,
    /// The project document `.wirebend`.
    Wirebend,
}

impl Format {
    pub const ALL: [Self; 16] = [
        Self::Obj,
        Self::Stl,
        Self::Ply,
        Self::ThreeMf,
        Self::Gltf,
        Self::Dxf,
        Self::Svg,
        Self::Xyz,
        Self::Assembly,
        Self::Conmech,
        Self::Pwf,
        Self::Kit,
        Self::Pensa,
        Self::Lra,
        Self::Moves,
        Self::Wirebend,
    ];

    /// The name by which it is chosen.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Obj => "obj",
            Self::Stl => "stl",
            Self::Ply => "ply",
            Self::ThreeMf => "3mf",
            Self::Gltf => "gltf",
            Self::Dxf => "dxf",
            Self::Svg => "svg",
            Self::Xyz => "xyz",
            Self::Assembly => "assembly",
            Self::Conmech => "conmech",
            Self::Pwf => "pwf",
            Self::Kit => "wirebend-kit",
            Self::Pensa => "pensa",
            Self::Lra => "lra",
            Self::Moves => "moves",
            Self::Wirebend => "wirebend",
        }
    }

    /// What it is, in a few words.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::Obj => "Wavefront OBJ",
            Self::Stl => "STL mesh",
            Self::Ply => "PLY mesh",
            Self::ThreeMf => "3MF model",
            Self::Gltf => "glTF model",
            Self::Dxf => "DXF drawing",
            Self::Svg => "SVG drawing",
            Self::Xyz => "XYZ point table",
            Self::Assembly => "assembly-instances JSON",
            Self::Conmech => "conmech JSON",
            Self::Pwf => "FrameFab PWF",
            Self::Kit => "WireBend-kit program",
            Self::Pensa => "Pensa D.I.Wire script",
            Self::Lra => "LRA/YBC table",
            Self::Moves => "recorded moves",
            Self::Wirebend => "WireBend project",
        }
    }

    /// File name extensions, the usual one first. Some belong to several formats.
    #[must_use]
    pub const fn extensions(self) -> &'static [&'static str] {
        match self {
            Self::Obj => &["obj"],
            Self::Stl => &["stl"],
            Self::Ply => &["ply"],
            Self::ThreeMf => &["3mf"],
            Self::Gltf => &["glb", "gltf"],
            Self::Dxf => &["dxf"],
            Self::Svg => &["svg"],
            Self::Xyz => &["xyz", "csv", "tsv", "txt"],
            Self::Assembly | Self::Conmech => &["json"],
            Self::Pwf => &["pwf"],
            Self::Kit => &["txt"],
            Self::Pensa => &["txt", "dsw", "diw"],
            Self::Lra => &["lra", "ybc", "csv", "tsv", "txt"],
            Self::Moves => &["wbmoves"],
            Self::Wirebend => &["wirebend"],
        }
    }
}

impl Format {
    /// The id of the format of drivers that writes the same, where that is the program of a machine.
    #[must_use]
    pub const fn written_as(self) -> Option<&'static str> {
        match self {
            Self::Kit => Some("wirebend-kit-text"),
            Self::Pensa => Some("pensa-script"),
            _ => None,
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A word that names no format.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("\"{0}\" is no format that can be read; they are {known}", known = known())]
pub struct UnknownName(String);

impl FromStr for Format {
    type Err = UnknownName;

    fn from_str(word: &str) -> Result<Self, UnknownName> {
        let found = Self::ALL.into_iter().find(|format| word.eq_ignore_ascii_case(format.name()));
        found.ok_or_else(|| UnknownName(word.to_owned()))
    }
}

/// The names of all formats, for messages.
pub(super) fn known() -> String {
    Format::ALL.map(Format::name).join(", ")
}
