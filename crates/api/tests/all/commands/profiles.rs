//! `profile-new` and `profile-explain`: what is refused, and what is never touched.

use std::path::Path;

use wirebend_api::{
    ApiError, Command, DriverFolders, ErrorKind, ErrorRemedy, Installation, NoProgress,
    ProfileExplainRequest, ProfileExplainResponse, ProfileKind, ProfileNewRequest, ProfileNewResponse,
    ProfilePlace, Response,
};

fn request(id: &str, inherits: &str, place: ProfilePlace) -> ProfileNewRequest {
    let (id, inherits) = (id.to_owned(), inherits.to_owned());
    ProfileNewRequest { id, inherits, kind: None, name: None, all: false, place, force: false }
}

/// Runs the command among the shipped profiles and a folder's.
fn new_in(folder: &Path, request: ProfileNewRequest) -> Result<ProfileNewResponse, ApiError> {
    let app = Installation::new(&[folder.to_owned()]).unwrap().with_drivers(no_drivers());
    match Command::ProfileNew(request).run(&app, &NoProgress)? {
        Response::ProfileNew(found) => Ok(*found),
        other => panic!("a new profile answered {other:?}"),
    }
}

/// What lies beside a test program is not for it.
fn no_drivers() -> DriverFolders {
    DriverFolders { own: Some(Vec::new()), ..DriverFolders::default() }
}

fn refused(id: &str, inherits: &str, kind: Option<ProfileKind>) -> ApiError {
    let folder = tempfile::tempdir().unwrap();
    let place = ProfilePlace::Folder(folder.path().to_owned());
    let error =
        new_in(folder.path(), ProfileNewRequest { kind, ..request(id, inherits, place) }).unwrap_err();
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0, "nothing is written: {error}");
    error
}

fn write(folder: &Path, path: &str, text: &str) {
    let path = folder.join(path);
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    std::fs::write(path, text).unwrap();
}

#[test]
fn a_new_profile_can_be_used_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let place = ProfilePlace::Folder(folder.path().to_owned());
    let made = new_in(folder.path(), request("my-pensa", "pensa-diwire-pro", place)).unwrap();
    let file = folder.path().join("machines/my-pensa.json");
    assert_eq!((made.file.as_ref(), made.kind), (Some(&file), ProfileKind::Machine));
    let app = Installation::new(&[folder.path().to_owned()]).unwrap();
    assert!(app.refused_profiles().is_empty(), "{:?}", app.refused_profiles());
    let explain = ProfileExplainRequest { id: "my-pensa".into(), kind: None };
    let Response::ProfileExplain(found) = Command::ProfileExplain(explain).run(&app, &NoProgress).unwrap()
    else {
        panic!("an explanation answered something else");
    };
    let ProfileExplainResponse { chain, values, .. } = *found;
    let chain: Vec<_> = chain.iter().map(|link| (link.id.as_str(), link.shipped)).collect();
    assert_eq!(chain, [("my-pensa", false), ("pensa-diwire-pro", true)]);
    let name = values.iter().find(|value| value.key == "name").unwrap();
    assert_eq!((name.value.as_str(), name.line), (Some("my-pensa"), Some(6)), "the last of five lines");
}

#[test]
fn an_id_that_is_none_becomes_no_path() {
    for id in ["My Bender", "../bender", "bender.json", ""] {
        let error = refused(id, "grbl-bender", None);
        assert_eq!((error.code().as_str(), error.kind()), ("value", ErrorKind::Usage), "{error}");
        assert!(error.to_string().contains("my-bender"), "{error}");
    }
}

#[test]
fn a_taken_id_is_refused_with_the_file_that_has_it() {
    let error = refused("pensa-diwire-pro", "grbl-bender", None);
    assert_eq!((error.code().as_str(), error.kind()), ("id-taken", ErrorKind::Usage));
    assert!(error.to_string().contains("machine-profiles/machines/pensa-diwire-pro.json"), "{error}");
    // As a material the id is free.
    let folder = tempfile::tempdir().unwrap();
    let made = new_in(folder.path(), request("pensa-diwire-pro", "steel-1mm", ProfilePlace::Returned));
    assert_eq!(made.unwrap().kind, ProfileKind::Material);
}

/// Whether an id is offered instead.
fn near(error: &ApiError, id: &str) -> bool {
    let offers = |remedy: &ErrorRemedy| matches!(remedy, ErrorRemedy::ChooseKnown { near, .. } if near.iter().any(|one| one == id));
    error.remedies().iter().any(offers)
}

#[test]
fn a_parent_is_found_by_its_id_or_its_kind_is_asked_for() {
    let error = refused("mine", "wirebend-kit", None);
    assert_eq!((error.code().as_str(), error.kind()), ("several-kinds", ErrorKind::Usage));
    let kinds = ["machine", "noise"].map(str::to_owned).to_vec();
    assert_eq!(error.remedies(), [ErrorRemedy::ChooseKind { kinds }]);
    let error = refused("mine", "steel-1mm", Some(ProfileKind::Machine));
    assert_eq!((error.code().as_str(), error.kind()), ("other-kind", ErrorKind::Usage));
    assert!(error.to_string().contains("a material profile"), "{error}");
    let error = refused("mine", "stel-1mm", None);
    assert_eq!((error.code().as_str(), error.kind()), ("profile-unknown-id", ErrorKind::Usage));
    assert!(near(&error, "steel-1mm"), "{:?}", error.remedies());
    let error = refused("mine", "stel-1mm", Some(ProfileKind::Material));
    assert_eq!((error.code().as_str(), error.kind()), ("profile-unknown", ErrorKind::Usage));
    assert!(error.to_string().contains("no material has the id"), "{error}");
}

#[test]
fn a_base_says_what_a_child_of_it_would_lack() {
    let error = refused("mine", "steel-1010", None);
    assert_eq!((error.code().as_str(), error.kind()), ("open-parent", ErrorKind::Usage));
    let said = error.to_string();
    for word in ["diameter_mm", "springback"] {
        assert!(said.contains(word), "{word} is not in {said}");
    }
    let ids = ["steel-0-9mm", "steel-1mm", "steel-3mm"].map(str::to_owned).to_vec();
    assert_eq!(error.remedies(), [ErrorRemedy::InheritFrom { ids }]);
    // A base from which nothing complete inherits.
    let folder = tempfile::tempdir().unwrap();
    let base = r#"{"schema_version": 1, "kind": "noise", "id": "base", "abstract": true}"#;
    write(folder.path(), "noise/base.json", base);
    let error = new_in(folder.path(), request("mine", "base", ProfilePlace::Returned)).unwrap_err();
    assert!(error.to_string().contains("curvature"), "{error}");
    assert!(
        matches!(error.remedies().as_slice(), [ErrorRemedy::InheritFrom { ids }, ErrorRemedy::AddKey { .. }] if ids.is_empty())
    );
}

#[test]
fn a_file_that_is_there_is_replaced_only_on_request() {
    let folder = tempfile::tempdir().unwrap();
    let place = || ProfilePlace::Folder(folder.path().to_owned());
    new_in(folder.path(), request("mine", "grbl-bender", place())).unwrap();
    let again = request("mine", "pensa-diwire-pro", place());
    let error = new_in(folder.path(), again.clone()).unwrap_err();
    assert_eq!((error.code().as_str(), error.kind()), ("exists", ErrorKind::Usage));
    new_in(folder.path(), ProfileNewRequest { force: true, ..again.clone() }).unwrap();
    let text = std::fs::read_to_string(folder.path().join("machines/mine.json")).unwrap();
    assert!(text.contains("pensa-diwire-pro"), "{text}");
    // Elsewhere the id would be there twice.
    let elsewhere = ProfilePlace::File(folder.path().join("mine.json"));
    let error =
        new_in(folder.path(), ProfileNewRequest { force: true, place: elsewhere, ..again }).unwrap_err();
    assert_eq!(error.code(), "id-taken");
    // And a profile is not its own parent.
    let itself = ProfileNewRequest { force: true, ..request("mine", "mine", place()) };
    assert_eq!(new_in(folder.path(), itself).unwrap_err().code(), "profile-cycle");
}

#[test]
fn what_profile_check_would_refuse_is_not_written() {
    let folder = tempfile::tempdir().unwrap();
    let odd = r#"{"schema_version": 1, "kind": "machine", "id": "odd", "inherits": "grbl-bender",
        "export": {"formats": ["no-such-format"]}}"#;
    write(folder.path(), "machines/odd.json", odd);
    let file = folder.path().join("machines/mine.json");
    let copy = ProfileNewRequest { all: true, ..request("mine", "odd", ProfilePlace::File(file.clone())) };
    let error = new_in(folder.path(), copy).unwrap_err();
    assert_eq!((error.code().as_str(), error.kind()), ("profile-rule", ErrorKind::BadInput));
    assert!(error.to_string().contains("no-such-format") && !file.exists(), "{error}");
    let other_name = ProfilePlace::File(folder.path().join("other.json"));
    let error = new_in(folder.path(), request("mine", "grbl-bender", other_name)).unwrap_err();
    assert_eq!(error.code(), "profile-id-not-file-name");
    let blank =
        ProfileNewRequest { name: Some(" ".into()), ..request("mine", "odd", ProfilePlace::Returned) };
    assert_eq!(new_in(folder.path(), blank).unwrap_err().code(), "value");
}

/// An editor finds the schema only where it really lies.
#[test]
fn the_schema_is_named_where_it_lies_beside_the_profile() {
    let folder = tempfile::tempdir().unwrap();
    let text = |place: ProfilePlace| {
        let made = new_in(folder.path(), request("mine", "none", place)).unwrap();
        let written = made.file.map(|file| std::fs::read_to_string(file).unwrap());
        written.unwrap_or_else(|| String::from_utf8(made.contents).unwrap())
    };
    assert!(!text(ProfilePlace::Returned).contains("$schema"));
    write(folder.path(), "schema/noise.schema.json", "{}");
    let beside = text(ProfilePlace::Folder(folder.path().to_owned()));
    assert!(beside.contains("\"$schema\": \"../schema/noise.schema.json\""), "{beside}");
}

#[test]
fn a_folder_that_cannot_be_made_is_said() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), "noise", "a file where the folder should be");
    let place = ProfilePlace::Folder(folder.path().to_owned());
    let error = new_in(folder.path(), request("mine", "none", place)).unwrap_err();
    assert_eq!((error.code().as_str(), error.kind()), ("document-save", ErrorKind::Failure));
}
