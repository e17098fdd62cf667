//! How documents are laid out: two levels deep a line each, deeper levels in one line, so that a
//! vertex is a line and a difference between two versions can be read.

use std::io::{self, Write};

use serde::Serialize;
use serde_json::ser::{Formatter, Serializer};

use super::error::DocumentError;

/// Values deeper than this stay on the line of their parent.
const MAX_LINE_DEPTH: usize = 3;

#[derive(Default)]
struct Layout {
    depth: usize,
}

impl Layout {
    fn line<W: Write + ?Sized>(&self, writer: &mut W) -> io::Result<()> {
        if self.depth > MAX_LINE_DEPTH {
            return Ok(());
        }
        writer.write_all(b"\n")?;
        (0..self.depth).try_for_each(|_| writer.write_all(b"  "))
    }

    fn separate<W: Write + ?Sized>(&self, writer: &mut W, first: bool) -> io::Result<()> {
        if !first {
            writer.write_all(if self.depth > MAX_LINE_DEPTH { b", " } else { b"," })?;
        }
        self.line(writer)
    }

    fn close<W: Write + ?Sized>(&mut self, writer: &mut W, mark: &[u8]) -> io::Result<()> {
        let inline = self.depth > MAX_LINE_DEPTH;
        self.depth -= 1;
        if !inline {
            self.line(writer)?;
        }
        writer.write_all(mark)
    }
}

impl Formatter for Layout {
    fn begin_array<W: Write + ?Sized>(&mut self, writer: &mut W) -> io::Result<()> {
        self.depth += 1;
        writer.write_all(b"[")
    }

    fn end_array<W: Write + ?Sized>(&mut self, writer: &mut W) -> io::Result<()> {
        self.close(writer, b"]")
    }

    fn begin_array_value<W: Write + ?Sized>(&mut self, writer: &mut W, first: bool) -> io::Result<()> {
        self.separate(writer, first)
    }

    fn begin_object<W: Write + ?Sized>(&mut self, writer: &mut W) -> io::Result<()> {
        self.depth += 1;
        writer.write_all(b"{")
    }

    fn end_object<W: Write + ?Sized>(&mut self, writer: &mut W) -> io::Result<()> {
        self.close(writer, b"}")
    }

    fn begin_object_key<W: Write + ?Sized>(&mut self, writer: &mut W, first: bool) -> io::Result<()> {
        self.separate(writer, first)
    }

    fn begin_object_value<W: Write + ?Sized>(&mut self, writer: &mut W) -> io::Result<()> {
        writer.write_all(b": ")
    }
}

/// A value as JSON with a line end behind it.
pub(crate) fn to_bytes(value: &impl Serialize) -> Result<Vec<u8>, DocumentError> {
    let mut bytes = Vec::new();
    value
        .serialize(&mut Serializer::with_formatter(&mut bytes, Layout::default()))
        .map_err(DocumentError::Write)?;
    bytes.push(b'\n');
    Ok(bytes)
}
