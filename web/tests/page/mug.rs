//! A mug, modelled with the mouse and the keys of Blender.

use crate::page::{DESKTOP, Page};
use egui::{Event, Modifiers, PointerButton, Pos2, Theme, vec2};
use egui_kittest::kittest::Queryable;
use glam::Vec3;
use halfedge::Mesh;
use meshwright_web::input::shortcut::Shortcut;

const MAX_ACTIONS: usize = 45;

/// The page in the hands of a user, whose actions are counted: a key, a typed number, a click, a drag and a notch of
/// the wheel are one each.
struct Hands {
    page: Page,
    actions: Vec<String>,
    /// The mesh at the start and after each step.
    steps: Vec<Mesh>,
}

impl Hands {
    /// On a first visit, with nothing done.
    fn new() -> Self {
        let mut page = Page::welcoming_drawn(DESKTOP, Theme::Dark);
        let steps = vec![page.mesh().clone()];
        Self { page, actions: Vec::new(), steps }
    }

    fn count(&mut self, action: impl Into<String>) {
        self.actions.push(action.into());
    }

    fn key(&mut self, text: &str) {
        self.count(text);
        let Shortcut { ctrl, alt, shift, key, .. } = Shortcut::parse(text).expect("a key");
        let modifiers = Modifiers { alt, ctrl, shift, mac_cmd: false, command: ctrl };
        for pressed in [true, false] {
            let event = Event::Key { key, physical_key: None, pressed, repeat: false, modifiers };
            self.page.harness.event_modifiers(event, modifiers);
            self.page.run();
        }
    }

    /// Types a number, each digit with its key as a browser sends it.
    fn number(&mut self, number: &str) {
        self.count(number);
        for character in number.chars() {
            let text = character.to_string();
            let key = match character {
                '.' => Some(egui::Key::Period),
                '-' => Some(egui::Key::Minus),
                _ => egui::Key::from_name(&text),
            };
            let key = key.expect("a key");
            let modifiers = Modifiers::NONE;
            self.page.harness.event(Event::Key {
                key,
                physical_key: None,
                pressed: true,
                repeat: false,
                modifiers,
            });
            self.page.harness.event(Event::Text(text));
            self.page.harness.event(Event::Key {
                key,
                physical_key: None,
                pressed: false,
                repeat: false,
                modifiers,
            });
            self.page.run();
        }
    }

    fn hover(&mut self, at: Pos2) {
        self.page.harness.hover_at(at);
        self.page.run();
    }

    fn button(&mut self, at: Pos2, button: PointerButton, modifiers: Modifiers, pressed: bool) {
        let event = Event::PointerButton { pos: at, button, pressed, modifiers };
        self.page.harness.event_modifiers(event, modifiers);
    }

    /// Clicks a place of the window.
    fn click_window(&mut self, what: &str, at: Pos2, button: PointerButton, modifiers: Modifiers) {
        self.count(what);
        self.hover(at);
        self.button(at, button, modifiers, true);
        self.button(at, button, modifiers, false);
        self.page.run();
    }

    /// Points at where the user sees a point of the model.
    fn hover_over(&mut self, point: [f32; 3]) {
        let at = self.page.at(point);
        self.hover(at);
    }

    /// Clicks where the user sees a point of the model.
    fn click(&mut self, point: [f32; 3], modifiers: Modifiers) {
        let at = self.page.at(point);
        self.click_window("click", at, PointerButton::Primary, modifiers);
    }

    /// Opens the menu of what is selected.
    fn right_click(&mut self, point: [f32; 3]) {
        let at = self.page.at(point);
        self.click_window("right click", at, PointerButton::Secondary, Modifiers::NONE);
    }

    /// Clicks the button with this label, in an open menu if there is one there.
    fn choose(&mut self, label: &str) {
        let layer = |at: &Pos2| self.page.harness.ctx.layer_id_at(*at).map(|layer| layer.order);
        let places = self.page.harness.query_all_by_label(label).map(|node| node.rect().center());
        let at = places.max_by_key(layer).expect("a button");
        self.click_window(label, at, PointerButton::Primary, Modifiers::NONE);
    }

    /// Drags from the middle of the viewport with the middle button: turns the view.
    fn orbit(&mut self, by: egui::Vec2) {
        self.count("orbit");
        let from = self.page.harness.get_by_label("Viewport").rect().center();
        self.hover(from);
        self.button(from, PointerButton::Middle, Modifiers::NONE, true);
        self.page.run();
        (1..=4u8).for_each(|part| self.hover(from + by * (f32::from(part) / 4.0)));
        self.button(from + by, PointerButton::Middle, Modifiers::NONE, false);
        self.page.run();
    }

    fn wheel(&mut self) {
        self.count("wheel");
        self.page.turn_wheel(egui::MouseWheelUnit::Line, 1.0);
    }

    /// Checks that what was done since the last step is one step of this name, and draws it.
    fn is_step(&mut self, name: &str, faces: usize) {
        let labels = self.page.undo_labels();
        let number = self.steps.len();
        crate::looks::picture(&mut self.page, &format!("mug {number} {name}"));
        assert_eq!(labels.len(), number, "after {:?}: {labels:?}", self.actions);
        assert_eq!(labels.last().map(String::as_str), Some(name));
        let mesh = self.page.mesh().clone();
        assert_eq!(mesh.face_count(), faces, "{name}");
        mesh.validate().expect("a valid mesh");
        self.steps.push(mesh);
    }
}

/// The middle of an edge or a face between two of the 32 directions around the axis, counted from the x axis.
fn between(direction: u8, radius: f32, height: f32) -> [f32; 3] {
    let step = std::f32::consts::TAU / 32.0;
    let (sine, cosine) = ((f32::from(direction) + 0.5) * step).sin_cos();
    let radius = radius * (step / 2.0).cos();
    [radius * cosine, height, radius * sine]
}

#[test]
fn a_mug_takes_at_most_45_actions() {
    let mut hands = Hands::new();
    hands.choose("Blender keys");
    hands.choose("Start with Cylinder");
    hands.is_step("New shape", 34);

    // The cavity: the top is inset and extruded downwards.
    hands.key("3");
    hands.click([0.0, 1.0, 0.0], Modifiers::NONE);
    hands.key("I");
    hands.number("0.12");
    hands.key("Enter");
    hands.is_step("Inset faces", 34 + 32);
    hands.key("E");
    hands.number("-1.8");
    hands.key("Enter");
    hands.is_step("Extrude faces", 34 + 2 * 32);

    // Rows of faces on the outside, from which the handle grows.
    hands.hover_over([1.0, 0.0, 0.0]);
    hands.key("Ctrl+R");
    hands.number("7");
    hands.click([1.0, 0.0, 0.0], Modifiers::NONE);
    hands.key("Enter");
    hands.is_step("Loop cut", 34 + 9 * 32);

    // The ends of the handle grow out of two faces, in two parts, so that the second parts can be joined.
    hands.key("3");
    hands.click(between(0, 1.0, 0.625), Modifiers::NONE);
    hands.click(between(0, 1.0, -0.375), Modifiers::SHIFT);
    hands.key("E");
    hands.number("0.35");
    hands.key("Enter");
    hands.is_step("Extrude faces", 330);
    hands.key("E");
    hands.number("0.22");
    hands.key("Enter");
    hands.is_step("Extrude faces", 338);

    // The faces that look at each other: the lower one is seen from above, the upper one from below.
    hands.click([1.46, -0.25, 0.14], Modifiers::NONE);
    hands.orbit(vec2(0.0, -150.0));
    hands.click([1.46, 0.5, 0.14], Modifiers::SHIFT);
    hands.right_click([1.46, 0.5, 0.14]);
    hands.choose("Bridge");
    hands.is_step("Bridge", 340);

    // Both edges of the rim are rounded.
    hands.orbit(vec2(0.0, 200.0));
    hands.key("2");
    hands.click(between(8, 1.0, 1.0), Modifiers::ALT);
    hands.click(between(24, 0.88, 1.0), Modifiers::ALT | Modifiers::SHIFT);
    hands.key("Ctrl+B");
    hands.number("0.04");
    hands.wheel();
    hands.key("Enter");
    hands.is_step("Bevel edges", 340 + 4 * 32);

    // One level of subdivision, smooth shading, and no edges drawn.
    hands.choose("Upsample (subdivide)");
    hands.is_step("Subdivide (Catmull-Clark)", 1928);
    hands.choose("Smooth shading");
    hands.key("Z");
    crate::looks::picture(&mut hands.page, "mug done");

    assert!(hands.actions.len() <= MAX_ACTIONS, "{} actions: {:?}", hands.actions.len(), hands.actions);
    let mesh = hands.page.mesh();
    mesh.validate().expect("a valid mesh");
    assert!(mesh.boundary_loops().is_empty(), "watertight");
    assert_eq!((mesh.components().1, mesh.euler_characteristic()), (1, 0), "one piece with one handle");
    let (min, max) = mesh
        .positions()
        .iter()
        .fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(min, max), &at| (min.min(at), max.max(at)));
    // As tall as the cylinder and about as wide, and half its radius more where the handle is.
    assert!((min - Vec3::new(-1.0, -1.0, -1.0)).abs().max_element() < 0.02, "{min}");
    assert!((max - Vec3::new(1.55, 1.0, 1.0)).abs().max_element() < 0.02, "{max}");

    // Undone one step after the other, down to the cube.
    let Hands { mut page, mut steps, .. } = hands;
    let (mut keys, mut labels) = (0, page.undo_labels().len());
    assert_eq!(labels + 1, steps.len(), "each step is one undo step");
    while !page.undo_labels().is_empty() {
        assert!(keys < 2 * MAX_ACTIONS, "{:?}", page.undo_labels());
        page.press_with(Modifiers::COMMAND, egui::Key::Z);
        keys += 1;
        if page.undo_labels().len() < labels {
            labels -= 1;
            steps.pop();
        }
        assert_eq!(page.undo_labels().len(), labels);
        assert_eq!(Some(page.mesh()), steps.last(), "{labels} steps are left");
    }
    assert_eq!(steps.len(), 1);
}
