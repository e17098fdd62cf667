//! The report of a planned wire.

use std::collections::BTreeMap;

use wirebend_accuracy::Resources;
use wirebend_core::plan::WirePlan;
use wirebend_core::units::Length;
use wirebend_core::wireframe::{EdgeId, Wireframe};
use wirebend_files::document::JobPause;

use crate::machine::Setup;
use crate::report::{
    CompensatedReport, DiagnosticReport, JobStep, ProgramReport, RouteReport, SagReport, SearchReport,
    WireReport, WireframeReport,
};

impl WireReport {
    /// The report of a planned wire.
    pub fn new(
        wireframe: &Wireframe,
        components: usize,
        plan: &WirePlan,
        pauses: &[JobPause],
        setup: &Setup,
        timings_ms: BTreeMap<&'static str, f64>,
    ) -> Self {
        let fed = plan.compensated.as_ref().map(wirebend_core::compensate::CompensatedProgram::feed_total);
        let wire = &setup.model.wire;
        let ids = |edges: &[EdgeId]| edges.iter().map(|id| id.0).collect();
        let length_of = |edges: &mut dyn Iterator<Item = EdgeId>| -> Length {
            edges.map(|edge| wireframe.edge_length(edge)).sum()
        };
        let doubled = plan.doubled_length(wireframe);
        let formed = fed.map(|fed| Resources { wire_g: wire.mass_g(fed), joints_g: 0.0 });
        let process_energy_kj =
            formed.zip(setup.process_energy_kj_per_g).map(|(used, each)| used.energy_kj(each));
        Self {
            wireframe: WireframeReport {
                vertices: plan.component.vertices.len(),
                edges: plan.component.edges.len(),
                components,
                odd_vertices: wireframe.odd_vertices(&plan.component, &[]).len(),
            },
            route: plan.route.as_ref().map(|route| RouteReport {
                feeds: route.traversals.len(),
                length_mm: length_of(&mut route.traversals.iter().map(|t| t.edge)).mm(),
                doubled_edges: plan.doubled.len(),
                doubled_mm: doubled.mm(),
                optimal: plan.is_cheapest && plan.proposal.is_matched_by(doubled),
                doubled: ids(&plan.doubled),
                beside: ids(&plan.beside),
                beside_mm: plan.length_beside(wireframe).mm(),
                vertices: route.vertices().iter().map(|id| id.0).collect(),
                edges: route.traversals.iter().map(|t| t.edge.0).collect(),
            }),
            program: plan.nominal.as_ref().map(|program| ProgramReport {
                bends: program.bend_count(),
                steps: program.steps.iter().copied().map(JobStep::from).collect(),
            }),
            compensated: plan.compensated.as_ref().zip(plan.stock).map(|(program, stock)| {
                CompensatedReport {
                    steps: program.told().map(JobStep::from).collect(),
                    feed_mm: program.feed_total().mm(),
                    stock_mm: stock.mm(),
                }
            }),
            diagnostics: plan.diagnostics.iter().map(DiagnosticReport::from).collect(),
            feasible: plan.is_feasible(),
            collisions_checked: plan.contacts.is_some(),
            // The wires of a part were searched for together: the first has what came of it, as it has the times.
            search: plan.searched.as_ref().filter(|_| !timings_ms.is_empty()).map(SearchReport::from),
            sag: plan.sag.map(SagReport::from),
            pauses: pauses.to_vec(),
            time_s: plan.seconds,
            cost: fed.and_then(|fed| wire.cost(fed)),
            stock_cost: plan.stock.and_then(|stock| wire.cost(stock)),
            currency: setup.currency.clone(),
            mass_g: fed.map(|fed| wire.mass_g(fed)),
            stock_mass_g: plan.stock.map(|stock| wire.mass_g(stock)),
            process_energy_kj,
            process_time_min: process_energy_kj.map(Resources::time_min),
            timings_ms,
        }
    }
}
