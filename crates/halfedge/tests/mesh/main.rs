//! Building, repairing, traversing, validating and undoing.

mod building;
mod cells;
mod edits;
mod undo;

use glam::{Vec2, Vec3};
use halfedge::attribute::{Column, Value};
use halfedge::edit::{Connect, Triangulation, set_crease, split_edge, triangulate_face};
use halfedge::{
    AddFaceError, Color, EdgeId, Element, FaceId, GivenIds, Mesh, NONE, NoteKind, PolygonSoup, RawMesh, Rule,
    VertexId, keys,
};
use proptest::prelude::*;

fn points(n: u32) -> Vec<Vec3> {
    (0..n).map(|i| Vec3::new(i as f32, (i % 7 * (i % 7) % 7) as f32, (i % 3) as f32)).collect()
}

fn soup(n: u32, faces: &[&[u32]]) -> PolygonSoup {
    PolygonSoup::new(points(n), faces)
}

fn built(n: u32, faces: &[&[u32]]) -> (Mesh, Vec<(NoteKind, usize)>) {
    let built = Mesh::build(soup(n, faces)).expect("small");
    built.mesh.validate().expect("valid");
    (built.mesh, built.notes.iter().map(|note| (note.kind, note.count)).collect())
}

const CUBE: &[&[u32]] =
    &[&[0, 1, 3, 2], &[4, 6, 7, 5], &[0, 4, 5, 1], &[2, 3, 7, 6], &[0, 2, 6, 4], &[1, 5, 7, 3]];

fn corners(mesh: &Mesh, f: u32) -> Vec<u32> {
    mesh.face_vertices(FaceId::new(f as usize)).map(VertexId::raw).collect()
}

/// A grid of quads, some cut into triangles and some missing: boundaries, several pieces, mixed polygons.
fn patchwork() -> impl Strategy<Value = PolygonSoup> {
    (2u32..6, 2u32..6, proptest::collection::vec(0u8..4, 25)).prop_map(|(w, h, kinds)| {
        let mut out = PolygonSoup { positions: points((w + 1) * (h + 1)), ..Default::default() };
        for y in 0..h {
            for x in 0..w {
                let a = y * (w + 1) + x;
                let quad = [a, a + 1, a + w + 2, a + w + 1];
                match kinds[(y * w + x) as usize % kinds.len()] {
                    0 => {}
                    1 => {
                        out.push_face([quad[0], quad[1], quad[2]]);
                        out.push_face([quad[0], quad[2], quad[3]]);
                    }
                    _ => out.push_face(quad),
                }
            }
        }
        let colors = (0..out.face_count()).map(|i| Color([i as u8, 0, 0])).collect();
        out.face_columns.push(Column::with_values(keys::FACE_COLOR, colors));
        let uv = (0..out.corners.len()).map(|i| Vec2::splat(i as f32)).collect();
        out.corner_columns.push(Column::with_values(keys::CORNER_UV, uv));
        out
    })
}
