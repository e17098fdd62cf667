//! A machine on the command line: wires that are run, stopped and resumed, and moves by hand.

#[cfg(target_os = "linux")]
mod asked;
#[cfg(target_os = "linux")]
mod bench;
#[cfg(target_os = "linux")]
mod bender;
#[cfg(target_os = "linux")]
mod board;
#[cfg(target_os = "linux")]
mod board_limits;
mod by_hand;
mod console;
#[cfg(target_os = "linux")]
mod cutting;
#[cfg(target_os = "linux")]
mod heads;
mod interrupted;
#[cfg(target_os = "linux")]
mod lost;
mod pieces;
#[cfg(target_os = "linux")]
mod random_stops;
mod runs;
#[cfg(target_os = "linux")]
mod silent;
#[cfg(target_os = "linux")]
mod simulated_as;
#[cfg(target_os = "linux")]
mod still_moving;
#[cfg(target_os = "linux")]
mod stop;
#[cfg(target_os = "linux")]
mod zeroed;
