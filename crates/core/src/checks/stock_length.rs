//! Whether the wire and the tail that cannot be fed fit the stock that the machine takes.

use super::{Code, Diagnostic, Limit, Place, Quantity, Severity, Wire};
use crate::estimate::stock;

pub(super) fn check(wire: &Wire, found: &mut Vec<Diagnostic>) {
    let (Some(program), Some(limit)) = (wire.compensated, &wire.limits.most_stock) else {
        return;
    };
    let needed = stock(program, wire.limits.tail.value);
    if needed <= limit.value {
        return;
    }
    found.push(Diagnostic {
        code: Code::StockTooLong,
        severity: Severity::Error,
        place: Place::default(),
        measured: Some(Quantity::Length(needed)),
        limit: Some(Limit { value: Quantity::Length(limit.value), source: limit.source.clone() }),
        message: format!(
            "the wire takes {needed:.1} of stock, {:.1} of it a tail that cannot be fed; the machine takes {:.1}",
            wire.limits.tail.value, limit.value
        ),
        help: "split the design into several wires, or scale it down".to_owned(),
    });
}
