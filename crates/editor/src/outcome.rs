//! What a command did.

use formats::ReportNote;
use halfedge::{EdgeId, FaceId, Mesh, Touched, VertexId};
use serde::Serialize;

/// What a command did: what was created and removed, in numbers and, for local edits, by id.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Outcome {
    /// The op.
    pub op: String,
    /// What is there that was not.
    pub created: Elements,
    /// What was there that is not.
    pub removed: Elements,
    /// One sentence for the user.
    pub message: String,
    /// What the user should know besides, such as what an import had to repair.
    pub warnings: Vec<String>,
    /// The import report, where the op was to open files.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub report: Vec<ReportNote>,
}

impl Outcome {
    /// The outcome of an op that created and removed these, with the sentence that says so.
    pub fn new(op: impl Into<String>, created: Elements, removed: Elements) -> Self {
        let op = op.into();
        let label = crate::OpId::named(&op).map_or(&*op, |id| id.spec().label);
        let message = message(label, &created, &removed);
        Self { op, created, removed, message, warnings: Vec::new(), report: Vec::new() }
    }
}

impl Outcome {
    /// The same outcome of an op that changed nothing, and says so.
    pub(crate) fn unchanged(self) -> Self {
        Self { message: format!("{}: nothing changed", self.message), ..self }
    }
}

/// Numbers of elements; which ones, where a local edit made or removed them.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Elements {
    /// How many vertices.
    pub vertices: usize,
    /// How many edges.
    pub edges: usize,
    /// How many faces.
    pub faces: usize,
    /// Which; none for operations on a whole mesh, which give every element a new id.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ids: Option<ElementIds>,
}

/// Ids per kind of element, in ascending order.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct ElementIds {
    /// Vertex ids.
    pub vertices: Vec<u32>,
    /// Edge ids.
    pub edges: Vec<u32>,
    /// Face ids.
    pub faces: Vec<u32>,
}

impl From<ElementIds> for Elements {
    fn from(ids: ElementIds) -> Self {
        Self { vertices: ids.vertices.len(), edges: ids.edges.len(), faces: ids.faces.len(), ids: Some(ids) }
    }
}

impl Elements {
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.vertices + self.edges + self.faces == 0
    }

    /// How many more elements `after` has than `before`, kind by kind; those it has fewer of
    /// count as none.
    pub(crate) fn gained(before: [usize; 3], after: [usize; 3]) -> Self {
        Self {
            vertices: after[0].saturating_sub(before[0]),
            edges: after[1].saturating_sub(before[1]),
            faces: after[2].saturating_sub(before[2]),
            ids: None,
        }
    }

    /// "1 vertex, 3 edges and 2 faces", leaving out what there is none of; none for nothing.
    fn words(&self) -> Option<String> {
        let parts: Vec<String> = [
            (self.vertices, "vertex", "vertices"),
            (self.edges, "edge", "edges"),
            (self.faces, "face", "faces"),
        ]
        .iter()
        .filter(|(count, ..)| *count > 0)
        .map(|(count, one, many)| format!("{count} {}", if *count == 1 { one } else { many }))
        .collect();
        match parts.as_slice() {
            [] => None,
            [only] => Some(only.clone()),
            [first @ .., last] => Some(format!("{} and {last}", first.join(", "))),
        }
    }
}

/// The numbers of vertices, edges and faces of some meshes together.
pub(crate) fn sizes<'a>(meshes: impl IntoIterator<Item = &'a Mesh>) -> [usize; 3] {
    meshes.into_iter().fold([0; 3], |[vertices, edges, faces], mesh| {
        [vertices + mesh.vertex_count(), edges + mesh.edge_count(), faces + mesh.face_count()]
    })
}

/// "Split edge: 1 vertex, 3 edges and 2 faces created".
pub(crate) fn message(label: &str, created: &Elements, removed: &Elements) -> String {
    match (created.words(), removed.words()) {
        (None, None) => label.to_owned(),
        (Some(made), None) => format!("{label}: {made} created"),
        (None, Some(gone)) => format!("{label}: {gone} removed"),
        (Some(made), Some(gone)) => format!("{label}: {made} created, {gone} removed"),
    }
}

/// How many ids of vertices, edges and faces a mesh had before a local edit.
#[derive(Clone, Copy)]
pub(crate) struct Before([usize; 3]);

impl Before {
    pub fn of(mesh: &Mesh) -> Self {
        Self([mesh.vertex_capacity(), mesh.edge_capacity(), mesh.face_capacity()])
    }

    /// What a local edit created and removed: it gives new elements ids past the old ones, and
    /// marks others as removed. What it created and removed itself is in neither.
    pub fn compare(self, mesh: &Mesh, touched: &Touched) -> (ElementIds, ElementIds) {
        let [vertices, edges, faces] = self.0.map(|n| n as u32);
        let range = |from: u32, to: usize| from..to as u32;
        let created = ElementIds {
            vertices: range(vertices, mesh.vertex_capacity())
                .filter(|&v| mesh.has_vertex(VertexId::new(v as usize)))
                .collect(),
            edges: range(edges, mesh.edge_capacity())
                .filter(|&e| mesh.has_edge(EdgeId::new(e as usize)))
                .collect(),
            faces: range(faces, mesh.face_capacity())
                .filter(|&f| mesh.has_face(FaceId::new(f as usize)))
                .collect(),
        };
        let removed = ElementIds {
            vertices: touched
                .vertices
                .iter()
                .filter(|v| v.raw() < vertices && !mesh.has_vertex(**v))
                .map(|v| v.raw())
                .collect(),
            edges: touched
                .edges
                .iter()
                .filter(|e| e.raw() < edges && !mesh.has_edge(**e))
                .map(|e| e.raw())
                .collect(),
            faces: touched
                .faces
                .iter()
                .filter(|f| f.raw() < faces && !mesh.has_face(**f))
                .map(|f| f.raw())
                .collect(),
        };
        (created, removed)
    }
}
