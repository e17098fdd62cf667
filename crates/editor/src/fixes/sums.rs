//! What a design takes after a fix, and what is different then.

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_core::plan::WirePlan;

use super::trials::Trial;
use crate::check::{LiveCheck, WireFigures};

/// Sums over all wires of the design afterwards, less those of before. Null where one of them is not known, as
/// without a route.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct FixChange {
    /// Designed length, mm.
    pub length_mm: Option<f64>,
    /// Stock to load, mm.
    pub stock_mm: Option<f64>,
    /// Time on the machine, s.
    pub time_s: Option<f64>,
    /// Price of the stock to load.
    pub cost: Option<f64>,
    /// Of the cost.
    pub currency: Option<String>,
    /// Errors. A wire that had no route was not checked for bends: its errors show once it has one.
    pub errors: i64,
    pub warnings: i64,
}

/// Sums over all wires of the design afterwards. Null where one of them is not known.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct FixTotals {
    /// How many wires there are.
    pub wires: usize,
    /// How many things they hit while they are bent; null where that was not looked for.
    pub collisions: Option<usize>,
    /// How many things they do not hit, but come nearer to than the clearance; null where that was not looked for.
    pub near: Option<usize>,
    /// Designed length, mm.
    pub length_mm: Option<f64>,
    /// Stock to load, mm.
    pub stock_mm: Option<f64>,
    /// Time on the machine, s.
    pub time_s: Option<f64>,
    /// Price of that stock: each wire wastes a tail besides.
    pub cost: Option<f64>,
}

impl FixTotals {
    pub(super) fn of(Trial { check, wires, .. }: &Trial) -> Self {
        let met = |hits: bool| {
            let of_wire = |wire: &WirePlan| {
                Some(wire.contacts.as_ref()?.iter().filter(|one| one.hits() == hits).count())
            };
            wires.iter().map(of_wire).sum()
        };
        Self {
            wires: check.wires.len(),
            collisions: met(true),
            near: met(false),
            length_mm: sum(check, |wire| wire.length_mm),
            stock_mm: sum(check, |wire| wire.stock_mm),
            time_s: sum(check, |wire| wire.time_s),
            cost: sum(check, |wire| wire.stock_cost),
        }
    }
}

impl FixChange {
    pub(super) fn between(before: &Trial, after: &Trial) -> Self {
        let change = |figure: fn(&WireFigures) -> Option<f64>| {
            Some(sum(&after.check, figure)? - sum(&before.check, figure)?)
        };
        let count = |trial: &Trial| {
            let (errors, warnings) = (trial.errors(), trial.warnings());
            (i64::try_from(errors).unwrap_or(i64::MAX), i64::try_from(warnings).unwrap_or(i64::MAX))
        };
        let (then, now) = (count(before), count(after));
        Self {
            length_mm: change(|wire| wire.length_mm),
            stock_mm: change(|wire| wire.stock_mm),
            time_s: change(|wire| wire.time_s),
            cost: change(|wire| wire.stock_cost),
            currency: after.check.wires.iter().find_map(|wire| wire.currency.clone()),
            errors: now.0 - then.0,
            warnings: now.1 - then.1,
        }
    }
}

pub(super) fn sum(check: &LiveCheck, figure: fn(&WireFigures) -> Option<f64>) -> Option<f64> {
    check.wires.iter().map(figure).sum()
}
