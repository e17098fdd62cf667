//! The same job through every driver that writes files: what is read back is the same wire, with the same
//! handedness, within what the digits of the format hold.
//!
//! Every golden case goes through every format, by the driver's own process. What a format cannot hold has to be
//! refused, and each list of refused cases is here with its reason: nothing is skipped.

mod bounds;
mod compared;
mod gcode_bender;
mod gcode_files;
mod kit_text;
mod planned;
mod points;
mod printed;
mod scripts;
mod serial_words;
mod signs;
mod tables;

/// Whether a case's wires are flat: only those are their own mirror image, turned over.
fn is_flat(case: &str) -> bool {
    ["fold-back", "house", "two-parts", "u-sample"].contains(&case)
}
