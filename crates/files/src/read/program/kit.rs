//! WireBend-kit text: `F 30.000`, `R -90.000` or `B 45.000` a line, mm and degrees.
//!
//! `#` and `;` start a comment. Source: Faruqi et al., SCF '25, doi 10.1145/3745778.3766662.

use wirebend_error::ErrorRemedy;

use super::super::Imported;
use super::super::error::{Location, ReadError};
use super::super::format::Format;
use super::super::note::{NoteKind, Notes};
use super::super::options::ReadOptions;
use super::super::text::{Source, decode, lines};
use super::{Commands, finish};

/// Reads a program; `options.convention` says how its machine counts the axes.
pub(in crate::read) fn read(
    bytes: &[u8],
    source: Source<'_>,
    options: &ReadOptions,
) -> Result<Imported, ReadError> {
    let factor = options.units.unwrap_or_default().mm() * options.scale;
    let mut commands = Commands::default();
    let mut notes = Notes::default();
    for (line, text) in lines(&decode(bytes)) {
        let (command, comment) = text.split_at(text.find(['#', ';']).unwrap_or(text.len()));
        notes.add(NoteKind::CommentsIgnored, usize::from(!comment.is_empty()));
        commands.comment(comment.trim_start_matches(['#', ';']));
        let words: Vec<&str> = command.split_whitespace().collect();
        source.room(Location::Line(line), commands.len(), "steps")?;
        match *words.as_slice() {
            [] => {}
            ["F" | "f", value] => commands.read_feed(source, line, value, factor)?,
            ["R" | "r", value] => commands.read_angle(source, line, value, Commands::rotate)?,
            ["B" | "b", value] => commands.read_angle(source, line, value, Commands::bend)?,
            _ => {
                let remedy = ErrorRemedy::CorrectFile;
                return Err(source.syntax(Location::Line(line), command, "F, R or B and one number", remedy));
            }
        }
    }
    let told = commands.told();
    let steps = commands.finish(&mut notes).counted(options.convention);
    finish(Format::Kit, source, options, steps, told, notes)
}
