//! Attributes, as the text of each edit describes them.

use crate::zoo::{self, he, v};
use glam::{Vec2, Vec3};
use halfedge::edit::*;
use halfedge::{Color, EdgeId, FaceId, HalfedgeId, Mesh, VertexId, keys};

fn uv(mesh: &Mesh, h: HalfedgeId) -> Vec2 {
    mesh.get(keys::CORNER_UV, h.index())
}

fn color(mesh: &Mesh, f: FaceId) -> Color {
    mesh.get(keys::FACE_COLOR, f.index())
}

/// Gives each vertex and corner its position as a value, which shows how it was interpolated.
fn place_values(mesh: &mut Mesh) {
    zoo::paint(mesh);
    for v in mesh.vertices().collect::<Vec<_>>() {
        mesh.set(keys::VERTEX_COLOR, v.index(), mesh.position(v));
    }
    for h in mesh.halfedges().collect::<Vec<_>>() {
        let at = mesh.position(mesh.from(h)).truncate();
        mesh.set(keys::CORNER_UV, h.index(), at);
    }
}

/// Checks that values still equal positions.
fn check_places(mesh: &Mesh) {
    for v in mesh.vertices() {
        let value: Vec3 = mesh.get(keys::VERTEX_COLOR, v.index());
        assert!((value - mesh.position(v)).length() < 1e-5, "{v}: {value} at {}", mesh.position(v));
    }
    for f in mesh.faces() {
        for h in mesh.face_halfedges(f) {
            let at = mesh.position(mesh.from(h)).truncate();
            assert!((uv(mesh, h) - at).length() < 1e-5, "{h} of {f}: {} at {at}", uv(mesh, h));
        }
    }
}

#[test]
fn values_that_follow_positions_still_do() {
    type Edit = fn(&mut Mesh);
    let edits: [(&str, Edit); 11] = [
        ("split", |m| drop(split_edge(m, EdgeId::new(5), 0.3, Connect::All).unwrap())),
        ("flip", |m| flip_edge(m, he(m, 6, 7).edge()).unwrap()),
        ("collapse", |m| drop(collapse_edge(m, he(m, 6, 7).edge(), 0.25).unwrap())),
        ("split vertex", |m| {
            let edges: Vec<EdgeId> = m.vertex_edges(v(6)).collect();
            let here = m.position(v(6));
            split_vertex(m, v(6), [edges[0], edges[2]], Some([here, here])).unwrap();
        }),
        ("dissolve vertex", |m| drop(dissolve_vertex(m, v(6)).unwrap())),
        ("dissolve edge", |m| drop(dissolve_edges(m, &[he(m, 6, 7).edge()], true).unwrap())),
        ("poke", |m| drop(poke_faces(m, &[FaceId::new(3)]).unwrap())),
        ("loop cut", |m| drop(loop_cut(m, he(m, 6, 7).edge(), 3, 0.3).unwrap())),
        ("bevel", |m| drop(bevel_edges(m, &[he(m, 6, 7).edge(), he(m, 7, 8).edge()], 2).unwrap())),
        ("bevel vertex", |m| drop(bevel_vertices(m, &[v(6), v(0)]).unwrap())),
        ("extrude", |m| drop(extrude_faces(m, &[FaceId::new(4), FaceId::new(5)], Grouping::Region).unwrap())),
    ];
    for (name, edit) in edits {
        println!("{name}");
        let mut mesh = zoo::grid(4, 3);
        place_values(&mut mesh);
        edit(&mut mesh);
        mesh.validate().unwrap();
        check_places(&mesh);
    }
    // A ring that crosses itself is interpolated both ways. These quads aren't flat.
    let mut mesh = zoo::trefoil();
    place_values(&mut mesh);
    loop_cut(&mut mesh, EdgeId::new(0), 2, 0.4).unwrap();
    check_places(&mesh);
}

#[test]
fn edges_that_become_one_keep_the_sharper_crease() {
    let mut mesh = zoo::triangle_grid(3, 3);
    zoo::paint(&mut mesh);
    let edge = he(&mesh, 5, 6).edge();
    let mut creases = Vec::new();
    for h in edge.halfedges() {
        let sides = [mesh.next(h), mesh.prev(h)].map(|h| mesh.get(keys::EDGE_CREASE, h.edge().index()));
        creases.push(sides[0].max(sides[1]));
    }
    let tips = edge.halfedges().map(|h| mesh.to(mesh.next(h)));
    let mut merged = mesh.clone();
    let ends = mesh.ends(edge);
    collapse_edge(&mut mesh, edge, 0.5).unwrap();
    merge_vertices(&mut merged, &ends, None).unwrap();
    for mesh in [mesh, merged] {
        for (tip, crease) in tips.iter().zip(&creases) {
            let edge = mesh.find_edge(ends[0], *tip).unwrap();
            assert_eq!(mesh.get(keys::EDGE_CREASE, edge.index()), *crease);
        }
    }
}

#[test]
fn new_faces_copy_the_face_they_belong_to() {
    let mut mesh = zoo::cube();
    zoo::paint(&mut mesh);
    let face = FaceId::new(3);
    let (own, group) = (color(&mesh, face), mesh.get(keys::FACE_GROUP, 3));
    for live in [
        extrude_faces(&mut mesh.clone(), &[face], Grouping::Region).map(|live| live.made),
        inset_faces(&mut mesh.clone(), &[face], Grouping::Individual).map(|live| live.made),
        poke_faces(&mut mesh.clone(), &[face]),
    ] {
        assert!(!live.unwrap().faces.is_empty());
    }
    let made = extrude_faces(&mut mesh, &[face], Grouping::Region).unwrap().made;
    let poked = poke_faces(&mut mesh, &[face]).unwrap();
    for f in made.faces.iter().chain(&poked.faces) {
        assert_eq!((color(&mesh, *f), mesh.get(keys::FACE_GROUP, f.index())), (own, group));
    }
    // Both the moved outline and the edges left behind keep their creases.
    let mut mesh = zoo::cube();
    zoo::paint(&mut mesh);
    let before: Vec<f32> =
        mesh.face_halfedges(face).map(|h| mesh.get(keys::EDGE_CREASE, h.edge().index())).collect();
    let left: Vec<EdgeId> = mesh.face_halfedges(face).map(HalfedgeId::edge).collect();
    extrude_faces(&mut mesh, &[face], Grouping::Region).unwrap();
    let after: Vec<f32> =
        mesh.face_halfedges(face).map(|h| mesh.get(keys::EDGE_CREASE, h.edge().index())).collect();
    assert_eq!(after, before);
    let stayed: Vec<f32> = left.iter().map(|e| mesh.get(keys::EDGE_CREASE, e.index())).collect();
    assert_eq!(stayed, before);
}

#[test]
fn creases_are_set() {
    let mut mesh = zoo::cube();
    let (edges, vertices) = ([EdgeId::new(2), EdgeId::new(4)], [VertexId::new(1)]);
    set_crease(&mut mesh, &edges, &vertices, 2.5).unwrap();
    assert_eq!(mesh.get(keys::EDGE_CREASE, 4), 2.5);
    assert_eq!(mesh.get(keys::EDGE_CREASE, 3), 0.0);
    assert_eq!(mesh.get(keys::VERTEX_CREASE, 1), 2.5);
    for bad in [-1.0, f32::NAN, f32::INFINITY] {
        assert!(set_crease(&mut mesh, &edges, &[], bad).is_err());
    }
    assert!(set_crease(&mut mesh, &[], &[], 1.0).is_err());
}
