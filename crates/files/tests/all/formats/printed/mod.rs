//! What a person prints: templates at 1:1, job sheets and the sheet of coupons.

mod coupons;
mod labels;
mod pages;
mod templates;
