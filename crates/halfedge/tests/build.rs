//! Building from soups that are not oriented manifolds: all give valid meshes.

use glam::{Vec2, Vec3};
use halfedge::attribute::Column;
use halfedge::{Built, Mesh, PolygonSoup, keys};
use proptest::prelude::*;

fn build(vertices: usize, faces: &[Vec<u32>]) -> Built {
    let positions = (0..vertices).map(|i| Vec3::new(i as f32, (i * i % 7) as f32, (i % 3) as f32)).collect();
    Mesh::build(PolygonSoup::new(positions, faces)).expect("small")
}

fn assert_valid(vertices: usize, faces: &[Vec<u32>]) -> Built {
    let built = build(vertices, faces);
    if let Err(defect) = built.mesh.validate() {
        panic!("{defect} from {faces:?}");
    }
    built
}

/// Three faces at the edge 0 3, two of them joined round both its ends too: copies of the edge would join the same two
/// vertices if nothing else were cut.
#[test]
fn copies_of_a_separated_edge_get_ends_of_their_own() {
    let faces = [vec![1, 3, 0], vec![3, 0, 4, 1], vec![0, 2, 3], vec![4, 1, 0]];
    let built = assert_valid(5, &faces);
    assert_eq!(built.mesh.face_count(), 4);
}

/// A Klein bottle of 4 x 4 quads: closed and not orientable.
#[test]
fn a_klein_bottle_is_cut_open() {
    let at = |i: u32, j: u32| {
        let (i, j) = if i == 4 { (0, (4 - j) % 4) } else { (i, j % 4) };
        i * 4 + j
    };
    let faces: Vec<Vec<u32>> = (0..16)
        .map(|q| (q / 4, q % 4))
        .map(|(i, j)| vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)])
        .collect();
    let built = assert_valid(16, &faces);
    assert_eq!(built.mesh.face_count(), 16);
    assert!(!built.mesh.boundary_loops().is_empty());
}

/// Many faces at one edge become as many pieces, in linear time.
#[test]
fn a_fan_of_pages_comes_apart() {
    let pages: Vec<Vec<u32>> = (0..5000).map(|i| vec![0, 1, i + 2]).collect();
    let built = assert_valid(5002, &pages);
    assert_eq!((built.mesh.face_count(), built.mesh.components().1), (5000, 5000));
}

/// A soup with a column for each kind of element.
fn with_columns(mut soup: PolygonSoup) -> PolygonSoup {
    let numbers = |count: usize| (0..count).map(|i| i as f32).collect::<Vec<_>>();
    let colors = numbers(soup.positions.len()).into_iter().map(Vec3::splat).collect();
    soup.vertex_columns.push(Column::with_values(keys::VERTEX_COLOR, colors));
    let uvs = numbers(soup.corners.len()).into_iter().map(Vec2::splat).collect();
    soup.corner_columns.push(Column::with_values(keys::CORNER_UV, uvs));
    let groups = (0..soup.face_count() as u32).collect();
    soup.face_columns.push(Column::with_values(keys::FACE_SMOOTHING, groups));
    soup
}

#[test]
fn an_oriented_manifold_gives_its_positions_to_the_mesh_without_a_copy() {
    let soup =
        PolygonSoup::new(vec![Vec3::ZERO, Vec3::X, Vec3::ONE, Vec3::Y], &[vec![0, 1, 2], vec![0, 2, 3]]);
    let given = soup.positions.as_ptr();
    let built = Mesh::build(soup).expect("small");
    assert_eq!(built.mesh.positions().as_ptr(), given);
    assert!(built.original.is_none());
}

proptest! {
    #[test]
    fn a_soup_that_is_changed_is_given_back(
        faces in prop::collection::vec(prop::collection::vec(0u32..9, 0..6), 0..8),
        not_finite in prop::option::of(0usize..8),
    ) {
        let positions = (0..8).map(|i| Vec3::new(i as f32, (i * i % 7) as f32, (i % 3) as f32)).collect();
        let mut soup = with_columns(PolygonSoup::new(positions, &faces));
        if let Some(v) = not_finite {
            soup.positions[v] = Vec3::splat(f32::INFINITY);
        }
        let built = Mesh::build(soup.clone()).expect("small");
        prop_assert!(not_finite.is_none() || !built.notes.is_empty());
        prop_assert_eq!(built.original, (!built.notes.is_empty()).then_some(soup));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    /// Polygons over few vertices collide in all possible ways.
    #[test]
    fn any_soup_builds_a_valid_mesh(
        faces in prop::collection::vec(prop::collection::vec(0u32..9, 0..6), 0..24),
    ) {
        let built = assert_valid(8, &faces);
        prop_assert_eq!(built.original.is_some(), !built.notes.is_empty());
        prop_assert!(built.mesh.vertex_count() >= 8);
        prop_assert_eq!(built.face_source.len(), built.mesh.face_count());
        prop_assert!(built.face_source.is_sorted());
        // The result needs no repair, and building it again gives the same mesh.
        let again = Mesh::build(built.mesh.to_soup()).expect("small");
        prop_assert_eq!(&again.notes, &[]);
        prop_assert!(again.mesh == built.mesh);
    }
}
