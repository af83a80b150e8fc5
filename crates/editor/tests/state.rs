//! The JSON that scripts see.

mod support;

use editor::halfedge::{Element, VertexId};
use editor::{Counts, Editor, SelectMode, element_kind};
use proptest::prelude::*;
use serde_json::{Value, json};
use support::*;

#[test]
fn the_state_has_what_the_interface_says() {
    let mut editor = on_two();
    run(&mut editor, json!({"op": "set-object-visible", "object": 1, "visible": false}));
    editor.undo().expect("free");
    editor.select(Element::Halfedge, [3, 1], SelectMode::Replace).expect("there");
    let state = editor.state();
    assert_eq!(
        state["document"],
        json!({
            "name": "Cube", "active": 0, "dirty": true,
            "objects": [
                {"name": "Cube", "visible": true, "faces": 6},
                {"name": "Grid", "visible": true, "faces": 4},
            ],
            "vertices": 17, "edges": 24, "halfedges": 48, "faces": 10,
            "boundary_loops": 1, "components": 2, "euler": 3,
        })
    );
    assert_eq!(state["selection"], json!({"kind": "halfedge", "ids": [1, 3]}));
    assert_eq!(state["history"]["undo"], json!(["New shape", "Activate object"]));
    assert_eq!(state["history"]["redo"], json!(["Show or hide object"]));
    assert_eq!(state["history"]["bytes"], editor.history_bytes());
    assert_eq!((&state["jobs"], &state["messages"]), (&json!([]), &json!([])));
    let _ = editor.run(command(json!({"op": "split-edge", "edge": 99})));
    assert_eq!(
        editor.state()["messages"],
        json!([{"kind": "error", "text": "Split edge: there is no edge 99; ids go from 0 to 11."}])
    );
}

#[test]
fn counts_follow_every_edit() {
    let mut editor = on_cube();
    let loops = |editor: &editor::Editor| editor.state()["document"]["boundary_loops"].clone();
    assert_eq!(loops(&editor), 0);
    run(&mut editor, json!({"op": "split-edge", "edge": 0}));
    assert_eq!(editor.state()["document"]["vertices"], 9);
    editor.undo().expect("free");
    assert_eq!(editor.state()["document"]["vertices"], 8);
    run(&mut editor, json!({"op": "separate", "faces": [0]}));
    assert_eq!(loops(&editor), 2);
    editor.undo().expect("free");
    assert_eq!(loops(&editor), 0);
}

#[test]
fn elements_have_their_pointers() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "set-vertex-position", "vertex": 7, "position": [0.1, 2.5, -3]}));
    let vertex = editor.element(Element::Vertex, 7).expect("there");
    assert_eq!(vertex["position"].to_string(), "[0.1,2.5,-3.0]");
    assert_eq!((&vertex["valence"], &vertex["boundary"]), (&json!(3), &json!(false)));
    let out = vertex["halfedge"].as_u64().expect("an id") as u32;
    let mesh = editor.mesh().expect("it").clone();
    assert_eq!(mesh.from(mesh.halfedge(out).expect("there")), VertexId::new(7));

    let h = mesh.halfedge(12).expect("there");
    assert_eq!(
        editor.element(Element::Halfedge, 12).expect("there"),
        json!({
            "id": 12, "next": mesh.next(h).raw(), "prev": mesh.prev(h).raw(), "twin": 13,
            "vertex": mesh.to(h).raw(), "edge": 6, "face": mesh.face_of(h).map(|f| f.raw()), "boundary": false,
        })
    );
    let face = editor.element(Element::Face, 0).expect("there");
    assert_eq!(
        (&face["corners"], &face["color"], &face["area"]),
        (&json!([0, 2, 3, 1]), &json!("#c8c8c8"), &json!(1.0))
    );
    let edge = editor.element(Element::Edge, 0).expect("there");
    assert_eq!((&edge["length"], &edge["boundary"]), (&json!(1.0), &json!(false)));

    let open = editor::Editor::with_mesh("Patches", patches());
    let boundary = open.mesh().expect("it").boundary_loops()[0];
    let halfedge = open.element(Element::Halfedge, boundary.raw()).expect("there");
    assert_eq!((&halfedge["face"], &halfedge["boundary"]), (&Value::Null, &json!(true)));

    for (kind, id) in [(Element::Vertex, 8), (Element::Edge, 12), (Element::Halfedge, 24), (Element::Face, 6)]
    {
        let error = editor.element(kind, id).expect_err("past the end");
        assert_eq!(error.to_string(), format!("element: `id`: there is no {kind} {id}"));
    }
    assert!(editor::Editor::new().element(Element::Vertex, 0).is_err());
}

#[test]
fn kinds_have_names() {
    assert_eq!(element_kind("half-edge"), Some(Element::Halfedge));
    assert_eq!(element_kind("halfedge"), Some(Element::Halfedge));
    assert_eq!(element_kind("corner"), None);
}

proptest! {
    #[test]
    fn counts_agree_with_traversals(deleted in prop::collection::vec(0u32..64, 0..40)) {
        let mut editor = Editor::new();
        run(&mut editor, json!({"op": "new", "shape": "grid", "columns": 8, "rows": 8}));
        for face in deleted {
            // Some are gone already.
            let _ = editor.run(command(json!({"op": "delete-faces", "faces": [face]})));
        }
        let mesh = editor.mesh().expect("a grid");
        let counts = Counts::of(mesh);
        prop_assert_eq!(counts.boundary_loops, mesh.boundary_loops().len());
        prop_assert_eq!(counts.components, mesh.components().1);
        let state = editor.state();
        prop_assert_eq!(&state["document"]["components"], &json!(counts.components));
        prop_assert_eq!(&state["document"]["boundary_loops"], &json!(counts.boundary_loops));
    }
}
