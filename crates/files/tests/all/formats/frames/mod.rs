//! Files of frames: what is read of them, and what is written.

mod files;
mod left_out;
mod pwf;
mod results;
