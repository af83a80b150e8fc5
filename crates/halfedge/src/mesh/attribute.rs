//! Typed columns of values beside the connectivity: colours, texture coordinates, creases, groups.
//!
//! A mesh has any number of named columns per kind of element, each as long as there are ids of
//! that kind. The kernel knows nothing of what they mean; it keeps them as long as their element
//! kind, fills new entries, records their changes for undo, and carries them through compaction.
//!
//! A half-edge column holds *corner* values: the value at half-edge `h` belongs to the corner of
//! `h`'s face at the vertex `h` leaves from.

use crate::Element;
use glam::{Vec2, Vec3};

/// An sRGB colour with eight bits a channel.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Color(pub [u8; 3]);

impl Color {
    /// The colour of a face that was never given one.
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

/// One value of a column.
#[derive(Clone, Copy, Debug)]
pub enum Value {
    /// A number, such as a sharpness.
    F32(f32),
    /// A texture coordinate.
    Vec2(Vec2),
    /// A direction or a colour in floats.
    Vec3(Vec3),
    /// A colour.
    Color(Color),
    /// A whole number, or the index of a label.
    U32(u32),
}

impl Value {
    /// Whether two values are of one type and equal. A missing one (NaN) equals none.
    pub(crate) fn same(self, other: Self) -> bool {
        match (self, other) {
            (Self::F32(a), Self::F32(b)) => a == b,
            (Self::Vec2(a), Self::Vec2(b)) => a == b,
            (Self::Vec3(a), Self::Vec3(b)) => a == b,
            (Self::Color(a), Self::Color(b)) => a == b,
            (Self::U32(a), Self::U32(b)) => a == b,
            _ => false,
        }
    }

    /// Whether two values are of one type and equal to the bit, so that a missing one equals itself.
    pub(crate) fn is_identical(self, other: Self) -> bool {
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

impl Values {
    /// How many values there are.
    pub fn len(&self) -> usize {
        each!(self, column => column.len())
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The value at `index`, if there is one.
    pub fn get(&self, index: usize) -> Option<Value> {
        Some(match self {
            Self::F32(column) => Value::F32(*column.get(index)?),
            Self::Vec2(column) => Value::Vec2(*column.get(index)?),
            Self::Vec3(column) => Value::Vec3(*column.get(index)?),
            Self::Color(column) => Value::Color(*column.get(index)?),
            Self::U32(column) => Value::U32(*column.get(index)?),
        })
    }

    /// Puts `value` at `index`; a value of another type or an index past the end changes nothing.
    pub(crate) fn set(&mut self, index: usize, value: Value) {
        fn put<T>(column: &mut [T], index: usize, value: T) {
            if let Some(slot) = column.get_mut(index) {
                *slot = value;
            }
        }
        match (self, value) {
            (Self::F32(column), Value::F32(v)) => put(column, index, v),
            (Self::Vec2(column), Value::Vec2(v)) => put(column, index, v),
            (Self::Vec3(column), Value::Vec3(v)) => put(column, index, v),
            (Self::Color(column), Value::Color(v)) => put(column, index, v),
            (Self::U32(column), Value::U32(v)) => put(column, index, v),
            _ => debug_assert!(false, "a value of another type"),
        }
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

    /// Makes the column `len` long, filling with `value`.
    pub(crate) fn resize(&mut self, len: usize, value: Value) {
        match (self, value) {
            (Self::F32(column), Value::F32(v)) => column.resize(len, v),
            (Self::Vec2(column), Value::Vec2(v)) => column.resize(len, v),
            (Self::Vec3(column), Value::Vec3(v)) => column.resize(len, v),
            (Self::Color(column), Value::Color(v)) => column.resize(len, v),
            (Self::U32(column), Value::U32(v)) => column.resize(len, v),
            _ => debug_assert!(false, "a value of another type"),
        }
    }

    /// The column made of `self[index]` for each index; [`NONE`](crate::NONE) and indices past the
    /// end give `default`. This is how whole-mesh operations carry attributes to their result.
    pub fn gather(&self, indices: impl Iterator<Item = u32>, default: Value) -> Self {
        fn pick<T: Copy>(column: &[T], indices: impl Iterator<Item = u32>, default: T) -> Vec<T> {
            indices.map(|i| column.get(i as usize).copied().unwrap_or(default)).collect()
        }
        match (self, default) {
            (Self::F32(column), Value::F32(d)) => Self::F32(pick(column, indices, d)),
            (Self::Vec2(column), Value::Vec2(d)) => Self::Vec2(pick(column, indices, d)),
            (Self::Vec3(column), Value::Vec3(d)) => Self::Vec3(pick(column, indices, d)),
            (Self::Color(column), Value::Color(d)) => Self::Color(pick(column, indices, d)),
            (Self::U32(column), Value::U32(d)) => Self::U32(pick(column, indices, d)),
            (other, _) => {
                debug_assert!(false, "a default of another type");
                other.clone()
            }
        }
    }

    /// Heap bytes in use.
    pub fn bytes(&self) -> usize {
        each!(self, column => std::mem::size_of_val(column.as_slice()))
    }

    /// Equal to the bit, so that a "no value" NaN equals itself.
    fn same(&self, other: &Self) -> bool {
        fn bits<T: bytemuck::NoUninit>(a: &[T], b: &[T]) -> bool {
            bytemuck::cast_slice::<T, u8>(a) == bytemuck::cast_slice::<T, u8>(b)
        }
        match (self, other) {
            (Self::F32(a), Self::F32(b)) => bits(a, b),
            (Self::Vec2(a), Self::Vec2(b)) => bits(a, b),
            (Self::Vec3(a), Self::Vec3(b)) => bits(a, b),
            (Self::Color(a), Self::Color(b)) => a == b,
            (Self::U32(a), Self::U32(b)) => a == b,
            _ => false,
        }
    }
}

/// A type that columns can hold.
pub trait AttributeType: Copy + 'static {
    /// The column's values, if they are of this type.
    fn slice(values: &Values) -> Option<&[Self]>;
    /// The column's values for writing, if they are of this type.
    fn slice_mut(values: &mut Values) -> Option<&mut [Self]>;
    /// The value with its type as a tag.
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

/// The name of a column with the element it is on, its type, and what an element has that was
/// never given a value.
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

/// The columns that Meshwright's own code uses.
pub mod keys {
    use super::{Color, Key};
    use crate::Element;
    use glam::{Vec2, Vec3};

    /// The painted colour of a face.
    pub const FACE_COLOR: Key<Color> = Key::new(Element::Face, "color", Color::UNPAINTED);
    /// The material of a face: an index into the column's labels.
    pub const FACE_MATERIAL: Key<u32> = Key::new(Element::Face, "material", crate::NONE);
    /// The group (`g` or `o` in an OBJ) of a face: an index into the column's labels.
    pub const FACE_GROUP: Key<u32> = Key::new(Element::Face, "group", crate::NONE);
    /// The smoothing group (`s` in an OBJ) of a face; 0 is "off".
    pub const FACE_SMOOTHING: Key<u32> = Key::new(Element::Face, "smoothing", 0);
    /// The texture coordinate of a corner; NaN where there is none.
    pub const CORNER_UV: Key<Vec2> = Key::new(Element::Halfedge, "uv", Vec2::NAN);
    /// The normal given for a corner by the file; NaN where there is none.
    pub const CORNER_NORMAL: Key<Vec3> = Key::new(Element::Halfedge, "normal", Vec3::NAN);
    /// The colour given for a vertex by the file.
    pub const VERTEX_COLOR: Key<Vec3> = Key::new(Element::Vertex, "color", Vec3::NAN);
    /// The sharpness of an edge, for semi-sharp creases: 0 is smooth, 10 or more infinitely sharp.
    pub const EDGE_CREASE: Key<f32> = Key::new(Element::Edge, "crease", 0.0);
    /// The sharpness of a vertex, for semi-sharp corners.
    pub const VERTEX_CREASE: Key<f32> = Key::new(Element::Vertex, "crease", 0.0);
}

/// A named column: values, what a new element gets, and names for whole numbers that stand for
/// something (materials, groups).
#[derive(Clone, Debug)]
pub struct Column {
    /// The column's name, unique per kind of element.
    pub name: String,
    /// One value for each id.
    pub values: Values,
    /// What an element that was never given a value has.
    pub default: Value,
    /// For a column of indices: what they stand for.
    pub labels: Vec<String>,
}

impl Column {
    /// A column with no values yet.
    pub fn new<T: AttributeType>(key: Key<T>) -> Self {
        Self::with_values(key, Vec::new())
    }

    /// A column with these values.
    pub fn with_values<T: AttributeType>(key: Key<T>, values: Vec<T>) -> Self {
        Self {
            name: key.name.to_owned(),
            values: T::values(values),
            default: key.default.value(),
            labels: Vec::new(),
        }
    }

    /// A column like it with the values of these indices, as [`Values::gather`] finds them.
    pub fn gather(&self, indices: impl Iterator<Item = u32>) -> Self {
        Self {
            name: self.name.clone(),
            values: self.values.gather(indices, self.default),
            default: self.default,
            labels: self.labels.clone(),
        }
    }

    /// Heap bytes in use.
    pub fn bytes(&self) -> usize {
        self.values.bytes() + self.labels.iter().map(|l| l.len() + size_of::<String>()).sum::<usize>()
    }
}

impl PartialEq for Column {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name && self.labels == other.labels && self.values.same(&other.values)
    }
}

/// All columns of a mesh, per kind of element.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Columns {
    vertex: Vec<Column>,
    halfedge: Vec<Column>,
    edge: Vec<Column>,
    face: Vec<Column>,
}

impl Columns {
    /// The columns of one kind of element.
    pub fn of(&self, element: Element) -> &[Column] {
        match element {
            Element::Vertex => &self.vertex,
            Element::Halfedge => &self.halfedge,
            Element::Edge => &self.edge,
            Element::Face => &self.face,
        }
    }

    /// The columns of one kind of element, for writing.
    pub fn of_mut(&mut self, element: Element) -> &mut Vec<Column> {
        match element {
            Element::Vertex => &mut self.vertex,
            Element::Halfedge => &mut self.halfedge,
            Element::Edge => &mut self.edge,
            Element::Face => &mut self.face,
        }
    }

    /// Where the column with this name is among its element's.
    pub fn position(&self, element: Element, name: &str) -> Option<usize> {
        self.of(element).iter().position(|column| column.name == name)
    }

    /// Heap bytes in use.
    pub fn bytes(&self) -> usize {
        Element::ALL.iter().flat_map(|&e| self.of(e)).map(Column::bytes).sum()
    }
}

/// The value between two of one column: floats and colours are mixed linearly, whole numbers are
/// taken from the nearer end (the first at the middle). A missing (NaN) end gives the other one.
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
