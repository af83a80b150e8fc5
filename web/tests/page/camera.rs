//! Moving the camera: the styles of its gestures, what it turns about, and how.

use crate::page::{DESKTOP, Page};
use crate::viewport::nearest_vertex;
use egui::{Event, Key, Modifiers, MouseWheelUnit, PointerButton, Pos2, Vec2, vec2};
use egui_kittest::kittest::Queryable;
use serde_json::Value;

const ALT_SHIFT: Modifiers = Modifiers { alt: true, ..Modifiers::SHIFT };

/// A drag with a button, and what it changes of the view.
type Gesture = (PointerButton, Modifiers, Moved);

/// What a movement changes of the view.
#[derive(Debug, PartialEq)]
enum Moved {
    Turned,
    Panned,
    Zoomed,
    Nothing,
}

fn view(page: &mut Page) -> Value {
    page.app().script().state()["view"].clone()
}

/// What changed between two states of the view.
fn moved(before: &Value, after: &Value) -> Moved {
    if before["yaw"] != after["yaw"] || before["pitch"] != after["pitch"] {
        Moved::Turned
    } else if before["distance"] != after["distance"] {
        Moved::Zoomed
    } else if before["target"] != after["target"] {
        Moved::Panned
    } else {
        Moved::Nothing
    }
}

/// A place in the viewport beside the mesh.
fn beside(page: &Page) -> Pos2 {
    page.find("Viewport").rect().left_bottom() + vec2(120.0, -60.0)
}

/// Drags with a button from one place; returns what it changed of the view.
fn drag(page: &mut Page, button: PointerButton, modifiers: Modifiers, from: Pos2, by: Vec2) -> Moved {
    let before = view(page);
    page.hover(from);
    page.harness.event(Event::ModifiersChanged(modifiers));
    let press = |pos, pressed| Event::PointerButton { pos, button, pressed, modifiers };
    page.harness.event_modifiers(press(from, true), modifiers);
    // Still held in the frames until the pointer moves: a long press is a drag too.
    page.harness.event(Event::ModifiersChanged(modifiers));
    page.run();
    for part in 1..=4 {
        page.harness.event_modifiers(Event::PointerMoved(from + by * (part as f32 / 4.0)), modifiers);
        page.run();
    }
    page.harness.event_modifiers(press(from + by, false), modifiers);
    page.run();
    page.harness.event(Event::ModifiersChanged(Modifiers::NONE));
    page.run();
    let after = view(page);
    moved(&before, &after)
}

/// Two fingers move over a trackpad; returns what it changed of the view.
fn scroll(page: &mut Page, modifiers: Modifiers, delta: Vec2) -> Moved {
    // The stroke before is over.
    page.wait();
    let before = view(page);
    page.harness.event_modifiers(
        Event::MouseWheel {
            unit: MouseWheelUnit::Point,
            delta,
            phase: egui::TouchPhase::Move,
            source: egui::MouseWheelSource::Unknown,
            modifiers,
        },
        modifiers,
    );
    page.run();
    page.harness.event(Event::ModifiersChanged(Modifiers::NONE));
    page.run();
    let after = view(page);
    moved(&before, &after)
}

fn styled(style: &str) -> Page {
    Page::with_setting(DESKTOP, "camera", style)
}

#[test]
fn each_style_has_its_gestures() {
    use Moved::{Nothing, Panned, Turned, Zoomed};
    use PointerButton::{Middle, Primary, Secondary};
    let (none, shift, ctrl, alt) = (Modifiers::NONE, Modifiers::SHIFT, Modifiers::COMMAND, Modifiers::ALT);
    let expected: [(&str, &[Gesture]); 5] = [
        ("course", &[(Primary, none, Turned), (Secondary, none, Panned), (Middle, none, Turned)]),
        (
            "blender",
            &[
                (Primary, none, Nothing),
                (Middle, none, Turned),
                (Middle, shift, Panned),
                (Middle, ctrl, Zoomed),
                (Primary, alt, Turned),
            ],
        ),
        (
            "maya",
            &[
                (Primary, none, Nothing),
                (Primary, alt, Turned),
                (Middle, alt, Panned),
                (Secondary, alt, Zoomed),
            ],
        ),
        ("cad", &[(Primary, none, Nothing), (Secondary, none, Turned), (Middle, none, Panned)]),
        ("trackpad", &[(Primary, none, Nothing), (Primary, alt, Turned), (Primary, ALT_SHIFT, Panned)]),
    ];
    for (style, gestures) in expected {
        let mut page = styled(style);
        assert_eq!(view(&mut page)["camera"], style);
        for (button, modifiers, wanted) in gestures {
            let from = beside(&page);
            let moved = drag(&mut page, *button, *modifiers, from, vec2(30.0, 20.0));
            assert_eq!(moved, *wanted, "{style}: {button:?} with {modifiers:?}");
        }
        assert!(page.selected().1.is_empty(), "{style}: boxes beside the mesh select nothing");
    }
}

#[test]
fn a_drag_with_a_free_button_selects_in_a_box() {
    let mut page = styled("cad");
    let area = page.find("Viewport").rect();
    let (from, to) = (area.left_bottom() + vec2(10.0, -10.0), area.right_top() + vec2(-10.0, 10.0));
    drag(&mut page, PointerButton::Primary, Modifiers::NONE, from, to - from);
    assert_eq!(page.selected().1.len(), 7, "the visible vertices of the cube");
}

#[test]
fn two_fingers_move_the_camera_and_a_wheel_zooms() {
    let mut page = styled("trackpad");
    let at = beside(&page);
    page.hover(at);
    for (modifiers, delta, wanted) in [
        (Modifiers::NONE, vec2(0.0, 7.25), Moved::Turned),
        (Modifiers::SHIFT, vec2(4.5, 7.25), Moved::Panned),
        (Modifiers::COMMAND, vec2(0.0, 7.25), Moved::Zoomed),
        (Modifiers::NONE, vec2(0.0, 120.0), Moved::Zoomed),
    ] {
        assert_eq!(scroll(&mut page, modifiers, delta), wanted, "{modifiers:?} {delta:?}");
    }
    let before = view(&mut page);
    page.harness.event(Event::Zoom(1.2));
    page.run();
    assert_eq!(moved(&before, &view(&mut page)), Moved::Zoomed, "a pinch");
    assert!(page.has_part("Two fingers: Orbit"), "the status line says so");
    let mut page = styled("blender");
    let at = beside(&page);
    page.hover(at);
    assert_eq!(scroll(&mut page, Modifiers::NONE, vec2(0.0, 7.25)), Moved::Zoomed);
}

#[test]
fn the_cad_style_turns_about_the_point_under_the_pointer() {
    let mut page = styled("cad");
    page.click("View");
    page.click("Camera style");
    page.click("CAD camera");
    let (_, corner) = nearest_vertex(&mut page);
    // The surface beside the vertex that is nearest to the eye.
    let from = corner + vec2(0.0, 2.0);
    drag(&mut page, PointerButton::Secondary, Modifiers::NONE, from, vec2(60.0, 40.0));
    let (_, after) = nearest_vertex(&mut page);
    assert!(after.distance(corner) < 4.0, "{corner:?} is at {after:?}");
    let middle = page.find("Viewport").rect().center();
    assert!(page.at([0.0; 3]).distance(middle) > 10.0, "the rest turns about it");
    assert_eq!(page.outside.setting("orbit-about").as_deref(), Some("pointer"));
}

#[test]
fn a_chosen_style_is_kept_and_otherwise_the_keys_decide() {
    let mut page = Page::new();
    for keys in ["Blender", "Maya", "Course"] {
        page.click("Edit");
        page.click("Keys");
        page.harness.get_by_label_contains(&format!("{keys} keys")).click();
        page.run();
        assert_eq!(view(&mut page)["camera"], keys.to_lowercase());
    }
    page.click("View");
    page.click("Camera style");
    page.click("Maya camera");
    assert_eq!(view(&mut page)["camera"], "maya");
    assert_eq!(page.outside.setting("camera").as_deref(), Some("maya"));
    let mut page = Page::with_setting(DESKTOP, "camera", "maya");
    assert_eq!(
        (view(&mut page)["camera"].clone(), view(&mut page)["keys"].clone()),
        ("maya".into(), "course".into())
    );
    page.click("View");
    page.click("Camera style");
    page.click("Camera of the keys");
    assert_eq!(view(&mut page)["camera"], "course");
    assert_eq!(page.outside.setting("camera").as_deref(), Some("keys"));
}

#[test]
fn the_view_turns_about_the_selection() {
    let mut page = Page::with_setting(DESKTOP, "orbit-about", "selection");
    page.select("vertex", &[0]);
    let at = page.mesh().position(halfedge::VertexId::new(0)).to_array();
    let before = page.at(at);
    let from = beside(&page);
    assert_eq!(
        drag(&mut page, PointerButton::Middle, Modifiers::NONE, from, vec2(90.0, 30.0)),
        Moved::Turned
    );
    assert!(page.at(at).distance(before) < 0.5);
    page.press(Key::Escape);
    assert!(page.selected().1.is_empty());
    let middle = page.find("Viewport").rect().center();
    let target: Vec<f64> = serde_json::from_value(view(&mut page)["target"].clone()).expect("a point");
    let target = [target[0] as f32, target[1] as f32, target[2] as f32];
    drag(&mut page, PointerButton::Middle, Modifiers::NONE, from, vec2(-50.0, 10.0));
    assert!(page.at(target).distance(middle) < 0.5, "about the middle of the view");
}

#[test]
fn free_rotation_goes_over_the_poles() {
    let mut page = Page::new();
    let from = beside(&page);
    let up = vec2(0.0, 400.0);
    drag(&mut page, PointerButton::Middle, Modifiers::NONE, from - up, up);
    assert_eq!(view(&mut page)["roll"], 0.0);
    page.press(Key::Space);
    page.click("View");
    page.click("Camera style");
    page.click("Free rotation");
    drag(&mut page, PointerButton::Middle, Modifiers::NONE, from - up, up);
    let upright = |page: &mut Page| page.at([0.0, 0.5, 0.0]).y < page.at([0.0, -0.5, 0.0]).y;
    assert!(!upright(&mut page), "upside down beyond the pole");
    assert_eq!(page.outside.setting("rotation").as_deref(), Some("trackball"));
    page.press_with(Modifiers::ALT, Key::Num1);
    assert!(upright(&mut page), "views from the sides are upright");
    drag(&mut page, PointerButton::Middle, Modifiers::NONE, from - vec2(0.0, 60.0), vec2(80.0, 50.0));
    page.click("View");
    page.click("Camera style");
    page.click("Free rotation");
    assert_eq!(view(&mut page)["roll"], 0.0, "the turntable stands upright");
}

#[test]
fn the_view_looks_straight_at_the_selection() {
    let mut page = Page::new();
    page.select("face", &[0]);
    let mesh = page.mesh();
    let face = halfedge::FaceId::new(0);
    let corners: Vec<glam::Vec3> = mesh.face_vertices(face).map(|v| mesh.position(v)).collect();
    let middle = corners.iter().sum::<glam::Vec3>() / corners.len() as f32;
    page.click("View");
    page.click("Look from");
    page.harness.get_by_label_contains("Align view to selection").click();
    page.run();
    let center = page.find("Viewport").rect().center();
    assert!(page.at(middle.to_array()).distance(center) < 1.0);
    // A point in front of the face is in line with it.
    assert!(page.at((middle * 1.5).to_array()).distance(center) < 1.0);
}
