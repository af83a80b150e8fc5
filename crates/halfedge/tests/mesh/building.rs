//! Building, repairing, traversing and validating.

use super::*;

#[test]
fn an_empty_soup_is_an_empty_mesh() {
    let (mesh, notes) = built(0, &[]);
    assert!(notes.is_empty());
    assert_eq!(mesh, Mesh::new());
    assert_eq!(mesh.euler_characteristic(), 0);
    assert_eq!(mesh.components().1, 0);
    assert!(mesh.boundary_loops().is_empty());
}

#[test]
fn a_cube_is_closed_and_keeps_the_order_of_everything() {
    let (mesh, notes) = built(8, CUBE);
    assert!(notes.is_empty());
    assert_eq!((mesh.vertex_count(), mesh.edge_count(), mesh.face_count()), (8, 12, 6));
    assert_eq!(mesh.halfedge_count(), 24);
    assert_eq!(mesh.euler_characteristic(), 2);
    assert!(mesh.boundary_loops().is_empty());
    for (f, face) in CUBE.iter().enumerate() {
        assert_eq!(corners(&mesh, f as u32), *face);
    }
    // Edges are numbered in the order in which faces first use them.
    assert_eq!(mesh.ends(mesh.edge(0).unwrap()).map(VertexId::raw), [0, 1]);
    assert_eq!(mesh.ends(mesh.edge(1).unwrap()).map(VertexId::raw), [1, 3]);
    assert_eq!(mesh.to_soup(), soup(8, CUBE));
}

#[test]
fn boundaries_are_loops_and_come_first_at_their_vertices() {
    // Two squares side by side, and an isolated vertex.
    let (mesh, _) = built(7, &[&[0, 1, 4, 3], &[1, 2, 5, 4]]);
    let loops = mesh.boundary_loops();
    assert_eq!(loops.len(), 1);
    assert_eq!(mesh.loop_of(loops[0]).count(), 6);
    for v in mesh.vertices().filter(|v| v.raw() != 6) {
        let first = mesh.outgoing(v).next().unwrap();
        assert!(mesh.is_boundary_halfedge(first), "{v}");
    }
    assert_eq!(mesh.valence(VertexId::new(1)), 3);
    assert_eq!(mesh.vertex_faces(VertexId::new(1)).count(), 2);
    assert_eq!(mesh.valence(VertexId::new(6)), 0);
    assert!(!mesh.is_boundary_vertex(VertexId::new(6)));
    assert_eq!(mesh.components().1, 2);
    assert_eq!(mesh.components().0, [0, 0, 0, 0, 0, 0, 1]);
}

#[test]
fn faces_are_turned_to_agree_with_the_majority() {
    let (mesh, notes) = built(4, &[&[0, 1, 2], &[0, 3, 1], &[3, 1, 2], &[0, 2, 3]]);
    assert_eq!(notes, [(NoteKind::FaceTurned, 1)]);
    assert_eq!(corners(&mesh, 2), [3, 2, 1], "the first corner stays first");
    assert_eq!(mesh.euler_characteristic(), 2);
    assert!(mesh.boundary_loops().is_empty());
}

#[test]
fn a_moebius_strip_is_cut_once() {
    let mut faces = Vec::new();
    for i in 0..5u32 {
        let (a, b) = (2 * i, 2 * i + 1);
        let (c, d) = if i == 4 { (1, 0) } else { (2 * i + 2, 2 * i + 3) };
        faces.push([a, c, d, b]);
    }
    let faces: Vec<&[u32]> = faces.iter().map(|f| f.as_slice()).collect();
    let (mesh, notes) = built(10, &faces);
    assert!(notes.contains(&(NoteKind::NotOrientable, 1)), "{notes:?}");
    assert_eq!(mesh.face_count(), 5);
    assert_eq!(mesh.vertex_count(), 12, "both ends of the cut are doubled");
    assert_eq!(mesh.boundary_loops().len(), 1);
}

#[test]
fn an_edge_with_three_faces_is_separated() {
    let (mesh, notes) = built(5, &[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4]]);
    assert!(notes.contains(&(NoteKind::NonManifoldEdge, 1)), "{notes:?}");
    assert_eq!(mesh.face_count(), 3);
    assert_eq!(mesh.components().1, 3);
    assert_eq!(mesh.vertex_count(), 9);
}

#[test]
fn a_bow_tie_vertex_gets_a_copy_for_its_second_fan() {
    let (mesh, notes) = built(5, &[&[0, 1, 2], &[0, 3, 4]]);
    assert_eq!(notes, [(NoteKind::VertexSeparated, 1)]);
    assert_eq!(mesh.vertex_count(), 6);
    assert_eq!(corners(&mesh, 0), [0, 1, 2]);
    assert_eq!(corners(&mesh, 1), [5, 3, 4]);
    assert_eq!(mesh.position(VertexId::new(5)), mesh.position(VertexId::new(0)));
}

#[test]
fn two_closed_fans_at_one_vertex_are_separated() {
    // Two tetrahedra that share vertex 0.
    let tetra = |a, b, c, d| [[a, b, c], [a, d, b], [d, c, b], [a, c, d]];
    let faces: Vec<[u32; 3]> = [tetra(0, 1, 2, 3), tetra(0, 4, 5, 6)].concat();
    let faces: Vec<&[u32]> = faces.iter().map(|f| f.as_slice()).collect();
    let (mesh, notes) = built(7, &faces);
    assert_eq!(notes, [(NoteKind::VertexSeparated, 1)]);
    assert_eq!(mesh.components().1, 2);
    assert_eq!(mesh.euler_characteristic(), 4);
}

#[test]
fn degenerate_duplicate_and_dangling_faces_are_left_out() {
    let faces: &[&[u32]] = &[
        &[0, 1, 2],
        &[0, 0, 1],
        &[0, 1],
        &[0, 1, 0, 2],
        &[1, 2, 0],
        &[0, 1, 9],
        &[3, 3, 4, 5, 5],
        &[2, 1, 0, 4],
    ];
    let built = Mesh::build(soup(6, faces)).unwrap();
    built.mesh.validate().unwrap();
    let notes: Vec<_> = built.notes.iter().map(|n| (n.kind, n.count, n.first.clone())).collect();
    assert!(notes.contains(&(NoteKind::MissingVertex, 1, vec![5])), "{notes:?}");
    assert!(notes.contains(&(NoteKind::DegenerateFace, 3, vec![1, 2, 3])), "{notes:?}");
    assert!(notes.contains(&(NoteKind::DuplicateFace, 1, vec![4])), "{notes:?}");
    assert_eq!(built.face_source, [0, 6, 7]);
    assert_eq!(built.mesh.face_count(), 3);
    assert_eq!(corners(&built.mesh, 1), [3, 4, 5], "corners that repeat in a row count once");
    for note in &built.notes {
        let text = note.to_string();
        assert!(text.starts_with(&note.count.to_string()) && text.ends_with(')'), "{text}");
    }
}

#[test]
fn a_two_sided_triangle_is_a_closed_surface() {
    let (mesh, notes) = built(3, &[&[0, 1, 2], &[0, 2, 1]]);
    assert!(notes.is_empty());
    assert_eq!(mesh.euler_characteristic(), 2);
    // Also beside a face that needs repair.
    let (mesh, notes) = built(6, &[&[0, 1, 2], &[0, 2, 1], &[3, 4, 5], &[4, 5, 3]]);
    assert_eq!(notes, [(NoteKind::DuplicateFace, 1)]);
    assert_eq!(mesh.face_count(), 3);
}

#[test]
fn the_hub_of_a_wheel_takes_no_longer_than_other_vertices() {
    // Visiting all spokes for each spoke would take 10^11 steps.
    let n = 300_000;
    let faces: Vec<[u32; 3]> = (1..=n).map(|i| [0, i, i % n + 1]).collect();
    let built = Mesh::build(PolygonSoup::new(points(n + 1), &faces)).unwrap();
    built.mesh.validate().unwrap();
    assert!(built.notes.is_empty());
    assert_eq!(built.mesh.valence(VertexId::new(0)), n as usize);
    assert_eq!(built.mesh.boundary_loops().len(), 1);
    assert_eq!(built.mesh.ends(built.mesh.edge(1).unwrap()).map(VertexId::raw), [1, 2], "numbered by faces");
}

#[test]
fn positions_that_are_not_finite_are_replaced_and_noted() {
    let mut bad = soup(3, &[&[0, 1, 2]]);
    bad.positions[1].y = f32::NAN;
    let built = Mesh::build(bad).unwrap();
    assert_eq!(
        (built.notes[0].kind, built.notes[0].first.as_slice()),
        (NoteKind::PositionNotFinite, &[1][..])
    );
    built.mesh.validate().unwrap();
}

#[test]
fn attributes_follow_their_elements_through_repair() {
    let mut soup = soup(5, &[&[0, 1, 2], &[0, 0, 1], &[2, 1, 3], &[1, 2, 4]]);
    soup.vertex_columns.push(Column::with_values(keys::VERTEX_CREASE, vec![0.0, 1.0, 2.0, 3.0, 4.0]));
    // The value of each corner tells its vertex and face.
    let uv = soup.corners.iter().enumerate().map(|(c, &v)| Vec2::new(v as f32, (c / 3) as f32)).collect();
    soup.corner_columns.push(Column::with_values(keys::CORNER_UV, uv));
    soup.face_columns.push(Column::with_values(keys::FACE_COLOR, (0..4).map(|i| Color([i; 3])).collect()));
    let mesh = Mesh::build(soup).unwrap().mesh;
    mesh.validate().unwrap();
    assert_eq!(mesh.attribute(keys::FACE_COLOR).unwrap(), [0, 2, 3].map(|i| Color([i; 3])));
    for f in mesh.faces() {
        for h in mesh.face_halfedges(f) {
            // The corner's vertex in the input.
            let vertex = mesh.get(keys::VERTEX_CREASE, mesh.from(h).index());
            let face = f32::from(mesh.get(keys::FACE_COLOR, f.index()).0[0]);
            assert_eq!(mesh.get(keys::CORNER_UV, h.index()), Vec2::new(vertex, face), "{h}");
        }
    }
    for h in mesh.halfedges().filter(|&h| mesh.is_boundary_halfedge(h)) {
        assert!(mesh.get(keys::CORNER_UV, h.index()).is_nan());
    }
}

#[test]
fn the_validator_names_the_broken_rule() {
    let (mesh, _) = built(7, &[&[0, 1, 4, 3], &[1, 2, 5, 4]]);
    let raw = mesh.into_raw();
    let broken = |change: &dyn Fn(&mut RawMesh)| {
        let mut raw = raw.clone();
        change(&mut raw);
        Mesh::from_raw(raw).validate().unwrap_err().rule
    };
    assert_eq!(broken(&|r| r.next.push(0)), Rule::ColumnLength);
    assert_eq!(broken(&|r| r.next[0] = 99), Rule::DanglingLink);
    assert_eq!(broken(&|r| r.to[0] = NONE), Rule::DanglingLink);
    assert_eq!(broken(&|r| r.next[0] = r.next[4]), Rule::NextAndPrev);
    assert_eq!(broken(&|r| r.to[0] = r.to[1]), Rule::LoopEdge);
    assert_eq!(broken(&|r| r.face[0] = 1), Rule::FaceOfLoop);
    assert_eq!(broken(&|r| r.face_halfedge[0] = r.face_halfedge[1]), Rule::HalfedgeOfFace);
    assert_eq!(broken(&|r| r.vertex_halfedge[0] = r.vertex_halfedge[2]), Rule::HalfedgeOfVertex);
    assert_eq!(broken(&|r| r.positions[0].x = f32::INFINITY), Rule::PositionNotFinite);
    assert_eq!(broken(&|r| r.vertex_halfedge[0] = 0), Rule::BoundaryFirst);
    assert_eq!(broken(&|r| r.to[6] = 6), Rule::BrokenLoop);
    assert_eq!(broken(&|r| r.vertex_halfedge[6] = 0), Rule::HalfedgeOfVertex);
    // A defect is described in words.
    let mut bad = raw.clone();
    bad.positions[2].z = f32::NAN;
    let defect = Mesh::from_raw(bad).validate().unwrap_err();
    assert_eq!(defect.to_string(), "vertex 2: its position is not finite");
}

proptest! {
    #[test]
    fn any_soup_becomes_a_valid_mesh(
        faces in proptest::collection::vec(proptest::collection::vec(0u32..9, 0..6), 0..14)
    ) {
        let given = faces.len();
        let built = Mesh::build(PolygonSoup::new(points(8), &faces)).unwrap();
        prop_assert_eq!(built.mesh.validate(), Ok(()));
        prop_assert!(built.mesh.vertex_count() >= 8);
        let dropped: usize = built.notes.iter().filter(|n| matches!(n.kind,
            NoteKind::MissingVertex | NoteKind::DegenerateFace | NoteKind::DuplicateFace)).map(|n| n.count).sum();
        prop_assert_eq!(built.mesh.face_count() + dropped, given);
        prop_assert_eq!(built.face_source.len(), built.mesh.face_count());
        // Building the result again changes only the numbering of edges.
        let again = Mesh::build(built.mesh.to_soup()).unwrap();
        prop_assert!(again.notes.is_empty(), "{:?}", again.notes);
        prop_assert_eq!(again.mesh.to_soup(), built.mesh.to_soup());
    }
}
