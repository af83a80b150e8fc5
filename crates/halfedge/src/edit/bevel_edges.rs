//! Bevel edges: each becomes a strip of faces, rounded if it has several segments.
//!
//! # Round a vertex
//!
//! The bevelled edges at a vertex (and the gap, on the boundary) divide the faces round it into sectors. The faces of
//! each sector get one new vertex in place of the old one, and the strip of each bevelled edge ends in a *profile*: a
//! line of vertices from the sector on the edge's left to that on its right.
//!
//! - Two sectors inside the mesh: the strips of both edges share the profile.
//! - Three sectors or more: the profiles surround a new face. On the boundary a boundary edge closes it; with two
//!   sectors there (one edge), the profile itself lies on the boundary.
//! - One sector (the bevel ends here): each of its edges gets a vertex. Those beside the bevelled edge are the width
//!   away from it; the others are as far along their edges as the farther of those two. If one face lies between those
//!   two, it takes the profile in. Otherwise a new face fills in between the profile and the other vertices. It has
//!   area, because a line between two points of a circle lies inside the circle. If there is only one other edge, the
//!   strip runs out in a point.
//!
//! All these vertices are new, so no edge is duplicated and no side taken twice. Only edges on the boundary are refused,
//! and strips that run out in a point at both ends.
//!
//! A bevel wider than a face is *clamped* to where the first edge would lose its length: [`Slide::limit`].

use crate::edit::patch::{Corner, Patch, Plan};
use crate::edit::shared::{Followers, counter_clockwise, miter};
use crate::edit::{Refusal, Slide, SlideVertex, SlidingEdit};
use crate::mesh::Mesh;
use crate::{EdgeId, FaceId, HalfedgeId, NumberRange, VertexId};
use glam::Vec3;
use rustc_hash::{FxHashMap, FxHashSet};

/// The numbers of segments of a bevel.
pub const BEVEL_SEGMENTS_RANGE: NumberRange = NumberRange::counts(1, 256);

/// Whether [`bevel_edges`] would succeed.
pub fn can_bevel_edges(mesh: &Mesh, edges: &[EdgeId], segments: u32) -> Result<(), Refusal> {
    plan_bevel(mesh, edges, segments).map(drop)
}

/// Makes each edge a strip of `segments` faces, without width: the slide's amount is the distance of the strip's sides
/// from the edge, in mesh units. Several segments are round: an arc that leaves both faces without a kink.
///
/// Faces that shrink keep their ids, and so do their other edges. Costs O(segments * edges + valences + degrees of the
/// faces round them). Attributes: new vertices copy the bevelled ones, new corners those that they are cut from, and
/// both follow the slide over the faces. Each half of a strip copies the face on its side, a face at a vertex one of
/// those round it. New edges have default values.
pub fn bevel_edges(mesh: &mut Mesh, edges: &[EdgeId], segments: u32) -> Result<SlidingEdit, Refusal> {
    let (plan, moves) = plan_bevel(mesh, edges, segments)?;
    let followers = plan.followers(mesh, moves.iter().map(|slide| slide.vertex));
    let followers = Followers::new(mesh, followers, |_, _| true);
    let made = plan.apply(mesh);
    Ok(SlidingEdit { made, slide: Slide::limited(mesh, moves, followers) })
}

fn plan_bevel(mesh: &Mesh, edges: &[EdgeId], segments: u32) -> Result<(Plan, Vec<SlideVertex>), Refusal> {
    mesh.require_edges(edges)?;
    BEVEL_SEGMENTS_RANGE.require("segments", segments as f32)?;
    let mut edges = edges.to_vec();
    edges.sort_unstable();
    edges.dedup();
    if let Some(&edge) = edges.iter().find(|&&edge| mesh.is_boundary_edge(edge)) {
        return Err(Refusal::BoundaryEdge(edge));
    }
    let mut ends: Vec<VertexId> = edges.iter().flat_map(|&edge| mesh.ends(edge)).collect();
    ends.sort_unstable();
    ends.dedup();
    let mut bevel = Bevel {
        mesh,
        segments: segments as usize,
        bevelled: edges.iter().copied().collect(),
        patch: Patch::new(mesh),
        moves: Vec::new(),
        corners: FxHashMap::default(),
        profiles: FxHashMap::default(),
        normals: FxHashMap::default(),
    };
    let mut faces: Vec<FaceId> = Vec::new();
    for &v in &ends {
        bevel.bevel_vertex(v);
        faces.extend(mesh.vertex_faces(v));
    }
    faces.sort_unstable();
    faces.dedup();
    for face in faces {
        bevel.bevel_face(face);
    }
    for &edge in &edges {
        bevel.add_strip(edge);
    }
    Ok((bevel.patch.plan(mesh)?, bevel.moves))
}

/// A new vertex, and its movement per unit of width.
#[derive(Clone, Copy)]
struct Point {
    vertex: VertexId,
    by: Vec3,
}

struct Bevel<'a> {
    mesh: &'a Mesh,
    segments: usize,
    bevelled: FxHashSet<EdgeId>,
    patch: Patch,
    moves: Vec<SlideVertex>,
    /// The vertices that replace a corner, in the order of its face.
    corners: FxHashMap<HalfedgeId, Vec<VertexId>>,
    /// Per half-edge of a bevelled edge: the profile at the vertex that it leaves, from the sector on its left to
    /// that on its right.
    profiles: FxHashMap<HalfedgeId, Vec<VertexId>>,
    normals: FxHashMap<FaceId, Vec3>,
}

impl Bevel<'_> {
    fn is_bevelled(&self, h: HalfedgeId) -> bool {
        self.bevelled.contains(&h.edge())
    }

    /// The unit normal of the face of a half-edge.
    fn normal(&mut self, h: HalfedgeId) -> Vec3 {
        let mesh = self.mesh;
        match mesh.face_of(h) {
            Some(face) => *self.normals.entry(face).or_insert_with(|| mesh.unit_normal(face)),
            None => Vec3::ZERO,
        }
    }

    /// The unit vector from a bevelled edge into the face on its left or right.
    fn inward(&mut self, h: HalfedgeId, left: bool) -> Vec3 {
        let side = if left { h } else { h.twin() };
        self.normal(side).cross(self.mesh.direction(side)).normalize_or_zero()
    }

    /// Adds a vertex where an old one is.
    fn add_point(&mut self, v: VertexId, by: Vec3) -> Point {
        let vertex = self.patch.copy_vertex(self.mesh, v);
        self.moves.push(SlideVertex { vertex, from: self.mesh.position(v), by });
        Point { vertex, by }
    }

    /// The movement along an edge by which a vertex gets away from bevelled edges by one.
    fn away_along(&self, edge: HalfedgeId, bevelled: &[HalfedgeId]) -> Vec3 {
        let u = self.mesh.direction(edge);
        let away = bevelled.iter().map(|&h| {
            let b = self.mesh.direction(h);
            1.0 / (u - b * u.dot(b)).length().max(0.25)
        });
        u * (away.sum::<f32>() / bevelled.len().max(1) as f32)
    }

    /// Decides what becomes of the corners at an end of a bevelled edge.
    fn bevel_vertex(&mut self, v: VertexId) {
        let mesh = self.mesh;
        let is_boundary = mesh.is_boundary_vertex(v);
        let mut around = counter_clockwise(mesh, v);
        let Some(first) = around.iter().position(|&h| self.is_bevelled(h)) else { return };
        let count = around.iter().filter(|&&h| self.is_bevelled(h)).count();
        if !is_boundary {
            around.rotate_left(first);
            if count == 1 {
                return self.end_bevel(v, &around);
            }
        }
        // The corner of `around[i]` lies between that edge and the next. Sectors are ranges of `around`; each
        // starts with a bevelled edge, except for the first one on the boundary.
        let starts: Vec<usize> =
            (0..around.len()).filter(|&i| i == 0 || self.is_bevelled(around[i])).collect();
        let mut sectors: Vec<Point> = Vec::with_capacity(starts.len());
        for (n, &start) in starts.iter().enumerate() {
            let stop = starts.get(n + 1).copied().unwrap_or(around.len());
            let before = Some(around[start]).filter(|&h| self.is_bevelled(h));
            // Inside the mesh the last sector ends at the first edge.
            let after = around.get(stop).copied().or((!is_boundary).then_some(around[0]));
            let by = self.sector_direction(before, after, &around[start..stop]);
            let point = self.add_point(v, by);
            for &h in &around[start..stop] {
                self.corners.insert(h, vec![point.vertex]);
            }
            sectors.push(point);
        }
        let edges: Vec<usize> = starts.iter().copied().filter(|&i| self.is_bevelled(around[i])).collect();
        let left_of = |n: usize| if is_boundary { n + 1 } else { n };
        let right_of = |n: usize| if is_boundary { n } else { (n + sectors.len() - 1) % sectors.len() };
        for (n, &i) in edges.iter().enumerate() {
            let (left, right) = (sectors[left_of(n)], sectors[right_of(n)]);
            // Two bevelled edges inside the mesh share one profile.
            let shared = if !is_boundary && count == 2 && n == 1 {
                self.profiles.get(&around[edges[0]])
            } else {
                None
            };
            let profile = match shared {
                Some(profile) => profile.iter().rev().copied().collect(),
                None => self.add_profile(v, left, right),
            };
            self.profiles.insert(around[i], profile);
        }
        if sectors.len() > 2 {
            let mut rim: Vec<VertexId> = Vec::new();
            for &i in &edges {
                // Counter-clockwise across an edge: from its right to its left.
                if let Some(profile) = self.profiles.get(&around[i]) {
                    rim.extend(profile.iter().rev().skip(usize::from(!rim.is_empty())));
                }
            }
            if !is_boundary {
                rim.pop();
            }
            self.add_cap(around[edges[0]], rim);
        }
    }

    /// The movement of a sector's vertex: along the boundary, along the one edge in the sector, or so that it gets
    /// away from the bevelled edges on both sides by one.
    fn sector_direction(
        &mut self,
        before: Option<HalfedgeId>,
        after: Option<HalfedgeId>,
        around: &[HalfedgeId],
    ) -> Vec3 {
        let free = &around[usize::from(before.is_some())..];
        match (before, after, free) {
            (Some(before), Some(after), &[edge]) => self.away_along(edge, &[before, after]),
            (Some(before), Some(after), _) => {
                let (left, right) = (self.inward(before, true), self.inward(after, false));
                miter(left, right)
            }
            (Some(before), None, [.., edge]) => self.away_along(*edge, &[before]),
            (None, Some(after), [edge, ..]) => self.away_along(*edge, &[after]),
            _ => Vec3::ZERO,
        }
    }

    /// Ends the bevel of the first edge of `around` at a vertex inside the mesh.
    fn end_bevel(&mut self, v: VertexId, around: &[HalfedgeId]) {
        let (h, others) = (around[0], &around[1..]);
        let &[next, .., last] = others else {
            self.profiles.insert(h, vec![v; self.segments + 1]);
            return;
        };
        let (to_left, to_right) = (self.away_along(next, &[h]), self.away_along(last, &[h]));
        let left = self.add_point(v, to_left);
        // Beyond the line from left to right.
        let reach = to_left.length().max(to_right.length());
        let middle: Vec<VertexId> = others[1..others.len() - 1]
            .iter()
            .map(|&edge| self.add_point(v, self.mesh.direction(edge) * reach).vertex)
            .collect();
        let right = self.add_point(v, to_right);
        let profile = self.add_profile(v, left, right);
        let across = profile.iter().rev().copied();
        self.corners.insert(h, vec![left.vertex]);
        self.corners.insert(last, vec![right.vertex]);
        if middle.is_empty() {
            self.corners.insert(next, across.collect());
        } else {
            let points: Vec<VertexId> =
                [left.vertex].into_iter().chain(middle.iter().copied()).chain([right.vertex]).collect();
            for (&edge, pair) in others.iter().zip(points.windows(2)) {
                self.corners.insert(edge, vec![pair[1], pair[0]]);
            }
            self.add_cap(next, across.chain(middle).collect());
        }
        self.profiles.insert(h, profile);
    }

    /// Adds the vertices from one sector to another: an arc that leaves both in the plane of their face. With v in the
    /// origin it is l + r - r cos θ - l sin θ, which is l at 0 and r at a right angle.
    fn add_profile(&mut self, v: VertexId, left: Point, right: Point) -> Vec<VertexId> {
        let mut profile = vec![left.vertex];
        for i in 1..self.segments {
            let angle = i as f32 / self.segments as f32 * std::f32::consts::FRAC_PI_2;
            let by = left.by * (1.0 - angle.sin()) + right.by * (1.0 - angle.cos());
            profile.push(self.add_point(v, by).vertex);
        }
        profile.push(right.vertex);
        profile
    }

    /// Adds a face at a vertex, with the attributes of the face at this corner.
    fn add_cap(&mut self, corner: HalfedgeId, rim: Vec<VertexId>) {
        let corners = rim.into_iter().map(|vertex| Corner::new(vertex, corner)).collect();
        self.patch.add_face(self.mesh.face_of(corner), corners);
    }

    /// Puts the new vertices in place of a face's corners.
    fn bevel_face(&mut self, face: FaceId) {
        let mut corners = Vec::new();
        for h in self.mesh.face_halfedges(face) {
            match self.corners.get(&h).map(Vec::as_slice) {
                Some([before @ .., last]) => {
                    corners.extend(before.iter().map(|&vertex| Corner::new(vertex, h)));
                    corners.push(Corner {
                        replaces: Some(h).filter(|&h| !self.is_bevelled(h)),
                        ..Corner::moved(*last, h)
                    });
                }
                _ => corners.push(Corner::keep(self.mesh, h)),
            }
        }
        self.patch.replace_face(face, corners);
    }

    /// Adds the strip of a bevelled edge.
    fn add_strip(&mut self, edge: EdgeId) {
        let mesh = self.mesh;
        let [h, twin] = edge.halfedges();
        let (Some(near), Some(far)) = (self.profiles.get(&h), self.profiles.get(&twin)) else { return };
        // Both profiles from the left of `h` to its right.
        let near: Vec<VertexId> = near.clone();
        let far: Vec<VertexId> = far.iter().rev().copied().collect();
        for (i, (a, b)) in near.windows(2).zip(far.windows(2)).enumerate() {
            let is_on_left = 2 * i < self.segments;
            let (at_near, at_far) = if is_on_left { (h, mesh.next(h)) } else { (mesh.next(twin), twin) };
            let mut corners = vec![
                Corner::new(a[1], at_near),
                Corner::new(b[1], at_far),
                Corner::new(b[0], at_far),
                Corner::new(a[0], at_near),
            ];
            // Where a strip runs out in a point, two corners are the same vertex.
            corners.dedup_by(|x, y| x.vertex == y.vertex);
            if corners.len() > 1 && corners[0].vertex == corners[corners.len() - 1].vertex {
                corners.pop();
            }
            self.patch.add_face(mesh.face_of(if is_on_left { h } else { twin }), corners);
        }
    }
}
