//! Regions of the screen, the elements in them, and the nearest element, against brute force.

mod support;

use glam::{DVec3, Vec2, Vec3, vec2};
use halfedge::geometry::PolygonTriangulator;
use halfedge::{Budget, EdgeId, Element, FaceId, HalfedgeId, InParts, Mesh, PolygonSoup, VertexId};
use proptest::prelude::*;
use std::collections::BTreeSet;
use support::sphere;
use surface::FaceTree;
use viewport::{Aim, Camera, Region, RegionSelection, ScreenRect, pick};

const VIEW: Vec2 = Vec2::new(800.0, 600.0);

fn point() -> impl Strategy<Value = Vec2> {
    (200.0..600.0_f32, 100.0..500.0_f32).prop_map(|(x, y)| vec2(x, y))
}

#[derive(Clone, Debug)]
enum Drawn {
    Box(Vec2, Vec2),
    Lasso(Vec<Vec2>),
    Brush(Vec2, Vec2, f32),
}

fn drawn() -> impl Strategy<Value = Drawn> {
    prop_oneof![
        (point(), point()).prop_map(|(a, b)| Drawn::Box(a, b)),
        prop::collection::vec(point(), 3..40).prop_map(Drawn::Lasso),
        (point(), point(), 1.0..150.0_f32).prop_map(|(a, b, radius)| Drawn::Brush(a, b, radius)),
    ]
}

impl Drawn {
    fn region(&self) -> Region {
        match self {
            Self::Box(a, b) => Region::rect(ScreenRect::between(*a, *b)),
            Self::Lasso(points) => Region::lasso(points.clone()),
            Self::Brush(a, b, radius) => Region::brush(*a, *b, *radius),
        }
    }

    /// How far inside a point is, less than 0 outside: by distances, and for a lasso by the angles that its sides are
    /// seen under.
    fn depth(&self, p: Vec2) -> f32 {
        match self {
            Self::Box(a, b) => {
                let (min, max) = (a.min(*b), a.max(*b));
                (p - min).min_element().min((max - p).min_element())
            }
            Self::Brush(a, b, radius) => radius - to_segment(p, [*a, *b]),
            Self::Lasso(points) => {
                let sides = || points.iter().zip(points.iter().cycle().skip(1));
                let away = sides().map(|(a, b)| to_segment(p, [*a, *b])).fold(f32::INFINITY, f32::min);
                let turn: f32 = sides().map(|(a, b)| (*a - p).angle_to(*b - p)).sum();
                if turn.abs() > 3.0 { away } else { -away }
            }
        }
    }
}

fn to_segment(p: Vec2, [a, b]: [Vec2; 2]) -> f32 {
    let along = b - a;
    let t = ((p - a).dot(along) / along.length_squared().max(1e-9)).clamp(0.0, 1.0);
    p.distance(a + along * t)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Points and parts of segments are inside where distances and angles say so.
    #[test]
    fn a_region_contains_what_it_goes_around(drawn in drawn(), a in point(), b in point(), short in any::<bool>()) {
        let region = drawn.region();
        let b = if short { a + (b - a) * 0.02 } else { b };
        let parts = region.clip([a, b]);
        prop_assert!(parts.windows(2).all(|pair| pair[0][1] <= pair[1][0]), "{:?}", parts);
        for step in 0..=200 {
            let t = step as f32 / 200.0;
            let p = a + (b - a) * t;
            let depth = drawn.depth(p);
            if depth.abs() < 0.02 {
                continue;
            }
            prop_assert_eq!(region.contains(p), depth > 0.0, "{} at {}", depth, p);
            let is_cut = parts.iter().any(|[from, to]| *from <= t && t <= *to);
            prop_assert_eq!(is_cut, depth > 0.0, "{} at {} in {:?}", depth, t, parts);
            prop_assert!(depth < 0.0 || (p.cmpge(region.bounds().min).all() && p.cmple(region.bounds().max).all()));
        }
    }
}

#[test]
fn a_line_that_crosses_itself_covers_all_its_loops() {
    // Twice around, the second time smaller: the inner disc isn't cut out.
    let around = |i: u32, radius: f32| Vec2::from_angle(i as f32 * 0.3) * radius + 100.0;
    let region = Region::lasso((0..42).map(|i| around(i, if i < 21 { 50.0 } else { 25.0 })).collect());
    assert!(region.contains(vec2(100.0, 100.0)));
    assert!(region.contains(vec2(140.0, 100.0)));
    // A figure of eight has two loops that go around in opposite directions.
    let eight = Region::lasso(vec![vec2(0., 0.), vec2(40., 20.), vec2(40., 0.), vec2(0., 20.)]);
    assert!(eight.contains(vec2(5.0, 10.0)) && eight.contains(vec2(35.0, 10.0)));
    assert!(!eight.contains(vec2(20.0, 2.0)));
    assert_eq!(eight.clip([vec2(-10.0, 10.0), vec2(50.0, 10.0)]), [[1.0 / 6.0, 5.0 / 6.0]]);
    for few in [vec![], vec![vec2(1.0, 1.0)], vec![vec2(1.0, 1.0), vec2(5.0, 5.0)]] {
        assert!(!Region::lasso(few).contains(vec2(1.0, 1.0)), "less than three points go around nothing");
    }
}

/// A small ball in front of a large one, with nothing else near.
fn two_balls(fine: u32) -> Mesh {
    let mut soup = PolygonSoup::default();
    for (middle, radius) in [(Vec3::ZERO, 1.0), (Vec3::new(0.2, 0.1, 2.5), 0.4)] {
        let ball = sphere(fine, fine * 3 / 4);
        let first = soup.positions.len() as u32;
        soup.positions.extend(ball.positions().iter().map(|p| *p * radius + middle));
        for f in ball.faces() {
            soup.push_face(ball.face_vertices(f).map(|v| v.raw() + first));
        }
    }
    // An isolated vertex behind and one in front.
    soup.positions.extend([Vec3::new(0.0, 0.0, -1.5), Vec3::new(-0.3, 0.0, 2.0)]);
    Mesh::build(soup).expect("two balls").mesh
}

/// How far in front of a point the frontmost face that hides it is, by trying all faces; none if no face
/// does. `near` are the faces that have the point.
fn hidden_by(mesh: &Mesh, camera: &Camera, point: Vec3, near: &[FaceId]) -> Option<f64> {
    let direction =
        if camera.orthographic { -camera.axes()[2] } else { (camera.eye() - point.as_dvec3()).normalize() };
    let mut triangulator = PolygonTriangulator::new();
    let mut front: Option<f64> = None;
    for face in mesh.faces().filter(|f| !near.contains(f)) {
        for corners in triangulator.triangulate_face(mesh, face) {
            let [a, b, c] = corners.map(|h| mesh.position(mesh.from(h)).as_dvec3() - point.as_dvec3());
            if let Some(t) = crossing([a, b, c], direction).filter(|t| *t > 1e-4) {
                front = Some(front.map_or(t, |n| n.max(t)));
            }
        }
    }
    front
}

/// Where a line from the origin crosses a triangle (Möller and Trumbore).
fn crossing([a, b, c]: [DVec3; 3], direction: DVec3) -> Option<f64> {
    let (ab, ac) = (b - a, c - a);
    let p = direction.cross(ac);
    let det = ab.dot(p);
    if det == 0.0 {
        return None;
    }
    let u = (-a).dot(p) / det;
    let q = (-a).cross(ab);
    let v = direction.dot(q) / det;
    (u >= 0.0 && v >= 0.0 && u + v <= 1.0).then(|| ac.dot(q) / det)
}

fn faces_of(mesh: &Mesh, kind: Element, id: usize) -> Vec<FaceId> {
    match kind {
        Element::Vertex => mesh.vertex_faces(VertexId::new(id)).collect(),
        Element::Edge => EdgeId::new(id).halfedges().into_iter().filter_map(|h| mesh.face_of(h)).collect(),
        Element::Halfedge => mesh.face_of(HalfedgeId::new(id)).into_iter().collect(),
        Element::Face => vec![FaceId::new(id)],
    }
}

fn found(mesh: &Mesh, camera: &Camera, region: &Region, kind: Element, visible: bool) -> Vec<u32> {
    let tree = FaceTree::new(mesh);
    let begun = || RegionSelection::new(camera, VIEW, region.clone(), kind, visible);
    let all = begun().finish((mesh, &tree));
    let mut parts = begun();
    let mut steps = 0;
    let in_parts = loop {
        steps += 1;
        if let Some(found) = parts.step((mesh, &tree), &mut Budget::new(50)) {
            break found;
        }
    };
    assert_eq!(in_parts, all, "{kind}, some at a time");
    assert!(steps > 1 || all.is_empty());
    assert!(all.is_sorted());
    all
}

fn camera() -> impl Strategy<Value = Camera> {
    (-0.4..0.4_f64, -0.4..0.4_f64, any::<bool>()).prop_map(|(yaw, pitch, orthographic)| Camera {
        yaw,
        pitch,
        orthographic,
        ..Camera::default()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// What is found is what distances on the screen, and trying all faces, find. What is within a fiftieth of a pixel of
    /// the region's edge, or hidden by less than a tenth of the model, may go either way.
    #[test]
    fn a_region_finds_what_brute_force_finds(drawn in drawn(), camera in camera()) {
        let mesh = two_balls(16);
        let region = drawn.region();
        let place = |p: Vec3| camera.project(p, VIEW).expect("in front");
        let samples = |a: Vec2, b: Vec2| (0..=400).map(move |i| a + (b - a) * (i as f32 / 400.0));
        for kind in Element::ALL {
            let through: BTreeSet<u32> = found(&mesh, &camera, &region, kind, false).into_iter().collect();
            let visible: BTreeSet<u32> = found(&mesh, &camera, &region, kind, true).into_iter().collect();
            prop_assert!(visible.is_subset(&through));
            for id in 0..mesh.capacity(kind) {
                // The deepest point of it, of which sampling finds nearly the deepest.
                let (depth, tolerance) = match kind {
                    Element::Vertex => (drawn.depth(place(mesh.position(VertexId::new(id)))), 0.02),
                    Element::Edge | Element::Halfedge => {
                        let edge = if kind == Element::Edge { EdgeId::new(id) } else { HalfedgeId::new(id).edge() };
                        let [a, b] = mesh.ends(edge).map(|v| place(mesh.position(v)));
                        (samples(a, b).map(|p| drawn.depth(p)).fold(f32::NEG_INFINITY, f32::max), 0.5)
                    }
                    Element::Face => {
                        let corners: Vec<Vec2> =
                            mesh.face_vertices(FaceId::new(id)).map(|v| place(mesh.position(v))).collect();
                        let middle = corners.iter().sum::<Vec2>() / corners.len() as f32;
                        let rings = [0.0, 0.3, 0.6, 0.8, 0.9, 1.0_f32];
                        let at = |ring: f32| corners.iter().zip(corners.iter().cycle().skip(1))
                            .flat_map(move |(a, b)| samples(middle.lerp(*a, ring), middle.lerp(*b, ring)));
                        let deepest = rings.into_iter().flat_map(at).step_by(7)
                            .map(|p| drawn.depth(p)).fold(f32::NEG_INFINITY, f32::max);
                        (deepest, 4.0)
                    }
                };
                if depth.abs() > tolerance {
                    prop_assert_eq!(through.contains(&(id as u32)), depth > 0.0, "{} {}, {} inside", kind, id, depth);
                }
                if kind == Element::Vertex && depth > tolerance {
                    let v = VertexId::new(id);
                    match hidden_by(&mesh, &camera, mesh.position(v), &faces_of(&mesh, kind, id)) {
                        Some(by) if by < 0.3 => {}
                        hidden => prop_assert_eq!(
                            visible.contains(&v.raw()), hidden.is_none(), "vertex {} hidden by {:?}", id, hidden
                        ),
                    }
                }
            }
        }
    }

    /// What is picked is the nearest of all elements that are not hidden, by trying all of them.
    #[test]
    fn the_nearest_element_that_is_seen_is_picked(
        pixel in point(), camera in camera(), radius in prop_oneof![Just(8.0_f32), Just(24.0)], through in any::<bool>(),
    ) {
        let mesh = two_balls(40);
        let tree = FaceTree::new(&mesh);
        for kind in [Element::Vertex, Element::Edge] {
            let mut candidates: Vec<(f32, u32, Option<f64>)> = Vec::new();
            for id in 0..mesh.capacity(kind) {
                let points: Vec<Vec3> = match kind {
                    Element::Vertex => vec![mesh.position(VertexId::new(id))],
                    _ => mesh.ends(EdgeId::new(id)).map(|v| mesh.position(v)).to_vec(),
                };
                let places: Vec<Vec2> = points.iter().map(|p| camera.project(*p, VIEW).expect("in front")).collect();
                let away = to_segment(pixel, [places[0], places[places.len() - 1]]);
                if away > radius + 0.1 {
                    continue;
                }
                let point = if points.len() == 1 { points[0] } else {
                    // Of many points of the edge the one that is nearest on the screen.
                    (0..=1000).map(|i| points[0].lerp(points[1], i as f32 / 1000.0))
                        .min_by(|a, b| {
                            let far = |p: &Vec3| camera.project(*p, VIEW).expect("in front").distance(pixel);
                            far(a).total_cmp(&far(b))
                        })
                        .expect("some")
                };
                let hidden = hidden_by(&mesh, &camera, point, &faces_of(&mesh, kind, id));
                candidates.push((away, id as u32, hidden));
            }
            candidates.sort_by(|a, b| a.0.total_cmp(&b.0));
            // Certainly seen, and perhaps seen.
            let seen = |c: &&(f32, u32, Option<f64>)| through || c.2.is_none();
            let maybe = |c: &(f32, u32, Option<f64>)| through || c.2.is_none_or(|by| by < 0.05);
            let picked = pick(&mesh, &tree, &camera, VIEW, pixel, Aim { kind, radius, through });
            let nearest = candidates.iter().find(seen).filter(|c| c.0 < radius - 0.1);
            match (picked, nearest) {
                (None, nearest) => prop_assert_eq!(nearest, None, "{}", kind),
                (Some(picked), nearest) => {
                    let found = candidates.iter().find(|c| c.1 == picked.id).expect("within the radius");
                    prop_assert!(maybe(found), "{} {:?} is hidden", kind, found);
                    if let Some(nearest) = nearest {
                        prop_assert!(found.0 <= nearest.0 + 0.01, "{} {:?} is nearer than {:?}", kind, nearest, found);
                    }
                }
            }
        }
    }
}
