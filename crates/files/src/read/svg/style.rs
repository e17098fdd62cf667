//! What style sheets say of elements, as far as it hides them.
//!
//! Selectors of elements, classes and ids are understood, also within and directly within others; the stronger rule wins
//! (CSS 2.1, 6.4). What depends on more, such as `:hover` or the width of a window, is counted where it would hide
//! something.
//!
//! `simplecss` 0.2.2, which `usvg` reads style sheets with, would give wire that a drawing hides: it skips `@media screen { … }`, ends a list of declarations at the first value that it does not know
//! (`font: 12px/1.5 serif; display: none`), and ends names at the letters U+0080 to U+00ED (`.gerät`). It does not tell
//! which rules it has left out, so nothing could be counted, and it tries each selector on each element, with every
//! combination of the elements around it: a small file could keep it busy for ever.

use std::collections::HashMap;
use std::rc::Rc;

use roxmltree::{Document, Node, NodeId};

/// The properties that are read; for those that can hide an element, their valid values.
const LOOKED_AT: &[(&str, Option<&[&str]>)] = &[
    ("display", Some(DISPLAYS)),
    ("visibility", Some(&["visible", "hidden", "collapse", "inherit", "initial", "unset"])),
    ("transform", None),
    ("transform-origin", None),
    ("clip-path", None),
    ("mask", None),
    ("filter", None),
    ("marker", None),
    ("marker-start", None),
    ("marker-mid", None),
    ("marker-end", None),
];
const DISPLAYS: &[&str] = &[
    "none",
    "inline",
    "block",
    "inline-block",
    "list-item",
    "run-in",
    "compact",
    "marker",
    "table",
    "inline-table",
    "table-row-group",
    "table-header-group",
    "table-footer-group",
    "table-row",
    "table-column-group",
    "table-column",
    "table-cell",
    "table-caption",
    "flex",
    "inline-flex",
    "grid",
    "inline-grid",
    "flow-root",
    "contents",
    "inherit",
    "initial",
    "unset",
];
/// How many comparisons of rules with elements are made: a hundred rules for each of twenty thousand elements. Of programs that
/// draw, an element has a class or two with a rule each.
const MAX_COMPARISONS: usize = 2_000_000;
/// How many selectors a drawing may have.
const MAX_RULES: usize = 100_000;
/// How deep `@media screen` blocks may be nested.
const MAX_DEPTH: usize = 8;

/// A property with its value, and whether it is `!important`.
#[derive(Debug, Clone)]
struct Declaration {
    name: &'static str,
    value: String,
    important: bool,
}

/// The declarations between `{` and `}`, or in a style attribute, in order.
fn declarations(text: &str) -> impl Iterator<Item = Declaration> {
    text.split(';').filter_map(|pair| {
        let (name, value) = pair.split_once(':')?;
        let name = name.trim().to_ascii_lowercase();
        let &(name, values) = LOOKED_AT.iter().find(|(known, _)| *known == name)?;
        let (value, mark) = value.split_once('!').unwrap_or((value, ""));
        let value = value.trim().to_owned();
        // An invalid value is ignored.
        let known = values.is_none_or(|values| values.iter().any(|known| value.eq_ignore_ascii_case(known)));
        let value = if values.is_some() { value.to_ascii_lowercase() } else { value };
        let important = mark.trim().eq_ignore_ascii_case("important");
        known.then_some(Declaration { name, value, important })
    })
}

/// The same without declarations that a later one overrides.
fn last_of_each(text: &str) -> Vec<Declaration> {
    let mut last: Vec<Declaration> = Vec::new();
    for said in declarations(text) {
        last.retain(|one| (one.name, one.important) != (said.name, said.important));
        last.push(said);
    }
    last
}

/// One element of a selector: `line.a#b`.
#[derive(Debug, Default)]
struct Simple {
    element: Option<String>,
    classes: Vec<String>,
    ids: Vec<String>,
    /// Whether the element before must be the parent, and not just an ancestor.
    child: bool,
}

impl Simple {
    /// Without a combinator; none where more than names is in it.
    fn parse(text: &str) -> Option<Self> {
        let mut simple = Self::default();
        let mut rest = text;
        while let Some(mark) = rest.chars().next() {
            let behind = if matches!(mark, '.' | '#' | '*') { &rest[1..] } else { rest };
            let is_name = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_') || !c.is_ascii();
            let end = if mark == '*' { 0 } else { behind.find(|c| !is_name(c)).unwrap_or(behind.len()) };
            let (name, after) = behind.split_at(end);
            match mark {
                '*' if rest.len() == text.len() => {}
                '.' if !name.is_empty() => simple.classes.push(name.to_owned()),
                '#' if !name.is_empty() => simple.ids.push(name.to_owned()),
                _ if rest.len() == text.len() && !name.is_empty() => simple.element = Some(name.to_owned()),
                _ => return None,
            }
            rest = after;
        }
        Some(simple)
    }

    fn fits(&self, node: Node<'_, '_>) -> bool {
        let class = node.attribute("class").unwrap_or_default();
        let id = node.attribute("id");
        self.element.as_deref().is_none_or(|name| node.tag_name().name() == name)
            && self.ids.iter().all(|wanted| id == Some(wanted))
            && self.classes.iter().all(|wanted| class.split_whitespace().any(|own| own == wanted))
    }
}

/// The key by which the rules for an element are found.
#[derive(Debug, PartialEq, Eq, Hash)]
enum Key<'a> {
    Id(&'a str),
    Class(&'a str),
    Element(&'a str),
    Any,
}

/// A selector with what it says.
#[derive(Debug)]
struct Rule {
    /// From the outermost element to the one that it is for.
    path: Vec<Simple>,
    said: Rc<[Declaration]>,
}

impl Rule {
    fn strength(&self) -> [usize; 3] {
        let sum = |of: fn(&Simple) -> usize| self.path.iter().map(of).sum();
        [
            sum(|one| one.ids.len()),
            sum(|one| one.classes.len()),
            sum(|one| usize::from(one.element.is_some())),
        ]
    }

    fn key(&self) -> Key<'_> {
        let Some(last) = self.path.last() else { return Key::Any };
        match (last.ids.first(), last.classes.first(), &last.element) {
            (Some(id), ..) => Key::Id(id),
            (_, Some(class), _) => Key::Class(class),
            (_, _, Some(element)) => Key::Element(element),
            _ => Key::Any,
        }
    }

    /// Whether it is for an element; counts the comparisons.
    fn fits(&self, node: Node<'_, '_>, comparisons: &mut usize) -> bool {
        let Some((last, around)) = self.path.split_last() else { return false };
        *comparisons += effort(node);
        let mut child = last.child;
        if !last.fits(node) {
            return false;
        }
        let mut outer = node.parent_element();
        for simple in around.iter().rev() {
            // The nearest match is enough, except for child combinators further out, which drawings do not use.
            let found = std::iter::successors(outer, Node::parent_element)
                .take(if child { 1 } else { usize::MAX })
                .inspect(|node| *comparisons += effort(*node))
                .find(|node| simple.fits(*node));
            let Some(found) = found else { return false };
            child = simple.child;
            outer = found.parent_element();
        }
        true
    }
}

/// The cost of comparing a rule with an element: a long list of classes is searched each time.
fn effort(node: Node<'_, '_>) -> usize {
    1 + node.attribute("class").map_or(0, str::len) / 64
}

/// The computed properties of the elements, from style sheets and style attributes.
#[derive(Debug, Default)]
pub(super) struct Styles {
    said: HashMap<NodeId, Vec<(&'static str, String)>>,
    /// Rules that hide something and whose selectors or conditions are not understood.
    pub(super) misunderstood: usize,
}

impl Styles {
    /// `None` if comparing all rules with all elements would take too long.
    pub(super) fn of(document: &Document<'_>) -> Option<Self> {
        let mut styles = Self::default();
        let mut rules = Vec::new();
        for sheet in document.descendants().filter(|node| node.tag_name().name() == "style") {
            let says = |name: &str, known: &[&str]| {
                let value = sheet.attribute(name).unwrap_or_default().trim();
                value.is_empty() || known.iter().any(|known| value.eq_ignore_ascii_case(known))
            };
            if says("type", &["text/css"]) && says("media", &["all", "screen"]) {
                let text: String = sheet.children().filter_map(|node| node.text()).collect();
                styles.rules(&without_comments(&text), 0, &mut rules);
            } else {
                styles.misunderstood += 1;
            }
        }
        if rules.len() > MAX_RULES {
            return None;
        }
        styles.weigh(document, &rules)?;
        Some(styles)
    }

    fn rules(&mut self, text: &str, depth: usize, rules: &mut Vec<Rule>) {
        let mut rest = text;
        while let Some(at) = rest.find(['{', ';']) {
            let (head, behind) = (rest[..at].trim(), &rest[at + 1..]);
            if rest.as_bytes()[at] == b';' {
                self.misunderstood += usize::from(head.to_ascii_lowercase().starts_with("@import"));
                rest = behind;
                continue;
            }
            let end = closing(behind);
            let body = &behind[..end];
            rest = behind.get(end + 1..).unwrap_or_default();
            if head.starts_with('@') {
                self.block(&head.to_ascii_lowercase(), body, depth, rules);
                continue;
            }
            let said: Rc<[Declaration]> = last_of_each(body).into();
            if said.is_empty() {
                continue;
            }
            // One more than there may be is enough to refuse them.
            for selector in head.split(',').take((MAX_RULES + 1).saturating_sub(rules.len())) {
                match path(selector) {
                    Some(path) => rules.push(Rule { path, said: said.clone() }),
                    None => self.misunderstood += usize::from(hides(said.iter())),
                }
            }
        }
    }

    /// Rules under a condition.
    fn block(&mut self, head: &str, body: &str, depth: usize, rules: &mut Vec<Rule>) {
        if matches!(head, "@media screen" | "@media all") && depth < MAX_DEPTH {
            self.rules(body, depth + 1, rules);
            return;
        }
        let conditional = ["@media", "@supports", "@layer", "@container"];
        let hides = body.split(['{', '}']).any(|said| hides(last_of_each(said).iter()));
        self.misunderstood += usize::from(hides && conditional.iter().any(|name| head.starts_with(name)));
    }

    fn weigh(&mut self, document: &Document<'_>, rules: &[Rule]) -> Option<()> {
        let mut by_key: HashMap<Key<'_>, Vec<usize>> = HashMap::new();
        for (order, rule) in rules.iter().enumerate() {
            by_key.entry(rule.key()).or_default().push(order);
        }
        let mut comparisons = 0;
        for node in document.descendants().filter(Node::is_element) {
            let classes = node.attribute("class").unwrap_or_default().split_whitespace().map(Key::Class);
            let id = node.attribute("id").unwrap_or_default();
            let others = [Key::Any, Key::Element(node.tag_name().name()), Key::Id(id)];
            let mut fitting: Vec<usize> = Vec::new();
            for order in others.into_iter().chain(classes).filter_map(|key| by_key.get(&key)).flatten() {
                if comparisons > MAX_COMPARISONS {
                    return None;
                }
                if rules[*order].fits(node, &mut comparisons) {
                    fitting.push(*order);
                }
            }
            let own = node.attribute("style").map(last_of_each).unwrap_or_default();
            if fitting.is_empty() && own.is_empty() {
                continue;
            }
            // The strongest last, and of equal ones the last in the text.
            fitting.sort_by_key(|&order| (rules[order].strength(), order));
            let sheets: Vec<&Declaration> =
                fitting.iter().flat_map(|&order| rules[order].said.iter()).collect();
            let own: Vec<&Declaration> = own.iter().collect();
            let value = |&(name, _): &(&'static str, Option<&[&str]>)| {
                let find = |said: &[&Declaration], important: bool| {
                    let found = said.iter().rfind(|one| one.name == name && one.important == important);
                    found.map(|one| one.value.clone())
                };
                let strong = find(&own, true).or_else(|| find(&sheets, true));
                let value = strong.or_else(|| find(&own, false)).or_else(|| find(&sheets, false))?;
                Some((name, value))
            };
            self.said.insert(node.id(), LOOKED_AT.iter().filter_map(value).collect());
        }
        Some(())
    }

    /// The value of a property: of the style attribute, of the sheets, or of the attribute of that name.
    pub(super) fn property<'a>(&'a self, node: Node<'a, '_>, name: &str) -> Option<&'a str> {
        let said = self.said.get(&node.id()).and_then(|said| said.iter().find(|(own, _)| *own == name));
        said.map(|(_, value)| value.as_str()).or_else(|| node.attribute(name).map(str::trim))
    }

    /// Whether a style, of a sheet or of its own, moves an element.
    pub(super) fn moves(&self, node: Node<'_, '_>) -> bool {
        let said = self.said.get(&node.id());
        said.is_some_and(|said| said.iter().any(|(name, _)| name.starts_with("transform")))
    }
}

/// Whether something is hidden.
fn hides<'a>(mut said: impl Iterator<Item = &'a Declaration>) -> bool {
    said.any(|one| {
        matches!((one.name, one.value.as_str()), ("display", "none") | ("visibility", "hidden" | "collapse"))
    })
}

/// Where the bracket is that closes the one before the text; its end where there is none.
fn closing(text: &str) -> usize {
    let mut depth = 0_usize;
    for (at, byte) in text.bytes().enumerate() {
        match (byte, depth) {
            (b'{', _) => depth += 1,
            (b'}', 0) => return at,
            (b'}', _) => depth -= 1,
            _ => {}
        }
    }
    text.len()
}

/// The elements of a selector; none where it is not understood.
fn path(selector: &str) -> Option<Vec<Simple>> {
    let spaced = selector.replace('>', " > ");
    let mut path: Vec<Simple> = Vec::new();
    let mut child = false;
    for word in spaced.split_whitespace() {
        if word == ">" {
            if child || path.is_empty() {
                return None;
            }
            child = true;
        } else {
            path.push(Simple { child: std::mem::take(&mut child), ..Simple::parse(word)? });
        }
    }
    (!child && !path.is_empty()).then_some(path)
}

fn without_comments(text: &str) -> String {
    let mut parts = text.split("/*");
    let mut plain = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        plain.push(' ');
        plain.push_str(part.split_once("*/").map_or("", |(_, behind)| behind));
    }
    plain
}
