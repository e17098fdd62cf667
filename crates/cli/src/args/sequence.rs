//! The arguments of sequences: the order in which struts are built.

use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use wirebend_api::{CostName, FrameSupports, GroupBy, SequenceFormat};

use super::frame::parse_supports;
use super::shared::DesignArgs;

#[derive(Debug, Args)]
pub(crate) struct SequenceArgs {
    #[command(flatten)]
    pub design: DesignArgs,
    /// Machine that builds the struts: the id of a strut builder (framefab-extruder, or your own)
    #[arg(long, short, value_name = "ID")]
    pub machine: String,
    /// What struts are made of, by id (see `wirebend materials`); what the design says, else what the machine's profile names, if absent
    #[arg(long, value_name = "ID")]
    pub material: Option<String>,
    /// What stands on the ground: the supports of the design, or vertices such as 0,4,7; with free nothing does, and nothing can be built
    #[arg(long, value_name = "design|free|V,V...", default_value = "design", value_parser = parse_supports)]
    pub supports: FrameSupports,
    /// How far a joint may be from where it is drawn, in mm; the radius of a strut less the machine's position tolerance if absent
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    pub epsilon: Option<f64>,
    /// Check this sequence in place of a search: a file that this command wrote, or one of FrameFab
    #[arg(long, value_name = "FILE", conflicts_with_all = ["cost", "limit", "seed", "output"])]
    pub check: Option<PathBuf>,
    /// Which order is best: sharing (struts that share a vertex after each other), or paper (the cost of FrameFab, layer by layer)
    #[arg(long, value_name = "COST", default_value = "sharing", value_parser = cost_parser())]
    pub cost: CostName,
    /// Cut the frame into layers, too
    #[arg(long = "layers")]
    pub in_layers: bool,
    /// What is placed at once: edge, or wire (along the walks that the design has chosen for its wires)
    #[arg(long, value_name = "PART", default_value = "edge", value_parser = group_parser())]
    pub group_by: GroupBy,
    /// End the search after so many seconds, 120 by default
    #[arg(long, value_name = "S", allow_negative_numbers = true)]
    pub limit: Option<f64>,
    /// Seed of the search; the same seed finds the same
    #[arg(long, value_name = "SEED", default_value_t = 1)]
    pub seed: u64,
    /// File to write the sequence to
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// What to write: wirebend (JSON that --check reads), framefab, or assembly-instances (elements in the order of building), or vtk (the frame under its own weight with the step of each strut)
    #[arg(long, short = 'f', value_name = "FORMAT", default_value = "wirebend", requires = "output", value_parser = format_parser())]
    pub format: SequenceFormat,
    /// Replace a file that is there
    #[arg(long, requires = "output")]
    pub force: bool,
}

fn cost_parser() -> impl TypedValueParser<Value = CostName> {
    // The parser before has refused every other word.
    PossibleValuesParser::new(["sharing", "paper"])
        .map(|word| if word == "paper" { CostName::Paper } else { CostName::Sharing })
}

fn format_parser() -> impl TypedValueParser<Value = SequenceFormat> {
    // The parser before has refused every other word.
    PossibleValuesParser::new(["wirebend", "framefab", "assembly-instances", "vtk"]).map(|word| {
        match word.as_str() {
            "framefab" => SequenceFormat::Framefab,
            "assembly-instances" => SequenceFormat::AssemblyInstances,
            "vtk" => SequenceFormat::Vtk,
            _ => SequenceFormat::Wirebend,
        }
    })
}

fn group_parser() -> impl TypedValueParser<Value = GroupBy> {
    // The parser before has refused every other word.
    PossibleValuesParser::new(["edge", "wire"])
        .map(|word| if word == "wire" { GroupBy::Wire } else { GroupBy::Edge })
}
