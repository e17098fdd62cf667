//! That the head of the machine was not measured, which is so for a design and not for each of its wires.

use wirebend_core::checks::{Diagnostic, Fact};
use wirebend_core::plan::WirePlan;

/// Takes it from the wires and says it once, with the bends of all that it matters for.
pub(super) fn of_all(wires: &mut [WirePlan]) -> Option<Diagnostic> {
    let mut all: Option<Diagnostic> = None;
    for wire in wires {
        wire.diagnostics.retain(|diagnostic| {
            let Fact::HeadNotMeasured(bends) = diagnostic.fact else { return true };
            match &mut all {
                Some(Diagnostic { fact: Fact::HeadNotMeasured(sum), .. }) => *sum += bends,
                _ => all = Some(diagnostic.clone()),
            }
            false
        });
    }
    all
}

#[cfg(test)]
mod tests {
    use std::fmt::Write as _;

    use super::*;
    use crate::design::DesignInput;
    use crate::{Installation, NoProgress, PlanChoices};

    /// Five bends of 30° to one side, each of which is pressed on wire that was bent before, in each of so many wires.
    fn arcs(wires: u32) -> String {
        let mut text = String::new();
        for wire in 0..wires {
            let mut at = [0.0_f64, 0.0];
            writeln!(text, "v 0 0 {}", wire * 100).unwrap();
            for k in 0..7 {
                let way = f64::to_radians(30.0 * f64::from(k));
                at = [at[0] + 28.0 * way.cos(), at[1] + 28.0 * way.sin()];
                let before = wire * 8 + k + 1;
                writeln!(text, "v {} {} {}\nl {before} {}", at[0], at[1], wire * 100, before + 1).unwrap();
            }
        }
        text
    }

    /// One thing to measure would stand in the list as often as there are wires.
    #[test]
    fn of_several_wires_it_is_said_once_with_the_bends_of_all() {
        let app = Installation::new(&[]).unwrap();
        let choices = PlanChoices { machine: Some("wirebend-kit".into()), ..PlanChoices::default() };
        let said = |wires: u32| -> Vec<usize> {
            let input = DesignInput::file(std::path::PathBuf::new());
            let opened = input.open_bytes("arcs.obj".into(), arcs(wires).as_bytes(), None).unwrap();
            let planned = app.plan_design(opened, &choices, &NoProgress).unwrap();
            assert_eq!(planned.wires.len(), wires as usize);
            let of_wires = planned.wires.iter().flat_map(|wire| &wire.diagnostics);
            let all = planned.design.iter().chain(of_wires);
            all.filter_map(|one| if let Fact::HeadNotMeasured(bends) = one.fact { Some(bends) } else { None })
                .collect()
        };
        let [one] = said(1)[..] else { panic!("it is not said of one wire") };
        assert!(one > 1);
        assert_eq!(said(3), [3 * one]);
    }
}
