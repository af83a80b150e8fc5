//! `isolate`: hide everything else.

use super::hiding::{faces_of, fields};
use crate::error::Problem;
use crate::history::Change;
use crate::ops::{
    Action, DocumentEdit, EdgeRef, FaceRef, Field, Operation, Place, Scope, Slot, Spec, VertexRef,
};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Hide everything else. Repeat to show everything.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Isolate {
    /// Faces; when nothing is given, the selection.
    pub faces: Option<Vec<FaceRef>>,
    /// Edges: the faces beside them.
    pub edges: Option<Vec<EdgeRef>>,
    /// Vertices: the faces around them.
    pub vertices: Option<Vec<VertexRef>>,
}

const FIELDS: [Field; 3] = fields("Faces to keep");

impl Operation for Isolate {
    const SPEC: Spec =
        Spec::new(Scope::Selection, "isolate", "Isolate", "Hide everything else. Repeat to show everything.")
            .synonyms(&["local view", "hide unselected", "solo"])
            .fields(&FIELDS);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Faces(&mut self.faces), Slot::Edges(&mut self.edges), Slot::Vertices(&mut self.vertices)]
    }

    fn action(&self) -> Action<'_> {
        Action::Document(self)
    }
}

impl DocumentEdit for Isolate {
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem> {
        let object = place.object()?;
        let (mesh, hidden) = (object.mesh(), object.hidden());
        let faces = faces_of(place, &self.faces, &self.edges, &self.vertices)?;
        let mut others: halfedge::geometry::BitSet = mesh.faces().map(|f| f.index()).collect();
        others.subtract(&faces);
        if others == **hidden {
            others = Default::default();
        }
        Ok(if others == **hidden { Vec::new() } else { vec![Change::Hidden(object.id(), Arc::new(others))] })
    }
}
