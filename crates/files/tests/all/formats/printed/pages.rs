//! PDF files, read by a library of others: pages, sizes, the ruler, text, and where the wire is on the pages.

use lopdf::content::Content;
use lopdf::{Document, Object};
use nalgebra::Point3;
use wirebend_core::units::{Angle, DisplayUnit};
use wirebend_files::write::{
    Figure, Finding, JobSheet, Layer, Paper, PictureWire, SheetStep, SheetWire, job_sheet, template,
    template_pdf,
};

use super::super::mm;
use super::templates::of;

pub(super) const POINTS: f64 = 72.0 / 25.4;
/// A4 and Letter upright, in points: 210 × 297 mm, 612 × 792.
const SIZES: [(Paper, [f64; 2]); 2] = [(Paper::A4, [595.276, 841.890]), (Paper::Letter, [612.0, 792.0])];

/// What a page shows.
#[derive(Debug, Default)]
pub(super) struct Page {
    size: [f64; 2],
    /// Lines that are drawn, from point to point, in points.
    pub(super) lines: Vec<[[f64; 2]; 2]>,
    /// Cubic curves that are drawn: begin, two handles, end.
    curves: Vec<[[f64; 2]; 4]>,
    /// Text, each piece where it stands.
    pub(super) texts: Vec<([f64; 2], String)>,
}

impl Page {
    pub(super) fn says(&self, words: &str) -> bool {
        self.texts.iter().any(|(_, text)| text.contains(words))
    }

    pub(super) fn all(&self) -> String {
        self.texts.iter().map(|(_, text)| text.as_str()).collect::<Vec<_>>().join(" ")
    }
}

fn number(object: &Object) -> f64 {
    f64::from(object.as_float().unwrap_or_else(|error| panic!("{error}: {object:?}")))
}

pub(super) fn pages(bytes: &[u8]) -> Vec<Page> {
    let document = Document::load_mem(bytes).unwrap();
    let page = |id| {
        let page = document.get_dictionary(id).unwrap();
        let media: Vec<f64> = page.get(b"MediaBox").unwrap().as_array().unwrap().iter().map(number).collect();
        let mut found = Page { size: [media[2] - media[0], media[3] - media[1]], ..Page::default() };
        let content = Content::decode(&document.get_page_content(id)).unwrap();
        let mut at = [0.0; 2];
        let mut text_at = [0.0; 2];
        for operation in content.operations {
            let n: Vec<f64> =
                operation.operands.iter().filter_map(|o| o.as_float().ok()).map(f64::from).collect();
            match operation.operator.as_str() {
                "m" => at = [n[0], n[1]],
                "l" => {
                    found.lines.push([at, [n[0], n[1]]]);
                    at = [n[0], n[1]];
                }
                "c" => {
                    found.curves.push([at, [n[0], n[1]], [n[2], n[3]], [n[4], n[5]]]);
                    at = [n[4], n[5]];
                }
                "Td" => text_at = [n[0], n[1]],
                "Tj" => {
                    let bytes = operation.operands[0].as_str().unwrap();
                    // Of Windows-1252 no more than Latin-1 and the dash is looked for.
                    let letter = |&byte: &u8| if byte == 0x96 { '–' } else { char::from(byte) };
                    found.texts.push((text_at, bytes.iter().map(letter).collect()));
                }
                _ => {}
            }
        }
        found
    };
    document.get_pages().into_values().map(page).collect()
}

/// A frame, 330 × 420 mm: too large for any paper.
fn large() -> Vec<Point3<f64>> {
    let corners = [[0., 0.], [330., 0.], [330., 420.], [20., 420.], [20., 60.]];
    corners.map(|[x, y]| Point3::new(x, y, 0.0)).to_vec()
}

#[test]
fn every_page_has_its_size_and_a_ruler_of_100_mm() {
    let drawing = template(&of(vec![large()]));
    for (paper, size) in SIZES {
        let pdf = template_pdf(&drawing, paper).unwrap();
        let pages = pages(&pdf.bytes);
        assert_eq!(pages.len(), pdf.pages);
        for page in &pages {
            let upright = [page.size[0].min(page.size[1]), page.size[0].max(page.size[1])];
            assert!(upright.iter().zip(size).all(|(a, b)| (a - b).abs() < 0.01), "{:?}", page.size);
            // 100 mm are 283.465 points.
            let is_ruler =
                |[a, b]: &[[f64; 2]; 2]| (a[1] - b[1]).abs() < 1e-6 && (b[0] - a[0] - 283.465).abs() < 1e-3;
            assert_eq!(page.lines.iter().filter(|line| is_ruler(line)).count(), 1);
            assert!(page.says("must measure 100 mm: print at 100 %"));
        }
    }
}

/// Pages show 190 × 263 mm of A4 upright, or 277 × 176 mm lying, and continue 10 mm beyond each other. With its edges, the
/// words at its ends and what stands under it the frame is less than 370 × 516 mm: two columns and two rows upright.
#[test]
fn pages_together_show_the_wire_at_its_size() {
    let drawing = template(&of(vec![large()]));
    let pdf = template_pdf(&drawing, Paper::A4).unwrap();
    let pages = pages(&pdf.bytes);
    let (mut left, mut top) = (f64::INFINITY, f64::NEG_INFINITY);
    let centre: Vec<[[f64; 2]; 2]> = drawing
        .shapes
        .iter()
        .filter(|(layer, _)| *layer == Layer::Centreline)
        .filter_map(|(_, shape)| match shape {
            wirebend_files::write::Shape::Line(ends) => Some(*ends),
            _ => None,
        })
        .collect();
    assert_eq!(centre.len(), 4);
    // Where A1 begins: the outermost edge of the wire, or of the text, whichever is farther to the left.
    for (_, shape) in &drawing.shapes {
        if let wirebend_files::write::Shape::Line(ends) = shape {
            for [x, y] in ends {
                (left, top) = (left.min(*x), top.max(*y));
            }
        }
        if let wirebend_files::write::Shape::Text { at, .. } = shape {
            left = left.min(at[0]);
        }
    }
    let mut covered = vec![Vec::new(); centre.len()];
    for page in &pages[1..] {
        let (name, of) = page
            .texts
            .iter()
            .find_map(|(_, text)| text.split_once(" of ").filter(|(_, of)| of.contains('×')))
            .unwrap_or_else(|| panic!("no name: {:?}", page.all()));
        assert_eq!(of, "2×2");
        let column = f64::from(name.as_bytes()[0] - b'A');
        let row: f64 = name[1..].parse::<f64>().unwrap() - 1.0;
        let window = [page.size[0] / POINTS - 20.0, page.size[1] / POINTS - 34.0];
        // From the page to the drawing.
        let corner = [left + column * (window[0] - 10.0), top - row * (window[1] - 10.0)];
        let to_drawing =
            |[x, y]: [f64; 2]| [corner[0] + x / POINTS - 10.0, corner[1] + y / POINTS - 24.0 - window[1]];
        for (ends, covered) in centre.iter().zip(&mut covered) {
            let same = |line: &&[[f64; 2]; 2]| {
                line.map(to_drawing).iter().zip(ends).all(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-3)
            };
            if page.lines.iter().any(|line| same(&line)) {
                covered.push([corner[0], corner[1] - window[1], corner[0] + window[0], corner[1]]);
            }
        }
    }
    // Every point of every side is in the window of a page that draws this side.
    for (ends, windows) in centre.iter().zip(&covered) {
        for k in 0..=1000 {
            let along = f64::from(k) / 1000.0;
            let [x, y] = [0, 1].map(|c| ends[0][c] + (ends[1][c] - ends[0][c]) * along);
            let shown = windows
                .iter()
                .any(|w| x >= w[0] - 1e-6 && x <= w[2] + 1e-6 && y >= w[1] - 1e-6 && y <= w[3] + 1e-6);
            assert!(shown, "{x}, {y} is on no page");
        }
    }
}

/// A cubic curve at a fraction of its parameter, by its polynomial.
fn on_curve(curve: &[[f64; 2]; 4], t: f64) -> [f64; 2] {
    let u = 1.0 - t;
    [0, 1].map(|c| {
        let [a, b, d, e] = curve.map(|point| point[c]);
        u.powi(3) * a + 3.0 * u * u * t * b + 3.0 * u * t * t * d + t.powi(3) * e
    })
}

/// Where the perpendiculars of two chords meet.
fn centre_of([a, b, c]: [[f64; 2]; 3]) -> [f64; 2] {
    let square = |p: [f64; 2]| p[0] * p[0] + p[1] * p[1];
    let twice = 2.0 * (a[0] * (b[1] - c[1]) + b[0] * (c[1] - a[1]) + c[0] * (a[1] - b[1]));
    let [aa, bb, cc] = [a, b, c].map(square);
    let x = aa * (b[1] - c[1]) + bb * (c[1] - a[1]) + cc * (a[1] - b[1]);
    let y = aa * (c[0] - b[0]) + bb * (a[0] - c[0]) + cc * (b[0] - a[0]);
    [x / twice, y / twice]
}

/// A right angle to the left: its curves are parts of circles about one centre, of 3, 4.5 and 6 mm, the middle of the
/// wire of 3 mm and its edges.
#[test]
fn bends_are_round_on_paper() {
    let path = [[0., 0.], [50., 0.], [50., 40.]].map(|[x, y]| Point3::new(x, y, 0.0)).to_vec();
    let pages = pages(&template_pdf(&template(&of(vec![path])), Paper::A4).unwrap().bytes);
    let curves = &pages[1].curves;
    let centre = centre_of([0.0, 0.5, 1.0].map(|t| on_curve(&curves[0], t)));
    let mut radii = std::collections::BTreeSet::new();
    for curve in curves {
        for k in 0..=10 {
            let [x, y] = on_curve(curve, f64::from(k) / 10.0);
            let radius_mm = (x - centre[0]).hypot(y - centre[1]) / POINTS;
            let nearest = (radius_mm / 1.5).round() * 1.5;
            assert!((radius_mm - nearest).abs() < 1e-3, "{radius_mm}");
            radii.insert(format!("{nearest}"));
        }
    }
    assert_eq!(radii.into_iter().collect::<Vec<_>>(), ["3", "4.5", "6"]);
}

/// A diagonal of one metre leaves corners of its square empty: no paper for them, and the overview says which.
#[test]
fn empty_pages_are_left_out_and_named() {
    let path = [[0., 0.], [700., 700.], [600., 705.]].map(|[x, y]| Point3::new(x, y, 0.0)).to_vec();
    let pdf = template_pdf(&template(&of(vec![path])), Paper::A4).unwrap();
    let pages = pages(&pdf.bytes);
    let first = pages[0].all();
    let count = pages.len() - 1;
    assert!(first.contains(&format!("{count} pages follow")), "{first}");
    assert!(first.contains("of 4 columns (A, B, "), "{first}");
    assert!(first.contains("would be empty and are left out: A1"), "{first}");
    assert!(
        !pages[1..].iter().any(|page| page.says("A1 of")),
        "A1 is empty: the wire begins at the lower left"
    );
    assert!(pages[1..].iter().all(|page| page.says(" of 4×")), "{first}");
}

#[test]
fn what_nobody_would_glue_is_refused() {
    let path: Vec<Point3<f64>> = (0..60)
        .map(|k| Point3::new(if k % 2 == 0 { 0.0 } else { 4000.0 }, f64::from(k) * 150.0, 0.0))
        .collect();
    let error = template_pdf(&template(&of(vec![path])), Paper::A4).unwrap_err();
    assert!(error.to_string().contains("more than 400 pages"), "{error}");
}

pub(super) fn sheet(steps: usize) -> JobSheet {
    let step = |k: usize| {
        #[allow(clippy::cast_precision_loss)]
        let k = k as f64;
        SheetStep {
            designed: [30.0 + k, -k, 90.5],
            told: Some([29.1 + k, k, -110.398]),
            before_zero: false,
            fed_mm: 29.1 + k,
        }
    };
    let path = [[0., 0., 0.], [30., 0., 0.], [30., 20., 0.], [30., 20., 10.]].map(Point3::from).to_vec();
    JobSheet {
        title: "Cup holder 針金".into(),
        date: Some("2026-05-01".into()),
        design_hash: "85d6f3525c4cd9c0223b".into(),
        job_hash: Some("d8139931d706aaaaaaaa".into()),
        feasible: false,
        collisions: vec!["No collision found.".to_owned()],
        joints: vec!["2 zip ties, 0.6 g: vertices 1 and 3".to_owned()],
        machine: "WireBend-kit".into(),
        material: "Aluminium, Ø 3 mm".into(),
        figures: vec![Figure {
            name: "springback".into(),
            value: "10.23°".into(),
            source: "measured: SCF25, a long sentence that goes on and on until it does not fit into one line of it".into(),
        }],
        wires: vec![SheetWire {
            picture: PictureWire { points: path, doubled: vec![1] },
            facts: vec![("stock length".into(), "858.1 mm".into()), ("bends".into(), "10".into())],
            steps: (0..steps).map(step).collect(),
        }],
        checked: true,
        findings: vec![Finding {
            severity: "error",
            code: "feed_too_short".into(),
            message: "edge 42 is fed 21.9 mm".into(),
            help: "make the edge at least 3.1 mm longer".into(),
        }],
        notes: vec!["the springback is an estimate".into()],
        paper: Paper::A4,
        unit: DisplayUnit::Millimetre,
        flat: mm(0.3),
        straight: Angle::from_deg(0.05).unwrap(),
    }
}

/// Whoever stands at the machine reads every number of every step from this sheet.
#[test]
fn a_job_sheet_has_every_step_and_all_that_is_known() {
    let pdf = job_sheet(&sheet(176));
    let pages = pages(&pdf.bytes);
    assert_eq!(pages.len(), pdf.pages);
    let all: String = pages.iter().map(Page::all).collect::<Vec<_>>().join(" ");
    for expected in [
        "Cup holder ??",
        "2026-05-01",
        "design 85d6f3525c4c",
        "job d8139931d706",
        "This cannot be bent as it is",
        "WireBend-kit",
        "Aluminium, Ø 3 mm",
        "858.1 mm",
        "10.23°",
        "until it does not fit",
        "error [feed_too_short]: edge 42 is fed 21.9 mm",
        "help: make the edge at least 3.1 mm longer",
        "2 zip ties, 0.6 g: vertices 1 and 3",
        "note: the springback is an estimate",
        "as sent to the machine",
    ] {
        assert!(all.contains(expected), "{expected}: {all}");
    }
    assert_eq!(pdf.missing.iter().collect::<String>(), "金針");
    let mut rows = pages.iter().flat_map(|page| {
        let mut rows: Vec<(f64, Vec<&str>)> = Vec::new();
        for ([_, y], text) in &page.texts {
            match rows.last_mut() {
                Some((last, row)) if (*last - y).abs() < 0.01 => row.push(text),
                _ => rows.push((*y, vec![text])),
            }
        }
        rows.into_iter().map(|(_, row)| row).filter(|row| row.len() == 8 && row[0] != "n").collect::<Vec<_>>()
    });
    let mut run = 0.0;
    for k in 0..176 {
        let n = f64::from(k);
        run += 29.1 + n;
        let degrees = if k == 0 { "0.000".to_owned() } else { format!("{:.3}", -n) };
        let expected = [
            (k + 1).to_string(),
            format!("{:.3}", 30.0 + n),
            degrees,
            "90.500".to_owned(),
            format!("{:.3}", 29.1 + n),
            format!("{n:.3}"),
            "-110.398".to_owned(),
            format!("{run:.3}"),
        ];
        assert_eq!(rows.next().unwrap(), expected.iter().map(String::as_str).collect::<Vec<_>>());
    }
    assert!(rows.next().is_none());
    for (index, page) in pages.iter().enumerate() {
        assert!(page.says(&format!("page {} of {}", index + 1, pages.len())), "{index}");
        // Nothing stands outside of the paper.
        let [width, height] = page.size;
        let inside = |[x, y]: [f64; 2]| x >= 0.0 && x <= width && y >= 0.0 && y <= height;
        assert!(page.texts.iter().all(|(at, _)| inside(*at)));
        assert!(page.lines.iter().flatten().all(|at| inside(*at)));
    }
}

#[test]
fn the_same_sheet_gives_the_same_bytes() {
    assert_eq!(job_sheet(&sheet(3)).bytes, job_sheet(&sheet(3)).bytes);
    let drawing = template(&of(vec![large()]));
    assert_eq!(template_pdf(&drawing, Paper::A4), template_pdf(&drawing, Paper::A4));
}

#[test]
fn a_sheet_of_nothing_is_a_sheet() {
    let nothing =
        JobSheet { wires: vec![SheetWire::default()], findings: vec![], figures: vec![], ..sheet(0) };
    let pages = pages(&job_sheet(&nothing).bytes);
    assert_eq!(pages.len(), 1);
    assert!(pages[0].says("See the notes."));
    let untold = SheetStep { designed: [10.0, 0.0, 20.0], told: None, before_zero: false, fed_mm: 10.0 };
    let wire = SheetWire { steps: vec![untold], ..SheetWire::default() };
    let pages = self::pages(&job_sheet(&JobSheet { wires: vec![wire], ..sheet(0) }).bytes);
    assert!(pages[0].says("–"));
}
