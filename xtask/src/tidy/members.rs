//! The crates of the workspace and what each depends on, from `cargo metadata --no-deps`.

use std::path::Path;

use anyhow::{Context, Result};
use cargo_metadata::{DependencyKind, MetadataCommand};

use super::tree::TreeFile;

/// A crate of the workspace.
pub(super) struct Member {
    /// Its folder below the workspace root: crates are known by their room, not by their name.
    pub(super) room: String,
    pub(super) dependencies: Vec<Dependency>,
    pub(super) targets: Vec<Target>,
}

/// A library, a program, or what else is compiled of a crate.
pub(super) struct Target {
    /// Its first file, below the workspace root.
    pub(super) source: String,
    /// Whether its tests are compiled and run.
    pub(super) tested: bool,
}

/// One line of a crate's dependency tables.
pub(super) struct Dependency {
    pub(super) name: String,
    /// From `[dependencies]` or `[build-dependencies]`, not `[dev-dependencies]`.
    pub(super) ships: bool,
    /// Folder below the workspace root when it is a crate of this repository.
    pub(super) room: Option<String>,
}

impl Member {
    pub(super) fn manifest(&self) -> String {
        format!("{}/Cargo.toml", self.room)
    }

    /// Line of the manifest that names `dependency`; 1 when it cannot be found.
    pub(super) fn line_of(&self, dependency: &str, files: &[TreeFile]) -> usize {
        let manifest = self.manifest();
        let mut lines = files.iter().filter(|file| file.path == manifest).flat_map(TreeFile::lines);
        let found = lines.find(|(_, line)| {
            let rest = line.trim_start_matches("[dependencies.").strip_prefix(dependency);
            rest.is_some_and(|rest| rest.starts_with([' ', '.', '=', ']']))
        });
        found.map_or(1, |(number, _)| number)
    }
}

/// Reads the members without resolving anything outside the workspace.
pub(super) fn read(root: &Path) -> Result<Vec<Member>> {
    let metadata =
        MetadataCommand::new().current_dir(root).no_deps().exec().context("cargo metadata failed")?;
    let room_of = |folder: &Path| {
        let below = folder.strip_prefix(root).unwrap_or(folder);
        below.to_string_lossy().replace('\\', "/")
    };
    let mut members = Vec::new();
    for package in &metadata.packages {
        let folder = package.manifest_path.parent().context("a manifest without a folder")?;
        let dependencies = package.dependencies.iter().map(|dependency| Dependency {
            name: dependency.name.clone(),
            ships: dependency.kind != DependencyKind::Development,
            room: dependency.path.as_ref().map(|path| room_of(path.as_std_path())),
        });
        let targets = package.targets.iter().map(|target| Target {
            source: room_of(target.src_path.as_std_path()),
            // Build scripts have no tests, benchmarks are run as such.
            tested: target.test || target.is_custom_build() || target.is_bench(),
        });
        members.push(Member {
            room: room_of(folder.as_std_path()),
            dependencies: dependencies.collect(),
            targets: targets.collect(),
        });
    }
    members.sort_by(|a, b| a.room.cmp(&b.room));
    Ok(members)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Were the folders not below the root, every dependency between rooms would look foreign and be allowed.
    #[test]
    fn crates_are_known_by_their_folder() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let members = read(root).unwrap();
        let core = members.iter().find(|member| member.room == "crates/core").unwrap();
        let ships = |name: &str| core.dependencies.iter().find(|d| d.name == name).map(|d| d.ships);
        assert_eq!((ships("thiserror"), ships("proptest")), (Some(true), Some(false)));
        let inside = members.iter().flat_map(|member| &member.dependencies).filter_map(|d| d.room.as_ref());
        for room in inside {
            assert!(members.iter().any(|member| member.room == *room), "{room} is not below the root");
        }
    }
}
