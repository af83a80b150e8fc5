//! Linear subdivision: the quads of Catmull-Clark on the faces as they are.

use super::carry::{self, Shape, Split};
use super::sharpness::{Sharpness, position};
use super::{check_size, quad_split_faces, quads, refine};
use crate::SurfaceError;
use halfedge::{Mesh, Progress};

/// How many levels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Linear {
    /// How often to subdivide; 0 gives the input, compacted.
    pub levels: u32,
}

/// Subdivides any polygons into quads by edge midpoints and face centroids (the means of the corners)
/// without smoothing: old vertices stay where they are. Ids and attributes as in
/// [`super::subdivide_catmull_clark`], but corner normals are interpolated too. Costs O(result).
///
/// # Errors
/// [`SurfaceError::TooManyFaces`] beforehand, above [`super::MAX_FACES`]; [`SurfaceError::Cancelled`].
pub fn subdivide_linear(
    mesh: &Mesh,
    options: &Linear,
    progress: &mut Progress<'_>,
) -> Result<Mesh, SurfaceError> {
    check_size(quad_split_faces(mesh, 1), options.levels)?;
    refine(
        mesh,
        options.levels,
        progress,
        |level, _, pace| {
            let mut child = quads::split(level, &mut pace.part(0.0, 0.8))?;
            let (old, new) = child.positions.split_at_mut(level.vertices());
            old.copy_from_slice(level.positions);
            for (point, ends) in new.iter_mut().zip(level.links.to.chunks_exact(2)) {
                *point = ((position(level, ends[0]) + position(level, ends[1])) * 0.5).as_vec3();
            }
            child.columns = carry::columns(level, Split::Quads, Shape::Kept);
            Ok(child)
        },
        Sharpness::of_children,
    )
}
