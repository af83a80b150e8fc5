//! Loop cut: new edges along the ring of quads through an edge.
//!
//! The ring runs from the edge both ways, across each quad to the opposite edge, until it closes or ends at the
//! boundary or at a face that isn't a quad; such a face gains corners there. Each edge lies in one ring, and the ring
//! passes it once: opposite edges of a quad are each other's only continuation. A ring can pass a quad twice, along
//! and across, and cross itself there: the quad becomes a grid.
//!
//! Always possible if a quad lies beside the edge: new vertices lie on edges of the ring, which both faces beside
//! them share, and new edges join new vertices within one quad.

use crate::edit::patch::{Corner, Patch, Plan};
use crate::edit::shared::Blend;
use crate::edit::{Made, Refusal, SPLIT_T_RANGE};
use crate::mesh::Mesh;
use crate::{EdgeId, FaceId, HalfedgeId, NumberRange, VertexId};
use rustc_hash::FxHashMap;

/// Whether [`loop_cut`] would succeed.
pub fn can_loop_cut(mesh: &Mesh, edge: EdgeId, cuts: u32, t: f32) -> Result<(), Refusal> {
    plan_cut(mesh, edge, cuts, t).map(drop)
}

/// The ring of quads through an edge, which previews draw: one half-edge of each of its edges, all pointing the same
/// way, and whether it is closed. The edge alone if no quad lies beside it. Costs O(edges of the ring).
pub fn edge_ring(mesh: &Mesh, edge: EdgeId) -> (Vec<HalfedgeId>, bool) {
    // The half-edge on the other side of the quad, pointing the same way.
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

/// The numbers of cuts at once.
pub const LOOP_CUTS_RANGE: NumberRange = NumberRange::counts(1, 1000);

/// A new vertex on an edge of the ring.
#[derive(Clone, Copy)]
struct Point {
    vertex: VertexId,
    /// The fraction of the way along the edge, in the ring's direction.
    at: f32,
    /// Whether the half-edge that the point is listed at runs against the ring's direction.
    is_reversed: bool,
}

impl Point {
    /// The fraction of the way along the half-edge that the point is listed at.
    fn along(self) -> f32 {
        if self.is_reversed { 1.0 - self.at } else { self.at }
    }

    /// The values of the corner in the face of the half-edge `h`: computed in the ring's direction on both
    /// sides of the edge, so that they are equal to the bit where the sides are.
    fn value(self, mesh: &Mesh, h: HalfedgeId) -> Blend {
        let (start, end) = (h.raw(), mesh.next(h).raw());
        if self.is_reversed { Blend::Mix(end, start, self.at) } else { Blend::Mix(start, end, self.at) }
    }
}

/// The new vertices on a half-edge in its direction.
type Points = FxHashMap<HalfedgeId, Vec<Point>>;

fn plan_cut(mesh: &Mesh, edge: EdgeId, cuts: u32, t: f32) -> Result<Plan, Refusal> {
    mesh.require_edge(edge)?;
    LOOP_CUTS_RANGE.require("cuts", cuts as f32)?;
    SPLIT_T_RANGE.require("t", t)?;
    let (ring, _) = edge_ring(mesh, edge);
    if ring.len() < 2 {
        return Err(Refusal::NoRing(edge));
    }
    let mut patch = Patch::new(mesh);
    let mut points = Points::default();
    let mut faces: Vec<FaceId> = Vec::new();
    for &h in &ring {
        let (a, b) = (mesh.from(h), mesh.to(h));
        let on: Vec<Point> = (1..=cuts)
            .map(|i| {
                let at = stretch(i as f32 / (cuts + 1) as f32, t);
                let position = mesh.position(a).lerp(mesh.position(b), at);
                let vertex = patch.add_vertex(position, Blend::Mix(a.raw(), b.raw(), at));
                Point { vertex, at, is_reversed: false }
            })
            .collect();
        points.insert(h.twin(), on.iter().rev().map(|&p| Point { is_reversed: true, ..p }).collect());
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
            _ => add_corners(&mut patch, mesh, &points, face, &sides),
        }
    }
    patch.plan(mesh)
}

/// Moves a fraction of an even spacing so that the middle goes to `t`.
fn stretch(even: f32, t: f32) -> f32 {
    if even <= 0.5 { 2.0 * t * even } else { t + (2.0 * even - 1.0) * (1.0 - t) }
}

/// Cuts a quad along its first and third side, and its second and fourth if they are cut too.
fn cut_quad(mesh: &Mesh, patch: &mut Patch, points: &Points, face: FaceId, sides: [HalfedgeId; 4]) {
    let [a, b, c, d] = sides;
    // Columns go along the first side, rows from it to the third.
    let near = line(mesh, points, a);
    let right = line(mesh, points, b);
    let mut far = line(mesh, points, c);
    far.reverse();
    let mut left = line(mesh, points, d);
    left.reverse();
    for (along, _) in &mut left {
        *along = 1.0 - *along;
    }
    let (columns, rows) = (near.len(), left.len());
    let [va, vb, vc, vd] = sides.map(|h| mesh.from(h));
    let mut grid: Vec<Corner> = Vec::with_capacity(columns * rows);
    for row in 0..rows {
        for column in 0..columns {
            let on_rim = if row == 0 {
                Some(&near[column])
            } else if row == rows - 1 {
                Some(&far[column])
            } else if column == 0 {
                Some(&left[row])
            } else if column == columns - 1 {
                Some(&right[row])
            } else {
                None
            };
            grid.push(match on_rim {
                Some((_, corner)) => corner.clone(),
                None => {
                    let (s, t) = (near[column].0, left[row].0);
                    let weights = [(1.0 - s) * (1.0 - t), s * (1.0 - t), s * t, (1.0 - s) * t];
                    let blend = |ids: [u32; 4]| Blend::Weighted(ids.into_iter().zip(weights).collect());
                    let [pa, pb, pc, pd] = [va, vb, vc, vd].map(|v| mesh.position(v));
                    let position = pa.lerp(pb, s).lerp(pd.lerp(pc, s), t);
                    let vertex = patch.add_vertex(position, blend([va, vb, vc, vd].map(VertexId::raw)));
                    Corner { vertex, value: blend(sides.map(HalfedgeId::raw)), replaces: None }
                }
            });
        }
    }
    for row in 0..rows - 1 {
        for column in 0..columns - 1 {
            let at = |row: usize, column: usize, is_on_rim: bool, side: HalfedgeId| {
                let mut corner = grid[row * columns + column].clone();
                corner.replaces = Some(side).filter(|_| is_on_rim);
                corner
            };
            let corners = vec![
                at(row, column, row == 0, a),
                at(row, column + 1, column + 2 == columns, b),
                at(row + 1, column + 1, row + 2 == rows, c),
                at(row + 1, column, column == 0, d),
            ];
            if row == 0 && column == 0 {
                patch.replace_face(face, corners);
            } else {
                patch.add_face(Some(face), corners);
            }
        }
    }
}

/// The corners along a side of a face with those at its ends, each with the fraction of the way along.
fn line(mesh: &Mesh, points: &Points, h: HalfedgeId) -> Vec<(f32, Corner)> {
    let next = mesh.next(h);
    let mut line = vec![(0.0, Corner::new(mesh.from(h), h))];
    line.extend(points.get(&h).into_iter().flatten().map(|point| {
        (point.along(), Corner { vertex: point.vertex, value: point.value(mesh, h), replaces: None })
    }));
    line.push((1.0, Corner::new(mesh.from(next), next)));
    line
}

/// Gives a face at an end of the ring, which isn't a quad, the corners there.
fn add_corners(patch: &mut Patch, mesh: &Mesh, points: &Points, face: FaceId, sides: &[HalfedgeId]) {
    let mut corners = Vec::new();
    for &h in sides {
        corners.push(Corner::keep(mesh, h));
        for point in points.get(&h).into_iter().flatten() {
            corners.push(Corner { vertex: point.vertex, value: point.value(mesh, h), replaces: Some(h) });
        }
    }
    patch.replace_face(face, corners);
}

/// Cuts the ring of quads through an edge `cuts` times: evenly if `t` is one half. Otherwise the middle of the cuts
/// lies at the fraction `t` along the edge's even half-edge, and the cuts are evenly spaced on either side of it.
///
/// Costs O(quads of the ring * cuts + valences of their vertices), times the cuts again for quads that the ring passes
/// twice. Attributes: new vertices and corners are interpolated; the pieces of an edge or a face copy its attributes,
/// and one keeps its id; cuts have default values.
pub fn loop_cut(mesh: &mut Mesh, edge: EdgeId, cuts: u32, t: f32) -> Result<Made, Refusal> {
    Ok(plan_cut(mesh, edge, cuts, t)?.apply(mesh))
}
