//! What was done to a design is there after a crash.

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, SystemTime};

use serde_json::json;
use wirebend_editor::{Editor, EditorError};
use wirebend_error::ErrorRemedy;
use wirebend_planning::{DesignInput, NoProgress};

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
    restored.close();
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
    editor.undo().unwrap();
    assert!(editor.is_changed());
    drop(editor);
    assert_eq!(Editor::unsaved(&keep).0.first().map(|unsaved| unsaved.changes), Some(1));
    let mut restored = Editor::restore(&Editor::unsaved(&keep).0[0].journal).unwrap();
    // Undone and done again it is what the file has.
    assert!(restored.is_changed());
    restored.redo().unwrap();
    assert!(!restored.is_changed());
    assert_eq!(restored.state().file.as_deref(), Some(file.as_path()));
    assert_eq!(restored.state().name, "mine.wirebend");
    drop(restored);
    assert!(Editor::unsaved(&keep).0.is_empty(), "a person would be asked about what they have saved");
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
    assert!(
        unsaved.is_empty() && problems[0].message.contains("line 2") && problems.len() == 1,
        "{problems:?}"
    );
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

/// Work continues where changes cannot be kept safe, and they are again as soon as that can be done.
#[test]
fn a_folder_that_cannot_be_written_is_said_until_it_can() {
    let folder = tempfile::tempdir().unwrap();
    let (taken, file) = (folder.path().join("taken"), folder.path().join("mine.wirebend"));
    fs::write(&taken, "a file").unwrap();
    let mut editor = Editor::new(&app(), None, Some(&taken)).unwrap();
    let unkept = |editor: &Editor| editor.state().unkept;
    assert!(unkept(&editor).unwrap().message.contains("taken"), "{:?}", unkept(&editor));
    let draw = |editor: &mut Editor, x: f64| {
        edit(editor, &json!({"edit": "draw", "through_mm": [[x, 0, 0], [x, 40, 0]]}));
    };
    draw(&mut editor, 0.0);
    draw(&mut editor, 10.0);
    editor.undo().unwrap();
    editor.save(Some(&file)).unwrap();
    assert!(unkept(&editor).unwrap().message.contains("taken"), "it still cannot");
    fs::remove_file(&taken).unwrap();
    editor.save(None).unwrap();
    assert_eq!(unkept(&editor), None);
    // What was done before the journal was begun can be undone and done again after it.
    for undone in [false, false, true, true, false] {
        if undone {
            editor.undo().unwrap()
        } else {
            editor.redo().unwrap()
        };
        draw(&mut editor, 20.0);
        editor.undo().unwrap();
    }
    editor.undo().unwrap();
    let document = editor.document().clone();
    drop(editor);
    let journal = Editor::unsaved(&taken).0[0].journal.clone();
    assert_eq!(Editor::restore(&journal).unwrap().document(), &document);
}

/// Where the journal is gone already there is nothing to delete, and closing is no failure.
#[test]
fn a_journal_that_somebody_has_deleted_is_no_reason_not_to_close() {
    let folder = tempfile::tempdir().unwrap();
    let editor = opened(folder.path());
    for entry in fs::read_dir(folder.path()).unwrap() {
        fs::remove_file(entry.unwrap().path()).unwrap();
    }
    editor.close();
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
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

/// A disk that is full: what was done is done, and a person is warned to save.
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
        assert!(unkept.message.contains("cannot be kept safe"), "{unkept:?}");
        assert!(unkept.remedies.contains(&ErrorRemedy::SaveDesign), "{unkept:?}");
        assert_eq!(editor.view().vertices, after(number).view().vertices);
        assert!(editor.undo().unwrap().is_some(), "and it can be undone");
        // Once it is saved, a journal that has room begins with what the file has.
        while editor.undo().unwrap().is_some() {}
        editor.save(Some(&Path::new(&folder).join("mine.wirebend"))).unwrap();
        assert_eq!(editor.state().unkept, None);
        step(&mut editor, 1);
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let name = "kept::what_cannot_be_kept_safe_is_done_all_the_same_and_said";
    // Files of 16 KB at most; a process that writes more gets an error, and is not ended.
    let limited = r#"trap "" XFSZ; ulimit -f 32; exec "$0" "$@""#;
    let mut program = Command::new("sh");
    program.args(["-c", limited]).arg(std::env::current_exe().unwrap()).args([name, "--exact"]);
    let done = program.env(FOLDER, folder.path()).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stdout));
    let unsaved = Editor::unsaved(folder.path()).0;
    assert_eq!(unsaved.len(), 1, "the broken one is gone, and the new one is there");
    assert_eq!((unsaved[0].changes, unsaved[0].name.as_str()), (1, "mine.wirebend"));
}

/// The number that ends a line; the runner of tests writes the name of the test before the first.
fn answer(line: &str) -> Option<u32> {
    line.rsplit(' ').next()?.parse().ok()
}

/// A moment of a person's work, ms after the first answer: some hundred changes are made until the last of them.
const LAST_MOMENT_MS: f64 = 80.0;

/// Numbers chosen by no person, each from 0 to below 1, and that are the same for the same seed (`SplitMix64`, Steele and
/// others 2014).
struct Moments(u64);

impl Moments {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        f64::from(u32::try_from((mixed ^ (mixed >> 31)) >> 32).unwrap()) / f64::from(u32::MAX)
    }
}

/// The program is killed at a hundred moments while a person works. What was answered is there; at most the change
/// that was being made is not.
#[cfg(unix)]
#[test]
fn whenever_it_is_killed_at_most_the_change_in_progress_is_lost() {
    if let Some(folder) = std::env::var_os(FOLDER) {
        // This is the program that is killed.
        let mut editor = opened(Path::new(&folder));
        println!("0");
        for number in 0.. {
            step(&mut editor, number);
            println!("{}", number + 1);
        }
    }
    let name = "kept::whenever_it_is_killed_at_most_the_change_in_progress_is_lost";
    let seed = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap().subsec_nanos();
    let mut moments = Moments(seed.into());
    let mut seen = std::collections::BTreeSet::new();
    for _ in 0..100 {
        let folder = tempfile::tempdir().unwrap();
        let mut program = Command::new(std::env::current_exe().unwrap());
        program.args([name, "--exact", "--nocapture", "--test-threads=1"]).env(FOLDER, folder.path());
        let mut child = program.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
        let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
        while answer(&lines.next().unwrap().unwrap()) != Some(0) {}
        // Nothing is waited for: this is when it is killed, wherever it is then.
        let moment = moments.next() * LAST_MOMENT_MS;
        std::thread::sleep(Duration::from_secs_f64(moment / 1000.0));
        child.kill().unwrap();
        child.wait().unwrap();
        let answered = lines.map_while(Result::ok).filter_map(|line| answer(&line)).last().unwrap_or(0);
        seen.insert(answered);
        let told = format!("seed {seed}, killed after {moment:.3} ms and {answered} changes");
        let unsaved = Editor::unsaved(folder.path()).0;
        let restored = unsaved.first().map(|found| Editor::restore(&found.journal).unwrap().view());
        // A design that is as its file is not offered.
        let after = |count: u32| Some(after(count)).filter(Editor::is_changed).map(|editor| editor.view());
        assert!(restored == after(answered) || restored == after(answered + 1), "{told}");
    }
    assert!(seen.len() > 1, "seed {seed}: the moments are all the same: {seen:?}");
}
