//! Blending attribute values.

use crate::Element;
use crate::attribute::{Column, Value, keys, mix};
use crate::mesh::Mesh;

/// The elements of the same kind that an element gets its attribute values from, as they were before the edit.
#[derive(Clone, Debug)]
pub(crate) enum Blend {
    /// All of one.
    Copy(u32),
    /// Between two.
    Mix(u32, u32, f32),
    /// The mean of several.
    Mean(Vec<u32>),
    /// The mean of several by weights above zero.
    Weighted(Vec<(u32, f32)>),
}

impl Blend {
    /// The value of a column; none if the column is too short. Equal values give that value to the bit, and normals are
    /// normalized.
    pub(crate) fn of(&self, column: &Column) -> Option<Value> {
        match self {
            Self::Copy(a) => column.values.get(*a as usize),
            Self::Mix(a, b, t) => {
                let [a, b] = [a, b].map(|id| column.values.get(*id as usize));
                Some(between(column, a?, b?, *t))
            }
            Self::Mean(all) => mean(column, all.iter().map(|&id| (id, 1.0))),
            Self::Weighted(all) => mean(column, all.iter().copied()),
        }
    }
}

/// Interpolates between two values of a column.
pub(crate) fn between(column: &Column, a: Value, b: Value, t: f32) -> Value {
    if a.is_identical(b) { a } else { normalize_if_normal(column, mix(a, b, t)) }
}

fn mean(column: &Column, mut all: impl Iterator<Item = (u32, f32)>) -> Option<Value> {
    let (id, mut weight) = all.next()?;
    let first = column.values.get(id as usize)?;
    let (mut sum, mut is_blend) = (first, false);
    for (id, more) in all {
        let value = column.values.get(id as usize)?;
        weight += more;
        if is_blend || !value.is_identical(first) {
            sum = mix(sum, value, more / weight);
            is_blend = true;
        }
    }
    Some(if is_blend { normalize_if_normal(column, sum) } else { first })
}

/// Normalizes normals: one between others is shorter than they are.
pub(crate) fn normalize_if_normal(column: &Column, value: Value) -> Value {
    match value {
        Value::Vec3(normal) if column.name == keys::CORNER_NORMAL.name => {
            Value::Vec3(normal.try_normalize().unwrap_or(normal))
        }
        other => other,
    }
}

impl Mesh {
    /// Copies all attribute values from one element to another of its kind.
    pub(crate) fn copy_attributes(&mut self, element: Element, from: u32, to: u32) {
        self.blend_attributes(element, &Blend::Copy(from), to);
    }

    /// Gives an element a blend of the values of others of its kind.
    pub(crate) fn blend_attributes(&mut self, element: Element, blend: &Blend, to: u32) {
        for at in 0..self.columns.of(element).len() {
            if let Some(value) = blend.of(&self.columns.of(element)[at]) {
                self.set_value(element, at, to as usize, value);
            }
        }
    }
}
