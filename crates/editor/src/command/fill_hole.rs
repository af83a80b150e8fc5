//! `fill-hole`: a polygon on a boundary loop.

use super::fields::one;
use super::{Action, Field, FieldKind, HalfedgeRef, LocalEdit, Operation, OperationKind, Spec, Target};
use crate::error::Problem;
use halfedge::{Mesh, edit};
use serde::{Deserialize, Serialize};

/// Puts one polygon on a boundary loop.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FillHole {
    /// A half-edge of the loop; those of the selected half-edges or edges if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub halfedge: Option<HalfedgeRef>,
}

impl Operation for FillHole {
    const SPEC: Spec = Spec {
        name: "fill-hole",
        label: "Fill hole",
        description: "Puts one polygon on a boundary loop.",
        key: None,
        kind: OperationKind::Local,
        fields: &[Field::new("halfedge", FieldKind::Halfedge, "A half-edge of the boundary loop")
            .or("the selected half-edges")],
    };

    fields_by_serde!();

    fn resolve(self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        if self.halfedge.is_some() {
            return Ok(vec![self]);
        }
        let sides = target.boundary("halfedge")?;
        Ok(sides.into_iter().map(|h| Self { halfedge: Some(h.into()) }).collect())
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for FillHole {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_fill_hole(mesh, one(self.halfedge, "halfedge")?.find(mesh, "halfedge")?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::fill_hole(mesh, one(self.halfedge, "halfedge")?.find(mesh, "halfedge")?)?;
        Ok(())
    }

    fn is_moot(&self, mesh: &Mesh) -> bool {
        // Another half-edge of the same loop came first.
        let found = self.halfedge.and_then(|h| h.find(mesh, "halfedge").ok());
        found.is_some_and(|h| !mesh.is_boundary_halfedge(h))
    }
}
