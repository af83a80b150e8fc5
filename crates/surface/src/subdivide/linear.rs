//! Linear subdivision: the topology of Catmull-Clark without smoothing.

use super::carry::{self, Shape, Split};
use super::sharpness::{Sharpness, position};
use super::{check_size, quad_split_faces, quads, refine};
use crate::SurfaceError;
use halfedge::{Mesh, Progress};

/// Options of linear subdivision.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Linear {
    /// The number of levels; 0 gives the compacted input.
    pub levels: u32,
}

/// Subdivides polygons into quads with edge midpoints and face points (the means of the corners); old vertices
/// stay where they are. Ids and attributes are as for [`super::subdivide_catmull_clark`], but corner normals are
/// interpolated too. Costs O(result).
///
/// # Errors
/// [`SurfaceError::TooManyFaces`] if there would be more than [`super::MAX_SUBDIVIDED_FACES`];
/// [`SurfaceError::Cancelled`].
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
