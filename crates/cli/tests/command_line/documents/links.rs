//! Links, pictures and paths.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use crate::documents::markdown::{Document, code_spans};
use crate::documents::{assert_none, documents, root};

/// Folders with what others or programs have written.
const SKIPPED: [&str; 4] = ["target", "node_modules", ".git", "dist"];

/// Every Markdown file of the repository.
fn all(folder: &Path, found: &mut Vec<Document>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let entry = entry.unwrap();
        let (path, name) = (entry.path(), entry.file_name());
        let is_folder = entry.file_type().unwrap().is_dir();
        if is_folder && !SKIPPED.iter().any(|skipped| name == *skipped) {
            all(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "md") {
            found.push(Document::read(&path));
        }
    }
}

/// Targets of links and pictures in a line, code left out.
fn targets(line: &str) -> Vec<String> {
    let prose: Vec<&str> = line.split('`').step_by(2).collect();
    let prose = prose.join("`");
    let after = prose.split("](").skip(1);
    after.filter_map(|rest| rest.split_once(')')).map(|(target, _)| target.to_owned()).collect()
}

fn broken(document: &Document, target: &str) -> Option<String> {
    if ["https://", "http://", "mailto:"].iter().any(|scheme| target.starts_with(scheme)) {
        return None;
    }
    let (file, anchor) = target.split_once('#').unwrap_or((target, ""));
    let path =
        if file.is_empty() { document.path.clone() } else { document.path.parent().unwrap().join(file) };
    if !path.exists() {
        return Some(format!("{target} leads nowhere"));
    }
    if anchor.is_empty() {
        return None;
    }
    let anchors = Document::read(&path).anchors();
    (!anchors.iter().any(|known| known == anchor)).then(|| format!("{target}: there is no such section"))
}

#[test]
fn every_link_and_picture_leads_somewhere() {
    let mut documents = Vec::new();
    all(&root(), &mut documents);
    assert!(documents.len() > 20, "the documents were not found");
    let mut wrong = Vec::new();
    for document in &documents {
        for (line, text) in document.prose() {
            let broken = targets(text).into_iter().filter_map(|target| broken(document, &target));
            wrong.extend(broken.map(|what| format!("{}: {what}", document.at(line))));
        }
    }
    assert_none(&wrong);
}

/// A picture that nothing shows is not made anew when the window changes.
#[test]
fn every_picture_is_shown_in_a_document() {
    let shown: BTreeSet<PathBuf> = documents()
        .iter()
        .flat_map(|document| {
            let folder = document.path.parent().unwrap().to_owned();
            let targets = document.prose().flat_map(|(_, line)| targets(line));
            targets.filter_map(|target| folder.join(target).canonicalize().ok()).collect::<Vec<_>>()
        })
        .collect();
    let pictures =
        std::fs::read_dir(root().join("docs/pictures")).unwrap().map(|entry| entry.unwrap().path());
    let unused = pictures.filter(|path| !shown.contains(path));
    let wrong: Vec<String> = unused.map(|path| format!("{} is in no document", path.display())).collect();
    assert_none(&wrong);
}

/// Code spans that begin with a folder of this repository are paths in it.
#[test]
fn every_path_of_the_repository_is_there() {
    let folders: Vec<String> = std::fs::read_dir(root())
        .unwrap()
        .map(|entry| entry.unwrap())
        .filter(|entry| entry.path().is_dir() && !SKIPPED.iter().any(|skipped| entry.file_name() == *skipped))
        .map(|entry| format!("{}/", entry.file_name().display()))
        .collect();
    let mut wrong = Vec::new();
    for document in documents() {
        for (line, text) in document.prose() {
            for span in code_spans(text) {
                let is_path = folders.iter().any(|folder| span.starts_with(folder));
                // Places to fill in, and several files at once.
                let is_pattern = span.contains(['<', '*', '…', ' ', '{'])
                    || span.chars().any(char::is_uppercase) && span.contains("ID");
                let path = span.split('#').next().unwrap_or(span);
                // Lines of a file are said after a colon.
                let path = path.split(':').next().unwrap_or(path);
                if is_path && !is_pattern && !root().join(path).exists() {
                    wrong.push(format!("{}: {span} is not there", document.at(line)));
                }
            }
        }
    }
    assert_none(&wrong);
}
