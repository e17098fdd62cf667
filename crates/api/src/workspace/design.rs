//! The open design: opening, editing, checking, saving.

use std::path::{Path, PathBuf};
use wirebend_planning::PlanningError;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::wireframe::{Vertex, VertexId};
use wirebend_editor::{DesignState, PastedVertex};
use wirebend_error::ProblemReport;
use wirebend_files::document::{Document, DocumentError, JointFile};

use super::{RecentEntry, Workspace, empty};
use crate::{
    ApiError, DesignInput, DesignView, EditOutcome, EditRequest, Editor, Fix, FixAll, Input, LiveCheck,
    Moved, Progress, Unsaved, ViewChange,
};
use wirebend_planning::choices::PlanChoices;
use wirebend_planning::report::{DiagnosticCode, NoteReport};

/// What a window needs when it opens.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct Start {}

/// What there is when a window opens.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Started {
    /// The version of the program.
    pub version: String,
    /// The open design.
    pub design: DesignView,
    /// Designs that were open when the program or the computer stopped, last changed first.
    pub unsaved: Vec<Unsaved>,
    /// What was open before.
    pub recent: Vec<RecentEntry>,
    /// What a person should know at once, such as profiles of theirs that cannot be used.
    pub warnings: Vec<ProblemReport>,
}

/// Begins an empty design.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct NewDesign {
    /// Its machine; absent, that of the design before.
    pub machine: Option<String>,
}

/// Opens a file as the design: a wireframe, a drawing, a program, or a stencil to trace on.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct OpenDesign {
    /// The file and how to read it.
    pub design: DesignInput,
}

#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct OpenExample {
    pub id: String,
}

#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct DesignOpened {
    pub design: DesignView,
    /// What was merged, ignored or assumed while reading.
    pub notes: Vec<NoteReport>,
    /// What was open before.
    pub recent: Vec<RecentEntry>,
}

/// Puts the surface of a file into the design, to trace on.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct PutStencil {
    /// The file and how to read it.
    pub design: DesignInput,
}

/// Adds the wireframe of a file to the design, where it lies in the file.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct PutWireframe {
    /// The file and how to read it.
    pub design: DesignInput,
}

/// What a change made of the design.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct EditMade {
    /// What is to be drawn anew; null where there was nothing to undo or to redo.
    pub change: Option<ViewChange>,
    /// What was merged, ignored or assumed while reading.
    pub notes: Vec<NoteReport>,
}

/// Makes a change.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct EditDesign {
    pub request: EditRequest,
}

/// Asks what a fillet or a shape would make, without making it.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct OutcomeRequest {
    pub request: EditRequest,
}

#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct OutcomeResponse {
    /// Null of an edit that is neither a shape nor a fillet of corners.
    pub outcome: Option<EditOutcome>,
}

/// Undoes the last change.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct Undo {}

/// Does again what was undone last.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct Redo {}

/// Saves the design as a `.wirebend` document.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct SaveDesign {
    /// Where; absent, where it was opened or saved before.
    pub path: Option<PathBuf>,
}

/// Checks the design on its machine, with some vertices elsewhere than they are.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct CheckDesign {
    /// Vertices that are being dragged.
    #[serde(default)]
    pub moved: Vec<Moved>,
}

/// Asks what would fix what the checks say.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct FixesRequest {
    /// Of collisions, instead of all else: each fix is tried with a check for collisions, which takes longer.
    #[serde(default)]
    pub collisions: bool,
}

/// What would fix what the checks say.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct FixesResponse {
    /// In the order of the diagnostics, the best of each first.
    pub fixes: Vec<Fix>,
}

/// Asks what would fix all that the checks say of a kind, as one change. A search for the same kind that is under way is
/// stopped.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct FixAllRequest {
    /// The kind, by its code.
    pub code: String,
}

/// What would fix all of a kind.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct FixAllResponse {
    /// Null where fewer than two can be fixed, where that would leave more errors than there are, or where the search was
    /// stopped.
    pub all: Option<FixAll>,
}

/// Closes the design; what is not saved is gone. An empty one takes its place.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct CloseDesign {}

/// Restores a design that was open when the program or the computer stopped.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct RestoreUnsaved {
    pub journal: PathBuf,
}

/// Throws away a design that was open when the program or the computer stopped.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct DiscardUnsaved {
    pub journal: PathBuf,
}

/// Empties the list of what was open before.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ClearRecent {}

impl Workspace {
    pub(crate) fn start(&self, _: &Start, _: &dyn Progress) -> Result<Started, ApiError> {
        let (unsaved, mut warnings) =
            self.keep_in().map(|folder| Editor::unsaved(&folder)).unwrap_or_default();
        warnings.extend(self.installation().refused_profiles().iter().map(ProblemReport::from));
        Ok(Started {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            design: self.open().view(),
            unsaved,
            recent: self.recent(),
            warnings,
        })
    }

    pub(crate) fn new_design(&self, asked: &NewDesign, _: &dyn Progress) -> Result<DesignOpened, ApiError> {
        let editor = match &asked.machine {
            Some(machine) => Editor::new(&self.installation(), Some(machine), self.keep_in().as_deref())?,
            None => empty(&self.installation(), self.places(), self.open().state().machine)?,
        };
        self.replace(editor, Vec::new())
    }

    pub(crate) fn open_design(
        &self,
        asked: &OpenDesign,
        progress: &dyn Progress,
    ) -> Result<DesignOpened, ApiError> {
        let before = self.open().state();
        let machine = before.machine.as_deref().map(|machine| (machine, before.material.as_deref()));
        let (editor, notes) = Editor::open_for(
            &self.installation(),
            &asked.design,
            machine,
            None,
            self.keep_in().as_deref(),
            progress,
        )?;
        if let Input::File(path) = &asked.design.input {
            self.remember(path);
        }
        self.replace(editor, notes)
    }

    pub(crate) fn put_stencil(
        &self,
        asked: &PutStencil,
        progress: &dyn Progress,
    ) -> Result<EditMade, ApiError> {
        let (stencil, notes) = asked.design.stencil(progress)?;
        let change = self.open().put_stencil(stencil)?;
        Ok(EditMade { change: Some(change), notes })
    }

    pub(crate) fn put_wireframe(
        &self,
        asked: &PutWireframe,
        progress: &dyn Progress,
    ) -> Result<EditMade, ApiError> {
        let app = self.installation();
        let DesignState { machine, material, .. } = self.open().state();
        let choices = PlanChoices { machine, material, ..PlanChoices::default() };
        let opened = asked.design.open_with(&app, &choices, progress)?.with_wireframe()?;
        let wireframe = &opened.document.wireframe;
        let ids: Vec<VertexId> = wireframe.vertices().map(|(id, _)| id).collect();
        let vertex = |(_, vertex): (VertexId, Vertex)| PastedVertex {
            at_mm: vertex.position.coords.into(),
            support: vertex.support,
            joint: vertex.joint.map(JointFile::from),
        };
        // A vertex that is not there is refused by the edit.
        let place = |id| ids.binary_search(&id).unwrap_or(usize::MAX);
        let paste = EditRequest::Paste {
            vertices: wireframe.vertices().map(vertex).collect(),
            edges: wireframe.edges().map(|(_, edge)| [place(edge.a), place(edge.b)]).collect(),
        };
        let name = Path::new(&opened.name).file_name().map(|name| name.to_string_lossy().into_owned());
        let label = format!("add {}", name.unwrap_or(opened.name));
        let mut open = self.open();
        let [_, first] = open.state().next;
        let ceiling = (first..).zip(wireframe.edges()).filter(|(_, (_, edge))| edge.ceiling);
        let edges: Vec<u32> = ceiling.map(|(id, _)| id).collect();
        let ceiling = (!edges.is_empty()).then_some(EditRequest::Ceiling { edges, ceiling: true });
        let edits = std::iter::once(paste).chain(ceiling).collect();
        let change = open.edit(&app, &EditRequest::Several { label, edits })?;
        let mut notes = opened.notes;
        notes.extend(left_out(&opened.document));
        Ok(EditMade { change: Some(change), notes })
    }

    pub(crate) fn edit(&self, asked: &EditDesign, _: &dyn Progress) -> Result<EditMade, ApiError> {
        let change = self.open().edit(&self.installation(), &asked.request)?;
        if let EditRequest::Machine { machine, .. } = &asked.request {
            self.remember_machine(machine);
        }
        Ok(EditMade { change: Some(change), notes: Vec::new() })
    }

    pub(crate) fn outcome(
        &self,
        asked: &OutcomeRequest,
        _: &dyn Progress,
    ) -> Result<OutcomeResponse, ApiError> {
        Ok(OutcomeResponse { outcome: self.open().outcome(&self.installation(), &asked.request)? })
    }

    pub(crate) fn undo(&self, _: &Undo, _: &dyn Progress) -> Result<EditMade, ApiError> {
        Ok(EditMade { change: self.open().undo()?, notes: Vec::new() })
    }

    pub(crate) fn redo(&self, _: &Redo, _: &dyn Progress) -> Result<EditMade, ApiError> {
        Ok(EditMade { change: self.open().redo()?, notes: Vec::new() })
    }

    pub(crate) fn check(&self, asked: &CheckDesign, _: &dyn Progress) -> Result<LiveCheck, ApiError> {
        Ok(self.open().check(&self.installation(), &asked.moved)?)
    }

    pub(crate) fn fixes(&self, asked: &FixesRequest, _: &dyn Progress) -> Result<FixesResponse, ApiError> {
        let app = self.installation();
        // Before the copy: a check that is asked for from here on, as after each change, ends the search.
        let of = self.collision_checks.now();
        // The user keeps dragging meanwhile.
        let search = self.open().fix_search(&app)?;
        let fixes = if asked.collisions {
            search.collision_fixes(&app, &|| self.collision_checks.is_last(of))?
        } else {
            search.fixes(&app)?
        };
        Ok(FixesResponse { fixes })
    }

    pub(crate) fn fix_all(
        &self,
        asked: &FixAllRequest,
        _: &dyn Progress,
    ) -> Result<FixAllResponse, ApiError> {
        // What is no code has no findings.
        let Some(&code) = DiagnosticCode::ALL.iter().find(|code| code.as_str() == asked.code) else {
            return Ok(FixAllResponse { all: None });
        };
        let app = self.installation();
        let searches = self.fix_all_searches.of(code);
        let own = searches.begin();
        let search = self.open().fix_search(&app)?;
        let all = search.fix_all(&app, code, &|| searches.is_last(own))?;
        Ok(FixAllResponse { all })
    }

    pub(crate) fn save(&self, asked: &SaveDesign, _: &dyn Progress) -> Result<DesignOpened, ApiError> {
        let mut open = self.open();
        let path = open.save(asked.path.as_deref())?;
        self.remember(&path);
        Ok(DesignOpened { design: open.view(), notes: Vec::new(), recent: self.recent() })
    }

    pub(crate) fn close(&self, _: &CloseDesign, progress: &dyn Progress) -> Result<DesignOpened, ApiError> {
        self.new_design(&NewDesign { machine: None }, progress)
    }

    pub(crate) fn restore(&self, asked: &RestoreUnsaved, _: &dyn Progress) -> Result<DesignOpened, ApiError> {
        self.replace(Editor::restore(&asked.journal)?, Vec::new())
    }

    pub(crate) fn discard(
        &self,
        asked: &DiscardUnsaved,
        progress: &dyn Progress,
    ) -> Result<Started, ApiError> {
        // Only what is offered can be thrown away: a window names no other file.
        let offered = self.keep_in().map(|folder| Editor::unsaved(&folder).0).unwrap_or_default();
        if let Some(unsaved) = offered.iter().find(|unsaved| unsaved.journal == asked.journal) {
            std::fs::remove_file(&unsaved.journal).map_err(|error| {
                PlanningError::Document(DocumentError::Save {
                    path: unsaved.journal.display().to_string(),
                    error,
                })
            })?;
        }
        self.start(&Start {}, progress)
    }

    pub(crate) fn clear_recent(&self, _: &ClearRecent, progress: &dyn Progress) -> Result<Started, ApiError> {
        self.forget_recent();
        self.start(&Start {}, progress)
    }

    /// Puts another design on the workspace; the one before is closed.
    pub(crate) fn replace(&self, editor: Editor, notes: Vec<NoteReport>) -> Result<DesignOpened, ApiError> {
        let design = editor.view();
        let before = std::mem::replace(&mut *self.open(), editor);
        before.close();
        self.put_run_file(None);
        Ok(DesignOpened { design, notes, recent: self.recent() })
    }
}

/// What a document has beside its wireframe, which is not added with that.
fn left_out(document: &Document) -> Option<NoteReport> {
    let more = [
        ("doubled edges", !document.doublings.is_empty()),
        ("start and order of the wires", document.start.is_some() || !document.walks.is_empty()),
        ("remarks", !document.pins.is_empty() || !document.notes.is_empty()),
        ("pause points", !document.pauses.is_empty()),
        ("names and colours of parts", !document.parts.is_empty()),
        ("construction lines", !document.construction.is_empty()),
        ("stencils", !document.stencils.is_empty()),
    ];
    let more: Vec<&str> = more.into_iter().filter(|(_, has)| *has).map(|(what, _)| what).collect();
    (!more.is_empty()).then(|| NoteReport {
        code: "left-out".into(),
        count: more.len(),
        message: format!("only the wireframe is added; left out: {}", more.join(", ")),
        remedies: Vec::new(),
    })
}
