//! Where the selected elements are: their middle, their normal, and what edits turn about.

use editor::Editor;
use glam::{DVec3, Vec3};
use halfedge::geometry::{BitSet, face_area_vector, mean_position};
use halfedge::{EdgeId, Element, FaceId, HalfedgeId, Mesh, VertexId};
use surface::selecting::vertices;

use crate::transforming::Pivot;

/// The selection's place and direction, in scene coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SelectionPlace {
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

impl SelectionPlace {
    /// The place of the selection; none if it is empty. Costs a pass over the selected elements.
    pub fn of_selection(editor: &Editor) -> Option<Self> {
        let selection = editor.selection();
        Self::of(editor, selection.kind(), selection.ids(), selection.latest()?)
    }

    /// The place of an edge; none if there is no edge with this id.
    pub fn of_edge(editor: &Editor, id: u32) -> Option<Self> {
        editor.mesh()?.edge(id)?;
        Self::of(editor, Element::Edge, [id], id)
    }

    /// The place of elements that exist, of which one is the latest.
    fn of(editor: &Editor, kind: Element, ids: impl IntoIterator<Item = u32>, latest: u32) -> Option<Self> {
        let mesh = editor.mesh()?;
        let mut seen = BitSet::default();
        let (mut sum, mut count, mut normal) = (DVec3::ZERO, 0usize, DVec3::ZERO);
        let (mut min, mut max) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for id in ids {
            vertices(mesh, kind, id as usize, |v| {
                if seen.insert(v.index()) {
                    let at = mesh.position(v);
                    (sum, count, min, max) = (sum + at.as_dvec3(), count + 1, min.min(at), max.max(at));
                }
            });
            faces(mesh, kind, id, |f| normal += face_area_vector(mesh, f));
        }
        let edge = match kind {
            Element::Edge => mesh.edge(latest),
            Element::Halfedge => mesh.halfedge(latest).map(|h| h.edge()),
            Element::Vertex | Element::Face => None,
        };
        let edge = edge.map_or(Vec3::ZERO, |e| {
            let [from, to] = mesh.ends(e).map(|v| mesh.position(v));
            to - from
        });
        (count > 0).then(|| Self {
            middle: (sum / count as f64).as_vec3(),
            bounds_middle: min.midpoint(max),
            active: mean_of_element(mesh, kind, latest),
            origin: -editor.document().offset().as_vec3(),
            normal: normal.normalize_or_zero().as_vec3(),
            edge,
        })
    }

    /// The point that stays in place, with the 3D cursor at `cursor`.
    pub fn pivot(&self, pivot: Pivot, cursor: Vec3) -> Vec3 {
        match pivot {
            Pivot::Middle | Pivot::Individual => self.middle,
            Pivot::Bounds => self.bounds_middle,
            Pivot::Active => self.active,
            Pivot::Origin => self.origin,
            Pivot::Cursor => cursor,
        }
    }
}

/// The mean of the vertices of an element that exists.
pub(crate) fn mean_of_element(mesh: &Mesh, kind: Element, id: u32) -> Vec3 {
    let mut all = Vec::new();
    vertices(mesh, kind, id as usize, |v| all.push(v));
    mean_position(mesh, all).as_vec3()
}

/// Visits the faces at an element.
fn faces(mesh: &Mesh, kind: Element, id: u32, visit: impl FnMut(FaceId)) {
    let at = id as usize;
    match kind {
        Element::Vertex => mesh.vertex_faces(VertexId::new(at)).for_each(visit),
        Element::Edge => {
            EdgeId::new(at).halfedges().into_iter().filter_map(|h| mesh.face_of(h)).for_each(visit)
        }
        Element::Halfedge => mesh.face_of(HalfedgeId::new(at)).into_iter().for_each(visit),
        Element::Face => std::iter::once(FaceId::new(at)).for_each(visit),
    }
}

/// The vertices of the selection, by index.
pub(crate) fn selected_vertices(editor: &Editor) -> BitSet {
    let (mut all, selection) = (BitSet::default(), editor.selection());
    let Some(mesh) = editor.mesh() else { return all };
    for id in selection.ids() {
        vertices(mesh, selection.kind(), id as usize, |v| {
            all.insert(v.index());
        });
    }
    all
}
