//! Figures of the binary: what it takes of the chip, and how long the step interrupt takes.

use std::process::Command;

use wirebend_tests_firmware::{firmware, vector};

use crate::controller::talk::Talk;
use wirebend_tests_firmware::board::{Avr, Board, HZ, MS};

/// Most of the flash and of the RAM that it may take, bytes; the chip has 32 KB less the boot loader, and 2 KB.
const FLASH: usize = 24 * 1024;
const RAM: usize = 1434;
/// Steps a second that every axis must be able to make.
const RATE: u64 = 6000;

fn sections(machine: &str) -> (usize, usize) {
    let out = Command::new("avr-size").arg(firmware(machine)).output().unwrap();
    let text = String::from_utf8(out.stdout).unwrap();
    let sizes: Vec<usize> =
        text.lines().nth(1).unwrap().split_whitespace().take(3).map(|n| n.parse().unwrap()).collect();
    let [text, data, bss] = sizes[..] else { panic!("{text}") };
    (text + data, data + bss)
}

#[test]
fn flash_of_both_machines() {
    for machine in ["wirebend-kit", "howtomechatronics"] {
        let (flash, ram) = sections(machine);
        println!("{machine}: {flash} bytes of flash, {ram} of RAM for variables");
        assert!(flash <= FLASH);
    }
}

/// Everything at once: all phases of lines, questions, damaged lines, settings stored, homing, a STOP.
#[test]
fn ram_with_the_deepest_stack() {
    let mut talk = Talk::<Avr>::homed();
    talk.table.board.uno.paint_stack().unwrap();
    let before = talk.table.board.uno.untouched_stack().unwrap();
    talk.asked("L");
    talk.asked("W12,1500");
    talk.asked("W18,-1600");
    talk.home(2);
    for n in 3..=10_u32 {
        talk.say(&format!("M{n},-2000,{},{}", if n % 2 == 0 { 900 } else { -900 }, 100 * n));
    }
    for i in 0..3000_u32 {
        talk.say(
            ["Q", "M4294967295,-2147483647,-2147483647,-2147483647", "C24", "X", "P", "G"][i as usize % 6],
        );
        talk.table.board.send(b"\x01 noise \xFF\n");
        talk.wait(6);
    }
    talk.stop();
    talk.home(11);
    let uno = &talk.table.board.uno;
    let (untouched, end) = (uno.untouched_stack().unwrap(), uno.symbol("_end").unwrap());
    let (variables, stack) = (end - 0x100, 0x900 - end - untouched);
    println!(
        "RAM: {variables} bytes of variables, {stack} of stack at the deepest, {} in all",
        variables + stack
    );
    assert!(untouched < before, "the paint shows nothing");
    assert!(variables + stack <= RAM);
}

/// One instruction after the other: from the entry of the step interrupt to its pulse, and to its end.
#[test]
fn the_step_interrupt() {
    let mut talk = Talk::<Avr>::homed();
    talk.say("M2,3000,0,0");
    talk.wait(100); // in the middle of the ramp, where every step has its division
    let count = |talk: &Talk<Avr>| {
        talk.table
            .board
            .uno
            .interrupt_times()
            .iter()
            .find(|t| t.vector == vector::TIMER1_COMPA)
            .unwrap()
            .count
    };
    let (mut to_pulse, mut entered, mut known) = (0, 0, count(&talk));
    let end = talk.table.board.now() + HZ / 20;
    while talk.table.board.now() < end {
        let before = talk.table.board.now();
        talk.table.board.uno.run_for(1).unwrap();
        if count(&talk) > known {
            (known, entered) = (known + 1, before);
        }
        for pin in talk.table.board.uno.pins() {
            if pin.bit == 2 && pin.level {
                to_pulse = to_pulse.max(pin.cycle - entered);
            }
        }
    }
    assert!(to_pulse > 0);
    // Both parts, with every other interrupt that comes between them, in all that the tests of the pins do.
    let mut talk = Talk::<Avr>::homed();
    for line in ["M2,6000,3000,1400", "M3,-6000,-3000,-1400"] {
        talk.say(line);
    }
    while !talk.heard.contains(&"d3".to_owned()) {
        talk.heard.clear();
        talk.say("Q");
        talk.wait(5);
    }
    let times = talk.table.board.uno.interrupt_times();
    for time in &times {
        println!("vector {}: {} times, {} cycles at most", time.vector, time.count, time.worst_cycles);
    }
    let step = times.iter().find(|time| time.vector == vector::TIMER1_COMPA).unwrap();
    // The chip takes 4 cycles to enter an interrupt, and one instruction of the main loop between two of them.
    let whole = step.worst_cycles + 8;
    let rate = HZ / whole;
    println!("step interrupt: {} cycles to the pulse, {whole} in all: up to {rate} steps/s", to_pulse + 4);
    assert!(rate >= RATE, "{rate} steps/s");
    assert!(to_pulse < 160, "{to_pulse} cycles to the pulse");
    assert!(talk.table.board.uno.overruns() == 0 && whole < 10 * MS);
}

/// A controller that waits takes no power for it, and is simulated fast.
#[test]
fn a_controller_that_has_nothing_to_do_sleeps() {
    let mut talk = Talk::<Avr>::homed();
    for (doing, least_percent) in [("nothing", 95), ("a line", 50)] {
        if doing == "a line" {
            talk.say("M2,6000,0,0");
        }
        let uno = &talk.table.board.uno;
        let (begun, slept) = (uno.cycle(), uno.asleep());
        talk.wait(500);
        let uno = &talk.table.board.uno;
        let percent = (uno.asleep() - slept) * 100 / (uno.cycle() - begun);
        println!("{doing}: asleep {percent} % of the time");
        assert!(percent >= least_percent, "{doing}: {percent} %");
    }
}
