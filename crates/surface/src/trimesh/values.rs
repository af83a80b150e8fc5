//! Copying and mixing attribute values in place.

use super::make_room;
use halfedge::attribute::{Column, Values, mix};

pub(super) fn push_copy(column: &mut Column, index: usize) {
    fn push<T: Copy>(values: &mut Vec<T>, index: usize) {
        make_room(values, 1);
        values.push(values[index]);
    }
    match &mut column.values {
        Values::F32(values) => push(values, index),
        Values::Vec2(values) => push(values, index),
        Values::Vec3(values) => push(values, index),
        Values::Color(values) => push(values, index),
        Values::U32(values) => push(values, index),
    }
}

pub(super) fn mix_into(column: &mut Column, to: usize, from: usize, t: f32) {
    if let (Some(a), Some(b)) = (column.values.get(to), column.values.get(from)) {
        column.values.set(to, mix(a, b, t));
    }
}
