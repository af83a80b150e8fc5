//! `subdivide-catmull-clark`: subdivide any polygons into smooth quads.

use super::each_mesh::EachMesh;
use super::subdivide::{self, Boundary};
use crate::error::Problem;
use crate::ops::choice::choice;
use crate::ops::facts::corners_at_most;
use crate::ops::{Action, Estimate, Facts, Operation, Scope, Spec};
use halfedge::geometry::BitSet;
use halfedge::{Element, Mesh, Progress};
use serde::{Deserialize, Serialize};

/// Subdivide any polygons into quads that approach a smooth surface (Catmull & Clark 1978).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SubdivideCatmullClark {
    /// The number of levels.
    pub levels: u32,
    /// What happens at the boundary.
    pub boundary: Boundary,
    /// Where old vertices go.
    pub vertex_rule: VertexRule,
}

choice! {
    /// Where old vertices go.
    pub enum VertexRule {
        /// As Catmull and Clark, and OpenSubdiv.
        Standard = "standard" "Standard",
        /// As MayaLite: from edge points after smoothing instead of before.
        SmoothedMidpoints = "smoothed-midpoints" "Smoothed midpoints",
    }
}

impl Default for SubdivideCatmullClark {
    fn default() -> Self {
        Self { levels: subdivide::LEVELS, boundary: Boundary::default(), vertex_rule: VertexRule::default() }
    }
}

impl Operation for SubdivideCatmullClark {
    const SPEC: Spec = Spec::new(
        Scope::Meshes,
        "subdivide-catmull-clark",
        "Subdivide (Catmull-Clark)",
        "Subdivide any polygons into quads that approach a smooth surface.",
    )
    .synonyms(&["subdivision surface", "refine"])
    .previewed()
    .fields(&[
        subdivide::levels(),
        subdivide::boundary(),
        VertexRule::field("vertex_rule", "Where old vertices go: as in OpenSubdiv, or as in MayaLite"),
    ]);

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl EachMesh for SubdivideCatmullClark {
    fn make(
        &self,
        mesh: &Mesh,
        _notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Mesh, Problem> {
        let options = surface::CatmullClark {
            levels: self.levels,
            boundary: self.boundary.into(),
            vertex_rule: match self.vertex_rule {
                VertexRule::Standard => surface::VertexRule::Standard,
                VertexRule::SmoothedMidpoints => surface::VertexRule::SmoothedMidpoints,
            },
        };
        surface::subdivide_catmull_clark(mesh, &options, progress).map_err(subdivide::refused)
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
