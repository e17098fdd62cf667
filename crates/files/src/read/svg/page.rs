//! Lengths, and the map from the numbers of a page to pixels.

use svgtypes::{Align, AspectRatio, Length, LengthUnit, Transform, ViewBox};

/// A pixel in mm: there are 96 in an inch.
pub(super) const PIXEL_MM: f64 = 25.4 / 96.0;

/// What a share of in per cent is a share of.
#[derive(Debug, Clone, Copy)]
pub(super) enum Along {
    Width,
    Height,
    Diagonal,
}

/// The size of the outermost page, or of one within it, in its own numbers.
#[derive(Debug, Clone, Copy)]
pub(super) struct Page {
    pub(super) width: f64,
    pub(super) height: f64,
}

impl Page {
    fn along(self, along: Along) -> f64 {
        match along {
            Along::Width => self.width,
            Along::Height => self.height,
            Along::Diagonal => self.width.hypot(self.height) / 2.0_f64.sqrt(),
        }
    }

    /// A length in the numbers of the page; none where it depends on a font.
    pub(super) fn length(self, length: Length, along: Along) -> Option<f64> {
        Some(match length.unit {
            LengthUnit::Percent => length.number / 100.0 * self.along(along),
            _ => pixels(length)?,
        })
    }
}

/// A length in pixels; none where it depends on the page or on a font.
pub(super) fn pixels(length: Length) -> Option<f64> {
    let mm = match length.unit {
        LengthUnit::None | LengthUnit::Px => return Some(length.number),
        LengthUnit::Mm => 1.0,
        LengthUnit::Cm => 10.0,
        LengthUnit::In => 25.4,
        LengthUnit::Pt => 25.4 / 72.0,
        LengthUnit::Pc => 25.4 / 6.0,
        LengthUnit::Em | LengthUnit::Ex | LengthUnit::Percent => return None,
    };
    Some(length.number * mm / PIXEL_MM)
}

/// Whether a length says how large it is in the hand.
pub(super) fn is_physical(length: Length) -> bool {
    matches!(length.unit, LengthUnit::Mm | LengthUnit::Cm | LengthUnit::In | LengthUnit::Pt | LengthUnit::Pc)
}

/// From a view box to the page that shows it: as large as it fits, or stretched if the aspect ratio is none.
pub(super) fn fit(view: ViewBox, page: Page, aspect: AspectRatio) -> Transform {
    let (sx, sy) = (page.width / view.w, page.height / view.h);
    let (sx, sy) = match (aspect.align, aspect.slice) {
        (Align::None, _) => (sx, sy),
        (_, false) => (sx.min(sy), sx.min(sy)),
        (_, true) => (sx.max(sy), sx.max(sy)),
    };
    let (mut right, mut down) = (page.width - view.w * sx, page.height - view.h * sy);
    right *= match aspect.align {
        Align::XMidYMin | Align::XMidYMid | Align::XMidYMax => 0.5,
        Align::XMaxYMin | Align::XMaxYMid | Align::XMaxYMax => 1.0,
        _ => 0.0,
    };
    down *= match aspect.align {
        Align::XMinYMid | Align::XMidYMid | Align::XMaxYMid => 0.5,
        Align::XMinYMax | Align::XMidYMax | Align::XMaxYMax => 1.0,
        _ => 0.0,
    };
    Transform::new(sx, 0.0, 0.0, sy, right - view.x * sx, down - view.y * sy)
}
