//! `--double --start`: a wire that begins where a person wants it, with the least wire beside itself.

use std::collections::{BTreeMap, BTreeSet};

use wirebend_api::{
    Command, DesignInput, Input, Installation, NoProgress, PlanChoices, PlanRequest, PlanResponse, Response,
};

type Edges = Vec<(u32, u32)>;

fn obj(points: &[[f64; 3]], edges: &Edges) -> DesignInput {
    let points = points.iter().map(|[x, y, z]| format!("v {x} {y} {z}\n"));
    let lines = edges.iter().map(|(a, b)| format!("l {} {}\n", a + 1, b + 1));
    let bytes = points.chain(lines).collect::<String>().into_bytes();
    DesignInput {
        input: Input::Bytes { name: "design.obj".to_owned(), bytes },
        ..DesignInput::file("design.obj".into())
    }
}

fn planned(design: DesignInput, start: u32) -> PlanResponse {
    let choices = PlanChoices {
        machine: Some("wirebend-kit".to_owned()),
        double: true,
        start: Some(start),
        ..PlanChoices::default()
    };
    let request = PlanRequest {
        design,
        choices,
        output: None,
        make_job: false,
        pauses: Vec::new(),
        despite_errors: false,
    };
    match Command::Plan(request).run(&Installation::new(&[]).unwrap(), &NoProgress).unwrap() {
        Response::Plan(found) => *found,
        other => panic!("a plan answered {other:?}"),
    }
}

/// The least length to travel twice for a walk from `start`, over all sets of edges: Euler's condition, tried out.
fn least(points: &[[f64; 3]], edges: &Edges, start: u32) -> f64 {
    let length = |&(a, b): &(u32, u32)| {
        let (p, q) = (points[a as usize], points[b as usize]);
        (0..3).map(|k| (p[k] - q[k]).powi(2)).sum::<f64>().sqrt()
    };
    let possible = (0..1_u32 << edges.len()).filter_map(|set| {
        let chosen =
            || edges.iter().enumerate().filter(move |(k, _)| set >> k & 1 == 1).map(|(_, edge)| edge);
        let mut ends: BTreeMap<u32, u32> = BTreeMap::new();
        for &(a, b) in edges.iter().chain(chosen()) {
            *ends.entry(a).or_default() += 1;
            *ends.entry(b).or_default() += 1;
        }
        let odd: BTreeSet<u32> =
            ends.into_iter().filter(|(_, count)| count % 2 == 1).map(|(v, _)| v).collect();
        (odd.is_empty() || (odd.len() == 2 && odd.contains(&start))).then(|| chosen().map(length).sum())
    });
    possible.fold(f64::INFINITY, f64::min)
}

/// A person who has the wire begin at a hook does not care which vertices are odd.
#[test]
fn a_wire_begins_at_any_vertex_with_the_least_length_twice() {
    let corner = |k: u32| [k & 1, k >> 1 & 1, k >> 2 & 1].map(|bit| 60.0 * f64::from(bit));
    let cube: Edges =
        (0..8).flat_map(|a| [1, 2, 4].map(|bit| (a, a | bit))).filter(|(a, b)| a != b).collect();
    let designs: [(&str, Vec<[f64; 3]>, Edges); 4] = [
        (
            "a U",
            vec![[0., 0., 0.], [70., 0., 0.], [70., 60., 0.], [0., 60., 0.]],
            vec![(0, 1), (1, 2), (2, 3)],
        ),
        (
            "a theta",
            vec![[0., 0., 0.], [90., 0., 0.], [45., 50., 0.], [45., -70., 0.], [45., 0., 40.]],
            vec![(0, 2), (2, 1), (0, 3), (3, 1), (0, 4), (4, 1)],
        ),
        ("a triangle", vec![[0., 0., 0.], [80., 0., 0.], [30., 60., 0.]], vec![(0, 1), (1, 2), (2, 0)]),
        ("a cube", (0..8).map(corner).collect(), cube),
    ];
    for (name, points, edges) in &designs {
        for start in 0..u32::try_from(points.len()).unwrap() {
            let found = planned(obj(points, edges), start);
            let [wire] = found.report.wires() else { panic!("{name}") };
            let route =
                wire.route.as_ref().unwrap_or_else(|| panic!("{name} from {start}: {:?}", wire.diagnostics));
            assert_eq!(route.vertices[0], start, "{name}");
            assert_eq!(route.edges.iter().collect::<BTreeSet<_>>().len(), edges.len(), "{name}: every edge");
            let expected = least(points, edges, start);
            assert!(
                (route.doubled_mm - expected).abs() < 1e-4,
                "{name} from {start}: {} for {expected}",
                route.doubled_mm
            );
            assert!(route.optimal);
        }
    }
}

/// Nothing is doubled unasked: the help says what it would take.
#[test]
fn a_start_that_does_not_fit_says_what_doubling_would_add() {
    let points = [[0., 0., 0.], [70., 0., 0.], [70., 60., 0.], [0., 60., 0.]];
    let mut request = PlanRequest {
        design: obj(&points, &vec![(0, 1), (1, 2), (2, 3)]),
        choices: PlanChoices {
            machine: Some("wirebend-kit".to_owned()),
            start: Some(2),
            ..PlanChoices::default()
        },
        output: None,
        make_job: false,
        pauses: Vec::new(),
        despite_errors: false,
    };
    let app = Installation::new(&[]).unwrap();
    let Response::Plan(found) = Command::Plan(request.clone()).run(&app, &NoProgress).unwrap() else {
        panic!()
    };
    let refused =
        found.report.wires()[0].diagnostics.iter().find(|d| d.code.as_str() == "route_refused").unwrap();
    // From vertex 2 the shorter way to an end is the last side.
    assert!(refused.help.contains("run the wire along 1 edge twice: that adds 70.0 mm"), "{}", refused.help);
    request.choices.double = true;
    let Response::Plan(found) = Command::Plan(request).run(&app, &NoProgress).unwrap() else { panic!() };
    assert_eq!(found.report.wires()[0].route.as_ref().unwrap().doubled, [2]);
}
