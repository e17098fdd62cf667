//! How strong the bend axis of a machine is beside each wire that fits it.

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_core::checks::TORQUE_MARGIN;

use crate::Installation;
use crate::machine::Setup;

/// What the bend axis has, and what it takes to bend each wire.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct BendTorqueReport {
    /// What the axis has, N·m.
    pub available_n_m: f64,
    /// There is a warning where it has less than so many times what a wire takes.
    pub margin: f64,
    /// The wires that fit the machine, the strongest first.
    pub wires: Vec<WireTorqueReport>,
}

#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct WireTorqueReport {
    /// The material, by id.
    pub material: String,
    /// Plastic moment of the wire, N·m.
    pub needed_n_m: f64,
    /// So many times as much the axis has.
    pub times: f64,
}

/// Of a machine that can be used; none where it states no torque.
pub(super) fn report(app: &Installation, machine: &str) -> Option<BendTorqueReport> {
    let machine = app.library.machine(machine).ok()?;
    let available_n_m = machine.profile.bend.torque_n_m.as_ref()?.value;
    let wire = |id: String| {
        // A wire that cannot be used says so where it is chosen.
        let setup = Setup::new(machine.clone(), app.library.material(&id).ok()?).ok()?;
        let limits = &setup.model.limits;
        let diameter = setup.model.wire.diameter;
        if diameter < limits.min_diameter.value || diameter > limits.max_diameter.value {
            return None;
        }
        let needed_n_m = limits.bend_torque.as_ref()?.needed_n_m;
        Some(WireTorqueReport { material: id, needed_n_m, times: available_n_m / needed_n_m })
    };
    let mut wires: Vec<WireTorqueReport> =
        app.library.materials().into_iter().filter_map(|listed| wire(listed.id)).collect();
    wires.sort_by(|one, other| one.times.total_cmp(&other.times));
    Some(BendTorqueReport { available_n_m, margin: TORQUE_MARGIN, wires })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The paper has 23 times for its wire.
    #[test]
    fn the_margin_of_each_wire_is_told_however_large_it_is() {
        let found = report(&Installation::new(&[]).unwrap(), "wirebend-kit").unwrap();
        let own = found.wires.iter().find(|wire| wire.material == "aluminium-6061-t6-3mm").unwrap();
        assert!((own.needed_n_m - 1.630).abs() < 5e-4 && (own.times - 23.0).abs() < 0.5, "{own:?}");
        assert!(found.wires.len() > 3 && found.wires.windows(2).all(|pair| pair[0].times <= pair[1].times));
        // A machine whose torque nobody states.
        assert_eq!(report(&Installation::new(&[]).unwrap(), "table-bender"), None);
    }
}
