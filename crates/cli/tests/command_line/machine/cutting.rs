//! Pieces that a controller cuts off.

use serde_json::json;

use super::bender::Bender;
use super::runs::Shop;
use crate::drivers::limits::machine;
use crate::grbl_model::Build;

/// What the controller really did: bends of the same shape, each cut off where its wire ends, and the tip brought back.
#[test]
fn a_row_of_pieces_is_cut_off_where_each_ends() {
    for cutter_mm in [7.5, -4.0] {
        let shop = Shop::on("u-sample.obj", "grbl-bender");
        let cut = ["M8", "G4 P0.1", "M9"];
        let settings = json!({"homing": "switches", "cut": cut, "cutter_mm": cutter_mm});
        machine(shop.path(), "cuts", "grbl-bender", &settings);
        let design = crate::example("u-sample.obj");
        shop.run(&["plan", &design, "-m", "cuts", "-o", "b.wbjob"]).ended(0);
        let bender = Bender::new(Build::default());
        let row = ["run", "b.wbjob", "--port", &bender.port, "--repeat", "3", "--stock", "5000", "--cut"];
        let ran = shop.run(&[&row[..], &["--yes", "--json"]].concat()).ended(0);
        let pieces = &ran.json()["pieces"];
        assert_eq!((&pieces["made"], &pieces["of"]), (&json!(3), &json!(3)), "{}", ran.err);
        assert_eq!(shop.list().len(), 3);

        let file = std::fs::read(shop.path().join("b.wbjob")).unwrap();
        let job: serde_json::Value = serde_json::from_slice(&file).unwrap();
        let steps = job["wires"][0]["compensated"].as_array().unwrap();
        let fed: f64 = steps.iter().map(|step| step["feed_mm"].as_f64().unwrap()).sum();
        let record = bender.model.end();
        assert_eq!(record.cuts.len(), 3);
        for at in &record.cuts {
            // Homing before each piece sets the feed to zero.
            assert!((at - fed - cutter_mm).abs() < 0.05, "{at}, not {fed} + {cutter_mm}");
        }
        let each = record.bends.len() / 3;
        let bent = |piece: usize| record.bends[piece * each..][..each].iter().map(|bend| bend[2]);
        assert!(bent(0).eq(bent(1)) && bent(1).eq(bent(2)), "{:?}", record.bends);
    }
}

#[test]
fn a_machine_without_a_cutter_says_so() {
    let shop = Shop::cube();
    let error = shop.make(&["--yes", "--cut", "--json"]).ended(2).json()["error"].clone();
    assert_eq!(error["code"], "no-cutter", "{error}");
    assert!(shop.list().is_empty(), "a wire was begun");
}
