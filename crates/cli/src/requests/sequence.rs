//! The request for a sequence.

use std::path::Path;

use wirebend_api::{Command, Output, SequenceRequest};

use super::{design, input};
use crate::args::sequence::SequenceArgs;
use crate::usage::WrongUse;

pub(super) fn sequence(args: SequenceArgs) -> anyhow::Result<Command> {
    if args.output.as_deref() == Some(Path::new("-")) {
        let words = "a sequence goes to a file: name one after -o, or take --json";
        return Err(WrongUse(words.to_owned()).into());
    }
    Ok(Command::Sequence(SequenceRequest {
        design: design(&args.design)?,
        machine: args.machine,
        material: args.material,
        supports: args.supports,
        epsilon_mm: args.epsilon,
        check: args.check.as_deref().map(input).transpose()?,
        layers: args.in_layers,
        group_by: args.group_by,
        cost: args.cost,
        limit_s: args.limit,
        seed: Some(args.seed),
        format: args.format,
        output: args.output.map(|path| Output { path, force: args.force }),
    }))
}
