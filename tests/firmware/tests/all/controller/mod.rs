//! The firmware, by what it does on its pins and its serial line: the binary of the board on a simulated Uno, and
//! the same core on this computer.

mod approach;
mod backing_off;
mod boot;
mod builds;
mod clone;
mod core;
mod dry;
mod figures;
mod frames;
mod homing;
mod inputs;
mod jobs;
mod kept;
mod limits;
mod lines;
mod pulses;
mod release;
mod session;
mod settings;
mod speed;
mod stop;
mod talk;
mod watch;
