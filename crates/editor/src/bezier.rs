//! Bezier curves and surfaces in a document: control points, and the mesh that shows them.
//!
//! An object that has control points is a Bezier object. Its mesh is made from them and nothing
//! else edits it: a surface's is its welded tessellation, fine enough to look at, and a curve's is
//! empty. `bezier-tessellate` gives the control points up for a mesh that everything can edit.

use crate::error::{CommandError, Problem};
use formats::Import;
use std::sync::Arc;
pub use surface::bezier::Bezier;

/// Gives objects that were read as control points the mesh that shows them. Opening does this too:
/// call it where the meshes are needed before.
///
/// # Errors
/// A surface has more patches than a mesh can show.
pub fn show_controls(import: &mut Import) -> Result<(), CommandError> {
    fill_previews(import).map_err(|problem| CommandError::of("open", problem))
}

pub(crate) fn fill_previews(import: &mut Import) -> Result<(), Problem> {
    for object in &mut import.model.objects {
        if let Some(bezier) = &object.bezier
            && object.mesh.vertex_count() == 0
        {
            let mesh = bezier.preview().map_err(|error| Problem::new(error.to_string()))?;
            object.mesh = Arc::new(mesh);
            if bezier.curve().is_none() {
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
