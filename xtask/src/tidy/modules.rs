//! Rule: between the modules of a crate the flow is one way too: no circles, and nothing against the order that is listed here.

use std::collections::{BTreeMap, BTreeSet};

use petgraph::algo::tarjan_scc;
use petgraph::graphmap::DiGraphMap;
use syn::visit::{self, Visit};

use super::finding::Finding;
use super::members::Member;
use super::tree::TreeFile;

const WHY: &str = "what knows each other can be neither read nor tested alone";
/// From here on a folder is no list any more.
const FLAT: usize = 25;

/// The modules of a crate in the order of its flow: each may know those before it.
const ORDER: &[(&str, &str)] = &[
    (
        "crates/core",
        "units mesh curve wireframe route bend schedule compensate calibrate estimate simulate motion sag clearance search checks plan",
    ),
    (
        "crates/profile",
        "kind position sourced profile heading shape material machine strut_builder rules noise \
         schema error shipped layer merge resolved library resolve explain figures child check",
    ),
    ("crates/files", "limit length_unit encoding number document read write"),
    ("crates/journal", "error chain reading log"),
    (
        "crates/driver-api",
        "port error number job bench serial description console call limits event deadline driver dispatch schemas abi glue table transcript \
         conformance",
    ),
    (
        "crates/driver-host",
        "trust registry library frame error ending process confine child driver session actor jobs",
    ),
    (
        "crates/planning",
        "text report stage progress error output misnamed installation signs drivers bodies machine contacts job choices curves program design stencil \
         turning_back playback pauses plan compare wires catalogue import generate picture export dump profiles calibrate as_given collisions simulate frame sequence",
    ),
    (
        "crates/editor",
        "plane request view error history edit_journal figures construction resolving changing outcome check collisions fixes",
    ),
    (
        "crates/operation",
        "event phase pieces order error front_end runs calibrate live ports machine_settings console simulate run by_hand operator",
    ),
    ("crates/api", "error places workspace requests asking"),
    (
        "crates/cli",
        "usage number exit again contents stop render errors progress keyboard terminal args requests",
    ),
];

/// A module of a crate by its path below the root: empty for the root itself.
type Path = Vec<String>;

/// What one crate's files say.
struct Crate {
    modules: BTreeSet<Path>,
    /// Names that a module passes on, and where they come from.
    passed_on: BTreeMap<(Path, String), Path>,
    /// From a module to what it names, with the file.
    names: Vec<(Path, Path, String)>,
}

/// Circles between modules, arrows against the order, and folders that are no list any more.
pub(super) fn check(members: &[Member], files: &[TreeFile]) -> Vec<Finding> {
    members.iter().flat_map(|member| check_crate(&member.room, files)).chain(flat(files)).collect()
}

fn check_crate(room: &str, files: &[TreeFile]) -> Vec<Finding> {
    let read = Crate::read(room, files);
    let mut arrows: BTreeMap<Path, BTreeMap<(String, String), String>> = BTreeMap::new();
    for (from, to, file) in &read.names {
        let to = read.resolved(to);
        let shared = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
        if let (Some(a), Some(b)) = (from.get(shared), to.get(shared)) {
            let level = arrows.entry(from[..shared].to_vec()).or_default();
            level.entry((a.clone(), b.clone())).or_insert_with(|| file.clone());
        }
    }
    let mut findings: Vec<Finding> =
        arrows.iter().flat_map(|(level, arrows)| circles(room, level, arrows)).collect();
    if let Some((_, order)) = ORDER.iter().find(|(listed, _)| *listed == room) {
        findings.extend(against(room, order, &read, arrows.get(&Vec::new())));
    }
    findings
}

/// Modules of one level that know each other.
fn circles(room: &str, level: &[String], arrows: &BTreeMap<(String, String), String>) -> Vec<Finding> {
    let mut graph = DiGraphMap::<&str, ()>::new();
    for (a, b) in arrows.keys() {
        graph.add_edge(a.as_str(), b.as_str(), ());
    }
    let mut found = Vec::new();
    for mut circle in tarjan_scc(&graph).into_iter().filter(|circle| circle.len() > 1) {
        circle.sort_unstable();
        let known: Vec<String> = arrows
            .iter()
            .filter(|((a, b), _)| circle.contains(&a.as_str()) && circle.contains(&b.as_str()))
            .map(|((a, b), file)| format!("{a} knows {b} in {file}"))
            .collect();
        let of = if level.is_empty() { room.to_owned() } else { format!("{room}, {}", level.join("::")) };
        let what = format!("the modules {} of {of} know each other: {}", circle.join(", "), known.join("; "));
        let mend = "move what both need to a module before both";
        found.push(Finding::new(&format!("{room}/src"), 1, what, WHY, mend));
    }
    found
}

/// Arrows to a later module, and modules that the order does not name.
fn against(
    room: &str,
    order: &str,
    read: &Crate,
    arrows: Option<&BTreeMap<(String, String), String>>,
) -> Vec<Finding> {
    let place = |name: &str| order.split_whitespace().position(|listed| listed == name);
    let here = "give it its place in ORDER of xtask/src/tidy/modules.rs";
    let unlisted = read.modules.iter().filter(|path| path.len() == 1 && place(&path[0]).is_none());
    let mut found: Vec<Finding> = unlisted
        .map(|path| {
            Finding::new(&format!("{room}/src"), 1, format!("module {} has no place", path[0]), WHY, here)
        })
        .collect();
    for ((a, b), file) in arrows.into_iter().flatten() {
        if let (Some(from), Some(to)) = (place(a), place(b))
            && from < to
        {
            let what = format!("{a} knows {b}, which comes after it");
            found.push(Finding::new(file, 1, what, WHY, "move the code that needs it to a later module"));
        }
    }
    found
}

/// Folders of sources with so many files that the listing shows nothing.
fn flat(files: &[TreeFile]) -> Vec<Finding> {
    let mut folders: BTreeMap<&str, usize> = BTreeMap::new();
    for file in
        files.iter().filter(|file| file.has_extension(&["rs", "ts", "tsx", "c", "h"]) && !file.is_fixture())
    {
        if let Some((folder, _)) = file.path.rsplit_once('/') {
            *folders.entry(folder).or_default() += 1;
        }
    }
    let many = folders.into_iter().filter(|(_, count)| *count > FLAT);
    many.map(|(folder, count)| {
        let why = "a listing of so many files shows nothing";
        Finding::new(folder, 1, format!("{count} files in one folder"), why, "sort them by what they do")
            .into_report()
    })
    .collect()
}

impl Crate {
    fn read(room: &str, files: &[TreeFile]) -> Self {
        let mut read = Self { modules: BTreeSet::new(), passed_on: BTreeMap::new(), names: Vec::new() };
        let root = format!("{room}/src/");
        let sources: Vec<(Path, &TreeFile)> =
            files.iter().filter_map(|file| Some((module(file.path.strip_prefix(&root)?)?, file))).collect();
        read.modules.extend(sources.iter().map(|(path, _)| path.clone()));
        for (path, file) in &sources {
            let Ok(parsed) = syn::parse_file(file.text.as_deref().unwrap_or_default()) else { continue };
            let mut reader = Reader { of: path, file: &file.path, read: &mut read };
            reader.visit_file(&parsed);
        }
        read
    }

    /// The module in which a name is at home.
    fn resolved(&self, name: &[String]) -> Path {
        let mut at = Path::new();
        let mut rest: Path = name.to_vec();
        // Names that are passed on in a ring do not compile.
        for _ in 0..32 {
            let Some(next) = rest.first().cloned() else { break };
            let child: Path = at.iter().cloned().chain([next.clone()]).collect();
            if self.modules.contains(&child) {
                at = child;
                rest.remove(0);
            } else if let Some(from) = self.passed_on.get(&(at.clone(), next)) {
                rest.clone_from(from);
                at = Path::new();
            } else {
                break;
            }
        }
        at
    }
}

/// The module of a file below `src`; none for a program and for tests.
fn module(file: &str) -> Option<Path> {
    let path = file.strip_suffix(".rs")?;
    let mut parts: Path = path.split('/').map(str::to_owned).collect();
    if parts.first().is_some_and(|first| first == "bin")
        || parts.last().is_some_and(|last| last == "tests" || last == "testing" || last.ends_with("_tests"))
    {
        return None;
    }
    if parts.last().is_some_and(|last| ["mod", "lib", "main"].contains(&last.as_str())) {
        parts.pop();
    }
    Some(parts)
}

/// Reads one file.
struct Reader<'a> {
    of: &'a Path,
    file: &'a str,
    read: &'a mut Crate,
}

impl Reader<'_> {
    /// From the root of the crate; none for what is of another crate.
    fn absolute(&self, segments: &[String]) -> Option<Path> {
        let mut base = self.of.clone();
        let mut rest = segments;
        match segments.first().map(String::as_str)? {
            "crate" => {
                base.clear();
                rest = &rest[1..];
            }
            "self" => rest = &rest[1..],
            "super" => {
                while rest.first().is_some_and(|segment| segment == "super") {
                    base.pop();
                    rest = &rest[1..];
                }
            }
            // A child of this module.
            first => {
                let child: Path = base.iter().cloned().chain([first.to_owned()]).collect();
                if !self.read.modules.contains(&child) {
                    return None;
                }
            }
        }
        base.extend_from_slice(rest);
        Some(base)
    }

    fn names(&mut self, segments: &[String]) {
        if let Some(name) = self.absolute(segments) {
            self.read.names.push((self.of.clone(), name, self.file.to_owned()));
        }
    }

    fn used(&mut self, tree: &syn::UseTree, before: &[String], public: bool) {
        let then =
            |ident: &syn::Ident| -> Path { before.iter().cloned().chain([ident.to_string()]).collect() };
        match tree {
            syn::UseTree::Path(path) => self.used(&path.tree, &then(&path.ident), public),
            syn::UseTree::Group(group) => group.items.iter().for_each(|item| self.used(item, before, public)),
            syn::UseTree::Name(name) => self.named(&then(&name.ident), &name.ident.to_string(), public),
            syn::UseTree::Rename(renamed) => {
                self.named(&then(&renamed.ident), &renamed.rename.to_string(), public);
            }
            syn::UseTree::Glob(_) => self.names(before),
        }
    }

    fn named(&mut self, segments: &[String], name: &str, public: bool) {
        self.names(segments);
        if let Some(home) = self.absolute(segments).filter(|_| public) {
            self.read.passed_on.insert((self.of.clone(), name.to_owned()), home);
        }
    }
}

impl Visit<'_> for Reader<'_> {
    fn visit_item_mod(&mut self, item: &syn::ItemMod) {
        let for_tests = item.attrs.iter().any(|attribute| {
            attribute.path().is_ident("cfg")
                && attribute.parse_args::<syn::Ident>().is_ok_and(|when| when == "test")
        });
        if !for_tests {
            visit::visit_item_mod(self, item);
        }
    }

    fn visit_item_use(&mut self, item: &syn::ItemUse) {
        self.used(&item.tree, &[], !matches!(item.vis, syn::Visibility::Inherited) || self.of.is_empty());
    }

    fn visit_path(&mut self, path: &syn::Path) {
        let segments: Path = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        if segments.first().is_some_and(|first| ["crate", "super"].contains(&first.as_str())) {
            self.names(&segments);
        }
        visit::visit_path(self, path);
    }
}

#[cfg(test)]
mod tests {
    use super::super::sample::file;
    use super::*;

    fn found(files: &[(&str, &str)]) -> Vec<String> {
        let files: Vec<TreeFile> =
            files.iter().map(|(path, text)| file(&format!("drivers/a/src/{path}"), text)).collect();
        check_crate("drivers/a", &files).into_iter().map(|finding| finding.what).collect()
    }

    #[test]
    fn modules_in_one_direction_are_fine() {
        let files = [("lib.rs", "mod a;\nmod b;"), ("a.rs", "pub struct A;"), ("b.rs", "use crate::a::A;")];
        assert_eq!(found(&files), [""; 0]);
    }

    #[test]
    fn a_circle_is_found_through_names_that_are_passed_on() {
        let files = [
            ("lib.rs", "mod a;\nmod b;\npub use b::B;"),
            ("a/mod.rs", "mod inner;"),
            ("a/inner.rs", "use crate::B;\npub fn f() -> super::super::B { B }"),
            ("b.rs", "pub struct B; fn g() { crate::a::f() }"),
        ];
        let found = found(&files);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].contains("modules a, b of drivers/a know each other"), "{found:?}");
    }

    #[test]
    fn a_circle_within_a_folder_is_found_and_what_tests_name_is_not() {
        let inside = [
            ("a/mod.rs", "mod one;\nmod two;"),
            ("a/one.rs", "use super::two::Two;"),
            ("a/two.rs", "use super::one::One;"),
        ];
        assert_eq!(found(&inside).len(), 1);
        let tested = [
            ("a/mod.rs", "mod one;\nmod two;"),
            ("a/one.rs", "use super::two::Two;"),
            ("a/two.rs", "#[cfg(test)]\nmod tests { use super::super::one::One; }"),
        ];
        assert_eq!(found(&tested).len(), 0);
    }

    #[test]
    fn an_arrow_against_the_order_and_a_module_without_a_place_are_found() {
        let files = [
            ("crates/core/src/units.rs", "use crate::plan::Machine;"),
            ("crates/core/src/plan.rs", ""),
            ("crates/core/src/odd.rs", ""),
        ];
        let files: Vec<TreeFile> = files.iter().map(|(path, text)| file(path, text)).collect();
        let found: Vec<String> =
            check_crate("crates/core", &files).into_iter().map(|finding| finding.what).collect();
        assert_eq!(found, ["module odd has no place", "units knows plan, which comes after it"]);
    }

    #[test]
    fn a_folder_of_many_files_is_reported() {
        let files: Vec<TreeFile> = (0..=FLAT).map(|n| file(&format!("ui/src/scene/{n}.ts"), "")).collect();
        let found = flat(&files);
        assert_eq!((found.len(), found[0].only_report), (1, true));
    }
}
