//! The cube on a machine with coarse gears, so that a line takes a second: what it should come to.

use std::path::PathBuf;
use std::sync::OnceLock;

use serde_json::{Value, json};

use crate::jobs::at_port::AtPort;
use crate::jobs::bender::{Gears, Pulse};
use crate::jobs::shop::{Shop, example};
use wirebend_tests_firmware::board::{Board, Host};

pub const GEARS: Gears =
    Gears { feed_steps_per_mm: 5.444, rotate_steps_per_turn: 1646, bend_steps_per_turn: 2148 };

pub const MACHINE: &str = "coarse-kit";

/// The machine's profile.
pub fn coarse() -> Value {
    json!({
        "schema_version": 1, "kind": "machine", "id": MACHINE, "inherits": "wirebend-kit", "name": "Coarse kit",
        // What the machine needs for a bend besides its moves, so that a port is not waited for longer than it has to be.
        "time": { "fixed_per_bend_s": { "value": 0.5, "source": "These settings, on the core", "measured": true } },
        "driver": { "settings": {
            // A port that does not reset its board is waited for so long.
            "boot_s": 0.2,
            "feed_steps_per_mm": GEARS.feed_steps_per_mm,
            "rotate_steps_per_turn": GEARS.rotate_steps_per_turn,
            "bend_steps_per_turn": GEARS.bend_steps_per_turn,
            "feed_rate_mm_per_s": 300.0, "rotate_rate_deg_per_s": 720.0, "bend_rate_deg_per_s": 900.0,
            "feed_acceleration_mm_per_s2": 6000.0, "rotate_acceleration_deg_per_s2": 10000.0,
            "bend_acceleration_deg_per_s2": 12000.0, "peg_time_ms": 60,
            "home_fast_rate_deg_per_s": 400.0, "home_slow_rate_deg_per_s": 20.0, "home_back_off_deg": 3.0,
        } },
    })
}

/// A job, and the board for it.
pub struct Job {
    pub shop: Shop,
    pub file: PathBuf,
    /// Settings, as the board has stored them.
    pub stored: Vec<u8>,
    whole: OnceLock<Whole>,
}

/// What the machine does when nothing interrupts it.
pub struct Whole {
    pub pulses: Vec<Pulse>,
    pub corners: Vec<[f64; 3]>,
}

impl Job {
    /// Planned once for all tests of a process.
    pub fn cube() -> &'static Self {
        static CUBE: OnceLock<Job> = OnceLock::new();
        CUBE.get_or_init(Self::plan)
    }

    fn plan() -> Self {
        let shop = Shop::new(&[coarse()]);
        let file = shop.path("cube.wbjob");
        let job = file.to_str().unwrap();
        shop.ran("whole", &["plan", &example("cube-8-edges.obj"), "--machine", MACHINE, "-o", job]).ended(0);
        let at = AtPort::<Host>::new(GEARS, None, true);
        let settings = ["machine-settings", "--machine", MACHINE, "--port", &at.port, "--write", "--yes"];
        shop.ran("whole", &settings).ended(0);
        let stored = at.with(|bender| bender.board.stored());
        Self { shop, file, stored, whole: OnceLock::new() }
    }

    /// Run the first time that a test asks, which takes as long as a cube does.
    pub fn whole(&self) -> &Whole {
        self.whole.get_or_init(|| {
            let at = AtPort::<Host>::new(GEARS, Some(&self.stored), true);
            let run = ["run", self.file.to_str().unwrap(), "--port", &at.port, "--yes"];
            self.shop.ran("whole", &run).ended(0);
            let bender = at.board.stop().unwrap();
            assert_eq!(bender.incidents(), Vec::<String>::new());
            let (pulses, corners) = (bender.pulses.job().to_vec(), bender.made().corners());
            assert_eq!(corners.len(), 9, "{corners:?}");
            Whole { pulses, corners }
        })
    }
}
