//! The unit in which a person reads lengths.

use std::cell::Cell;
use std::sync::atomic::{AtomicBool, Ordering};

use wirebend_core::units::{DisplayUnit, written_in};

static INCHES: AtomicBool = AtomicBool::new(false);

thread_local! {
    static KEEPING: Cell<Option<DisplayUnit>> = const { Cell::new(None) };
}

/// Chooses the unit of [`shown`] for this process, which has one person before it.
pub fn show_lengths_in(unit: DisplayUnit) {
    INCHES.store(unit == DisplayUnit::Inch, Ordering::Relaxed);
}

fn chosen() -> DisplayUnit {
    let of_person = if INCHES.load(Ordering::Relaxed) { DisplayUnit::Inch } else { DisplayUnit::Millimetre };
    KEEPING.get().unwrap_or(of_person)
}

/// Words something for the person at the front end: lengths in it are in the unit that they have chosen.
pub fn shown<T>(word: impl FnOnce() -> T) -> T {
    written_in(chosen, word)
}

/// Words something that is kept, as in an exported file: lengths in it are in millimetres, also in what is worded for a person.
pub fn kept<T>(word: impl FnOnce() -> T) -> T {
    kept_in(DisplayUnit::Millimetre, word)
}

/// Words something that is kept and for which a unit was asked for, as a sheet to print.
pub fn kept_in<T>(unit: DisplayUnit, word: impl FnOnce() -> T) -> T {
    struct Before(Option<DisplayUnit>);
    impl Drop for Before {
        fn drop(&mut self) {
            KEEPING.set(self.0);
        }
    }
    let _before = Before(KEEPING.replace(Some(unit)));
    written_in(chosen, word)
}
