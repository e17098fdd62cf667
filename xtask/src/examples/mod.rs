//! `cargo xtask examples`: the parametric wireframes in `examples/`, as OBJ files in millimetres.
//!
//! `household` holds the things that desktop benders publish as their demonstrations, `probes` the smallest frames
//! that show one difficulty each, `truss` the large regular frames.

mod household;
mod obj;
mod probes;
mod truss;

use crate::committed::CommittedFile;

/// A position in mm, right-handed axes, z up.
type Point = [f64; 3];

/// One wireframe that a newcomer can open.
struct Example {
    /// File name in `examples/`.
    file: String,
    /// Comment lines at the head of the file: what it is, and the parameters.
    about: Vec<String>,
    points: Vec<Point>,
    /// Chains of indices into `points`, from 0; a chain of two is one edge.
    chains: Vec<Vec<usize>>,
}

impl Example {
    /// A single wire from the first point to the last.
    fn wire(file: &str, about: &[&str], points: Vec<Point>) -> Self {
        let chain = (0..points.len()).collect();
        Self::frame(file, about, points, vec![chain])
    }

    fn frame(file: &str, about: &[&str], points: Vec<Point>, chains: Vec<Vec<usize>>) -> Self {
        let about = about.iter().map(ToString::to_string).collect();
        Self { file: file.to_owned(), about, points, chains }
    }
}

/// Every file that the command makes.
pub(crate) fn files() -> Vec<CommittedFile> {
    let mut examples = household::all();
    examples.extend(probes::all());
    examples.extend(truss::all());
    examples
        .iter()
        .map(|example| CommittedFile {
            path: format!("examples/{}", example.file),
            text: obj::render(example),
        })
        .collect()
}

/// What the tests of the shapes measure.
#[cfg(test)]
mod measure {
    use std::collections::BTreeMap;

    use super::{Example, Point};

    pub(super) fn minus(a: Point, b: Point) -> Point {
        [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
    }

    pub(super) fn length(a: Point) -> f64 {
        a.iter().map(|c| c * c).sum::<f64>().sqrt()
    }

    pub(super) fn edges(example: &Example) -> Vec<(usize, usize)> {
        let pairs = example.chains.iter().flat_map(|chain| chain.windows(2));
        pairs.map(|pair| (pair[0].min(pair[1]), pair[0].max(pair[1]))).collect()
    }

    pub(super) fn edge_lengths(example: &Example) -> Vec<f64> {
        edges(example).iter().map(|&(a, b)| length(minus(example.points[a], example.points[b]))).collect()
    }

    pub(super) fn odd_vertices(example: &Example) -> usize {
        let mut degree = BTreeMap::new();
        for (a, b) in edges(example) {
            *degree.entry(a).or_insert(0) += 1;
            *degree.entry(b).or_insert(0) += 1;
        }
        degree.values().filter(|d| *d % 2 == 1).count()
    }

    /// Angle in degrees at each inner vertex of the first chain, 0 where the wire goes straight on.
    pub(super) fn turns(example: &Example) -> Vec<f64> {
        let chain: Vec<Point> = example.chains[0].iter().map(|&i| example.points[i]).collect();
        let turn = |three: &[Point]| {
            let (a, b) = (minus(three[1], three[0]), minus(three[2], three[1]));
            let cosine = (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / (length(a) * length(b));
            cosine.clamp(-1.0, 1.0).acos().to_degrees()
        };
        chain.windows(3).map(turn).collect()
    }

    /// Six times the volume of the tetrahedron of four points: its sign is their handedness.
    pub(super) fn handedness(p: &[Point]) -> f64 {
        let (a, b, c) = (minus(p[1], p[0]), minus(p[2], p[0]), minus(p[3], p[0]));
        a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_example_refers_to_its_own_points_and_uses_no_edge_twice() {
        for example in household::all().into_iter().chain(probes::all()).chain(truss::all()) {
            let mut edges = measure::edges(&example);
            assert!(edges.iter().all(|&(a, b)| a < b && b < example.points.len()), "{}", example.file);
            let count = edges.len();
            edges.sort_unstable();
            edges.dedup();
            assert_eq!(edges.len(), count, "{} has an edge twice", example.file);
        }
    }

    #[test]
    fn file_names_are_unique() {
        let mut names: Vec<String> = files().into_iter().map(|file| file.path).collect();
        names.sort();
        let count = names.len();
        names.dedup();
        assert_eq!(names.len(), count);
    }
}
