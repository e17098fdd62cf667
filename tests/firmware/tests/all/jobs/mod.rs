//! A job from the program to the wire: `wirebend` and its driver as they are shipped, the firmware behind a port.

mod at_port;
mod bender;
mod cube;
mod head;
mod interrupted;
mod limits;
mod lost;
mod refused;
mod shop;
mod standing;
mod stop;
mod wrong;
