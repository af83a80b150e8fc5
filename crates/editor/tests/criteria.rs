//! Selecting by commands, hiding, and named selections.

mod support;

use editor::{Begun, Command, Editor, OpId, Scope, SelectBy, SelectMode};
use halfedge::{Budget, Element};
use proptest::prelude::*;
use serde_json::{Value, json};
use support::*;

fn ids(editor: &Editor) -> Vec<u32> {
    editor.selection().ids().collect()
}

fn faces(editor: &mut Editor, ids: &[u32]) {
    editor.select(Element::Face, ids.iter().copied(), SelectMode::Replace).expect("there");
}

fn hidden(editor: &Editor) -> Vec<usize> {
    editor.document().active().expect("an object").hidden().iter().collect()
}

/// The reason for a refusal, as the interface gives it.
fn refusal(editor: &mut Editor, value: Value) -> String {
    editor.run(command(value)).expect_err("refused").reason()
}

#[test]
fn criteria_select_what_they_say() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "delete-faces", "faces": [5]}));
    let cases = [
        (json!({"op": "select-boundary", "kind": "edge"}), Element::Edge, 4),
        (json!({"op": "select-boundary", "kind": "halfedge"}), Element::Halfedge, 4),
        (json!({"op": "select-boundary"}), Element::Halfedge, 4),
        (json!({"op": "select-boundary", "kind": "face"}), Element::Face, 4),
        (json!({"op": "select-sharp-edges"}), Element::Edge, 8),
        (json!({"op": "select-sharp-edges", "angle": 91}), Element::Edge, 0),
        (json!({"op": "select-by-corners"}), Element::Face, 5),
        (json!({"op": "select-by-corners", "corners": 3}), Element::Face, 0),
        (json!({"op": "select-by-valence", "valence": 3}), Element::Vertex, 8),
        (json!({"op": "select-by-valence", "valence": 3, "compare": "different"}), Element::Vertex, 0),
        (json!({"op": "select-by-area", "area": 4.5}), Element::Face, 5),
        (json!({"op": "select-by-length", "length": 2.5, "compare": "more"}), Element::Edge, 0),
        (json!({"op": "select-non-planar"}), Element::Face, 0),
        (json!({"op": "select-degenerate"}), Element::Face, 0),
        (json!({"op": "select-degenerate", "kind": "edge", "at_most": 2}), Element::Edge, 12),
        (json!({"op": "select-isolated"}), Element::Vertex, 0),
        (json!({"op": "select-smaller-components", "kind": "face"}), Element::Face, 0),
        (json!({"op": "select-facing", "direction": [0, 0, 1], "angle": 10}), Element::Face, 1),
        (json!({"op": "select-elements", "edges": [[0, 1], 7]}), Element::Edge, 2),
        (json!({"op": "select-all", "kind": "face"}), Element::Face, 5),
        (json!({"op": "select-related", "by": "outline"}), Element::Edge, 4),
        (json!({"op": "select-related", "by": "linked"}), Element::Edge, 12),
        (json!({"op": "select-related", "by": "touching-faces"}), Element::Face, 5),
    ];
    for (value, kind, count) in cases {
        let outcome = run(&mut editor, value.clone());
        assert_eq!((editor.selection().kind(), ids(&editor).len()), (kind, count), "{value}");
        assert!(outcome.message.contains(&format!("{count} ")), "{}", outcome.message);
        assert!(outcome.created.is_empty() && outcome.removed.is_empty());
    }
    assert_eq!(editor.undo_labels().count(), 1, "selecting is no edit");
}

#[test]
fn similar_elements_are_like_the_latest() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "poke-faces", "faces": [0]}));
    run(&mut editor, json!({"op": "set-face-color", "faces": [1, 2], "color": "#ff0000"}));
    let mut similar = |kind, id, by: &str| {
        editor.select(kind, [id], SelectMode::Replace).expect("there");
        run(&mut editor, json!({"op": "select-similar", "by": by}));
        ids(&editor).len()
    };
    assert_eq!(similar(Element::Face, 1, "count"), 5);
    assert_eq!(similar(Element::Face, 6, "count"), 4);
    assert_eq!(similar(Element::Face, 1, "color"), 2);
    assert_eq!(similar(Element::Face, 3, "normal"), 1);
    assert_eq!(similar(Element::Face, 6, "normal"), 4);
    assert_eq!(similar(Element::Face, 1, "size"), 5);
    assert_eq!(similar(Element::Edge, 0, "size"), 12);
    assert_eq!(similar(Element::Edge, 12, "size"), 4);
    assert_eq!(similar(Element::Vertex, 8, "count"), 5, "the new vertex and those around it");
    editor.deselect();
    for (value, reason) in [
        (json!({"op": "select-similar"}), "Select a vertex first."),
        (json!({"op": "select-similar", "by": "color"}), "Select a face first."),
        (json!({"op": "select-facing"}), "Select a face first."),
        (
            json!({"op": "select-facing", "direction": [0, 0, 0]}),
            "Direction has no length, so it points nowhere.",
        ),
        (json!({"op": "select-elements"}), "Give one list: vertices, edges, half-edges or faces."),
        (json!({"op": "select-elements", "faces": [99]}), "There is no face 99."),
        (json!({"op": "hide"}), "Select something first."),
    ] {
        let before = editor.selection().clone();
        assert!(refusal(&mut editor, value.clone()).starts_with(reason.trim_end_matches('.')), "{value}");
        assert_eq!(editor.selection(), &before);
    }
    editor.select(Element::Edge, [1], SelectMode::Replace).expect("there");
    let edges = refusal(&mut editor, json!({"op": "select-similar"}));
    assert_eq!(edges, "Select a face or a vertex first: edges have no corners.");
}

#[test]
fn all_but_the_largest_component_are_selected() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "new", "shape": "tetrahedron", "add": true}));
    run(&mut editor, json!({"op": "new", "shape": "grid", "columns": 2, "rows": 1, "add": true}));
    run(&mut editor, json!({"op": "join-objects"}));
    for (kind, count) in [("vertex", 4 + 6), ("edge", 6 + 7), ("halfedge", 2 * (6 + 7)), ("face", 4 + 2)] {
        run(&mut editor, json!({"op": "select-smaller-components", "kind": kind}));
        assert_eq!(ids(&editor).len(), count, "{kind}");
    }
    run(&mut editor, json!({"op": "delete-faces"}));
    assert_eq!(sizes(&editor), [8, 12, 6], "the cube is left");
}

#[test]
fn modes_combine_with_the_selection() {
    let start = [0_u32, 1, 2];
    let found = [2_u32, 3];
    for (mode, expected) in [
        (SelectMode::Replace, vec![2, 3]),
        (SelectMode::Extend, vec![0, 1, 2, 3]),
        (SelectMode::Toggle, vec![0, 1, 3]),
        (SelectMode::Intersect, vec![2]),
    ] {
        let mut editor = on_cube();
        faces(&mut editor, &start);
        editor.select(Element::Face, found, mode).expect("there");
        assert_eq!(ids(&editor), expected, "{mode:?}");
        let mut editor = on_cube();
        faces(&mut editor, &start);
        run(
            &mut editor,
            json!({"op": "select-elements", "faces": found, "mode": serde_json::to_value(mode).expect("a word")}),
        );
        assert_eq!(ids(&editor), expected, "{mode:?} as a command");
        // Another kind starts over.
        let edges = if mode == SelectMode::Intersect { vec![] } else { vec![1] };
        editor.select(Element::Edge, [1], mode).expect("there");
        assert_eq!((editor.selection().kind(), ids(&editor)), (Element::Edge, edges));
    }
}

#[test]
fn a_selecting_command_is_adjusted_until_something_else_is_selected() {
    let mut editor = on_cube();
    // From nothing of one kind to nothing of another is no step.
    editor.switch_kind(Element::Face, false);
    run(&mut editor, json!({"op": "select-sharp-edges", "angle": 120}));
    assert!(ids(&editor).is_empty());
    let adjust = |editor: &mut Editor, angle: u32| {
        editor.adjust(command(json!({"op": "select-sharp-edges", "angle": angle}))).map(drop)
    };
    adjust(&mut editor, 60).expect("the last one");
    assert_eq!(ids(&editor).len(), 12);
    adjust(&mut editor, 100).expect("the last one");
    assert!(ids(&editor).is_empty());
    adjust(&mut editor, 10).expect("the last one");
    assert_eq!(editor.undo_step().expect("free").as_deref(), Some("Select"));
    assert_eq!(editor.undo_step().expect("free"), None, "one step in all");
    editor.redo_step().expect("free");
    assert_eq!(ids(&editor).len(), 12);
    editor.select(Element::Edge, [1], SelectMode::Extend).expect("there");
    run(&mut editor, json!({"op": "select-sharp-edges"}));
    faces(&mut editor, &[1]);
    assert!(adjust(&mut editor, 60).is_err(), "something else was selected");
    assert_eq!(ids(&editor), [1]);
}

#[test]
fn hidden_faces_are_left_alone() {
    let mut editor = on_cube();
    faces(&mut editor, &[0, 1]);
    let outcome = run(&mut editor, json!({"op": "hide"}));
    assert_eq!(outcome.message, "Hide: 2 faces hidden");
    assert!(ids(&editor).is_empty(), "what is hidden is deselected");
    assert_eq!(hidden(&editor), [0, 1]);
    assert_eq!(editor.state()["document"]["objects"][0]["hidden"], 2);
    editor.select_all(Element::Face);
    assert_eq!(ids(&editor), [2, 3, 4, 5]);
    faces(&mut editor, &[2]);
    editor.select_by(SelectBy::Linked).expect("a face");
    assert_eq!(ids(&editor), [2, 3, 4, 5]);
    faces(&mut editor, &[2]);
    editor.select_inverse(Element::Face);
    assert_eq!(ids(&editor), [3, 4, 5]);
    run(&mut editor, json!({"op": "select-by-corners"}));
    assert_eq!(ids(&editor), [2, 3, 4, 5]);
    // Faces 0 and 1 lie opposite each other: every edge and vertex has another face.
    editor.select_all(Element::Edge);
    assert_eq!(ids(&editor).len(), 12);
    run(&mut editor, json!({"op": "hide", "faces": [2]}));
    editor.select_all(Element::Edge);
    assert_eq!(ids(&editor).len(), 10, "two edges are between hidden faces");
    editor.select_all(Element::Halfedge);
    assert_eq!(ids(&editor).len(), 12, "those inside three faces");
    assert_eq!(editor.can(&command(json!({"op": "hide", "faces": [0]}))), Ok(()));
    assert_eq!(run(&mut editor, json!({"op": "hide", "faces": [0]})).message, "Hide: nothing changed");

    // A named element is selected all the same, and what is saved is everything.
    faces(&mut editor, &[0]);
    assert_eq!(ids(&editor), [0]);
    assert_eq!(editor.mesh().expect("a mesh").face_count(), 6);
    let steps = editor.undo_labels().count();
    run(&mut editor, json!({"op": "reveal"}));
    assert!(hidden(&editor).is_empty());
    assert_eq!(editor.state()["document"]["objects"][0].get("hidden"), None);
    let nothing = editor.can(&command(json!({"op": "reveal"}))).expect_err("nothing hidden").reason();
    assert_eq!(nothing, "Nothing is hidden.");
    editor.undo().expect("free");
    assert_eq!(hidden(&editor), [0, 1, 2]);
    editor.redo().expect("free");
    assert_eq!((hidden(&editor).len(), editor.undo_labels().count()), (0, steps + 1));
}

#[test]
fn isolating_again_reveals() {
    let mut editor = on_cube();
    let _ = editor.take_changes();
    editor.select(Element::Vertex, [0], SelectMode::Replace).expect("there");
    run(&mut editor, json!({"op": "isolate"}));
    assert_eq!(hidden(&editor).len(), 3, "those around the vertex stay");
    let changes = editor.take_changes();
    assert_eq!(changes.hidden.len(), 1);
    assert_eq!(changes.hidden[0].1.iter().collect::<Vec<_>>(), hidden(&editor));
    assert!(changes.objects.is_empty(), "the mesh is the same");
    assert_eq!(ids(&editor), [0]);
    run(&mut editor, json!({"op": "isolate"}));
    assert!(hidden(&editor).is_empty());
    run(&mut editor, json!({"op": "isolate", "edges": [0]}));
    assert_eq!(hidden(&editor).len(), 4);
    editor.undo().expect("free");
    assert!(hidden(&editor).is_empty());
}

#[test]
fn edits_keep_what_is_hidden_where_ids_stay() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "hide", "faces": [2, 4]}));
    run(&mut editor, json!({"op": "poke-faces", "faces": [2]}));
    let poked = hidden(&editor);
    assert!(poked.iter().all(|&f| editor.mesh().expect("it").exists(Element::Face, f as u32)), "{poked:?}");
    assert!(poked.contains(&4));
    run(&mut editor, json!({"op": "delete-faces", "faces": [4]}));
    assert!(!hidden(&editor).contains(&4));
    editor.undo().expect("free");
    assert_eq!(hidden(&editor), poked);
    let outcome = run(&mut editor, json!({"op": "remesh", "edge_length": 0.5}));
    assert!(hidden(&editor).is_empty(), "the faces have new ids");
    let count = poked.len();
    let of = if count == 1 { "face of" } else { "faces of" };
    assert_eq!(outcome.warnings, [format!("{count} hidden {of} Cube shown again")]);
    editor.undo().expect("free");
    assert_eq!(hidden(&editor), poked);
    editor.undo().expect("free");
    assert_eq!(hidden(&editor), [2, 4]);
}

#[test]
fn named_selections_live_with_the_document() {
    let mut editor = on_cube();
    assert_eq!(
        refusal(&mut editor, json!({"op": "name-selection", "name": "Top"})),
        "Select something first."
    );
    faces(&mut editor, &[1, 3]);
    run(&mut editor, json!({"op": "name-selection", "name": " Sides "}));
    editor.select(Element::Halfedge, [4, 5, 20], SelectMode::Replace).expect("there");
    run(&mut editor, json!({"op": "name-selection", "name": "Seam"}));
    let named = |editor: &Editor| editor.state()["document"]["objects"][0]["selections"].clone();
    assert_eq!(
        named(&editor),
        json!([
            {"name": "Sides", "kind": "face", "count": 2},
            {"name": "Seam", "kind": "halfedge", "count": 3},
        ])
    );
    run(&mut editor, json!({"op": "select-named", "name": "Sides"}));
    assert_eq!((editor.selection().kind(), ids(&editor)), (Element::Face, vec![1, 3]));
    faces(&mut editor, &[5]);
    run(&mut editor, json!({"op": "select-named", "name": "Sides", "mode": "extend"}));
    assert_eq!(ids(&editor), [1, 3, 5]);

    // Edits remove what vanished, undo brings it back.
    run(&mut editor, json!({"op": "delete-faces", "faces": [3]}));
    assert_eq!(named(&editor)[0]["count"], 1);
    editor.undo().expect("free");
    assert_eq!(named(&editor)[0]["count"], 2);
    let removed = |editor: &Editor| !editor.mesh().expect("it").exists(Element::Halfedge, 20);
    run(&mut editor, json!({"op": "dissolve-edge", "edge": 10}));
    assert!(removed(&editor));
    assert_eq!(named(&editor)[1]["count"], 2);
    editor.undo().expect("free");

    run(&mut editor, json!({"op": "rename-named-selection", "name": "Sides", "to": "Walls"}));
    let taken = refusal(&mut editor, json!({"op": "rename-named-selection", "name": "Walls", "to": "Seam"}));
    assert_eq!(taken, "New name: another selection is called “Seam”.");
    let unknown = refusal(&mut editor, json!({"op": "select-named", "name": "Sides"}));
    assert_eq!(unknown, "Name: there is no selection “Sides”; there are “Walls”, “Seam”.");
    run(&mut editor, json!({"op": "delete-named-selection", "name": "Seam"}));
    assert_eq!(named(&editor), json!([{"name": "Walls", "kind": "face", "count": 2}]));
    editor.undo().expect("free");
    assert_eq!(named(&editor).as_array().map(Vec::len), Some(2));
    let outcome = run(&mut editor, json!({"op": "remesh", "edge_length": 0.5}));
    assert_eq!(named(&editor), Value::Null);
    assert_eq!(
        outcome.warnings,
        ["The elements have new ids, so these named selections were dropped: “Walls”, “Seam”"]
    );
    editor.undo().expect("free");
    assert_eq!(named(&editor).as_array().map(Vec::len), Some(2));
}

/// A grid of 40,000 faces, which is too large to be searched at once.
fn on_large() -> Editor {
    let mut editor = Editor::new();
    run(&mut editor, json!({"op": "new", "shape": "grid", "columns": 200, "rows": 200}));
    editor
}

/// Looks for some elements at a time; returns how often.
fn step(editor: &mut Editor) -> usize {
    let mut steps = 0;
    while editor.is_selecting() {
        editor.select_some(&mut Budget::new(1000));
        steps += 1;
    }
    steps
}

#[test]
fn large_meshes_are_searched_some_elements_at_a_time() {
    let mut editor = on_large();
    faces(&mut editor, &[7]);
    editor.begin_select_by(SelectBy::Linked).expect("a face");
    assert_eq!(ids(&editor), [7], "not yet");
    assert!(step(&mut editor) > 20);
    assert_eq!(ids(&editor).len(), 40_000);
    editor.undo_step().expect("free");
    assert_eq!(ids(&editor), [7]);

    let sharp = command(json!({"op": "select-boundary", "kind": "edge"}));
    assert!(matches!(editor.begin(sharp.clone()), Ok(Begun::Selecting)));
    assert!(step(&mut editor) > 20);
    assert_eq!(ids(&editor).len(), 800);
    assert_eq!(editor.last_command(), Some(&sharp));
    assert_eq!(editor.messages().last().map(|m| m.text.as_str()), Some("Select boundary: 800 edges found"));

    // Whatever is done next comes after it; cancelling leaves the selection.
    editor.select_all(Element::Face);
    assert!(editor.is_selecting());
    run(&mut editor, json!({"op": "hide"}));
    assert_eq!(hidden(&editor).len(), 40_000);
    editor.undo().expect("free");
    faces(&mut editor, &[3]);
    editor.select_all(Element::Vertex);
    assert!(editor.is_selecting() && editor.cancel_selecting());
    assert_eq!((editor.is_selecting(), ids(&editor)), (false, vec![3]));
    editor.select_all(Element::Vertex);
    assert_eq!(editor.undo_step().expect("free").as_deref(), Some("Select"));
    assert_eq!(ids(&editor), [3]);
}

/// Some operation that selects or hides.
fn any_selecting() -> impl Strategy<Value = Value> {
    let list = || prop::collection::vec(0_u32..12, 1..5);
    let mode = || prop::sample::select(vec!["replace", "extend", "toggle", "intersect"]);
    prop_oneof![
        (list(), mode()).prop_map(|(f, m)| json!({"op": "select-elements", "faces": f, "mode": m})),
        (list(), mode()).prop_map(|(v, m)| json!({"op": "select-elements", "vertices": v, "mode": m})),
        mode().prop_map(|m| json!({"op": "select-boundary", "mode": m})),
        mode().prop_map(|m| json!({"op": "select-all", "kind": "face", "mode": m})),
        prop::sample::select(vec!["grow", "shrink", "linked", "edges", "touching-faces"])
            .prop_map(|by| json!({"op": "select-related", "by": by})),
        list().prop_map(|f| json!({"op": "hide", "faces": f})),
        Just(json!({"op": "hide"})),
        Just(json!({"op": "isolate"})),
        Just(json!({"op": "reveal"})),
        prop::sample::select(vec!["A", "B"]).prop_map(|n| json!({"op": "name-selection", "name": n})),
        prop::sample::select(vec!["A", "B"]).prop_map(|n| json!({"op": "select-named", "name": n})),
        list().prop_map(|f| json!({"op": "delete-faces", "faces": f})),
        list().prop_map(|f| json!({"op": "poke-faces", "faces": f})),
        (0_u32..12).prop_map(|e| json!({"op": "dissolve-edge", "edge": e})),
        Just(json!({"op": "subdivide-linear"})),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn undo_steps_restore_document_and_selection(values in prop::collection::vec(any_selecting(), 1..20)) {
        let mut editor = on_cube();
        let mut states = vec![(editor.document().clone(), editor.selection().clone())];
        for value in values {
            if editor.mesh().expect("it").face_count() > 500 {
                break;
            }
            let _ = editor.run(command(value.clone()));
            validate(&editor);
            let object = editor.document().active().expect("an object");
            let mesh = object.mesh();
            let exists = |kind, id| mesh.exists(kind, id);
            prop_assert!(object.hidden().iter().all(|f| exists(Element::Face, f as u32)), "{value}");
            for named in object.named_selections() {
                prop_assert!(named.selection.ids().all(|id| exists(named.selection.kind(), id)), "{value}");
            }
            let state = (editor.document().clone(), editor.selection().clone());
            if states.last() != Some(&state) {
                states.push(state);
            }
        }
        while let Some((document, selection)) = states.pop() {
            prop_assert_eq!(editor.document(), &document);
            prop_assert_eq!(editor.selection().ids().collect::<Vec<_>>(), selection.ids().collect::<Vec<_>>());
            // An empty selection of another kind is no step of its own.
            while states.last().is_some_and(|(d, s)| d == &document && s.is_empty() && selection.is_empty()) {
                states.pop();
            }
            prop_assert_eq!(editor.undo_step().expect("free").is_some(), !states.is_empty());
        }
    }
}

#[test]
fn every_selecting_operation_is_no_change_of_meshes() {
    for &id in OpId::ALL.iter().filter(|id| id.spec().scope == Scope::Selection) {
        let mut editor = on_cube();
        faces(&mut editor, &[1]);
        let before = editor.mesh().expect("it").clone();
        if let Ok(command) = Command::from_fields(id, Default::default()) {
            let _ = editor.run(command);
        }
        assert_eq!(editor.mesh(), Some(&before), "{}", id.spec().name);
    }
}
