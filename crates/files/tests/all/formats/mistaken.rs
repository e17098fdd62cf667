//! Files that are opened for something else: each is named as what it is.

use wirebend_error::{ErrorCode, ErrorRemedy};
use wirebend_files::read::{Format, ReadOptions, read};

use super::import;

/// Who has only the program for their machine left tries to open that.
#[test]
fn g_code_is_refused_by_its_name() {
    let program = "; a wire\nG21\nG91\nG1 X30.642 F600\nG1 A66.232 F900\nM30\n";
    let known = Format::ALL.map(Format::name).join(", ");
    for name in ["a.nc", "a.gcode", "a.NC", "a.txt", "a.obj", "a.csv", "standard input"] {
        let error = import(name, program).unwrap_err();
        assert_eq!(error.to_string(), format!("{name}: G-code can't be opened; these formats can: {known}"));
        assert_eq!(
            (error.code(), error.remedies()),
            (ErrorCode::ReadUnknownFormat, vec![ErrorRemedy::OpenModel])
        );
    }
    // A name alone says so where nothing else is known of the content; a table keeps its own.
    assert!(import("a.ngc", "Dear diary").unwrap_err().to_string().contains("G-code can't be opened"));
    assert!(import("a.nc", "L,R,A\n100,0,90\n50,0,0\n").is_ok());
    let error = read(program.as_bytes(), "a.nc", Some(Format::Lra), &ReadOptions::default()).unwrap_err();
    assert!(error.to_string().contains("G-code can't be opened"), "{error}");
}

/// Who has the result of FrameFab looks for the frame in it.
#[test]
fn an_order_of_struts_is_refused_as_what_it_is() {
    let order = include_str!("../../data/framefab/bunny_result.json");
    let error = import("bunny_result.json", order).unwrap_err();
    assert!(error.to_string().contains("an order in which struts are built"), "{error}");
    assert_eq!(error.remedies(), [ErrorRemedy::OpenModel]);
}
