//! OBJ files made by others, and random ones: what comes in goes out and comes in the same; `tobj`
//! reads the same; damage never panics.

use super::common::{self, by_code, load, mesh, read, write};
use fixtures::{fixtures, shared_files};
use formats::NamedBytes;
use halfedge::{Mesh, NONE};
use proptest::prelude::*;

fixtures::shared_tests!(common_models_have_their_counts_and_round_trip);

/// Vertices, faces and boundary edges as the models' README states them; for those that need
/// repair the counts are of the file.
const COUNTS: [(&str, usize, usize, usize); 10] = [
    ("alligator", 3208, 5981, 433),
    ("beetle", 1148, 2053, 296),
    ("cheburashka", 6669, 13334, 0),
    ("cow", 2903, 5804, 0),
    ("fandisk", 6475, 12946, 0),
    ("spot", 2930, 5856, 0),
    ("spot_control_mesh", 188, 180, 0),
    ("spot_quadrangulated", 2930, 2928, 0),
    ("stanford-bunny", 35947, 69451, 223),
    ("teapot", 3644, 6320, 1036),
];

fn boundary_edges(mesh: &Mesh) -> usize {
    mesh.edges().filter(|&e| mesh.is_boundary_edge(e)).count()
}

/// What is written reads back as the same mesh, bit for bit and label for label.
fn assert_round_trip(name: &str, mesh: &Mesh) {
    let files = write(by_code("obj"), mesh);
    let back = read(&files).unwrap_or_else(|error| panic!("{name}: {error}"));
    assert!(back.report.is_clean(), "{name}: {}", back.report);
    assert!(common::mesh(&back) == mesh, "{name} comes back different");
}

fn common_models_have_their_counts_and_round_trip() {
    for path in shared_files("models/common", "obj") {
        let file = load(&path);
        let import = read(std::slice::from_ref(&file)).expect("readable");
        let mesh = mesh(&import);
        let name = file.stem();
        let &(_, vertices, faces, boundary) =
            COUNTS.iter().find(|(n, ..)| *n == name).unwrap_or_else(|| panic!("{name} is not in the table"));
        // Separating non-manifold edges and vertices adds vertices and boundary.
        let separated: usize = mesh.vertex_count() - vertices;
        assert_eq!(mesh.face_count(), faces, "{name}: {}", import.report);
        match name {
            "beetle" => assert!(boundary_edges(mesh) > boundary && separated > 0, "{}", import.report),
            _ => assert_eq!(boundary_edges(mesh), boundary, "{name}"),
        }
        match name {
            // Their vertices in several fans.
            "teapot" => {
                assert!(import.report.to_string().contains("38 vertices separated"), "{}", import.report)
            }
            "cow" => assert!(import.report.to_string().contains("1 vertex separated"), "{}", import.report),
            "beetle" => {}
            _ => {
                assert_eq!(separated, 0, "{name}");
                assert!(import.report.is_clean(), "{name}: {}", import.report);
            }
        }
        assert_round_trip(name, mesh);
    }
}

#[test]
fn small_cases_read_with_their_materials_and_round_trip() {
    let libraries: Vec<NamedBytes> = fixtures("obj-cases", "mtl").iter().map(|path| load(path)).collect();
    for path in fixtures("obj-cases", "obj") {
        let mut files = vec![load(&path)];
        let alone = read(&files).unwrap_or_else(|error| panic!("{error}"));
        assert_round_trip(&files[0].name, mesh(&alone));
        files.extend(libraries.iter().cloned());
        let import = read(&files).unwrap_or_else(|error| panic!("{error}"));
        let mesh = mesh(&import);
        assert_round_trip(&files[0].name, mesh);
        assert!(mesh.positions() == alone.model.objects[0].mesh.positions());
        match files[0].stem() {
            "cube" => {
                let color = |f: usize| mesh.get(halfedge::keys::FACE_COLOR, f).0;
                assert_eq!([0, 2, 4].map(color), [[255, 255, 255], [255, 0, 0], [0, 255, 0]]);
            }
            "smoothing-group-two-squares" => assert_eq!(mesh.face_count(), 2),
            "line-prim" | "points-prim" => {
                assert_eq!((mesh.vertex_count(), mesh.face_count()), (8, 0));
                assert!(import.report.to_string().contains("only faces are edited"));
            }
            "invalid-face-definition" => assert_eq!((mesh.vertex_count(), mesh.face_count()), (8, 0)),
            "invalid-relative-vertex-index" => {
                assert_eq!(mesh.vertex_count(), 0);
                assert!(import.report.to_string().contains("line 1"));
            }
            _ => {}
        }
    }
}

/// The text of an OBJ with these positions and faces, laid out at random.
fn obj_text(positions: &[[f32; 3]], faces: &[Vec<usize>], style: u8) -> String {
    let mut text = String::new();
    let end = if style & 1 == 0 { "\n" } else { " \r\n\t\r\n # comment\r\n" };
    for [x, y, z] in positions {
        match style >> 1 & 3 {
            0 => text += &format!("v {x} {y} {z}{end}"),
            1 => text += &format!("v  {x:e}\t{y:e} {z:e}{end}"),
            _ => text += &format!("v {x:.5} {y:.5} {z:.5}{end}"),
        }
    }
    for face in faces {
        text += "f";
        for &corner in face {
            match style >> 3 & 1 {
                0 => text += &format!(" {}", corner + 1),
                _ => text += &format!(" {}", corner as i64 - positions.len() as i64),
            }
        }
        text += end;
    }
    text
}

fn any_obj() -> impl Strategy<Value = (Vec<[f32; 3]>, Vec<Vec<usize>>, u8)> {
    prop::collection::vec(prop::array::uniform3(-1e6f32..1e6), 3..20).prop_flat_map(|positions| {
        let count = positions.len();
        let face = prop::collection::vec(0..count, 3..6);
        (Just(positions), prop::collection::vec(face, 0..20), any::<u8>())
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// `tobj` reads the same corner positions, bit for bit, face by face.
    #[test]
    fn agrees_with_tobj((positions, faces, style) in any_obj()) {
        let text = obj_text(&positions, &faces, style);
        let ours = read(&[NamedBytes::new("a.obj", text.as_str())]).expect("valid");
        let mesh = mesh(&ours);
        prop_assert!(mesh.vertex_count() >= positions.len());
        // Faces that fit no manifold are ours to repair: compare those the report doesn't mention.
        let options = tobj::LoadOptions { triangulate: false, single_index: false, ..Default::default() };
        let (models, _) = tobj::load_obj_buf(&mut text.as_bytes(), &options, |_| Ok(Default::default())).expect("valid");
        let mut theirs = Vec::new();
        for model in &models {
            let mut at = 0;
            let arities = if model.mesh.face_arities.is_empty() {
                vec![3; model.mesh.indices.len() / 3]
            } else {
                model.mesh.face_arities.clone()
            };
            for arity in arities {
                let corners = &model.mesh.indices[at..at + arity as usize];
                at += arity as usize;
                theirs.push(corners.iter().map(|&i| {
                    let p = &model.mesh.positions[i as usize * 3..][..3];
                    [p[0].to_bits(), p[1].to_bits(), p[2].to_bits()]
                }).collect::<Vec<_>>());
            }
        }
        prop_assert_eq!(theirs.len(), faces.len());
        let ours_faces: Vec<Vec<[u32; 3]>> = mesh
            .faces()
            .map(|f| mesh.face_vertices(f).map(|v| mesh.position(v).to_array().map(f32::to_bits)).collect())
            .collect();
        if ours.report.is_clean() {
            prop_assert_eq!(ours_faces, theirs);
        } else {
            // Every face kept is one of theirs, possibly turned or without repeated corners.
            for face in ours_faces {
                let set = |f: &[[u32; 3]]| { let mut s = f.to_vec(); s.sort_unstable(); s.dedup(); s };
                prop_assert!(theirs.iter().any(|other| set(other) == set(&face)));
            }
        }
    }

    /// Whatever is read is valid, and what was written of it reads back the same.
    #[test]
    fn random_soups_round_trip((positions, faces, style) in any_obj()) {
        let text = obj_text(&positions, &faces, style);
        let import = read(&[NamedBytes::new("a.obj", text)]).expect("valid");
        assert_round_trip("random", mesh(&import));
    }
}

/// A file with one of everything, to damage.
const EVERYTHING: &str = "\u{feff}# all\nmtllib a.mtl\no body\nv 0 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1\nv 0 1 0\nv .5 .5 1e0\nvt 0 0\nvt 1 0\nvt 1 1 0\nvn 0 0 1\nvn 0 -1 0\ng a b\nusemtl red\ns 1\nf 1/1/1 2/2/1 3/3/1 4/1/1\nf -1 -4 -5\ns off\nf 2//2 5//2 3//1\nf 3/1 \\\n 5/2 4/3\ng\nusemtl color-00ff00\nl 1 2\np 1\nf 4 5 1\ncurv 0 1 1 2\n";

fn damage(bytes: &mut Vec<u8>, kind: u8, at: usize, value: u8) {
    const PIECES: [&[u8]; 16] = [
        b"\n",
        b" ",
        b"/",
        b"-",
        b"\\\n",
        b"f 1 2 3\n",
        b"v 1e39 nan -inf\n",
        b"999999999999999999999",
        b"0",
        b"#",
        b"f -1 -2 -3 -4 -5 -6\n",
        b"\r",
        b"\xff\xfe",
        b"f 1/4294967295/1 2//-2147483648 3\n",
        b"4294967296",
        b"o\ng\ns 1\n",
    ];
    let at = at % (bytes.len() + 1);
    match kind % 5 {
        0 if at < bytes.len() => bytes[at] = value,
        1 if at < bytes.len() => {
            bytes.remove(at);
        }
        2 => bytes.truncate(at),
        3 => {
            let end = (at + usize::from(value)).min(bytes.len());
            let copy = bytes[at..end].to_vec();
            bytes.extend(copy);
        }
        _ => {
            bytes.splice(at..at, PIECES[usize::from(value) % 16].iter().copied());
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    /// Damaged files are errors or valid meshes, which round trip: never a panic.
    #[test]
    fn damaged_files_never_panic(
        damages in prop::collection::vec((any::<u8>(), any::<usize>(), any::<u8>()), 1..12),
        library in prop::collection::vec(any::<u8>(), 0..40),
    ) {
        let mut bytes = EVERYTHING.as_bytes().to_vec();
        for (kind, at, value) in damages {
            damage(&mut bytes, kind, at, value);
        }
        let mut material = b"newmtl red\nKd ".to_vec();
        material.extend(library);
        let files = [NamedBytes::new("a.obj", bytes), NamedBytes::new("a.mtl", material)];
        if let Ok(import) = read(&files) {
            let mesh = mesh(&import);
            let labels = mesh.column(halfedge::Element::Face, "group").map_or(0, |column| column.labels.len());
            let groups = mesh.attribute(halfedge::keys::FACE_GROUP).unwrap_or_default();
            prop_assert!(groups.iter().all(|&group| group == NONE || (group as usize) < labels));
            let again = read(&write(by_code("obj"), mesh)).expect("what was written reads");
            prop_assert!(again.report.is_clean(), "{}", again.report);
            prop_assert!(again.model.objects[0].mesh.to_soup().positions == mesh.to_soup().positions);
            prop_assert!(again.model.objects[0].mesh.to_soup().corners == mesh.to_soup().corners);
        }
    }

    #[test]
    fn any_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        if let Ok(import) = read(&[NamedBytes::new("a.obj", bytes)]) {
            mesh(&import);
        }
    }
}
