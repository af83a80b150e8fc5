//! The form of an operation, generated from the fields of its description.

use editor::Spec;
use editor::ops::{Arity, Choice, Facts, Field, FieldKind, Fill, Unit, sentence_case};
use egui::{ComboBox, RichText, Ui};
use serde_json::{Value, json};
use surface::Shape;

use crate::lists::columns::element_name;
use crate::session::form::{Filled, alternatives, chosen};
use crate::units::Measure;
use crate::widgets::color_button::color_button;
use crate::widgets::controls::{FIELD_WIDTH, check_box, form_number, text_field};
use crate::widgets::number_box::number_box;
use halfedge::Element;

/// The rows of those fields of an operation for which `shown` is true, without those that something else fills in.
pub fn rows(ui: &mut Ui, spec: &Spec, filled: &mut Filled, facts: &Facts, shown: impl Fn(&Field) -> bool) {
    let mut last_title = None;
    let is_filled_in = |field: &Field| matches!(field.fill, Fill::Optional(_));
    for field in spec.fields.iter().filter(|field| shown(field) && !is_filled_in(field)) {
        match (field.kind, field.alternative) {
            (_, Some(title)) if last_title == Some(title) => {}
            (_, Some(title)) => {
                last_title = Some(title);
                alternative_rows(ui, spec, title, filled, facts);
            }
            (FieldKind::Shape, None) => shape_rows(ui, field, filled),
            (FieldKind::ShapeSize, None) => {}
            (_, None) => row(ui, spec, field, filled, facts),
        }
    }
}

/// One row of a form: the field's name, its value, and its meaning as a tooltip. Fields that the selection
/// fills are one line that says so.
fn row(ui: &mut Ui, spec: &Spec, field: &'static Field, filled: &mut Filled, facts: &Facts) {
    let label = field.label();
    let words = field.default_words().unwrap_or_default();
    if matches!(field.fill, Fill::Selection(_)) {
        ui.label(RichText::new(&label).weak()).on_hover_text(field.description);
        ui.label(RichText::new(words).weak());
        ui.end_row();
        return;
    }
    let name = ui.label(&label).on_hover_text(field.description);
    ui.label_inputs_by(name.id, |ui| {
        ui.horizontal(|ui| {
            if let Fill::Unset(words) = field.fill {
                let mut given = filled.contains_key(field.name);
                let check = ui
                    .add(check_box(&mut given))
                    .accessible_name(format!("Set {label}"))
                    .on_hover_text(format!("Set a value instead of using {words}"));
                if check.changed() {
                    if given {
                        filled.insert(field.name.to_owned(), field.initial_value(facts));
                    } else {
                        filled.remove(field.name);
                    }
                }
                if !given {
                    ui.label(RichText::new(words).weak());
                    return;
                }
            }
            let value = filled.entry(field.name).or_insert_with(|| field.initial_value(facts));
            ui.push_id((spec.name, field.name), |ui| edit(ui, field, &label, value, facts));
        });
    });
    ui.end_row();
}

/// The rows of alternatives: a choice, and the value of the chosen one.
fn alternative_rows(ui: &mut Ui, spec: &Spec, title: &'static str, filled: &mut Filled, facts: &Facts) {
    let Some(mut field) = chosen(spec, title, filled).or_else(|| alternatives(spec, title).next()) else {
        return;
    };
    let label = ui.label(title);
    let combo =
        ComboBox::from_id_salt(title).selected_text(field.label()).width(FIELD_WIDTH).show_ui(ui, |ui| {
            for other in alternatives(spec, title) {
                let option = ui.selectable_label(other.name == field.name, other.label());
                if option.on_hover_text(other.description).clicked() && other.name != field.name {
                    let before = filled.remove(field.name);
                    let value =
                        converted(field, before, other, facts).unwrap_or_else(|| other.initial_value(facts));
                    filled.insert(other.name.to_owned(), value);
                    field = other;
                }
            }
        });
    combo.response.labelled_by(label.id).on_hover_text(field.description);
    ui.end_row();
    row(ui, spec, field, filled, facts);
}

/// The value of one alternative, converted from the equivalent value of another.
fn converted(from: &Field, value: Option<Value>, to: &Field, facts: &Facts) -> Option<Value> {
    let (value, triangles) = (value?.as_f64()?, facts.triangles().filter(|count| *count > 0)? as f64);
    match (unit(from)?, unit(to)?) {
        (Unit::ShareOfTriangles, Unit::Triangles) => Some(json!(((value * triangles).round() as u32).max(1))),
        (Unit::Triangles, Unit::ShareOfTriangles) => {
            Some(json!(editor::ops::four_digits((value / triangles).min(1.0))))
        }
        _ => None,
    }
}

fn unit(field: &Field) -> Option<Unit> {
    match field.kind {
        FieldKind::Number { unit, .. } | FieldKind::Integer { unit, .. } => Some(unit),
        _ => None,
    }
}

fn edit(ui: &mut Ui, field: &Field, label: &str, value: &mut Value, facts: &Facts) {
    match field.kind {
        FieldKind::Number { unit, range } => {
            number(ui, None, value, range.bounds(), (measure_of(unit), speed(unit, value, facts)));
        }
        FieldKind::Integer { unit: Unit::Triangles, range } => {
            let (min, max) = range.whole_bounds().into_inner();
            let most =
                facts.triangles().and_then(|count| i64::try_from(count).ok()).unwrap_or(max).clamp(min, max);
            integer(ui, value, min..=most, (most as f64 * 0.002).max(0.2));
        }
        FieldKind::Integer { range, .. } => integer(ui, value, range.whole_bounds(), 0.1),
        FieldKind::Elements { arity: Arity::One, .. } => integer(ui, value, 0..=i64::from(u32::MAX) - 1, 0.1),
        FieldKind::Elements { .. } | FieldKind::Objects => ids(ui, value),
        FieldKind::Vector => axes(ui, label, value, Measure::Length),
        FieldKind::Factors => axes(ui, label, value, Measure::Factor),
        FieldKind::VectorPair => {
            for (at, vector) in value.as_array_mut().into_iter().flatten().enumerate() {
                axes(ui, &format!("{label} {}", at + 1), vector, Measure::Length);
            }
        }
        // Two rows: one would widen the panel.
        FieldKind::Rotation => drop(ui.vertical(|ui| {
            if let Some(axis) = value.get_mut("axis") {
                ui.horizontal(|ui| axes(ui, &format!("{label} axis"), axis, Measure::Number));
            }
            if let Some(degrees) = value.get_mut("degrees") {
                let speed = speed(Unit::Degrees, degrees, facts);
                number(ui, Some("Degrees"), degrees, -360.0..=360.0, (Measure::Angle, speed));
            }
        })),
        FieldKind::Color => color(ui, label, value),
        FieldKind::Choice(choices) => choice(ui, label, value, choices),
        FieldKind::Flag => {
            let mut on = value.as_bool().unwrap_or_default();
            if ui.add(check_box(&mut on)).changed() {
                *value = on.into();
            }
        }
        FieldKind::Text => {
            let mut text = value.as_str().unwrap_or_default().to_owned();
            if ui.add(text_field(&mut text).desired_width(FIELD_WIDTH)).changed() {
                *value = text.into();
            }
        }
        // The form of a shape has its own rows.
        FieldKind::Shape | FieldKind::ShapeSize => {}
    }
}

/// What a number in a unit measures.
fn measure_of(unit: Unit) -> Measure {
    match unit {
        Unit::Length => Measure::Length,
        Unit::Degrees => Measure::Angle,
        Unit::Fraction | Unit::ShareOfTriangles => Measure::Factor,
        Unit::Area | Unit::Count | Unit::Triangles => Measure::Number,
    }
}

/// The change of a number per point of a drag.
fn speed(unit: Unit, value: &Value, facts: &Facts) -> f64 {
    let by_value = (value.as_f64().unwrap_or_default().abs() * 0.01).clamp(0.001, 1e6);
    match (unit, facts.diagonal) {
        (Unit::ShareOfTriangles, _) => 0.002,
        // Small and large models both need steps in proportion to their size.
        (Unit::Length, Some(diagonal)) if diagonal > 0.0 => by_value.min(diagonal * 1e-3),
        _ => by_value,
    }
}

/// A spin box; without an accessible name of its own it takes that of the row's label.
fn number(
    ui: &mut Ui,
    name: Option<&str>,
    value: &mut Value,
    range: std::ops::RangeInclusive<f64>,
    (measure, speed): (Measure, f64),
) {
    let mut number = value.as_f64().unwrap_or_default();
    let spin = number_box(ui, &mut number, measure).speed(speed).range(range);
    let spin = spin.clamp_existing_to_range(false).max_decimals(6);
    let mut spin = form_number(ui, spin);
    if let Some(name) = name {
        spin = spin.accessible_name(name);
    }
    if spin.changed() {
        *value = json!(number);
    }
}

fn integer(ui: &mut Ui, value: &mut Value, range: std::ops::RangeInclusive<i64>, speed: f64) {
    let mut number = value.as_i64().unwrap_or_default();
    let spin = number_box(ui, &mut number, Measure::Number).speed(speed).range(range);
    let spin = spin.clamp_existing_to_range(false);
    if form_number(ui, spin).changed() {
        *value = number.into();
    }
}

/// The decimals that three boxes in a row have room for.
const MAX_AXIS_DECIMALS: usize = 4;

fn axes(ui: &mut Ui, label: &str, value: &mut Value, measure: Measure) {
    // A single number stands for all three.
    let at = |i: usize| value.get(i).unwrap_or(&*value).as_f64().unwrap_or_default();
    let mut numbers = [at(0), at(1), at(2)];
    let mut changed = false;
    for (axis, number) in ["x", "y", "z"].iter().zip(&mut numbers) {
        let drag = number_box(ui, number, measure).speed(0.01).max_decimals(MAX_AXIS_DECIMALS);
        changed |= ui
            .add_sized([54.0, ui.spacing().interact_size.y], drag)
            .accessible_name(format!("{label} {axis}"))
            .changed();
    }
    if changed {
        *value = json!(numbers);
    }
}

fn color(ui: &mut Ui, label: &str, value: &mut Value) {
    let parsed = value.as_str().and_then(halfedge::Color::from_hex).unwrap_or(halfedge::Color::UNPAINTED);
    let mut rgb = parsed.0;
    if color_button(ui, label, &mut rgb).1 {
        *value = halfedge::Color(rgb).to_hex().into();
    }
}

/// The label of a choice.
pub fn choice_label(choices: &'static [Choice], name: &str) -> &'static str {
    choices.iter().find(|choice| choice.name == name).map_or("", |choice| choice.label)
}

fn choice(ui: &mut Ui, label: &str, value: &mut Value, choices: &'static [Choice]) {
    let chosen = value.as_str().unwrap_or_default().to_owned();
    let text = choice_label(choices, &chosen);
    let combo = ComboBox::from_id_salt("choice").selected_text(text).width(FIELD_WIDTH).show_ui(ui, |ui| {
        for choice in choices {
            if ui.selectable_label(chosen == choice.name, choice.label).clicked() {
                *value = choice.name.into();
            }
        }
    });
    combo.response.accessible_name(label);
}

/// A field for ids, separated by spaces or commas.
fn ids(ui: &mut Ui, value: &mut Value) {
    let listed: Vec<String> =
        value.as_array().map_or_else(Vec::new, |ids| ids.iter().map(Value::to_string).collect());
    let mut text = listed.join(" ");
    if ui.add(text_field(&mut text).hint_text("0 1 2").desired_width(FIELD_WIDTH)).changed() {
        let ids: Vec<u32> = text.split([' ', ',']).filter_map(|id| id.parse().ok()).collect();
        *value = json!(ids);
    }
}

/// The rows of a shape: the choice, and the sizes of the chosen shape.
fn shape_rows(ui: &mut Ui, field: &Field, filled: &mut Filled) {
    let name = filled.get(field.name).and_then(Value::as_str).unwrap_or_default().to_owned();
    let label = ui.label(field.label());
    let combo = ComboBox::from_id_salt("shape")
        .selected_text(sentence_case(&name))
        .width(FIELD_WIDTH)
        .height(460.0)
        .show_ui(ui, |ui| {
            for other in Shape::names() {
                if ui.selectable_label(other == name, sentence_case(other)).clicked() {
                    // The same size may mean something else for another shape.
                    let sizes = Shape::named(&name).map(|shape| shape.fields()).unwrap_or_default();
                    filled.retain(|key, _| sizes.iter().all(|size| size.name != key));
                    filled.insert(field.name.into(), other.into());
                }
            }
        });
    combo.response.labelled_by(label.id).on_hover_text(field.description);
    ui.end_row();

    let chosen = filled.get(field.name).and_then(Value::as_str).unwrap_or_default();
    let Some(shape) = Shape::named(chosen) else { return };
    for size in shape.fields() {
        let label = ui.label(sentence_case(size.name));
        let mut value = filled.get(size.name).and_then(Value::as_f64).unwrap_or(size.default);
        let measure = if size.whole { Measure::Number } else { Measure::Length };
        let drag = number_box(ui, &mut value, measure).range(size.min..=size.max);
        let drag = if size.whole {
            drag.speed(0.1).max_decimals(0)
        } else {
            let speed = (size.default * 0.01).max(1e-6);
            drag.speed(speed).max_decimals(6)
        };
        if form_number(ui, drag).labelled_by(label.id).changed() {
            let value = if size.whole { json!(value.round() as u64) } else { json!(value) };
            filled.insert(size.name.into(), value);
        }
        ui.end_row();
    }
}

/// "3 edges are selected", or the name of a single one, for the fields that the selection fills.
pub fn selection_words(kind: Element, count: usize, latest: Option<u32>) -> String {
    match (count, latest) {
        (0, _) => "Nothing is selected".to_owned(),
        (1, Some(id)) => format!("{} is selected", element_name(kind, id)),
        _ => format!("{} are selected", crate::lists::columns::counted(kind, count)),
    }
}
