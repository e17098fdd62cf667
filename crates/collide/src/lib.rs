//! Distance and first contact between a chain of straight pieces and solids that move past it.
//!
//! A [`Chain`] is a line of straight pieces in order, fixed in its frame. A [`Solid`] is convex and known by its signed
//! distance; a [`Motion`] says where it sees the chain at each time from 0 to 1, and bounds how fast. [`first_contact`] is
//! the earliest time at which they come closer than asked, [`closest`] the least distance over the whole motion. Nothing is
//! sampled: a part of the motion is left out only where a bound on speed, or what the motion leaves as it is (see [`Ring`]), proves
//! that nothing meets there.
//!
//! A [`Head`] is carried along a line without turning, and is asked for many directions of its axis at once.
//!
//! Lengths have one unit throughout; here it is called mm. Thickness is the caller's: a chain of capsules of radius r meets a
//! solid where the distance of its centreline is r.

mod chain;
mod direction_set;
mod head;
mod motion;
mod pairs;
mod parts;
mod piece;
mod ring;
mod sector;
mod solid;
mod sweep;

pub use chain::{Chain, Interval};
pub use direction_set::DirectionSet;
pub use head::{Head, HeadError, Passage};
pub use motion::Motion;
pub use pairs::{ClosePair, close_pairs};
pub use parts::Parts;
pub use piece::{Near, between_pieces, to_solid};
pub use ring::Ring;
pub use sector::{Sector, Walls};
pub use solid::Solid;
pub use sweep::{Proximity, Task, closest, first_contact};
