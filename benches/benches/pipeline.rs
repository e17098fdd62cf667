//! The pipeline in process: whole, and the stages that a peer can be asked for too.

#![allow(missing_docs)] // criterion's macros make public functions
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a benchmark may stop at what cannot be

use std::f64::consts::{PI, TAU};
use std::hint::black_box;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, criterion_group, criterion_main};
use integer_blossom::min_weight_perfect_matching;
use nalgebra::{Point3, Vector3};
use wirebend_api::{
    Command, DesignInput, EventSink, Input, Installation, NoProgress, Places, PlanChoices, PlanRequest,
    Response, WindowEvent, Workspace,
};
use wirebend_core::route::{RouteOptions, doubling, route};
use wirebend_core::wireframe::{Vertex, VertexId, Wireframe};
use wirebend_files::read::{ReadOptions, read};
use wirebend_postman::cheapest_pairs;

fn example(name: &str) -> Vec<u8> {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../examples").join(name);
    std::fs::read(path).unwrap()
}

fn planning(name: &str, bytes: Vec<u8>, face_edges: bool, double: bool) -> Command {
    let input = Input::Bytes { name: name.to_owned(), bytes };
    let design = DesignInput { input, face_edges, ..DesignInput::file(PathBuf::new()) };
    let machine = Some("wirebend-kit".to_owned());
    let choices = PlanChoices { machine, double, ..PlanChoices::default() };
    Command::Plan(PlanRequest {
        design,
        choices,
        output: None,
        make_job: false,
        pauses: Vec::new(),
        despite_errors: true,
    })
}

/// A column of triangles: rings of `around` vertices, every vertex of degree 4 or 6 but for the rims, so
/// that one wire runs through all of it.
fn column(rings: u32, around: u32) -> Wireframe {
    let mut w = Wireframe::new();
    for ring in 0..rings {
        for k in 0..around {
            let turn = (f64::from(k) + 0.5 * f64::from(ring % 2)) / f64::from(around) * TAU;
            let at = Point3::new(150.0 * turn.cos(), 150.0 * turn.sin(), 60.0 * f64::from(ring));
            w.add_vertex(Vertex::at(at)).unwrap();
        }
    }
    let at = |ring: u32, k: u32| VertexId(ring * around + k % around);
    for ring in 0..rings {
        for k in 0..around {
            w.add_edge(at(ring, k), at(ring, k + 1)).unwrap();
            if ring + 1 < rings {
                let shift = ring % 2;
                w.add_edge(at(ring, k), at(ring + 1, k + shift)).unwrap();
                w.add_edge(at(ring, k), at(ring + 1, k + shift + around - 1)).unwrap();
            }
        }
    }
    w
}

fn whole_pipeline(c: &mut Criterion) {
    let app = Installation::new(&[]).unwrap();
    let mut group = c.benchmark_group("plan");
    group.measurement_time(Duration::from_secs(5));
    let bunny = planning("bunny.obj", example("bunny.obj"), true, true);
    group.bench_function("bunny", |b| {
        b.iter(|| black_box(&bunny).run(&app, &NoProgress).unwrap());
    });
    // 1000 edges, checked on the $293 bender with everything that a route tells.
    let wireframe = column(34, 10);
    assert_eq!(wireframe.edge_count(), 1000);
    let document = wirebend_files::document::Document::new(wireframe).to_bytes().unwrap();
    let thousand = planning("column.wirebend", document, false, false);
    let Response::Plan(found) = thousand.run(&app, &NoProgress).unwrap() else { panic!("no plan") };
    assert_eq!(found.report.wires()[0].route.as_ref().map(|route| route.feeds), Some(1000));
    group.bench_function("column-1000-edges", |b| {
        b.iter(|| black_box(&thousand).run(&app, &NoProgress).unwrap());
    });
    group.finish();
}

/// A sheet of triangles, some of whose cells are divided the other way, so that hundreds of vertices are odd. With spikes all edges run
/// the same way from the tip of each, so that no route avoids bends past the machine's limit there.
fn sheet(side: u32, spikes: bool) -> Wireframe {
    let mut w = Wireframe::new();
    for k in 0..side * side {
        let (row, column) = (k / side, k % side);
        let height = if spikes && row % 4 == 1 && column % 4 == 1 { 400.0 } else { 0.0 };
        w.add_vertex(Vertex::at(Point3::new(60.0 * f64::from(column), 60.0 * f64::from(row), height)))
            .unwrap();
    }
    let at = |row: u32, column: u32| VertexId(row * side + column);
    for row in 0..side {
        for column in 0..side {
            let (right, down) = (column + 1 < side, row + 1 < side);
            if right {
                w.add_edge(at(row, column), at(row, column + 1)).unwrap();
            }
            if down {
                w.add_edge(at(row, column), at(row + 1, column)).unwrap();
            }
            if right && down {
                let (a, b) =
                    if (row * 7 + column * 5) % 3 == 0 { (column, column + 1) } else { (column + 1, column) };
                w.add_edge(at(row, a), at(row + 1, b)).unwrap();
            }
        }
    }
    w
}

/// What a window asks while a person drags a vertex: text in, text out.
fn live_check(c: &mut Criterion) {
    let mut group = c.benchmark_group("live-check");
    let (column, sheet, spikes) = (column(34, 10), sheet(59, false), sheet(59, true));
    assert!(sheet.edge_count() >= 10_000, "{}", sheet.edge_count());
    let odd = sheet.odd_vertices(&sheet.components()[0], &[]).len();
    assert!(odd > 1000, "{odd}");
    for (name, wireframe) in
        [("column-1000-edges", column), ("sheet-10000-edges", sheet), ("spikes-10000-edges", spikes)]
    {
        drag(&mut group, name, wireframe);
    }
    group.finish();
}

/// A window in which a design is open.
fn opened(wireframe: Wireframe) -> Workspace {
    struct Nobody;
    impl EventSink for Nobody {
        fn emit(&self, _: &WindowEvent) {}
    }
    let workspace = Workspace::new(Places::default(), Arc::new(Nobody)).unwrap();
    let bytes = wirebend_files::document::Document::new(wireframe).to_bytes().unwrap();
    let open = serde_json::json!({
        "ask": "open",
        "design": { "input": { "bytes": { "name": "dragged.wirebend", "bytes": bytes } } },
    });
    workspace.ask_json(&open.to_string()).unwrap();
    workspace
}

/// A question with a vertex a little elsewhere each time.
fn dragged(ask: &'static str, wireframe: &Wireframe, vertex: u32) -> impl FnMut() -> String + use<> {
    let at = wireframe.vertex(VertexId(vertex)).unwrap().position;
    let mut turn = 0.0_f64;
    move || {
        turn += 0.1;
        let at = [at.x + turn.sin(), at.y + turn.cos(), at.z];
        serde_json::json!({ "ask": ask, "moved": [{ "vertex": vertex, "at_mm": at }] }).to_string()
    }
}

fn drag(group: &mut BenchmarkGroup<'_, WallTime>, name: &str, wireframe: Wireframe) {
    let mut question = dragged("check", &wireframe, 100);
    let workspace = opened(wireframe);
    group.bench_function(name, |b| b.iter(|| workspace.ask_json(black_box(&question())).unwrap()));
}

/// The check for collisions while a person drags a vertex of a design of 200 edges, and how soon one that is under way ends when it is
/// given up for a later place.
fn live_collisions(c: &mut Criterion) {
    let mut group = c.benchmark_group("live-collisions");
    let column = column(9, 8);
    assert_eq!(column.edge_count(), 200);
    let mut question = dragged("collisions", &column, 30);
    let workspace = opened(column);
    let answer = workspace.ask_json(&question()).unwrap();
    let found: serde_json::Value = serde_json::from_str(answer.get()).unwrap();
    assert_eq!(found["checked"], true, "{answer}");
    group.bench_function("column-200-edges", |b| {
        b.iter(|| workspace.ask_json(black_box(&question())).unwrap());
    });
    group.bench_function("given-up", |b| {
        b.iter_custom(|times| (0..times).map(|_| given_up(&workspace, &question())).sum());
    });
    group.finish();
}

/// From the word that a check is not wanted any more until it has ended.
fn given_up(workspace: &Workspace, question: &str) -> Duration {
    std::thread::scope(|scope| {
        let check = scope.spawn(|| {
            let answer = workspace.ask_json(question).unwrap();
            let ended = Instant::now();
            let found: serde_json::Value = serde_json::from_str(answer.get()).unwrap();
            assert_eq!(found["stopped"], true, "it was over before: {answer}");
            ended
        });
        // It is well under way.
        std::thread::sleep(Duration::from_millis(10));
        let begun = Instant::now();
        workspace.ask_json(r#"{ "ask": "stop-collisions" }"#).unwrap();
        check.join().unwrap().saturating_duration_since(begun)
    })
}

fn euler_path_and_doubling(c: &mut Criterion) {
    let mut group = c.benchmark_group("euler");
    group.measurement_time(Duration::from_secs(5));
    for (name, face_edges) in
        [("bunny", true), ("teapot", true), ("truss-1", false), ("truss-2", false), ("truss-3", false)]
    {
        let options = ReadOptions { face_edges, ..ReadOptions::default() };
        let wireframe =
            read(&example(&format!("{name}.obj")), name, Some(wirebend_files::read::Format::Obj), &options)
                .unwrap()
                .wireframe;
        group.bench_function(name, |b| {
            b.iter(|| {
                let component = wireframe.components().remove(0);
                let doubled = doubling(&wireframe, &component, None, false).unwrap().edges;
                let options = RouteOptions { doubled, ..RouteOptions::default() };
                route(black_box(&wireframe), &component, &options).unwrap()
            });
        });
    }
    group.finish();
}

/// Costs of all pairs of edge ends at a vertex by their bends, 1000 to the square degree, and far more beyond 155°. The ends lead
/// away from it up to `widest` from one line.
fn costs_of_bends(ends: u32, widest: f64) -> Vec<i64> {
    let out: Vec<Vector3<f64>> = (0..ends)
        .map(|end| {
            // Evenly on a sphere, or on its cap.
            let around = f64::from(end) * TAU * 0.618_033_988_75;
            let height = 1.0 - (f64::from(end) + 0.5) / f64::from(ends) * (1.0 - widest.cos());
            let beside = (1.0 - height * height).sqrt();
            Vector3::new(beside * around.cos(), beside * around.sin(), height)
        })
        .collect();
    let pairs = out.iter().flat_map(|p| out.iter().map(move |q| (-p).angle(q).to_degrees()));
    #[allow(clippy::cast_possible_truncation)] // at most 180² · 1000
    let cost = |bend: f64| (bend * bend * 1000.0).round() as i64 + if bend > 155.0 { 1 << 35 } else { 0 };
    pairs.map(cost).collect()
}

/// Which edge end follows which at a vertex of 400, beside another's solver.
fn ends_at_a_vertex(c: &mut Criterion) {
    const ENDS: u32 = 400;
    let mut group = c.benchmark_group("edge-ends");
    for (name, widest) in [("all-around", PI), ("one-side", PI / 4.0)] {
        let costs = costs_of_bends(ENDS, widest);
        let ours = || cheapest_pairs(ENDS, |a, b| costs[(a * ENDS + b) as usize].unsigned_abs());
        let peer = || min_weight_perfect_matching(&costs, ENDS as usize);
        let sum = |mates: &[usize]| -> i64 {
            mates.iter().enumerate().map(|(a, &b)| costs[a * ENDS as usize + b]).sum()
        };
        let of_ours: Vec<usize> = ours().into_iter().map(|mate| mate as usize).collect();
        assert_eq!(sum(&of_ours), sum(&peer()), "{name}");
        group.bench_function(name, |b| b.iter(ours));
        group.bench_function(format!("{name}-integer-blossom"), |b| b.iter(peer));
    }
    group.finish();
}

criterion_group!(
    benches,
    whole_pipeline,
    live_check,
    live_collisions,
    euler_path_and_doubling,
    ends_at_a_vertex
);
criterion_main!(benches);
