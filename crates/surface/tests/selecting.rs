//! Sets of elements that follow from others.

mod common;

use common::*;
use halfedge::geometry::BitSet;
use halfedge::{EdgeId, Element, FaceId, Mesh, VertexId};
use proptest::prelude::*;
use surface::selecting::*;
use surface::{Shape, join_meshes};

fn set(ids: impl IntoIterator<Item = u32>) -> BitSet {
    ids.into_iter().map(|id| id as usize).collect()
}

fn ids(set: &BitSet) -> Vec<usize> {
    set.iter().collect()
}

fn all(mesh: &Mesh, kind: Element) -> BitSet {
    (0..mesh.capacity(kind)).filter(|&id| mesh.exists(kind, id as u32)).collect()
}

/// The vertex in a column and row of `grid(n)`.
fn at(n: u32, column: u32, row: u32) -> VertexId {
    VertexId::new((row * (n + 1) + column) as usize)
}

fn edge(mesh: &Mesh, a: VertexId, b: VertexId) -> EdgeId {
    mesh.find_edge(a, b).expect("neighbours")
}

#[test]
fn growing_and_shrinking_in_a_grid() {
    let mesh = grid(6);
    let middle = at(6, 3, 3);
    let grown = grow(&mesh, Element::Vertex, &set([middle.raw()]));
    let block = (2..=4).flat_map(|row| (2..=4).map(move |column| at(6, column, row).raw()));
    assert_eq!(grown, set(block));
    assert_eq!(shrink(&mesh, Element::Vertex, &grown), set([middle.raw()]));
    // The face in column 2 and row 2 has eight neighbours.
    let face = mesh
        .faces()
        .find(|&f| {
            mesh.face_vertices(f).any(|v| v == at(6, 2, 2)) && mesh.face_vertices(f).any(|v| v == at(6, 3, 3))
        })
        .expect("there");
    let grown = grow(&mesh, Element::Face, &set([face.raw()]));
    assert_eq!(grown.len(), 9);
    assert_eq!(shrink(&mesh, Element::Face, &grown), set([face.raw()]));
    // Everything has no neighbours outside.
    for kind in Element::ALL {
        assert_eq!(shrink(&mesh, kind, &all(&mesh, kind)), all(&mesh, kind));
    }
    let spoke = edge(&mesh, at(6, 3, 3), at(6, 4, 3));
    assert_eq!(grow(&mesh, Element::Edge, &set([spoke.raw()])).len(), 7);
}

#[test]
fn a_piece_is_linked_to_itself_only() {
    let two = join_meshes([&cube(), &grid(2)]).expect("small");
    for kind in Element::ALL {
        let whole = cube().count(kind);
        let first = linked(&two, kind, &set([0]));
        assert_eq!(ids(&first), (0..whole).collect::<Vec<_>>(), "{kind}");
        let last = two.capacity(kind) as u32 - 1;
        assert_eq!(linked(&two, kind, &set([last])).len(), two.count(kind) - whole, "{kind}");
        assert!(linked(&two, kind, &BitSet::new()).is_empty());
    }
}

#[test]
fn edge_loops_run_straight_and_end_at_poles() {
    let mesh = grid(6);
    // Through the middle from boundary to boundary.
    let line = edge_loop(&mesh, edge(&mesh, at(6, 2, 3), at(6, 3, 3)));
    let expected: Vec<EdgeId> =
        (0..6).map(|column| edge(&mesh, at(6, column, 3), at(6, column + 1, 3))).collect();
    assert_eq!(
        line.iter().copied().collect::<std::collections::BTreeSet<_>>(),
        expected.into_iter().collect()
    );
    // The boundary is one loop, round its corners.
    assert_eq!(edge_loop(&mesh, edge(&mesh, at(6, 0, 0), at(6, 1, 0))).len(), 24);
    // Each edge of a torus of quads lies on a closed loop, which every other edge of it gives too.
    let torus = Shape::named("torus").expect("listed").build().expect("fits");
    for e in torus.edges() {
        let line = edge_loop(&torus, e);
        assert!(line.len() > 2);
        let ends: Vec<VertexId> = line.iter().flat_map(|&e| torus.ends(e)).collect();
        assert!(ends.iter().all(|v| ends.iter().filter(|w| *w == v).count() == 2), "closed");
        let other: std::collections::BTreeSet<_> = edge_loop(&torus, line[1]).into_iter().collect();
        assert_eq!(other, line.into_iter().collect());
    }
    // A cube has no vertex with four edges.
    assert_eq!(edge_loop(&cube(), EdgeId::new(3)), [EdgeId::new(3)]);
}

#[test]
fn strips_cross_quads_and_stop_before_other_faces() {
    let cube = cube();
    for e in cube.edges() {
        let strip = face_strip(&cube, e);
        assert_eq!(strip.len(), 4, "round the cube");
    }
    let mesh = grid(6);
    let strip = face_strip(&mesh, edge(&mesh, at(6, 2, 3), at(6, 3, 3)));
    assert_eq!(strip.len(), 6, "a column");
    // A triangle fan has no quads.
    let cone = Shape::named("cone").expect("listed").build().expect("fits");
    let apex = cone.vertices().max_by_key(|&v| cone.valence(v)).expect("some");
    let spoke = cone.vertex_edges(apex).next().expect("some");
    assert!(face_strip(&cone, spoke).iter().all(|&f| cone.face_degree(f) == 4));
}

#[test]
fn paths_are_the_shortest() {
    let n = 6;
    let mesh = grid(n);
    let path =
        shortest_path(&mesh, Element::Vertex, at(n, 1, 2).raw(), at(n, 5, 4).raw()).expect("connected");
    assert_eq!(path.len(), 4 + 2 + 1, "as many steps as columns and rows between");
    let (a, b) = (edge(&mesh, at(n, 0, 0), at(n, 1, 0)), edge(&mesh, at(n, 4, 0), at(n, 5, 0)));
    let path = shortest_path(&mesh, Element::Edge, a.raw(), b.raw()).expect("connected");
    let row: Vec<u32> = {
        let mut row: Vec<u32> = (0..5).map(|c| edge(&mesh, at(n, c, 0), at(n, c + 1, 0)).raw()).collect();
        row.sort_unstable();
        row
    };
    assert_eq!(path, row);
    let two = join_meshes([&cube(), &cube()]).expect("small");
    assert_eq!(shortest_path(&two, Element::Face, 0, 11), None, "other pieces can't be reached");
    assert_eq!(shortest_path(&two, Element::Face, 3, 3), Some(vec![3]));
    assert_eq!(shortest_path(&two, Element::Face, 0, 400), None);
    // From a face of a cube to the one opposite there is one face between.
    let faces = shortest_path(&cube(), Element::Face, 0, 1).expect("connected");
    assert_eq!(faces.len(), 3);
}

#[test]
fn kinds_are_converted() {
    let mesh = grid(6);
    let face = FaceId::new(7);
    let one = set([face.raw()]);
    let vertices = convert(&mesh, Element::Face, Element::Vertex, &one);
    assert_eq!(vertices.len(), 4);
    for kind in [Element::Vertex, Element::Edge, Element::Halfedge] {
        let there = convert(&mesh, Element::Face, kind, &one);
        assert_eq!(there.len(), 4, "{kind}");
        assert_eq!(convert(&mesh, kind, Element::Face, &there), one, "{kind}");
    }
    assert_eq!(convert(&mesh, Element::Vertex, Element::Edge, &vertices).len(), 4);
    let edge = set([3]);
    assert_eq!(ids(&convert(&mesh, Element::Edge, Element::Halfedge, &edge)), [6, 7]);
    assert!(convert(&mesh, Element::Edge, Element::Face, &edge).is_empty());
}

proptest! {
    #[test]
    fn sets_keep_their_relations(chosen in prop::collection::btree_set(0u32..60, 0..12), which in 0usize..4, other in 0usize..4) {
        let mesh = grid_and_cube();
        let (kind, to) = (Element::ALL[which], Element::ALL[other]);
        let chosen: BitSet = chosen.into_iter().filter(|&id| mesh.exists(kind, id)).map(|id| id as usize).collect();
        let within = |a: &BitSet, b: &BitSet| a.iter().all(|id| b.contains(id));
        let (grown, shrunk) = (grow(&mesh, kind, &chosen), shrink(&mesh, kind, &chosen));
        prop_assert!(within(&chosen, &grown) && within(&shrunk, &chosen));
        prop_assert!(within(&chosen, &shrink(&mesh, kind, &grown)), "growing and shrinking loses nothing");
        prop_assert!(within(&grow(&mesh, kind, &shrunk), &chosen) || shrunk.is_empty());
        let piece = linked(&mesh, kind, &chosen);
        prop_assert_eq!(&grow(&mesh, kind, &piece), &piece);
        prop_assert!(within(&grown, &piece));
        let there = convert(&mesh, kind, to, &chosen);
        prop_assert!(there.iter().all(|id| mesh.exists(to, id as u32)));
        // What is contained comes back at least.
        let back = convert(&mesh, to, Element::Vertex, &there);
        prop_assert!(within(&back, &convert(&mesh, kind, Element::Vertex, &chosen)));
    }
}

/// A grid with a hole beside a cube.
fn grid_and_cube() -> Mesh {
    let mut mesh = join_meshes([&grid(4), &cube()]).expect("small");
    halfedge::edit::delete_faces(&mut mesh, &[FaceId::new(5)]).expect("there");
    mesh
}

proptest! {
    #[test]
    fn expanding_takes_whatever_touches_the_set(
        which in 0..3_usize,
        from in 0..4_usize,
        to in 0..4_usize,
        chosen in prop::collection::btree_set(0_u32..60, 0..12),
    ) {
        let mesh = vec![cube(), grid(3), join_meshes([&cube(), &grid(2)]).expect("small")].swap_remove(which);
        let [from, to] = [from, to].map(|at| Element::ALL[at]);
        let set = set(chosen.into_iter().filter(|&id| mesh.exists(from, id)));
        let expanded = expand(&mesh, from, to, &set);
        let parts = |kind: Element, id: u32, part: Element| -> Vec<u32> {
            let one: BitSet = [id as usize].into_iter().collect();
            convert(&mesh, kind, part, &one).iter().map(|id| id as u32).collect()
        };
        // From smaller parts to what has any of them; else as a plain conversion.
        let is_up = matches!(
            (from, to),
            (Element::Vertex, Element::Edge | Element::Halfedge | Element::Face)
                | (Element::Edge | Element::Halfedge, Element::Face)
        );
        let expected: BitSet = if is_up {
            let touches = |id: &usize| parts(to, *id as u32, from).iter().any(|&p| set.contains(p as usize));
            ids(&all(&mesh, to)).into_iter().filter(touches).collect()
        } else {
            convert(&mesh, from, to, &set)
        };
        prop_assert_eq!(ids(&expanded), ids(&expected), "{} to {}", from, to);
    }
}
