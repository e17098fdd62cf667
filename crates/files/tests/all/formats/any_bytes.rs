//! No bytes make a reader panic, and none make it believe a count.

use base64::Engine as _;
use proptest::prelude::*;
use proptest::sample::Index;
use wirebend_files::document::{Document, Job};
use wirebend_files::read::{Format, ReadOptions, detect, read};

use super::data;

fn read_as_all(bytes: &[u8], options: &ReadOptions) {
    let _ = detect("file.csv", bytes);
    for format in Format::ALL {
        let _ = read(bytes, "file", Some(format), options);
    }
    let _ = Document::open(bytes, "file");
    let _ = Job::open(bytes, "file");
}

/// Small valid files of every format, to be broken.
pub fn valid_files() -> Vec<(Format, Vec<u8>)> {
    let text = |format, text: &str| (format, text.as_bytes().to_vec());
    let mut stl = vec![0_u8; 84 + 100];
    stl[80] = 2;
    stl[84..].iter_mut().enumerate().for_each(|(k, byte)| *byte = u8::try_from(k * 7 % 60).unwrap());
    let mut ply = b"ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\nproperty double y\nproperty uchar z\nelement face 1\nproperty list uchar uint vertex_indices\nend_header\n".to_vec();
    ply.extend([0; 39]);
    ply.extend([3, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 2]);
    let mut frame = data("assembly-instances/four-frame.json").0;
    frame.truncate(frame.len());
    let document =
        Document::new(read(b"F 10\nB 90\nF 10", "a.txt", None, &ReadOptions::default()).unwrap().wireframe);
    let drawings = super::broken_drawings::small_files()
        .into_iter()
        .map(|(name, bytes)| (detect(name, &bytes).unwrap(), bytes));
    let buffer = base64::prelude::BASE64_STANDARD.encode(super::models::buffer());
    let buffer = format!("{{\"uri\": \"data:;base64,{buffer}\", \"byteLength\": 60}}");
    let mut files = vec![
        text(Format::Gltf, &super::models::scene("[{\"mesh\": 0}]", super::models::QUAD, &buffer)),
        text(Format::Obj, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1/1/1 2//2 3 -1\nl 1 2 3\nvn 0 0 1\n"),
        (Format::Stl, stl),
        text(
            Format::Stl,
            "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\nendsolid a\n",
        ),
        (Format::Ply, ply),
        text(
            Format::Ply,
            "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nelement edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n0 0 0\n1 0 0\n0 1\n",
        ),
        text(Format::Xyz, "x_mm;y_mm;z_mm\n0;0;0\n1,5;0;0\n1,5;2;0\n"),
        (Format::Assembly, frame),
        (Format::Conmech, data("conmech/four-frame.json").0),
        text(Format::Pwf, "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\np 1 2\nc 1 3\ng 2 3 4\n"),
        text(Format::Kit, "# design\nF 10\nR -90\nB 45\nF 20\n"),
        text(Format::Pensa, "FEED 10 (x)\nROTATE -90\nBEND 45\nPINZ -5\nFEED 20\n"),
        text(Format::Lra, "L,R,A,CLR\n10,0,90,5\n20,-,45,5\n30\n"),
        text(Format::Lra, "D_mm,Rabs_deg,A_deg,CLR_mm\n10,350,90,5\n37.85,10,45,5\n71.78\n"),
        (Format::Moves, include_bytes!("../../../../../fuzz/seeds/moves/corner.wbmoves").to_vec()),
        (Format::Wirebend, document.to_bytes().unwrap()),
    ];
    files.extend(drawings);
    files.extend([
        (Format::Obj, include_bytes!("../../../../../fuzz/seeds/obj/utf16.obj").to_vec()),
        (Format::Ply, include_bytes!("../../../../../fuzz/seeds/ply/odd.ply").to_vec()),
        (Format::Stl, include_bytes!("../../../../../fuzz/seeds/stl/odd.stl").to_vec()),
        (Format::Lra, include_bytes!("../../../../../fuzz/seeds/lra/left.csv").to_vec()),
        (Format::Pensa, include_bytes!("../../../../../fuzz/seeds/pensa/told.dsw").to_vec()),
    ]);
    files
}

#[test]
fn the_files_are_valid_before_they_are_broken() {
    for (format, bytes) in valid_files() {
        let result = read(&bytes, "file", Some(format), &ReadOptions::default());
        assert!(result.is_ok(), "{format}: {}", result.unwrap_err());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn any_bytes(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        read_as_all(&bytes, &ReadOptions::default());
    }

    #[test]
    fn any_text(text in "[vlfpcgFRB0-9 .,;\\-e\n\t(){}\"#a-z]{0,200}") {
        read_as_all(text.as_bytes(), &ReadOptions { face_edges: true, ..ReadOptions::default() });
    }

    #[test]
    fn broken_files(
        choice: Index,
        cut in any::<Index>(),
        changes in prop::collection::vec((any::<Index>(), any::<u8>()), 0..6),
        doubled: bool,
        scale in prop_oneof![Just(1.0), Just(1e300), Just(1e-300)],
    ) {
        let files = valid_files();
        let (format, mut bytes) = choice.get(&files).clone();
        for (place, byte) in changes {
            let place = place.index(bytes.len());
            bytes[place] = byte;
        }
        if doubled {
            bytes.extend_from_within(..);
        } else {
            bytes.truncate(cut.index(bytes.len() + 1).max(1));
        }
        let options = ReadOptions { face_edges: doubled, scale, ..ReadOptions::default() };
        let _ = read(&bytes, "file", Some(format), &options);
        let _ = detect("file", &bytes);
    }
}
