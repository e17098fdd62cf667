//! Lengths and angles that are always finite.
//!
//! Millimetres and degrees at every edge of the program, radians only inside this crate. A value
//! of these types is never NaN and never infinite, so comparisons are total and a wrong number is
//! caught where it enters.

use std::cell::Cell;
use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, AddAssign, Neg, Sub, SubAssign};

/// A number that was expected to be finite was NaN or infinite.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("{value} is not a finite number of {unit}")]
pub struct NotFinite {
    /// The offending value.
    pub value: f64,
    /// What it would have measured, in plural: "millimetres", "degrees", "radians".
    pub unit: &'static str,
}

/// Arithmetic on finite numbers can only leave the finite range by overflow; there it saturates.
const fn saturate(value: f64) -> f64 {
    value.clamp(f64::MIN, f64::MAX)
}

macro_rules! quantity {
    ($name:ident) => {
        impl $name {
            /// Zero.
            pub const ZERO: Self = Self(0.0);

            /// The absolute value.
            #[must_use]
            pub const fn abs(self) -> Self {
                Self(self.0.abs())
            }

            /// -1, 0 or 1.
            #[must_use]
            pub fn signum(self) -> f64 {
                if self.0 == 0.0 { 0.0 } else { self.0.signum() }
            }

            /// The smaller of two values.
            #[must_use]
            pub const fn min(self, other: Self) -> Self {
                Self(self.0.min(other.0))
            }

            /// The larger of two values.
            #[must_use]
            pub const fn max(self, other: Self) -> Self {
                Self(self.0.max(other.0))
            }

            /// Whole multiples (saturates at the largest finite number).
            #[must_use]
            pub fn times(self, count: i32) -> Self {
                Self(saturate(self.0 * f64::from(count)))
            }
        }

        impl Add for $name {
            type Output = Self;
            fn add(self, other: Self) -> Self {
                Self(saturate(self.0 + other.0))
            }
        }

        impl Sub for $name {
            type Output = Self;
            fn sub(self, other: Self) -> Self {
                Self(saturate(self.0 - other.0))
            }
        }

        impl Neg for $name {
            type Output = Self;
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }

        impl AddAssign for $name {
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }

        impl SubAssign for $name {
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }

        impl std::iter::Sum for $name {
            fn sum<I: Iterator<Item = Self>>(items: I) -> Self {
                items.fold(Self::ZERO, Add::add)
            }
        }

        impl Eq for $name {}

        impl PartialOrd for $name {
            fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
                Some(self.cmp(other))
            }
        }

        impl Ord for $name {
            fn cmp(&self, other: &Self) -> Ordering {
                // Finite numbers are totally ordered; `-0.0` equals `0.0`.
                self.0.partial_cmp(&other.0).unwrap_or(Ordering::Equal)
            }
        }
    };
}

/// A length in millimetres; finite.
///
/// ```
/// use wirebend_core::units::Length;
/// let strut = Length::from_mm(30.0)?;
/// assert_eq!((strut + strut).mm(), 60.0);
/// assert!(Length::from_mm(f64::NAN).is_err());
/// # Ok::<(), wirebend_core::units::NotFinite>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Length(f64);

quantity!(Length);

impl Length {
    /// A length from millimetres.
    ///
    /// # Errors
    /// [`NotFinite`] for NaN and infinities.
    pub const fn from_mm(mm: f64) -> Result<Self, NotFinite> {
        if mm.is_finite() { Ok(Self(mm)) } else { Err(NotFinite { value: mm, unit: "millimetres" }) }
    }

    /// A length from a number that arithmetic on finite numbers gave (overflow saturates, and NaN,
    /// which such arithmetic cannot give, becomes zero). What comes from outside goes through [`Length::from_mm`].
    #[must_use]
    pub const fn computed(mm: f64) -> Self {
        if mm.is_nan() { Self(0.0) } else { Self(saturate(mm)) }
    }

    /// Millimetres.
    #[must_use]
    pub const fn mm(self) -> f64 {
        self.0
    }
}

impl fmt::Display for Length {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:.*}", f.precision().unwrap_or(1), Mm(self.0))
    }
}

/// What lengths are written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum DisplayUnit {
    /// Millimetres: everywhere but in [`written_in`].
    #[default]
    Millimetre,
    /// Inches of 25.4 mm.
    Inch,
}

const MM_PER_INCH: f64 = 25.4;
/// The digits behind the point that a figure in inches has at least, and at most.
const MIN_DIGITS: usize = 3;
const MAX_DIGITS: usize = 9;

thread_local! {
    static WRITTEN_IN: Cell<fn() -> DisplayUnit> = const { Cell::new(|| DisplayUnit::Millimetre) };
}

/// Runs `write`; on this thread, and until it returns, [`Length`] and [`Mm`] are written in `unit`.
///
/// ```
/// use wirebend_core::units::{DisplayUnit, Length, written_in};
/// let strut = Length::from_mm(25.4)?;
/// assert_eq!(strut.to_string(), "25.4 mm");
/// assert_eq!(written_in(|| DisplayUnit::Inch, || strut.to_string()), "1.000 in");
/// # Ok::<(), wirebend_core::units::NotFinite>(())
/// ```
pub fn written_in<T>(unit: fn() -> DisplayUnit, write: impl FnOnce() -> T) -> T {
    struct Before(fn() -> DisplayUnit);
    impl Drop for Before {
        fn drop(&mut self) {
            WRITTEN_IN.set(self.0);
        }
    }
    let _before = Before(WRITTEN_IN.replace(unit));
    write()
}

/// Millimetres as text, where they are a plain number: with the digits that are asked for, else with as many as they need; in
/// inches with three that count.
#[derive(Debug, Clone, Copy)]
pub struct Mm(pub f64);

impl fmt::Display for Mm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (WRITTEN_IN.get()(), f.precision()) {
            (DisplayUnit::Millimetre, Some(digits)) => write!(f, "{:.digits$} mm", self.0),
            (DisplayUnit::Millimetre, None) => write!(f, "{} mm", self.0),
            // An inch is long: with two digits more no less is told.
            (DisplayUnit::Inch, Some(digits)) => {
                write!(f, "{:.*} in", (digits + 2).max(MIN_DIGITS), self.0 / MM_PER_INCH)
            }
            (DisplayUnit::Inch, None) => {
                // Three digits that count of what is small.
                let (inches, mut digits, mut least) = (self.0 / MM_PER_INCH, MIN_DIGITS, 0.1);
                while inches != 0.0 && inches.abs() < least && digits < MAX_DIGITS {
                    (digits, least) = (digits + 1, least / 10.0);
                }
                write!(f, "{inches:.digits$} in")
            }
        }
    }
}

/// An angle, stored in radians; finite. Right-handed about the axis that its owner names.
///
/// ```
/// use wirebend_core::units::Angle;
/// let bend = Angle::from_deg(-270.0)?;
/// assert!((bend.wrapped().deg() - 90.0).abs() < 1e-12);
/// # Ok::<(), wirebend_core::units::NotFinite>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Angle(f64);

quantity!(Angle);

impl Angle {
    /// Half a turn, 180°.
    pub const HALF_TURN: Self = Self(std::f64::consts::PI);
    /// A whole turn, 360°.
    pub const TURN: Self = Self(std::f64::consts::TAU);

    /// An angle from degrees.
    ///
    /// # Errors
    /// [`NotFinite`] for NaN and infinities.
    pub const fn from_deg(deg: f64) -> Result<Self, NotFinite> {
        if deg.is_finite() {
            Ok(Self(deg.to_radians()))
        } else {
            Err(NotFinite { value: deg, unit: "degrees" })
        }
    }

    /// An angle from radians.
    ///
    /// # Errors
    /// [`NotFinite`] for NaN and infinities.
    pub const fn from_rad(rad: f64) -> Result<Self, NotFinite> {
        if rad.is_finite() { Ok(Self(rad)) } else { Err(NotFinite { value: rad, unit: "radians" }) }
    }

    /// An angle from a number that arithmetic on finite numbers gave (see [`Length::computed`]).
    #[must_use]
    pub const fn computed(rad: f64) -> Self {
        if rad.is_nan() { Self(0.0) } else { Self(saturate(rad)) }
    }

    /// Radians.
    #[must_use]
    pub const fn rad(self) -> f64 {
        self.0
    }

    /// Degrees.
    #[must_use]
    pub const fn deg(self) -> f64 {
        self.0.to_degrees()
    }

    /// The same direction in the canonical range (-180°, 180°].
    #[must_use]
    pub fn wrapped(self) -> Self {
        use std::f64::consts::{PI, TAU};
        if self.0 > -PI && self.0 <= PI {
            return self;
        }
        let turned = self.0.rem_euclid(TAU);
        Self(if turned > PI { turned - TAU } else { turned })
    }
}

impl fmt::Display for Angle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:.*}°", f.precision().unwrap_or(1), self.deg())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn only_finite_numbers_get_in() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(Length::from_mm(bad).is_err());
            assert!(Angle::from_deg(bad).is_err());
            assert!(Angle::from_rad(bad).is_err());
        }
    }

    #[test]
    fn lengths_are_written_in_inches_only_where_that_is_asked_for() {
        let (length, plain) = (Length::from_mm(12.7).unwrap(), Mm(0.01));
        let all = || format!("{length}, {length:.2}, {plain}, {plain:.0}");
        assert_eq!(all(), "12.7 mm, 12.70 mm, 0.01 mm, 0 mm");
        let inner = written_in(|| DisplayUnit::Inch, || [all(), written_in(|| DisplayUnit::Millimetre, all)]);
        assert_eq!(inner, ["0.500 in, 0.5000 in, 0.000394 in, 0.000 in".to_owned(), all()]);
        let thrown = std::panic::catch_unwind(|| {
            written_in(|| DisplayUnit::Inch, || std::panic::resume_unwind(Box::new(())))
        });
        assert!(thrown.is_err());
        assert_eq!(length.to_string(), "12.7 mm", "also after a panic");
    }

    proptest! {
        #[test]
        fn arithmetic_stays_finite(a in proptest::num::f64::NORMAL, b in proptest::num::f64::NORMAL, k: i32) {
            let (a, b) = (Length::from_mm(a).unwrap(), Length::from_mm(b).unwrap());
            for value in [a + b, a - b, -a, a.abs(), a.times(k), a.min(b), a.max(b)] {
                prop_assert!(value.mm().is_finite());
            }
        }

        #[test]
        fn wrapping_keeps_the_direction(deg in -100_000.0..100_000.0_f64) {
            let angle = Angle::from_deg(deg).unwrap();
            let wrapped = angle.wrapped();
            prop_assert!(wrapped.deg() > -180.0 && wrapped.deg() <= 180.0);
            prop_assert!((wrapped.rad().sin() - angle.rad().sin()).abs() < 1e-9);
            prop_assert!((wrapped.rad().cos() - angle.rad().cos()).abs() < 1e-9);
        }
    }
}
