//! Errors of the motions.

use wirebend_driver_wirebend_kit::bench::{BenchError, ErrorTerm, Made, Noise};

use super::compensation::{ALL, Step};
use super::hand::{Hand, published};

fn step(feed_mm: f64, rotate_deg: f64, bend_deg: f64) -> Step {
    Step { feed_mm, rotate_deg, bend_deg }
}

fn made(noise: &Noise) -> Made {
    let mut hand = Hand::new(published().with_noise(noise).unwrap());
    ALL.run(&[step(50.0, 0.0, 90.0), step(50.0, 60.0, -70.0), step(50.0, 0.0, 0.0)], &mut hand);
    hand.bench.made()
}

fn spread(sigma: f64) -> ErrorTerm {
    ErrorTerm { bias: 0.0, sigma }
}

#[test]
fn the_same_seed_makes_the_same_wire() {
    let noise = |seed| Noise { seed, feed_mm: spread(0.1), rotate_deg: spread(0.5), bend_deg: spread(1.0) };
    assert_eq!(made(&noise(7)), made(&noise(7)));
    assert_ne!(made(&noise(7)), made(&noise(8)));
}

#[test]
fn a_constant_error_is_on_every_motion() {
    let (quiet, off) = (made(&Noise::default()), |bias| ErrorTerm { bias, sigma: 0.0 });
    let longer = made(&Noise { feed_mm: off(0.2), ..Noise::default() });
    assert!((longer.length_mm() - quiet.length_mm() - 3.0 * 0.2).abs() < 1e-9);
    let further = made(&Noise { bend_deg: off(1.0), ..Noise::default() });
    for (further, quiet) in further.bends().iter().zip(quiet.bends()) {
        assert!((further.angle_deg - quiet.angle_deg - 1.0).abs() < 1e-9);
    }
    let turned = made(&Noise { rotate_deg: off(-2.0), ..Noise::default() });
    assert!((turned.bends()[0].head_deg - quiet.bends()[0].head_deg).abs() < 1e-9);
    assert!((turned.bends()[1].head_deg - quiet.bends()[1].head_deg + 2.0).abs() < 1e-9);
}

#[test]
fn errors_are_as_large_as_they_are_said_to_be() {
    let mut hand = Hand::new(
        published().with_noise(&Noise { seed: 1, bend_deg: spread(1.4), ..Noise::default() }).unwrap(),
    );
    for _ in 0..200 {
        hand.feed(40.0).press(90.0);
    }
    let bends: Vec<f64> = hand.bench.made().bends().iter().map(|bend| bend.angle_deg).collect();
    assert_eq!(bends.len(), 200);
    let mean = bends.iter().sum::<f64>() / 200.0;
    let sigma = (bends.iter().map(|bend| (bend - mean).powi(2)).sum::<f64>() / 199.0).sqrt();
    // The deviation of 200 draws is off by 5 % of itself as a rule; four times that.
    assert!((sigma - 1.4).abs() < 0.28, "{sigma}");
}

#[test]
fn a_feed_more_changes_no_error_of_a_bend() {
    let noise = Noise { seed: 3, feed_mm: spread(0.1), bend_deg: spread(1.0), ..Noise::default() };
    let bends = |feeds: &[f64]| {
        let mut hand = Hand::new(published().with_noise(&noise).unwrap());
        for &feed in feeds {
            hand.feed(feed);
        }
        hand.press(90.0).feed(40.0).press(90.0);
        hand.bench.made().bends().iter().map(|bend| bend.angle_deg).collect::<Vec<f64>>()
    };
    assert_eq!(bends(&[50.0]), bends(&[55.0, -5.0]));
}

#[test]
fn errors_that_cannot_be_drawn_are_refused() {
    for term in [spread(-1.0), spread(f64::NAN), ErrorTerm { bias: f64::INFINITY, sigma: 0.0 }] {
        let refused = published().with_noise(&Noise { bend_deg: term, ..Noise::default() });
        assert!(matches!(refused, Err(BenchError::Figure { what: "the error of a bend", .. })));
    }
}
