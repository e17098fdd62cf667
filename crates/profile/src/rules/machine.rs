//! What a complete machine profile needs and what contradicts itself in one.

use super::{FIGURE, above, within};
use crate::Kind;
use crate::heading::heading;
use crate::kind::is_slug;
use crate::machine::{BendMethod, MachineProfile};
use crate::profile::{Fault, Profile};

const REQUIRED: &[(&str, &str)] = &[
    ("name", "a name for people"),
    ("driver.id", "the id of the driver that speaks to the machine"),
    ("export.formats", "a list of format ids, the default first"),
    ("default_material", "the id of a material profile"),
    ("wire.min_diameter_mm", FIGURE),
    ("wire.max_diameter_mm", FIGURE),
    ("limits.min_bend_deg", FIGURE),
    ("limits.max_bend_deg", FIGURE),
    ("limits.min_edge_mm", FIGURE),
    ("limits.min_feed_mm", FIGURE),
    ("limits.tail_mm", FIGURE),
    ("limits.min_rotation_deg", FIGURE),
    ("limits.max_rotation_deg", FIGURE),
    ("feed.rate_mm_per_s", FIGURE),
    ("feed.resolution_mm", FIGURE),
    ("rotate.rate_deg_per_s", FIGURE),
    ("rotate.resolution_deg", FIGURE),
    ("bend.method", "\"peg\" or \"direct\""),
    ("bend.rate_deg_per_s", FIGURE),
    ("bend.resolution_deg", FIGURE),
    ("bend.pin_radius_mm", FIGURE),
    ("compensation.feed", "true or false"),
    ("compensation.setback", "true or false"),
    ("compensation.springback", "true or false"),
    ("signs.bend", "1 or -1"),
    ("signs.rotate", "1 or -1"),
    ("time.fixed_per_bend_s", FIGURE),
];
const PEG: &[(&str, &str)] = &[
    ("bend.rod_radius_mm", FIGURE),
    ("bend.orbit_radius_mm", FIGURE),
    ("bend.orbit_offset_mm", FIGURE),
    ("bend.axis_limit_deg", FIGURE),
];
impl Profile for MachineProfile {
    const KIND: Kind = Kind::Machine;
    const WHOLE: &'static [&'static str] = &[];
    heading!();

    fn required(&self) -> Vec<(&'static str, &'static str)> {
        let mut keys = REQUIRED.to_vec();
        if self.bend.method.as_deref() == Some(&BendMethod::Peg) {
            keys.extend(PEG);
        }
        keys
    }

    fn faults(&self) -> Vec<Fault> {
        let mut faults = Vec::new();
        self.range_faults(&mut faults);
        self.sign_faults(&mut faults);
        self.peg_faults(&mut faults);
        self.id_faults(&mut faults);
        self.shapes.iter().flatten().for_each(|shape| shape.faults(&mut faults));
        faults
    }

    fn references(&self) -> Vec<(&'static str, Kind, &str)> {
        let material =
            self.default_material.iter().map(|id| ("default_material", Kind::Material, id.value.as_str()));
        let noise = self.error.iter().map(|id| ("error", Kind::Noise, id.value.as_str()));
        material.chain(noise).collect()
    }
}

impl MachineProfile {
    fn range_faults(&self, faults: &mut Vec<Fault>) {
        let (wire, limits) = (&self.wire, &self.limits);
        let pairs = [
            ("wire.max_diameter_mm", &wire.min_diameter_mm, &wire.max_diameter_mm, true),
            ("limits.max_bend_deg", &limits.min_bend_deg, &limits.max_bend_deg, false),
            ("limits.max_feed_mm", &limits.min_feed_mm, &limits.max_feed_mm, false),
            ("limits.max_rotation_deg", &limits.min_rotation_deg, &limits.max_rotation_deg, false),
        ];
        for (key, low, high, may_be_equal) in pairs {
            let (Some(low), Some(high)) = (low, high) else {
                continue;
            };
            if low.value > high.value || (low.value >= high.value && !may_be_equal) {
                let relation = if may_be_equal { "at least" } else { "above" };
                let expected = format!("{relation} the lower bound, {}", low.value);
                let low_key = key.replace(".max_", ".min_");
                faults.push(Fault::new(key, high.value, expected).against(&low_key));
            }
        }
        within(faults, "limits.min_bend_deg", &limits.min_bend_deg, -180.0, 0.0);
        within(faults, "limits.max_bend_deg", &limits.max_bend_deg, 0.0, 180.0);
        within(faults, "limits.min_rotation_deg", &limits.min_rotation_deg, f64::MIN, 0.0);
        within(faults, "limits.max_rotation_deg", &limits.max_rotation_deg, 0.0, f64::MAX);
    }

    /// A peg that is thicker than its orbit is wide never leaves the wire.
    fn peg_faults(&self, faults: &mut Vec<Fault>) {
        let (Some(orbit), Some(rod)) = (&self.bend.orbit_radius_mm, &self.bend.rod_radius_mm) else { return };
        let thickest = self.wire.max_diameter_mm.as_ref().map_or(0.0, |figure| figure.value);
        let contact = rod.value + thickest / 2.0;
        if orbit.value <= contact {
            let expected = format!("more than the rod's radius and half the thickest wire, {contact}");
            faults.push(
                Fault::new("bend.orbit_radius_mm", orbit.value, expected).against("bend.rod_radius_mm"),
            );
            return;
        }
        // Further back, the orbit ends behind the pin, and the peg never touches the wire.
        let min = -(orbit.value.powi(2) - contact.powi(2)).sqrt();
        if let Some(offset) = self.bend.orbit_offset_mm.as_ref().filter(|offset| offset.value <= min) {
            let expected = format!("above {min:.3}, from where the orbit reaches the wire ahead of the pin");
            faults.push(
                Fault::new("bend.orbit_offset_mm", offset.value, expected).against("bend.orbit_radius_mm"),
            );
        }
    }

    fn sign_faults(&self, faults: &mut Vec<Fault>) {
        let above_zero = [
            ("wire.min_diameter_mm", &self.wire.min_diameter_mm),
            ("wire.max_diameter_mm", &self.wire.max_diameter_mm),
            ("limits.max_feed_mm", &self.limits.max_feed_mm),
            ("limits.max_stock_mm", &self.limits.max_stock_mm),
            ("feed.rate_mm_per_s", &self.feed.rate_mm_per_s),
            ("feed.resolution_mm", &self.feed.resolution_mm),
            ("rotate.rate_deg_per_s", &self.rotate.rate_deg_per_s),
            ("rotate.resolution_deg", &self.rotate.resolution_deg),
            ("bend.rate_deg_per_s", &self.bend.rate_deg_per_s),
            ("bend.resolution_deg", &self.bend.resolution_deg),
            ("bend.pin_radius_mm", &self.bend.pin_radius_mm),
            ("bend.rod_radius_mm", &self.bend.rod_radius_mm),
            ("bend.orbit_radius_mm", &self.bend.orbit_radius_mm),
            ("bend.axis_limit_deg", &self.bend.axis_limit_deg),
            ("bend.torque_n_m", &self.bend.torque_n_m),
        ];
        for (key, figure) in above_zero {
            above(faults, key, figure);
        }
        let zero_or_more = [
            ("limits.min_edge_mm", &self.limits.min_edge_mm),
            ("limits.min_feed_mm", &self.limits.min_feed_mm),
            ("limits.tail_mm", &self.limits.tail_mm),
            ("time.fixed_per_bend_s", &self.time.fixed_per_bend_s),
            ("time.fixed_per_feed_s", &self.time.fixed_per_feed_s),
            ("time.fixed_per_turn_s", &self.time.fixed_per_turn_s),
        ];
        for (key, figure) in zero_or_more {
            within(faults, key, figure, 0.0, f64::MAX);
        }
        // Farther off a motion is broken, or somebody has typed per cent.
        within(faults, "feed.scale", &self.feed.scale, 0.8, 1.25);
        within(faults, "rotate.offset_deg", &self.rotate.offset_deg, -20.0, 20.0);
        within(faults, "rotate.backlash_deg", &self.rotate.backlash_deg, 0.0, 20.0);
    }

    fn id_faults(&self, faults: &mut Vec<Fault>) {
        let rule = "an id of lower-case letters, digits and hyphens";
        if let Some(id) = self.driver.id.as_deref().filter(|id| !is_slug(id)) {
            faults.push(Fault::new("driver.id", id, rule));
        }
        if let Some(id) = self.export.native.as_deref().filter(|id| !is_slug(id)) {
            faults.push(Fault::new("export.native", id, rule));
        }
        let Some(formats) = &self.export.formats else {
            return;
        };
        if formats.is_empty() {
            faults.push(Fault::new("export.formats", "an empty list", "at least one format id"));
        }
        for (i, id) in formats.iter().enumerate() {
            if !is_slug(id) {
                faults.push(Fault::new("export.formats", id, rule));
            }
            if formats.iter().take(i).any(|earlier| earlier == id) {
                faults.push(Fault::new("export.formats", id, "each format id once"));
            }
        }
    }
}
