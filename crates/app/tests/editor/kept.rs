//! What was done to a design is there after a crash.

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, SystemTime};

use serde_json::json;
use wirebend_app::{DesignInput, Editor, EditorError, NoProgress};

use crate::edits::every_edit;
use crate::{app, edit, example};

const FOLDER: &str = "WIREBEND_TEST_EDITING";

fn opened(folder: &Path) -> Editor {
    let input = DesignInput::file(example("cube.obj"));
    Editor::open(&input, Some(folder), &NoProgress).unwrap().0
}

/// The edit of a number: a vertex farther out, every third time an undo.
fn step(editor: &mut Editor, number: u32) {
    if number % 3 == 2 {
        editor.undo().unwrap();
    } else {
        edit(editor, &json!({"edit": "draw", "from": 0, "through_mm": [[number, 0.1, -1.5]]}));
    }
}

/// The state after so many steps.
fn after(count: u32) -> Editor {
    let (mut editor, _) = Editor::open(&DesignInput::file(example("cube.obj")), None, &NoProgress).unwrap();
    (0..count).for_each(|number| step(&mut editor, number));
    editor
}

#[test]
fn unsaved_changes_are_offered_after_a_crash_and_can_be_undone() {
    let folder = tempfile::tempdir().unwrap();
    let mut editor = opened(folder.path());
    assert!(Editor::unsaved(folder.path()).0.is_empty(), "it is open");
    (0..5).for_each(|number| step(&mut editor, number));
    // As when the program is gone.
    drop(editor);
    let (unsaved, problems) = Editor::unsaved(folder.path());
    assert!(problems.is_empty(), "{problems:?}");
    assert_eq!((unsaved.len(), unsaved[0].changes, unsaved[0].name.as_str()), (1, 5, "cube.obj"));
    assert_eq!(unsaved[0].file, None, "an imported file is not the design's");
    let mut restored = Editor::restore(&unsaved[0].journal).unwrap();
    let mut expected = after(5);
    assert_eq!(restored.view(), expected.view());
    assert!(restored.is_changed());
    while expected.undo().unwrap().is_some() {
        restored.undo().unwrap();
        assert_eq!(restored.view(), expected.view());
    }
    assert_eq!(restored.undo().unwrap(), None);
    assert!(matches!(Editor::restore(&unsaved[0].journal), Err(EditorError::Log(_))), "it is open");
    // Closed, it is given up.
    restored.close().unwrap();
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn what_a_file_has_is_not_offered() {
    let folder = tempfile::tempdir().unwrap();
    let (keep, file) = (folder.path().join("keep"), folder.path().join("mine.wirebend"));
    let mut editor = opened(&keep);
    assert!(editor.save(None).unwrap_err().to_string().contains("no file yet"));
    step(&mut editor, 0);
    assert_eq!(editor.save(Some(&file)).unwrap(), file);
    assert!(!editor.is_changed());
    let document = editor.document().clone();
    // Undone and done again it is what the file has.
    editor.undo().unwrap();
    assert!(editor.is_changed());
    editor.redo().unwrap();
    assert!(!editor.is_changed());
    drop(editor);
    assert_eq!(Editor::unsaved(&keep).0.first().map(|unsaved| unsaved.changes), Some(2));
    let mut restored = Editor::restore(&Editor::unsaved(&keep).0[0].journal).unwrap();
    assert!(!restored.is_changed());
    assert_eq!(restored.state().file.as_deref(), Some(file.as_path()));
    assert_eq!(restored.state().name, "mine.wirebend");
    restored.save(None).unwrap();
    drop(restored);
    assert!(Editor::unsaved(&keep).0.is_empty());
    assert_eq!(fs::read_dir(&keep).unwrap().count(), 0, "and its journal is gone");
    let (mut again, _) = Editor::open(&DesignInput::file(file.clone()), Some(&keep), &NoProgress).unwrap();
    assert_eq!((again.document(), again.state().file), (&document, Some(file)));
    step(&mut again, 3);
    drop(again);
    let unsaved = Editor::unsaved(&keep).0;
    assert_eq!(unsaved[0].name, "mine.wirebend");
}

#[test]
fn a_journal_that_is_damaged_or_of_a_later_program_is_told_and_left() {
    let folder = tempfile::tempdir().unwrap();
    let mut editor = opened(folder.path());
    (0..4).for_each(|number| step(&mut editor, number));
    drop(editor);
    let journal = Editor::unsaved(folder.path()).0[0].journal.clone();
    let good = fs::read_to_string(&journal).unwrap();
    fs::write(&journal, good.replacen("-1.5", "-2.5", 1)).unwrap();
    let (unsaved, problems) = Editor::unsaved(folder.path());
    assert!(unsaved.is_empty() && problems[0].contains("line 2") && problems.len() == 1, "{problems:?}");
    assert!(journal.exists());
    // Half of its last line: the change before that was the last.
    fs::write(&journal, &good[..good.len() - 20]).unwrap();
    assert_eq!(Editor::unsaved(folder.path()).0[0].changes, 3);
    assert_eq!(Editor::restore(&journal).unwrap().view(), after(3).view());
    fs::write(&journal, "").unwrap();
    assert!(Editor::unsaved(folder.path()).0.is_empty());
    assert!(journal.exists(), "another program may be beginning it");
    let before = SystemTime::now() - Duration::from_hours(1);
    fs::File::options().write(true).open(&journal).unwrap().set_modified(before).unwrap();
    assert!(Editor::unsaved(folder.path()).0.is_empty());
    assert!(!journal.exists(), "there was nothing in it");
}

#[test]
fn a_folder_that_cannot_be_written_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let taken = folder.path().join("taken");
    fs::write(&taken, "a file").unwrap();
    let error = Editor::new(&app(), None, Some(&taken)).unwrap_err();
    assert!(error.to_string().contains("taken"), "{error}");
}

/// Whatever was done is understood again, on a document that has been written and read.
#[test]
fn every_edit_is_restored() {
    for (request, _) in every_edit() {
        let folder = tempfile::tempdir().unwrap();
        let mut editor = opened(folder.path());
        edit(&mut editor, &json!({"edit": "machine", "machine": "wirebend-kit", "material": null}));
        edit(&mut editor, &json!({"edit": "start", "vertex": 1}));
        edit(&mut editor, &request);
        edit(&mut editor, &json!({"edit": "draw", "through_mm": [[7, 7, 7]]}));
        let document = editor.document().clone();
        drop(editor);
        let (unsaved, problems) = Editor::unsaved(folder.path());
        assert!(problems.is_empty(), "{request}: {problems:?}");
        assert_eq!(Editor::restore(&unsaved[0].journal).unwrap().document(), &document, "{request}");
    }
}

/// A disk that is full: what was done is done, and a person is told to save.
#[cfg(unix)]
#[test]
fn what_cannot_be_kept_safe_is_done_all_the_same_and_said() {
    if let Some(folder) = std::env::var_os(FOLDER) {
        let mut editor = opened(Path::new(&folder));
        let mut number = 0;
        while editor.state().unkept.is_none() {
            assert!(number < 10_000, "the disk is not full");
            step(&mut editor, number);
            number += 1;
        }
        let unkept = editor.state().unkept.unwrap();
        assert!(unkept.contains("cannot be kept safe") && unkept.contains("save"), "{unkept}");
        assert_eq!(editor.view().vertices, after(number).view().vertices);
        assert!(editor.undo().unwrap().is_some(), "and it can be undone");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let name = "kept::what_cannot_be_kept_safe_is_done_all_the_same_and_said";
    // Files of 16 KB at most; who writes more is told, and not ended.
    let limited = r#"trap "" XFSZ; ulimit -f 32; exec "$0" "$@""#;
    let mut program = Command::new("sh");
    program.args(["-c", limited]).arg(std::env::current_exe().unwrap()).args([name, "--exact"]);
    let done = program.env(FOLDER, folder.path()).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stdout));
    assert_eq!(Editor::unsaved(folder.path()).0.len(), 1, "what was kept before is there");
}

/// The number that ends a line; the runner of tests writes the name of the test before the first.
fn answer(line: &str) -> Option<u32> {
    line.rsplit(' ').next()?.parse().ok()
}

/// The program is killed at a hundred moments while a person works. What was answered is there; at most the change
/// that was being made is not.
#[cfg(unix)]
#[test]
fn whenever_it_is_killed_at_most_the_change_in_progress_is_lost() {
    if let Some(folder) = std::env::var_os(FOLDER) {
        // This is the program that is killed.
        let mut editor = opened(Path::new(&folder));
        for number in 0.. {
            step(&mut editor, number);
            println!("{}", number + 1);
        }
    }
    let name = "kept::whenever_it_is_killed_at_most_the_change_in_progress_is_lost";
    for moment in 0..100_u32 {
        let folder = tempfile::tempdir().unwrap();
        let mut program = Command::new(std::env::current_exe().unwrap());
        program.args([name, "--exact", "--nocapture", "--test-threads=1"]).env(FOLDER, folder.path());
        let mut child = program.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
        let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
        let mut answered = 0;
        // The moment is one of the program's own: after an answer, and however far it has come since.
        while answered < moment % 10 {
            answered = answer(&lines.next().unwrap().unwrap()).unwrap_or(answered);
        }
        std::thread::yield_now();
        child.kill().unwrap();
        child.wait().unwrap();
        let last = lines.map_while(Result::ok).filter_map(|line| answer(&line)).last();
        let answered = last.unwrap_or(answered);
        let unsaved = Editor::unsaved(folder.path()).0;
        let Some(found) = unsaved.first() else {
            assert_eq!(answered, 0, "nothing was answered");
            continue;
        };
        let restored = Editor::restore(&found.journal).unwrap();
        let lost_nothing = restored.view() == after(answered).view();
        assert!(lost_nothing || restored.view() == after(answered + 1).view(), "killed after {answered}");
    }
}
