//! Borders between faces with different attributes, and creases.

use super::TriMesh;
use halfedge::{Color, Mesh, keys};

/// The attributes whose borders simplification and remeshing keep.
pub(crate) struct Borders<'a> {
    material: Option<&'a [u32]>,
    group: Option<&'a [u32]>,
    color: Option<&'a [Color]>,
    crease: Option<&'a [f32]>,
}

impl<'a> Borders<'a> {
    /// Those of a mesh.
    pub fn new(mesh: &'a Mesh) -> Self {
        Self {
            material: mesh.attribute(keys::FACE_MATERIAL),
            group: mesh.attribute(keys::FACE_GROUP),
            color: mesh.attribute(keys::FACE_COLOR),
            crease: mesh.attribute(keys::EDGE_CREASE),
        }
    }

    /// Whether an inner edge is creased or separates faces with different materials, groups or colours. `tri` has
    /// the triangles of the mesh with their sources.
    pub fn has(&self, tri: &TriMesh, h: u32) -> bool {
        self.is_creased(tri, h) || self.separates(tri, h)
    }

    fn is_creased(&self, tri: &TriMesh, h: u32) -> bool {
        let sharpness = self.crease.zip(tri.edge_source.get(h as usize));
        sharpness.is_some_and(|(crease, &e)| crease.get(e as usize).is_some_and(|&sharpness| sharpness > 0.0))
    }

    fn separates(&self, tri: &TriMesh, h: u32) -> bool {
        let faces = [h, tri.opp(h)].map(|h| tri.face_source.get(h as usize / 3));
        let [Some(&a), Some(&b)] = faces else { return false };
        let (a, b) = (a as usize, b as usize);
        self.material.is_some_and(|m| m[a] != m[b])
            || self.group.is_some_and(|g| g[a] != g[b])
            || self.color.is_some_and(|c| c[a] != c[b])
    }
}
