//! The part of the form of `simplify` that says how far to go: one of three fields, never two.

use egui::{ComboBox, DragValue, Ui};
use serde_json::{Value, json};

use crate::measures::rounded;
use crate::panels::fields::{Filled, Hints, label_of};

/// The fields of which one is given, with what the choice between them calls it.
const TARGETS: [(&str, &str); 3] =
    [("ratio", "A share"), ("faces", "A count"), ("max_error", "An error limit")];

/// Whether a field of `simplify` is among those that the rows here stand for.
pub fn is_target(field: &str) -> bool {
    TARGETS.iter().any(|(name, _)| *name == field)
}

/// The field that is filled in: the share where none is.
fn chosen(filled: &Filled) -> &'static str {
    TARGETS.iter().map(|(name, _)| *name).find(|name| filled.contains_key(*name)).unwrap_or("ratio")
}

/// What a field starts with when it is chosen: about what the one before it asked for.
fn start(field: &str, before: &Filled, hints: &Hints) -> Value {
    let triangles = hints.triangles().unwrap_or(1000) as f64;
    let share = match (before.get("ratio"), before.get("faces")) {
        (Some(ratio), _) => ratio.as_f64().unwrap_or(0.5),
        (None, Some(faces)) => faces.as_f64().unwrap_or(triangles) / triangles.max(1.0),
        (None, None) => 0.5,
    };
    let share = if share > 0.0 && share <= 1.0 { share } else { 0.5 };
    match field {
        "faces" => json!(((triangles * share).round() as u64).max(1)),
        // A thousandth of the mesh's size, which the eye can't see.
        "max_error" => json!(hints.measures.map_or(0.001, |m| rounded(m.diagonal * 1e-3))),
        _ => json!(rounded(share)),
    }
}

/// The rows of the form.
pub fn rows(ui: &mut Ui, filled: &mut Filled, hints: &Hints) {
    let field = chosen(filled);
    let label = ui.label("Simplify to");
    let called = |field| TARGETS.iter().find(|(name, _)| *name == field).map_or("", |(_, text)| *text);
    let combo =
        ComboBox::from_id_salt("simplify to").selected_text(called(field)).width(110.0).show_ui(ui, |ui| {
            for (name, text) in TARGETS {
                if ui.selectable_label(name == field, text).clicked() && name != field {
                    let value = start(name, filled, hints);
                    filled.retain(|key, _| !is_target(key));
                    filled.insert(name.into(), value);
                }
            }
        });
    combo.response.labelled_by(label.id).on_hover_text("How far to go");
    ui.end_row();

    let field = chosen(filled);
    if !filled.contains_key(field) {
        filled.insert(field.into(), start(field, filled, hints));
    }
    let Some(value) = filled.get_mut(field) else { return };
    let label = ui.label(label_of(field));
    let mut number = value.as_f64().unwrap_or_default();
    let spin = match field {
        "faces" => {
            let most = hints.triangles().unwrap_or(u32::MAX as usize).clamp(1, u32::MAX as usize) as f64;
            DragValue::new(&mut number).speed((most * 0.002).max(0.2)).max_decimals(0).range(1.0..=most)
        }
        "max_error" => {
            let most = hints.measures.map_or(f64::from(f32::MAX), |m| m.diagonal.max(1e-6));
            DragValue::new(&mut number).speed(most * 1e-5).max_decimals(7).range(0.0..=most)
        }
        _ => DragValue::new(&mut number).speed(0.002).max_decimals(4).range(0.0001..=1.0),
    };
    if ui.add(spin).labelled_by(label.id).changed() {
        *value = if field == "faces" { json!(number.round() as u64) } else { json!(number) };
    }
    ui.end_row();
}
