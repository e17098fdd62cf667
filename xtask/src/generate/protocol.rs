//! The codes of the wire protocol, from one table for the firmware, the driver and the manual.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail};

use crate::committed::CommittedFile;

const CODES: &str = "firmware/protocol/codes.csv";
const SETTINGS: &str = "firmware/protocol/settings.csv";
const NOTICE: &str =
    "Made by `cargo xtask generate` from firmware/protocol/codes.csv and settings.csv: change those.";

/// Bits of the setting `inverted`.
const INVERTED: [(&str, u8); 4] = [("feed", 1), ("rotate", 2), ("bend", 4), ("switch", 8)];

struct Code {
    group: String,
    value: String,
    name: String,
    fields: String,
    meaning: String,
}

struct Setting {
    id: u8,
    name: String,
    unit: String,
    min: i32,
    max: i32,
    meaning: String,
}

/// The header of the firmware, the constants of the driver, and the tables of the manual.
pub(super) fn files(root: &Path) -> Result<Vec<CommittedFile>> {
    let codes = codes(root)?;
    let settings = settings(root)?;
    Ok(vec![
        CommittedFile { path: "firmware/core/common/codes.h".into(), text: header(&codes, &settings) },
        CommittedFile {
            path: "drivers/wirebend-kit/src/protocol/codes.rs".into(),
            text: constants(&codes, &settings),
        },
        CommittedFile { path: "firmware/protocol/README.md".into(), text: manual(&codes, &settings) },
    ])
}

fn rows(root: &Path, file: &str) -> Result<Vec<csv::StringRecord>> {
    let text = fs::read_to_string(root.join(file)).with_context(|| format!("cannot read {file}"))?;
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    reader.records().collect::<Result<_, _>>().with_context(|| format!("{file} is no table"))
}

fn codes(root: &Path) -> Result<Vec<Code>> {
    let codes: Vec<Code> = rows(root, CODES)?
        .into_iter()
        .map(|row| {
            let at = |k: usize| row[k].to_owned();
            Code { group: at(0), value: at(1), name: at(2), fields: at(3), meaning: at(4) }
        })
        .collect();
    // An echoed command must never look like a reply.
    let letters = |group: &str| -> Vec<String> {
        codes.iter().filter(|code| code.group == group).map(|code| code.value.to_lowercase()).collect()
    };
    let replies = letters("reply");
    if let Some(shared) = letters("command").iter().find(|letter| replies.contains(letter)) {
        bail!("{CODES}: '{shared}' is a command and a reply");
    }
    Ok(codes)
}

fn settings(root: &Path) -> Result<Vec<Setting>> {
    let mut settings = Vec::new();
    for (k, row) in rows(root, SETTINGS)?.into_iter().enumerate() {
        let number = |at: usize| row[at].parse::<i32>().with_context(|| format!("{SETTINGS}:{}", k + 2));
        let id = u8::try_from(number(0)?)?;
        if usize::from(id) != k + 1 {
            bail!("{SETTINGS}:{}: ids count from 1 without gaps", k + 2);
        }
        settings.push(Setting {
            id,
            name: row[1].to_owned(),
            unit: row[2].to_owned(),
            min: number(3)?,
            max: number(4)?,
            meaning: row[5].to_owned(),
        });
    }
    Ok(settings)
}

fn constant(name: &str) -> String {
    name.replace('-', "_").to_uppercase()
}

fn is_letter(code: &Code) -> bool {
    code.group == "command" || code.group == "reply"
}

fn header(codes: &[Code], settings: &[Setting]) -> String {
    let mut text = format!("/* {NOTICE} */\n#ifndef WB_CODES_H\n#define WB_CODES_H\n");
    let mut group = "";
    for code in codes {
        if code.group != group {
            group = &code.group;
            text.push('\n');
        }
        let value = if is_letter(code) { format!("'{}'", code.value) } else { code.value.clone() };
        let name = format!("WB_{}_{}", constant(group), constant(&code.name));
        let _ = writeln!(text, "#define {name} {value} /* {} */", code.meaning);
    }
    let _ = write!(text, "\n#define WB_SETTINGS_COUNT {}\n", settings.len());
    for Setting { id, name, unit, meaning, .. } in settings {
        let _ = writeln!(text, "#define WB_SETTING_{} {id} /* {unit}: {meaning} */", constant(name));
    }
    let ranges: Vec<String> =
        settings.iter().map(|Setting { min, max, .. }| format!("    {{{min}, {max}}}")).collect();
    let _ = write!(text, "\n#define WB_SETTINGS_RANGES \\\n{}\n\n", ranges.join(", \\\n"));
    for (name, bit) in INVERTED {
        let _ = writeln!(text, "#define WB_INVERTED_{} {bit}", constant(name));
    }
    text.push_str("\n#endif\n");
    text
}

fn camel(name: &str) -> String {
    let part = |part: &str| part[..1].to_uppercase() + &part[1..];
    name.split(['-', '_']).map(part).collect()
}

fn constants(codes: &[Code], settings: &[Setting]) -> String {
    let mut text = format!("//! Codes of the wire protocol.\n//!\n//! {NOTICE}\n");
    let title = |group: &str| match group {
        "command" => ("Command", "A request of the host."),
        "reply" => ("Reply", "A frame of the controller: an answer, or a report."),
        "error" => ("Refusal", "Why a command is refused."),
        "alarm" => ("Alarm", "Why the controller has stopped or holds."),
        "state" => ("State", "What the controller is doing."),
        "reset" => ("Reset", "Why the controller has started."),
        _ => ("Machine", "The machine that a firmware was built for: its pins and its default settings."),
    };
    let mut groups: Vec<&str> = codes.iter().map(|code| code.group.as_str()).collect();
    groups.dedup();
    for group in groups {
        let (name, doc) = title(group);
        let members: Vec<&Code> = codes.iter().filter(|code| code.group == group).collect();
        let letters = members.iter().all(|code| is_letter(code));
        let value = |code: &Code| if letters { format!("b'{}'", code.value) } else { code.value.clone() };
        let _ = write!(
            text,
            "\n/// {doc}\n#[derive(Debug, Clone, Copy, PartialEq, Eq)]\n#[repr(u8)]\npub enum {name} {{\n"
        );
        for code in &members {
            let _ = writeln!(text, "    /// {}.", code.meaning);
            let _ = writeln!(text, "    {} = {},", camel(&code.name), value(code));
        }
        let _ = write!(
            text,
            "}}\n\nimpl {name} {{\n    /// The variant with this code.\n    #[must_use]\n    pub const fn of(code: u8) -> Option<Self> {{\n        Some(match code {{\n"
        );
        for code in &members {
            let _ = writeln!(text, "            {} => Self::{},", value(code), camel(&code.name));
        }
        text.push_str("            _ => return None,\n        })\n    }\n");
        if !letters {
            text.push_str("\n    /// The text for a user.\n    #[must_use]\n    pub const fn meaning(self) -> &'static str {\n        match self {\n");
            for code in &members {
                let meaning = match group {
                    "machine" => code.meaning.clone(),
                    _ => code.meaning.to_lowercase().replace("stop byte", "STOP byte"),
                };
                let _ = writeln!(text, "            Self::{} => {meaning:?},", camel(&code.name));
            }
            text.push_str("        }\n    }\n");
        }
        if group == "machine" {
            text.push_str("\n    /// Its file in `firmware/machines`, by which its firmware is built.\n    #[must_use]\n    pub const fn name(self) -> &'static str {\n        match self {\n");
            for code in &members {
                let _ = writeln!(text, "            Self::{} => {:?},", camel(&code.name), code.name);
            }
            text.push_str("        }\n    }\n");
        }
        text.push_str("}\n");
    }
    text.push_str(
        "\n/// A setting of the controller.\n#[derive(Debug, Clone, Copy, PartialEq, Eq)]\npub struct Setting {\n    /// Its id in frames.\n    pub id: u8,\n    /// As in profiles and messages.\n    pub name: &'static str,\n    /// Unit of its value.\n    pub unit: &'static str,\n    /// Smallest allowed value.\n    pub min: i32,\n    /// Largest allowed value.\n    pub max: i32,\n}\n\n",
    );
    let _ = writeln!(
        text,
        "/// Every setting, in order of their numbers, which count from 1.\npub const SETTINGS: [Setting; {}] = [",
        settings.len()
    );
    for Setting { id, name, unit, min, max, .. } in settings {
        let _ = writeln!(
            text,
            "    Setting {{ id: {id}, name: {name:?}, unit: {unit:?}, min: {}, max: {} }},",
            grouped(*min),
            grouped(*max)
        );
    }
    text.push_str("];\n");
    text
}

/// A number as clippy wants to see it.
fn grouped(number: i32) -> String {
    let digits = number.unsigned_abs().to_string();
    let mut text = String::new();
    for (k, digit) in digits.chars().enumerate() {
        if k > 0 && (digits.len() - k).is_multiple_of(3) && digits.len() > 4 {
            text.push('_');
        }
        text.push(digit);
    }
    if number < 0 { format!("-{text}") } else { text }
}

fn manual(codes: &[Code], settings: &[Setting]) -> String {
    let mut text = format!("# The wire protocol: codes and settings\n\n{NOTICE}\n\n");
    text.push_str(
        "A frame is `PAYLOAD*HHHH` and a newline; the rules are in [the firmware's manual](../README.md).\n",
    );
    let heading = |group: &str| match group {
        "command" => "Commands: from the host",
        "reply" => "Replies: from the controller",
        "error" => "Errors of `e`",
        "alarm" => "Alarms of `x` and `t`",
        "state" => "States of `t`",
        "reset" => "Causes of a reset of `b`",
        _ => "Machines of `b` and `o`",
    };
    let mut group = "";
    for code in codes {
        if code.group != group {
            group = &code.group;
            let first = if is_letter(code) { "Payload" } else { "Code" };
            let _ = write!(
                text,
                "\n## {}\n\n| {first} | Name | Meaning |\n| --- | --- | --- |\n",
                heading(group)
            );
        }
        let _ = writeln!(text, "| `{}{}` | {} | {} |", code.value, code.fields, code.name, code.meaning);
    }
    text.push_str("\n## Settings\n\n| Id | Name | Unit | Min | Max | Meaning |\n| --- | --- | --- | --- | --- | --- |\n");
    for Setting { id, name, unit, min, max, meaning } in settings {
        let _ = writeln!(text, "| {id} | `{name}` | {unit} | {min} | {max} | {meaning} |");
    }
    text
}
