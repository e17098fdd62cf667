//! The words for the Arduino bender of howtomechatronics.com, read by a few lines of our own.

use serde_json::Value;
use wirebend_core::bend::Step;
use wirebend_core::units::{Angle, Length};

use crate::exports::bounds::Off;
use crate::exports::compared::{Rounding, assert_near, assert_numbers, axes, other_hand, path};
use crate::exports::is_flat;
use crate::exports::planned::each_case;

const MACHINE: &str = "howtomechatronics";

/// `f38`, `z90`, `b-45` between `manual` and `end`.
fn words(text: &str) -> Vec<(char, i32)> {
    let mut lines = text.lines();
    assert_eq!((lines.next(), lines.next_back()), (Some("manual"), Some("end")), "{text}");
    let word = |line: &str| {
        let (letter, number) = line.split_at(1);
        let number: i32 = number.parse().unwrap_or_else(|error| panic!("{error}: '{line}'"));
        // The sketch turns its motor without end for a feed below zero, and counts to 682 mm.
        assert!(letter != "f" || (1..=682).contains(&number), "{line}");
        (letter.chars().next().unwrap(), number)
    };
    lines.map(word).collect()
}

/// The steps that words give. A long feed is several words: as many as it takes to come as near to what was meant as
/// whole numbers can when what is left over goes to the next.
fn steps_of(words: &[(char, i32)], meant: &[Step]) -> Vec<Step> {
    let mut left = words.iter().copied().peekable();
    let (mut fed, mut meant_fed) = (0, 0.0);
    let angle = |deg: Option<i32>| Angle::from_deg(f64::from(deg.unwrap_or_default())).unwrap();
    let step = |step: &Step| {
        let mut word = |letter| left.next_if(|(found, _)| *found == letter).map(|(_, number)| number);
        let before = fed;
        meant_fed += step.feed.mm();
        while let Some(part) = word('f') {
            fed += part;
            if (f64::from(fed) - meant_fed).abs() <= 0.5 + 1e-9 {
                break;
            }
        }
        let feed = Length::from_mm(f64::from(fed - before)).unwrap();
        Step { feed, rotate: angle(word('z')), bend: angle(word('b')) }
    };
    let steps = meant.iter().map(step).collect();
    assert_eq!(left.next(), None, "words that no step needs");
    steps
}

/// Bends in one plane add up, and so are rounded in their sum; those in another plane start anew. The planes are those
/// of the words, whose rotations are whole.
fn assert_bends(case: &str, read: &[Step], meant: &[Step]) {
    let (mut at, mut plane) = (0.0, None);
    let mut sums: (Vec<f64>, Vec<f64>) = Default::default();
    for (read, meant) in read.iter().zip(meant) {
        at += read.rotate.deg().round();
        if meant.bend.deg().abs() < 1e-9 {
            assert!(read.bend.abs().deg() < 0.5, "{case}: a bend that was not asked for");
            continue;
        }
        // Whole numbers, so that they can be compared as they are.
        let here = Some(at.rem_euclid(180.0).round());
        if plane != here {
            (plane, sums) = (here, Default::default());
        }
        let side = if at.rem_euclid(360.0) < 179.5 { 1.0 } else { -1.0 };
        sums.0.push(side * read.bend.deg());
        sums.1.push(side * meant.bend.deg());
        assert_numbers(&format!("{case}: bend"), &sums.0, &sums.1, 1.0, Rounding::Sum);
    }
}

/// Feeds, rotations and the bends of a plane are never more than half a unit in all from where they should be. So a step
/// is off by a whole unit at most, and a wire by what that makes along it: tens of millimetres where it is long, in
/// which a mirror image could hide. The sums of the rotations distinguish the hands.
///
/// The arm ends at 130 degrees (1400 steps of 1/16 degree from its switch, and 43 more to the other side), from which
/// springback takes 3: bunny, teapot, the folded wire and the Z with corners of 135 degrees bend more.
#[test]
fn every_case_is_the_wire_of_its_words() {
    let settings = Value::Null;
    let outcomes = each_case(MACHINE, "howtomechatronics-serial", &settings, |planned, wires, texts| {
        for (wire, text) in wires.iter().zip(texts) {
            let (case, meant) = (&planned.name, &wire.compensated);
            let steps = steps_of(&words(text), meant);
            let ([feeds, rotations, _], [meant_feeds, meant_rotations, _]) = (axes(&steps), axes(meant));
            assert_numbers(&format!("{case}: feed"), &feeds, &meant_feeds, 1.0, Rounding::Sum);
            assert_numbers(&format!("{case}: rotate"), &rotations, &meant_rotations, 1.0, Rounding::Sum);
            assert_bends(case, &steps, meant);
            let off = vec![Off { feed_mm: 1.0, angles_deg: 2.0 }; steps.len()];
            assert_near(case, &path(&steps), &path(meant), &off);
            let turned = |steps: &[Step]| -> Vec<f64> {
                let sums = steps.iter().scan(0.0, |sum, step| {
                    *sum += step.rotate.deg();
                    Some(*sum)
                });
                sums.collect()
            };
            let (read, image) = (turned(&steps), turned(&other_hand(meant)));
            let apart = read.iter().zip(&image).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(is_flat(case) || apart > 10.0, "{case}: the mirror image is {apart} degrees away");
        }
    });
    let not_bent = ["bunny", "fold-back", "teapot", "two-parts"].map(|case| (case, "compensated"));
    let not_planned = [&not_bent[..1], &[("cube-not-doubled", "route")], &not_bent[1..]].concat();
    outcomes.assert(15, &not_planned, &[]);
    // The reason, from the designs themselves.
    each_case("table-bender", "xyz-csv", &Value::Null, |planned, wires, _| {
        let bends = wires.iter().flat_map(|wire| &wire.nominal).map(|step| step.bend.deg());
        let sharpest = bends.fold(0.0, f64::max);
        let not_bent = not_bent.iter().any(|(case, _)| *case == planned.name);
        assert_eq!(not_bent, sharpest > 127.0, "{}: {sharpest}", planned.name);
    });
}
