//! What has no place in a table of the design: to which side each bend is run, how far the head is turned for it, and how the part
//! is turned before the first bend. It avoids collisions, or brings every bend within reach of the head.

use wirebend_core::bend::{NominalProgram, Step};
use wirebend_core::plan::fastest_schedule;
use wirebend_core::units::Angle;
use wirebend_error::ErrorRemedy;
use wirebend_files::document::JobWire;

use super::content::Content;
use super::format::Chosen;
use crate::Installation;
use crate::machine::{Setup, kept_steps};
use crate::report::{NoteReport, SHOWN_AS_ZERO};

/// What machines of these tables are not told, where the program of the design relies on it. `None` where they are told all, or where
/// it relies on nothing that they leave out.
pub(super) fn note(app: &Installation, content: &Content, chosen: &Chosen) -> Option<NoteReport> {
    if !chosen.is_of_design() {
        return None;
    }
    let mut wires = 0;
    let mut avoids = false;
    let mut lost = Lost::default();
    for wire in content.wires.iter().filter_map(|wire| wire.kept.as_ref()) {
        let Some((nominal, scheduled)) = steps(wire) else { continue };
        let mut of_wire = Lost::of(&nominal.steps, &scheduled);
        if !wire.avoids_collisions && is_fastest(&content.setup, &nominal, &scheduled) {
            // A machine that reads it finds the sides by itself, and begins with the head at zero.
            of_wire = Lost { first_deg: of_wire.first_deg, ..Lost::default() };
        } else {
            avoids |= of_wire != Lost::default();
        }
        wires += usize::from(of_wire != Lost::default());
        lost.add(of_wire);
    }
    let (why, what) = if avoids {
        ("the wire hits nothing", "hit the wire")
    } else {
        ("the head reaches every bend", "not reach them")
    };
    let words = lost.words();
    (!words.is_empty()).then(|| NoteReport {
        code: "not-carried".into(),
        count: wires,
        message: format!(
            "the program was chosen so that {why}, and {} cannot say all of it: {}; a machine that reads it may {what}",
            chosen.id(),
            words.join(", ")
        ),
        remedies: own_format(app, &content.setup)
            .map(|format| ErrorRemedy::ExportFormat { format })
            .into_iter()
            .chain([ErrorRemedy::WatchFirstWire])
            .collect(),
    })
}

/// The machine's own format, which is told to its axes as planned.
fn own_format(app: &Installation, setup: &Setup) -> Option<String> {
    let export = &setup.machine.profile.export;
    let all = export.native.iter().chain(export.formats.iter().flatten());
    let own = |id: &&String| Chosen::new(app, Some(id), setup).is_ok_and(|chosen| chosen.is_own());
    all.into_iter().find(own).cloned()
}

fn steps(wire: &JobWire) -> Option<(NominalProgram, Vec<Step>)> {
    let spans = wire.spans.iter().map(|&[from, to]| from..to).collect();
    let nominal = NominalProgram { steps: kept_steps(&wire.nominal).ok()?, spans };
    Some((nominal, kept_steps(&wire.scheduled).ok()?))
}

/// Whether a program is run as it is where nobody chooses: the fastest way.
fn is_fastest(setup: &Setup, nominal: &NominalProgram, scheduled: &[Step]) -> bool {
    let Ok(fastest) = fastest_schedule(&setup.model, nominal) else { return false };
    let same = |(one, other): (&Step, &Step)| {
        let off = (one.rotate - other.rotate).abs() + (one.bend - other.bend).abs();
        off.deg() < SHOWN_AS_ZERO
    };
    fastest.steps.iter().zip(scheduled).all(same)
}

#[derive(Debug, Default, PartialEq)]
struct Lost {
    /// How far the head turns before the first bend of each wire where it does, degrees.
    first_deg: Vec<f64>,
    /// Bends to the other side than a table has them.
    flipped: usize,
    /// Bends for which the head turns the long way.
    wound: usize,
}

impl Lost {
    fn of(nominal: &[Step], scheduled: &[Step]) -> Self {
        let mut lost = Self::default();
        let (mut bent, mut turned) = (false, Angle::ZERO);
        for (designed, step) in nominal.iter().zip(scheduled) {
            turned += step.rotate;
            if step.bend == Angle::ZERO {
                continue;
            }
            lost.flipped += usize::from(step.bend.signum() * designed.bend.signum() < 0.0);
            if bent {
                lost.wound += usize::from(turned.abs().deg() > 180.0 + SHOWN_AS_ZERO);
            } else {
                lost.first_deg.extend(Some(turned.deg()).filter(|first| first.abs() > SHOWN_AS_ZERO));
            }
            (bent, turned) = (true, Angle::ZERO);
        }
        lost
    }

    fn add(&mut self, other: Self) {
        self.first_deg.extend(other.first_deg);
        self.flipped += other.flipped;
        self.wound += other.wound;
    }

    fn words(&self) -> Vec<String> {
        let first: Vec<String> = self.first_deg.iter().map(|deg| format!("{deg:.1}°")).collect();
        let bends = |count: usize, one: &str, many: &str| match count {
            0 => None,
            1 => Some(format!("1 bend {one}")),
            _ => Some(format!("{count} bends {many}")),
        };
        let first = (!first.is_empty())
            .then(|| format!("the head turns by {} before the first bend", first.join(" and ")));
        let flipped = bends(self.flipped, "goes to the other side", "go to the other side");
        let wound =
            bends(self.wound, "comes after more than half a turn", "come after more than half a turn");
        [first, flipped, wound].into_iter().flatten().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn step(rotate: f64, bend: f64) -> Step {
        let deg = |deg| Angle::from_deg(deg).unwrap();
        Step { rotate: deg(rotate), bend: deg(bend), ..Step::default() }
    }

    /// A table has positive bends and the shortest rotations between them, and its first bend has none.
    #[test]
    fn what_a_table_says_is_not_lost() {
        let nominal = [step(0.0, 90.0), step(-120.0, 30.0), step(0.0, 0.0)];
        assert_eq!(Lost::of(&nominal, &nominal), Lost::default());
        assert!(Lost::default().words().is_empty());
        // The same wire with the part turned, its second bend to the other side, and that the long way round.
        let turned = [step(40.0, 90.0), step(60.0, -30.0), step(0.0, 0.0)];
        let lost = Lost::of(&nominal, &turned);
        assert_eq!(
            lost.words(),
            ["the head turns by 40.0° before the first bend", "1 bend goes to the other side"]
        );
        let wound = [step(0.0, 90.0), step(240.0, 30.0), step(0.0, 0.0)];
        assert_eq!(Lost::of(&nominal, &wound).words(), ["1 bend comes after more than half a turn"]);
        // Rotations without a bend count towards the next one.
        let divided = [step(0.0, 90.0), step(120.0, 0.0), step(120.0, 30.0)];
        assert_eq!(Lost::of(&[nominal[0], nominal[2], nominal[1]], &divided).wound, 1);
    }
}
