//! `poke-faces`: cut faces from their centres.

use crate::error::Problem;
use crate::ops::refs::{all, corner_count};
use crate::ops::with_pieces;
use crate::ops::{Action, FaceRef, Field, LocalEdit, Operation, SYMMETRY, Scope, Selected, Slot, Spec};
use crate::outcome::ElementIds;
use crate::selection::Selection;
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Add a vertex at the centroid of each face and join it to every corner.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PokeFaces {
    /// The faces; the selected ones when left out.
    pub faces: Option<Vec<FaceRef>>,
}

impl Operation for PokeFaces {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "poke-faces",
        "Poke faces",
        "Add a vertex at the centre of each face and join it to every corner.",
    )
    .fields(&[Field::many("faces", Element::Face, Selected::All, "The faces to poke"), SYMMETRY]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Faces(&mut self.faces)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for PokeFaces {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_poke_faces(mesh, &all(&self.faces, "faces", mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::poke_faces(mesh, &all(&self.faces, "faces", mesh)?)?;
        Ok(())
    }

    fn selects(&self, mesh: &Mesh, created: &ElementIds) -> Option<Selection> {
        Some(with_pieces(mesh, self.faces.as_ref()?, created))
    }

    fn cuts_faces(&self) -> bool {
        true
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        corner_count(&self.faces, mesh)
    }
}
