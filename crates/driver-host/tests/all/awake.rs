//! Time in which this program ran. Where the whole computer stands still, or gives this program no turn, nothing that is expected of it
//! can happen.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::{Duration, Instant};

/// The clock wakes up so often.
const LOOK: Duration = Duration::from_millis(20);
/// What passed between two looks counts as no more.
const MOST_FOR_ONE: Duration = Duration::from_millis(40);

static MICROSECONDS: AtomicU64 = AtomicU64::new(0);
static CLOCK: OnceLock<()> = OnceLock::new();

/// A moment on that clock.
#[derive(Debug, Clone, Copy)]
pub struct Awake(Duration);

impl Awake {
    pub fn now() -> Self {
        CLOCK.get_or_init(|| {
            thread::spawn(|| {
                loop {
                    let begun = Instant::now();
                    thread::sleep(LOOK);
                    let ran = begun.elapsed().min(MOST_FOR_ONE);
                    MICROSECONDS.fetch_add(u64::try_from(ran.as_micros()).unwrap(), Ordering::Relaxed);
                }
            });
        });
        Self(Duration::from_micros(MICROSECONDS.load(Ordering::Relaxed)))
    }

    pub fn elapsed(self) -> Duration {
        Self::now().0.saturating_sub(self.0)
    }
}
