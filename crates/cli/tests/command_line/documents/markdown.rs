//! The parts of a Markdown file that are checked.

use std::ops::Range;
use std::path::{Path, PathBuf};

/// A fenced block of code.
pub struct Block {
    /// The first word of its first line.
    pub language: String,
    /// The second word, if there is one.
    pub name: Option<String>,
    /// Number of its first line, from 1.
    pub line: usize,
    /// What is between the fences, without their indentation.
    pub lines: Vec<String>,
    /// The same in the lines of the file, from 0.
    pub within: Range<usize>,
    /// How far its fences are indented.
    pub indent: usize,
}

/// A table: its heading and rows as cells, each row with its line from 1.
pub struct Table {
    pub heading: Vec<String>,
    pub rows: Vec<(usize, Vec<String>)>,
}

pub struct Document {
    pub path: PathBuf,
    pub lines: Vec<String>,
    pub blocks: Vec<Block>,
}

impl Document {
    pub fn read(path: &Path) -> Self {
        let text =
            std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let lines: Vec<String> = text.lines().map(str::to_owned).collect();
        let blocks = blocks(&lines);
        Self { path: path.to_owned(), lines, blocks }
    }

    /// Its path below the root of the repository.
    pub fn name(&self) -> String {
        self.path.strip_prefix(crate::documents::root()).unwrap_or(&self.path).display().to_string()
    }

    /// A line of it, for a message.
    pub fn at(&self, line: usize) -> String {
        format!("{}:{line}", self.name())
    }

    /// Its lines outside of blocks of code, with their numbers from 1.
    pub fn prose(&self) -> impl Iterator<Item = (usize, &str)> {
        let in_block = |index: usize| {
            // The fences too.
            self.blocks.iter().any(|block| index + 1 >= block.within.start && index <= block.within.end)
        };
        let lines = self.lines.iter().enumerate().filter(move |(index, _)| !in_block(*index));
        lines.map(|(index, line)| (index + 1, line.as_str()))
    }

    pub fn tables(&self) -> Vec<Table> {
        let mut tables: Vec<Table> = Vec::new();
        let mut last = 0;
        for (number, line) in self.prose() {
            let Some(cells) = cells(line) else { continue };
            match tables.last_mut().filter(|_| last + 1 == number) {
                Some(table) => table.rows.push((number, cells)),
                None => tables.push(Table { heading: cells, rows: Vec::new() }),
            }
            last = number;
        }
        for table in &mut tables {
            // The line of dashes.
            table.rows.remove(0);
        }
        tables
    }

    /// The targets of links to sections of it, as they are made of headings.
    pub fn anchors(&self) -> Vec<String> {
        let headings = self.prose().filter_map(|(_, line)| {
            let title = line.trim_start_matches('#');
            (title.len() < line.len() && title.starts_with(' ')).then(|| title.trim())
        });
        headings.map(anchor).collect()
    }
}

fn blocks(lines: &[String]) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut at = 0;
    while at < lines.len() {
        let fence = lines[at].trim_start();
        let Some(words) = fence.strip_prefix("```") else {
            at += 1;
            continue;
        };
        let indent = lines[at].len() - fence.len();
        let mut words = words.split_whitespace().map(str::to_owned);
        let end = (at + 1..lines.len()).find(|&k| lines[k].trim() == "```");
        let end = end.unwrap_or_else(|| panic!("the block of line {} does not end", at + 1));
        let inner = lines[at + 1..end].iter().map(|line| line.get(indent..).unwrap_or_default().to_owned());
        blocks.push(Block {
            language: words.next().unwrap_or_default(),
            name: words.next(),
            line: at + 1,
            lines: inner.collect(),
            within: at + 1..end,
            indent,
        });
        at = end + 1;
    }
    blocks
}

/// The cells of a line of a table. A bar in a code span is written `\|`.
fn cells(line: &str) -> Option<Vec<String>> {
    let inner = line.trim().strip_prefix('|')?.strip_suffix('|')?.replace("\\|", "\u{0}");
    Some(inner.split('|').map(|cell| cell.trim().replace('\u{0}', "|")).collect())
}

/// What stands between backticks in a piece of prose.
pub fn code_spans(text: &str) -> Vec<&str> {
    text.split('`').skip(1).step_by(2).collect()
}

fn anchor(heading: &str) -> String {
    let kept = heading.to_lowercase();
    let kept = kept.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect()
}
