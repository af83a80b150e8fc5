//! `bezier-tessellate`: a Bezier surface as a mesh to edit.

use super::{Action, Field, FieldKind, Input, Operation, OperationKind, Output, Spec, WholeMesh};
use crate::bezier::Bezier;
use crate::error::Problem;
use halfedge::Progress;
use serde::{Deserialize, Serialize};
use surface::bezier::{MAX_RESOLUTION, tessellate};

/// Makes a Bezier surface a mesh: quads, and triangles at poles, welded where patches share a
/// border, with exact normals at the corners. The control points are given up.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BezierTessellate {
    /// How many quads lie along a patch's side.
    #[serde(default = "default_resolution", with = "crate::json::whole")]
    pub resolution: u32,
}

fn default_resolution() -> u32 {
    8
}

impl Operation for BezierTessellate {
    const SPEC: Spec = Spec {
        name: "bezier-tessellate",
        label: "Tessellate Bezier surface",
        description: "Makes a Bezier surface a mesh of quads, welded where patches meet.",
        key: None,
        kind: OperationKind::WholeMesh,
        fields: &[Field::new(
            "resolution",
            FieldKind::Integer { min: 1, max: MAX_RESOLUTION },
            "How many quads lie along a patch's side",
        )
        .or("8")],
    };

    fields_by_serde!();

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl WholeMesh for BezierTessellate {
    fn check(&self) -> Result<(), Problem> {
        if (1..=MAX_RESOLUTION).contains(&self.resolution) {
            return Ok(());
        }
        let text = format!("{} is out of range; it must be 1 to {MAX_RESOLUTION}", self.resolution);
        Err(Problem::field("resolution", text))
    }

    fn check_inputs(&self, inputs: &[Input]) -> Result<(), Problem> {
        for input in inputs {
            match input.bezier.as_deref() {
                Some(Bezier::Surface(_)) => {}
                Some(Bezier::Curve(_)) => {
                    return Err(Problem::new(format!(
                        "{} is a Bezier curve, which bounds no faces",
                        input.name
                    )));
                }
                None => return Err(Problem::new(format!("{} is a mesh already", input.name))),
            }
        }
        Ok(())
    }

    fn compute(
        &self,
        inputs: &[Input],
        notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Vec<Output>, Problem> {
        let mut outputs = Vec::with_capacity(inputs.len());
        for (at, input) in inputs.iter().enumerate() {
            if progress(at as f32 / inputs.len() as f32).is_break() {
                return Err(Problem::cancelled());
            }
            let patches = input.bezier.as_deref().map_or(&[][..], Bezier::patches);
            let made = tessellate(patches, self.resolution).map_err(|e| Problem::new(e.to_string()))?;
            notes.extend(made.notes.iter().map(ToString::to_string));
            outputs.push(Output::new("", made.mesh));
        }
        Ok(outputs)
    }

    fn cost(&self, inputs: &[Input]) -> usize {
        let patches = |input: &Input| input.bezier.as_deref().map_or(0, |bezier| bezier.patches().len());
        let faces = (self.resolution as usize).pow(2);
        inputs.iter().map(|input| patches(input).saturating_mul(faces)).sum()
    }
}
