//! Rules about writing jobs.

use super::sample::{job, mirrored};
use super::subject::{done, refused};
use super::{Conformance, Subject};
use crate::{Call, Capability, Content, Description, Encode, Encoded, Files, FormatDescription, Job};

pub(super) fn check(subject: &mut dyn Subject, description: &Description, found: &mut Conformance) {
    let unknown = refused(encode(subject, "no-such-format", &job())).map(drop);
    found.note("refuses a format that it does not have", unknown);
    if !description.can(Capability::Export) {
        return;
    }
    for format in &description.formats {
        let id = &format.id;
        if !found.note(format!("{id}: writes a job"), writes(subject, format)) {
            continue;
        }
        found.note(format!("{id}: writes the same job the same way"), repeats(subject, format));
        found.note(
            format!("{id}: distinguishes a wire from its mirror image"),
            tells_mirrored(subject, format),
        );
        found.note(format!("{id}: writes every wire of a job"), writes_all(subject, format));
        if format.content == Content::Machine {
            let mut bare = job();
            bare.wires[0].machine = None;
            let outcome = refused(encode(subject, id, &bare)).map(drop);
            found.note(format!("{id}: refuses a wire that has no steps for a machine"), outcome);
        }
    }
}

fn encode(subject: &mut dyn Subject, format: &str, job: &Job) -> Result<crate::Reply, super::Broken> {
    let call = Call::Encode(Box::new(Encode { format: format.to_owned(), job: job.clone() }));
    subject.call(&serde_json::to_vec(&call).unwrap_or_default())
}

fn written(subject: &mut dyn Subject, format: &FormatDescription, job: &Job) -> Result<Vec<String>, String> {
    let reply = done(encode(subject, &format.id, job))?;
    let encoded: Encoded =
        serde_json::from_slice(&reply).map_err(|error| format!("the reply cannot be read: {error}"))?;
    Ok(encoded.files.into_iter().map(|file| file.text).collect())
}

fn writes(subject: &mut dyn Subject, format: &FormatDescription) -> Result<(), String> {
    let files = written(subject, format, &job())?;
    match files.as_slice() {
        [text] if !text.trim().is_empty() => Ok(()),
        [_] => Err("the file is empty".to_owned()),
        files => Err(format!("one wire became {} files", files.len())),
    }
}

fn repeats(subject: &mut dyn Subject, format: &FormatDescription) -> Result<(), String> {
    let (first, second) = (written(subject, format, &job())?, written(subject, format, &job())?);
    if first == second { Ok(()) } else { Err("the second file differs from the first".to_owned()) }
}

fn tells_mirrored(subject: &mut dyn Subject, format: &FormatDescription) -> Result<(), String> {
    let (one, other) = (written(subject, format, &job())?, written(subject, format, &mirrored())?);
    if one == other {
        Err("both are written alike: the sign of the rotation is lost".to_owned())
    } else {
        Ok(())
    }
}

fn writes_all(subject: &mut dyn Subject, format: &FormatDescription) -> Result<(), String> {
    let mut two = job();
    two.wires.push(mirrored().wires.remove(0));
    let (one, files) = (written(subject, format, &job())?, written(subject, format, &two)?);
    let expected = if format.files == Files::One { 1 } else { 2 };
    if files.len() != expected {
        return Err(format!("two wires became {} files, not {expected}", files.len()));
    }
    // One file of all wires has more in it; files of their own are what each would be alone.
    let kept = if expected == 1 { files[0].len() > one[0].len() } else { files[0] == one[0] };
    if kept { Ok(()) } else { Err("what is written of the first wire depends on the second".to_owned()) }
}
