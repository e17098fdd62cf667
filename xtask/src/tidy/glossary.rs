//! Rule: the glossary has each term once. A term is what stands in bold letters.

use super::finding::Finding;
use super::tree::TreeFile;

const NAME: &str = "GLOSSARY.md";

/// Terms that an earlier entry has already.
pub(super) fn check(files: &[TreeFile]) -> Vec<Finding> {
    let glossary = files.iter().find(|file| file.path == NAME);
    let terms: Vec<(usize, String)> = glossary.iter().flat_map(|file| terms(file)).collect();
    let mut findings = Vec::new();
    for (k, (line, term)) in terms.iter().enumerate() {
        if let Some((first, _)) = terms[..k].iter().find(|(_, earlier)| earlier == term) {
            let what = format!("the term '{term}' has an entry in line {first}");
            let why = "a word with two meanings is misread";
            let to_do = "use another word for one of them, or join the entries";
            findings.push(Finding::new(NAME, *line, what, why, to_do));
        }
    }
    findings
}

/// Each term with its line: `**Accept, trust**` are two.
fn terms(file: &TreeFile) -> Vec<(usize, String)> {
    let in_bold = |text: &str| -> Vec<String> {
        let bold = text.split("**").skip(1).step_by(2);
        bold.flat_map(|terms| terms.split(',')).map(|term| term.trim().to_lowercase()).collect()
    };
    // A sentence in bold letters that begins a paragraph is a heading.
    let is_heading = |term: &String| term.ends_with('.');
    let lines = file.lines().flat_map(|(line, text)| in_bold(text).into_iter().map(move |term| (line, term)));
    lines.filter(|(_, term)| !is_heading(term)).collect()
}

#[cfg(test)]
mod tests {
    use super::super::sample::{file, places};
    use super::*;

    #[test]
    fn a_second_entry_of_a_term_is_found_on_its_line() {
        let text = "# Glossary\n\n- **Pin**: a remark.\n- **Peg**: a rod beside the pin.\n- **Post, pin**: what the wire wraps.\n";
        let found = check(&[file(NAME, text)]);
        assert_eq!(places(&found), ["GLOSSARY.md:5"]);
        assert_eq!(found[0].what, "the term 'pin' has an entry in line 3");
    }

    #[test]
    fn a_term_within_another_entry_counts_too() {
        let text = "- **Hold**: stands still. **Alarm**: was stopped.\n- **Home**: and **alarm** again.\n";
        assert_eq!(places(&check(&[file(NAME, text)])), ["GLOSSARY.md:2"]);
    }

    #[test]
    fn different_terms_headings_and_other_documents_are_fine() {
        let text = "**Numbering.** One.\n\n**Numbering.** Two.\n- **Head**: turns.\n- **Head position**: an angle.\n";
        assert!(check(&[file(NAME, text), file("README.md", "**Pin** and **pin**")]).is_empty());
    }
}
