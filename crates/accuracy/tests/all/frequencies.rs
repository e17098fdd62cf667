//! How free trusses vibrate, with straight struts and with bowed ones, against the Abaqus runs of the authors of Bend-Forming (their sheet
//! beside `HaaarshB/Bend-Forming`, 57988a9) and an independent program.

use wirebend_accuracy::bows;
use wirebend_frame::{Assembly, ModeKind, ModeSearch, Pieces};

use super::near;
use super::truss::{DEPTH, Truss};

/// Pieces of a straight strut, and of a bowed one.
const STRAIGHT: usize = 4;
const BOWED: usize = 9;

/// The first frequency of what is no rigid motion, Hz.
fn first(cut: Pieces) -> f64 {
    let assembly = Assembly::new(&cut.model).unwrap();
    let search = ModeSearch { count: 1, shift_hz: 60.0, struts: cut.struts, masses: Vec::new() };
    let modes = assembly.modes(&assembly.all(), &search).unwrap();
    modes.iter().find(|mode| mode.kind != ModeKind::Rigid).unwrap().frequency_hz
}

/// The authors' walks with their doubled struts (0.3 %), and the independent program, of which `OpenSees` confirms the first two.
#[test]
fn straight_struts() {
    for (rings, authors, independent) in [(1, 582.14, 582.36), (3, 588.90, 589.19), (5, 427.14, 427.95)] {
        let model = Truss::new(rings, DEPTH).locked(&format!("ring-{rings}"));
        let found = first(Pieces::new(&model, STRAIGHT));
        near(found, authors, 3e-3);
        near(found, independent, 2e-5);
    }
    // With so many pieces it has come to its limit.
    let model = Truss::new(1, DEPTH).locked("ring-1");
    near(first(Pieces::new(&model, 16)), 582.13, 1e-5);
}

/// Struts that bow by 1 to 5 % of their length, each in a direction of its own: the mean of five frames, against the means of five of the
/// authors and of the independent program (2 %).
fn bowed(rings: i32, authors: [f64; 5], independent: [f64; 5]) {
    let truss = Truss::new(rings, DEPTH);
    let model = truss.locked(&format!("ring-{rings}"));
    let struts: Vec<_> =
        model.members.iter().map(|member| model.nodes[member.b.0] - model.nodes[member.a.0]).collect();
    for ((percent, authors), independent) in (1_u8..).zip(authors).zip(independent) {
        let of = |seed| first(Pieces::bowed(&model, BOWED, &bows(&struts, f64::from(percent) / 100.0, seed)));
        let mean = (0..5).map(of).sum::<f64>() / 5.0;
        near(mean, authors, 0.02);
        near(mean, independent, 0.02);
    }
}

#[test]
fn bowed_struts_of_one_ring() {
    bowed(1, [594.3, 578.2, 560.5, 518.8, 477.0], [591.1, 581.6, 554.5, 512.8, 468.7]);
}

#[test]
fn bowed_struts_of_three_rings() {
    bowed(3, [524.4, 393.2, 297.0, 235.0, 193.1], [533.8, 393.9, 299.0, 237.1, 195.1]);
}
