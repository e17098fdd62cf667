//! What a person prints: templates at 1:1 and job sheets. The program writes them itself, without a driver.

use serde_json::{Value, json};
use wirebend_api::{
    ApiError, Command, DesignInput, ExportFormat, ExportResponse, Input, PlanChoices, PlanRequest,
    PlanningError, Response,
};
use wirebend_core::bend::Step;
use wirebend_files::document::Job;

use crate::cases::{self, Case};

const MACHINE: &str = "table-bender";
/// Pin of 3 mm and half of 3 mm wire.
const RADIUS_MM: f64 = 4.5;
const PRINTED: [&str; 4] = ["template-svg", "template-dxf", "template-pdf", "job-sheet"];

fn printed(
    design: DesignInput,
    choices: PlanChoices,
    format: &str,
    settings: &Value,
) -> Result<ExportResponse, ApiError> {
    cases::exported(cases::asked(design, choices, format, settings))
}

fn house(format: &str, settings: &Value) -> Result<ExportResponse, ApiError> {
    let case = Case::load(&cases::root().join("tests/golden/house"));
    printed(case.input(), case.choices(MACHINE), format, settings)
}

/// The steps of a case as designed, wire by wire.
fn designed(case: &Case) -> Vec<Vec<Step>> {
    let (make_job, despite_errors) = (true, true);
    let request = PlanRequest {
        design: case.input(),
        choices: case.choices(MACHINE),
        output: None,
        make_job,
        pauses: Vec::new(),
        despite_errors,
    };
    let Ok(Response::Plan(found)) = cases::run(&Command::Plan(request)) else { panic!("no plan") };
    let job = Job::open(&found.contents, "job").unwrap();
    let steps = |wire: &wirebend_files::document::JobWire| {
        wire.nominal.iter().map(|&step| Step::try_from(step).unwrap()).collect()
    };
    job.contents().wires.iter().map(steps).collect()
}

/// The length of what is on the centreline of a DXF file.
fn centreline_mm(dxf: &str) -> f64 {
    let lines: Vec<&str> = dxf.lines().collect();
    let pairs: Vec<(&str, &str)> = lines.chunks(2).map(|pair| (pair[0].trim(), pair[1])).collect();
    let begins: Vec<usize> = (0..pairs.len()).filter(|&k| pairs[k].0 == "0").collect();
    let mut sum = 0.0;
    for pair in begins.windows(2) {
        let entity = &pairs[pair[0]..pair[1]];
        let number = |code: &str| -> f64 {
            entity.iter().find(|pair| pair.0 == code).map_or(0.0, |pair| pair.1.parse().unwrap())
        };
        if !entity.contains(&("8", "CENTRELINE")) {
            continue;
        }
        sum += match entity[0].1 {
            "LINE" => (number("11") - number("10")).hypot(number("21") - number("20")),
            "ARC" => number("40") * (number("51") - number("50")).rem_euclid(360.0).to_radians(),
            other => panic!("{other}: a flat wire is of lines and arcs"),
        };
    }
    sum
}

/// Every case that has a route is printed; one without is refused with the stage that it does not reach.
#[test]
fn every_case_is_printed() {
    let mut refused = Vec::new();
    for (name, _, case) in cases::all() {
        for format in PRINTED {
            match printed(case.input(), case.choices(MACHINE), format, &Value::Null) {
                Ok(found) => {
                    assert_eq!((found.contents.len(), found.driver.as_deref()), (1, None), "{name}");
                    let begin = match format {
                        "template-svg" => "<svg",
                        "template-dxf" => "  0\nSECTION",
                        _ => "%PDF-",
                    };
                    assert!(found.contents[0].starts_with(begin.as_bytes()), "{name}: {format}");
                }
                Err(ApiError::Planning(PlanningError::StageNotReached { stage, .. })) => {
                    refused.push(format!("{name}, {format}: {}", stage.as_str()));
                }
                Err(other) => panic!("{name}: {other}"),
            }
        }
    }
    assert_eq!(refused, PRINTED.map(|format| format!("cube-not-doubled, {format}: route")));
}

/// A bent wire that is laid on its template covers it: the template is as long as the design less what arcs save.
#[test]
fn flat_cases_are_as_long_as_they_are_bent() {
    for name in ["house", "two-parts", "u-sample"] {
        let case = Case::load(&cases::root().join("tests/golden").join(name));
        let found = printed(case.input(), case.choices(MACHINE), "template-dxf", &Value::Null).unwrap();
        let steps = designed(&case).concat();
        let bent: f64 = steps
            .iter()
            .map(|step| {
                let bend = step.bend.rad();
                step.feed.mm() - RADIUS_MM * (2.0 * (bend / 2.0).tan() - bend)
            })
            .sum();
        let drawn = centreline_mm(std::str::from_utf8(&found.contents[0]).unwrap());
        assert!((drawn - bent).abs() < 1e-3, "{name}: {drawn} mm for {bent} mm");
        assert!(found.notes.iter().all(|note| note.code != "bends-tightened"), "{name}");
    }
}

/// The same of a design and of the job that was planned from it, on the same day: the same program, with a hash more.
#[test]
fn a_job_is_printed_like_its_design() {
    let case = Case::load(&cases::root().join("tests/golden/house"));
    let request = PlanRequest {
        design: case.input(),
        choices: case.choices(MACHINE),
        output: None,
        make_job: true,
        pauses: Vec::new(),
        despite_errors: false,
    };
    let Ok(Response::Plan(plan)) = cases::run(&Command::Plan(request)) else { panic!("no plan") };
    let job = DesignInput {
        input: Input::Bytes { name: "house.wbjob".into(), bytes: plan.contents },
        ..DesignInput::file(cases::root())
    };
    for format in &PRINTED[..3] {
        let of_job = printed(job.clone(), PlanChoices::default(), format, &Value::Null).unwrap();
        assert!(of_job.contents == house(format, &Value::Null).unwrap().contents, "{format}");
    }
    let date = json!({"date": "2026-05-01"});
    let sheet = printed(job.clone(), PlanChoices::default(), "job-sheet", &date).unwrap().contents;
    assert_eq!(sheet, printed(job, PlanChoices::default(), "job-sheet", &date).unwrap().contents);
}

#[test]
fn settings_are_those_of_the_format() {
    for (format, settings, expected) in [
        ("template-pdf", json!({"paper": "a3"}), "paper is a3, expected a4 or letter"),
        ("template-pdf", json!({"paper": 4}), "paper is 4, expected a4 or letter"),
        ("template-pdf", json!({"date": "today"}), "expected paper (a4 or letter) or units (mm or in)"),
        ("job-sheet", json!({"papier": "a4"}), "a setting of job-sheet is papier, expected paper"),
        ("job-sheet", json!({"date": 2026}), "date is 2026, expected a text"),
        ("template-dxf", json!({"paper": "a4"}), "a setting of template-dxf is paper, expected units alone"),
        ("job-sheet", json!({"units": "inch"}), "units is inch, expected mm or in"),
        ("svg", json!({"paper": "a4"}), "svg has no settings"),
    ] {
        let error = house(format, &settings).unwrap_err();
        assert!(error.to_string().contains(expected), "{error}");
    }
    for format in PRINTED {
        let units = |units: &str| house(format, &json!({"units": units})).unwrap().contents.remove(0);
        assert!(units("in") != units("mm"), "{format}");
    }
    for format in ["template-pdf", "job-sheet"] {
        let paper = |paper: &str| house(format, &json!({"paper": paper})).unwrap().contents.remove(0);
        assert!(paper("letter") != paper("a4"), "{format}");
        assert!(paper("LETTER").starts_with(b"%PDF"));
    }
}

/// Letters that a PDF's fonts do not have are reported, and so is a template that is too large to print.
#[test]
fn what_cannot_be_printed_is_said() {
    let file = |name: &str, text: &str| DesignInput {
        input: Input::Bytes { name: name.into(), bytes: text.into() },
        ..DesignInput::file(cases::root())
    };
    let choices = PlanChoices { machine: Some(MACHINE.into()), ..PlanChoices::default() };
    let bent = "v 0 0 0\nv 100 0 0\nv 100 50 0\nl 1 2 3\n";
    for format in ["template-pdf", "job-sheet"] {
        let found = printed(file("針金.obj", bent), choices.clone(), format, &Value::Null).unwrap();
        let note = found.notes.iter().find(|note| note.code == "letters-replaced").unwrap();
        assert!(note.message.contains("金針"), "{}", note.message);
    }
    let large = "v 0 0 0\nv 90000 0 0\nv 90000 90000 0\nl 1 2 3\n";
    let error = printed(file("large.obj", large), choices, "template-pdf", &Value::Null).unwrap_err();
    assert!(error.to_string().contains("more than 400 pages"), "{error}");
    assert_eq!(error.code(), "unwritable");
}

/// What a front end names a file by.
#[test]
fn extensions_fit_the_formats() {
    let endings: Vec<&str> = ExportFormat::ALL.iter().map(|format| format.extension()).collect();
    assert_eq!(endings, ["svg", "png", "obj", "obj", "glb", "svg", "dxf", "pdf", "pdf"]);
    let ids = ExportFormat::ALL.map(ExportFormat::id);
    assert_eq!(ids[5..], PRINTED);
}
