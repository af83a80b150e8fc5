//! Checking a patch, and deciding all ids.

use super::{Corner, Patch};
use crate::edit::{Made, Refusal};
use crate::{EdgeId, FaceId, HalfedgeId, Mesh, VertexId};
use rustc_hash::{FxHashMap, FxHashSet};

/// A patch that leaves the mesh valid, with all ids decided.
pub(crate) struct Plan {
    pub(super) patch: Patch,
    /// The ids of the new faces.
    pub(super) face_ids: Vec<FaceId>,
    /// The half-edge of each corner's side, one new face after the other.
    pub(super) sides: Vec<HalfedgeId>,
    /// The ends of each new edge, and the edge whose attributes it copies.
    pub(super) new_edges: Vec<(VertexId, VertexId, Option<EdgeId>)>,
    /// Existing half-edges that get other ends: from and to.
    pub(super) moved_edges: Vec<(HalfedgeId, VertexId, VertexId)>,
    /// Half-edges of removed faces that no new face takes.
    pub(super) freed_sides: Vec<HalfedgeId>,
    /// Half-edges that arrive at the new vertex of a separated fan.
    pub(super) separated: Vec<(HalfedgeId, VertexId)>,
    pub(super) boundary_links: Vec<(HalfedgeId, HalfedgeId)>,
    pub(super) vertex_halfedges: Vec<(VertexId, HalfedgeId)>,
    pub(crate) made: Made,
}

impl Plan {
    /// Refuses a plan that removes vertices, except for those that `may_go`.
    pub(crate) fn require_vertices(self, may_go: impl Fn(VertexId) -> bool) -> Result<Self, Refusal> {
        match self.made.removed_vertices.iter().find(|&&v| !may_go(v)) {
            Some(&v) => Err(Refusal::LeftWithoutFace(v)),
            None => Ok(self),
        }
    }
}

/// Half-edges by the vertices they leave and point to; each stands for its twin too.
#[derive(Default)]
struct SidesByEnds(FxHashMap<(VertexId, VertexId), HalfedgeId>);

impl SidesByEnds {
    fn get(&self, u: VertexId, v: VertexId) -> Option<HalfedgeId> {
        self.0.get(&(u.min(v), u.max(v))).map(|&h| if u < v { h } else { h.twin() })
    }

    fn insert(&mut self, u: VertexId, v: VertexId, h: HalfedgeId) {
        self.0.insert((u.min(v), u.max(v)), if u < v { h } else { h.twin() });
    }
}

/// The vertices that each side of a face leaves and points to.
fn ends_of_sides(corners: &[Corner]) -> impl Iterator<Item = (VertexId, VertexId)> + '_ {
    let after = corners.iter().skip(1).chain(corners.first());
    corners.iter().zip(after).map(|(a, b)| (a.vertex, b.vertex))
}

/// What is known of the result while a patch is being planned.
struct Planner<'a> {
    mesh: &'a Mesh,
    removed: FxHashSet<FaceId>,
    sides_by_ends: SidesByEnds,
    /// The new face that takes each half-edge.
    taken: FxHashMap<HalfedgeId, FaceId>,
    /// Existing edges that may lose or gain a face.
    affected_edges: Vec<EdgeId>,
    /// Vertices whose fans may change.
    affected_vertices: Vec<VertexId>,
    face_ids: Vec<FaceId>,
    new_edges: Vec<(VertexId, VertexId, Option<EdgeId>)>,
    moved_edges: Vec<(HalfedgeId, VertexId, VertexId)>,
}

impl Patch {
    /// Checks the patch and decides all ids.
    ///
    /// # Errors
    /// Why the result would not be a valid mesh.
    pub(crate) fn plan(mut self, mesh: &Mesh) -> Result<Plan, Refusal> {
        self.remove.sort_unstable();
        self.remove.dedup();
        let mut planner = Planner {
            mesh,
            removed: self.remove.iter().copied().collect(),
            sides_by_ends: SidesByEnds::default(),
            taken: FxHashMap::default(),
            affected_edges: Vec::new(),
            affected_vertices: Vec::new(),
            face_ids: Vec::new(),
            new_edges: Vec::new(),
            moved_edges: Vec::new(),
        };
        let old_sides = planner.remove_faces(&self);
        let found = planner.find_sides(&self)?;
        let sides = planner.make_sides(&self, found)?;
        check_edge_count(mesh.edge_capacity(), planner.new_edges.len())?;
        planner.affected_edges.extend(sides.iter().map(|h| h.edge()));
        planner.affected_edges.sort_unstable();
        planner.affected_edges.dedup();
        let made = planner.list_made(&self);
        planner.affected_vertices.sort_unstable();
        planner.affected_vertices.dedup();
        let freed_sides = old_sides.into_iter().filter(|h| !planner.taken.contains_key(h)).collect();
        let Planner { removed, affected_vertices, face_ids, new_edges, moved_edges, .. } = planner;
        let mut plan = Plan {
            patch: self,
            face_ids,
            sides,
            new_edges,
            moved_edges,
            freed_sides,
            separated: Vec::new(),
            boundary_links: Vec::new(),
            vertex_halfedges: Vec::new(),
            made,
        };
        plan.order_fans(mesh, &affected_vertices, |h| stays(mesh, &removed, h))?;
        Ok(plan)
    }
}

/// Whether a half-edge exists and keeps its face.
fn stays(mesh: &Mesh, removed: &FxHashSet<FaceId>, h: HalfedgeId) -> bool {
    h.index() < mesh.halfedge_capacity() && mesh.face_of(h).is_some_and(|face| !removed.contains(&face))
}

impl Planner<'_> {
    fn stays(&self, h: HalfedgeId) -> bool {
        stays(self.mesh, &self.removed, h)
    }

    /// Gives a half-edge to a new face.
    fn take(&mut self, h: HalfedgeId, face: FaceId, (u, v): (VertexId, VertexId)) -> Result<(), Refusal> {
        if self.stays(h) || self.taken.insert(h, face).is_some() {
            return Err(Refusal::SideTaken(u, v));
        }
        Ok(())
    }

    /// Notes what removing the faces affects; returns their half-edges.
    fn remove_faces(&mut self, patch: &Patch) -> Vec<HalfedgeId> {
        let mesh = self.mesh;
        let mut sides = Vec::new();
        for h in patch.remove.iter().flat_map(|&face| mesh.face_halfedges(face)) {
            self.sides_by_ends.insert(mesh.from(h), mesh.to(h), h);
            self.affected_edges.push(h.edge());
            self.affected_vertices.push(mesh.from(h));
            sides.push(h);
        }
        sides
    }

    /// Numbers the new faces and finds the sides that lie on existing edges; none for the others.
    fn find_sides(&mut self, patch: &Patch) -> Result<Vec<Option<HalfedgeId>>, Refusal> {
        let mesh = self.mesh;
        let mut found = Vec::new();
        let mut next_face = mesh.face_capacity();
        let mut vertices: Vec<VertexId> = Vec::new();
        for face in &patch.faces {
            let id = face.id.unwrap_or_else(|| {
                next_face += 1;
                FaceId::new(next_face - 1)
            });
            self.face_ids.push(id);
            if face.corners.len() < 3 {
                return Err(Refusal::TooFewCorners(face.id.or(face.attributes_of)));
            }
            vertices.clear();
            vertices.extend(face.corners.iter().map(|corner| corner.vertex));
            self.affected_vertices.extend(&vertices);
            vertices.sort_unstable();
            if let Some(pair) = vertices.windows(2).find(|pair| pair[0] == pair[1]) {
                return Err(Refusal::RepeatedCorner(pair[0]));
            }
            for (u, v) in ends_of_sides(&face.corners) {
                let mut side = self.sides_by_ends.get(u, v);
                if side.is_none() && [u, v].iter().all(|v| v.index() < mesh.vertex_capacity()) {
                    side = mesh.find_halfedge_between(u, v);
                    if let Some(h) = side {
                        self.sides_by_ends.insert(u, v, h);
                        self.affected_edges.push(h.edge());
                    }
                }
                if let Some(h) = side {
                    self.take(h, id, (u, v))?;
                }
                found.push(side);
            }
        }
        Ok(found)
    }

    /// Puts the sides that were not found on edges that nothing else needs, or on new edges.
    fn make_sides(
        &mut self,
        patch: &Patch,
        found: Vec<Option<HalfedgeId>>,
    ) -> Result<Vec<HalfedgeId>, Refusal> {
        let mut sides = Vec::with_capacity(found.len());
        let mut used: FxHashSet<EdgeId> = found.iter().flatten().map(|h| h.edge()).collect();
        let mut found = found.into_iter();
        for (i, face) in patch.faces.iter().enumerate() {
            for (corner, (u, v)) in face.corners.iter().zip(ends_of_sides(&face.corners)) {
                if let Some(h) = found.next().flatten() {
                    sides.push(h);
                    continue;
                }
                let h = match self.sides_by_ends.get(u, v) {
                    Some(h) => h,
                    None => {
                        let is_free = |h: HalfedgeId| {
                            !self.stays(h) && !self.stays(h.twin()) && !used.contains(&h.edge())
                        };
                        let h = match corner.replaces.filter(|&h| is_free(h)) {
                            Some(h) => {
                                used.insert(h.edge());
                                self.moved_edges.push((h, u, v));
                                h
                            }
                            None => {
                                self.new_edges.push((u, v, corner.replaces.map(HalfedgeId::edge)));
                                EdgeId::new(self.mesh.edge_capacity() + self.new_edges.len() - 1).halfedge()
                            }
                        };
                        self.sides_by_ends.insert(u, v, h);
                        h
                    }
                };
                self.take(h, self.face_ids[i], (u, v))?;
                sides.push(h);
            }
        }
        Ok(sides)
    }

    /// What the patch makes and removes, except for vertices left without a face.
    fn list_made(&mut self, patch: &Patch) -> Made {
        let mesh = self.mesh;
        let new_faces = patch.faces.iter().filter(|face| face.id.is_none()).count();
        let ids = |first: usize, count: usize| first..first + count;
        let mut made = Made {
            vertices: ids(mesh.vertex_capacity(), patch.vertices.len()).map(VertexId::new).collect(),
            edges: ids(mesh.edge_capacity(), self.new_edges.len()).map(EdgeId::new).collect(),
            faces: ids(mesh.face_capacity(), new_faces).map(FaceId::new).collect(),
            ..Made::default()
        };
        let affected = std::mem::take(&mut self.affected_edges);
        for &edge in &affected {
            let has_face = |h: HalfedgeId| self.taken.contains_key(&h) || self.stays(h);
            if !edge.halfedges().into_iter().any(has_face) {
                made.removed_edges.push(edge);
            }
            if edge.index() < mesh.edge_capacity() {
                self.affected_vertices.extend(mesh.ends(edge));
            }
        }
        let reused: FxHashSet<FaceId> = patch.faces.iter().filter_map(|face| face.id).collect();
        made.removed_faces = patch.remove.iter().copied().filter(|face| !reused.contains(face)).collect();
        made
    }
}

/// Refuses more edges than ids can number.
fn check_edge_count(edges: usize, more: usize) -> Result<(), Refusal> {
    if edges + more > Mesh::MAX_EDGES { Err(Refusal::TooManyEdges) } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_edges_than_can_be_numbered_are_refused() {
        assert_eq!(check_edge_count(Mesh::MAX_EDGES - 4, 4), Ok(()));
        assert_eq!(check_edge_count(Mesh::MAX_EDGES - 4, 5), Err(Refusal::TooManyEdges));
    }
}
