//! Each reason to refuse occurs, and says where and what to do.

use crate::zoo::{self, he, v};
use glam::Vec3;
use halfedge::edit::*;
use halfedge::{EdgeId, Element, FaceId, Refusal, VertexId};

/// A refusal for each reason but those that `name` excepts.
fn reached() -> Vec<Refusal> {
    let cube = zoo::cube();
    let grid = zoo::grid(2, 2);
    let strip = zoo::grid(2, 1);
    let pieces = zoo::several();
    let inner = he(&grid, 1, 4).edge();
    let rim = he(&grid, 0, 1).edge();
    let across = he(&strip, 1, 4).edge();
    let cut_coin = zoo::cut_coin();
    let frame = zoo::frame();
    let loops = frame.boundary_loops();
    let triangle = zoo::triangle();
    let mut joined = zoo::octahedron();
    let first = he(&joined, 0, 2).edge();
    flip_edge(&mut joined, first).unwrap();
    let mut tube = zoo::cube();
    delete_faces(&mut tube, &[FaceId::new(0), FaceId::new(1)]).unwrap();
    let ends = tube.boundary_loops();
    let mut twice_holed = zoo::grid(5, 5);
    delete_faces(&mut twice_holed, &[FaceId::new(6), FaceId::new(18)]).unwrap();
    let mut holed = zoo::complete_torus();
    delete_vertices(&mut holed, &[v(6)]).unwrap();
    let hole = holed.boundary_loops()[0];
    let filled = fill_hole(&mut holed, hole).unwrap().faces[0];
    let mut far = zoo::cube();
    let live = extrude_faces(&mut far, &[FaceId::new(0)], Grouping::Region).unwrap();
    let all: Vec<FaceId> = cube.faces().collect();

    let refused: Vec<Result<(), Refusal>> = vec![
        can_flip_edge(&cube, EdgeId::new(99)),
        can_delete_faces(&cube, &[]),
        can_merge_vertices(&cube, &[v(0), v(0)], None),
        can_collapse_edge(&cube, EdgeId::new(0), 2.0),
        can_merge_vertices(&cube, &[v(0), v(1)], Some(Vec3::INFINITY)),
        live.slide.apply(&mut far, f32::INFINITY).map(drop),
        can_flip_edge(&joined, he(&joined, 1, 3).edge()),
        can_split_edge(&zoo::pillow(), EdgeId::new(0), 0.5, Connect::Triangles),
        can_dissolve_vertex(&triangle, v(0)),
        can_collapse_edge(&cut_coin, he(&cut_coin, 0, 3).edge(), 0.5),
        can_bridge(&tube, &[ends[0], ends[1]], Bands::default()),
        can_merge_vertices(&pieces, &[v(0), v(8)], None),
        can_collapse_edge(&triangle, EdgeId::new(0), 0.5),
        can_flip_edge(&grid, rim),
        can_extrude_edges(&grid, &[inner]),
        can_fill_hole(&grid, inner.halfedge()),
        can_collapse_edge(&strip, across, 0.5),
        can_flip_edge(&zoo::tetrahedron(), EdgeId::new(0)),
        can_split_vertex(&grid, v(0), [rim, inner], None),
        can_connect_vertices(&cube, v(0), v(7)),
        can_dissolve_edges(&zoo::pillow(), &[EdgeId::new(0)]),
        can_inset_faces(&cube, &all, Grouping::Region),
        can_loop_cut(&triangle, EdgeId::new(0), 1, 0.5),
        can_slide_edges(&cube, &[(0, 1), (0, 2), (0, 4)].map(|(a, b)| he(&cube, a, b).edge()), 0.5),
        can_slide_edges(&zoo::coin(5), &[EdgeId::new(0)], 0.5),
        can_slide_vertices(&cube, &[v(0)], Vec3::ZERO, 0.5),
        can_bridge(&twice_holed, &twice_holed.boundary_loops(), Bands::default()),
        can_bridge(&frame, &[loops[0], frame.next(loops[0])], Bands::default()),
        can_bridge_faces(&cube, &[all[0], all[2]], Bands::default()),
        can_rip_edges(&cube, &[EdgeId::new(0)]),
        can_merge_vertices(&cube, &[VertexId::new(0)], None),
        can_flip_orientation(&cube, &all[1..]),
        can_triangulate_face(&holed, filled, Triangulation::Ears),
    ];
    refused.into_iter().map(|refused| refused.unwrap_err()).collect()
}

/// The name of each reason. A new reason must be added here, and so to the test.
fn name(refusal: &Refusal) -> &'static str {
    match refusal {
        Refusal::NoSuchElement(..) => "no such element",
        Refusal::NothingGiven(_) => "nothing given",
        Refusal::GivenTwice(..) => "given twice",
        Refusal::OnlyOne(..) => "only one",
        Refusal::OutOfRange { .. } => "out of range",
        Refusal::TooFarAway(_) => "too far away",
        // A unit test covers this: a mesh of two billion edges doesn't fit into memory.
        Refusal::TooManyEdges => "too many edges",
        Refusal::AlreadyJoined(..) => "already joined",
        Refusal::CutsMeet(_) => "cuts meet",
        Refusal::TooFewCorners(_) => "too few corners",
        Refusal::RepeatedCorner(_) => "repeated corner",
        Refusal::SideTaken(..) => "side taken",
        Refusal::Pinched(_) => "pinched",
        Refusal::LeftWithoutFace(_) => "left without face",
        Refusal::BoundaryEdge(_) => "boundary edge",
        Refusal::NotOnBoundary(_) => "not on boundary",
        Refusal::NotABoundaryHalfedge(_) => "not a boundary half-edge",
        Refusal::JoinsBoundaries(_) => "joins boundaries",
        Refusal::ValenceTooLow(..) => "valence too low",
        Refusal::NotAtVertex(..) => "not at vertex",
        Refusal::NotInOneFace(..) => "not in one face",
        Refusal::NotADisc(_) => "not a disc",
        Refusal::NoOutline(_) => "no outline",
        Refusal::NoRing(_) => "no ring",
        Refusal::Branches(_) => "branches",
        Refusal::NoRail(_) => "no rail",
        Refusal::NoDirection => "no direction",
        Refusal::NotInPairs(_) => "not in pairs",
        Refusal::SameLoop(..) => "same loop",
        Refusal::FacesTouch(..) => "faces touch",
        Refusal::StaysJoined(_) => "stays joined",
        Refusal::NotAWholePiece(_) => "not a whole piece",
        Refusal::NoTriangulation(_) => "no triangulation",
    }
}

#[test]
fn every_reason_occurs_and_is_explained() {
    let mut names: Vec<&str> = reached().iter().map(name).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), 32, "{names:?}");
    for refusal in reached() {
        let words = refusal.to_string();
        assert!(words.len() > 15, "{words}");
    }
    let words = Refusal::NoSuchElement(Element::Edge, 99).to_string();
    assert_eq!(words, "there is no edge 99");
}

#[test]
fn elements_that_do_not_exist_are_refused_by_every_edit() {
    let (bad_v, bad_e, bad_f) = (VertexId::new(99), EdgeId::new(99), FaceId::new(99));
    let bad_h = bad_e.halfedge();
    for (_, mesh) in zoo::all() {
        let e = mesh.edges().next().unwrap();
        let refused = [
            can_split_edge(&mesh, EdgeId::new(9999), 0.5, Connect::None),
            can_flip_edge(&mesh, EdgeId::new(9999)),
            can_collapse_edge(&mesh, EdgeId::new(9999), 0.5),
            can_collapse_face(&mesh, FaceId::new(9999)),
            can_split_vertex(&mesh, VertexId::new(9999), [e, e], None),
            can_split_vertex(&mesh, mesh.ends(e)[0], [e, EdgeId::new(9999)], None),
            can_dissolve_vertex(&mesh, VertexId::new(9999)),
            can_dissolve_edges(&mesh, &[EdgeId::new(9999)]),
            can_delete_faces(&mesh, &[FaceId::new(9999)]),
            can_delete_vertices(&mesh, &[VertexId::new(9999)]),
            can_triangulate_face(&mesh, FaceId::new(9999), Triangulation::Fan),
            can_triangulate_face(&mesh, FaceId::new(9999), Triangulation::Ears),
            can_poke_faces(&mesh, &[FaceId::new(9999)]),
            can_connect_vertices(&mesh, mesh.ends(e)[0], VertexId::new(9999)),
            can_extrude_faces(&mesh, &[FaceId::new(9999)], Grouping::Region),
            can_extrude_edges(&mesh, &[EdgeId::new(9999)]),
            can_inset_faces(&mesh, &[FaceId::new(9999)], Grouping::Region),
            can_bevel_edges(&mesh, &[EdgeId::new(9999)], 1),
            can_bevel_vertices(&mesh, &[VertexId::new(9999)]),
            can_loop_cut(&mesh, EdgeId::new(9999), 1, 0.5),
            can_slide_edges(&mesh, &[EdgeId::new(9999)], 0.5),
            can_slide_edges(&mesh, &[e, EdgeId::new(9999)], 0.5),
            can_slide_vertices(&mesh, &[VertexId::new(9999)], Vec3::X, 0.5),
            can_fill_hole(&mesh, EdgeId::new(9999).halfedge()),
            can_bridge(&mesh, &[EdgeId::new(9999).halfedge(); 2], Bands::default()),
            can_bridge_faces(&mesh, &[FaceId::new(9999); 2], Bands::default()),
            can_merge_vertices(&mesh, &[VertexId::new(9999)], None),
            can_weld_edges(&mesh, [EdgeId::new(9999), e]),
            can_rip_edges(&mesh, &[EdgeId::new(9999)]),
            can_flip_orientation(&mesh, &[FaceId::new(9999)]),
            can_set_crease(&mesh, &[EdgeId::new(9999)], &[], 1.0),
        ];
        for refused in refused {
            assert!(matches!(refused, Err(Refusal::NoSuchElement(_, 9999 | 19998))), "{refused:?}");
        }
    }
    // Removed elements too.
    let mut mesh = zoo::cube();
    let made = collapse_edge(&mut mesh, EdgeId::new(0), 0.5).unwrap();
    assert!(can_flip_edge(&mesh, made.removed_edges[0]).is_err());
    assert!(can_dissolve_vertex(&mesh, made.removed_vertex).is_err());
    let empty = halfedge::Mesh::new();
    assert!(can_delete_vertices(&empty, &[bad_v]).is_err());
    assert!(can_fill_hole(&empty, bad_h).is_err());
    assert!(can_poke_faces(&empty, &[bad_f]).is_err());
}
