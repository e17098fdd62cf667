//! What a complete profile needs and what contradicts itself in one.

mod machine;
mod material;
mod strut_builder;

use crate::profile::Fault;
use crate::sourced::Sourced;

/// What a figure is in a file.
pub(crate) const FIGURE: &str = "{\"value\": number, \"source\": text, \"measured\": true or false}";

type Figure = Option<Sourced<f64>>;

/// Asks for a value above zero.
pub(crate) fn above(faults: &mut Vec<Fault>, key: &str, figure: &Figure) {
    if let Some(figure) = figure
        && figure.value <= 0.0
    {
        faults.push(Fault::new(key, figure.value, "a value above 0"));
    }
}

/// Asks for a value in `[low, high]`; `f64::MIN` and `f64::MAX` mean no bound.
pub(crate) fn within(faults: &mut Vec<Fault>, key: &str, figure: &Figure, low: f64, high: f64) {
    let Some(figure) = figure else { return };
    if figure.value >= low && figure.value <= high {
        return;
    }
    let expected = match (low > f64::MIN, high < f64::MAX) {
        (true, true) => format!("a value between {low} and {high}"),
        (true, false) => format!("{low} or more"),
        _ => format!("{high} or less"),
    };
    faults.push(Fault::new(key, figure.value, expected));
}
