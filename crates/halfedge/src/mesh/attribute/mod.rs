//! Attributes: typed columns of values such as colours, texture coordinates, creases and groups.
//!
//! A mesh has any number of named columns for each kind of element, with a value for each id. The kernel
//! doesn't know what they mean; it keeps their length, fills new entries with the default, records changes
//! for undo, and carries values through compaction.
//!
//! A half-edge column holds *corner* values: the value at half-edge `h` belongs to the corner of
//! `h`'s face at the vertex that `h` leaves.

mod column;
pub mod keys;
mod values;

pub use column::{Column, Columns};
pub use values::{AttributeType, Values};

use crate::Element;
use glam::{Vec2, Vec3};

/// An sRGB colour with eight bits per channel.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(transparent)]
pub struct Color(pub [u8; 3]);

impl Color {
    /// The colour of faces that were never painted.
    pub const UNPAINTED: Self = Self([0xc8, 0xc8, 0xc8]);

    /// Reads `#rrggbb`.
    pub fn from_hex(text: &str) -> Option<Self> {
        let digits = text.strip_prefix('#')?;
        if digits.len() != 6 || !digits.bytes().all(|b| b.is_ascii_hexdigit()) {
            return None;
        }
        let value = u32::from_str_radix(digits, 16).ok()?;
        Some(Self([(value >> 16) as u8, (value >> 8) as u8, value as u8]))
    }

    /// Writes `#rrggbb`.
    pub fn to_hex(self) -> String {
        let [r, g, b] = self.0;
        format!("#{r:02x}{g:02x}{b:02x}")
    }
}

/// One value of a column. By `==` a missing value (NaN) equals none; see [`Value::is_identical`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A number, such as a sharpness.
    F32(f32),
    /// A texture coordinate.
    Vec2(Vec2),
    /// A direction, or a colour as floats.
    Vec3(Vec3),
    /// A colour.
    Color(Color),
    /// A whole number, or the index of a label.
    U32(u32),
}

impl Value {
    /// Whether two values have the same type and bits, so that a missing one is identical to itself.
    pub fn is_identical(self, other: Self) -> bool {
        match (self, other) {
            (Self::F32(a), Self::F32(b)) => a.to_bits() == b.to_bits(),
            (Self::Vec2(a), Self::Vec2(b)) => bytemuck::bytes_of(&a) == bytemuck::bytes_of(&b),
            (Self::Vec3(a), Self::Vec3(b)) => bytemuck::bytes_of(&a) == bytemuck::bytes_of(&b),
            (Self::Color(a), Self::Color(b)) => a == b,
            (Self::U32(a), Self::U32(b)) => a == b,
            _ => false,
        }
    }
}

/// The name of a column, its kind of element, its type and its default.
#[derive(Clone, Copy, Debug)]
pub struct Key<T> {
    /// The kind of element.
    pub element: Element,
    /// The column's name.
    pub name: &'static str,
    /// The value of elements that were never given one.
    pub default: T,
}

impl<T> Key<T> {
    /// A key.
    pub const fn new(element: Element, name: &'static str, default: T) -> Self {
        Self { element, name, default }
    }
}

/// Interpolates between two values of a column. Floats and colours are interpolated linearly; whole numbers come
/// from the nearer end, the first at the middle. Where one end is missing (NaN) the other is taken.
pub fn mix(a: Value, b: Value, t: f32) -> Value {
    match (a, b) {
        (Value::F32(x), Value::F32(y)) => Value::F32(x + (y - x) * t),
        (Value::Vec2(x), Value::Vec2(y)) if x.is_nan() || y.is_nan() => {
            Value::Vec2(if x.is_nan() { y } else { x })
        }
        (Value::Vec2(x), Value::Vec2(y)) => Value::Vec2(x.lerp(y, t)),
        (Value::Vec3(x), Value::Vec3(y)) if x.is_nan() || y.is_nan() => {
            Value::Vec3(if x.is_nan() { y } else { x })
        }
        (Value::Vec3(x), Value::Vec3(y)) => Value::Vec3(x.lerp(y, t)),
        (Value::Color(x), Value::Color(y)) => {
            let channel =
                |i: usize| (f32::from(x.0[i]) + (f32::from(y.0[i]) - f32::from(x.0[i])) * t).round() as u8;
            Value::Color(Color([channel(0), channel(1), channel(2)]))
        }
        _ if t <= 0.5 => a,
        _ => b,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_read_and_write_hex() {
        assert_eq!(Color::from_hex("#ff8001"), Some(Color([255, 128, 1])));
        assert_eq!(Color([255, 128, 1]).to_hex(), "#ff8001");
        for bad in ["ff8001", "#ff80", "#ff80zz", "#+f8001", ""] {
            assert_eq!(Color::from_hex(bad), None, "{bad}");
        }
    }

    #[test]
    fn mixing_keeps_the_end_that_has_a_value() {
        let Value::Vec2(v) = mix(Value::Vec2(Vec2::NAN), Value::Vec2(Vec2::ONE), 0.5) else { panic!("type") };
        assert_eq!(v, Vec2::ONE);
        let Value::U32(v) = mix(Value::U32(3), Value::U32(7), 0.6) else { panic!("type") };
        assert_eq!(v, 7);
        let Value::Color(c) = mix(Value::Color(Color([0, 0, 0])), Value::Color(Color([255, 100, 2])), 0.5)
        else {
            panic!("type")
        };
        assert_eq!(c, Color([128, 50, 1]));
    }

    #[test]
    fn columns_with_missing_values_equal_themselves() {
        let column = Column::with_values(keys::CORNER_UV, vec![Vec2::NAN, Vec2::ONE]);
        assert_eq!(column, column.clone());
    }
}
