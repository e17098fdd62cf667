//! Jobs come back as they were, and what was changed or does not fit together is refused.

use expect_test::expect;
use wirebend_files::document::{DocumentError, Job, JobContents, JobPause, JobStep, JobWire};
use wirebend_files::read::{ReadOptions, read};

use super::super::step;
use super::example;

fn pause(after: u32, note: &str) -> JobPause {
    JobPause { after, note: note.to_owned() }
}

pub(super) fn example_job() -> JobContents {
    let steps: Vec<JobStep> =
        [step(30., 0., 45.), step(20., -90., 30.), step(10., 0., 0.)].map(JobStep::from).to_vec();
    JobContents {
        design_hash: example().design_hash().unwrap(),
        machine: example().machine.unwrap(),
        material: example().material.unwrap(),
        wires: vec![JobWire {
            vertices: vec![0, 1, 7, 1],
            path_mm: vec![[0.1, 0.0, 0.0], [0.1 + 0.2, 1.0, 2.0], [30.0, 1.0, 2.0], [30.0, 9.0, 2.0]],
            nominal: steps.clone(),
            spans: vec![[0, 1], [1, 2], [2, 3]],
            scheduled: steps.clone(),
            compensated: steps,
            stock_mm: 460.0,
            time_s: 91.5,
            avoids_collisions: false,
            clearance_mm: None,
            sag: false,
            pauses: vec![pause(2, "turn the part")],
        }],
        objections: vec!["edge 1 is too short".into()],
        program: None,
    }
}

#[test]
fn a_job_whose_stages_do_not_fit_each_other_is_refused() {
    let cases: [fn(&mut JobWire); 10] = [
        |wire| wire.path_mm.truncate(3),
        |wire| wire.compensated.truncate(2),
        |wire| wire.spans[2] = [2, 9],
        |wire| wire.spans[1] = [2, 2],
        |wire| wire.spans.truncate(1),
        |wire| {
            for stage in [&mut wire.nominal, &mut wire.scheduled, &mut wire.compensated] {
                stage.clear();
            }
        },
        // Before the wire begins and after its end a person is asked in any case.
        |wire| wire.pauses[0].after = 0,
        |wire| wire.pauses[0].after = 3,
        |wire| wire.pauses.push(pause(1, "clip the joint")),
        |wire| wire.pauses[0].note = " ".to_owned(),
    ];
    for damage in cases {
        let mut contents = example_job();
        damage(&mut contents.wires[0]);
        assert!(matches!(Job::seal(contents), Err(DocumentError::Inconsistent { wire: 0, .. })));
    }
}

#[test]
fn a_job_comes_back_as_it_was_and_only_so() {
    let job = Job::seal(example_job()).unwrap();
    let bytes = job.to_bytes().unwrap();
    assert_eq!(Job::open(&bytes, "a.wbjob").unwrap(), job);
    assert_eq!(job.contents(), &example_job());
    let text = String::from_utf8(bytes).unwrap();
    // Laid out anew it is the same job; with one digit changed it is none.
    let value: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(Job::open(value.to_string().as_bytes(), "a.wbjob").unwrap(), job);
    let refused = |text: &str| Job::open(text.as_bytes(), "a.wbjob").unwrap_err();
    assert!(matches!(refused(&text.replace("460.0", "460.1")), DocumentError::Changed { .. }));
    assert!(
        matches!(refused(&text.replace("20.4", "20.5")), DocumentError::Changed { .. }),
        "profiles are sealed, too"
    );
    assert!(matches!(refused(&text.replace("\"hash\"", "\"hush\"")), DocumentError::Json { .. }));
    expect!["a.wbjob: its version 9 is newer than 1, the newest known here"]
        .assert_eq(&refused(&text.replace("\"version\": 1", "\"version\": 9")).to_string());
    assert!(matches!(refused(&text.replace("turn the part", "turn it")), DocumentError::Changed { .. }));
    let error = read(text.as_bytes(), "a.wbjob", None, &ReadOptions::default()).unwrap_err();
    assert_eq!(error.code(), "document-wrong-format", "a job is no wireframe: {error}");
}

#[test]
fn a_job_with_a_number_that_is_none_is_not_sealed() {
    let mut contents = example_job();
    contents.wires[0].compensated[1].bend_deg = f64::NAN;
    assert_eq!(Job::seal(contents).unwrap_err().code(), "document-not-finite");
}

/// Jobs of before have no pause points, and keep their hash.
#[test]
fn a_job_without_pause_points_says_nothing_of_them() {
    let mut contents = example_job();
    contents.wires[0].pauses.clear();
    let job = Job::seal(contents).unwrap();
    let text = String::from_utf8(job.to_bytes().unwrap()).unwrap();
    assert!(!text.contains("pauses"));
    assert_eq!(Job::open(text.as_bytes(), "a.wbjob").unwrap(), job);
}
