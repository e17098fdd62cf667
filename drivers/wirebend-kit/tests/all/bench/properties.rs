//! Whatever the pulses, the bench works out a wire.

use std::sync::LazyLock;

use proptest::prelude::*;
use wirebend_driver_api::Axis;
use wirebend_driver_wirebend_kit::bench::{Bench, Bender, Compliance, ErrorTerm, Noise, Peg, Scale, Wire};

use super::hand::pulses;

#[derive(Debug, Clone, Copy)]
enum Deed {
    Pulses(Axis, i64),
    Peg(Peg),
}

fn deeds() -> impl Strategy<Value = Vec<Deed>> {
    let axis = prop_oneof![Just(Axis::Feed), Just(Axis::Rotate), Just(Axis::Bend)];
    let peg = prop_oneof![Just(Peg::In), Just(Peg::Between), Just(Peg::Out)];
    let some = prop_oneof![3 => -60..60_i64, 3 => 0..160_i64, 1 => -400..400_i64];
    let deed = prop_oneof![
        3 => (axis, some).prop_map(|(axis, steps)| Deed::Pulses(axis, steps)),
        2 => peg.prop_map(Deed::Peg),
    ];
    proptest::collection::vec(deed, 0..60)
}

/// A millimetre or a degree a pulse, so that few pulses go far.
const COARSE: Scale = Scale { feed_mm_per_step: 1.0, rotate_deg_per_step: 1.0, bend_deg_per_step: 1.0 };

static BENCH: LazyLock<Bench> = LazyLock::new(|| {
    Bench::new(Bender::PUBLISHED, Wire::PUBLISHED, COARSE, Compliance { deg_per_n_m: 4.0 }).unwrap()
});

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn no_pulses_break_it(deeds in deeds(), seed in 0..4_u64, sigma in prop_oneof![Just(0.0), 0.0..20.0]) {
        let error = ErrorTerm { bias: 0.0, sigma };
        let noise = Noise { seed, feed_mm: error, rotate_deg: error, bend_deg: error };
        let mut bench = BENCH.clone().with_noise(&noise).unwrap().with_bend_axis_at(-90.0).unwrap();
        let mut expected = 0;
        for deed in deeds {
            match deed {
                Deed::Pulses(axis, steps) => {
                    pulses(&mut bench, axis, steps);
                    expected += steps.unsigned_abs();
                }
                Deed::Peg(peg) => bench.peg(peg),
            }
        }
        let made = bench.made();
        prop_assert_eq!(bench.pulses(), expected);
        prop_assert!(bench.incidents().is_sorted_by_key(|incident| incident.pulse));
        for point in made.corners().iter().chain(&made.centreline(0.1)) {
            prop_assert!(point.iter().all(|x| x.is_finite()), "{made:?}");
        }
        prop_assert!(made.length_mm() >= 0.0);
        prop_assert!(made.bends().iter().all(|bend| bend.angle_deg.is_finite() && bend.radius_mm > 0.0));
        prop_assert!(made.deviations(&made.corners()).is_ok());
        // Asking changes nothing.
        prop_assert_eq!(made, bench.made());
    }

    /// Any bender that is taken gives angles that rise with the axis, whatever its figures.
    #[test]
    fn no_figures_break_it(
        pin in -1.0..20.0_f64,
        rod in 0.1..20.0_f64,
        orbit in 0.1..60.0_f64,
        offset in -1.0..40.0_f64,
        limit in 10.0..190.0_f64,
        diameter in 0.1..10.0_f64,
        k_factor in -0.1..1.1_f64,
        ultimate in 200.0..2000.0_f64,
    ) {
        let bender = Bender {
            pin_radius_mm: pin,
            rod_radius_mm: rod,
            orbit_radius_mm: orbit,
            orbit_offset_mm: offset,
            axis_limit_deg: limit,
        };
        let wire = Wire {
            diameter_mm: diameter,
            k_factor,
            ultimate_strength_mpa: ultimate,
            ..Wire::PUBLISHED
        };
        let Ok(bench) = Bench::new(bender, wire, COARSE, Compliance::RIGID) else { return Ok(()) };
        let mut before = 0.0;
        for axis_deg in [20, 60, 100, 140] {
            let mut bench = bench.clone();
            pulses(&mut bench, Axis::Feed, 300);
            pulses(&mut bench, Axis::Bend, -90);
            bench.peg(Peg::Out);
            pulses(&mut bench, Axis::Bend, 90 + axis_deg);
            pulses(&mut bench, Axis::Bend, -90 - axis_deg);
            bench.peg(Peg::In);
            let angle = bench.made().bends().first().map_or(0.0, |bend| bend.angle_deg);
            prop_assert!(f64::from(i32::try_from(axis_deg).unwrap()) > limit || angle >= before, "{angle} after {before}");
            before = angle;
        }
    }
}
