//! The printed sheet of a calibration, read by a library of others: the lines in true size, and a box for each reading.

use std::f64::consts::PI;

use proptest::prelude::*;
use wirebend_files::write::{CouponSheet, Paper, PrintedCoupon, PrintedReading, coupon_sheet};

use super::pages::{POINTS, Page, pages};

fn angle(deg: f64) -> PrintedCoupon {
    let bend = |wanted| PrintedReading { what: "bend", wanted, unit: "°", is_bend: true };
    PrintedCoupon { name: format!("angle-{deg:.2}"), wire_mm: 180.0, readings: vec![bend(deg), bend(-deg)] }
}

fn side(mm: f64) -> PrintedCoupon {
    let reading = PrintedReading { what: "side", wanted: mm, unit: " mm", is_bend: false };
    PrintedCoupon { name: format!("side-{mm}"), wire_mm: 3.0 * mm, readings: vec![reading] }
}

fn sheet(angles: &[f64], repeats: u32, wire_diameter_mm: f64) -> CouponSheet {
    let coupons = angles.iter().copied().map(angle).chain([side(35.0), side(140.0)]).collect();
    let (machine, material) = ("A bender".into(), "A wire".into());
    CouponSheet { machine, material, wire_diameter_mm, coupons, repeats, paper: Paper::A4 }
}

/// Lines of a page in mm, in a direction.
fn along(page: &Page, deg: f64) -> Vec<[[f64; 2]; 2]> {
    let mm = page.lines.iter().map(|line| line.map(|end| end.map(|value| value / POINTS)));
    let wanted = deg.to_radians();
    mm.filter(|[a, b]| {
        let found = (b[1] - a[1]).atan2(b[0] - a[0]);
        ((found - wanted + PI).rem_euclid(2.0 * PI) - PI).abs() < 1e-3
            && (b[0] - a[0]).hypot(b[1] - a[1]) > 15.0
    })
    .collect()
}

/// Where a line passes the origin, to its left.
fn aside([a, b]: [[f64; 2]; 2], from: [f64; 2]) -> f64 {
    let (x, y) = (b[0] - a[0], b[1] - a[1]);
    (x * (from[1] - a[1]) - y * (from[0] - a[0])) / x.hypot(y)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// A leg of the wire's own thickness lies between two lines whose middle goes through the corner.
    #[test]
    fn a_leg_lies_between_its_lines(
        tens in prop::collection::btree_set(2_u32..14, 1..7),
        diameter in 0.5_f64..6.0,
        repeats in 1_u32..=20,
    ) {
        let angles: Vec<f64> = tens.into_iter().map(|tens| 10.0 * f64::from(tens) + 3.0).collect();
        let pdf = coupon_sheet(&sheet(&angles, repeats, diameter));
        let pages = pages(&pdf.bytes);
        prop_assert_eq!((pages.len(), pdf.missing.len()), (pdf.pages, 0));
        let base = along(&pages[0], 180.0);
        prop_assert_eq!(base.len(), 2);
        // They begin at the corner.
        let corner = [base[0][0][0], f64::midpoint(base[0][0][1], base[1][0][1])];
        for &deg in angles.iter().chain([&180.0]) {
            let lines = along(&pages[0], deg);
            prop_assert_eq!(lines.len(), 2, "{}", deg);
            for line in lines {
                prop_assert!((aside(line, corner).abs() - diameter / 2.0).abs() < 1e-3, "{}: {:?}", deg, line);
            }
        }
        for deg in angles {
            let name = format!("angle-{deg:.2}");
            prop_assert!(pages[0].says(&name));
        }
        prop_assert!(along(&pages[0], 0.0).iter().any(|[a, b]| (b[0] - a[0] - 150.0).abs() < 1e-3));
    }

    /// Nothing that is to be read has no place to be written.
    #[test]
    fn every_reading_has_a_box(count in 1_u32..40, repeats in 1_u32..=20) {
        let angles: Vec<f64> = (1..=count).map(|k| 180.0 * f64::from(k) / f64::from(count + 1)).collect();
        let pdf = coupon_sheet(&sheet(&angles, repeats, 3.0));
        // As high as there is room to write a number.
        let upright = |[a, b]: &&[[f64; 2]; 2]| {
            (a[0] - b[0]).abs() < 1e-6 && ((a[1] - b[1]).abs() - 5.4 * POINTS).abs() < 0.01
        };
        let sides: usize = pages(&pdf.bytes).iter().map(|page| page.lines.iter().filter(upright).count()).sum();
        // Two for each angle, one for each side.
        let boxes = (2 * count + 2) * repeats;
        prop_assert_eq!(sides, 2 * boxes as usize);
        // How much wire to cut for the coupons of 35 and 140 mm.
        for wire in ["105", "420"] {
            prop_assert!(pages(&pdf.bytes).iter().any(|page| page.texts.iter().any(|(_, text)| text == wire)), "{}", wire);
        }
        for page in &pages(&pdf.bytes) {
            prop_assert!(page.texts.iter().all(|([x, y], _)| *x > 0.0 && *y > 0.0 && *x < 210.0 * POINTS));
        }
    }
}
