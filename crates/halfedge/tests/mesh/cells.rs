//! Meshes made cell by cell, with given ids.

use super::*;

/// Everything that `shared/design/half-edge-interface.md` asks for, on a closed mesh and on one with a boundary.
#[test]
fn the_course_interface_is_there() {
    let mut open = GivenIds::new();
    // Ids have gaps, and the second cell makes its own vertices.
    for id in [10, 20, 30] {
        open.add_vertex(id).unwrap();
    }
    open.add_cell(7, &[10, 20, 30]).unwrap();
    open.add_cell(9, &[20, 10, 40, 50]).unwrap();
    assert_eq!(open.vertex_ids(), [10, 20, 30, 40, 50]);
    assert_eq!(open.cell_ids(), [7, 9]);
    assert_eq!((open.max_vertex_id(), open.max_cell_id()), (Some(50), Some(9)));
    open.set_position(40, Vec3::new(1.0, 2.0, 3.0)).unwrap();
    assert_eq!(open.set_position(41, Vec3::ZERO), Err(AddFaceError::NoSuchVertex(41)));
    let v40 = open.vertex(40).unwrap();
    assert_eq!((0..3).map(|k| open.mesh().position(v40)[k]).collect::<Vec<_>>(), [1.0, 2.0, 3.0]);
    assert_eq!(open.mesh().face_degree(open.cell(9).unwrap()), 4);
    assert_eq!(open.add_vertex(10), Err(AddFaceError::IdTaken(10)));
    assert_eq!(open.add_cell(7, &[1, 2, 3]), Err(AddFaceError::IdTaken(7)));
    assert_eq!(open.add_cell(11, &[1, 2]), Err(AddFaceError::TooFewCorners(2)));
    assert_eq!(open.add_cell(11, &[10, 20, 60]), Err(AddFaceError::SideTaken(10, 20)));
    assert_eq!(open.add_cell(11, &[60, 20, 60]), Err(AddFaceError::RepeatedVertex(60)));
    assert_eq!(open.vertex(60), None, "a refused cell leaves no vertex behind");
    let (open, notes) = open.finish();
    assert!(notes.is_empty());

    let mut closed = GivenIds::new();
    closed.add_vertices(8).unwrap();
    assert_eq!(closed.add_vertices(3), Err(AddFaceError::IdTaken(0)));
    for (id, face) in CUBE.iter().enumerate() {
        closed.add_cell(id as u32, face).unwrap();
    }
    assert_eq!(closed.add_cell(6, &[0, 8, 9]), Err(AddFaceError::VertexClosed(0)));
    let (closed, notes) = closed.finish();
    assert!(notes.is_empty());

    for (mesh, boundary) in [(&open, true), (&closed, false)] {
        mesh.validate().unwrap();
        assert_eq!(mesh.boundary_loops().len(), usize::from(boundary));
        assert_eq!(mesh.vertices().count(), mesh.vertex_count());
        assert_eq!(mesh.halfedges().count(), mesh.halfedge_count());
        assert_eq!(mesh.edges().count(), mesh.edge_count());
        assert_eq!(mesh.faces().count(), mesh.face_count());
        assert_eq!(mesh.vertices().last().unwrap().index() + 1, mesh.capacity(Element::Vertex));
        assert_eq!(mesh.vertex(mesh.vertex_capacity() as u32), None);
        for v in mesh.vertices() {
            assert_eq!(mesh.vertex(v.raw()), Some(v));
            let out: Vec<_> = mesh.outgoing(v).collect();
            assert_eq!(out.len(), mesh.valence(v));
            assert_eq!(mesh.halfedge_from(v), Some(out[0]));
            assert_eq!(mesh.is_boundary_halfedge(out[0]), mesh.is_boundary_vertex(v));
            for k in 0..out.len() {
                let h = mesh.outgoing(v).nth(k).unwrap();
                assert_eq!(mesh.from(h), v);
                assert_eq!(mesh.find_halfedge(v, mesh.to(h)), Some(h));
                assert_eq!(mesh.prev_around_from(out[(k + 1) % out.len()]), h);
            }
            assert_eq!(mesh.find_halfedge(v, v), None);
        }
        for h in mesh.halfedges() {
            assert_eq!(mesh.halfedge(h.raw()), Some(h));
            assert_eq!(mesh.prev(mesh.next(h)), h);
            assert_eq!(mesh.from(mesh.next(h)), mesh.to(h));
            assert_eq!(h.twin().twin(), h);
            assert_eq!(h.edge().halfedge().edge(), h.edge());
            assert_eq!(mesh.face_of(h).is_none(), mesh.is_boundary_halfedge(h));
            let open = mesh.face_of(h).is_none() || mesh.face_of(h.twin()).is_none();
            assert_eq!(mesh.is_boundary_edge(h.edge()), open);
        }
        for f in mesh.faces() {
            assert_eq!(mesh.face(f.raw()), Some(f));
            assert_eq!(mesh.face_of(mesh.halfedge_of(f)), Some(f));
            assert_eq!(mesh.face_degree(f), mesh.face_vertices(f).count());
            assert_eq!(mesh.is_boundary_face(f), boundary);
        }
    }
}

#[test]
fn cells_that_only_touch_at_a_vertex_are_separated_when_finished() {
    let mut ids = GivenIds::new();
    ids.add_cell(0, &[0, 1, 2]).unwrap();
    ids.add_cell(1, &[0, 3, 4]).unwrap();
    ids.add_cell(2, &[0, 5, 6]).unwrap();
    assert_eq!(ids.mesh().validate().unwrap_err().rule, Rule::NonManifoldVertex);
    // The cell between the first two makes them one fan.
    ids.add_cell(3, &[0, 2, 3]).unwrap();
    let (mesh, notes) = ids.finish();
    mesh.validate().unwrap();
    assert_eq!(notes.len(), 1);
    assert_eq!(mesh.vertex_count(), 8);
}

proptest! {
    #[test]
    fn cells_added_in_any_order_give_the_mesh_that_a_soup_gives(soup in patchwork(), seed in any::<u64>()) {
        let mut order: Vec<usize> = (0..soup.face_count()).collect();
        let mut state = seed | 1;
        for i in (1..order.len()).rev() {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            order.swap(i, (state >> 33) as usize % (i + 1));
        }
        let mut ids = GivenIds::new();
        ids.add_vertices(soup.positions.len() as u32).unwrap();
        for &f in &order {
            prop_assert!(ids.add_cell(f as u32 + 5, soup.face(f)).is_ok());
        }
        let (mesh, _) = ids.finish();
        prop_assert_eq!(mesh.validate(), Ok(()));
        let expected = Mesh::build(soup).unwrap().mesh;
        prop_assert_eq!(mesh.vertex_count(), expected.vertex_count());
        prop_assert_eq!(mesh.edge_count(), expected.edge_count());
        prop_assert_eq!(mesh.boundary_loops().len(), expected.boundary_loops().len());
    }
}
