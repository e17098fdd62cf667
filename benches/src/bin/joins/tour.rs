//! From a wireframe to its route: the times of one, with that of its file's text apart, and the bends beyond what a machine makes beside those of a random walk.

use std::path::Path;
use std::time::Instant;

use anyhow::{Context, Result};
use rand::seq::SliceRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::json;
use wirebend_core::route::{Route, RouteOptions, doubling, forced_bends, route};
use wirebend_core::units::Angle;
use wirebend_core::wireframe::{Component, EdgeId, VertexId, Wireframe};
use wirebend_files::read::{Format, ReadOptions, read};

use crate::peak_mib;

/// What the $293 bender makes.
const MAX_BEND_DEG: f64 = 155.0;
/// So many random walks are averaged.
const WALKS: u32 = 20;

/// One wireframe: prints its figures.
pub fn one(file: &str) -> Result<()> {
    let bytes = std::fs::read(file).with_context(|| file.to_owned())?;
    let started = Instant::now();
    let mut since = started;
    let mut took = || {
        let ms = since.elapsed().as_secs_f64() * 1000.0;
        since = Instant::now();
        ms
    };
    let name = Path::new(file).file_name().and_then(|name| name.to_str()).context("a file without a name")?;
    let options = ReadOptions { face_edges: true, ..ReadOptions::default() };
    let wireframe = read(&bytes, name, Some(Format::Obj), &options)?.wireframe;
    drop(bytes);
    let text_ms = took();
    let component = wireframe.components().into_iter().next().context("no part")?;
    let read_ms = took();
    let max_bend = Some(Angle::from_deg(MAX_BEND_DEG)?);
    let mut figures = json!({ "edges": component.edges.len(), "text_ms": text_ms, "read_ms": read_ms });
    for closed in [true, false] {
        took();
        let doubled = doubling(&wireframe, &component, None, closed)?.edges;
        let join_ms = took();
        let options = RouteOptions { doubled, closed, max_bend, ..RouteOptions::default() };
        let found = route(&wireframe, &component, &options)?;
        let tour_ms = took();
        let forced = forced_bends(&wireframe, &component, &options)?.len();
        let mut random = ChaCha8Rng::seed_from_u64(1);
        let walks = if component.edges.len() > 20_000 { 1 } else { WALKS };
        let sharp: usize = (0..walks)
            .map(|_| sharp_bends(&wireframe, &walk(&wireframe, &component, &options.doubled, &mut random)))
            .sum();
        figures[if closed { "closed" } else { "open" }] = json!({
            "join_ms": join_ms, "tour_ms": tour_ms, "sharp": sharp_bends(&wireframe, &vertices_and_edges(&found)),
            "forced": forced, "sharp_at_random": f64::from(u32::try_from(sharp)?) / f64::from(walks),
        });
    }
    figures["peak_mib"] = json!(peak_mib()?);
    println!("{figures}");
    Ok(())
}

fn vertices_and_edges(route: &Route) -> Vec<(EdgeId, VertexId)> {
    route.traversals.iter().map(|traversal| (traversal.edge, traversal.from)).collect()
}

/// Hierholzer's algorithm, which takes any edge that is left: each edge with the vertex that it is left from.
fn walk(
    wireframe: &Wireframe,
    component: &Component,
    doubled: &[EdgeId],
    random: &mut ChaCha8Rng,
) -> Vec<(EdgeId, VertexId)> {
    let index = |vertex: VertexId| component.vertices.binary_search(&vertex).unwrap_or_default();
    let copies: Vec<EdgeId> = component.edges.iter().chain(doubled).copied().collect();
    let mut at: Vec<Vec<usize>> = vec![Vec::new(); component.vertices.len()];
    let ends: Vec<[VertexId; 2]> =
        copies.iter().filter_map(|&edge| wireframe.edge(edge)).map(|edge| [edge.a, edge.b]).collect();
    for (copy, ends) in ends.iter().enumerate() {
        for &end in ends {
            at[index(end)].push(copy);
        }
    }
    for list in &mut at {
        list.shuffle(random);
    }
    let odd: Vec<usize> = (0..at.len()).filter(|&vertex| at[vertex].len() % 2 == 1).collect();
    let first = odd.first().copied().unwrap_or_else(|| random.random_range(0..at.len()));
    let mut used = vec![false; copies.len()];
    let mut stack: Vec<(usize, Option<usize>)> = vec![(first, None)];
    let mut walk = Vec::with_capacity(copies.len());
    while let Some(&(vertex, came)) = stack.last() {
        while at[vertex].last().is_some_and(|&copy| used[copy]) {
            at[vertex].pop();
        }
        if let Some(copy) = at[vertex].pop() {
            used[copy] = true;
            let [a, b] = ends[copy].map(index);
            stack.push((if a == vertex { b } else { a }, Some(copy)));
        } else {
            stack.pop();
            walk.extend(came.map(|copy| (copies[copy], component.vertices[vertex])));
        }
    }
    walk
}

/// How many bends of a walk are beyond what the machine makes.
fn sharp_bends(wireframe: &Wireframe, walk: &[(EdgeId, VertexId)]) -> usize {
    let out = |&(edge, from): &(EdgeId, VertexId)| wireframe.direction(edge, from);
    let bend = |pair: &[(EdgeId, VertexId)]| Some(out(&pair[0])?.angle(&out(&pair[1])?).to_degrees());
    walk.windows(2).filter_map(bend).filter(|&bend| bend > MAX_BEND_DEG + 1e-9).count()
}
