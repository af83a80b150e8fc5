//! The named selections of an object, and their names.

use crate::document::{NamedSelection, Object};
use crate::error::Problem;
use crate::history::Change;
use std::sync::Arc;

/// A name without spaces around it.
pub(super) fn name_of(given: &str, field: &str) -> Result<String, Problem> {
    let name = given.trim();
    if name.is_empty() || name.chars().any(char::is_control) {
        return Err(Problem::field(field, "a name needs at least one character, and no control characters"));
    }
    Ok(name.to_owned())
}

/// The place of a named selection.
pub(super) fn find(object: &Object, name: &str) -> Result<usize, Problem> {
    let name = name.trim();
    object.named_selections().iter().position(|named| named.name == name).ok_or_else(|| {
        let known: Vec<String> = object.named_selections().iter().map(|n| format!("“{}”", n.name)).collect();
        Problem::field(
            "name",
            match known.as_slice() {
                [] => format!("there is no selection “{name}”; none has a name"),
                known => format!("there is no selection “{name}”; there are {}", known.join(", ")),
            },
        )
    })
}

/// The change to these named selections.
pub(super) fn change(object: &Object, named: Vec<NamedSelection>) -> Vec<Change> {
    if named == object.named_selections() {
        return Vec::new();
    }
    vec![Change::NamedSelections(object.id(), Arc::new(named))]
}
