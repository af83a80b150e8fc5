//! How operations are carried out: on a few elements, on whole meshes, or on the list of objects.

use super::facts::{Estimate, Facts};
use super::symmetry::{Mirror, Mirroring, Reflection, edit_symmetric};
use super::{FaceRef, Op, SelectMode, Slot, Spec, Target};
use crate::bezier::Bezier;
use crate::document::{Document, Object, ObjectId};
use crate::error::Problem;
use crate::history::Change;
use crate::outcome::ElementIds;
use crate::selection::Selection;
use formats::NamedMesh;
use halfedge::geometry::BitSet;
use halfedge::{EdgeId, Element, FaceId, HalfedgeId, Mesh, Progress, VertexId};
use std::collections::BTreeSet;
use surface::MirrorImages;
use surface::selecting::Finding;

/// An operation: a struct with the fields of its JSON.
pub(crate) trait Operation: Clone {
    /// Its name, texts and fields.
    const SPEC: Spec;

    /// Its element fields, in the order of [`Operation::SPEC`].
    fn elements(&mut self) -> Vec<Slot<'_>> {
        Vec::new()
    }

    /// Fills in what depends on other fields, once the elements are filled in from the selection.
    fn complete(&mut self, target: &Target<'_>) -> Result<(), Problem> {
        let _ = target;
        Ok(())
    }

    /// Whether the fields ask for elements of the selection at all.
    fn takes_selection(&self) -> bool {
        true
    }

    /// Adapts operations whose elements the selection filled in, one for each selected element or one for all.
    fn from_selection(ops: Vec<Self>, mesh: &Mesh) -> Result<Vec<Self>, Problem> {
        let _ = mesh;
        Ok(ops)
    }

    /// How it is mirrored.
    const MIRRORING: Mirroring = Mirroring::Together;

    /// Reflects what its fields say besides the elements, which are replaced already.
    fn reflect(&mut self, reflection: Reflection) {
        let _ = reflection;
    }

    /// The operation for the mirror image; none where this one does the same, perhaps once it is adapted.
    fn pair(&mut self, image: Self, mesh: &Mesh) -> Option<Self> {
        let _ = mesh;
        Some(image)
    }

    /// How it is carried out.
    fn action(&self) -> Action<'_>;
}

/// How an operation is carried out.
pub(crate) enum Action<'a> {
    /// On one mesh, recorded write by write.
    Local(&'a dyn LocalEdit),
    /// On whole meshes, giving others.
    WholeMesh(&'a dyn WholeMesh),
    /// On the list of objects.
    Document(&'a dyn DocumentEdit),
    /// On the selection.
    Select(&'a dyn SelectEdit),
}

/// An operation on a few elements of one mesh. Called on resolved operations, whose elements are
/// all given.
pub(crate) trait LocalEdit {
    /// Whether the edit would succeed; where not, why.
    fn can(&self, mesh: &Mesh) -> Result<(), Problem>;

    /// Makes the edit, all or nothing: the caller undoes what was written before an error. Warnings
    /// go to `notes`.
    fn edit(&self, mesh: &mut Mesh, notes: &mut Vec<String>) -> Result<(), Problem>;

    /// Makes the edit where its lists have the mirror images of their elements too.
    fn edit_mirrored(
        &self,
        mesh: &mut Mesh,
        mirror: &Mirror<'_>,
        notes: &mut Vec<String>,
    ) -> Result<(), Problem> {
        let _ = mirror;
        self.edit(mesh, notes)
    }

    /// Why the edit would change nothing, where that is known beforehand: its menu entry is greyed.
    fn changes_nothing(&self, mesh: &Mesh) -> Option<&'static str> {
        let _ = mesh;
        None
    }

    /// Whether an earlier edit of the same undo step has made this one unnecessary, or removed its element.
    fn is_moot(&self, mesh: &Mesh) -> bool {
        let _ = mesh;
        false
    }

    /// Whether the faces that it makes are pieces of those that they get their attributes from, so that the pieces of a hidden
    /// face are hidden.
    fn cuts_faces(&self) -> bool {
        false
    }

    /// What to select after the edit, by what was created in its undo step; none if the elements that it acted on
    /// stay selected.
    fn selects(&self, mesh: &Mesh, created: &ElementIds) -> Option<Selection> {
        let _ = (mesh, created);
        None
    }

    /// The work in faces written to, at least as many as the edit creates: what decides whether it
    /// becomes a job.
    fn cost(&self, mesh: &Mesh) -> usize;
}

/// The created edges between created vertices.
pub(crate) fn edges_between_created(mesh: &Mesh, created: &ElementIds) -> Vec<EdgeId> {
    let is_new = |v: VertexId| created.vertices.binary_search(&v.raw()).is_ok();
    let edges = created.edges.iter().filter_map(|&id| mesh.edge(id));
    edges.filter(|&edge| mesh.ends(edge).into_iter().all(is_new)).collect()
}

/// Faces that were cut, with the pieces of them that were created: a cut is a created edge.
pub(crate) fn with_pieces(mesh: &Mesh, faces: &[FaceRef], created: &ElementIds) -> Selection {
    let mut pieces: Vec<FaceId> = faces.iter().filter_map(|face| mesh.face(face.0)).collect();
    let mut found: BTreeSet<FaceId> = pieces.iter().copied().collect();
    let mut at = 0;
    while let Some(&face) = pieces.get(at) {
        let is_cut = |h: &HalfedgeId| created.edges.binary_search(&h.edge().raw()).is_ok();
        let beside = mesh.face_halfedges(face).filter(is_cut).filter_map(|h| mesh.face_of(h.twin()));
        pieces.extend(beside.filter(|other| found.insert(*other)));
        at += 1;
    }
    Selection::of(Element::Face, found.into_iter().map(FaceId::raw))
}

/// Refuses to edit the mesh that shows a Bezier object: moving a control point would replace it.
pub(crate) fn refuse_bezier(name: &str, bezier: Option<&Bezier>) -> Result<(), Problem> {
    match bezier {
        None => Ok(()),
        Some(Bezier::Surface(_)) => Err(Problem::new(format!(
            "{name} is a Bezier surface; tessellate it first (`bezier-tessellate`)"
        ))
        .advise(format!("{name} is a Bezier surface. Tessellate it first."))),
        Some(Bezier::Curve(_)) => {
            Err(Problem::new(format!("{name} is a Bezier curve, which has no vertices, edges or faces"))
                .advise(format!("{name} is a Bezier curve, which has no faces.")))
        }
    }
}

/// Where the meshes go that a whole-mesh operation made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Commit {
    /// The first replaces the mesh it was made of; the others become objects after it.
    Replace,
    /// The one mesh replaces the first input's; the other inputs' objects are deleted.
    Join,
    /// It replaces the whole document.
    NewDocument,
    /// It becomes another object, the active one.
    NewObject,
}

/// An operation on whole meshes.
pub(crate) trait WholeMesh {
    /// Checks the fields: what can be refused without looking at a mesh.
    fn check(&self) -> Result<(), Problem> {
        Ok(())
    }

    /// Checks the meshes, as far as is possible without running the operation. Costs O(mesh) at most.
    fn check_inputs(&self, inputs: &[NamedMesh]) -> Result<(), Problem> {
        inputs.iter().try_for_each(|input| refuse_bezier(&input.name, input.bezier.as_deref()))
    }

    /// Why it would change nothing, where that is known beforehand: its menu entry is greyed.
    fn changes_nothing(&self, inputs: &[NamedMesh]) -> Option<&'static str> {
        let _ = inputs;
        None
    }

    /// Whether it reads the faces as they were in the file.
    fn reads_soup(&self) -> bool {
        false
    }

    /// Makes the new meshes from the old ones. Warnings go to `notes`.
    fn compute(
        &self,
        inputs: &[NamedMesh],
        notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Vec<NamedMesh>, Problem>;

    /// The elements of the result that a set of elements of one kind became; none where the result is made anew.
    fn follow(&self, mesh: &Mesh, element: Element, set: &BitSet) -> Option<BitSet> {
        let _ = (mesh, element, set);
        None
    }

    /// The size of the result; none where it is not worth showing.
    fn result(&self, facts: &Facts) -> Option<Estimate> {
        let _ = facts;
        None
    }

    /// The work in faces read or made, at least as many as the result has: what decides whether it
    /// becomes a job. Costs O(mesh) at most.
    fn cost(&self, inputs: &[NamedMesh]) -> usize;

    /// Which objects it reads.
    fn objects(&self, place: &Place<'_>) -> Result<Vec<ObjectId>, Problem> {
        Ok(vec![place.object()?.id()])
    }

    /// Whether the command line runs it on every object of a file.
    fn is_for_each_object(&self) -> bool {
        true
    }

    /// What becomes of the result.
    fn commit(&self) -> Commit {
        Commit::Replace
    }
}

/// An operation on the list of objects.
pub(crate) trait DocumentEdit {
    /// The changes that make the edit, in order; none where it changes nothing.
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem>;

    /// Why it would change nothing, where that is known beforehand: its menu entry is greyed.
    fn changes_nothing(&self, place: &Place<'_>) -> Option<&'static str> {
        let _ = place;
        None
    }
}

/// An operation on the selection of the active object.
pub(crate) trait SelectEdit {
    /// What to look for. Costs O(selection) at most.
    fn find(&self, target: &Target<'_>) -> Result<Finding, Problem>;

    /// How what is found changes the selection.
    fn mode(&self) -> SelectMode;

    /// Whether it selects hidden elements too, because it names them.
    fn takes_hidden(&self) -> bool {
        false
    }
}

/// Where in a document an operation acts.
pub(crate) struct Place<'a> {
    pub document: &'a Document,
    /// The command's `object`, if it has one.
    pub object: Option<usize>,
    /// The identity of the next object that is made.
    pub next_object: ObjectId,
    /// The selection on the active object.
    pub selection: &'a Selection,
}

impl<'a> Place<'a> {
    /// The place in the list of the object that the command names, or else of the active one.
    pub fn index(&self) -> Result<usize, Problem> {
        match self.object {
            Some(at) => self.check(at, "object"),
            None if self.document.objects.is_empty() => Err(no_object()),
            None => Ok(self.document.active),
        }
    }

    /// The object that the command names, or else the active one.
    pub fn object(&self) -> Result<&'a Object, Problem> {
        let at = self.index()?;
        self.document.objects.get(at).ok_or_else(no_object)
    }

    /// The selection, if the object is the active one.
    pub fn selection(&self) -> Option<&'a Selection> {
        (self.index().ok()? == self.document.active).then_some(self.selection)
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

fn no_object() -> Problem {
    Problem::new("the document has no object")
        .advise("There is no object. Open a file or make a shape first.")
}

/// Makes local edits, with the mirror images of their elements if there are any.
pub(crate) fn edit_local(
    ops: &[Op],
    images: Option<&mut MirrorImages>,
    mesh: &mut Mesh,
    notes: &mut Vec<String>,
    progress: &mut Progress<'_>,
) -> Result<(), Problem> {
    match images {
        Some(images) => edit_symmetric(ops, images, mesh, notes, progress),
        None => edit_all(ops, mesh, notes, progress),
    }
}

/// Makes local edits one after the other. The first always runs, so that its refusal is reported.
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
