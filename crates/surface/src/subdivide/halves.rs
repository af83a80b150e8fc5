//! The halves of edges, which both splits have in common.

use super::Level;
use crate::SurfaceError;
use crate::pace::Pace;
use glam::Vec3;
use halfedge::{NONE, RawMesh};

/// A mesh of this size whose columns are zero.
pub(super) fn blank(vertices: usize, halfedges: usize, faces: usize) -> RawMesh {
    let halfedge_column = || vec![0u32; halfedges];
    RawMesh {
        positions: vec![Vec3::ZERO; vertices],
        vertex_halfedge: vec![0; vertices],
        next: halfedge_column(),
        prev: halfedge_column(),
        to: halfedge_column(),
        face: halfedge_column(),
        face_halfedge: vec![0; faces],
        ..RawMesh::default()
    }
}

/// Fills in boundary half-edges, and the half-edges of old vertices and edge points.
pub(super) fn finish(
    raw: &mut RawMesh,
    level: &Level<'_>,
    pace: &mut Pace<'_, '_>,
) -> Result<(), SurfaceError> {
    let links = level.links;
    let vertices = level.vertices();
    let RawMesh { vertex_halfedge, next, prev, to, face, .. } = raw;
    pace.chunks(level.edges(), |range| {
        for e in range {
            let even = 2 * e;
            let mut out_of_middle = 2 * even + 3;
            for h in [even, even + 1] {
                if links.face[h] != NONE {
                    continue;
                }
                let (first_half, second_half) = (2 * h, 2 * (h ^ 1) + 1);
                next[first_half] = second_half as u32;
                prev[first_half] = 2 * (links.prev[h] ^ 1) + 1;
                to[first_half] = (vertices + e) as u32;
                face[first_half] = NONE;
                next[second_half] = 2 * links.next[h];
                prev[second_half] = first_half as u32;
                to[second_half] = links.to[h];
                face[second_half] = NONE;
                out_of_middle = second_half;
            }
            vertex_halfedge[vertices + e] = out_of_middle as u32;
        }
    })?;
    for (child, &h) in vertex_halfedge.iter_mut().zip(links.vertex_halfedge) {
        *child = if h == NONE { NONE } else { 2 * h };
    }
    Ok(())
}
