//! Typing errors are found and named, and readings that are right are not accused.

use super::*;

/// How a person mistypes a number: digits swapped, struck twice or left out, a point left out, a key beside the right one.
/// What is off by less than 4 degrees shows in no table that scatters by half a degree, and is not taken for one.
fn mistyped(reading: f64, random: &mut Normals) -> f64 {
    loop {
        let mut typed: Vec<char> = format!("{reading:.1}").chars().collect();
        let at = random.below(u32::try_from(typed.len() - 2).unwrap()) as usize;
        match random.below(5) {
            0 => typed.swap(0, 1),
            1 => typed.insert(at, typed[at]),
            2 => drop(typed.remove(at)),
            3 => typed.retain(|&typed| typed != '.'),
            _ => typed[at] = char::from(b'0' + u8::try_from(random.below(10)).unwrap()),
        }
        let typed: f64 = typed.into_iter().collect::<String>().parse().unwrap_or(reading);
        if (typed - reading).abs() >= 4.0 {
            return typed;
        }
    }
}

/// A table of 14 to 20 angles to both sides, with repeats or without, of a machine near the published one.
fn table(random: &mut Normals) -> Vec<AngleSample> {
    let mut near = |value: f64| value * (1.0 + random.next(0.05));
    let truth = machine([near(20.4), near(12.0), near(3.0), near(4.675)], near(10.23));
    let repeats = 1 + random.below(2) as usize;
    let count = 14 + random.below(7);
    let angles: Vec<f64> = (0..count).map(|k| 20.0 + 115.0 * f64::from(k) / f64::from(count - 1)).collect();
    ladder(&truth, &angles, repeats, 0.5, random)
}

fn fitted(angles: Vec<AngleSample>) -> Vec<LeftOut> {
    let measured = Measurements { angles, ..Measurements::default() };
    calibrate(&published(), &measured, ShapeChoice::Better).unwrap().left_out
}

#[test]
fn a_typing_error_is_found_in_each_of_a_hundred_tables() {
    let mut random = Normals::new(80_725);
    for round in 0..100 {
        let mut angles = table(&mut random);
        let place = ReadingPlace {
            sample: random.below(u32::try_from(angles.len()).unwrap()) as usize,
            repeat: random.below(u32::try_from(angles[0].readings.len()).unwrap()) as usize,
        };
        let reading = &mut angles[place.sample].readings[place.repeat];
        let right = reading.unwrap().abs().deg();
        let typed = mistyped(right, &mut random);
        *reading = Some(deg(typed));
        let left_out = fitted(angles);
        let named = left_out.iter().find(|left| left.place == place);
        let named =
            named.unwrap_or_else(|| panic!("round {round}: {right:.1} typed as {typed} is not found"));
        assert!((named.expected.plain().abs() - right).abs() < 12.0, "{named:?} for {right:.1}");
        assert!(left_out.len() <= 2, "round {round}: {left_out:?}");
    }
}

#[test]
fn nothing_is_accused_in_at_least_95_of_a_hundred_tables_without_an_error() {
    let mut random = Normals::new(14);
    let accused = (0..100).filter(|_| !fitted(table(&mut random)).is_empty()).count();
    assert!(accused <= 5, "{accused} of 100 accused");
}

/// 80 typed as 725 is in a table of an actual machine.
#[test]
fn what_cannot_be_an_angle_is_left_out_and_the_rest_is_fitted() {
    let truth = machine([20.4, 12.0, 3.0, 4.675], 10.23);
    let mut angles = ladder(&truth, &[40.0, 60.0, 80.0, 100.0, 120.0], 2, 0.3, &mut Normals::new(5));
    angles[4].readings[1] = Some(deg(725.0));
    let clean = {
        let mut angles = angles.clone();
        angles[4].readings[1] = None;
        angles
    };
    let fit = |angles| {
        let measured = Measurements { angles, ..Measurements::default() };
        calibrate(&published(), &measured, ShapeChoice::Better).unwrap()
    };
    let (with, without) = (fit(angles), fit(clean));
    assert_eq!(with.left_out.len(), 1);
    assert_eq!(with.left_out[0].reason, LeftOutReason::Impossible);
    assert_eq!(with.left_out[0].place, ReadingPlace { sample: 4, repeat: 1 });
    assert_eq!(with.bends, without.bends);
}
