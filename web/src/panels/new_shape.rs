//! The form of `new`: a shape, and the sizes that this shape has.

use egui::{ComboBox, DragValue, Ui};
use serde_json::{Value, json};
use surface::Shape;

use crate::lists::columns::thousands;
use crate::panels::fields::{Filled, label_of};

/// The shape that is filled in, with the sizes that are.
fn shape_of(filled: &Filled) -> Option<Shape> {
    let mut shape = Shape::named(filled.get("shape")?.as_str()?)?;
    for field in shape.fields() {
        if let Some(value) = filled.get(field.name).and_then(Value::as_f64) {
            shape.set(field.name, value).ok()?;
        }
    }
    Some(shape)
}

/// The rows of the form.
pub fn form(ui: &mut Ui, filled: &mut Filled) {
    let name = filled.get("shape").and_then(Value::as_str).unwrap_or("cube").to_owned();
    let label = ui.label("Shape");
    let combo = ComboBox::from_id_salt("shape")
        .selected_text(label_of(&name))
        .width(140.0)
        .height(460.0)
        .show_ui(ui, |ui| {
            for other in Shape::names() {
                if ui.selectable_label(other == name, label_of(other)).clicked() {
                    // Sizes of one shape mean something else in another.
                    let add = filled.remove("add");
                    filled.clear();
                    filled.insert("shape".into(), other.into());
                    filled.extend(add.map(|add| ("add".into(), add)));
                }
            }
        });
    combo.response.labelled_by(label.id).on_hover_text("Which shape to start from");
    ui.end_row();

    let Some(shape) = shape_of(filled).or_else(|| Shape::named(&name)) else { return };
    for field in shape.fields() {
        let label = ui.label(label_of(field.name));
        let mut value = shape.get(field.name).unwrap_or(field.default);
        let range = field.min..=field.max;
        let speed = (value * 0.01).max(1e-6);
        let drag = if field.whole {
            DragValue::new(&mut value).speed(0.1).max_decimals(0).range(range)
        } else {
            DragValue::new(&mut value).speed(speed).max_decimals(6).range(range)
        };
        if ui.add(drag).labelled_by(label.id).changed() {
            let value = if field.whole { json!(value.round() as u64) } else { json!(value) };
            filled.insert(field.name.into(), value);
        }
        ui.end_row();
    }
    ui.label("");
    let mut add = filled.get("add").and_then(Value::as_bool).unwrap_or_default();
    if ui
        .checkbox(&mut add, "Add to this document")
        .on_hover_text("Off: the shape starts a new document")
        .changed()
    {
        filled.insert("add".into(), add.into());
    }
    ui.end_row();
}

/// How many faces the shape has.
pub fn estimate(filled: &Filled) -> Option<String> {
    let shape = shape_of(filled)?;
    let faces = usize::try_from(shape.face_count()).ok()?;
    Some(format!("Result: {} {}", thousands(faces), if faces == 1 { "face" } else { "faces" }))
}
