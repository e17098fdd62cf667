//! Files that are no profiles.

use std::path::Path;

use expect_test::expect;
use wirebend_profile::{Library, MAX_FILE_BYTES, check_file};

use crate::refusals::{child, refuse, refuse_folder};

#[test]
fn broken_json_is_shown_where_it_breaks() {
    refuse(
        "mine.json",
        "{\n\"schema_version\": 1,\n\"kind\" \"machine\"}",
        expect![[r#"
            profile-syntax: mine.json:3: not JSON: expected `:` (column 8) [CorrectProfile]
        "#]],
    );
}

#[test]
fn an_unknown_key_is_answered_with_the_nearest_one() {
    let text = child("\"limits\": {\n\"max_bend\": 3}");
    refuse(
        "mine.json",
        &text,
        expect![[r#"
            profile-shape: mine.json:7: unknown field `max_bend`, expected one of `min_bend_deg`, `max_bend_deg`, `min_edge_mm`, `min_feed_mm`, `max_feed_mm`, `max_stock_mm`, `tail_mm`, `min_rotation_deg`, `max_rotation_deg` (column 10) [ChooseKnown { near: ["max_bend_deg", "max_feed_mm", "max_rotation_deg"], known: [] }]
        "#]],
    );
}

#[test]
fn a_figure_without_a_source_is_refused() {
    let text = child("\"limits\": {\n\"tail_mm\": {\"value\": 3, \"measured\": true}}");
    refuse(
        "mine.json",
        &text,
        expect![[r#"
            profile-shape: mine.json:7: missing field `source` (column 41) [AddKey { text: "\"source\"" }]
        "#]],
    );
    let text = child("\"limits\": {\n\"tail_mm\": 3}");
    refuse(
        "mine.json",
        &text,
        expect![[r#"
            profile-shape: mine.json:7: invalid type: integer `3`, expected a figure with its source (column 12) [AddKey { text: "{\"value\": number, \"source\": text, \"measured\": true or false}" }]
        "#]],
    );
    let text = child("\"limits\": {\n\"tail_mm\": {\"value\": 3, \"source\": \" \", \"measured\": true}}");
    refuse(
        "mine.json",
        &text,
        expect![[r#"
            profile-rule: mine.json:7: limits.tail_mm.source is an empty text, expected where the figure comes from, or why it is an estimate [CorrectProfile]
        "#]],
    );
}

#[test]
fn a_sign_is_one_or_minus_one() {
    refuse(
        "mine.json",
        &child("\"signs\": {\"bend\": 2}"),
        expect![[r#"
            profile-shape: mine.json:6: a sign is 1 or -1, not 2 (column 20) [SeeSchema]
        "#]],
    );
}

#[test]
fn a_number_that_is_too_large_for_a_number_is_refused() {
    let text = child("\"limits\": {\"tail_mm\": {\"value\": 1e999, \"source\": \"s\", \"measured\": true}}");
    refuse(
        "mine.json",
        &text,
        expect![[r#"
            profile-syntax: mine.json:6: not JSON: number out of range (column 37) [CorrectProfile]
        "#]],
    );
}

#[test]
fn a_file_says_what_it_describes() {
    refuse(
        "mine.json",
        "{\"schema_version\": 1, \"id\": \"mine\"}",
        expect![[r#"
            profile-unknown-kind: mine.json:1: no "kind", expected "kind": "machine", "material", "noise" or "strut-builder" [CorrectProfile]
        "#]],
    );
    refuse(
        "mine.json",
        "{\n\"kind\": \"robot\"}",
        expect![[r#"
            profile-unknown-kind: mine.json:2: the unknown kind "robot", expected "kind": "machine", "material", "noise" or "strut-builder" [CorrectProfile]
        "#]],
    );
    refuse(
        "mine.json",
        "{\n\"kind\": 3}",
        expect![[r#"
            profile-unknown-kind: mine.json:2: a "kind" that is not text, expected "kind": "machine", "material", "noise" or "strut-builder" [CorrectProfile]
        "#]],
    );
    refuse(
        "mine.json",
        "[1]",
        expect![[r#"
            profile-unknown-kind: mine.json:1: not a JSON object, expected "kind": "machine", "material", "noise" or "strut-builder" [CorrectProfile]
        "#]],
    );
}

#[test]
fn a_newer_format_asks_for_an_update_and_not_for_other_keys() {
    let text = "{\"kind\": \"machine\",\n\"schema_version\": 2, \"id\": \"mine\", \"warp\": 9}";
    refuse(
        "mine.json",
        text,
        expect![[r#"
            profile-newer-version: mine.json:2: schema_version 2, this program reads up to 1 [UpdateProgram]
        "#]],
    );
    let text = "{\"kind\": \"machine\",\n\"schema_version\": 0, \"id\": \"mine\"}";
    refuse(
        "mine.json",
        text,
        expect![[r#"
            profile-rule: mine.json:2: schema_version is 0, expected 1 [CorrectProfile]
        "#]],
    );
}

#[test]
fn an_id_is_a_slug_and_the_files_name() {
    let text = child("").replace("\"mine\"", "\"My Bender\"");
    refuse(
        "My Bender.json",
        &text,
        expect![[r#"
            profile-bad-id: My Bender.json:4: the id `My Bender` must be of lower-case letters, digits and single hyphens, such as `my-bender` [ChooseOtherId]
        "#]],
    );
    refuse(
        "folder/yours.json",
        &child(""),
        expect![[r#"
            profile-id-not-file-name: folder/yours.json:4: the id `mine` differs from the file's name [RenameFile { name: "mine.json" }]
        "#]],
    );
}

#[test]
fn a_file_that_is_no_profile_at_all_is_refused_before_it_is_read() {
    let large = vec![b' '; MAX_FILE_BYTES + 1];
    let in_wrong_folder = child("").replace("\"mine\"", "\"machine\"");
    let files: [(&str, &[u8]); 3] = [
        ("machines/large.json", &large),
        ("machines/latin.json", b"{\"name\": \"\xe9\"}"),
        ("noise/machine.json", in_wrong_folder.as_bytes()),
    ];
    refuse_folder(
        &files,
        expect![[r#"
            profile-too-large: PROFILES/machines/large.json: larger than 1048576 bytes, which no profile is [CheckRightFile]
            profile-not-text: PROFILES/machines/latin.json: not UTF-8 text (byte 10) [ExportAs { form: "UTF-8 text" }]
            profile-wrong-folder: PROFILES/noise/machine.json:3: a machine profile in the folder noise/ [MoveFile { folder: "machines/" }]
        "#]],
    );
}

#[test]
fn a_folder_or_file_that_is_not_there_is_said_to_be() {
    let nowhere = Path::new("/no/such/folder");
    let added = Library::shipped().unwrap().add_folder(nowhere);
    assert_eq!(added.refused[0].code(), "profile-unreadable");
    assert!(added.refused[0].to_string().starts_with("/no/such/folder: cannot be read"));
    let errors = check_file(&nowhere.join("mine.json")).unwrap_err();
    assert_eq!(errors[0].code(), "profile-unreadable");
}
