//! Golden cases: designs through every stage, a file a stage under `tests/golden/<case>/`.
//!
//! The files show what changes; whether it is right is said by `case.json`, whose facts come from
//! elsewhere, and by properties that hold for every case. `UPDATE_EXPECT=1` rewrites the files.

mod facts;
mod properties;
mod stages;

use std::collections::BTreeSet;

use crate::cases::{self, Case};

/// A test for each case, by the name of its folder.
macro_rules! cases {
    ($($case:ident),* $(,)?) => {
        $(
            #[test]
            fn $case() {
                is_what_its_files_and_facts_say(&stringify!($case).replace('_', "-"));
            }
        )*

        #[test]
        fn every_case_has_a_test() {
            let known = [$(stringify!($case).replace('_', "-")),*];
            let there: Vec<String> = cases::all().into_iter().map(|(name, ..)| name).collect();
            assert_eq!(there, known, "name every folder of tests/golden in the list of tests, in order");
        }
    };
}

cases!(
    bunny,
    collinear,
    cube,
    cube_8_edges,
    cube_closed,
    cube_not_doubled,
    cup_holder,
    fold_back,
    house,
    isogrid,
    mirror_left,
    mirror_right,
    spring,
    teapot,
    truss_0,
    truss_1,
    truss_2,
    truss_3,
    two_parts,
    u_sample
);

fn is_what_its_files_and_facts_say(name: &str) {
    let folder = cases::root().join("tests/golden").join(name);
    let case = Case::load(&folder);
    let made = stages::files(&case);
    let mut expected: BTreeSet<String> = made.iter().map(|(file, _)| file.clone()).collect();
    for (file, text) in made {
        expect_test::expect_file![folder.join(file)].assert_eq(&text);
    }
    expected.insert("case.json".to_owned());
    let on_disk = std::fs::read_dir(&folder).unwrap();
    let on_disk: BTreeSet<String> =
        on_disk.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    assert_eq!(on_disk, expected, "{name}: files that no stage makes, or stages without a file");
    case.assert_facts();
    properties::assert_all(&case);
}

#[test]
fn mirror_images_differ_in_the_signs_of_their_turns_alone() {
    let steps = |name: &str| {
        let case = Case::load(&cases::root().join("tests/golden").join(name));
        case.plan("wirebend-kit").wires()[0].program.clone().unwrap().steps
    };
    let (left, right) = (steps("mirror-left"), steps("mirror-right"));
    assert_eq!(left.len(), right.len());
    assert!(left.iter().any(|step| step.rotate_deg.abs() > 5.0), "flat wires have no handedness");
    for (a, b) in left.iter().zip(&right) {
        assert!((a.feed_mm - b.feed_mm).abs() < 1e-6 && (a.bend_deg - b.bend_deg).abs() < 1e-6);
        assert!((a.rotate_deg + b.rotate_deg).abs() < 1e-6, "{} and {}", a.rotate_deg, b.rotate_deg);
    }
}
