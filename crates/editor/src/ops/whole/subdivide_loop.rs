//! `subdivide-loop`: subdivide triangles into smoother triangles.

use super::each_mesh::EachMesh;
use super::subdivide::{self, Boundary};
use crate::error::Problem;
use crate::ops::choice::choice;
use crate::ops::{Action, Estimate, Facts, Operation, Scope, Spec};
use halfedge::geometry::BitSet;
use halfedge::{Element, Mesh, Progress};
use serde::{Deserialize, Serialize};
use surface::SurfaceError;

/// Subdivide triangles into triangles that approach a smooth surface (Loop 1987).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SubdivideLoop {
    /// The number of levels.
    pub levels: u32,
    /// What happens at the boundary.
    pub boundary: Boundary,
    /// The weights of a vertex's neighbours.
    pub weights: Weights,
}

choice! {
    /// The weights of a vertex's neighbours.
    pub enum Weights {
        /// Loop 1987, as OpenSubdiv, OpenMesh and CGAL have it.
        Loop = "loop" "Loop",
        /// Warren's: 3/16 at valence 3, else 3/(8n).
        Warren = "warren" "Warren",
    }
}

impl Default for SubdivideLoop {
    fn default() -> Self {
        Self { levels: subdivide::LEVELS, boundary: Boundary::default(), weights: Weights::default() }
    }
}

impl Operation for SubdivideLoop {
    const SPEC: Spec = Spec::new(
        Scope::Meshes,
        "subdivide-loop",
        "Subdivide (Loop)",
        "Subdivide triangles into triangles that approach a smooth surface.",
    )
    .synonyms(&["refine"])
    .previewed()
    .fields(&[
        subdivide::levels(),
        subdivide::boundary(),
        Weights::field(
            "weights",
            "How much a vertex's neighbours count: as in OpenSubdiv, or as in the CS184 course",
        ),
    ]);

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl EachMesh for SubdivideLoop {
    fn check_mesh(&self, mesh: &Mesh) -> Result<(), Problem> {
        let polygon = mesh.faces().find(|&f| mesh.face_halfedges(f).take(4).count() != 3);
        polygon.map_or(Ok(()), |face| {
            let refusal = SurfaceError::NotTriangles { face, corners: mesh.face_degree(face) };
            Err(Problem::from(refusal)
                .advise("Loop subdivision needs a mesh of triangles. Triangulate the faces first."))
        })
    }

    fn make(
        &self,
        mesh: &Mesh,
        _notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Mesh, Problem> {
        let options = surface::Loop {
            levels: self.levels,
            boundary: self.boundary.into(),
            weights: match self.weights {
                Weights::Loop => surface::LoopWeights::Loop,
                Weights::Warren => surface::LoopWeights::Warren,
            },
        };
        surface::subdivide_loop(mesh, &options, progress).map_err(subdivide::refused)
    }

    fn follow(&self, mesh: &Mesh, element: Element, set: &BitSet) -> Option<BitSet> {
        Some(surface::descendants(mesh, surface::Split::Triangles, self.levels, element, set))
    }

    fn result(&self, facts: &Facts) -> Option<Estimate> {
        subdivide::estimate(subdivide::faces_after(facts.faces, self.levels))
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        subdivide::faces_after(mesh.face_count(), self.levels)
    }
}
