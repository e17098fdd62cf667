//! What a structure takes, as Bend-Forming reckons it (Bhundiya and Cordero 2023, Table 1).

/// The authors' power, W.
const POWER_W: f64 = 25.0;

/// Energy and time for a mass. The energy is what a process takes for each gram, the authors' 0.33 kJ for steel wire: the plastic work of
/// the bends is about a thousandth of it. The time is that energy at a constant power, and not the time of any machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resources {
    /// Mass of the wire, g.
    pub wire_g: f64,
    /// Mass of what joins it at the vertices, g.
    pub joints_g: f64,
}

impl Resources {
    /// Wire and joints, g.
    #[must_use]
    pub fn mass_g(&self) -> f64 {
        self.wire_g + self.joints_g
    }

    /// Energy, kJ, for what a gram takes.
    #[must_use]
    pub fn energy_kj(&self, kj_per_g: f64) -> f64 {
        kj_per_g * self.mass_g()
    }

    /// Time for an energy in kJ, min.
    #[must_use]
    pub fn time_min(energy_kj: f64) -> f64 {
        energy_kj * 1.0e3 / POWER_W / 60.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Table 1: mass with joints in g, energy in kJ, time in min, as its own factors give them; the paper prints whole numbers.
    #[test]
    fn energy_and_time_are_those_of_table_1() {
        let table = [
            (29.0, 9.57, 6.38),
            (54.0, 17.82, 11.88),
            (60.0, 19.80, 13.20),
            (183.0, 60.39, 40.26),
            (218.0, 71.94, 47.96),
        ];
        for (mass, energy, time) in table {
            let used = Resources { wire_g: mass - 2.0, joints_g: 2.0 };
            let found = used.energy_kj(0.33);
            assert!((found / energy - 1.0).abs() < 1e-3, "{mass} g take {found} kJ");
            let minutes = Resources::time_min(found);
            assert!((minutes / time - 1.0).abs() < 1e-3, "{mass} g take {minutes} min");
        }
    }
}
