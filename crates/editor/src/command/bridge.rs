//! `bridge`: a band between two boundary loops.

use super::fields::pair;
use super::{Action, Field, FieldKind, HalfedgeRef, LocalEdit, Operation, OperationKind, Spec, Target};
use crate::error::Problem;
use halfedge::{Mesh, edit};
use serde::{Deserialize, Serialize};

/// Puts a band of faces between two boundary loops.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Bridge {
    /// A boundary half-edge of each loop; the two selected ones if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub halfedges: Option<[HalfedgeRef; 2]>,
}

impl Operation for Bridge {
    const SPEC: Spec = Spec {
        name: "bridge",
        label: "Bridge",
        description: "Puts a band of faces between two boundary loops.",
        key: None,
        kind: OperationKind::Local,
        fields: &[Field::new("halfedges", FieldKind::Halfedges, "A boundary half-edge of each loop")
            .or("the two selected half-edges")],
    };

    fields_by_serde!();

    fn resolve(mut self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        if self.halfedges.is_none() {
            self.halfedges = Some(target.two_boundary("halfedges")?.map(HalfedgeRef::from));
        }
        Ok(vec![self])
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for Bridge {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_bridge(mesh, pair(&self.halfedges, "halfedges", |h, field| h.find(mesh, field))?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::bridge(mesh, pair(&self.halfedges, "halfedges", |h, field| h.find(mesh, field))?)?;
        Ok(())
    }
}
