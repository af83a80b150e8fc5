//! The validator: all rules that a mesh keeps.

use crate::mesh::Mesh;
use crate::{Element, FaceId, HalfedgeId, NONE, VertexId};
use std::fmt;

/// A broken rule and the element that breaks it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Defect {
    /// The element's kind.
    pub element: Element,
    /// The element's number.
    pub id: u32,
    /// The rule.
    pub rule: Rule,
}

/// The rules of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Rule {
    /// All columns of a kind of element have the same length.
    ColumnLength,
    /// Links lead to elements that exist.
    DanglingLink,
    /// `prev` of `next` of a half-edge is the half-edge itself.
    NextAndPrev,
    /// `next` of a half-edge leaves the vertex it points to.
    BrokenLoop,
    /// All half-edges of a loop have the same face.
    FaceOfLoop,
    /// A face's half-edge lies in that face.
    HalfedgeOfFace,
    /// A face has at least three corners.
    TooFewCorners,
    /// A face has each vertex only once.
    RepeatedCorner,
    /// The ends of an edge are different vertices.
    LoopEdge,
    /// An edge has a face on at least one side.
    EdgeWithoutFace,
    /// A vertex's half-edge leaves it.
    HalfedgeOfVertex,
    /// The half-edge of a vertex on the boundary is a boundary one.
    BoundaryFirst,
    /// A walk around a vertex reaches all half-edges that leave it.
    NonManifoldVertex,
    /// At most one edge joins two vertices.
    DuplicateEdge,
    /// Positions are finite.
    PositionNotFinite,
}

impl fmt::Display for Rule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::ColumnLength => "its columns differ in length",
            Self::DanglingLink => "it is linked to something that doesn't exist",
            Self::NextAndPrev => "next and previous disagree",
            Self::BrokenLoop => "its next half-edge doesn't leave the vertex it points to",
            Self::FaceOfLoop => "its loop has more than one face",
            Self::HalfedgeOfFace => "its half-edge lies in another face",
            Self::TooFewCorners => "it has fewer than three corners",
            Self::RepeatedCorner => "it has the same vertex at two corners",
            Self::LoopEdge => "both its ends are the same vertex",
            Self::EdgeWithoutFace => "it has no face on either side",
            Self::HalfedgeOfVertex => "its half-edge doesn't leave it",
            Self::BoundaryFirst => "it is on the boundary and its half-edge isn't",
            Self::NonManifoldVertex => "its faces don't form one fan",
            Self::DuplicateEdge => "another edge joins the same two vertices",
            Self::PositionNotFinite => "its position is not finite",
        })
    }
}

impl fmt::Display for Defect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}: {}", self.element, self.id, self.rule)
    }
}

impl std::error::Error for Defect {}

fn defect(element: Element, id: u32, rule: Rule) -> Result<(), Defect> {
    Err(Defect { element, id, rule })
}

/// Per vertex the last walk that reached it, which tells in O(1) whether a walk reaches it twice.
struct Stamps(Vec<u32>);

impl Stamps {
    fn first_time(&mut self, v: VertexId, walk: u32) -> bool {
        std::mem::replace(&mut self.0[v.index()], walk) != walk
    }
}

impl Mesh {
    /// Checks all rules; the error names the first broken one. Costs O(mesh) time and memory.
    pub fn validate(&self) -> Result<(), Defect> {
        self.check_columns()?;
        for h in self.halfedges() {
            self.check_halfedge(h)?;
        }
        for f in self.faces() {
            self.check_face_halfedge(f)?;
        }
        for v in self.vertices() {
            self.check_vertex_halfedge(v)?;
        }
        let mut stamps = Stamps(vec![NONE; self.vertex_capacity()]);
        let mut in_faces = 0;
        for f in self.faces() {
            in_faces += self.check_corners(f, |v| stamps.first_time(v, f.raw()))?;
        }
        let (mut around, mut boundary) = (0, 0);
        stamps.0.fill(NONE);
        for v in self.vertices() {
            let before = boundary;
            for h in self.outgoing(v) {
                around += 1;
                boundary += usize::from(self.is_boundary_halfedge(h));
                if !stamps.first_time(self.to(h), v.raw()) {
                    return defect(Element::Edge, h.edge().raw(), Rule::DuplicateEdge);
                }
            }
            if boundary > before + 1 {
                return defect(Element::Vertex, v.raw(), Rule::NonManifoldVertex);
            }
        }
        // A walk around its from-vertex reaches each half-edge, and so does its face's loop.
        if around != self.halfedge_count() {
            return self.find_unreached();
        }
        if in_faces + boundary != self.halfedge_count() {
            for h in self.halfedges() {
                if self.face_of(h).is_some_and(|f| !self.face_halfedges(f).any(|side| side == h)) {
                    return defect(Element::Halfedge, h.raw(), Rule::HalfedgeOfFace);
                }
            }
        }
        Ok(())
    }

    /// Checks the rules at and around these vertices and faces: those that an edit's journal touched. Elements that
    /// don't exist are ignored. The cost depends only on valences and face degrees.
    pub fn validate_near(
        &self,
        vertices: impl IntoIterator<Item = VertexId>,
        faces: impl IntoIterator<Item = FaceId>,
    ) -> Result<(), Defect> {
        let mut met = Vec::new();
        for f in faces.into_iter().filter(|&f| self.has_face(f)) {
            self.check_face_halfedge(f)?;
            for h in self.face_halfedges(f) {
                self.check_halfedge(h)?;
            }
            met.clear();
            met.extend(self.face_vertices(f));
            met.sort_unstable();
            let repeated = met.windows(2).any(|pair| pair[0] == pair[1]);
            self.check_corners(f, |_| !repeated)?;
        }
        for v in vertices.into_iter().filter(|&v| self.has_vertex(v)) {
            self.check_vertex_halfedge(v)?;
            met.clear();
            let mut gaps = 0;
            for h in self.outgoing(v) {
                if !self.has_halfedge(h) {
                    return defect(Element::Vertex, v.raw(), Rule::DanglingLink);
                }
                self.check_halfedge(h)?;
                gaps += usize::from(self.is_boundary_halfedge(h));
                met.push(self.to(h));
            }
            met.sort_unstable();
            if met.windows(2).any(|pair| pair[0] == pair[1]) {
                return defect(Element::Vertex, v.raw(), Rule::DuplicateEdge);
            }
            if gaps > 1 {
                return defect(Element::Vertex, v.raw(), Rule::NonManifoldVertex);
            }
        }
        Ok(())
    }

    fn check_columns(&self) -> Result<(), Defect> {
        let halfedges = self.next.len();
        if [self.prev.len(), self.to.len(), self.face.len()].iter().any(|&len| len != halfedges)
            || halfedges % 2 == 1
        {
            return defect(Element::Halfedge, 0, Rule::ColumnLength);
        }
        if self.vertex_halfedge.len() != self.positions.len() {
            return defect(Element::Vertex, 0, Rule::ColumnLength);
        }
        for element in Element::ALL {
            if self.columns.of(element).iter().any(|column| column.values.len() != self.capacity(element)) {
                return defect(element, 0, Rule::ColumnLength);
            }
        }
        Ok(())
    }

    fn check_halfedge(&self, h: HalfedgeId) -> Result<(), Defect> {
        let fail = |rule| defect(Element::Halfedge, h.raw(), rule);
        let links = [self.next[h.index()], self.prev[h.index()]];
        if links.iter().any(|&raw| self.halfedge(raw).is_none())
            || self.vertex(self.to[h.index()]).is_none()
            || self.face_of(h).is_some_and(|f| !self.has_face(f))
        {
            return fail(Rule::DanglingLink);
        }
        if self.to(h) == self.from(h) {
            return defect(Element::Edge, h.edge().raw(), Rule::LoopEdge);
        }
        let next = self.next(h);
        if self.prev(next) != h || self.next(self.prev(h)) != h {
            return fail(Rule::NextAndPrev);
        }
        if self.from(next) != self.to(h) {
            return fail(Rule::BrokenLoop);
        }
        if self.face_of(next) != self.face_of(h) {
            return fail(Rule::FaceOfLoop);
        }
        if self.is_boundary_halfedge(h) && self.is_boundary_halfedge(h.twin()) {
            return defect(Element::Edge, h.edge().raw(), Rule::EdgeWithoutFace);
        }
        Ok(())
    }

    fn check_face_halfedge(&self, f: FaceId) -> Result<(), Defect> {
        match self.halfedge(self.face_halfedge[f.index()]) {
            None => defect(Element::Face, f.raw(), Rule::DanglingLink),
            Some(h) if self.face_of(h) != Some(f) => defect(Element::Face, f.raw(), Rule::HalfedgeOfFace),
            Some(_) => Ok(()),
        }
    }

    fn check_vertex_halfedge(&self, v: VertexId) -> Result<(), Defect> {
        let fail = |rule| defect(Element::Vertex, v.raw(), rule);
        if !self.position(v).is_finite() {
            return fail(Rule::PositionNotFinite);
        }
        let raw = self.vertex_halfedge[v.index()];
        if raw == NONE {
            return Ok(());
        }
        let Some(h) = self.halfedge(raw) else { return fail(Rule::DanglingLink) };
        if self.from(h) != v {
            return fail(Rule::HalfedgeOfVertex);
        }
        if !self.is_boundary_halfedge(h) && self.outgoing(v).any(|h| self.is_boundary_halfedge(h)) {
            return fail(Rule::BoundaryFirst);
        }
        Ok(())
    }

    /// Checks a face's corners; returns their number.
    fn check_corners(
        &self,
        f: FaceId,
        mut first_time: impl FnMut(VertexId) -> bool,
    ) -> Result<usize, Defect> {
        let mut corners = 0;
        for v in self.face_vertices(f) {
            corners += 1;
            if !first_time(v) {
                return Err(Defect { element: Element::Face, id: f.raw(), rule: Rule::RepeatedCorner });
            }
        }
        if corners < 3 {
            return Err(Defect { element: Element::Face, id: f.raw(), rule: Rule::TooFewCorners });
        }
        Ok(corners)
    }

    fn find_unreached(&self) -> Result<(), Defect> {
        for h in self.halfedges() {
            let v = self.from(h);
            if !self.outgoing(v).any(|out| out == h) {
                return defect(Element::Vertex, v.raw(), Rule::NonManifoldVertex);
            }
        }
        Ok(())
    }
}
