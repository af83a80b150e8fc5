//! Attributes without a meaning here, as properties of a written PLY.

use crate::model::attributes::attributes;
use crate::soup::pieces::Pieces;
use crate::text::print::{push_float, push_integer};
use halfedge::Element;
use halfedge::attribute::Value;

/// The names of properties that are written for what has a meaning.
const TAKEN: [&str; 12] =
    ["x", "y", "z", "nx", "ny", "nz", "red", "green", "blue", "vertex_indices", "texcoord", "texnumber"];

/// How an attribute's numbers are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Type {
    Byte,
    Short,
    Int,
    Float,
}

/// An attribute of all vertices or all faces.
pub(super) struct Attribute {
    name: String,
    kind: Type,
    values: Vec<f64>,
}

impl Attribute {
    /// The attributes that any of the meshes has; 0 in a mesh without.
    pub(super) fn all(pieces: &Pieces, element: Element) -> Vec<Self> {
        let mut names: Vec<&str> = Vec::new();
        for column in pieces.meshes.iter().flat_map(|(mesh, _)| attributes(mesh, element)) {
            if !names.contains(&column.name.as_str()) {
                names.push(&column.name);
            }
        }
        names.into_iter().map(|name| Self::of_name(name, pieces, element)).collect()
    }

    fn of_name(name: &str, pieces: &Pieces, element: Element) -> Self {
        let mut values: Vec<f64> = Vec::new();
        let mut is_float = false;
        for (mesh, _) in &pieces.meshes {
            let column = attributes(mesh, element).find(|column| column.name == name);
            is_float |= column.is_some_and(|column| matches!(column.default, Value::F32(_)));
            // The mesh is compact.
            values.extend((0..mesh.capacity(element)).map(|place| {
                match column.and_then(|column| column.values.get(place)) {
                    Some(Value::U32(value)) => f64::from(value),
                    Some(Value::F32(value)) => f64::from(value),
                    _ => 0.0,
                }
            }));
        }
        let most = values.iter().copied().fold(0.0, f64::max);
        let kind = match most {
            _ if is_float => Type::Float,
            most if most <= f64::from(u8::MAX) => Type::Byte,
            most if most <= f64::from(u16::MAX) => Type::Short,
            _ => Type::Int,
        };
        let mut name: String =
            name.chars().map(|c| if c.is_whitespace() || c.is_control() { '_' } else { c }).collect();
        if TAKEN.contains(&name.as_str()) {
            name.push('_');
        }
        Self { name, kind, values }
    }

    /// Its line in the header.
    pub(super) fn property(&self) -> String {
        let kind = match self.kind {
            Type::Byte => "uchar",
            Type::Short => "ushort",
            Type::Int => "uint",
            Type::Float => "float",
        };
        format!("property {kind} {}\n", self.name)
    }

    /// Appends the value of an element in binary.
    pub(super) fn push_binary(&self, place: usize, out: &mut Vec<u8>) {
        let value = self.values.get(place).copied().unwrap_or_default();
        match self.kind {
            Type::Byte => out.push(value as u8),
            Type::Short => out.extend_from_slice(&(value as u16).to_le_bytes()),
            Type::Int => out.extend_from_slice(&(value as u32).to_le_bytes()),
            Type::Float => out.extend_from_slice(&(value as f32).to_le_bytes()),
        }
    }

    /// Appends a blank and the value of an element in text.
    pub(super) fn push_text(&self, place: usize, out: &mut Vec<u8>) {
        let value = self.values.get(place).copied().unwrap_or_default();
        out.push(b' ');
        match self.kind {
            Type::Float => push_float(out, value as f32),
            _ => push_integer(out, value as u64),
        }
    }
}
