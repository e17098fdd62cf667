//! The arguments of frames: what they carry, and how accurate they are.

use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use wirebend_api::{ClosingName, ContinuumChoice, FrameSupports, RequirementsChoice, VaryName};

use super::shared::{ChoiceArgs, DesignArgs, ReadArgs};

#[derive(Debug, Args)]
pub(crate) struct FrameArgs {
    #[command(flatten)]
    pub design: DesignArgs,
    #[command(flatten)]
    pub choices: ChoiceArgs,
    /// What holds the frame: the supports of the design, nothing (free), or vertices such as 0,4,7
    #[arg(long, value_name = "design|free|V,V...", default_value = "design", value_parser = parse_supports)]
    pub supports: FrameSupports,
    /// Gravity along x, y and z, as multiples of standard gravity; 0,0,-1 if absent and without --loads
    #[arg(long, value_name = "X,Y,Z", value_parser = parse_gravity, allow_hyphen_values = true)]
    pub gravity: Option<Gravity>,
    /// Loads besides: load cases as conmech writes them; gravity acts then only if they or --gravity say so
    #[arg(long, value_name = "FILE")]
    pub loads: Option<PathBuf>,
    /// Load case, where the file has several
    #[arg(long, value_name = "NAME", requires = "loads")]
    pub load_case: Option<String>,
    /// Write displacements and forces as VTK, for ParaView
    #[arg(long, value_name = "FILE")]
    pub vtk: Option<PathBuf>,
    /// Write displacements and forces as tables, NAME-nodes.csv and NAME-members.csv for NAME.csv
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,
    /// Write the frame as it is computed, and what acts on it, for conmech: NAME.json and NAME-loads.json
    #[arg(long, value_name = "FILE")]
    pub conmech: Option<PathBuf>,
    /// Write the deformed shape as a model, binary glTF
    #[arg(long, value_name = "FILE")]
    pub glb: Option<PathBuf>,
    /// Enlarge the displacements of the model by this factor; 1 is true scale
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, requires = "glb", allow_hyphen_values = true)]
    pub displacement_scale: f64,
    /// Replace files that are there
    #[arg(long)]
    pub force: bool,
    /// Find so many modes of vibration, rigid ones aside
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub modes: u32,
    /// Pieces that a strut is cut into to vibrate
    #[arg(long, value_name = "N", default_value_t = 4, requires = "modes")]
    pub pieces: u32,
    /// Find the modes also where every strut bows by this share of its length, in a random direction; an arc is cut into 9 pieces at least
    #[arg(long, value_name = "SHARE", requires = "modes", value_parser = parse_share, allow_hyphen_values = true)]
    pub bow: Option<f64>,
    /// Close the joints of the wires that the machine bends, with its errors, and say how accurate the frame is
    #[arg(long, requires = "errors")]
    pub close: bool,
    /// Errors of the machine: the id of a noise profile (none, wirebend-kit, bend-forming, or your own)
    #[arg(long, value_name = "PROFILE", requires = "close")]
    pub errors: Option<String>,
    #[command(flatten)]
    pub closing: ClosingArgs,
    /// How many wires to draw
    #[arg(long, value_name = "N", default_value_t = 100, requires = "close", value_parser = clap::value_parser!(u32).range(1..))]
    pub runs: u32,
    /// Where the random numbers start; the same seed draws the same wires and the same bows [default: 1]
    #[arg(long, value_name = "S")]
    pub seed: Option<u64>,
    /// Write the first wire that is drawn, once its joints are closed, as VTK
    #[arg(long, value_name = "FILE", requires = "close")]
    pub closed_vtk: Option<PathBuf>,
    /// Draw no wires: the exact expectation over all, for errors that bow no strut
    #[arg(long, requires = "close", conflicts_with_all = ["runs", "closed_vtk"])]
    pub expected: bool,
}

/// How joints are closed, and what is measured.
#[derive(Debug, Args)]
pub(crate) struct ClosingArgs {
    /// How joints are closed: aligned (each pass turns freely until all are locked; unless said otherwise), or coupled (rigid from the start)
    #[arg(long, value_name = "MODEL", value_parser = closing_parser())]
    pub closing: Option<ClosingName>,
    /// Faces that are to be flat: a JSON list of lists of vertices; without them all vertices count
    #[arg(long, value_name = "FILE")]
    pub faces: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct ToleranceArgs {
    /// Wireframe: a .wirebend document or any file that can be imported, or - for standard input
    #[arg(value_name = "WIREFRAME", required_unless_present = "continuum", conflicts_with = "continuum")]
    pub file: Option<PathBuf>,
    #[command(flatten)]
    pub read: ReadArgs,
    #[command(flatten)]
    pub choices: ChoiceArgs,
    /// What is required, as surface=1mm,force=5N,stress=100MPa: RMS of the distances from flat faces, of forces along struts, and of von Mises stresses
    #[arg(long = "require", value_name = "LIMITS", value_parser = parse_requirements)]
    pub required: RequirementsChoice,
    /// Motions that are off: feed, angle (bends and rotations), or both
    #[arg(long, value_name = "MOTIONS", default_value = "feed", value_parser = vary_parser())]
    pub vary: VaryName,
    /// With --vary both, the share of each required square that is for feeds
    #[arg(long, value_name = "SHARE", default_value_t = 0.5)]
    pub feed_share: f64,
    #[command(flatten)]
    pub closing: ClosingArgs,
    /// In place of a wireframe a tetrahedral truss of many rings, by closed formulas: rings, depth and diameter in mm
    #[arg(long, value_name = "N,DEPTH,DIAMETER", value_parser = parse_continuum)]
    pub continuum: Option<ContinuumChoice>,
    /// How far the struts of such a truss bow, as a share of their length: its first frequency falls
    #[arg(
        long,
        value_name = "SHARE",
        requires = "continuum",
        default_value_t = 0.0,
        allow_hyphen_values = true
    )]
    pub bow: f64,
}

/// Along x, y and z.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Gravity(pub [f64; 3]);

pub(super) fn parse_supports(text: &str) -> Result<FrameSupports, String> {
    match text {
        "design" => Ok(FrameSupports::Design),
        "free" => Ok(FrameSupports::Free),
        list => {
            let ids: Result<Vec<u32>, _> = list.split(',').map(|id| id.trim().parse()).collect();
            let words = "expected design, free, or the ids of vertices such as 0,4,7";
            ids.map(FrameSupports::Vertices).map_err(|_| words.to_owned())
        }
    }
}

fn parse_gravity(text: &str) -> Result<Gravity, String> {
    let words = "expected three numbers such as 0,0,-1";
    numbers(text).map(Gravity).ok_or_else(|| words.to_owned())
}

fn parse_continuum(text: &str) -> Result<ContinuumChoice, String> {
    let words = "expected a number of rings, a depth and a diameter in mm, such as 10,50,1200";
    let wrong = || words.to_owned();
    let (rings, rest) = text.split_once(',').ok_or_else(wrong)?;
    let (depth, diameter) = rest.split_once(',').ok_or_else(wrong)?;
    let number = |text: &str| text.trim().parse::<f64>().map_err(|_| wrong());
    Ok(ContinuumChoice {
        rings: rings.trim().parse().map_err(|_| wrong())?,
        depth_mm: number(depth)?,
        diameter_mm: number(diameter)?,
        bow: 0.0,
    })
}

/// `0.03`, or `3%`.
fn parse_share(text: &str) -> Result<f64, String> {
    let (number, whole) = text.strip_suffix('%').map_or((text, 1.0), |percent| (percent, 100.0));
    let number: Result<f64, _> = number.trim().parse();
    number.map(|number| number / whole).map_err(|_| "expected a share such as 0.03 or 3%".to_owned())
}

fn numbers(text: &str) -> Option<[f64; 3]> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    numbers?.try_into().ok()
}

/// `surface=1mm,force=5N,stress=100MPa`; units may be left out.
fn parse_requirements(text: &str) -> Result<RequirementsChoice, String> {
    let mut required = RequirementsChoice::default();
    for part in text.split(',') {
        let (name, value) =
            part.split_once('=').ok_or_else(|| format!("'{part}' has no limit; {REQUIREMENTS}"))?;
        let (limit, unit) = match name.trim() {
            "surface" => (&mut required.surface_mm, "mm"),
            "force" => (&mut required.force_n, "N"),
            "stress" => (&mut required.stress_mpa, "MPa"),
            name => return Err(format!("'{name}' cannot be required; {REQUIREMENTS}")),
        };
        let number = value.trim().strip_suffix(unit).unwrap_or(value.trim()).trim();
        let number: f64 =
            number.parse().map_err(|_| format!("'{value}' is no number of {unit}; {REQUIREMENTS}"))?;
        if limit.replace(number).is_some() {
            return Err(format!("'{}' is given twice; {REQUIREMENTS}", name.trim()));
        }
    }
    Ok(required)
}

const REQUIREMENTS: &str =
    "expected limits for some of surface, force and stress, such as surface=1mm,force=5N,stress=100MPa";

fn closing_parser() -> impl TypedValueParser<Value = ClosingName> {
    // The parser before has refused every other word.
    PossibleValuesParser::new(["aligned", "coupled"])
        .map(|word| if word == "coupled" { ClosingName::Coupled } else { ClosingName::Aligned })
}

fn vary_parser() -> impl TypedValueParser<Value = VaryName> {
    // The parser before has refused every other word.
    PossibleValuesParser::new(["feed", "angle", "both"]).map(|word| match word.as_str() {
        "angle" => VaryName::Angle,
        "both" => VaryName::Both,
        _ => VaryName::Feed,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn requirements_are_read_with_and_without_units() {
        let required = parse_requirements("surface=1mm, force=5").unwrap();
        assert_eq!(
            (required.surface_mm, required.force_n, required.stress_mpa),
            (Some(1.0), Some(5.0), None)
        );
        for wrong in ["", "surface", "weight=3", "force=5mm", "force=1N,force=2N"] {
            assert!(parse_requirements(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn shares_are_numbers_or_percent() {
        assert_eq!(parse_share("0.03"), Ok(0.03));
        assert_eq!(parse_share("3%"), Ok(0.03));
        for wrong in ["", "%", "x", "3 mm"] {
            assert!(parse_share(wrong).is_err_and(|words| words.contains("0.03 or 3%")), "{wrong}");
        }
    }

    #[test]
    fn supports_are_words_or_vertices() {
        assert_eq!(parse_supports("free"), Ok(FrameSupports::Free));
        assert_eq!(parse_supports("0, 4"), Ok(FrameSupports::Vertices(vec![0, 4])));
        assert!(parse_supports("0;4").is_err() && parse_supports("").is_err());
    }
}
