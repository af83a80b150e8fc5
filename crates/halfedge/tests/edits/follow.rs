//! Corner values and vertex colours that follow moved vertices, by example.

use crate::zoo::{self, he, v};
use glam::{Vec2, Vec3};
use halfedge::attribute::{Column, Key};
use halfedge::edit::*;
use halfedge::{Color, Element, FaceId, HalfedgeId, Mesh, Refusal, VertexId, keys};

const CORNER_COLOR: Key<Color> = Key::new(Element::Halfedge, "color", Color::UNPAINTED);

/// The corners with a face.
fn corners(mesh: &Mesh) -> Vec<HalfedgeId> {
    mesh.halfedges().filter(|&h| !mesh.is_boundary_halfedge(h)).collect()
}

/// A grid of 3 x 3 quads in the unit square of texture space, vertices coloured by their place.
fn textured_grid() -> Mesh {
    let mut mesh = zoo::grid(3, 3);
    for h in corners(&mesh) {
        let position = mesh.position(mesh.from(h));
        mesh.set(keys::CORNER_UV, h.index(), position.truncate() / 3.0);
    }
    for v in mesh.vertices().collect::<Vec<_>>() {
        mesh.set(keys::VERTEX_COLOR, v.index(), mesh.position(v) / 3.0);
    }
    mesh
}

fn check_textured(mesh: &Mesh, what: &str) {
    for h in corners(mesh) {
        let (uv, position) = (mesh.get(keys::CORNER_UV, h.index()), mesh.position(mesh.from(h)));
        assert!(uv.distance(position.truncate() / 3.0) < 1e-6, "{what}: {uv} at {position}");
    }
    for v in mesh.vertices() {
        let (color, position) = (mesh.get(keys::VERTEX_COLOR, v.index()), mesh.position(v));
        assert!(color.distance(position / 3.0) < 1e-6, "{what}: colour {color} at {position}");
    }
}

type LiveEdit = fn(&mut Mesh) -> Result<SlidingEdit, Refusal>;

#[test]
fn values_follow_a_drag_there_and_back() {
    let edits: [(&str, LiveEdit); 7] = [
        ("inset", |m| inset_faces(m, &[FaceId::new(4)], Grouping::Region)),
        ("inset each", |m| inset_faces(m, &[3, 4, 5].map(FaceId::new), Grouping::Individual)),
        ("inset region", |m| inset_faces(m, &[1, 4, 5].map(FaceId::new), Grouping::Region)),
        ("bevel edge", |m| bevel_edges(m, &[he(m, 5, 6).edge()], 1)),
        ("bevel edges", |m| bevel_edges(m, &[he(m, 1, 5).edge(), he(m, 5, 6).edge()], 3)),
        ("bevel vertex", |m| bevel_vertices(m, &[v(5)])),
        ("bevel vertices", |m| bevel_vertices(m, &[v(0), v(5), v(6), v(14)])),
    ];
    for (what, edit) in edits {
        let mut mesh = textured_grid();
        let live = edit(&mut mesh).unwrap();
        let at_zero = mesh.clone();
        for amount in [0.1, 0.4, 0.2] {
            live.slide.apply(&mut mesh, amount).unwrap();
            mesh.validate().unwrap();
            check_textured(&mesh, &format!("{what} by {amount}"));
        }
        let mut again = at_zero.clone();
        live.slide.apply(&mut again, 0.2).unwrap();
        assert!(mesh == again, "{what}: a drag depends on where it has been");
        live.slide.apply(&mut mesh, 0.0).unwrap();
        assert!(mesh == at_zero, "{what}: a drag back to zero changes something");
    }
}

#[test]
fn values_on_the_two_sides_of_a_seam_stay_apart() {
    // The quads left of x = 1 have their texture a whole tile further up.
    let mut mesh = textured_grid();
    let shift = |face: FaceId| if face.index().is_multiple_of(3) { Vec2::Y } else { Vec2::ZERO };
    for h in corners(&mesh) {
        let uv = mesh.get(keys::CORNER_UV, h.index()) + shift(mesh.face_of(h).unwrap());
        mesh.set(keys::CORNER_UV, h.index(), uv);
    }
    // Vertex 5 on the seam slides along its four edges.
    let live = bevel_vertices(&mut mesh, &[v(5)]).unwrap();
    live.slide.apply(&mut mesh, 0.25).unwrap();
    for f in mesh.faces().filter(|f| f.index() < 9) {
        for h in mesh.face_halfedges(f) {
            let expected = mesh.position(mesh.from(h)).truncate() / 3.0 + shift(f);
            assert!(mesh.get(keys::CORNER_UV, h.index()).distance(expected) < 1e-6);
        }
    }
    // The new face belongs to one side.
    let cap = live.made.faces[0];
    let ups: Vec<bool> =
        mesh.face_halfedges(cap).map(|h| mesh.get(keys::CORNER_UV, h.index()).y > 1.0).collect();
    assert!(ups.iter().all(|up| *up == ups[0]), "{ups:?}");
}

#[test]
fn normals_between_others_are_units() {
    let mut start = zoo::torus(6, 4);
    for h in corners(&start) {
        let normal = start.position(start.from(h)).normalize();
        start.set(keys::CORNER_NORMAL, h.index(), normal);
    }
    type Edit = fn(&mut Mesh);
    let edits: [(&str, Edit); 6] = [
        ("split", |m| drop(split_edge(m, he(m, 0, 1).edge(), 0.3, Connect::All).unwrap())),
        ("loop cut", |m| drop(loop_cut(m, he(m, 0, 1).edge(), 3, 0.4).unwrap())),
        ("poke", |m| drop(poke_faces(m, &[FaceId::new(0)]).unwrap())),
        ("collapse", |m| drop(collapse_edge(m, he(m, 0, 1).edge(), 0.5).unwrap())),
        ("merge", |m| drop(collapse_face(m, FaceId::new(3)).unwrap())),
        ("inset", |m| {
            let live = inset_faces(m, &[FaceId::new(1)], Grouping::Region).unwrap();
            live.slide.apply(m, 0.2).unwrap();
        }),
    ];
    for (what, edit) in edits {
        let mut mesh = start.clone();
        edit(&mut mesh);
        for h in corners(&mesh) {
            let normal = mesh.get(keys::CORNER_NORMAL, h.index());
            assert!((normal.length() - 1.0).abs() < 1e-5, "{what}: {normal} has length {}", normal.length());
        }
    }
    // Equal normals give the same normal to the bit, unit or not.
    let mut mesh = zoo::grid(2, 2);
    let normal = Vec3::new(0.1, 0.2, 1.3);
    for h in corners(&mesh) {
        mesh.set(keys::CORNER_NORMAL, h.index(), normal);
    }
    let edge = he(&mesh, 3, 4).edge();
    split_edge(&mut mesh, edge, 0.3, Connect::All).unwrap();
    assert!(corners(&mesh).iter().all(|h| mesh.get(keys::CORNER_NORMAL, h.index()) == normal));
}

#[test]
fn colours_beyond_a_face_are_no_brighter_than_the_face() {
    let mut mesh = textured_grid();
    for h in corners(&mesh) {
        let channel = (mesh.position(mesh.from(h)).x * 80.0) as u8;
        mesh.set(CORNER_COLOR, h.index(), Color([channel, 10, 20]));
    }
    let rim: Vec<_> = mesh.edges().filter(|&e| mesh.is_boundary_edge(e)).collect();
    let live = extrude_edges(&mut mesh, &rim, Vec3::new(2.0, 0.5, 0.0)).unwrap();
    live.slide.apply(&mut mesh, 1.0).unwrap();
    for &v in &live.made.vertices {
        let color = mesh.get(keys::VERTEX_COLOR, v.index());
        assert!(color.min_element() >= 0.0 && color.max_element() <= 1.0, "{color}");
        for h in mesh.outgoing(v).filter(|&h| !mesh.is_boundary_halfedge(h)) {
            let Color([r, g, b]) = mesh.get(CORNER_COLOR, h.index());
            assert!(r <= 240 && (g, b) == (10, 20), "{r} {g} {b}");
        }
    }
    // Texture coordinates go on.
    let uv = |h: HalfedgeId| mesh.get(keys::CORNER_UV, h.index());
    assert!(corners(&mesh).into_iter().any(|h| uv(h).x > 1.5));
}

#[test]
fn missing_values_stay_missing() {
    let mut mesh = zoo::grid(3, 3);
    for h in mesh.face_halfedges(FaceId::new(4)).collect::<Vec<_>>() {
        mesh.set(keys::CORNER_UV, h.index(), mesh.position(mesh.from(h)).truncate());
    }
    let live = bevel_vertices(&mut mesh, &[v(5)]).unwrap();
    live.slide.apply(&mut mesh, 0.25).unwrap();
    collapse_face(&mut mesh, FaceId::new(2)).unwrap();
    for f in mesh.faces() {
        for h in mesh.face_halfedges(f) {
            let uv = mesh.get(keys::CORNER_UV, h.index());
            if f.index() == 4 {
                assert!(uv.distance(mesh.position(mesh.from(h)).truncate()) < 1e-6);
            } else if f.index() < 9 {
                assert!(uv.is_nan(), "{f} has got {uv}");
            }
        }
    }
}

#[test]
fn a_face_of_a_hundred_thousand_corners_is_inset_and_bevelled() {
    let n = 100_000;
    let circle = |i: usize| Vec2::from_angle(i as f32 / n as f32 * std::f32::consts::TAU) * 50.0;
    let start = {
        let positions = (0..n).map(|i| Vec3::from((circle(i), 0.0))).collect();
        let mut mesh = zoo::mesh(positions, &[(0..n as u32).collect::<Vec<u32>>()]);
        let uv = (0..mesh.halfedge_capacity()).map(|h| {
            let v = mesh.from(HalfedgeId::new(h));
            mesh.position(v).truncate() / 100.0
        });
        let column = Column::with_values(keys::CORNER_UV, uv.collect());
        mesh.insert_column(Element::Halfedge, column);
        mesh
    };
    let check = |mesh: &Mesh| {
        for h in corners(mesh) {
            let expected = mesh.position(mesh.from(h)).truncate() / 100.0;
            assert!(mesh.get(keys::CORNER_UV, h.index()).distance(expected) < 1e-4);
        }
    };
    let mut mesh = start.clone();
    let live = inset_faces(&mut mesh, &[FaceId::new(0)], Grouping::Region).unwrap();
    live.slide.apply(&mut mesh, 20.0).unwrap();
    check(&mesh);
    let mut mesh = start;
    let all: Vec<VertexId> = mesh.vertices().collect();
    let live = bevel_vertices(&mut mesh, &all).unwrap();
    live.slide.apply(&mut mesh, 1e-3).unwrap();
    check(&mesh);
}
