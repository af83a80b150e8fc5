//! Bezier curves and patches: de Casteljau's construction step by step, and tessellation into a mesh.
//!
//! Source: G. Farin, *Curves and Surfaces for CAGD*, 5th ed., chapters 4 (curves) and 14 (patches).

mod curve;
mod object;
mod patch;
mod teapot;
mod tessellate;

pub use curve::Curve;
pub use object::Bezier;
pub use patch::{Patch, PatchConstruction, PatchPoint};
pub use teapot::teapot_patches;
pub use tessellate::{RESOLUTION_RANGE, Tessellated, tessellate, weld_distance};
