//! Bezier curves and surfaces in a document: control points, and the mesh that shows them.
//!
//! An object that has control points is a Bezier object. Its mesh is made from them and nothing
//! else edits it: a surface's is its welded tessellation, fine enough to look at, and a curve's is
//! empty. `bezier-tessellate` gives the control points up for a mesh that everything can edit.

use crate::error::{CommandError, Problem};
use formats::{Controls, Import};
use glam::Vec3;
use halfedge::Mesh;
use surface::bezier::{Curve, Patch, tessellate};

/// The control points of a Bezier object.
#[derive(Clone, Debug, PartialEq)]
pub enum Bezier {
    /// A curve, whose `construction`, `point` and `polyline` the page draws.
    Curve(Curve),
    /// A surface: its patches, each with `construction` and `point`.
    Surface(Vec<Patch>),
}

impl Bezier {
    /// The mesh that shows a surface has 8 x 8 quads per patch, fewer where that would make more
    /// than this many in all: it is made anew at each movement of a control point.
    const MOST_PREVIEW_FACES: usize = 20_000;

    /// "Bezier curve" or "Bezier surface".
    pub fn name(&self) -> &'static str {
        match self {
            Self::Curve(_) => "Bezier curve",
            Self::Surface(_) => "Bezier surface",
        }
    }

    /// The curve, if it is one.
    pub fn curve(&self) -> Option<&Curve> {
        match self {
            Self::Curve(curve) => Some(curve),
            Self::Surface(_) => None,
        }
    }

    /// The patches of a surface; none for a curve.
    pub fn patches(&self) -> &[Patch] {
        match self {
            Self::Curve(_) => &[],
            Self::Surface(patches) => patches,
        }
    }

    /// How many quads lie along a patch's side in the mesh that shows the surface.
    pub fn preview_resolution(&self) -> u32 {
        let most = Self::MOST_PREVIEW_FACES / self.patches().len().max(1);
        most.isqrt().clamp(1, 8) as u32
    }

    /// The mesh that shows it; an empty one for a curve. Costs O(its faces).
    pub(crate) fn preview(&self) -> Result<Mesh, Problem> {
        match self {
            Self::Curve(_) => Ok(Mesh::new()),
            Self::Surface(patches) => tessellate(patches, self.preview_resolution())
                .map(|made| made.mesh)
                .map_err(|error| Problem::new(error.to_string())),
        }
    }

    pub(crate) fn bytes(&self) -> usize {
        match self {
            Self::Curve(curve) => curve.points.len() * size_of::<Vec3>(),
            Self::Surface(patches) => patches.len() * size_of::<Patch>(),
        }
    }
}

impl From<Controls> for Bezier {
    fn from(controls: Controls) -> Self {
        match controls {
            Controls::Curve(points) => Self::Curve(Curve { points }),
            Controls::Surface(patches) => {
                Self::Surface(patches.into_iter().map(|rows| Patch { rows }).collect())
            }
        }
    }
}

impl From<&Bezier> for Controls {
    fn from(bezier: &Bezier) -> Self {
        match bezier {
            Bezier::Curve(curve) => Self::Curve(curve.points.clone()),
            Bezier::Surface(patches) => Self::Surface(patches.iter().map(|patch| patch.rows).collect()),
        }
    }
}

/// Gives objects that were read as control points the mesh that shows them. Opening does this too:
/// call it where the meshes are needed before.
///
/// # Errors
/// A surface has more patches than a mesh can show.
pub fn show_controls(import: &mut Import) -> Result<(), CommandError> {
    fill_previews(import).map_err(|problem| CommandError::of("open", problem))
}

pub(crate) fn fill_previews(import: &mut Import) -> Result<(), Problem> {
    for object in &mut import.objects {
        if let Some(controls) = &object.controls
            && object.mesh.vertex_count() == 0
        {
            let bezier = Bezier::from(controls.clone());
            object.mesh = bezier.preview()?;
            if !controls.is_curve() {
                let n = bezier.preview_resolution();
                import.report.info(format!(
                    "{} is shown by a mesh of {n} x {n} quads per patch; bezier-tessellate makes one to edit",
                    object.name
                ));
            }
        }
    }
    Ok(())
}
