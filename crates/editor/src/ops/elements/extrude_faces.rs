//! `extrude-faces`: move faces outward and build walls behind them.

use super::sized::{Mode, set_size};
use crate::error::Problem;
use crate::ops::refs::{all, corner_count};
use crate::ops::{
    Action, Drag, FaceRef, Family, Field, LocalEdit, Operation, SYMMETRY, Scope, Selected, Slot, Spec, Unit,
};
use halfedge::{Element, Mesh, NumberRange, edit};
use serde::{Deserialize, Serialize};

/// Move faces outward and build walls behind them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ExtrudeFaces {
    /// The faces; the selected ones when left out.
    pub faces: Option<Vec<FaceRef>>,
    /// How far outward, in mesh units; negative goes inward.
    #[serde(with = "crate::script::json::finite")]
    pub distance: f32,
    /// Whether faces that share an edge stay together.
    pub mode: Mode,
}

impl Operation for ExtrudeFaces {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "extrude-faces",
        "Extrude faces",
        "Move faces outward and build walls behind them.",
    )
    .family(Family::Extrude)
    .fields(&[
        Field::many("faces", Element::Face, Selected::All, "The faces to extrude"),
        Field::number("distance", Unit::Length, NumberRange::ANY, "How far outward, in mesh units")
            .drag(Drag::Distance),
        Mode::field("mode", "Whether faces that share an edge stay together"),
        SYMMETRY,
    ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Faces(&mut self.faces)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for ExtrudeFaces {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_extrude_faces(mesh, &all(&self.faces, "faces", mesh)?, self.mode.into())?)
    }

    fn edit(&self, mesh: &mut Mesh, notes: &mut Vec<String>) -> Result<(), Problem> {
        let live = edit::extrude_faces(mesh, &all(&self.faces, "faces", mesh)?, self.mode.into())?;
        set_size(mesh, &live, self.distance, "distance", notes)
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        corner_count(&self.faces, mesh)
    }
}
