//! Tables as programs for bending keep them: how far the pin was moved, and what the wire made of it.

use wirebend_error::ErrorRemedy;

use super::super::error::{Location, ReadError};
use super::super::text::Source;
use super::Table;
use crate::encoding::decode;

/// A bend of such a table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PinPair {
    /// Its line, from 1.
    pub line: usize,
    /// Where the pin went, degrees from where it is on the axis of the wire.
    pub pin_deg: f64,
    /// The bend that stayed, degrees, signed as its side. A small bend may stay while the pin is still before zero.
    pub left_deg: f64,
}

/// What the second column says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Says {
    /// The bend that stayed.
    Left,
    /// What the wire took back.
    Loss,
}

const PIN: [&str; 2] = ["pin", "axis"];
/// Of the pin where nothing else is, and else of the wire.
const ANGLE: [&str; 2] = ["bend", "angle"];
const LEFT: [&str; 6] = ["left", "stayed", "stays", "formed", "result", "after"];
const LOSS: [&str; 3] = ["loss", "lost", "taken"];
/// Some say so of what stays, some of what is lost.
const EITHER: [&str; 2] = ["springback", "spring"];
/// From so many degrees on a wire keeps the most of a bend, and no pin is still before zero.
const FAR_DEG: f64 = 30.0;
/// Less than the first share of the pin's angle is lost, more than the second has stayed.
const SHARES: [f64; 2] = [0.4, 0.6];

/// Reads a table of pin angles: in the second column, or as a header line names them, the bend that stayed or what the wire took back.
/// Where no name says which, the figures do: a wire keeps the most of a large bend. A pair of which one is missing is none, and neither
/// is one that left no bend: there the pin touches the wire. A loss counts to the side of the pin: below zero more stayed than the pin moved.
///
/// # Errors
/// [`ReadError`] with the line of what is no number, where there is no pair, and where nothing says what the second column is.
pub fn pin_table(file: &str, bytes: &[u8]) -> Result<Vec<PinPair>, ReadError> {
    let source = Source { name: file };
    let text = decode(bytes);
    let table = Table::read(&text, source, 2)?;
    let (pin, second, says) = columns(&table);
    let pin_factor = table.degrees(source, Some(pin))?;
    let second_factor = table.degrees(source, Some(second))?;
    let mut rows = Vec::new();
    for (row, (line, _)) in table.rows.iter().enumerate() {
        let value = |column: usize| table.value(source, row, column);
        if let (Some(pin), Some(second)) = (value(pin)?, value(second)?) {
            rows.push((*line, pin * pin_factor, second * second_factor));
        }
    }
    let Some(&(first, ..)) = rows.first() else {
        let expected = "pair of pin angle and angle that stayed";
        return Err(ReadError::Empty { file: file.to_owned(), expected, but: String::new() });
    };
    let says = says.or_else(|| by_figures(&rows)).ok_or_else(|| ReadError::Syntax {
        file: file.to_owned(),
        place: Location::Line(first),
        found: "two columns of angles".to_owned(),
        expected: "a line above them that names them: `pin, left` where the second is the bend that stayed, `pin, loss` where it is \
            what the wire took back"
            .into(),
        remedy: Box::new(ErrorRemedy::CorrectFile),
    })?;
    // A table that goes far to both sides has the side in the sign of the pin.
    let both_sides = rows.iter().any(|(_, pin, _)| *pin < -FAR_DEG);
    let pairs = rows.into_iter().map(|(line, pin_deg, second)| {
        let left_deg = match says {
            Says::Left if both_sides => second.abs() * pin_deg.signum(),
            Says::Left => second,
            Says::Loss => kept_deg(pin_deg, second, both_sides),
        };
        PinPair { line, pin_deg, left_deg }
    });
    Ok(pairs.filter(|pair| pair.left_deg != 0.0).collect())
}

/// Where the pin stands, what became of it, and what that is as far as its name says so. A table with a pin has its angle there and the
/// wire's in another column, whatever the order.
fn columns(table: &Table<'_>) -> (usize, usize, Option<Says>) {
    let said = |names: &[&str], says| table.column(names).map(|column| (column, says));
    let second = said(&LEFT, Some(Says::Left))
        .or_else(|| said(&LOSS, Some(Says::Loss)))
        .or_else(|| said(&EITHER, None));
    let pin = table.column(&PIN).or_else(|| table.column(&ANGLE));
    let pin = pin.unwrap_or_else(|| usize::from(second.is_some_and(|(column, _)| column == 0)));
    let is_angle = |name: &str| ANGLE.contains(&name);
    let mut named = table.header.iter().flatten().enumerate();
    let other = named.find(|(column, named)| *column != pin && is_angle(&named.name));
    let other = other.map_or(usize::from(pin == 0), |(column, _)| column);
    let (second, says) = second.unwrap_or((other, None));
    (pin, second, says)
}

/// The bend that stayed, where the wire took back so much; 0 where that is all. A loss below zero is a gain: more stayed than the pin
/// moved. That of a pin to the other side may be written with either sign; but of one that is before zero, in a table that goes to one
/// side, the wire may keep a bend to that side.
fn kept_deg(pin_deg: f64, loss_deg: f64, both_sides: bool) -> f64 {
    if pin_deg >= 0.0 {
        return (pin_deg - loss_deg).max(0.0);
    }
    let kept_deg = pin_deg.abs() - loss_deg.abs();
    let before_zero = loss_deg < 0.0 && !both_sides;
    if kept_deg > 0.0 || before_zero { -kept_deg } else { 0.0 }
}

/// What the second column says, by how much of the pin's angle it is where that is large; none where that is not clear.
fn by_figures(rows: &[(usize, f64, f64)]) -> Option<Says> {
    let far = rows.iter().filter(|(_, pin, _)| pin.abs() >= FAR_DEG);
    let mut shares: Vec<f64> = far.map(|(_, pin, second)| (second / pin).abs()).collect();
    shares.sort_by(f64::total_cmp);
    let share = *shares.get(shares.len() / 2)?;
    if share < SHARES[0] {
        return Some(Says::Loss);
    }
    (share > SHARES[1]).then_some(Says::Left)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pairs(text: &str) -> Vec<(f64, f64)> {
        let pairs = pin_table("t", text.as_bytes()).unwrap();
        pairs.into_iter().map(|PinPair { pin_deg, left_deg, .. }| (pin_deg, left_deg)).collect()
    }

    #[test]
    fn what_is_lost_is_read_in_either_order() {
        assert_eq!(pairs("20 5.5\n40 6\n60\n"), [(20.0, 14.5), (40.0, 34.0)]);
        assert_eq!(pairs("springback_angle,pin_angle\n5.5,-20\n6,40\n"), [(-20.0, -14.5), (40.0, 34.0)]);
        assert_eq!(pairs("pin,loss\n20,5.5\n"), [(20.0, 14.5)]);
        assert_eq!(pairs("pin_gon,loss_deg\n\"40,0\",\"5,5\"\n"), [(36.0, 30.5)]);
        let lines: Vec<usize> =
            pin_table("t", b"pin,left\n9,1\n\n10,2\n").unwrap().iter().map(|pair| pair.line).collect();
        assert_eq!(lines, [2, 4]);
    }

    /// The beginning of a table of others: see `crates/core/tests/data/bending-tables`.
    #[test]
    fn what_stayed_is_known_by_its_size_and_may_stay_before_zero() {
        let galvanized = "-19.47,0\n-15,2.58\n-10,7.563\n0,19.601\n35,74.679\n45,92.669\n";
        let stayed = [(-15.0, 2.58), (-10.0, 7.563), (0.0, 19.601), (35.0, 74.679), (45.0, 92.669)];
        assert_eq!(pairs(galvanized), stayed);
        assert_eq!(pairs("pin;left\n-15;2,58\n"), [(-15.0, 2.58)]);
    }

    #[test]
    fn the_sign_of_the_pin_is_the_side_where_the_table_goes_far_to_both() {
        assert_eq!(pairs("-60,55\n-20,14\n60,56\n"), [(-60.0, -55.0), (-20.0, -14.0), (60.0, 56.0)]);
    }

    /// As programs that look a pin angle up by the bend keep it: the bend first.
    #[test]
    fn the_pin_is_the_column_that_says_so_in_any_order() {
        let stayed = [(32.9, 20.0), (60.0, 40.0)];
        assert_eq!(pairs("angle,pin\n20,32.9\n40,60.0\n"), stayed);
        assert_eq!(pairs("bend angle,pin angle\n20,32.9\n40,60.0\n"), stayed);
        assert_eq!(pairs("no,pin,angle\n1,32.9,20\n2,60,40\n"), stayed);
        assert_eq!(pairs("bend;left\n32,9;20\n60;40\n"), stayed);
        assert_eq!(pairs("angle,axis,loss\n0,20,5.5\n"), [(20.0, 14.5)]);
    }

    /// A peg that stands off the wire bends it farther than it goes itself: with a loss of -22.395 degrees 5 become 27.395.
    #[test]
    fn more_may_stay_than_the_pin_moved_and_never_a_bend_to_the_other_side() {
        assert_eq!(pairs("pin,loss\n5,-22.395\n40,6\n"), [(5.0, 27.395), (40.0, 34.0)]);
        assert_eq!(pairs("pin,loss\n0,-2.5\n"), [(0.0, 2.5)]);
        // As large a loss as the pin's angle leaves nothing, and a larger one no more.
        assert_eq!(pairs("pin,loss\n4,4\n4,5\n-4,5\n40,6\n"), [(40.0, 34.0)]);
        assert_eq!(pairs("pin,loss\n-40,-6\n-60,8\n-4,-5\n"), [(-40.0, -34.0), (-60.0, -52.0)]);
        // Before zero: -15 degrees less what stayed, 2.5.
        assert_eq!(pairs("pin,loss\n-15,-17.5\n40,6\n"), [(-15.0, 2.5), (40.0, 34.0)]);
    }

    #[test]
    fn a_table_that_may_be_either_is_refused_with_what_would_help() {
        for unclear in ["10,5\n20,9\n", "40,20\n60,30\n"] {
            let refused = pin_table("pins.csv", unclear.as_bytes()).unwrap_err().to_string();
            assert!(refused.contains("pins.csv, line 1") && refused.contains("`pin, left`"), "{refused}");
        }
        assert!(pin_table("t", b"nothing\n").is_err());
    }
}
