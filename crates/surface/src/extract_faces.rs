//! Copying some faces of a mesh into a mesh of their own.

use halfedge::attribute::Column;
use halfedge::geometry::BitSet;
use halfedge::{Element, FaceId, Mesh, NONE, PolygonSoup, TooLarge};

/// Copies some faces of a mesh, in this order, with all their attributes. Their vertices keep their order; with
/// `keep_isolated` the mesh's isolated vertices are copied too. A vertex at which the faces no longer form one
/// fan becomes several. Costs O(mesh).
///
/// # Errors
/// Never for faces of a valid mesh: they are fewer than there are ids for.
pub fn extract_faces(mesh: &Mesh, faces: &[FaceId], keep_isolated: bool) -> Result<Mesh, TooLarge> {
    let used: BitSet = faces.iter().flat_map(|&f| mesh.face_vertices(f)).map(|v| v.index()).collect();
    let mut kept = Vec::new();
    let mut number = vec![NONE; mesh.vertex_capacity()];
    for v in mesh.vertices() {
        if used.contains(v.index()) || (keep_isolated && mesh.halfedge_from(v).is_none()) {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::join_meshes;
    use glam::{Vec2, Vec3};
    use halfedge::{Color, keys};

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
        let mut all = extract_faces(&mesh, &faces, true).expect("small");
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
        let part = extract_faces(&mesh, &[f], false).expect("small");
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
        let joined = join_meshes([&a, &b]).expect("small");
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
            extract_faces(&joined, &joined.faces().skip(3).collect::<Vec<_>>(), false)
                .expect("small")
                .vertex_count(),
            9
        );
    }

    #[test]
    fn joining_nothing_is_an_empty_mesh() {
        assert_eq!(join_meshes([]).expect("small"), Mesh::new());
    }
}
