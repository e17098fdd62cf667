//! What a wire's errors are to the struts of the frame that it becomes: each is a little too long, or starts at a wrong angle.
//!
//! Errors are those of single motions, and not the places that they add up to: these are tens of millimetres off, which no linear
//! computation can follow.

use std::ops::Range;

use nalgebra::Vector3;
use wirebend_core::bend::{Frame, NominalProgram};
use wirebend_core::compensate::is_turn;
use wirebend_core::simulate::ErrorSource;

/// A wire on the vertices of a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct FrameWire {
    /// The vertices that it passes, by their place among the frame's; one more than it has struts.
    pub vertices: Vec<usize>,
    /// The frame in which its program begins.
    pub start: Frame,
    /// Its program with the signs of its bends as they are made, since only a rotation that is made is off; the spans of its steps are
    /// the struts between these vertices.
    pub program: NominalProgram,
}

/// What one unit of an error, mm or radian, does to a strut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct StrutMisfit {
    /// Which strut, counted along all wires.
    pub strut: usize,
    /// How much longer it is, mm.
    pub extra_length: f64,
    /// How its ends are turned against the wire at its vertices, as small rotation vectors.
    pub turned: [Vector3<f64>; 2],
}

/// A motion of the machine that is off, or more than one strut by the same.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct MisfitSource {
    /// What is off.
    pub of: ErrorSource,
    /// The wire and the step of its program.
    pub wire: usize,
    pub step: usize,
    /// To which side its constant part is: 1, or -1 where a bend to the other side gets larger.
    pub side: f64,
    /// What one mm or one radian of it does.
    pub changes: Vec<StrutMisfit>,
}

/// Everything that can be off while the wires are made, with struts counted from `first` on. `lengths` are those of the struts, mm.
pub(super) fn sources(wire: &FrameWire, index: usize, first: usize, lengths: &[f64]) -> Vec<MisfitSource> {
    let mut frame = wire.start;
    let mut found = Vec::new();
    let mut has_bent = false;
    let program = &wire.program;
    for (step, (made, span)) in program.steps.iter().zip(&program.spans).enumerate() {
        let mut add = |of, side, changes| found.push(MisfitSource { of, wire: index, step, side, changes });
        add(ErrorSource::Feed, 1.0, fed(span, first, lengths));
        let along = frame.t();
        frame.rotate(made.rotate);
        // Before its first bend the head turns the wire as a whole.
        if is_turn(made.rotate) && is_turn(made.bend) && has_bent && span.end > 0 {
            // The head turns the part beyond against the strut that was just fed: that is twisted.
            let turned = [Vector3::zeros(), -along];
            let strut = first + span.end - 1;
            add(ErrorSource::Rotation, 1.0, vec![StrutMisfit { strut, extra_length: 0.0, turned }]);
        }
        if is_turn(made.bend) && span.end < lengths.len() {
            let turned = [frame.b(), Vector3::zeros()];
            let strut = first + span.end;
            add(
                ErrorSource::Bend,
                made.bend.signum(),
                vec![StrutMisfit { strut, extra_length: 0.0, turned }],
            );
        }
        has_bent |= is_turn(made.bend);
        frame.bend(made.bend);
    }
    found
}

/// A feed that is too long makes each strut of it longer by its share.
fn fed(span: &Range<usize>, first: usize, lengths: &[f64]) -> Vec<StrutMisfit> {
    let of = lengths.get(span.clone()).unwrap_or_default();
    let whole: f64 = of.iter().sum();
    let strut = |(k, length): (usize, &f64)| StrutMisfit {
        strut: first + span.start + k,
        extra_length: length / whole,
        turned: [Vector3::zeros(); 2],
    };
    of.iter().enumerate().map(strut).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::deg;
    use nalgebra::Point3;
    use wirebend_core::bend::{Step, program_of_path};

    fn wire(points: &[[f64; 3]]) -> (FrameWire, Vec<f64>) {
        let path: Vec<Point3<f64>> = points.iter().map(|&p| p.into()).collect();
        let (start, program) = program_of_path(&path, deg(0.0)).unwrap();
        let lengths = path.windows(2).map(|pair| (pair[1] - pair[0]).norm()).collect();
        (FrameWire { vertices: (0..path.len()).collect(), start, program }, lengths)
    }

    #[test]
    fn only_motions_that_are_made_are_off() {
        use ErrorSource::{Bend, Feed, Rotation};
        // Straight over the second vertex, then a bend in the plane, then one out of it.
        let (wire, lengths) = wire(&[
            [0.0, 0.0, 0.0],
            [10.0, 0.0, 0.0],
            [30.0, 0.0, 0.0],
            [30.0, 10.0, 0.0],
            [30.0, 10.0, 10.0],
        ]);
        let of: Vec<(ErrorSource, usize)> =
            sources(&wire, 0, 0, &lengths).iter().map(|source| (source.of, source.step)).collect();
        assert_eq!(of, [(Feed, 0), (Bend, 0), (Feed, 1), (Rotation, 1), (Bend, 1), (Feed, 2)]);
    }

    /// What is always off makes each bend larger, and the head's way to the first bend turns the wire as a whole.
    #[test]
    fn a_bend_to_the_other_side_is_off_to_that_side() {
        use ErrorSource::{Bend, Feed, Rotation};
        let (mut wire, lengths) =
            wire(&[[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [10.0, 10.0, 0.0], [20.0, 10.0, 0.0]]);
        let turned = |step: &mut Step, rotate: f64| (step.rotate, step.bend) = (deg(rotate), -step.bend);
        turned(&mut wire.program.steps[0], 30.0);
        turned(&mut wire.program.steps[1], -10.0);
        let sides: Vec<(ErrorSource, usize, f64)> = sources(&wire, 0, 0, &lengths)
            .iter()
            .map(|source| (source.of, source.step, source.side))
            .collect();
        let expected = [
            (Feed, 0, 1.0),
            (Bend, 0, -1.0),
            (Feed, 1, 1.0),
            (Rotation, 1, 1.0),
            (Bend, 1, -1.0),
            (Feed, 2, 1.0),
        ];
        assert_eq!(sides, expected);
    }

    #[test]
    fn a_feed_over_two_struts_is_shared_by_their_lengths() {
        let (wire, lengths) = wire(&[[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [40.0, 0.0, 0.0], [40.0, 10.0, 0.0]]);
        let feed = &sources(&wire, 0, 5, &lengths)[0];
        let shares: Vec<(usize, f64)> =
            feed.changes.iter().map(|change| (change.strut, change.extra_length)).collect();
        assert_eq!(shares, [(5, 0.25), (6, 0.75)]);
    }

    #[test]
    fn a_bend_turns_the_strut_after_it_and_a_rotation_twists_the_one_before() {
        let (wire, lengths) =
            wire(&[[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [10.0, 10.0, 0.0], [10.0, 10.0, 10.0]]);
        let all = sources(&wire, 0, 0, &lengths);
        let of = |of| all.iter().filter(move |source| source.of == of).flat_map(|source| &source.changes);
        let bends: Vec<_> = of(ErrorSource::Bend).collect();
        assert!((bends[0].turned[0] - Vector3::z()).norm() < 1e-12 && bends[0].strut == 1);
        assert!((bends[1].turned[0] - Vector3::x()).norm() < 1e-12 && bends[1].strut == 2);
        let twist = of(ErrorSource::Rotation).next().unwrap();
        assert!((twist.turned[1] + Vector3::y()).norm() < 1e-12 && twist.strut == 1);
    }
}
