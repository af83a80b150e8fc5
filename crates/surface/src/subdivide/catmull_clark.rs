//! Catmull-Clark subdivision.
//!
//! Catmull and Clark: Recursively generated B-spline surfaces on arbitrary topological meshes (1978),
//! with boundaries, creases and corners as OpenSubdiv's uniform refinement has them.

use super::carry::{self, Shape, Split};
use super::sharpness::{self, Sharpness, position};
use super::{BoundaryRule, Level, check_size, quad_split_faces, quads, refine};
use crate::SurfaceError;
use crate::pace::Pace;
use glam::{DVec3, Vec3};
use halfedge::{Mesh, Progress, RawMesh};

/// How many levels, and by which rules.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CatmullClark {
    /// How often to subdivide; 0 gives the input, compacted.
    pub levels: u32,
    /// What happens at the boundary.
    pub boundary: BoundaryRule,
    /// Where old vertices go.
    pub vertex_rule: VertexRule,
}

impl Default for CatmullClark {
    fn default() -> Self {
        Self { levels: 1, boundary: BoundaryRule::default(), vertex_rule: VertexRule::default() }
    }
}

/// Where a smooth vertex P of valence n goes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum VertexRule {
    /// ((n - 2) P + mean of neighbours + mean of face centroids) / n.
    #[default]
    Standard,
    /// The variant of MayaLite: ((n - 2) P + mean of the *new* edge points + mean of face
    /// centroids) / n.
    SmoothedMidpoints,
}

/// Subdivides any polygons into quads; the input is untouched.
///
/// Old vertices keep their ids, edge `e`'s point is vertex `V + e` and face `f`'s is `V + E + f` (after
/// closing gaps in the ids). Faces hand their attributes to their children, corner and vertex
/// attributes are interpolated linearly, creases soften by one a level; corner normals, which would no
/// longer fit, are left out. Costs O(result).
///
/// # Errors
/// [`SurfaceError::TooManyFaces`] beforehand, above [`super::MAX_FACES`]; [`SurfaceError::Cancelled`].
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

/// Puts edge points and old vertices where they go; face points are there already.
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

/// ((n - 2) / n) P plus 1 / n^2 of what every half-edge leaving the vertex adds.
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
