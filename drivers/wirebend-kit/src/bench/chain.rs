//! The wire as it is: straights and arcs from its tip to the nozzle, in lengths of the neutral fibre.

/// Turns of the head that are less than this apart bend in one plane: 0.5 degrees, about the spread of a
/// head that is told to stay. Radians.
const ONE_PLANE: f64 = 0.009;

/// A bend that was pressed, even where nothing of it stayed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Arc {
    /// What stayed of the bend, with the sign of the press. Radians.
    pub turn: f64,
    /// Neutral fibre in it.
    pub fibre: f64,
    /// How the head stood, radians.
    pub head: f64,
}

/// A straight and the arc behind it, on the side of the nozzle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Piece {
    pub straight: f64,
    pub arc: Arc,
}

/// The wire outside the nozzle.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Chain {
    pub pieces: Vec<Piece>,
    /// Straight wire before the nozzle.
    pub tail: f64,
}

/// What taking wire from the chain met.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Taken {
    /// Fibre that was found.
    pub fibre: f64,
    /// Whether some of it was bent.
    pub was_bent: bool,
}

impl Chain {
    /// Feeds wire out, or back where the length is negative. Returns how much more than the straight
    /// part was asked back: so much slips.
    pub fn feed(&mut self, length: f64) -> f64 {
        self.tail += length;
        let slipped = (-self.tail).max(0.0);
        self.tail = self.tail.max(0.0);
        slipped
    }

    /// Whether the wire is as straight as it came.
    pub fn is_straight(&self) -> bool {
        self.pieces.iter().all(|piece| piece.arc.turn == 0.0)
    }

    /// The last arc where it still is at the pin, with its turn as a head at `head` sees it: less was fed
    /// since than the arc itself takes, and it lies in the plane of that head.
    pub fn at_pin(&self, head: f64) -> Option<Arc> {
        let arc = self.pieces.last().map(|piece| piece.arc).filter(|arc| self.tail <= arc.fibre)?;
        let (sin, cos) = (head - arc.head).sin_cos();
        let turn = arc.turn * cos.signum();
        (sin.abs() < ONE_PLANE).then_some(Arc { turn, head, ..arc })
    }

    /// Takes so much fibre away, from the nozzle's side.
    pub fn take(&mut self, fibre: f64) -> Taken {
        let mut taken = Taken::default();
        loop {
            let wanted = fibre - taken.fibre;
            if self.tail >= wanted {
                self.tail -= wanted;
                return Taken { fibre, ..taken };
            }
            taken.fibre += self.tail;
            self.tail = 0.0;
            let Some(mut piece) = self.pieces.pop() else { return taken };
            let wanted = fibre - taken.fibre;
            taken.was_bent |= piece.arc.turn != 0.0;
            if piece.arc.fibre > wanted {
                piece.arc.turn *= 1.0 - wanted / piece.arc.fibre;
                piece.arc.fibre -= wanted;
                self.pieces.push(piece);
                return Taken { fibre, ..taken };
            }
            taken.fibre += piece.arc.fibre;
            self.tail = piece.straight;
        }
    }

    /// Puts an arc at the nozzle.
    pub fn put(&mut self, arc: Arc) {
        self.pieces.push(Piece { straight: self.tail, arc });
        self.tail = 0.0;
    }

    /// Puts a bend of nothing at the nozzle, where there is none yet.
    pub fn mark(&mut self, head: f64) {
        if self.tail > 0.0 || self.pieces.is_empty() {
            self.put(Arc { turn: 0.0, fibre: 0.0, head });
        }
    }

    /// Straight wire behind the arc at the nozzle.
    pub fn straight_behind_arc(&self) -> f64 {
        let straights = self.pieces.iter().rev().map(|piece| piece.straight);
        [self.tail].into_iter().chain(straights).find(|straight| *straight > 0.0).unwrap_or(0.0)
    }

    /// Wire outside the nozzle.
    pub fn length(&self) -> f64 {
        self.pieces.iter().map(|piece| piece.straight + piece.arc.fibre).sum::<f64>() + self.tail
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bent() -> Chain {
        let arc = Arc { turn: 1.0, fibre: 4.0, head: 0.0 };
        Chain { pieces: vec![Piece { straight: 30.0, arc }], tail: 1.0 }
    }

    #[test]
    fn wire_that_is_taken_is_straight_first_then_the_arc_then_what_is_behind_it() {
        let mut chain = bent();
        assert_eq!(chain.take(0.5), Taken { fibre: 0.5, was_bent: false });
        assert_eq!(chain.take(1.5), Taken { fibre: 1.5, was_bent: true });
        assert_eq!(chain.pieces[0].arc, Arc { turn: 0.75, fibre: 3.0, head: 0.0 });
        assert_eq!(chain.take(10.0), Taken { fibre: 10.0, was_bent: true });
        assert_eq!(chain, Chain { pieces: vec![], tail: 23.0 });
        assert_eq!(chain.take(40.0), Taken { fibre: 23.0, was_bent: false });
        assert_eq!(chain, Chain::default());
    }

    #[test]
    fn wire_can_be_fed_back_up_to_the_arc() {
        let mut chain = bent();
        assert!(chain.feed(-0.75) == 0.0 && (chain.tail - 0.25).abs() < 1e-12);
        assert!((chain.feed(-2.0) - 1.75).abs() < 1e-12);
        assert!((chain.length() - 34.0).abs() < 1e-12);
    }

    #[test]
    fn an_arc_is_seen_by_a_head_in_its_plane_only() {
        let turn = |head: f64| bent().at_pin(head.to_radians()).map(|arc| arc.turn);
        assert_eq!(turn(0.0), Some(1.0));
        assert_eq!(turn(180.0), Some(-1.0));
        assert_eq!(turn(-360.0), Some(1.0));
        assert_eq!(turn(90.0), None);
        let mut fed_on = bent();
        fed_on.feed(3.1);
        assert_eq!(fed_on.at_pin(0.0), None);
    }
}
