//! `generate`: designs from a few figures.

use crate::{assert_fits, run, run_in};

#[test]
fn a_truss_is_written_and_can_be_planned() {
    let folder = tempfile::tempdir().unwrap();
    let truss = ["generate", "truss", "--rings", "1", "--strut", "61.237", "-o", "truss.wirebend"];
    let made = run_in(folder.path(), &truss, b"").ended(0);
    assert!(made.out.is_empty());
    // The counts are the published ones of one ring.
    assert!(made.err.starts_with("24 vertices, 78 edges of 61.2 mm; "), "{}", made.err);
    let again = run_in(folder.path(), &truss, b"").ended(2);
    assert!(again.err.contains("truss.wirebend"), "{}", again.err);
    let plan = ["plan", "truss.wirebend", "-m", "pensa-diwire-pro", "--double", "--json"];
    let planned = run_in(folder.path(), &plan, b"").json();
    assert_eq!(planned["wireframe"]["odd_vertices"], 24, "as published");
}

#[test]
fn a_report_fits_its_schema() {
    let folder = tempfile::tempdir().unwrap();
    let deep =
        ["generate", "truss", "--rings", "2", "--strut", "10", "--depth", "30", "-o", "t.obj", "--json"];
    let made = run_in(folder.path(), &deep, b"").ended(0).json();
    assert_fits("generate", &made);
    assert_eq!((&made["vertices"], &made["edges"]), (&54.into(), &198.into()));
    let struts: Vec<f64> =
        made["strut_mm"].as_array().unwrap().iter().map(|mm| mm.as_f64().unwrap()).collect();
    let diagonal = (100.0_f64 / 3.0 + 900.0).sqrt();
    assert!((struts[0] - 10.0).abs() < 1e-9 && (struts[1] - diagonal).abs() < 1e-9, "{struts:?}");
    let text = std::fs::read_to_string(folder.path().join("t.obj")).unwrap();
    assert_eq!(text.lines().filter(|line| line.starts_with("l ")).count(), 198);
}

/// Bend-Forming names its trusses by rings and depth; all struts are of one length then.
#[test]
fn a_depth_alone_is_that_of_regular_tetrahedra() {
    let folder = tempfile::tempdir().unwrap();
    let deep = ["generate", "truss", "--rings", "1", "--depth", "50", "-o", "t.obj", "--json"];
    let made = run_in(folder.path(), &deep, b"").ended(0).json();
    for end in made["strut_mm"].as_array().unwrap() {
        assert!((end.as_f64().unwrap() - 61.237_243_569_579_45).abs() < 1e-9, "{made}");
    }
    let text = run(&["generate", "truss", "--rings", "1"]).ended(2).err;
    assert!(text.contains("<--strut <MM>|--depth <MM>>"), "{text}");
}

#[test]
fn what_is_no_truss_is_a_wrong_use() {
    let refused = |rings: &str, strut: &str, depth: &str| {
        let depth = format!("--depth={depth}");
        let strut = format!("--strut={strut}");
        run(&["generate", "truss", "--rings", rings, &strut, &depth]).ended(2).err
    };
    assert!(refused("101", "1", "1").contains("the number of rings is 101, expected 0 to 100"));
    assert!(refused("1", "-1", "1").contains("the length of a strut is -1, expected a length in mm above 0"));
    assert!(refused("1", "1", "nan").contains("the depth is NaN, expected a length in mm above 0"));
    assert!(refused("100", "1e6", "1").contains("the truss is"));
}
