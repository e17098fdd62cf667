//! The log file: what happened, for finding causes later.

use std::path::Path;

pub(crate) use tracing_appender::non_blocking::WorkerGuard as LogGuard;
use tracing_appender::rolling::{RollingFileAppender, Rotation};
use tracing_subscriber::filter::LevelFilter;
use tracing_subscriber::layer::SubscriberExt;
use tracing_subscriber::util::SubscriberInitExt;
use tracing_subscriber::{Layer, fmt};

/// How many days are kept.
const DAYS: usize = 7;

/// Writes what the program logs about its work to a file a day, and warnings to the error stream. What is returned is held
/// until the end: dropping it writes the last lines.
pub(crate) fn begin(state: Option<&Path>) -> Option<LogGuard> {
    let terminal = fmt::layer()
        .with_writer(std::io::stderr)
        .without_time()
        .with_target(false)
        .with_filter(LevelFilter::WARN);
    let file = state.map(|state| {
        let folder = state.join("log");
        // The appender reports what cannot be created.
        let _ = std::fs::create_dir_all(&folder);
        RollingFileAppender::builder()
            .rotation(Rotation::DAILY)
            .filename_prefix("wirebend-kit")
            .filename_suffix("log")
            .max_log_files(DAYS)
            .build(folder)
    });
    let (file, error) = match file {
        Some(Ok(file)) => (Some(tracing_appender::non_blocking(file)), None),
        Some(Err(error)) => (None, Some(error)),
        None => (None, None),
    };
    let (writer, guard) = file.unzip();
    let kept =
        writer.map(|writer| fmt::layer().with_writer(writer).with_ansi(false).with_filter(LevelFilter::INFO));
    tracing_subscriber::registry().with(terminal).with(kept).init();
    if let Some(error) = error {
        tracing::warn!("there is no log file: {error}");
    }
    tracing::info!("wirebend-kit {} begins", env!("CARGO_PKG_VERSION"));
    guard
}
