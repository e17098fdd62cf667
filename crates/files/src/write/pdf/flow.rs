//! Text that continues from page to page.

use super::{Canvas, Pen, Type, letters};

/// White around each page, in mm.
const MARGIN: f64 = 15.0;
/// For what stands under each page, in mm.
const FOOT: f64 = 8.0;

pub(crate) const SMALL: Type = Type { size: 2.9, bold: false, grey: 0.3 };

/// Pages that are filled from above.
pub(crate) struct Flow {
    /// Width and height of the paper in mm.
    pub paper: [f64; 2],
    full: Vec<Canvas>,
    current: Canvas,
    /// How far down the page is used.
    y: f64,
}

impl Flow {
    pub fn new(paper: [f64; 2]) -> Self {
        Self { paper, full: Vec::new(), current: Canvas::new(paper), y: paper[1] - MARGIN }
    }

    pub fn page(&mut self) -> &mut Canvas {
        &mut self.current
    }

    /// Between the margins.
    pub fn width(&self) -> f64 {
        self.paper[0] - 2.0 * MARGIN
    }

    /// Whether so much fits on this page.
    pub fn fits(&self, height: f64) -> bool {
        self.y - height >= MARGIN + FOOT
    }

    /// The next strip of a height, on the next page where it does not fit on this one.
    pub fn take(&mut self, height: f64) -> [f64; 4] {
        if !self.fits(height) {
            self.next_page();
        }
        let top = self.y;
        self.y -= height;
        [MARGIN, self.y, self.paper[0] - MARGIN, top]
    }

    pub fn next_page(&mut self) {
        self.full.push(std::mem::replace(&mut self.current, Canvas::new(self.paper)));
        self.y = self.paper[1] - MARGIN;
    }

    pub fn gap(&mut self, height: f64) {
        self.y -= height;
    }

    /// A heading that stands with the first `with` mm of what it is of.
    pub fn heading(&mut self, text: &str, with: f64) {
        let kind = Type::new(4.0).bold();
        self.gap(4.0);
        if !self.fits(7.0 + with) {
            self.next_page();
        }
        let [left, bottom, right, _] = self.take(5.0);
        self.current.text([left, bottom + 0.5], text, kind);
        self.current.line([left, bottom - 1.0], [right, bottom - 1.0], Pen::new(0.2, 0.6));
        self.gap(2.5);
    }

    pub fn text(&mut self, text: &str, kind: Type) {
        self.indented(text, kind, 0.0);
    }

    /// A paragraph that begins so far to the right.
    pub fn indented(&mut self, text: &str, kind: Type, by: f64) {
        for line in letters::lines(text, kind.size, kind.bold, self.width() - by) {
            let [left, bottom, ..] = self.take(kind.size * 1.4);
            self.current.text([left + by, bottom + kind.size * 0.2], &line, kind);
        }
    }

    /// The pages, each with what it is of and its number.
    pub fn finish(mut self, about: &str) -> Vec<Canvas> {
        self.full.push(self.current);
        let (count, width) = (self.full.len(), self.paper[0]);
        for (index, page) in self.full.iter_mut().enumerate() {
            let number = format!("page {} of {count}", index + 1);
            let room = width - 2.0 * MARGIN - SMALL.width(&number) - 4.0;
            page.text([MARGIN, MARGIN - 3.0], &letters::cut(about, SMALL.size, false, room), SMALL);
            page.text_to([width - MARGIN, MARGIN - 3.0], &number, SMALL);
        }
        self.full
    }
}
