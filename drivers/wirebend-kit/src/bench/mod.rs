//! The bench: what the pulses of a controller do to a wire, by physics, so that a program can be
//! checked without a bender.
//!
//! ```text
//! pulses, peg ─▶ Bench ─▶ contact of the peg ─▶ press of the wire ─▶ chain of straights and arcs ─▶ Made
//! ```
//!
//! Nothing here inverts the compensation of a program: the contact is solved as the tangency of two
//! circles and a line, springback is the unloading of an elastic and plastic section, and lengths follow
//! from the fibre that is neither stretched nor pressed. What agrees with the compensation agrees for
//! another reason.
//!
//! # Frames
//!
//! *Head*: the nozzle's exit is the origin, the wire comes out along +x, a positive bend turns what is
//! out from +x towards +y about +z. Pins stand at (0, ±(pin radius + wire radius)), the peg runs about
//! (offset, 0), and the bend axis is zero with the peg on the wire's axis, out along +x.
//!
//! *Wire*: a turtle that starts at the tip of the wire, which came out first, with t = +x, n = +y,
//! b = +z, and walks towards the nozzle. In the head it walks along -x, so its frame (t, n, b) lies along
//! (-x, +y, -z). A turn of the head by +φ is right-handed about t: about -x of the head, seen from the
//! wire. With that, `feed L, rotate φ, bend θ` make what the same words say of a turtle, and not its
//! mirror image.
//!
//! # What it does not know
//!
//! The time, the servo, the homing switch; what the formed wire runs into; weight, friction, twist and the
//! bow of straights. Only the part of the wire next to the nozzle meets the peg. Where that was not
//! enough, [`Made::warnings`] says so.
//!
//! ```
//! use wirebend_driver_api::Axis;
//! use wirebend_driver_wirebend_kit::bench::{Bench, Bender, Compliance, Peg, Scale, Wire};
//!
//! # fn main() -> Result<(), wirebend_driver_wirebend_kit::bench::BenchError> {
//! let scale = Scale { feed_mm_per_step: 0.1, rotate_deg_per_step: 0.1, bend_deg_per_step: 0.1 };
//! let mut bench = Bench::new(Bender::PUBLISHED, Wire::PUBLISHED, scale, Compliance::published()?)?;
//! let mut run = |bench: &mut Bench, axis, steps: i32| {
//!     (0..steps.abs()).for_each(|_| bench.step(axis, steps > 0));
//! };
//! run(&mut bench, Axis::Feed, 400); // 40 mm
//! run(&mut bench, Axis::Bend, -200); // below the wire
//! bench.peg(Peg::Out);
//! run(&mut bench, Axis::Bend, 1000); // to 80 degrees
//! run(&mut bench, Axis::Bend, -1000);
//! bench.peg(Peg::In);
//! assert!(bench.incidents().is_empty());
//! let made = bench.made();
//! assert!((made.bends()[0].angle_deg - 57.0).abs() < 1.0); // 67 by the peg's place, less springback
//! # Ok(())
//! # }
//! ```

mod bending;
mod chain;
mod contact;
mod deviation;
mod formed;
mod incident;
mod machine;
mod made;
mod noise;
mod press;
mod section;
mod settings;

pub use deviation::{CompareError, Deviations};
pub use incident::{Incident, ModelWarning, Violation};
pub use machine::{Bench, Peg};
pub use made::{Made, MadeBend};
pub use noise::{ErrorTerm, Noise};
pub use press::Compliance;
pub use settings::{BenchError, Bender, Drives, Scale, Wire};
