//! Selected and hovered elements: drawn over everything, whatever is in front of them.

use super::stream::Stream;
use glam::Vec3;
use halfedge::geometry::{BitSet, PolygonTriangulator};
use halfedge::{Element, FaceId, HalfedgeId, Mesh};
use surface::normals;

/// Which highlight: they are drawn one over the other, in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layer {
    /// The selection.
    Selected,
    /// What the pointer is over.
    Hovered,
}

/// Elements to be highlighted.
#[derive(Clone, Copy, Debug)]
pub struct Highlight<'a> {
    /// The object they are of, as told to `sync_object`.
    pub object: u64,
    /// Its mesh.
    pub mesh: &'a Mesh,
    /// Their kind.
    pub kind: Element,
    /// Their ids; those that don't exist are left out.
    pub ids: &'a [u32],
}

/// A highlight's buffers.
pub struct Marked {
    pub object: Option<u64>,
    /// Vertices: a position each.
    pub points: Stream,
    /// Edges, or the outline of the faces: two positions each.
    pub lines: Stream,
    /// Half-edges: two positions and the direction into their face.
    pub arrows: Stream,
    /// Triangles of the faces: three positions each.
    pub fill: Stream,
    /// What is still to be uploaded.
    rest: Option<Rest>,
}

/// Elements of a highlight that is uploaded some at a time.
struct Rest {
    kind: Element,
    origin: Vec3,
    ids: Vec<u32>,
    next: usize,
    /// The faces that are highlighted: edges between two are not drawn.
    marked: BitSet,
}

/// What goes into the buffers; positions relative to the object's origin.
#[derive(Default)]
struct Shapes {
    points: Vec<[f32; 3]>,
    lines: Vec<[[f32; 3]; 2]>,
    arrows: Vec<[[f32; 3]; 3]>,
    fill: Vec<[f32; 3]>,
}

impl Marked {
    pub fn new() -> Self {
        Self {
            object: None,
            points: Stream::new("highlighted vertices"),
            lines: Stream::new("highlighted edges"),
            arrows: Stream::new("highlighted half-edges"),
            fill: Stream::new("highlighted faces"),
            rest: None,
        }
    }

    /// Begins with a highlight, or none, which [`Marked::upload_elements`] uploads. Costs O(elements), little for
    /// each.
    pub fn begin_upload(&mut self, device: &wgpu::Device, highlight: Option<(Highlight<'_>, Vec3)>) {
        self.object = highlight.map(|(h, _)| h.object);
        // Room for all of it where every face is a triangle; for more they grow.
        let room = |kind, size| match highlight {
            Some((h, _)) if h.kind == kind => h.ids.len() as u64 * size,
            _ => 0,
        };
        self.points.reset(device, room(Element::Vertex, 12));
        self.lines.reset(device, room(Element::Edge, 24));
        self.arrows.reset(device, room(Element::Halfedge, 36));
        self.fill.reset(device, room(Element::Face, 36));
        self.rest = highlight.map(|(h, origin)| {
            let Highlight { mesh, kind, ids, .. } = h;
            let mut marked = BitSet::new();
            let mut ids = ids.to_vec();
            if kind == Element::Face {
                ids.retain(|&id| mesh.face(id).is_some() && marked.insert(id as usize));
            }
            Rest { kind, origin, ids, next: 0, marked }
        });
    }

    /// Whether there is more to upload.
    pub fn is_uploading(&self) -> bool {
        self.rest.is_some()
    }

    /// Uploads so many elements more, of the mesh that it began with; gives whether there are any left.
    pub fn upload_elements(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        mesh: &Mesh,
        elements: usize,
    ) -> bool {
        let Some(rest) = &mut self.rest else { return false };
        let shapes = rest.take(mesh, elements);
        let is_left = rest.next < rest.ids.len();
        self.points.append(device, queue, &shapes.points);
        self.lines.append(device, queue, &shapes.lines);
        self.arrows.append(device, queue, &shapes.arrows);
        self.fill.append(device, queue, &shapes.fill);
        if !is_left {
            self.rest = None;
        }
        is_left
    }
}

impl Rest {
    /// The shapes of so many elements more.
    fn take(&mut self, mesh: &Mesh, elements: usize) -> Shapes {
        let end = self.next.saturating_add(elements).min(self.ids.len());
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

/// Triangles of the faces, and the edges between those that are marked and the others: many faces are
/// outlined as one region.
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
