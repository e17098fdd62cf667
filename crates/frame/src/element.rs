//! Stiffness, mass and loads of one beam.
