//! What can be said of a reading by itself, before anything is fitted: impossible, other side, other unit.

use super::figure::{Figure, ReadingPlace};
use super::least_squares::Datum;
use super::measured::{AngleSample, Kind, LeftOut, LeftOutReason, OtherUnit};
use crate::units::{Angle, Length};

/// Two angles in degrees that are meant as one by a person who read in another unit.
const ABOUT_DEG: f64 = 12.0;
/// The same for lengths, as a part of the expected one.
const ABOUT_PART: f64 = 0.2;
/// An angle this far from the expected one is looked at in other units.
const FAR_DEG: f64 = 25.0;

/// The readings of a kind that can be fitted, and those that cannot.
#[derive(Debug, Default)]
pub(super) struct Screened {
    /// Their samples are counted among those that have readings.
    pub data: Vec<Datum>,
    /// For each datum where it stands.
    pub places: Vec<ReadingPlace>,
    /// For each sample that has data its place among all samples.
    pub samples: Vec<usize>,
    pub left_out: Vec<LeftOut>,
    /// How many readings there were.
    pub given: usize,
}

/// Takes the readings of samples apart. `judge` says for a reading of a sample what it counts as, in mm or degrees, or
/// why not; `expected` what the figures of before make of a sample.
pub(super) fn screen<V: Copy>(
    kind: Kind,
    samples: &[&[Option<V>]],
    figure: impl Fn(V) -> Figure,
    expected: impl Fn(usize) -> Figure,
    judge: impl Fn(usize, V) -> Result<f64, LeftOutReason>,
) -> Screened {
    let mut screened = Screened::default();
    for (sample, readings) in samples.iter().enumerate() {
        for (repeat, reading) in readings.iter().enumerate() {
            let Some(reading) = *reading else { continue };
            screened.given += 1;
            let place = ReadingPlace { sample, repeat };
            match judge(sample, reading) {
                Ok(value) => {
                    if screened.samples.last() != Some(&sample) {
                        screened.samples.push(sample);
                    }
                    screened.places.push(place);
                    screened.data.push(Datum { sample: screened.samples.len() - 1, value, weight: 1.0 });
                }
                Err(reason) => screened.left_out.push(LeftOut {
                    kind,
                    place,
                    reading: figure(reading),
                    expected: expected(sample),
                    reason,
                }),
            }
        }
    }
    screened
}

/// What the readings of a whole table of bends are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ReadAs {
    Bends,
    /// As a protractor shows them.
    InnerAngles,
    Radians,
}

/// A bend, signed as its side; `expected` is its size by the figures of before.
pub(super) fn bend(
    sample: &AngleSample,
    limit: Option<Angle>,
    (expected, read_as): (Angle, ReadAs),
    reading: Angle,
) -> Result<f64, LeftOutReason> {
    if let Some(limit) = limit.filter(|limit| sample.axis.abs() > *limit) {
        return Err(LeftOutReason::AxisOutOfRange { limit });
    }
    if read_as == ReadAs::Radians {
        return Err(LeftOutReason::Unit(OtherUnit::Radians));
    }
    let size = turn(Angle::computed(sample.side), expected, reading)?;
    let (read, wanted) = (size.abs(), expected.abs().deg());
    if read == 0.0 {
        return Err(LeftOutReason::NoBend);
    }
    let is_inner = (read - wanted).abs() > FAR_DEG && (180.0 - read - wanted).abs() < ABOUT_DEG;
    if is_inner || (read_as == ReadAs::InnerAngles && read < 180.0) {
        return Err(LeftOutReason::Unit(OtherUnit::InnerAngle));
    }
    if read >= 180.0 {
        return Err(LeftOutReason::Impossible);
    }
    Ok(size)
}

/// A turn, signed as it was commanded; its own sign may be left out. In degrees.
pub(super) fn turn(commanded: Angle, expected: Angle, reading: Angle) -> Result<f64, LeftOutReason> {
    if commanded > Angle::ZERO && reading < Angle::ZERO {
        return Err(LeftOutReason::OtherSide);
    }
    let (read, wanted) = (reading.abs().deg(), expected.abs().deg());
    if wanted > FAR_DEG && (read.to_degrees() - wanted).abs() < ABOUT_DEG {
        return Err(LeftOutReason::Unit(OtherUnit::Radians));
    }
    if read > 400.0 {
        return Err(LeftOutReason::Impossible);
    }
    Ok(commanded.signum() * read)
}

/// A side from corner to corner, in mm. Another unit is of what was read: over the outside of the wire, half a wire more at either end.
pub(super) fn side(expected: Length, reading: Length, diameter: Length) -> Result<f64, LeftOutReason> {
    let (read, outside, wanted) = (reading.mm(), (reading + diameter).mm(), (expected + diameter).mm());
    let is_in = |factor: f64| (outside * factor / wanted - 1.0).abs() < ABOUT_PART;
    if outside <= 0.0 {
        return Err(LeftOutReason::Impossible);
    }
    if is_in(25.4) {
        return Err(LeftOutReason::Unit(OtherUnit::Inches));
    }
    if is_in(10.0) {
        return Err(LeftOutReason::Unit(OtherUnit::Centimetres));
    }
    if read <= 0.0 {
        return Err(LeftOutReason::Impossible);
    }
    Ok(read)
}
