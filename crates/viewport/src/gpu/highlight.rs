//! Highlights of selected and hovered elements: fainter where faces hide them.

use super::frame::Shape;
use super::stream::Stream;
use glam::Vec3;
use halfedge::geometry::{BitSet, PolygonTriangulator};
use halfedge::{Budget, Element, FaceId, HalfedgeId, InParts, Mesh};
use surface::normals;

/// The highlights.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layer {
    /// The selection.
    Selected,
    /// The element that was selected last.
    Active,
    /// The element under the pointer.
    Hovered,
}

/// Elements to highlight.
#[derive(Clone, Copy, Debug)]
pub struct Highlight<'a> {
    /// Their object's id, as given to `sync_object`.
    pub object: u64,
    /// The object's mesh.
    pub mesh: &'a Mesh,
    /// The elements' kind.
    pub kind: Element,
    /// The elements' ids; those that don't exist are left out.
    pub ids: &'a [u32],
}

/// A highlight's buffers.
pub struct HighlightBuffers {
    pub object: Option<u64>,
    /// Vertices: a position each.
    pub points: Stream,
    /// Edges, or the outline of the faces: two positions each.
    pub lines: Stream,
    /// Half-edges: two positions and the direction into their face.
    pub arrows: Stream,
    /// Triangles of the faces: three positions each.
    pub fill: Stream,
    /// The elements that are still to be uploaded.
    pending: Option<Pending>,
}

/// Elements of a highlight that is uploaded some at a time.
struct Pending {
    kind: Element,
    origin: Vec3,
    ids: Vec<u32>,
    next: usize,
    /// The highlighted faces: edges between two of them aren't drawn.
    marked: BitSet,
}

/// The contents of the buffers; positions are relative to the object's origin.
#[derive(Default)]
struct Shapes {
    points: Vec<[f32; 3]>,
    lines: Vec<[[f32; 3]; 2]>,
    arrows: Vec<[[f32; 3]; 3]>,
    fill: Vec<[f32; 3]>,
}

impl HighlightBuffers {
    pub fn new() -> Self {
        Self {
            object: None,
            points: Stream::new("highlighted vertices"),
            lines: Stream::new("highlighted edges"),
            arrows: Stream::new("highlighted half-edges"),
            fill: Stream::new("highlighted faces"),
            pending: None,
        }
    }

    /// Begins a highlight, or none, that [`HighlightBuffers::step`] uploads. Costs O(elements),
    /// little for each.
    pub fn begin_upload(&mut self, device: &wgpu::Device, highlight: Option<(Highlight<'_>, Vec3)>) {
        self.object = highlight.map(|(h, _)| h.object);
        // Room for all if every face is a triangle; buffers grow for more.
        let room = |kind, size| match highlight {
            Some((h, _)) if h.kind == kind => h.ids.len() as u64 * size,
            _ => 0,
        };
        self.points.reset(device, room(Element::Vertex, 12));
        self.lines.reset(device, room(Element::Edge, 24));
        self.arrows.reset(device, room(Element::Halfedge, 36));
        self.fill.reset(device, room(Element::Face, 36));
        self.pending = highlight.map(|(h, origin)| {
            let Highlight { mesh, kind, ids, .. } = h;
            let mut marked = BitSet::new();
            let mut ids = ids.to_vec();
            if kind == Element::Face {
                ids.retain(|&id| mesh.face(id).is_some() && marked.insert(id as usize));
            }
            Pending { kind, origin, ids, next: 0, marked }
        });
    }

    /// The buffer of a kind of primitive.
    pub fn stream(&self, shape: Shape) -> &Stream {
        match shape {
            Shape::Fill => &self.fill,
            Shape::Lines => &self.lines,
            Shape::Arrows => &self.arrows,
            Shape::Points => &self.points,
        }
    }

    /// Whether there are elements left to upload.
    pub fn is_uploading(&self) -> bool {
        self.pending.is_some()
    }
}

/// Uploads the elements of the mesh that it began with.
impl InParts for HighlightBuffers {
    type Input<'a> = (&'a wgpu::Device, &'a wgpu::Queue, &'a Mesh);
    type Output = ();

    fn step(&mut self, (device, queue, mesh): Self::Input<'_>, budget: &mut Budget) -> Option<()> {
        let Some(pending) = &mut self.pending else { return Some(()) };
        let shapes = pending.take(mesh, budget);
        let is_left = pending.next < pending.ids.len();
        self.points.append(device, queue, &shapes.points);
        self.lines.append(device, queue, &shapes.lines);
        self.arrows.append(device, queue, &shapes.arrows);
        self.fill.append(device, queue, &shapes.fill);
        if is_left {
            return None;
        }
        self.pending = None;
        Some(())
    }
}

impl Pending {
    /// The shapes of more elements, as many as the budget has.
    fn take(&mut self, mesh: &Mesh, budget: &mut Budget) -> Shapes {
        let end = self.next + budget.take(self.ids.len() - self.next);
        let ids = self.ids.get(self.next..end).unwrap_or_default();
        self.next = end;
        shapes(mesh, self.kind, ids, &self.marked, self.origin)
    }
}

fn shapes(mesh: &Mesh, kind: Element, ids: &[u32], marked: &BitSet, origin: Vec3) -> Shapes {
    let mut shapes = Shapes::default();
    let ids = ids.iter().copied();
    let at = |v| (mesh.position(v) - origin).to_array();
    match kind {
        Element::Vertex => shapes.points.extend(ids.filter_map(|id| mesh.vertex(id)).map(at)),
        Element::Edge => {
            shapes.lines.extend(ids.filter_map(|id| mesh.edge(id)).map(|e| mesh.ends(e).map(at)));
        }
        Element::Halfedge => {
            for h in ids.filter_map(|id| mesh.halfedge(id)) {
                let inward = inward(mesh, h).to_array();
                shapes.arrows.push([at(mesh.from(h)), at(mesh.to(h)), inward]);
            }
        }
        Element::Face => faces(mesh, ids.filter_map(|id| mesh.face(id)), marked, origin, &mut shapes),
    }
    shapes
}

/// The unit direction across a half-edge into its face; for a boundary half-edge, out of the face
/// on the other side.
fn inward(mesh: &Mesh, h: HalfedgeId) -> Vec3 {
    let face = mesh.face_of(h).or_else(|| mesh.face_of(h.twin()));
    let normal = face.map_or(Vec3::Z, |f| normals::face_normal(mesh, f));
    let along = mesh.position(mesh.to(h)).as_dvec3() - mesh.position(mesh.from(h)).as_dvec3();
    normal.as_dvec3().cross(along.normalize_or_zero()).normalize_or_zero().as_vec3()
}

/// Adds the faces' triangles, and the edges between marked faces and others, so that many faces have one
/// outline.
fn faces(
    mesh: &Mesh,
    faces: impl Iterator<Item = FaceId>,
    marked: &BitSet,
    origin: Vec3,
    shapes: &mut Shapes,
) {
    let is_marked = |f: FaceId| marked.contains(f.index());
    let mut triangulator = PolygonTriangulator::new();
    let mut points = Vec::new();
    for face in faces {
        points.clear();
        points.extend(mesh.face_vertices(face).map(|v| mesh.position(v)));
        let corner = |i: u32| points.get(i as usize).map(|p| (*p - origin).to_array());
        shapes.fill.extend(triangulator.triangulate(&points).iter().flatten().filter_map(|&i| corner(i)));
        for h in mesh.face_halfedges(face) {
            if !mesh.face_of(h.twin()).is_some_and(is_marked) {
                shapes.lines.push([mesh.from(h), mesh.to(h)].map(|v| (mesh.position(v) - origin).to_array()));
            }
        }
    }
}
