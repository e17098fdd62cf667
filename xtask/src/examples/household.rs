//! The kinds of things that the published $293 bender shows (Faruqi et al., SCF '25): cube, house, cup holder, phone
//! stand, spring, and the sample on which its feed compensation was measured.
//!
//! The total lengths are the published ones; except for the cube and the U the coordinates are our own designs, because
//! the originals are not published. Every bend is within the ±155° and every edge above the 20.4 mm of that machine.

use std::f64::consts::TAU;

use super::{Example, Point};

pub(super) fn all() -> Vec<Example> {
    vec![cube(), cube_of_eight_edges(), house(), cup_holder(), phone_stand(), u_sample(), spring()]
}

/// Corner of a cube: bit 0, 1, 2 of the index is x, y, z.
fn cube_corners(side_mm: f64) -> Vec<Point> {
    let along = |index: usize, bit: usize| if index >> bit & 1 == 1 { side_mm } else { 0.0 };
    (0..8).map(|index| [along(index, 0), along(index, 1), along(index, 2)]).collect()
}

fn cube() -> Example {
    let edges = (0..8_usize)
        .flat_map(|a| (0..3).map(move |bit| vec![a, a | 1 << bit]).filter(|edge| edge[0] != edge[1]));
    Example::frame(
        "cube.obj",
        &["Cube: 12 edges of 30 mm. All 8 corners are odd, so one wire needs doubled edges."],
        cube_corners(30.0),
        edges.collect(),
    )
}

fn cube_of_eight_edges() -> Example {
    // Visits all corners and ends beside an earlier one: odd only at its two ends.
    let way = vec![0, 1, 3, 2, 6, 7, 5, 4, 6];
    Example::frame(
        "cube-8-edges.obj",
        &[
            "Cube of one open wire: 8 edges of 30 mm, 7 bends of 90 degrees.",
            "The published demonstration of the $293 bender has these numbers (241 mm); which 8 edges is our choice.",
        ],
        cube_corners(30.0),
        vec![way],
    )
}

fn house() -> Example {
    let (width, wall, slope) = (70.0_f64, 60.0, 51.0_f64);
    let rise = (slope * slope - width * width / 4.0).sqrt();
    let (half, ridge) = (width / 2.0, wall + rise);
    let points = vec![
        [0.0, 0.0, 0.0],
        [half, 0.0, 0.0],
        [half, 0.0, wall],
        [0.0, 0.0, ridge],
        [-half, 0.0, wall],
        [-half, 0.0, 0.0],
    ];
    Example::frame(
        "house.obj",
        &[
            "Gable house, planar and closed: floor 70 mm, walls 60 mm, roof 51 mm a side; 292 mm of wire.",
            "The ends meet in the middle of the floor, so that every corner is a bend. Our design of the published kind.",
        ],
        points,
        vec![vec![0, 1, 2, 3, 4, 5, 0]],
    )
}

fn cup_holder() -> Example {
    let (sides, side, upright, hook_out, hook_down) = (8_u32, 30.0, 150.0, 30.0, 49.0);
    let radius = side / (2.0 * (TAU / f64::from(sides) / 2.0).sin());
    let corner = |i: u32| TAU * f64::from(i) / f64::from(sides);
    let mut points: Vec<Point> =
        (0..sides).map(|i| [radius * corner(i).cos(), radius * corner(i).sin(), 0.0]).collect();
    points.push([radius, 0.0, upright]);
    points.push([radius + hook_out, 0.0, upright]);
    points.push([radius + hook_out, 0.0, upright - hook_down]);
    let way = vec![0, 1, 2, 3, 4, 5, 6, 7, 0, 8, 9, 10];
    Example::frame(
        "cup-holder.obj",
        &[
            "Cup holder that hangs over the edge of a board: ring of 8 sides of 30 mm, upright 150 mm,",
            "hook 30 mm out and 49 mm down; 469 mm of wire. Our design of the published kind.",
        ],
        points,
        vec![way],
    )
}

fn phone_stand() -> Example {
    let (width, lip, depth, back) = (60.0, 30.0, 55.0, 66.0);
    let lean = 70.0_f64.to_radians();
    let (top_y, top_z) = (depth - back * lean.cos(), back * lean.sin());
    Example::wire(
        "phone-stand.obj",
        &[
            "Phone stand: lips 30 mm, rails 55 mm, back 66 mm leaning forward by 20 degrees, 60 mm wide; 362 mm of wire.",
            "Our design of the published kind.",
        ],
        vec![
            [0.0, 0.0, lip],
            [0.0, 0.0, 0.0],
            [0.0, depth, 0.0],
            [0.0, top_y, top_z],
            [width, top_y, top_z],
            [width, depth, 0.0],
            [width, 0.0, 0.0],
            [width, 0.0, lip],
        ],
    )
}

fn u_sample() -> Example {
    Example::wire(
        "u-sample.obj",
        &["U: three sides of 35 mm, two bends of 90 degrees. The published sample for feed compensation."],
        vec![[0.0, 35.0, 0.0], [0.0, 0.0, 0.0], [35.0, 0.0, 0.0], [35.0, 35.0, 0.0]],
    )
}

fn spring() -> Example {
    let (segments, per_turn, total, pitch) = (21_u32, 6_u32, 641.0, 24.0);
    let segment = total / f64::from(segments);
    let rise = pitch / f64::from(per_turn);
    let step = TAU / f64::from(per_turn);
    let radius = (segment * segment - rise * rise).sqrt() / (2.0 * (step / 2.0).sin());
    let point = |i: u32| {
        let turned = step * f64::from(i);
        [radius * turned.cos(), radius * turned.sin(), rise * f64::from(i)]
    };
    Example::wire(
        "spring.obj",
        &[
            "Spring: right-handed helix of 21 equal segments, 6 a turn, pitch 24 mm; 641 mm of wire.",
            "Our design of the published kind.",
        ],
        (0..=segments).map(point).collect(),
    )
}

#[cfg(test)]
mod tests {
    use super::super::measure::{edge_lengths, odd_vertices, turns};
    use super::*;

    /// Length in mm and bends of the published jobs; the cube's 241 mm are 8 × 30 mm and a rest of the wire.
    #[test]
    fn wires_have_the_published_lengths() {
        let cases = [
            (cube_of_eight_edges(), 240.0, 7),
            (house(), 292.0, 5),
            (cup_holder(), 469.0, 10),
            (phone_stand(), 362.0, 6),
            (u_sample(), 105.0, 2),
            (spring(), 641.0, 20),
        ];
        for (example, total_mm, bends) in cases {
            let length: f64 = edge_lengths(&example).iter().sum();
            assert!((length - total_mm).abs() < 1e-9, "{} is {length} mm long", example.file);
            assert_eq!(turns(&example).len(), bends, "{}", example.file);
        }
    }

    #[test]
    fn wires_can_be_bent_on_the_published_machine_without_doubling() {
        for example in all().into_iter().filter(|example| example.file != "cube.obj") {
            assert!(odd_vertices(&example) <= 2, "{} is not one wire", example.file);
            assert!(edge_lengths(&example).iter().all(|&mm| mm > 30.0 - 1e-9), "{}", example.file);
            assert!(turns(&example).iter().all(|&deg| deg > 1.0 && deg < 155.0), "{}", example.file);
        }
    }

    #[test]
    fn cube_bends_are_right_angles() {
        assert!(turns(&cube_of_eight_edges()).iter().all(|deg| (deg - 90.0).abs() < 1e-9));
        assert_eq!(edge_lengths(&cube()), vec![30.0; 12]);
        assert_eq!(odd_vertices(&cube()), 8);
    }
}
