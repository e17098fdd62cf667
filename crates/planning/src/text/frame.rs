//! The frame as a structure: what holds it, and what its struts carry.

use wirebend_core::checks::Location;
use wirebend_core::units::Length;

use super::number::{count, digits_apart};

pub(super) fn unsupported(at: &Location, edges: usize, whole: bool) -> String {
    let edges = count(edges, "edge", "edges");
    match at.vertices.first() {
        Some(vertex) if !whole => format!("nothing holds the part of {edges} at vertex {vertex}"),
        _ => "nothing holds the frame: no vertex is a support".to_owned(),
    }
}

pub(super) fn mechanism(at: &Location) -> String {
    let place =
        at.vertices.first().map(|vertex| format!(": vertex {vertex} can move or turn")).unwrap_or_default();
    format!("the frame does not stand{place}, and nothing resists it")
}

pub(super) fn hardly_stands(at: &Location, displacement: Length, size: Length) -> String {
    let vertex = at.vertices.first().map_or_else(|| "a vertex".to_owned(), |id| format!("vertex {id}"));
    format!(
        "the frame hardly stands: {vertex} would move by {displacement:.1}, and all of it is {size:.1} large"
    )
}

pub(super) fn overstressed(at: &Location, stress_mpa: f64, yield_mpa: f64) -> String {
    let digits = digits_apart(stress_mpa, yield_mpa, 1);
    format!(
        "{} yields: {stress_mpa:.digits$} MPa, and it bears {yield_mpa:.digits$} MPa{}",
        strut(at),
        others(at, "yield")
    )
}

pub(super) fn near_buckling(at: &Location, ratio: f64) -> String {
    let percent = 100.0 * ratio;
    let others = others(at, "are near buckling");
    if ratio >= 1.0 {
        return format!("{} buckles: its compression is {percent:.0} % of its Euler load{others}", strut(at));
    }
    let linear = "from 50 % on displacements are larger than computed";
    format!(
        "{} is near buckling: its compression is {percent:.0} % of its Euler load, and {linear}{others}",
        strut(at)
    )
}

fn strut(at: &Location) -> String {
    at.edges.first().map_or_else(|| "a strut".to_owned(), |edge| format!("edge {edge}"))
}

/// "; 3 more yield".
fn others(at: &Location, words: &str) -> String {
    match at.edges.len().saturating_sub(1) {
        0 => String::new(),
        1 => format!("; 1 more {}", if words == "yield" { "yields" } else { "is near buckling" }),
        more => format!("; {more} more {words}"),
    }
}

#[cfg(test)]
mod tests {
    use wirebend_core::wireframe::{EdgeId, VertexId};

    use super::*;

    fn edges(ids: &[u32]) -> Location {
        Location::at_edges(ids.iter().copied().map(EdgeId))
    }

    #[test]
    fn a_frame_that_nothing_holds_is_named_with_its_place() {
        let at = Location::at_vertices([VertexId(4)]);
        assert_eq!(unsupported(&at, 6, true), "nothing holds the frame: no vertex is a support");
        assert_eq!(unsupported(&at, 6, false), "nothing holds the part of 6 edges at vertex 4");
        assert_eq!(
            mechanism(&at),
            "the frame does not stand: vertex 4 can move or turn, and nothing resists it"
        );
        let [moved, size] = [48_812.0, 2000.0].map(|mm| Length::from_mm(mm).unwrap());
        assert_eq!(
            hardly_stands(&at, moved, size),
            "the frame hardly stands: vertex 4 would move by 48812.0 mm, and all of it is 2000.0 mm large"
        );
    }

    #[test]
    fn struts_that_do_not_hold_are_named_worst_first() {
        let one = "edge 7 yields: 202.5 MPa, and it bears 40.0 MPa";
        assert_eq!(overstressed(&edges(&[7]), 202.46, 40.0), one);
        assert_eq!(overstressed(&edges(&[7, 3]), 202.46, 40.0), format!("{one}; 1 more yields"));
        assert_eq!(overstressed(&edges(&[7, 3, 5]), 202.46, 40.0), format!("{one}; 2 more yield"));
        assert_eq!(
            near_buckling(&edges(&[2, 3]), 0.634),
            "edge 2 is near buckling: its compression is 63 % of its Euler load, and from 50 % on displacements are \
             larger than computed; 1 more is near buckling"
        );
        assert_eq!(
            near_buckling(&edges(&[2]), 1.2),
            "edge 2 buckles: its compression is 120 % of its Euler load"
        );
    }
}
