//! Joining several meshes into one.

use glam::{Vec2, Vec3};
use halfedge::attribute::{AttributeType, Column, Columns, Value, Values};
use halfedge::{Color, Element, Mesh, NONE, RawMesh, TooLarge};
use std::collections::HashMap;

/// Joins meshes into one, in this order, with all their attributes. The ids of the result have no gaps.
/// Columns of the same name are joined, and so are labels of the same text. Costs O(result).
///
/// # Errors
/// [`TooLarge`] if ids run out.
pub fn join_meshes<'a>(meshes: impl IntoIterator<Item = &'a Mesh>) -> Result<Mesh, TooLarge> {
    let parts: Vec<RawMesh> =
        meshes.into_iter().map(|mesh| mesh.to_compact().into_owned().into_raw()).collect();
    let halfedges: usize = parts.iter().map(|part| part.next.len()).sum();
    let vertices: usize = parts.iter().map(|part| part.positions.len()).sum();
    if halfedges / 2 > Mesh::MAX_EDGES || vertices >= NONE as usize {
        return Err(TooLarge { corners: halfedges });
    }
    let mut joined = RawMesh { columns: join_columns(&parts), ..RawMesh::default() };
    for part in &parts {
        let shift = |column: &[u32], by: usize| {
            let by = by as u32;
            column.iter().map(|&id| if id == NONE { NONE } else { id + by }).collect::<Vec<_>>()
        };
        let (v, h, f) = (joined.positions.len(), joined.next.len(), joined.face_halfedge.len());
        joined.positions.extend(&part.positions);
        joined.vertex_halfedge.extend(shift(&part.vertex_halfedge, h));
        joined.next.extend(shift(&part.next, h));
        joined.prev.extend(shift(&part.prev, h));
        joined.to.extend(shift(&part.to, v));
        joined.face.extend(shift(&part.face, f));
        joined.face_halfedge.extend(shift(&part.face_halfedge, h));
    }
    Ok(Mesh::from_raw(joined))
}

fn join_columns(parts: &[RawMesh]) -> Columns {
    let mut columns = Columns::default();
    for element in Element::ALL {
        let mut names: Vec<&Column> = Vec::new();
        for column in parts.iter().flat_map(|part| part.columns.of(element)) {
            if !names.iter().any(|known| known.name == column.name) {
                names.push(column);
            }
        }
        let joined: Vec<Column> = names
            .into_iter()
            .map(|like| match like.default {
                Value::F32(d) => join_column::<f32>(parts, element, like, d),
                Value::Vec2(d) => join_column::<Vec2>(parts, element, like, d),
                Value::Vec3(d) => join_column::<Vec3>(parts, element, like, d),
                Value::Color(d) => join_column::<Color>(parts, element, like, d),
                Value::U32(d) => join_column::<u32>(parts, element, like, d),
            })
            .collect();
        *columns.of_mut(element) = joined;
    }
    columns
}

fn join_column<T: AttributeType>(parts: &[RawMesh], element: Element, like: &Column, default: T) -> Column {
    let mut labels: Vec<String> = Vec::new();
    let mut places: HashMap<String, u32> = HashMap::new();
    let mut values: Vec<T> = Vec::new();
    for part in parts {
        let len = match element {
            Element::Vertex => part.positions.len(),
            Element::Edge => part.next.len() / 2,
            Element::Halfedge => part.next.len(),
            Element::Face => part.face_halfedge.len(),
        };
        let column = part.columns.of(element).iter().find(|column| column.name == like.name);
        let relabeled = column.and_then(|column| relabel(column, &mut labels, &mut places));
        let own = relabeled.as_ref().or(column.map(|column| &column.values)).and_then(T::slice);
        match own {
            Some(own) => values.extend(own),
            None => values.resize(values.len() + len, default),
        }
    }
    Column { name: like.name.clone(), values: T::values(values), default: like.default, labels }
}

/// The values of a labelled column as indices into the joined labels; none for a column without labels.
fn relabel(column: &Column, labels: &mut Vec<String>, places: &mut HashMap<String, u32>) -> Option<Values> {
    let Values::U32(values) = &column.values else { return None };
    if column.labels.is_empty() {
        return None;
    }
    let map: Vec<u32> = column
        .labels
        .iter()
        .map(|label| {
            *places.entry(label.clone()).or_insert_with(|| {
                labels.push(label.clone());
                labels.len() as u32 - 1
            })
        })
        .collect();
    Some(Values::U32(values.iter().map(|&v| map.get(v as usize).copied().unwrap_or(v)).collect()))
}
