//! Cutting the polygons of a mesh so that the triangles form a mesh, too.

use super::PolygonTriangulator;
use crate::{FaceId, HalfedgeId, Mesh};
use rustc_hash::FxHashSet;

/// Cuts the faces of a mesh into triangles, one face after the other, for files that hold triangles only.
///
/// The triangles are those of [`PolygonTriangulator`], except where such a cut would join vertices that an edge or an
/// earlier cut joins already: three triangles would meet there, or two would be the same. Those polygons are cut in
/// another way, if there is one.
#[derive(Clone, Debug)]
pub struct MeshTriangulator<'a> {
    mesh: &'a Mesh,
    triangulator: PolygonTriangulator,
    /// The vertices that cuts have joined so far, the smaller id first.
    cuts: FxHashSet<[u32; 2]>,
    conflicts: usize,
}

impl<'a> MeshTriangulator<'a> {
    /// A triangulator of the faces of this mesh.
    pub fn new(mesh: &'a Mesh) -> Self {
        Self { mesh, triangulator: PolygonTriangulator::new(), cuts: FxHashSet::default(), conflicts: 0 }
    }

    /// The triangles of a face, which is asked for once: three half-edges each, which leave the triangle's corners. Costs
    /// as much as [`PolygonTriangulator::triangulate_face`], and O(valence) for each cut.
    pub fn triangulate_face(&mut self, face: FaceId) -> &[[HalfedgeId; 3]] {
        let Self { mesh, triangulator, cuts, conflicts } = self;
        let joins = |a: HalfedgeId, b: HalfedgeId| {
            let [a, b] = [mesh.from(a), mesh.from(b)];
            ([a.raw().min(b.raw()), a.raw().max(b.raw())], mesh.find_halfedge_between(a, b).is_some())
        };
        if !triangulator.triangulate_face_with(mesh, face, |a, b| {
            let (cut, is_edge) = joins(a, b);
            !is_edge && !cuts.contains(&cut)
        }) {
            *conflicts += 1;
            triangulator.triangulate_face(mesh, face);
        }
        if triangulator.side_triangles.len() > 1 {
            for &[a, b, c] in &triangulator.side_triangles {
                for (a, b) in [(a, b), (b, c), (c, a)] {
                    let (cut, is_edge) = joins(a, b);
                    if !is_edge {
                        cuts.insert(cut);
                    }
                }
            }
        }
        &triangulator.side_triangles
    }

    /// The number of faces so far for which no way was found: their triangles don't form a mesh with the others.
    pub fn conflicts(&self) -> usize {
        self.conflicts
    }
}
