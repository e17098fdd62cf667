//! Feeds after compensation: too short to grip, arcs that overlap, longer than any stock.

use super::{Code, Diagnostic, Limit, Quantity, Severity, Wire, is_near};
use crate::compensate::{corner, with_bend_before};
use crate::units::{Angle, Length};

pub(super) fn check(wire: &Wire, found: &mut Vec<Diagnostic>) {
    let Some(nominal) = wire.nominal else { return };
    for (step, (before, designed)) in with_bend_before(&nominal.steps).enumerate() {
        // A fold back has no corner to reckon with; it has a check of its own.
        if before == Angle::HALF_TURN || designed.bend == Angle::HALF_TURN {
            judge(wire, step, designed.feed, designed.feed, found);
            continue;
        }
        // Bends have a radius on every machine, also on one that reckons with it on its own.
        let corner = |bend: Angle| corner(wire.bend_radius, bend);
        let straight = designed.feed - corner(before) - corner(designed.bend);
        if straight < Length::ZERO {
            let needed = designed.feed - straight;
            found.push(Diagnostic {
                code: Code::ArcsOverlap,
                severity: Severity::Error,
                place: wire.place_of_step(step),
                measured: Some(Quantity::Length(designed.feed)),
                limit: Some(Limit {
                    value: Quantity::Length(needed),
                    source: format!("bends of centreline radius {:.2}", wire.bend_radius),
                }),
                message: format!(
                    "the bends at both ends of {} take {needed:.1} of its {:.1}",
                    edges(wire, step),
                    designed.feed
                ),
                help: "make the edge longer or its bends gentler".to_owned(),
            });
            continue;
        }
        let model = wire.compensation.feed;
        let feed = model.map_or(designed.feed, |model| model.feed_for(designed.feed, before, designed.bend));
        judge(wire, step, designed.feed, feed, found);
    }
}

fn judge(wire: &Wire, step: usize, designed: Length, feed: Length, found: &mut Vec<Diagnostic>) {
    let least = &wire.limits.least_feed;
    let room = (feed - least.value).mm();
    let fed = || format!("{} ({designed:.1} as designed) is fed {feed:.1}", edges(wire, step));
    let most = wire.limits.most_stock.as_ref().map(|stock| (stock.value - wire.limits.tail.value, stock));
    let (code, severity, limit, message, help) = if room < 0.0 {
        let message =
            format!("{} after compensation; the machine cannot feed less than {:.1}", fed(), least.value);
        let help = format!("make the edge at least {:.1} longer", Length::computed(-room));
        (Code::FeedTooShort, Severity::Error, (least.value, &least.source), message, help)
    } else if let Some(longest) = wire.limits.most_feed.as_ref().filter(|longest| feed > longest.value) {
        let message = format!("{}; the machine feeds at most {:.1} at once", fed(), longest.value);
        let help = "shorten the straight part, or put a bend into it".to_owned();
        (Code::FeedTooLong, Severity::Error, (longest.value, &longest.source), message, help)
    } else if let Some((longest, stock)) = most.filter(|(longest, _)| feed > *longest) {
        let message = format!("{}; the stock without its tail is only {longest:.1}", fed());
        let help = "divide the edge among two wires".to_owned();
        (Code::FeedTooLong, Severity::Error, (longest, &stock.source), message, help)
    } else if is_near(room, least.value.mm()) {
        let message = format!("{} after compensation; the shortest feed is {:.1}", fed(), least.value);
        let help = "leave it, or make the edge a little longer".to_owned();
        (Code::FeedNearLimit, Severity::Warning, (least.value, &least.source), message, help)
    } else {
        return;
    };
    found.push(Diagnostic {
        code,
        severity,
        place: wire.place_of_step(step),
        measured: Some(Quantity::Length(feed)),
        limit: Some(Limit { value: Quantity::Length(limit.0), source: limit.1.clone() }),
        message,
        help,
    });
}

fn edges(wire: &Wire, step: usize) -> String {
    let edges: Vec<String> = wire.edges_of_step(step).iter().map(ToString::to_string).collect();
    match edges.len() {
        0 => format!("step {}", step + 1),
        1 => format!("edge {}", edges[0]),
        _ => format!("the straight of edges {}", edges.join(", ")),
    }
}
