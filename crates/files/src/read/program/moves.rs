//! Recorded moves (`.wbmoves`) as a program: what a machine did by hand.
//!
//! Its feeds, turns and bends are what the machine was told, in canonical signs. Between two bends only the sums of feeds and
//! turns count.

use serde::Deserialize;
use wirebend_core::bend::Step;
use wirebend_core::units::{Angle, Length};
use wirebend_error::ErrorRemedy;

use super::super::Imported;
use super::super::error::{Location, ReadError};
use super::super::format::Format;
use super::super::json;
use super::super::note::{NoteKind, Notes};
use super::super::options::ReadOptions;
use super::super::text::Source;
use super::{Written, finish};

const FORMAT: &str = "wbmoves";
/// The newest version that is known.
const VERSION: u64 = 1;

#[derive(Debug, Deserialize)]
struct Recording {
    format: String,
    version: u64,
    machine: String,
    moves: Vec<Move>,
}

#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(tag = "move", rename_all = "kebab-case")]
enum Move {
    Home,
    Feed { mm: f64 },
    Rotate { deg: f64 },
    Bend { deg: f64 },
}

/// Reads a recording. A wire begins anew where the machine was homed.
pub(in crate::read) fn read(
    bytes: &[u8],
    source: Source<'_>,
    options: &ReadOptions,
) -> Result<Imported, ReadError> {
    let read: Recording = json::parse(bytes, source, "a recording of moves")?;
    if read.format != FORMAT {
        let (found, expected) = (format!("\"format\": \"{}\"", read.format), "\"format\": \"wbmoves\"");
        return Err(source.syntax(Location::File, &found, expected, ErrorRemedy::CorrectFile));
    }
    if read.version != VERSION {
        let found = format!("version {}", read.version);
        return Err(source.syntax(Location::File, &found, "version 1", ErrorRemedy::UpdateProgram));
    }
    let mut notes = Notes::default();
    let begins = read.moves.iter().rposition(|one| *one == Move::Home).map_or(0, |at| at + 1);
    let before = read.moves.iter().take(begins).filter(|one| **one != Move::Home).count();
    notes.add(NoteKind::MovesBeforeHoming, before);
    let factor = options.units.unwrap_or_default().mm() * options.scale;
    let mut steps = Vec::new();
    let (mut fed_mm, mut rotated_deg) = (0.0, 0.0);
    for (index, one) in read.moves.iter().enumerate().skip(begins) {
        source.room(Location::Item("move", index + 1), index, "moves")?;
        match *one {
            Move::Home | Move::Bend { deg: 0.0 } => {}
            Move::Feed { mm } => fed_mm += mm * factor,
            Move::Rotate { deg } => rotated_deg += deg,
            Move::Bend { deg } => {
                steps.push(step(fed_mm, rotated_deg, deg, &mut notes));
                (fed_mm, rotated_deg) = (0.0, 0.0);
            }
        }
    }
    if rotated_deg != 0.0 {
        notes.add(NoteKind::RotationsUnused, 1);
    }
    if fed_mm > 0.0 {
        steps.push(step(fed_mm, 0.0, 0.0, &mut notes));
    }
    let mut imported =
        finish(Format::Moves, source, options, Written { steps, ..Written::default() }, true, notes)?;
    if let Some(program) = &mut imported.program {
        program.machine = Some(read.machine);
    }
    Ok(imported)
}

/// What is drawn back behind the bend before cannot be done to a wire.
fn step(fed_mm: f64, rotated_deg: f64, bend_deg: f64, notes: &mut Notes) -> Step {
    notes.add(NoteKind::DrawnBack, usize::from(fed_mm < 0.0));
    Step {
        feed: Length::from_mm(fed_mm.max(0.0)).unwrap_or_default(),
        rotate: Angle::from_deg(rotated_deg).unwrap_or_default(),
        bend: Angle::from_deg(bend_deg).unwrap_or_default(),
    }
}
