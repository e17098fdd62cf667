//! Where the wire meets the machine or itself.

use wirebend_core::checks::Location;
use wirebend_core::clearance::{Obstacle, Phase};
use wirebend_core::search::{Helps, MovedVertex};
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::EdgeId;

use super::number::count;

/// "when step 12 is bent to 63.4°".
pub(super) fn moment(at: &Location, phase: Phase, fed: Length, bent: Angle, head: Angle) -> String {
    let what = match phase {
        Phase::Feed => format!("has fed {fed:.1}"),
        Phase::Rotate => format!("has the head at {head:.1}"),
        Phase::Approach => "brings the peg to its side".to_owned(),
        Phase::PegOut => "puts the peg out".to_owned(),
        Phase::Bend => format!("has bent it to {bent:.1}"),
        Phase::Release => "takes the bend axis back".to_owned(),
        Phase::PegIn => "takes the peg in".to_owned(),
        Phase::Return => "returns the bend axis to zero".to_owned(),
    };
    at.step.map(|step| format!(" when step {} {what}", step + 1)).unwrap_or_default()
}

/// `deep`: how deep, less than zero where it only comes near, and in how many later steps again.
pub(super) fn meets_machine(
    moment: &str,
    struck: &[EdgeId],
    body: &str,
    deep: (Length, usize),
    measured: bool,
) -> String {
    let estimated = if measured { "" } else { "; its dimensions are estimates" };
    format!("{} the {body}{moment}{}{estimated}", goes_into(struck, deep.0), again(deep.1))
}

pub(super) fn meets_stock(moment: &str, struck: &[EdgeId], deep: (Length, usize)) -> String {
    format!("{} the wire that is still to be bent{moment}{}", goes_into(struck, deep.0), again(deep.1))
}

/// How much was searched.
pub(super) fn searched(checks: u64, exhausted: bool) -> String {
    if exhausted {
        "every walk of one wire was tried".to_owned()
    } else if checks == 0 {
        "it was not searched".to_owned()
    } else {
        format!("{checks} steps were checked")
    }
}

/// `passed`: how many edges of how many.
pub(super) fn no_clear_program(
    at: &Location,
    searched: &str,
    obstacle: Option<Obstacle>,
    body: Option<&str>,
    passed: Option<(usize, usize)>,
) -> String {
    let found = format!("no program without a collision was found: {searched}");
    let Some((passed, of)) = passed else { return found + &before_the_search(at) };
    let what = match (obstacle, body) {
        (Some(Obstacle::Body(_)), Some(body)) => format!("the wire would hit the {body}"),
        (Some(_), _) => "the wire would hit the wire that is still to be bent".to_owned(),
        (None, _) => "the head cannot turn far enough".to_owned(),
    };
    let place = at.vertices.first().map(|vertex| format!(" at vertex {vertex}")).unwrap_or_default();
    format!("{found}; the search got as far as edge {passed} of {of}:{place} {what}")
}

/// Bends that no route avoids, which come before a search.
fn before_the_search(at: &Location) -> String {
    let names: Vec<String> = at.vertices.iter().map(ToString::to_string).collect();
    match &names[..] {
        [] => String::new(),
        [one] => format!("; the bend at vertex {one} comes first"),
        several => format!("; the bends at vertices {} come first", several.join(", ")),
    }
}

/// What was tried and helps.
pub(super) fn helps(Helps { wires, moved }: Helps) -> String {
    let wires = wires.map(|wires| format!("{} hit nothing", count(wires, "wire", "wires")));
    let moved = moved.map(|MovedVertex { vertex, to, by }| {
        format!(
            "vertex {vertex} moved by {by:.0} to ({:.1}, {:.1}, {:.1}) makes a program possible",
            to.x, to.y, to.z
        )
    });
    let tried: Vec<String> = wires.into_iter().chain(moved).collect();
    if tried.is_empty() { String::new() } else { format!("; tried: {}", tried.join("; ")) }
}

fn goes_into(struck: &[EdgeId], depth: Length) -> String {
    if depth < Length::ZERO {
        return format!("the wire{} comes within {:.1} of", along(struck), -depth);
    }
    format!("the wire{} goes {depth:.1} into", along(struck))
}

fn again(later: usize) -> String {
    if later == 0 { String::new() } else { format!(", and in {}", count(later, "later step", "later steps")) }
}

/// " of edge 3", or " of edges 3, 4" where a straight part has several.
fn along(edges: &[EdgeId]) -> String {
    let names: Vec<String> = edges.iter().map(ToString::to_string).collect();
    let noun = match edges.len() {
        0 => return String::new(),
        1 => "edge",
        _ => "edges",
    };
    format!(" of {noun} {}", names.join(", "))
}
