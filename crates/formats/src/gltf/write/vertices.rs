//! The vertices of a mesh as glTF has them.

use crate::model::srgb::to_linear;
use crate::soup::hash::Unique;
use crate::soup::weld::Weld;
use glam::{Vec2, Vec3};
use halfedge::{Mesh, NONE, keys};

/// Vertices, split where corners of one vertex differ, in the mesh's order.
#[derive(Default)]
pub(super) struct Vertices {
    pub positions: Vec<[f32; 3]>,
    pub normals: Vec<[f32; 3]>,
    pub uvs: Vec<[f32; 2]>,
    pub colors: Vec<[f32; 3]>,
    /// The mesh's vertex that each stands for.
    pub ids: Vec<u32>,
    /// Those in no face.
    pub isolated: Vec<u32>,
    /// For each half-edge of a face the vertex of its corner.
    pub of_corner: Vec<u32>,
}

impl Vertices {
    pub(super) fn new(mesh: &Mesh) -> Self {
        let mut this = Self { of_corner: vec![NONE; mesh.halfedge_capacity()], ..Self::default() };
        let corners = || mesh.halfedges().filter(|&h| !mesh.is_boundary_halfedge(h));
        // glTF has no way to leave a normal out: all corners have one, or none is written.
        let normals = mesh.attribute(keys::CORNER_NORMAL).filter(|normals| {
            corners().all(|h| normals.get(h.index()).is_some_and(|normal| !normal.is_nan()))
        });
        let uvs = mesh
            .attribute(keys::CORNER_UV)
            .filter(|uvs| corners().any(|h| uvs.get(h.index()).is_some_and(|uv| !uv.is_nan())));
        let colors =
            mesh.attribute(keys::VERTEX_COLOR).filter(|colors| colors.iter().any(|color| !color.is_nan()));
        let mut unique = Unique::new();
        for v in mesh.vertices() {
            let mut is_isolated = true;
            // The vertex takes part in the comparison by the bits of its number.
            let id = f32::from_bits(v.raw());
            let push = |this: &mut Self, uv: Vec2, normal: Vec3| {
                this.positions.push(mesh.position(v).to_array());
                this.ids.push(v.raw());
                if normals.is_some() {
                    this.normals.push(normal.to_array());
                }
                if uvs.is_some() {
                    this.uvs.push([uv.x, 1.0 - uv.y]);
                }
                if let Some(color) = colors.and_then(|colors| colors.get(v.index())) {
                    let color = if color.is_nan() { Vec3::ONE } else { *color };
                    this.colors.push(color.to_array().map(to_linear));
                }
            };
            for h in mesh.outgoing(v).filter(|&h| !mesh.is_boundary_halfedge(h)) {
                let uv = uvs
                    .and_then(|uvs| uvs.get(h.index()))
                    .copied()
                    .filter(|uv| !uv.is_nan())
                    .unwrap_or(Vec2::ZERO);
                let normal = normals.and_then(|normals| normals.get(h.index())).copied().unwrap_or_default();
                let (number, new) = unique.number([id, uv.x, uv.y, normal.x, normal.y, normal.z]);
                if new {
                    push(&mut this, uv, normal);
                }
                is_isolated = false;
                if let Some(corner) = this.of_corner.get_mut(h.index()) {
                    *corner = number;
                }
            }
            if is_isolated {
                // Numbers go by what was added, so this takes one too.
                this.isolated.push(unique.number([id, f32::NAN, 0.0, 0.0, 0.0, 0.0]).0);
                push(&mut this, Vec2::ZERO, Vec3::Z);
            }
        }
        this
    }
}

/// Whether two vertices lie at the same place.
pub(super) fn has_coincident(mesh: &Mesh) -> bool {
    let mut places = Weld::new();
    mesh.vertices().for_each(|v| {
        places.vertex(mesh.position(v));
    });
    places.positions.len() < mesh.vertex_count()
}
