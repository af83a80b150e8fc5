//! What symmetric edits leave behind: a symmetric mesh, or a refusal.

use crate::error::Problem;
use halfedge::Mesh;
use surface::{MirrorImages, faces_of};

/// Makes the result of edits on both sides its own mirror image. `made_from` is the number of vertices before the edit,
/// `alone` that of elements without an image, and `left_out` why the image of an edit was not made.
///
/// # Errors
/// The mesh was its own mirror image where it was edited, and its result is not.
pub(super) fn settle(
    images: &MirrorImages,
    mesh: &mut Mesh,
    made_from: usize,
    alone: usize,
    left_out: Option<&Problem>,
) -> Result<(), Problem> {
    let moved: Vec<_> =
        mesh.recorded_moves().into_iter().map(|(v, _)| v).filter(|v| mesh.has_vertex(*v)).collect();
    images.settle(mesh, &moved);
    if alone > 0 || images.settle_result(mesh, made_from) {
        return Ok(());
    }
    let before = mesh.before_recording();
    if !MirrorImages::have_images(&before, images.axis(), &faces_of(&before, &mesh.recorded())) {
        // What wasn't symmetric need not become so.
        return Ok(());
    }
    let axis = super::AXIS_NAMES.get(images.axis()).copied().unwrap_or_default();
    let problem = match left_out {
        Some(problem) => format!("its mirror image along {axis} can't be made, because {}", problem.text),
        None => format!(
            "the result would not be symmetric along {axis}, because the edit and its mirror image change the same faces"
        ),
    };
    Err(Problem::new(format!(
        "{problem}; choose elements farther from the mirror's plane, or turn symmetry off"
    )))
}
