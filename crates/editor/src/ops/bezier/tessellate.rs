//! `bezier-tessellate`: make a Bezier surface a mesh to edit.

use crate::bezier::Bezier;
use crate::error::Problem;
use crate::ops::{
    Action, DefaultValue, Estimate, Facts, Field, NamedMesh, Operation, Scope, Spec, WholeMesh,
};
use halfedge::Progress;
use serde::{Deserialize, Serialize};
use surface::bezier::{RESOLUTION_RANGE, tessellate};

/// Make a mesh from a Bezier surface: quads, and triangles at poles, welded where patches share a
/// border, with exact normals at the corners. The control points are given up.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BezierTessellate {
    /// How many quads lie along a patch's side.
    pub resolution: u32,
}

/// The default number of quads along a patch's side.
const RESOLUTION: u32 = 8;

impl Default for BezierTessellate {
    fn default() -> Self {
        Self { resolution: RESOLUTION }
    }
}

impl Operation for BezierTessellate {
    const SPEC: Spec = Spec::new(
        Scope::Meshes,
        "bezier-tessellate",
        "Tessellate Bezier surface",
        "Make a mesh of quads from a Bezier surface, welded where patches meet.",
    )
    .fields(&[Field::count("resolution", RESOLUTION_RANGE, "How many quads lie along a patch's side")
        .labelled("Quads per side")
        .or(DefaultValue::Integer(RESOLUTION))]);

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl WholeMesh for BezierTessellate {
    fn check_inputs(&self, inputs: &[NamedMesh]) -> Result<(), Problem> {
        for input in inputs {
            match input.bezier.as_deref() {
                Some(Bezier::Surface(_)) => {}
                Some(Bezier::Curve(_)) => {
                    return Err(Problem::new(format!(
                        "{} is a Bezier curve, which bounds no faces",
                        input.name
                    )));
                }
                None => {
                    return Err(Problem::new(format!("{} is a mesh already", input.name))
                        .advise("This is a mesh already. Open a Bezier surface, a .bez file, first."));
                }
            }
        }
        Ok(())
    }

    fn compute(
        &self,
        inputs: &[NamedMesh],
        notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Vec<NamedMesh>, Problem> {
        let mut outputs = Vec::with_capacity(inputs.len());
        for (at, input) in inputs.iter().enumerate() {
            if progress(at as f32 / inputs.len() as f32).is_break() {
                return Err(Problem::cancelled());
            }
            let patches = input.bezier.as_deref().map_or(&[][..], Bezier::patches);
            let made = tessellate(patches, self.resolution).map_err(|e| Problem::new(e.to_string()))?;
            notes.extend(made.notes.iter().map(ToString::to_string));
            outputs.push(NamedMesh::new("", made.mesh));
        }
        Ok(outputs)
    }

    fn result(&self, facts: &Facts) -> Option<Estimate> {
        let side = self.resolution as usize;
        side.checked_mul(side)?.checked_mul(facts.patches).map(Estimate::faces)
    }

    fn cost(&self, inputs: &[NamedMesh]) -> usize {
        let patches = |input: &NamedMesh| input.bezier.as_deref().map_or(0, |bezier| bezier.patches().len());
        let faces = (self.resolution as usize).pow(2);
        inputs.iter().map(|input| patches(input).saturating_mul(faces)).sum()
    }
}
