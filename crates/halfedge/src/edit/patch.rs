//! Patch: takes faces out of a mesh and puts others in their place.
//!
//! Most edits are a patch: they say which faces go and which come, by their corners, and nothing
//! of how half-edges are linked. [`plan`] works out on paper what the mesh would be and checks
//! every rule of [`Mesh::validate`] where the patch reaches; [`Plan::apply`] writes it.
//!
//! Why the checks suffice. A side of a new face lies on the edge that joins its ends: one that was
//! there, found by its ends, or a new one, one for each pair of ends, so no edge is duplicated. No
//! two faces take the same side of an edge, or the patch is refused ([`Refusal::SideTaken`]); an
//! edge with no face goes. Corners of a new face differ and are three or more. At each vertex
//! touched, the corners of all faces there, old and new, are put into order by the edges between
//! them: they must be one fan. Boundary half-edges are linked from each fan's end to its start,
//! and the vertex is given the one that leaves it.
//!
//! Costs O(corners of the faces that go and come + valences of their vertices), times a logarithm
//! for sorting; hash tables are as large as the patch, never as the mesh.

use crate::attribute::{Value, keys};
use crate::edit::blend::Blend;
use crate::edit::follow::{Follower, Followers};
use crate::edit::{Made, Refusal};
use crate::mesh::Mesh;
use crate::{EdgeId, Element, FaceId, HalfedgeId, VertexId};
use glam::Vec3;
use rustc_hash::{FxHashMap, FxHashSet};

/// A corner of a new face, and the side that leaves it.
#[derive(Clone, Debug)]
pub(crate) struct Corner {
    /// A vertex of the mesh, or one of the patch's own.
    pub vertex: VertexId,
    /// The corner's values, from corners of the mesh.
    pub value: Blend,
    /// The half-edge of a face that goes which this side replaces: where no edge joins the side's
    /// ends, its edge is bent to them if nothing else needs it, else a new edge copies it.
    pub like: Option<HalfedgeId>,
}

impl Corner {
    /// The corner and side of a half-edge as they are.
    pub(crate) fn keep(mesh: &Mesh, h: HalfedgeId) -> Self {
        Self::moved(mesh.from(h), h)
    }

    /// The corner and side of a half-edge, at another vertex.
    pub(crate) fn moved(vertex: VertexId, h: HalfedgeId) -> Self {
        Self { vertex, value: Blend::Copy(h.raw()), like: Some(h) }
    }

    /// A corner with the values of a half-edge's, its side a new one.
    pub(crate) fn new(vertex: VertexId, h: HalfedgeId) -> Self {
        Self { vertex, value: Blend::Copy(h.raw()), like: None }
    }
}

/// A face that comes.
#[derive(Clone, Debug)]
pub(crate) struct NewFace {
    /// A face that goes whose id and attributes this one takes over.
    pub id: Option<FaceId>,
    /// The face whose attributes a new one copies.
    pub like: Option<FaceId>,
    pub corners: Vec<Corner>,
}

/// A vertex that comes.
#[derive(Clone, Debug)]
pub(crate) struct NewVertex {
    pub position: Vec3,
    pub value: Blend,
}

/// Faces that go, and vertices and faces that come.
#[derive(Clone, Debug, Default)]
pub(crate) struct Patch {
    /// Ids may repeat.
    pub remove: Vec<FaceId>,
    pub vertices: Vec<NewVertex>,
    pub faces: Vec<NewFace>,
    /// Whether a vertex left with several fans gets a new vertex for each but the first; else the
    /// patch is refused.
    pub separate: bool,
    pub first_vertex: usize,
}

impl Patch {
    pub(crate) fn new(mesh: &Mesh) -> Self {
        Self { first_vertex: mesh.vertex_capacity(), ..Self::default() }
    }

    /// A new vertex; gives the id it will have.
    pub(crate) fn add_vertex(&mut self, position: Vec3, value: Blend) -> VertexId {
        self.vertices.push(NewVertex { position, value });
        VertexId::new(self.first_vertex + self.vertices.len() - 1)
    }

    /// A new vertex where one of the mesh is, with its attributes.
    pub(crate) fn copy_vertex(&mut self, mesh: &Mesh, v: VertexId) -> VertexId {
        self.add_vertex(mesh.position(v), Blend::Copy(v.raw()))
    }

    /// A new face with the attributes of `like`.
    pub(crate) fn add_face(&mut self, like: Option<FaceId>, corners: Vec<Corner>) {
        self.faces.push(NewFace { id: None, like, corners });
    }

    /// Gives a face other corners; fewer than three take it away, if `may_vanish`.
    pub(crate) fn replace_face(&mut self, face: FaceId, corners: Vec<Corner>, may_vanish: bool) {
        self.remove.push(face);
        if corners.len() >= 3 || !may_vanish {
            self.faces.push(NewFace { id: Some(face), like: None, corners });
        }
    }
}

/// A patch that was found to leave a valid mesh, with all ids decided.
pub(crate) struct Plan {
    patch: Patch,
    /// Per new face.
    face_ids: Vec<FaceId>,
    /// Per corner of the new faces, one face after the other: the half-edge of its side.
    sides: Vec<HalfedgeId>,
    /// The ends of each new edge, and the edge it is like.
    new_edges: Vec<(VertexId, VertexId, Option<EdgeId>)>,
    /// Sides whose edge is bent to other ends.
    bent: Vec<(HalfedgeId, VertexId, VertexId)>,
    /// Half-edges of the faces that go that will have no face.
    bared: Vec<HalfedgeId>,
    /// Half-edges that arrive at a separated fan's vertex.
    separated: Vec<(HalfedgeId, VertexId)>,
    boundary_links: Vec<(HalfedgeId, HalfedgeId)>,
    vertex_halfedges: Vec<(VertexId, HalfedgeId)>,
    pub(crate) made: Made,
}

impl Plan {
    /// The corners at these vertices after the patch, each with those that it has its value from. None where
    /// the mesh has nothing that follows.
    pub(crate) fn followers(&self, mesh: &Mesh, vertices: impl Iterator<Item = VertexId>) -> Vec<Follower> {
        let mut followers = Vec::new();
        if !Followers::has_columns(mesh) {
            return followers;
        }
        let vertices: FxHashSet<VertexId> = vertices.collect();
        let mut sides = self.sides.iter();
        for face in &self.patch.faces {
            for (corner, &side) in face.corners.iter().zip(&mut sides) {
                let sources = match &corner.value {
                    Blend::Copy(h) => std::slice::from_ref(h),
                    Blend::Mean(all) => all.as_slice(),
                    Blend::Mix(..) | Blend::Weighted(_) => &[],
                };
                if !vertices.contains(&corner.vertex) {
                    continue;
                }
                for &h in sources {
                    let source = HalfedgeId::new(h as usize);
                    // A face that stays knows more than what is put beside it; one that shrinks to fewer
                    // corners knows most.
                    let stays = face.id.is_some() && mesh.face_of(source) == face.id;
                    let rank = if stays { sources.len() } else { 0 };
                    followers.push(Follower {
                        corner: source,
                        vertex: corner.vertex,
                        side: Some(side),
                        rank,
                    });
                }
            }
        }
        let gone: FxHashSet<FaceId> = self.patch.remove.iter().copied().collect();
        for &v in vertices.iter().filter(|&&v| mesh.has_vertex(v)) {
            for h in mesh.outgoing(v) {
                if mesh.face_of(h).is_some_and(|face| !gone.contains(&face)) {
                    followers.push(Follower { corner: h, vertex: v, side: Some(h), rank: 1 });
                }
            }
        }
        followers
    }

    /// Refuses a plan that leaves a vertex without a face, but for these.
    pub(crate) fn keeping_vertices(self, but: impl Fn(VertexId) -> bool) -> Result<Self, Refusal> {
        match self.made.removed_vertices.iter().find(|&&v| !but(v)) {
            Some(&v) => Err(Refusal::LeftWithoutFace(v)),
            None => Ok(self),
        }
    }
}

fn key(u: VertexId, v: VertexId) -> (VertexId, VertexId) {
    (u.min(v), u.max(v))
}

/// Edges by their ends: the side that points to the larger end.
#[derive(Default)]
struct Ends(FxHashMap<(VertexId, VertexId), HalfedgeId>);

impl Ends {
    fn get(&self, u: VertexId, v: VertexId) -> Option<HalfedgeId> {
        self.0.get(&key(u, v)).map(|&h| if u < v { h } else { h.twin() })
    }

    fn insert(&mut self, u: VertexId, v: VertexId, h: HalfedgeId) {
        self.0.insert(key(u, v), if u < v { h } else { h.twin() });
    }
}

/// Checks a patch and decides all ids.
pub(crate) fn plan(mesh: &Mesh, mut patch: Patch) -> Result<Plan, Refusal> {
    patch.remove.sort_unstable();
    patch.remove.dedup();
    let gone: FxHashSet<FaceId> = patch.remove.iter().copied().collect();
    let old_halfedges = mesh.halfedge_capacity();
    let kept = |h: HalfedgeId| {
        h.index() < old_halfedges && mesh.face_of(h).is_some_and(|face| !gone.contains(&face))
    };
    let mut ends = Ends::default();
    let mut affected: Vec<EdgeId> = Vec::new();
    let mut touched: Vec<VertexId> = Vec::new();
    let mut old_sides = Vec::new();
    for &face in &patch.remove {
        for h in mesh.face_halfedges(face) {
            ends.insert(mesh.from(h), mesh.to(h), h);
            affected.push(h.edge());
            touched.push(mesh.from(h));
            old_sides.push(h);
        }
    }

    let mut claimed: FxHashMap<HalfedgeId, FaceId> = FxHashMap::default();
    let mut claim = |h: HalfedgeId, face: FaceId, u: VertexId, v: VertexId| {
        if kept(h) || claimed.insert(h, face).is_some() { Err(Refusal::SideTaken(u, v)) } else { Ok(()) }
    };
    // Sides on edges that are there.
    let (mut face_ids, mut found) = (Vec::new(), Vec::new());
    let mut next_face = mesh.face_capacity();
    let old_vertices = mesh.vertex_capacity();
    let mut met: Vec<VertexId> = Vec::new();
    for face in &patch.faces {
        let id = face.id.unwrap_or_else(|| {
            next_face += 1;
            FaceId::new(next_face - 1)
        });
        face_ids.push(id);
        if face.corners.len() < 3 {
            return Err(Refusal::TooFewCorners(face.id.or(face.like)));
        }
        met.clear();
        met.extend(face.corners.iter().map(|corner| corner.vertex));
        touched.extend(&met);
        met.sort_unstable();
        if let Some(pair) = met.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(Refusal::RepeatedCorner(pair[0]));
        }
        for (u, v) in sides_of(&face.corners) {
            let mut at = ends.get(u, v);
            if at.is_none() && u.index() < old_vertices && v.index() < old_vertices {
                at = mesh.joined(u, v);
                if let Some(h) = at {
                    ends.insert(u, v, h);
                    affected.push(h.edge());
                }
            }
            if let Some(h) = at {
                claim(h, id, u, v)?;
            }
            found.push(at);
        }
    }
    // Sides on edges that are not: bend one that nothing needs, or make one.
    let (mut sides, mut new_edges, mut bent) = (Vec::with_capacity(found.len()), Vec::new(), Vec::new());
    let mut used: FxHashSet<EdgeId> = found.iter().flatten().map(|h| h.edge()).collect();
    let mut found = found.into_iter();
    for (face, &id) in patch.faces.iter().zip(&face_ids) {
        for (corner, (u, v)) in face.corners.iter().zip(sides_of(&face.corners)) {
            if let Some(h) = found.next().flatten() {
                sides.push(h);
                continue;
            }
            let h = ends.get(u, v).unwrap_or_else(|| {
                let free = |h: &HalfedgeId| !kept(*h) && !kept(h.twin()) && !used.contains(&h.edge());
                let h = match corner.like.filter(free) {
                    Some(h) => {
                        used.insert(h.edge());
                        bent.push((h, u, v));
                        h
                    }
                    None => {
                        new_edges.push((u, v, corner.like.map(HalfedgeId::edge)));
                        HalfedgeId::new(old_halfedges + 2 * (new_edges.len() - 1))
                    }
                };
                ends.insert(u, v, h);
                h
            });
            claim(h, id, u, v)?;
            sides.push(h);
        }
    }
    need_room(mesh.edge_capacity(), new_edges.len())?;

    affected.extend(sides.iter().map(|h| h.edge()));
    affected.sort_unstable();
    affected.dedup();
    let faced = |h: HalfedgeId| claimed.contains_key(&h) || kept(h);
    let mut made = Made {
        vertices: (old_vertices..old_vertices + patch.vertices.len()).map(VertexId::new).collect(),
        edges: (mesh.edge_capacity()..mesh.edge_capacity() + new_edges.len()).map(EdgeId::new).collect(),
        faces: (mesh.face_capacity()..next_face).map(FaceId::new).collect(),
        ..Made::default()
    };
    for &edge in &affected {
        let [h, twin] = edge.halfedges();
        if !faced(h) && !faced(twin) {
            made.removed_edges.push(edge);
        }
        if edge.index() < mesh.edge_capacity() {
            touched.extend(mesh.ends(edge));
        }
    }
    let reused: FxHashSet<FaceId> = patch.faces.iter().filter_map(|face| face.id).collect();
    made.removed_faces = patch.remove.iter().copied().filter(|face| !reused.contains(face)).collect();
    let bared = old_sides.into_iter().filter(|h| !claimed.contains_key(h)).collect();

    let mut plan = Plan {
        patch,
        face_ids,
        sides,
        new_edges,
        bent,
        bared,
        separated: Vec::new(),
        boundary_links: Vec::new(),
        vertex_halfedges: Vec::new(),
        made,
    };
    touched.sort_unstable();
    touched.dedup();
    plan.order_fans(mesh, &touched, kept)?;
    Ok(plan)
}

/// Refuses more edges than ids can number.
fn need_room(edges: usize, more: usize) -> Result<(), Refusal> {
    if edges + more > Mesh::MAX_EDGES { Err(Refusal::TooManyEdges) } else { Ok(()) }
}

fn sides_of(corners: &[Corner]) -> impl Iterator<Item = (VertexId, VertexId)> + '_ {
    let after = corners.iter().skip(1).chain(corners.first());
    corners.iter().zip(after).map(|(a, b)| (a.vertex, b.vertex))
}

/// A corner at a vertex as a fan sees it: the sides that arrive and leave.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Wedge {
    vertex: VertexId,
    arrives: HalfedgeId,
    leaves: HalfedgeId,
}

impl Plan {
    /// Puts the corners at each touched vertex into fans.
    fn order_fans(
        &mut self,
        mesh: &Mesh,
        touched: &[VertexId],
        kept: impl Fn(HalfedgeId) -> bool,
    ) -> Result<(), Refusal> {
        let mut wedges = Vec::with_capacity(self.sides.len());
        let mut first = 0;
        for face in &self.patch.faces {
            let sides = &self.sides[first..first + face.corners.len()];
            let before = sides.iter().cycle().skip(sides.len() - 1);
            for ((corner, &leaves), &arrives) in face.corners.iter().zip(sides).zip(before) {
                wedges.push(Wedge { vertex: corner.vertex, arrives, leaves });
            }
            first += face.corners.len();
        }
        for &vertex in touched.iter().filter(|v| v.index() < mesh.vertex_capacity()) {
            for leaves in mesh.outgoing(vertex).filter(|&h| kept(h)) {
                wedges.push(Wedge { vertex, arrives: mesh.prev(leaves), leaves });
            }
        }
        wedges.sort_unstable();
        let mut rest = wedges.as_slice();
        for &v in touched {
            let (here, after) = rest.split_at(rest.partition_point(|wedge| wedge.vertex <= v));
            rest = after;
            if here.is_empty() {
                self.made.removed_vertices.push(v);
            } else {
                self.order_fan(mesh, v, here)?;
            }
        }
        Ok(())
    }

    /// `here` are the corners at one vertex in order of the half-edge that arrives.
    fn order_fan(&mut self, mesh: &Mesh, v: VertexId, here: &[Wedge]) -> Result<(), Refusal> {
        // Turning clockwise: from the edge that leaves a corner to the corner where it arrives.
        let after: Vec<Option<usize>> = here
            .iter()
            .map(|wedge| here.binary_search_by_key(&wedge.leaves.twin(), |wedge| wedge.arrives).ok())
            .collect();
        let mut is_first = vec![true; here.len()];
        for &next in after.iter().flatten() {
            is_first[next] = false;
        }
        let starts =
            (0..here.len()).filter(|&i| is_first[i]).chain((0..here.len()).filter(|&i| !is_first[i]));
        let mut met = vec![false; here.len()];
        let mut fans = 0;
        for start in starts {
            if met[start] {
                continue;
            }
            fans += 1;
            let vertex = match fans {
                1 => v,
                _ if self.patch.separate => {
                    let twin = self.patch.copy_vertex(mesh, v);
                    self.made.vertices.push(twin);
                    twin
                }
                _ => return Err(Refusal::Pinched(v)),
            };
            let (mut at, mut last) = (Some(start), start);
            while let Some(i) = at.filter(|&i| !met[i]) {
                met[i] = true;
                last = i;
                if fans > 1 {
                    self.separated.extend([(here[i].arrives, vertex), (here[i].leaves.twin(), vertex)]);
                }
                at = after[i];
            }
            let leaves = if is_first[start] {
                let (arriving, leaving) = (here[last].leaves.twin(), here[start].arrives.twin());
                self.boundary_links.push((arriving, leaving));
                leaving
            } else {
                // Inside, any will do: the one it has, if that still leaves it.
                let old = (fans == 1 && v.index() < mesh.vertex_capacity()).then(|| mesh.halfedge_from(v));
                let stays = old
                    .flatten()
                    .filter(|&h| here.iter().zip(&met).any(|(wedge, met)| *met && wedge.leaves == h));
                stays.unwrap_or(here[start].leaves)
            };
            self.vertex_halfedges.push((vertex, leaves));
        }
        Ok(())
    }

    /// Writes the plan to the mesh it was made for.
    pub(crate) fn apply(self, mesh: &mut Mesh) -> Made {
        let patch = self.patch;
        let corners = || patch.faces.iter().flat_map(|face| &face.corners);
        // Values of corners and of edges that merge are read before anything is written.
        let values: Vec<Vec<Option<Value>>> = mesh
            .columns
            .of(Element::Halfedge)
            .iter()
            .map(|column| corners().map(|corner| corner.value.of(column)).collect())
            .collect();
        let creases: Vec<(usize, f32)> = corners()
            .zip(&self.sides)
            .filter_map(|(corner, side)| Some((corner.like?.edge(), side.edge().index())))
            .filter(|(like, edge)| like.index() != *edge && *edge < mesh.edge_capacity())
            .map(|(like, edge)| (edge, mesh.get(keys::EDGE_CREASE, like.index())))
            .collect();

        for vertex in &patch.vertices {
            let v = mesh.add_vertex(vertex.position);
            mesh.blend_attributes(Element::Vertex, &vertex.value, v.raw());
        }
        for &(u, v, like) in &self.new_edges {
            let h = mesh.add_edge(u, v);
            if let Some(like) = like {
                mesh.copy_attributes(Element::Edge, like.raw(), h.edge().raw());
            }
        }
        for (h, u, v) in self.bent {
            mesh.set_to(h, v);
            mesh.set_to(h.twin(), u);
        }
        for h in self.bared {
            mesh.set_face(h, None);
        }
        let mut first = 0;
        for (face, &id) in patch.faces.iter().zip(&self.face_ids) {
            let sides = &self.sides[first..first + face.corners.len()];
            first += face.corners.len();
            match face.id {
                Some(id) => mesh.set_face_halfedge(id, sides[0]),
                None => {
                    mesh.add_face(sides[0]);
                    if let Some(like) = face.like {
                        mesh.copy_attributes(Element::Face, like.raw(), id.raw());
                    }
                }
            }
            for (&h, &next) in sides.iter().zip(sides.iter().cycle().skip(1)) {
                mesh.set_face(h, Some(id));
                mesh.link(h, next);
            }
        }
        for (h, next) in self.boundary_links {
            mesh.link(h, next);
        }
        for (h, v) in self.separated {
            mesh.set_to(h, v);
        }
        for (v, h) in self.vertex_halfedges {
            mesh.set_vertex_halfedge(v, Some(h));
        }
        for (column, values) in values.into_iter().enumerate() {
            for ((value, side), corner) in values.into_iter().zip(&self.sides).zip(corners()) {
                let same = matches!(corner.value, Blend::Copy(from) if from == side.raw());
                if let Some(value) = value.filter(|_| !same) {
                    mesh.set_value(Element::Halfedge, column, side.index(), value);
                }
            }
        }
        for (edge, crease) in creases {
            if crease > mesh.get(keys::EDGE_CREASE, edge) {
                mesh.set(keys::EDGE_CREASE, edge, crease);
            }
        }
        for &face in &self.made.removed_faces {
            mesh.mark(Element::Face, face.raw(), true);
        }
        for &edge in &self.made.removed_edges {
            mesh.mark(Element::Edge, edge.raw(), true);
        }
        for &v in &self.made.removed_vertices {
            mesh.mark(Element::Vertex, v.raw(), true);
        }
        self.made
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_edges_than_can_be_numbered_are_refused() {
        assert_eq!(need_room(Mesh::MAX_EDGES - 4, 4), Ok(()));
        assert_eq!(need_room(Mesh::MAX_EDGES - 4, 5), Err(Refusal::TooManyEdges));
    }
}
