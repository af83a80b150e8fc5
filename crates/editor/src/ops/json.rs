//! How operations read and write their fields, and what is said of fields that don't fit.

use super::symmetry::{self, Symmetry};
use super::{Operation, Spec};
use crate::error::Problem;
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
    fn parse(mut fields: Map<String, Value>) -> Result<Self, Problem> {
        add_defaults(&O::SPEC, &mut fields);
        from_fields(fields)
    }

    fn to_fields(&self) -> Value {
        // Plain data with text keys: this can't fail.
        let mut value = serde_json::to_value(self).unwrap_or_default();
        if let Value::Object(fields) = &mut value {
            fields.retain(|_, value| !value.is_null());
        }
        value
    }
}

/// Adds the defaults that are values, for fields that are left out.
fn add_defaults(spec: &Spec, fields: &mut Map<String, Value>) {
    for field in spec.fields {
        // The symmetry belongs to the command.
        if !field.is_symmetry()
            && !fields.contains_key(field.name)
            && let Some(value) = field.default_value()
        {
            fields.insert(field.name.to_owned(), value);
        }
    }
}

/// Takes the symmetry from the fields of an operation that can be mirrored.
pub(crate) fn take_symmetry(spec: &Spec, fields: &mut Map<String, Value>) -> Result<Symmetry, Problem> {
    #[derive(Default, serde::Deserialize)]
    struct Mirrored {
        symmetry: Symmetry,
    }
    let given = spec.field(symmetry::FIELD_NAME).and_then(|field| fields.remove_entry(field.name));
    let read = given.map(|given| from_fields::<Mirrored>(Map::from_iter([given])));
    Ok(read.transpose()?.unwrap_or_default().symmetry)
}

/// Reads an operation's fields, naming the one at fault.
fn from_fields<T: DeserializeOwned>(fields: Map<String, Value>) -> Result<T, Problem> {
    serde_path_to_error::deserialize(Value::Object(fields)).map_err(|error| {
        let path = error.path().to_string();
        let text = error.into_inner().to_string();
        let quoted = |prefix: &str| Some(text.strip_prefix(prefix)?.split('`').next()?.to_owned());
        if let Some(field) = quoted("missing field `") {
            let field = if path == "." { field } else { format!("{path}.{field}") };
            return Problem::field(field, "is missing");
        }
        if quoted("unknown field `").is_some() {
            let known = text.split_once("expected ").map_or("", |(_, known)| known);
            let text = match known {
                "" => "is not a field of this op, which has none".to_owned(),
                known => format!("is not a field of this op; expected {known}"),
            };
            return Problem::field(path, text);
        }
        if let Some((given, known)) =
            text.strip_prefix("unknown variant ").and_then(|rest| rest.split_once(", expected "))
        {
            return Problem::field(path, format!("{given} is not a choice; expected {known}"));
        }
        let text = in_plain_words(&text).unwrap_or(text);
        if path == "." { Problem::new(text) } else { Problem::field(path, text) }
    })
}

/// What serde says about a value that doesn't fit, without the names of Rust's types.
pub(crate) fn in_plain_words(text: &str) -> Option<String> {
    // A type that reads its own parts adds no place, but the reader does not know that.
    let text = text.split(" at line ").next().unwrap_or(text);
    if let Some(rest) = text.strip_prefix("invalid length ") {
        let (length, expected) = rest.split_once(", expected ")?;
        return Some(match expected.strip_prefix("an array of length ") {
            Some(wanted) => format!("is a list of {length} values where {wanted} are expected"),
            None if expected == "fewer elements in array" => {
                format!("is a list of {length} values, which is too long")
            }
            None => format!("is a list of {length} values; expected {}", plain(expected)),
        });
    }
    let rest = text.strip_prefix("invalid type: ").or_else(|| text.strip_prefix("invalid value: "))?;
    let (given, expected) = rest.split_once(", expected ")?;
    let given = match given.split_once(' ').unwrap_or((given, "")) {
        ("map", _) => "an object",
        ("sequence", _) => "a list",
        ("integer" | "boolean", value) => value.trim_matches('`'),
        ("floating", value) => value.trim_start_matches("point ").trim_matches('`'),
        ("string", value) => value,
        _ => given,
    };
    Some(match expected.strip_prefix("an array of length ") {
        Some(length) => format!("{given} is not a list of {length} numbers"),
        None => format!("{given} is not {}", plain(expected)),
    })
}

/// What serde expects, without the names of Rust's types.
fn plain(expected: &str) -> &str {
    match expected {
        "f64" | "f32" => "a number",
        "usize" | "u64" | "u32" => "a whole number of 0 or more",
        "a sequence" => "a list",
        "a boolean" => "true or false",
        "a map" => "an object",
        "a string" => "text in quotes",
        "string or map" | "map with a single key" | "unit" | "unit variant" | "variant identifier" => {
            "one of its words, in quotes"
        }
        other => other,
    }
}
