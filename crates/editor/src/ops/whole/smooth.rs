//! `smooth`: move vertices towards their neighbours.

use super::each_mesh::EachMesh;
use crate::error::Problem;
use crate::ops::choice::choice;
use crate::ops::{
    Action, Amount, Counted, DefaultValue, Estimate, Facts, Field, Operation, Scope, Spec, Unit,
};
use crate::script::json::shortest;
use halfedge::geometry::BitSet;
use halfedge::{Element, Mesh, Progress};
use serde::{Deserialize, Serialize};
use surface::{SMOOTH_ITERATIONS_RANGE, SMOOTH_STRENGTH_RANGE};

/// Move every vertex towards the centre of its neighbours.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Smooth {
    /// The number of iterations.
    pub iterations: u32,
    /// The fraction of the way to move in each iteration, above 0 and up to 1.
    #[serde(with = "crate::script::json::finite")]
    pub strength: f32,
    /// How.
    pub method: SmoothMethod,
}

choice! {
    /// How vertices are moved.
    pub enum SmoothMethod {
        /// Towards the centre of the neighbours; shrinks the mesh.
        Laplacian = "laplacian" "Laplacian",
        /// There and a little more back (Taubin 1995); keeps the volume.
        Taubin = "taubin" "Taubin",
    }
}

const ITERATIONS: u32 = 1;
const STRENGTH: f32 = 0.5;

impl Default for Smooth {
    fn default() -> Self {
        Self { iterations: ITERATIONS, strength: STRENGTH, method: SmoothMethod::default() }
    }
}

impl Operation for Smooth {
    const SPEC: Spec = Spec::new(
        Scope::Meshes,
        "smooth",
        "Smooth",
        "Move every vertex towards the centre of its neighbours.",
    )
    .synonyms(&["relax", "laplacian", "taubin"])
    .previewed()
    .fields(&[
        Field::count("iterations", SMOOTH_ITERATIONS_RANGE, "The number of iterations")
            .or(DefaultValue::Integer(ITERATIONS)),
        Field::number(
            "strength",
            Unit::Fraction,
            SMOOTH_STRENGTH_RANGE,
            "The fraction of the way to move in each iteration",
        )
        .or(DefaultValue::Number(STRENGTH as f64)),
        SmoothMethod::field(
            "method",
            "Move vertices towards their neighbours only, or also back, which nearly keeps the volume",
        ),
    ]);

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl EachMesh for Smooth {
    fn make(
        &self,
        mesh: &Mesh,
        _notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Mesh, Problem> {
        let options = surface::Smooth {
            iterations: self.iterations,
            strength: shortest(self.strength),
            method: match self.method {
                SmoothMethod::Laplacian => surface::SmoothMethod::Laplacian,
                SmoothMethod::Taubin => surface::SmoothMethod::Taubin,
            },
        };
        Ok(surface::smooth(mesh, &options, progress)?)
    }

    fn follow(&self, mesh: &Mesh, element: Element, set: &BitSet) -> Option<BitSet> {
        Some(surface::compact_ids(mesh, element, set))
    }

    fn result(&self, facts: &Facts) -> Option<Estimate> {
        Some(Estimate { count: Amount::Exactly(facts.vertices), counted: Counted::MovedVertices, of: None })
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        mesh.face_count().saturating_mul(self.iterations as usize)
    }
}
