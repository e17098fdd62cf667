//! What style sheets of a drawing hide.

use wirebend_files::read::Imported;

use super::drawn::edges;
use super::svg::page;
use super::{import, notes};

fn of(elements: &str) -> Imported {
    import("a.svg", page(elements)).unwrap_or_else(|error| panic!("{error}"))
}

/// The x where the lines that are drawn end, by which the tests tell them.
fn drawn(elements: &str) -> Vec<f64> {
    edges(&of(elements)).iter().map(|ends| ends[1][0]).collect()
}

fn hidden(imported: &Imported) -> usize {
    imported.notes.iter().filter(|note| note.kind.code() == "hidden-ignored").map(|note| note.count).sum()
}

/// Construction lines of Illustrator and of CAD programs are hidden by a class.
#[test]
fn a_sheet_hides_by_class_id_and_element() {
    let sheet = "<style type=\"text/css\"><![CDATA[ /* of a program */\n.st0{fill:none;stroke:#000;display:none;}\n\
        #help , g.off{visibility:hidden}\n ellipse{ DISPLAY : none !important } .st1{stroke:red} ]]></style>";
    let lines = "<line class=\"st0\" x2=\"1\"/><line id=\"help\" x2=\"2\"/><g class=\"a off b\"><line x2=\"3\"/>\
        <line visibility=\"visible\" x2=\"4\"/></g><ellipse class=\"st1\" rx=\"3\" ry=\"2\"/><line class=\"st1 st2\" x2=\"5\"/>\
        <line class=\"off\" x2=\"6\"/>";
    let imported = of(&format!("{sheet}{lines}"));
    assert_eq!(drawn(&format!("{sheet}{lines}")), [4.0, 5.0, 6.0]);
    assert_eq!(hidden(&imported), 4);
    assert!(notes(&imported.notes).contains(&"4 hidden elements left out".to_owned()));
    // A sheet may stand behind what it hides.
    assert_eq!(drawn(&format!("{lines}{sheet}")), [4.0, 5.0, 6.0]);
}

/// CSS 2.1, 6.4: !important, then the style attribute, then ids, classes, elements, then what comes last; attributes
/// of the element itself come before all rules.
#[test]
fn the_stronger_rule_wins() {
    let of_rules = |rules: &str, line: &str| {
        !drawn(&format!("<style>{rules}</style><line style=\"visibility:visible;display:inline\" x2=\"9\"/><line {line} x2=\"1\"/>")).contains(&1.0)
    };
    assert!(of_rules(".a{display:none}", "class=\"a\" display=\"inline\""));
    assert!(!of_rules(".a{display:none}", "class=\"a\" style=\"display:inline\""));
    assert!(of_rules(".a{display:none!important}", "class=\"a\" style=\"display:inline\""));
    assert!(of_rules("#i{display:none} .a{display:inline}", "class=\"a\" id=\"i\""));
    assert!(!of_rules(".a{display:none} .b{display:inline}", "class=\"b a\""));
    assert!(of_rules(".a.b{display:none} .b{display:inline}", "class=\"b a\""));
    assert!(!of_rules(".a.c{display:none}", "class=\"b a\""));
    assert!(!of_rules("circle.a{display:none}", "class=\"a\""));
    assert!(of_rules("*{visibility:hidden} #none{}", "id=\"i\""));
    assert!(of_rules("line.a{display:none} line{display:inline}", "class=\"a\""));
    assert!(of_rules(".a{display:none;display:bogus}", "class=\"a\""));
    assert!(of_rules("svg .a{display:none}", "class=\"a\""));
    assert!(of_rules("svg > .a{display:none}", "class=\"a\""));
    assert!(!of_rules("g .a{display:none}", "class=\"a\""));
}

#[test]
fn rules_that_are_not_understood_are_counted() {
    let sheet = "<style>@import url(other.css); @media print { .a{display:none} } line:hover{display:none} \
        line[x2]{visibility:hidden} .b + .c{display:none} line:hover{stroke:red} .a{</style>";
    let imported = of(&format!("{sheet}<line class=\"a\" x2=\"1\"/>"));
    assert_eq!(edges(&imported).len(), 1);
    let expected = "5 rules of style sheets not understood: what they hide is read";
    assert!(notes(&imported.notes).contains(&expected.to_owned()), "{:?}", notes(&imported.notes));
    let other = of(
        "<style type=\"text/less\">.a{display:none}</style><style media=\"print\">.a{display:none}</style>\
        <style media=\"screen\">.b{display:none}</style><line class=\"a\" x2=\"1\"/><line class=\"b\" x2=\"2\"/>",
    );
    assert_eq!(edges(&other).len(), 1);
    let expected = "2 rules of style sheets not understood: what they hide is read";
    assert!(notes(&other.notes).contains(&expected.to_owned()), "{:?}", notes(&other.notes));
}

#[test]
fn a_page_that_is_hidden_holds_nothing() {
    for hide in ["display=\"none\"", "style=\"display:none\"", "visibility=\"hidden\""] {
        let text = page("<line x2=\"1\"/>").replacen("<svg", &format!("<svg {hide}"), 1);
        let error = import("a.svg", text).unwrap_err();
        assert!(error.to_string().contains("(1 hidden element left out)"), "{hide}: {error}");
    }
    // A transform of a sheet would move what it names.
    let text = page("<style>.a{transform:scale(2)}</style><line class=\"a\" x2=\"1\"/>");
    assert_eq!(import("a.svg", text).unwrap_err().code(), "read-unsupported");
}
