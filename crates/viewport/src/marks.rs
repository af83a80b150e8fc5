//! Marks: edges and vertices that one looks for, and normals, found in a mesh in parts.

use glam::Vec3;
use halfedge::geometry::{BitSet, face_area_vector};
use halfedge::{Budget, EdgeId, Element, HalfedgeId, InParts, Mesh, VertexId, keys};
use std::collections::{HashMap, HashSet};
use std::sync::Arc;
use surface::selecting::is_hidden;
use surface::{measure, normals};

use crate::corner_normals::{Hardness, Shading};

/// To look up a vertex's place takes about as long as this many other elements.
const ELEMENTS_PER_PLACE: usize = 4;

/// A kind of mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Edges with a face on one side only.
    Boundary,
    /// Edges with a crease, and those whose faces meet at a greater angle than [`Shading::HARD_ANGLE_DEGREES`].
    Sharp,
    /// Edges across which texture coordinates jump.
    Seam,
    /// Edges and vertices that lie where others do though their faces can't be joined there: what importing had to
    /// separate.
    NonManifold,
    /// The normals of faces, as lines.
    FaceNormals,
    /// The normals of vertices, as lines.
    VertexNormals,
}

impl Mark {
    /// All, in the order of menus.
    pub const ALL: [Self; 6] =
        [Self::Boundary, Self::Sharp, Self::Seam, Self::NonManifold, Self::FaceNormals, Self::VertexNormals];

    /// The name in scripts.
    pub fn name(self) -> &'static str {
        match self {
            Self::Boundary => "boundary",
            Self::Sharp => "sharp",
            Self::Seam => "seam",
            Self::NonManifold => "non-manifold",
            Self::FaceNormals => "face-normals",
            Self::VertexNormals => "vertex-normals",
        }
    }
}

/// A set of kinds of marks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Marks(u8);

impl Marks {
    /// Whether a kind is in the set.
    pub fn has(self, mark: Mark) -> bool {
        self.0 & (1 << mark as u8) != 0
    }

    /// The set with this kind added, or removed if it was there.
    #[must_use]
    pub fn toggled(self, mark: Mark) -> Self {
        Self(self.0 ^ (1 << mark as u8))
    }

    /// Whether the set is empty.
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The kinds in the set.
    pub fn iter(self) -> impl Iterator<Item = Mark> {
        Mark::ALL.into_iter().filter(move |mark| self.has(*mark))
    }
}

/// Two ends of a line.
pub(crate) type Line = [[f32; 3]; 2];

/// The marks of a mesh, relative to an origin.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Found {
    /// The lines of each kind.
    pub lines: [Vec<Line>; Mark::ALL.len()],
    /// Vertices of [`Mark::NonManifold`].
    pub points: Vec<[f32; 3]>,
}

/// The bits of a position; zero has one sign.
type Place = [u32; 3];

fn place(position: Vec3) -> Place {
    (position + Vec3::ZERO).to_array().map(f32::to_bits)
}

/// What the search does at the moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    /// Looks for vertices where others are.
    Places,
    /// Counts the faces at edges between such places, and finds the other marks of edges.
    Edges,
    /// Finds the edges of which too many are in one place.
    Crowded,
    /// The other marks of vertices.
    Vertices,
    Faces,
}

/// A search for marks.
pub(crate) struct MarkSearch {
    marks: Marks,
    origin: Vec3,
    /// The length of normals.
    length: f32,
    stage: Stage,
    next: usize,
    found: Found,
    /// The first vertex in each place.
    places: HashMap<Place, u32>,
    /// The vertices where others are too.
    shared: BitSet,
    /// The faces to both sides of the edges between two places, the lesser first.
    sides: HashMap<[Place; 2], [u32; 2]>,
    /// Places with several edges, whether they could be joined or not.
    edged: HashSet<Place>,
    /// Faces that are hidden with what belongs to no others.
    hidden: Arc<BitSet>,
}

impl MarkSearch {
    /// Begins a search; positions will be relative to the origin. Costs O(1).
    pub fn new(mesh: &Mesh, marks: Marks, origin: Vec3) -> Self {
        const SAMPLED_EDGES: usize = 1000;
        let sample = mesh.edges().take(SAMPLED_EDGES).map(|e| measure::edge_length(mesh, e));
        let (sum, count) = sample.fold((0.0, 0.0), |(sum, count), length| (sum + length, count + 1.0));
        Self {
            marks,
            origin,
            length: if count > 0.0 { (0.6 * sum / count) as f32 } else { 0.0 },
            stage: Stage::Places,
            next: 0,
            found: Found::default(),
            places: HashMap::new(),
            shared: BitSet::new(),
            sides: HashMap::new(),
            edged: HashSet::new(),
            hidden: Arc::default(),
        }
    }

    /// Finds no marks of hidden elements: these faces, and edges and vertices of no others.
    pub fn without(self, hidden: &Arc<BitSet>) -> Self {
        Self { hidden: hidden.clone(), ..self }
    }

    fn shows(&self, mesh: &Mesh, kind: Element, id: usize) -> bool {
        !is_hidden(mesh, kind, id, &self.hidden)
    }

    /// The kinds that are searched for.
    pub fn marks(&self) -> Marks {
        self.marks
    }

    fn push(&mut self, mark: Mark, line: Line) {
        if let Some(lines) = self.found.lines.get_mut(mark as usize) {
            lines.push(line);
        }
    }

    fn at(&self, mesh: &Mesh, v: VertexId) -> [f32; 3] {
        (mesh.position(v) - self.origin).to_array()
    }

    fn line(&self, mesh: &Mesh, e: EdgeId) -> Line {
        mesh.ends(e).map(|v| self.at(mesh, v))
    }

    fn visit(&mut self, mesh: &Mesh, id: u32) {
        match self.stage {
            Stage::Places => {
                if let Some(v) = mesh.vertex(id) {
                    let first = *self.places.entry(place(mesh.position(v))).or_insert(id);
                    if first != id {
                        self.shared.insert(first as usize);
                        self.shared.insert(id as usize);
                    }
                }
            }
            Stage::Edges => {
                if let Some(e) = mesh.edge(id) {
                    self.visit_edge(mesh, e);
                }
            }
            Stage::Crowded => {
                if let Some(e) = mesh.edge(id).filter(|e| self.shows(mesh, Element::Edge, e.index()))
                    && self.shared(mesh, e).and_then(|(key, _)| self.sides.get(&key)).is_some_and(is_crowded)
                {
                    self.push(Mark::NonManifold, self.line(mesh, e));
                }
            }
            Stage::Vertices => {
                if let Some(v) = mesh.vertex(id) {
                    self.visit_vertex(mesh, v);
                }
            }
            Stage::Faces => {
                if let Some(f) = mesh.face(id).filter(|f| self.shows(mesh, Element::Face, f.index())) {
                    let middle = (measure::face_center(mesh, f) - self.origin.as_dvec3()).as_vec3();
                    let tip = middle + normals::face_normal(mesh, f) * self.length;
                    self.push(Mark::FaceNormals, [middle.to_array(), tip.to_array()]);
                }
            }
        }
    }

    fn visit_edge(&mut self, mesh: &Mesh, e: EdgeId) {
        let line = self.line(mesh, e);
        let shows = self.shows(mesh, Element::Edge, e.index());
        if shows && self.marks.has(Mark::Boundary) && mesh.is_boundary_edge(e) {
            self.push(Mark::Boundary, line);
        }
        if shows && self.marks.has(Mark::Sharp) && is_sharp(mesh, e) {
            self.push(Mark::Sharp, line);
        }
        if shows && self.marks.has(Mark::Seam) && is_seam(mesh, e) {
            self.push(Mark::Seam, line);
        }
        if let Some((key, is_forward)) = self.shared(mesh, e) {
            let [left, right] = self.sides.entry(key).or_default();
            if *left + *right > 0 {
                self.edged.extend(key);
            }
            let h = e.halfedge();
            let [along, against] = [h, h.twin()].map(|h| u32::from(mesh.face_of(h).is_some()));
            let (to_left, to_right) = if is_forward { (along, against) } else { (against, along) };
            *left += to_left;
            *right += to_right;
        }
    }

    /// The places of an edge's ends and whether it runs from the first to the second; none unless there are other
    /// vertices at both.
    fn shared(&self, mesh: &Mesh, e: EdgeId) -> Option<([Place; 2], bool)> {
        if !self.marks.has(Mark::NonManifold) {
            return None;
        }
        let ends = [mesh.from(e.halfedge()), mesh.to(e.halfedge())];
        if !ends.iter().all(|v| self.shared.contains(v.index())) {
            return None;
        }
        let [a, b] = ends.map(|v| place(mesh.position(v)));
        (a != b).then(|| if a < b { ([a, b], true) } else { ([b, a], false) })
    }

    fn visit_vertex(&mut self, mesh: &Mesh, v: VertexId) {
        if mesh.halfedge_from(v).is_none() || !self.shows(mesh, Element::Vertex, v.index()) {
            return;
        }
        if self.marks.has(Mark::VertexNormals) {
            let tip = Vec3::from(self.at(mesh, v)) + normals::vertex_normal(mesh, v) * self.length;
            self.push(Mark::VertexNormals, [self.at(mesh, v), tip.to_array()]);
        }
        // Pieces that only touch at a vertex: no edges of them run along each other there.
        if self.marks.has(Mark::NonManifold)
            && self.shared.contains(v.index())
            && !self.edged.contains(&place(mesh.position(v)))
        {
            self.found.points.push(self.at(mesh, v));
        }
    }

    /// The number of ids to visit in this stage; 0 if nothing that is wanted needs it.
    fn ids(&self, mesh: &Mesh) -> usize {
        let wants = |marks: &[Mark]| marks.iter().any(|mark| self.marks.has(*mark));
        match self.stage {
            Stage::Places if wants(&[Mark::NonManifold]) => mesh.vertex_capacity(),
            Stage::Edges if wants(&[Mark::Boundary, Mark::Sharp, Mark::Seam, Mark::NonManifold]) => {
                mesh.edge_capacity()
            }
            Stage::Crowded if !self.sides.is_empty() => mesh.edge_capacity(),
            Stage::Vertices if wants(&[Mark::NonManifold, Mark::VertexNormals]) => mesh.vertex_capacity(),
            Stage::Faces if wants(&[Mark::FaceNormals]) => mesh.face_capacity(),
            _ => 0,
        }
    }
}

impl InParts for MarkSearch {
    type Input<'a> = &'a Mesh;
    type Output = Found;

    fn step(&mut self, mesh: &Mesh, budget: &mut Budget) -> Option<Found> {
        loop {
            let ids = self.ids(mesh);
            let cost = if self.stage == Stage::Places { ELEMENTS_PER_PLACE } else { 1 };
            if self.stage == Stage::Places && self.next == 0 {
                self.places.reserve(ids);
            }
            let wanted = ids.saturating_sub(self.next).saturating_mul(cost);
            let end = self.next + budget.take(wanted).div_ceil(cost);
            for id in self.next..end {
                self.visit(mesh, id as u32);
            }
            self.next = end;
            if end < ids {
                return None;
            }
            self.next = 0;
            self.stage = match self.stage {
                Stage::Places => Stage::Edges,
                Stage::Edges => Stage::Crowded,
                Stage::Crowded => Stage::Vertices,
                Stage::Vertices => Stage::Faces,
                Stage::Faces => return Some(std::mem::take(&mut self.found)),
            };
        }
    }
}

/// Whether two faces or more are on the same side of the edges in one place.
fn is_crowded(sides: &[u32; 2]) -> bool {
    sides.iter().any(|count| *count > 1)
}

fn is_sharp(mesh: &Mesh, e: EdgeId) -> bool {
    if mesh.get(keys::EDGE_CREASE, e.index()) > 0.0 {
        return true;
    }
    let h = e.halfedge();
    let (Some(left), Some(right)) = (mesh.face_of(h), mesh.face_of(h.twin())) else { return false };
    let [left, right] = [left, right].map(|f| face_area_vector(mesh, f));
    Hardness::new(Shading::HARD_ANGLE_DEGREES).is_hard(left, right)
}

fn is_seam(mesh: &Mesh, e: EdgeId) -> bool {
    let (h, t) = (e.halfedge(), e.halfedge().twin());
    if mesh.face_of(h).is_none() || mesh.face_of(t).is_none() {
        return false;
    }
    let uv = |h: HalfedgeId| mesh.get(keys::CORNER_UV, h.index());
    let differs = |a: glam::Vec2, b: glam::Vec2| a != b && !(a.is_nan() && b.is_nan());
    differs(uv(h), uv(mesh.next(t))) || differs(uv(t), uv(mesh.next(h)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{Vec2, vec3};
    use halfedge::PolygonSoup;

    fn build(positions: &[Vec3], faces: &[&[u32]]) -> Mesh {
        Mesh::build(PolygonSoup::new(positions.to_vec(), faces)).expect("a mesh").mesh
    }

    fn found(mesh: &Mesh, mark: Mark) -> Found {
        MarkSearch::new(mesh, Marks::default().toggled(mark), Vec3::ZERO).finish(mesh)
    }

    fn lines(mesh: &Mesh, mark: Mark) -> usize {
        found(mesh, mark).lines[mark as usize].len()
    }

    #[test]
    fn hidden_elements_are_not_marked() {
        let mesh = folded(90.0);
        let count = |hidden: &[usize], mark: Mark| {
            let hidden = Arc::new(hidden.iter().copied().collect());
            let search = MarkSearch::new(&mesh, Marks::default().toggled(mark), Vec3::ZERO).without(&hidden);
            search.finish(&mesh).lines[mark as usize].len()
        };
        for (hidden, expected) in [(&[][..], [6, 1, 2, 6]), (&[0], [3, 1, 1, 4]), (&[0, 1], [0; 4])] {
            let marks = [Mark::Boundary, Mark::Sharp, Mark::FaceNormals, Mark::VertexNormals];
            assert_eq!(marks.map(|mark| count(hidden, mark)), expected, "{hidden:?}");
        }
    }

    /// Two squares that share an edge, the second turned up by an angle.
    fn folded(degrees: f32) -> Mesh {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let far = |z| vec3(-cos, sin, z);
        let near = [vec3(0., 0., 0.), vec3(1., 0., 0.), vec3(1., 0., 1.), vec3(0., 0., 1.)];
        build(&[&near[..], &[far(0.0), far(1.0)]].concat(), &[&[0, 3, 2, 1], &[4, 5, 3, 0]])
    }

    #[test]
    fn boundaries_sharp_edges_and_seams() {
        assert_eq!(lines(&folded(0.0), Mark::Boundary), 6);
        assert_eq!(lines(&folded(20.0), Mark::Sharp), 0);
        assert_eq!(lines(&folded(40.0), Mark::Sharp), 1);
        let mut flat = folded(0.0);
        let shared = flat.edges().find(|e| !flat.is_boundary_edge(*e)).expect("the shared edge");
        flat.set(keys::EDGE_CREASE, shared.index(), 2.0);
        assert_eq!(lines(&flat, Mark::Sharp), 1);
        assert_eq!(lines(&flat, Mark::Seam), 0, "without texture coordinates there is no seam");
        for h in flat.faces().flat_map(|f| flat.face_halfedges(f).collect::<Vec<_>>()).collect::<Vec<_>>() {
            let p = flat.position(flat.from(h));
            flat.set(keys::CORNER_UV, h.index(), Vec2::new(p.x, p.z));
        }
        assert_eq!(lines(&flat, Mark::Seam), 0);
        flat.set(keys::CORNER_UV, shared.halfedge().index(), Vec2::new(7.0, 7.0));
        assert_eq!(lines(&flat, Mark::Seam), 1);
    }

    #[test]
    fn what_importing_separates_is_non_manifold() {
        let quads = |up: f32| [vec3(0., 0., 0.), vec3(0., 0., 1.), vec3(1., up, 0.), vec3(1., up, 1.)];
        let points = [&quads(0.0)[..], &quads(1.0)[2..], &quads(-1.0)[2..]].concat();
        // Three faces at the edge from 0 to 1.
        let three = build(&points, &[&[0, 1, 3, 2], &[0, 1, 5, 4], &[0, 1, 7, 6]]);
        let count = lines(&three, Mark::NonManifold);
        assert!((2..=3).contains(&count), "{count} edges in one place");
        // Two triangles that touch at a point.
        let touching =
            [vec3(0., 0., 0.), vec3(1., 0., 0.), vec3(1., 1., 0.), vec3(-1., 0., 0.), vec3(-1., -1., 0.)];
        let touching = build(&touching, &[&[0, 1, 2], &[0, 3, 4]]);
        assert_eq!(found(&touching, Mark::NonManifold).points, [[0.0; 3]; 2]);
        assert_eq!(lines(&touching, Mark::NonManifold), 0);
        // Two faces side by side that were never joined are only open.
        let open =
            [&quads(0.0)[..], &[vec3(0., 0., 0.), vec3(0., 0., 1.), vec3(-1., 0., 0.), vec3(-1., 0., 1.)]];
        let open = build(&open.concat(), &[&[0, 1, 3, 2], &[5, 4, 6, 7]]);
        let none = found(&open, Mark::NonManifold);
        assert_eq!((none.lines[Mark::NonManifold as usize].len(), none.points.len()), (0, 0));
        assert_eq!(lines(&open, Mark::Boundary), 8);
    }

    #[test]
    fn normals_stand_on_faces_and_vertices() {
        let flat = folded(0.0);
        for mark in [Mark::FaceNormals, Mark::VertexNormals] {
            let found = found(&flat, mark);
            let lines = &found.lines[mark as usize];
            assert_eq!(lines.len(), if mark == Mark::FaceNormals { 2 } else { 6 });
            for [from, to] in lines {
                let along = Vec3::from(*to) - Vec3::from(*from);
                assert!((along - Vec3::Y * 0.6).length() < 1e-5, "{along}");
            }
        }
    }

    #[test]
    fn a_search_in_parts_finds_the_same() {
        let mesh = folded(50.0);
        let all = Mark::ALL.into_iter().fold(Marks::default(), Marks::toggled);
        let whole = MarkSearch::new(&mesh, all, Vec3::X).finish(&mesh);
        let mut search = MarkSearch::new(&mesh, all, Vec3::X);
        let mut parts = 0;
        let found = loop {
            parts += 1;
            if let Some(found) = search.step(&mesh, &mut Budget::new(3)) {
                break found;
            }
        };
        assert!(parts > 5, "{parts}");
        assert_eq!(found, whole);
    }
}
