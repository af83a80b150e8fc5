//! Selecting with a box, a lasso and a circle, and through surfaces.

use crate::page::Page;
use crate::viewport::click_at;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Rect, vec2};
use halfedge::Element;
use serde_json::json;

const LEFT: PointerButton = PointerButton::Primary;

/// A grid of six by six quads that lists vertices, seen from above.
fn grid() -> Page {
    let mut page = Page::new();
    page.command(json!({"op": "new", "shape": "grid", "columns": 6, "rows": 6}));
    page.press(Key::Num1);
    page
}

/// The vertex in a column and row.
fn vertex(column: u32, row: u32) -> u32 {
    row * 7 + column
}

fn place(page: &mut Page, v: u32) -> Pos2 {
    let mesh = page.mesh();
    let at = mesh.position(mesh.vertex(v).expect("there"));
    page.at(at.to_array())
}

/// Drags along a path with a button and modifiers held all the way.
pub fn drag_along(page: &mut Page, path: &[Pos2], button: PointerButton, modifiers: Modifiers) {
    let [first, .., last] = path else { panic!("a path") };
    page.harness.hover_at(*first);
    page.run();
    let event = |pos: Pos2, pressed| Event::PointerButton { pos, button, pressed, modifiers };
    page.harness.event_modifiers(event(*first, true), modifiers);
    page.run();
    for at in path {
        page.harness.event_modifiers(Event::PointerMoved(*at), modifiers);
        page.run();
    }
    page.harness.event_modifiers(event(*last, false), modifiers);
    page.run();
}

/// A loop around the square of vertices between two columns and rows, half a step outside.
fn around(page: &mut Page, [left, top]: [u32; 2], [right, bottom]: [u32; 2]) -> Vec<Pos2> {
    let corners = [(left, top), (right, top), (right, bottom), (left, bottom)];
    let places = corners.map(|(column, row)| place(page, vertex(column, row)));
    let middle = places.iter().fold(vec2(0.0, 0.0), |sum, p| sum + p.to_vec2()) / 4.0;
    let size = (right - left) as f32;
    let out = |p: Pos2| (middle + (p.to_vec2() - middle) * (1.0 + 0.8 / size)).to_pos2();
    let corners = places.map(out);
    let mut path = Vec::new();
    for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        path.extend((0..6).map(|step| *a + (*b - *a) * (step as f32 / 6.0)));
    }
    path
}

#[test]
fn a_lasso_selects_what_it_goes_around() {
    let mut page = grid();
    page.click("Select");
    page.click("Select tool");
    page.click("Lasso select");
    let path = around(&mut page, [1, 1], [3, 3]);
    drag_along(&mut page, &path, LEFT, Modifiers::NONE);
    let square: Vec<u32> = (1..=3).flat_map(|row| (1..=3).map(move |column| vertex(column, row))).collect();
    assert_eq!(page.selected(), (Element::Vertex, square.clone()));

    let path = around(&mut page, [3, 3], [5, 5]);
    drag_along(&mut page, &path, LEFT, Modifiers::SHIFT);
    assert_eq!(page.selected().1.len(), 9 + 9 - 1, "Shift adds");
    drag_along(&mut page, &path, LEFT, Modifiers::COMMAND);
    assert_eq!(page.selected().1.len(), 8, "Ctrl removes what was selected");
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(page.selected().1.len(), 17, "a lasso is one step");

    // Escape during the drag selects nothing, and the next one ends the tool.
    page.harness.hover_at(path[0]);
    page.harness.drag_at(path[0]);
    page.run();
    path.iter().for_each(|at| {
        page.harness.hover_at(*at);
        page.run();
    });
    page.press(Key::Escape);
    page.drop(path[0]);
    assert_eq!(page.selected().1.len(), 17);
    page.press(Key::Escape);
    page.press(Key::Escape);
    assert!(page.selected().1.is_empty());

    // Without the tool, Ctrl and the right button draw one.
    let path = around(&mut page, [1, 1], [3, 3]);
    drag_along(&mut page, &path, PointerButton::Secondary, Modifiers::COMMAND);
    assert_eq!(page.selected().1, square);
    let path = around(&mut page, [3, 3], [5, 5]);
    drag_along(&mut page, &path, PointerButton::Secondary, Modifiers::COMMAND.plus(Modifiers::SHIFT));
    assert_eq!(page.selected().1.len(), 17);
    drag_along(&mut page, &path, PointerButton::Secondary, Modifiers::COMMAND.plus(Modifiers::ALT));
    assert_eq!(page.selected().1.len(), 8);
    drag_along(&mut page, &path, PointerButton::Secondary, Modifiers::COMMAND);
    assert_eq!(page.selected().1.len(), 9, "without Shift it replaces the selection");
}

#[test]
fn a_circle_paints_the_selection() {
    let mut page = grid();
    let row =
        |page: &mut Page, row| (0..7).map(|column| place(page, vertex(column, row))).collect::<Vec<_>>();
    page.press_with(Modifiers::SHIFT, Key::C);
    // Less than the distance between two rows.
    let path = row(&mut page, 2);
    (0..4).for_each(|_| page.press(Key::OpenBracket));
    drag_along(&mut page, &path, LEFT, Modifiers::NONE);
    let all = |r: u32| (0..7).map(move |column| vertex(column, r));
    assert_eq!(page.selected(), (Element::Vertex, all(2).collect()));
    // Painting adds, and so does one slow frame.
    let path = row(&mut page, 4);
    page.harness.hover_at(path[0]);
    page.run();
    let button =
        |pos, pressed| Event::PointerButton { pos, button: LEFT, pressed, modifiers: Modifiers::NONE };
    let events = &mut page.harness.input_mut().events;
    events.push(button(path[0], true));
    events.extend(path.iter().map(|at| Event::PointerMoved(*at)));
    events.push(button(path[6], false));
    page.harness.step();
    page.run();
    assert_eq!(page.selected().1, all(2).chain(all(4)).collect::<Vec<_>>());
    // Ctrl and the middle button deselect.
    let down: Vec<Pos2> = (0..7).map(|r| place(&mut page, vertex(3, r))).collect();
    drag_along(&mut page, &down, LEFT, Modifiers::COMMAND);
    assert_eq!(page.selected().1.len(), 12);
    drag_along(&mut page, &path, PointerButton::Middle, Modifiers::NONE);
    assert_eq!(page.selected().1.len(), 6);
    // Each stroke is a step.
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(page.selected().1.len(), 12);
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(page.selected().1.len(), 14);

    // A press without a movement paints too; the wheel and brackets change the size, and don't zoom.
    page.press(Key::Escape);
    page.press(Key::Escape);
    page.press_with(Modifiers::SHIFT, Key::C);
    let middle = place(&mut page, vertex(3, 3));
    let distance = page.app().script().state()["view"]["distance"].clone();
    let mut sizes = Vec::new();
    for larger in [false, true] {
        if larger {
            page.harness.hover_at(middle);
            page.run();
            page.turn_wheel(egui::MouseWheelUnit::Point, 400.0);
        }
        click_at(&mut page, middle, Modifiers::NONE);
        sizes.push(page.selected().1.len());
    }
    page.press(Key::CloseBracket);
    page.press(Key::CloseBracket);
    page.press(Key::CloseBracket);
    click_at(&mut page, middle, Modifiers::NONE);
    sizes.push(page.selected().1.len());
    assert!(sizes[0] == 1 && sizes[1] > 1 && sizes[2] > sizes[1], "{sizes:?}");
    assert_eq!(page.app().script().state()["view"]["distance"], distance);
    assert!(page.has("Go to id"), "the brackets don't close the lists");

    // A right click ends it, without a menu.
    page.harness.event(Event::PointerButton {
        pos: middle,
        button: PointerButton::Secondary,
        pressed: true,
        modifiers: Modifiers::NONE,
    });
    page.harness.event(Event::PointerButton {
        pos: middle,
        button: PointerButton::Secondary,
        pressed: false,
        modifiers: Modifiers::NONE,
    });
    page.run();
    assert!(!page.has_part("Isolate"), "no menu");
    click_at(&mut page, middle, Modifiers::NONE);
    assert_eq!(page.selected().1, [vertex(3, 3)], "a click selects again");
    for pressed in [true, false] {
        let (button, modifiers) = (PointerButton::Secondary, Modifiers::NONE);
        page.harness.event(Event::PointerButton { pos: middle, button, pressed, modifiers });
    }
    page.run();
    assert!(page.has_part("Isolate"), "a right click opens the menu again");
}

#[test]
fn with_x_ray_everything_selects_through_the_surface() {
    let mut page = Page::new();
    let area: Rect = page.find("Viewport").rect();
    let (from, to) = (area.left_bottom() + vec2(10.0, -10.0), area.right_top() + vec2(-10.0, 10.0));
    page.select("vertex", &[0]);
    let hidden = hidden_vertex(&mut page);
    let at = place(&mut page, hidden);
    click_at(&mut page, at, Modifiers::NONE);
    assert_ne!(page.selected().1, [hidden]);
    page.press_with(Modifiers::ALT, Key::X);
    click_at(&mut page, at, Modifiers::NONE);
    assert_eq!(page.selected().1, [hidden], "a click reaches through");
    let lasso = [from, from + vec2(area.width() - 20.0, 0.0), to, to - vec2(area.width() - 20.0, 0.0), from];
    for (tool, count) in [(Key::B, 8), (Key::C, 8)] {
        page.press(Key::Escape);
        page.press_with(Modifiers::SHIFT, tool);
        if tool == Key::C {
            (0..20).for_each(|_| page.press(Key::CloseBracket));
            drag_along(&mut page, &[area.center(), area.center()], LEFT, Modifiers::NONE);
        } else {
            drag_along(&mut page, &[from, to], LEFT, Modifiers::NONE);
        }
        assert_eq!(page.selected().1.len(), count, "{tool:?}");
        page.press(Key::Escape);
    }
    drag_along(&mut page, &lasso, PointerButton::Secondary, Modifiers::COMMAND);
    assert_eq!(page.selected().1.len(), 8);
    page.press_with(Modifiers::ALT, Key::X);
    drag_along(&mut page, &lasso, PointerButton::Secondary, Modifiers::COMMAND);
    assert_eq!(page.selected().1.len(), 7, "without it, never what is hidden");
}

/// The vertex of the cube that is behind all faces.
fn hidden_vertex(page: &mut Page) -> u32 {
    let view = page.app().script().state()["view"].clone();
    let number = |name: &str| view[name].as_f64().expect("a number") as f32;
    let (yaw, pitch) = (number("yaw"), number("pitch"));
    let back = glam::vec3(yaw.sin() * pitch.cos(), pitch.sin(), yaw.cos() * pitch.cos());
    let mesh = page.mesh();
    let nearness = |v: &halfedge::VertexId| mesh.position(*v).dot(back);
    mesh.vertices().min_by(|a, b| nearness(a).total_cmp(&nearness(b))).expect("a vertex").raw()
}

#[test]
fn a_finger_need_not_be_exact() {
    let mut page = grid();
    let at = place(&mut page, vertex(0, 0));
    let beside = place(&mut page, vertex(1, 1));
    // Beyond a mouse's tolerance, beside the mesh.
    let near = at + (at - beside).normalized() * 14.0;
    click_at(&mut page, near, Modifiers::NONE);
    assert!(page.selected().1.is_empty());
    let touch = |phase| Event::Touch {
        device_id: egui::TouchDeviceId(0),
        id: egui::TouchId(1),
        phase,
        pos: near,
        force: None,
    };
    let button =
        |pressed| Event::PointerButton { pos: near, button: LEFT, pressed, modifiers: Modifiers::NONE };
    for (phase, pressed) in [(egui::TouchPhase::Start, true), (egui::TouchPhase::End, false)] {
        page.harness.event(button(pressed));
        page.harness.event(touch(phase));
        page.harness.step();
    }
    page.run();
    assert_eq!(page.selected().1, [vertex(0, 0)]);
}

#[test]
fn only_two_clicks_with_the_same_keys_are_a_double_click() {
    let mut page = grid();
    // A frame of a test is a quarter of a second, and two clicks take several.
    page.harness.ctx.options_mut(|options| options.input_options.max_double_click_delay = 3.0);
    let at = place(&mut page, vertex(3, 3));
    click_at(&mut page, at, Modifiers::NONE);
    click_at(&mut page, at, Modifiers::SHIFT);
    assert_eq!(page.selected().1, [vertex(3, 3)], "Shift is held for the second click only");
    page.press(Key::Escape);
    page.wait();
    click_at(&mut page, at, Modifiers::NONE);
    click_at(&mut page, at, Modifiers::NONE);
    assert_eq!(page.selected().1.len(), 7, "the loop through the vertex");
}
