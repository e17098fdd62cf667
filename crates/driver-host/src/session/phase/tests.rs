//! What can be said of any row of acts and reports.

use proptest::prelude::*;
use wirebend_driver_api::{DoneBy, DriverError, HeadBy, Limits, PausedBy, ReferenceBy, ResumeState};

use super::*;

const ACTS: [Act; 13] = [
    Act::Home,
    Act::Arm,
    Act::ArmByHand,
    Act::Send,
    Act::Jog,
    Act::Pause,
    Act::Speed,
    Act::Resume,
    Act::Reattach,
    Act::WriteSettings,
    Act::Ask,
    Act::Command,
    Act::Cut,
];

fn events() -> Vec<Event> {
    let error = DriverError::new("x", "x", "x");
    let connected = |homed, resume| Event::Connected {
        identity: String::new(),
        settings: Vec::new(),
        homed,
        resume,
        reference: ReferenceBy::default(),
        done_by: DoneBy::default(),
        head: HeadBy::default(),
        limits: Limits::default(),
    };
    vec![
        connected(false, None),
        connected(true, None),
        connected(false, Some(ResumeState { accepted: 3, done: 1 })),
        connected(true, Some(ResumeState { accepted: 3, done: 1 })),
        Event::Homed,
        Event::Done { n: 1 },
        Event::Finished,
        Event::Jogged,
        Event::Paused { by: PausedBy::Program },
        Event::Resumed,
        Event::Speed { percent: 50 },
        Event::Stopped { homed: true },
        Event::SettingsWritten { settings: Vec::new(), limits: Limits::default() },
        Event::ConsoleDone { homed: true, moved: true },
        Event::ConsoleDone { homed: false, moved: false },
        Event::Cut,
        Event::Warning(error.clone()),
        Event::Fault { error, in_doubt: None, disconnected: true },
    ]
}

proptest! {
    /// However a driver reports and whatever is asked: from anywhere to running there is no way without a
    /// person's yes, which is arming or reattaching; and to armed none that does not pass through a reference.
    #[test]
    fn nothing_runs_that_nobody_confirmed(turns in prop::collection::vec((any::<bool>(), 0_usize..18), 0..60)) {
        let (mut state, mut confirmed, mut referenced) = (Phase::Connecting, false, false);
        for (is_act, k) in turns {
            let before = state;
            if is_act {
                let act = ACTS[k % ACTS.len()];
                if let Transition::To(next) = state.on(act) {
                    match act {
                        Act::Arm | Act::ArmByHand => {
                            prop_assert!(referenced, "armed without a reference from {before}");
                            confirmed = true;
                        }
                        Act::Reattach => {
                            prop_assert_eq!(before, Phase::Interrupted);
                            confirmed = true;
                        }
                        Act::Home | Act::WriteSettings | Act::Command => (referenced, confirmed) = (false, false),
                        Act::Cut => prop_assert!(referenced, "{act} from {before}"),
                        Act::Send | Act::Jog | Act::Resume => prop_assert!(confirmed, "{act} from {before}"),
                        Act::Pause | Act::Speed | Act::Ask => {}
                    }
                    state = next;
                }
            } else {
                state = state.after(&events()[k]);
                let ends = [Phase::Ready, Phase::Stopped, Phase::Failed, Phase::Interrupted];
                if ends.contains(&state) && state != before {
                    confirmed = false;
                }
                referenced = match state {
                    // A wire that resumes has its reference from before, and needs no other.
                    Phase::Ready => true,
                    // A wire that resumes has its reference from before, and needs no other.
                    Phase::Stopped | Phase::Failed | Phase::Connected | Phase::Homing | Phase::Connecting => false,
                    _ => referenced,
                };
            }
            let needs_a_yes = [Phase::Making, Phase::Holding, Phase::Armed, Phase::Moving].contains(&state);
            prop_assert!(!needs_a_yes || confirmed, "{state}");
        }
    }

    /// No report makes a machine that was interrupted run: only what was taken before is run by itself.
    #[test]
    fn an_interrupted_wire_goes_on_at_a_persons_word_alone(reports in prop::collection::vec(0_usize..18, 0..30)) {
        let mut state = Phase::Interrupted;
        for k in reports {
            state = state.after(&events()[k]);
            prop_assert!(matches!(state, Phase::Interrupted | Phase::Stopped | Phase::Failed), "{state}");
        }
    }
}

/// Its axes are where they are: homed anew or armed for another wire, the begun one would be spoilt unasked.
#[test]
fn an_interrupted_wire_is_taken_up_or_stopped() {
    for act in ACTS {
        let possible = matches!(Phase::Interrupted.on(act), Transition::To(_));
        assert_eq!(possible, act == Act::Reattach, "{act}");
    }
    for state in Phase::ALL {
        let possible = matches!(state.on(Act::Reattach), Transition::To(_));
        assert_eq!(possible, state == Phase::Interrupted, "reattaching while {state}");
    }
}

#[test]
fn a_stop_or_a_fault_is_left_by_homing_alone() {
    for state in [Phase::Stopped, Phase::Failed] {
        for act in ACTS {
            let leaves = matches!(state.on(act), Transition::To(next) if next != state);
            // A typed line may unlock it; it has to be homed all the same.
            let typed = act == Act::Command && state == Phase::Stopped;
            assert_eq!(leaves, act == Act::Home || typed, "{act} while {state}");
        }
        for event in events() {
            let next = state.after(&event);
            assert!(matches!(next, Phase::Stopped | Phase::Failed), "{event:?} leads from {state} to {next}");
        }
    }
}

/// The user presses hold as the last step ends: the wire is finished, and the machine free for the next.
#[test]
fn a_wire_that_ends_while_the_machine_holds_is_made() {
    assert_eq!(Phase::Holding.after(&Event::Finished), Phase::Ready);
}

/// As long as it may move, nothing but another stop is asked of it, and only its own word ends that.
#[test]
fn a_stop_is_over_when_the_machine_says_so() {
    for act in ACTS {
        assert!(matches!(Phase::Stopping.on(act), Transition::Refused { .. }), "{act}");
    }
    for event in events() {
        let ends = matches!(event, Event::Stopped { .. } | Event::Fault { .. });
        assert_eq!(Phase::Stopping.after(&event) != Phase::Stopping, ends, "{event:?}");
    }
}

/// A machine that moves is not told other steps for each degree.
#[test]
fn settings_are_written_at_rest_alone_and_cost_the_reference() {
    for state in Phase::ALL {
        let moves = [
            Phase::Connecting,
            Phase::Homing,
            Phase::Making,
            Phase::Holding,
            Phase::Interrupted,
            Phase::Commanded,
            Phase::Cutting,
            Phase::Stopping,
            Phase::Closed,
        ]
        .contains(&state);
        match state.on(Act::WriteSettings) {
            Transition::Refused { .. } => assert!(moves, "refused while {state}"),
            Transition::To(next) => {
                assert!(
                    !moves && [Phase::Connected, Phase::Stopped, Phase::Failed].contains(&next),
                    "{state}"
                );
            }
        }
    }
}

#[test]
fn every_state_has_a_name_of_its_own() {
    let names: std::collections::BTreeSet<String> = Phase::ALL.iter().map(ToString::to_string).collect();
    assert_eq!(names.len(), Phase::ALL.len());
}
