//! Figures of samples.

use statrs::distribution::{ContinuousCDF, StudentsT};

/// The factor on a standard deviation within which a share of all readings lies, for a deviation that is itself from
/// so many degrees of freedom (at least 1).
pub(super) fn within(share: f64, freedom: f64) -> f64 {
    // Beyond a thousand the factor changes by less than 0.2 %, and the search for it loses its way.
    let student = StudentsT::new(0.0, 1.0, freedom.clamp(1.0, 1000.0));
    student.map_or(f64::INFINITY, |student| student.inverse_cdf(f64::midpoint(1.0, share)))
}

/// The middle value; zero of none.
pub(super) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let half = values.len() / 2;
    match (values.get(half), values.get(half.wrapping_sub(1))) {
        (Some(&upper), Some(&lower)) if values.len().is_multiple_of(2) => f64::midpoint(lower, upper),
        (Some(&middle), _) => middle,
        _ => 0.0,
    }
}

/// The standard deviation of normal values by the median of their distances from zero, which a few wild ones hardly
/// move.
pub(super) fn robust_deviation(residuals: impl Iterator<Item = f64>) -> f64 {
    1.4826 * median(residuals.map(f64::abs).collect())
}

/// A count as a number.
#[allow(clippy::cast_precision_loss)] // counts are far below 2^52
pub(super) fn count(of: usize) -> f64 {
    of as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn students_factors_are_those_of_the_printed_tables() {
        // Two-sided 95 %: 12.706 for 1, 2.228 for 10, 1.960 for very many.
        let printed = [(1.0, 12.706), (10.0, 2.228), (60.0, 2.000), (120.0, 1.980), (1000.0, 1.962)];
        for (freedom, factor) in printed {
            assert!((within(0.95, freedom) - factor).abs() < 1e-3, "{freedom}: {}", within(0.95, freedom));
        }
        // And 99.9 %: 3.646 for 30, 3.373 for 120.
        for (freedom, factor) in [(30.0, 3.646), (120.0, 3.373)] {
            assert!((within(0.999, freedom) - factor).abs() < 1e-3, "{freedom}: {}", within(0.999, freedom));
        }
    }

    #[test]
    fn a_wild_value_does_not_move_the_deviation() {
        let values = [-1.0, 0.5, 0.9, -0.4, 1.1, 0.7, -0.8];
        let plain = robust_deviation(values.into_iter());
        let wild = robust_deviation(values.into_iter().chain([645.0]));
        assert!((wild / plain - 1.0).abs() < 0.15, "{plain} {wild}");
        assert!(median(Vec::new()) == 0.0);
    }
}
