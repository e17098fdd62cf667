//! `dump`: one stage's value as JSON, for tests and for people who look into a plan.

use nalgebra::Point3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use wirebend_core::mesh::Stencil;
use wirebend_core::plan::WirePlan;
use wirebend_core::wireframe::Wireframe;
use wirebend_files::document::JointFile;

use crate::choices::PlanChoices;
use crate::design::{DesignInput, Opened};
use crate::plan::Planned;
use crate::report::JobStep;
use crate::stage::StageName;
use crate::{Installation, PlanningError, Progress};

/// Which stage of what.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct DumpRequest {
    pub stage: StageName,
    pub design: DesignInput,
    /// On which machine, and how; not needed for the first two stages.
    pub choices: PlanChoices,
}

/// A stage's value: one entry for each wire from the route on.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct DumpResponse {
    pub stage: StageName,
    pub value: Value,
}

pub fn dump(
    app: &Installation,
    request: &DumpRequest,
    progress: &dyn Progress,
) -> Result<DumpResponse, PlanningError> {
    let stage = request.stage;
    let opened =
        app.designed(request.design.open_with(app, &request.choices, progress)?, &request.choices)?;
    let value = match stage {
        StageName::Stencil => stencil(&opened),
        StageName::Wireframe => wireframe(&opened),
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
    let stencil: Stencil = opened.document.surfaces_in_place().collect();
    if stencil.vertices().is_empty() {
        return Value::Null;
    }
    json!({
        "vertices_mm": stencil.vertices().iter().map(point).collect::<Vec<_>>(),
        "faces": stencil.faces(),
    })
}

fn wireframe(opened: &Opened) -> Value {
    let wireframe = &opened.document.wireframe;
    let vertex = |(id, vertex): (wirebend_core::wireframe::VertexId, wirebend_core::wireframe::Vertex)| {
        let mut value = json!({ "id": id.0, "at_mm": point(&vertex.position) });
        if vertex.support {
            value["support"] = json!(true);
        }
        if let Some(joint) = vertex.joint {
            value["joint"] = json!(JointFile::from(joint));
        }
        value
    };
    let edge = |(id, edge): (wirebend_core::wireframe::EdgeId, wirebend_core::wireframe::Edge)| {
        let mut value = json!({ "id": id.0, "a": edge.a.0, "b": edge.b.0 });
        if edge.ceiling {
            value["ceiling"] = json!(true);
        }
        value
    };
    json!({
        "vertices": wireframe.vertices().map(vertex).collect::<Vec<_>>(),
        "edges": wireframe.edges().map(edge).collect::<Vec<_>>(),
    })
}

fn of_wires(stage: StageName, planned: &Planned) -> Result<Value, PlanningError> {
    let unreached = || PlanningError::StageNotReached { stage, report: Box::new(planned.report()) };
    if stage == StageName::Job {
        let job = planned.job()?.ok_or_else(unreached)?;
        return Ok(serde_json::from_slice(&job.to_bytes()?)?);
    }
    let wireframe = &planned.opened.document.wireframe;
    let wires: Option<Vec<Value>> =
        planned.wires.iter().map(|wire| of_wire(stage, wireframe, wire)).collect();
    wires.map(Value::Array).ok_or_else(unreached)
}

fn of_wire(stage: StageName, wireframe: &Wireframe, plan: &WirePlan) -> Option<Value> {
    let steps = |steps: &[wirebend_core::bend::Step]| {
        let steps: Vec<JobStep> = steps.iter().copied().map(JobStep::from).collect();
        json!(steps)
    };
    Some(match stage {
        StageName::Program => {
            let program = plan.nominal.as_ref()?;
            let spans: Vec<[usize; 2]> = program.spans.iter().map(|span| [span.start, span.end]).collect();
            json!({ "steps": steps(&program.steps), "spans": spans })
        }
        StageName::Schedule => {
            let scheduled = plan.scheduled.as_ref()?;
            let head: Vec<f64> = scheduled.head.iter().map(|angle| angle.deg()).collect();
            json!({ "steps": steps(&scheduled.steps), "head_deg": head })
        }
        StageName::Compensated => json!({
            "steps": plan.compensated.as_ref()?.told().map(JobStep::from).collect::<Vec<_>>(),
            "stock_mm": plan.stock?.mm(),
            "time_s": plan.seconds?,
        }),
        // The stages before and after the wires are handled by the callers.
        StageName::Route | StageName::Stencil | StageName::Wireframe | StageName::Job => {
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
