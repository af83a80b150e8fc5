//! `join-objects`: join several objects into one.

use crate::document::{Object, ObjectId};
use crate::error::Problem;
use crate::ops::{Action, Commit, Field, FieldKind, NamedMesh, Operation, Place, Scope, Spec, WholeMesh};
use halfedge::Progress;
use serde::{Deserialize, Serialize};

/// Join several objects into one; the first one given keeps its name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct JoinObjects {
    /// The places of the objects in the list, two or more; all when left out.
    pub objects: Option<Vec<usize>>,
}

impl Operation for JoinObjects {
    const SPEC: Spec = Spec::new(
        Scope::Meshes,
        "join-objects",
        "Join objects",
        "Join several objects into one; no vertices are merged.",
    )
    .synonyms(&["combine", "attach"])
    .fields(&[Field::required("objects", FieldKind::Objects, "The objects to join").optional("all objects")]);

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl WholeMesh for JoinObjects {
    fn compute(
        &self,
        inputs: &[NamedMesh],
        _notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Vec<NamedMesh>, Problem> {
        if progress(0.0).is_break() {
            return Err(Problem::cancelled());
        }
        let mesh = surface::join_meshes(inputs.iter().map(|input| &*input.mesh))
            .map_err(|e| Problem::new(e.to_string()))?;
        Ok(vec![NamedMesh::new("", mesh)])
    }

    fn cost(&self, inputs: &[NamedMesh]) -> usize {
        inputs.iter().map(|input| input.mesh.face_count()).sum()
    }

    fn objects(&self, place: &Place<'_>) -> Result<Vec<ObjectId>, Problem> {
        let objects = &place.document.objects;
        let Some(list) = &self.objects else {
            return match objects.len() {
                0 | 1 => Err(Problem::new("there is only one object, so there is nothing to join")),
                _ => Ok(objects.iter().map(Object::id).collect()),
            };
        };
        let mut ids = Vec::with_capacity(list.len());
        for (at, &index) in list.iter().enumerate() {
            let field = format!("objects[{at}]");
            let id = objects.get(place.check(index, &field)?).map(Object::id);
            match id {
                Some(id) if !ids.contains(&id) => ids.push(id),
                _ => return Err(Problem::field(field, format!("object {index} is given twice"))),
            }
        }
        if ids.len() < 2 {
            return Err(Problem::field("objects", "joining takes two objects or more"));
        }
        Ok(ids)
    }

    fn is_for_each_object(&self) -> bool {
        false
    }

    fn commit(&self) -> Commit {
        Commit::Join
    }
}
