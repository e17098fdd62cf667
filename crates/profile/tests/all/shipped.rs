//! The profiles inside the program: each loads, and says what was published.

use std::path::Path;

use serde_json::Value;
use wirebend_profile::{BendFigures, Kind, Library, LossPoint, Springback, check_file, schema};

fn library() -> Library {
    Library::shipped().unwrap()
}

fn near(value: f64, expected: f64) {
    assert!((value - expected).abs() < 1e-9, "{value} is not {expected}");
}

/// Files of `machine-profiles/`, read from the checkout rather than from the program.
fn files(kind: Kind) -> Vec<std::path::PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../machine-profiles");
    let folder = std::fs::read_dir(root.join(kind.folder())).unwrap();
    folder.map(|entry| entry.unwrap().path()).collect()
}

#[test]
fn every_shipped_profile_can_be_chosen() {
    let library = library();
    for listing in library.machines().iter().filter(|listing| !listing.is_abstract) {
        library.machine(&listing.id).unwrap().figures().unwrap();
    }
    for listing in library.materials().iter().filter(|listing| !listing.is_abstract) {
        library.material(&listing.id).unwrap().figures().unwrap();
    }
    for listing in library.strut_builders().iter().filter(|listing| !listing.is_abstract) {
        library.strut_builder(&listing.id).unwrap().figures().unwrap();
    }
    for listing in library.noises().iter().filter(|listing| !listing.is_abstract) {
        library.noise(&listing.id).unwrap().figures().unwrap();
    }
}

#[test]
fn the_lists_have_the_machines_materials_and_errors_that_the_manual_names() {
    let ids = |list: Vec<wirebend_profile::Listing>| -> Vec<String> {
        list.into_iter().filter(|one| !one.is_abstract).map(|one| one.id).collect()
    };
    let library = library();
    let machines = ["grbl-bender", "howtomechatronics", "pensa-diwire-pro", "table-bender", "wirebend-kit"];
    assert_eq!(ids(library.machines()), machines);
    let materials = [
        "abs-1-5mm",
        "aluminium-3-175mm",
        "aluminium-6061-o-3mm",
        "aluminium-6061-t6-3mm",
        "brass-1-6mm",
        "copper-2mm",
        "pla-3mm",
        "steel-0-9mm",
        "steel-1mm",
        "steel-3mm",
    ];
    assert_eq!(ids(library.materials()), materials);
    assert_eq!(ids(library.strut_builders()), ["framefab-extruder"]);
    assert_eq!(ids(library.noises()), ["bend-forming", "none", "wirebend-kit"]);
}

#[test]
fn a_machines_default_material_fits_it() {
    let library = library();
    for listing in library.machines() {
        let machine = library.machine(&listing.id).unwrap();
        let figures = machine.figures().unwrap();
        let material = library.material(machine.profile.default_material.as_deref().unwrap());
        let diameter = material.unwrap().figures().unwrap().diameter_mm;
        let range = figures.min_diameter_mm..=figures.max_diameter_mm;
        assert!(range.contains(&diameter), "{}: {diameter} not in {range:?}", listing.id);
    }
}

/// Figures of Faruqi et al., SCF '25.
#[test]
fn the_kit_has_its_published_figures() {
    let kit = library().machine("wirebend-kit").unwrap();
    let figures = kit.figures().unwrap();
    near(figures.limits.min_bend_deg, -155.0);
    near(figures.limits.max_bend_deg, 155.0);
    near(figures.limits.min_edge_mm, 20.4);
    near(figures.limits.min_feed_mm, 25.0);
    near(figures.limits.tail_mm, 400.0);
    near(figures.limits.max_rotation_deg, 360.0);
    near(figures.feed_rate_mm_per_s, 110.2);
    near(figures.bend_rate_deg_per_s, 15.1);
    near(figures.rotate_rate_deg_per_s, 131.3);
    near(figures.pin_radius_mm, 1.5);
    assert_eq!(kit.profile.export.native.as_deref(), Some("wirebend-kit-text"));
    assert!(figures.compensate_feed && figures.compensate_setback);
    assert!(figures.compensate_springback);
}

/// With too low an axis limit the machine could not bend the 155 degrees that the machine is sold with.
#[test]
fn the_kits_axis_reaches_its_largest_bend_with_springback() {
    let library = library();
    let figures = library.machine("wirebend-kit").unwrap().figures().unwrap();
    let wire = library.material("aluminium-6061-t6-3mm").unwrap().figures().unwrap();
    let Springback::Constant { angle_deg } = wire.springback else { panic!("a constant") };
    let BendFigures::Peg { rod_radius_mm, orbit_radius_mm, orbit_offset_mm, axis_limit_deg, .. } =
        figures.bend
    else {
        panic!("a peg")
    };
    let wire_radius = wire.diameter_mm / 2.0;
    let (r_n, r_e) = (figures.pin_radius_mm + wire_radius, rod_radius_mm + wire_radius);
    let theta = (figures.limits.max_bend_deg + angle_deg.value).to_radians();
    let lift = orbit_offset_mm * theta.sin() - r_e - r_n * (1.0 - theta.cos());
    let axis = (theta + (lift / orbit_radius_mm).asin()).to_degrees();
    assert!(axis < axis_limit_deg && axis_limit_deg <= 180.0, "{axis} {axis_limit_deg}");
}

#[test]
fn a_pensa_machine_gets_nominal_programs_and_clones_get_compensated_ones() {
    let library = library();
    let pensa = library.machine("pensa-diwire-pro").unwrap().figures().unwrap();
    assert!(!pensa.compensate_feed && !pensa.compensate_springback);
    assert!(!pensa.compensate_setback);
    let clone = library.machine("howtomechatronics").unwrap();
    assert_eq!(clone.profile.export.native.as_deref(), Some("howtomechatronics-serial"));
    assert!(clone.figures().unwrap().compensate_springback);
    let grbl = library.machine("grbl-bender").unwrap();
    assert_eq!(grbl.profile.export.native.as_deref(), Some("gcode"));
}

#[test]
fn wires_have_their_published_figures() {
    let library = library();
    let t6 = library.material("aluminium-6061-t6-3mm").unwrap().figures().unwrap();
    near(t6.youngs_modulus_gpa, 68.03);
    near(t6.yield_strength_mpa, 268.47);
    near(t6.ultimate_strength_mpa, 362.14);
    near(t6.price_per_mm.unwrap(), 0.00199);
    near(t6.k_factor, 0.3);
    let eighth = library.material("aluminium-3-175mm").unwrap().figures().unwrap();
    let Springback::Table { positive, measured, .. } = eighth.springback else { panic!() };
    let pairs = [(10.0, 4.9), (130.0, 8.6)];
    let pairs = pairs.map(|(angle_deg, loss_deg)| LossPoint { angle_deg, loss_deg });
    assert_eq!(positive, pairs);
    assert!(measured);
    let steel = library.material("steel-0-9mm").unwrap();
    near(steel.figures().unwrap().diameter_mm, 0.9);
    assert_eq!(steel.chain, ["steel-0-9mm", "steel-1010"]);
}

/// The stiffness that published frames were computed with: FrameFab's ABS, the PLA of the assembly instances, whose shear modulus
/// is stated and does not follow from its Poisson's ratio, and the steel of the Bend-Forming accuracy models.
#[test]
fn struts_have_the_stiffness_of_the_published_frames() {
    let library = library();
    let figures = |id| library.material(id).unwrap().figures().unwrap();
    let abs = figures("abs-1-5mm");
    near(abs.youngs_modulus_gpa, 3.457);
    near(abs.shear_modulus_gpa.unwrap(), 1.294);
    near(abs.density_kg_per_m3, 1210.0);
    near(abs.diameter_mm, 1.5);
    let pla = figures("pla-3mm");
    near(pla.youngs_modulus_gpa, 3.5);
    near(pla.shear_modulus_gpa.unwrap(), 2.4);
    near(pla.density_kg_per_m3, 1249.99);
    let steel = figures("steel-0-9mm");
    near(steel.youngs_modulus_gpa, 200.0);
    near(steel.shear_modulus_gpa.unwrap(), 200.0 / 2.58);
    near(steel.density_kg_per_m3, 7800.0);
    near(steel.process_energy_mj_per_kg.unwrap(), 0.33);
    for listing in library.materials().iter().filter(|listing| !listing.is_abstract) {
        let figures = figures(&listing.id);
        assert!(figures.shear_modulus_gpa.is_some() && figures.fracture_strain.is_some(), "{}", listing.id);
    }
}

/// An estimate that is labelled as measured would be trusted.
#[test]
fn only_measured_springback_is_called_measured() {
    let library = library();
    for listing in library.materials().iter().filter(|listing| !listing.is_abstract) {
        let measured = match library.material(&listing.id).unwrap().profile.springback.unwrap() {
            Springback::Constant { angle_deg } => angle_deg.measured,
            Springback::Table { measured, .. } => measured,
        };
        let is_known = ["aluminium-6061-t6-3mm", "aluminium-3-175mm"].contains(&&*listing.id);
        assert_eq!(measured, is_known, "{}", listing.id);
    }
}

#[test]
fn an_editor_and_the_reader_agree_on_every_shipped_file() {
    for kind in Kind::ALL {
        let validator = jsonschema::validator_for(&schema(kind)).unwrap();
        for path in files(kind) {
            check_file(&path).unwrap_or_else(|errors| panic!("{errors:?}"));
            let value: Value = serde_json::from_slice(&std::fs::read(&path).unwrap()).unwrap();
            let errors: Vec<String> = validator.iter_errors(&value).map(|error| error.to_string()).collect();
            assert!(errors.is_empty(), "{}: {errors:?}", path.display());
        }
    }
}

#[test]
fn an_editor_marks_what_the_reader_refuses() {
    let validator = jsonschema::validator_for(&schema(Kind::Machine)).unwrap();
    let head = r#""schema_version": 1, "kind": "machine", "id": "a""#;
    assert!(validator.is_valid(&serde_json::from_str(&format!("{{{head}}}")).unwrap()));
    for rest in [
        r#""speed": 3"#,
        r#""limits": {"max_bend": 3}"#,
        r#""limits": {"tail_mm": 3}"#,
        r#""signs": {"bend": 2}"#,
        r#""id": "A B""#,
        r#""kind": "material""#,
        r#""schema_version": 2"#,
    ] {
        let value = serde_json::from_str(&format!("{{{head}, {rest}}}")).unwrap();
        assert!(!validator.is_valid(&value), "{rest}");
    }
}

/// Whoever looks at a value is told where it comes from: a paper, a data sheet, an estimate, a decision of ours.
#[test]
fn every_value_of_every_shipped_profile_has_a_source() {
    // What a profile is called and how it is connected is no value of the machine or the wire.
    let is_heading = |key: &str| {
        ["name", "description", "alloy", "temper", "sources", "signs.note"].contains(&key)
            || ["driver.", "export."].iter().any(|group| key.starts_with(group))
            // The source of its pairs or of its angle stands beside them.
            || key == "springback.model"
    };
    let library = library();
    let mut seen = 0;
    for kind in Kind::ALL {
        for listing in library.list(kind) {
            let explained = library.explain(kind, &listing.id).unwrap();
            for value in explained.values.iter().filter(|value| !is_heading(&value.key)) {
                let bodies = value.value.as_array().filter(|_| value.key == "shapes");
                let sources: Vec<Option<&str>> = match bodies {
                    Some(bodies) => bodies.iter().map(|body| body["source"].as_str()).collect(),
                    None => vec![value.source.as_deref()],
                };
                for source in sources {
                    let stated = source.is_some_and(|source| !source.trim().is_empty());
                    assert!(stated, "{kind} {}: {} has no source", listing.id, value.key);
                    seen += 1;
                }
            }
        }
    }
    assert!(seen > 250, "{seen} values");
}
