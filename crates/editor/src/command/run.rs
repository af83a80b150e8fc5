//! How operations are carried out: the three ways, and what each is given.

use crate::bezier::Bezier;
use crate::command::{EdgeRef, FaceRef, Op, VertexRef};
use crate::document::{Document, Object, ObjectId};
use crate::error::Problem;
use crate::history::Change;
use crate::selection::Selection;
use halfedge::{EdgeId, Element, HalfedgeId, Mesh, PolygonSoup, Progress, VertexId};
use std::sync::Arc;

/// How an operation is carried out.
pub(crate) enum Action<'a> {
    /// On one mesh, recorded write by write.
    Local(&'a dyn LocalEdit),
    /// On whole meshes, giving others.
    WholeMesh(&'a dyn WholeMesh),
    /// On the list of objects.
    Document(&'a dyn DocumentEdit),
}

/// What an operation is resolved against.
pub(crate) struct Target<'a> {
    pub mesh: &'a Mesh,
    /// The selection; an empty one where the operation is for an object that isn't active.
    pub selection: &'a Selection,
}

impl Target<'_> {
    /// The selected vertices; for edges and faces that are selected, theirs.
    pub fn vertices(&self, field: &str) -> Result<Vec<VertexId>, Problem> {
        let mesh = self.mesh;
        let ids = self.selection.ids();
        let mut vertices: Vec<VertexId> = match self.selection.kind() {
            Element::Vertex => ids.filter_map(|id| mesh.vertex(id)).collect(),
            Element::Edge => ids.filter_map(|id| mesh.edge(id)).flat_map(|e| mesh.ends(e)).collect(),
            Element::Halfedge => {
                ids.filter_map(|id| mesh.halfedge(id)).flat_map(|h| mesh.ends(h.edge())).collect()
            }
            Element::Face => ids
                .filter_map(|id| mesh.face(id))
                .flat_map(|f| mesh.face_vertices(f).collect::<Vec<_>>())
                .collect(),
        };
        vertices.sort_unstable();
        vertices.dedup();
        if vertices.is_empty() { Err(missing(field, "nothing")) } else { Ok(vertices) }
    }

    /// The selected edges, or those of the selected half-edges.
    pub fn edges(&self, field: &str) -> Result<Vec<EdgeId>, Problem> {
        let mut edges: Vec<EdgeId> = match self.selection.kind() {
            Element::Edge => self.selection.ids().filter_map(|id| self.mesh.edge(id)).collect(),
            Element::Halfedge => {
                self.selection.ids().filter_map(|id| self.mesh.halfedge(id)).map(|h| h.edge()).collect()
            }
            _ => Vec::new(),
        };
        edges.dedup();
        if edges.is_empty() { Err(missing(field, "no edge")) } else { Ok(edges) }
    }

    /// Whether elements of this kind are selected.
    pub fn has_selected(&self, kind: Element) -> bool {
        self.selection.kind() == kind && !self.selection.is_empty()
    }

    /// The ids of the selected elements of exactly this kind.
    pub fn ids(&self, kind: Element, field: &str) -> Result<Vec<u32>, Problem> {
        if self.has_selected(kind) {
            return Ok(self.selection.ids().collect());
        }
        Err(missing(field, &format!("no {kind}")))
    }

    /// The id of the one selected element of this kind.
    pub fn only(&self, kind: Element, field: &str) -> Result<u32, Problem> {
        match self.ids(kind, field)?.as_slice() {
            [only] => Ok(*only),
            many => Err(wrong_number(field, many.len(), &format!("one {kind}"))),
        }
    }

    /// The one selected edge.
    pub fn only_edge(&self, field: &str) -> Result<EdgeId, Problem> {
        match self.edges(field)?.as_slice() {
            [only] => Ok(*only),
            many => Err(wrong_number(field, many.len(), "one edge")),
        }
    }

    /// The ids of the two selected elements of this kind, the one selected last second.
    pub fn two(&self, kind: Element, field: &str) -> Result<[u32; 2], Problem> {
        match self.ids(kind, field)?.as_slice() {
            &[a, b] if self.selection.latest() == Some(a) => Ok([b, a]),
            &[a, b] => Ok([a, b]),
            many => Err(wrong_number(field, many.len(), &format!("two of kind {kind}"))),
        }
    }

    /// The selected half-edges, and the boundary sides of selected edges.
    pub fn boundary(&self, field: &str) -> Result<Vec<HalfedgeId>, Problem> {
        if self.selection.kind() == Element::Halfedge {
            let ids = self.ids(Element::Halfedge, field)?;
            return Ok(ids.into_iter().filter_map(|id| self.mesh.halfedge(id)).collect());
        }
        let side = |e: EdgeId| {
            let sides = e.halfedges();
            sides.into_iter().find(|&h| self.mesh.is_boundary_halfedge(h)).unwrap_or(e.halfedge())
        };
        Ok(self.edges(field)?.into_iter().map(side).collect())
    }

    /// [`Target::boundary`] where there are two.
    pub fn two_boundary(&self, field: &str) -> Result<[HalfedgeId; 2], Problem> {
        match self.boundary(field)?.as_slice() {
            &[a, b] => Ok([a, b]),
            many => Err(wrong_number(field, many.len(), "two half-edges")),
        }
    }

    /// Fills in the selected vertices where none are given.
    pub fn fill_vertices(&self, list: &mut Option<Vec<VertexRef>>, field: &str) -> Result<(), Problem> {
        if list.is_none() {
            *list = Some(self.ids(Element::Vertex, field)?.into_iter().map(VertexRef).collect());
        }
        Ok(())
    }

    /// Fills in the selected edges, or those of the selected half-edges, where none are given.
    pub fn fill_edges(&self, list: &mut Option<Vec<EdgeRef>>, field: &str) -> Result<(), Problem> {
        if list.is_none() {
            *list = Some(self.edges(field)?.into_iter().map(EdgeRef::from).collect());
        }
        Ok(())
    }

    /// Fills in the selected faces where none are given.
    pub fn fill_faces(&self, list: &mut Option<Vec<FaceRef>>, field: &str) -> Result<(), Problem> {
        if list.is_none() {
            *list = Some(self.ids(Element::Face, field)?.into_iter().map(FaceRef).collect());
        }
        Ok(())
    }

    /// [`Target::fill_faces`] for a list that stands for all faces where it stays empty.
    pub fn fill_faces_or_all(&self, list: &mut Option<Vec<FaceRef>>) -> Result<(), Problem> {
        if self.has_selected(Element::Face) { self.fill_faces(list, "faces") } else { Ok(()) }
    }

    /// The operation on its vertex, or one on each selected vertex.
    pub fn each_vertex<O: Clone>(
        &self,
        op: O,
        field: &str,
        place: fn(&mut O) -> &mut Option<VertexRef>,
    ) -> Result<Vec<O>, Problem> {
        each(op, place, || Ok(self.ids(Element::Vertex, field)?.into_iter().map(VertexRef).collect()))
    }

    /// The operation on its edge, or one on each selected edge.
    pub fn each_edge<O: Clone>(
        &self,
        op: O,
        field: &str,
        place: fn(&mut O) -> &mut Option<EdgeRef>,
    ) -> Result<Vec<O>, Problem> {
        each(op, place, || Ok(self.edges(field)?.into_iter().map(EdgeRef::from).collect()))
    }

    /// The operation on its face, or one on each selected face.
    pub fn each_face<O: Clone>(
        &self,
        op: O,
        field: &str,
        place: fn(&mut O) -> &mut Option<FaceRef>,
    ) -> Result<Vec<O>, Problem> {
        each(op, place, || Ok(self.ids(Element::Face, field)?.into_iter().map(FaceRef).collect()))
    }
}

fn each<O: Clone, R>(
    mut op: O,
    place: fn(&mut O) -> &mut Option<R>,
    selected: impl FnOnce() -> Result<Vec<R>, Problem>,
) -> Result<Vec<O>, Problem> {
    if place(&mut op).is_some() {
        return Ok(vec![op]);
    }
    let on = |element| {
        let mut op = op.clone();
        *place(&mut op) = Some(element);
        op
    };
    Ok(selected()?.into_iter().map(on).collect())
}

fn missing(field: &str, what: &str) -> Problem {
    Problem::field(field, format!("is missing, and {what} is selected that it could stand for"))
}

fn wrong_number(field: &str, selected: usize, needed: &str) -> Problem {
    let are = if selected == 1 { "1 is" } else { &format!("{selected} are") };
    Problem::field(field, format!("is missing, and {are} selected where it takes {needed}"))
}

/// An operation on a few elements of one mesh. Called on resolved operations, whose elements are
/// all given.
pub(crate) trait LocalEdit {
    /// Whether the edit would succeed; where not, why.
    fn can(&self, mesh: &Mesh) -> Result<(), Problem>;

    /// Makes the edit, all or nothing: the caller takes back what was written before an error.
    /// What the user should know besides goes to `notes`.
    fn edit(&self, mesh: &mut Mesh, notes: &mut Vec<String>) -> Result<(), Problem>;

    /// Whether there is nothing left to do because an earlier one of several edits made in one step
    /// took the element away.
    fn is_moot(&self, mesh: &Mesh) -> bool {
        let _ = mesh;
        false
    }

    /// About how many faces are written to: what decides whether it becomes a job.
    fn cost(&self, mesh: &Mesh) -> usize {
        let _ = mesh;
        1
    }
}

/// A mesh that a whole-mesh operation reads.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Input {
    pub name: String,
    pub mesh: Arc<Mesh>,
    /// The control points that the mesh is made from.
    pub bezier: Option<Arc<Bezier>>,
    /// The faces as they were in the file, where the mesh had to be made something else.
    pub soup: Option<Arc<PolygonSoup>>,
}

/// A mesh that a whole-mesh operation made, with the name its object should have; an empty one
/// leaves the name as it is.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Output {
    pub name: String,
    pub mesh: Arc<Mesh>,
}

impl Output {
    pub fn new(name: impl Into<String>, mesh: Mesh) -> Self {
        Self { name: name.into(), mesh: Arc::new(mesh) }
    }
}

/// Refuses to edit the mesh that shows a Bezier object: the next movement of a control point would
/// make it anew.
pub(crate) fn refuse_bezier(name: &str, bezier: Option<&Bezier>) -> Result<(), Problem> {
    match bezier {
        None => Ok(()),
        Some(Bezier::Surface(_)) => Err(Problem::new(format!(
            "{name} is a Bezier surface; make it a mesh first, with `bezier-tessellate`"
        ))),
        Some(Bezier::Curve(_)) => {
            Err(Problem::new(format!("{name} is a Bezier curve, which has no vertices, edges or faces")))
        }
    }
}

/// What becomes of the meshes that a whole-mesh operation made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Commit {
    /// The first replaces the mesh it was made of; the others become objects after it.
    Replace,
    /// The one mesh replaces the first input's; the other inputs' objects go.
    Join,
    /// The document is started over with it.
    NewDocument,
    /// It becomes another object, the active one.
    NewObject,
}

/// An operation on whole meshes.
pub(crate) trait WholeMesh {
    /// Looks at the fields: what can be refused without looking at a mesh.
    fn check(&self) -> Result<(), Problem> {
        Ok(())
    }

    /// Looks at what it would run on, as far as that can be refused without running.
    fn check_inputs(&self, inputs: &[Input]) -> Result<(), Problem> {
        inputs.iter().try_for_each(|input| refuse_bezier(&input.name, input.bezier.as_deref()))
    }

    /// Whether it reads the faces as they were in the file.
    fn reads_soup(&self) -> bool {
        false
    }

    /// Makes the new meshes from the old ones. What the user should know besides goes to `notes`.
    fn compute(
        &self,
        inputs: &[Input],
        notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Vec<Output>, Problem>;

    /// About how many faces the result has: what decides whether it becomes a job.
    fn cost(&self, inputs: &[Input]) -> usize;

    /// Which objects it reads.
    fn objects(&self, place: &Place<'_>) -> Result<Vec<ObjectId>, Problem> {
        Ok(vec![place.object()?.id()])
    }

    /// What becomes of the result.
    fn commit(&self) -> Commit {
        Commit::Replace
    }
}

/// An operation on the list of objects.
pub(crate) trait DocumentEdit {
    /// The changes that make the edit, in order.
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem>;
}

/// Where in a document an operation acts.
pub(crate) struct Place<'a> {
    pub document: &'a Document,
    /// The command's `object`, if it has one.
    pub object: Option<usize>,
    /// The identity that an object has which the operation makes.
    pub next_object: ObjectId,
}

impl<'a> Place<'a> {
    /// The place in the list of the object that the command names, or else of the active one.
    pub fn index(&self) -> Result<usize, Problem> {
        match self.object {
            Some(at) => self.check(at, "object"),
            None if self.document.objects.is_empty() => Err(Problem::new("the document has no object")),
            None => Ok(self.document.active),
        }
    }

    /// The object that the command names, or else the active one.
    pub fn object(&self) -> Result<&'a Object, Problem> {
        let at = self.index()?;
        self.document.objects.get(at).ok_or_else(|| Problem::new("the document has no object"))
    }

    /// Checks a place in the list.
    pub fn check(&self, at: usize, field: &str) -> Result<usize, Problem> {
        match self.document.objects.len() {
            n if at < n => Ok(at),
            0 => Err(Problem::field(field, "the document has no object")),
            1 => Err(Problem::field(field, format!("there is no object {at}; the only one is 0"))),
            n => Err(Problem::field(field, format!("there is no object {at}; they go from 0 to {}", n - 1))),
        }
    }
}

/// Makes local edits one after the other; the first runs in any case, so that what is wrong with
/// it is told.
pub(crate) fn edit_all(
    ops: &[Op],
    mesh: &mut Mesh,
    notes: &mut Vec<String>,
    progress: &mut Progress<'_>,
) -> Result<(), Problem> {
    for (at, op) in ops.iter().enumerate() {
        let Action::Local(edit) = op.action() else {
            return Err(Problem::new("this op does not edit a few elements, so it can't be previewed"));
        };
        if progress(at as f32 / ops.len() as f32).is_break() {
            return Err(Problem::cancelled());
        }
        if at == 0 || !edit.is_moot(mesh) {
            edit.edit(mesh, notes)?;
        }
    }
    Ok(())
}
