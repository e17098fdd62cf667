//! A board behind a port with a job on it, and what is waited for.

use std::sync::mpsc::{Receiver, channel};
use std::sync::{Condvar, Mutex};
use std::time::Duration;

use wirebend_tests_firmware::{OnPty, Options, Pace};

use crate::jobs::bender::{Bender, Gears, Moment};
use wirebend_tests_firmware::board::{Board, MS};

/// A board that has not moved for so long does not resume by itself: it waits for the host for a second at most.
const STILL: u64 = 1300 * MS;

/// Machines that run at the same time, of all tests: each takes about a tenth of a core with the program that runs it.
const MACHINES: usize = 14;

static RUNNING: Mutex<usize> = Mutex::new(0);
static ENDED: Condvar = Condvar::new();

/// Room for a machine, until it is dropped.
struct Room;

impl Room {
    fn wait() -> Self {
        let full = |running: &mut usize| *running == MACHINES;
        *ENDED.wait_while(RUNNING.lock().unwrap(), full).unwrap() += 1;
        Self
    }
}

impl Drop for Room {
    fn drop(&mut self) {
        *RUNNING.lock().unwrap() -= 1;
        ENDED.notify_one();
    }
}

/// A machine at a port.
pub struct AtPort<B> {
    pub board: OnPty<Bender<B>>,
    pub port: String,
    _room: Room,
}

impl<B: Board + Send + 'static> AtPort<B> {
    /// `stored`: the settings. An Uno starts anew whenever its port is opened; some boards do not.
    pub fn new(gears: Gears, stored: Option<&[u8]>, reset_on_open: bool) -> Self {
        let room = Room::wait();
        let options = Options { pace: Pace::Times(1), reset_on_open };
        let board = OnPty::new(Bender::new(gears, stored), options).unwrap();
        let port = board.port().to_str().unwrap().to_owned();
        Self { board, port, _room: room }
    }

    pub fn with<T: Send + 'static>(&self, what: impl FnOnce(&mut Bender<B>) -> T + Send + 'static) -> T {
        self.board.with(what).unwrap()
    }

    /// Hears of a moment of the job, at which something is done to the board.
    pub fn at(&self, moment: Moment, then: impl FnOnce(&mut Bender<B>) + Send + 'static) -> Receiver<()> {
        let (reached, hears) = channel();
        self.with(move |bender| {
            bender.at(moment, move |bender| {
                then(bender);
                // A caller that does not wait has failed before.
                let _ = reached.send(());
            });
        });
        hears
    }

    /// Waits until nothing moves any more.
    #[track_caller]
    pub fn until_still(&self) {
        let (reached, hears) = channel();
        self.with(move |bender| {
            bender.watch(|bender| bender.still_for() > STILL, move |_| reached.send(()).unwrap_or_default());
        });
        hears.recv_timeout(Duration::from_secs(20)).expect("the machine to stand still");
    }
}
