//! Columns of a mesh that no part of Meshwright gives a meaning: attributes that a file brought along.

use halfedge::attribute::{Column, Value};
use halfedge::{Element, Mesh, keys};

/// Whether a column of this name has a meaning of its own.
pub(crate) fn has_meaning(element: Element, name: &str) -> bool {
    let names: &[&str] = match element {
        Element::Vertex => &[keys::VERTEX_COLOR.name, keys::VERTEX_CREASE.name],
        Element::Halfedge => &[keys::CORNER_UV.name, keys::CORNER_NORMAL.name],
        Element::Edge => &[keys::EDGE_CREASE.name],
        Element::Face => &[
            keys::FACE_COLOR.name,
            keys::FACE_MATERIAL.name,
            keys::FACE_GROUP.name,
            keys::FACE_SMOOTHING.name,
        ],
    };
    names.contains(&name)
}

/// The columns of numbers that have no meaning here.
pub(crate) fn attributes(mesh: &Mesh, element: Element) -> impl Iterator<Item = &Column> {
    let is_number = |column: &&Column| matches!(column.default, Value::F32(_) | Value::U32(_));
    let columns = mesh.columns().of(element).iter().filter(is_number);
    columns.filter(move |column| !has_meaning(element, &column.name))
}
