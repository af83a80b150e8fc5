//! How operations read and write their fields, and what is said of fields that don't fit.
//!
//! The description of an operation decides which fields it has, what each takes and within which range. What passes these
//! checks fits the operation's struct, so that nothing that is said depends on how serde words its errors.

use super::symmetry::{self, Symmetry};
use super::{Arity, Choice, Field, FieldKind, Fill, Operation, Spec};
use crate::error::Problem;
use halfedge::{Element, NumberRange};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

/// An operation's fields as JSON.
pub(crate) trait Fields: Sized {
    /// Reads the fields; defaults stand in for those that are left out.
    fn parse(fields: Map<String, Value>) -> Result<Self, Problem>;

    /// The fields as a JSON object, without those that are not set.
    fn to_fields(&self) -> Value;
}

impl<O: Operation + Serialize + DeserializeOwned> Fields for O {
    fn parse(fields: Map<String, Value>) -> Result<Self, Problem> {
        read(checked(&O::SPEC, fields)?)
    }

    fn to_fields(&self) -> Value {
        without_unset(serde_json::to_value(self))
    }
}

// What follows is compiled once, what is above once for each operation.

/// The fields with defaults for those that are left out, if they fit.
fn checked(spec: &Spec, mut fields: Map<String, Value>) -> Checked<Value> {
    fill_in(spec, &mut fields);
    check_fields(spec, &fields)?;
    Ok(Value::Object(fields))
}

fn without_unset(fields: serde_json::Result<Value>) -> Value {
    // Plain data with text keys: this can't fail.
    let mut value = fields.unwrap_or_default();
    if let Value::Object(fields) = &mut value {
        fields.retain(|_, value| !value.is_null());
    }
    value
}

/// Adds the defaults that are values, for fields that are left out. Fields without one may be null instead.
fn fill_in(spec: &Spec, fields: &mut Map<String, Value>) {
    // The symmetry belongs to the command.
    for field in spec.fields.iter().filter(|field| !field.is_symmetry()) {
        match (field.default_value(), fields.get(field.name)) {
            (Some(value), None) => drop(fields.insert(field.name.to_owned(), value)),
            (None, Some(Value::Null)) if field.fill != Fill::Required => drop(fields.remove(field.name)),
            _ => {}
        }
    }
}

/// Takes the symmetry from the fields of an operation that can be mirrored.
pub(crate) fn take_symmetry(spec: &Spec, fields: &mut Map<String, Value>) -> Result<Symmetry, Problem> {
    let Some(field) = spec.field(symmetry::FIELD_NAME) else { return Ok(Symmetry::default()) };
    let Some(value) = fields.remove(field.name) else { return Ok(Symmetry::default()) };
    check_value(field, &value)?;
    read(value)
}

/// Reads what has passed the checks. A test tries wrong values of every field, so that none gets past them.
fn read<T: DeserializeOwned>(checked: Value) -> Result<T, Problem> {
    serde_json::from_value(checked).map_err(unlike_description)
}

fn unlike_description(error: serde_json::Error) -> Problem {
    Problem::internal(format!("the fields are not those of the operation's description: {error}"))
}

/// Checks that there are all fields and no others, and that each has a value that it takes.
fn check_fields(spec: &Spec, fields: &Map<String, Value>) -> Checked {
    for (name, value) in fields {
        match spec.field(name) {
            Some(field) => check_value(field, value)?,
            None => return Err(unknown(name, spec)),
        }
    }
    let mut required =
        spec.fields.iter().filter(|field| field.fill == Fill::Required && field.alternative.is_none());
    match required.find(|field| !fields.contains_key(field.name)) {
        Some(field) => Err(Problem::of_field(field.name, "is missing")),
        None => Ok(()),
    }
}

fn unknown(name: &str, spec: &Spec) -> Problem {
    let known = match spec.fields {
        [] => "which has none".to_owned(),
        fields => format!("which has {}", listed(fields.iter().map(|field| field.name), "and")),
    };
    Problem::of_field(name, format!("is not a field of this op, {known}"))
}

/// Words as a sentence lists them: "`a`, `b` or `c`".
fn listed<'a>(words: impl Iterator<Item = &'a str>, conjunction: &str) -> String {
    let mut words: Vec<String> = words.map(|word| format!("`{word}`")).collect();
    match (words.pop(), words.is_empty()) {
        (Some(last), false) => format!("{} {conjunction} {last}", words.join(", ")),
        (last, _) => last.unwrap_or_default(),
    }
}

type Checked<T = ()> = Result<T, Problem>;

/// Says that a value is not what is expected. The place in the field is added on the way out.
fn is_not<T>(value: &Value, expected: &str) -> Checked<T> {
    let given = match value {
        Value::Array(_) => "a list".to_owned(),
        Value::Object(_) => "an object".to_owned(),
        other => other.to_string(),
    };
    Err(Problem::field("", format!("{given} is not {expected}")))
}

/// Adds in which part of a value the problem is: `axis`, and then `rotate.axis`.
fn in_part(part: &str, problem: Problem) -> Problem {
    Problem { field: Some(format!("{part}{}", problem.field.unwrap_or_default())), ..problem }
}

/// Checks that a value is one that the field takes.
fn check_value(field: &Field, value: &Value) -> Checked {
    let checked = match field.kind {
        FieldKind::Elements { element, arity } => elements(element, arity, value),
        FieldKind::Number { range, .. } => finite(value).and_then(|number| in_range(value, number, range)),
        FieldKind::Integer { range, .. } => integer(value, range),
        FieldKind::Vector => vector(value),
        FieldKind::VectorPair => list_of(2, value, "positions", vector),
        FieldKind::Factors => factors(value),
        FieldKind::Rotation => rotation(value),
        FieldKind::Choice(choices) => choice(choices, value),
        FieldKind::Flag if value.is_boolean() => Ok(()),
        FieldKind::Flag => is_not(value, "true or false"),
        FieldKind::Color | FieldKind::Text | FieldKind::Shape if value.is_string() => Ok(()),
        FieldKind::Color | FieldKind::Text | FieldKind::Shape => is_not(value, "text in quotes"),
        FieldKind::Objects => list(value, |item| whole(item).map(drop)),
        FieldKind::ShapeSize => finite(value).map(drop),
    };
    checked.map_err(|problem| in_part(field.name, problem))
}

fn elements(element: Element, arity: Arity, value: &Value) -> Checked {
    match arity {
        Arity::One => one_element(element, value),
        Arity::Two => list_of(2, value, element.plural(), |item| one_element(element, item)),
        Arity::Many => list(value, |item| one_element(element, item)),
    }
}

/// Checks an id, or for edges and half-edges a pair of vertex ids.
fn one_element(element: Element, value: &Value) -> Checked {
    let (expected, takes_pair) = match element {
        Element::Vertex => ("a vertex id, a whole number from 0", false),
        Element::Face => ("a face id, a whole number from 0", false),
        Element::Edge => ("an edge id, or the pair [a, b] of the vertices at its ends", true),
        Element::Halfedge => ("a half-edge id, or the pair [from, to] of its vertices", true),
    };
    match value {
        Value::Array(pair) if takes_pair && pair.len() != 2 => {
            Err(Problem::of_field("", format!("is a list of {} values; expected {expected}", pair.len())))
        }
        Value::Array(_) if takes_pair => list(value, |item| one_element(Element::Vertex, item)),
        _ if value.as_u64().is_some_and(|id| id < u64::from(halfedge::NONE)) => Ok(()),
        _ => is_not(value, expected),
    }
}

/// Checks every item of a list.
fn list(value: &Value, check: impl Fn(&Value) -> Checked) -> Checked {
    let Value::Array(items) = value else { return is_not(value, "a list") };
    let mut items = items.iter().enumerate();
    items.try_for_each(|(at, item)| check(item).map_err(|problem| in_part(&format!("[{at}]"), problem)))
}

/// Checks a list of so many items.
fn list_of(count: usize, value: &Value, items: &str, check: impl Fn(&Value) -> Checked) -> Checked {
    match value.as_array().map(Vec::len) {
        Some(given) if given != count => {
            Err(Problem::of_field("", format!("is a list of {given} values where {count} are expected")))
        }
        Some(_) => list(value, check),
        None => is_not(value, &format!("a list of {count} {items}")),
    }
}

fn vector(value: &Value) -> Checked {
    list_of(3, value, "numbers", |item| finite(item).map(drop))
}

fn factors(value: &Value) -> Checked {
    let checked = if value.is_array() { vector(value) } else { finite(value).map(drop) };
    checked.map_err(|problem| {
        let text = format!("{}; a factor or a list of three is expected", problem.text);
        Problem { text, ..problem }
    })
}

fn rotation(value: &Value) -> Checked {
    let Value::Object(parts) = value else {
        return is_not(value, "an axis and degrees, as in `{\"axis\": [0, 0, 1], \"degrees\": 90}`");
    };
    let check = |name: &str, part: &Value| match name {
        "axis" => vector(part),
        "degrees" => finite(part).map(drop),
        _ => Err(Problem::of_field("", "is not a part of a rotation, which has `axis` and `degrees`")),
    };
    for (name, part) in parts {
        check(name, part).map_err(|problem| in_part(&format!(".{name}"), problem))?;
    }
    match ["axis", "degrees"].into_iter().find(|name| !parts.contains_key(*name)) {
        Some(missing) => Err(Problem::of_field(format!(".{missing}"), "is missing")),
        None => Ok(()),
    }
}

fn choice(choices: &[Choice], value: &Value) -> Checked {
    let Some(word) = value.as_str() else { return is_not(value, "one of its words, in quotes") };
    if choices.iter().any(|choice| choice.name == word) {
        return Ok(());
    }
    let known = listed(choices.iter().map(|choice| choice.name), "or");
    Err(Problem::field("", format!("`{word}` is not a choice; expected {known}")))
}

/// A number that is finite as an `f32` too. JavaScript gives numbers that JSON can't express by their names.
fn finite(value: &Value) -> Checked<f64> {
    if let Some(name @ ("NaN" | "Infinity" | "-Infinity")) = value.as_str() {
        return Err(Problem::field("", format!("{name} is not a finite number")));
    }
    let number = value.as_f64().map(|number| number as f32).filter(|number| number.is_finite());
    number.map_or_else(|| is_not(value, "a finite number of at most 3.4e38"), |number| Ok(number.into()))
}

fn whole(value: &Value) -> Checked<f64> {
    let Some(number) = value.as_u64() else { return is_not(value, "a whole number of 0 or more") };
    let number = u32::try_from(number)
        .map_err(|_| Problem::field("", format!("{number} is too large; it may be {} at most", u32::MAX)))?;
    Ok(number.into())
}

/// A whole number of the range.
fn integer(value: &Value, range: NumberRange) -> Checked {
    let number = match value.as_i64().and_then(|number| i32::try_from(number).ok()) {
        Some(number) if number < 0 && *range.bounds().start() < 0.0 => number.into(),
        _ => whole(value)?,
    };
    in_range(value, number, range)
}

fn in_range(value: &Value, number: f64, range: NumberRange) -> Checked {
    if range.contains(number) {
        return Ok(());
    }
    Err(Problem::field("", format!("{value} is out of range; it must be {range}")))
}
