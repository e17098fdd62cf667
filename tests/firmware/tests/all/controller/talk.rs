//! A machine on a table, and a host that sends exactly what it is given.

use wirebend_driver_wirebend_kit::protocol::{Lines, NO_SESSION, ReplyFrame, STOP, Status, sealed};

use wirebend_tests_firmware::board::{Board, MS, Reset};
use wirebend_tests_firmware::table::{EDGE, Table};

/// Longer than any answer takes, with the lines before it: 128 bytes are over in 11 ms.
pub const ANSWER_MS: u64 = 20;
/// The session that [`Talk::open`] opens.
pub const SESSION: u16 = 0x1234;
/// Longer than any homing of these tests may take.
const HOMING_MS: u64 = 95_000;

pub struct Talk<B> {
    pub table: Table<B>,
    pub session: u16,
    lines: Lines,
    /// What was heard, seal checked, and not taken.
    pub heard: Vec<String>,
}

impl<B: Board> Talk<B> {
    /// A machine that has just started; what it says first is not taken.
    pub fn new() -> Self {
        Self::at(Table::new())
    }

    pub fn at(table: Table<B>) -> Self {
        let mut talk = Self { table, session: NO_SESSION, lines: Lines::default(), heard: Vec::new() };
        talk.wait(ANSWER_MS);
        talk
    }

    /// With a session and the settings that were compiled in.
    pub fn open() -> Self {
        Self::open_at(Table::new())
    }

    pub fn open_at(table: Table<B>) -> Self {
        let mut talk = Self::at(table);
        talk.begin_session(SESSION);
        talk.asked("L");
        talk
    }

    pub fn begin_session(&mut self, id: u16) {
        self.table.board.send(b"\n"); // what a STOP has left of a line is answered in the old session
        self.wait(ANSWER_MS);
        self.heard.clear();
        self.say_sealed(&format!("S{id}"), NO_SESSION);
        self.session = id;
        self.wait(ANSWER_MS);
        let said = self.taken();
        let [open] = said.as_slice() else { panic!("{}: {said:?}", B::NAME) };
        // How often it has started comes last.
        assert!(open.starts_with(&format!("o{id},0,0,1,113,1,")), "{}: {open}", B::NAME);
    }

    /// Homed by line 1, the peg in. The way from the switch to zero is made short, which saves ten seconds of time.
    pub fn homed() -> Self {
        let mut table = Table::new();
        table.turn_to(EDGE + 100);
        let mut talk = Self::open_at(table);
        assert_eq!(talk.asked("W12,1500"), ["v12,1500"]); // the bend axis may go so far
        assert_eq!(talk.asked("W18,-1600"), ["v18,-1600"]); // and its switch is here
        talk.home(1);
        talk
    }

    pub fn home(&mut self, n: u32) {
        self.say(&format!("H{n}"));
        assert!(self.done(n, HOMING_MS), "{}: not homed: {:?}", B::NAME, self.heard);
        self.heard.clear();
    }

    pub fn say(&mut self, payload: &str) {
        self.say_sealed(payload, self.session);
    }

    pub fn say_sealed(&mut self, payload: &str, seal: u16) {
        self.table.board.send(&sealed(payload, seal));
    }

    pub fn stop(&mut self) {
        self.table.board.send(&[STOP]);
    }

    pub fn reset(&mut self, cause: Reset) {
        self.table.reset(cause);
        self.after_reset();
    }

    /// Begins to listen again, to what it says first.
    pub fn after_reset(&mut self) {
        self.session = NO_SESSION;
        self.lines = Lines::default();
        self.heard.clear();
        self.wait(ANSWER_MS);
    }

    pub fn wait(&mut self, ms: u64) {
        self.wait_cycles(ms * MS);
    }

    pub fn wait_cycles(&mut self, cycles: u64) {
        self.table.run(cycles);
        for byte in std::mem::take(&mut self.table.bytes) {
            let Some(line) = self.lines.feed(byte) else { continue };
            let heard = ReplyFrame::of(&line, self.session);
            assert!(heard.is_some(), "{}: it says {line:?} in session {:#x}", B::NAME, self.session);
            self.heard.push(line.payload);
        }
    }

    pub fn taken(&mut self) -> Vec<String> {
        std::mem::take(&mut self.heard)
    }

    /// Says it, and gives all that is heard in the time of an answer.
    pub fn asked(&mut self, payload: &str) -> Vec<String> {
        self.heard.clear();
        self.say(payload);
        self.wait(ANSWER_MS);
        self.taken()
    }

    /// The last status that was heard after a query now.
    pub fn status(&mut self) -> Status {
        let answers = self.asked("Q");
        let status = answers.iter().rev().find(|answer| answer.starts_with('t')).expect("a status");
        let mut lines = Lines::default();
        let line = sealed(status, NO_SESSION).into_iter().find_map(|byte| lines.feed(byte));
        match ReplyFrame::of(&line.unwrap(), NO_SESSION) {
            Some(ReplyFrame::Status(status)) => status,
            other => panic!("{other:?}"),
        }
    }

    /// Waits for the end of a line, asking for the status as a host does; false when it takes longer.
    pub fn done(&mut self, n: u32, most_ms: u64) -> bool {
        self.until(&format!("d{n}"), most_ms)
    }

    pub fn until(&mut self, wanted: &str, most_ms: u64) -> bool {
        let mut passed = 0;
        while !self.heard.iter().any(|heard| heard == wanted) {
            if passed > most_ms {
                return false;
            }
            if passed % 250 == 0 {
                self.say("Q");
            }
            self.wait(10);
            passed += 10;
        }
        true
    }
}
