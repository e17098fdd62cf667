//! Pensa D.I.Wire script: `FEED`, `ROTATE`, `BEND` or `PINZ` and a number a line, in any case.
//!
//! mm and degrees; text in parentheses is a comment. The machine feeds along +y, +BEND turns the
//! formed wire about -z and +ROTATE about +y. Seen from the wire, which travels along -y, these are
//! our own signs: the default convention fits.

use wirebend_error::ErrorRemedy;

use super::super::Imported;
use super::super::error::{Location, ReadError};
use super::super::format::Format;
use super::super::note::{NoteKind, Notes};
use super::super::options::ReadOptions;
use super::super::text::{Source, decode, lines};
use super::{Commands, finish};

/// Whether a word is a command of the script.
pub(in crate::read) fn is_command(word: &str) -> bool {
    ["FEED", "ROTATE", "BEND", "PINZ"].iter().any(|command| word.eq_ignore_ascii_case(command))
}

/// Reads a script; pin commands are counted and ignored.
pub(in crate::read) fn read(
    bytes: &[u8],
    source: Source<'_>,
    options: &ReadOptions,
) -> Result<Imported, ReadError> {
    let factor = options.units.unwrap_or_default().mm() * options.scale;
    let mut commands = Commands::default();
    let mut notes = Notes::default();
    for (line, text) in lines(&decode(bytes)) {
        let (code, comments) = without_comments(source, line, text)?;
        notes.add(NoteKind::CommentsIgnored, comments.len());
        for comment in comments {
            commands.comment(comment);
        }
        let words: Vec<&str> = code.split_whitespace().collect();
        source.room(Location::Line(line), commands.len(), "steps")?;
        let command = words.first().map(|word| word.to_ascii_uppercase()).unwrap_or_default();
        match (command.as_str(), words.as_slice()) {
            (_, []) => {}
            ("FEED", [_, value]) => commands.read_feed(source, line, value, factor)?,
            ("ROTATE", [_, value]) => commands.read_angle(source, line, value, Commands::rotate)?,
            ("BEND", [_, value]) => commands.read_angle(source, line, value, Commands::bend)?,
            ("PINZ", [_, value]) if value.parse::<f64>().is_ok() => {
                notes.add(NoteKind::PinsIgnored, 1);
            }
            _ => {
                let remedy = ErrorRemedy::CorrectFile;
                let expected = "a command: FEED, ROTATE, BEND or PINZ and one number";
                return Err(source.syntax(Location::Line(line), &code, expected, remedy));
            }
        }
    }
    let told = commands.told();
    let steps = commands.finish(&mut notes).counted(options.convention);
    finish(Format::Pensa, source, options, steps, told, notes)
}

/// A line without what is in parentheses, and that.
fn without_comments<'a>(
    source: Source<'_>,
    line: usize,
    text: &'a str,
) -> Result<(String, Vec<&'a str>), ReadError> {
    let mut code = String::new();
    let mut rest = text;
    let mut comments = Vec::new();
    while let Some((before, after)) = rest.split_once('(') {
        let Some((comment, behind)) = after.split_once(')') else {
            let remedy = ErrorRemedy::CorrectFile;
            return Err(source.syntax(Location::Line(line), text, "a comment that ends with )", remedy));
        };
        code.push_str(before);
        code.push(' ');
        rest = behind;
        comments.push(comment);
    }
    code.push_str(rest);
    Ok((code, comments))
}
