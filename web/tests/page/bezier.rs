//! The Bezier players: control points, the construction, and the operations on curves and surfaces.

use crate::page::Page;
use editor::Bezier;
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, Pos2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use glam::Vec3;
use serde_json::{Value, json};

const CURVE: &str = "4\n0 0 1 2 3 2 4 0\n";

/// A page on a flat curve of four control points.
fn on_curve() -> Page {
    let mut page = Page::new();
    page.open("arc.bzc", CURVE);
    page
}

/// Two patches side by side, arched along x.
fn on_surface() -> Page {
    let mut text = "2\n".to_owned();
    for patch in 0..2 {
        for row in 0..4 {
            for column in 0..4 {
                let height = if column == 1 || column == 2 { 1 } else { 0 };
                text += &format!("{} {row} {height} ", patch * 3 + column);
            }
        }
    }
    let mut page = Page::new();
    page.open("arches.bez", &text);
    page
}

fn points(page: &mut Page) -> Vec<Vec3> {
    match page.app().editor().document().active().and_then(|object| object.bezier()) {
        Some(Bezier::Curve(curve)) => curve.points.clone(),
        Some(Bezier::Surface(patches)) => {
            patches.iter().flat_map(|p| p.rows.as_flattened().to_vec()).collect()
        }
        None => panic!("the active object is a mesh"),
    }
}

fn player(page: &mut Page, field: &str) -> Value {
    page.app().script().state()["view"]["bezier"][field].clone()
}

fn click_at(page: &mut Page, at: Pos2, times: usize) {
    page.harness.hover_at(at);
    page.run();
    // A frame of a test is a quarter of a second, and a double click takes three.
    page.harness.ctx.options_mut(|options| options.input_options.max_double_click_delay = 0.8);
    for _ in 0..times {
        for pressed in [true, false] {
            let button = egui::PointerButton::Primary;
            page.harness.event(Event::PointerButton { pos: at, button, pressed, modifiers: Modifiers::NONE });
            page.harness.step();
        }
    }
    page.run();
}

#[test]
fn a_curve_opens_seen_from_above_with_its_player() {
    let mut page = on_curve();
    assert!(page.has("Bezier curve") && page.has_part("4 control points, degree 3"));
    let [first, last] = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0]].map(|p| page.at(p));
    assert!((first.y - last.y).abs() < 0.5 && last.x > first.x + 100.0, "seen as drawn: {first} to {last}");
    assert!(page.has("A curve has no vertices"), "the lists say where its points are");
    assert!(page.undo_labels().len() == 1);
}

#[test]
fn e_draws_level_by_level_and_c_the_whole_curve() {
    let mut page = on_curve();
    for level in [1, 2, 3, 0, 1] {
        page.press(Key::E);
        assert_eq!(player(&mut page, "level"), level);
    }
    assert_eq!(player(&mut page, "whole"), true);
    page.press(Key::C);
    assert_eq!(player(&mut page, "whole"), false);
    page.click("Whole curve");
    assert_eq!(player(&mut page, "whole"), true);
    assert_eq!(page.undo_labels().len(), 1, "looking is no edit");

    // On a mesh, the same keys extrude and collapse.
    page.command(json!({ "op": "new", "shape": "cube" }));
    page.select("edge", &[0]);
    page.press(Key::C);
    assert_eq!(page.mesh().vertex_count(), 7);
}

#[test]
fn a_curve_of_twenty_thousand_points_is_sampled_and_says_so() {
    let text: String = (0..20_000).map(|i| format!("\n{i} {}", i % 7)).collect();
    let mut page = Page::new();
    page.open("large.bzc", &format!("20000{text}"));
    assert!(page.has_part("20\u{a0}000 control points, degree 19\u{a0}999"));
    assert!(page.has_part("one control point in 10"));
    assert!(!page.has_part("one point in"));
    page.press(Key::E);
    assert!(page.has_part("one point in 20 of level 1"));
    page.press(Key::C);
    page.find("Play").click();
    for _ in 0..5 {
        page.harness.step();
    }
    page.find("Pause").click();
    page.run();
    assert!(player(&mut page, "t").as_f64() != Some(0.5), "it moved");
    page.command(json!({ "op": "bezier-move-point", "point": 5, "position": [0, 9, 0] }));
    assert_eq!(points(&mut page)[5], Vec3::new(0.0, 9.0, 0.0));
}

#[test]
fn a_control_point_is_dragged_in_one_step_and_stays_in_the_plane() {
    let mut page = on_curve();
    let at = page.at([1.0, 2.0, 0.0]);
    let to = at + vec2(60.0, 35.0);
    page.drag(at, to);
    let moved = points(&mut page)[1];
    assert!(moved != Vec3::new(1.0, 2.0, 0.0), "it follows the pointer");
    page.drop(to);
    let moved = points(&mut page)[1];
    assert_eq!(moved.z, 0.0);
    assert!(page.at(moved.to_array()).distance(to) < 1.0, "it is under the pointer");
    assert_eq!(page.undo_labels().len(), 2, "{:?}", page.undo_labels());
    assert_eq!(player(&mut page, "chosen"), json!({ "point": 1 }));
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(points(&mut page)[1], Vec3::new(1.0, 2.0, 0.0));

    // Escape leaves no trace.
    page.drag(at, to);
    page.press(Key::Escape);
    assert_eq!(points(&mut page)[1], Vec3::new(1.0, 2.0, 0.0));
    page.drop(to);
    assert_eq!(page.undo_labels().len(), 1);
}

#[test]
fn points_are_added_and_deleted_in_the_viewport() {
    let mut page = on_curve();
    // On the line between two others.
    let at = page.at([2.0, 2.0, 0.0]);
    click_at(&mut page, at, 2);
    let now = points(&mut page);
    assert_eq!(now.len(), 5);
    assert!(now[2].distance(Vec3::new(2.0, 2.0, 0.0)) < 0.05, "{now:?}");
    assert_eq!(player(&mut page, "chosen"), json!({ "point": 2 }));
    page.press(Key::Delete);
    assert_eq!(points(&mut page).len(), 4);
    assert_eq!(player(&mut page, "chosen"), Value::Null);

    // Anywhere else it comes last.
    let at = page.at([3.0, -1.0, 0.0]);
    click_at(&mut page, at, 2);
    let now = points(&mut page);
    assert_eq!(now.len(), 5);
    assert!(now[4].distance(Vec3::new(3.0, -1.0, 0.0)) < 0.05, "{now:?}");
    assert_eq!(page.undo_labels().len(), 4);
}

#[test]
fn the_panel_does_what_the_viewport_does() {
    let mut page = on_curve();
    page.type_into("Point 1 y", "3.5");
    assert_eq!(points(&mut page)[1], Vec3::new(1.0, 3.5, 0.0));
    assert_eq!(page.undo_labels().len(), 2);
    page.click("Control point 3");
    page.click("Add point");
    assert_eq!(points(&mut page)[4], Vec3::new(5.0, -2.0, 0.0), "as far on as from the one before");
    page.click("Control point 0");
    page.click("Delete point");
    assert_eq!(points(&mut page)[0], Vec3::new(1.0, 3.5, 0.0));
}

#[test]
fn elevating_keeps_the_shape_and_splitting_makes_two() {
    let mut page = on_curve();
    let before = points(&mut page);
    page.click("Elevate degree");
    assert_eq!(points(&mut page).len(), 5);
    assert_eq!(points(&mut page)[4], before[3]);
    page.press_with(Modifiers::COMMAND, Key::Z);

    page.click("Split at t");
    let objects = page.app().editor().document().objects().len();
    assert_eq!(objects, 2);
    assert_eq!(points(&mut page)[3], Vec3::new(2.0, 1.5, 0.0), "the middle of the curve");
    assert!(page.has("arc 2"), "the rest is in the list of objects");
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(points(&mut page), before);
}

#[test]
fn playing_moves_t_until_it_is_paused() {
    let mut page = on_curve();
    page.find("Play").click();
    for _ in 0..10 {
        page.harness.step();
    }
    assert_eq!(player(&mut page, "playing"), true);
    assert_eq!(player(&mut page, "level"), 3, "the construction is drawn so that one sees it move");
    let t = player(&mut page, "t").as_f64().expect("a number");
    assert!(t > 0.5, "{t}");
    page.find("Pause").click();
    page.run();
    assert_eq!(player(&mut page, "playing"), false);

    // Its key does the same, and opens no palette.
    for playing in [true, false] {
        page.harness.key_press(Key::K);
        page.harness.step();
        assert_eq!(player(&mut page, "playing"), playing);
    }
    page.press(Key::Questionmark);
    assert!(page.has("Play: K"), "the list of keys has it");
}

#[test]
fn a_surface_of_many_patches_says_that_one_net_is_drawn() {
    let patches = |count: usize| {
        let patch = |at: usize| {
            let point = |i: usize| format!("{} {} 0 ", at * 3 + i % 4, i / 4);
            (0..16).map(point).collect::<String>()
        };
        let mut page = Page::new();
        let text = format!("{count}\n{}\n", (0..count).map(patch).collect::<String>());
        page.open("strip.bez", &text);
        page
    };
    let says = "only that of patch";
    assert!(!patches(64).has_part(says), "all are drawn");
    let mut page = patches(65);
    assert!(page.has_part("only that of patch 0 is drawn"));
    page.type_into("Patch", "7");
    assert!(page.has_part("only that of patch 7 is drawn"));
    page.click("Control nets");
    assert!(!page.has_part(says), "none is");
}

#[test]
fn a_surface_has_nets_to_drag_and_is_tessellated() {
    let mut page = on_surface();
    assert!(page.has("Bezier surface") && page.has_part("2 patches"));
    assert_eq!(page.mesh().face_count(), 128, "a mesh shows it");
    let from = points(&mut page)[5];
    let at = page.at(from.to_array());
    page.drag(at, at + vec2(0.0, -40.0));
    page.drop(at + vec2(0.0, -40.0));
    assert_ne!(points(&mut page)[5], from);
    assert_eq!(player(&mut page, "chosen"), json!({ "patch": 0, "row": 1, "column": 1 }));
    assert_eq!(page.undo_labels().len(), 2);
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(points(&mut page)[5], from);

    // The construction goes along the rows and then down the column.
    for level in [1, 2, 3, 4, 5, 6, 0] {
        page.press(Key::E);
        assert_eq!(player(&mut page, "level"), level);
    }

    // A point of the shared border moves both patches.
    page.click("Control point 0, 3");
    page.type_into("Point z", "2");
    let now = points(&mut page);
    assert_eq!((now[3], now[16]), (Vec3::new(3.0, 0.0, 2.0), Vec3::new(3.0, 0.0, 2.0)));

    page.type_into("Quads per side", "5");
    page.click("Tessellate");
    assert_eq!(page.mesh().face_count(), 50);
    assert!(page.mesh().validate().is_ok());
    assert!(!page.has("Bezier surface"), "it is a mesh now");
}

#[test]
fn mesh_operations_say_why_they_do_not_apply() {
    let mut page = on_surface();
    page.open_not_now();
    assert!(page.has_part("arches is a Bezier surface. Tessellate it first."));
    page.press(Key::U);
    assert_eq!(page.undo_labels().len(), 1);

    let mut page = Page::new();
    page.open_not_now();
    let apply = page.harness.get_by_role_and_label(Role::Button, "Tessellate Bezier surface");
    assert!(apply.accesskit_node().is_disabled());
}

#[test]
fn control_points_are_saved_as_control_points() {
    let mut page = on_curve();
    page.press_with(Modifiers::COMMAND, Key::S);
    assert_eq!(page.find("Format").value().as_deref(), Some("BZC"));
    page.press(Key::Enter);
    let file = page.outside.downloads().pop().expect("a file");
    assert_eq!(file.name, "arc.bzc");
    assert_eq!(String::from_utf8_lossy(&file.bytes).split_whitespace().next(), Some("4"));
    let mut page = on_surface();
    page.press_with(Modifiers::COMMAND, Key::S);
    assert_eq!(page.find("Format").value().as_deref(), Some("BEZ"));
}

#[test]
fn a_curve_and_a_patch_are_made_from_nothing_and_edited() {
    for (entry, name, count) in
        [("New Bezier curve", "Bezier curve", 4), ("New Bezier patch", "Bezier surface", 16)]
    {
        let mut page = Page::new();
        page.click("Bezier");
        page.click(entry);
        page.run();
        assert!(page.has(name), "{name}");
        let before = points(&mut page);
        assert_eq!(before.len(), count);
        // Its control points are in view, and a drag moves one.
        let viewport = page.find("Viewport").rect();
        let from = page.at(before[1].to_array());
        assert!(viewport.contains(from));
        page.drag(from, from + egui::vec2(30.0, -40.0));
        page.drop(from + egui::vec2(30.0, -40.0));
        let after = points(&mut page);
        assert_ne!(after[1], before[1], "{name}");
        assert_eq!(after.iter().zip(&before).filter(|(a, b)| a != b).count(), 1);
        crate::looks::picture(&mut page, entry);
        page.press_with(egui::Modifiers::COMMAND, egui::Key::Z);
        assert_eq!(points(&mut page), before);
        page.press_with(egui::Modifiers::COMMAND, egui::Key::Z);
        assert_eq!(page.mesh().face_count(), 6, "the cube is back");
    }
    // In the form of a new shape too, with the degree of a curve.
    let mut page = Page::new();
    page.command(json!({ "op": "new", "shape": "bezier-curve", "degree": 5, "add": true }));
    assert_eq!(points(&mut page).len(), 6);
    assert_eq!(page.app().editor().document().objects().len(), 2);
}
