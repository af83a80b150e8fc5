//! A polygon has the same triangles wherever it is cut: drawn, picked, saved, simplified and triangulated.

mod support;

use formats::{Format, Model};
use glam::Vec3;
use halfedge::edit::{Triangulation, triangulate_face};
use halfedge::geometry::PolygonTriangulator;
use halfedge::{FaceId, Mesh};
use proptest::prelude::*;
use support::mesh;
use surface::{FaceTree, Ray, Simplify, SimplifyTarget};
use viewport::buffers::{Buffers, Corners, Sink};
use viewport::{Coloring, Shading};

type Triangle = [[u32; 3]; 3];

/// The bits of triangles' positions, each triangle starting with its smallest corner, sorted.
fn sorted(triangles: impl IntoIterator<Item = [Vec3; 3]>) -> Vec<Triangle> {
    let turned = |triangle: [Vec3; 3]| {
        let [a, b, c] = triangle.map(|p| p.to_array().map(f32::to_bits));
        [[a, b, c], [b, c, a], [c, a, b]].into_iter().min().expect("three")
    };
    let mut triangles: Vec<Triangle> = triangles.into_iter().map(turned).collect();
    triangles.sort_unstable();
    triangles
}

fn of_mesh(mesh: &Mesh) -> Vec<Triangle> {
    sorted(mesh.faces().map(|f| {
        let corners: Vec<Vec3> = mesh.face_vertices(f).map(|v| mesh.position(v)).collect();
        corners.try_into().expect("a triangle")
    }))
}

#[derive(Default)]
struct Drawn(Vec<[f32; 3]>);

impl Sink for Drawn {
    fn reset(&mut self, _triangles: u32, _with_uvs: bool) {
        self.0.clear();
    }

    fn write(&mut self, _first_triangle: u32, corners: &Corners) {
        self.0.extend(&corners.positions);
    }
}

fn drawn(mesh: &Mesh) -> Vec<Triangle> {
    let mut drawn = Drawn::default();
    Buffers::default().rebuild(mesh, Vec3::ZERO, Shading::Flat, Coloring::default(), &mut drawn);
    sorted(drawn.0.as_chunks::<3>().0.iter().map(|t| t.map(Vec3::from_array)))
}

fn saved(mesh: &Mesh) -> Vec<Triangle> {
    let stl = Format::from_code("stl").expect("a format");
    let files = formats::write(stl, &Model::of_mesh("polygon", mesh.clone())).expect("small");
    sorted(files[0].bytes[84..].as_chunks::<50>().0.iter().map(|facet| {
        let float = |at: usize| f32::from_le_bytes(std::array::from_fn(|i| facet[at + i]));
        [12, 24, 36].map(|at| Vec3::new(float(at), float(at + 4), float(at + 8)))
    }))
}

/// Checks that rays from just above each triangle's centre hit drawn triangles.
fn assert_picked(mesh: &Mesh, triangles: &[Triangle]) {
    let tree = FaceTree::new(mesh);
    for triangle in triangles {
        let [a, b, c] = triangle.map(|p| Vec3::from_array(p.map(f32::from_bits)));
        let normal = (b - a).cross(c - a);
        if normal.length() < 1e-3 {
            continue;
        }
        let origin = (a + b + c) / 3.0 + normal.normalize() * 0.01;
        let hit = tree.hit(mesh, Ray { origin, direction: -normal }).expect("something there");
        let picked = sorted([hit.corners.map(|h| mesh.position(mesh.from(h)))]);
        assert!(triangles.contains(&picked[0]), "{picked:?} is not drawn");
        assert!(hit.distance < 0.0101, "{} away from {triangle:?}", hit.distance);
    }
}

fn assert_agree(polygon: &[Vec3]) {
    let mut mesh = mesh(polygon.to_vec(), &[(0..polygon.len() as u32).collect::<Vec<_>>()]);
    let drawn = drawn(&mesh);
    let mut triangulator = PolygonTriangulator::new();
    let by_numbers = triangulator.triangulate(polygon).iter().map(|t| t.map(|i| polygon[i as usize]));
    assert_eq!(drawn, sorted(by_numbers));
    assert_eq!(drawn, saved(&mesh));
    let all =
        Simplify { target: SimplifyTarget::Faces(usize::MAX), preserve_boundary: true, preserve_seams: true };
    let simplified = surface::simplify(&mesh, &all, &mut |_| std::ops::ControlFlow::Continue(()));
    assert_eq!(drawn, of_mesh(&simplified.expect("not cancelled").mesh));
    assert_picked(&mesh, &drawn);
    triangulate_face(&mut mesh, FaceId::new(0), Triangulation::Auto).expect("no edge is in the way");
    mesh.validate().expect("valid");
    assert_eq!(drawn, of_mesh(&mesh));
}

/// Corners at any distance from a centre, in a tilted plane or bent out of it: concave polygons, and convex ones if
/// the distances are similar.
fn star() -> impl Strategy<Value = Vec<Vec3>> {
    let radii = prop_oneof![
        prop::collection::vec(0.1f32..2.0, 4..12),
        prop::collection::vec(0.1f32..2.0, 12..60),
        prop::collection::vec(1.9f32..2.0, 4..20),
    ];
    (radii, prop_oneof![Just(0.0f32), -1.0f32..1.0], prop_oneof![Just(0.0f32), 0.0f32..0.5]).prop_map(
        |(radii, tilt, bend)| {
            let angle = |i: usize| i as f32 / radii.len() as f32 * std::f32::consts::TAU;
            let corner = |(i, r): (usize, &f32)| {
                let (x, y) = (r * angle(i).cos(), r * angle(i).sin());
                Vec3::new(x, y, x * tilt + bend * (i as f32 * 2.1).sin())
            };
            radii.iter().enumerate().map(corner).collect()
        },
    )
}

/// Corners anywhere: polygons that cross themselves.
fn tangle() -> impl Strategy<Value = Vec<Vec3>> {
    let corner = prop::array::uniform3(-1.0f32..1.0).prop_map(Vec3::from_array);
    prop_oneof![
        prop::collection::vec(corner.clone(), 4..9),
        prop::collection::vec(corner.clone(), 9..40),
        prop::collection::vec(corner, 120..150),
    ]
}

/// Corners in few places: coinciding and collinear corners, sides that run back along others, no area.
fn degenerate() -> impl Strategy<Value = Vec<Vec3>> {
    let corner = (0u8..4, 0u8..4, prop_oneof![4 => Just(0u8), 1 => 0u8..2])
        .prop_map(|(x, y, z)| Vec3::new(x.into(), y.into(), z.into()));
    prop_oneof![prop::collection::vec(corner.clone(), 4..9), prop::collection::vec(corner, 9..30)]
}

proptest! {
    #[test]
    fn all_algorithms_cut_a_polygon_alike(polygon in prop_oneof![star(), tangle(), degenerate()]) {
        assert_agree(&polygon);
    }
}

#[test]
fn all_algorithms_cut_a_huge_polygon_that_crosses_itself_alike() {
    // A star of 1501 points drawn in one stroke.
    let angle = |i: u16| f32::from(i) * 750.0 / 1501.0 * std::f32::consts::TAU;
    let star: Vec<Vec3> = (0..1501).map(|i| Vec3::new(angle(i).cos(), angle(i).sin(), 0.0)).collect();
    assert_agree(&star);
}
