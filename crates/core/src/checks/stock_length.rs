//! Whether the wire and its unusable tail fit the stock that the machine holds.

use super::{Diagnostic, Fact, Location, ROUNDING, Remedy, Severity, WireStages};
use crate::estimate::stock;

pub(super) fn check(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    let (Some(program), Some(limit)) = (wire.compensated, &wire.limits.max_stock) else {
        return;
    };
    let tail = wire.limits.tail.value;
    let needed = stock(program, tail);
    if (needed - limit.value).mm() <= ROUNDING {
        return;
    }
    found.push(Diagnostic {
        severity: Severity::Error,
        location: Location::default(),
        fact: Fact::StockTooLong { needed, tail, limit: limit.clone() },
        remedies: vec![Remedy::SplitDesign, Remedy::ScaleDown],
    });
}
