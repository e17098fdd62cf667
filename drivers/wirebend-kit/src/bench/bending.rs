//! Letting the wire go: what the peg has pushed since it came out becomes an arc.

use super::chain::Arc;
use super::formed::{Formed, Held, Met};
use super::incident::ModelWarning;
use super::machine::{Bench, Stroke};

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
        let sign = stroke.sign();
        let axis = self.axis(stroke.furthest);
        let met = self.met(&stroke, axis);
        stroke.furthest = i64::from(stroke.side) * self.bend_steps();
        self.stroke = Some(stroke);
        let leg = self.leg();
        let bend = self.presses;
        let Met::Held(Held { leg: placed, arm: contact_mm }) = met else {
            // On straight wire it would be a bend.
            let is_meant = self.press.contact.leg_angle(axis) > sign * leg.unwrap_or(0.0);
            if is_meant && matches!(met, Met::Past) {
                self.presses += 1;
                self.doubts.push(self.past(bend, leg.is_none()));
                self.mark();
            }
            return;
        };
        if placed <= sign * leg.unwrap_or(0.0) {
            return;
        }
        self.presses += 1;
        if placed >= std::f64::consts::PI {
            self.doubts.push(ModelWarning::PastFoldBack { bend });
        }
        self.press(bend, sign, placed, contact_mm);
        let straight_mm = self.chain.straight_behind_arc();
        if contact_mm > straight_mm + 1e-9 {
            self.doubts.push(ModelWarning::ShortLeg { bend, contact_mm, straight_mm });
        }
    }

    /// Why the peg bends nothing: it goes past the wire, which ends or is bent out of its way.
    fn past(&self, bend: usize, ends: bool) -> ModelWarning {
        if ends {
            let (out_mm, needed_mm) = (self.chain.length(), self.press.contact.clear_of_orbit());
            ModelWarning::PegPastTip { bend, out_mm, needed_mm }
        } else {
            ModelWarning::PegPastBend { bend, straight_mm: self.chain.straight_behind_arc() }
        }
    }

    /// What the peg does to the wire with the axis at a place towards the side that it bends to, radians.
    pub(super) fn met(&self, stroke: &Stroke, axis: f64) -> Met {
        let leg = stroke.sign() * self.leg().unwrap_or(0.0);
        let contact = &self.press.contact;
        let wrapped = |leg: f64| self.press.fibre(self.press.wrapped(leg));
        self.formed(stroke).map_or_else(
            || {
                let placed = contact.leg_angle(axis);
                Met::Held(Held { leg: placed, arm: self.press.leg(placed) })
            },
            |formed| {
                let given = |placed: f64| self.press.held(placed);
                formed.held(contact, leg, [self.axis(stroke.from), axis], wrapped, given)
            },
        )
    }

    /// The wire within the peg's reach, where it is bent there.
    fn formed(&self, stroke: &Stroke) -> Option<Formed> {
        Formed::beyond(&self.chain, &self.press.contact, self.head(), stroke.sign(), self.press.off_centre())
    }

    /// Whether the peg comes out where wire is that is bent within its reach.
    pub(super) fn comes_into_formed(&self, stroke: &Stroke) -> bool {
        let leg = stroke.sign() * self.leg().unwrap_or(0.0);
        let wrapped = self.press.fibre(self.press.wrapped(leg));
        let overlaps =
            |formed: Formed| formed.overlaps(&self.press.contact, leg, self.axis(stroke.from), wrapped);
        self.formed(stroke).is_some_and(overlaps)
    }

    fn press(&mut self, bend: usize, sign: f64, placed: f64, arm: f64) {
        let wrapped = self.press.wrapped_by(placed, arm);
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
