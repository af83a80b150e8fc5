//! Catmull-Clark subdivision.
//!
//! Catmull and Clark: Recursively generated B-spline surfaces on arbitrary topological meshes (1978), with
//! boundaries, creases and corners as in OpenSubdiv's uniform refinement.

use super::carry::{self, Shape, Split};
use super::sharpness::{self, Sharpness, position};
use super::{BoundaryRule, Level, check_size, quad_split_faces, quads, refine};
use crate::SurfaceError;
use crate::pace::Pace;
use glam::{DVec3, Vec3};
use halfedge::{Mesh, Progress, RawMesh};

/// Options of Catmull-Clark subdivision.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CatmullClark {
    /// The number of levels; 0 gives the compacted input.
    pub levels: u32,
    /// The rule at the boundary.
    pub boundary: BoundaryRule,
    /// The rule for old vertices.
    pub vertex_rule: VertexRule,
}

impl Default for CatmullClark {
    fn default() -> Self {
        Self { levels: 1, boundary: BoundaryRule::default(), vertex_rule: VertexRule::default() }
    }
}

/// The new position of a smooth vertex P of valence n.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum VertexRule {
    /// ((n - 2) P + mean of neighbours + mean of face centroids) / n.
    #[default]
    Standard,
    /// The variant of MayaLite: ((n - 2) P + mean of the *new* edge points + mean of face
    /// centroids) / n.
    SmoothedMidpoints,
}

/// Subdivides polygons into quads.
///
/// Old vertices keep their ids, the point of edge `e` is vertex `V + e` and that of face `f` is `V + E + f`
/// (after closing gaps in the ids). Children get the attributes of their face; corner and vertex attributes are
/// interpolated linearly; creases soften by 1 per level. Corner normals no longer fit and are dropped. Costs
/// O(result).
///
/// # Errors
/// [`SurfaceError::TooManyFaces`] if there would be more than [`super::MAX_SUBDIVIDED_FACES`];
/// [`SurfaceError::Cancelled`].
pub fn subdivide_catmull_clark(
    mesh: &Mesh,
    options: &CatmullClark,
    progress: &mut Progress<'_>,
) -> Result<Mesh, SurfaceError> {
    check_size(quad_split_faces(mesh, 1), options.levels)?;
    refine(
        mesh,
        options.levels,
        progress,
        |level, sharpness, pace| {
            let mut child = quads::split(level, &mut pace.part(0.0, 0.6))?;
            place(level, sharpness, options, &mut child, &mut pace.part(0.6, 0.9))?;
            child.columns = carry::columns(level, Split::Quads, Shape::Smoothed);
            Ok(child)
        },
        Sharpness::of_children,
    )
}

/// Places edge points and old vertices; face points are placed already.
fn place(
    level: &Level<'_>,
    sharpness: &Sharpness,
    options: &CatmullClark,
    child: &mut RawMesh,
    pace: &mut Pace<'_, '_>,
) -> Result<(), SurfaceError> {
    let links = level.links;
    let (old, new) = child.positions.split_at_mut(level.vertices());
    let (edge_points, face_points) = new.split_at_mut(level.edges());
    let face_point = |face: u32| face_points[face as usize].as_dvec3();
    pace.part(0.0, 0.5).chunks(edge_points.len(), |range| {
        for e in range {
            edge_points[e] = sharpness::edge_point(level, sharpness, e, |ends| {
                (ends + (face_point(links.face[2 * e]) + face_point(links.face[2 * e + 1]))) * 0.25
            })
            .as_vec3();
        }
    })?;
    let edge_points: &[Vec3] = edge_points;
    pace.part(0.5, 1.0).chunks(old.len(), |range| {
        for v in range {
            let standard = |first| {
                smooth_vertex(level, v, first, |h| {
                    position(level, links.to[h as usize]) + face_point(links.face[h as usize])
                })
            };
            let smoothed = |first| {
                smooth_vertex(level, v, first, |h| {
                    edge_points[h as usize / 2].as_dvec3() + face_point(links.face[h as usize])
                })
            };
            old[v] = match options.vertex_rule {
                VertexRule::Standard => {
                    sharpness::vertex_point(level, sharpness, options.boundary, v, standard)
                }
                VertexRule::SmoothedMidpoints => {
                    sharpness::vertex_point(level, sharpness, options.boundary, v, smoothed)
                }
            }
            .as_vec3();
        }
    })
}

/// ((n - 2) / n) P plus 1 / n^2 of the sum of `adds` over the half-edges leaving the vertex.
#[inline]
fn smooth_vertex(level: &Level<'_>, v: usize, first: u32, adds: impl Fn(u32) -> DVec3) -> DVec3 {
    let mut sum = DVec3::ZERO;
    let mut valence = 0u32;
    let mut h = first;
    loop {
        sum += adds(h);
        valence += 1;
        h = level.links.next[h as usize ^ 1];
        if h == first {
            break;
        }
    }
    let n = f64::from(valence);
    let here = level.positions[v].as_dvec3();
    (here * (n - 2.0) + sum / n) / n
}
