//! Rays and closest points against a search through all faces.

mod common;

use common::*;
use glam::{DVec3, Vec3};
use halfedge::edit::{Connect, split_edge};
use halfedge::geometry::PolygonTriangulator;
use halfedge::{Budget, FaceId, InParts, Mesh, PolygonSoup};
use proptest::prelude::*;
use surface::*;

/// The distance along the ray to the nearest face, from all triangles of all faces (Möller, Trumbore).
fn slow_hit(mesh: &Mesh, ray: Ray) -> Option<f64> {
    let (o, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3().normalize());
    let mut cut = PolygonTriangulator::new();
    let mut best: Option<f64> = None;
    for f in mesh.faces() {
        for &corners in cut.triangulate_face(mesh, f) {
            let [a, b, c] = corners.map(|h| mesh.position(mesh.from(h)).as_dvec3());
            let (ab, ac) = (b - a, c - a);
            let p = d.cross(ac);
            let det = ab.dot(p);
            if det == 0.0 {
                continue;
            }
            let u = (o - a).dot(p) / det;
            let q = (o - a).cross(ab);
            let (v, t) = (d.dot(q) / det, ac.dot(q) / det);
            if u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t >= 0.0 && best.is_none_or(|b| t < b) {
                best = Some(t);
            }
        }
    }
    best
}

/// The smallest distance to any triangle: to the foot on its plane or to its nearest side.
fn slow_distance(mesh: &Mesh, p: DVec3) -> f64 {
    let mut cut = PolygonTriangulator::new();
    let mut best = f64::INFINITY;
    for f in mesh.faces() {
        for &corners in cut.triangulate_face(mesh, f) {
            let t = corners.map(|h| mesh.position(mesh.from(h)).as_dvec3());
            let n = (t[1] - t[0]).cross(t[2] - t[0]);
            let inside = (0..3).all(|i| {
                let (a, b) = (t[i], t[(i + 1) % 3]);
                n.cross(b - a).dot(p - a) >= 0.0
            });
            if inside && n.length_squared() > 0.0 {
                best = best.min((p - t[0]).dot(n.normalize()).abs());
            }
            for i in 0..3 {
                let (a, b) = (t[i], t[(i + 1) % 3]);
                let along = ((p - a).dot(b - a) / (b - a).length_squared().max(1e-300)).clamp(0.0, 1.0);
                best = best.min(p.distance(a + (b - a) * along));
            }
        }
    }
    best
}

fn assert_agrees(tree: &FaceTree, mesh: &Mesh, ray: Ray) {
    let (fast, slow) = (tree.hit(mesh, ray), slow_hit(mesh, ray));
    match (fast, slow) {
        (Some(hit), Some(distance)) => {
            assert!((hit.distance - distance).abs() <= 1e-5 * (1.0 + distance), "{hit:?} is not {distance}");
            let from_weights: DVec3 = hit
                .corners
                .iter()
                .zip(hit.barycentric)
                .map(|(&h, w)| mesh.position(mesh.from(h)).as_dvec3() * f64::from(w))
                .sum();
            assert!(from_weights.distance(hit.point.as_dvec3()) < 1e-4 * (1.0 + distance));
            assert!(hit.corners.iter().all(|&h| mesh.face_of(h) == Some(hit.face)));
            assert!((hit.barycentric.iter().sum::<f32>() - 1.0).abs() < 1e-5);
        }
        (None, None) => {}
        // A ray along a side may be decided either way.
        (Some(hit), None) => {
            assert!(hit.barycentric.iter().any(|w| w.abs() < 1e-6), "{hit:?} should miss");
        }
        (None, Some(distance)) => panic!("missed what is at {distance}"),
    }
    let point = ray.origin;
    let closest = tree.closest_point(mesh, point);
    let distance = slow_distance(mesh, point.as_dvec3());
    match closest {
        Some(hit) => assert!((hit.distance - distance).abs() < 1e-5 * (1.0 + distance), "{hit:?} {distance}"),
        None => assert_eq!(mesh.face_count(), 0),
    }
}

fn rays() -> impl Strategy<Value = Vec<Ray>> {
    let vector = || (-9f32..9.0, -9f32..9.0, -9f32..9.0).prop_map(|(x, y, z)| Vec3::new(x, y, z));
    prop::collection::vec(
        (vector(), vector(), 0..4usize).prop_map(|(origin, direction, axis)| Ray {
            origin,
            // Rays along an axis have zeros in their direction.
            direction: if axis < 3 { Vec3::AXES[axis] } else { direction },
        }),
        1..30,
    )
}

proptest! {
    #[test]
    fn agrees_with_a_search_through_all_faces(mesh in random_mesh(false), rays in rays()) {
        let tree = FaceTree::new(&mesh);
        for ray in rays {
            prop_assume!(ray.direction.length() > 1e-3);
            assert_agrees(&tree, &mesh, ray);
        }
    }

    #[test]
    fn follows_edits(
        mesh in random_mesh(false),
        moves in prop::collection::vec((any::<prop::sample::Index>(), -4f32..4.0), 1..12),
        rays in rays(),
    ) {
        let mut mesh = mesh;
        let mut tree = FaceTree::new(&mesh);
        for (pick, by) in moves {
            mesh.start_recording();
            if by < 0.0 && mesh.edge_count() > 0 {
                let e = mesh.edges().nth(pick.index(mesh.edge_count())).expect("in range");
                // Refused, and nothing changed, where the cuts on both sides would meet.
                split_edge(&mut mesh, e, 0.5, Connect::All).ok();
            }
            let v = mesh.vertices().nth(pick.index(mesh.vertex_count())).expect("in range");
            mesh.set_position(v, mesh.position(v) + Vec3::new(by, -by, by * 0.5));
            let journal = mesh.finish_recording();
            let mut touched: Vec<FaceId> = journal.touched().faces;
            touched.extend(mesh.vertex_faces(v));
            tree.update(&mesh, touched);
        }
        for ray in rays {
            prop_assume!(ray.direction.length() > 1e-3);
            assert_agrees(&tree, &mesh, ray);
        }
    }
}

#[test]
fn no_ray_slips_through_an_edge() {
    let mesh = Shape::named("ico-sphere").expect("listed").build().expect("default sizes");
    let tree = FaceTree::new(&mesh);
    for e in mesh.edges() {
        let [a, b] = mesh.ends(e).map(|v| mesh.position(v));
        for t in [0.0, 0.25, 0.5, 0.75] {
            // From the centre through a point of the edge, rounded to floats.
            let ray = Ray { origin: Vec3::ZERO, direction: a.lerp(b, t) };
            let hit = tree.hit(&mesh, ray).expect("closed all round");
            assert!((hit.distance - 1.0).abs() < 0.02);
        }
    }
}

#[test]
fn faces_in_any_order_and_gaps_are_found() {
    // A grid with shuffled faces, so that the order of ids is unrelated to their places.
    let n = 60u32;
    let ordered = grid(n);
    let mut soup = PolygonSoup { positions: ordered.positions().to_vec(), ..PolygonSoup::default() };
    let count = n * n;
    for i in 0..count {
        let f = (u64::from(i) * 7919 % u64::from(count)) as usize;
        soup.push_face(ordered.face_vertices(FaceId::new(f)).map(|v| v.raw()));
    }
    let mesh = build(soup);
    let tree = FaceTree::new(&mesh);
    for mesh in [&mesh, &ordered, &Mesh::new()] {
        for slice in [1, 100, 3599, 3600] {
            let (mut builder, mut slices) = (FaceTreeBuilder::new(mesh), 1);
            let made = loop {
                match builder.step(mesh, &mut Budget::new(slice)) {
                    Some(tree) => break tree,
                    None => slices += 1,
                }
            };
            assert_eq!(format!("{made:?}"), format!("{:?}", FaceTree::new(mesh)), "{slice} at a time");
            assert!(slices >= mesh.face_count().div_ceil(slice.next_multiple_of(16)), "{slices}");
        }
    }
    for i in 0..n {
        for j in 0..n {
            let origin = Vec3::new(i as f32 + 0.3, j as f32 + 0.6, 5.0);
            let hit = tree.hit(&mesh, Ray { origin, direction: Vec3::NEG_Z }).expect("below");
            assert_eq!((hit.distance, hit.point), (5.0, origin.with_z(0.0)));
            assert!(mesh.face_vertices(hit.face).any(|v| mesh.position(v) == origin.floor().with_z(0.0)));
            let side = Ray { origin: origin.with_z(0.0) - Vec3::X * 100.0, direction: Vec3::Y };
            assert_eq!(tree.hit(&mesh, side), None);
        }
    }
}

#[test]
fn nothing_to_hit_is_no_hit() {
    let empty = Mesh::new();
    let tree = FaceTree::new(&empty);
    assert_eq!(tree.hit(&empty, Ray { origin: Vec3::ZERO, direction: Vec3::X }), None);
    assert_eq!(tree.closest_point(&empty, Vec3::ZERO), None);
    let cube = cube();
    let tree = FaceTree::new(&cube);
    for direction in [Vec3::ZERO, Vec3::NAN, Vec3::INFINITY] {
        assert_eq!(tree.hit(&cube, Ray { origin: Vec3::ZERO, direction }), None);
    }
    assert_eq!(tree.closest_point(&cube, Vec3::NAN), None);
    // Behind the origin.
    assert_eq!(tree.hit(&cube, Ray { origin: Vec3::X * 3.0, direction: Vec3::X }), None);
    // In the plane of a face: past it there is no hit; from within there is one on the far side.
    let inside = tree.hit(&cube, Ray { origin: Vec3::ZERO, direction: Vec3::X * 0.001 }).expect("closed");
    assert_eq!((inside.distance, inside.face), (1.0, FaceId::new(5)));
}

/// Faces whose corners lie on a line or at one place, in every order.
#[test]
fn faces_without_area_are_their_sides() {
    let spots =
        [Vec3::ZERO, Vec3::new(1.0, 0.5, -0.25), Vec3::new(0.3, 0.15, -0.075), Vec3::new(3.0, 1.5, -0.75)];
    let probes = [
        Vec3::ZERO,
        Vec3::new(0.4, 0.2, -0.1),
        Vec3::new(0.5, 1.0, 2.0),
        Vec3::new(-1.0, 3.0, 0.1),
        Vec3::new(5.0, 0.0, 0.0),
        Vec3::new(0.9, 0.5, -0.2),
    ];
    for a in spots {
        for b in spots {
            for c in spots {
                let soup = PolygonSoup::new(vec![a, b, c], &[&[0u32, 1, 2][..]]);
                let mesh = Mesh::build(soup).expect("small").mesh;
                for p in probes {
                    let found = FaceTree::new(&mesh).closest_point(&mesh, p).expect("has a face");
                    let expected = slow_distance(&mesh, p.as_dvec3());
                    assert!(
                        (found.distance - expected).abs() < 1e-6,
                        "{a} {b} {c} {p}: {found:?} {expected}"
                    );
                    assert!(found.point.is_finite());
                }
            }
        }
    }
}
