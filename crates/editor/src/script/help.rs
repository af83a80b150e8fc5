//! The operations in the help of the command-line program `meshwright`.

use super::words;
use crate::ops::OpId;
use std::fmt::Write;

/// A line for each operation: its name and what it does.
pub fn operations_help() -> String {
    let width = OpId::ALL.iter().map(|id| id.spec().name.len()).max().unwrap_or_default();
    OpId::ALL.iter().map(|id| format!("  {:width$}  {}\n", id.spec().name, id.spec().description)).collect()
}

/// An operation's description and fields, with the values and the default of each.
pub fn operation_help(id: OpId) -> String {
    let spec = id.spec();
    let mut text = format!("{}: {}\n", spec.name, spec.description);
    if spec.fields.is_empty() {
        text += "\nIt has no fields.\n";
        return text;
    }
    text += "\nFields:\n";
    for field in spec.fields {
        // Writing to a string can't fail.
        let _ = write!(
            text,
            "  {}\n      {}.\n      {}; {}\n",
            field.name,
            field.description,
            words::values(field).replace('`', ""),
            words::when_left_out(field),
        );
    }
    text += "\nOn the command line nothing is selected until an operation selects.\n";
    text
}
