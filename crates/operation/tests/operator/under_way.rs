//! Program and driver of before were killed while the machine was running a step: its port is not opened before that is over,
//! unless a person wants the machine stopped.

use std::path::PathBuf;

use wirebend_operation::{Answer, MachineState, Phase};

use crate::bender::Bender;
use crate::shop::Shop;

/// The only journal that there is.
fn journal(shop: &Shop) -> PathBuf {
    let mut files =
        std::fs::read_dir(shop.folder.path().join("runs")).unwrap().map(|file| file.unwrap().path());
    files.find(|file| file.extension().is_some_and(|extension| extension == "journal")).unwrap()
}

/// The journal as it is where everything ends once the machine has taken its steps.
fn cut_off(shop: &Shop) {
    let file = journal(shop);
    let text = std::fs::read_to_string(&file).unwrap();
    let end = text.find("\"record\":\"accepted\"").unwrap();
    let line = text[end..].find('\n').unwrap();
    std::fs::write(file, &text[..=end + line]).unwrap();
}

#[test]
fn a_window_counts_down_before_it_opens_a_port_and_a_stop_opens_it_at_once() {
    let (shop, bender) = (Shop::new(), Bender::without_switches());
    let seat = shop.connect("grbl-bender", Some(&bender.port));
    seat.until_phase(Phase::Connected);
    seat.start(&shop.job("u-sample.obj", "grbl-bender"));
    seat.says(Answer::Yes);
    seat.until_run();
    drop(seat);
    cut_off(&shop);

    let heard = bender.heard();
    let seat = shop.connect("grbl-bender", Some(&bender.port));
    let seconds = |below: u64| {
        let left = |state: &MachineState| {
            let doing = state.doing.as_deref().unwrap_or_default();
            let left = doing.strip_prefix("waiting until the machine stands: ")?.strip_suffix(" s")?;
            left.parse::<u64>().ok().filter(|left| *left < below)
        };
        let counts = seat.until_state(|state| left(state).is_some());
        assert_eq!((counts.phase, bender.heard()), (Phase::Connecting, heard), "{counts:?}");
        left(&counts).unwrap()
    };
    // The three steps of a U take 59 s by the profile: half as much again, and a margin, less what has gone by.
    let first = seconds(92);
    assert!(first > 45, "{first} s are left");
    seconds(first);
    assert!(seat.operator.stop());
    assert_eq!(seat.until_problem().0, "stopped");
    seat.until_phase(Phase::Failed);
    assert!(bender.model.resets() > 0, "the stop is at the machine");
}
