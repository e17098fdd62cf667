//! Every number of `docs/physics.md`, computed again by the stages that it describes. What is an input is read from the page, and what
//! comes out is compared with the page in as many digits as it shows.

mod bending;
mod document;
mod estimates;
mod paths;
mod routes;

use document::Document;
use wirebend_core::units::{Angle, Length};

fn deg(value: f64) -> Angle {
    Angle::from_deg(value).unwrap()
}

fn mm(value: f64) -> Length {
    Length::from_mm(value).unwrap()
}

/// Names and formulas in running text whose digits are no results.
const NAMES: &[&str] = &[
    "[SCF25]",
    "[BF23]",
    "[SCF25, Eq. 1]",
    "[BF23, Eq. 1 and Appendix A]",
    "Eq. 2",
    "6061-T6",
    "tan(θ / 2)",
    "d / 2",
    "(0, r_n)",
    "l_lost(θn - θn+1)",
];

#[test]
fn no_number_of_the_page_is_left_unchecked() {
    let mut page = Document::read();
    for claims in [paths::claims, routes::claims, bending::claims, estimates::claims] {
        claims(&mut page);
    }
    for name in NAMES {
        page.pass_over(name);
    }
    let left = page.unchecked();
    assert!(left.is_empty(), "nothing computes these again:\n{}", left.join("\n"));
}
