//! Meshes taken apart and put together, with all their attributes.

use glam::{Vec2, Vec3};
use halfedge::attribute::{AttributeType, Column, Columns, Value, Values};
use halfedge::{Color, Element, FaceId, Mesh, NONE, PolygonSoup, RawMesh, TooLarge};
use std::collections::HashMap;

/// The mesh of some faces of another, in this order. Vertices keep their order; those in none of
/// the faces come along only if `loose` says so and they are in no face at all. A vertex at which
/// the faces no longer form one fan becomes several. Costs O(mesh).
///
/// # Errors
/// Never for faces of a valid mesh: they are fewer than there are ids for.
pub(crate) fn extract(mesh: &Mesh, faces: &[FaceId], loose: bool) -> Result<Mesh, TooLarge> {
    let mut used = vec![false; mesh.vertex_capacity()];
    for &f in faces {
        for v in mesh.face_vertices(f) {
            used[v.index()] = true;
        }
    }
    let mut kept = Vec::new();
    let mut number = vec![NONE; mesh.vertex_capacity()];
    for v in mesh.vertices() {
        if used[v.index()] || (loose && mesh.halfedge_from(v).is_none()) {
            number[v.index()] = kept.len() as u32;
            kept.push(v.raw());
        }
    }
    let mut soup = PolygonSoup {
        positions: kept.iter().map(|&v| mesh.positions()[v as usize]).collect(),
        ..PolygonSoup::default()
    };
    let mut corners = Vec::new();
    for &f in faces {
        soup.push_face(mesh.face_vertices(f).map(|v| number[v.index()]));
        corners.extend(mesh.face_halfedges(f).map(|h| h.raw()));
    }
    let columns = mesh.columns();
    let gather = |element, ids: &[u32]| -> Vec<Column> {
        columns.of(element).iter().map(|column| column.gather(ids.iter().copied())).collect()
    };
    soup.vertex_columns = gather(Element::Vertex, &kept);
    soup.corner_columns = gather(Element::Halfedge, &corners);
    let raw_faces: Vec<u32> = faces.iter().map(|f| f.raw()).collect();
    soup.face_columns = gather(Element::Face, &raw_faces);
    let built = Mesh::build(soup)?;
    let mut part = built.mesh;
    if !columns.of(Element::Edge).is_empty() {
        let mut source = vec![NONE; part.edge_capacity()];
        for (f, &from) in part.faces().zip(&built.face_source) {
            let Some(&old) = faces.get(from as usize) else { continue };
            for (h, old) in part.face_halfedges(f).zip(mesh.face_halfedges(old)) {
                source[h.edge().index()] = old.edge().raw();
            }
        }
        for column in columns.of(Element::Edge) {
            part.insert_column(Element::Edge, column.gather(source.iter().copied()));
        }
    }
    Ok(part)
}

/// Several meshes as one, the elements of the first first. Gaps in ids are closed. Columns of the
/// same name become one, and so do labels of the same text. Costs O(result).
pub(crate) fn join<'a>(meshes: impl IntoIterator<Item = &'a Mesh>) -> Result<Mesh, TooLarge> {
    let parts: Vec<RawMesh> = meshes
        .into_iter()
        .map(|mesh| if mesh.is_compact() { mesh.clone() } else { mesh.compacted().0 }.into_raw())
        .collect();
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

/// The values of a labelled column as indices into the joined labels; none for one without labels.
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

#[cfg(test)]
mod tests {
    use super::*;
    use halfedge::keys;

    /// Two quads side by side, a triangle apart, and a vertex in no face.
    fn mesh() -> Mesh {
        let positions = (0..10).map(|i| Vec3::new(i as f32, (i * i) as f32, 0.0)).collect();
        let faces: [&[u32]; 3] = [&[0, 1, 4, 3], &[1, 2, 5, 4], &[6, 7, 8]];
        let mut mesh = Mesh::build(PolygonSoup::new(positions, &faces)).expect("small").mesh;
        mesh.set(keys::FACE_COLOR, 2, Color([1, 2, 3]));
        for e in 0..mesh.edge_capacity() {
            mesh.set(keys::EDGE_CREASE, e, e as f32);
        }
        for h in 0..mesh.halfedge_capacity() {
            mesh.set(keys::CORNER_UV, h, Vec2::splat(h as f32));
        }
        mesh
    }

    #[test]
    fn extracting_everything_gives_an_equal_mesh() {
        let mesh = mesh();
        let faces: Vec<FaceId> = mesh.faces().collect();
        let mut all = extract(&mesh, &faces, true).expect("small");
        all.validate().expect("valid");
        // Corner values of boundary half-edges belong to no corner and don't come along.
        let mut expected = mesh;
        for h in 0..expected.halfedge_capacity() {
            let h = expected.halfedge(h as u32).expect("no gaps");
            if expected.is_boundary_halfedge(h) {
                expected.set(keys::CORNER_UV, h.index(), Vec2::NAN);
                all.set(keys::CORNER_UV, h.index(), Vec2::NAN);
            }
        }
        assert_eq!(all, expected);
    }

    #[test]
    fn extracting_keeps_attributes_of_edges_and_corners() {
        let mesh = mesh();
        let f = FaceId::new(1);
        let part = extract(&mesh, &[f], false).expect("small");
        part.validate().expect("valid");
        assert_eq!((part.vertex_count(), part.edge_count(), part.face_count()), (4, 4, 1));
        for (h, old) in part.face_halfedges(FaceId::new(0)).zip(mesh.face_halfedges(f)) {
            assert_eq!(part.position(part.from(h)), mesh.position(mesh.from(old)));
            assert_eq!(part.get(keys::EDGE_CREASE, h.edge().index()), old.edge().raw() as f32);
            assert_eq!(part.get(keys::CORNER_UV, h.index()), Vec2::splat(old.raw() as f32));
        }
    }

    #[test]
    fn joining_adds_up_and_merges_labels() {
        let mut a = mesh();
        let mut b = mesh();
        for (mesh, names, value) in [(&mut a, ["wood", "iron"], 1), (&mut b, ["iron", "glass"], 0)] {
            let mut column = Column::with_values(keys::FACE_MATERIAL, vec![value; 3]);
            column.labels = names.map(str::to_owned).to_vec();
            mesh.insert_column(Element::Face, column);
        }
        b.set(keys::VERTEX_CREASE, 3, 2.0);
        let joined = join([&a, &b]).expect("small");
        joined.validate().expect("valid");
        assert_eq!(joined.vertex_count(), 20);
        assert_eq!(joined.face_count(), 6);
        assert_eq!(joined.get(keys::FACE_COLOR, 5), Color([1, 2, 3]));
        assert_eq!(joined.get(keys::VERTEX_CREASE, 13), 2.0);
        assert_eq!(joined.get(keys::VERTEX_CREASE, 3), 0.0);
        let column = joined.column(Element::Face, "material").expect("joined");
        assert_eq!(column.labels, ["wood", "iron", "glass"]);
        assert_eq!(joined.attribute(keys::FACE_MATERIAL).expect("joined"), [1; 6]);
        assert_eq!(
            extract(&joined, &joined.faces().skip(3).collect::<Vec<_>>(), false)
                .expect("small")
                .vertex_count(),
            9
        );
    }

    #[test]
    fn joining_nothing_is_an_empty_mesh() {
        assert_eq!(join([]).expect("small"), Mesh::new());
    }
}
