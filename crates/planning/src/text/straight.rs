//! Straight parts: edges as designed, and feeds after compensation.

use wirebend_core::checks::Location;
use wirebend_core::units::{Angle, Length};

use super::number::{digits_beside, edge_list, straight};

pub(super) fn edge(at: &Location, length: Length, min: Length) -> String {
    let digits = digits_beside(length.mm(), min.mm());
    let edges = if at.edges.len() > 1 {
        format!("edges {} are", edge_list(at))
    } else {
        format!("edge {} is", edge_list(at))
    };
    format!("{edges} {length:.digits$} long; the machine's minimum is {min:.digits$}")
}

pub(super) fn feed_too_short(
    at: &Location,
    designed: Length,
    feed: Length,
    min: Length,
    unpressed: Option<Angle>,
) -> String {
    let digits = digits_beside(feed.mm(), min.mm());
    let bend = unpressed.map(|bend| format!(", and the peg cannot press the bend of {bend:.1} at its end"));
    format!(
        "{} after compensation; the machine cannot feed less than {min:.digits$}{}",
        fed(at, designed, feed, digits),
        bend.unwrap_or_default()
    )
}

pub(super) fn feed_near_limit(at: &Location, designed: Length, feed: Length, min: Length) -> String {
    let digits = digits_beside(feed.mm(), min.mm());
    format!("{} after compensation; the shortest feed is {min:.digits$}", fed(at, designed, feed, digits))
}

pub(super) fn feed_too_long(at: &Location, designed: Length, feed: Length, max: Length) -> String {
    let digits = digits_beside(feed.mm(), max.mm());
    format!("{}; the machine feeds at most {max:.digits$} at once", fed(at, designed, feed, digits))
}

pub(super) fn feed_longer_than_stock(at: &Location, designed: Length, feed: Length, max: Length) -> String {
    let digits = digits_beside(feed.mm(), max.mm());
    format!("{}; the stock without its tail is only {max:.digits$}", fed(at, designed, feed, digits))
}

pub(super) fn arcs_overlap(at: &Location, designed: Length, needed: Length) -> String {
    let digits = digits_beside(designed.mm(), needed.mm());
    format!("the bends at both ends of {} take {needed:.digits$} of its {designed:.digits$}", straight(at))
}

fn fed(at: &Location, designed: Length, feed: Length, digits: usize) -> String {
    format!("{} ({designed:.1} as designed) is fed {feed:.digits$}", straight(at))
}
