//! Lines with placeholders, which people write and whose values come from designs: neither may become a
//! command that was not meant.

use wirebend_driver_api::DriverError;

use super::refusal::refuse;

/// Placeholders of texts. They may stand in comments only: a name is no command.
const TEXTS: [&str; 4] = ["name", "design", "job", "machine"];
/// Placeholders of numbers.
const NUMBERS: [&str; 3] = ["wire", "steps", STOCK];
const STOCK: &str = "stock_mm";
/// What three decimals can show, up to what has room in a line, mm.
const STOCK_MM: std::ops::RangeInclusive<f64> = 0.001..=9_999_999.0;
/// The longest that a text becomes: a hash has 64 letters.
pub(crate) const MAX_TEXT: usize = 64;
/// The longest that a number becomes, such as 4294967295 or 123456.789.
const MAX_NUMBER: usize = 12;
/// grbl keeps 79 characters of a line, comments and blanks left out (`LINE_BUFFER_SIZE` 80, `protocol.h`).
const MAX_CODE: usize = 79;
/// What fits into grbl's receive buffer together with its end (`RX_BUFFER_SIZE` 128, `serial.h`).
const MAX_LINE: usize = 126;

/// What the placeholders stand for.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Names {
    pub name: String,
    pub design: String,
    pub job: String,
    pub machine: String,
    pub wire: usize,
    pub steps: usize,
    pub stock_mm: Option<f64>,
}

/// Text as it may stand in a comment. A comment cannot be ended by it, and none of its characters is taken
/// out of the line by grbl, which acts on `!`, `~`, `?` and every byte above 127 wherever they stand.
pub(crate) fn clean(text: &str) -> String {
    let kept = |c: char| {
        if c.is_ascii_alphanumeric() || " -_.,:+=/#'".contains(c) { c } else { '_' }
    };
    text.chars().take(MAX_TEXT).map(kept).collect()
}

impl Names {
    /// The lines of a block that was checked, by its key. Refuses the stock where it is no length: a 0 in its
    /// place could move the machine to where it was not meant to go.
    pub fn fill(&self, key: &str, block: &[String]) -> Result<Vec<String>, DriverError> {
        let stock = self.stock_mm.filter(|stock_mm| STOCK_MM.contains(stock_mm));
        let stock = stock.map(|stock_mm| format!("{stock_mm:.3}"));
        let line = |(index, line): (usize, &String)| {
            let filled = self.fill_line(line, stock.as_deref());
            filled.ok_or_else(|| self.no_stock(key, index + 1))
        };
        block.iter().enumerate().map(line).collect()
    }

    /// Nothing where the line has the stock and there is none.
    fn fill_line(&self, line: &str, stock: Option<&str>) -> Option<String> {
        let texts = [&self.name, &self.design, &self.job, &self.machine];
        let placed = |placeholder: &str| format!("{{{placeholder}}}");
        let stock = if line.contains(&placed(STOCK)) { stock? } else { "" };
        let mut line = line.to_owned();
        for (placeholder, value) in TEXTS.iter().zip(texts) {
            line = line.replace(&placed(placeholder), &clean(value));
        }
        let numbers = [self.wire.to_string(), self.steps.to_string(), stock.to_owned()];
        for (placeholder, value) in NUMBERS.iter().zip(numbers) {
            line = line.replace(&placed(placeholder), &value);
        }
        Some(line)
    }

    fn no_stock(&self, key: &str, line: usize) -> DriverError {
        let found = self.stock_mm.map_or_else(|| "not known".to_owned(), |stock_mm| format!("{stock_mm} mm"));
        DriverError::new(
            "no-stock",
            format!(
                "wire {}: '{key}', line {line} has {{{STOCK}}}, and the stock of this wire is {found}",
                self.wire
            ),
            format!("plan the wire so that its stock is known, or take {{{STOCK}}} out of the line"),
        )
    }
}

/// Refuses lines that cannot be sent, by key and line. Lines count from 1.
pub(super) fn check(key: &str, lines: &[String], placeholders: bool) -> Result<(), DriverError> {
    for (index, line) in lines.iter().enumerate() {
        let wrong = |what: String, help: &str| refuse(format!("'{key}', line {}: {what}", index + 1), help);
        if let Some(bad) = line.chars().find(|c| !c.is_ascii() || c.is_ascii_control() || "!?~".contains(*c))
        {
            return Err(wrong(
                format!("the character '{}' is not possible", bad.escape_default()),
                "grbl acts on !, ? and ~ wherever they stand, and lines are ASCII: leave it out",
            ));
        }
        if line.trim_start().starts_with('$') {
            return Err(wrong(
                "'$' commands are not part of a program".to_owned(),
                "write G-code; the driver homes the machine by itself",
            ));
        }
        measure(line, placeholders).map_err(|(what, help)| wrong(what, help))?;
    }
    Ok(())
}

/// Walks through a line: placeholders that are known and where they may be, and room for all of it.
fn measure(line: &str, placeholders: bool) -> Result<(), (String, &'static str)> {
    let (mut code, mut all) = (0, 0);
    let (mut parenthesis, mut semicolon) = (false, false);
    let mut rest = line;
    while let Some(c) = rest.chars().next() {
        let comment = parenthesis || semicolon;
        let mut length = 1;
        match c {
            '{' => {
                let Some(end) = rest.find('}') else {
                    return Err(("a '{' has no '}'".to_owned(), "close the placeholder"));
                };
                let name = &rest[1..end];
                length = room(name, comment, placeholders)?;
                rest = &rest[end..];
            }
            '}' => return Err(("a '}' has no '{'".to_owned(), "leave it out, or open the placeholder")),
            '(' if !comment => parenthesis = true,
            ')' if parenthesis => parenthesis = false,
            ';' if !comment => semicolon = true,
            _ => {}
        }
        all += length;
        if !comment && !parenthesis && !semicolon && !c.is_whitespace() {
            code += length;
        }
        rest = &rest[1..];
    }
    if code > MAX_CODE || all > MAX_LINE {
        return Err((
            format!("it can become {all} characters, {code} of them outside comments"),
            "grbl takes 126 of which 79 may be outside comments: make it two lines",
        ));
    }
    Ok(())
}

/// The longest that a placeholder becomes.
fn room(name: &str, comment: bool, placeholders: bool) -> Result<usize, (String, &'static str)> {
    if !placeholders {
        return Err((
            format!("the placeholder {{{name}}} is not possible here"),
            "'start_block' and 'end_block' have placeholders",
        ));
    }
    if NUMBERS.contains(&name) {
        return Ok(MAX_NUMBER);
    }
    if !TEXTS.contains(&name) {
        return Err((
            format!("{{{name}}} is not a placeholder"),
            "there are {name}, {design}, {job}, {machine}, {wire}, {steps} and {stock_mm}",
        ));
    }
    if comment {
        return Ok(MAX_TEXT);
    }
    Err((format!("{{{name}}} is a text and stands outside a comment"), "put it into a comment: (…) or ; …"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(line: &str) -> String {
        check("start_block", &[String::new(), line.to_owned()], true).expect_err(line).to_string()
    }

    #[test]
    fn what_cannot_be_sent_is_refused_with_key_and_line() {
        for (line, part) in [
            ("G0 {x}", "'start_block', line 2: {x} is not a placeholder"),
            ("G0 {name}", "{name} is a text and stands outside a comment"),
            ("(a) {design}", "stands outside a comment"),
            ("(a {wire", "a '{' has no '}'"),
            ("(a wire})", "a '}' has no '{'"),
            ("(what?)", "the character '?' is not possible"),
            ("M3\nM5", "the character '\\n' is not possible"),
            ("(Stück)", "the character '\\u{fc}' is not possible"),
            (" $H", "'$' commands"),
            ("({name}{design})", "it can become 130 characters"),
        ] {
            assert!(said(line).contains(part), "{line}: {}", said(line));
        }
        assert!(said(&"G".repeat(80)).contains("80 of them outside comments"));
        let error = check("pin_in", &["M5 ({wire})".to_owned()], false).expect_err("no placeholders");
        assert!(error.to_string().contains("'pin_in', line 1: the placeholder {wire} is not possible here"));
    }

    #[test]
    fn what_can_be_sent_is_taken() {
        for line in ["", "G0 X{stock_mm} (for {name}) M8", "; {design} ( {wire}", &"G 1".repeat(26)] {
            check("end_block", &[line.to_owned()], true).expect(line);
        }
    }

    #[test]
    fn a_name_cannot_end_its_comment_nor_reach_the_machine() {
        let name = ") G0 X99 ; \u{18}!~?\n\u{84}é";
        assert_eq!(clean(name), "_ G0 X99 _ _______");
        let names = Names {
            name: name.to_owned(),
            design: "{name}".to_owned(),
            job: "d".repeat(70),
            machine: "m".to_owned(),
            wire: 1,
            steps: 2,
            stock_mm: Some(420.0),
        };
        let filled = |line: &str| names.fill("start_block", &[line.to_owned()]).unwrap().concat();
        assert_eq!(filled("({name})"), "(_ G0 X99 _ _______)");
        // A value is not filled in itself.
        assert_eq!(filled("; {design}"), "; _name_");
        assert_eq!(filled("({job})").len(), 66);
        assert_eq!(filled("P{wire} Q{steps} X{stock_mm} (m {machine})"), "P1 Q2 X420.000 (m m)");
    }
}
