//! The whole bunny on both controllers, which takes minutes: `make firmware-soak`.

#![cfg(target_os = "linux")]

use wirebend_tests_firmware::lockstep;

fn main() {
    lockstep::in_lockstep("bunny", &lockstep::lines(include_str!("../tests/all/controller/steps/bunny.csv")));
}
