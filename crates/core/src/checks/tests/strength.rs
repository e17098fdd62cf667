//! The radius that a wire is bent to beside the one that it takes.

use super::*;

/// Wire of 3 mm round the pin of 1.5 mm is what the paper shows to hold.
#[test]
fn a_bend_that_is_tighter_than_the_wire_takes_is_told() {
    let u = chain(&[[0., 0., 0.], [35., 0., 0.], [35., 35., 0.]]);
    let mut machine = published_machine();
    let bend = machine.limits.bend_radius.clone().unwrap();
    for (diameters, within, warned) in [
        (0.0, 0.0, false),
        (0.5, 0.0, false),
        (0.501, 0.0, true),
        (2.0, 0.0, true),
        // A pin of 1.5 mm to within 0.7 mm may be one of 1.8 mm.
        (0.6, 0.7, false),
        (0.6, 0.2, true),
    ] {
        let least_diameters = Sourced { value: diameters, ..bend.least_diameters.clone() };
        machine.limits.bend_radius =
            Some(BendRadius { least_diameters, inner_within: mm(within), ..bend.clone() });
        let found = on(&machine, &u, &PlanOptions::default());
        let small: Vec<_> = found.iter().filter(|one| one.code() == Code::BendRadiusSmall).collect();
        assert_eq!(small.len(), usize::from(warned), "{diameters} diameters");
        for one in small {
            assert_eq!(one.severity, Severity::Warning);
            let (value, limit) = (one.fact.measured(), one.fact.limit().unwrap());
            assert_eq!(value, Some(Quantity::Length(mm(1.5))));
            assert_eq!(limit.value, Quantity::Length(mm(3.0 * diameters)));
        }
    }
}
