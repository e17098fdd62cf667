//! Templates at 1:1.

use wirebend_core::units::{DisplayUnit, Length};
use wirebend_files::write::{Drawing, Template, template, template_dxf, template_pdf, template_svg};

use super::content::{Content, Wire};
use super::print::{Print, letters_replaced};
use super::{ExportFormat, bends_tightened, chord};
use crate::PlanningError;

/// A template as SVG, DXF or PDF.
pub(super) fn encode(
    content: &mut Content,
    format: ExportFormat,
    print: &Print,
) -> Result<Vec<u8>, PlanningError> {
    let drawing = drawing(content, print.unit);
    content.notes.extend(bends_tightened(drawing.tightened));
    match format {
        ExportFormat::TemplatePdf => {
            let pdf = template_pdf(&drawing, print.paper).map_err(|error| PlanningError::Unwritable {
                wire: 0,
                format: format.id(),
                reason: error.to_string(),
            })?;
            content.notes.extend(letters_replaced(&pdf.missing));
            Ok(pdf.bytes)
        }
        ExportFormat::TemplateDxf => Ok(template_dxf(&drawing).into_bytes()),
        _ => Ok(template_svg(&drawing).into_bytes()),
    }
}

fn drawing(content: &Content, unit: DisplayUnit) -> Drawing {
    let model = &content.setup.model;
    let diameter = model.wire.diameter;
    template(&Template {
        title: content.title.clone(),
        wires: content.wires.iter().map(|wire| wire.path.clone()).collect(),
        diameter,
        radius: model.bend_radius,
        flat: lies_flat(diameter),
        straight: model.straight,
        chord: chord(diameter),
        steps: content.wires.iter().map(Wire::labels).collect(),
        unit,
    })
}

/// On a table a wire that stands up by a tenth of its diameter lies flat.
pub(super) fn lies_flat(diameter: Length) -> Length {
    Length::from_mm(diameter.mm() / 10.0).unwrap_or_default()
}
