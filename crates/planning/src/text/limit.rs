//! Where limits come from.

use wirebend_core::checks::{LimitSource, ReachLimit};

use super::number::digits_apart;

/// Where a limit comes from. What a profile or a driver states is passed on as it is.
#[must_use]
pub fn source(source: LimitSource) -> String {
    match source {
        LimitSource::Stated(source) => source.to_string(),
        LimitSource::WeldTolerance => "the weld tolerance".to_owned(),
        LimitSource::Diameter => "the diameter of the wire".to_owned(),
        LimitSource::EulerPath => "Euler: only the ends of wires may be odd".to_owned(),
        LimitSource::BendRadius(radius) => format!("bends of centreline radius {radius:.2}"),
        LimitSource::Reach(ReachLimit::Axis { needed, travel }) => {
            let digits = digits_apart(needed.deg(), travel.value.deg(), 1);
            format!(
                "the bend axis, which would have to reach {needed:.digits$} and goes to {:.digits$} [{}]",
                travel.value, travel.source
            )
        }
        LimitSource::Reach(ReachLimit::Peg) => {
            "springback and setback of this wire on this machine".to_owned()
        }
        LimitSource::SmallDeflection => {
            "a tenth of the reach: beam theory is of small deflections".to_owned()
        }
        LimitSource::EulerLoad => {
            "half the load at which a column with pinned ends buckles (Euler)".to_owned()
        }
        LimitSource::JointReach => "how far a joint may be from where it is drawn".to_owned(),
        LimitSource::HeadClearance => "the head's clearance".to_owned(),
        LimitSource::HeadApproach => "the machine's largest angle of approach".to_owned(),
        LimitSource::AxisResolution => "half the resolution of the bend axis".to_owned(),
    }
}
