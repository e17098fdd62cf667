//! Options that several commands have, and what their words become.

use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use wirebend_api::{
    Format, Handedness, LengthUnit, ProfileKind, ProgramKind, SearchWeights, ShortestEdge, StageName,
    StepPause,
};

/// Which kind of profile is meant.
#[derive(Debug, Args)]
pub(crate) struct KindArgs {
    /// Kind of the profile, where several kinds have its id
    #[arg(long, value_name = "KIND", value_parser = kind_parser())]
    pub kind: Option<ProfileKind>,
}

/// What is not given reads a file with these.
const SCALE: f64 = 1.0;
const WELD_MM: f64 = 0.001;
const TOLERANCE_MM: f64 = 0.1;

/// How to read a file.
#[derive(Debug, Args)]
pub(crate) struct ReadArgs {
    /// Format of the file, where its name and contents do not tell
    #[arg(long, value_name = "FORMAT", value_parser = parse_format)]
    pub from: Option<Format>,
    /// Factor on all coordinates
    #[arg(long, value_name = "FACTOR", default_value_t = SCALE)]
    pub scale: f64,
    /// Unit of the coordinates: mm, cm, m or inch
    #[arg(long, value_name = "UNIT", value_parser = parse_unit)]
    pub units: Option<LengthUnit>,
    /// Join vertices that are closer than this, in mm; corners of a program or a table are joined without it as far as their rounded figures miss
    #[arg(long, value_name = "TOLERANCE", default_value_t = WELD_MM)]
    pub weld: f64,
    /// Take the edges of faces as the wireframe
    #[arg(long)]
    pub face_edges: bool,
    /// Centreline radius of the bends of a table that does not say, in mm
    #[arg(long, value_name = "RADIUS")]
    pub clr: Option<f64>,
    /// Make curves of a drawing straight edges that are no farther from them than this, in mm
    #[arg(long, value_name = "DISTANCE", default_value_t = TOLERANCE_MM)]
    pub tolerance: f64,
    /// Make no edge of a curve of a drawing shorter than this, in mm, though it may be farther from the curve; or machine: what the machine can make
    #[arg(long, value_name = "LENGTH", value_parser = parse_shortest_edge)]
    pub shortest_edge: Option<ShortestEdge>,
    /// Read this layer of a drawing only, by name; may be given again
    #[arg(long = "layer", value_name = "NAME")]
    pub layers: Vec<String>,
    /// Way in which the rotations of a table turn, where the table does not say: right or left
    #[arg(long, value_name = "HAND", value_parser = handedness_parser())]
    pub handedness: Option<Handedness>,
    /// What the steps of a program are, where it does not say: nominal (the design), or compensated (what a machine was told)
    #[arg(long, value_name = "KIND", value_parser = program_parser())]
    pub program: Option<ProgramKind>,
}

/// What to work on.
#[derive(Debug, Args)]
pub(crate) struct DesignArgs {
    /// Wireframe: a .wirebend document or any file that can be imported, or - for standard input
    #[arg(value_name = "WIREFRAME")]
    pub file: PathBuf,
    #[command(flatten)]
    pub read: ReadArgs,
}

/// What to export.
#[derive(Debug, Args)]
pub(crate) struct ExportedArgs {
    /// Job, wireframe document or any file that can be imported, or - for standard input
    #[arg(value_name = "JOB|WIREFRAME")]
    pub file: PathBuf,
    #[command(flatten)]
    pub read: ReadArgs,
}

/// On which machine, and which way the wire runs.
#[derive(Debug, Args)]
#[allow(clippy::struct_excessive_bools)] // each is an option of its own
pub(crate) struct ChoiceArgs {
    /// Machine, by id (see `wirebend machines`)
    #[arg(long, short, value_name = "ID")]
    pub machine: Option<String>,
    /// Wire in the machine, by id (see `wirebend materials`)
    #[arg(long, value_name = "ID")]
    pub material: Option<String>,
    /// Run the wire along the cheapest edges twice where the wires cannot run otherwise
    #[arg(long)]
    pub double: bool,
    /// Run it along edges twice, too, where only such a detour avoids a bend that the machine cannot make
    #[arg(long)]
    pub detours: bool,
    /// Bend the design from up to N wires, fewer where more would not save doubled edges; with `plan`, N..M compares numbers of wires
    #[arg(long, value_name = "N", value_parser = parse_wires)]
    pub wires: Option<WireRange>,
    /// End the wire where it starts
    #[arg(long, conflicts_with = "wires")]
    pub closed: bool,
    /// Vertex where the wire starts
    #[arg(long, value_name = "VERTEX")]
    pub start: Option<u32>,
    /// Run the wire the other way
    #[arg(long)]
    pub reverse: bool,
    /// Keep the bend order of the imported program, from its start to its end
    #[arg(long, conflicts_with_all = ["double", "detours", "wires", "closed", "start"])]
    pub keep_order: bool,
    /// Look where the wire hits the machine or itself while it is bent
    #[arg(long)]
    pub collisions: bool,
    /// Search for wires that hit nothing: another walk, other sides of the bends, and if need be more wires (with --wires N, up to N)
    #[arg(long, conflicts_with = "reverse")]
    pub avoid_collisions: bool,
    /// Steps that the search may check for each number of wires, 20000 by default
    #[arg(long, value_name = "STEPS", requires = "avoid_collisions", value_parser = clap::value_parser!(u32).range(1..))]
    pub effort: Option<u32>,
    /// Seed of the search; the same seed finds the same
    #[arg(long = "search-seed", value_name = "SEED", requires = "avoid_collisions")]
    pub search_seed: Option<u64>,
    /// What each wire, each doubled mm and each second costs the search, as wires=1000,doubled=1,time=5: the least sum is the best.
    /// Without weights fewest wires count first, then the least doubled length, then the least time
    #[arg(long, value_name = "WEIGHTS", requires = "avoid_collisions", value_parser = parse_weights)]
    pub weights: Option<SearchWeights>,
    /// Say how far the part already bent sags under its own weight while it is bent; with --collisions, look as it hangs
    #[arg(long)]
    pub sag: bool,
    #[command(flatten)]
    pub clearance: ClearanceArgs,
}

impl ReadArgs {
    /// Those that are given.
    pub fn given(&self) -> Vec<&'static str> {
        let is_other = |value: f64, plain: f64| value.total_cmp(&plain).is_ne();
        named(&[
            ("--from", self.from.is_some()),
            ("--scale", is_other(self.scale, SCALE)),
            ("--units", self.units.is_some()),
            ("--weld", is_other(self.weld, WELD_MM)),
            ("--face-edges", self.face_edges),
            ("--clr", self.clr.is_some()),
            ("--tolerance", is_other(self.tolerance, TOLERANCE_MM)),
            ("--shortest-edge", self.shortest_edge.is_some()),
            ("--layer", !self.layers.is_empty()),
            ("--handedness", self.handedness.is_some()),
            ("--program", self.program.is_some()),
        ])
    }
}

impl ChoiceArgs {
    /// Those that are given of how the wires run.
    pub fn walk(&self) -> Vec<&'static str> {
        named(&[
            ("--double", self.double),
            ("--detours", self.detours),
            ("--wires", self.wires.is_some()),
            ("--closed", self.closed),
            ("--start", self.start.is_some()),
            ("--reverse", self.reverse),
            ("--keep-order", self.keep_order),
            ("--avoid-collisions", self.avoid_collisions),
        ])
    }

    /// Those that are given of what is looked at while a wire is bent.
    pub fn looks(&self) -> Vec<&'static str> {
        named(&[("--collisions", self.collisions), ("--sag", self.sag)])
    }
}

fn named(options: &[(&'static str, bool)]) -> Vec<&'static str> {
    options.iter().filter(|(_, given)| *given).map(|(name, _)| *name).collect()
}

/// How far the wire has to stay from what it could hit.
#[derive(Debug, Args)]
pub(crate) struct ClearanceArgs {
    /// With --collisions, also name what comes nearer than this without hitting, in mm, instead of what the design or the job says
    #[arg(long, value_name = "MM", requires = "collisions", allow_negative_numbers = true)]
    pub clearance: Option<f64>,
}

/// Where the result goes.
#[derive(Debug, Args)]
pub(crate) struct OutputArgs {
    /// File to write, or - for standard output
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Replace a file that is there
    #[arg(long)]
    pub force: bool,
}

/// What a person has to say that they know.
#[derive(Debug, Args)]
pub(crate) struct DangerArgs {
    /// Write a program although a check says that it cannot be made
    #[arg(long)]
    pub despite_errors: bool,
}

/// A number of wires, or a range of them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WireRange {
    pub from: u32,
    pub to: u32,
}

impl WireRange {
    /// Whether it is more than one number.
    pub fn is_several(self) -> bool {
        self.from < self.to
    }
}

/// `N` or `N..M`.
fn parse_wires(text: &str) -> Result<WireRange, String> {
    let (from, to) = text.split_once("..").unwrap_or((text, text));
    let range = from.parse().ok().zip(to.parse().ok()).map(|(from, to)| WireRange { from, to });
    let range = range.filter(|range| (1..=range.to).contains(&range.from));
    range.ok_or_else(|| "expected a number of wires, at least 1, or a range such as 1..6".to_owned())
}

/// `wires=W,doubled=W,time=W`; what is left out costs nothing.
fn parse_weights(text: &str) -> Result<SearchWeights, String> {
    let mut weights = SearchWeights::default();
    let mut named: Vec<&str> = Vec::new();
    for part in text.split(',') {
        let (name, value) =
            part.split_once('=').ok_or_else(|| format!("'{part}' has no weight; {WEIGHTS}"))?;
        if named.contains(&name.trim()) {
            return Err(format!("'{}' has two weights; {WEIGHTS}", name.trim()));
        }
        named.push(name.trim());
        let weight = match name.trim() {
            "wires" => &mut weights.wire,
            "doubled" => &mut weights.doubled_mm,
            "time" => &mut weights.second,
            _ => return Err(format!("'{name}' has no weight; {WEIGHTS}")),
        };
        *weight = value.trim().parse().map_err(|_| format!("'{value}' is no whole number; {WEIGHTS}"))?;
    }
    if weights == SearchWeights::default() {
        return Err(format!("all of them are 0; {WEIGHTS}"));
    }
    Ok(weights)
}

const WEIGHTS: &str = "expected whole numbers for some of wires, doubled (each mm) and time (each second), such as \
                       wires=1000,doubled=1,time=5";

fn parse_format(word: &str) -> Result<Format, String> {
    word.parse().map_err(|error: <Format as std::str::FromStr>::Err| error.to_string())
}

/// `KEY=VALUE`; a value that is no JSON is a text.
pub(super) fn parse_setting(text: &str) -> Result<(String, serde_json::Value), String> {
    let (key, value) = text.split_once('=').ok_or("expected KEY=VALUE, such as decimals=2")?;
    let value = serde_json::from_str(value).unwrap_or_else(|_| serde_json::Value::String(value.to_owned()));
    Ok((key.to_owned(), value))
}

/// `STEP:NOTE` or `WIRE/STEP:NOTE`, both counted from 1.
pub(super) fn parse_pause(text: &str) -> Result<StepPause, String> {
    const EXPECTED: &str = "expected STEP:NOTE, such as 3:turn the part, or WIRE/STEP:NOTE";
    let (place, note) = text.split_once(':').ok_or(EXPECTED)?;
    let (wire, step) = place.split_once('/').unwrap_or(("1", place));
    let number = |text: &str| text.trim().parse::<u32>().ok().filter(|number| *number > 0).ok_or(EXPECTED);
    let (wire, after) = (number(wire)?, number(step)?);
    if note.trim().is_empty() {
        return Err("the note is empty: say what is to be done there, such as 3:turn the part".to_owned());
    }
    Ok(StepPause { wire: wire as usize - 1, after, note: note.to_owned() })
}

fn parse_unit(word: &str) -> Result<LengthUnit, String> {
    LengthUnit::from_word(word).ok_or_else(|| "expected mm, cm, m or inch".to_owned())
}

fn parse_shortest_edge(word: &str) -> Result<ShortestEdge, String> {
    if word == "machine" {
        return Ok(ShortestEdge::Machine);
    }
    word.parse().map(ShortestEdge::Mm).map_err(|_| "expected a length in mm, or machine".to_owned())
}

fn handedness_parser() -> impl TypedValueParser<Value = Handedness> {
    // The parser before has refused every other word.
    PossibleValuesParser::new(Handedness::ALL.map(Handedness::name))
        .map(|word| if word == Handedness::Left.name() { Handedness::Left } else { Handedness::Right })
}

fn program_parser() -> impl TypedValueParser<Value = ProgramKind> {
    let compensated = ProgramKind::Compensated;
    PossibleValuesParser::new(ProgramKind::ALL.map(ProgramKind::name))
        .map(move |word| if word == compensated.name() { compensated } else { ProgramKind::Nominal })
}

fn kind_parser() -> impl TypedValueParser<Value = ProfileKind> {
    // The parser before has refused every other word.
    PossibleValuesParser::new(ProfileKind::ALL.map(ProfileKind::word))
        .map(|word| ProfileKind::from_word(&word).unwrap_or(ProfileKind::Machine))
}

pub(super) fn stage_parser() -> impl TypedValueParser<Value = StageName> {
    let by_name = |name: String| StageName::ALL.into_iter().find(|stage| stage.as_str() == name);
    // The parser before has refused every other name.
    PossibleValuesParser::new(StageName::ALL.map(StageName::as_str))
        .map(move |name| by_name(name).unwrap_or(StageName::Wireframe))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pause_names_its_step_and_what_is_to_be_done() {
        let pause = |wire, after| StepPause { wire, after, note: "turn the part: 90°".to_owned() };
        assert_eq!(parse_pause("3:turn the part: 90°"), Ok(pause(0, 3)));
        assert_eq!(parse_pause("2/11:turn the part: 90°"), Ok(pause(1, 11)));
        for wrong in
            ["3", "turn the part", "0:turn", "-1:turn", "0/3:turn", "1/:turn", "3: ", "99999999999:turn"]
        {
            parse_pause(wrong).unwrap_err();
        }
    }
}
