//! Edges with more than two faces: solids that touch there stay closed.

use glam::{IVec3, Vec3};
use halfedge::{Mesh, NoteKind, PolygonSoup};
use proptest::prelude::*;
use std::collections::{BTreeSet, HashMap};

/// The corners of the faces of a unit cube, counter-clockwise seen from outside, and the directions they look.
const SIDES: [([[i32; 3]; 4], [i32; 3]); 6] = [
    ([[0, 0, 0], [0, 1, 0], [1, 1, 0], [1, 0, 0]], [0, 0, -1]),
    ([[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], [0, 0, 1]),
    ([[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]], [0, -1, 0]),
    ([[0, 1, 0], [0, 1, 1], [1, 1, 1], [1, 1, 0]], [0, 1, 0]),
    ([[0, 0, 0], [0, 0, 1], [0, 1, 1], [0, 1, 0]], [-1, 0, 0]),
    ([[1, 0, 0], [1, 1, 0], [1, 1, 1], [1, 0, 1]], [1, 0, 0]),
];

/// The faces of unit cubes with shared vertices. Without walls, those between two cubes are left out.
fn cubes(at: &BTreeSet<[i32; 3]>, walls: bool) -> (Vec<Vec3>, Vec<Vec<u32>>) {
    let mut positions = Vec::new();
    let mut numbers: HashMap<IVec3, u32> = HashMap::new();
    let mut faces = Vec::new();
    for &cube in at {
        for (corners, direction) in SIDES {
            if !walls && at.contains(&(IVec3::from(cube) + IVec3::from(direction)).to_array()) {
                continue;
            }
            let vertex = |corner: [i32; 3]| {
                let place = IVec3::from(cube) + IVec3::from(corner);
                *numbers.entry(place).or_insert_with(|| {
                    positions.push(place.as_vec3());
                    positions.len() as u32 - 1
                })
            };
            faces.push(corners.map(vertex).to_vec());
        }
    }
    (positions, faces)
}

fn build(positions: Vec<Vec3>, faces: &[Vec<u32>]) -> (Mesh, Vec<NoteKind>) {
    let built = Mesh::build(PolygonSoup::new(positions, faces)).expect("small");
    built.mesh.validate().expect("valid");
    let notes = built.notes.iter().map(|note| note.kind).collect();
    (built.mesh, notes)
}

/// Six times the volume of each component.
fn volumes(mesh: &Mesh) -> Vec<f32> {
    let (component, count) = mesh.components();
    let mut volumes = vec![0.0; count];
    for f in mesh.faces() {
        let corners: Vec<_> = mesh.face_vertices(f).collect();
        let at = |i: usize| mesh.position(corners[i]);
        for i in 2..corners.len() {
            volumes[component[corners[0].index()] as usize] += at(0).dot(at(i - 1).cross(at(i)));
        }
    }
    volumes
}

fn is_closed(mesh: &Mesh) -> bool {
    mesh.boundary_loops().is_empty()
}

#[test]
fn two_cubes_that_share_an_edge_stay_closed() {
    let (positions, faces) = cubes(&[[0, 0, 0], [1, 1, 0]].into(), true);
    assert_eq!((positions.len(), faces.len()), (14, 12));
    // Whichever order the faces come in, and whichever way round each cube is.
    for turn in 0..faces.len() {
        for inside_out in [false, true] {
            let mut faces = faces.clone();
            if inside_out {
                faces[6..].iter_mut().for_each(|face| face.reverse());
            }
            faces.rotate_left(turn);
            let (mesh, notes) = build(positions.clone(), &faces);
            assert!(is_closed(&mesh) && mesh.components().1 == 2, "{turn}");
            let second = if inside_out { -6.0 } else { 6.0 };
            let mut volumes = volumes(&mesh);
            volumes.sort_by(|a, b| b.total_cmp(a));
            assert_eq!(volumes, [6.0, second]);
            assert_eq!(notes, [NoteKind::NonManifoldEdge, NoteKind::VertexSeparated]);
        }
    }
}

#[test]
fn cubes_with_a_wall_between_them_stay_closed() {
    let (positions, faces) = cubes(&[[0, 0, 0], [0, 0, 1], [0, 1, 1]].into(), true);
    let (mesh, notes) = build(positions, &faces);
    assert!(is_closed(&mesh));
    assert_eq!(volumes(&mesh), [6.0; 3]);
    assert_eq!(notes, [NoteKind::NonManifoldEdge, NoteKind::VertexSeparated]);
}

#[test]
fn a_sheet_with_two_faces_at_every_place_is_one_sheet() {
    let (positions, faces) = cubes(&[[0, 0, 0], [1, 0, 0]].into(), false);
    let top: Vec<Vec<u32>> =
        faces.into_iter().filter(|face| face.iter().all(|&v| positions[v as usize].z == 1.0)).collect();
    let other: Vec<Vec<u32>> = top.iter().map(|face| face.iter().rev().copied().collect()).collect();
    let (mesh, notes) = build(positions, &[top, other].concat());
    assert_eq!((mesh.face_count(), mesh.boundary_loops().len()), (2, 1));
    assert_eq!(notes, [NoteKind::DuplicateFace]);
}

#[test]
fn a_cube_with_a_fin_stays_closed() {
    let (mut positions, mut faces) = cubes(&[[0, 0, 0]].into(), true);
    let [a, b, c, _] = faces[0][..] else { panic!("a quad") };
    let tips = [8, 9];
    positions.extend([Vec3::splat(-1.0), Vec3::splat(0.5)]);
    // Outside at one edge, and inside at another.
    for fin in [[a, b, tips[0]], [b, a, tips[0]], [b, c, tips[1]], [c, b, tips[1]]] {
        faces.push(fin.to_vec());
        let (mesh, _) = build(positions.clone(), &faces);
        faces.pop();
        assert_eq!((mesh.face_count(), mesh.boundary_loops().len()), (7, 1));
        assert_eq!(mesh.components().1, 3, "the cube, the fin and the tip of the other fin");
        assert!(volumes(&mesh).contains(&6.0), "{:?}", volumes(&mesh));
    }
}

#[test]
fn sheets_that_bound_no_solid_are_separated() {
    // Three pages at a spine.
    let positions = vec![Vec3::ZERO, Vec3::Z, Vec3::X, Vec3::Y, -Vec3::X];
    let pages = [vec![0, 1, 2], vec![1, 0, 3], vec![0, 1, 4]];
    let (mesh, _) = build(positions, &pages);
    assert_eq!((mesh.components().1, mesh.vertex_count()), (3, 9));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Any cubes of a grid, each with all of its faces, stay as many closed cubes.
    #[test]
    fn cubes_that_touch_stay_closed(at in prop::collection::btree_set(prop::array::uniform3(0i32..3), 1..20)) {
        let (positions, faces) = cubes(&at, true);
        let (mesh, _) = build(positions, &faces);
        prop_assert!(is_closed(&mesh));
        prop_assert_eq!(volumes(&mesh), vec![6.0; at.len()]);
    }
}
