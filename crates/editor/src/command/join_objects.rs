//! `join-objects`: several objects as one.

use super::{
    Action, Commit, Field, FieldKind, Input, Operation, OperationKind, Output, Place, Spec, WholeMesh,
};
use crate::document::{Object, ObjectId};
use crate::error::Problem;
use crate::pieces;
use halfedge::Progress;
use serde::{Deserialize, Serialize};

/// Makes several objects one; the first one given keeps its name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct JoinObjects {
    /// The places of the objects in the list, two or more; all if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub objects: Option<Vec<usize>>,
}

impl Operation for JoinObjects {
    const SPEC: Spec = Spec {
        name: "join-objects",
        label: "Join objects",
        description: "Makes several objects one; nothing is glued together.",
        key: None,
        kind: OperationKind::WholeMesh,
        fields: &[Field::new("objects", FieldKind::Objects, "The objects to join").or("all objects")],
    };

    fields_by_serde!();

    fn is_for_whole_meshes(&self) -> bool {
        false
    }

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl WholeMesh for JoinObjects {
    fn compute(
        &self,
        inputs: &[Input],
        _notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Vec<Output>, Problem> {
        if progress(0.0).is_break() {
            return Err(Problem::cancelled());
        }
        let mesh =
            pieces::join(inputs.iter().map(|input| &*input.mesh)).map_err(|e| Problem::new(e.to_string()))?;
        Ok(vec![Output::new("", mesh)])
    }

    fn cost(&self, inputs: &[Input]) -> usize {
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

    fn commit(&self) -> Commit {
        Commit::Join
    }
}
