//! Where the wire meets the machine or itself.

use wirebend_core::checks::{Location, Meeting};
use wirebend_core::clearance::{Obstacle, Phase};
use wirebend_core::route::Route;
use wirebend_core::search::{Change, ChangeKind, Help, Helps, MovedVertex};
use wirebend_core::units::{Length, Mm};
use wirebend_core::wireframe::EdgeId;

use super::number::count;

/// The ends of so many wires are named in a sentence.
const WIRES_NAMED: usize = 6;

/// Depths are said in so many millimetres.
const TENTH: f64 = 0.1;

const STOCK: &str = "wire that is still to be bent";

/// "when step 12 is bent to 63.4°".
fn moment(at: &Location, Meeting { phase, fed, bent, head, .. }: &Meeting) -> String {
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

pub(super) fn meets_machine(at: &Location, meeting: &Meeting, body: &str, measured: bool) -> String {
    let estimated = if measured { "" } else { "; its dimensions are estimates" };
    meets(at, meeting, body) + estimated
}

pub(super) fn meets_stock(at: &Location, meeting: &Meeting) -> String {
    meets(at, meeting, STOCK)
}

/// Where it first meets something, how deep it goes in that step, and in how many later steps they meet again.
fn meets(at: &Location, meeting: &Meeting, what: &str) -> String {
    let Meeting { struck, depth, later, .. } = meeting;
    let tenth = Mm(TENTH);
    let (does, again, how) = if !meeting.hits() {
        ("comes near", "comes near it", format!("comes within {:.1} of it", Mm((-depth.mm()).max(TENTH))))
    } else if depth.mm() < TENTH / 2.0 {
        ("hits", "hits it", format!("goes less than {tenth:.1} into it"))
    } else {
        ("hits", "hits it", format!("goes {depth:.1} into it"))
    };
    let then = match later {
        0 => format!(", and {how}"),
        _ => format!(", {how}, and {again} again in {}", count(*later, "later step", "later steps")),
    };
    format!("the wire{} {does} the {what}{}{then}", along(struck), moment(at, meeting))
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

/// What is in the way of a search.
pub(super) fn obstacle(obstacle: Option<Obstacle>, body: Option<&str>, clearance: Length) -> String {
    let what = match (obstacle, body) {
        (None, _) => return "the head cannot turn far enough".to_owned(),
        (Some(Obstacle::Body(_)), Some(body)) => body,
        (Some(_), _) => STOCK,
    };
    // Whether it would be hit, too, the search does not tell apart.
    let digits = if clearance.mm() < 1.0 { 2 } else { 1 };
    let near = || format!("come within {clearance:.digits$} of");
    let would = if clearance > Length::ZERO { near() } else { "hit".to_owned() };
    format!("the wire would {would} the {what}")
}

/// `passed`: how many edges of how many.
pub(super) fn no_clear_program(
    at: &Location,
    searched: &str,
    obstacle: &str,
    passed: Option<(usize, usize)>,
) -> String {
    let found = format!("no program without a collision was found: {searched}");
    let Some((passed, of)) = passed else { return found + &before_the_search(at) };
    let place = at.vertices.first().map(|vertex| format!(" at vertex {vertex}")).unwrap_or_default();
    format!("{found}; the search got as far as edge {passed} of {of}:{place} {obstacle}")
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

/// What was tried, and what of it helps. What a person has ended says nothing of the rest.
pub(super) fn helps(helps: &Helps) -> String {
    let found = helps.found.iter().map(|Help { change, routes }| match change {
        Change::MoreWires => {
            format!("{} hit nothing{}", count(routes.len(), "wire", "wires"), ends(routes))
        }
        Change::Doubled { edges, added } => {
            let names: Vec<String> = edges.iter().map(ToString::to_string).collect();
            let noun = if edges.len() == 1 { "edge" } else { "edges" };
            let names = names.join(", ");
            format!("{noun} {names} run along twice ({added:.1} more) makes a program possible")
        }
        Change::Moved(MovedVertex { vertex, to, by }) => format!(
            "vertex {vertex} moved by {by:.0} to ({:.1}, {:.1}, {:.1}) makes a program possible",
            to.x, to.y, to.z
        ),
    });
    let helps_not = |kind: &&ChangeKind| helps.found.iter().all(|help| help.change.kind() != **kind);
    let in_vain = helps.tried.iter().filter(helps_not).map(|kind| {
        let what = match kind {
            ChangeKind::MoreWires => "more wires",
            ChangeKind::Doubled => "one more edge run along twice",
            ChangeKind::Moved => "a vertex near there moved",
        };
        format!("nothing was found with {what}")
    });
    let tried: Vec<String> = found.chain(in_vain).collect();
    let ended = match (helps.ended, helps.tried.is_empty()) {
        (false, _) => "",
        (true, true) => "; no change that could help was tried",
        (true, false) => "; other changes were not tried to the end",
    };
    let tried = if tried.is_empty() { String::new() } else { format!("; tried: {}", tried.join("; ")) };
    tried + ended
}

/// Where wires begin and end: ": from vertex 0 to 4, from 4 to 7".
fn ends(routes: &[Route]) -> String {
    let ends = |route: &Route| {
        let (first, last) = (route.traversals.first()?, route.traversals.last()?);
        Some(format!("from vertex {} to vertex {}", first.from, last.to))
    };
    let all: Vec<String> = routes.iter().filter_map(ends).collect();
    let more = all.len().saturating_sub(WIRES_NAMED);
    let rest = if more == 0 { String::new() } else { format!(", and {more} more") };
    format!(", {}{rest}", all[..all.len() - more].join(", "))
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
