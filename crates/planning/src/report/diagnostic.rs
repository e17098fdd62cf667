//! A finding of the checks: its facts, and the words for them.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Serialize, Serializer};
use wirebend_core::checks::{Code, Diagnostic, Fact, LimitSource, Quantity, Severity};

use super::remedy::RemedyReport;
use super::search::UnfoundReport;
use crate::text;

/// How bad a finding is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum SeverityName {
    /// The machine cannot bend the wire.
    Error,
    /// Near a limit, or the result may differ from the design.
    Warning,
    /// Worth knowing; nothing is wrong.
    Info,
}

impl From<Severity> for SeverityName {
    fn from(severity: Severity) -> Self {
        match severity {
            Severity::Error => Self::Error,
            Severity::Warning => Self::Warning,
            Severity::Info => Self::Info,
        }
    }
}

/// A finding: what is wrong or worth knowing.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct DiagnosticReport {
    /// The kind of finding: a name that stays the same.
    #[serde(serialize_with = "code_name")]
    #[schemars(with = "CodeSchema")]
    pub code: Code,
    /// How bad it is.
    pub severity: SeverityName,
    /// The vertex that it is about foremost.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vertex: Option<u32>,
    /// The edge that it is about foremost.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub edge: Option<u32>,
    /// The step of the program, counted from 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step: Option<usize>,
    /// All its vertices, where there are several.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub vertices: Vec<u32>,
    /// All its edges, where there are several.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub edges: Vec<u32>,
    /// The body of the machine that the wire hits, as its profile calls it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body: Option<String>,
    /// What was measured, in `unit`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub value: Option<f64>,
    /// The limit, in `unit`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit: Option<f64>,
    /// The unit of value and limit: `mm`, `deg`, `mpa`, or none for a count and for a share.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unit: Option<&'static str>,
    /// Where the limit comes from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit_source: Option<String>,
    /// Why the limit is what it is, where its profile or driver says so: `limit_source` without what it stands in.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit_reason: Option<String>,
    /// What it says, with its figures: a sentence without a full stop.
    pub message: String,
    /// What to do: the remedies in words.
    pub help: String,
    /// What can be done about it, the most promising first.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub remedies: Vec<RemedyReport>,
    /// Of a search that has found no program without a collision: what was in its way, and what helps.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub search: Option<UnfoundReport>,
}

impl From<&Diagnostic> for DiagnosticReport {
    fn from(diagnostic: &Diagnostic) -> Self {
        let several = |ids: Vec<u32>| if ids.len() > 1 { ids } else { Vec::new() };
        let vertices: Vec<u32> = diagnostic.location.vertices.iter().map(|id| id.0).collect();
        let edges: Vec<u32> = diagnostic.location.edges.iter().map(|id| id.0).collect();
        let (measured, limit) = (diagnostic.measured(), diagnostic.limit());
        Self {
            code: diagnostic.code(),
            severity: diagnostic.severity.into(),
            vertex: vertices.first().copied(),
            edge: edges.first().copied(),
            step: diagnostic.location.step,
            vertices: several(vertices),
            edges: several(edges),
            body: match &diagnostic.fact {
                Fact::MeetsMachine { body, .. } => Some(body.clone()),
                Fact::NoClearProgram { body, .. } => body.clone(),
                _ => None,
            },
            value: measured.map(|measured| number(measured).0),
            limit: limit.map(|limit| number(limit.value).0),
            unit: measured.or(limit.map(|limit| limit.value)).and_then(|q| number(q).1),
            limit_source: limit.map(|limit| text::shown(|| text::source(limit.source))),
            limit_reason: limit.and_then(|limit| match limit.source {
                LimitSource::Stated(source) => source.reason.clone(),
                _ => None,
            }),
            message: text::shown(|| text::message(diagnostic)),
            help: text::shown(|| text::help(diagnostic)),
            remedies: diagnostic.remedies.iter().map(RemedyReport::from).collect(),
            search: UnfoundReport::of(&diagnostic.fact),
        }
    }
}

#[allow(clippy::cast_precision_loss)] // counts are far below 2^52
fn number(quantity: Quantity) -> (f64, Option<&'static str>) {
    match quantity {
        Quantity::Length(length) => (length.mm(), Some("mm")),
        Quantity::Angle(angle) => (angle.deg(), Some("deg")),
        Quantity::Count(count) => (count as f64, None),
        Quantity::Stress(mpa) => (mpa, Some("mpa")),
        Quantity::Ratio(ratio) => (ratio, None),
    }
}

#[allow(clippy::trivially_copy_pass_by_ref)] // serde passes a reference
fn code_name<S: Serializer>(code: &Code, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(code.as_str())
}

/// The codes as a list in the schema, of which generated types are a union: a front end without words for one of them
/// does not compile.
struct CodeSchema;

impl JsonSchema for CodeSchema {
    fn schema_name() -> Cow<'static, str> {
        "DiagnosticCode".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let codes: Vec<&str> = Code::ALL.iter().map(|code| code.as_str()).collect();
        json_schema!({
            "description": "The kind of a finding: a name that stays the same.",
            "type": "string",
            "enum": codes
        })
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;
    use wirebend_core::checks::{Location, Remedy};
    use wirebend_core::units::Length;
    use wirebend_core::wireframe::{EdgeId, VertexId};

    use super::*;

    /// Scripts read these keys, and front ends choose by code and remedy.
    #[test]
    fn a_finding_is_facts_and_words_side_by_side() {
        let mm = |value| Length::from_mm(value).unwrap();
        let odd = Diagnostic {
            severity: Severity::Error,
            location: Location::at_vertices([VertexId(3), VertexId(8)]),
            fact: Fact::NoEulerPath { odd: 4, allowed: 2 },
            remedies: vec![Remedy::DoubleEdges {
                edges: vec![EdgeId(5)],
                added: mm(70.0),
                design: mm(140.0),
            }],
        };
        let expected = json!({
            "code": "no_euler_path",
            "severity": "error",
            "vertex": 3,
            "vertices": [3, 8],
            "value": 4.0,
            "limit": 2.0,
            "limit_source": "Euler: only the ends of wires may be odd",
            "message": "needs more than one wire (4 odd corners)",
            "help": "run the wire along 1 edge twice: that adds 70.0 mm (50.0 % of the design), the least possible",
            "remedies": [{"remedy": "double_edges", "edges": [5], "added_mm": 70.0, "design_mm": 140.0}]
        });
        assert_eq!(serde_json::to_value(DiagnosticReport::from(&odd)).unwrap(), expected);
    }
}
