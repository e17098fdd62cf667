//! What a person prints: templates at 1:1 and job sheets.

mod labels;
mod pages;
mod templates;
