//! Letting the wire go: what the peg has pushed since it came out becomes an arc.

use super::chain::Arc;
use super::incident::ModelWarning;
use super::machine::Bench;

impl Bench {
    /// Angle of the wire behind the nozzle in the plane of the head, radians. None where the wire is too
    /// short to meet the peg.
    pub(super) fn leg(&self) -> Option<f64> {
        let meets = !self.chain.is_straight() || self.chain.length() >= self.press.contact.clear_of_orbit();
        meets.then(|| self.chain.at_pin(self.head()).map_or(0.0, |arc| arc.turn))
    }

    /// Bends the wire as far as the peg has pushed it, and lets it spring back.
    pub(super) fn let_go(&mut self) {
        let Some(mut stroke) = self.stroke else { return };
        let placed = self.press.contact.leg_angle(self.axis(stroke.furthest));
        let sign = stroke.sign();
        stroke.furthest = i64::from(stroke.side) * self.bend_steps();
        self.stroke = Some(stroke);
        let leg = self.leg();
        if placed <= sign * leg.unwrap_or(0.0) {
            return;
        }
        let bend = self.presses;
        self.presses += 1;
        if leg.is_none() {
            let (out_mm, needed_mm) = (self.chain.length(), self.press.contact.clear_of_orbit());
            self.doubts.push(ModelWarning::PegPastTip { bend, out_mm, needed_mm });
            self.mark();
            return;
        }
        if placed >= std::f64::consts::PI {
            self.doubts.push(ModelWarning::PastFoldBack { bend });
        }
        self.press(bend, sign, placed);
        let contact_mm = self.press.leg(placed);
        let straight_mm = self.chain.straight_behind_arc();
        if contact_mm > straight_mm + 1e-9 {
            self.doubts.push(ModelWarning::ShortLeg { bend, contact_mm, straight_mm });
        }
    }

    fn press(&mut self, bend: usize, sign: f64, placed: f64) {
        let wrapped = self.press.wrapped(placed);
        let at_pin = self.chain.at_pin(self.head()).filter(|arc| arc.fibre > 0.0);
        let at_pin = at_pin.map(|arc| Arc { turn: sign * arc.turn, ..arc });
        let (wanted, same_bend) = match at_pin {
            // What there is of a bend already only gives.
            Some(arc) if wrapped <= arc.turn => return,
            Some(arc) => {
                let shared = if arc.turn >= 0.0 { self.chain.tail + arc.fibre } else { 0.0 };
                (self.fibre_onto(&arc, wrapped), shared)
            }
            None if wrapped <= 0.0 => return self.mark(),
            None => (self.press.fibre(wrapped), 0.0),
        };
        let own = self.chain.take(wanted.min(same_bend));
        let more = self.chain.take(wanted - own.fibre);
        if more.was_bent {
            self.doubts.push(ModelWarning::BendOverBend { bend });
        }
        let fibre = own.fibre + more.fibre;
        let stays = sign * self.press.released(self.press.angle_of(fibre));
        let error = match &mut self.draws {
            Some(draws) if stays != 0.0 => draws.bend_deg.next().to_radians(),
            _ => 0.0,
        };
        self.chain.put(Arc { turn: stays + error, fibre, head: self.head() });
    }

    /// How much of the wire before the nozzle, which is straight and then in an arc, has to be wrapped
    /// until it stands at `wrapped` altogether, which is more than the arc does by itself.
    fn fibre_onto(&self, arc: &Arc, wrapped: f64) -> f64 {
        let straight = self.chain.tail;
        let turn_of_straight = self.press.angle_of(straight);
        if turn_of_straight + arc.turn >= wrapped {
            return self.press.fibre(wrapped - arc.turn);
        }
        if self.press.angle_of(straight + arc.fibre) <= wrapped {
            return self.press.fibre(wrapped);
        }
        // From here each length that is wrapped loses the turn that it had.
        let gained = self.press.angle_of(1.0) - arc.turn / arc.fibre;
        straight + (wrapped - turn_of_straight - arc.turn) / gained
    }

    /// A press of which nothing stays. It is a bend of 0 degrees, so that the next ones keep their numbers.
    fn mark(&mut self) {
        let head = self.head();
        self.chain.mark(head);
    }
}
