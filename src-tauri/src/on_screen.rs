//! A window that is kept from another screen comes where all of it is seen: STOP must be in sight.

use tauri::{PhysicalPosition, PhysicalRect, PhysicalSize, Runtime, Window};

type Area = PhysicalRect<i32, u32>;

/// Asked once its page is there: a window that opens is placed in several steps. Where a system does not tell where windows and
/// screens are, nothing is moved.
pub fn bring_back<R: Runtime>(window: &Window<R>) {
    let told = || -> tauri::Result<Option<(Area, Area, PhysicalSize<u32>)>> {
        if window.is_maximized()? || window.is_fullscreen()? {
            return Ok(None);
        }
        let screens: Vec<Area> =
            window.available_monitors()?.iter().map(|screen| *screen.work_area()).collect();
        let window_area = Area { position: window.outer_position()?, size: window.outer_size()? };
        Ok(fitted(window_area, &screens)
            .map(|fits| (window_area, fits, window.inner_size().unwrap_or(fits.size))))
    };
    let Ok(Some((is, fits, inner))) = told() else { return };
    if fits.size != is.size {
        // Its frame is around what can be set.
        let size = PhysicalSize {
            width: fits.size.width.saturating_sub(is.size.width.saturating_sub(inner.width)),
            height: fits.size.height.saturating_sub(is.size.height.saturating_sub(inner.height)),
        };
        let _ = window.set_size(size);
    }
    if fits.position != is.position {
        let _ = window.set_position(fits.position);
    }
}

/// A window on the screen that has most of it, made no larger than that; `None` where it can stay, or without a screen.
fn fitted(window: Area, screens: &[Area]) -> Option<Area> {
    let end = |from: i32, length: u32| i64::from(from) + i64::from(length);
    let shared =
        |a: (i32, u32), b: (i32, u32)| (end(a.0, a.1).min(end(b.0, b.1)) - i64::from(a.0.max(b.0))).max(0);
    let overlap = |screen: &&Area| {
        let (at, size) = (screen.position, screen.size);
        shared((window.position.x, window.size.width), (at.x, size.width))
            * shared((window.position.y, window.size.height), (at.y, size.height))
    };
    // The first of equal ones is the main screen.
    let screen = screens.iter().rev().max_by_key(overlap)?;
    let along = |from: i32, length: u32, first: i32, room: u32| {
        let length = length.min(room);
        let last = end(first, room - length);
        let from = i64::from(from).clamp(i64::from(first), last);
        (i32::try_from(from).unwrap_or(first), length)
    };
    let (x, width) = along(window.position.x, window.size.width, screen.position.x, screen.size.width);
    let (y, height) = along(window.position.y, window.size.height, screen.position.y, screen.size.height);
    let fits = Area { position: PhysicalPosition { x, y }, size: PhysicalSize { width, height } };
    (fits.position != window.position || fits.size != window.size).then_some(fits)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(x: i32, y: i32, width: u32, height: u32) -> Area {
        Area { position: PhysicalPosition { x, y }, size: PhysicalSize { width, height } }
    }

    fn moved(window: Area, screens: &[Area]) -> Option<(i32, i32, u32, u32)> {
        fitted(window, screens)
            .map(|fits| (fits.position.x, fits.position.y, fits.size.width, fits.size.height))
    }

    #[test]
    fn a_window_of_a_larger_screen_is_seen_whole_on_a_smaller_one() {
        let laptop = [area(0, 27, 1366, 741)];
        assert_eq!(moved(area(900, 300, 2560, 1400), &laptop), Some((0, 27, 1366, 741)));
        assert_eq!(moved(area(900, 300, 1000, 600), &laptop), Some((366, 168, 1000, 600)));
        assert_eq!(moved(area(100, 100, 1000, 600), &laptop), None, "it stays where it was");
    }

    #[test]
    fn the_screen_that_has_most_of_it_keeps_it() {
        let two = [area(0, 0, 1920, 1080), area(1920, 0, 1280, 800)];
        assert_eq!(moved(area(1800, 50, 1000, 700), &two), Some((1920, 50, 1000, 700)));
        // A screen that is gone had it: it comes to the main one.
        assert_eq!(moved(area(-4000, 50, 1000, 700), &two), Some((0, 50, 1000, 700)));
        assert_eq!(moved(area(i32::MIN, i32::MAX, u32::MAX, u32::MAX), &two), Some((0, 0, 1920, 1080)));
        assert_eq!(moved(area(0, 0, 10, 10), &[]), None);
    }
}
