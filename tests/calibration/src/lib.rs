//! For tests: a machine is calibrated from coupons that the bench has bent, whose physics are not the models that are
//! fitted, and what it bends after that is compared with what was wanted.

#![cfg(test)]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test may stop at what cannot be
#![allow(clippy::print_stdout)] // figures, for --nocapture

mod before_zero;
mod near_corners;
mod recovery;
mod shop;
