//! Where the pause points of a design come in its wires.

use wirebend_files::document::JobPause;

use super::*;
use crate::design::DesignInput;
use crate::plan::Planned;
use crate::playback::played;
use crate::{Installation, NoProgress, PlanChoices};

fn planned(example: &str, pauses: &[(u32, u32, &str)]) -> Planned {
    let app = Installation::new(&[]).unwrap();
    let example = format!("{}/../../examples/{example}.obj", env!("CARGO_MANIFEST_DIR"));
    let mut opened = DesignInput::file(example.into()).open(&NoProgress).unwrap();
    let point = |&(vertex, pass, note): &(u32, u32, &str)| PausePoint {
        vertex: VertexId(vertex),
        pass: NonZeroU32::new(pass).unwrap(),
        note: note.to_owned(),
    };
    opened.document.pauses = pauses.iter().map(point).collect();
    let choices = PlanChoices { machine: Some("wirebend-kit".into()), ..PlanChoices::default() };
    app.plan_design(opened, &choices, &NoProgress).unwrap()
}

fn pause(after: u32, note: &str) -> JobPause {
    JobPause { after, note: note.to_owned() }
}

/// The wire of this cube comes to vertex 6 twice: after 4 edges, and at its end. It has a bend at each vertex.
#[test]
fn a_pause_point_comes_after_the_step_that_brings_the_wire_there() {
    let route = planned("cube-8-edges", &[]).wires[0].route.as_ref().unwrap().vertices();
    let (start, third) = (route[0].0, route[3].0);
    assert_eq!(route[4], route[8]);
    let twice = route[4].0;
    let planned = planned(
        "cube-8-edges",
        &[
            (third, 1, "clip the joint"),
            (twice, 1, "turn the part"),
            (twice, 2, "a"),
            (twice, 3, "b"),
            (start, 1, "c"),
        ],
    );
    assert_eq!(planned.pauses.wires, [[pause(3, "clip the joint"), pause(4, "turn the part")]]);
    let job = planned.job().unwrap().unwrap();
    assert_eq!(job.contents().wires[0].pauses, planned.pauses.wires[0]);
    let why: Vec<&str> = planned.pauses.left_out.iter().map(|left| left.why.as_str()).collect();
    assert_eq!(why, ["a wire ends there", "the wires do not come there 3 times", "a wire begins there"]);
    let notes = planned.opened.notes.iter().filter(|note| note.code == "pause-left-out");
    assert_eq!(notes.count(), 3);
    // The window offers each of them under the name by which it is kept.
    let mut wires = vec![played(&planned.wires[0], &planned.setup.model.time).unwrap()];
    planned.pauses.show(&planned.wires, &mut wires);
    let steps = &wires[0].steps;
    assert_eq!(steps[3].pause.as_deref(), Some("turn the part"));
    assert_eq!(steps[3].place, Some(PausePlace { vertex: twice, pass: NonZeroU32::MIN }));
    assert_eq!(steps.iter().filter(|step| step.pause.is_some()).count(), 2);
    assert_eq!(steps[7].place, None, "after the last step there is nothing to wait with");
}

/// Two vertices in a straight run are passed in one step: the machine stands there once.
#[test]
fn vertices_in_a_straight_line_are_left_behind_with_their_step() {
    let all = planned("collinear", &[]);
    let wire = &all.wires[0];
    let spans = &wire.nominal.as_ref().unwrap().spans;
    let (step, span) =
        spans.iter().enumerate().find(|(step, span)| span.len() > 1 && step + 1 < spans.len()).unwrap();
    let route = wire.route.as_ref().unwrap().vertices();
    let (inner, end) = (route[span.start + 1].0, route[span.end].0);
    let planned = planned("collinear", &[(end, 1, "turn the part"), (inner, 1, "clip the joint")]);
    let after = u32::try_from(step + 1).unwrap();
    assert_eq!(planned.pauses.wires, [[pause(after, "turn the part; clip the joint")]]);
}

#[test]
fn a_step_that_is_not_there_is_refused() {
    let planned = planned("cube-8-edges", &[]);
    let asked = |wire, after, note: &str| {
        let asked = [StepPause { wire, after, note: note.to_owned() }];
        planned.pauses.clone().and(&asked, &planned.wires)
    };
    assert_eq!(asked(0, 7, " turn  the part ").unwrap().wires, [[pause(7, "turn the part")]]);
    let refused = |wire, after, note| asked(wire, after, note).unwrap_err().to_string();
    let step =
        "the step of a pause is 8 of 8, expected a step of the wire before its last one, counted from 1";
    assert_eq!(refused(0, 8, "turn the part"), step);
    assert!(refused(0, 0, "turn the part").starts_with("the step of a pause is 0 of 8"));
    assert_eq!(
        refused(1, 1, "turn the part"),
        "the wire of a pause is 2, expected one of the wires of the plan"
    );
    assert_eq!(refused(0, 1, "\t"), "the note of a pause is empty, expected what the person has to do");
}
