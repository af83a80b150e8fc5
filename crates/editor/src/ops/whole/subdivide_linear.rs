//! `subdivide-linear`: subdivide any polygons into quads, without smoothing.

use super::each_mesh::EachMesh;
use super::subdivide;
use crate::error::Problem;
use crate::ops::facts::corners_at_most;
use crate::ops::{Action, Estimate, Facts, Operation, Scope, Spec};
use halfedge::geometry::BitSet;
use halfedge::{Element, Mesh, Progress};
use serde::{Deserialize, Serialize};

/// Cut polygons into quads as Catmull-Clark does, leaving the surface where it is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SubdivideLinear {
    /// The number of levels.
    pub levels: u32,
}

impl Default for SubdivideLinear {
    fn default() -> Self {
        Self { levels: subdivide::LEVELS }
    }
}

impl Operation for SubdivideLinear {
    const SPEC: Spec = Spec::new(
        Scope::Meshes,
        "subdivide-linear",
        "Subdivide (linear)",
        "Cut polygons into quads without smoothing.",
    )
    .synonyms(&["tessellate", "refine"])
    .previewed()
    .fields(&[subdivide::levels()]);

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl EachMesh for SubdivideLinear {
    fn make(
        &self,
        mesh: &Mesh,
        _notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Mesh, Problem> {
        let options = surface::Linear { levels: self.levels };
        surface::subdivide_linear(mesh, &options, progress).map_err(subdivide::refused)
    }

    fn follow(&self, mesh: &Mesh, element: Element, set: &BitSet) -> Option<BitSet> {
        Some(surface::descendants(mesh, surface::Split::Quads, self.levels, element, set))
    }

    fn result(&self, facts: &Facts) -> Option<Estimate> {
        subdivide::estimate(subdivide::quads_after(facts.corners?, self.levels))
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        subdivide::quads_after(corners_at_most(mesh), self.levels)
    }
}
