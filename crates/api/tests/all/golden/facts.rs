//! What is known of a case from elsewhere, held against what comes out.

use std::collections::BTreeMap;

use serde::Deserialize;
use wirebend_api::{Command, PlanReport, PlanRequest, Response};

use crate::cases::{Case, run};

/// What others have worked out.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Facts {
    /// Where the numbers come from.
    because: String,
    #[serde(default = "one")]
    wires: usize,
    vertices: Option<usize>,
    edges: Option<usize>,
    odd_vertices: Option<usize>,
    feeds: Option<usize>,
    bends: Option<usize>,
    doubled_edges: Option<usize>,
    /// Designed length, with its tolerance.
    length_mm: Option<(f64, f64)>,
    /// Time on the $293 bender, with its tolerance.
    time_s: Option<(f64, f64)>,
    /// Cost on the $293 bender, with its tolerance.
    cost: Option<(f64, f64)>,
    /// Whether each machine can make it.
    #[serde(default)]
    feasible: BTreeMap<String, bool>,
    /// Codes that the checks of a machine must say, how often.
    #[serde(default)]
    says: BTreeMap<String, BTreeMap<String, usize>>,
}

fn one() -> usize {
    1
}

impl Case {
    pub fn plan(&self, machine: &str) -> PlanReport {
        let request = PlanRequest {
            design: self.input(),
            choices: self.choices(machine),
            output: None,
            make_job: false,
            pauses: Vec::new(),
            despite_errors: true,
        };
        match run(&Command::Plan(request)) {
            Ok(Response::Plan(found)) => found.report,
            other => panic!("{}: {other:?}", self.about),
        }
    }

    pub fn assert_facts(&self) {
        let facts = Facts::deserialize(&self.facts).unwrap_or_else(|error| panic!("{}: {error}", self.about));
        let kit = self.plan("wirebend-kit");
        let (about, because) = (&self.about, &facts.because);
        let same = |name: &str, found: Option<usize>, fact: Option<usize>| {
            if fact.is_some() {
                assert_eq!(found, fact, "{about}: {name}; {because}");
            }
        };
        let near = |name: &str, found: Option<f64>, fact: Option<(f64, f64)>| {
            if let Some((value, tolerance)) = fact {
                let found = found.unwrap_or(f64::NAN);
                assert!(
                    (found - value).abs() <= tolerance,
                    "{about}: {name} is {found}, not {value}; {because}"
                );
            }
        };
        let wires = kit.wires();
        assert_eq!(wires.len(), facts.wires, "{about}: wires; {because}");
        let sum = |of: fn(&wirebend_api::WireReport) -> usize| Some(wires.iter().map(of).sum());
        same("vertices", sum(|wire| wire.wireframe.vertices), facts.vertices);
        same("edges", sum(|wire| wire.wireframe.edges), facts.edges);
        same("odd vertices", sum(|wire| wire.wireframe.odd_vertices), facts.odd_vertices);
        let route = |wire: &wirebend_api::WireReport| wire.route.as_ref().map(|route| route.feeds);
        same("feeds", wires.iter().map(route).sum(), facts.feeds);
        let bends = |wire: &wirebend_api::WireReport| wire.program.as_ref().map(|program| program.bends);
        same("bends", wires.iter().map(bends).sum(), facts.bends);
        let doubled = |wire: &wirebend_api::WireReport| wire.route.as_ref().map(|route| route.doubled_edges);
        same("doubled edges", wires.iter().map(doubled).sum(), facts.doubled_edges);
        let length = |wire: &wirebend_api::WireReport| wire.route.as_ref().map(|route| route.length_mm);
        near("length", wires.iter().map(length).sum(), facts.length_mm);
        near("time", wires.iter().map(|wire| wire.time_s).sum(), facts.time_s);
        // Published prices are of designed lengths; ours are of what is fed, at the same price a millimetre.
        let cost = |wire: &wirebend_api::WireReport| {
            let fed = wire.compensated.as_ref()?.feed_mm;
            Some(wire.cost? / fed * wire.route.as_ref()?.length_mm)
        };
        near("cost", wires.iter().map(cost).sum(), facts.cost);
        for (machine, &feasible) in &facts.feasible {
            assert_eq!(self.plan(machine).feasible(), feasible, "{about} on {machine}; {because}");
        }
        for (machine, codes) in &facts.says {
            let plan = self.plan(machine);
            let of_wires = plan.wires().iter().flat_map(|wire| &wire.diagnostics);
            let said: Vec<&str> =
                plan.diagnostics().iter().chain(of_wires).map(|d| d.code.as_str()).collect();
            for (code, &times) in codes {
                let found = said.iter().filter(|said| *said == code).count();
                assert_eq!(found, times, "{about} on {machine}: {code}; {because}");
            }
        }
    }
}
