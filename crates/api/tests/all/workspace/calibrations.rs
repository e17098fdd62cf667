//! Coupons, readings and a fit in the window.

use super::*;

/// What a person types, with one slip of the keyboard in it: the slip is named in its cell, and the design
/// has the calibrated machine at once.
#[test]
fn readings_are_typed_fitted_and_applied() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "house"}));
    let folder = window.home.path().join("calibration");
    let made = window.ask(
        "calibrate-new",
        json!({"machine": "wirebend-kit", "angles_deg": [30, 60, 90], "repeats": 2, "folder": folder}),
    );
    let sheet = made["sheet"].as_str().unwrap().to_owned();
    let table = window.ask("calibrate-sheet", json!({"sheet": sheet}));
    assert_eq!((&table["machine"], &table["jobs"].as_array().unwrap().len()), (&json!("wirebend-kit"), &3));
    let rows = table["rows"].as_array().unwrap().clone();
    let first = &rows[0];
    assert_eq!(
        (&first["coupon"], &first["row"], &first["unit"]),
        (&json!("angle-30"), &json!(1), &json!("deg"))
    );
    assert_eq!(first["readings"], json!([null, null]));
    // Without readings there is nothing to fit.
    assert_eq!(window.try_ask("calibrate-fit", json!({"sheet": sheet})).unwrap_err().code, "calibration");

    // Every bend springs back 2 degrees more than the profile says; one reading is typed with its point left out.
    for row in rows.iter().filter(|row| row["what"] == "bend") {
        let (coupon, number) = (row["coupon"].as_str().unwrap(), &row["row"]);
        let read = row["wanted"].as_f64().unwrap();
        let read = read - 2.0 * read.signum();
        let second = if coupon == "angle-60" && number == &json!(1) { read * 10.0 } else { read + 0.2 };
        let readings = format!("{coupon}:{number}={read},{second}");
        window.ask("calibrate-enter", json!({"sheet": sheet, "readings": [readings]}));
    }
    let report = window.ask("calibrate-fit", json!({"sheet": sheet}));
    let left_out = report["left_out"].as_array().unwrap();
    assert_eq!(left_out.len(), 1, "{left_out:?}");
    let slip = rows.iter().find(|row| row["coupon"] == "angle-60" && row["row"] == 1).unwrap();
    assert_eq!((&left_out[0]["line"], &left_out[0]["reading"]), (&slip["line"], &json!(2)));
    let bends = &report["kinds"][0];
    let off = |which: &str| bends[which]["mean_abs"].as_f64().unwrap();
    assert!(off("before") > 1.5 && off("after") < 0.3, "{bends}");

    let apply = json!({"sheet": sheet, "machine_id": "my-kit", "material_id": "my-wire"});
    let applied = window.ask("apply-calibration", apply.clone());
    assert_eq!((&applied["machine"], &applied["material"]), (&json!("my-kit"), &json!("my-wire")));
    // It is known at once, without a restart.
    window.ask("edit", json!({"request": {"edit": "machine", "machine": "my-kit", "material": "my-wire"}}));
    let compared =
        window.ask("calibrate-compare", json!({"machines": ["wirebend-kit", "my-kit"], "sheet": sheet}));
    let misfits = &compared["misfits"][0]["misfits"];
    assert!(misfits[0]["mean_abs"].as_f64().unwrap() > misfits[1]["mean_abs"].as_f64().unwrap() + 1.0);
    assert_eq!(window.try_ask("apply-calibration", apply.clone()).unwrap_err().code, "exists");

    // A calibration that replaces one can be taken back.
    let file = window.ask("profile-view", json!({"kind": "material", "id": "my-wire"}))["file"].clone();
    let before = std::fs::read(file.as_str().unwrap()).unwrap();
    // The slip is measured again.
    window.ask("calibrate-enter", json!({"sheet": sheet, "readings": ["angle-60:1=58,58.4"]}));
    let mut again = apply;
    again["force"] = json!(true);
    window.ask("apply-calibration", again);
    assert_ne!(std::fs::read(file.as_str().unwrap()).unwrap(), before);
    for (kind, id) in [("machine", "my-kit"), ("material", "my-wire")] {
        assert_eq!(window.ask("profile-view", json!({"kind": kind, "id": id}))["has_last_change"], true);
        window.ask("revert-profile", json!({"kind": kind, "id": id, "keys": []}));
    }
    assert_eq!(std::fs::read(file.as_str().unwrap()).unwrap(), before);
}
