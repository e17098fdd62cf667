//! A progress bar on a terminal.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use wirebend_api::{Observer, Progress, Snapshot, WireProgress};

use crate::render::number::duration;

/// Work that is over within this time is not worth a bar.
const PATIENCE: Duration = Duration::from_millis(300);

/// A line on the error stream that says what is done and how far it is. It appears when the work
/// takes longer than a moment, and is wiped when it is over.
#[derive(Debug)]
pub(crate) struct Bar {
    bar: ProgressBar,
    started: std::time::Instant,
}

impl Bar {
    pub fn new() -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        let style = ProgressStyle::with_template("{msg} [{wide_bar}] {pos}/{len}");
        bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        Self { bar, started: std::time::Instant::now() }
    }

    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }

    /// Does something while the bar is out of the way.
    pub fn aside<T>(&self, act: impl FnOnce() -> T) -> T {
        self.bar.suspend(act)
    }

    fn appear(&self) {
        if self.bar.is_hidden() && self.started.elapsed() > PATIENCE {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
    }
}

impl Progress for Bar {
    fn stage(&self, name: &str) {
        self.appear();
        self.bar.set_message(name.to_owned());
    }

    fn advance(&self, done: u64, of: u64) {
        self.appear();
        self.bar.set_length(of);
        self.bar.set_position(done);
    }
}

impl Observer for Bar {
    fn snapshot(&self, snapshot: &Snapshot) {
        let Some(WireProgress { made, of, elapsed, remaining, .. }) = snapshot.wire else { return };
        self.appear();
        self.bar.set_length(u64::from(of));
        self.bar.set_position(u64::from(made));
        let (elapsed, left) = (duration(elapsed.as_secs_f64()), duration(remaining.as_secs_f64()));
        let next = (made + 1).min(of);
        self.bar.set_message(format!("step {next} of {of}, {elapsed}, about {left} left"));
    }
}
