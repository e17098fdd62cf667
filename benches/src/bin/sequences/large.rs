//! Frames of 6400 struts: what they take of time and memory, each part in a process of its own. A bridge is solved and vibrates; its short
//! struts leave a head no room, and so a sequence is looked for of seven ducks in a row.

use std::ops::ControlFlow;
use std::process::Command;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail, ensure};
use wirebend_frame::{Assembly, Load, ModeKind, ModeSearch, Pieces};
use wirebend_sequence::{GivenStep, Groups, SearchOptions, Task, check, search};

use wirebend_benches::frames::peer::GRAVITY;
use wirebend_benches::frames::{brute, built, models};

use super::searching;

const DUCKS: u32 = 7;

/// The first argument of such a process.
pub const PART: &str = "--part";

pub fn measure() -> Result<()> {
    for part in ["static", "modes", "sequence"] {
        let done = Command::new(std::env::current_exe()?).args([PART, part]).output()?;
        ensure!(done.status.success(), "{part}: {}", String::from_utf8_lossy(&done.stderr));
        print!("{}", String::from_utf8_lossy(&done.stdout));
    }
    Ok(())
}

pub fn part(name: &str) -> Result<()> {
    let model = if name == "sequence" { models::ducks(DUCKS)? } else { models::bridge()? };
    let begin = Instant::now();
    let [mut searched, mut checked] = [Duration::ZERO; 2];
    let mut peak = None;
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
            let search = ModeSearch { count: 3, shift_hz: 100.0, struts: cut.struts, masses: Vec::new() };
            let modes = assembly.modes(&assembly.all(), &search)?;
            let first = modes.iter().find(|mode| mode.kind != ModeKind::Rigid).context("no mode")?;
            format!("3 modes from {:.2} Hz on, 4 pieces a strut", first.frequency_hz)
        }
        "sequence" => {
            let (structure, builder, weight) =
                (searching::structure(&model)?, built::builder(), built::abs());
            let groups = Groups::single(&structure);
            let task = Task { structure: &structure, groups: &groups, builder: &builder, weight: &weight };
            let goes_on = &mut |_: &_| ControlFlow::Continue(());
            let outcome = search(&task, &SearchOptions::default(), goes_on)?;
            ensure!(outcome.is_found(), "{:?}", outcome.obstacle);
            searched = begin.elapsed();
            let steps = outcome.steps.iter().map(|step| GivenStep::of(step, &structure, &builder));
            let steps: Vec<GivenStep> = steps.collect();
            let violations = check(&task, &steps).violations;
            ensure!(violations.is_empty(), "{violations:?}");
            checked = begin.elapsed().saturating_sub(searched);
            // Without what brute force takes.
            peak = Some(peak_mb()?);
            let faults = brute::faults(&task, &steps);
            ensure!(faults.is_empty(), "{faults:?}");
            "a sequence, confirmed by brute force".to_owned()
        }
        other => bail!("there is no part {other}"),
    };
    let all = begin.elapsed();
    let after = if searched.is_zero() {
        String::new()
    } else {
        format!(", and {:.1} s to check it", checked.as_secs_f64())
    };
    let seconds = if searched.is_zero() { all } else { searched }.as_secs_f64();
    let peak = peak.map_or_else(peak_mb, Ok)?;
    println!("{} struts, {words}: {seconds:.2} s{after}, {peak} MB at most", model.members.len());
    Ok(())
}

/// The most memory of this process so far.
fn peak_mb() -> Result<u64> {
    let status = std::fs::read_to_string("/proc/self/status")?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).context("no peak")?;
    let kb: u64 = line.trim().trim_end_matches(" kB").parse()?;
    Ok(kb / 1024)
}
