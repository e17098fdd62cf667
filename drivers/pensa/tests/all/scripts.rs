//! Scripts as examples: what a person finds in the file.

use wirebend_driver_api::conformance::{self, sample_job};
use wirebend_driver_api::{DriverError, Encoded, Job, MachineDriver, Step};
use wirebend_driver_pensa::{Case, Comments, Extension, Pensa, Settings};

fn encoded(settings: Settings, job: &Job) -> Encoded {
    Pensa::open(settings).unwrap().encode("pensa-script", job).unwrap()
}

fn script(settings: Settings, steps: &[(f64, f64, f64)]) -> String {
    encoded(settings, &job_of(steps)).files.remove(0).text
}

fn refusal(steps: &[(f64, f64, f64)]) -> DriverError {
    Pensa::open(Settings::default()).unwrap().encode("pensa-script", &job_of(steps)).unwrap_err()
}

/// Notes as code and message.
fn notes(settings: Settings, steps: &[(f64, f64, f64)]) -> Vec<(String, usize, String)> {
    let notes = encoded(settings, &job_of(steps)).notes;
    notes.into_iter().map(|note| (note.code, note.count, note.message)).collect()
}

/// The sample with these steps for the machine.
fn job_of(steps: &[(f64, f64, f64)]) -> Job {
    let step =
        |&(feed_mm, rotate_deg, bend_deg): &_| Step { feed_mm, rotate_deg, bend_deg, approach_deg: None };
    let mut job = sample_job();
    job.wires[0].machine = Some(steps.iter().map(step).collect());
    job
}

fn bare() -> Settings {
    Settings { comments: Comments::None, ..Settings::default() }
}

#[test]
fn keeps_the_rules() {
    conformance::assert_kept::<Pensa>();
}

/// `FEED 61.23724`, `BEND 120.00000` and `BEND -120.00000` are lines of the published program
/// `AccuracyTest_TetraTruss.txt`, whose struts are 50·√(3/2) mm long. The rest follows from the rule that
/// feeds are always written and turns of zero never.
#[test]
fn a_script_is_spelled_as_published_programs_are() {
    let strut = 50.0 * 1.5_f64.sqrt();
    let steps = [
        (strut, 0.0, 120.0),
        (strut, -70.528_78, -120.0),
        (strut, 0.0, -0.000_001),
        (0.0, 0.0, 10.0),
        (5.0, 30.0, 0.0),
    ];
    let expected = "FEED 61.23724\nBEND 120.00000\nFEED 61.23724\nROTATE -70.52878\nBEND -120.00000\n\
                    FEED 61.23724\nFEED 0.00000\nBEND 10.00000\nFEED 5.00000\n";
    assert_eq!(script(bare(), &steps), expected);
}

#[test]
fn the_first_line_says_which_design_it_is() {
    let text = script(Settings::default(), &[(5.0, 0.0, 0.0)]);
    assert_eq!(text, format!("(design {})\nFEED 5.00000\n", "a5".repeat(32)));
}

/// A line of its own would be run by the machine.
#[test]
fn a_comment_cannot_be_left_from_inside() {
    let job = Job { design_hash: "a) b (\nFEED 900".to_owned(), ..job_of(&[(5.0, 0.0, 0.0)]) };
    let text = encoded(Settings::default(), &job).files.remove(0).text;
    assert_eq!(text, "(design a] b [ FEED 900)\nFEED 5.00000\n");
}

#[test]
fn spelling_and_decimals_are_settings() {
    let written =
        |case| script(Settings { case, decimals: 2, ..bare() }, &[(5.0, 0.0, 45.0), (5.0, 0.0, 0.0)]);
    assert_eq!(written(Case::Upper), "FEED 5.00\nBEND 45.00\nFEED 5.00\n");
    assert_eq!(written(Case::Lower), "feed 5.00\nbend 45.00\nfeed 5.00\n");
    assert_eq!(written(Case::Title), "Feed 5.00\nBend 45.00\nFeed 5.00\n");
    let settings = |text: &str| serde_json::from_str::<Settings>(text);
    assert_eq!(settings(r#"{"case": "title", "comments": "none"}"#).unwrap().case, Case::Title);
    assert!(settings(r#"{"case": "Title"}"#).unwrap_err().to_string().contains("`title`"));
}

/// The pin is down whenever the wire moves along or about itself, up whenever it is bent, and no command
/// repeats what the one before has done.
#[test]
fn the_pin_is_out_of_the_way_between_bends() {
    let steps = [(10.0, 0.0, 45.0), (20.0, 90.0, 0.0), (30.0, 0.0, 45.0), (40.0, 0.0, 0.0)];
    let text = script(Settings { pin_between: true, decimals: 0, ..bare() }, &steps);
    let expected = "PINZ -5\nFEED 10\nPINZ 0\nBEND 45\n\
                    PINZ -5\nFEED 20\nROTATE 90\nFEED 30\nPINZ 0\nBEND 45\n\
                    PINZ -5\nFEED 40\n";
    assert_eq!(text, expected);
    let lower = Settings { pin_between: true, case: Case::Lower, ..bare() };
    assert!(script(lower, &steps).starts_with("pinz -5\nfeed 10.00000\npinz 0\n"));
}

/// 10.4, 20.3 and -0.3 are 0.4, 0.3 and 0.3 from the whole numbers that are written; 30 and 90 are whole.
#[test]
fn rounding_that_can_be_seen_is_said() {
    let steps = [(10.4, 20.3, 90.0), (30.0, 0.0, -0.3), (5.0, 0.0, 0.0)];
    let coarse = Settings { decimals: 0, ..bare() };
    assert_eq!(script(coarse.clone(), &steps), "FEED 10\nROTATE 20\nBEND 90\nFEED 30\nFEED 5\n");
    let message = "values rounded by more than 0.05: 3; feeds by up to 0.400 mm, angles by up to 0.300 \
                   degrees; raise 'decimals' in the driver's settings";
    assert_eq!(notes(coarse, &steps), [("rounded".to_owned(), 3, message.to_owned())]);
    // One decimal is wrong by 0.05 at most, which is not more than 0.05.
    let tenths = Settings { decimals: 1, ..bare() };
    assert_eq!(notes(tenths, &[(10.05, 20.25, 45.35), (5.0, 0.0, 0.0)]), []);
}

#[test]
fn a_script_that_ends_on_a_bend_says_so() {
    let steps = [(10.0, 0.0, 45.0)];
    assert_eq!(script(bare(), &steps), "FEED 10.00000\nBEND 45.00000\n");
    let message = "the script ends on a bend that no feed follows; the wire stays in the head".to_owned();
    assert_eq!(notes(bare(), &steps), [("ends-on-bend".to_owned(), 1, message)]);
}

/// The program names files, so a person reads what their machine wants.
#[test]
fn another_extension_is_said() {
    let text = Settings { extension: Extension::Txt, ..bare() };
    let expected = ("extension".to_owned(), 1, "save it with the ending .txt".to_owned());
    assert_eq!(notes(text, &[(5.0, 0.0, 0.0)]), [expected]);
    assert_eq!(notes(bare(), &[(5.0, 0.0, 0.0)]), []);
    assert_eq!(Pensa::describe().formats[0].extensions, ["dsw", "txt", "diw"]);
}

#[test]
fn what_cannot_be_written_is_named_with_wire_and_step() {
    let line = (5.0, 0.0, 0.0);
    for (step, what) in [
        ((f64::NAN, 0.0, 0.0), "feed is NaN"),
        ((5.0, f64::INFINITY, 0.0), "rotate is inf"),
        ((5.0, 0.0, f64::NEG_INFINITY), "bend is -inf"),
    ] {
        let error = refusal(&[line, step]);
        assert_eq!(error.code, "not-a-number");
        assert_eq!(error.message, format!("wire 1, step 2: {what}, expected a number"));
    }
    let error = refusal(&[]);
    assert_eq!(
        (error.code.as_str(), error.message.as_str()),
        ("empty-wire", "wire 1 has no steps, expected one at least")
    );
    let mut second = sample_job();
    second.wires.push(second.wires[0].clone());
    second.wires[1].machine = None;
    let error = Pensa::open(Settings::default()).unwrap().encode("pensa-script", &second).unwrap_err();
    assert!(error.message.starts_with("wire 2 has no steps for a machine"), "{error}");
}

#[test]
fn settings_and_formats_that_are_not_there_are_named() {
    let error = Pensa::open(Settings { decimals: 10, ..Settings::default() }).unwrap_err();
    assert_eq!(
        (error.code.as_str(), error.message.as_str()),
        ("settings", "'decimals' is 10; it can be 0 to 9")
    );
    let error = Pensa::open(bare()).unwrap().encode("lra-csv", &sample_job()).unwrap_err();
    assert_eq!(error.code, "unknown-format");
    assert!(error.help.contains("pensa-script"), "{}", error.help);
}
