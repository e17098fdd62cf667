//! What people bring and take away: readers, writers and the project documents.
//!
//! Every reader takes bytes and gives a wireframe, a stencil or a program, with a note on all that
//! it merged, ignored or assumed. Every writer takes values and gives text. Files are touched in
//! two places only: [`read::read_file`] and [`document::save_atomically`].

pub mod document;
mod encoding;
mod length_unit;
mod limit;
pub mod number;
pub mod read;
pub mod write;
