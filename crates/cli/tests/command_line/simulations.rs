//! Simulations: on the simulated machine where there is one, by formulas where there is none.

use serde_json::Value;

use crate::{assert_fits, example, run_in};

fn simulated(machine: &str, name: &str, more: &[&str]) -> Value {
    let folder = tempfile::tempdir().unwrap();
    let plan = ["plan", &example(name), "-m", machine, "--despite-errors", "-o", "a.wbjob"];
    run_in(folder.path(), &plan, b"");
    let simulate = [&["simulate", "a.wbjob", "--json"], more].concat();
    let found = run_in(folder.path(), &simulate, b"").ended(0).json();
    assert_fits("simulate", &found);
    found
}

fn worst(found: &Value, figure: &str) -> f64 {
    found["wires"][0][figure].as_f64().unwrap()
}

/// The formulas undo what the formulas did, and so find nothing. The bench of the simulated machine does not know
/// them: it finds what they leave. The published cube stays within half a millimetre.
#[test]
fn the_simulated_machine_sees_what_formulas_cannot() {
    let kit = simulated("wirebend-kit", "cube-8-edges.obj", &[]);
    assert_eq!(kit["model"], "simulated-machine");
    let off = worst(&kit, "worst_machine_mm");
    assert!(off > 1e-3 && off < 0.5, "{off}");
    assert!(worst(&kit, "worst_systematic_mm") < 1e-6);
    let of_vertices = kit["wires"][0]["vertices"].as_array().unwrap();
    let largest = of_vertices.iter().map(|vertex| vertex["machine_mm"].as_f64().unwrap()).fold(0.0, f64::max);
    assert_eq!((of_vertices.len(), largest.to_bits()), (9, off.to_bits()));
    // Vertex 6 is passed twice: first and last distances are of the same place in the design.
    let gap = kit["wires"][0]["gaps"][0]["machine_mm"].as_f64().unwrap();
    assert!(gap > 0.0 && gap <= 2.0 * off, "{gap}");
    assert_eq!(kit["notes"], serde_json::json!([]), "nothing went wrong on the machine");

    let pensa = simulated("pensa-diwire-pro", "cube-8-edges.obj", &[]);
    assert_eq!(
        (&pensa["model"], &pensa["wires"][0]["worst_machine_mm"]),
        (&"closed-form".into(), &Value::Null)
    );
    assert!(worst(&pensa, "worst_systematic_mm") < 1e-6);
}

/// Spatial bends to both sides and vertices on straights: were a sign or a frame wrong, the wire would be off by
/// centimetres.
#[test]
fn every_example_that_can_be_made_comes_out_on_the_simulated_machine() {
    for name in ["house.obj", "cup-holder.obj", "phone-stand.obj", "spring.obj", "two-parts.obj"] {
        let found = simulated("wirebend-kit", name, &[]);
        assert_eq!(found["model"], "simulated-machine", "{name}");
        for wire in found["wires"].as_array().unwrap() {
            let off = wire["worst_machine_mm"].as_f64().unwrap();
            assert!(off < 3.0, "{name}: {off} mm");
        }
    }
}

#[test]
fn with_errors_the_figures_over_all_runs_are_of_formulas() {
    let found = simulated("wirebend-kit", "house.obj", &["--noise", "wirebend-kit", "--runs", "20"]);
    assert!(worst(&found, "worst_machine_mm") < 0.5, "the machine makes no errors of its own");
    assert!(worst(&found, "worst_radius_95_mm") > worst(&found, "worst_mean_mm"));
}

/// A person hears which of the two it was.
#[test]
fn the_report_says_how_it_was_found() {
    let folder = tempfile::tempdir().unwrap();
    for (machine, said) in
        [("wirebend-kit", "simulated machine"), ("grbl-bender", "this machine has no simulator")]
    {
        let job = format!("{machine}.wbjob");
        run_in(
            folder.path(),
            &["plan", &example("house.obj"), "-m", machine, "--despite-errors", "-o", &job],
            b"",
        );
        let told = run_in(folder.path(), &["simulate", &job], b"").ended(0).err;
        assert!(told.contains(said), "{told}");
    }
}
