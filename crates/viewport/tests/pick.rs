//! Picking and box selection on meshes with obvious answers.

mod support;

use glam::{Vec2, Vec3, vec2, vec3};
use halfedge::geometry::BitSet;
use halfedge::{Budget, Element, FaceId, InParts, Mesh, PolygonSoup, VertexId};
use proptest::prelude::*;
use std::collections::BTreeSet;
use std::sync::Arc;
use support::{cube, grid, sphere};
use surface::FaceTree;
use viewport::{Aim, Camera, Picked, Region, RegionSelection, ScreenRect, pick};

const VIEW: Vec2 = Vec2::new(800.0, 600.0);
const ALL: ScreenRect = ScreenRect { min: Vec2::ZERO, max: VIEW };

fn front() -> Camera {
    Camera { yaw: 0.0, pitch: 0.0, ..Camera::default() }
}

fn at(camera: &Camera, p: Vec3) -> Vec2 {
    camera.project(p, VIEW).expect("in front")
}

fn aim(kind: Element, radius: f32) -> Aim {
    Aim { kind, radius, through: false }
}

fn picked(mesh: &Mesh, camera: &Camera, pixel: Vec2, kind: Element) -> Option<Picked> {
    pick(mesh, &FaceTree::new(mesh), camera, VIEW, pixel, aim(kind, 8.0))
}

fn id(mesh: &Mesh, camera: &Camera, pixel: Vec2, kind: Element) -> Option<u32> {
    picked(mesh, camera, pixel, kind).map(|p| p.id)
}

#[test]
fn a_cube_from_the_front() {
    let (cube, camera) = (cube(), front());
    let corner = at(&camera, vec3(1.0, 1.0, 1.0));
    // Vertex 7, from inside the face and from outside the silhouette.
    for shift in [vec2(-5.0, 5.0), vec2(5.0, -5.0), vec2(0.0, -6.0)] {
        assert_eq!(id(&cube, &camera, corner + shift, Element::Vertex), Some(7), "{shift}");
    }
    assert_eq!(id(&cube, &camera, corner + vec2(9.0, 0.0), Element::Vertex), None);
    // The vertex behind it, hidden by the front.
    assert_eq!(id(&cube, &camera, at(&camera, vec3(1.0, 1.0, -1.0)), Element::Vertex), None);

    let front_face = picked(&cube, &camera, VIEW * 0.5, Element::Face).expect("a face");
    assert_eq!((front_face.element, front_face.id), (Element::Face, 0));
    assert!((front_face.distance - 4.0).abs() < 1e-4);
    assert_eq!(id(&cube, &camera, vec2(5.0, 5.0), Element::Face), None);

    let right = cube.find_edge(VertexId::new(5), VertexId::new(7)).expect("an edge");
    let middle = at(&camera, vec3(1.0, 0.0, 1.0));
    for shift in [-6.0, 6.0] {
        assert_eq!(id(&cube, &camera, middle + vec2(shift, 0.0), Element::Edge), Some(right.raw()));
        // On either side of it: the right face is turned away.
        let h = id(&cube, &camera, middle + vec2(shift, 0.0), Element::Halfedge).expect("a half-edge");
        assert_eq!(cube.face_of(cube.halfedge(h).expect("exists")), Some(FaceId::new(0)));
    }
}

#[test]
fn half_edges_by_the_side_the_pointer_is_on() {
    let (grid, camera) = (grid(2, 1, false), front());
    let middle = at(&camera, Vec3::ZERO);
    for (shift, face) in [(-3.0, 0), (3.0, 1)] {
        let h = id(&grid, &camera, middle + vec2(shift, 0.0), Element::Halfedge).expect("a half-edge");
        assert_eq!(grid.face_of(grid.halfedge(h).expect("exists")), Some(FaceId::new(face)));
    }
    // Outside the surface the boundary half-edge; on it the face's.
    let right = at(&camera, vec3(1.0, 0.0, 0.0));
    let outer = id(&grid, &camera, right + vec2(3.0, 0.0), Element::Halfedge).expect("a half-edge");
    let inner = id(&grid, &camera, right - vec2(3.0, 0.0), Element::Halfedge).expect("a half-edge");
    assert_eq!(outer, inner ^ 1);
    assert!(grid.is_boundary_halfedge(grid.halfedge(outer).expect("exists")));
}

#[test]
fn an_isolated_vertex_can_be_picked_unless_it_is_hidden() {
    let mut soup = PolygonSoup::new(
        vec![vec3(-1., -1., 0.), vec3(1., -1., 0.), vec3(0., 1., 0.), vec3(1.5, 1.0, 0.0), vec3(0., 0., -1.)],
        &[[0_u32, 1, 2]],
    );
    let mesh = Mesh::build(std::mem::take(&mut soup)).expect("small").mesh;
    let camera = front();
    assert_eq!(id(&mesh, &camera, at(&camera, vec3(1.5, 1.0, 0.0)) + 2.0, Element::Vertex), Some(3));
    assert_eq!(id(&mesh, &camera, VIEW * 0.5, Element::Vertex), None);
    let empty = Mesh::new();
    for kind in Element::ALL {
        assert_eq!(picked(&empty, &camera, VIEW * 0.5, kind), None);
    }
}

#[test]
fn isolated_vertices_are_picked_and_boxed() {
    let soup = PolygonSoup {
        positions: (0..5).map(|i| Vec3::splat(i as f32 * 0.2)).collect(),
        ..PolygonSoup::default()
    };
    let (mesh, camera) = (Mesh::build(soup).expect("points").mesh, Camera::default());
    for v in mesh.vertices() {
        let pixel = at(&camera, mesh.position(v));
        assert_eq!(id(&mesh, &camera, pixel + 2.0, Element::Vertex), Some(v.raw()));
        assert_eq!(id(&mesh, &camera, pixel, Element::Face), None);
    }
    for visible in [false, true] {
        assert_eq!(inside(&mesh, &camera, ALL, Element::Vertex, visible), [0, 1, 2, 3, 4]);
    }
}

fn inside(mesh: &Mesh, camera: &Camera, rect: ScreenRect, kind: Element, visible: bool) -> Vec<u32> {
    let tree = FaceTree::new(mesh);
    let begun = || RegionSelection::new(camera, VIEW, Region::rect(rect), kind, visible);
    let all = begun().finish((mesh, &tree));
    // Some elements at a time give the same.
    let mut parts = begun();
    let found = loop {
        if let Some(found) = parts.step((mesh, &tree), &mut Budget::new(3)) {
            break found;
        }
    };
    assert_eq!(found, all, "{kind}");
    all
}

#[test]
fn a_box_around_a_cube() {
    let cube = cube();
    for orthographic in [false, true] {
        let camera = Camera { orthographic, ..Camera::default() };
        let count = |kind, visible| inside(&cube, &camera, ALL, kind, visible).len();
        assert_eq!(Element::ALL.map(|kind| count(kind, false)), [8, 12, 24, 6]);
        assert_eq!(Element::ALL.map(|kind| count(kind, true)), [7, 9, 12, 3]);
        let nothing = ScreenRect::between(vec2(1.0, 9.0), vec2(9.0, 1.0));
        for kind in Element::ALL {
            assert!(inside(&cube, &camera, nothing, kind, false).is_empty());
        }
    }
}

#[test]
fn a_box_inside_a_face_or_across_an_edge() {
    let (grid, camera) = (grid(2, 1, false), front());
    let rect = |a: Vec3, b: Vec3| ScreenRect::between(at(&camera, a), at(&camera, b));
    let within = rect(vec3(-0.6, -0.2, 0.0), vec3(-0.4, 0.2, 0.0));
    assert_eq!(inside(&grid, &camera, within, Element::Face, true), [0]);
    assert!(inside(&grid, &camera, within, Element::Edge, true).is_empty());
    let across = rect(vec3(-0.1, -0.2, 0.0), vec3(0.1, 0.2, 0.0));
    assert_eq!(inside(&grid, &camera, across, Element::Face, true), [0, 1]);
    let middle = grid.find_edge(VertexId::new(1), VertexId::new(4)).expect("an edge").raw();
    assert_eq!(inside(&grid, &camera, across, Element::Edge, true), [middle]);
    assert_eq!(inside(&grid, &camera, across, Element::Halfedge, true), [middle * 2, middle * 2 + 1]);
}

#[test]
fn a_box_works_from_within_the_mesh() {
    let ball = sphere(12, 8);
    let camera = Camera { distance: 0.5, ..front() };
    let all = inside(&ball, &camera, ALL, Element::Edge, false);
    let seen = inside(&ball, &camera, ALL, Element::Edge, true);
    assert!(!seen.is_empty() && seen.len() < ball.edge_count());
    assert_eq!(all, seen, "nothing hides anything inside a ball");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10))]

    /// A face of a convex body is visible if it faces the eye, and so are its edges and corners. The depth buffer
    /// decides about most small faces, rays about large ones.
    #[test]
    fn a_box_finds_the_near_side_of_a_convex_body(
        yaw in 0.0..std::f64::consts::TAU,
        pitch in -1.5..1.5_f64,
        orthographic in any::<bool>(),
        fine in any::<bool>(),
    ) {
        let ball = if fine { sphere(48, 36) } else { sphere(7, 5) };
        let camera = Camera { yaw, pitch, orthographic, ..Camera::default() };
        // How far each face faces the eye.
        let turned: Vec<f64> = ball.faces().map(|f| {
            let corner = ball.face_vertices(f).next().map_or(Vec3::ZERO, |v| ball.position(v)).as_dvec3();
            let to_eye = if orthographic { -camera.axes()[2] } else { (camera.eye() - corner).normalize() };
            surface::normals::face_normal(&ball, f).as_dvec3().dot(to_eye)
        }).collect();
        for kind in Element::ALL {
            let found: BTreeSet<u32> = inside(&ball, &camera, ALL, kind, true).into_iter().collect();
            for id in 0..ball.capacity(kind) as u32 {
                let faces: Vec<f64> = match kind {
                    Element::Vertex => ball.vertex_faces(VertexId::new(id as usize)).collect(),
                    Element::Edge => halfedge::EdgeId::new(id as usize)
                        .halfedges().into_iter().filter_map(|h| ball.face_of(h)).collect(),
                    Element::Halfedge => ball.face_of(halfedge::HalfedgeId::new(id as usize)).into_iter().collect(),
                    Element::Face => vec![FaceId::new(id as usize)],
                }.into_iter().map(|f| turned[f.index()]).collect();
                let most = faces.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                if most.abs() > 0.04 {
                    prop_assert_eq!(found.contains(&id), most > 0.0, "{} {} turned {}", kind, id, most);
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Pointing at a vertex or edge that a box finds visible picks it, or one in front of it in the same place, but
    /// never a hidden one.
    #[test]
    fn what_is_visible_can_be_picked(yaw in 0.0..std::f64::consts::TAU, pitch in -1.5..1.5_f64, orthographic in any::<bool>()) {
        let ball = sphere(10, 8);
        let tree = FaceTree::new(&ball);
        let camera = Camera { yaw, pitch, orthographic, ..Camera::default() };
        let visible: BTreeSet<u32> =
            RegionSelection::new(&camera, VIEW, Region::rect(ALL), Element::Vertex, true).finish((&ball, &tree)).into_iter().collect();
        for v in ball.vertices() {
            let p = ball.position(v);
            let picked = pick(&ball, &tree, &camera, VIEW, at(&camera, p), aim(Element::Vertex, 2.0));
            if visible.contains(&v.raw()) {
                prop_assert_eq!(picked.map(|p| p.id), Some(v.raw()));
                let away = picked.map_or(0.0, |p| p.distance);
                prop_assert!(orthographic || (away - camera.eye().distance(p.as_dvec3())).abs() < 1e-4);
            } else if let Some(picked) = picked {
                prop_assert!(visible.contains(&picked.id));
            }
        }
    }
}

#[test]
fn a_pixel_on_a_model_always_means_an_element() {
    let cube = cube();
    let tree = FaceTree::new(&cube);
    let camera = Camera { yaw: 0.0, pitch: 0.0, distance: 6.0, ..Camera::default() };
    let nearest = |pixel, kind| {
        viewport::pick_nearest(&cube, &tree, &camera, VIEW, pixel, aim(kind, 8.0)).map(|picked| picked.id)
    };
    let middle = camera.project(vec3(0.0, 0.0, 1.0), VIEW).expect("in front");
    let corner = (4..8).map(VertexId::new).find(|&v| cube.position(v) == vec3(1.0, 1.0, 1.0)).expect("there");
    assert_eq!(id(&cube, &camera, middle + vec2(5.0, -7.0), Element::Vertex), None);
    assert_eq!(nearest(middle + vec2(5.0, -7.0), Element::Vertex), Some(corner.raw()), "up and to the right");
    let side = nearest(middle + vec2(9.0, 1.0), Element::Edge).expect("the right edge");
    let ends = cube.ends(cube.edge(side).expect("there")).map(|v| cube.position(v));
    assert!(ends.iter().all(|p| p.x == 1.0 && p.z == 1.0), "{ends:?}");
    let inside = nearest(middle + vec2(9.0, 1.0), Element::Halfedge).expect("its half-edge");
    let face = cube.halfedge(inside).and_then(|h| cube.face_of(h)).map(|f| f.raw());
    assert_eq!(face, nearest(middle, Element::Face), "that of the face under the pointer");
    assert_eq!(nearest(vec2(1.0, 1.0), Element::Vertex), None, "beside the model there is nothing");
}

#[test]
fn elements_near_a_place_are_the_visible_ones_nearest_first() {
    let ball = sphere(24, 16);
    let tree = FaceTree::new(&ball);
    let size = glam::vec2(400.0, 300.0);
    for (yaw, orthographic) in [(0.0, false), (1.0, true)] {
        let camera = Camera { yaw, pitch: 0.2, distance: 3.0, orthographic, ..Camera::default() };
        let middle = size * 0.5;
        let all = viewport::Around { pixel: middle, radius: 80.0, gap: glam::Vec2::ZERO, limit: 1000 };
        let elements = |around| viewport::elements_near((&ball, &tree), &camera, size, around);
        let near = elements(all);
        for pair in near.windows(2) {
            assert!(pair[0].pixel.distance(middle) <= pair[1].pixel.distance(middle));
        }
        // Exactly those vertices within reach that a click would take.
        let mut found: Vec<u32> = near.iter().filter(|n| n.kind == Element::Vertex).map(|n| n.id).collect();
        found.sort_unstable();
        let towards = camera.eye().as_vec3();
        let expected: Vec<u32> = ball
            .vertices()
            .filter(|v| camera.project(ball.position(*v), size).is_some_and(|p| p.distance(middle) <= 80.0))
            .filter(|v| ball.position(*v).dot(towards) > 0.0)
            .map(|v| v.raw())
            .collect();
        assert_eq!(found, expected);
        assert!(near.iter().any(|n| n.kind == Element::Edge) && near.iter().any(|n| n.kind == Element::Face));
        assert_eq!(elements(viewport::Around { limit: 7, ..all })[..], near[..7]);
        let gap = glam::vec2(30.0, 12.0);
        let apart = elements(viewport::Around { gap, ..all });
        assert!(apart.len() > 10 && apart.len() < near.len(), "{} of {}", apart.len(), near.len());
        for (i, a) in apart.iter().enumerate() {
            assert!(apart[..i].iter().all(|b| (a.pixel - b.pixel).abs().cmpge(gap).any()));
        }
        let beside = elements(viewport::Around { pixel: glam::vec2(2.0, 2.0), ..all });
        assert!(beside.is_empty());
    }
}

#[test]
fn hidden_faces_are_neither_picked_nor_boxed_and_hide_nothing() {
    let (cube, camera) = (cube(), front());
    let mut tree = FaceTree::new(&cube);
    let front_face = id(&cube, &camera, VIEW * 0.5, Element::Face).expect("in front");
    let ids = |ids: &[u32]| Arc::new(ids.iter().map(|&id| id as usize).collect::<BitSet>());
    tree.set_hidden(&ids(&[front_face]));
    let pick = |tree: &FaceTree, p: Vec3, kind| {
        let aim = Aim { kind, radius: 8.0, through: false };
        pick(&cube, tree, &camera, VIEW, at(&camera, p), aim).map(|picked| picked.id)
    };
    // Through it, the back.
    let back = pick(&tree, Vec3::ZERO, Element::Face).expect("behind");
    assert_ne!(back, front_face);
    let behind = pick(&tree, vec3(1.0, 1.0, -1.0), Element::Vertex).expect("behind");
    assert_eq!(cube.position(VertexId::new(behind as usize)), vec3(1.0, 1.0, -1.0));
    let corner = cube.vertices().find(|&v| cube.position(v) == vec3(1.0, 1.0, 1.0)).expect("a corner");
    assert_eq!(pick(&tree, vec3(1.0, 1.0, 1.0), Element::Vertex), Some(corner.raw()), "it has other faces");
    let boxed = |tree: &FaceTree, kind| {
        RegionSelection::new(&camera, VIEW, Region::rect(ALL), kind, true).finish((&cube, tree)).len()
    };
    assert_eq!(boxed(&tree, Element::Face), 5, "the inside of all others is seen");

    // A vertex is hidden when all its faces are, an edge when both are.
    let around: Vec<u32> = cube.vertex_faces(corner).map(FaceId::raw).collect();
    tree.set_hidden(&ids(&around));
    assert_ne!(pick(&tree, vec3(1.0, 1.0, 1.0), Element::Vertex), Some(corner.raw()));
    for (kind, count) in [(Element::Vertex, 7), (Element::Edge, 9), (Element::Face, 3)] {
        assert_eq!(boxed(&tree, kind), count, "{kind}");
    }
    // Updates keep what is hidden; revealed, everything is as before.
    tree.update(&cube, cube.faces());
    assert_eq!(boxed(&tree, Element::Face), 3);
    tree.set_hidden(&ids(&[]));
    assert_eq!(pick(&tree, Vec3::ZERO, Element::Face), Some(front_face));
}
