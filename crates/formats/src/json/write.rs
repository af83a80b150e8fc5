//! Writing the half-edge mesh itself as JSON:
//!
//! `{"positions": [[x,y,z]], "vertices": [halfedge or null], "halfedges": [[next, prev, twin,
//! vertex, edge, face or null]], "edges": [halfedge], "faces": [halfedge]}`. A half-edge's vertex
//! is the one it points to. Ids are places in these lists, after gaps were closed; several objects
//! follow each other as the separate pieces of one mesh.

use crate::file::NamedBytes;
use crate::model::Model;
use crate::text::print::{push_float, push_integer};
use glam::DVec3;
use halfedge::Mesh;
use std::borrow::Cow;

/// Writes the objects as one half-edge mesh.
pub(crate) fn write(model: &Model) -> Vec<NamedBytes> {
    let mut start = Offsets::default();
    let meshes: Vec<(Cow<Mesh>, Offsets)> = model
        .objects
        .iter()
        .map(|object| {
            let mesh = object.mesh.to_compact();
            let offsets = start;
            start.vertex += mesh.vertex_count() as u64;
            start.edge += mesh.edge_count() as u64;
            start.face += mesh.face_count() as u64;
            (mesh, offsets)
        })
        .collect();
    let mut out = Vec::new();
    out.extend_from_slice(b"{\"positions\":");
    let positions = meshes.iter().flat_map(|(mesh, _)| mesh.positions());
    list(&mut out, positions, |out, position| match model.offset {
        DVec3::ZERO => list(out, position.to_array(), push_float),
        offset => list(out, (position.as_dvec3() + offset).to_array(), push_float),
    });
    out.extend_from_slice(b",\"vertices\":");
    let vertices = meshes.iter().flat_map(|(mesh, at)| mesh.vertices().map(move |v| (mesh, at, v)));
    list(&mut out, vertices, |out, (mesh, at, v)| {
        nullable(out, mesh.halfedge_from(v).map(|h| at.halfedge(h.raw())));
    });
    out.extend_from_slice(b",\"halfedges\":");
    let halfedges = meshes.iter().flat_map(|(mesh, at)| mesh.halfedges().map(move |h| (mesh, at, h)));
    list(&mut out, halfedges, |out, (mesh, at, h)| {
        let links = [
            Some(at.halfedge(mesh.next(h).raw())),
            Some(at.halfedge(mesh.prev(h).raw())),
            Some(at.halfedge(h.twin().raw())),
            Some(at.vertex + u64::from(mesh.to(h).raw())),
            Some(at.edge + u64::from(h.edge().raw())),
            mesh.face_of(h).map(|f| at.face + u64::from(f.raw())),
        ];
        list(out, links, nullable);
    });
    out.extend_from_slice(b",\"edges\":");
    let edges =
        meshes.iter().flat_map(|(mesh, at)| mesh.edges().map(move |e| at.halfedge(e.halfedge().raw())));
    list(&mut out, edges, push_integer);
    out.extend_from_slice(b",\"faces\":");
    let faces = meshes
        .iter()
        .flat_map(|(mesh, at)| mesh.faces().map(move |f| at.halfedge(mesh.halfedge_of(f).raw())));
    list(&mut out, faces, push_integer);
    out.extend_from_slice(b"}\n");
    vec![NamedBytes { name: format!("{}.json", model.name), bytes: out }]
}

/// How many elements earlier objects have.
#[derive(Clone, Copy, Default)]
struct Offsets {
    vertex: u64,
    edge: u64,
    face: u64,
}

impl Offsets {
    fn halfedge(&self, raw: u32) -> u64 {
        self.edge * 2 + u64::from(raw)
    }
}

fn list<T>(out: &mut Vec<u8>, items: impl IntoIterator<Item = T>, mut push: impl FnMut(&mut Vec<u8>, T)) {
    out.push(b'[');
    for (i, item) in items.into_iter().enumerate() {
        if i > 0 {
            out.push(b',');
        }
        push(out, item);
    }
    out.push(b']');
}

fn nullable(out: &mut Vec<u8>, value: Option<u64>) {
    match value {
        Some(value) => push_integer(out, value),
        None => out.extend_from_slice(b"null"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::NamedMesh;
    use glam::Vec3;
    use halfedge::PolygonSoup;

    #[test]
    fn two_objects_make_one_mesh_in_pieces() {
        let corners = vec![Vec3::ZERO, Vec3::X, Vec3::new(0.0, 0.5, -0.0), Vec3::Z];
        let mesh = Mesh::build(PolygonSoup::new(corners, &[[0, 1, 2]])).expect("small").mesh;
        let object = NamedMesh::new("a", mesh);
        let files = write(&Model { name: "two".to_owned(), objects: vec![object; 2], ..Model::default() });
        let text = String::from_utf8(files[0].bytes.clone()).expect("ASCII");
        assert_eq!(files[0].name, "two.json");
        let value: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        let lengths = ["positions", "vertices", "halfedges", "edges", "faces"]
            .map(|field| value[field].as_array().map_or(0, Vec::len));
        assert_eq!(lengths, [8, 8, 12, 6, 2]);
        assert_eq!(value["positions"][2][1], 0.5);
        assert_eq!(value["vertices"][3], serde_json::Value::Null);
        assert_eq!(value["faces"], serde_json::json!([0, 6]));
        let halfedges = value["halfedges"].as_array().expect("a list");
        for (h, links) in halfedges.iter().enumerate() {
            let link = |i: usize| links[i].as_u64().expect("a number") as usize;
            assert_eq!(halfedges[link(0)][1], h);
            assert_eq!(link(2), h ^ 1);
            assert_eq!(link(4), h / 2);
            assert_eq!(links[5].is_null(), h % 2 == 1);
            assert_eq!(link(0) / 6, h / 6);
        }
        assert_eq!(halfedges[6][3], 5);
    }
}
