//! What a command did.

use crate::Task;
use formats::ReportNote;
use halfedge::words::counted;
use halfedge::{EdgeId, FaceId, Mesh, Touched, VertexId};
use serde::Serialize;
use std::collections::HashMap;

/// What a command created and removed: in numbers and, for local edits, by id.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Outcome {
    /// The operation, or what else was done.
    pub op: Task,
    /// The elements that were created.
    pub created: Elements,
    /// The elements that were removed.
    pub removed: Elements,
    /// One sentence for the user.
    pub message: String,
    /// What else the user should know, such as what an import had to repair.
    pub warnings: Vec<String>,
    /// The import report, if the command opened files.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub report: Vec<ReportNote>,
}

impl Outcome {
    /// The outcome of an operation that created and removed these elements, with a sentence that says so.
    pub fn new(op: Task, created: Elements, removed: Elements) -> Self {
        let message = message(op.label(), &created, &removed);
        Self { op, created, removed, message, warnings: Vec::new(), report: Vec::new() }
    }
}

impl Outcome {
    /// The same outcome, with a message about what was created only: what was there before is another document.
    pub(crate) fn into_new_document(self) -> Self {
        Self { message: message(self.op.label(), &self.created, &Elements::default()), ..self }
    }

    /// The same outcome, with a message that nothing changed.
    pub(crate) fn unchanged(self) -> Self {
        Self { message: format!("{}: nothing changed", self.message), ..self }
    }
}

/// Counts of elements and, for local edits, their ids.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Elements {
    /// How many vertices.
    pub vertices: usize,
    /// How many edges.
    pub edges: usize,
    /// How many faces.
    pub faces: usize,
    /// The ids; none for operations on whole meshes, which renumber every element.
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
    /// For each face that was cut off another one, where the operation cuts faces, the one that was there before.
    #[serde(skip)]
    pub(crate) cut_from: Vec<u32>,
}

impl ElementIds {
    /// Notes of created faces which ones they were cut from. `sources` are new faces with those that they were made from.
    pub(crate) fn with_sources(self, sources: &[(FaceId, FaceId)]) -> Self {
        // What was cut from a piece was cut from the whole.
        let mut wholes: HashMap<u32, u32> = HashMap::new();
        for (made, source) in sources {
            let whole = wholes.get(&source.raw()).copied().unwrap_or(source.raw());
            wholes.insert(made.raw(), whole);
        }
        let cut_from = self.faces.iter().map(|face| wholes.get(face).copied().unwrap_or(*face)).collect();
        Self { cut_from, ..self }
    }

    /// The created faces that were cut from others, with those.
    pub(crate) fn pieces(&self) -> impl Iterator<Item = (u32, u32)> + '_ {
        self.faces.iter().copied().zip(self.cut_from.iter().copied()).filter(|(face, whole)| face != whole)
    }
}

impl From<ElementIds> for Elements {
    fn from(ids: ElementIds) -> Self {
        Self { vertices: ids.vertices.len(), edges: ids.edges.len(), faces: ids.faces.len(), ids: Some(ids) }
    }
}

impl Elements {
    /// Whether there are no elements.
    pub fn is_empty(&self) -> bool {
        self.vertices + self.edges + self.faces == 0
    }

    /// The increase from `before` to `after` for each kind of element; 0 where there was a decrease.
    pub(crate) fn gained(before: [usize; 3], after: [usize; 3]) -> Self {
        Self {
            vertices: after[0].saturating_sub(before[0]),
            edges: after[1].saturating_sub(before[1]),
            faces: after[2].saturating_sub(before[2]),
            ids: None,
        }
    }

    /// "1 vertex, 3 edges and 2 faces", without the kinds whose count is 0; none if all are.
    pub(crate) fn words(&self) -> Option<String> {
        let parts: Vec<String> = [
            (self.vertices, "vertex", "vertices"),
            (self.edges, "edge", "edges"),
            (self.faces, "face", "faces"),
        ]
        .iter()
        .filter(|(count, ..)| *count > 0)
        .map(|(count, one, many)| counted(*count, one, many))
        .collect();
        match parts.as_slice() {
            [] => None,
            [only] => Some(only.clone()),
            [first @ .., last] => Some(format!("{} and {last}", first.join(", "))),
        }
    }
}

/// The counts of vertices, edges and faces of several meshes together.
pub(crate) fn sizes<'a>(meshes: impl IntoIterator<Item = &'a Mesh>) -> [usize; 3] {
    meshes.into_iter().fold([0; 3], |[vertices, edges, faces], mesh| {
        [vertices + mesh.vertex_count(), edges + mesh.edge_count(), faces + mesh.face_count()]
    })
}

/// "Split edge: 1 vertex, 3 edges and 2 faces created".
fn message(label: &str, created: &Elements, removed: &Elements) -> String {
    match (created.words(), removed.words()) {
        (None, None) => label.to_owned(),
        (Some(made), None) => format!("{label}: {made} created"),
        (None, Some(gone)) => format!("{label}: {gone} removed"),
        (Some(made), Some(gone)) => format!("{label}: {made} created, {gone} removed"),
    }
}

/// The ends of the id ranges of vertices, edges and faces before a local edit.
#[derive(Clone, Copy)]
pub(crate) struct Before([usize; 3]);

impl Before {
    pub fn of(mesh: &Mesh) -> Self {
        Self([mesh.vertex_capacity(), mesh.edge_capacity(), mesh.face_capacity()])
    }

    /// The elements that a local edit created and removed. New elements have ids past the old ends; removed
    /// ones are marked. Elements that the edit both created and removed are in neither list.
    pub fn compare(self, mesh: &Mesh, touched: &Touched) -> (ElementIds, ElementIds) {
        let [vertices, edges, faces] = self.0.map(|n| n as u32);
        let range = |from: u32, to: usize| from..to as u32;
        let created = ElementIds {
            cut_from: Vec::new(),
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
            cut_from: Vec::new(),
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
