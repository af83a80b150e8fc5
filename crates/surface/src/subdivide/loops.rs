//! Loop subdivision of triangle meshes.
//!
//! Loop: Smooth subdivision surfaces based on triangles (1987), with boundaries, creases and corners as in
//! OpenSubdiv's uniform refinement; or with the vertex weights of Warren (1995).

use super::carry::{self, Shape, Split};
use super::sharpness::{self, Sharpness, position};
use super::{BoundaryRule, Level, check_size, refine, triangles};
use crate::SurfaceError;
use crate::pace::Pace;
use crate::trig::sin_cos_turns;
use glam::DVec3;
use halfedge::{Mesh, Progress, RawMesh};

/// Options of Loop subdivision.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Loop {
    /// The number of levels; 0 gives the compacted input.
    pub levels: u32,
    /// The rule at the boundary.
    pub boundary: BoundaryRule,
    /// The weights of a vertex's neighbours.
    pub weights: LoopWeights,
}

impl Default for Loop {
    fn default() -> Self {
        Self { levels: 1, boundary: BoundaryRule::default(), weights: LoopWeights::default() }
    }
}

/// The weight of each neighbour of a smooth vertex of valence n; the vertex itself gets the rest.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LoopWeights {
    /// (5/8 - (3/8 + cos(2 pi / n) / 4)^2) / n: Loop 1987, as OpenSubdiv, OpenMesh and CGAL.
    #[default]
    Loop,
    /// 3/16 at valence 3, else 3 / (8 n): Warren 1995, as libigl, geometry-central and CS184.
    Warren,
}

impl LoopWeights {
    fn of_neighbor(self, valence: u32) -> f64 {
        let n = f64::from(valence);
        match self {
            // The formula's value without rounding the cosine of 60 degrees.
            Self::Loop if valence == 6 => 1.0 / 16.0,
            Self::Loop => {
                let beta = 0.375 + 0.25 * sin_cos_turns(1.0 / n).1;
                (0.625 - beta * beta) / n
            }
            Self::Warren if valence == 3 => 3.0 / 16.0,
            Self::Warren => 3.0 / (8.0 * n),
        }
    }
}

/// Weights of smaller valences are in a table.
const TABULATED_VALENCES: usize = 32;

/// Subdivides each triangle into four.
///
/// Old vertices keep their ids and the point of edge `e` is vertex `V + e` (after closing gaps in the ids).
/// Attributes are as for [`super::subdivide_catmull_clark`]. Costs O(result).
///
/// # Errors
/// [`SurfaceError::NotTriangles`]; [`SurfaceError::MeetTwice`]; [`SurfaceError::TooManyFaces`] if there would be
/// more than [`super::MAX_SUBDIVIDED_FACES`]; [`SurfaceError::Cancelled`].
pub fn subdivide_loop(
    mesh: &Mesh,
    options: &Loop,
    progress: &mut Progress<'_>,
) -> Result<Mesh, SurfaceError> {
    crate::require_triangles(mesh)?;
    refuse_double_neighbors(mesh)?;
    check_size((mesh.face_count() as u64).saturating_mul(4), options.levels)?;
    let mut table = [0.0; TABULATED_VALENCES];
    for (valence, weight) in (0u32..).zip(&mut table).skip(1) {
        *weight = options.weights.of_neighbor(valence);
    }
    refine(
        mesh,
        options.levels,
        progress,
        |level, sharpness, pace| {
            let mut child = triangles::split(level, &mut pace.part(0.0, 0.6))?;
            place(level, sharpness, options, &table, &mut child, &mut pace.part(0.6, 0.9))?;
            child.columns = carry::columns(level, Split::Triangles, Shape::Smoothed);
            Ok(child)
        },
        Sharpness::of_children,
    )
}

/// Refuses triangles that share two edges: the vertex between has no other edges.
fn refuse_double_neighbors(mesh: &Mesh) -> Result<(), SurfaceError> {
    for h in mesh.halfedges() {
        // The half-edge after `h` from the same vertex, and the one after that.
        let other = mesh.next(h.twin());
        if mesh.next(other.twin()) == h
            && let (Some(a), Some(b)) = (mesh.face_of(h), mesh.face_of(h.twin()))
        {
            return Err(SurfaceError::MeetTwice { vertex: mesh.from(h), faces: [a, b] });
        }
    }
    Ok(())
}

fn place(
    level: &Level<'_>,
    sharpness: &Sharpness,
    options: &Loop,
    table: &[f64; TABULATED_VALENCES],
    child: &mut RawMesh,
    pace: &mut Pace<'_, '_>,
) -> Result<(), SurfaceError> {
    let links = level.links;
    let (old, edge_points) = child.positions.split_at_mut(level.vertices());
    // The vertex across the triangle of a half-edge.
    let across = |h: usize| position(level, links.to[links.next[h] as usize]);
    pace.part(0.0, 0.5).chunks(edge_points.len(), |range| {
        for e in range {
            edge_points[e] = sharpness::edge_point(level, sharpness, e, |ends| {
                ends * 0.375 + (across(2 * e) + across(2 * e + 1)) * 0.125
            })
            .as_vec3();
        }
    })?;
    pace.part(0.5, 1.0).chunks(old.len(), |range| {
        for v in range {
            let smooth = |first: u32| {
                let mut sum = DVec3::ZERO;
                let mut valence = 0u32;
                let mut h = first;
                loop {
                    sum += position(level, links.to[h as usize]);
                    valence += 1;
                    h = links.next[h as usize ^ 1];
                    if h == first {
                        break;
                    }
                }
                let weight = match table.get(valence as usize) {
                    Some(&weight) => weight,
                    None => options.weights.of_neighbor(valence),
                };
                level.positions[v].as_dvec3() * (1.0 - f64::from(valence) * weight) + sum * weight
            };
            old[v] = sharpness::vertex_point(level, sharpness, options.boundary, v, smooth).as_vec3();
        }
    })
}
