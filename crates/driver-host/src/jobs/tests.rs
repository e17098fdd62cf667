//! What may be done after an interruption, tried on machines and programs that end at any moment.

use proptest::prelude::*;
use wirebend_driver_api::ResumeState;

use super::*;

const STEPS: u32 = 6;

fn begun() -> JournalState {
    JournalState::new(Heading { steps: STEPS, ..Heading::default() })
}

fn after(whats: &[EntryKind]) -> JournalState {
    let mut state = begun();
    for what in whats {
        state.count(what).unwrap();
    }
    state
}

fn armed(after: u32) -> EntryKind {
    EntryKind::Armed { token: Some("7".into()), after, resumed: false }
}

fn intent(from: u32, to: u32) -> EntryKind {
    EntryKind::Intent { from, to }
}

/// Four steps sent, three taken, one done; then the program ended.
fn interrupted() -> JournalState {
    after(&[armed(0), intent(1, 4), EntryKind::Accepted { n: 3 }, EntryKind::Done { n: 1 }])
}

const fn machine(accepted: u32, done: u32) -> ResumeState {
    ResumeState { accepted, done }
}

#[test]
fn the_same_session_goes_on_after_the_last_step_that_it_took() {
    let state = interrupted();
    for (accepted, done) in [(3, 1), (3, 3), (4, 2), (4, 4)] {
        let expected = Resume::Reattach { from: accepted + 1, done };
        assert_eq!(Resume::decide(&state, Some(machine(accepted, done))), expected);
    }
}

#[test]
fn a_machine_that_was_reset_makes_a_person_look() {
    let state = interrupted();
    assert_eq!(Resume::decide(&state, None), Resume::Ask { in_doubt: 2, last: 4 });
    assert_eq!(state.in_doubt(), Some(2..=4));
    // The second was done, the third was not: the fourth cannot have been.
    let mut state = state;
    // While it may still be run, no answer about it is taken.
    state.count(&EntryKind::Decided { n: 2, made: true }).unwrap_err();
    state.count(&EntryKind::Connected { identity: String::new(), resume: None }).unwrap();
    state.count(&EntryKind::Decided { n: 2, made: true }).unwrap();
    assert_eq!(Resume::decide(&state, None), Resume::Ask { in_doubt: 3, last: 4 });
    state.count(&EntryKind::Decided { n: 3, made: false }).unwrap();
    assert_eq!(Resume::decide(&state, None), Resume::Arm { from: 3 });
    assert_eq!(state.in_doubt(), None);
}

/// A person may correct themselves as long as nothing is bent after it.
#[test]
fn what_was_said_can_be_taken_back_until_something_is_made() {
    let mut before = interrupted();
    before.count(&EntryKind::Stopped { by: None }).unwrap();
    let mut state = before.clone();
    for n in 2..=3 {
        state.count(&EntryKind::Decided { n, made: true }).unwrap();
    }
    state.count(&EntryKind::TakenBack { n: 4 }).unwrap_err();
    state.count(&EntryKind::TakenBack { n: 3 }).unwrap();
    assert_eq!((state.done, state.in_doubt()), (2, Some(3..=4)));
    state.count(&EntryKind::TakenBack { n: 2 }).unwrap();
    assert_eq!(state, before);
    state.count(&EntryKind::Part { n: 2, feed_mm: 4.0, rotate_deg: 0.0, by: ToldBy::Person }).unwrap();
    state.count(&armed(1)).unwrap();
    state.count(&EntryKind::TakenBack { n: 2 }).unwrap_err();
}

/// Once it is settled how much of the first step is in the wire, no step counts as sent.
#[test]
fn a_part_of_the_first_step_is_in_the_wire() {
    let mut state = begun();
    assert!(state.is_blank());
    for what in [armed(0), intent(1, 1), EntryKind::Stopped { by: None }] {
        state.count(&what).unwrap();
    }
    assert!(!state.is_blank());
    let part = |feed_mm| EntryKind::Part { n: 1, feed_mm, rotate_deg: 0.0, by: ToldBy::Person };
    state.count(&part(4.0)).unwrap();
    assert_eq!(state.sent, 0);
    assert!(!state.is_blank());
    state.count(&EntryKind::TakenBack { n: 1 }).unwrap();
    state.count(&EntryKind::Decided { n: 1, made: false }).unwrap();
    assert!(state.is_blank());
}

#[test]
fn what_is_over_is_over() {
    assert_eq!(Resume::decide(&begun(), None), Resume::Arm { from: 1 });
    let mut made = vec![armed(0), intent(1, STEPS)];
    made.extend((1..=STEPS).map(|n| EntryKind::Done { n }));
    assert_eq!(Resume::decide(&after(&made), None), Resume::Nothing(Settled::AllMade));
    // The machine still waits for word that it was the last.
    assert_eq!(
        Resume::decide(&after(&made), Some(machine(STEPS, STEPS))),
        Resume::Reattach { from: STEPS + 1, done: STEPS }
    );
    made.push(EntryKind::Finished);
    assert_eq!(
        Resume::decide(&after(&made), Some(machine(STEPS, STEPS))),
        Resume::Nothing(Settled::Finished)
    );
    let abandoned = after(&[armed(0), intent(1, 1), EntryKind::Abandoned]);
    assert_eq!(Resume::decide(&abandoned, None), Resume::Nothing(Settled::Abandoned));
}

#[test]
fn a_machine_and_a_journal_that_contradict_each_other_are_told_apart() {
    use ContradictionKind::{MadeLess, MadeMoreThanTaken, NeverSent, Stopped};
    let state = interrupted();
    let cases = [
        (machine(5, 1), NeverSent { machine: 5, journal: 4 }, "no more than 4 were sent"),
        (machine(3, 0), MadeLess { machine: 0, journal: 1 }, "has done 0 steps, and has reported 1"),
        (machine(3, 4), MadeMoreThanTaken { done: 4, accepted: 3 }, "done 4 steps and taken 3"),
    ];
    for (machine, kind, words) in cases {
        let Resume::Contradiction(contradiction) = Resume::decide(&state, Some(machine)) else {
            panic!("{machine:?} was believed");
        };
        assert_eq!(contradiction.kind, kind);
        assert!(contradiction.to_string().contains(words), "{contradiction}");
    }
    // Even after it was connected to again a stop stays a stop.
    let mut stopped = state;
    stopped.count(&EntryKind::Stopped { by: None }).unwrap();
    stopped.count(&EntryKind::Connected { identity: String::new(), resume: Some(machine(3, 1)) }).unwrap();
    assert_eq!(
        Resume::decide(&stopped, Some(machine(3, 1))),
        Resume::Contradiction(Contradiction { kind: Stopped })
    );
}

/// Of what the driver has refused, or had no room for, the user is not asked.
#[test]
fn steps_that_were_not_taken_are_in_no_doubt() {
    let mut state = after(&[armed(0), intent(1, 4), EntryKind::Accepted { n: 3 }, EntryKind::Done { n: 1 }]);
    state.count(&EntryKind::NotTaken { after: 3 }).unwrap();
    assert_eq!(state.in_doubt(), Some(2..=3));
    // They are sent later, as if for the first time.
    state.count(&intent(4, 5)).unwrap();
    state.count(&EntryKind::NotTaken { after: 2 }).unwrap_err();
    state.count(&EntryKind::NotTaken { after: 6 }).unwrap_err();
    let mut refused = after(&[armed(0), intent(1, 4)]);
    refused.count(&EntryKind::NotTaken { after: 0 }).unwrap();
    assert_eq!((refused.in_doubt(), Resume::decide(&refused, None)), (None, Resume::Arm { from: 1 }));
}

/// What a driver had taken and not passed on to the machine died with it: it is sent again.
#[test]
fn steps_that_died_with_the_driver_are_sent_again() {
    assert_eq!(interrupted().accepted, 3);
    assert_eq!(Resume::decide(&interrupted(), Some(machine(2, 1))), Resume::Reattach { from: 3, done: 1 });
}

/// A journal that says what cannot be is not counted with.
#[test]
fn what_cannot_have_happened_is_refused() {
    let base = [armed(0), intent(1, 3), EntryKind::Accepted { n: 2 }, EntryKind::Done { n: 1 }];
    let cases = [
        EntryKind::Job(Heading::default()),
        intent(3, 4),
        intent(5, 5),
        intent(4, STEPS + 1),
        EntryKind::Accepted { n: 4 },
        EntryKind::Accepted { n: 1 },
        EntryKind::Done { n: 1 },
        EntryKind::Done { n: 3 },
        EntryKind::Decided { n: 2, made: true },
        EntryKind::Finished,
        armed(1),
        armed(2),
    ];
    for what in cases {
        let mut state = after(&base);
        let before = state.clone();
        assert!(state.count(&what).is_err(), "{what:?} was counted");
        assert_eq!(state, before, "{what:?} left something");
    }
    let mut over = after(&base);
    over.count(&EntryKind::Abandoned).unwrap();
    assert!(over.count(&EntryKind::Done { n: 2 }).is_err());
    over.count(&EntryKind::Made { corners_mm: Vec::new(), deviations_mm: Some(vec![0.1]) }).unwrap();
}

/// A machine with a queue, which continues without a program and forgets it when it is reset.
#[derive(Debug, Default)]
struct Bender {
    session: Option<u32>,
    sessions: u32,
    accepted: u32,
    done: u32,
    made: Vec<u32>,
}

impl Bender {
    fn arm(&mut self, after: u32) -> String {
        self.sessions += 1;
        (self.session, self.accepted, self.done) = (Some(self.sessions), after, after);
        self.sessions.to_string()
    }

    fn make(&mut self) {
        if self.session.is_some() && self.done < self.accepted {
            self.done += 1;
            self.made.push(self.done);
        }
    }

    fn is_in(&self, token: Option<&str>) -> Option<ResumeState> {
        let same = self.session.map(|session| session.to_string()).as_deref() == token && token.is_some();
        same.then_some(ResumeState { accepted: self.accepted, done: self.done })
    }
}

/// What a program does that has just been started: everything by the journal, nothing by heart.
fn begin(state: &mut JournalState, bender: &mut Bender) -> bool {
    let machine = bender.is_in(state.token.as_deref());
    state.count(&EntryKind::Connected { identity: String::new(), resume: machine }).unwrap();
    loop {
        match Resume::decide(state, machine) {
            Resume::Reattach { done, .. } => {
                (state.done + 1..=done).for_each(|n| state.count(&EntryKind::Done { n }).unwrap());
                let (token, after) = (state.token.clone(), state.done);
                state.count(&EntryKind::Armed { token, after, resumed: true }).unwrap();
                return true;
            }
            Resume::Ask { in_doubt: n, .. } => {
                let made = bender.made.contains(&n);
                state.count(&EntryKind::Decided { n, made }).unwrap();
            }
            Resume::Arm { from } => {
                let token = Some(bender.arm(from - 1));
                state.count(&EntryKind::Armed { token, after: from - 1, resumed: false }).unwrap();
                return true;
            }
            Resume::Nothing(_) => return false,
            Resume::Contradiction(contradiction) => panic!("{contradiction}"),
        }
    }
}

proptest! {
    /// Whenever the program ends and whenever the machine is reset, before, in the middle of or after whatever
    /// is written, sent, done and heard: with a person who answers correctly each step is done exactly once.
    #[test]
    fn every_step_is_made_exactly_once(events in prop::collection::vec((0_u8..8, 0_u32..4), 0..80)) {
        let (mut state, mut bender) = (begun(), Bender::default());
        let mut running = begin(&mut state, &mut bender);
        // What chance leaves undone is done at the end by a program that nothing happens to.
        let calm = [(0, 3), (3, 0), (3, 0), (3, 0), (4, 3)].into_iter().cycle().take(60);
        for (event, size) in events.into_iter().chain([(5, 0)]).chain(calm) {
            match event {
                // Steps are written down and sent; the machine takes some of them. Or the program ends before.
                0..=2 if running && bender.session.is_some() => {
                    let to = (bender.accepted + 1 + size).min(STEPS).min(bender.done + 4);
                    if to > state.sent {
                        let from = state.sent + 1;
                        state.count(&EntryKind::Intent { from, to }).unwrap();
                    }
                    if event == 1 {
                        running = false;
                    } else {
                        bender.accepted = bender.accepted.max(to);
                        if event == 0 && bender.accepted > state.accepted {
                            state.count(&EntryKind::Accepted { n: bender.accepted }).unwrap();
                        }
                    }
                }
                3 => bender.make(),
                4 if running => {
                    let heard = bender.done.min(state.done + size);
                    (state.done + 1..=heard).for_each(|n| state.count(&EntryKind::Done { n }).unwrap());
                    if state.done == STEPS && !state.is_over() {
                        state.count(&EntryKind::Finished).unwrap();
                        running = false;
                    }
                }
                5 => running = !state.is_over() && begin(&mut state, &mut bender),
                6 => running = false,
                7 => {
                    bender.session = None;
                    running = false;
                }
                _ => {}
            }
        }
        prop_assert_eq!(bender.made, (1..=STEPS).collect::<Vec<_>>());
        prop_assert_eq!(state.done, STEPS);
    }
}
