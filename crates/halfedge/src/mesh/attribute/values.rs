//! Columns of values of one type.

use super::{Color, Value};
use glam::{Vec2, Vec3};

/// A whole column of values.
#[derive(Clone, Debug)]
pub enum Values {
    /// Numbers.
    F32(Vec<f32>),
    /// Two-component vectors.
    Vec2(Vec<Vec2>),
    /// Three-component vectors.
    Vec3(Vec<Vec3>),
    /// Colours.
    Color(Vec<Color>),
    /// Whole numbers.
    U32(Vec<u32>),
}

/// Runs `$body` with the column, whatever its type.
macro_rules! each {
    ($values:expr, $column:ident => $body:expr) => {
        match $values {
            Values::F32($column) => $body,
            Values::Vec2($column) => $body,
            Values::Vec3($column) => $body,
            Values::Color($column) => $body,
            Values::U32($column) => $body,
        }
    };
}

/// Runs `$body` with the column and a value of its type, and `$other` where the types differ.
macro_rules! each_with {
    ($values:expr, $value:expr, ($column:ident, $v:ident) => $body:expr, else $other:expr) => {
        match ($values, $value) {
            (Values::F32($column), Value::F32($v)) => $body,
            (Values::Vec2($column), Value::Vec2($v)) => $body,
            (Values::Vec3($column), Value::Vec3($v)) => $body,
            (Values::Color($column), Value::Color($v)) => $body,
            (Values::U32($column), Value::U32($v)) => $body,
            _ => $other,
        }
    };
}

impl Values {
    /// The number of values.
    pub fn len(&self) -> usize {
        each!(self, column => column.len())
    }

    /// Whether there are no values.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The value at `index`, if there is one.
    pub fn get(&self, index: usize) -> Option<Value> {
        each!(self, column => column.get(index).map(|value| value.value()))
    }

    /// Sets the value at `index`. A value of another type and an index past the end change nothing.
    pub fn set(&mut self, index: usize, value: Value) {
        each_with!(self, value, (column, v) => {
            if let Some(slot) = column.get_mut(index) {
                *slot = v;
            }
        }, else debug_assert!(false, "a value of another type"));
    }

    /// An empty column of the type of `value`.
    pub fn empty_like(value: Value) -> Self {
        match value {
            Value::F32(_) => Self::F32(Vec::new()),
            Value::Vec2(_) => Self::Vec2(Vec::new()),
            Value::Vec3(_) => Self::Vec3(Vec::new()),
            Value::Color(_) => Self::Color(Vec::new()),
            Value::U32(_) => Self::U32(Vec::new()),
        }
    }

    /// Makes the column `len` long; new entries get `value`.
    pub(crate) fn resize(&mut self, len: usize, value: Value) {
        each_with!(self, value, (column, v) => column.resize(len, v),
            else debug_assert!(false, "a value of another type"));
    }

    /// The column of `self[index]` for each index; [`NONE`](crate::NONE) and indices past the end give
    /// `default`. Whole-mesh operations carry attributes over to their result this way.
    pub fn gather(&self, indices: impl Iterator<Item = u32>, default: Value) -> Self {
        each_with!(self, default, (column, default) => {
            let pick = |i: u32| column.get(i as usize).copied().unwrap_or(default);
            AttributeType::values(indices.map(pick).collect())
        }, else {
            debug_assert!(false, "a default of another type");
            self.clone()
        })
    }

    /// Heap bytes in use.
    pub fn bytes(&self) -> usize {
        each!(self, column => std::mem::size_of_val(column.as_slice()))
    }
}

impl PartialEq for Values {
    /// Whether all values are the same to the bit, so that a missing one (NaN) equals itself.
    fn eq(&self, other: &Self) -> bool {
        fn same_bits<T: bytemuck::NoUninit>(a: &[T], b: &[T]) -> bool {
            bytemuck::cast_slice::<T, u8>(a) == bytemuck::cast_slice::<T, u8>(b)
        }
        match (self, other) {
            (Self::F32(a), Self::F32(b)) => same_bits(a, b),
            (Self::Vec2(a), Self::Vec2(b)) => same_bits(a, b),
            (Self::Vec3(a), Self::Vec3(b)) => same_bits(a, b),
            (Self::Color(a), Self::Color(b)) => a == b,
            (Self::U32(a), Self::U32(b)) => a == b,
            _ => false,
        }
    }
}

/// A type that columns can hold.
pub trait AttributeType: Copy + 'static {
    /// The values, if they are of this type.
    fn slice(values: &Values) -> Option<&[Self]>;
    /// The values for writing, if they are of this type.
    fn slice_mut(values: &mut Values) -> Option<&mut [Self]>;
    /// The value, tagged with its type.
    fn value(self) -> Value;
    /// A column of these values.
    fn values(column: Vec<Self>) -> Values;
}

macro_rules! attribute_type {
    ($rust:ty, $variant:ident) => {
        impl AttributeType for $rust {
            fn slice(values: &Values) -> Option<&[Self]> {
                match values {
                    Values::$variant(column) => Some(column),
                    _ => None,
                }
            }
            fn slice_mut(values: &mut Values) -> Option<&mut [Self]> {
                match values {
                    Values::$variant(column) => Some(column),
                    _ => None,
                }
            }
            fn value(self) -> Value {
                Value::$variant(self)
            }
            fn values(column: Vec<Self>) -> Values {
                Values::$variant(column)
            }
        }
    };
}

attribute_type!(f32, F32);
attribute_type!(Vec2, Vec2);
attribute_type!(Vec3, Vec3);
attribute_type!(Color, Color);
attribute_type!(u32, U32);
