//! What holds for every script.

use proptest::prelude::*;
use wirebend_driver_api::conformance::sample_job;
use wirebend_driver_api::{MachineDriver, Step};
use wirebend_driver_pensa::{Case, Pensa, Settings};

/// Steps with values that round to nothing in either direction among them. The last has no bend.
fn any_steps() -> impl Strategy<Value = Vec<Step>> {
    let angle = || prop_oneof![6 => -180.0..180.0_f64, 1 => Just(0.0), 1 => -1e-7..1e-7, 1 => Just(-0.0)];
    let feed = || prop_oneof![8 => 0.0..500.0_f64, 1 => Just(0.0)];
    let step = (feed(), angle(), angle()).prop_map(|(feed_mm, rotate_deg, bend_deg)| Step {
        feed_mm,
        rotate_deg,
        bend_deg,
        approach_deg: None,
    });
    let last = (feed(), angle()).prop_map(|(feed_mm, rotate_deg)| Step {
        feed_mm,
        rotate_deg,
        bend_deg: 0.0,
        approach_deg: None,
    });
    (prop::collection::vec(step, 0..20), last).prop_map(|(mut steps, last)| {
        steps.push(last);
        steps
    })
}

fn any_settings() -> impl Strategy<Value = Settings> {
    let case = prop_oneof![Just(Case::Upper), Just(Case::Lower), Just(Case::Title)];
    (case, 0..=9_u8, any::<bool>()).prop_map(|(case, decimals, pin_between)| Settings {
        case,
        decimals,
        pin_between,
        ..Settings::default()
    })
}

/// A machine that runs a script: steps as it runs them, and whether the pin is up.
fn run(script: &str) -> Result<Vec<Step>, String> {
    let mut steps: Vec<Step> = Vec::new();
    let mut pin = None;
    for line in script.lines().filter(|line| !line.starts_with('(')) {
        let (command, value) = line.split_once(' ').ok_or(line)?;
        if value.starts_with("-0") && !value.contains(|c| ('1'..='9').contains(&c)) {
            return Err(format!("minus zero: {line}"));
        }
        let value: f64 = value.parse().map_err(|_| line)?;
        let command = command.to_ascii_uppercase();
        match (command.as_str(), pin) {
            ("FEED" | "ROTATE", Some(up)) if up => return Err(format!("the pin is in the way: {line}")),
            ("BEND", Some(up)) if !up => return Err(format!("the pin is not there: {line}")),
            _ => {}
        }
        match command.as_str() {
            "FEED" => steps.push(Step { feed_mm: value, ..Step::default() }),
            "ROTATE" => steps.last_mut().ok_or("no feed")?.rotate_deg = value,
            "BEND" => steps.last_mut().ok_or("no feed")?.bend_deg = value,
            "PINZ" => pin = Some(value == 0.0),
            _ => return Err(format!("not a command: {line}")),
        }
    }
    Ok(steps)
}

proptest! {
    #[test]
    fn a_machine_makes_the_steps_that_it_was_sent(steps in any_steps(), settings in any_settings()) {
        let mut job = sample_job();
        job.wires[0].machine = Some(steps.clone());
        let half = 0.5 / 10_f64.powi(settings.decimals.into()) + 1e-9;
        let text = Pensa::open(settings).unwrap().encode("pensa-script", &job).unwrap().files.remove(0).text;
        let made = run(&text).map_err(TestCaseError::fail)?;
        prop_assert_eq!(made.len(), steps.len());
        for (n, (made, asked)) in made.iter().zip(&steps).enumerate() {
            prop_assert!((made.feed_mm - asked.feed_mm).abs() <= half, "{:?} {:?}", made, asked);
            prop_assert!((made.bend_deg - asked.bend_deg).abs() <= half, "{:?} {:?}", made, asked);
            // A rotation at the end turns nothing, and is left out.
            let rotate = if n + 1 < steps.len() { asked.rotate_deg } else { 0.0 };
            prop_assert!((made.rotate_deg - rotate).abs() <= half, "{:?} {:?}", made, asked);
        }
        let last = text.lines().last().unwrap_or_default().to_ascii_uppercase();
        prop_assert!(last.starts_with("FEED "), "{}", text);
    }
}
