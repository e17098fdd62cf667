//! Several pieces of the same, one after the other, and the wire that they are bent from.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::units::Mm;
use wirebend_driver_host::jobs::Piece;
use wirebend_files::document::JobWire;
use wirebend_planning::PlanningError;

/// More pieces in a row nobody watches.
const MAX_PIECES: u32 = 10_000;

/// Lengths are printed to so many mm.
const PRINTED_MM: f64 = 0.1;

/// How many pieces are bent in a row, and from how much wire.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Repeat {
    pub pieces: u32,
    /// Length of the wire that is loaded, mm: as long as it suffices, no new wire is asked for. Absent, it is not known.
    #[serde(default)]
    pub stock_mm: Option<f64>,
    /// Whether the machine cuts each piece off. As long as the wire that is loaded suffices, the next one is bent without a question.
    #[serde(default)]
    pub cut: bool,
}

impl Default for Repeat {
    fn default() -> Self {
        Self { pieces: 1, stock_mm: None, cut: false }
    }
}

/// How far they are.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct PiecesReport {
    /// How many came to their end.
    pub made: u32,
    /// How many there were to be.
    pub of: u32,
    /// Wire that is left, mm; null where it is not known.
    pub stock_left_mm: Option<f64>,
}

/// Which piece is bent, and how much wire is left.
#[derive(Debug, Clone, Copy, Default)]
pub struct Pieces {
    repeat: Repeat,
    /// How many came to their end.
    made: u32,
    /// Whether something was bent before this wire, of which it has to be cut off.
    follows: bool,
    left_mm: Option<f64>,
    /// Where the cutter of the machine is, mm, if it has one.
    cutter_mm: Option<f64>,
}

impl Pieces {
    /// # Errors
    /// [`PlanningError::Value`] for numbers that make no sense.
    pub fn new(repeat: Repeat) -> Result<Self, PlanningError> {
        let wrong =
            |name, value: String, expected| PlanningError::Value { input: None, name, value, expected };
        if !(1..=MAX_PIECES).contains(&repeat.pieces) {
            let expected = "a whole number from 1 to 10000";
            return Err(wrong("the number of pieces", repeat.pieces.to_string(), expected));
        }
        if let Some(mm) = repeat.stock_mm.filter(|mm| !mm.is_finite() || *mm <= 0.0) {
            return Err(wrong("the length of the wire", mm.to_string(), "a length above 0 mm"));
        }
        Ok(Self { repeat, left_mm: repeat.stock_mm, ..Self::default() })
    }

    /// Refuses wire that does not suffice for one piece even when it is new.
    pub fn require_enough(&self, wire: &JobWire) -> Result<(), PlanningError> {
        match self.repeat.stock_mm {
            // A plan prints what is needed to a tenth.
            Some(mm) if mm < self.needed_mm(wire) - PRINTED_MM / 2.0 => Err(PlanningError::Value {
                input: None,
                name: "the length of the wire",
                value: format!("{mm:.1} mm of the {:.1} that one piece needs", Mm(self.needed_mm(wire))),
                expected: "the stock of one piece at least, with its unusable tail",
            }),
            _ => Ok(()),
        }
    }

    /// Which piece it is, where there are several.
    pub fn piece(&self) -> Option<Piece> {
        let of = self.repeat.pieces;
        (of > 1).then(|| Piece { number: (self.made + 1).min(of), of })
    }

    /// Whether a wire was bent before this one in the same row.
    pub const fn follows(&self) -> bool {
        self.follows
    }

    /// Wire that is left, mm.
    pub const fn left_mm(&self) -> Option<f64> {
        self.left_mm
    }

    pub const fn report(&self) -> PiecesReport {
        PiecesReport { made: self.made, of: self.repeat.pieces, stock_left_mm: self.left_mm }
    }

    /// A wire of so many mm came to its end.
    pub fn wire_made(&mut self, fed_mm: f64) {
        self.wire_fed(fed_mm);
        self.follows = true;
    }

    /// So many mm were fed of a wire that is in the machine.
    pub fn wire_fed(&mut self, fed_mm: f64) {
        self.left_mm = self.left_mm.map(|left| (left - fed_mm).max(0.0));
    }

    /// The last wire of a piece came to its end.
    pub const fn piece_made(&mut self) {
        self.made += 1;
    }

    /// A person has said that what was asked for this wire is so: where new wire was needed, it is loaded.
    pub fn confirmed(&mut self, wire: &JobWire) {
        if self.suffices(wire) == Some(false) {
            self.left_mm = self.repeat.stock_mm;
        }
    }

    /// The machine is known.
    pub const fn with_cutter(self, cutter_mm: Option<f64>) -> Self {
        Self { cutter_mm, ..self }
    }

    /// Where the cutter is, mm, if each piece is cut off by it.
    pub const fn cut_at_mm(&self) -> Option<f64> {
        if self.repeat.cut { self.cutter_mm } else { None }
    }

    /// Whether the next wire is bent without a question.
    pub fn goes_on(&self, wire: &JobWire) -> bool {
        self.follows && self.cut_at_mm().is_some() && self.suffices(wire) == Some(true)
    }

    /// Whether the wire that is left suffices; nothing where its length is not known.
    fn suffices(&self, wire: &JobWire) -> Option<bool> {
        self.left_mm.map(|left| left >= self.needed_mm(wire) - PRINTED_MM / 2.0)
    }

    /// Wire that has to be there, mm, with what cannot be fed. To a cutter outside of the machine it is fed farther.
    fn needed_mm(&self, wire: &JobWire) -> f64 {
        wire.stock_mm + self.cut_at_mm().unwrap_or_default().max(0.0)
    }

    /// What to see to before a wire of a material is bent, of which so many mm are fed.
    pub fn lines(&self, material: &str, wire: &JobWire, fed: f64) -> Vec<String> {
        let mut lines = Vec::new();
        if let Some(Piece { number, of }) = self.piece() {
            lines.push(format!("piece {number} of {of}"));
        }
        let follows = self.follows && (self.piece().is_some() || self.left_mm.is_some());
        match (self.cut_at_mm(), self.cutter_mm) {
            (Some(_), _) if self.follows => {}
            (Some(mm), _) => lines.extend(cutter_lines(mm, self.repeat)),
            (None, None) if follows => {
                lines.push(
                    "cut off what was bent before and take it out: this machine does not cut".to_owned(),
                );
            }
            (None, _) if follows => lines.push("cut off what was bent before and take it out".to_owned()),
            (None, _) => {}
        }
        match (self.suffices(wire), self.left_mm) {
            (Some(true), Some(left)) => lines.push(format!(
                "{:.0} of {} are loaded, and {:.0} are left after it",
                Mm(left),
                material,
                Mm(left - fed)
            )),
            (Some(false), Some(left)) => lines.push(format!(
                "load new wire, {:.0} of {}: the {:.0} that are left do not suffice for the {:.0} of this one",
                Mm(self.repeat.stock_mm.unwrap_or_default()),
                material,
                Mm(left),
                Mm(self.needed_mm(wire).ceil())
            )),
            _ => lines.push(format!(
                "load at least {:.0} of {} (includes {:.0} unusable tail)",
                Mm(self.needed_mm(wire).ceil()),
                material,
                Mm(self.needed_mm(wire) - fed)
            )),
        }
        lines
    }

    /// What is asked before a wire that follows another one.
    pub fn question(&self, wire: &JobWire) -> &'static str {
        match (self.suffices(wire), self.piece()) {
            (Some(false), _) if self.cut_at_mm().is_some() => "Is new wire loaded, and may the machine move?",
            _ if self.cut_at_mm().is_some() => "Is there wire for this one, and may the machine move?",
            (Some(true), _) => "Is what was bent before cut off and taken out, and may the machine move?",
            (Some(false), _) => {
                "Is what was bent before cut off and taken out, is new wire loaded, and may the machine move?"
            }
            (None, Some(_)) => {
                "Is the piece before cut off and taken out, is there wire for this one, and may the machine move?"
            }
            (None, None) => "Is the wire before taken out and new wire in, and may the machine move?",
        }
    }
}

/// What a person has to know of a cutter before it cuts.
fn cutter_lines(mm: f64, repeat: Repeat) -> Vec<String> {
    let place = if mm < 0.0 {
        format!("pulled back by {:.1}, to the cutter, and cut", Mm(-mm))
    } else if mm > 0.0 {
        format!("fed farther by {:.1}, to the cutter, and cut", Mm(mm))
    } else {
        "cut".to_owned()
    };
    let mut lines = vec![
        format!("after each piece the wire is {place}"),
        "keep hands away from the cutter, and see that what falls off it lies clear of the machine"
            .to_owned(),
    ];
    if repeat.pieces > 1 && repeat.stock_mm.is_some() {
        lines.push(
            "the next piece begins without a question, as long as the wire that is loaded suffices"
                .to_owned(),
        );
    }
    lines
}

#[cfg(test)]
mod tests {
    use wirebend_files::document::JobStep;

    use super::*;

    /// 200 mm are fed, and 400 mm cannot be.
    fn wire() -> JobWire {
        let step = JobStep { feed_mm: 200.0, ..JobStep::default() };
        JobWire {
            vertices: vec![0, 1],
            path_mm: vec![[0.0; 3], [200.0, 0.0, 0.0]],
            nominal: vec![step],
            spans: vec![[0, 1]],
            scheduled: vec![step],
            compensated: vec![step],
            stock_mm: 600.0,
            time_s: 1.0,
            avoids_collisions: false,
            clearance_mm: None,
            sag: false,
            pauses: Vec::new(),
        }
    }

    /// Were it asked for too late, a machine would run out of wire in the middle of a piece.
    #[test]
    fn new_wire_is_asked_for_when_the_tail_would_be_fed() {
        let wire = wire();
        let mut pieces = Pieces::new(Repeat { pieces: 5, stock_mm: Some(1000.0), cut: false }).unwrap();
        let mut asked = Vec::new();
        for _ in 0..5 {
            asked.push((pieces.suffices(&wire).unwrap(), pieces.left_mm.unwrap()));
            pieces.confirmed(&wire);
            pieces.wire_made(200.0);
            pieces.piece_made();
        }
        // 1000, 800 and 600 mm suffice for 600 mm; then there is new wire.
        let expected = [(true, 1000.0), (true, 800.0), (true, 600.0), (false, 400.0), (true, 800.0)];
        assert_eq!(asked, expected);
        let PiecesReport { made, of, stock_left_mm } = pieces.report();
        assert_eq!((made, of, stock_left_mm), (5, 5, Some(600.0)));
    }

    #[test]
    fn what_makes_no_sense_is_refused() {
        for (pieces, stock_mm) in [(0, None), (20_000, None), (2, Some(0.0)), (2, Some(f64::NAN))] {
            let repeat = Repeat { pieces, stock_mm, cut: false };
            assert!(Pieces::new(repeat).is_err(), "{pieces} {stock_mm:?}");
        }
        let short = Pieces::new(Repeat { pieces: 2, stock_mm: Some(599.0), cut: false }).unwrap();
        assert!(short.require_enough(&wire()).is_err());
        assert_eq!(Pieces::new(Repeat::default()).unwrap().piece(), None);
    }

    /// Wire that is fed to a cutter is there, and a person is asked for new wire alone.
    #[test]
    fn with_a_cutter_the_next_piece_waits_for_wire_alone() {
        let wire = wire();
        let repeat = Repeat { pieces: 5, stock_mm: Some(1000.0), cut: true };
        for (cutter_mm, asked) in [(-8.0, [3]), (0.0, [3]), (12.5, [2])] {
            let mut pieces = Pieces::new(repeat).unwrap().with_cutter(Some(cutter_mm));
            let mut found = Vec::new();
            assert!(!pieces.goes_on(&wire), "the first one");
            for n in 0..4 {
                if n > 0 && !pieces.goes_on(&wire) {
                    found.push(n);
                    pieces.confirmed(&wire);
                }
                pieces.wire_made(200.0);
                pieces.piece_made();
            }
            assert_eq!(found, asked, "{cutter_mm}");
        }
        let unknown = Repeat { stock_mm: None, ..repeat };
        let mut pieces = Pieces::new(unknown).unwrap().with_cutter(Some(0.0));
        pieces.wire_made(200.0);
        assert!(!pieces.goes_on(&wire), "nobody knows whether there is wire");
    }
}
