//! PDF: pages of lines and text. Fonts are those that every viewer has, so that none is embedded; text can be
//! selected and searched. The same pages give the same bytes: no clock is read.

mod canvas;
pub(crate) mod flow;
pub(crate) mod letters;

use std::collections::BTreeSet;
use std::io::Write as _;

use flate2::Compression;
use flate2::write::ZlibEncoder;
use pdf_writer::{Filter, Finish as _, Name, Rect, Ref, TextStr};

pub(crate) use canvas::{Canvas, Pen, Type};

/// Paper to print on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Paper {
    /// 210 × 297 mm.
    #[default]
    A4,
    /// 8.5 × 11 in, 215.9 × 279.4 mm.
    Letter,
}

impl Paper {
    pub const ALL: [Self; 2] = [Self::A4, Self::Letter];

    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::A4 => "a4",
            Self::Letter => "letter",
        }
    }

    /// Width and height in mm, upright.
    #[must_use]
    pub const fn size_mm(self) -> [f64; 2] {
        match self {
            Self::A4 => [210.0, 297.0],
            Self::Letter => [215.9, 279.4],
        }
    }
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pdf {
    pub bytes: Vec<u8>,
    /// How many pages it has.
    pub pages: usize,
    /// Letters that the fonts do not have: question marks on the pages. The file's own title has them.
    pub missing: BTreeSet<char>,
}

/// Makes a file of pages. A viewer is asked to print them without scaling.
pub(crate) fn document(title: &str, pages: Vec<Canvas>) -> Pdf {
    let mut numbers = (1..).map(Ref::new);
    let mut next = || numbers.next().unwrap_or(Ref::new(1));
    let (catalog, tree, about, plain, bold) = (next(), next(), next(), next(), next());
    let ids: Vec<(Ref, Ref)> = pages.iter().map(|_| (next(), next())).collect();
    let mut pdf = pdf_writer::Pdf::new();
    let mut root = pdf.catalog(catalog);
    root.pages(tree);
    root.viewer_preferences().pair(Name(b"PrintScaling"), Name(b"None"));
    root.finish();
    pdf.document_info(about).title(TextStr(title)).producer(TextStr("WireBend-kit"));
    let count = i32::try_from(pages.len()).unwrap_or(i32::MAX);
    pdf.pages(tree).kids(ids.iter().map(|(page, _)| *page)).count(count);
    for (font, name) in [(plain, "Helvetica"), (bold, "Helvetica-Bold")] {
        let encoding = Name(b"WinAnsiEncoding");
        pdf.type1_font(font).base_font(Name(name.as_bytes())).encoding_predefined(encoding);
    }
    let mut missing = BTreeSet::new();
    let page_count = pages.len();
    for (canvas, (page, contents)) in pages.into_iter().zip(ids) {
        missing.extend(canvas.missing);
        #[allow(clippy::cast_possible_truncation)] // sizes of paper
        let [width, height] = canvas.size.map(|mm| (mm * 72.0 / 25.4) as f32);
        let mut page = pdf.page(page);
        page.media_box(Rect::new(0.0, 0.0, width, height)).parent(tree).contents(contents);
        page.resources().fonts().pair(Name(b"F1"), plain).pair(Name(b"F2"), bold);
        page.finish();
        let drawn = canvas.content.finish();
        match packed(drawn.as_slice()) {
            Ok(packed) => drop(pdf.stream(contents, &packed).filter(Filter::FlateDecode)),
            // In full it is as good.
            Err(_) => drop(pdf.stream(contents, drawn.as_slice())),
        }
    }
    Pdf { bytes: pdf.finish(), pages: page_count, missing }
}

fn packed(bytes: &[u8]) -> std::io::Result<Vec<u8>> {
    let mut packer = ZlibEncoder::new(Vec::new(), Compression::default());
    packer.write_all(bytes)?;
    packer.finish()
}
