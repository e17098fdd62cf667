//! What is stored outlives a write that is cut at any of its bytes, and bytes that go bad.

use wirebend_driver_wirebend_kit::protocol::{Reset, SETTINGS};
use wirebend_tests_firmware::board::{Avr, Board, Host, MS};

use crate::controller::settings::{COPIES, LENGTH, value};
use crate::controller::talk::{ANSWER_MS, Talk};

/// Cycles after which the board's memory is looked at: fewer than it takes from one byte to the next.
const LOOK: u64 = 40;
/// Where the number of starts is kept, 16 times 4 bytes, and where the side of the peg.
const BOOTS: std::ops::Range<usize> = 128..192;

/// A board of which every state of its memory can be had.
trait Cut: Board + Sized {
    /// What is said, and the memory after each byte that is stored because of it.
    fn images(talk: &mut Talk<Self>, payload: &str) -> Vec<Vec<u8>>;
}

impl Cut for Avr {
    fn images(talk: &mut Talk<Self>, payload: &str) -> Vec<Vec<u8>> {
        let mut images = vec![talk.table.board.stored()];
        talk.say(payload);
        let end = talk.table.board.now() + 2 * ANSWER_MS * MS;
        while talk.table.board.now() < end {
            talk.table.board.uno.run_for(LOOK).unwrap();
            let stored = talk.table.board.stored();
            if images.last() != Some(&stored) {
                images.push(stored);
            }
        }
        talk.wait(ANSWER_MS);
        images
    }
}

impl Cut for Host {
    fn images(talk: &mut Talk<Self>, payload: &str) -> Vec<Vec<u8>> {
        let before = talk.table.board.stored();
        let mut images = vec![before.clone()];
        for bytes in 1.. {
            talk.table.board.store(&before);
            talk.reset(Reset::PowerOn);
            talk.begin_session(3);
            talk.table.board.store(&before); // without this start
            talk.table.board.fail_after(bytes);
            talk.asked(payload);
            let stored = talk.table.board.stored();
            if images.last() == Some(&stored) {
                return images;
            }
            images.push(stored);
        }
        unreachable!()
    }
}

fn all<B: Board>(talk: &mut Talk<B>) -> Vec<i32> {
    SETTINGS.iter().map(|setting| value(talk, setting.id)).collect()
}

/// Each memory of before a byte, with that byte as it was, and with what a supply that fails makes of it.
fn cuts(images: &[Vec<u8>]) -> Vec<Vec<u8>> {
    let mut cuts = images.to_vec();
    for pair in images.windows(2) {
        let changed: Vec<usize> = (0..pair[0].len()).filter(|&at| pair[0][at] != pair[1][at]).collect();
        let [at] = changed[..] else { panic!("not a byte at a time: {changed:?}") };
        for byte in [0xFF, 0, pair[0][at] & pair[1][at], pair[1][at] ^ 0x10] {
            let mut cut = pair[0].clone();
            cut[at] = byte;
            cuts.push(cut);
        }
    }
    cuts
}

/// Settings as they were before or as they are after, and nothing else, however the write was cut.
fn cut<B: Cut>(setting: &str, payload: &str, least: usize) {
    let mut talk = Talk::<B>::open();
    assert_eq!(talk.asked(&format!("W{setting}")), [format!("v{setting}")]);
    let before = all(&mut talk);
    let images = B::images(&mut talk, payload);
    assert!(images.len() > least, "{}, {payload}: {} bytes were stored", B::NAME, images.len());
    talk.table.board.store(images.last().unwrap());
    talk.reset(Reset::PowerOn);
    talk.begin_session(3);
    let after = all(&mut talk);
    assert_ne!(before, after);
    let cuts = cuts(&images);
    let (mut old, mut new) = (0, 0);
    for cut in &cuts {
        talk.table.board.store(cut);
        talk.reset(Reset::PowerOn);
        talk.begin_session(3);
        let found = all(&mut talk);
        assert!(found == before || found == after, "{}, {payload}: {found:?}", B::NAME);
        if found == after {
            new += 1;
        } else {
            old += 1;
        }
        // And it is kept twice again.
        let stored = talk.table.board.stored();
        let [first, second] = COPIES.map(|copy| &stored[copy..copy + LENGTH]);
        assert_eq!(first, second, "{}, {payload}", B::NAME);
    }
    println!(
        "{}, {payload}: cut {} ways at {} bytes: {old} times the old, {new} the new",
        B::NAME,
        cuts.len(),
        images.len() - 1
    );
    assert!(old > 0 && new > 0);
}

#[test]
fn settings_outlive_a_write_that_is_cut_at_any_byte() {
    // Two bytes of the value and the checksum, of each copy; and all that differ from what was compiled in.
    cut::<Avr>("4,6000", "W4,1234", 8);
    cut::<Host>("4,6000", "W4,1234", 8);
    cut::<Avr>("22,15000", "L", 8);
    cut::<Host>("22,15000", "L", 8);
}

/// One copy goes bad while nothing writes: the other is there, and makes it good.
fn one_copy<B: Board>(bits: &[u8]) {
    let mut talk = Talk::<B>::open();
    assert_eq!(talk.asked("W4,1234"), ["v4,1234"]);
    let good = talk.table.board.stored();
    for copy in COPIES {
        for place in 0..LENGTH {
            for bit in bits {
                let mut bytes = good.clone();
                bytes[copy + place] ^= 1 << bit;
                talk.table.board.store(&bytes);
                talk.reset(Reset::PowerOn);
                talk.begin_session(3);
                assert_eq!(value(&mut talk, 4), 1234, "{}: byte {place} bit {bit}", B::NAME);
                let stored = talk.table.board.stored();
                assert_eq!(stored[copy..copy + LENGTH], good[copy..copy + LENGTH], "{}", B::NAME);
            }
        }
    }
}

#[test]
fn one_damaged_copy_of_the_settings_is_made_good_by_the_other() {
    one_copy::<Avr>(&[6]);
    one_copy::<Host>(&[0, 3, 7]);
}

/// The checksum of frames and settings, bit by bit.
fn crc(seed: u16, bytes: &[u8]) -> u16 {
    bytes.iter().fold(seed, |crc, &byte| {
        (0..8).fold(crc ^ u16::from(byte), |crc, _| if crc & 1 == 1 { crc >> 1 ^ 0x8408 } else { crc >> 1 })
    })
}

/// The memory of a board with firmware 1.00: starts, version 1, machine, 24 numbers, checksum from the version on.
fn of_firmware_1_00(machine: u8, values: &[i32; 24]) -> Vec<u8> {
    let mut kept = vec![1, machine];
    kept.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    let sum = crc(1, &kept);
    let mut memory = vec![41, 0];
    memory.extend(kept);
    memory.extend(sum.to_le_bytes());
    memory.resize(1024, 0xFF);
    memory
}

fn taken_over<B: Board>() {
    // The published machine with another feed, as `machine-settings --write` stored it.
    let values = [
        54_001, 16_457, 21_480, 6000, 6000, 900, 30_000, 20_000, 4000, 400_000, 16_457, 9248, 1089, 1193,
        1000, 2000, 500, -9547, 600, 100, 120, 20_000, 90_000, 0,
    ];
    let mut talk = Talk::<B>::new();
    let old = of_firmware_1_00(1, &values);
    for _ in 0..2 {
        talk.table.board.store(&old);
        talk.reset(Reset::PowerOn);
        assert!(talk.taken()[0].ends_with(",42"), "{}: its starts count on", B::NAME);
        talk.begin_session(3);
        assert_eq!(all(&mut talk)[..24], values, "{}", B::NAME);
        // What it did not have is off: the motors hold, and no input is looked at.
        assert!(all(&mut talk)[24..].iter().all(|&value| value == 0), "{}", B::NAME);
    }
    // Once taken over, the old ones do not come back when both copies are damaged.
    let mut stored = talk.table.board.stored();
    for copy in COPIES {
        stored[copy + 9] ^= 1;
    }
    talk.table.board.store(&stored);
    talk.reset(Reset::PowerOn);
    talk.begin_session(3);
    assert_eq!(talk.asked("C1"), ["e7,1,67"], "{}", B::NAME);
    // Damaged, or of another machine, they are refused as ever.
    let mut damaged = old;
    damaged[20] ^= 4;
    for memory in [damaged, of_firmware_1_00(2, &values)] {
        talk.table.board.store(&memory);
        talk.reset(Reset::PowerOn);
        talk.begin_session(3);
        assert_eq!(talk.asked("C1"), ["e7,1,67"], "{}", B::NAME);
        assert_eq!(talk.asked("H1"), ["e7,1,72"], "{}", B::NAME);
    }
}

#[test]
fn settings_of_firmware_1_00_are_taken_over() {
    taken_over::<Avr>();
    taken_over::<Host>();
}

/// Starts are counted on, however the write of the number was cut, and no cell is written at every start.
fn starts<B: Board>() {
    let mut talk = Talk::<B>::open();
    let mut writes = [0; 1024];
    let mut before = talk.table.board.stored();
    for boots in 1..=64_usize {
        talk.reset(Reset::External);
        assert!(talk.taken()[0].ends_with(&format!(",{boots}")), "{}", B::NAME);
        let stored = talk.table.board.stored();
        for at in 0..stored.len() {
            writes[at] += usize::from(stored[at] != before[at]);
        }
        // Cut at any of its bytes: the next start has this number or the one after it, never one of before.
        let changed: Vec<usize> = (0..stored.len()).filter(|&at| stored[at] != before[at]).collect();
        assert!(changed.iter().all(|at| BOOTS.contains(at)), "{}: {changed:?}", B::NAME);
        if boots % 16 < 2 {
            for (count, &at) in changed.iter().enumerate() {
                for byte in [before[at], 0xFF, 0] {
                    let mut cut = before.clone();
                    changed[..count].iter().for_each(|&done| cut[done] = stored[done]);
                    cut[at] = byte;
                    talk.table.board.store(&cut);
                    talk.reset(Reset::PowerOn);
                    let next = talk.taken()[0].rsplit(',').next().unwrap().parse::<usize>().unwrap();
                    assert!(next == boots || next == boots + 1, "{}: {next} after {boots}", B::NAME);
                }
            }
            talk.table.board.store(&stored);
        }
        before = stored;
    }
    let most = writes.iter().max().unwrap();
    println!("{}: 64 starts wrote no cell more than {most} times", B::NAME);
    assert!(*most <= 64 / 16 + 1, "{}: {most}", B::NAME);
}

#[test]
fn starts_are_counted_on_whatever_is_cut_and_wear_no_cell_out() {
    starts::<Avr>();
    starts::<Host>();
}

/// The side of the peg: a cell is written at most once in 64 changes, and a cut write leaves what was before or after.
fn sides<B: Board>() {
    let mut talk = Talk::<B>::homed();
    let mut before = talk.table.board.stored();
    let mut writes = [0; 1024];
    for n in 2..42 {
        talk.say(&format!("M{n},0,0,{}", if n % 2 == 0 { 60 } else { -60 }));
        assert!(talk.done(n, 20_000), "{}: {:?}", B::NAME, talk.heard.last());
        let stored = talk.table.board.stored();
        let changed: Vec<usize> = (0..stored.len()).filter(|&at| stored[at] != before[at]).collect();
        assert!(changed.iter().all(|at| (192..256).contains(at)), "{}: {changed:?}", B::NAME);
        assert_eq!(changed.len(), 2, "{}: out and in", B::NAME);
        for &at in &changed {
            writes[at] += 1;
        }
        before = stored;
    }
    assert!(writes.iter().max() <= Some(&2), "{}: 80 changes of 64 cells", B::NAME);
}

#[test]
fn a_bend_wears_no_cell_out() {
    sides::<Host>();
    sides::<Avr>();
}
