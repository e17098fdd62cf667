//! The packages of others that the program is made of, for its About: name, version, licence.

use std::collections::{BTreeSet, HashMap};
use std::path::Path;

use anyhow::{Context, Result};
use cargo_metadata::{DependencyKind, MetadataCommand, PackageId};
use serde_json::Value;

use crate::committed::CommittedFile;

/// What is installed; of the window's packages those of this system are named, which are the most.
const SHIPPED: &[&str] =
    &["wirebend-window", "wirebend-cli", "wirebend-driver-wirebend-kit", "wirebend-driver-grbl"];
const SYSTEM: &str = "x86_64-unknown-linux-gnu";
const FILE: &str = "crates/api/src/workspace/packages.json";

pub(super) fn file(root: &Path) -> Result<CommittedFile> {
    let mut packages = of_cargo(root)?;
    packages.extend(of_npm(root)?);
    let lines: Vec<String> = packages.iter().map(serde_json::to_string).collect::<Result<_, _>>()?;
    Ok(CommittedFile { path: FILE.to_owned(), text: format!("[\n  {}\n]\n", lines.join(",\n  ")) })
}

fn of_cargo(root: &Path) -> Result<BTreeSet<[String; 3]>> {
    let options = ["--filter-platform", SYSTEM, "--locked"].map(str::to_owned);
    let metadata = MetadataCommand::new().current_dir(root).other_options(options).exec()?;
    let resolve = metadata.resolve.as_ref().context("cargo has not resolved the packages")?;
    let nodes: HashMap<&PackageId, _> = resolve.nodes.iter().map(|node| (&node.id, node)).collect();
    let mut open: Vec<&PackageId> = metadata
        .workspace_packages()
        .into_iter()
        .filter(|package| SHIPPED.contains(&package.name.as_str()))
        .map(|package| &package.id)
        .collect();
    let mut known: BTreeSet<&PackageId> = open.iter().copied().collect();
    while let Some(id) = open.pop() {
        let Some(node) = nodes.get(id) else { continue };
        // What builds it or tests it is not in it.
        let linked = |kinds: &[cargo_metadata::DepKindInfo]| {
            kinds.iter().any(|info| info.kind == DependencyKind::Normal)
        };
        for dependency in node.deps.iter().filter(|dependency| linked(&dependency.dep_kinds)) {
            if known.insert(&dependency.pkg) {
                open.push(&dependency.pkg);
            }
        }
    }
    let others =
        metadata.packages.iter().filter(|package| known.contains(&package.id) && package.source.is_some());
    let named = |package: &cargo_metadata::Package| {
        let licence = package.license.clone().unwrap_or_else(|| "see its licence file".to_owned());
        [package.name.to_string(), package.version.to_string(), licence]
    };
    Ok(others.map(named).collect())
}

fn of_npm(root: &Path) -> Result<Vec<[String; 3]>> {
    let path = root.join("ui/package-lock.json");
    let text = std::fs::read_to_string(&path).with_context(|| path.display().to_string())?;
    let lock: Value = serde_json::from_str(&text)?;
    let packages = lock["packages"].as_object().context("ui/package-lock.json has no packages")?;
    let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    // What is optional is for Node alone: it is not in what a browser loads.
    let left_out = |package: &Value| ["dev", "optional"].iter().any(|key| package[*key] == Value::Bool(true));
    let shipped = packages.iter().filter(|(path, package)| !path.is_empty() && !left_out(package));
    let named = |(path, package): (&String, &Value)| {
        let name = path.rsplit("node_modules/").next().unwrap_or_default();
        [format!("npm:{name}"), text(&package["version"]), text(&package["license"])]
    };
    Ok(shipped.map(named).collect())
}
