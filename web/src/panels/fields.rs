//! The form of an operation, generated from the fields of its description.

use editor::{Field, FieldKind, Spec};
use egui::{Checkbox, ComboBox, DragValue, RichText, TextEdit, Ui};
use serde_json::{Map, Value, json};

use crate::lists::columns::element_name;
use crate::measures::{Measures, rounded};
use crate::panels::color_button::color_button;
use crate::panels::simplify;
use halfedge::Element;

/// What the person filled in, by the fields' names. What is not in it is left out of the command.
pub type Filled = Map<String, Value>;

/// What forms know of the mesh that they are filled in for.
#[derive(Clone, Copy, Debug, Default)]
pub struct Hints {
    /// Its lengths and area, where a field of the form is about those.
    pub measures: Option<Measures>,
    /// How many vertices it has.
    pub vertices: usize,
    /// How many faces it has.
    pub faces: usize,
    /// How many corners its faces have in all; none while they are counted.
    pub corners: Option<usize>,
}

impl Hints {
    /// How many triangles the faces can be cut into, where that is known.
    pub fn triangles(&self) -> Option<usize> {
        self.corners?.checked_sub(2 * self.faces)
    }
}

/// Whether an operation's form suggests lengths, which have to be measured.
pub fn suggests_lengths(op: &str) -> bool {
    matches!(op, "remesh" | "simplify" | "merge-by-distance")
}

/// The values that a form starts with: the defaults that are values. Defaults in words, such as
/// "the selected faces", stay out.
pub fn initial(spec: &Spec, hints: &Hints) -> Filled {
    spec.fields
        .iter()
        .filter_map(|field| {
            let value = match default_value(field) {
                Some(value) => value,
                None if field.default.is_none() => suggested(spec, field, hints),
                None => return None,
            };
            Some((field.name.to_owned(), value))
        })
        .collect()
}

/// The default as a value, where it is one.
pub fn default_value(field: &Field) -> Option<Value> {
    serde_json::from_str(field.default?).ok()
}

/// Whether a field stands for elements, which the selection gives.
pub fn is_elements(kind: FieldKind) -> bool {
    matches!(
        kind,
        FieldKind::Vertex
            | FieldKind::Edge
            | FieldKind::Halfedge
            | FieldKind::Face
            | FieldKind::Vertices
            | FieldKind::Edges
            | FieldKind::Halfedges
            | FieldKind::Faces
            | FieldKind::Objects
    )
}

/// What a field starts with that has no value for a default: what suits the mesh, where it depends on
/// that.
fn suggested(spec: &Spec, field: &Field, hints: &Hints) -> Value {
    let fitting = hints.measures.and_then(|measures| match (spec.name, field.name) {
        ("remesh", "edge_length") => Some(measures.mean_edge),
        ("merge-by-distance", "distance") => Some(measures.diagonal * 1e-4),
        ("simplify", "ratio") => Some(0.5),
        _ => None,
    });
    match fitting.map(rounded).filter(|number| *number > 0.0) {
        Some(number) => json!(number),
        None => blank(field.kind),
    }
}

/// What a field of a kind starts with.
fn blank(kind: FieldKind) -> Value {
    match kind {
        FieldKind::Number { min, max } => json!(1.0_f32.clamp(min, max)),
        FieldKind::Integer { min, max } => json!(1_u32.clamp(min, max)),
        FieldKind::Vector => json!([0.0, 0.0, 0.0]),
        FieldKind::VectorPair => json!([[0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]),
        FieldKind::Factors => json!([1.0, 1.0, 1.0]),
        FieldKind::Rotation => json!({ "axis": [0.0, 1.0, 0.0], "degrees": 0.0 }),
        FieldKind::Color => json!("#c8c8c8"),
        FieldKind::Choice(words) => json!(words.first().copied().unwrap_or_default()),
        FieldKind::Flag => json!(false),
        FieldKind::Text => json!(""),
        FieldKind::Vertex | FieldKind::Edge | FieldKind::Halfedge | FieldKind::Face => json!(0),
        _ => json!([]),
    }
}

/// One row of a form: the field's name, its value, and a tooltip with what it means. Fields that the
/// selection gives are one line that says so.
fn show(ui: &mut Ui, spec: &Spec, field: &Field, filled: &mut Filled, hints: &Hints) {
    let label = label_of(field.name);
    if is_elements(field.kind) && field.default.is_some() {
        ui.label(RichText::new(&label).weak()).on_hover_text(field.description);
        ui.label(RichText::new(field.default.unwrap_or_default()).weak());
        ui.end_row();
        return;
    }
    let name = ui.label(&label).on_hover_text(field.description);
    let optional = field.default.is_some() && default_value(field).is_none();
    ui.label_inputs_by(name.id, |ui| {
        ui.horizontal(|ui| {
            if optional {
                let mut given = filled.contains_key(field.name);
                let hint = format!("Set this instead of {}", field.default.unwrap_or_default());
                let check = ui
                    .add(Checkbox::without_text(&mut given))
                    .accessible_name(format!("Set {label}"))
                    .on_hover_text(hint);
                if check.changed() {
                    if given {
                        filled.insert(field.name.to_owned(), suggested(spec, field, hints));
                    } else {
                        filled.remove(field.name);
                    }
                }
                if !given {
                    ui.label(RichText::new(field.default.unwrap_or_default()).weak());
                    return;
                }
            }
            let value = filled.entry(field.name).or_insert_with(|| suggested(spec, field, hints));
            ui.push_id((spec.name, field.name), |ui| edit(ui, field, &label, value));
        });
    });
    ui.end_row();
}

/// The rows of an operation's fields that `shown` picks.
pub fn rows(ui: &mut Ui, spec: &Spec, filled: &mut Filled, hints: &Hints, shown: impl Fn(&Field) -> bool) {
    let simplifies = spec.name == "simplify";
    if simplifies {
        simplify::rows(ui, filled, hints);
    }
    for field in spec.fields.iter().filter(|field| shown(field)) {
        if !(simplifies && simplify::is_target(field.name)) {
            show(ui, spec, field, filled, hints);
        }
    }
}

fn edit(ui: &mut Ui, field: &Field, label: &str, value: &mut Value) {
    match field.kind {
        FieldKind::Number { min, max } => number(ui, None, value, f64::from(min)..=f64::from(max)),
        FieldKind::Integer { min, max } => integer(ui, value, min..=max),
        FieldKind::Vertex | FieldKind::Edge | FieldKind::Halfedge | FieldKind::Face => {
            integer(ui, value, 0..=u32::MAX - 1)
        }
        FieldKind::Vector | FieldKind::Factors => axes(ui, label, value),
        FieldKind::VectorPair => {
            for (at, vector) in value.as_array_mut().into_iter().flatten().enumerate() {
                axes(ui, &format!("{label} {}", at + 1), vector);
            }
        }
        FieldKind::Rotation => {
            if let Some(axis) = value.get_mut("axis") {
                axes(ui, &format!("{label} axis"), axis);
            }
            if let Some(degrees) = value.get_mut("degrees") {
                number(ui, Some("Degrees"), degrees, -360.0..=360.0);
            }
        }
        FieldKind::Color => color(ui, label, value),
        FieldKind::Choice(words) => choice(ui, label, value, words),
        FieldKind::Flag => {
            let mut on = value.as_bool().unwrap_or_default();
            if ui.add(Checkbox::without_text(&mut on)).changed() {
                *value = on.into();
            }
        }
        FieldKind::Text => {
            let mut text = value.as_str().unwrap_or_default().to_owned();
            if ui.add(TextEdit::singleline(&mut text).desired_width(140.0)).changed() {
                *value = text.into();
            }
        }
        FieldKind::Vertices
        | FieldKind::Edges
        | FieldKind::Halfedges
        | FieldKind::Faces
        | FieldKind::Objects => {
            ids(ui, value);
        }
    }
}

/// A spin box; without a name of its own it is called what the row's label says.
fn number(ui: &mut Ui, name: Option<&str>, value: &mut Value, range: std::ops::RangeInclusive<f64>) {
    let mut number = value.as_f64().unwrap_or_default();
    // A hundredth of the value a point, so that small and large models both can be hit.
    let speed = (number.abs() * 0.01).clamp(0.001, 1e6);
    let mut spin = ui.add(DragValue::new(&mut number).speed(speed).range(range).max_decimals(6));
    if let Some(name) = name {
        spin = spin.accessible_name(name);
    }
    if spin.changed() {
        *value = json!(number);
    }
}

fn integer(ui: &mut Ui, value: &mut Value, range: std::ops::RangeInclusive<u32>) {
    let mut number = value.as_u64().and_then(|n| u32::try_from(n).ok()).unwrap_or_default();
    if ui.add(DragValue::new(&mut number).speed(0.1).range(range)).changed() {
        *value = number.into();
    }
}

fn axes(ui: &mut Ui, label: &str, value: &mut Value) {
    // One number stands for all three.
    let at = |i: usize| value.get(i).unwrap_or(&*value).as_f64().unwrap_or_default();
    let mut numbers = [at(0), at(1), at(2)];
    let mut changed = false;
    for (axis, number) in ["x", "y", "z"].iter().zip(&mut numbers) {
        let drag = DragValue::new(number).speed(0.01).max_decimals(5);
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

fn choice(ui: &mut Ui, label: &str, value: &mut Value, words: &[&str]) {
    let chosen = value.as_str().unwrap_or_default().to_owned();
    let combo =
        ComboBox::from_id_salt("choice").selected_text(readable(&chosen)).width(140.0).show_ui(ui, |ui| {
            for word in words {
                if ui.selectable_label(chosen == *word, readable(word)).clicked() {
                    *value = (*word).into();
                }
            }
        });
    combo.response.accessible_name(label);
}

/// Ids, typed with spaces or commas between them.
fn ids(ui: &mut Ui, value: &mut Value) {
    let listed: Vec<String> =
        value.as_array().map_or_else(Vec::new, |ids| ids.iter().map(Value::to_string).collect());
    let mut text = listed.join(" ");
    if ui.add(TextEdit::singleline(&mut text).hint_text("0 1 2").desired_width(140.0)).changed() {
        let ids: Vec<u32> = text.split([' ', ',']).filter_map(|id| id.parse().ok()).collect();
        *value = json!(ids);
    }
}

/// Names that say too little when only their first letter is made large.
const LABELS: [(&str, &str); 7] = [
    ("by", "Separate by"),
    ("color", "Colour"),
    ("non_manifold", "Non-manifold edges"),
    ("orient", "Re-orient faces"),
    ("project", "Stay on surface"),
    ("t", "Position (0 to 1)"),
    ("uv-sphere", "UV sphere"),
];

/// `boundary_rule` as people read it: "Boundary rule".
pub fn label_of(name: &str) -> String {
    if let Some((_, label)) = LABELS.iter().find(|(known, _)| *known == name) {
        return (*label).to_owned();
    }
    let mut text = name.replace(['_', '-'], " ");
    if let Some(first) = text.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    text
}

/// A word of a choice as people read it: "edge-and-corner" is "Edge and corner".
fn readable(word: &str) -> String {
    label_of(word)
}

/// "3 edges", or the name of the one: what the selection gives a form.
pub fn selection_words(kind: Element, count: usize, latest: Option<u32>) -> String {
    match (count, latest) {
        (0, _) => "Nothing is selected".to_owned(),
        (1, Some(id)) => format!("{} is selected", element_name(kind, id)),
        _ => format!("{} are selected", crate::lists::columns::counted(kind, count)),
    }
}
