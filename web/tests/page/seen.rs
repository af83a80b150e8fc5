//! Everything that a user could see change, so that a test can say that one thing happened and nothing else.

use std::collections::BTreeMap;

use editor::OpId;
use egui::Shape;
use egui::accesskit::{Role, Toggled};
use glam::Vec3;
use meshwright_web::access::tree::{UiTree, Widget};
use meshwright_web::input::key_preset::KeyPreset;

use crate::page::Page;

/// What is seen, by name.
pub struct Seen(BTreeMap<String, String>);

/// Parts of the state that follow from others, or from how long frames take.
const LEFT_OUT: [&str; 10] = [
    "document.boundary_loops",
    "document.components",
    "document.dirty",
    "document.euler",
    "document.halfedges",
    "document.objects",
    "history.bytes",
    "view.frame_ms",
    "view.rect",
    "view.views",
];

/// The hints of the status line that name what the keys do in flight.
const FLIGHT_HINT: &str = "W A S D: Fly";
/// What the status line calls the edge length of resampling.
const TARGET_EDGE: &str = "Target edge length of resampling";

impl Seen {
    /// Reads the document, the selection, the history, the view, switches, dialogs, menus, fields, the focus and messages.
    pub fn read(page: &mut Page) -> Self {
        let mut seen = BTreeMap::new();
        flatten("", &page.app().script().state(), &mut seen);
        let views = page.app().script().state()["view"]["views"].as_array().map_or(0, Vec::len);
        seen.insert("views".to_owned(), views.to_string());
        seen.insert("file dialogs".to_owned(), page.outside.dialogs().to_string());
        seen.insert("hidden faces".to_owned(), page.hidden_faces().len().to_string());
        if let Some(mesh) = page.app().editor().mesh() {
            let corner = |fold: fn(Vec3, Vec3) -> Vec3, from: f32| {
                mesh.vertices().map(|v| mesh.position(v)).fold(Vec3::splat(from), fold)
            };
            let [min, max] = [corner(Vec3::min, f32::INFINITY), corner(Vec3::max, f32::NEG_INFINITY)];
            seen.insert("box".to_owned(), format!("{min:.2} to {max:.2}"));
        }
        let shapes = page.harness.output().shapes.iter().filter_map(|clipped| match &clipped.shape {
            Shape::Circle(circle) if circle.fill == egui::Color32::TRANSPARENT => Some(circle.radius),
            _ => None,
        });
        let largest = shapes.fold(0.0, f32::max);
        seen.insert("largest circle".to_owned(), format!("{largest:.0}"));
        let focus = page.harness.ctx.memory(|memory| memory.focused()).map(|id| id.accesskit_id());
        let tree = page.harness.ctx.plugin::<UiTree>();
        let tree = tree.lock();
        let widgets = tree.read();
        for widget in &widgets {
            if Some(widget.id) == focus {
                seen.insert("focus".to_owned(), widget.name.clone());
            }
            seen.extend(told(widget));
        }
        // A form takes the place of the list of operations.
        if !widgets.iter().any(|widget| widget.name == "Filter operations") {
            let is_button = |widget: &&Widget<'_>| {
                widget.node.role() == Role::Button && widget.node.has_popup().is_none()
            };
            let buttons = widgets.iter().filter(is_button);
            let forms = buttons.filter(|button| opens_form(&button.name));
            seen.extend(forms.map(|button| (format!("form {}", button.name), "open".to_owned())));
        }
        Self(seen)
    }

    /// What differs later, one line for each: the name and the value then.
    pub fn changed(&self, later: &Self) -> Vec<String> {
        let names = self.0.keys().chain(later.0.keys().filter(|name| !self.0.contains_key(*name)));
        let changed = names.filter(|name| self.0.get(*name) != later.0.get(*name));
        let value = |name: &String| later.0.get(name).map_or("gone", String::as_str);
        let mut lines: Vec<String> = changed.map(|name| format!("{name}: {}", value(name))).collect();
        lines.sort();
        lines
    }
}

/// What a widget says about the state of the page.
fn told(widget: &Widget<'_>) -> Option<(String, String)> {
    let name = &widget.name;
    let is_preset = KeyPreset::ALL.iter().any(|preset| *name == format!("{} keys", preset.label()));
    if is_preset || is_field(name.strip_prefix("Set ").unwrap_or(name)) {
        return None;
    }
    let on = widget.node.is_selected().or(widget.node.toggled().map(|toggled| toggled == Toggled::True));
    match (widget.node.role(), on) {
        (Role::ListBoxOption, ..) => None,
        (_, Some(on)) => Some((format!("switch {name}"), on.to_string())),
        (Role::Dialog | Role::Menu | Role::Window, ..) if !name.is_empty() => {
            Some((format!("window {name}"), "open".to_owned()))
        }
        (Role::TextInput, ..) => Some((format!("field {name}"), "there".to_owned())),
        (Role::Label, ..) if name.starts_with(TARGET_EDGE) => {
            let value = name.strip_prefix(TARGET_EDGE)?.trim_start_matches(": ");
            Some((TARGET_EDGE.to_owned(), value.to_owned()))
        }
        (Role::Label, ..) if name.contains(FLIGHT_HINT) => Some((FLIGHT_HINT.to_owned(), "said".to_owned())),
        _ => None,
    }
}

/// Whether an operation has a field of this name. Forms come and go with what they are about, which is seen otherwise.
fn is_field(name: &str) -> bool {
    let mut fields = OpId::ALL.iter().flat_map(|id| id.spec().fields);
    fields.any(|field| field.label() == name)
}

/// Whether the operation of this name opens a form.
fn opens_form(name: &str) -> bool {
    OpId::ALL.iter().any(|id| id.spec().label == name && !id.spec().runs_without_form())
}

/// Each value of the state, with the path to it.
fn flatten(path: &str, value: &serde_json::Value, seen: &mut BTreeMap<String, String>) {
    match value {
        _ if LEFT_OUT.contains(&path) => {}
        serde_json::Value::Object(fields) => {
            for (name, value) in fields {
                let dot = if path.is_empty() { "" } else { "." };
                flatten(&format!("{path}{dot}{name}"), value, seen);
            }
        }
        serde_json::Value::Number(number) if number.is_f64() => {
            seen.insert(path.to_owned(), format!("{:.2}", number.as_f64().unwrap_or(f64::NAN)));
        }
        other => drop(seen.insert(path.to_owned(), other.to_string())),
    }
}
