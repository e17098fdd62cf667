use std::rc::Rc;

use super::*;
use crate::Settings;

/// Homing clears the alarm of a stop. What it goes on by may be on its way when the stop is sent, and be heard together with the alarm.
#[test]
fn homing_that_is_stopped_goes_on_by_nothing() {
    for (homing, heard) in [
        (Homing::Opening, Some(MachineEvent::Open { resumed: None, fresh: None })),
        (Homing::SettingHead, Some(MachineEvent::Answered(Request::Head(0)))),
        (Homing::Stopping, None),
    ] {
        let mut machine = Machine::new(Rc::new(Settings::default()), None, Duration::ZERO);
        machine.activity = Activity::Homing(homing);
        machine.stop(Duration::ZERO);
        for event in heard.into_iter().chain([MachineEvent::Alarm(Alarm::Stop)]) {
            machine.hear(event, Duration::ZERO);
        }
        assert_eq!(machine.activity, Activity::Idle, "{homing:?}");
        assert_eq!(machine.link.line(b'M', &[0, 0, 0]), 1, "a line before this one after {homing:?}");
    }
}
