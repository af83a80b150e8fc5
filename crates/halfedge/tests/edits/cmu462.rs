//! Pairs of meshes before and after an edit, from the CMU 15-462 course: exactly one edge gives each result.

use glam::Vec3;
use halfedge::edit::*;
use halfedge::{EdgeId, Mesh, PolygonSoup, Refusal};
use std::path::PathBuf;

fixtures::shared_tests!(flip_split_and_collapse_are_those_of_the_course);

/// Reads the mesh of a file of the course: one `polylist`, whose vertex indices come first.
fn read(path: &PathBuf) -> Mesh {
    let text = std::fs::read_to_string(path).unwrap();
    let document = roxmltree::Document::parse(&text).unwrap();
    let find = |name: &str| document.descendants().find(|node| node.has_tag_name(name)).unwrap();
    let numbers = |node: roxmltree::Node<'_, '_>| node.text().unwrap().to_owned();
    let list = find("polylist");
    let child = |name: &str| list.children().find(|node| node.has_tag_name(name)).unwrap();
    let inputs = list.children().filter(|node| node.has_tag_name("input")).count();
    let positions: Vec<f32> = document
        .descendants()
        .find(|node| node.has_tag_name("float_array") && node.attribute("id").unwrap().contains("positions"))
        .map(numbers)
        .unwrap()
        .split_whitespace()
        .map(|n| n.parse().unwrap())
        .collect();
    let positions = positions.chunks(3).map(Vec3::from_slice).collect();
    let all: Vec<u32> = numbers(child("p")).split_whitespace().map(|n| n.parse().unwrap()).collect();
    let mut corners = all.iter().step_by(inputs).copied();
    let mut soup = PolygonSoup { positions, ..PolygonSoup::default() };
    for degree in numbers(child("vcount")).split_whitespace() {
        let degree: usize = degree.parse().unwrap();
        soup.push_face(corners.by_ref().take(degree).collect::<Vec<_>>());
    }
    let built = Mesh::build(soup).unwrap();
    assert!(built.notes.is_empty(), "{}: {:?}", path.display(), built.notes);
    built.mesh
}

/// The faces by the positions of their corners in units of 1e-4, independent of ids.
fn geometry(mesh: &Mesh) -> Vec<Vec<[i32; 3]>> {
    let mut all: Vec<Vec<[i32; 3]>> = mesh
        .faces()
        .map(|f| {
            let mut corners: Vec<_> = mesh
                .face_vertices(f)
                .map(|v| (mesh.position(v) * 1e4).round().as_ivec3().to_array())
                .collect();
            let first = (0..corners.len()).min_by_key(|&i| corners[i]).unwrap();
            corners.rotate_left(first);
            corners
        })
        .collect();
    all.sort();
    all
}

fn flip_split_and_collapse_are_those_of_the_course() {
    let folder = fixtures::shared("models/cmu462");
    type Edit = fn(&mut Mesh, EdgeId) -> Result<(), Refusal>;
    let edits: [(&str, Edit); 3] = [
        ("edgeFlip", flip_edge),
        ("edgeSplit", |mesh, edge| split_edge(mesh, edge, 0.5, Connect::Triangles).map(drop)),
        ("edgeCollapse", |mesh, edge| collapse_edge(mesh, edge, 0.5).map(drop)),
    ];
    for model in ["cube", "torus", "icosahedron"] {
        let before = read(&folder.join(model).join("input.dae"));
        for (name, edit) in edits {
            let after = geometry(&read(&folder.join(model).join(format!("{name}.dae"))));
            let found: Vec<EdgeId> = before
                .edges()
                .filter(|&edge| {
                    let mut mesh = before.clone();
                    edit(&mut mesh, edge).is_ok() && geometry(&mesh) == after
                })
                .collect();
            println!("{model}, {name}: {found:?}");
            assert_eq!(found.len(), 1, "{model}, {name}");
        }
    }
}
