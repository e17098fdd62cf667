//! What every driver keeps.

use wirebend_driver_wirebend_kit::WirebendKit;

#[test]
fn the_driver_keeps_the_rules() {
    wirebend_driver_api::conformance::assert_kept::<WirebendKit>();
}
