//! The lists: selecting, going to an id, the filter, and three million rows.

use crate::page::Page;
use egui::accesskit::Role;
use egui::{Key, Modifiers, Vec2};
use egui_kittest::{Harness, kittest::Queryable};
use halfedge::Element;
use meshwright_web::lists::columns::{Align, Column, Row};
use meshwright_web::lists::row_list::{RowContent, RowList, RowListState};
use serde_json::json;

#[test]
fn a_click_on_a_row_selects_and_its_numbers_are_there() {
    let mut page = Page::new();
    page.row("Vertex 3").click();
    page.run();
    assert_eq!(page.selected(), (Element::Vertex, vec![3]));
    let [x, y, z] = page.mesh().position(halfedge::VertexId::new(3)).to_array();
    let value = page.row("Vertex 3").value().expect("the row's numbers");
    assert_eq!(value, format!("x {x:.5}, y {y:.5}, z {z:.5}"));
}

#[test]
fn shift_extends_and_control_toggles() {
    let mut page = Page::new();
    page.click("Faces");
    page.row("Face 1").click();
    page.run();
    page.row("Face 4").click_modifiers(Modifiers::SHIFT);
    page.run();
    assert_eq!(page.selected(), (Element::Face, vec![1, 2, 3, 4]));
    page.row("Face 2").click_modifiers(Modifiers::COMMAND);
    page.run();
    assert_eq!(page.selected(), (Element::Face, vec![1, 3, 4]));
    page.row("Face 5").click();
    page.run();
    assert_eq!(page.selected(), (Element::Face, vec![5]));
}

#[test]
fn arrows_page_and_end_move_the_selection() {
    let mut page = Page::new();
    page.command(json!({ "op": "new", "shape": "grid", "columns": 40, "rows": 40 }));
    page.row("Vertex 2").click();
    page.run();
    page.press(Key::ArrowDown);
    assert_eq!(page.selected().1, [3]);
    page.press(Key::ArrowUp);
    page.press(Key::ArrowUp);
    assert_eq!(page.selected().1, [1]);
    page.press_with(Modifiers::SHIFT, Key::ArrowDown);
    assert_eq!(page.selected().1, [1, 2]);
    page.press(Key::End);
    let last = page.mesh().vertex_count() as u32 - 1;
    assert_eq!(page.selected().1, [last]);
    assert!(page.has_row(&format!("Vertex {last}")), "the list goes where the keyboard does");
    page.press(Key::PageUp);
    let up = page.selected().1[0];
    assert!(up < last - 10 && page.has_row(&format!("Vertex {up}")), "a page up from {last} is {up}");
    page.press(Key::Home);
    assert_eq!(page.selected().1, [0]);
}

#[test]
fn a_selection_made_elsewhere_scrolls_into_view() {
    let mut page = Page::new();
    page.command(json!({ "op": "new", "shape": "grid", "columns": 60, "rows": 60 }));
    assert!(!page.has_row("Half-edge 7000"));
    page.select("halfedge", &[7000]);
    assert!(page.has_row("Half-edge 7000"), "the list shows the kind that was selected, and scrolls to it");
    let mesh = page.mesh();
    let h = mesh.halfedge(7000).expect("there are that many");
    let face = mesh.face_of(h).map_or("–".to_owned(), |f| f.raw().to_string());
    let numbers = format!("next {}, twin 7001, face {face}, vertex {}", mesh.next(h).raw(), mesh.to(h).raw());
    assert_eq!(page.row("Half-edge 7000").value(), Some(numbers));
}

#[test]
fn go_to_id_selects_or_names_the_valid_ids() {
    let mut page = Page::new();
    page.command(json!({ "op": "new", "shape": "grid", "columns": 60, "rows": 60 }));
    page.press_with(Modifiers::COMMAND, Key::G);
    page.find("Go to id").type_text("3000");
    page.press(Key::Enter);
    assert_eq!(page.selected(), (Element::Vertex, vec![3000]));
    assert!(page.has_row("Vertex 3000"));

    page.press_with(Modifiers::COMMAND, Key::G);
    page.find("Go to id").type_text("99999");
    page.press(Key::Enter);
    assert_eq!(page.selected().1, [3000], "nothing else is selected");
    assert!(page.has_part("There is no vertex “99999”: ids go from 0 to 3\u{a0}720."));
}

#[test]
fn the_filter_shows_the_selection_alone() {
    let mut page = Page::new();
    page.select("edge", &[2, 5, 9]);
    page.click("Only selected");
    let shown: Vec<bool> = (0..12).map(|e| page.has_row(&format!("Edge {e}"))).collect();
    let wanted: Vec<bool> = (0..12).map(|e| [2, 5, 9].contains(&e)).collect();
    assert_eq!(shown, wanted);
    page.press_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::A);
    assert!(page.has("No edge is selected"), "an empty list says why");
    page.click("Only selected");
    assert!(page.has_row("Edge 0"));
}

#[test]
fn rows_follow_edits_and_undo() {
    let mut page = Page::new();
    page.click("Faces");
    assert!(!page.has_row("Face 6"));
    page.command(json!({ "op": "triangulate-faces" }));
    assert!(page.has_row("Face 11"));
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert!(page.has_row("Face 5") && !page.has_row("Face 6"));
}

/// A list of many rows alone, each called by its number.
fn long_list(rows: usize) -> Harness<'static, RowListState> {
    const COLUMNS: [Column; 1] =
        [Column { title: "Id", meaning: "Number", chars: 10.0, align: Align::Right }];
    let show = move |ui: &mut egui::Ui, state: &mut RowListState| {
        meshwright_web::fonts::install(ui.ctx());
        let list = RowList { label: "Rows", columns: &COLUMNS, rows, row_height: 20.0 };
        list.show(ui, state, |at| {
            Some(RowContent {
                row: Row { id: at as u32, cells: vec![at.to_string()], swatch: None },
                name: format!("Row {at}"),
                value: String::new(),
                selected: false,
                hovered: false,
            })
        });
    };
    Harness::builder()
        .with_size(Vec2::new(300.0, 420.0))
        .with_max_steps(24)
        .build_ui_state(show, RowListState::default())
}

fn tops(harness: &Harness<'_, RowListState>, from: usize, to: usize) -> Vec<f32> {
    (from..=to).map(|row| harness.get_by_label(&format!("Row {row}")).rect().min.y).collect()
}

#[test]
fn three_million_rows_scroll_exactly() {
    const ROWS: usize = 3_000_001;
    let mut harness = long_list(ROWS);
    harness.run();
    harness.state_mut().reveal(ROWS - 1);
    harness.run();
    let last = harness.get_by_label(&format!("Row {}", ROWS - 1)).rect();
    let list = harness.get_by_role_and_label(egui::accesskit::Role::ListBox, "Rows").rect();
    assert!(
        (last.max.y - list.max.y).abs() < 0.01,
        "the last row {last:?} ends where the list {list:?} does"
    );
    for pair in tops(&harness, ROWS - 12, ROWS - 1).windows(2) {
        assert!((pair[1] - pair[0] - 20.0).abs() < 0.01, "rows are 20 points apart: {pair:?}");
    }

    // The wheel moves by what it says, three million rows down: 50 points are two and a half rows.
    harness.hover_at(list.center());
    harness.run();
    let before = tops(&harness, ROWS - 10, ROWS - 10)[0];
    harness.event(crate::page::wheel(egui::MouseWheelUnit::Point, 50.0));
    harness.run();
    let after = tops(&harness, ROWS - 10, ROWS - 10)[0];
    assert!((after - before - 50.0).abs() < 0.5, "scrolled by {}", after - before);
}

#[test]
fn the_scroll_bar_reaches_both_ends() {
    const ROWS: usize = 3_000_000;
    let mut harness = long_list(ROWS);
    harness.run();
    let bar = harness.get_by_label("Scroll rows").rect();
    harness.drag_at(bar.center_top() + Vec2::new(0.0, 5.0));
    harness.run();
    harness.hover_at(bar.center_bottom() + Vec2::new(0.0, 40.0));
    harness.run();
    harness.drop_at(bar.center_bottom());
    harness.run();
    assert!(harness.query_by_label(&format!("Row {}", ROWS - 1)).is_some());
    harness.drag_at(bar.center_bottom() - Vec2::new(0.0, 5.0));
    harness.run();
    harness.hover_at(bar.center_top() - Vec2::new(0.0, 40.0));
    harness.run();
    assert!(harness.query_by_label("Row 0").is_some());
}

#[test]
fn hidden_elements_have_no_rows_until_they_are_revealed() {
    let mut page = Page::new();
    page.command(json!({ "op": "new", "shape": "grid", "columns": 3, "rows": 2 }));
    page.press(Key::Num4);
    assert!(page.has_row("Face 0") && !page.has_part("hidden"));
    page.command(json!({ "op": "hide", "faces": [0, 1, 3] }));
    assert!(page.has("3 of 6 faces, 3 hidden"));
    let shown: Vec<bool> = (0..6).map(|f| page.has_row(&format!("Face {f}"))).collect();
    assert_eq!(shown, [false, false, true, false, true, true]);
    // Keys, ranges and typed ids go by what is shown.
    page.row("Face 2").click();
    page.run();
    page.press(Key::ArrowDown);
    assert_eq!(page.selected().1, [4]);
    page.row("Face 2").click_modifiers(Modifiers::SHIFT);
    page.run();
    assert_eq!(page.selected().1, [2, 4]);
    page.press_with(Modifiers::COMMAND, Key::G);
    page.find("Go to id").type_text("3");
    page.press(Key::Enter);
    assert!(page.has("Face 3 is hidden: reveal it first."));
    assert_eq!(page.selected().1, [2, 4]);

    // Vertices and edges are hidden with the last of their faces.
    page.press(Key::Num1);
    assert!(page.has_part(" of 12 vertices, "));
    let (hidden, mesh) = (page.hidden_faces(), page.mesh().clone());
    for v in mesh.vertices() {
        let shows = mesh.vertex_faces(v).any(|f| !hidden.contains(&f.raw()));
        assert_eq!(page.has_row(&format!("Vertex {}", v.raw())), shows, "{v}");
    }

    page.press(Key::Num4);
    page.press_with(Modifiers::COMMAND, Key::A);
    page.press(Key::H);
    assert!(page.has("All faces are hidden") && page.has("0 of 6 faces, 6 hidden"));
    page.harness.get_all_by_role_and_label(Role::Button, "Reveal").last().expect("a button").click();
    page.run();
    assert!(page.has_row("Face 0") && !page.has_part("faces, 6 hidden"));
}

#[test]
fn hidden_elements_of_a_large_mesh_leave_the_list_within_some_frames() {
    let mut page = Page::new();
    page.command(json!({ "op": "new", "shape": "grid", "columns": 500, "rows": 500 }));
    page.press(Key::Num4);
    page.command(json!({ "op": "hide", "faces": (0..249_990).collect::<Vec<u32>>() }));
    assert!(page.has("10 of 250\u{a0}000 faces, 249\u{a0}990 hidden"));
    assert!(page.has_row("Face 249990") && page.has_row("Face 249999") && !page.has_row("Face 0"));
    // Edits keep up with it without finding all rows anew.
    page.command(json!({ "op": "poke-faces", "faces": [249_995] }));
    assert!(page.has("13 of 250\u{a0}003 faces, 249\u{a0}990 hidden"));
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert!(page.has("10 of 250\u{a0}000 faces, 249\u{a0}990 hidden"));
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert!(page.has_row("Face 0") && !page.has_part("hidden"));
}
