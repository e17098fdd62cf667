//! Small bends of soft wire, whose axis stops before zero: the bench, which finds contacts by marching, makes them as they were asked
//! for.

use wirebend_core::compensate::{Compensation, ToldStep, compensate};

use crate::near_corners::{machine, off, program};
use crate::shop::Shop;

fn told_sides(loss: f64) -> Compensation {
    let mut machine = machine(loss);
    machine.bend.before_zero = true;
    machine
}

/// How far the bends after edges of `edge` mm are off, and how many of them end before zero.
fn made(shop: &mut Shop, loss: f64, edge: f64, bends: &[(f64, f64)]) -> (Vec<f64>, usize) {
    let (machine, program) = (told_sides(loss), program(edge, bends));
    let told = compensate(&program, &machine).unwrap();
    assert_eq!(told.unpressed(), []);
    let told: Vec<ToldStep> = told.told().collect();
    let before_zero = told.iter().filter(|told| told.bends() && told.beyond_zero() < 0.0).count();
    let off = off(shop, &program, &told, &machine);
    println!("{bends:?} after {edge} mm: off by {off:.3?}, {before_zero} before zero");
    (off, before_zero)
}

/// What straight wire springs back by after a bend: what calibration gives.
fn loss_at(shop: &mut Shop, bend: f64) -> f64 {
    let mut loss = 0.3;
    for _ in 0..4 {
        loss -= made(shop, loss, 60.0, &[(0.0, bend)]).0[0];
    }
    loss
}

#[test]
fn small_bends_of_soft_wire_come_out() {
    // Next to none of its strength, and so much that it springs back by some tenths of a degree.
    for share in [1e-6, 0.08] {
        for bend in [0.5, 2.0, 5.0] {
            let mut shop = Shop::soft(share);
            let loss = if share < 0.01 { 0.0 } else { loss_at(&mut shop, bend) };
            assert!(share < 0.01 || (0.1..0.6).contains(&loss), "{loss}");
            for side in [1.0, -1.0] {
                let (off, before_zero) = made(&mut shop, loss, 60.0, &[(0.0, side * bend)]);
                assert_eq!(before_zero, 1);
                assert!(off[0].abs() < 0.05, "{bend} to {side}: {off:?}");
                // A corner to either side within the reach of the peg, in its plane and out of it.
                for before in [[(0.0, 8.0), (0.0, -6.0)], [(0.0, -12.0), (70.0, 7.0)]] {
                    let bends = [before[0], before[1], (0.0, side * bend), (0.0, -side * bend)];
                    let (off, before_zero) = made(&mut shop, loss, 24.0, &bends);
                    assert!(before_zero > 1 && off.iter().all(|off| off.abs() < 0.3), "{bend}: {off:?}");
                }
            }
        }
    }
}
