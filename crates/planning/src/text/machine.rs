//! The machine as a whole: its head, its stock, the wires that it takes.

use wirebend_core::checks::{BendRadius, Location};
use wirebend_core::sag::Sag;
use wirebend_core::units::{Angle, Length};

use super::number::{digits_apart, of_bend};

pub(super) fn rotation_out_of_range(at: &Location, wanted: Angle, [min, max]: [Angle; 2]) -> String {
    format!(
        "the bend{} needs the head at {wanted:.2} (or half turns from there); the head turns from {min:.1} to {max:.1}",
        of_bend(at)
    )
}

pub(super) fn sent_out_of_range(at: &Location, sent: Angle, [min, max]: [Angle; 2]) -> String {
    let passed = if sent > max { max } else { min };
    let digits = digits_apart(sent.deg(), passed.deg(), 2);
    format!(
        "for the bend{} the head is sent to {sent:.digits$}; it turns from {min:.1} to {max:.1}",
        of_bend(at)
    )
}

pub(super) fn stock_too_long(needed: Length, tail: Length, max: Length) -> String {
    let digits = digits_apart(needed.mm(), max.mm(), 1);
    format!(
        "the wire takes {needed:.digits$} of stock, {tail:.1} of it unusable tail; the machine takes {max:.digits$}"
    )
}

pub(super) fn bend_torque_low(available_n_m: f64, needed_n_m: f64) -> String {
    let times = available_n_m / needed_n_m;
    format!(
        "the bend axis has {available_n_m:.2} N·m, {times:.2} times the {needed_n_m:.2} N·m that bend this wire: it may stall"
    )
}

pub(super) fn bend_radius_small(bend: &BendRadius) -> String {
    let BendRadius { inner, least_diameters, .. } = bend;
    let least = bend.least();
    // As many digits as tell the two apart.
    let alike = |digits: &usize| {
        format!("{inner:.digits$}", digits = *digits) == format!("{least:.digits$}", digits = *digits)
    };
    let digits = (2..4).find(|digits| !alike(digits)).unwrap_or(4);
    format!(
        "the inside of every bend has a radius of {inner:.digits$}, and this wire was seen to take {least:.digits$} or more ({} times its diameter): the outside of bends may crack",
        least_diameters.value
    )
}

pub(super) fn part_sags(Sag { deflection, reach, .. }: &Sag) -> String {
    format!(
        "the part already bent reaches {reach:.0} and sags by about {deflection:.0}, more than a tenth of that: it will not lie where the program has it"
    )
}

pub(super) fn wire_does_not_fit(diameter: Length, [min, max]: [Length; 2]) -> String {
    let compared = if diameter < min { "thinner" } else { "thicker" };
    format!("a wire of {diameter:.2} is {compared} than the machine takes ({min:.2} to {max:.2})")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_beyond_a_limit_does_not_read_like_it() {
        let [sent, most] = [360.003, 360.0].map(|deg| Angle::from_deg(deg).unwrap());
        let said = sent_out_of_range(&Location::default(), sent, [-most, most]);
        assert!(said.contains("sent to 360.003°"), "{said}");
        let [needed, tail, max] = [2000.04, 400.0, 2000.0].map(|mm| Length::from_mm(mm).unwrap());
        let said = stock_too_long(needed, tail, max);
        assert!(said.contains("takes 2000.04 mm of stock") && said.ends_with("takes 2000.00 mm"), "{said}");
    }
}
