//! G-code, which is recognised so that its error can name it. It commands the axes of one machine, in words that every
//! control and workshop gives its own meaning: no wire can be read back from it.

use super::text::lines;

/// The extensions that programs give it.
const EXTENSIONS: [&str; 7] = ["gcode", "nc", "ngc", "gco", "cnc", "tap", "g"];

/// How many blocks tell what a text is.
const TELLING: usize = 3;

/// Whether a file has a name that only G-code has.
pub(super) fn is_named(extension: Option<&str>) -> bool {
    extension.is_some_and(|extension| EXTENSIONS.contains(&extension))
}

/// Whether a text begins with blocks of G-code, of which one has a G or M word.
pub(super) fn looks_like(text: &str) -> bool {
    let mut blocks = lines(text).map(|(_, line)| without_comments(line)).filter(|block| !is_aside(block));
    let telling: Option<Vec<bool>> = blocks.by_ref().take(TELLING).map(|block| commands(&block)).collect();
    telling.is_some_and(|blocks| blocks.contains(&true))
}

/// A line without what stands in brackets or after a semicolon, and without spaces at its ends.
fn without_comments(line: &str) -> String {
    let (mut block, mut in_comment) = (String::new(), false);
    for c in line.chars() {
        match c {
            ';' if !in_comment => break,
            '(' => in_comment = true,
            ')' if in_comment => in_comment = false,
            c if !in_comment => block.push(c),
            _ => {}
        }
    }
    block.trim().to_owned()
}

/// What may stand between blocks: nothing, the mark of a tape, a setting of the control.
fn is_aside(block: &str) -> bool {
    block.is_empty() || block == "%" || block.starts_with('$')
}

/// Whether a block has a G or M word; `None` where it is no block: letters, each with a number right behind it.
fn commands(block: &str) -> Option<bool> {
    let mut rest = block.trim_start_matches('/').trim_start();
    let mut found = false;
    while let Some(letter) = rest.chars().next() {
        if !letter.is_ascii_alphabetic() {
            return None;
        }
        let behind = &rest[1..];
        let end = behind.find(|c: char| !(c.is_ascii_digit() || "+-.".contains(c))).unwrap_or(behind.len());
        let (number, after) = behind.split_at(end);
        number.parse::<f64>().ok()?;
        found |= matches!(letter.to_ascii_uppercase(), 'G' | 'M');
        // A checksum ends the block.
        rest = after.split('*').next().unwrap_or_default().trim_start();
    }
    Some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first of them are in the words of three publishers: RS274/NGC (NIST), grbl and Marlin.
    #[test]
    fn blocks_are_told_from_other_lines_of_letters_and_numbers() {
        for text in [
            "%\nO0001 (a part)\nN10 G21 G90\nN20 G00 X1.5 Y-.5\n",
            "$H\nG21\nG91 G1 X30.642 F600\n",
            ";FLAVOR:Marlin\n;TIME:6\nN1 M104 S200*97\nG28 ; home\nG1 X0 Y0\n",
            "g1x10y20\r\ng1x0\r\n",
            "/M6 T1",
        ] {
            assert!(looks_like(text), "{text}");
        }
        for text in [
            "",
            "F 30.642\nB 66.232\n",
            "F30\nR90\nB45\n",
            "FEED 10\nBEND 45\n",
            "L,R,A\n1,2,3\n",
            "v 0 0 0\ng 1\n",
            "G\nM\n",
            "G1 and then some prose\n",
            "G1 X1\nThe rest is prose.\n",
            "(only a comment)\n; and another\n",
            "Ä1",
        ] {
            assert!(!looks_like(text), "{text}");
        }
    }
}
