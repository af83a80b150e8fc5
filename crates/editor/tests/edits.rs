//! Local edits as commands: their effect on small meshes, and how the selection fills in missing fields.

mod support;

use editor::halfedge::{Element, VertexId, keys};
use editor::ops::{Arity, FieldKind, Fill};
use editor::{Begun, Editor, OpId, Scope, SelectMode};
use serde_json::{Value, json};
use support::*;

/// An editor on a grid of 4 by 4 quads with a boundary.
fn on_grid() -> Editor {
    let mut editor = Editor::new();
    run(&mut editor, json!({"op": "new", "shape": "grid", "size": 4, "columns": 4, "rows": 4}));
    editor
}

/// The id of the edge between two vertices.
fn edge(editor: &Editor, a: usize, b: usize) -> u32 {
    let mesh = editor.mesh().expect("a mesh");
    mesh.find_edge(VertexId::new(a), VertexId::new(b)).expect("an edge").raw()
}

/// The change of the numbers of vertices, edges and faces that a command makes.
fn change(editor: &mut Editor, value: Value) -> [i64; 3] {
    let before = sizes(editor);
    let outcome = run(editor, value.clone());
    let after = sizes(editor);
    let change = std::array::from_fn(|i| after[i] as i64 - before[i] as i64);
    let (made, gone) = (&outcome.created, &outcome.removed);
    let told = [
        made.vertices as i64 - gone.vertices as i64,
        made.edges as i64 - gone.edges as i64,
        made.faces as i64 - gone.faces as i64,
    ];
    assert_eq!(told, change, "{value}: what is told is what is");
    // Ids that are told to be there are there, and the others are not.
    let mesh = editor.mesh().expect("a mesh");
    let (made, gone) = (made.ids.clone().expect("local"), gone.ids.clone().expect("local"));
    assert!(made.vertices.iter().all(|&v| mesh.vertex(v).is_some()), "{value}");
    assert!(made.edges.iter().all(|&e| mesh.edge(e).is_some()), "{value}");
    assert!(made.faces.iter().all(|&f| mesh.face(f).is_some()), "{value}");
    assert!(gone.vertices.iter().all(|&v| mesh.vertex(v).is_none()), "{value}");
    assert!(gone.edges.iter().all(|&e| mesh.edge(e).is_none()), "{value}");
    assert!(gone.faces.iter().all(|&f| mesh.face(f).is_none()), "{value}");
    change
}

#[test]
fn each_edit_changes_the_counts_as_it_should() {
    let inner = edge(&on_grid(), 6, 7);
    let rim = edge(&on_grid(), 0, 1);
    let hole = {
        let grid = on_grid();
        grid.mesh().expect("a grid").boundary_loops()[0].raw()
    };
    let cases: &[(Value, [i64; 3])] = &[
        (json!({"op": "flip-edge", "edge": inner}), [0, 0, 0]),
        (json!({"op": "collapse-edge", "edge": inner}), [-1, -1, 0]),
        (json!({"op": "collapse-edge", "edge": rim, "t": 0}), [-1, -1, 0]),
        (json!({"op": "collapse-face", "face": 5}), [-3, -4, -1]),
        (json!({"op": "dissolve-vertex", "vertex": 12}), [-1, -4, -3]),
        (json!({"op": "dissolve-edge", "edge": inner}), [0, -1, -1]),
        (json!({"op": "delete-faces", "faces": [0, 1]}), [-2, -4, -2]),
        (json!({"op": "delete-vertices", "vertices": [12]}), [-1, -4, -4]),
        (json!({"op": "triangulate-faces", "method": "ear", "faces": [3]}), [0, 1, 1]),
        (json!({"op": "poke-faces", "faces": [0, 15]}), [2, 8, 6]),
        (json!({"op": "connect-vertices", "vertices": [0, 6]}), [0, 1, 1]),
        (json!({"op": "extrude-faces", "faces": [5, 6], "distance": 0.5}), [6, 12, 6]),
        (json!({"op": "extrude-faces", "faces": [5, 6], "distance": 0.5, "mode": "individual"}), [8, 16, 8]),
        (json!({"op": "extrude-edges", "edges": [rim], "offset": [0, 1, 0]}), [2, 3, 1]),
        (json!({"op": "inset-faces", "faces": [5], "amount": 0.25}), [4, 8, 4]),
        (json!({"op": "loop-cut", "edge": inner, "cuts": 2}), [10, 18, 8]),
        (json!({"op": "slide-edges", "edges": [[5, 6], [6, 7]], "amount": -0.5}), [0, 0, 0]),
        (json!({"op": "slide-vertices", "vertices": [6, 7], "amount": 0.5}), [0, 0, 0]),
        (json!({"op": "fill-hole", "halfedge": hole}), [0, 0, 1]),
        (json!({"op": "merge-vertices", "vertices": [6, 7]}), [-1, -1, 0]),
        (json!({"op": "flip-orientation"}), [0, 0, 0]),
        (json!({"op": "set-crease", "edges": [inner], "vertices": [12], "sharpness": 2}), [0, 0, 0]),
    ];
    for (value, expected) in cases {
        let mut editor = on_grid();
        let before = editor.document().clone();
        assert_eq!(change(&mut editor, value.clone()), *expected, "{value}");
        assert_eq!(editor.undo_labels().count(), 2);
        editor.undo().expect("free");
        assert_eq!(editor.document(), &before, "{value}");
    }
}

#[test]
fn edits_that_need_a_closed_mesh_or_several_pieces() {
    let mut editor = on_cube();
    assert_eq!(
        change(&mut editor, json!({"op": "bevel-vertices", "vertices": [0], "width": 0.25})),
        [2, 3, 1]
    );
    let mut editor = on_cube();
    let made =
        change(&mut editor, json!({"op": "bevel-edges", "edges": [[0, 1]], "width": 0.25, "segments": 2}));
    assert_eq!(made[0] - made[1] + made[2], 0, "still a sphere");
    assert!(made[2] >= 2);

    // Two openings of a cube bridged: a ring.
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "delete-faces", "faces": [0, 1]}));
    editor.select_all(Element::Halfedge);
    let loops: Vec<u32> = editor.mesh().expect("it").boundary_loops().iter().map(|h| h.raw()).collect();
    assert_eq!(loops.len(), 2);
    run(&mut editor, json!({"op": "extrude-faces", "faces": [2], "distance": 1}));
    editor.undo().expect("free");
    // The same vertices are joined by edges already.
    let text = refusal(&mut editor, json!({"op": "bridge", "halfedges": loops}));
    assert!(text.starts_with("bridge: "), "{text}");
    run(
        &mut editor,
        json!({"op": "inset-faces", "faces": [2, 3, 4, 5], "amount": 0.1, "mode": "individual"}),
    );

    // Ripping the edge line of a grid and welding it again.
    let mut editor = on_grid();
    let line = [[2, 7], [7, 12]];
    assert_eq!(change(&mut editor, json!({"op": "rip-edges", "edges": line})), [2, 2, 0]);
    let open: Vec<u32> = editor.mesh().expect("it").edges().map(|e| e.raw()).collect();
    assert_eq!(open.len(), 42);
}

#[test]
fn edges_slide_to_the_left_of_the_first_and_vertices_along_a_direction() {
    let row = |editor: &Editor| {
        let mesh = editor.mesh().expect("it");
        [10, 11, 12, 13, 14].map(|v| mesh.position(VertexId::new(v)))
    };
    let slid = |value: Value| {
        let mut editor = on_grid();
        let before = row(&editor);
        let outcome = run(&mut editor, value);
        let after = row(&editor);
        let moves: Vec<glam::Vec3> = after.iter().zip(before).map(|(a, b)| *a - b).collect();
        (moves, outcome.warnings)
    };
    let forth = json!([[10, 11], [11, 12], [12, 13], [13, 14]]);
    let back = json!([[14, 13], [13, 12], [12, 11], [11, 10]]);
    let (left, notes) = slid(json!({"op": "slide-edges", "edges": forth, "amount": 0.5}));
    assert!(notes.is_empty() && left.iter().all(|by| by.length() > 0.01));
    let (right, _) = slid(json!({"op": "slide-edges", "edges": forth, "amount": -0.5}));
    assert!(left.iter().zip(&right).all(|(a, b)| (*a + *b).length() < 1e-5), "{left:?} {right:?}");
    let (other, _) = slid(json!({"op": "slide-edges", "edges": back, "amount": -0.5}));
    assert_eq!(other, left, "left of the way there is right of the way back");
    let way = left[0].to_array();
    let all = [10, 11, 12, 13, 14];
    let (by_vertex, _) =
        slid(json!({"op": "slide-vertices", "vertices": all, "direction": way, "amount": 0.5}));
    assert_eq!(by_vertex, left);
    // The selection stands in for elements.
    let mut editor = on_grid();
    let two = [edge(&editor, 10, 11), edge(&editor, 11, 12)];
    editor.select(Element::Edge, two, SelectMode::Replace).expect("they exist");
    run(&mut editor, json!({"op": "slide-edges", "amount": 0.5}));
    let text = refusal(&mut on_grid(), json!({"op": "slide-edges", "edges": forth, "amount": 2}));
    assert_eq!(text, "slide-edges: `amount`: 2 is out of range; it must be from -1 to 1");
    let text = refusal(
        &mut on_grid(),
        json!({"op": "slide-edges", "edges": [[11, 12], [12, 13], [12, 7]], "amount": 0.1}),
    );
    assert!(text.contains("three or more of the given edges meet at vertex 12"), "{text}");
    let text = refusal(
        &mut on_grid(),
        json!({"op": "slide-vertices", "vertices": [0], "direction": [0, 0, 0], "amount": 0.1}),
    );
    assert!(text.contains("`direction`") && text.contains("is too short to give a direction"), "{text}");
}

#[test]
fn split_vertex_opens_two_edges_into_triangles() {
    let mut editor = on_grid();
    let e = edge(&editor, 11, 12);
    run(&mut editor, json!({"op": "collapse-edge", "edge": e}));
    assert_eq!(sizes(&editor), [24, 39, 16]);
    let v = if editor.mesh().expect("it").vertex(11).is_some() { 11 } else { 12 };
    let mesh = editor.mesh().expect("it");
    let up = |w: usize| mesh.find_edge(VertexId::new(v), VertexId::new(w)).map(|e| e.raw());
    let edges = [up(6).or(up(7)).expect("an edge"), up(16).or(up(17)).expect("an edge")];
    let value =
        json!({"op": "split-vertex", "vertex": v, "edges": edges, "positions": [[0, 0, 0], [0.5, 0, 0]]});
    assert_eq!(change(&mut editor, value), [1, 3, 2]);
    // By selecting the two edges.
    editor.undo().expect("free");
    editor.select(Element::Edge, edges, SelectMode::Replace).expect("there");
    assert_eq!(change(&mut editor, json!({"op": "split-vertex"})), [1, 3, 2]);
    editor.undo().expect("free");
    editor.select(Element::Edge, [0], SelectMode::Replace).expect("there");
    let text = refusal(&mut editor, json!({"op": "split-vertex"}));
    assert!(text.contains("`edges`") && text.contains("1 is selected"), "{text}");
}

#[test]
fn welding_glues_what_ripping_opened() {
    let mut editor = on_grid();
    run(&mut editor, json!({"op": "delete-faces", "faces": [0]}));
    // The two open sides at the corner that is left.
    let mesh = editor.mesh().expect("it");
    let (a, b) = (edge(&editor, 1, 6), edge(&editor, 5, 6));
    assert!([a, b].iter().all(|&e| mesh.is_boundary_edge(mesh.edge(e).expect("there"))));
    editor.select(Element::Edge, [a, b], SelectMode::Replace).expect("there");
    assert_eq!(change(&mut editor, json!({"op": "weld-edges"})), [-1, -1, 0]);
}

#[test]
fn selected_elements_are_edited_one_after_the_other() {
    let mut editor = on_grid();
    // The four edges of a face: after some are collapsed others are gone.
    let face: Vec<u32> = {
        let mesh = editor.mesh().expect("it");
        mesh.face_halfedges(mesh.face(5).expect("there")).map(|h| h.edge().raw()).collect()
    };
    editor.select(Element::Edge, face.iter().copied(), SelectMode::Replace).expect("there");
    let change_of = change(&mut editor, json!({"op": "collapse-edge"}));
    assert_eq!(change_of[0], -3, "the face's corners are one vertex");
    assert_eq!(editor.undo_labels().count(), 2);
    assert!(editor.selection().is_empty(), "what is gone is not selected");
    editor.undo().expect("free");
    assert_eq!(editor.selection().len(), 4);

    editor.select_all(Element::Edge);
    let text = refusal(&mut editor, json!({"op": "flip-edge"}));
    assert!(text.contains("on the boundary"), "all or none: {text}");

    let rim = editor.mesh().expect("it").boundary_loops()[0];
    let rim: Vec<u32> = editor.mesh().expect("it").loop_of(rim).map(|h| h.raw()).collect();
    editor.select(Element::Halfedge, rim, SelectMode::Replace).expect("there");
    assert_eq!(change(&mut editor, json!({"op": "fill-hole"})), [0, 0, 1], "one loop is filled once");

    editor.select(Element::Vertex, [0, 1], SelectMode::Replace).expect("there");
    run(&mut editor, json!({"op": "set-crease", "sharpness": 3}));
    assert_eq!(editor.mesh().expect("it").get(keys::VERTEX_CREASE, 1), 3.0);
    editor.select(Element::Face, [3], SelectMode::Replace).expect("there");
    assert_eq!(change(&mut editor, json!({"op": "merge-vertices"})), [-3, -4, -1]);
    let text = refusal(&mut editor, json!({"op": "loop-cut"}));
    assert!(text.contains("`edge`") && text.contains("no edge is selected"), "{text}");
}

#[test]
fn sizes_beyond_the_limit_are_clamped_with_a_warning() {
    let mut editor = on_cube();
    let outcome = run(&mut editor, json!({"op": "inset-faces", "faces": [0], "amount": 5}));
    assert_eq!(outcome.warnings, ["Amount was limited to 0.5, because beyond that edges would reverse"]);
    let outcome = run(&mut on_cube(), json!({"op": "inset-faces", "faces": [0], "amount": 0.25}));
    assert_eq!(outcome.warnings, [] as [String; 0]);
    for op in [
        json!({"op": "inset-faces", "faces": [0], "amount": -0.1}),
        json!({"op": "bevel-edges", "edges": [0], "width": -1}),
        json!({"op": "bevel-vertices", "vertices": [0], "width": -1}),
        json!({"op": "bevel-edges", "edges": [0], "width": 0.1, "segments": 0}),
        json!({"op": "set-crease", "edges": [0], "sharpness": -1}),
        json!({"op": "extrude-faces", "faces": [0], "distance": 0.1, "mode": "both"}),
    ] {
        let text = refusal(&mut on_cube(), op.clone());
        let name = op["op"].as_str().expect("text");
        assert!(text.starts_with(&format!("{name}: `")), "{text}");
    }
}

#[test]
fn every_local_edit_refuses_elements_that_are_not_there() {
    for spec in OpId::ALL.iter().map(|id| id.spec()).filter(|spec| spec.scope == Scope::Elements) {
        for field in spec.fields {
            let wrong = match field.kind {
                FieldKind::Elements { arity: Arity::One, .. } => json!(99),
                FieldKind::Elements { .. } => json!([99, 98]),
                _ => continue,
            };
            // The other fields as they have to be, so that only this one is wrong.
            let mut value = json!({"op": spec.name, field.name: wrong});
            for other in spec.fields.iter().filter(|other| other.name != field.name) {
                if other.fill == Fill::Required {
                    value[other.name] = match other.kind {
                        FieldKind::Vector => json!([0, 0, 0]),
                        FieldKind::Color => json!("#ffffff"),
                        _ => json!(0.1),
                    };
                }
            }
            if spec.name == "split-vertex" {
                let other =
                    if field.name == "vertex" { ("edges", json!([0, 1])) } else { ("vertex", json!(0)) };
                value[other.0] = other.1;
            }
            let text = refusal(&mut on_cube(), value.clone());
            assert!(text.starts_with(&format!("{}: `{}", spec.name, field.name)), "{value}: {text}");
            assert!(text.contains("there is no"), "{value}: {text}");
        }
    }
}

#[test]
fn the_last_operation_can_be_adjusted() {
    let mut editor = on_cube();
    editor.select(Element::Face, [0], SelectMode::Replace).expect("there");
    let before = editor.document().clone();
    run(&mut editor, json!({"op": "extrude-faces", "distance": 1}));
    let last = editor.last_command().expect("just run").to_value();
    assert_eq!(last, json!({"op": "extrude-faces", "distance": 1.0, "mode": "region"}));
    for distance in [2.0, 3.0] {
        let adjusted =
            editor.adjust(command(json!({"op": "extrude-faces", "distance": distance}))).expect("free");
        assert!(matches!(adjusted, Begun::Done(_)));
        assert_eq!(editor.undo_labels().count(), 1);
    }
    let mut direct = on_cube();
    run(&mut direct, json!({"op": "extrude-faces", "faces": [0], "distance": 3}));
    assert_eq!(editor.document(), direct.document());

    // A refused adjustment leaves what was there, and the next one works.
    let error = editor.adjust(command(json!({"op": "extrude-faces", "distance": 1, "faces": [44]})));
    assert!(error.expect_err("no face 44").to_string().contains("no face 44"));
    assert_eq!(editor.document(), direct.document());
    assert!(editor.last_command().is_some());
    editor.undo().expect("free");
    assert_eq!(editor.document(), &before);
    assert_eq!(editor.last_command(), None);
    let error =
        editor.adjust(command(json!({"op": "extrude-faces", "distance": 1}))).expect_err("nothing to adjust");
    assert!(error.to_string().contains("no last operation"), "{error}");

    // After a drag too.
    editor.update_edit(command(json!({"op": "extrude-faces", "distance": 0.5}))).expect("a preview");
    assert_eq!(editor.last_command(), None);
    editor.commit_edit();
    assert!(editor.last_command().is_some());
}
