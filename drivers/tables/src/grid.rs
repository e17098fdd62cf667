//! Numbers with a fixed count of decimals, counted in whole units of the last place. Sums and differences
//! of whole units are exact, so nothing is lost between one row and the next.

/// The most units that an f64 counts and writes exactly: a kilometre with nine decimals.
pub(crate) const MAX_UNITS: f64 = 1e15;

/// How many decimals there are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Grid {
    pub decimals: u8,
}

impl Grid {
    /// Units in 1.
    pub fn scale(self) -> f64 {
        10_f64.powi(self.decimals.into())
    }

    /// The nearest whole number of units, never -0.
    pub fn units(self, value: f64) -> f64 {
        (value * self.scale()).round() + 0.0
    }

    pub fn value(self, units: f64) -> f64 {
        units / self.scale()
    }

    /// Units in half a turn.
    pub fn half_turn(self) -> f64 {
        180.0 * self.scale()
    }

    /// The same turn in [0°, 360°).
    pub fn absolute(self, turn: f64) -> f64 {
        turn.rem_euclid(2.0 * self.half_turn()) + 0.0
    }

    /// The same turn in (-180°, 180°].
    pub fn relative(self, turn: f64) -> f64 {
        let turn = self.absolute(turn);
        if turn > self.half_turn() { turn - 2.0 * self.half_turn() } else { turn }
    }

    pub fn text(self, units: f64) -> String {
        format!("{:.places$}", self.value(units), places = usize::from(self.decimals))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_reader_ever_finds_minus_zero() {
        let grid = Grid { decimals: 3 };
        for value in [-0.0, -0.0004, 0.0004] {
            assert_eq!(grid.text(grid.units(value)), "0.000");
        }
        assert_eq!(grid.text(grid.units(-0.0006)), "-0.001");
        assert_eq!(grid.text(grid.relative(grid.units(-360.0))), "0.000");
    }

    #[test]
    fn turns_are_counted_once_around() {
        let grid = Grid { decimals: 1 };
        let both = |turn: f64| {
            [grid.relative(grid.units(turn)), grid.absolute(grid.units(turn))].map(|units| grid.text(units))
        };
        assert_eq!(both(-90.0), ["-90.0", "270.0"]);
        assert_eq!(both(-179.96), ["180.0", "180.0"]);
        assert_eq!(both(359.96), ["0.0", "0.0"]);
        assert_eq!(both(540.0), ["180.0", "180.0"]);
    }

    /// Floats have room to spare at the limit: the digits that come out are those that went in.
    #[test]
    fn the_largest_numbers_are_written_digit_by_digit() {
        let grid = Grid { decimals: 9 };
        assert_eq!(grid.text(MAX_UNITS - 1.0), "999999.999999999");
        assert_eq!(grid.text(123_456_789_012_345.0), "123456.789012345");
    }
}
