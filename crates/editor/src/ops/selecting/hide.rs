//! `hide`: hide faces in the viewport.

use super::hiding::{faces_of, fields};
use crate::error::Problem;
use crate::history::Change;
use crate::ops::{
    Action, DocumentEdit, EdgeRef, FaceRef, Field, Operation, Place, Scope, Slot, Spec, VertexRef,
};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Hide faces, or the faces of edges and vertices, in the viewport.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Hide {
    /// Faces; when nothing is given, the selection.
    pub faces: Option<Vec<FaceRef>>,
    /// Edges: the faces beside them.
    pub edges: Option<Vec<EdgeRef>>,
    /// Vertices: the faces around them.
    pub vertices: Option<Vec<VertexRef>>,
}

const FIELDS: [Field; 3] = fields("Faces to hide");

impl Operation for Hide {
    const SPEC: Spec = Spec::new(
        Scope::Selection,
        "hide",
        "Hide",
        "Hide faces, or the faces of edges and vertices, in the viewport.",
    )
    .synonyms(&["hide selected"])
    .fields(&FIELDS);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Faces(&mut self.faces), Slot::Edges(&mut self.edges), Slot::Vertices(&mut self.vertices)]
    }

    fn action(&self) -> Action<'_> {
        Action::Document(self)
    }
}

impl DocumentEdit for Hide {
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem> {
        let object = place.object()?;
        let hidden = object.hidden();
        let faces = faces_of(place, &self.faces, &self.edges, &self.vertices)?;
        let mut all = (**hidden).clone();
        all.union_with(&faces);
        Ok(if all == **hidden { Vec::new() } else { vec![Change::Hidden(object.id(), Arc::new(all))] })
    }
}
