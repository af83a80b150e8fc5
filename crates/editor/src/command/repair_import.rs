//! `repair-import`: what was read made a mesh another way.

use super::{
    Action, Field, FieldKind, Input, Operation, OperationKind, Output, Spec, WholeMesh, refuse_bezier, whole,
};
use crate::error::Problem;
use formats::{NonManifold, Repairs};
use halfedge::Progress;
use serde::{Deserialize, Serialize};

/// Builds an object's mesh anew from the faces of its file, with other choices where those are not
/// a mesh as they stand. Edits made since are not in it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RepairImport {
    /// What becomes of faces at edges where more than two meet.
    #[serde(default)]
    pub non_manifold: NonManifold,
    /// Vertices this near to each other become one, in mesh units.
    #[serde(default, skip_serializing_if = "Option::is_none", with = "crate::json::finite_option")]
    pub merge_by_distance: Option<f32>,
    /// Whether faces are turned so that neighbours face the same way.
    #[serde(default = "yes")]
    pub orient: bool,
}

fn yes() -> bool {
    true
}

impl Operation for RepairImport {
    const SPEC: Spec = Spec {
        name: "repair-import",
        label: "Repair import",
        description: "Makes what was read from a file a mesh another way; edits made since are not in it.",
        key: None,
        kind: OperationKind::WholeMesh,
        fields: &[
            Field::new(
                "non_manifold",
                FieldKind::Choice(&["separate", "drop"]),
                "Faces at edges where more than two meet: each gets its own, or only the first two stay",
            )
            .or("\"separate\""),
            Field::new(
                "merge_by_distance",
                FieldKind::Number { min: 0.0, max: f32::MAX },
                "Vertices this near to each other become one, in mesh units",
            )
            .or("none"),
            Field::new(
                "orient",
                FieldKind::Flag,
                "Whether faces are turned so that neighbours face the same way",
            )
            .or("true"),
        ],
    };

    fields_by_serde!();

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl WholeMesh for RepairImport {
    fn check(&self) -> Result<(), Problem> {
        match self.merge_by_distance {
            Some(distance) if distance < 0.0 => {
                let text = format!("{distance} is out of range; it must be 0 or more");
                Err(Problem::field("merge_by_distance", text))
            }
            _ => Ok(()),
        }
    }

    fn check_inputs(&self, inputs: &[Input]) -> Result<(), Problem> {
        inputs.iter().try_for_each(|input| {
            refuse_bezier(&input.name, input.bezier.as_deref())?;
            match &input.soup {
                Some(_) => Ok(()),
                None => Err(Problem::new(format!(
                    "nothing was repaired when {} came to be, so there is nothing to do another way; merge-by-distance \
                     works on any mesh",
                    input.name
                ))),
            }
        })
    }

    fn reads_soup(&self) -> bool {
        true
    }

    fn compute(
        &self,
        inputs: &[Input],
        notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Vec<Output>, Problem> {
        let repairs = Repairs {
            non_manifold: self.non_manifold,
            merge_by_distance: self.merge_by_distance,
            orient: self.orient,
        };
        let mut outputs = Vec::with_capacity(inputs.len());
        for input in inputs {
            if progress(0.0).is_break() {
                return Err(Problem::cancelled());
            }
            let soup = input.soup.as_deref().ok_or_else(|| Problem::new("there is nothing to repair"))?;
            let (mesh, changed) =
                formats::rebuild(soup, &repairs).map_err(|error| Problem::new(error.to_string()))?;
            notes.extend(changed);
            outputs.push(Output::new("", mesh));
        }
        Ok(outputs)
    }

    fn cost(&self, inputs: &[Input]) -> usize {
        whole::faces(inputs)
    }
}
