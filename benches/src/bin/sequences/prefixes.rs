//! How far the bunny sags after each step of the sequence that `FrameFab`'s authors publish, by us and by peers.

use anyhow::{Context, Result, ensure};
use nalgebra::Point3;
use wirebend_benches::timed;
use wirebend_frame::{Assembly, Flexibility, Load, Member, MemberId, MemberSet, Model};

use wirebend_benches::frames::peer::{GRAVITY, ask, written};
use wirebend_benches::frames::{built, models};

/// Its pillars stand before the first step.
const PILLARS: usize = 12;
/// Ours and a peer's sags agree so well, as a share.
const SAME: f64 = 1e-6;
/// At least so many times as fast as pyconmech.
const AIM: f64 = 25.0;

pub fn measure(python: &str) -> Result<()> {
    let model = in_order(models::bunny()?)?;
    let steps = model.members.len() + 1 - PILLARS;
    let assembly = Assembly::new(&model)?;
    let (factored, sags) = timed(5, || by_factoring(&assembly))?;
    let (grown, growing) = timed(5, || by_growing(&assembly))?;
    let same = |name: &str, found: &[f64]| -> Result<()> {
        ensure!(found.len() == sags.len(), "{name}: {} sags instead of {}", found.len(), sags.len());
        let mut pairs = found.iter().zip(&sags);
        ensure!(pairs.all(|(found, ours)| (found / ours - 1.0).abs() < SAME), "{name} has other sags");
        Ok(())
    };
    same("growing", &growing)?;
    print!(
        "{steps} frames of the published sequence of the bunny: {grown:.1} ms by one strut more each, {factored:.1} ms each factored;"
    );
    let folder = tempfile::tempdir()?;
    let file = written(folder.path(), &model, PILLARS)?;
    for (peer, aim) in [("pyconmech", Some(AIM)), ("scipy", None)] {
        let theirs = ask(python, &["prefixes", peer], &file)?;
        let ms = theirs["ms"].as_f64().context("no time")?;
        same(peer, &serde_json::from_value::<Vec<f64>>(theirs["max_mm"].clone())?)?;
        print!(" {peer} {ms:.0} ms, {:.0}x", ms / grown);
        match aim {
            Some(aim) => print!(" ({aim:.0}x wanted);"),
            None => println!(),
        }
    }
    Ok(())
}

/// The members in the order in which they are built.
fn in_order(model: Model) -> Result<Model> {
    let near = |one: &Point3<f64>, other: &Point3<f64>| (one - other).norm() < 0.1;
    let ends = |member: &Member| [&model.nodes[member.a.0], &model.nodes[member.b.0]];
    let members: Option<Vec<Member>> = built::published_bunny()
        .iter()
        .map(|step| {
            let is_it = |member: &&Member| {
                let [a, b] = ends(member);
                (near(a, &step.from) && near(b, &step.to)) || (near(b, &step.from) && near(a, &step.to))
            };
            model.members.iter().find(is_it).copied()
        })
        .collect();
    let members = members.context("a step of the published sequence is no strut of the bunny")?;
    ensure!(members.len() == model.members.len(), "{} steps", members.len());
    Ok(Model { members, ..model })
}

fn by_factoring(assembly: &Assembly) -> Result<Vec<f64>> {
    let load = Load { gravity: GRAVITY, ..Load::default() };
    let mut standing = MemberSet::empty(assembly.model().members.len());
    let mut sags = Vec::new();
    for member in (0..assembly.model().members.len()).map(MemberId) {
        standing.insert(member);
        if standing.len() >= PILLARS {
            sags.push(assembly.factor(&standing)?.solve(&load)?.max_displacement().1);
        }
    }
    Ok(sags)
}

fn by_growing(assembly: &Assembly) -> Result<Vec<f64>> {
    let mut growing = Flexibility::new(assembly, GRAVITY);
    let mut sags = Vec::new();
    for member in (0..assembly.model().members.len()).map(MemberId) {
        let sag = growing.add(member)?.max_displacement;
        if growing.standing().len() >= PILLARS {
            sags.push(sag);
        }
    }
    Ok(sags)
}
