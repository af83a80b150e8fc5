//! The TypeScript types of commands and of `window.meshwright`.

use super::words;
use crate::ops::{Arity, Field, FieldKind, Fill, OpId};
use halfedge::Element;
use std::fmt::Write;
use surface::Shape;

const HEAD: &str = "\
// The commands of Meshwright and the API of `window.meshwright`.
// Made from the operations' descriptions: `MESHWRIGHT_UPDATE=1 cargo test -p editor --test script` rewrites it.

";

/// The parts that don't depend on operations.
const API: &str = include_str!("api.d.ts");

/// A declaration file: a type for each command, their union, and the API.
pub fn typescript_types() -> String {
    let mut text = HEAD.to_owned();
    for id in OpId::ALL {
        text += &command(*id);
    }
    text += "/** Any command. */\nexport type Command =\n";
    let names: Vec<String> = OpId::ALL.iter().map(|id| format!("  | {id:?}")).collect();
    text += &names.join("\n");
    text += ";\n\n";
    text += API;
    text
}

fn command(id: OpId) -> String {
    let spec = id.spec();
    let mut text =
        format!("/** {} */\nexport interface {id:?} {{\n  op: \"{}\";\n", spec.description, spec.name);
    text += "  /** The place of the object in the document's list; default: the active object. */\n";
    text += "  object?: number;\n";
    for field in spec.fields {
        let is_required = field.fill == Fill::Required && field.alternative.is_none();
        // Writing to a string can't fail.
        let _ = write!(
            text,
            "  /** {}: {}; {}. */\n  {}{}: {};\n",
            field.description,
            words::values(field),
            words::when_left_out(field),
            field.name,
            if is_required { "" } else { "?" },
            type_of(field),
        );
    }
    text + "}\n\n"
}

fn type_of(field: &Field) -> String {
    match field.kind {
        FieldKind::Elements { element, arity } => {
            let one = match element {
                Element::Vertex | Element::Face => "number",
                Element::Edge | Element::Halfedge => "number | Pair",
            };
            match arity {
                Arity::One => one.to_owned(),
                Arity::Two => format!("[{one}, {one}]"),
                Arity::Many if one.contains('|') => format!("({one})[]"),
                Arity::Many => format!("{one}[]"),
            }
        }
        FieldKind::Number { .. } | FieldKind::Integer { .. } | FieldKind::ShapeSize => "number".to_owned(),
        FieldKind::Vector => "Vector".to_owned(),
        FieldKind::VectorPair => "[Vector, Vector]".to_owned(),
        FieldKind::Factors => "number | Vector".to_owned(),
        FieldKind::Rotation => "{ axis: Vector; degrees: number }".to_owned(),
        FieldKind::Color | FieldKind::Text => "string".to_owned(),
        FieldKind::Choice(choices) => union(choices.iter().map(|choice| choice.name)),
        FieldKind::Flag => "boolean".to_owned(),
        FieldKind::Objects => "number[]".to_owned(),
        FieldKind::Shape => union(Shape::names()),
    }
}

fn union<'a>(words: impl Iterator<Item = &'a str>) -> String {
    words.map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(" | ")
}
