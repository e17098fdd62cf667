//! Which orders are possible when, and why the others are not: the one table of it.

use std::collections::BTreeSet;
use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_driver_api::{Capability, ReferenceBy};

use super::phase::Phase;

/// An order without its particulars, such as for a button.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum OrderName {
    /// The machine homes.
    Home,
    /// Moves by hand.
    Jog,
    /// Plans the open design, checks one of its wires and asks a person; after a yes it can be started.
    Arm,
    /// What was armed is not started.
    Disarm,
    /// Bends the armed wire.
    Start,
    /// The machine holds in the middle of a wire.
    Pause,
    /// It resumes after a pause.
    Resume,
    /// Bends the wire slower or faster than it is programmed.
    Speed,
    /// Resumes the wire that was interrupted.
    ResumeRun,
    /// Gives up the wire that was interrupted. Nothing moves for it.
    Abandon,
    /// Replays recorded moves.
    Replay,
    /// Makes the moves of a wire of the open design or file with no wire loaded, slowly, the peg in.
    DryRun,
    /// Sets the machine as its profile says, for good. Nothing moves for it, and it has to be homed afterwards.
    WriteSettings,
    /// Passes on a line that was typed.
    Console,
    /// Closes the port.
    Disconnect,
}

impl OrderName {
    pub const ALL: [Self; 15] = [
        Self::Home,
        Self::Jog,
        Self::Arm,
        Self::Disarm,
        Self::Start,
        Self::Pause,
        Self::Resume,
        Self::Speed,
        Self::ResumeRun,
        Self::Abandon,
        Self::Replay,
        Self::DryRun,
        Self::WriteSettings,
        Self::Console,
        Self::Disconnect,
    ];

    /// What a driver has to be able to do for it.
    const fn needs(self) -> Option<Capability> {
        match self {
            Self::Home => Some(Capability::Home),
            Self::Jog | Self::Replay => Some(Capability::Jog),
            Self::DryRun => Some(Capability::DryRun),
            Self::Pause => Some(Capability::Pause),
            Self::Resume => Some(Capability::Resume),
            Self::Speed => Some(Capability::Speed),
            Self::WriteSettings => Some(Capability::Settings),
            Self::Console => Some(Capability::Console),
            _ => None,
        }
    }
}

impl fmt::Display for OrderName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Home => "homing",
            Self::Jog => "moving by hand",
            Self::Arm => "arming",
            Self::Disarm => "disarming",
            Self::Start => "starting a wire",
            Self::Pause => "pausing",
            Self::Resume => "resuming after a pause",
            Self::Speed => "changing the speed",
            Self::ResumeRun => "resuming an interrupted wire",
            Self::Abandon => "giving up a wire",
            Self::Replay => "replaying moves",
            Self::DryRun => "a dry run",
            Self::WriteSettings => "writing settings",
            Self::Console => "a line of the console",
            Self::Disconnect => "disconnecting",
        })
    }
}

/// Why an order is not possible now.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Because {
    /// The machine is being connected.
    Connecting,
    /// It has to be homed first.
    NotHomed,
    Homing,
    /// It is moved by hand.
    Moving,
    NoWireArmed,
    /// A wire is armed: it has to be started or disarmed first.
    WireArmed,
    /// No wire is being bent.
    NoWireUnderWay,
    /// A wire is being bent.
    WireUnderWay,
    /// The machine holds in the middle of a wire.
    Holding,
    /// A stop is on its way.
    Stopping,
    /// The machine failed, and has to be connected again.
    Failed,
    /// No machine is connected.
    NotConnected,
    /// The driver of the machine cannot do it.
    Unable,
    /// An order before it is not done yet.
    Busy,
    /// A question has to be answered first.
    QuestionOpen,
}

/// An order that is not possible now.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct RefusedOrder {
    pub order: OrderName,
    pub because: Because,
}

/// Which orders are possible.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Orders {
    /// Those that are.
    pub can: Vec<OrderName>,
    /// All others.
    pub cannot: Vec<RefusedOrder>,
}

impl Orders {
    /// In a phase, of a machine whose driver can do so much.
    #[must_use]
    pub fn of(phase: Phase, abilities: &BTreeSet<Capability>, reference: ReferenceBy) -> Self {
        let mut orders = Self::default();
        // What a driver that is lost could do is not known any more.
        let lacks = if phase == Phase::Failed { Because::Failed } else { Because::Unable };
        for order in OrderName::ALL {
            let unable = || order.needs().filter(|needed| !abilities.contains(needed)).map(|_| lacks);
            match refusal(phase, order, reference).or_else(unable) {
                None => orders.can.push(order),
                Some(because) => orders.cannot.push(RefusedOrder { order, because }),
            }
        }
        orders
    }

    /// None of them, for a reason that stands before all others.
    #[must_use]
    pub fn none(because: Because) -> Self {
        let cannot = OrderName::ALL.iter().map(|&order| RefusedOrder { order, because }).collect();
        Self { can: Vec::new(), cannot }
    }

    /// Why an order is not possible; `None` where it is.
    #[must_use]
    pub fn why_not(&self, order: OrderName) -> Option<Because> {
        self.cannot.iter().find(|refused| refused.order == order).map(|refused| refused.because)
    }
}

/// The table.
const fn refusal(phase: Phase, order: OrderName, reference: ReferenceBy) -> Option<Because> {
    use OrderName::{
        Abandon, Arm, Console, Disarm, Disconnect, DryRun, Home, Jog, Pause, Replay, Resume, ResumeRun,
        Speed, Start, WriteSettings,
    };
    match (phase, order) {
        // A wire, and a recording, begin with homing where the reference is not known. Where a person brings
        // the axes to zero, they do it by jogging, too.
        (Phase::Connected | Phase::Stopped, Jog) if !matches!(reference, ReferenceBy::Person) => {
            Some(Because::NotHomed)
        }
        (
            Phase::Connected | Phase::Stopped | Phase::Ready,
            Home | Jog | Arm | ResumeRun | Abandon | Replay | DryRun | WriteSettings | Console | Disconnect,
        )
        | (Phase::Armed, Start | Disarm | Home | Jog | Arm | ResumeRun | Abandon | Replay | DryRun | Disconnect)
        | (Phase::Making, Pause | Speed)
        | (Phase::Holding, Resume | Speed)
        // Homing ends what only the machine itself has against moving; resuming connects anew.
        | (Phase::Failed, Home | ResumeRun | Abandon | Disconnect) => None,
        (Phase::Connected | Phase::Stopped | Phase::Ready, Start | Disarm) => Some(Because::NoWireArmed),
        (Phase::Connected | Phase::Stopped | Phase::Ready | Phase::Armed, Pause | Resume | Speed) => {
            Some(Because::NoWireUnderWay)
        }
        (Phase::Armed, WriteSettings | Console) => Some(Because::WireArmed),
        (Phase::Making, _) => Some(Because::WireUnderWay),
        (Phase::Holding, _) => Some(Because::Holding),
        (Phase::Failed, _) => Some(Because::Failed),
        (Phase::Connecting | Phase::Interrupted, _) => Some(Because::Connecting),
        (Phase::Homing, _) => Some(Because::Homing),
        (Phase::Moving | Phase::Commanded | Phase::Cutting, _) => Some(Because::Moving),
        (Phase::Stopping, _) => Some(Because::Stopping),
        (Phase::Closed, _) => Some(Because::NotConnected),
    }
}

#[cfg(test)]
mod tests {
    use super::super::phase::{Act, Transition};
    use super::*;

    fn can(phase: Phase, reference: ReferenceBy) -> Vec<OrderName> {
        let abilities = [
            Capability::Home,
            Capability::Jog,
            Capability::DryRun,
            Capability::Pause,
            Capability::Resume,
            Capability::Speed,
            Capability::Settings,
            Capability::Console,
        ];
        Orders::of(phase, &abilities.into_iter().collect(), reference).can
    }

    /// A button that is there and is refused when it is pressed would be a puzzle.
    #[test]
    fn what_is_offered_is_not_refused_by_the_session() {
        let acts = [
            (OrderName::Home, Act::Home),
            (OrderName::WriteSettings, Act::WriteSettings),
            (OrderName::Pause, Act::Pause),
            (OrderName::Resume, Act::Resume),
            (OrderName::Speed, Act::Speed),
            (OrderName::Console, Act::Ask),
            (OrderName::Console, Act::Command),
        ];
        for phase in Phase::ALL {
            let offered = can(phase, ReferenceBy::Machine);
            for (order, act) in acts.into_iter().filter(|(order, _)| offered.contains(order)) {
                assert!(matches!(phase.on(act), Transition::To(_)), "{phase}: {order:?}");
            }
        }
    }

    /// What moves is stopped or held; nothing else is asked of it.
    #[test]
    fn a_machine_that_moves_takes_no_other_order() {
        for phase in Phase::ALL.into_iter().filter(|phase| phase.is_under_way()) {
            let expected = match phase {
                Phase::Making => vec![OrderName::Pause, OrderName::Speed],
                Phase::Holding => vec![OrderName::Resume, OrderName::Speed],
                _ => Vec::new(),
            };
            assert_eq!(can(phase, ReferenceBy::Machine), expected, "{phase}");
        }
    }

    #[test]
    fn a_machine_is_homed_before_it_is_jogged_unless_a_person_sets_its_zero() {
        for phase in [Phase::Connected, Phase::Stopped] {
            assert!(!can(phase, ReferenceBy::Machine).contains(&OrderName::Jog), "{phase}");
            assert!(can(phase, ReferenceBy::Person).contains(&OrderName::Jog), "{phase}");
        }
    }

    #[test]
    fn what_a_driver_cannot_do_is_refused_as_such() {
        let orders = Orders::of(Phase::Ready, &BTreeSet::new(), ReferenceBy::Machine);
        assert_eq!(orders.why_not(OrderName::Home), Some(Because::Unable));
        assert_eq!(orders.why_not(OrderName::Start), Some(Because::NoWireArmed));
        assert_eq!(orders.why_not(OrderName::Arm), None);
    }
}
