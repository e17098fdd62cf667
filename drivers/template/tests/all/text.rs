//! What the driver writes, as data.

use template_driver::{Settings, Template};
use wirebend_driver_api::conformance::{self, sample_job};
use wirebend_driver_api::{DriverError, Job, MachineDriver, Step};

fn written(settings: Settings, job: &Job) -> String {
    Template::open(settings).unwrap().encode("template-text", job).unwrap().files.remove(0).text
}

/// The sample with these steps for the machine.
fn job_of(steps: &[(f64, f64, f64)]) -> Job {
    let step =
        |&(feed_mm, rotate_deg, bend_deg): &_| Step { feed_mm, rotate_deg, bend_deg, approach_deg: None };
    let mut job = sample_job();
    job.wires[0].machine = Some(steps.iter().map(step).collect());
    job
}

fn refusal(job: &Job) -> DriverError {
    Template::open(Settings::default()).unwrap().encode("template-text", job).unwrap_err()
}

#[test]
fn keeps_the_rules() {
    conformance::assert_kept::<Template>();
}

/// The numbers are those of the sample job, which are whole.
#[test]
fn a_job_is_a_table_with_its_hash_above() {
    let hash = "a5".repeat(32);
    let expected = format!(
        "# sample for Sample bender, design {hash}\n\
         n, feed_mm, rotate_deg, bend_deg\n\
         1, 60.000, 90.000, 90.000\n\
         2, 40.000, -90.000, 90.000\n\
         3, 50.000, 45.000, -60.000\n\
         4, 70.000, 0.000, 0.000\n"
    );
    assert_eq!(written(Settings::default(), &sample_job()), expected);
}

#[test]
fn comment_header_and_decimals_are_settings() {
    let bare = Settings { decimals: 0, header: false, comment: String::new() };
    assert_eq!(written(bare, &sample_job()), "1, 60, 90, 90\n2, 40, -90, 90\n3, 50, 45, -60\n4, 70, 0, 0\n");
}

/// Ten feeds of 0.4 mm are 4 mm of wire: rounding each alone would feed none at all.
#[test]
fn what_is_rounded_away_is_written_later_and_zero_has_no_sign() {
    let bare = Settings { decimals: 0, header: false, comment: String::new() };
    let text = written(bare, &job_of(&[(0.4, -0.2, -0.4); 10]));
    let sum = |column: usize| -> i64 {
        text.lines().map(|line| line.split(", ").nth(column).unwrap().parse::<i64>().unwrap()).sum()
    };
    assert_eq!((sum(1), sum(2), sum(3)), (4, -2, -4));
    assert!(text.starts_with("1, 0, 0, 0\n"), "{text}");
}

/// A half that was written as a whole must not come back as a turn the other way where there is none.
#[test]
fn a_zero_stays_zero() {
    let bare = Settings { decimals: 1, header: false, comment: String::new() };
    let text = written(bare, &job_of(&[(0.15, -0.05, 0.25), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)]));
    assert_eq!(text.lines().skip(1).collect::<Vec<_>>(), ["2, 0.0, 0.0, 0.0", "3, 0.0, 0.0, 0.0"]);
}

/// A name is what a person typed; as a line of its own it would be read as a step.
#[test]
fn a_name_cannot_break_out_of_the_comment() {
    let job = Job { name: "one\n9, 9, 9, 9\r\u{85}".to_owned(), ..sample_job() };
    assert!(written(Settings::default(), &job).starts_with("# one9, 9, 9, 9 for Sample bender"));
}

#[test]
fn what_cannot_be_written_is_named_with_wire_and_step() {
    let error = refusal(&job_of(&[(1.0, 0.0, 0.0), (1e6, 0.0, 0.0)]));
    assert_eq!(error.message, "wire 1, step 2: feed is 1000000; a column holds up to 100000");
    let error = refusal(&job_of(&[(1.0, 0.0, f64::NAN)]));
    assert_eq!(error.message, "wire 1, step 1: bend is NaN; a column holds up to 100000");
}

#[test]
fn settings_out_of_range_are_named() {
    let many = Settings { decimals: 7, ..Settings::default() };
    assert!(Template::open(many).unwrap_err().message.contains("'decimals' is 7"));
    let broken = Settings { comment: "#\n".to_owned(), ..Settings::default() };
    assert!(Template::open(broken).unwrap_err().message.contains("'comment'"));
}
