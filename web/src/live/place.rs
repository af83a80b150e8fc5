//! Where the selected elements are: their middle, their normal, and what edits turn about.

use editor::Editor;
use glam::{DVec3, Vec3};
use halfedge::geometry::{BitSet, face_area_vector};
use halfedge::{Element, FaceId, Mesh, VertexId};

use crate::transforming::Pivot;

/// The selection's place and direction, in scene coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    /// The mean of the vertices, which `transform` takes as its pivot by itself.
    pub middle: Vec3,
    bounds_middle: Vec3,
    active: Vec3,
    origin: Vec3,
    /// The sum of the area vectors of the faces at the selection; zero where it has none.
    pub normal: Vec3,
    /// The direction and length of the edge selected last, from its even half-edge's start.
    pub edge: Vec3,
}

impl Place {
    /// The place of the selection; none if it is empty. Costs a pass over the selected elements.
    pub fn of_selection(editor: &Editor) -> Option<Self> {
        let (mesh, selection) = (editor.mesh()?, editor.selection());
        let kind = selection.kind();
        let latest = selection.latest()?;
        let mut seen = BitSet::default();
        let (mut sum, mut count, mut normal) = (DVec3::ZERO, 0usize, DVec3::ZERO);
        let (mut min, mut max) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for id in selection.ids() {
            for v in vertices(mesh, kind, id) {
                if seen.insert(v.index()) {
                    let at = mesh.position(v);
                    (sum, count, min, max) = (sum + at.as_dvec3(), count + 1, min.min(at), max.max(at));
                }
            }
            normal += faces(mesh, kind, id).map(|f| face_area_vector(mesh, f)).sum::<DVec3>();
        }
        let of_latest: Vec<Vec3> = vertices(mesh, kind, latest).map(|v| mesh.position(v)).collect();
        let edge = match of_latest.as_slice() {
            [from, to] => *to - *from,
            _ => Vec3::ZERO,
        };
        (count > 0).then(|| Self {
            middle: (sum / count as f64).as_vec3(),
            bounds_middle: min.midpoint(max),
            active: of_latest.iter().sum::<Vec3>() / of_latest.len().max(1) as f32,
            origin: -editor.document().offset().as_vec3(),
            normal: normal.normalize_or_zero().as_vec3(),
            edge,
        })
    }

    /// The point that stays in place.
    pub fn pivot(&self, pivot: Pivot) -> Vec3 {
        match pivot {
            Pivot::Middle | Pivot::Individual => self.middle,
            Pivot::Bounds => self.bounds_middle,
            Pivot::Active => self.active,
            Pivot::Origin => self.origin,
        }
    }
}

/// The vertices of an element; of an edge, from the start of its even half-edge.
pub(crate) fn vertices(mesh: &Mesh, kind: Element, id: u32) -> Box<dyn Iterator<Item = VertexId> + '_> {
    match kind {
        Element::Vertex => Box::new(mesh.vertex(id).into_iter()),
        Element::Edge => Box::new(mesh.edge(id).into_iter().flat_map(|e| mesh.ends(e))),
        Element::Halfedge => Box::new(mesh.halfedge(id).into_iter().flat_map(|h| [mesh.from(h), mesh.to(h)])),
        Element::Face => Box::new(mesh.face(id).into_iter().flat_map(|f| mesh.face_vertices(f))),
    }
}

/// The mean of an element's vertices; none if there is no such element.
pub(crate) fn mean_position(mesh: &Mesh, kind: Element, id: u32) -> Option<Vec3> {
    let positions: Vec<Vec3> = vertices(mesh, kind, id).map(|v| mesh.position(v)).collect();
    (!positions.is_empty()).then(|| positions.iter().sum::<Vec3>() / positions.len() as f32)
}

/// The faces at an element.
fn faces(mesh: &Mesh, kind: Element, id: u32) -> Box<dyn Iterator<Item = FaceId> + '_> {
    match kind {
        Element::Vertex => Box::new(mesh.vertex(id).into_iter().flat_map(|v| mesh.vertex_faces(v))),
        Element::Edge => {
            Box::new(mesh.edge(id).into_iter().flat_map(|e| e.halfedges()).filter_map(|h| mesh.face_of(h)))
        }
        Element::Halfedge => Box::new(mesh.halfedge(id).into_iter().filter_map(|h| mesh.face_of(h))),
        Element::Face => Box::new(mesh.face(id).into_iter()),
    }
}
