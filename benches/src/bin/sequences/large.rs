//! A frame of 6427 struts: what it takes of time and memory, each part in a process of its own.

use std::ops::ControlFlow;
use std::process::Command;
use std::time::Instant;

use anyhow::{Context, Result, bail, ensure};
use wirebend_core::sequence::{GivenStep, Groups, SearchOptions, Task, check, search};
use wirebend_frame::{Assembly, Load, ModeKind, ModeSearch, Pieces};

use super::peer::GRAVITY;
use super::{frames, models, searching};

/// The first argument of such a process.
pub const CHILD: &str = "--part";

pub fn measure() -> Result<()> {
    for part in ["static", "modes", "sequence"] {
        let done = Command::new(std::env::current_exe()?).args([CHILD, part]).output()?;
        ensure!(done.status.success(), "{part}: {}", String::from_utf8_lossy(&done.stderr));
        print!("bridge, 6427 struts, {}", String::from_utf8_lossy(&done.stdout));
    }
    Ok(())
}

pub fn part(name: &str) -> Result<()> {
    let model = models::bridge()?;
    let begin = Instant::now();
    let words = match name {
        "static" => {
            let assembly = Assembly::new(&model)?;
            let load = Load { gravity: GRAVITY, ..Load::default() };
            let response = assembly.factor(&assembly.all())?.solve(&load)?;
            format!("under its own weight {:.3e} mm", response.max_displacement().1)
        }
        "modes" => {
            let cut = Pieces::new(&model, 4);
            let assembly = Assembly::new(&cut.model)?;
            let search = ModeSearch { count: 3, shift_hz: 100.0, struts: cut.struts };
            let modes = assembly.modes(&assembly.all(), &search)?;
            let first = modes.iter().find(|mode| mode.kind != ModeKind::Rigid).context("no mode")?;
            format!("3 modes from {:.2} Hz on, 4 pieces a strut", first.frequency_hz)
        }
        "sequence" => {
            let (structure, builder, weight) =
                (searching::structure(&model), frames::builder(), frames::abs());
            let groups = Groups::single(&structure);
            let task = Task { structure: &structure, groups: &groups, builder: &builder, weight: &weight };
            let goes_on = &mut |_: &_| ControlFlow::Continue(());
            let outcome = search(&task, &SearchOptions::default(), goes_on)?;
            if outcome.is_found() {
                let steps = outcome.steps.iter().map(|step| GivenStep::of(step, &structure, &builder));
                let violations = check(&task, &steps.collect::<Vec<_>>()).violations;
                ensure!(violations.is_empty(), "{violations:?}");
                "a sequence, and its check".to_owned()
            } else {
                format!("no sequence: {:?}", outcome.obstacle.map(|obstacle| obstacle.rule))
            }
        }
        other => bail!("there is no part {other}"),
    };
    let seconds = begin.elapsed().as_secs_f64();
    println!("{words}: {seconds:.2} s, {} MB at most", peak_mb()?);
    Ok(())
}

/// The most memory of this process so far.
fn peak_mb() -> Result<u64> {
    let status = std::fs::read_to_string("/proc/self/status")?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).context("no peak")?;
    let kb: u64 = line.trim().trim_end_matches(" kB").parse()?;
    Ok(kb / 1024)
}
