//! What a person prints: templates at 1:1 and job sheets.

mod coupons;
mod labels;
mod pages;
mod templates;
