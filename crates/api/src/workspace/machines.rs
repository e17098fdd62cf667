//! Machines to choose from: what they look like and can do, what changes with another one, and a person's own.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use wirebend_planning::bodies::{peg_top_mm, pivot_mm};
use wirebend_planning::curves::MachineEdges;
use wirebend_planning::profiles::set::replace;
use wirebend_profile::{Kind, Shape};

use super::Workspace;
use crate::{ApiError, CompareRequest, CompareResponse, PlanChoices, ProblemReport, Progress};

/// Asks for one machine.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct MachineViewRequest {
    /// Its id.
    pub machine: String,
}

/// A setting of the machine's driver.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SettingValue {
    pub key: String,
    pub value: Value,
    /// The profile that sets it; null where it is the driver's default.
    pub set_by: Option<String>,
    /// The file of that profile.
    pub file: Option<String>,
    /// The line in it, from 1.
    pub line: Option<usize>,
}

#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MachineViewResponse {
    pub id: String,
    pub name: String,
    pub description: String,
    /// Whether it comes with the program: then it cannot be changed, but copied.
    pub shipped: bool,
    /// Its profile.
    pub file: String,
    /// The profile that it inherits from.
    pub inherits: Option<String>,
    pub driver: String,
    /// Why its driver cannot be used; null where it can.
    pub driver_problem: Option<ProblemReport>,
    /// Largest bends to both sides, degrees.
    pub bend_deg: [f64; 2],
    /// Shortest designed edge, mm.
    pub min_edge_mm: f64,
    /// Shortest edge beside a bend of 90°, mm, with the machine's own wire, wherever it is in the wire: a bend takes a part of it, and
    /// the feed has a limit too. Null where that is not known.
    pub min_edge_between_mm: Option<f64>,
    /// Shortest feed, mm.
    pub min_feed_mm: f64,
    /// How far the head turns to both sides, degrees.
    pub rotation_deg: [f64; 2],
    /// Thinnest and thickest wire, mm.
    pub diameter_mm: [f64; 2],
    /// Longest stock, mm; null: no limit.
    pub max_stock_mm: Option<f64>,
    /// Speeds: feed in mm/s, rotate and bend in degrees/s.
    pub rates: [f64; 3],
    /// Whether its bend head was measured on the machine itself, by a person or by calibrating; null where it has no peg.
    pub head_measured: Option<bool>,
    /// Its bodies. Frame: the origin is where a bend begins, x the way the wire leaves, z the bend axis.
    pub shapes: Vec<Shape>,
    /// A point of the axis about which the peg goes, mm, in the same frame.
    pub pivot_mm: [f64; 3],
    /// How far the peg reaches beyond the middle of the wire along the bend axis while it is out, mm.
    pub peg_top_mm: f64,
    /// The JSON Schema of its driver's settings; null where the driver cannot be asked.
    pub settings_schema: Option<Value>,
    /// Its driver's settings, those at their default included.
    pub settings: Vec<SettingValue>,
}

/// Plans the open design for other machines and says what changes.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct CompareDesign {
    /// The other machines.
    pub against: Vec<String>,
}

/// Changes the driver's settings in a profile of the person's own.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ChangeSettings {
    pub machine: String,
    /// All settings that the profile is to set; what is left out is its parent's, or the driver's default.
    pub settings: Map<String, Value>,
}

/// The machine with other settings.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SettingsChanged {
    /// The profile that was written.
    pub file: PathBuf,
    pub machine: MachineViewResponse,
}

impl Workspace {
    pub(crate) fn machine_view(
        &self,
        asked: &MachineViewRequest,
        progress: &dyn Progress,
    ) -> Result<MachineViewResponse, ApiError> {
        progress.stage("asking the driver");
        let app = self.installation();
        let machine = app.library.machine(&asked.machine)?;
        let figures = machine.figures()?;
        let explained = app.library.explain(Kind::Machine, &asked.machine)?;
        let profile = &machine.profile;
        let driver = profile.driver.id.clone().unwrap_or_default();
        let started = app.driver(&driver);
        let schema = started.as_ref().ok().map(|driver| driver.description().settings_schema.clone());
        let own = explained.chain.first();
        let mut settings: Vec<SettingValue> = explained
            .values
            .iter()
            .filter_map(|value| {
                let key = value.key.strip_prefix("driver.settings.")?.to_owned();
                Some(SettingValue {
                    key,
                    value: value.value.clone(),
                    set_by: Some(value.id.clone()),
                    file: Some(value.place.file.clone()),
                    line: value.place.line,
                })
            })
            .collect();
        let defaults = schema.as_ref().and_then(|schema| schema["properties"].as_object());
        for (key, property) in defaults.into_iter().flatten() {
            if let Some(value) =
                property.get("default").filter(|_| settings.iter().all(|one| one.key != *key))
            {
                let (key, value) = (key.clone(), value.clone());
                settings.push(SettingValue { key, value, set_by: None, file: None, line: None });
            }
        }
        let limits = &figures.limits;
        Ok(MachineViewResponse {
            id: asked.machine.clone(),
            name: profile.name.clone().unwrap_or_else(|| asked.machine.clone()),
            description: profile.description.clone().unwrap_or_default(),
            shipped: own.is_some_and(|own| own.shipped),
            file: own.map(|own| own.file.clone()).unwrap_or_default(),
            inherits: explained.chain.get(1).map(|parent| parent.id.clone()),
            driver_problem: started.as_ref().err().map(ProblemReport::from),
            driver,
            bend_deg: [limits.min_bend_deg, limits.max_bend_deg],
            min_edge_mm: limits.min_edge_mm,
            min_edge_between_mm: app
                .setup(&asked.machine, None)
                .ok()
                .map(|setup| MachineEdges::of(&setup.model).shortest_edge_mm),
            min_feed_mm: limits.min_feed_mm,
            rotation_deg: [limits.min_rotation_deg, limits.max_rotation_deg],
            diameter_mm: [figures.min_diameter_mm, figures.max_diameter_mm],
            max_stock_mm: limits.max_stock_mm,
            rates: [figures.feed_rate_mm_per_s, figures.rotate_rate_deg_per_s, figures.bend_rate_deg_per_s],
            head_measured: profile.head_measured(),
            peg_top_mm: peg_top_mm(profile.shapes.as_deref().unwrap_or_default()),
            shapes: profile.shapes.clone().unwrap_or_default(),
            pivot_mm: [pivot_mm(&figures), 0.0, 0.0],
            settings_schema: schema,
            settings,
        })
    }

    pub(crate) fn compare(
        &self,
        asked: &CompareDesign,
        progress: &dyn Progress,
    ) -> Result<CompareResponse, ApiError> {
        let request = CompareRequest {
            design: self.as_input()?,
            choices: PlanChoices::default(),
            against: asked.against.clone(),
        };
        Ok(wirebend_planning::compare::compare(&self.installation(), &request, progress)?)
    }

    pub(crate) fn change_settings(
        &self,
        asked: &ChangeSettings,
        progress: &dyn Progress,
    ) -> Result<SettingsChanged, ApiError> {
        let settings = Some(&asked.settings).filter(|settings| !settings.is_empty());
        let settings = settings.map(|settings| Value::Object(settings.clone()));
        let of = (Kind::Machine, asked.machine.as_str());
        let file = replace(&self.installation(), of, "driver.settings", settings)?;
        self.reload()?;
        let machine = self.machine_view(&MachineViewRequest { machine: asked.machine.clone() }, progress)?;
        Ok(SettingsChanged { file, machine })
    }
}
