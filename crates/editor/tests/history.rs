//! Undo, redo, ongoing edits, the memory limit of the history, and the reported changes.

mod support;

use editor::halfedge::{Element, Mesh, VertexId};
use std::ops::ControlFlow;

use editor::formats::Format;
use editor::{Command, Document, Editor, Finished, ObjectChange, SelectMode, Selection};
use proptest::prelude::*;
use serde_json::json;
use support::random::*;
use support::*;

fn position(editor: &Editor, v: usize) -> [f32; 3] {
    editor.mesh().expect("a mesh").position(VertexId::new(v)).to_array()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn can_agrees_with_refusals(edits in prop::collection::vec(any_edit(), 1..20), cube in any::<bool>()) {
        let mut editor = if cube { on_cube() } else { Editor::with_mesh("Patches", patches()) };
        for value in edits {
            let can = editor.can(&command(value.clone()));
            let messages = editor.messages().count();
            let ran = editor.run(command(value.clone()));
            validate(&editor);
            let refused = can.err().filter(|error| error.kind != editor::ErrorKind::NothingToDo);
            prop_assert_eq!(refused, ran.as_ref().err().cloned(), "{}", value);
            prop_assert_eq!(editor.messages().count() - messages, usize::from(ran.is_err()).min(200 - messages));
        }
    }

    #[test]
    fn undo_and_redo_go_through_the_same_states(
        steps in prop::collection::vec((any_command(), any_element(), 0u32..20), 1..14),
    ) {
        let mut editor = on_two();
        let first = editor.undo_labels().count();
        // Before each step the state it starts from, with what was selected then.
        let mut states: Vec<(Document, Selection)> = Vec::new();
        for (value, kind, id) in &steps {
            let _ = editor.select(*kind, [*id], SelectMode::Extend);
            let before = (editor.document().clone(), editor.selection().clone());
            let labels = editor.undo_labels().count();
            if editor.document().objects().iter().map(|o| o.mesh().face_count()).sum::<usize>() < 3000 {
                let _ = editor.run(command(value.clone()));
                validate(&editor);
            }
            match editor.undo_labels().count() - labels {
                0 => prop_assert_eq!(editor.document(), &before.0, "{}", value),
                1 => states.push(before),
                n => prop_assert!(false, "{} steps for {}", n, value),
            }
        }
        let last = (editor.document().clone(), editor.selection().clone());
        for (document, selection) in states.iter().rev() {
            prop_assert!(editor.undo().expect("free").is_some());
            prop_assert_eq!(editor.document(), document);
            prop_assert_eq!(editor.selection(), selection);
        }
        prop_assert_eq!(editor.undo_labels().count(), first);
        for (document, _) in states.iter().skip(1) {
            prop_assert!(editor.redo().expect("free").is_some());
            prop_assert_eq!(editor.document(), document);
        }
        if !states.is_empty() {
            prop_assert!(editor.redo().expect("free").is_some());
        }
        prop_assert_eq!(editor.document(), &last.0);
        prop_assert_eq!(editor.redo().expect("free"), None);
        validate(&editor);
    }
}

#[test]
fn a_drag_is_one_step_and_leaves_no_trace_when_cancelled() {
    let mut editor = on_cube();
    let before = editor.document().clone();
    for i in 1..=100 {
        let value = json!({"op": "set-vertex-position", "vertex": 7, "position": [i, 0, 0]});
        editor.update_edit(command(value)).expect("a move");
        assert_eq!(position(&editor, 7), [i as f32, 0.0, 0.0]);
        assert!(editor.is_editing() && editor.is_dirty());
        assert_eq!(editor.undo_labels().count(), 0);
    }
    assert_eq!(editor.cancel_edit().as_deref(), Some("Move vertex"));
    assert_eq!(editor.document(), &before);
    assert_eq!((editor.undo_labels().count(), editor.history_bytes(), editor.is_dirty()), (0, 0, false));

    for i in 1..=100 {
        editor
            .update_edit(command(json!({"op": "transform", "vertices": [7], "translate": [i, 0, 0]})))
            .expect("a move");
    }
    // Each preview replaced the last: the moves don't add up.
    assert_eq!(position(&editor, 7), [101.0, 1.0, 1.0]);
    let one = {
        let mut other = on_cube();
        run(&mut other, json!({"op": "transform", "vertices": [7], "translate": [100, 0, 0]}));
        other.history_bytes()
    };
    editor.commit_edit();
    assert_eq!(editor.undo_labels().collect::<Vec<_>>(), ["Move"]);
    assert_eq!(editor.history_bytes(), one, "a drag costs what one edit does");
    assert_eq!(editor.undo().expect("free").as_deref(), Some("Move"));
    assert_eq!(editor.document(), &before);
    assert_eq!(editor.redo().expect("free").as_deref(), Some("Move"));
    assert_eq!(position(&editor, 7), [101.0, 1.0, 1.0]);
    assert_eq!(editor.commit_edit(), None);
    assert_eq!(editor.cancel_edit(), None);
}

#[test]
fn a_file_written_during_a_drag_does_not_end_it() {
    let mut editor = on_cube();
    editor
        .update_edit(command(json!({"op": "transform", "vertices": [7], "translate": [1, 0, 0]})))
        .expect("a move");
    let request = editor.begin_export(Format::default());
    let written = request.run(&mut |_| ControlFlow::Continue(()));
    assert!(matches!(editor.finish(request.id(), written), Ok(Finished::Exported(_))));
    assert!(editor.is_editing());
    assert_eq!(editor.undo_labels().count(), 0);
    editor.cancel_edit();
    assert_eq!(position(&editor, 7), [1.0; 3]);
}

#[test]
fn a_drag_of_an_edit_that_makes_elements_is_one_step_too() {
    let mut editor = on_cube();
    editor.select(Element::Edge, [0, 11], SelectMode::Replace).expect("there");
    let before = editor.document().clone();
    for t in [0.1, 0.5, 0.9] {
        editor
            .update_edit(command(json!({"op": "split-edge", "edge": 0, "t": t, "connect": "all"})))
            .expect("a split");
        validate(&editor);
        assert_eq!(sizes(&editor), [9, 15, 8]);
    }
    editor.commit_edit();
    assert_eq!(editor.undo_labels().count(), 1);
    editor.undo().expect("free");
    assert_eq!(editor.document(), &before);
    assert_eq!(editor.selection().ids().collect::<Vec<_>>(), [0, 11]);
}

#[test]
fn a_preview_of_the_whole_mesh_is_kept_only_by_a_commit() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "triangulate-faces", "faces": [0, 1, 2, 3, 4, 5]}));
    run(&mut editor, json!({"op": "split-edge", "edge": 0}));
    editor.select(Element::Vertex, [3], SelectMode::Replace).expect("there");
    editor.mark_saved(editor.revision());
    let before = editor.document().clone();
    let smooth = |strength: f32| command(json!({"op": "smooth", "strength": strength, "iterations": 3}));
    let tried = |editor: &mut Editor| {
        let last = editor.last_command().cloned();
        editor.update_edit(smooth(0.7)).expect("quick");
        assert_ne!(editor.document(), &before);
        assert!(editor.is_previewing_mesh() && !editor.is_dirty());
        assert_eq!(editor.last_command().cloned(), last, "nothing was done");
    };
    tried(&mut editor);
    editor.update_edit(smooth(0.2)).expect("quick");
    let mut other = Editor::with_mesh("Cube", before.objects()[0].mesh().clone());
    run(&mut other, json!({"op": "smooth", "strength": 0.2, "iterations": 3}));
    assert_eq!(editor.mesh(), other.mesh(), "each preview is of the mesh as it was");

    // Whatever else is done takes it back first.
    let steps = |editor: &Editor| editor.undo_labels().count();
    assert_eq!(editor.cancel_edit().as_deref(), Some("Smooth"));
    assert_eq!((editor.document(), steps(&editor)), (&before, 2));
    assert_eq!(editor.selection().ids().collect::<Vec<_>>(), [3]);
    tried(&mut editor);
    assert_eq!(editor.undo().expect("free").as_deref(), Some("Smooth"));
    assert_eq!((editor.document(), steps(&editor)), (&before, 2));
    tried(&mut editor);
    let request = editor.begin_export(Format::default());
    let written = request.run(&mut |_| ControlFlow::Continue(()));
    assert!(matches!(editor.finish(request.id(), written), Ok(Finished::Exported(_))));
    assert_eq!((editor.document(), steps(&editor)), (&before, 2), "what is saved is what was done");
    tried(&mut editor);
    run(&mut editor, json!({"op": "split-edge", "edge": 1}));
    assert_eq!(editor.undo_labels().last(), Some("Split edge"));
    editor.undo().expect("free");
    assert_eq!((editor.document(), steps(&editor)), (&before, 2));
    tried(&mut editor);
    assert_eq!(editor.redo().expect("free").as_deref(), Some("Split edge"));
    editor.undo().expect("free");
    assert_eq!(editor.document(), &before);

    // Another operation in place of it, kept.
    tried(&mut editor);
    editor.update_edit(command(json!({"op": "simplify", "faces": 8}))).expect("quick");
    assert_eq!(editor.commit_edit().as_deref(), Some("Simplify"));
    assert_eq!(editor.mesh().map(Mesh::face_count), Some(8));
    assert_eq!(editor.last_command().map(Command::name), Some("simplify"));
    editor.undo().expect("free");
    assert_eq!(editor.document(), &before);
    assert_eq!(editor.selection().ids().collect::<Vec<_>>(), [3]);

    // What is refused, or takes long, shows nothing.
    for bad in [json!({"op": "simplify"}), json!({"op": "smooth", "iterations": 1000, "object": 7})] {
        assert!(editor.update_edit(command(bad)).is_err());
        assert_eq!((editor.document(), editor.is_editing()), (&before, false));
    }
    run(&mut editor, json!({"op": "new", "shape": "grid", "columns": 200, "rows": 200}));
    assert!(!editor.is_quick(&smooth(0.5)));
    let error = editor.update_edit(smooth(0.5)).expect_err("too much");
    assert!(error.to_string().contains("too long"), "{error}");
}

#[test]
fn a_refused_preview_leaves_the_last_one() {
    let mut editor = on_cube();
    editor.update_edit(command(json!({"op": "split-edge", "edge": 0, "t": 0.5}))).expect("a split");
    let shown = editor.document().clone();
    for bad in [
        json!({"op": "collapse-edge", "edge": 77}),
        json!({"op": "new", "shape": "cube"}),
        json!({"op": "rename-object", "name": "No"}),
        // Edge 12 is there in the preview only.
        json!({"op": "split-edge", "edge": 12}),
    ] {
        let error = editor.update_edit(command(bad.clone())).expect_err("refused");
        assert!(error.to_string().starts_with(bad["op"].as_str().expect("text")), "{error}");
        assert_eq!(editor.document(), &shown, "{bad}");
        assert!(editor.is_editing());
    }
    editor.commit_edit();
    editor.undo().expect("free");
    assert_eq!(editor.document(), on_cube().document());
    assert!(editor.update_edit(command(json!({"op": "split-edge", "edge": 77}))).is_err());
    assert!(!editor.is_editing());
}

#[test]
fn a_command_ends_a_drag_and_undo_takes_it_back() {
    let mut editor = on_cube();
    let value = json!({"op": "set-vertex-position", "vertex": 7, "position": [5, 0, 0]});
    editor.update_edit(command(value.clone())).expect("a move");
    run(&mut editor, json!({"op": "split-edge", "edge": 0}));
    assert_eq!(editor.undo_labels().collect::<Vec<_>>(), ["Move vertex", "Split edge"]);
    editor.update_edit(command(value)).expect("a move");
    assert_eq!(editor.undo().expect("free").as_deref(), Some("Move vertex"));
    assert_eq!(editor.undo_labels().count(), 2, "only the drag was taken back");
}

#[test]
fn history_is_bounded_by_bytes_and_drops_the_oldest() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "set-vertex-position", "vertex": 0, "position": [0, 0, 0.5]}));
    let step = editor.history_bytes();
    editor.set_history_limit(step * 10);
    for i in 0..100 {
        run(&mut editor, json!({"op": "set-vertex-position", "vertex": 0, "position": [0, 0, i]}));
        assert!(editor.history_bytes() <= editor.history_limit());
    }
    assert_eq!(editor.undo_labels().count(), 10);
    for i in (90..100).rev() {
        assert_eq!(position(&editor, 0), [0.0, 0.0, i as f32]);
        editor.undo().expect("free");
    }
    assert_eq!(editor.undo().expect("free"), None);
    assert_eq!(position(&editor, 0), [0.0, 0.0, 89.0]);
    // Redo counts too, and the latest step is kept whatever its size.
    assert_eq!(editor.redo_labels().count(), 10);
    editor.set_history_limit(0);
    run(&mut editor, json!({"op": "subdivide-linear"}));
    assert_eq!((editor.undo_labels().count(), editor.redo_labels().count()), (1, 0));
    editor.undo().expect("free");
    assert_eq!(position(&editor, 0), [0.0, 0.0, 89.0]);
}

#[test]
fn a_document_is_dirty_until_it_is_as_it_was_saved() {
    let mut editor = on_cube();
    assert!(!editor.is_dirty());
    run(&mut editor, json!({"op": "split-edge", "edge": 0}));
    assert!(editor.is_dirty());
    editor.undo().expect("free");
    assert!(!editor.is_dirty());
    editor.redo().expect("free");
    editor.mark_saved(editor.revision());
    assert!(!editor.is_dirty());
    editor.undo().expect("free");
    assert!(editor.is_dirty());
    run(&mut editor, json!({"op": "split-edge", "edge": 0}));
    assert!(editor.is_dirty(), "the same command is not the same state");
}

#[test]
fn changes_list_what_was_edited() {
    let mut editor = on_cube();
    let first = editor.take_changes();
    let id = editor.document().objects()[0].id();
    assert_eq!(first.of(id), Some(&ObjectChange::Added));
    assert!(editor.take_changes().is_empty());
    run(&mut editor, json!({"op": "set-vertex-position", "vertex": 7, "position": [5, 0, 0]}));
    run(&mut editor, json!({"op": "set-vertex-position", "vertex": 2, "position": [5, 0, 0]}));
    let changes = editor.take_changes();
    assert!(changes.history && !changes.selection);
    let Some(ObjectChange::Touched(touched)) = changes.of(id) else { panic!("{changes:?}") };
    assert_eq!(touched.vertices, [VertexId::new(2), VertexId::new(7)]);
    assert_eq!((touched.halfedges.len(), touched.edges.len(), touched.faces.len()), (0, 0, 0));
    editor.undo().expect("free");
    let changes = editor.take_changes();
    let Some(ObjectChange::Touched(touched)) = changes.of(id) else { panic!("{changes:?}") };
    assert_eq!(touched.vertices, [VertexId::new(2)]);
    run(&mut editor, json!({"op": "split-edge", "edge": 0}));
    run(&mut editor, json!({"op": "subdivide-linear"}));
    assert_eq!(editor.take_changes().of(id), Some(&ObjectChange::Everything));
    run(&mut editor, json!({"op": "new", "shape": "plane", "add": true}));
    let plane = editor.document().objects()[1].id();
    run(&mut editor, json!({"op": "delete-object", "object": 0}));
    let changes = editor.take_changes();
    assert_eq!((changes.of(id), changes.of(plane)), (Some(&ObjectChange::Gone), Some(&ObjectChange::Added)));
    assert!(changes.document);
    editor.undo().expect("free");
    assert_eq!(editor.take_changes().of(id), Some(&ObjectChange::Added));
    editor.select_all(Element::Face);
    let changes = editor.take_changes();
    assert!(changes.selection && changes.objects.is_empty());
}

#[test]
fn selecting_replaces_extends_toggles_and_ranges() {
    let mut editor = on_cube();
    let ids = |editor: &Editor| editor.selection().ids().collect::<Vec<_>>();
    editor.select(Element::Face, [1, 3], SelectMode::Replace).expect("there");
    editor.select(Element::Face, [5], SelectMode::Extend).expect("there");
    assert_eq!((ids(&editor), editor.selection().latest()), (vec![1, 3, 5], Some(5)));
    editor.select(Element::Face, [3, 4], SelectMode::Toggle).expect("there");
    assert_eq!((ids(&editor), editor.selection().latest()), (vec![1, 4, 5], Some(4)));
    editor.select_range(Element::Face, 2).expect("there");
    assert_eq!((ids(&editor), editor.selection().latest()), (vec![1, 2, 3, 4, 5], Some(2)));
    let error = editor.select(Element::Face, [0, 6], SelectMode::Extend).expect_err("no face 6");
    assert_eq!(error.to_string(), "select: `ids`: there is no face 6");
    assert_eq!(ids(&editor), [1, 2, 3, 4, 5]);
    editor.select(Element::Edge, [11], SelectMode::Extend).expect("another kind starts over");
    assert_eq!((editor.selection().kind(), ids(&editor)), (Element::Edge, vec![11]));
    editor.select_all(Element::Halfedge);
    assert_eq!(editor.selection().len(), 24);
    editor.deselect();
    assert!(editor.selection().is_empty());
    assert_eq!(editor.undo_labels().count(), 0);
}

#[test]
fn activating_another_object_drops_the_selection_and_undo_brings_it_back() {
    let mut editor = on_two();
    editor.select(Element::Vertex, [7], SelectMode::Replace).expect("there");
    run(&mut editor, json!({"op": "activate-object", "object": 1}));
    assert!(editor.selection().is_empty());
    editor.undo().expect("free");
    assert_eq!(editor.selection().ids().collect::<Vec<_>>(), [7]);
}

#[test]
fn the_first_colour_of_a_mesh_changes_its_own_face_alone() {
    let mut editor = on_cube();
    let id = editor.document().objects()[0].id();
    let _ = editor.take_changes();
    let faces = |editor: &mut Editor| match editor.take_changes().of(id) {
        Some(ObjectChange::Touched(touched)) => touched.faces.iter().map(|f| f.raw()).collect::<Vec<_>>(),
        other => panic!("{other:?}"),
    };
    run(&mut editor, json!({"op": "set-face-color", "faces": [3], "color": "#ff0000"}));
    assert_eq!(faces(&mut editor), [3]);
    editor.undo().expect("free");
    assert_eq!(faces(&mut editor), [3]);
    assert_eq!(editor.document(), on_cube().document());
    editor.redo().expect("free");
    assert_eq!(faces(&mut editor), [3]);
    run(&mut editor, json!({"op": "set-face-color", "faces": [4], "color": "#00ff00"}));
    assert_eq!(faces(&mut editor), [4]);
}

/// The labels of the edits that can be undone and redone.
fn labels(editor: &Editor) -> [Vec<&str>; 2] {
    [editor.undo_labels().collect(), editor.redo_labels().collect()]
}

fn selected(editor: &Editor) -> Vec<u32> {
    editor.selection().ids().collect()
}

#[test]
fn changes_of_the_selection_are_undone_step_by_step_but_are_no_edits() {
    let mut editor = on_cube();
    let pick = |editor: &mut Editor, ids: &[u32]| {
        editor.select(Element::Face, ids.iter().copied(), SelectMode::Replace).expect("there");
    };
    pick(&mut editor, &[1]);
    pick(&mut editor, &[1]);
    pick(&mut editor, &[1, 2]);
    run(&mut editor, json!({"op": "poke-faces", "faces": [0]}));
    editor.select_by(editor::SelectBy::Grow).expect("faces");
    editor.deselect();
    assert_eq!(labels(&editor), [vec!["Poke faces"], vec![]]);
    assert!(editor.history_bytes() > 0);

    let mut undone = Vec::new();
    while let Some(label) = editor.undo_step().expect("free") {
        undone.push((label, selected(&editor).len()));
    }
    let step = |label: &str, len| (label.to_owned(), len);
    let all = editor.mesh().expect("a mesh").face_count();
    assert_eq!(all, 6);
    // The selection of the same face again made no step.
    let expected =
        [step("Select", 8), step("Select", 2), step("Poke faces", 2), step("Select", 1), step("Select", 0)];
    assert_eq!(undone, expected);
    assert_eq!(labels(&editor), [vec![], vec!["Poke faces"]]);
    for len in [1, 2, 2, 8, 0] {
        assert!(editor.redo_step().expect("free").is_some());
        assert_eq!(selected(&editor).len(), len);
    }
    assert_eq!(editor.redo_step().expect("free"), None);

    // Undo for scripts goes from edit to edit.
    assert_eq!(editor.undo().expect("free").as_deref(), Some("Poke faces"));
    assert_eq!(selected(&editor), [1, 2]);
    assert_eq!(editor.undo().expect("free"), None, "no edit is left");
    assert_eq!(selected(&editor), [1, 2]);
    assert_eq!(editor.redo().expect("free").as_deref(), Some("Poke faces"));
    assert!(selected(&editor).is_empty(), "as it was when the edit was undone");
}

#[test]
fn selecting_forgets_no_edit_that_could_be_redone() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "split-edge", "edge": 0}));
    editor.select(Element::Vertex, [8], SelectMode::Replace).expect("there");
    editor.undo_step().expect("free");
    editor.undo_step().expect("free");
    editor.select(Element::Vertex, [3], SelectMode::Replace).expect("there");
    assert_eq!(labels(&editor), [vec![], vec!["Split edge"]]);
    assert_eq!(editor.redo_step().expect("free").as_deref(), Some("Split edge"));
    validate(&editor);
    // The change of the selection to vertex 8 was undone before something else was selected.
    assert_eq!(editor.redo_step().expect("free").as_deref(), Some("Select"));
    assert_eq!(selected(&editor), [8]);
    for wanted in ["Select", "Split edge"] {
        assert_eq!(editor.undo_step().expect("free").as_deref(), Some(wanted));
    }
    assert_eq!(selected(&editor), [3]);
}

#[test]
fn selections_count_for_the_limit_and_never_push_out_the_last_edit() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "new", "shape": "grid", "columns": 100, "rows": 100}));
    run(&mut editor, json!({"op": "set-vertex-position", "vertex": 0, "position": [0, 0, 1]}));
    let edits = editor.history_bytes();
    for id in 0..50 {
        editor.select(Element::Face, [9000 + id], SelectMode::Replace).expect("there");
    }
    assert!(editor.history_bytes() > edits + 50 * 9000 / 8, "{}", editor.history_bytes());
    editor.set_history_limit(edits / 2);
    assert!(editor.history_bytes() <= edits / 2);
    assert_eq!(editor.undo_labels().last(), Some("Move vertex"));
    editor.set_history_limit(0);
    assert_eq!(editor.undo_labels().collect::<Vec<_>>(), ["Move vertex"]);
    editor.select(Element::Face, [7], SelectMode::Replace).expect("there");
    assert_eq!(editor.undo_step().expect("free").as_deref(), Some("Move vertex"));
}

#[test]
fn an_operation_is_adjusted_whatever_was_selected_since() {
    let mut editor = on_cube();
    editor.select(Element::Face, [0], SelectMode::Replace).expect("there");
    run(&mut editor, json!({"op": "inset-faces", "amount": 0.1}));
    editor.select(Element::Face, [3], SelectMode::Replace).expect("there");
    let wider = command(json!({"op": "inset-faces", "amount": 0.3}));
    editor.adjust(wider.clone()).expect("the same faces");
    assert_eq!(labels(&editor), [vec!["Inset faces"], vec![]]);
    let mut other = on_cube();
    other.select(Element::Face, [0], SelectMode::Replace).expect("there");
    other.run(wider).expect("a face");
    assert_eq!(editor.document(), other.document());
}

#[test]
fn a_stroke_of_selecting_is_one_step() {
    let mut editor = on_cube();
    let paint = |editor: &mut Editor, ids: &[u32], mode, stroke| {
        editor.select_in_stroke(Element::Face, ids.iter().copied(), mode, stroke).expect("there");
    };
    paint(&mut editor, &[], SelectMode::Extend, 1);
    paint(&mut editor, &[0], SelectMode::Extend, 1);
    paint(&mut editor, &[1, 2], SelectMode::Extend, 1);
    paint(&mut editor, &[2, 3], SelectMode::Remove, 2);
    paint(&mut editor, &[0], SelectMode::Remove, 2);
    assert_eq!(selected(&editor), [1]);
    assert!(editor.undo_step().expect("free").is_some());
    assert_eq!(selected(&editor), [0, 1, 2]);
    // After an undo the same stroke begins another step.
    paint(&mut editor, &[5], SelectMode::Extend, 1);
    assert_eq!(selected(&editor), [0, 1, 2, 5]);
    assert!(editor.undo_step().expect("free").is_some());
    assert_eq!(selected(&editor), [0, 1, 2]);
    assert!(editor.undo_step().expect("free").is_some());
    assert!(selected(&editor).is_empty());
    assert_eq!(editor.undo_step().expect("free"), None);

    editor.select(Element::Vertex, [4], SelectMode::Replace).expect("there");
    paint(&mut editor, &[0], SelectMode::Remove, 3);
    assert_eq!((editor.selection().kind(), selected(&editor)), (Element::Vertex, vec![4]));
}
