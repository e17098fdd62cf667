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
/// is one that left no bend: there the pin touches the wire.
///
/// # Errors
/// [`ReadError`] with the line of what is no number, where there is no pair, and where nothing says what the second column is.
pub fn pin_table(file: &str, bytes: &[u8]) -> Result<Vec<PinPair>, ReadError> {
    let source = Source { name: file };
    let text = decode(bytes);
    let table = Table::read(&text, source, 2)?;
    let named = |names: &[&str], says| table.column(names).map(|column| (column, says));
    let named = named(&LEFT, Some(Says::Left)).or_else(|| named(&LOSS, Some(Says::Loss)));
    let (second, says) = named.or_else(|| Some((table.column(&EITHER)?, None))).unwrap_or((1, None));
    let pin = table.column(&["pin", "bend", "angle", "axis"]).unwrap_or(usize::from(second == 0));
    let mut rows = Vec::new();
    for (row, (line, _)) in table.rows.iter().enumerate() {
        let value = |column: usize| {
            let value = table.value(source, row, column)?;
            Ok::<_, ReadError>(value.map(|value| value * table.degrees(Some(column))))
        };
        if let (Some(pin), Some(second)) = (value(pin)?, value(second)?) {
            rows.push((*line, pin, second));
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
        let size = match says {
            Says::Left => second.abs(),
            Says::Loss => pin_deg.abs() - second.abs(),
        };
        let by_pin = says == Says::Loss || both_sides;
        let side = if by_pin { pin_deg.signum() } else { second.signum() };
        PinPair { line, pin_deg, left_deg: side * size }
    });
    Ok(pairs.filter(|pair| pair.left_deg != 0.0).collect())
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

    #[test]
    fn a_table_that_may_be_either_is_refused_with_what_would_help() {
        for unclear in ["10,5\n20,9\n", "40,20\n60,30\n"] {
            let refused = pin_table("pins.csv", unclear.as_bytes()).unwrap_err().to_string();
            assert!(refused.contains("pins.csv, line 1") && refused.contains("`pin, left`"), "{refused}");
        }
        assert!(pin_table("t", b"nothing\n").is_err());
    }
}
