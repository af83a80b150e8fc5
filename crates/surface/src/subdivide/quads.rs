//! The quad split: each corner of each face becomes a quad.
//!
//! With V vertices, E edges, F faces and C corners before, and corners numbered in order of face:
//!
//! | child | id |
//! |---|---|
//! | vertex `v` itself; the point of edge `e`; of face `f` | `v`; `V + e`; `V + E + f` |
//! | the half of half-edge `h`'s edge at the vertex `h` leaves | edge `h` |
//! | the edge from the point of corner `c`'s half-edge to the face's | edge `2E + c` |
//! | the quad at corner `c` | face `c` |
//!
//! Half-edge `h` becomes `2h` (from its vertex to the middle) and `2 (h ^ 1) + 1` (from the middle to its
//! end). A quad's first half-edge leaves the old vertex.

use super::{Level, halves};
use crate::SurfaceError;
use crate::pace::Pace;
use glam::DVec3;
use halfedge::RawMesh;

/// The children's links, with the positions of face points (means of the corners); other positions are zero.
pub(super) fn split(level: &Level<'_>, pace: &mut Pace<'_, '_>) -> Result<RawMesh, SurfaceError> {
    let links = level.links;
    let (vertices, edges, faces) = (level.vertices(), level.edges(), level.faces());
    let corners = level.corners();
    let halfedges = 4 * edges + 2 * corners;
    let mut raw = halves::blank(vertices + edges + faces, halfedges, corners);
    let RawMesh { positions, vertex_halfedge, next, prev, to, face, face_halfedge, .. } = &mut raw;
    let (first_edge_point, first_face_point) = (vertices as u32, (vertices + edges) as u32);
    let first_inner = 4 * edges as u32;
    let mut ring: Vec<u32> = Vec::new();
    let mut corner = 0u32;
    pace.part(0.0, 0.8).chunks(faces, |range| {
        for f in range {
            let first = links.face_halfedge[f];
            ring.clear();
            let mut h = first;
            let mut sum = DVec3::ZERO;
            loop {
                ring.push(h);
                sum += level.positions[links.to[h as usize] as usize].as_dvec3();
                h = links.next[h as usize];
                if h == first {
                    break;
                }
            }
            let degree = ring.len() as u32;
            let face_point = first_face_point + f as u32;
            positions[face_point as usize] = (sum / f64::from(degree)).as_vec3();
            // From the last corner's point: prev's half-edge, its end vertex and its inner edge.
            let mut p = ring[ring.len() - 1];
            let mut p_inner = first_inner + 2 * (corner + degree - 1);
            vertex_halfedge[face_point as usize] = first_inner + 2 * corner + 1;
            for (k, &h) in ring.iter().enumerate() {
                let c = corner + k as u32;
                let out = 2 * h;
                let inner = first_inner + 2 * c;
                let back = p_inner + 1;
                let home = 2 * (p ^ 1) + 1;
                let put = |column: &mut [u32], values: [u32; 4]| {
                    column[out as usize] = values[0];
                    column[inner as usize] = values[1];
                    column[back as usize] = values[2];
                    column[home as usize] = values[3];
                };
                put(next, [inner, back, home, out]);
                put(prev, [home, out, inner, back]);
                put(
                    to,
                    [
                        first_edge_point + (h >> 1),
                        face_point,
                        first_edge_point + (p >> 1),
                        links.to[p as usize],
                    ],
                );
                put(face, [c; 4]);
                face_halfedge[c as usize] = out;
                p = h;
                p_inner = inner;
            }
            corner += degree;
        }
    })?;
    halves::finish(&mut raw, level, &mut pace.part(0.8, 0.9))?;
    Ok(raw)
}
