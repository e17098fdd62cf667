//! Names of files that promise something else than what is in them: whoever opens such a file is told that it is damaged.

use wirebend_files::read::Format;

use crate::output::Output;
use crate::report::NoteReport;

/// What is written to a file.
#[derive(Debug, Clone, Copy)]
pub struct FileKind<'a> {
    /// As a sentence calls it.
    pub called: &'a str,
    /// How its names end, the usual ending first.
    pub endings: &'a [&'a str],
}

/// A design as this program keeps it.
pub const PROJECT: FileKind<'static> =
    FileKind { called: "a WireBend project", endings: &["wirebend", "json"] };

/// A plan for a machine.
pub const JOB: FileKind<'static> = FileKind { called: "a WireBend job", endings: &[JOB_ENDING, "json"] };

/// A profile of a machine, a wire or errors.
pub const PROFILE: FileKind<'static> = FileKind { called: "a profile", endings: &["json"] };

/// What became of a wire.
pub const RECORD: FileKind<'static> = FileKind { called: "the record of a wire", endings: &["json"] };

/// Moves by hand, to be replayed.
pub const MOVES: FileKind<'static> = FileKind { called: "recorded moves", endings: &["wbmoves", "json"] };

const JOB_ENDING: &str = "wbjob";

/// Endings of what this program writes and does not read.
const WRITTEN: [&str; 4] = ["png", "pdf", "vtk", JOB_ENDING];

/// Endings of text of any kind.
const TEXT: [&str; 2] = ["txt", "tsv"];

impl FileKind<'_> {
    /// A note on a name that ends otherwise.
    #[must_use]
    pub fn misnamed(&self, output: Option<&Output>) -> Option<NoteReport> {
        self.note(output, |_| true)
    }

    /// The same of the program of a machine. What such programs are called is up to the person, except as another kind of file.
    #[must_use]
    pub fn misnamed_program(&self, output: Option<&Output>) -> Option<NoteReport> {
        self.note(output, is_of_a_kind)
    }

    fn note(&self, output: Option<&Output>, counts: impl Fn(&str) -> bool) -> Option<NoteReport> {
        let named = output?.path.extension()?.to_str()?.to_lowercase();
        let is_wrong = !self.endings.contains(&named.as_str()) && counts(&named);
        is_wrong.then(|| NoteReport {
            code: "misnamed".into(),
            count: 1,
            message: format!(
                "the name ends in .{named}, and what is written is {}, whose names end in .{}",
                self.called,
                self.endings.join(" or .")
            ),
            remedies: Vec::new(),
        })
    }
}

/// Whether it is the ending of something that this program reads or writes.
fn is_of_a_kind(ending: &str) -> bool {
    let is_read = Format::ALL.iter().any(|format| format.extensions().contains(&ending));
    (is_read || WRITTEN.contains(&ending)) && !TEXT.contains(&ending)
}

#[cfg(test)]
mod tests {
    use super::*;

    const PROGRAM: FileKind<'static> = FileKind { called: "'gcode'", endings: &["nc", "gcode"] };

    fn output(name: &str) -> Output {
        Output { path: name.into(), force: false }
    }

    /// Who opens a job under the name of a mesh is told by another program that the mesh is damaged.
    #[test]
    fn what_this_program_keeps_has_its_own_names() {
        let said = JOB.misnamed(Some(&output("a.STL"))).unwrap().message;
        let expected = "the name ends in .stl, and what is written is a WireBend job, whose names end in .wbjob or .json";
        assert_eq!(said, expected);
        for name in ["a.txt", "a.wirebend", "a.v2"] {
            assert!(JOB.misnamed(Some(&output(name))).is_some(), "{name}");
        }
        for name in ["a.wbjob", "a.WBJOB", "a.json", "a"] {
            assert!(JOB.misnamed(Some(&output(name))).is_none(), "{name}");
        }
        assert!(JOB.misnamed(None).is_none());
    }

    /// Each controller has its own habit of names, and none is that of a document.
    #[test]
    fn a_program_is_called_as_a_person_likes_but_for_other_kinds() {
        for name in ["a.wirebend", "a.wbjob", "a.gltf", "a.csv", "a.json", "a.svg", "a.stl", "a.wbmoves"] {
            assert!(PROGRAM.misnamed_program(Some(&output(name))).is_some(), "{name}");
        }
        for name in ["a.nc", "a.tap", "a.txt", "a.cnc", "a"] {
            assert!(PROGRAM.misnamed_program(Some(&output(name))).is_none(), "{name}");
        }
    }
}
