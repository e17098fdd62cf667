//! Figure: a job is interrupted in every way, at every line, and resumed.

mod case;
mod end;
mod job;

use std::sync::Mutex;
use std::time::Instant;

use crate::jobs::bender::Phase;
use crate::jobs::shop::shared;
use case::{Case, What};
pub use job::{GEARS, Job, MACHINE, coarse};
use wirebend_tests_firmware::board::{Avr, Board, Host};

/// Cases of a test that are under way at the same time: most of a case is waiting for the machine.
const AT_ONCE: usize = 6;
/// Lines of the cube.
const LINES: usize = 8;
/// Moments within a line, per cent of a phase; each way of interrupting a job begins with another one at the first line.
const MOMENTS: [(Phase, usize); 7] = [
    (Phase::Feed, 50),
    (Phase::Swing, 30),
    (Phase::Peg, 0),
    (Phase::Rotate, 60),
    (Phase::Return, 50),
    (Phase::Feed, 10),
    (Phase::Swing, 90),
];

fn cases() -> Vec<Case> {
    let every = What::ALL.into_iter().enumerate();
    let cases = every.flat_map(|(number, (what, resets))| {
        (0..LINES).map(move |line| {
            let (phase, percent) = MOMENTS[(2 * number + line) % MOMENTS.len()];
            // What does not say that opening resets the board, does so at every second line.
            let reset_on_open = resets.unwrap_or(line % 2 == 1);
            Case { what, line, phase, percent, reset_on_open }
        })
    });
    cases.collect()
}

/// How many runs are stopped at random moments, in so many tests, which go on beside each other.
const RANDOM: usize = 200;
const PARTS: usize = 4;

/// Stops, and drivers that are killed, in every phase of every step: seldom the same twice, and the same in every run of the
/// tests.
fn random_cases() -> Vec<Case> {
    let phases = [Phase::Feed, Phase::Rotate, Phase::Peg, Phase::Swing, Phase::Return];
    let mut state = 20_261_122_u64;
    // The constants of Knuth's MMIX.
    let mut random = |below: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(state >> 33).unwrap() % below
    };
    let (known, mut cases) = (self::cases(), Vec::new());
    while cases.len() < RANDOM {
        // The place is not known where a lost driver stops the machine.
        let what = if random(4) == 0 { What::DriverKilled } else { What::Stopped };
        // The last step only feeds, and is over before the program hears of anything.
        let (line, phase, percent) = (random(LINES - 1), phases[random(phases.len())], random(100));
        let case = Case { what, line, phase, percent, reset_on_open: random(2) == 0 };
        if !cases.contains(&case) && !known.contains(&case) {
            cases.push(case);
        }
    }
    cases
}

/// Runs them all, and reports each that failed.
fn try_all<B: Board + Send + 'static>(job: &Job, cases: Vec<Case>, at_once: usize) {
    let begun = Instant::now();
    let count = cases.len();
    let left = Mutex::new(cases.into_iter());
    let failed = Mutex::new(Vec::new());
    let went = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..at_once {
            scope.spawn(|| {
                loop {
                    let Some(case) = left.lock().unwrap().next() else { return };
                    let tried = std::thread::scope(|alone| alone.spawn(|| case.try_on::<B>(job)).join());
                    match tried {
                        Ok(one) => {
                            println!("{}: {case}: {}", B::NAME, one.told);
                            went.lock().unwrap().push(one);
                        }
                        Err(_) => failed.lock().unwrap().push(case),
                    }
                }
            });
        }
    });
    let failed = failed.into_inner().unwrap();
    let went = went.into_inner().unwrap();
    println!(
        "{}: {count} cases in {:.0} s: {} resumed without a question, in {} a person was asked; the farthest corner is {:.3} mm off",
        B::NAME,
        begun.elapsed().as_secs_f64(),
        went.iter().filter(|one| one.asked == 0).count(),
        went.iter().filter(|one| one.asked > 0).count(),
        went.iter().map(|one| one.off_mm).fold(0.0, f64::max)
    );
    assert!(failed.is_empty(), "{}", failed.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "));
}

#[test]
fn a_job_survives_every_interruption_at_every_line() {
    let _others = shared();
    try_all::<Host>(Job::cube(), cases(), AT_ONCE);
}

/// Runs that are stopped at random moments come out as planned.
mod stopped_at_random_moments {
    use super::*;

    fn part(number: usize) {
        let _others = shared();
        let mine = random_cases().into_iter().skip(number).step_by(PARTS);
        try_all::<Host>(Job::cube(), mine.collect(), AT_ONCE);
    }

    #[test]
    fn the_first_quarter() {
        part(0);
    }

    #[test]
    fn the_second_quarter() {
        part(1);
    }

    #[test]
    fn the_third_quarter() {
        part(2);
    }

    #[test]
    fn the_last_quarter() {
        part(3);
    }
}

/// The same with the binary of the board, once each.
#[test]
fn the_board_survives_what_the_core_survives() {
    let _others = shared();
    let lines = [2, 6, 4, 1, 5, 3, 0];
    let some = What::ALL.into_iter().zip(lines).zip(MOMENTS);
    let cases = some.map(|(((what, resets), line), (phase, percent))| Case {
        what,
        line,
        phase,
        percent,
        reset_on_open: resets.unwrap_or(true),
    });
    try_all::<Avr>(Job::cube(), cases.collect(), 4);
}
