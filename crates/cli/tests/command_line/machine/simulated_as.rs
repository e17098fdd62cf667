//! A simulated machine that is not what its profile says, as every real one is: calibrating finds out.

use super::board::terminal;
use crate::{Ran, example, run_in};

/// A machine whose profile has the orbit a tenth off, and commands for it on one whose orbit is as published.
struct Shop(tempfile::TempDir);

impl Shop {
    fn new() -> Self {
        let shop = Self(tempfile::tempdir().unwrap());
        let off = ["bend.orbit_radius_mm=22.44", "bend.orbit_offset_mm=13.2"];
        let set =
            ["profile", "set", "mine", "--from", "wirebend-kit", "--kind", "machine", "--source", "a ruler"];
        shop.run(&[&set[..], &off].concat()).ended(0);
        shop
    }

    fn run(&self, arguments: &[&str]) -> Ran {
        run_in(self.0.path(), arguments, b"")
    }

    /// How far off the vertices of the published U-sample are at most, as the machine bends it that is planned for `machine`.
    fn u_sample_off(&self, machine: &str) -> f64 {
        let job = format!("{machine}.wbjob");
        self.run(&["plan", &example("u-sample.obj"), "-m", machine, "-o", &job]).ended(0);
        let bent =
            ["run", &job, "--port", "sim:max", "--yes", "--json", "--simulated-machine", "wirebend-kit"];
        let bent = self.run(&bent).ended(0).json();
        assert_eq!(bent["notes"][0]["code"], "simulated-as", "{bent}");
        let off = bent["wires"][0]["deviations_mm"].as_array().unwrap();
        off.iter().filter_map(serde_json::Value::as_f64).fold(0.0, f64::max)
    }
}

#[test]
fn a_machine_that_its_profile_does_not_know_bends_as_wanted_once_it_is_calibrated() {
    let shop = Shop::new();
    let before = shop.u_sample_off("mine");
    shop.run(&["calibrate", "new", "--machine", "mine", "--angles", "30,60,90,120", "-o", "coupons"])
        .ended(0);
    for (job, wires) in [("angles", 4), ("sides", 2), ("turns", 1)] {
        let job = format!("coupons/{job}.wbjob");
        for wire in 1..=wires {
            let wire = wire.to_string();
            let run = ["run", &job, "--wire", &wire, "--port", "sim:max", "--yes"];
            shop.run(&[&run[..], &["--simulated-machine", "wirebend-kit"]].concat()).ended(0);
        }
        shop.run(&["calibrate", "enter", "coupons/sheet.csv", "--bent", &job]).ended(0);
    }
    let apply = ["--machine-id", "known", "--material-id", "its-wire"];
    shop.run(&[&["calibrate", "apply", "coupons/sheet.csv"], &apply[..]].concat()).ended(0);
    let after = shop.u_sample_off("known");
    // Of its free end, which sums up what both bends and all sides are off.
    assert!(before > 2.0 && after < before / 15.0, "{before} mm before, {after} after");
}

#[test]
fn what_cannot_be_simulated_so_is_refused() {
    let shop = Shop::new();
    shop.run(&["plan", &example("u-sample.obj"), "-m", "mine", "-o", "u.wbjob"]).ended(0);
    let said = |more: &[&str], status: i32| {
        shop.run(&[&["run", "u.wbjob", "--yes"], more].concat()).ended(status).err
    };
    let none = said(&["--port", "sim:max", "--simulated-machine", "table-bender"], 2);
    assert!(none.contains("machine 'table-bender' has no pin and peg"), "{none}");
    assert!(none.contains("leave out --simulated-machine and --simulated-material"), "{none}");
    let unknown = said(&["--port", "sim:max", "--simulated-material", "gold"], 2);
    assert!(unknown.contains("no material has the id `gold`"), "{unknown}");
    let clone = "howtomechatronics";
    shop.run(&["plan", &example("u-sample.obj"), "-m", clone, "-o", "u.wbjob", "--force"]).ended(0);
    let (_far, _near, port) = terminal();
    let real = said(&["--port", &port, "--simulated-machine", "mine"], 2);
    assert!(real.contains("is a real one"), "{real}");
}
