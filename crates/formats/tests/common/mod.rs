//! Helpers for the tests of all formats.
#![allow(dead_code, reason = "each test binary uses a part")]

use formats::{Bezier, Format, Import, Model, NamedBytes, NamedMesh};
use glam::{Vec2, Vec3};
use halfedge::{Mesh, PolygonSoup, keys};
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;

/// Reads with nobody watching the progress. What the report warns of must be readable.
pub fn read(files: &[NamedBytes]) -> Result<Import, formats::ReadError> {
    let import = formats::read(files, &mut |_| ControlFlow::Continue(()))?;
    for warning in import.report.warnings() {
        assert!(colons(warning) <= 2, "reasons go into brackets: {warning}");
    }
    Ok(import)
}

/// The number of colons in a text, without those in brackets.
fn colons(text: &str) -> usize {
    let mut depth = 0;
    let outside = text.chars().filter(|letter| {
        depth += i32::from(*letter == '(') - i32::from(*letter == ')');
        depth == 0
    });
    outside.collect::<String>().matches(": ").count()
}

/// Reads one text as an OBJ.
pub fn read_obj(text: &str) -> Import {
    read(&[NamedBytes::new("test.obj", text)]).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// The one mesh of an import, checked.
pub fn mesh(import: &Import) -> &Mesh {
    assert_eq!(import.model.objects.len(), 1);
    import.model.objects[0].mesh.validate().expect("a valid mesh");
    &import.model.objects[0].mesh
}

/// Six times the volume of a closed mesh of triangles, more than zero where its faces look outward.
pub fn volume(mesh: &Mesh) -> f32 {
    let of = |f| {
        let corners: Vec<_> = mesh.face_vertices(f).map(|v| mesh.position(v)).collect();
        corners[0].dot(corners[1].cross(corners[2]))
    };
    mesh.faces().map(of).sum()
}

/// A tetrahedron with texture coordinates that tell where each corner lies and the normals of its faces.
pub fn tetrahedron() -> Mesh {
    let positions = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z];
    let faces = [[0u32, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
    let mut mesh = Mesh::build(PolygonSoup::new(positions, &faces)).expect("small").mesh;
    for f in mesh.faces().collect::<Vec<_>>() {
        let corners: Vec<_> = mesh.face_halfedges(f).collect();
        let at = |i: usize| mesh.position(mesh.from(corners[i]));
        let normal = (at(1) - at(0)).cross(at(2) - at(0)).normalize();
        for &h in &corners {
            let p = mesh.position(mesh.from(h));
            mesh.set(keys::CORNER_UV, h.index(), Vec2::new(p.x + 2.0 * p.y, p.z));
            mesh.set(keys::CORNER_NORMAL, h.index(), normal);
        }
    }
    mesh
}

/// Checks that a mesh read is the tetrahedron, placed so that `back` takes it where it was: faces look
/// outward, corners still have their texture coordinates, and normals those of their faces.
pub fn check_tetrahedron(mesh: &Mesh, back: impl Fn(Vec3) -> Vec3) {
    assert_eq!((mesh.vertex_count(), mesh.face_count()), (4, 4));
    assert!(volume(mesh) > 0.0, "{}", volume(mesh));
    for f in mesh.faces() {
        let corners: Vec<_> = mesh.face_halfedges(f).collect();
        let at = |i: usize| mesh.position(mesh.from(corners[i]));
        let normal = (at(1) - at(0)).cross(at(2) - at(0)).normalize();
        for &h in &corners {
            let p = back(mesh.position(mesh.from(h)));
            let uv = mesh.get(keys::CORNER_UV, h.index());
            assert!(uv.distance(Vec2::new(p.x + 2.0 * p.y, p.z)) < 1e-5, "{p}: {uv}");
            let kept = mesh.get(keys::CORNER_NORMAL, h.index());
            assert!(kept.distance(normal) < 1e-5, "{normal}: {kept}");
        }
    }
}

/// The format of this code.
pub fn by_code(code: &str) -> Format {
    Format::from_code(code).unwrap_or_else(|| panic!("{code} is no format"))
}

/// What was read, under another name.
pub fn renamed(import: &Import, name: &str) -> Model {
    Model { name: name.to_owned(), ..import.model.clone() }
}

/// A model of meshes with these names.
pub fn model(name: &str, meshes: &[(&str, &Mesh)]) -> Model {
    let object = |&(name, mesh): &(&str, &Mesh)| NamedMesh::new(name, mesh.clone());
    Model { name: name.to_owned(), objects: meshes.iter().map(object).collect(), ..Model::default() }
}

/// A Bezier object without the mesh that shows it.
pub fn bezier(name: &str, bezier: &Bezier) -> NamedMesh {
    NamedMesh { bezier: Some(Arc::new(bezier.clone())), ..NamedMesh::new(name, Mesh::new()) }
}

/// Writes one mesh.
pub fn write(format: Format, mesh: &Mesh) -> Vec<NamedBytes> {
    formats::write(format, &Model::of_mesh("test", mesh.clone())).expect("small enough")
}

/// The text of a written file.
pub fn text(file: &NamedBytes) -> &str {
    std::str::from_utf8(&file.bytes).expect("UTF-8")
}

/// A file from disk.
pub fn load(path: &Path) -> NamedBytes {
    let name = path.file_name().expect("a file").to_string_lossy();
    NamedBytes::new(name, std::fs::read(path).expect("readable"))
}

/// A file of `tests/cases`, which holds files made after faults of other programs.
pub fn case_file(name: &str) -> NamedBytes {
    load(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases").join(name))
}
