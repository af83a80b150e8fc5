//! Named columns.

use super::{AttributeType, Key, Value, Values};
use crate::Element;

/// A named column of values.
#[derive(Clone, Debug)]
pub struct Column {
    /// The column's name, unique for its kind of element.
    pub name: String,
    /// One value for each id.
    pub values: Values,
    /// The value of elements that were never given one.
    pub default: Value,
    /// For a column of indices, such as materials and groups: the names that they stand for.
    pub labels: Vec<String>,
}

impl Column {
    /// A column without values.
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

    /// A column like this one with the values at these indices; see [`Values::gather`].
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
        self.name == other.name && self.labels == other.labels && self.values == other.values
    }
}

/// All columns of a mesh, by kind of element.
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

    /// The index of the column with this name among its element's.
    pub fn position(&self, element: Element, name: &str) -> Option<usize> {
        self.of(element).iter().position(|column| column.name == name)
    }

    /// Heap bytes in use.
    pub fn bytes(&self) -> usize {
        Element::ALL.iter().flat_map(|&e| self.of(e)).map(Column::bytes).sum()
    }
}
