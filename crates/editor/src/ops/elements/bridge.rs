//! `bridge`: join two boundary loops with faces.

use crate::error::Problem;
use crate::ops::refs::two;
use crate::ops::{Action, Field, HalfedgeRef, LocalEdit, Operation, Scope, Slot, Spec};
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Join two boundary loops with a band of faces.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Bridge {
    /// A boundary half-edge of each loop; the two selected ones when left out.
    pub halfedges: Option<[HalfedgeRef; 2]>,
}

impl Operation for Bridge {
    const SPEC: Spec =
        Spec::new(Scope::Elements, "bridge", "Bridge", "Join two boundary loops with a band of faces.")
            .synonyms(&["bridge edge loops"])
            .fields(&[Field::two("halfedges", Element::Halfedge, "A boundary half-edge of each loop")]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::TwoHalfedges(&mut self.halfedges)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for Bridge {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_bridge(mesh, two(self.halfedges, "halfedges", mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::bridge(mesh, two(self.halfedges, "halfedges", mesh)?)?;
        Ok(())
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        // Each half-edge of either loop gets at most one face.
        let loops = two(self.halfedges, "halfedges", mesh);
        loops.map_or(0, |loops| loops.into_iter().map(|h| mesh.loop_of(h).count()).sum())
    }
}
