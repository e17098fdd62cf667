//! How a joint is written.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::wireframe::{Joint, JointKind};

/// What holds struts together at a vertex.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Joint")]
pub struct JointFile {
    pub kind: JointKindFile,
    /// What it weighs, in g.
    #[schemars(range(min = 0.0, max = 1_000_000.0))]
    pub mass_g: f64,
}

/// How struts are held together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(rename = "JointKind")]
pub enum JointKindFile {
    /// A printed part that the struts snap into.
    SnapFit,
    Solder,
    ZipTie,
}

impl From<Joint> for JointFile {
    fn from(joint: Joint) -> Self {
        let kind = match joint.kind {
            JointKind::SnapFit => JointKindFile::SnapFit,
            JointKind::Solder => JointKindFile::Solder,
            JointKind::ZipTie => JointKindFile::ZipTie,
        };
        Self { kind, mass_g: joint.mass_g }
    }
}

impl From<JointFile> for Joint {
    fn from(joint: JointFile) -> Self {
        let kind = match joint.kind {
            JointKindFile::SnapFit => JointKind::SnapFit,
            JointKindFile::Solder => JointKind::Solder,
            JointKindFile::ZipTie => JointKind::ZipTie,
        };
        Self { kind, mass_g: joint.mass_g }
    }
}
