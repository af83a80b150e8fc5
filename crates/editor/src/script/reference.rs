//! The operations reference.

use super::words;
use crate::ops::{OpId, Scope};
use std::fmt::Write;

const HEAD: &str = "\
# Operations

<!-- Made from the operations' descriptions; `MESHWRIGHT_UPDATE=1 cargo test -p editor --test script` rewrites it. -->

A command is a JSON object: `{\"op\": \"<name>\", ...fields}`. Every command also takes `\"object\"`, the place of an \
object in the document's list, from 0; by default it is for the active object.

Positions are relative to `document.offset` of the state, as those of elements are. It is missing, which means zero, \
unless the model lies so far from the origin that 32-bit numbers are too coarse there; files and the page's fields have \
the sum.
";

/// All operations with their fields, as Markdown.
pub fn operations_reference() -> String {
    let mut text = HEAD.to_owned();
    let parts = [
        (Scope::Elements, "Local edits", "They keep the ids of elements that they don't change."),
        (Scope::Meshes, "Operations on whole meshes", "They renumber all elements; long ones run as jobs."),
        (Scope::Bezier, "Bezier curves and surfaces", "They edit control points."),
        (
            Scope::Selection,
            "Selecting and hiding",
            "They change what is selected and shown, not the mesh. Hidden elements are never selected by what they are like, \
             but operations on whole meshes and files include them. An edit keeps hidden faces hidden and named selections \
             as they are, without the elements that it removes; an operation that renumbers the mesh shows everything and \
             drops the named selections.",
        ),
        (Scope::Document, "Objects", "They edit the document's list of objects."),
    ];
    for (scope, title, note) in parts {
        // Writing to a string can't fail.
        let _ = write!(text, "\n## {title}\n\n{note}\n");
        for id in OpId::ALL.iter().filter(|id| id.spec().scope == scope) {
            text += &operation(*id);
        }
    }
    text
}

fn operation(id: OpId) -> String {
    let spec = id.spec();
    let mut text = format!("\n### `{}`\n\n{}\n", spec.name, spec.description);
    if spec.fields.is_empty() {
        return text;
    }
    text += "\n| Field | Meaning | Values | When left out |\n|---|---|---|---|\n";
    for field in spec.fields {
        let _ = writeln!(
            text,
            "| `{}` | {} | {} | {} |",
            field.name,
            field.description,
            words::values(field),
            words::when_left_out(field).trim_start_matches("default: "),
        );
    }
    text
}
