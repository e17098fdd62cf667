//! Jobs of the examples on both controllers. The whole bunny is run by `make firmware-soak`.

use wirebend_tests_firmware::lockstep::{in_lockstep, lines};

const CUBE: &str = include_str!("steps/cube.csv");
const SPRING: &str = include_str!("steps/spring.csv");
const BUNNY: &str = include_str!("steps/bunny.csv");

#[test]
fn the_cube_in_lockstep() {
    in_lockstep("cube", &lines(CUBE));
}

#[test]
fn the_spring_in_lockstep() {
    in_lockstep("spring", &lines(SPRING));
}

/// Fifteen lines, with a bend at the limit of the machine.
#[test]
fn a_part_of_the_bunny_in_lockstep() {
    in_lockstep("bunny, 15 lines", &lines(BUNNY)[30..45]);
}
