//! Loop cut: new edges along the ring of quads through an edge.
//!
//! From the edge the ring goes on across each quad to the opposite edge, both ways, until it comes
//! round (a closed ring) or reaches the boundary or a face that is no quad (an open one; such a
//! face gains corners where the ring ends). Each edge is in one ring, and passed once: two opposite
//! edges of a quad are each other's only continuation. A quad can be passed twice, along and
//! across, where the ring crosses itself: it becomes a grid.
//!
//! Always possible if the edge is beside a quad: new vertices lie on the ring's edges, which both
//! faces beside them share, and new edges join new vertices within one quad.

use crate::edit::patch::{Blend, Corner, Patch, Plan, plan};
use crate::edit::{Made, Refusal};
use crate::mesh::Mesh;
use crate::{EdgeId, FaceId, HalfedgeId, VertexId};
use rustc_hash::FxHashMap;

/// The most cuts at once.
const MOST: u32 = 1000;

/// Whether [`loop_cut`] would succeed.
pub fn can_loop_cut(mesh: &Mesh, edge: EdgeId, cuts: u32, t: f32) -> Result<(), Refusal> {
    plan_cut(mesh, edge, cuts, t).map(drop)
}

/// The ring of quads through an edge, as one half-edge of each of its edges, all pointing the same
/// way; and whether it is closed. One edge alone where no quad is beside it. What a preview draws.
pub fn edge_ring(mesh: &Mesh, edge: EdgeId) -> (Vec<HalfedgeId>, bool) {
    // The half-edge across the quad at `h`, pointing the same way.
    let across = |h: HalfedgeId| {
        mesh.face_of(h)?;
        let opposite = mesh.next(mesh.next(h));
        (mesh.next(mesh.next(opposite)) == h && opposite != h).then(|| opposite.twin())
    };
    let [start, back] = edge.halfedges();
    let mut ahead = vec![start];
    let mut at = start;
    while let Some(next) = across(at) {
        if next == start {
            return (ahead, true);
        }
        ahead.push(next);
        at = next;
    }
    let mut behind = Vec::new();
    at = back;
    while let Some(next) = across(at) {
        behind.push(next.twin());
        at = next;
    }
    behind.reverse();
    behind.extend(ahead);
    (behind, false)
}

/// The new vertices on a half-edge in its direction, each with how far along it is.
type Points = FxHashMap<HalfedgeId, Vec<(VertexId, f32)>>;

fn plan_cut(mesh: &Mesh, edge: EdgeId, cuts: u32, t: f32) -> Result<Plan, Refusal> {
    mesh.need_edge(edge)?;
    if !(1..=MOST).contains(&cuts) {
        return Err(Refusal::OutOfRange { field: "cuts", value: cuts as f32, range: "from 1 to 1000" });
    }
    if !(t > 0.0 && t < 1.0) {
        return Err(Refusal::OutOfRange { field: "t", value: t, range: "between 0 and 1" });
    }
    let (ring, _) = edge_ring(mesh, edge);
    if ring.len() < 2 {
        return Err(Refusal::NoRing(edge));
    }
    let mut patch = Patch::new(mesh);
    let mut points = Points::default();
    let mut faces: Vec<FaceId> = Vec::new();
    for &h in &ring {
        let (a, b) = (mesh.from(h), mesh.to(h));
        let on: Vec<(VertexId, f32)> = (1..=cuts)
            .map(|i| {
                let at = place(i as f32 / (cuts + 1) as f32, t);
                let position = mesh.position(a).lerp(mesh.position(b), at);
                (patch.add_vertex(position, Blend::Mix(a.raw(), b.raw(), at)), at)
            })
            .collect();
        points.insert(h.twin(), on.iter().rev().map(|&(v, at)| (v, 1.0 - at)).collect());
        points.insert(h, on);
        faces.extend([h, h.twin()].into_iter().filter_map(|h| mesh.face_of(h)));
    }
    faces.sort_unstable();
    faces.dedup();
    for face in faces {
        let sides: Vec<HalfedgeId> = mesh.face_halfedges(face).collect();
        match *sides.as_slice() {
            [a, b, c, d] if points.contains_key(&a) => {
                cut_quad(mesh, &mut patch, &points, face, [a, b, c, d])
            }
            [a, b, c, d] => cut_quad(mesh, &mut patch, &points, face, [b, c, d, a]),
            _ => end_of_ring(&mut patch, mesh, &points, face, &sides),
        }
    }
    plan(mesh, patch)
}

/// Where a place in an even spacing goes when its middle goes to `t`.
fn place(even: f32, t: f32) -> f32 {
    if even <= 0.5 { 2.0 * t * even } else { t + (2.0 * even - 1.0) * (1.0 - t) }
}

/// Cuts a quad along its first and third side, and its second and fourth if they are cut too.
fn cut_quad(mesh: &Mesh, patch: &mut Patch, points: &Points, face: FaceId, sides: [HalfedgeId; 4]) {
    let [a, b, c, d] = sides;
    let line = |from: VertexId, h: HalfedgeId, reversed: bool, to: VertexId| {
        let on = points.get(&h).map(Vec::as_slice).unwrap_or_default();
        let mut line = vec![(from, 0.0)];
        if reversed {
            line.extend(on.iter().rev().map(|&(v, at)| (v, 1.0 - at)));
        } else {
            line.extend(on);
        }
        line.push((to, 1.0));
        line
    };
    let [va, vb, vc, vd] = sides.map(|h| mesh.from(h));
    // Columns go along the first side, rows from it to the third.
    let near = line(va, a, false, vb);
    let far = line(vd, c, true, vc);
    let left = line(va, d, true, vd);
    let right = line(vb, b, false, vc);
    let (columns, rows) = (near.len(), left.len());
    let corner_weights = |s: f32, t: f32| {
        let weights = [(1.0 - s) * (1.0 - t), s * (1.0 - t), s * t, (1.0 - s) * t];
        move |ids: [u32; 4]| {
            Blend::Weighted(ids.into_iter().zip(weights).filter(|&(_, weight)| weight > 0.0).collect())
        }
    };
    let mut grid = Vec::with_capacity(columns * rows);
    for row in 0..rows {
        for column in 0..columns {
            let (s, t) = (near[column].1, left[row].1);
            let vertex = if row == 0 {
                near[column].0
            } else if row == rows - 1 {
                far[column].0
            } else if column == 0 {
                left[row].0
            } else if column == columns - 1 {
                right[row].0
            } else {
                let [pa, pb, pc, pd] = [va, vb, vc, vd].map(|v| mesh.position(v));
                let position = pa.lerp(pb, s).lerp(pd.lerp(pc, s), t);
                patch.add_vertex(position, corner_weights(s, t)([va, vb, vc, vd].map(VertexId::raw)))
            };
            let value = corner_weights(s, t)(sides.map(HalfedgeId::raw));
            grid.push(Corner { vertex, value, like: None });
        }
    }
    for row in 0..rows - 1 {
        for column in 0..columns - 1 {
            let at = |row: usize, column: usize, on_rim: bool, like: HalfedgeId| {
                let mut corner = grid[row * columns + column].clone();
                corner.like = Some(like).filter(|_| on_rim);
                corner
            };
            let corners = vec![
                at(row, column, row == 0, a),
                at(row, column + 1, column + 2 == columns, b),
                at(row + 1, column + 1, row + 2 == rows, c),
                at(row + 1, column, column == 0, d),
            ];
            if row == 0 && column == 0 {
                patch.replace_face(face, corners, false);
            } else {
                patch.add_face(Some(face), corners);
            }
        }
    }
}

/// Gives a face that is no quad the corners where the ring ends.
fn end_of_ring(patch: &mut Patch, mesh: &Mesh, points: &Points, face: FaceId, sides: &[HalfedgeId]) {
    let mut corners = Vec::new();
    for &h in sides {
        corners.push(Corner::keep(mesh, h));
        for &(vertex, at) in points.get(&h).map(Vec::as_slice).unwrap_or_default() {
            let value = Blend::Mix(h.raw(), mesh.next(h).raw(), at);
            corners.push(Corner { vertex, value, like: Some(h) });
        }
    }
    patch.replace_face(face, corners, false);
}

/// Cuts the ring of quads through an edge, `cuts` times: evenly where `t` is one half; else the
/// middle of the cuts is at the fraction `t` of the way along the edge's even half-edge, and the
/// spacing on either side of it is even.
///
/// Costs O(quads of the ring * cuts + valences of their vertices), times cuts again for quads that
/// the ring passes twice. Attributes: new vertices and corners are interpolated, pieces of an edge
/// copy it (one keeps its id), pieces of a face copy it (one keeps its id), cuts have default values.
pub fn loop_cut(mesh: &mut Mesh, edge: EdgeId, cuts: u32, t: f32) -> Result<Made, Refusal> {
    Ok(plan_cut(mesh, edge, cuts, t)?.apply(mesh))
}
