//! The window's Rust side behind HTTP on this computer, for tests in a browser.
//!
//! Everything needs the token that is in the printed address: other programs and pages on the computer do not have it.
//! Files that a browser hands over go to a folder of this run. Not part of what is installed.

mod http;

use std::io::Write;
use std::net::{Ipv4Addr, SocketAddr};
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;

use anyhow::{Context, Result};
use clap::Parser;
use tokio::sync::broadcast;
use wirebend_api::{EventSink, Places, WindowEvent, Workspace};

/// How many events are kept for a page that is slow.
const KEPT: usize = 4096;

#[derive(Parser)]
#[command(name = "wirebend-loopback", about = "Serves the editor to a browser on this computer, for tests")]
struct Arguments {
    /// The built editor.
    #[arg(long, value_name = "FOLDER")]
    dist: PathBuf,
    /// Where profiles, journals and handed-over files of this run go.
    #[arg(long, value_name = "FOLDER")]
    home: PathBuf,
    /// The port; 0 takes a free one.
    #[arg(long, default_value_t = 0)]
    port: u16,
}

/// Passes events on to every page that listens.
struct EventRelay(broadcast::Sender<String>);

impl EventSink for EventRelay {
    fn emit(&self, event: &WindowEvent) {
        // Without a page that listens it goes nowhere.
        let _ = serde_json::to_string(event).map(|text| self.0.send(text));
    }
}

fn main() -> ExitCode {
    // The process of a driver is this program too, and knows of nothing else.
    let mut words = std::env::args_os().skip(1);
    if words.next().is_some_and(|word| word == wirebend_api::CHILD_COMMAND) {
        return wirebend_api::child_main(&words.collect::<Vec<_>>());
    }
    tracing_subscriber::fmt().with_writer(std::io::stderr).with_max_level(tracing::Level::WARN).init();
    match serve(Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            tracing::error!("{error:#}");
            ExitCode::FAILURE
        }
    }
}

fn serve(arguments: Arguments) -> Result<()> {
    let Arguments { dist, home, port } = arguments;
    anyhow::ensure!(
        dist.join("index.html").is_file(),
        "{} holds no built editor: build it first",
        dist.display()
    );
    let places = Places {
        own: Some(home.join("own")),
        runs: Some(home.join("runs")),
        state: Some(home.join("state")),
        ..Places::default()
    };
    let files = home.join("files");
    std::fs::create_dir_all(&files).with_context(|| format!("{} cannot be made", files.display()))?;
    let (sender, _) = broadcast::channel(KEPT);
    let desk = Arc::new(Workspace::new(places, Arc::new(EventRelay(sender.clone())))?);
    let token = token()?;
    let runtime = tokio::runtime::Builder::new_multi_thread().worker_threads(2).enable_io().build()?;
    runtime.block_on(async {
        let listener = tokio::net::TcpListener::bind(SocketAddr::from((Ipv4Addr::LOCALHOST, port))).await?;
        writeln!(std::io::stdout(), "http://{}/?token={token}", listener.local_addr()?)?;
        let served = http::Served { desk, events: sender, token: token.into(), dist, files };
        axum::serve(listener, http::router(Arc::new(served))).await?;
        Ok(())
    })
}

/// A number that nobody guesses.
fn token() -> Result<String> {
    let mut bytes = [0_u8; 16];
    getrandom::fill(&mut bytes)
        .map_err(|error| anyhow::anyhow!("this computer has no random numbers: {error}"))?;
    Ok(format!("{:032x}", u128::from_be_bytes(bytes)))
}
