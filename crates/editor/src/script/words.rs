//! Descriptions of fields in words.

use crate::ops::{Arity, Field, FieldKind, Unit};
use halfedge::{Element, NumberRange};
use surface::Shape;

/// The values that a field accepts, as in "a number from 0 to 1".
pub(super) fn values(field: &Field) -> String {
    match field.kind {
        FieldKind::Elements { element, arity } => elements(element, arity),
        FieldKind::Number { unit, range } => format!("a number{}{}", in_unit(unit), in_range(range)),
        FieldKind::Integer { unit, range } => format!("a whole number{}{}", in_unit(unit), in_range(range)),
        FieldKind::Vector => "three numbers: `[x, y, z]`".to_owned(),
        FieldKind::VectorPair => "two positions: `[[x, y, z], [x, y, z]]`".to_owned(),
        FieldKind::Factors => "a factor, or three: `[x, y, z]`".to_owned(),
        FieldKind::Rotation => "an axis and degrees: `{\"axis\": [0, 0, 1], \"degrees\": 90}`".to_owned(),
        FieldKind::Color => "a colour: `\"#rrggbb\"`".to_owned(),
        FieldKind::Choice(choices) => one_of(choices.iter().map(|choice| choice.name)),
        FieldKind::Flag => "`true` or `false`".to_owned(),
        FieldKind::Text => "text".to_owned(),
        FieldKind::Objects => "a list of objects by their places, from 0".to_owned(),
        FieldKind::Shape => one_of(Shape::names()),
        FieldKind::ShapeSize => "a number, for shapes that have this size".to_owned(),
    }
}

fn elements(element: Element, arity: Arity) -> String {
    let (one, many, pair) = match element {
        Element::Vertex => ("vertex", "vertices", None),
        Element::Edge => ("edge", "edges", Some("`[a, b]`, the vertices at its ends")),
        Element::Halfedge => ("half-edge", "half-edges", Some("`[from, to]`, its vertices")),
        Element::Face => ("face", "faces", None),
    };
    let id = match pair {
        None => "by id".to_owned(),
        Some(pair) => format!("by id or by {pair}"),
    };
    match arity {
        Arity::One => format!("{} {one} {id}", if element == Element::Edge { "an" } else { "a" }),
        Arity::Two => format!("a list of two {many}, each {id}"),
        Arity::Many => format!("a list of {many}, each {id}"),
    }
}

fn in_unit(unit: Unit) -> &'static str {
    match unit {
        Unit::Length => " in mesh units",
        Unit::Area => " in square mesh units",
        Unit::Degrees => " of degrees",
        Unit::Triangles => " of triangles",
        Unit::Fraction | Unit::ShareOfTriangles | Unit::Count => "",
    }
}

/// The range after the kind of number: " from 0 to 1", ", 0 or more"; nothing where there is no limit.
fn in_range(range: NumberRange) -> String {
    match (range.has_min(), range.has_max()) {
        (false, false) => String::new(),
        (true, false) if range.contains(*range.bounds().start()) => format!(", {range}"),
        _ => format!(" {range}"),
    }
}

fn one_of<'a>(words: impl Iterator<Item = &'a str>) -> String {
    let words: Vec<String> = words.map(|word| format!("`\"{word}\"`")).collect();
    format!("one of {}", words.join(", "))
}

/// The effect of leaving a field out: its default, or that it is required.
pub(super) fn when_left_out(field: &Field) -> String {
    match (field.kind, field.alternative, field.default_words()) {
        (FieldKind::ShapeSize, ..) => format!("default: {}", shape_sizes(field.name)),
        (_, Some(_), _) => "exactly one of these is required".to_owned(),
        (_, None, None) => "required".to_owned(),
        (_, None, Some(default)) => format!("default: {default}"),
    }
}

/// The default of a size for each shape that has it.
fn shape_sizes(name: &str) -> String {
    let sizes = Shape::names().filter_map(|shape| {
        let field = *Shape::named(shape)?.fields().iter().find(|field| field.name == name)?;
        Some(format!("{} for {shape}", field.default))
    });
    sizes.collect::<Vec<_>>().join(", ")
}
