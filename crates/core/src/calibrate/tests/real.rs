//! Tables that others have measured on a machine of theirs: `tests/data/bending-tables` says whose.

#![allow(clippy::print_stdout, reason = "figures, for --nocapture")]

use nalgebra::{DMatrix, DVector};

use super::*;

struct Table {
    name: &'static str,
    text: &'static str,
    orbit: f64,
    diameter: f64,
}

macro_rules! table {
    ($name:literal, $orbit:literal, $diameter:literal) => {
        Table {
            name: $name,
            text: include_str!(concat!("../../../tests/data/bending-tables/", $name, ".csv")),
            orbit: $orbit,
            diameter: $diameter,
        }
    };
}

const TABLES: [Table; 5] = [
    table!("steel-1085-1mm", 12.0, 1.0),
    table!("steel-1085-1.5mm", 12.0, 1.5),
    table!("steel-galvanized-2mm", 12.0, 2.0),
    table!("steel-mild-3.175mm", 16.5, 3.175),
    table!("steel-spring-3mm", 27.5, 3.0),
];

impl Table {
    /// Each angle of the axis with its readings.
    fn samples(&self) -> Vec<AngleSample> {
        let mut samples: Vec<AngleSample> = Vec::new();
        for row in self.text.lines().skip(1) {
            let (axis, left) = row.split_once(',').unwrap();
            let [axis, left] = [axis, left].map(|text| deg(text.trim().parse().unwrap()));
            // Where the pin touches the wire was computed.
            if left == Angle::ZERO {
                continue;
            }
            match samples.iter_mut().find(|sample| sample.axis == axis) {
                Some(sample) => sample.readings.push(Some(left)),
                None => samples.push(AngleSample { axis, side: left.signum(), readings: vec![Some(left)] }),
            }
        }
        samples
    }

    /// The machine as its program has it, whose dimensions nobody has measured.
    fn assumed(&self) -> Assumed {
        let about = |value: f64, deviation: f64| KnownLength { value: mm(value), deviation: mm(deviation) };
        Assumed {
            peg: Some(KnownPeg {
                orbit_radius: about(self.orbit, 0.02 * self.orbit),
                orbit_offset: about(-0.8, 1.0),
                peg_radius: about(3.0 + self.diameter / 2.0, 0.3),
            }),
            bend_radius: about(2.5 + self.diameter / 2.0, 0.3),
            springback: None,
            axis_limit: None,
            diameter: mm(self.diameter),
            ..published()
        }
    }

    fn fitted(&self, angles: Vec<AngleSample>) -> Calibration {
        let measured = Measurements { angles, ..Measurements::default() };
        calibrate(&self.assumed(), &measured, ShapeChoice::Better).unwrap()
    }
}

/// How far off a polynomial of degree 3 is for an angle of the axis that it has not seen: what the source itself fits.
fn cubic_left_out(samples: &[AngleSample]) -> f64 {
    let rows: Vec<(usize, f64, f64)> = samples
        .iter()
        .enumerate()
        .flat_map(|(k, sample)| {
            sample.readings.iter().flatten().map(move |left| (k, sample.axis.rad(), left.deg()))
        })
        .collect();
    let powers = |x: f64| [1.0, x, x * x, x * x * x];
    let mut squared = 0.0;
    for k in 0..samples.len() {
        let seen: Vec<_> = rows.iter().filter(|row| row.0 != k).collect();
        let design = DMatrix::from_fn(seen.len(), 4, |row, column| powers(seen[row].1)[column]);
        let left = DVector::from_iterator(seen.len(), seen.iter().map(|row| row.2));
        let fit = design.svd(true, true).solve(&left, 1e-12).unwrap();
        for row in rows.iter().filter(|row| row.0 == k) {
            let predicted: f64 = powers(row.1).iter().zip(&fit).map(|(power, factor)| power * factor).sum();
            squared += (predicted - row.2).powi(2);
        }
    }
    (squared / rows.iter().map(|_| 1.0).sum::<f64>()).sqrt()
}

#[test]
fn tables_of_another_machine_are_predicted_and_nothing_in_them_is_accused() {
    let (mut ours, mut theirs) = (0.0, 0.0);
    for table in &TABLES {
        let samples = table.samples();
        assert!(samples.len() >= 14, "{}", table.name);
        let cubic = cubic_left_out(&samples);
        let found = table.fitted(samples);
        let bends = found.bends.unwrap();
        let rms = bends.fit.leave_one_out.rms;
        println!(
            "{}: leave-one-out {rms:.2} degrees rms ({:?}), readings scatter by {:.2}; by a polynomial {cubic:.2}",
            table.name,
            bends.shape,
            bends.fit.scatter.plain(),
        );
        assert_eq!(found.left_out, [], "{}", table.name);
        assert!(rms < 2.0, "{}: {rms} degrees", table.name);
        ours += rms;
        theirs += cubic;
    }
    assert!(ours <= theirs, "{ours} degrees in all, by polynomials {theirs}");
}

#[test]
fn a_typing_error_in_any_line_of_them_is_found() {
    for table in &TABLES {
        let clean = table.samples();
        let mut found = 0;
        let mut planted = 0;
        for sample in 0..clean.len() {
            let mut angles = clean.clone();
            let Some(right) = angles[sample].readings[0] else { continue };
            // A digit struck twice: 80 becomes 880, 31 becomes 331.
            let text = format!("{:.0}", right.abs().deg());
            let typed: f64 = format!("{}{text}", &text[..1]).parse().unwrap();
            angles[sample].readings[0] = Some(deg(typed));
            planted += 1;
            let place = ReadingPlace { sample, repeat: 0 };
            found += usize::from(table.fitted(angles).left_out.iter().any(|left| left.place == place));
        }
        println!("{}: {found} of {planted}", table.name);
        assert_eq!(found, planted, "{}", table.name);
    }
}
