//! Recording changes, undoing and redoing.

use super::*;

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

proptest! {
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
}

#[test]
fn moves_of_much_of_a_large_mesh_are_undone_and_redone_as_a_column() {
    let (columns, rows) = (150, 150);
    let at = |i: u32| Vec3::new((i % columns) as f32, (i / columns) as f32, 0.0);
    let mut soup = PolygonSoup { positions: (0..columns * rows).map(at).collect(), ..PolygonSoup::default() };
    for i in (0..columns * (rows - 1)).filter(|i| i % columns + 1 < columns) {
        soup.push_face([i, i + 1, i + columns + 1, i + columns]);
    }
    let before = Mesh::build(soup).expect("a grid").mesh;
    for moved in [9_000, 12_000, 22_500] {
        let mut mesh = before.clone();
        mesh.start_recording();
        for v in (0..moved).chain(0..moved).map(VertexId::new) {
            mesh.set_position(v, mesh.position(v) + Vec3::Z);
        }
        let (mut journal, after) = (mesh.finish_recording(), mesh.clone());
        let bytes = journal.bytes();
        journal.fold_moves(&mesh);
        assert!(journal.bytes() <= bytes / 2, "{moved}: {} of {bytes}", journal.bytes());
        assert_eq!(journal.touched().everything, moved > 10_000, "{moved}");
        let redo = mesh.undo(journal);
        assert_eq!(mesh, before, "{moved}");
        mesh.undo(redo);
        assert_eq!(mesh, after, "{moved}");
    }
}
