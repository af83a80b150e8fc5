//! Fields of JSON objects.

use serde_json::Value;

/// Sets a field of a JSON object.
pub(super) fn set(object: &mut Value, key: &str, value: impl Into<Value>) {
    if let Some(fields) = object.as_object_mut() {
        fields.insert(key.to_owned(), value.into());
    }
}
