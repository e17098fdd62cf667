//! A look into a file before it is opened: what it is, and how large in which unit.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::mesh::{Placement, Stencil};
use wirebend_files::read::Format;

use super::Workspace;
use crate::{ApiError, DesignInput, Progress};
use wirebend_planning::curves::{CurvesReport, MachineEdges, bend_count};
use wirebend_planning::job::{is_job, open_job};
use wirebend_planning::machine::Setup;
use wirebend_planning::report::NoteReport;

/// What to look into.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct LookRequest {
    /// The file and how it would be read.
    pub design: DesignInput,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Seen {
    /// A document of this program, taken as it is.
    Document,
    /// Lines to bend.
    Wireframe,
    /// A surface to trace on.
    Stencil,
    /// A surface, and lines.
    Both,
    /// A job, which is run and not edited.
    Job,
    /// Recorded moves, which are replayed, or become a design.
    Moves,
}

#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct LookResponse {
    pub name: String,
    pub format: String,
    pub seen: Seen,
    /// Whether the machine of the open design runs it as it stands: a program of its own format.
    pub runs: bool,
    /// Whether units and scale are open: the format does not say them.
    pub asks_units: bool,
    /// Its size in x, y and z as it would be read, mm; null where there is nothing.
    pub size_mm: Option<[f64; 3]>,
    /// Vertices of its lines.
    pub vertices: usize,
    /// Its lines.
    pub edges: usize,
    /// Faces of its surface.
    pub faces: usize,
    /// Of its lines, vertices with two edges that the machine of the open design bends; all corners without one.
    pub bends: usize,
    /// The layers of a drawing, hidden ones included.
    pub layers: Vec<String>,
    /// The name of the machine of the open design; null without one.
    pub machine: Option<String>,
    /// What edges it can make.
    pub machine_edges: Option<MachineEdges>,
    /// What would become of the curves of a drawing; null unless the edges have a least length.
    pub curves: Option<CurvesReport>,
    /// What would be merged, ignored or assumed.
    pub notes: Vec<NoteReport>,
}

impl Workspace {
    pub(crate) fn look(
        &self,
        asked: &LookRequest,
        progress: &dyn Progress,
    ) -> Result<LookResponse, ApiError> {
        let (name, bytes) = asked.design.input.load()?;
        if is_job(&name, &bytes) {
            // One that is damaged, or of another version, is reported as that.
            open_job(&name, &bytes)?;
            let none = LookResponse {
                name,
                format: "wbjob".to_owned(),
                seen: Seen::Job,
                runs: true,
                asks_units: false,
                size_mm: None,
                vertices: 0,
                edges: 0,
                faces: 0,
                bends: 0,
                layers: Vec::new(),
                machine: None,
                machine_edges: None,
                curves: None,
                notes: Vec::new(),
            };
            return Ok(none);
        }
        progress.stage("reading");
        let setup = self.machine_at_hand();
        let machine = setup.as_ref().map(|setup| &setup.model);
        let opened = asked.design.open_bytes(name, &bytes, machine)?;
        let document = &opened.document;
        // Most lie as in their file, and are looked at at every figure that is typed: these are not copied.
        let in_place = document.placed_stencils().filter_map(|(stencil, surface)| {
            let surface = surface.embedded()?;
            let lies_as_read = stencil.placement == Placement::default();
            let placed = || Arc::new(surface.placed(&stencil.placement));
            Some(if lies_as_read { Arc::clone(surface) } else { placed() })
        });
        let surfaces: Vec<Arc<Stencil>> = in_place.collect();
        let (lines, surface) = (document.wireframe.edge_count() > 0, !surfaces.is_empty());
        let points = document.wireframe.vertices().map(|(_, vertex)| vertex.position);
        let corners = surfaces.iter().flat_map(|surface| surface.vertices().iter().copied());
        let bounds = points.chain(corners).fold(None, |bounds: Option<[[f64; 3]; 2]>, point| {
            let at: [f64; 3] = point.coords.into();
            let [low, high] = bounds.unwrap_or([at, at]);
            let pick = |a: [f64; 3], of: fn(f64, f64) -> f64| [0, 1, 2].map(|k| of(a[k], at[k]));
            Some([pick(low, f64::min), pick(high, f64::max)])
        });
        Ok(LookResponse {
            format: opened.format.to_string(),
            runs: self.runs(opened.format),
            seen: match (opened.format, lines, surface) {
                (Format::Moves, ..) => Seen::Moves,
                (Format::Wirebend, ..) => Seen::Document,
                (_, true, true) => Seen::Both,
                (_, false, true) => Seen::Stencil,
                _ => Seen::Wireframe,
            },
            asks_units: asks_units(opened.format),
            size_mm: bounds.map(|[low, high]| [0, 1, 2].map(|k| high[k] - low[k])),
            vertices: document.wireframe.vertex_count(),
            edges: document.wireframe.edge_count(),
            faces: surfaces.iter().map(|surface| surface.faces().len()).sum(),
            bends: bend_count(&document.wireframe, machine.map_or(0.0, |machine| machine.straight.deg())),
            machine: setup.as_ref().map(|setup| setup.machine_name().to_owned()),
            machine_edges: machine.map(MachineEdges::of),
            curves: opened.curves,
            layers: opened.layers,
            notes: opened.notes,
            name: opened.name,
        })
    }
}

impl Workspace {
    /// The machine of the open design, with its wire; none where its profile cannot be had, since a file can be looked
    /// into without one.
    fn machine_at_hand(&self) -> Option<Setup> {
        let state = self.open().state();
        self.installation().setup(&state.machine?, state.material.as_deref()).ok()
    }

    /// Whether a format is that of programs of the open design's machine.
    fn runs(&self, format: Format) -> bool {
        let machine = self.open().state().machine;
        let profile = machine.and_then(|machine| self.installation().library.machine(&machine).ok());
        let own = profile.and_then(|machine| machine.profile.export.native);
        format.written_as().is_some_and(|id| own.as_deref() == Some(id))
    }
}

/// Meshes and bare coordinates do not say their unit; drawings, documents, programs, 3MF and glTF do.
const fn asks_units(format: Format) -> bool {
    matches!(format, Format::Obj | Format::Stl | Format::Ply | Format::Xyz)
}
