//! Jumping to any state of the history.

mod support;

use editor::formats;
use editor::halfedge::{Budget, Element};
use editor::{Begun, Document, Editor, Jump, SelectMode};
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

/// Goes some steps further, and some more until the jump is done; returns the states that were passed.
fn passed(editor: &mut Editor, states: &[Document]) -> Vec<usize> {
    let mut passed = Vec::new();
    while editor.jump().is_some() {
        editor.jump_some(&mut Budget::new(1)).expect("free");
        validate(editor);
        let at = editor.undo_labels().count();
        assert_eq!(editor.document(), &states[at], "the state after {at} edits");
        passed.push(at);
    }
    passed.dedup();
    passed
}

#[test]
fn a_jump_in_parts_is_whole_after_each() {
    let (mut editor, states) = edited();
    editor.begin_jump(2).expect("free");
    assert_eq!(editor.jump(), Some(Jump { back: true, left: 5, all: 5 }));
    assert_eq!(editor.document(), &states[7], "nothing is done yet");
    assert_eq!(passed(&mut editor, &states), [6, 5, 4, 3, 2]);
    editor.begin_jump(100).expect("free");
    assert_eq!(passed(&mut editor, &states), [3, 4, 5, 6, 7]);
    editor.begin_jump(7).expect("free");
    assert_eq!(editor.jump(), None, "it is there already");
}

#[test]
fn a_jump_stops_where_it_is_or_goes_elsewhere() {
    let (mut editor, states) = edited();
    editor.begin_jump(0).expect("free");
    while editor.undo_labels().count() > 4 {
        editor.jump_some(&mut Budget::new(1)).expect("free");
    }
    assert!(editor.stop_jump());
    assert!(!editor.stop_jump());
    editor.jump_some(&mut Budget::unlimited()).expect("nothing to do");
    assert_eq!(editor.document(), &states[4]);
    editor.begin_jump(0).expect("free");
    editor.jump_some(&mut Budget::new(1)).expect("free");
    editor.begin_jump(6).expect("free");
    assert_eq!(passed(&mut editor, &states).last(), Some(&6));
}

#[test]
fn whatever_is_done_first_completes_a_jump() {
    type Act = fn(&mut Editor);
    let others: [(&str, Act); 5] = [
        ("undo", |editor| drop(editor.undo_step().expect("free"))),
        ("select", |editor| editor.select(Element::Face, [1], SelectMode::Replace).expect("a face")),
        ("run", |editor| drop(run(editor, json!({"op": "rename-object", "name": "Other"})))),
        ("drag", |editor| {
            let drag = json!({"op": "set-vertex-position", "vertex": 1, "position": [9, 9, 9]});
            drop(editor.update_edit(command(drag)).expect("a vertex"));
        }),
        ("save", |editor| drop(editor.begin_export(formats::Format::default()))),
    ];
    for (name, act) in others {
        let (mut one, _) = edited();
        let (mut other, _) = edited();
        one.jump_to(3).expect("free");
        other.begin_jump(3).expect("free");
        other.jump_some(&mut Budget::new(1)).expect("free");
        act(&mut one);
        act(&mut other);
        assert_eq!(other.jump(), None, "{name}");
        assert_eq!(one.document(), other.document(), "{name}");
        assert_eq!(one.undo_labels().count(), other.undo_labels().count(), "{name}");
    }
}
