//! `repair-import`: build the mesh again from the faces of its file.

use crate::error::Problem;
use crate::ops::{
    Action, Choice, DefaultValue, Field, FieldKind, MergeByDistance, NamedMesh, Operation, Scope, Spec, Unit,
    WholeMesh, refuse_bezier,
};
use formats::{NonManifold, Repairs};
use halfedge::{NumberRange, Progress};
use serde::{Deserialize, Serialize};

/// Build an object's mesh again from the faces of its file, with other repairs where those faces are
/// no mesh. Edits made since are lost.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RepairImport {
    /// What happens to faces at edges where more than two meet.
    pub non_manifold: NonManifold,
    /// Vertices this near to each other are merged, in mesh units.
    #[serde(default, with = "crate::script::json::finite_option")]
    pub merge_by_distance: Option<f32>,
    /// Orient faces consistently.
    pub orient: bool,
}

const NON_MANIFOLD: &[Choice] =
    &[Choice { name: "separate", label: "Separate" }, Choice { name: "drop", label: "Drop" }];

impl Operation for RepairImport {
    const SPEC: Spec = Spec::new(
        Scope::Meshes,
        "repair-import",
        "Repair import",
        "Build the mesh again from the faces of its file, with other repairs; edits made since are lost.",
    )
    .fields(&[
        Field::required(
            "non_manifold",
            FieldKind::Choice(NON_MANIFOLD),
            "Faces at edges where more than two meet: separate them all, or keep only the first two",
        )
        .labelled("Non-manifold edges")
        .or(DefaultValue::Choice("separate")),
        Field::number(
            "merge_by_distance",
            Unit::Length,
            NumberRange::NOT_NEGATIVE,
            "Merge vertices within this distance of each other, in mesh units",
        )
        .unset("none"),
        Field::required("orient", FieldKind::Flag, "Orient faces consistently")
            .labelled("Re-orient faces")
            .or(DefaultValue::Flag(true)),
    ]);

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl WholeMesh for RepairImport {
    fn check_inputs(&self, inputs: &[NamedMesh]) -> Result<(), Problem> {
        inputs.iter().try_for_each(|input| {
            refuse_bezier(&input.name, input.bezier.as_deref())?;
            match &input.soup {
                Some(_) => Ok(()),
                None => Err(Problem::new(format!(
                    "nothing was repaired when {} was read, so there is nothing to repair in another way; \
                     {} works on any mesh",
                    input.name,
                    MergeByDistance::SPEC.label
                ))),
            }
        })
    }

    fn reads_soup(&self) -> bool {
        true
    }

    fn compute(
        &self,
        inputs: &[NamedMesh],
        notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Vec<NamedMesh>, Problem> {
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
            outputs.push(NamedMesh::new("", mesh));
        }
        Ok(outputs)
    }

    fn cost(&self, inputs: &[NamedMesh]) -> usize {
        // Faces that were left out may come back: those of the file count.
        let faces = |input: &NamedMesh| input.soup.as_ref().map_or(0, |soup| soup.face_count());
        inputs.iter().map(faces).sum()
    }
}
