//! Positions and attribute values.

use crate::attribute::{AttributeType, Column, Columns, Key, Value};
use crate::mesh::Mesh;
use crate::mesh::journal::{Change, ColumnPlace};
use crate::{Element, VertexId};
use glam::Vec3;

impl Mesh {
    /// The position of a vertex, in mesh units.
    #[inline]
    pub fn position(&self, v: VertexId) -> Vec3 {
        self.positions[v.index()]
    }

    /// The positions of all vertex ids, with removed ones.
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// Moves a vertex. The position must be finite, which commands check.
    pub fn set_position(&mut self, v: VertexId, position: Vec3) {
        let old = std::mem::replace(&mut self.positions[v.index()], position);
        if bytemuck::bytes_of(&old) != bytemuck::bytes_of(&position) {
            self.record(Change::Position(v.raw(), old));
        }
    }

    /// Moves all vertices at once.
    ///
    /// # Errors
    /// Returns the positions if there aren't as many as [`Mesh::vertex_capacity`].
    pub fn set_positions(&mut self, positions: Vec<Vec3>) -> Result<(), Vec<Vec3>> {
        if positions.len() != self.positions.len() {
            return Err(positions);
        }
        let old = std::mem::replace(&mut self.positions, positions);
        if !same_bits(&old, &self.positions) {
            self.record(Change::Positions(old.into_boxed_slice()));
        }
        Ok(())
    }

    /// All attribute columns.
    pub fn columns(&self) -> &Columns {
        &self.columns
    }

    /// A column's values, one for each id, if the mesh has a column of that name and type.
    pub fn attribute<T: AttributeType>(&self, key: Key<T>) -> Option<&[T]> {
        let at = self.columns.position(key.element, key.name)?;
        T::slice(&self.columns.of(key.element).get(at)?.values)
    }

    /// A value of a column; the key's default if the mesh has no such column.
    pub fn get<T: AttributeType>(&self, key: Key<T>, index: usize) -> T {
        self.attribute(key).and_then(|values| values.get(index)).copied().unwrap_or(key.default)
    }

    /// The column of that name, if there is one.
    pub fn column(&self, element: Element, name: &str) -> Option<&Column> {
        let at = self.columns.position(element, name)?;
        self.columns.of(element).get(at)
    }

    /// Sets a value. A missing column is added, unless the value is the default.
    pub fn set<T: AttributeType>(&mut self, key: Key<T>, index: usize, value: T) {
        let at = match self.columns.position(key.element, key.name) {
            Some(at) => at,
            None if value.value().is_identical(key.default.value()) => return,
            None => self.insert_column(key.element, Column::new(key)),
        };
        self.set_value(key.element, at, index, value.value());
    }

    /// Sets a value in the column with this index among its element's.
    pub fn set_value(&mut self, element: Element, column: usize, index: usize, value: Value) {
        let Some(target) = self.columns.of_mut(element).get_mut(column) else { return };
        let Some(old) = target.values.get(index) else { return };
        if old.is_identical(value) {
            return;
        }
        target.values.set(index, value);
        self.record(Change::Attribute(ColumnPlace::new(element, column), index as u32, old));
    }

    /// Adds a column, or replaces the one of that name, after fitting its length to the element's ids.
    /// Returns its index among the element's columns.
    pub fn insert_column(&mut self, element: Element, mut column: Column) -> usize {
        let blank = column.values.is_empty();
        column.values.resize(self.capacity(element), column.default);
        let old_at = self.columns.position(element, &column.name);
        let columns = self.columns.of_mut(element);
        match old_at {
            Some(at) => {
                if columns[at] == column && columns[at].default.is_identical(column.default) {
                    return at;
                }
                let old = std::mem::replace(&mut columns[at], column);
                self.record(Change::Column(ColumnPlace::new(element, at), Box::new(old)));
                at
            }
            None => {
                columns.push(column);
                let at = columns.len() - 1;
                self.record(Change::ColumnAdded(element, blank));
                at
            }
        }
    }

    /// Undoes the last [`Mesh::add_vertex`], for callers that record nothing.
    pub(crate) fn pop_isolated_vertex(&mut self) {
        self.positions.pop();
        self.vertex_halfedge.pop();
        let len = self.positions.len();
        for column in self.columns.of_mut(Element::Vertex) {
            column.values.resize(len, column.default);
        }
    }
}

pub(crate) fn same_bits(a: &[Vec3], b: &[Vec3]) -> bool {
    bytemuck::cast_slice::<Vec3, u8>(a) == bytemuck::cast_slice::<Vec3, u8>(b)
}
