//! An example as the text of a Wavefront OBJ file: comments, `v` lines, `l` lines with indices from 1.

use wirebend_files::number::short;

use super::{Example, Point};

/// The whole file; coordinates in mm with six decimals, zeros at their end left away.
pub(super) fn render(example: &Example) -> String {
    let comments = example.about.iter().map(|line| format!("# {line}"));
    let origin = "# Millimetres. Made by `cargo xtask examples`: change the parameters there, not this file."
        .to_owned();
    let points = example.points.iter().map(|&point| vertex_line(point));
    let chains = example.chains.iter().map(|chain| {
        let indices: Vec<String> = chain.iter().map(|index| (index + 1).to_string()).collect();
        format!("l {}", indices.join(" "))
    });
    let lines: Vec<String> = comments.chain([origin]).chain(points).chain(chains).collect();
    lines.join("\n") + "\n"
}

fn vertex_line(point: Point) -> String {
    let [x, y, z] = point.map(|coordinate_mm| short(coordinate_mm, 6));
    format!("v {x} {y} {z}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_start_at_one_and_numbers_are_short() {
        let example =
            Example::wire("x.obj", &["A wire."], vec![[0.0, -0.0, -1e-9], [30.0, 0.5, 61.237_243_6]]);
        let text = render(&example);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[0], "# A wire.");
        assert_eq!(&lines[2..], ["v 0 0 0", "v 30 0.5 61.237244", "l 1 2"]);
    }
}
