//! Wrong files: a message that names the file, says what and where, and the window continues with what it had.

use super::*;

/// Twenty files that people drop by mistake, or that were written to break something.
#[test]
fn a_wrong_file_is_refused_with_its_name_and_the_design_stays() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "house"}));
    let before = window.ask("start", json!({}))["design"].clone();
    let noise: Vec<u8> = (0..4096_u32).map(|k| k.wrapping_mul(2_654_435_761).to_le_bytes()[2]).collect();
    let document = |text: &str| text.as_bytes().to_vec();
    let mut huge = b"solid x\n".to_vec();
    huge.extend(std::iter::repeat_n(b'9', 300_000));
    let files: Vec<(&str, Vec<u8>)> = vec![
        ("empty.obj", vec![]),
        ("empty.stl", vec![]),
        ("empty.wirebend", vec![]),
        ("noise.obj", noise.clone()),
        ("noise.stl", noise.clone()),
        ("noise.ply", noise.clone()),
        ("noise.3mf", noise.clone()),
        ("noise.glb", noise.clone()),
        ("noise.dxf", noise.clone()),
        ("noise.svg", noise.clone()),
        ("noise.wirebend", noise),
        ("nan.obj", document("v 0 0 nan\nv 1 0 0\nl 1 2\n")),
        ("index.obj", document("v 0 0 0\nv 1 0 0\nl 1 7\n")),
        ("counts.ply", document("ply\nformat ascii 1.0\nelement vertex 99999999999\nend_header\n")),
        ("text.png", document("hello")),
        ("page.html", document("<html><body>no</body></html>")),
        ("really-a-dxf.stl", std::fs::read(example("hook.dxf")).unwrap()),
        ("newer.wirebend", document(r#"{"format": "wirebend", "version": 999}"#)),
        ("newer.wbjob", document(r#"{"format": "wbjob", "version": 999}"#)),
        ("other.wirebend", document(r#"{"hello": 1}"#)),
        ("huge.stl", huge),
        ("bomb.svg", document(&format!("<svg xmlns='http://www.w3.org/2000/svg'>{}", "<g>".repeat(100_000)))),
    ];
    assert!(files.len() >= 20);
    for (name, contents) in files {
        let path = window.file(name, &contents);
        for ask in ["look", "open", "put-stencil", "put-wireframe"] {
            let Err(refusal) = window.try_ask(ask, file(&path)) else {
                // A drawing is known by what is in it.
                assert_eq!(name, "really-a-dxf.stl", "{ask}");
                continue;
            };
            assert!(refusal.message.contains(name), "{ask} {name}: {}", refusal.message);
            assert!(refusal.message.len() < 600, "{ask} {name}: {}", refusal.message);
        }
        if name == "really-a-dxf.stl" {
            window.ask("open-example", json!({"id": "house"}));
        }
    }
    for path in [window.home.path().join("not-there.obj"), window.home.path().to_owned()] {
        let refusal = window.try_ask("open", file(&path)).unwrap_err();
        assert!(refusal.message.contains(path.to_str().unwrap()), "{}", refusal.message);
    }
    let after = window.ask("start", json!({}))["design"].clone();
    assert_eq!((&before["edges"], &before["vertices"]), (&after["edges"], &after["vertices"]));
}

/// Profiles that inherit from each other in a circle are left out, and said at the start.
#[test]
fn wrong_profiles_are_told_at_the_start_and_the_others_stay() {
    let home = tempfile::tempdir().unwrap();
    let machines = home.path().join("own/machines");
    std::fs::create_dir_all(&machines).unwrap();
    let profile = |id: &str, parent: &str| {
        format!(r#"{{"schema_version": 1, "kind": "machine", "id": "{id}", "inherits": "{parent}"}}"#)
    };
    std::fs::write(machines.join("one.json"), profile("one", "two")).unwrap();
    std::fs::write(machines.join("two.json"), profile("two", "one")).unwrap();
    std::fs::write(machines.join("garbage.json"), "{").unwrap();
    std::fs::write(machines.join("fine.json"), profile("fine", "wirebend-kit")).unwrap();
    let window = Window::at(home);
    let warnings = window.ask("start", json!({}))["warnings"].to_string();
    for word in ["one.json", "two.json", "garbage.json"] {
        assert!(warnings.contains(word), "{warnings}");
    }
    let machines = window.ask("machines", json!({}))["machines"].to_string();
    assert!(machines.contains("\"fine\"") && !machines.contains("\"one\""), "{machines}");
}
