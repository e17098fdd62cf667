use std::sync::{Arc, Mutex};

use wirebend_driver_api::DriverError;

use super::*;

#[derive(Clone, Default)]
struct Disk(Arc<Mutex<(Vec<HeadPlace>, bool)>>);

impl HeadKeeper for Disk {
    fn keep(&mut self, place: HeadPlace) -> Result<(), String> {
        let mut disk = self.0.lock().unwrap();
        if disk.1 {
            return Err("no space left".to_owned());
        }
        disk.0.push(place);
        Ok(())
    }
}

impl Disk {
    fn last(&self) -> HeadPlace {
        *self.0.lock().unwrap().0.last().unwrap()
    }
}

fn connected(head: HeadBy) -> Event {
    Event::Connected {
        identity: String::new(),
        settings: Vec::new(),
        homed: false,
        resume: None,
        reference: ReferenceBy::Machine,
        done_by: wirebend_driver_api::DoneBy::Machine,
        head,
        limits: wirebend_driver_api::Limits::default(),
    }
}

fn head(by: HeadBy, place: HeadPlace) -> (Head, Disk) {
    let disk = Disk::default();
    let mut head = Head::default();
    hears(&mut head, &[connected(by)]);
    head.place = place;
    head.keeper = Some(Box::new(disk.clone()));
    (head, disk)
}

fn hears(head: &mut Head, events: &[Event]) {
    head.listens();
    for event in events {
        head.hears(event, ReferenceBy::Machine);
    }
}

fn sends(head: &mut Head, turns: &[f64]) -> (HeadPlace, f64) {
    let steps: Vec<NumberedStep> = (1..)
        .zip(turns)
        .map(|(n, &rotate_deg)| NumberedStep { n, step: Step { rotate_deg, ..Step::default() } })
        .collect();
    head.sends(steps.iter()).unwrap()
}

fn position(rotate_deg: f64) -> Event {
    Event::Position(Step { rotate_deg, ..Step::default() })
}

fn making(turns: &[f64]) -> (Head, Disk) {
    let (mut head, disk) = head(HeadBy::Program, HeadPlace::At(0.0));
    assert_eq!(head.homes(ReferenceBy::Machine).unwrap(), Some(0.0));
    hears(&mut head, &[Event::Homed]);
    head.begins(0.0).unwrap();
    sends(&mut head, turns);
    (head, disk)
}

const STOPPED: Event = Event::Stopped { homed: false };

/// On the disk is where the head can be before it is sent there, and less of that as steps are reported.
#[test]
fn the_range_is_kept_before_the_steps_are_sent() {
    let (mut head, disk) = making(&[90.0, -150.0, 0.0]);
    assert_eq!(disk.last(), HeadPlace::Between(-60.0, 90.0));
    hears(&mut head, &[Event::Done { n: 1 }]);
    assert_eq!(disk.last(), HeadPlace::Between(-60.0, 90.0));
    hears(&mut head, &[Event::Done { n: 2 }]);
    assert_eq!(disk.last(), HeadPlace::At(-60.0));
}

/// A report of the machine at rest shows where it stands; one of before, when it turned, does not.
#[test]
fn after_a_stop_it_stands_where_the_machine_says() {
    let (mut head, disk) = making(&[90.0]);
    hears(&mut head, &[position(41.0), STOPPED]);
    assert_eq!(disk.last(), HeadPlace::At(41.0));
    let (mut head, disk) = making(&[90.0]);
    hears(&mut head, &[position(41.0)]);
    hears(&mut head, &[STOPPED]);
    assert_eq!(disk.last(), HeadPlace::Between(0.0, 90.0));
}

/// A controller that has started anew counts from wherever its head stands.
#[test]
fn what_the_machine_has_forgotten_it_is_told() {
    let (mut head, disk) = head(HeadBy::Program, HeadPlace::At(90.0));
    assert_eq!(head.homes(ReferenceBy::Machine).unwrap(), Some(90.0));
    assert_eq!(disk.last(), HeadPlace::Between(0.0, 90.0), "it is turned back now");
    // Before it is homed, its positions count from an unknown place.
    hears(&mut head, &[position(0.0), STOPPED]);
    assert_eq!(disk.last(), HeadPlace::Between(0.0, 90.0));
    let error = head.homes(ReferenceBy::Machine).unwrap_err();
    assert!(matches!(error, SessionError::HeadUnknown { .. }), "{error}");
}

#[test]
fn a_machine_that_remembers_is_told_nothing() {
    let (mut remembers, _) = head(HeadBy::Kept, HeadPlace::Between(0.0, 90.0));
    assert_eq!(remembers.homes(ReferenceBy::Machine).unwrap(), None);
    let (mut finds, disk) = head(HeadBy::Reference, HeadPlace::Between(0.0, 90.0));
    assert_eq!(finds.homes(ReferenceBy::Machine).unwrap(), None);
    hears(&mut finds, &[Event::Homed]);
    assert_eq!(disk.last(), HeadPlace::At(0.0));
    // Once more through the same connection, and after a fault, which may have been a reset.
    let (mut again, _) = making(&[]);
    assert_eq!(again.homes(ReferenceBy::Machine).unwrap(), None);
    hears(&mut again, &[Event::Homed]);
    let error = DriverError::new("restarted", "it has started anew", "");
    hears(&mut again, &[Event::Fault { error, in_doubt: None, disconnected: false }]);
    assert_eq!(again.homes(ReferenceBy::Machine).unwrap(), Some(0.0));
}

/// Nothing is known of a machine's head before its first wire, and what it counts itself is not touched.
#[test]
fn a_machine_of_which_nothing_is_known_is_told_nothing() {
    let (mut first, disk) = head(HeadBy::Program, HeadPlace::Unsaid);
    assert_eq!(first.homes(ReferenceBy::Machine).unwrap(), None);
    hears(&mut first, &[Event::Homed]);
    assert_eq!(disk.last(), HeadPlace::At(0.0));
}

#[test]
fn no_wire_begins_with_a_turned_head() {
    let (mut turned, _) = head(HeadBy::Reference, HeadPlace::At(90.0));
    assert!(matches!(turned.begins(0.0), Err(SessionError::OffZero { rotate_deg: 90.0, .. })));
    let (mut lost, _) = head(HeadBy::Reference, HeadPlace::Between(0.0, 90.0));
    assert!(matches!(lost.begins(0.0), Err(SessionError::HeadUnknown { .. })));
}

#[test]
fn what_was_refused_was_not_turned() {
    let (mut refused, disk) = making(&[]);
    let before = sends(&mut refused, &[90.0, 90.0]);
    refused.not_taken(1, before);
    assert_eq!(disk.last(), HeadPlace::Between(0.0, 90.0));
    refused.not_taken(1, before);
    assert_eq!(disk.last(), HeadPlace::At(0.0));
    let motion = Motion::new(Axis::Rotate, -45.0);
    let before = refused.jogs(motion).unwrap();
    assert_eq!(disk.last(), HeadPlace::Between(-45.0, 0.0));
    refused.stays(before);
    assert_eq!(disk.last(), HeadPlace::At(0.0));
    refused.jogs(motion).unwrap();
    hears(&mut refused, &[Event::Jogged]);
    assert_eq!(disk.last(), HeadPlace::At(-45.0));
}

/// A driver that turns the head to where the wire begins takes no step before.
#[test]
fn a_wire_that_begins_before_zero_ends_where_its_steps_do() {
    let (mut before_zero, disk) = head(HeadBy::Program, HeadPlace::At(0.0));
    before_zero.begins(-2.5).unwrap();
    let before = sends(&mut before_zero, &[2.5]);
    before_zero.not_taken(1, before);
    assert_eq!(disk.last(), HeadPlace::Between(-2.5, 0.0));
    sends(&mut before_zero, &[2.5, 90.0]);
    hears(&mut before_zero, &[Event::Done { n: 1 }, Event::Done { n: 2 }]);
    assert_eq!(disk.last(), HeadPlace::At(90.0));
}

/// A disk that is full: nothing is turned that would not be known later.
#[test]
fn what_cannot_be_kept_is_not_turned() {
    let (mut full, disk) = making(&[]);
    disk.0.lock().unwrap().1 = true;
    let error = full.jogs(Motion::new(Axis::Rotate, 10.0)).unwrap_err();
    assert!(matches!(error, SessionError::HeadNotKept { .. }), "{error}");
    assert_eq!(full.place, HeadPlace::At(0.0));
    // What does not turn the head still works.
    full.jogs(Motion::new(Axis::Feed, 10.0)).unwrap();
}

/// Where a person zeroes the axes, moves may count from anywhere: the head keeps its account.
#[test]
fn a_head_that_is_zeroed_elsewhere_keeps_its_account() {
    let (mut zeroed, disk) = head(HeadBy::Reference, HeadPlace::At(90.0));
    assert_eq!(zeroed.homes(ReferenceBy::Person).unwrap(), None);
    zeroed.hears(&Event::Homed, ReferenceBy::Person);
    zeroed.jogs(Motion::new(Axis::Rotate, -90.0)).unwrap();
    // Stopped on its way: the machine counts from where it was zeroed.
    hears(&mut zeroed, &[position(-30.0), STOPPED]);
    assert_eq!(disk.last(), HeadPlace::At(60.0));
}

/// A sum of turns is seldom exactly nothing, and the rest is too small to turn a head by hand.
#[test]
fn what_a_person_reads_as_zero_is_zero() {
    assert!(HeadPlace::At(0.04).is_zero() && HeadPlace::At(-0.04).is_zero());
    assert!(!HeadPlace::At(0.06).is_zero() && !HeadPlace::Between(-0.01, 0.01).is_zero());
}

/// What a machine reports after a line of the console may count from elsewhere.
#[test]
fn after_a_command_the_head_may_be_anywhere_unless_the_driver_says_that_nothing_moved() {
    let done = |moved| Event::ConsoleDone { homed: false, moved };
    let anywhere = HeadPlace::Between(-CABLE_DEG, CABLE_DEG);
    for before in [HeadPlace::At(20.0), HeadPlace::Unsaid] {
        for (events, after) in [
            (vec![done(false)], before),
            (vec![position(5.0), done(true)], anywhere),
            (vec![position(5.0), STOPPED], anywhere),
        ] {
            let (mut head, disk) = head(HeadBy::Kept, before);
            head.may_be_anywhere().unwrap();
            assert_eq!(disk.last(), anywhere, "on the disk before the line is sent");
            hears(&mut head, &events);
            assert_eq!((head.place, disk.last()), (after, after), "{before:?} {events:?}");
        }
    }
}

#[test]
fn a_command_changes_nothing_of_a_head_that_nobody_keeps_account_of() {
    let mut head = Head { place: HeadPlace::At(20.0), ..Head::default() };
    head.may_be_anywhere().unwrap();
    hears(&mut head, &[Event::ConsoleDone { homed: false, moved: true }]);
    assert_eq!(head.place, HeadPlace::At(20.0));
}
