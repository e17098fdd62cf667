//! The elements of an SVG file, by id and by line.

use std::collections::HashMap;

use roxmltree::{Document, Error, Node, ParsingOptions};
use wirebend_error::ErrorRemedy;

use super::super::error::{Location, ReadError};
use super::super::text::{LIMIT, Source};
use super::style::Styles;

/// How many bytes entities may become.
const MAX_EXPANDED: usize = 64 << 20;
/// How many entities a file may declare; programs that draw declare a dozen.
const MAX_ENTITIES: usize = 256;
/// How many attributes an element may have, by their equals signs; those of a path or a style are a few.
const MAX_EQUALS_SIGNS: usize = 10_000;

pub(super) struct Tree<'a, 'input> {
    pub(super) source: Source<'a>,
    pub(super) document: &'a Document<'input>,
    by_id: HashMap<&'a str, Node<'a, 'input>>,
    pub(super) styles: Styles,
    /// Where each line begins.
    lines: Vec<usize>,
}

/// Parses the text. Entities of other files are not resolved, and those within may not grow without end.
///
/// # Errors
/// [`ReadError::Syntax`] with the line, [`ReadError::TooMany`].
pub(super) fn parse<'input>(text: &'input str, source: Source<'_>) -> Result<Document<'input>, ReadError> {
    let references = text.bytes().filter(|byte| *byte == b'&').count();
    if expanded(text).is_none_or(|longest| longest.saturating_mul(references) > MAX_EXPANDED) {
        let (file, what) = (source.name.to_owned(), "a text that entities make so long".to_owned());
        return Err(ReadError::Unsupported {
            file,
            place: Location::File,
            what,
            remedy: Box::new(plain_svg()),
        });
    }
    // The parser compares each attribute of an element with all before it.
    let max = text.split('<').map(|tag| tag.bytes().filter(|byte| *byte == b'=').count()).max();
    if max.is_some_and(|max| max > MAX_EQUALS_SIGNS) {
        let what = "attributes of one element";
        return Err(ReadError::TooMany {
            file: source.name.to_owned(),
            place: Location::File,
            what,
            limit: MAX_EQUALS_SIGNS,
        });
    }
    let nodes_limit = u32::try_from(LIMIT).unwrap_or(u32::MAX);
    let options = ParsingOptions { allow_dtd: true, nodes_limit, entity_resolver: None };
    Document::parse_with_options(text, options).map_err(|error| match error {
        Error::NodesLimitReached => {
            let file = source.name.to_owned();
            ReadError::TooMany { file, place: Location::File, what: "elements", limit: LIMIT }
        }
        error => {
            let place = Location::Line(error.pos().row as usize);
            source.refused(place, &error, "an XML text with an svg element", plain_svg())
        }
    })
}

/// How many bytes one reference may become; none where there are too many entities to tell.
fn expanded(text: &str) -> Option<usize> {
    let (mut longest, mut nested) = (0, 1);
    for (k, (at, keyword)) in text.match_indices("<!ENTITY").enumerate() {
        let rest = &text[at + keyword.len()..];
        let value = rest.find(['"', '\'']).map_or("", |open| {
            let (quote, value) = rest[open..].split_at(1);
            value.split(quote).next().unwrap_or_default()
        });
        longest = longest.max(value.len());
        if value.contains('&') {
            // The parser stops a reference that holds more.
            nested = 256;
        }
        if k == MAX_ENTITIES {
            return None;
        }
    }
    Some(longest * nested)
}

impl<'a, 'input> Tree<'a, 'input> {
    /// # Errors
    /// [`ReadError::Unsupported`] for style sheets that are too large for as many elements.
    pub(super) fn new(document: &'a Document<'input>, source: Source<'a>) -> Result<Self, ReadError> {
        let Some(styles) = Styles::of(document) else {
            let (file, what) =
                (source.name.to_owned(), "a style sheet of so many rules for so many elements".to_owned());
            let remedy = ErrorRemedy::ExportWithout { part: "style sheets".to_owned() };
            return Err(ReadError::Unsupported {
                file,
                place: Location::File,
                what,
                remedy: Box::new(remedy),
            });
        };
        let elements = document.descendants().filter(Node::is_element);
        // Of elements with one id the first has it.
        let by_id = elements.rev().filter_map(|node| Some((node.attribute("id")?, node))).collect();
        let ends = document.input_text().bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        let lines = std::iter::once(0).chain(ends.map(|(at, _)| at + 1)).collect();
        Ok(Self { source, document, by_id, styles, lines })
    }

    pub(super) fn by_id(&self, id: &str) -> Option<Node<'a, 'input>> {
        self.by_id.get(id).copied()
    }

    /// The line where an element begins.
    pub(super) fn place(&self, node: Node<'_, '_>) -> Location {
        Location::Line(self.lines.partition_point(|&begin| begin <= node.range().start))
    }

    /// A wrong value of an attribute.
    pub(super) fn refuse(&self, node: Node<'_, '_>, name: &str, what: &str) -> ReadError {
        let found = node.attribute(name).unwrap_or_default();
        let expected = format!("another value of {name} ({what})");
        self.source.syntax(self.place(node), found, expected, plain_svg())
    }

    pub(super) fn unsupported(&self, node: Node<'_, '_>, what: &str, remedy: ErrorRemedy) -> ReadError {
        let (file, place) = (self.source.name.to_owned(), self.place(node));
        ReadError::Unsupported { file, place, what: what.to_owned(), remedy: Box::new(remedy) }
    }
}

/// What an editor of drawings writes without its own additions.
fn plain_svg() -> ErrorRemedy {
    ErrorRemedy::ExportAs { form: "plain SVG".to_owned() }
}
