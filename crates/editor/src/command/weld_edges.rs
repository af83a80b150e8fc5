//! `weld-edges`: two boundary edges made one.

use super::fields::pair;
use super::{Action, EdgeRef, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target};
use crate::error::Problem;
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Makes two boundary edges one: the opposite of ripping.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WeldEdges {
    /// Two boundary edges; the two selected ones if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edges: Option<[EdgeRef; 2]>,
}

impl Operation for WeldEdges {
    const SPEC: Spec = Spec {
        name: "weld-edges",
        label: "Weld edges",
        description: "Makes two boundary edges one.",
        key: None,
        kind: OperationKind::Local,
        fields: &[Field::new("edges", FieldKind::Edges, "Two boundary edges").or("the two selected edges")],
    };

    fields_by_serde!();

    fn resolve(mut self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        if self.edges.is_none() {
            self.edges = Some(target.two(Element::Edge, "edges")?.map(EdgeRef::Id));
        }
        Ok(vec![self])
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for WeldEdges {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_weld_edges(mesh, pair(&self.edges, "edges", |e, field| e.find(mesh, field))?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::weld_edges(mesh, pair(&self.edges, "edges", |e, field| e.find(mesh, field))?)?;
        Ok(())
    }
}
