//! Formats are told by content: whatever a file is called, it is read as what it holds, or refused.

mod common;

use common::read;
use formats::{Controls, Format, NamedBytes, ObjectRef};
use glam::Vec3;
use halfedge::Mesh;

/// The extensions of all formats that can be read.
fn extensions() -> Vec<&'static str> {
    let all = Format::ALL.into_iter().filter(|format| format.can_read());
    all.flat_map(|format| format.extensions().iter().copied()).collect()
}

/// What each writer writes, under names without extension.
fn written() -> Vec<(Format, Vec<NamedBytes>)> {
    let (mesh, empty) = (common::tetrahedron(), Mesh::new());
    let patch = [[Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z]; 4];
    let (curve, surface) = (Controls::Curve(patch[0].to_vec()), Controls::Surface(vec![patch; 2]));
    let formats = Format::ALL.into_iter().filter(|&format| format != Format::Json);
    formats
        .map(|format| {
            let object = match format {
                Format::BezierCurve => ObjectRef { controls: Some(&curve), ..ObjectRef::new("x", &empty) },
                Format::BezierSurface => {
                    ObjectRef { controls: Some(&surface), ..ObjectRef::new("x", &empty) }
                }
                _ => ObjectRef::new("x", &mesh),
            };
            (format, formats::write(format, "x", &[object]).expect("what the format holds"))
        })
        .collect()
}

#[test]
fn every_content_is_read_under_every_extension() {
    for (format, files) in written() {
        let expected = read(&files).expect("its own").objects;
        for extension in extensions() {
            let mut files = files.clone();
            files[0].name = format!("x.{extension}");
            let import = read(&files).unwrap_or_else(|error| panic!("{format:?} as .{extension}: {error}"));
            assert!(import.objects == expected, "{format:?} as .{extension}");
            // What is called a surface may be one that ends early.
            let is_doubtful = format == Format::BezierCurve && extension == "bez";
            assert!(import.report.is_clean() != is_doubtful, "{format:?} as .{extension}: {}", import.report);
            let is_own = format.extensions().contains(&extension);
            let told =
                import.report.to_string().contains(&format!("The file is named .{extension} but holds"));
            let is_alias = extension == "coff";
            assert!(told != (is_own || is_alias), "{format:?} as .{extension}: {}", import.report);
        }
    }
}

#[test]
fn an_obj_by_another_name_still_brings_its_materials() {
    let obj = NamedBytes::new("box.stl", "mtllib box.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
    assert_eq!(formats::companions(&obj), ["box.mtl"]);
    let import = read(&[NamedBytes::new("box.mtl", "newmtl red\nKd 1 0 0\n"), obj.clone()]).expect("an OBJ");
    assert_eq!((import.objects.len(), import.name.as_str()), (1, "box"));
    assert_eq!(import.materials.list.len(), 1);
    // A model by the name of a material library is a model.
    let import = read(&[NamedBytes { name: "box.mtl".to_owned(), ..obj }]).expect("an OBJ");
    assert_eq!(import.objects[0].mesh.face_count(), 1);
}

#[test]
fn what_is_no_model_is_refused_under_every_extension() {
    let readme = "# Read me\n\nsolid advice: v 1 of this text is 3 lines long.\nf sharp, 1 note\nply wood\n{ and } <a>\n";
    // Bytes that follow from nothing (G. Marsaglia, "Xorshift RNGs", 2003).
    let mut state = 0x9e37_79b9_7f4a_7c15u64;
    let mut noise = |length: usize| -> Vec<u8> {
        let mut next = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 32) as u8
        };
        (0..length).map(|_| next()).collect()
    };
    let mut garbage: Vec<Vec<u8>> =
        vec![readme.into(), readme.repeat(40).into(), vec![0; 4000], vec![b' '; 200]];
    garbage.extend([100, 134, 200, 3000, 100_000].map(&mut noise));
    for extension in extensions() {
        for bytes in &garbage {
            let name = format!("x.{extension}");
            let error = read(&[NamedBytes::new(name.as_str(), bytes.clone())])
                .map(|import| import.report.to_string());
            let error = error.expect_err(&format!("{} bytes as {name}", bytes.len())).to_string();
            assert!(error.starts_with(&name) && error.len() > name.len() + 20, "{error}");
            assert!(
                Format::from_extension(extension).is_some_and(Format::is_bezier)
                    || error.contains("check that it is the right file"),
                "{error}"
            );
        }
    }
}

#[test]
fn binary_stls_cut_short_or_with_more_behind_are_read_as_far_as_they_go() {
    let whole = formats::write(Format::Stl, "x", &[ObjectRef::new("x", &common::tetrahedron())])
        .expect("small")
        .remove(0)
        .bytes;
    for extension in ["stl", "obj", "ply"] {
        let read = |bytes: &[u8]| {
            let import = read(&[NamedBytes::new(format!("x.{extension}"), bytes)]).expect("an STL");
            (common::mesh(&import).face_count(), import.report.warnings().collect::<Vec<_>>().join("\n"))
        };
        assert_eq!(read(&whole), (4, String::new()));
        let (faces, warnings) = read(&whole[..84 + 2 * 50 + 13]);
        assert!(
            faces == 2 && warnings.contains("The file ends early: 2 of 4 triangles are there"),
            "{warnings}"
        );
        let (faces, warnings) = read(&[&whole[..], b"the end"].concat());
        assert!(
            faces == 4 && warnings.contains("7 bytes after the last of its 4 triangles left out"),
            "{warnings}"
        );
    }
}
