//! Selections that follow from the current one.

mod support;

use editor::{Editor, SelectBy, SelectMode};
use halfedge::Element;
use serde_json::json;
use support::*;
use surface::selecting::Line;

/// A grid of six by six quads.
fn on_grid() -> Editor {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "new", "shape": "grid", "columns": 6, "rows": 6}));
    editor
}

fn ids(editor: &Editor) -> Vec<u32> {
    editor.selection().ids().collect()
}

fn select(editor: &mut Editor, kind: Element, ids: &[u32]) {
    editor.select(kind, ids.iter().copied(), SelectMode::Replace).expect("there");
}

#[test]
fn refusals_say_what_to_select_first_and_change_nothing() {
    let mut editor = on_grid();
    let cases = [
        (Element::Vertex, &[][..], SelectBy::Grow, "Select something first."),
        (Element::Edge, &[1], SelectBy::Outline, "Select faces first."),
        (Element::Face, &[1, 2, 3], SelectBy::Path, "Select the two ends of the path first."),
        (
            Element::Face,
            &[1],
            SelectBy::Loops,
            "Select two neighbouring faces first: they give the direction.",
        ),
        (
            Element::Vertex,
            &[1],
            SelectBy::Rings,
            "Select two neighbouring vertices first: they give the direction.",
        ),
        (Element::Edge, &[1], SelectBy::Kind(Element::Edge), "The selection consists of edges already."),
    ];
    for (kind, chosen, by, reason) in cases {
        select(&mut editor, kind, chosen);
        let before = editor.selection().clone();
        let asked = editor.can_select_by(by).expect_err("refused");
        let refused = editor.select_by(by).expect_err("refused");
        assert_eq!((asked.reason(), refused.reason()), (reason.to_owned(), reason.to_owned()));
        assert_eq!(editor.selection(), &before);
    }
    // What only a look at the mesh tells.
    select(&mut editor, Element::Vertex, &[0, 48]);
    let refused = editor.select_by(SelectBy::Loops).expect_err("refused").reason();
    assert!(refused.starts_with("No two of the selected vertices are neighbours"), "{refused}");
    assert_eq!(ids(&editor), [0, 48]);
    let refused =
        editor.select_line(Element::Edge, 4000, Line::Loop, SelectMode::Replace).expect_err("refused");
    assert_eq!(refused.to_string(), "select: `ids`: there is no half-edge 4000");
}

#[test]
fn selections_follow_from_the_selection() {
    let mut editor = on_grid();
    select(&mut editor, Element::Vertex, &[16, 17]);
    editor.select_by(SelectBy::Loops).expect("neighbours");
    assert_eq!(ids(&editor), (14..21).collect::<Vec<_>>());
    select(&mut editor, Element::Vertex, &[14, 20]);
    editor.select_by(SelectBy::Path).expect("two");
    assert_eq!(ids(&editor), (14..21).collect::<Vec<_>>());
    editor.select_by(SelectBy::Kind(Element::Edge)).expect("another kind");
    assert_eq!((editor.selection().kind(), ids(&editor).len()), (Element::Edge, 6));
    editor.select_by(SelectBy::Rings).expect("edges");
    assert_eq!(ids(&editor).len(), 6 * 7, "all edges that lie that way");
    editor.select_by(SelectBy::Linked).expect("some");
    assert_eq!(ids(&editor).len(), 84);
    editor.select_by(SelectBy::Kind(Element::Face)).expect("another kind");
    assert_eq!(ids(&editor).len(), 36);
    editor.select_by(SelectBy::Outline).expect("faces");
    assert_eq!(ids(&editor).len(), 24);
    assert_eq!(editor.undo_labels().count(), 1, "selecting is no step");
}

#[test]
fn a_path_goes_on_from_the_element_selected_last() {
    let mut editor = on_grid();
    editor.select_path_to(Element::Vertex, 0).expect("there");
    assert_eq!(ids(&editor), [0]);
    editor.select_path_to(Element::Vertex, 3).expect("connected");
    assert_eq!(editor.selection().latest(), Some(3));
    editor.select_path_to(Element::Vertex, 17).expect("connected");
    assert_eq!(ids(&editor), [0, 1, 2, 3, 10, 17]);
    // Another kind starts anew; another piece can't be reached.
    editor.select_path_to(Element::Face, 5).expect("there");
    assert_eq!(ids(&editor), [5]);
    run(&mut editor, json!({"op": "delete-faces", "faces": [6, 7, 8, 9, 10, 11]}));
    select(&mut editor, Element::Face, &[0]);
    let refused = editor.select_path_to(Element::Face, 20).expect_err("refused").reason();
    assert_eq!(refused, "No path leads from face 0 to face 20: they are in different pieces.");
    assert_eq!(ids(&editor), [0]);
}

#[test]
fn selecting_ends_an_ongoing_edit() {
    let mut editor = on_grid();
    select(&mut editor, Element::Vertex, &[16]);
    let moved = json!({"op": "transform", "vertices": [16], "translate": [0, 1, 0]});
    editor.update_edit(command(moved)).expect("a move");
    editor.select_by(SelectBy::Grow).expect("one");
    assert!(!editor.is_editing());
    assert_eq!(editor.undo_labels().last(), Some("Move"));
}
