//! Which format is written, and by whom.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_driver_host::Driver;
use wirebend_driver_host::api::{Content, FormatDescription};

use crate::machine::Setup;
use crate::{Installation, PlanningError};

/// A format that the program writes without a driver.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ExportFormat {
    /// Picture.
    Svg,
    /// Picture in pixels.
    Png,
    /// Centreline of the bent wire.
    Obj,
    /// The bent wire as a surface.
    ObjTube,
    /// The same for programs that draw and animate.
    Gltf,
    /// Template at 1:1 for a browser or a cutter.
    TemplateSvg,
    /// Template at 1:1 for CAD.
    TemplateDxf,
    /// Template at 1:1 on pages to print.
    TemplatePdf,
    /// What a person takes to the machine.
    JobSheet,
}

impl ExportFormat {
    pub const ALL: [Self; 9] = [
        Self::Svg,
        Self::Png,
        Self::Obj,
        Self::ObjTube,
        Self::Gltf,
        Self::TemplateSvg,
        Self::TemplateDxf,
        Self::TemplatePdf,
        Self::JobSheet,
    ];

    /// The name in profiles and on the command line.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Png => "png",
            Self::Obj => "obj",
            Self::ObjTube => "obj-tube",
            Self::Gltf => "gltf",
            Self::TemplateSvg => "template-svg",
            Self::TemplateDxf => "template-dxf",
            Self::TemplatePdf => "template-pdf",
            Self::JobSheet => "job-sheet",
        }
    }

    /// The name for people.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Svg => "Picture (SVG)",
            Self::Png => "Picture (PNG)",
            Self::Obj => "Bent wire, centreline (OBJ)",
            Self::ObjTube => "Bent wire, surface (OBJ)",
            Self::Gltf => "Bent wire, surface (glTF)",
            Self::TemplateSvg => "Template at 1:1 (SVG)",
            Self::TemplateDxf => "Template at 1:1 (DXF)",
            Self::TemplatePdf => "Template at 1:1 on pages (PDF)",
            Self::JobSheet => "Job sheet (PDF)",
        }
    }

    /// The JSON Schema of what can be set; `None` where nothing can.
    #[must_use]
    pub fn settings_schema(self) -> Option<serde_json::Value> {
        let paper = serde_json::json!({
            "type": "string", "title": "Paper", "enum": ["a4", "letter"], "default": "a4",
        });
        let date = serde_json::json!({
            "type": "string", "title": "Date", "description": "On the sheet; absent: today's.",
        });
        let units = serde_json::json!({
            "type": "string", "title": "Units", "enum": ["mm", "in"], "default": "mm",
            "description": "Of the lengths that a person reads. What the machine is sent stays in mm.",
        });
        let properties = match self {
            Self::TemplateSvg | Self::TemplateDxf => serde_json::json!({ "units": units }),
            Self::TemplatePdf => serde_json::json!({ "paper": paper, "units": units }),
            Self::JobSheet => serde_json::json!({ "paper": paper, "units": units, "date": date }),
            _ => return None,
        };
        Some(serde_json::json!({ "type": "object", "properties": properties }))
    }

    /// How the names of its files end.
    #[must_use]
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Svg | Self::TemplateSvg => "svg",
            Self::Png => "png",
            Self::Obj | Self::ObjTube => "obj",
            Self::Gltf => "glb",
            Self::TemplateDxf => "dxf",
            Self::TemplatePdf | Self::JobSheet => "pdf",
        }
    }

    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.id() == id)
    }
}

/// A format with the driver that writes it.
pub(super) enum Chosen {
    BuiltIn(ExportFormat),
    Driver(Box<Driver>, FormatDescription),
}

impl Chosen {
    /// The wanted format; absent, the machine's own, or the first that its profile lists.
    pub fn new(app: &Installation, wanted: Option<&str>, setup: &Setup) -> Result<Self, PlanningError> {
        let export = &setup.machine.profile.export;
        let first = export.formats.as_deref().and_then(|formats| formats.first());
        let id = wanted.or(export.native.as_deref()).or(first.map(String::as_str)).unwrap_or_default();
        if let Some(format) = ExportFormat::from_id(id) {
            return Ok(Self::BuiltIn(format));
        }
        let (driver, format) = app.driver_of_format(id, setup)?;
        Ok(Self::Driver(Box::new(driver), format))
    }

    pub fn id(&self) -> &str {
        match self {
            Self::BuiltIn(format) => format.id(),
            Self::Driver(_, format) => &format.id,
        }
    }

    pub fn driver_id(&self) -> Option<&str> {
        match self {
            Self::BuiltIn(_) => None,
            Self::Driver(driver, _) => Some(&driver.description().id),
        }
    }

    /// How the names of its files end, the usual one first.
    pub fn extensions(&self) -> Vec<&str> {
        match self {
            Self::BuiltIn(format) => vec![format.extension()],
            Self::Driver(_, format) => format.extensions.iter().map(String::as_str).collect(),
        }
    }

    /// Whether a machine runs it: then it is not written for a design that cannot be made.
    pub fn is_program(&self) -> bool {
        match self {
            Self::BuiltIn(_) => false,
            Self::Driver(_, format) => format.program,
        }
    }

    /// Whether it is compensated, and so for one machine alone. What is of the design itself, in
    /// canonical signs, is for machines that compensate on their own.
    pub fn is_own(&self) -> bool {
        match self {
            Self::BuiltIn(_) => false,
            Self::Driver(_, format) => format.content == Content::Machine,
        }
    }

    /// Whether a driver writes it of the design: walk, lengths and angles, and nothing of how a machine runs it.
    pub fn is_of_design(&self) -> bool {
        match self {
            Self::BuiltIn(_) => false,
            Self::Driver(_, format) => format.content == Content::Design,
        }
    }

    /// Refuses the program of another machine: it would be in that machine's format with this one's
    /// angles.
    pub fn require_for(&self, setup: &Setup) -> Result<(), PlanningError> {
        let export = &setup.machine.profile.export;
        let known: Vec<String> =
            export.native.iter().chain(export.formats.iter().flatten()).cloned().collect();
        if !self.is_own() || known.iter().any(|id| id == self.id()) {
            return Ok(());
        }
        Err(PlanningError::FormatOfAnother {
            format: self.id().to_owned(),
            machine: setup.machine_id().to_owned(),
            known,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Output;
    use crate::misnamed::FileKind;

    /// A program under the name of a picture or a model is taken for one.
    #[test]
    fn no_program_has_the_name_of_what_is_written_without_a_driver() {
        let program = FileKind { called: "'gcode'", endings: &["nc"] };
        for format in ExportFormat::ALL {
            let output = Output { path: format!("a.{}", format.extension()).into(), force: false };
            assert!(program.misnamed_program(Some(&output)).is_some(), "{}", format.id());
        }
    }
}
