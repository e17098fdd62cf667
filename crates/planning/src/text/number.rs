//! Figures, names and lists as sentences show them.

use wirebend_core::checks::Location;

/// The digits behind the point, at least `min`, with which two values read differently: a value beyond a limit is never
/// shown with the same digits as the limit. Nine at most, below which nothing here distinguishes values.
pub(super) fn digits_apart(value: f64, limit: f64, min: usize) -> usize {
    let alike = |&digits: &usize| format!("{value:.digits$}") == format!("{limit:.digits$}");
    min + (min..9).take_while(alike).count()
}

/// What arithmetic may leave between a value and a limit that it is at, mm or degrees.
const ROUNDING: f64 = 1e-9;

/// The digits for a value beside a limit that it may be at: then both read alike, as they should.
pub(super) fn digits_beside(value: f64, limit: f64) -> usize {
    if (value - limit).abs() <= ROUNDING { 1 } else { digits_apart(value, limit, 1) }
}

/// A least value in so many digits: none that is shown is too little.
pub(super) fn at_least(value: f64, digits: i32) -> f64 {
    let shift = 10.0_f64.powi(digits);
    (value * shift - 1e-6).ceil() / shift
}

/// The same of a largest one.
pub(super) fn at_most(value: f64, digits: i32) -> f64 {
    let shift = 10.0_f64.powi(digits);
    (value * shift + 1e-6).floor() / shift
}

/// "$1.20"; a currency without a sign of its own behind the figure: "1.20 CHF".
#[must_use]
pub fn price(value: f64, currency: &str) -> String {
    let sign = match currency {
        "USD" => "$",
        "EUR" => "€",
        "GBP" => "£",
        "JPY" => "¥",
        _ => return format!("{value:.2} {currency}"),
    };
    format!("{sign}{value:.2}")
}

/// "1 edge", "3 edges".
pub(super) fn count(number: usize, one: &str, many: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { many })
}

/// "a", "a, or b", "a, b, or c".
pub(super) fn alternatives(all: &[String]) -> String {
    match all {
        [] => String::new(),
        [only] => only.clone(),
        [first @ .., last] => format!("{}, or {last}", first.join(", ")),
    }
}

/// " at vertex 4", or " of step 3" where no vertex is known.
pub(super) fn of_bend(at: &Location) -> String {
    match (at.vertices.first(), at.step) {
        (Some(vertex), _) => format!(" at vertex {vertex}"),
        (None, Some(step)) => format!(" of step {}", step + 1),
        (None, None) => String::new(),
    }
}

/// The edges of a location, with commas.
pub(super) fn edge_list(at: &Location) -> String {
    let edges: Vec<String> = at.edges.iter().map(ToString::to_string).collect();
    edges.join(", ")
}

/// "edge 2", "the straight of edges 2, 5", or "step 3" where no edge is known.
pub(super) fn straight(at: &Location) -> String {
    match (at.edges.len(), at.step) {
        (0, Some(step)) => format!("step {}", step + 1),
        (0 | 1, _) => format!("edge {}", edge_list(at)),
        _ => format!("the straight of edges {}", edge_list(at)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_price_has_the_sign_of_its_currency() {
        assert_eq!([price(0.237, "USD"), price(12.0, "CHF")], ["$0.24", "12.00 CHF"]);
    }

    /// What a person is told to do has to be enough.
    #[test]
    fn a_least_value_is_rounded_up_and_a_largest_one_down() {
        let least = [0.02, 0.1, 0.14].map(|value| at_least(value, 1));
        assert_eq!(least.map(|value| format!("{value:.1}")), ["0.1", "0.1", "0.2"]);
        let most = [141.2278, 141.22].map(|value| at_most(value, 2));
        assert_eq!(most.map(|value| format!("{value:.2}")), ["141.22", "141.22"]);
    }

    #[test]
    fn what_differs_reads_differently() {
        for (value, limit, digits) in
            [(155.0001, 155.0, 4), (160.0, 155.0, 1), (20.399_999, 20.4, 6), (1.0, 1.0, 9)]
        {
            assert_eq!(digits_apart(value, limit, 1), digits, "{value} beside {limit}");
        }
        assert_eq!(digits_beside(155.0 + 1e-12, 155.0), 1, "at the limit both read alike");
    }
}
