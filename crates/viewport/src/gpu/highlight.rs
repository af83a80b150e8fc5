//! Selected and hovered elements: drawn over everything, whatever is in front of them.

use super::stream::Stream;
use glam::Vec3;
use halfedge::{Element, FaceId, HalfedgeId, Mesh};
use surface::{CornerTriangulator, normals};

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
        }
    }

    /// Uploads a highlight, or none. Costs O(elements).
    pub fn set(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        highlight: Option<(Highlight<'_>, Vec3)>,
    ) {
        self.object = highlight.map(|(h, _)| h.object);
        let shapes = highlight.map_or_else(Shapes::default, |(h, origin)| shapes(h, origin));
        self.points.set(device, queue, &shapes.points);
        self.lines.set(device, queue, &shapes.lines);
        self.arrows.set(device, queue, &shapes.arrows);
        self.fill.set(device, queue, &shapes.fill);
    }
}

fn shapes(highlight: Highlight<'_>, origin: Vec3) -> Shapes {
    let Highlight { mesh, kind, ids, .. } = highlight;
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
        Element::Face => faces(mesh, ids.filter_map(|id| mesh.face(id)), origin, &mut shapes),
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

/// Triangles of the faces, and the edges between them and the others: many faces are outlined as
/// one region.
fn faces(mesh: &Mesh, faces: impl Iterator<Item = FaceId>, origin: Vec3, shapes: &mut Shapes) {
    let mut marked = vec![0_u64; mesh.face_capacity().div_ceil(64)];
    let mut list = Vec::new();
    for face in faces {
        if let Some(word) = marked.get_mut(face.index() / 64) {
            let bit = 1 << (face.index() % 64);
            if *word & bit == 0 {
                *word |= bit;
                list.push(face);
            }
        }
    }
    let is_marked = |f: FaceId| marked.get(f.index() / 64).is_some_and(|w| w >> (f.index() % 64) & 1 == 1);
    let mut triangulator = CornerTriangulator::new();
    let mut points = Vec::new();
    for face in list {
        points.clear();
        points.extend(mesh.face_vertices(face).map(|v| mesh.position(v)));
        let corner = |i: u32| points.get(i as usize).map(|p| (*p - origin).to_array());
        shapes.fill.extend(triangulator.of_polygon(&points).iter().flatten().filter_map(|&i| corner(i)));
        for h in mesh.face_halfedges(face) {
            if !mesh.face_of(h.twin()).is_some_and(is_marked) {
                shapes.lines.push([mesh.from(h), mesh.to(h)].map(|v| (mesh.position(v) - origin).to_array()));
            }
        }
    }
}
