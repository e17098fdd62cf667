//! Where the head has to turn, and where it is sent for that.

use super::*;

#[test]
fn a_head_that_cannot_turn_far_enough_is_named_with_the_step() {
    let mut stiff = published_machine();
    stiff.head.min = deg(0.0);
    stiff.head.max = deg(0.0);
    let twisted = chain(&[[0., 0., 0.], [40., 0., 0.], [40., 40., 0.], [40., 40., 40.]]);
    let found = on(&stiff, &twisted, &PlanOptions::default());
    let rotation = only(&found, Code::RotationOutOfRange);
    assert_eq!((rotation.location.step, &rotation.location.vertices[..]), (Some(1), &[VertexId(2)][..]));
}

/// The head comes to 90° or -90°; one that turns too little is sent farther. Where the other side is within its limits it goes there.
#[test]
fn a_head_that_is_sent_farther_than_it_can_turn_is_named_with_the_step() {
    let twisted = chain(&[[0., 0., 0.], [40., 0., 0.], [40., 40., 0.], [40., 40., 40.]]);
    for (min, max, offset, sent) in [
        (-90.0, 90.0, 0.0, None),
        (0.0, 90.0, 5.0, None),
        (0.0, 90.0, -5.0, Some(95.0)),
        (-90.0, 90.0, -5.0, None),
        (-90.0, 0.0, 5.0, Some(-95.0)),
    ] {
        let mut machine = published_machine();
        (machine.head.min, machine.head.max) = (deg(min), deg(max));
        machine.compensation.motion.rotate_offset = deg(offset);
        let found = on(&machine, &twisted, &PlanOptions::default());
        let named = found.iter().find(|d| d.code() == Code::RotationOutOfRange);
        assert_eq!(named.map(|d| measured_deg(d).round()), sent, "{min} to {max}, {offset}");
        assert!(named.is_none_or(|d| d.location.step == Some(1) && d.is_error()));
    }
}
