//! Formats are told by content: whatever a file is called, it is read as what it holds, or refused.

mod common;

use common::{bezier, by_code, model, read};
use formats::{Bezier, Format, Model, NamedBytes, NamedMesh};
use glam::Vec3;

/// The extensions of all formats that can be read.
fn extensions() -> Vec<&'static str> {
    let all = Format::all().filter(|format| format.can_read());
    all.flat_map(|format| format.extensions().iter().copied()).collect()
}

/// What each writer writes, under names without extension.
fn written() -> Vec<(Format, Vec<NamedBytes>)> {
    let points = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z];
    let (curve, surface) =
        (Bezier::from_points(true, points.to_vec()), Bezier::from_points(false, points.repeat(8)));
    let formats = Format::all().filter(|&format| format.can_write() && format != by_code("json"));
    formats
        .map(|format| {
            let object = match format.code() {
                "bzc" => bezier("x", &curve),
                "bez" => bezier("x", &surface),
                _ => NamedMesh::new("x", common::tetrahedron()),
            };
            let model = Model { name: "x".to_owned(), objects: vec![object], ..Model::default() };
            (format, formats::write(format, &model).expect("what the format holds"))
        })
        .collect()
}

#[test]
fn every_content_is_read_under_every_extension() {
    for (format, files) in written() {
        let expected = read(&files).expect("its own").model.objects;
        for extension in extensions() {
            let mut files = files.clone();
            files[0].name = format!("x.{extension}");
            let import = read(&files).unwrap_or_else(|error| panic!("{format:?} as .{extension}: {error}"));
            assert!(import.model.objects == expected, "{format:?} as .{extension}");
            // What is called a surface may be one that ends early.
            let is_doubtful = format == by_code("bzc") && extension == "bez";
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
    assert_eq!((import.model.objects.len(), import.model.name.as_str()), (1, "box"));
    assert_eq!(import.model.materials.list.len(), 1);
    // A model by the name of a material library is a model.
    let import = read(&[NamedBytes { name: "box.mtl".to_owned(), ..obj }]).expect("an OBJ");
    assert_eq!(import.model.objects[0].mesh.face_count(), 1);
}

#[test]
fn content_without_a_model_is_refused_under_every_extension() {
    let readme = "# Read me\n\nsolid advice: v 1 of this text is 3 lines long.\nf sharp, 1 note\nply wood\n{ and } <a>\n";
    // Bytes that follow from nothing.
    let mut random = fixtures::Random(0x9e37_79b9_7f4a_7c15);
    let mut noise = |length: usize| -> Vec<u8> { (0..length).map(|_| random.byte()).collect() };
    let mut garbage: Vec<Vec<u8>> =
        vec![readme.into(), readme.repeat(40).into(), vec![0; 4000], vec![b' '; 200]];
    garbage.extend([100, 134, 200, 3000, 100_000].map(&mut noise));
    for extension in extensions() {
        for bytes in &garbage {
            let name = format!("x.{extension}");
            let error = read(&[NamedBytes::new(name.as_str(), bytes.clone())])
                .map(|import| import.report.to_string());
            let error = error.expect_err(&format!("{} bytes as {name}", bytes.len())).to_string();
            assert!(error.starts_with(&format!("Could not open {name}. ")), "{error}");
            assert!(error.ends_with('.') && error.matches(": ").count() <= 1, "one colon at most: {error}");
            assert!(
                Format::from_extension(extension).is_some_and(Format::is_bezier)
                    || error.contains("Check that it is the right file")
                    || bytes.iter().all(|byte| *byte == b' '),
                "{error}"
            );
        }
    }
}

#[test]
fn an_empty_file_is_called_empty_under_every_name() {
    for extension in extensions().into_iter().chain(["xyz", "jpg"]) {
        for content in ["", " \r\n\t\n"] {
            let name = format!("x.{extension}");
            let error = read(&[NamedBytes::new(name.as_str(), content)]).expect_err("nothing in it");
            assert_eq!(error.to_string(), format!("Could not open {name}. The file is empty."));
        }
    }
}

#[test]
fn binary_stls_cut_short_or_with_more_behind_are_read_as_far_as_they_go() {
    let whole = formats::write(by_code("stl"), &model("x", &[("x", &common::tetrahedron())]))
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

fn detect(name: &str, bytes: &[u8]) -> Option<&'static str> {
    Format::detect(&NamedBytes::new(name, bytes)).map(Format::code)
}

#[test]
fn formats_are_told_by_name_and_by_content() {
    assert_eq!(detect("a/b.OBJ", b""), Some("obj"));
    assert_eq!(detect("pasted", b"# hello\n\n  v 0 0 0\n"), Some("obj"));
    assert_eq!(detect("pasted.txt", b"\xef\xbb\xbff -1/2 1 1"), Some("obj"));
    assert_eq!(detect("pasted.txt", b"vn 0 0 1\n"), Some("obj"));
    assert_eq!(detect("readme.txt", b"v for vendetta\nf sharp\nv 2\nf 16 bit\nv 1 a b"), None);
    assert_eq!(detect("nothing", b""), None);
}

#[test]
fn content_counts_for_more_than_the_name() {
    assert_eq!(detect("a.obj", b"ply\nformat ascii 1.0\n"), Some("ply"));
    assert_eq!(detect("a.stl", b"# x\nCOFF 3 1 0\n"), Some("off"));
    assert_eq!(detect("a.off", b"solid a b\nfacet normal 0 0 1\n"), Some("stl"));
    assert_eq!(detect("a.off", b"solid a\ncolor 1 0 0\nfacet normal 0 0 1\n"), Some("stl"));
    assert_eq!(detect("a.ply", b"{\"accessors\":[{\"componentType\":5126"), Some("gltf"));
    assert_eq!(detect("a.stl", b"v 0 0 0\n"), Some("obj"));
    assert_eq!(detect("a.obj", b"2\n0 0\n1 1\n"), Some("bzc"));
    // An OFF without its first word is one by name only.
    assert_eq!(detect("a.off", b"3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), Some("off"));
}

/// A binary STL of triangles side by side that says it has `count`.
fn binary_stl(count: u32, triangles: u8) -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    bytes[..5].copy_from_slice(b"solid");
    bytes.extend(count.to_le_bytes());
    for i in 0..triangles {
        let x = f32::from(i);
        for c in [0.0, 0.0, 1.0, x, 0.0, 0.0, x + 1.0, 0.0, 0.0, x, 1.0, 0.0] {
            bytes.extend(c.to_le_bytes());
        }
        bytes.extend([0, 0]);
    }
    bytes
}

#[test]
fn a_binary_stl_is_one_whose_triangles_are_there() {
    let whole = binary_stl(4, 4);
    let with_more = [&whole[..], b"made by x"].concat();
    let with_many_more = [&whole[..], &[1; 500]].concat();
    let without_count = [binary_stl(0, 4), binary_stl(u32::MAX, 4)];
    for bytes in [&whole, &whole[..whole.len() - 7], &whole[..140], &with_more, &with_many_more]
        .into_iter()
        .chain(without_count.iter().map(|bytes| &bytes[..]))
    {
        for name in ["model", "a.stl", "a.obj", "a.glb"] {
            assert_eq!(detect(name, bytes), Some("stl"), "{name}, {} bytes", bytes.len());
        }
    }
    // As long as its count says, whatever its triangles are.
    assert_eq!(detect("model", &[vec![1; 80], vec![1, 0, 0, 0], vec![0xff; 50]].concat()), Some("stl"));
    // Not what starts elsewhere, has too absurd a count, or none where its first triangle ends.
    for bytes in [&whole[1..], &binary_stl(u32::MAX - 1, 4), &whole[..130], &[0; 284]] {
        assert_eq!(detect("model", bytes), None, "{} bytes", bytes.len());
    }
}
