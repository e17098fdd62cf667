//! The intervals that are stated hold what they say they do.

use super::*;

/// 500 machines that are off by as much as was assumed: of each stated interval 92 to 98 % contain the truth.
#[test]
fn stated_intervals_contain_the_truth_as_often_as_they_say() {
    let mut random = Normals::new(95);
    let assumed = published();
    let names = [
        Parameter::OrbitRadius,
        Parameter::OrbitOffset,
        Parameter::BendRadius,
        Parameter::PegRadius,
        Parameter::Springback,
    ];
    let mut covered = [0; 5];
    let mut rounds = 0;
    while rounds < 500 {
        // Dimensions as far off as was assumed, and a loss of which nothing was.
        let mut dimensions = [20.4, 12.0, 3.0, 4.675];
        for value in &mut dimensions {
            *value *= 1.0 + random.next(0.15);
        }
        let loss = 10.23 + random.next(1.0);
        let [orbit, offset, pin, peg] = dimensions;
        // Machines that cannot be built, or cannot bend 130 degrees, are not calibrated.
        let Ok(geometry) = PegGeometry::new(mm(orbit), mm(offset), mm(pin), mm(peg)) else { continue };
        if geometry.reach() < deg(150.0) {
            continue;
        }
        let truth = machine(dimensions, loss);
        let angles = ladder(&truth, &[25.0, 60.0, 95.0, 125.0], 2, 0.5, &mut random);
        if angles.iter().any(|sample| truth.result(sample.axis).abs() < deg(8.0)) {
            continue;
        }
        rounds += 1;
        let measured = Measurements { angles, ..Measurements::default() };
        let found = calibrate(&assumed, &measured, ShapeChoice::Fixed(SpringbackShape::Constant)).unwrap();
        let fit = found.bends.unwrap().fit;
        for ((name, truth), covered) in names.iter().zip([orbit, offset, pin, peg, loss]).zip(&mut covered) {
            *covered += usize::from(covers(&estimate(&fit, *name), truth));
        }
    }
    for (name, covered) in names.iter().zip(covered) {
        assert!((460..=490).contains(&covered), "{name:?}: {covered} of 500");
    }
}
