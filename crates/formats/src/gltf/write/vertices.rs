//! Splits the vertices of a mesh where their corners differ.

use crate::model::Model;
use crate::model::srgb::to_linear;
use crate::soup::hash::Unique;
use crate::soup::weld::Weld;
use glam::{Vec2, Vec3};
use halfedge::words::counted;
use halfedge::{Mesh, NONE, keys};

/// The vertices to write, in the mesh's order.
#[derive(Default)]
pub(super) struct Vertices {
    pub positions: Vec<[f32; 3]>,
    pub normals: Vec<[f32; 3]>,
    pub uvs: Vec<[f32; 2]>,
    pub colors: Vec<[f32; 3]>,
    /// The mesh's vertex that each comes from.
    pub ids: Vec<u32>,
    /// The vertices in no face.
    pub isolated: Vec<u32>,
    /// For each half-edge of a face the vertex at its corner.
    pub of_corner: Vec<u32>,
}

impl Vertices {
    pub(super) fn new(mesh: &Mesh) -> Self {
        let mut this = Self { of_corner: vec![NONE; mesh.halfedge_capacity()], ..Self::default() };
        // All vertices have an attribute, or none has.
        let normals = mesh.attribute(keys::CORNER_NORMAL).filter(|_| {
            let (with, without) = corners_with_normals(mesh);
            with > 0 && without == 0
        });
        let corners = || mesh.halfedges().filter(|&h| !mesh.is_boundary_halfedge(h));
        let uvs = mesh
            .attribute(keys::CORNER_UV)
            .filter(|uvs| corners().any(|h| uvs.get(h.index()).is_some_and(|uv| !uv.is_nan())));
        let colors =
            mesh.attribute(keys::VERTEX_COLOR).filter(|colors| colors.iter().any(|color| !color.is_nan()));
        let mut unique = Unique::new();
        for v in mesh.vertices() {
            let mut is_isolated = true;
            // Vertices are compared by the bits of their numbers.
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
                // A key that no corner has, so that the vertex gets a number of its own.
                this.isolated.push(unique.number([id, f32::NAN, 0.0, 0.0, 0.0, 0.0]).0);
                push(&mut this, Vec2::ZERO, Vec3::Z);
            }
        }
        this
    }
}

/// How many corners have a normal, and how many have none.
fn corners_with_normals(mesh: &Mesh) -> (usize, usize) {
    let corners = || mesh.halfedges().filter(|&h| !mesh.is_boundary_halfedge(h));
    let with = corners().filter(|h| !mesh.get(keys::CORNER_NORMAL, h.index()).is_nan()).count();
    (with, corners().count() - with)
}

/// The loss of normals that only some corners of a mesh have.
pub(super) fn losses(model: &Model) -> Option<String> {
    let lost = model.objects.iter().map(|object| match corners_with_normals(&object.mesh) {
        (_, 0) => 0,
        (with, _) => with,
    });
    let lost: usize = lost.sum();
    (lost > 0).then(|| {
        let corners = counted(lost, "corner", "corners");
        format!("glTF holds normals of all corners of a mesh or of none: those of {corners} are lost")
    })
}

/// Whether several vertices share a position.
pub(super) fn has_coincident(mesh: &Mesh) -> bool {
    let mut places = Weld::new();
    mesh.vertices().for_each(|v| {
        places.vertex(mesh.position(v));
    });
    places.positions.len() < mesh.vertex_count()
}
