//! Figure: the published cube by the binary of the board, and what it would be without compensation.

use serde_json::{Value, json};
use wirebend_driver_wirebend_kit::bench::Deviations;
use wirebend_tests_firmware::{Behind, OnPty, Options};

use crate::jobs::bender::{Bender, Gears};
use crate::jobs::shop::{Shop, example, shared};
use wirebend_tests_firmware::board::{Avr, MS};

/// The published machine, as fast as its controller can step, so that a cube takes half a minute.
fn quick() -> Value {
    json!({
        "schema_version": 1, "kind": "machine", "id": "quick-kit", "inherits": "wirebend-kit",
        "name": "Quick kit",
        "driver": { "settings": {
            "feed_rate_mm_per_s": 146.0, "rotate_rate_deg_per_s": 174.0, "bend_rate_deg_per_s": 134.0,
            "feed_acceleration_mm_per_s2": 2000.0, "rotate_acceleration_deg_per_s2": 2000.0,
            "bend_acceleration_deg_per_s2": 1000.0, "peg_time_ms": 100, "home_fast_rate_deg_per_s": 100.0,
        } },
    })
}

/// The same, with programs as if wire had no thickness and did not spring.
fn plain() -> Value {
    json!({
        "schema_version": 1, "kind": "machine", "id": "plain-kit", "inherits": "quick-kit", "name": "Plain kit",
        "compensation": { "feed": false, "setback": false, "springback": false },
    })
}

/// The cube as it is drawn, in the order of the route.
fn design(planned: &Value) -> Vec<[f64; 3]> {
    let text = std::fs::read_to_string(example("cube-8-edges.obj")).unwrap();
    let vertices: Vec<[f64; 3]> = text
        .lines()
        .filter_map(|line| line.strip_prefix("v "))
        .map(|line| line.split(' ').map(|x| x.parse().unwrap()).collect::<Vec<_>>().try_into().unwrap())
        .collect();
    let route = planned["route"]["vertices"].as_array().unwrap();
    route.iter().map(|id| vertices[usize::try_from(id.as_u64().unwrap()).unwrap()]).collect()
}

/// Bent by a board that comes from the shelf: its settings are written, it is homed, it runs the job.
fn made(shop: &Shop, machine: &str) -> Deviations {
    let job = format!("{machine}.wbjob");
    let planned = shop
        .ran(machine, &["plan", &example("cube-8-edges.obj"), "--machine", machine, "-o", &job, "--json"])
        .ended(0)
        .json();
    let bender = Bender::<Avr>::new(Gears::PUBLISHED, None);
    let board = OnPty::new(bender, Options::default()).unwrap();
    let port = board.port().to_str().unwrap().to_owned();
    let settings = ["machine-settings", "--machine", machine, "--port", &port, "--write", "--yes"];
    shop.ran(machine, &settings).ended(0);
    let before = board.with(|bender| bender.cycle()).unwrap();
    let ran = shop.ran(machine, &["run", &job, "--port", &port, "--yes", "--json"]).ended(0).json();
    assert_eq!(ran["wires"][0]["outcome"], "made", "{ran}");
    let bender = board.stop().unwrap();
    assert_eq!(bender.incidents(), Vec::<String>::new(), "{machine}");
    let wire = bender.made();
    assert_eq!(wire.warnings().len(), 0, "{:?}", wire.warnings());
    let ms = (bender.cycle() - before) / MS;
    println!("{machine}: {} pulses, {ms} ms of the board", bender.pulses.len());
    wire.deviations(&design(&planned)).unwrap()
}

/// Mean and worst of what should be zero.
fn mean_and_worst(errors: &[f64]) -> [f64; 2] {
    let sizes = errors.iter().map(|error| error.abs());
    let count = errors.iter().fold(0.0, |count, _| count + 1.0);
    [sizes.clone().sum::<f64>() / count, sizes.fold(0.0, f64::max)]
}

#[test]
fn the_cube_comes_out_of_the_board_as_designed() {
    let _others = shared();
    let shop = Shop::new(&[quick(), plain()]);
    let [with, without] = std::thread::scope(|scope| {
        ["quick-kit", "plain-kit"]
            .map(|machine| {
                scope.spawn({
                    let shop = &shop;
                    move || made(shop, machine)
                })
            })
            .map(|made| made.join().unwrap())
    });
    for (name, deviations) in [("compensated", &with), ("not compensated", &without)] {
        let [angle, worst_angle] = mean_and_worst(&deviations.angle_deg);
        let [edge, worst_edge] = mean_and_worst(&deviations.edge_mm);
        println!(
            "{name}: worst vertex {:.3} mm (best fit {:.3} mm), angle {angle:.3} worst {worst_angle:.3} deg, \
             edge {edge:.3} worst {worst_edge:.3} mm",
            deviations.worst_from_start_mm(),
            deviations.worst_fitted_mm(),
        );
    }
    let worst = with.worst_from_start_mm();
    assert!(worst < 0.5, "the worst vertex is {worst} mm off");
    let times = |of: fn(&Deviations) -> &[f64]| {
        let ([mean, worst], [plain_mean, plain_worst]) =
            (mean_and_worst(of(&with)), mean_and_worst(of(&without)));
        [plain_mean / mean, plain_worst / worst]
    };
    let [angle, worst_angle] = times(|deviations| &deviations.angle_deg);
    let [edge, worst_edge] = times(|deviations| &deviations.edge_mm);
    println!(
        "worse without: angle {angle:.1} times (worst {worst_angle:.1}), edge {edge:.1} (worst {worst_edge:.1})"
    );
    // Of the plan: compensation makes angles seven times better and feeds ten times.
    assert!(angle >= 7.0 && worst_angle >= 7.0, "angle {angle}, {worst_angle}");
    assert!(edge >= 10.0 && worst_edge >= 10.0, "edge {edge}, {worst_edge}");
}
