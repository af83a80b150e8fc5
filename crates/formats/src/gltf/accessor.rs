//! Accessors: how rows of numbers lie in the buffers.

use super::buffers::Buffers;
use super::json::{ACCESSORS, Document, Object};
use super::rows::{Component, Rows, Sparse, Table};
use std::borrow::Cow;

/// The rows of an accessor, as far as the buffer has data for them.
///
/// # Errors
/// When the buffer has none, or the accessor can't be read.
pub(super) fn rows<'b>(document: &Document, buffers: &'b Buffers, index: usize) -> Result<Rows<'b>, String> {
    read(document.item(ACCESSORS, index)?, buffers).map_err(|why| format!("in accessor {index}, {why}"))
}

fn read<'b>(accessor: Object, buffers: &'b Buffers) -> Result<Rows<'b>, String> {
    let width = match accessor.text("type").unwrap_or_default() {
        "SCALAR" => 1,
        "VEC2" => 2,
        "VEC3" => 3,
        "VEC4" => 4,
        "MAT4" => 16,
        _ => return Err("its type is none of SCALAR, VEC2, VEC3, VEC4, MAT4".to_owned()),
    };
    let component = component_of(accessor)?;
    let count = accessor.required_index("count")?;
    let sparse = accessor.object("sparse").map(|sparse| sparse_rows(sparse, component, width, buffers));
    let sparse = sparse.transpose()?;
    let is_normalized = accessor.flag("normalized").unwrap_or(false);
    let mut rows = Rows { table: None, sparse, is_normalized, width, count, missing: 0 };
    if let Some(view) = accessor.index("bufferView")? {
        let table = table(accessor, view, component, width, buffers)?;
        rows.count = table.rows(component.size() * width).min(count);
        rows.missing = count - rows.count;
        if rows.count == 0 && count > 0 {
            return Err("its data lies outside its buffer".to_owned());
        }
        rows.table = Some(table);
    }
    Ok(rows)
}

/// The rows that replace others.
fn sparse_rows<'b>(
    sparse: Object,
    component: Component,
    width: usize,
    buffers: &'b Buffers,
) -> Result<Sparse<'b>, String> {
    let part = |key: &str| sparse.object(key).ok_or_else(|| format!("its sparse \"{key}\" are missing"));
    let indices = part("indices")?;
    let values = part("values")?;
    let index_type = component_of(indices)?;
    let numbers = table(indices, indices.required_index("bufferView")?, index_type, 1, buffers)?;
    let values = table(values, values.required_index("bufferView")?, component, width, buffers)?;
    let count = sparse.required_index("count")?;
    if numbers.rows(index_type.size()) < count || values.rows(component.size() * width) < count {
        return Err("its sparse data lies outside its buffer".to_owned());
    }
    let replaced = (0..count as u32).map(|i| (numbers.number(i as usize, 0, false) as u32, i));
    let mut replaced: Vec<(u32, u32)> = replaced.collect();
    replaced.sort_by_key(|&(row, _)| row);
    Ok(Sparse { replaced, values })
}

fn component_of(object: Object) -> Result<Component, String> {
    let code = object.required_index("componentType")?;
    Component::of(code).ok_or_else(|| format!("its component type {code} is unknown"))
}

/// The numbers in a view, from the `byteOffset` of an accessor or of a part of it.
fn table<'b>(
    object: Object,
    view: usize,
    component: Component,
    width: usize,
    buffers: &'b Buffers,
) -> Result<Table<'b>, String> {
    let view = buffers.view(view)?;
    let row = component.size() * width;
    let stride = view.stride.unwrap_or(row);
    if stride < row {
        return Err("its rows overlap".to_owned());
    }
    let bytes = view.bytes.get(object.index_or("byteOffset", 0)?..).unwrap_or_default();
    Ok(Table { bytes: Cow::Borrowed(bytes), stride, component })
}
