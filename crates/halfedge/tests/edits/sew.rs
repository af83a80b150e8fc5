//! Fill hole, bridge, weld, rip, flip orientation.

use crate::zoo::{self, counts, he, v};
use glam::Vec3;
use halfedge::edit::*;
use halfedge::{EdgeId, FaceId, HalfedgeId, Mesh, Refusal};

#[test]
fn a_hole_is_filled_with_one_polygon() {
    let mut mesh = zoo::frame();
    let inner = mesh.boundary_loops().into_iter().find(|&h| mesh.loop_of(h).count() == 4).unwrap();
    let made = fill_hole(&mut mesh, inner).unwrap();
    assert_eq!(mesh.halfedge_of(made.faces[0]), inner);
    assert_eq!(counts(&mesh), [16, 24, 9]);
    // The back of a single triangle.
    let mut mesh = zoo::triangle();
    let outside = mesh.boundary_loops()[0];
    fill_hole(&mut mesh, outside).unwrap();
    assert_eq!(zoo::faces(&mesh), zoo::faces(&zoo::pillow()));
    let inside = HalfedgeId::new(0);
    assert_eq!(can_fill_hole(&mesh, inside), Err(Refusal::NotABoundaryHalfedge(inside)));
}

/// Regular polygons of n and m corners in parallel planes, the ends of a prism.
fn lids(n: u32, m: u32) -> Mesh {
    let ring = |n: u32, z: f32| {
        (0..n).map(move |i| {
            let angle = i as f32 / n as f32 * std::f32::consts::TAU;
            Vec3::new(angle.cos(), angle.sin(), z)
        })
    };
    let positions = ring(n, 0.0).chain(ring(m, 1.0)).collect();
    let bottom: Vec<u32> = (0..n).rev().collect();
    let top: Vec<u32> = (n..n + m).collect();
    zoo::mesh(positions, &[bottom, top])
}

#[test]
fn loops_of_any_lengths_are_bridged() {
    for (n, m) in [(4, 4), (3, 8), (9, 4), (5, 6), (30, 30)] {
        let mut mesh = lids(n, m);
        let loops = mesh.boundary_loops();
        let made = bridge(&mut mesh, &[loops[0], loops[1]], Bands::default())
            .unwrap_or_else(|r| panic!("{n} and {m}: {r}"));
        let steps = n.max(m) as usize;
        assert_eq!(made.faces.len(), steps);
        assert_eq!(counts(&mesh)[2], steps + 2);
        assert_eq!(mesh.euler_characteristic(), 2);
        assert!(mesh.boundary_loops().is_empty());
        let quads = made.faces.iter().filter(|&&f| mesh.face_degree(f) == 4).count();
        assert_eq!(quads, n.min(m) as usize);
        // Between loops of equal length all edges across are upright.
        if n == m {
            assert!(made.edges.iter().all(|&e| {
                let [a, b] = mesh.ends(e).map(|v| mesh.position(v));
                (a.truncate() - b.truncate()).length() < 1e-6
            }));
        }
    }
    // Both loops of one piece: a wide frame becomes a torus.
    let mut mesh = zoo::grid(5, 5);
    delete_faces(&mut mesh, &[FaceId::new(12)]).unwrap();
    let loops = mesh.boundary_loops();
    let made = bridge(&mut mesh, &[loops[0], loops[1]], Bands::default()).unwrap();
    assert_eq!(made.faces.len(), 20);
    counts(&mesh);
    assert_eq!((mesh.euler_characteristic(), mesh.boundary_loops().len()), (0, 0));
}

#[test]
fn two_faces_become_a_handle_or_join_two_pieces() {
    // A passage between opposite faces of a cube whose other faces are inset, so that nothing joins them.
    let mut mesh = zoo::cube();
    let faces: Vec<FaceId> = mesh.faces().collect();
    let inset = inset_faces(&mut mesh, &faces, Grouping::Individual).unwrap();
    inset.slide.apply(&mut mesh, 0.25).unwrap();
    let [one, other] = [faces[0], faces[1]];
    let sides = |mesh: &Mesh, f| mesh.face_vertices(f).collect::<Vec<_>>();
    let ends: Vec<_> = sides(&mesh, one).into_iter().chain(sides(&mesh, other)).collect();
    let before = counts(&mesh);
    let made = bridge_faces(&mut mesh, &[one, other], Bands::default()).unwrap();
    assert_eq!((made.removed_faces.len(), made.faces.len(), made.edges.len()), (2, 4, 4));
    assert!(made.vertices.is_empty() && made.removed_vertices.is_empty() && made.removed_edges.is_empty());
    assert_eq!(counts(&mesh), [before[0], before[1] + 4, before[2] + 2]);
    assert_eq!((mesh.euler_characteristic(), mesh.boundary_loops().len()), (0, 0));
    assert!(made.faces.iter().flat_map(|&f| sides(&mesh, f)).all(|v| ends.contains(&v)));

    // Two single triangles, whose sides are boundary edges, become a prism without lids.
    let mut mesh = lids(3, 3);
    let [one, other] = [FaceId::new(0), FaceId::new(1)];
    bridge_faces(&mut mesh, &[one, other], Bands::default()).unwrap();
    assert_eq!(counts(&mesh)[2], 3);
    assert_eq!(mesh.boundary_loops().len(), 2);

    let cube = zoo::cube();
    assert_eq!(
        can_bridge_faces(&cube, &[one, one], Bands::default()),
        Err(Refusal::GivenTwice(halfedge::Element::Face, one.raw()))
    );
    // Edges already join opposite faces of a cube where the band would.
    let across = cube.faces().find(|&f| sides(&cube, f).iter().all(|v| !sides(&cube, one).contains(v)));
    assert!(matches!(
        can_bridge_faces(&cube, &[one, across.unwrap()], Bands::default()),
        Err(Refusal::SideTaken(..))
    ));
}

#[test]
fn bridges_that_fail() {
    // A narrow frame has edges already where the band would.
    let mesh = zoo::frame();
    let loops = mesh.boundary_loops();
    assert!(matches!(
        can_bridge(&mesh, &[loops[0], loops[1]], Bands::default()),
        Err(Refusal::SideTaken(..))
    ));
    // So has a tube.
    let mut mesh = zoo::cube();
    delete_faces(&mut mesh, &[FaceId::new(0), FaceId::new(1)]).unwrap();
    let loops = mesh.boundary_loops();
    assert!(matches!(
        can_bridge(&mesh, &[loops[0], loops[1]], Bands::default()),
        Err(Refusal::SideTaken(..))
    ));
    let next = mesh.next(loops[0]);
    assert_eq!(
        can_bridge(&mesh, &[loops[0], next], Bands::default()),
        Err(Refusal::SameLoop(loops[0], next))
    );
    let inside = loops[0].twin();
    assert_eq!(
        can_bridge(&mesh, &[loops[0], inside], Bands::default()),
        Err(Refusal::NotABoundaryHalfedge(inside))
    );
}

#[test]
fn ripping_and_welding_are_opposites() {
    let start = zoo::grid(2, 2);
    // The line 3 4 5 from boundary to boundary cuts the grid into two pieces.
    let line: Vec<EdgeId> = [(3, 4), (4, 5)].iter().map(|&(a, b)| he(&start, a, b).edge()).collect();
    let mut mesh = start.clone();
    let made = rip_edges(&mut mesh, &line).unwrap();
    assert_eq!((made.vertices.len(), made.edges.len()), (3, 2));
    assert_eq!(counts(&mesh), [12, 14, 4]);
    assert_eq!(mesh.components().1, 2);
    // Each edge is welded with the one at the same place.
    for (old, new) in line.iter().zip(&made.edges) {
        weld_edges(&mut mesh, [*old, *new]).unwrap();
        mesh.validate().unwrap();
    }
    assert_eq!(counts(&mesh), counts(&start));
    mesh.compact();
    assert_eq!(zoo::faces(&mesh).len(), 4);
    assert!(mesh.edges().all(|e| mesh.ends(e).iter().all(|v| mesh.position(*v).fract() == Vec3::ZERO)));
}

#[test]
fn rips_inside_and_from_the_boundary() {
    let mut mesh = zoo::grid(4, 4);
    let lone = he(&mesh, 11, 12).edge();
    assert_eq!(can_rip_edges(&mesh, &[lone]), Err(Refusal::StaysJoined(lone)));
    // Two edges in a row inside make a slit.
    let row = [he(&mesh, 11, 12).edge(), he(&mesh, 12, 13).edge()];
    rip_edges(&mut mesh, &row).unwrap();
    counts(&mesh);
    assert_eq!(mesh.boundary_loops().len(), 2);
    let rim = mesh.edges().find(|&e| mesh.is_boundary_edge(e)).unwrap();
    assert_eq!(can_rip_edges(&mesh, &[rim]), Err(Refusal::BoundaryEdge(rim)));
    // One edge is enough if it ends at the boundary.
    let mut mesh = zoo::grid(2, 2);
    let spoke = he(&mesh, 1, 4).edge();
    rip_edges(&mut mesh, &[spoke]).unwrap();
    assert_eq!(counts(&mesh), [10, 13, 4]);
    // All edges: each face is on its own.
    let mut mesh = zoo::cube();
    let all: Vec<EdgeId> = mesh.edges().collect();
    rip_edges(&mut mesh, &all).unwrap();
    assert_eq!(counts(&mesh), [24, 24, 6]);
}

#[test]
fn welds_zip_and_close() {
    // Two boundary edges that share an end are zipped.
    let mut mesh = zoo::grid(4, 4);
    rip_edges(&mut mesh, &[he(&zoo::grid(4, 4), 2, 7).edge()]).unwrap();
    let h = mesh.boundary_loops()[0];
    let notch = mesh
        .loop_of(h)
        .find(|&h| mesh.position(mesh.from(h)) == mesh.position(mesh.to(mesh.next(h))))
        .unwrap();
    let pair = [notch.edge(), mesh.next(notch).edge()];
    weld_edges(&mut mesh, pair).unwrap();
    assert_eq!(counts(&mesh), [25, 40, 16]);
    let edge = notch.edge();
    assert_eq!(
        can_weld_edges(&mesh, [edge, edge]),
        Err(Refusal::GivenTwice(halfedge::Element::Edge, edge.raw()))
    );
    let rim = mesh.edges().find(|&e| mesh.is_boundary_edge(e)).unwrap();
    assert_eq!(can_weld_edges(&mesh, [rim, edge]), Err(Refusal::NotOnBoundary(edge)));
    // Two edges of a triangle can't be welded.
    let mesh = zoo::triangle();
    let [a, b] = [0, 1].map(EdgeId::new);
    assert!(can_weld_edges(&mesh, [a, b]).is_err());
}

#[test]
fn turning_pieces_inside_out() {
    let mut mesh = zoo::several();
    zoo::paint(&mut mesh);
    let start = mesh.clone();
    let cube: Vec<FaceId> = mesh.faces().take(6).collect();
    flip_orientation(&mut mesh, &cube).unwrap();
    mesh.validate().unwrap();
    for &f in &cube {
        let (mut now, before): (Vec<_>, Vec<_>) =
            (mesh.face_vertices(f).collect(), start.face_vertices(f).collect());
        assert_eq!(now[0], before[0], "the first corner stays");
        now[1..].reverse();
        assert_eq!(now, before);
        // Values stay with their corners.
        for h in mesh.face_halfedges(f) {
            let old = start.face_halfedges(f).find(|&old| start.from(old) == mesh.from(h)).unwrap();
            let uv = halfedge::keys::CORNER_UV;
            assert_eq!(mesh.get(uv, h.index()), start.get(uv, old.index()));
            let normal = halfedge::keys::CORNER_NORMAL;
            assert_eq!(mesh.get(normal, h.index()), -start.get(normal, old.index()));
        }
    }
    flip_orientation(&mut mesh, &cube).unwrap();
    assert!(mesh == start);
    // All pieces at once, some with a boundary.
    let all: Vec<FaceId> = mesh.faces().collect();
    flip_orientation(&mut mesh, &all).unwrap();
    mesh.validate().unwrap();
    assert!(matches!(can_flip_orientation(&mesh, &cube[..5]), Err(Refusal::NotAWholePiece(_))));
    assert_eq!(can_flip_orientation(&mesh, &[]), Err(Refusal::NothingGiven(halfedge::Element::Face)));
    assert!(mesh.has_vertex(v(0)));
}
