//! Bends whose peg meets wire that was bent before: compensated as if the leg were straight they come out wrong, with the
//! wire as it is they do not. The bench marches; what compensates has formulas.

use wirebend_core::bend::Step;
use wirebend_core::compensate::{
    BendModel, Compensation, FeedModel, MotionModel, PegGeometry, Springback, ToldStep, approaches,
    compensate,
};
use wirebend_core::schedule::ScheduledProgram;
use wirebend_core::units::{Angle, Length};
use wirebend_driver_wirebend_kit::bench::{Incident, Violation};

use crate::shop::Shop;

pub(crate) fn mm(value: f64) -> Length {
    Length::from_mm(value).unwrap()
}

pub(crate) fn deg(value: f64) -> Angle {
    Angle::from_deg(value).unwrap()
}

pub(crate) fn machine(loss: f64) -> Compensation {
    let peg = PegGeometry::new(mm(20.4), mm(12.0), mm(3.0), mm(4.675)).unwrap().with_peg_length(mm(26.0));
    Compensation {
        feed: Some(FeedModel::new(mm(1.5), mm(3.0), 0.3)),
        bend: BendModel {
            springback: Some(Springback::Constant(deg(loss))),
            setback: Some(peg),
            axis_limit: Some(deg(155.0)),
            before_zero: false,
        },
        motion: MotionModel::default(),
    }
}

/// Edges of 60 mm, then of `edge`, with a bend and a turn of the head after each.
pub(crate) fn program(edge: f64, bends: &[(f64, f64)]) -> ScheduledProgram {
    let feed = |k: usize| mm(if k == 0 { 60.0 } else { edge });
    let step = |(k, &(rotate, bend)): (usize, &(f64, f64))| Step {
        feed: feed(k),
        rotate: deg(rotate),
        bend: deg(bend),
    };
    let mut steps: Vec<Step> = bends.iter().enumerate().map(step).collect();
    steps.push(Step { feed: mm(60.0), rotate: Angle::ZERO, bend: Angle::ZERO });
    ScheduledProgram { head: vec![Angle::ZERO; steps.len()], steps }
}

/// How far each bend of a program is off, degrees, compensated so.
pub(crate) fn off(
    shop: &mut Shop,
    program: &ScheduledProgram,
    told: &[ToldStep],
    machine: &Compensation,
) -> Vec<f64> {
    let steps: Vec<Step> = told.iter().map(|told| told.step).collect();
    let bench = shop.bent(&steps, &approaches(told, machine));
    assert_eq!(bench.incidents(), []);
    let made = bench.made();
    let bends = program.steps.iter().filter(|step| step.bend != Angle::ZERO);
    bends.zip(made.bends()).map(|(step, bent)| bent.angle_deg - step.bend.deg()).collect()
}

/// The springback with which a bend on a straight leg comes out: what calibration gives.
fn loss_at(shop: &mut Shop, bend: f64) -> f64 {
    let lone = program(60.0, &[(0.0, bend)]);
    let mut loss = 10.23;
    for _ in 0..4 {
        let told = compensate(&lone, &machine(loss)).unwrap();
        loss -= off(shop, &lone, &told.told().collect::<Vec<_>>(), &machine(loss))[0];
    }
    loss
}

/// The largest error with the leg taken to be straight, and with the wire as it is.
fn both(edge: f64, bend: f64, bends: &[(f64, f64)]) -> [f64; 2] {
    let mut shop = Shop::exact();
    let machine = machine(loss_at(&mut shop, bend));
    let program = program(edge, bends);
    let as_formed: Vec<ToldStep> = compensate(&program, &machine).unwrap().told().collect();
    let straight: Vec<ToldStep> = as_formed
        .iter()
        .zip(&program.steps)
        .map(|(told, step)| Step { bend: machine.bend.command(step.bend).unwrap(), ..told.step }.into())
        .collect();
    [straight, as_formed].map(|told| {
        let off = off(&mut shop, &program, &told, &machine);
        println!("{edge} mm, {bends:?}: {off:.2?} degrees off");
        off.iter().fold(0.0, |most: f64, off| most.max(off.abs()))
    })
}

#[test]
fn six_bends_to_one_side_come_out_as_they_should() {
    let [straight, as_formed] = both(25.0, 30.0, &[(0.0, 30.0); 6]);
    assert!(straight > 1.0, "{straight}");
    assert!(as_formed <= 0.3, "{as_formed}");
}

/// Where the peg comes out for straight wire, wire that is bent towards it may be.
#[test]
fn the_peg_comes_out_beside_wire_that_is_bent_towards_it() {
    let machine = machine(10.23);
    let bends = [(0.0, 30.0), (0.0, -30.0), (0.0, 30.0), (0.0, -30.0)];
    let told = compensate(&program(22.0, &bends), &machine).unwrap();
    let mut shop = Shop::exact();
    let known = approaches(&told.told().collect::<Vec<_>>(), &machine);
    println!("comes out at {known:.2?}");
    assert_eq!(known[0], None, "nothing is bent yet");
    assert!(known[1..4].iter().all(Option::is_some), "{known:?}");
    // From there on the wire is another.
    let blind = shop.bent(told.steps(), &[None; 5]);
    assert!(
        matches!(blind.incidents()[..], [Incident { what: Violation::PegIntoWire { .. }, .. }, ..]),
        "{:?}",
        blind.incidents()
    );
    assert_eq!(shop.bent(told.steps(), &known).incidents(), []);
}

#[test]
fn bends_to_both_sides_and_in_several_planes_do_so_too() {
    for (edge, bends) in [
        (27.0, [(0.0, 30.0), (0.0, -30.0), (0.0, 30.0), (0.0, -30.0)]),
        (25.0, [(0.0, 30.0), (40.0, 30.0), (40.0, 30.0), (-60.0, 30.0)]),
    ] {
        let [straight, as_formed] = both(edge, 30.0, &bends);
        // The leg gives more where the peg holds it farther out, which no springback of the angle alone knows.
        assert!(straight > 1.5 && as_formed <= 0.4, "{straight}, {as_formed}");
    }
}
