//! Sequences and layers of frames that others have built.

use std::ops::ControlFlow;

use anyhow::{Result, ensure};
use wirebend_benches::timed;
use wirebend_core::wireframe::{Vertex, VertexId, Wireframe};
use wirebend_frame::Model;
use wirebend_sequence::{
    GivenStep, Groups, LayerOptions, SearchOptions, Structure, Task, layers, search, search_by_paper,
};

use wirebend_benches::frames::{brute, built, models};

/// What is wanted, and what `FrameFab`'s authors needed, s.
struct Aims {
    search: f64,
    /// With layers.
    paper: Option<f64>,
    layers: f64,
    paper_layers: Option<f64>,
}

const SMALL: Aims = Aims { search: 0.7, paper: Some(38.0), layers: 0.05, paper_layers: Some(3.02) };
const LARGE: Aims = Aims { search: 4.0, paper: None, layers: f64::INFINITY, paper_layers: None };

pub fn measure() -> Result<()> {
    let [(bunny, of_bunny), (c_shape, of_c_shape)] = built::both();
    one(bunny, &of_bunny, &SMALL)?;
    one(
        c_shape,
        &of_c_shape,
        &Aims { paper: Some(40.0), layers: f64::INFINITY, paper_layers: None, ..SMALL },
    )?;
    // The authors' own fertility has 316 nodes and 911 struts.
    one("fertility", &structure(&models::fertility()?)?, &Aims { paper: Some(969.0), ..LARGE })?;
    one("duck", &structure(&models::duck()?)?, &LARGE)
}

/// The same frame as a design whose edges are its members.
pub fn structure(model: &Model) -> Result<Structure> {
    let mut made = Wireframe::new();
    for (node, at) in model.nodes.iter().enumerate() {
        let support = model.supports.iter().any(|support| support.node.0 == node);
        made.add_vertex(Vertex { support, ..Vertex::at(*at) })?;
    }
    for member in &model.members {
        let [a, b] = [member.a, member.b].map(|node| u32::try_from(node.0).map(VertexId));
        made.add_edge(a?, b?)?;
    }
    Ok(Structure::new(&made)?)
}

fn one(name: &str, structure: &Structure, aims: &Aims) -> Result<()> {
    let (builder, weight, groups) = (built::builder(), built::abs(), Groups::single(structure));
    let task = Task { structure, groups: &groups, builder: &builder, weight: &weight };
    let goes_on = &mut |_: &_| ControlFlow::Continue(());
    let (ms, outcome) = timed(3, || Ok(search(&task, &SearchOptions::default(), goes_on)?))?;
    let seconds = ms / 1000.0;
    let confirm = |outcome: &wirebend_sequence::Outcome| -> Result<()> {
        ensure!(outcome.is_found(), "{name}: {:?}", outcome.obstacle);
        let given: Vec<GivenStep> =
            outcome.steps.iter().map(|step| GivenStep::of(step, structure, &builder)).collect();
        let faults = brute::faults(&task, &given);
        ensure!(faults.is_empty(), "{name}: {faults:?}");
        Ok(())
    };
    confirm(&outcome)?;
    print!(
        "{name}, {} struts: a sequence in {seconds:.2} s (at most {} wanted)",
        structure.struts().len(),
        aims.search
    );
    if let Some(paper) = aims.paper {
        print!(", the authors of FrameFab {paper} s, {:.0}x (50x wanted)", paper / seconds);
    }
    let (ms, layer) = timed(3, || Ok(layers(&task, &[], &LayerOptions::default())?))?;
    let count = layer.iter().max().map_or(0, |top| top + 1);
    print!("; {count} layers in {ms:.0} ms");
    if aims.layers.is_finite() {
        print!(" (at most {:.0} wanted)", 1000.0 * aims.layers);
    }
    if let Some(paper) = aims.paper_layers {
        print!(", the authors {paper} s, {:.0}x", 1000.0 * paper / ms);
    }
    if structure.struts().len() < 500 {
        let goes_on = &mut |_: &_| ControlFlow::Continue(());
        let (ms, outcome) = timed(3, || Ok(search_by_paper(&task, &layer, 1000, goes_on)?))?;
        confirm(&outcome)?;
        print!("; by their cost in {:.2} s", ms / 1000.0);
    }
    println!("; confirmed by brute force");
    Ok(())
}
