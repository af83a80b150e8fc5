//! Jumping to any state of the history.

mod support;

use editor::halfedge::Element;
use editor::{Begun, Document, Editor, SelectMode};
use proptest::prelude::*;
use serde_json::json;
use support::*;

/// An editor with edits of several kinds and selections between them, and the document after each edit.
fn edited() -> (Editor, Vec<Document>) {
    let mut editor = on_cube();
    let mut states = vec![editor.document().clone()];
    let edits = [
        json!({"op": "extrude-faces", "faces": [0], "distance": 1}),
        json!({"op": "subdivide-catmull-clark"}),
        json!({"op": "set-vertex-position", "vertex": 0, "position": [5, 6, 7]}),
        json!({"op": "new", "shape": "torus", "add": true}),
        json!({"op": "delete-faces", "faces": [3]}),
        json!({"op": "new", "shape": "tetrahedron"}),
        json!({"op": "poke-faces", "faces": [1]}),
    ];
    for (at, edit) in edits.into_iter().enumerate() {
        editor.select(Element::Face, [at as u32 % 3], SelectMode::Replace).expect("there");
        run(&mut editor, edit);
        editor.select(Element::Face, [2], SelectMode::Replace).expect("there");
        states.push(editor.document().clone());
    }
    (editor, states)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn every_state_is_one_jump_away(jumps in prop::collection::vec(0usize..8, 1..12)) {
        let (mut editor, states) = edited();
        let all = editor.undo_labels().count();
        prop_assert_eq!(all + 1, states.len());
        for to in jumps {
            editor.jump_to(to).expect("free");
            prop_assert_eq!(editor.document(), &states[to]);
            prop_assert_eq!((editor.undo_labels().count(), editor.redo_labels().count()), (to, all - to));
            validate(&editor);
        }
        editor.jump_to(100).expect("free");
        prop_assert_eq!(editor.document(), &states[all]);
    }
}

#[test]
fn a_jump_cancels_an_ongoing_edit() {
    let (mut editor, states) = edited();
    editor.jump_to(4).expect("free");
    let drag = json!({"op": "set-vertex-position", "vertex": 1, "position": [9, 9, 9]});
    editor.update_edit(command(drag)).expect("a vertex");
    editor.jump_to(6).expect("free");
    assert_eq!(editor.document(), &states[6]);
    assert!(!editor.is_editing());
}

#[test]
fn a_jump_is_refused_as_a_whole_while_a_job_runs_on_the_mesh() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "new", "shape": "grid", "columns": 300, "rows": 300}));
    run(&mut editor, json!({"op": "set-vertex-position", "vertex": 0, "position": [0, 0, 1]}));
    run(&mut editor, json!({"op": "rename-object", "name": "Sheet"}));
    let Begun::Job(job) = editor.begin(command(json!({"op": "smooth"}))).expect("a mesh") else {
        panic!("a mesh of this size takes a job");
    };
    let before = editor.document().clone();
    // The first step back is a name, which the job doesn't need; the next one moves a vertex.
    let refused = editor.jump_to(1).expect_err("the mesh is in use").to_string();
    assert!(refused.contains("still running"), "{refused}");
    assert_eq!(editor.document(), &before);
    editor.cancel_job(job.id());
    editor.jump_to(1).expect("free");
    assert_eq!((editor.undo_labels().count(), editor.redo_labels().count()), (1, 2));
}

#[test]
fn the_history_says_when_its_first_steps_are_gone() {
    let (mut editor, _) = edited();
    assert!(editor.has_whole_history());
    editor.set_history_limit(editor.history_bytes() / 2);
    assert!(!editor.has_whole_history());
    editor.jump_to(0).expect("free");
    assert_eq!(editor.undo_labels().count(), 0);
}
