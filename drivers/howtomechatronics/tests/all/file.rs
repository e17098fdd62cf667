//! Files: what is written, what is said about it, and what is refused.

use proptest::prelude::*;
use serde_json::{Value, json};
use wirebend_driver_api::conformance::{self, mirrored_job, sample_job};
use wirebend_driver_api::{DriverError, Encoded, Job, MachineDriver, Step};
use wirebend_driver_howtomechatronics::{HowToMechatronics, Settings};

fn encode(settings: Settings, job: &Job) -> Result<Encoded, DriverError> {
    HowToMechatronics::open(settings).unwrap().encode("howtomechatronics-serial", job)
}

/// The sample with these steps for the machine.
fn job_of(steps: &[(f64, f64, f64)]) -> Job {
    let step =
        |&(feed_mm, rotate_deg, bend_deg): &_| Step { feed_mm, rotate_deg, bend_deg, approach_deg: None };
    let mut job = sample_job();
    job.wires[0].machine = Some(steps.iter().map(step).collect());
    job
}

fn notes(encoded: &Encoded) -> Vec<(&str, usize)> {
    encoded.notes.iter().map(|note| (note.code.as_str(), note.count)).collect()
}

#[test]
fn keeps_the_rules() {
    conformance::assert_kept::<HowToMechatronics>();
}

/// The numbers are those of the sample job, which are whole; feed, rotate, bend is the order of a step.
#[test]
fn a_job_of_whole_numbers_is_written_as_it_is() {
    let encoded = encode(Settings::default(), &sample_job()).unwrap();
    let expected = "manual\nf60\nz90\nb90\nf40\nz-90\nb90\nf50\nz45\nb-60\nf70\nend\n";
    assert_eq!(encoded.files[0].text, expected);
    assert_eq!(notes(&encoded), [("no-hash", 1), ("line-by-line", 1)], "nothing was rounded");
}

/// A person has to hear what whole numbers do to the wire: here 3 × 10.4 mm are 31 instead of 31.2.
#[test]
fn rounding_is_told_with_its_size() {
    let mut job = job_of(&[(10.4, 0.0, 0.0), (10.4, 0.0, 45.5), (10.4, 0.0, 0.0)]);
    job.wires.push(mirrored_job().wires.remove(0));
    let encoded = encode(Settings::default(), &job).unwrap();
    assert_eq!(encoded.files[0].text, "manual\nf10\nf11\nb46\nf10\nend\n");
    assert_eq!(notes(&encoded), [("no-hash", 2), ("line-by-line", 2), ("rounded", 4)]);
    let message = &encoded.notes[2].message;
    // f11 stands for 10.4, and 31 for 31.2; b46 for 45.5, with nothing after it to correct that.
    assert!(
        message.contains("a feed is off by up to 0.60 mm and all of them together by 0.20 mm"),
        "{message}"
    );
    assert!(
        message.contains("a bend by up to 0.50 degrees and those in one plane together by 0.50"),
        "{message}"
    );
}

/// The note promises what is kept: here 45.4 and 45.4 in two planes are 45 each, which nothing makes up for, and the
/// last bend has only 0.1 left over.
#[test]
fn what_a_plane_lacks_at_its_end_is_told() {
    let encoded =
        encode(Settings::default(), &job_of(&[(1.0, 0.0, 45.4), (1.0, 90.0, 45.4), (1.0, 90.0, 30.1)]));
    let encoded = encoded.unwrap();
    assert_eq!(encoded.files[0].text, "manual\nf1\nb45\nf1\nz90\nb45\nf1\nz90\nb30\nend\n");
    let message = &encoded.notes[2].message;
    assert!(
        message.contains("a bend by up to 0.40 degrees and those in one plane together by 0.40"),
        "{message}"
    );
}

#[test]
fn a_long_feed_is_divided_and_told() {
    let settings = Settings { most_feed_mm: 300, ..Settings::default() };
    let encoded = encode(settings, &job_of(&[(700.0, 0.0, 90.0), (300.0, 0.0, 0.0)])).unwrap();
    assert_eq!(encoded.files[0].text, "manual\nf300\nf300\nf100\nb90\nf300\nend\n");
    assert_eq!(notes(&encoded)[2], ("divided-feed", 1));
}

#[test]
fn a_feed_below_zero_is_refused_with_its_place() {
    let error = encode(Settings::default(), &job_of(&[(10.0, 0.0, 90.0), (-2.5, 0.0, 0.0)])).unwrap_err();
    assert_eq!(error.code, "negative-feed");
    assert!(error.message.starts_with("wire 1, step 2: feed is -2.5 mm"), "{error}");
}

#[test]
fn settings_out_of_range_are_named() {
    for (key, value) in [
        ("baud", json!(0)),
        ("boot_s", json!(-1)),
        ("feed_rate_mm_per_s", json!(0)),
        ("margin_percent", json!(1001)),
        ("most_feed_mm", json!(0)),
    ] {
        let settings = serde_json::from_value(json!({ key: value })).unwrap();
        let error = HowToMechatronics::open(settings).unwrap_err();
        assert!(error.message.starts_with(&format!("'{key}' is {value}; it can be")), "{error}");
    }
    let error = HowToMechatronics::open(Settings { command_s: f64::NAN, ..Settings::default() }).unwrap_err();
    assert!(error.message.starts_with("'command_s' is NaN"), "{error}");
}

/// A machine that is chosen from the list has to work as it is.
#[test]
fn the_shipped_profile_names_this_driver_and_settings_that_it_takes() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../machine-profiles/machines/howtomechatronics.json");
    let profile: Value = serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap();
    let description = HowToMechatronics::describe();
    assert_eq!(profile["driver"]["id"], description.id);
    assert!(description.format(profile["export"]["native"].as_str().unwrap()).is_some());
    let settings: Settings = serde_json::from_value(profile["driver"]["settings"].clone()).unwrap();
    HowToMechatronics::open(settings.clone()).unwrap();
    // The time model of plans and the clock of the driver are of one machine.
    let rates = [
        ("/feed/rate_mm_per_s/value", settings.feed_rate_mm_per_s),
        ("/rotate/rate_deg_per_s/value", settings.rotate_rate_deg_per_s),
        ("/bend/rate_deg_per_s/value", settings.bend_rate_deg_per_s),
    ];
    for (place, rate) in rates {
        assert_eq!(profile.pointer(place).and_then(Value::as_f64), Some(rate), "{place}");
    }
}

/// What a machine does that reads the file, in order: `f`, `z` or `b`, and its number.
fn read_back(text: &str) -> Vec<(char, i64)> {
    let body = text.strip_prefix("manual\n").unwrap().strip_suffix("end\n").unwrap();
    let word = |line: &str| {
        let number: i64 = line[1..].parse().unwrap();
        assert_ne!(number, 0, "a command that does nothing");
        assert!(!line.starts_with('f') || (1..=682).contains(&number), "a feed that never ends: {line}");
        (line.chars().next().unwrap(), number)
    };
    body.lines().map(word).collect()
}

/// What all words of an axis add up to.
fn sum(words: &[(char, i64)], axis: char) -> i64 {
    words.iter().filter(|(letter, _)| *letter == axis).map(|(_, number)| number).sum()
}

/// Half a unit, and what the last bits of floats do.
fn near(made: i64, exact: f64) -> bool {
    #[allow(clippy::cast_precision_loss)] // far below 2^53
    let error = made as f64 - exact;
    error.abs() <= 0.5 + 1e-6
}

/// Rotations within a plane and out of it, those that round to such ones among them.
fn rotation() -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => prop::sample::select(vec![0.0, 180.0, -180.0, 360.0, 90.0, -90.0]),
        1 => -0.6..0.6_f64,
        1 => 179.0..181.0_f64,
        1 => -180.0..180.0_f64,
    ]
}

proptest! {
    /// However long the wire: its feeds and rotations end within half a unit of the job.
    #[test]
    fn the_error_of_a_wire_does_not_grow(
        steps in prop::collection::vec((0.0..900.0_f64, -180.0..180.0_f64, -130.0..130.0_f64), 0..200),
    ) {
        let words = read_back(&encode(Settings::default(), &job_of(&steps)).unwrap().files[0].text);
        for (axis, exact) in [
            ('f', steps.iter().map(|step| step.0).sum::<f64>()),
            ('z', steps.iter().map(|step| step.1).sum()),
        ] {
            let made = sum(&words, axis);
            prop_assert!(near(made, exact), "{axis}: {made} for {exact}");
        }
    }

    /// Bends that follow one another in one plane turn the wire by what the job says, within half a degree; so
    /// does each bend that is alone in its plane. The planes are those of the file, whose rotations are whole.
    #[test]
    fn a_wire_turns_in_each_plane_by_what_was_asked(
        turns in prop::collection::vec((rotation(), prop_oneof![Just(0.0), -1.0..1.0_f64, -130.0..130.0_f64]), 0..100),
    ) {
        // Every step has a feed, which shows in the file where it begins.
        let steps: Vec<_> = turns.iter().map(|&(rotate, bend)| (10.0, rotate, bend)).collect();
        let words = read_back(&encode(Settings::default(), &job_of(&steps)).unwrap().files[0].text);
        let made: Vec<_> = words.split(|word| *word == ('f', 10)).skip(1).collect();
        prop_assert_eq!(made.len(), steps.len());
        // Where the bend axis points, degrees, and the plane and the sums of the bends that are looked at.
        let (mut at, mut plane, mut made_sum, mut asked_sum) = (0, None, 0, 0.0);
        for (n, (words, (_, _, asked))) in made.into_iter().zip(&steps).enumerate() {
            at += sum(words, 'z');
            if *asked == 0.0 {
                prop_assert_eq!(sum(words, 'b'), 0, "step {} bends nothing", n);
                continue;
            }
            let here = Some(at.rem_euclid(180));
            if plane != here {
                (plane, made_sum, asked_sum) = (here, 0, 0.0);
            }
            // Above half a turn the axis points the other way.
            let way = if at.rem_euclid(360) < 180 { 1 } else { -1 };
            made_sum += way * sum(words, 'b');
            asked_sum += if way > 0 { *asked } else { -asked };
            prop_assert!(near(made_sum, asked_sum), "step {n}: {made_sum} for {asked_sum}");
        }
    }

    /// The same in steps smaller than a unit, where everything is carried; the bends are in one plane.
    #[test]
    fn small_steps_are_not_lost(size in 0.001..0.5_f64, count in 1_u32..500) {
        let made = |step: (f64, f64, f64)| {
            let steps = vec![step; usize::try_from(count).unwrap()];
            read_back(&encode(Settings::default(), &job_of(&steps)).unwrap().files[0].text)
        };
        let (arc, twist) = (made((size, 0.0, size)), made((size, -size, 0.0)));
        let sums = [sum(&arc, 'f'), sum(&arc, 'b'), -sum(&twist, 'z')];
        prop_assert_eq!(sums, [sums[0]; 3], "the axes round alike");
        let exact = size * f64::from(count);
        prop_assert!(near(sums[0], exact), "{} for {exact}", sums[0]);
    }
}
