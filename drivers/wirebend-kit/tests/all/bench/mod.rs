//! The bench against published measurements, hand calculation and other ways to the same result.

mod comparing;
mod compensation;
mod drives;
mod hand;
mod noise;
mod pressing;
mod properties;
mod published;
mod shape;
mod violations;
