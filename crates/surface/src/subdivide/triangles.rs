//! The triangle split: each triangle becomes four.
//!
//! With V vertices, E edges and F triangles before, corner `3f + k` being the `k`-th of face `f`:
//!
//! | child | id |
//! |---|---|
//! | vertex `v` itself; the point of edge `e` | `v`; `V + e` |
//! | the half of half-edge `h`'s edge at the vertex `h` leaves | edge `h` |
//! | the edge that cuts off corner `c` | edge `2E + c` |
//! | the triangle at the `k`-th corner; the middle one | face `4f + k`; `4f + 3` |

use super::{Level, halves};
use crate::SurfaceError;
use crate::pace::Pace;
use halfedge::RawMesh;

/// The half-edges of a triangle in order.
pub(super) fn sides(level: &Level<'_>, face: usize) -> [u32; 3] {
    let a = level.links.face_halfedge[face];
    [a, level.links.next[a as usize], level.links.prev[a as usize]]
}

/// The children's links; all positions are zero.
pub(super) fn split(level: &Level<'_>, pace: &mut Pace<'_, '_>) -> Result<RawMesh, SurfaceError> {
    let links = level.links;
    let (vertices, edges, faces) = (level.vertices(), level.edges(), level.faces());
    let halfedges = 4 * edges + 6 * faces;
    let mut raw = halves::blank(vertices + edges, halfedges, 4 * faces);
    let RawMesh { next, prev, to, face, face_halfedge, .. } = &mut raw;
    let first_edge_point = vertices as u32;
    pace.part(0.0, 0.8).chunks(faces, |range| {
        for f in range {
            let ring = sides(level, f);
            let first_inner = 4 * edges + 6 * f;
            let middle_face = 4 * f as u32 + 3;
            for k in 0..3 {
                let (h, p) = (ring[k], ring[(k + 2) % 3]);
                let out = 2 * h as usize;
                let home = 2 * (p ^ 1) as usize + 1;
                // From h's point to p's, and back inside the middle triangle.
                let cut = first_inner + 2 * k;
                let middle = cut + 1;
                let (h_point, p_point) = (first_edge_point + (h >> 1), first_edge_point + (p >> 1));
                let child = (4 * f + k) as u32;
                next[out] = cut as u32;
                next[cut] = home as u32;
                next[home] = out as u32;
                prev[out] = home as u32;
                prev[cut] = out as u32;
                prev[home] = cut as u32;
                to[out] = h_point;
                to[cut] = p_point;
                to[home] = links.to[p as usize];
                face[out] = child;
                face[cut] = child;
                face[home] = child;
                face_halfedge[child as usize] = out as u32;
                next[middle] = (first_inner + 2 * ((k + 1) % 3) + 1) as u32;
                prev[middle] = (first_inner + 2 * ((k + 2) % 3) + 1) as u32;
                to[middle] = h_point;
                face[middle] = middle_face;
            }
            // Leaves the first side's point, as the first corner's half-edge leaves its vertex.
            face_halfedge[middle_face as usize] = (first_inner + 3) as u32;
        }
    })?;
    halves::finish(&mut raw, level, &mut pace.part(0.8, 0.9))?;
    Ok(raw)
}
