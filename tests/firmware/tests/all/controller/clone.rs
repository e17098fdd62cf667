//! The binary for the `HowToMechatronics` bender, on the pins of its sketch.

use wirebend_driver_wirebend_kit::protocol::{NO_SESSION, sealed};
use wirebend_tests_firmware::{HZ, PinChange, Port, Uno, firmware};

use wirebend_tests_firmware::board::MS;

const SESSION: u16 = 5;
/// D9 and D10: step and direction of the bender; D11: its switch, low when pressed; D2: the servo.
const STEP: (Port, u8) = (Port::B, 1);
const DIRECTION: (Port, u8) = (Port::B, 2);
const SWITCH: (Port, u8) = (Port::B, 3);
const SERVO: (Port, u8) = (Port::D, 2);

fn said(uno: &mut Uno) -> String {
    uno.run_for(100 * MS).unwrap();
    uno.received().into_iter().map(|(_, byte)| char::from(byte)).collect()
}

fn started() -> Uno {
    let mut uno = Uno::new(&firmware("howtomechatronics")).unwrap();
    uno.set_input(SWITCH.0, SWITCH.1, true).unwrap();
    assert!(said(&mut uno).starts_with("b1,113,2,0,0*"), "machine 2");
    uno.send(&sealed(&format!("S{SESSION}"), NO_SESSION));
    uno.send(&sealed("L", SESSION));
    assert!(said(&mut uno).contains("v1,48000*"), "48 steps a millimetre");
    uno.send(&sealed("Q", SESSION));
    assert!(said(&mut uno).contains("t0,0,0,0,0,0,0,2,0,0*"), "at rest, its switch released");
    uno.pins();
    uno
}

fn of(pins: &[PinChange], pin: (Port, u8)) -> Vec<(u64, bool)> {
    let wanted = |change: &&PinChange| (change.port, change.bit) == pin;
    pins.iter().filter(wanted).map(|change| (change.cycle, change.level)).collect()
}

/// The sketch goes to its switch in the direction in which it counts up, and its library drives the pin high then.
#[test]
fn it_looks_for_its_switch_where_the_sketch_does() {
    let mut uno = started();
    uno.send(&sealed("H1", SESSION));
    uno.run_for(2 * HZ).unwrap();
    let pins = uno.pins();
    assert_eq!(of(&pins, DIRECTION).iter().map(|&(_, level)| level).collect::<Vec<_>>(), [true]);
    assert!(of(&pins, STEP).len() > 1000);
    uno.set_input(SWITCH.0, SWITCH.1, false).unwrap();
    uno.run_for(HZ).unwrap();
    assert!(!of(&uno.pins(), DIRECTION)[0].1, "it turns back from the switch");
    uno.send(&[0x80]);
    assert!(said(&mut uno).contains("x1*"));
    uno.pins();
    uno.run_for(HZ).unwrap();
    assert!(of(&uno.pins(), STEP).is_empty());
}

/// Servo positions of the sketch: 130 degrees in, 40 out; the Servo library has 544 µs at 0 and 2400 µs at 180. The
/// program makes these edges itself: they may wait for an interrupt.
#[test]
fn its_servo_gets_the_positions_of_the_sketch() {
    let mut uno = started();
    for (line, degrees) in [("K1,0", 130), ("K2,1", 40)] {
        uno.send(&sealed(line, SESSION));
        uno.run_for(600 * MS).unwrap();
        uno.pins();
        for _ in 0..50 {
            uno.send(&sealed("Q", SESSION));
            uno.run_for(10 * MS).unwrap();
        }
        let edges = of(&uno.pins(), SERVO);
        let widths = edges.windows(2).filter(|pair| pair[0].1).map(|pair| pair[1].0 - pair[0].0);
        let expected = (544 + degrees * (2400 - 544) / 180) * MS / 1000;
        let off: Vec<u64> = widths.map(|width| width.abs_diff(expected)).collect();
        assert!(off.len() > 20, "{off:?}");
        // A count is 4 µs; another interrupt takes less than 10.
        assert!(off.iter().all(|&cycles| cycles <= 14 * MS / 1000), "{line}: {off:?}");
    }
}
