//! Soft limits: what would leave the range of an axis is refused before anything moves.

use crate::controller::talk::Talk;
use wirebend_tests_firmware::board::{Avr, Board, Host};

/// The ranges of the shipped settings, steps: 155 degrees of 21480 a turn, a turn of the head, 400000 of feed.
const BEND: i32 = 9248;
const HEAD: i32 = 16_457;
const FEED: i32 = 400_000;
/// Refused: beyond the range of an axis, and not homed; 77 is M.
const BEYOND: &str = "e6,2,77";
const NOT_HOMED: &str = "e5,1,77";

fn limits<B: Board>() {
    let mut talk = Talk::<B>::open();
    assert_eq!(talk.asked("M1,100,0,0"), [NOT_HOMED], "{}", B::NAME);
    talk.home(1);
    let pulses = talk.table.pulses();
    let most = i32::MAX;
    let beyond = [
        [FEED + 1, 0, 0],
        [-FEED - 1, 0, 0],
        [0, HEAD + 1, 0],
        [0, -HEAD - 1, 0],
        [0, 0, BEND + 1],
        [0, 0, -BEND - 1],
        [most, most, most],
        [-most, -most, -most],
        [0, most, 0],
        [0, -most, 0],
        [1, 1, -most],
    ];
    for [feed, rotate, bend] in beyond {
        let line = format!("M2,{feed},{rotate},{bend}");
        assert_eq!(talk.asked(&line), [BEYOND], "{}: {line}", B::NAME);
    }
    assert_eq!(talk.table.pulses(), pulses);
    // Up to the limit it goes, and from there back, and not a step further; lines that wait are counted.
    for (line, answer) in [
        (format!("M2,0,{HEAD},0"), "a2,"),
        ("M3,0,1,0".to_owned(), "e6,3,77"),
        (format!("M3,0,{},0", -2 * HEAD), "a3,"),
        ("M4,0,-1,0".to_owned(), "e6,4,77"),
        (format!("M4,0,{HEAD},0"), "a4,"),
    ] {
        let answers = talk.asked(&line);
        assert!(answers[0].starts_with(answer), "{}: {line}: {answers:?}", B::NAME);
    }
    assert!(talk.done(4, 30_000));
    for (n, bend) in [(5, BEND), (6, -BEND)] {
        assert!(talk.asked(&format!("M{n},0,0,{bend}"))[0].starts_with('a'));
        assert!(talk.done(n, 60_000), "{}: {:?}", B::NAME, talk.heard);
        assert_eq!(talk.status().position[2], 0);
    }
}

#[test]
fn no_axis_is_sent_beyond_its_range() {
    limits::<Avr>();
    limits::<Host>();
}

/// The head stands somewhere else than it thinks: a person says where.
fn head<B: Board>() {
    let mut talk = Talk::<B>::homed();
    for steps in [HEAD + 1, -HEAD - 1, i32::MAX, -i32::MAX] {
        assert_eq!(talk.asked(&format!("Z{steps}")), ["e6,2,90"], "{}", B::NAME);
    }
    assert!(talk.asked(&format!("Z{HEAD}"))[0].contains(&format!(",{HEAD},")));
    assert_eq!(talk.asked("M2,0,1,0"), [BEYOND]);
    talk.say("M2,12000,-1,0");
    talk.wait(300);
    assert_eq!(talk.asked("Z0").last().unwrap(), "e1,3,90", "{}: only at rest", B::NAME);
}

#[test]
fn the_head_is_where_a_person_says() {
    head::<Avr>();
    head::<Host>();
}

/// However short a bend is and however far the peg goes back, it goes no further than where it came out.
fn back_off<B: Board>() {
    for (bend, back_off) in [(1, 1193), (-1, 1193), (300, 100_000), (-300, 100_000), (1400, 0)] {
        let mut talk = Talk::<B>::homed();
        talk.asked(&format!("W14,{back_off}"));
        talk.home(2);
        let zero = talk.table.bend;
        talk.say(&format!("M3,0,0,{bend}"));
        let (mut least, mut most) = (0, 0);
        while !talk.heard.iter().any(|heard| heard == "d3") {
            talk.say("Q");
            for _ in 0..200 {
                talk.wait(1);
                let at = talk.table.bend - zero;
                (least, most) = (at.min(least), at.max(most));
            }
        }
        // 1089 steps: the side from which it bends.
        let expected = if bend > 0 { (-1089, bend) } else { (bend, 1089) };
        assert_eq!((least, most), expected, "{}: bend {bend}, back {back_off}", B::NAME);
    }
}

#[test]
fn the_peg_goes_back_no_further_than_it_came_from() {
    back_off::<Avr>();
    back_off::<Host>();
}
