//! Slide edges: lines of edges move sideways over the surface, each vertex along a rail to its left or to its right.
//!
//! The edges form chains, open or closed, in which each vertex has one edge or two; edges that branch are refused. A chain
//! has a direction, and so a left and a right, seen from outside. The first given edge's chain runs along that edge's even
//! half-edge. Each other one runs so that its vertices go the same way as those of the first, as far as they can be compared.
//!
//! The rail of a vertex on one side is
//! - at an end of a chain, the edge next to the chain's last edge on that side;
//! - else the edge on that side that is nearest to perpendicular to the chain, as seen by its cosine;
//! - across a face, where two edges are equally near, or there is none because both edges of the chain are sides of one
//!   face. It ends at the mean of the corners of the face that are neither neighbours of the vertex nor on a chain: in a
//!   quad at the opposite corner. A face without such corners takes those that are on no chain, or else all;
//! - none where the side has no face, or where the end of a chain has only one other edge, which just continues the chain.
//!   The vertex stays.
//!
//! Vertices that would slide towards each other along one edge meet in its middle. Always possible otherwise: only positions
//! change.

use crate::edit::Refusal;
use crate::edit::shared::{Along, Rail, check_amount, slide_along};
use crate::mesh::Mesh;
use crate::{EdgeId, Element, FaceId, HalfedgeId, VertexId};
use glam::{DVec3, Vec3};
use rustc_hash::{FxHashMap, FxHashSet};

/// Edges whose cosines differ by less are equally near to perpendicular.
const COSINE_TOLERANCE: f32 = 1e-3;

/// The rails of the edges' vertices: to the left, and to the right. Costs O(valences + degrees of the faces there).
///
/// # Errors
/// If an edge doesn't exist, none is given, they branch, or no vertex has a rail.
pub fn edge_rails(mesh: &Mesh, edges: &[EdgeId]) -> Result<[Vec<Rail>; 2], Refusal> {
    let Some(&first) = edges.first() else { return Err(Refusal::NothingGiven(Element::Edge)) };
    let mut lines = Lines::new(mesh, edges)?;
    let mut seen: FxHashSet<EdgeId> = FxHashSet::default();
    let mut rails = [Vec::new(), Vec::new()];
    let mut across_first = DVec3::ZERO;
    for &edge in edges {
        if seen.contains(&edge) {
            continue;
        }
        let (chain, closed) = lines.chain_of(edge.halfedge());
        seen.extend(chain.iter().map(|h| h.edge()));
        let [mut left, mut right] = lines.rails(&chain, closed);
        let across = sum_of_rails(mesh, &left) - sum_of_rails(mesh, &right);
        if edge == first {
            across_first = across;
        } else if across.dot(across_first) < 0.0 {
            std::mem::swap(&mut left, &mut right);
        }
        rails[0].extend(left);
        rails[1].extend(right);
    }
    if rails.iter().all(Vec::is_empty) {
        return Err(Refusal::NoRail(first));
    }
    rails.iter_mut().for_each(|side| stop_halfway(mesh, side));
    Ok(rails)
}

fn sum_of_rails(mesh: &Mesh, rails: &[Rail]) -> DVec3 {
    rails.iter().map(|rail| rail.to.as_dvec3() - mesh.position(rail.vertex).as_dvec3()).sum()
}

/// Ends the rails of vertices that slide towards each other in the middle of their edge.
fn stop_halfway(mesh: &Mesh, rails: &mut [Rail]) {
    let along = |rail: &Rail| match rail.along {
        Along::Edge(h) => Some(h),
        Along::Face(_) => None,
    };
    let taken: FxHashSet<HalfedgeId> = rails.iter().filter_map(along).collect();
    for rail in rails.iter_mut() {
        if along(rail).is_some_and(|h| taken.contains(&h.twin())) {
            let from = mesh.position(rail.vertex).as_dvec3();
            rail.to = from.lerp(rail.to.as_dvec3(), 0.5).as_vec3();
        }
    }
}

/// Lines of edges without branches.
struct Lines<'a> {
    mesh: &'a Mesh,
    /// The edges' half-edges that leave each vertex.
    leaving: FxHashMap<VertexId, [Option<HalfedgeId>; 2]>,
    /// What is known of the faces that rails cross.
    crossed: FxHashMap<FaceId, Crossed>,
}

/// A face that rails cross.
#[derive(Clone, Copy)]
struct Crossed {
    /// The sum of its corners that are on no line.
    sum: DVec3,
    count: usize,
    /// The mean of all its corners.
    mean: Vec3,
}

impl<'a> Lines<'a> {
    fn new(mesh: &'a Mesh, edges: &[EdgeId]) -> Result<Self, Refusal> {
        let mut leaving: FxHashMap<VertexId, [Option<HalfedgeId>; 2]> = FxHashMap::default();
        for &edge in edges {
            mesh.require_edge(edge)?;
            for h in edge.halfedges() {
                let v = mesh.from(h);
                let [first, second] = leaving.entry(v).or_default();
                match (*first, *second) {
                    (Some(other), _) | (_, Some(other)) if other == h => {}
                    (None, _) => *first = Some(h),
                    (_, None) => *second = Some(h),
                    _ => return Err(Refusal::Branches(v)),
                }
            }
        }
        Ok(Self { mesh, leaving, crossed: FxHashMap::default() })
    }

    /// The other half-edge of a line that leaves the vertex of `h`.
    fn beside(&self, h: HalfedgeId) -> Option<HalfedgeId> {
        let both = self.leaving.get(&self.mesh.from(h))?;
        both.iter().flatten().copied().find(|&other| other != h)
    }

    /// The chain through a half-edge, in its direction, and whether it is closed.
    fn chain_of(&self, h: HalfedgeId) -> (Vec<HalfedgeId>, bool) {
        let mut first = h;
        let before = |at| self.beside(at).map(HalfedgeId::twin);
        while let Some(at) = before(first).filter(|&at| at != h) {
            first = at;
        }
        let mut chain = vec![first];
        let mut last = first;
        while let Some(at) = self.beside(last.twin()).filter(|&at| at != first) {
            chain.push(at);
            last = at;
        }
        (chain, before(first).is_some())
    }

    /// The rails of a chain's vertices to the left and to the right.
    fn rails(&mut self, chain: &[HalfedgeId], closed: bool) -> [Vec<Rail>; 2] {
        let mut rails = [Vec::new(), Vec::new()];
        let mut add = |[left, right]: [Option<Rail>; 2]| {
            rails[0].extend(left);
            rails[1].extend(right);
        };
        let ends = [chain.first(), chain.last()].map(|h| h.copied());
        if let ([Some(first), Some(last)], false) = (ends, closed) {
            add(self.rails_at_end(first));
            let [left, right] = self.rails_at_end(last.twin());
            add([right, left]);
        }
        if let ([Some(first), Some(last)], true) = (ends, closed) {
            add(self.rails_between(last, first));
        }
        for pair in chain.windows(2) {
            if let &[into, out] = pair {
                add(self.rails_between(into, out));
            }
        }
        rails
    }

    /// The rails of the vertex at the end of a chain, left and right of the half-edge that leaves it.
    fn rails_at_end(&self, h: HalfedgeId) -> [Option<Rail>; 2] {
        let mesh = self.mesh;
        let left = mesh.face_of(h).map(|_| mesh.prev(h).twin());
        let right = mesh.face_of(h.twin()).map(|_| mesh.next(h.twin()));
        if left == right {
            return [None; 2];
        }
        [left, right].map(|h| h.map(|h| Rail::along_edge(mesh, h)))
    }

    /// The rails of the vertex between two half-edges of a chain.
    fn rails_between(&mut self, into: HalfedgeId, out: HalfedgeId) -> [Option<Rail>; 2] {
        let back = into.twin();
        // Counter-clockwise, from the way forward to the way back, and from there on.
        let mut around: Vec<HalfedgeId> = self.mesh.turn_from(out).skip(1).collect();
        around.reverse();
        let (left, right) = match around.iter().position(|&h| h == back) {
            Some(at) => around.split_at(at),
            None => (&around[..], &[][..]),
        };
        let right = right.get(1..).unwrap_or_default();
        let tangent = (self.mesh.direction(out) - self.mesh.direction(back)).normalize_or_zero();
        let [left, right] = [(left, out), (right, back)].map(|(side, corner)| match side {
            [] => Some(Along::Face(corner)),
            _ => self.most_perpendicular(side, tangent),
        });
        [left, right].map(|along| match along? {
            Along::Edge(h) => Some(Rail::along_edge(self.mesh, h)),
            Along::Face(corner) => self.across(corner),
        })
    }

    /// Of edges in counter-clockwise order the one that is nearest to perpendicular, or the face between two that are equally
    /// near.
    fn most_perpendicular(&self, edges: &[HalfedgeId], tangent: Vec3) -> Option<Along> {
        let cosine = |h: HalfedgeId| self.mesh.direction(h).dot(tangent).abs();
        let nearest = edges.iter().map(|&h| cosine(h)).fold(f32::INFINITY, f32::min);
        let mut equal = edges.iter().enumerate().filter(|(_, h)| cosine(**h) < nearest + COSINE_TOLERANCE);
        let (at, &first) = equal.next()?;
        let next_too = equal.next().is_some_and(|(next, _)| next == at + 1);
        let between = next_too && self.mesh.face_of(first).is_some();
        Some(if between { Along::Face(first) } else { Along::Edge(first) })
    }

    /// The rail across the face at a corner; none if there is no face.
    fn across(&mut self, corner: HalfedgeId) -> Option<Rail> {
        let mesh = self.mesh;
        let face = mesh.face_of(corner)?;
        let leaving = &self.leaving;
        let is_free = |v: &VertexId| !leaving.contains_key(v);
        let place = |v: VertexId| mesh.position(v).as_dvec3();
        let all = *self.crossed.entry(face).or_insert_with(|| {
            let free = || mesh.face_vertices(face).filter(is_free);
            Crossed { sum: free().map(place).sum(), count: free().count(), mean: mesh.corner_mean(face) }
        });
        let beside = [mesh.to(corner), mesh.from(mesh.prev(corner))];
        let beside = beside.into_iter().filter(is_free);
        let (sum, count) = beside.fold((all.sum, all.count), |(sum, count), v| (sum - place(v), count - 1));
        let to = match (count, all.count) {
            (0, 0) => all.mean,
            (0, count) => (all.sum / count as f64).as_vec3(),
            (count, _) => (sum / count as f64).as_vec3(),
        };
        Some(Rail { vertex: mesh.from(corner), to, along: Along::Face(corner) })
    }
}

/// Whether [`slide_edges`] would succeed.
pub fn can_slide_edges(mesh: &Mesh, edges: &[EdgeId], amount: f32) -> Result<(), Refusal> {
    check_amount(amount)?;
    edge_rails(mesh, edges).map(drop)
}

/// Slides lines of edges over the surface: not at all at amount 0, to the ends of their vertices' rails on the left at 1, and
/// to those on the right at -1. Left is that of the first edge's even half-edge, seen from outside. Returns how many
/// vertices have moved.
///
/// Costs O(valences + degrees of the faces round the vertices). Attributes: corner and vertex values become those that the
/// faces had at the new places; edges keep their creases.
pub fn slide_edges(mesh: &mut Mesh, edges: &[EdgeId], amount: f32) -> Result<usize, Refusal> {
    check_amount(amount)?;
    let [left, right] = edge_rails(mesh, edges)?;
    let rails = if amount < 0.0 { right } else { left };
    slide_along(mesh, &rails, amount.abs());
    Ok(if amount == 0.0 { 0 } else { rails.len() })
}
