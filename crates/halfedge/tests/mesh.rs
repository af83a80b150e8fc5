//! Building, repairing, traversing, validating, compacting and undoing.

use glam::{Vec2, Vec3};
use halfedge::attribute::{Column, Value};
use halfedge::edit::{Connect, Triangulation, set_crease, split_edge, triangulate_face};
use halfedge::{
    AddFaceError, Color, EdgeId, Element, FaceId, GivenIds, Mesh, NONE, NoteKind, PolygonSoup, RawMesh, Rule,
    VertexId, keys,
};
use proptest::prelude::*;

fn points(n: u32) -> Vec<Vec3> {
    (0..n).map(|i| Vec3::new(i as f32, (i % 7 * (i % 7) % 7) as f32, (i % 3) as f32)).collect()
}

fn soup(n: u32, faces: &[&[u32]]) -> PolygonSoup {
    PolygonSoup::new(points(n), faces)
}

fn built(n: u32, faces: &[&[u32]]) -> (Mesh, Vec<(NoteKind, usize)>) {
    let built = Mesh::build(soup(n, faces)).expect("small");
    built.mesh.validate().expect("valid");
    (built.mesh, built.notes.iter().map(|note| (note.kind, note.count)).collect())
}

const CUBE: &[&[u32]] =
    &[&[0, 1, 3, 2], &[4, 6, 7, 5], &[0, 4, 5, 1], &[2, 3, 7, 6], &[0, 2, 6, 4], &[1, 5, 7, 3]];

fn corners(mesh: &Mesh, f: u32) -> Vec<u32> {
    mesh.face_vertices(FaceId::new(f as usize)).map(VertexId::raw).collect()
}

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
    // Edges are numbered as the faces first name them.
    assert_eq!(mesh.ends(mesh.edge(0).unwrap()).map(VertexId::raw), [0, 1]);
    assert_eq!(mesh.ends(mesh.edge(1).unwrap()).map(VertexId::raw), [1, 3]);
    assert_eq!(mesh.to_soup(), soup(8, CUBE));
}

#[test]
fn boundaries_are_loops_and_come_first_at_their_vertices() {
    // Two squares side by side and a vertex on its own.
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
    // Beside something that needs repair it stays one, too.
    let (mesh, notes) = built(6, &[&[0, 1, 2], &[0, 2, 1], &[3, 4, 5], &[4, 5, 3]]);
    assert_eq!(notes, [(NoteKind::DuplicateFace, 1)]);
    assert_eq!(mesh.face_count(), 3);
}

#[test]
fn the_hub_of_a_wheel_takes_no_longer_than_other_vertices() {
    // Walking all spokes for each spoke would be 10^11 steps.
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
    // Each corner's coordinate says which vertex and face it belongs to.
    let uv = soup.corners.iter().enumerate().map(|(c, &v)| Vec2::new(v as f32, (c / 3) as f32)).collect();
    soup.corner_columns.push(Column::with_values(keys::CORNER_UV, uv));
    soup.face_columns.push(Column::with_values(keys::FACE_COLOR, (0..4).map(|i| Color([i; 3])).collect()));
    let mesh = Mesh::build(soup).unwrap().mesh;
    mesh.validate().unwrap();
    assert_eq!(mesh.attribute(keys::FACE_COLOR).unwrap(), [0, 2, 3].map(|i| Color([i; 3])));
    for f in mesh.faces() {
        for h in mesh.face_halfedges(f) {
            // The vertex the corner had in the input, whatever number it has now.
            let vertex = mesh.get(keys::VERTEX_CREASE, mesh.from(h).index());
            let face = f32::from(mesh.get(keys::FACE_COLOR, f.index()).0[0]);
            assert_eq!(mesh.get(keys::CORNER_UV, h.index()), Vec2::new(vertex, face), "{h}");
        }
    }
    for h in mesh.halfedges().filter(|&h| mesh.is_boundary_halfedge(h)) {
        assert!(mesh.get(keys::CORNER_UV, h.index()).is_nan());
    }
}

/// Calls everything that `shared/design/half-edge-interface.md` asks for, on a closed mesh and on
/// one with a boundary.
#[test]
fn the_course_interface_is_there() {
    let mut open = GivenIds::new();
    // Ids with gaps; the second cell makes its own vertices.
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
    // The cell between the first two joins them into one fan.
    ids.add_cell(3, &[0, 2, 3]).unwrap();
    let (mesh, notes) = ids.finish();
    mesh.validate().unwrap();
    assert_eq!(notes.len(), 1);
    assert_eq!(mesh.vertex_count(), 8);
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
    // A defect reads as a sentence.
    let mut bad = raw.clone();
    bad.positions[2].z = f32::NAN;
    let defect = Mesh::from_raw(bad).validate().unwrap_err();
    assert_eq!(defect.to_string(), "vertex 2: its position is not finite");
}

#[test]
fn splitting_an_edge_makes_what_it_says() {
    for (connect, faces, edges) in
        [(Connect::None, 6, 13), (Connect::Triangles, 6, 13), (Connect::All, 8, 15)]
    {
        let (mut mesh, _) = built(8, CUBE);
        let edge = mesh.edge(3).unwrap();
        let [a, b] = mesh.ends(edge);
        let split = split_edge(&mut mesh, edge, 0.25, connect).unwrap();
        mesh.validate().unwrap();
        assert_eq!((mesh.vertex_count(), mesh.edge_count(), mesh.face_count()), (9, edges, faces));
        assert_eq!(mesh.position(split.vertex), mesh.position(a).lerp(mesh.position(b), 0.25));
        assert_eq!(mesh.ends(edge), [a, split.vertex]);
        assert_eq!(mesh.ends(split.edges[0]), [split.vertex, b]);
        assert_eq!(split.faces.len(), faces - 6);
        for f in 0..6 {
            let first = corners(&mesh, f)[0];
            assert!(
                first == CUBE[f as usize][0] || first == split.vertex.raw(),
                "face {f} starts at {first}"
            );
        }
    }
}

#[test]
fn a_split_that_would_join_two_vertices_twice_is_refused() {
    let (mut mesh, _) = built(3, &[&[0, 1, 2], &[0, 2, 1]]);
    let before = mesh.clone();
    let edge = mesh.edge(0).unwrap();
    assert!(split_edge(&mut mesh, edge, 0.5, Connect::Triangles).is_err());
    assert!(split_edge(&mut mesh, edge, 0.0, Connect::None).is_err());
    assert!(split_edge(&mut mesh, edge, f32::NAN, Connect::None).is_err());
    assert_eq!(mesh, before);
    split_edge(&mut mesh, edge, 0.5, Connect::None).unwrap();
    mesh.validate().unwrap();
}

#[test]
fn a_failed_transaction_leaves_no_trace() {
    let (mut mesh, _) = built(8, CUBE);
    let before = mesh.clone();
    let result: Result<((), _), &str> = mesh.transaction(|mesh| {
        split_edge(mesh, mesh.edge(0).unwrap(), 0.5, Connect::All).map_err(|_| "split")?;
        mesh.set(keys::FACE_COLOR, 2, Color([1, 2, 3]));
        Err("changed my mind")
    });
    assert_eq!(result.err(), Some("changed my mind"));
    assert_eq!(mesh, before);
}

#[test]
fn writes_to_columns_past_the_65_536th_undo_and_redo() {
    let (mesh, _) = built(8, CUBE);
    let mut raw = mesh.into_raw();
    for i in 0..65_540 {
        let mut column = Column::with_values(keys::FACE_SMOOTHING, vec![i; 6]);
        column.name = i.to_string();
        raw.columns.of_mut(Element::Face).push(column);
    }
    let mut mesh = Mesh::from_raw(raw);
    let start = mesh.clone();
    let last = mesh.columns().of(Element::Face).len() - 1;
    let ((), journal) = mesh
        .transaction(|mesh| {
            mesh.set_value(Element::Face, last, 2, Value::U32(7));
            let mut column = Column::with_values(keys::FACE_SMOOTHING, vec![9; 6]);
            column.name = (last - 1).to_string();
            mesh.insert_column(Element::Face, column);
            Ok::<_, ()>(())
        })
        .unwrap();
    let end = mesh.clone();
    // Not `assert_eq`, which would print all the columns.
    assert!(end != start);
    let redo = mesh.undo(journal);
    assert!(mesh == start);
    mesh.undo(redo);
    assert!(mesh == end);
}

#[test]
fn edits_that_change_nothing_record_nothing() {
    let (mut mesh, _) = built(6, &[&[0, 1, 2], &[2, 1, 3, 4]]);
    let uv = Column::with_values(keys::CORNER_UV, vec![Vec2::NAN; mesh.halfedge_capacity()]);
    mesh.insert_column(Element::Halfedge, uv.clone());
    mesh.set(keys::EDGE_CREASE, 1, 2.0);
    let start = mesh.clone();
    type Edit = fn(&mut Mesh);
    let idle: [(&str, Edit); 8] = [
        ("position", |m| m.set_position(VertexId::new(1), m.position(VertexId::new(1)))),
        ("positions", |m| m.set_positions(m.positions().to_vec()).unwrap()),
        ("value", |m| m.set(keys::EDGE_CREASE, 1, 2.0)),
        ("missing value", |m| m.set(keys::CORNER_UV, 3, Vec2::NAN)),
        ("default of no column", |m| m.set(keys::FACE_COLOR, 0, Color::UNPAINTED)),
        ("column", |m| {
            let column = m.column(Element::Halfedge, "uv").unwrap().clone();
            m.insert_column(Element::Halfedge, column);
        }),
        ("triangle", |m| drop(triangulate_face(m, FaceId::new(0), Triangulation::Fan).unwrap())),
        ("crease", |m| set_crease(m, &[EdgeId::new(1)], &[], 2.0).unwrap()),
    ];
    for (what, edit) in idle {
        mesh.start_recording();
        edit(&mut mesh);
        let journal = mesh.finish_recording();
        assert!(journal.is_empty() && mesh == start, "{what}");
    }
    let busy: [(&str, Edit); 4] = [
        ("the sign of zero", |m| m.set_position(VertexId::new(0), -Vec3::ZERO)),
        ("value", |m| m.set(keys::EDGE_CREASE, 1, 2.5)),
        ("color", |m| m.set(keys::FACE_COLOR, 0, Color([1, 2, 3]))),
        ("quad", |m| drop(triangulate_face(m, FaceId::new(1), Triangulation::Fan).unwrap())),
    ];
    for (what, edit) in busy {
        mesh.start_recording();
        edit(&mut mesh);
        let journal = mesh.finish_recording();
        assert!(!journal.is_empty() && mesh != start, "{what}");
        mesh.undo(journal);
        assert!(mesh == start, "{what}");
    }
}

#[test]
fn a_fan_starts_at_the_first_corner() {
    let (mut mesh, _) = built(6, &[&[2, 3, 4, 5, 0, 1]]);
    let made = triangulate_face(&mut mesh, FaceId::new(0), Triangulation::Fan).unwrap();
    mesh.validate().unwrap();
    assert_eq!((made.faces.len(), made.edges.len()), (3, 3));
    for f in mesh.faces() {
        assert_eq!(mesh.face_degree(f), 3);
        assert!(corners(&mesh, f.raw()).contains(&2));
    }
}

/// A grid of quads, some of them cut, some missing: boundaries, several pieces, mixed polygons.
fn patchwork() -> impl Strategy<Value = PolygonSoup> {
    (2u32..6, 2u32..6, proptest::collection::vec(0u8..4, 25)).prop_map(|(w, h, kinds)| {
        let mut out = PolygonSoup { positions: points((w + 1) * (h + 1)), ..Default::default() };
        for y in 0..h {
            for x in 0..w {
                let a = y * (w + 1) + x;
                let quad = [a, a + 1, a + w + 2, a + w + 1];
                match kinds[(y * w + x) as usize % kinds.len()] {
                    0 => {}
                    1 => {
                        out.push_face([quad[0], quad[1], quad[2]]);
                        out.push_face([quad[0], quad[2], quad[3]]);
                    }
                    _ => out.push_face(quad),
                }
            }
        }
        let colors = (0..out.face_count()).map(|i| Color([i as u8, 0, 0])).collect();
        out.face_columns.push(Column::with_values(keys::FACE_COLOR, colors));
        let uv = (0..out.corners.len()).map(|i| Vec2::splat(i as f32)).collect();
        out.corner_columns.push(Column::with_values(keys::CORNER_UV, uv));
        out
    })
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
        // What came out goes in again unchanged, apart from the numbering of edges.
        let again = Mesh::build(built.mesh.to_soup()).unwrap();
        prop_assert!(again.notes.is_empty(), "{:?}", again.notes);
        prop_assert_eq!(again.mesh.to_soup(), built.mesh.to_soup());
    }

    #[test]
    fn edits_undo_and_redo_to_the_bit(
        soup in patchwork(), picks in proptest::collection::vec((0u8..6, any::<u32>()), 1..30)
    ) {
        let mut mesh = Mesh::build(soup).unwrap().mesh;
        let mut states = vec![mesh.clone()];
        let mut undo = Vec::new();
        for (kind, pick) in picks {
            let edge = (mesh.edge_count() > 0).then(|| mesh.edge(pick % mesh.edge_capacity() as u32)).flatten();
            let face = (mesh.face_count() > 0).then(|| mesh.face(pick % mesh.face_capacity() as u32)).flatten();
            let v = VertexId::new(pick as usize % mesh.vertex_capacity());
            let done = mesh.transaction(|mesh| match (kind, edge, face) {
                (0, Some(e), _) => split_edge(mesh, e, 0.3, Connect::None).map(drop),
                (1, Some(e), _) => split_edge(mesh, e, 0.5, Connect::Triangles).map(drop),
                (2, Some(e), _) => split_edge(mesh, e, 0.5, Connect::All).map(drop),
                (3, _, Some(f)) => triangulate_face(mesh, f, Triangulation::Fan).map(drop),
                (4, _, Some(f)) => {
                    mesh.set(keys::FACE_COLOR, f.index(), Color([9, 9, kind]));
                    Ok(())
                }
                _ => {
                    mesh.set(keys::VERTEX_CREASE, v.index(), 2.0);
                    mesh.set_position(v, Vec3::splat(pick as f32));
                    Ok(())
                }
            });
            prop_assert_eq!(mesh.validate(), Ok(()));
            match done {
                Ok(((), journal)) => {
                    let touched = journal.touched();
                    prop_assert_eq!(mesh.validate_near(touched.vertices, touched.faces), Ok(()));
                    undo.push(journal);
                    states.push(mesh.clone());
                }
                Err(_) => prop_assert_eq!(&mesh, states.last().unwrap()),
            }
        }
        let mut redo = Vec::new();
        for (journal, state) in undo.into_iter().zip(&states).rev() {
            redo.push(mesh.undo(journal));
            prop_assert_eq!(&mesh, state);
        }
        for (journal, state) in redo.into_iter().rev().zip(&states[1..]) {
            mesh.undo(journal);
            prop_assert_eq!(&mesh, state);
        }
    }

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
