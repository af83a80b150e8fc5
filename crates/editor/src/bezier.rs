//! Bezier curves and surfaces in a document: control points, and the mesh that shows them.
//!
//! An object with control points is a Bezier object. Its mesh is computed from them and can't be edited by
//! itself: for a surface it is the welded tessellation, fine enough for display; for a curve it is empty.
//! `bezier-tessellate` replaces the control points by a mesh that every operation can edit.

use crate::Task;
use crate::error::{CommandError, Problem, not_opened};
use formats::Import;
use std::sync::Arc;
pub use surface::bezier::Bezier;

/// Computes the meshes that show objects imported as control points. Opening the import does so too; call
/// this if you need the meshes earlier.
///
/// # Errors
/// A surface has more patches than a mesh can show.
pub fn show_controls(import: &mut Import) -> Result<(), CommandError> {
    fill_previews(import).map_err(|problem| CommandError::of(Task::Open, problem))
}

pub(crate) fn fill_previews(import: &mut Import) -> Result<(), Problem> {
    for object in &mut import.model.objects {
        if let Some(bezier) = &object.bezier
            && object.mesh.vertex_count() == 0
        {
            let mesh = bezier
                .preview()
                .map_err(|error| Problem::new(not_opened(&object.name, &error.to_string())))?;
            object.mesh = Arc::new(mesh);
            if bezier.curve().is_none() {
                let n = bezier.preview_resolution();
                import.report.info(format!(
                    "{} is shown by a mesh of {n} x {n} quads per patch; Tessellate makes one to edit",
                    object.name
                ));
            }
        }
    }
    Ok(())
}
