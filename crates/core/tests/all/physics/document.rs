//! `docs/physics.md` as text from which numbers are taken.

/// A number as the page shows it.
#[derive(Debug, Clone, Copy)]
pub struct Number {
    pub value: f64,
    decimals: i32,
}

impl Number {
    /// The same number, if it is this one in the digits that it shows.
    #[track_caller]
    pub fn is(self, computed: f64) {
        let half = 0.5 * 10_f64.powi(-self.decimals);
        let off = (self.value - computed).abs();
        assert!(off <= half * 1.001, "the page says {}, and {computed} comes out", self.value);
    }
}

/// The page as one line without code, in which the numbers that were taken are marked.
pub struct Document {
    text: Vec<char>,
    taken: Vec<bool>,
    rows: Vec<Vec<String>>,
    code: Vec<String>,
}

impl Document {
    pub fn read() -> Self {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/physics.md");
        let text = std::fs::read_to_string(file).unwrap();
        let text = text.split("\n## Sources").next().unwrap();
        let mut prose = String::new();
        let (mut rows, mut code) = (Vec::new(), Vec::new());
        let mut in_code = false;
        for line in text.lines() {
            if line.starts_with("```") {
                in_code = !in_code;
            } else if line.starts_with('|') {
                rows.push(line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect());
            } else if in_code {
                code.push(line.to_owned());
            } else {
                // Code spans hold paths and keys.
                prose.extend(line.trim().split('`').step_by(2));
                prose.push(' ');
            }
        }
        let text: Vec<char> = prose.chars().collect();
        Self { taken: vec![false; text.len()], text, rows, code }
    }

    /// The numbers at the places `{}` of a sentence, which has to stand on the page once.
    #[track_caller]
    pub fn sentence<const N: usize>(&mut self, sentence: &str) -> [Number; N] {
        let parts: Vec<Vec<char>> = sentence.split("{}").map(|part| part.chars().collect()).collect();
        assert_eq!(parts.len(), N + 1, "{sentence}");
        let found: Vec<_> = (0..self.text.len()).filter_map(|start| self.at(start, &parts)).collect();
        assert_eq!(found.len(), 1, "this stands on the page {} times: {sentence}", found.len());
        let (numbers, range) = &found[0];
        self.taken[range.clone()].fill(true);
        <[Number; N]>::try_from(numbers.clone()).unwrap()
    }

    /// The numbers with decimals in the equation that begins like this.
    #[track_caller]
    pub fn factors<const N: usize>(&self, equation: &str) -> [Number; N] {
        let line = self.code.iter().find(|line| line.starts_with(equation));
        let line = line.unwrap_or_else(|| panic!("no equation '{equation}'"));
        let words = line.split_whitespace().filter(|word| word.contains('.'));
        let found: Vec<Number> = words.map(number).collect();
        <[Number; N]>::try_from(found).unwrap()
    }

    fn at(&self, start: usize, parts: &[Vec<char>]) -> Option<(Vec<Number>, std::ops::Range<usize>)> {
        let mut at = start;
        let mut numbers = Vec::new();
        for (k, part) in parts.iter().enumerate() {
            if k > 0 {
                let length = number_length(&self.text[at..])?;
                numbers.push(number(&self.text[at..at + length].iter().collect::<String>()));
                at += length;
            }
            if !self.text[at..].starts_with(part) {
                return None;
            }
            at += part.len();
        }
        Some((numbers, start..at))
    }

    /// The rows of the table whose heading has these cells, each with the numbers of its cells; `None` for an empty cell or a name.
    #[track_caller]
    pub fn table(&mut self, heading: &[&str]) -> Vec<(String, Vec<Option<Number>>)> {
        let start =
            self.rows.iter().position(|row| row == heading).unwrap_or_else(|| panic!("no table {heading:?}"));
        let length = self.rows[start + 2..]
            .iter()
            .take_while(|row| row.len() == heading.len() && is_data(row))
            .count();
        let rows: Vec<_> = self.rows.drain(start..start + 2 + length).collect();
        let cells =
            |row: &[String]| row[1..].iter().map(|cell| (!cell.is_empty()).then(|| number(cell))).collect();
        rows[2..].iter().map(|row| (row[0].trim_matches('`').to_owned(), cells(row))).collect()
    }

    /// Digits in these words are no results.
    #[track_caller]
    pub fn pass_over(&mut self, words: &str) {
        let words: Vec<char> = words.chars().collect();
        let found: Vec<usize> =
            (0..self.text.len()).filter(|&at| self.text[at..].starts_with(&words)).collect();
        assert!(!found.is_empty(), "{words:?} is not on the page: it needs not be passed over");
        for at in found {
            self.taken[at..at + words.len()].fill(true);
        }
    }

    /// Digits that were not taken, with what stands around them, and tables.
    pub fn unchecked(&self) -> Vec<String> {
        let left = (0..self.text.len()).filter(|&at| self.text[at].is_ascii_digit() && !self.taken[at]);
        let mut last = 0;
        let mut found = Vec::new();
        for at in left {
            if found.is_empty() || at > last + 20 {
                found.push(self.text[at.saturating_sub(30)..(at + 30).min(self.text.len())].iter().collect());
                last = at;
            }
        }
        found.extend(self.rows.iter().map(|row| row.join(" | ")));
        found
    }
}

/// Whether a row holds data, and is not the heading of the next table.
fn is_data(row: &[String]) -> bool {
    row[0].starts_with('`') || row[0].starts_with(|c: char| c.is_ascii_digit())
}

fn number_length(text: &[char]) -> Option<usize> {
    let sign = usize::from(text.first() == Some(&'-'));
    let digits = |from: usize| text[from..].iter().take_while(|c| c.is_ascii_digit()).count();
    let whole = digits(sign);
    if whole == 0 {
        return None;
    }
    let end = sign + whole;
    let fraction = if text.get(end) == Some(&'.') { digits(end + 1) } else { 0 };
    Some(if fraction > 0 { end + 1 + fraction } else { end })
}

fn number(text: &str) -> Number {
    let value = text.parse().unwrap_or_else(|error| panic!("{text:?}: {error}"));
    let decimals = text.split_once('.').map_or(0, |(_, fraction)| fraction.len());
    Number { value, decimals: i32::try_from(decimals).unwrap() }
}

#[test]
fn numbers_are_taken_as_they_are_shown() {
    for (text, length) in [("-13.25°", 6), ("2.", 1), ("10°", 2), ("1495.39", 7)] {
        assert_eq!(number_length(&text.chars().collect::<Vec<_>>()), Some(length), "{text}");
    }
    assert_eq!(number_length(&['-', 'x']), None);
    number("2.230").is(2.2302);
    assert!(std::panic::catch_unwind(|| number("2.230").is(2.231)).is_err());
}
