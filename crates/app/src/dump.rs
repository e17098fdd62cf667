//! `dump`: one stage's value as JSON, for tests and for people who look into a plan.

use nalgebra::Point3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use wirebend_core::plan::WirePlan;
use wirebend_core::wireframe::Wireframe;

use crate::design::{DesignInput, Opened};
use crate::plan::{PlanChoices, Planned};
use crate::report::StepReport;
use crate::{App, AppError, Progress};

/// A stage of the pipeline.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum DumpStage {
    /// The surface that was read.
    Stencil,
    /// The graph that was read.
    Wireframe,
    /// The walk along every edge.
    Route,
    /// The nominal program.
    Program,
    /// Signs and turns of the head.
    Schedule,
    /// What the machine is told.
    Compensated,
    /// The sealed job.
    Job,
}

impl DumpStage {
    /// Every stage, in the order of the pipeline.
    pub const ALL: [Self; 7] = [
        Self::Stencil,
        Self::Wireframe,
        Self::Route,
        Self::Program,
        Self::Schedule,
        Self::Compensated,
        Self::Job,
    ];

    /// The name on the command line.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Stencil => "stencil",
            Self::Wireframe => "wireframe",
            Self::Route => "route",
            Self::Program => "program",
            Self::Schedule => "schedule",
            Self::Compensated => "compensated",
            Self::Job => "job",
        }
    }
}

/// Which stage of what.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct DumpRequest {
    /// The stage.
    pub stage: DumpStage,
    /// The design.
    pub design: DesignInput,
    /// On which machine, and how; not needed for the first two stages.
    pub choices: PlanChoices,
}

/// A stage's value: one entry for each wire from the route on.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct DumpResponse {
    /// The stage.
    pub stage: DumpStage,
    /// Its value.
    pub value: Value,
}

pub(crate) fn dump(
    app: &App,
    request: &DumpRequest,
    progress: &dyn Progress,
) -> Result<DumpResponse, AppError> {
    let stage = request.stage;
    let opened = app.designed(request.design.open(progress)?, &request.choices)?;
    let value = match stage {
        DumpStage::Stencil => stencil(&opened),
        DumpStage::Wireframe => wireframe(&opened),
        _ => {
            let planned = app.plan_design(opened.with_wireframe()?, &request.choices, progress)?;
            of_wires(stage, &planned)?
        }
    };
    Ok(DumpResponse { stage, value })
}

fn point(p: &Point3<f64>) -> Value {
    json!([p.x, p.y, p.z])
}

fn stencil(opened: &Opened) -> Value {
    opened.document.embedded_stencil().map_or(Value::Null, |stencil| {
        json!({
            "vertices_mm": stencil.vertices().iter().map(point).collect::<Vec<_>>(),
            "faces": stencil.faces(),
        })
    })
}

fn wireframe(opened: &Opened) -> Value {
    let wireframe = &opened.document.wireframe;
    let vertex = |(id, vertex): (wirebend_core::wireframe::VertexId, wirebend_core::wireframe::Vertex)| {
        let mut value = json!({ "id": id.0, "at_mm": point(&vertex.position) });
        if vertex.support {
            value["support"] = json!(true);
        }
        value
    };
    json!({
        "vertices": wireframe.vertices().map(vertex).collect::<Vec<_>>(),
        "edges": wireframe.edges().map(|(id, e)| json!({ "id": id.0, "a": e.a.0, "b": e.b.0 })).collect::<Vec<_>>(),
    })
}

fn of_wires(stage: DumpStage, planned: &Planned) -> Result<Value, AppError> {
    let unreached =
        || AppError::StageNotReached { stage: stage.as_str(), report: Box::new(planned.report()) };
    if stage == DumpStage::Job {
        let job = planned.job()?.ok_or_else(unreached)?;
        return Ok(serde_json::from_slice(&job.to_bytes()?)?);
    }
    let wireframe = &planned.opened.document.wireframe;
    let wires: Option<Vec<Value>> =
        planned.wires.iter().map(|wire| of_wire(stage, wireframe, wire)).collect();
    wires.map(Value::Array).ok_or_else(unreached)
}

fn of_wire(stage: DumpStage, wireframe: &Wireframe, plan: &WirePlan) -> Option<Value> {
    let steps = |steps: &[wirebend_core::bend::Step]| {
        let steps: Vec<StepReport> = steps.iter().map(StepReport::from).collect();
        json!(steps)
    };
    Some(match stage {
        DumpStage::Program => {
            let program = plan.nominal.as_ref()?;
            let spans: Vec<[usize; 2]> = program.spans.iter().map(|span| [span.start, span.end]).collect();
            json!({ "steps": steps(&program.steps), "spans": spans })
        }
        DumpStage::Schedule => {
            let scheduled = plan.scheduled.as_ref()?;
            let head: Vec<f64> = scheduled.head.iter().map(|angle| angle.deg()).collect();
            json!({ "steps": steps(&scheduled.steps), "head_deg": head })
        }
        DumpStage::Compensated => json!({
            "steps": steps(plan.compensated.as_ref()?.steps()),
            "stock_mm": plan.stock?.mm(),
            "time_s": plan.seconds?,
        }),
        // The stages before and after the wires are handled by the callers.
        DumpStage::Route | DumpStage::Stencil | DumpStage::Wireframe | DumpStage::Job => {
            let route = plan.route.as_ref()?;
            json!({
                "vertices": route.vertices().iter().map(|id| id.0).collect::<Vec<_>>(),
                "edges": route.traversals.iter().map(|t| t.edge.0).collect::<Vec<_>>(),
                "doubled": plan.doubled.iter().map(|id| id.0).collect::<Vec<_>>(),
                "doubled_mm": plan.doubled_length(wireframe).mm(),
            })
        }
    })
}
