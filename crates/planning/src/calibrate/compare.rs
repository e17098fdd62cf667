//! `calibrate compare`: two versions of a machine and its wire side by side, and how well each fits a sheet.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use wirebend_files::read::{MeasuringSheet, read_file};
use wirebend_profile::Kind;

use super::report::{KindName, MisfitReport};
use crate::{Installation, PlanningError, Progress};

#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct CalibrateCompareRequest {
    /// The two machines; each with the wire that it names, the one that a sheet is of with the wire of the sheet.
    pub machines: [String; 2],
    /// A sheet whose readings both are held against.
    pub sheet: Option<PathBuf>,
}

/// A value that differs.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ComparedValue {
    pub kind: Kind,
    /// Dotted key.
    pub key: String,
    /// The values of both; null where one has none.
    pub values: [Value; 2],
    /// Where both come from.
    pub sources: [Option<String>; 2],
}

/// How far readings are from what a version predicts.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct VersionMisfit {
    pub kind: KindName,
    /// `deg` or `mm`.
    pub unit: &'static str,
    /// Of both.
    pub misfits: [MisfitReport; 2],
}

#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct CalibrateCompareResponse {
    pub machines: [String; 2],
    pub materials: [String; 2],
    /// What differs of machine and wire.
    pub values: Vec<ComparedValue>,
    /// Where a sheet was given: how well each fits its readings.
    pub misfits: Vec<VersionMisfit>,
}

pub fn compare(
    app: &Installation,
    request: &CalibrateCompareRequest,
    progress: &dyn Progress,
) -> Result<CalibrateCompareResponse, PlanningError> {
    progress.stage("comparing");
    let [first, second] = &request.machines;
    // The machine that a sheet is of has bent the wire of the sheet.
    let of_sheet = request.sheet.as_deref().map(|path| {
        let sheet = MeasuringSheet::read(&path.display().to_string(), &read_file(path)?)?;
        Ok::<_, PlanningError>([sheet.machine, sheet.material])
    });
    let of_sheet = of_sheet.transpose()?;
    let wire = |id: &String| {
        of_sheet.as_ref().and_then(|[machine, material]| (machine == id).then_some(material.as_str()))
    };
    let setups = [app.setup(first, wire(first))?, app.setup(second, wire(second))?];
    let materials = [0, 1].map(|k: usize| setups[k].material_id().to_owned());
    let mut values = differing(app, Kind::Machine, &request.machines)?;
    // That they name another wire is no value of theirs.
    values.retain(|value| value.key != "default_material");
    values.extend(differing(app, Kind::Material, &materials)?);
    values.retain(|value| !["name", "description"].contains(&value.key.as_str()));
    let mut misfits = Vec::new();
    if let Some(sheet) = &request.sheet {
        let of = |k: usize| app.fitted(sheet, None, Some([&request.machines[k], &materials[k]]), progress);
        let (a, b) = (of(0)?.report, of(1)?.report);
        for kind in &a.kinds {
            if let Some(other) = b.kinds.iter().find(|other| other.kind == kind.kind) {
                misfits.push(VersionMisfit {
                    kind: kind.kind,
                    unit: kind.unit,
                    misfits: [kind.before, other.before],
                });
            }
        }
    }
    Ok(CalibrateCompareResponse { machines: request.machines.clone(), materials, values, misfits })
}

fn differing(app: &Installation, kind: Kind, ids: &[String; 2]) -> Result<Vec<ComparedValue>, PlanningError> {
    let [first, second] = ids;
    let (a, b) = (app.library.explain(kind, first)?.values, app.library.explain(kind, second)?.values);
    let mut keys: Vec<&str> = a.iter().chain(&b).map(|value| value.key.as_str()).collect();
    let mut seen = std::collections::BTreeSet::new();
    keys.retain(|key| seen.insert(*key));
    let compared = keys.into_iter().filter_map(|key| {
        let found = [&a, &b].map(|values| values.iter().find(|value| value.key == key));
        let values = found.map(|value| value.map(|value| value.value.clone()).unwrap_or_default());
        (values[0] != values[1]).then(|| ComparedValue {
            kind,
            key: key.to_owned(),
            values,
            sources: found.map(|value| value?.source.clone()),
        })
    });
    Ok(compared.collect())
}
