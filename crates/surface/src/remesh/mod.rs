//! Isotropic remeshing: triangles with edges of one length.
//!
//! Botsch and Kobbelt: A remeshing approach to multiresolution modeling (2004). Each iteration splits edges
//! longer than 4/3 of the length, collapses those shorter than 4/5, flips edges towards valence 6 (4 on the
//! boundary), moves vertices along the surface to the middle of their triangles, and projects them onto the
//! input. At the end the worst triangles are improved one by one.
//!
//! Boundaries, edges sharper than the feature angle (including folds of non-planar polygons), seams of corner
//! attributes, creases, and borders between materials, groups and colours are kept: their vertices slide along
//! them, and stay where such curves end, meet or turn. Sharp edges that are only noise at the new length aren't
//! kept: connected ones shorter in all than five edge lengths on a wider component; loose ends shorter than an
//! edge length; and sides of slivers, folded or not, beyond which the surface doesn't turn. All others are kept:
//! where they are closer together than an edge length, or meet at a small angle, triangles between them have
//! small angles too.

mod changes;
mod curves;
mod kept_edges;
mod polish;
mod relax;
mod side_numbers;
mod work;

use crate::error::{SurfaceError, check_iterations};
use crate::pace::Pace;
use crate::trimesh::TriMesh;
use halfedge::{Mesh, NONE, Progress};
use relax::relax;
use work::Work;

/// The most iterations that [`remesh`] accepts: after a few dozen nothing improves.
pub const MAX_REMESH_ITERATIONS: u32 = 1000;

/// Options of remeshing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Remesh {
    /// The length of edges in mesh units; [`Remesh::default_length`] if none.
    pub edge_length: Option<f64>,
    /// The number of iterations, up to [`MAX_REMESH_ITERATIONS`].
    pub iterations: u32,
    /// Edges are kept if the normals of their faces differ by more than this, in degrees.
    pub feature_angle: f64,
    /// Whether vertices are projected onto the input in each iteration.
    pub project: bool,
}

impl Default for Remesh {
    fn default() -> Self {
        Self { edge_length: None, iterations: 5, feature_angle: 45.0, project: true }
    }
}

/// The area of an equilateral triangle as a part of its side's square, sqrt(3) / 4.
const EQUILATERAL_AREA: f64 = 0.433;

/// The most by which the default length of edges differs from the one that keeps the number of triangles.
const MAX_LENGTH_CHANGE: f64 = 2.0;

impl Remesh {
    /// The length of edges that is taken by default; see [`Remesh::fitted_length`]. Costs O(mesh).
    pub fn default_length(mesh: &Mesh) -> f64 {
        let triangles: usize = mesh.faces().map(|f| mesh.face_degree(f).saturating_sub(2)).sum();
        let mean = crate::measure::mean_edge_length(mesh);
        Self::fitted_length(mean, crate::measure::surface_area(mesh), triangles)
    }

    /// The mean length of edges, kept within a factor of two of the length of as many equilateral triangles as the faces
    /// can be cut into. The mean alone says little of a mesh with large polygons: the sides of a disc of a thousand
    /// corners are so short that triangles of that size would be hundreds of times as many.
    pub fn fitted_length(mean: f64, area: f64, triangles: usize) -> f64 {
        let even = (area / (triangles as f64 * EQUILATERAL_AREA)).sqrt();
        if !(even > 0.0 && even.is_finite()) {
            return mean;
        }
        mean.clamp(even / MAX_LENGTH_CHANGE, even * MAX_LENGTH_CHANGE)
    }

    /// The approximate number of equilateral triangles with this edge length on a surface of this area.
    pub fn expected(area: f64, edge_length: f64) -> f64 {
        area / (edge_length * edge_length * EQUILATERAL_AREA)
    }
}

/// The most triangles that remeshing may make.
const MAX_REMESHED_TRIANGLES: u64 = 8_000_000;

/// Remeshes a surface. Polygons are cut into triangles first; isolated vertices are dropped. Triangles have the
/// face attributes of the one that they were split from; corner, vertex and edge attributes are interpolated where
/// edges are split and merged, and corner and vertex attributes also where vertices move over the surface. Costs
/// O(iterations x (mesh + result)).
///
/// A vertex is projected onto the closest point of the input that it reaches by moving ever closer, which is never
/// on the far side of a thin wall. A vertex on a kept curve lies exactly on that curve of the input, unless a
/// triangle would turn over.
///
/// # Errors
/// [`SurfaceError::BadField`]; [`SurfaceError::TooManyFaces`] for an edge length that is too short;
/// [`SurfaceError::Cancelled`].
pub fn remesh(mesh: &Mesh, options: &Remesh, progress: &mut Progress<'_>) -> Result<Mesh, SurfaceError> {
    let length = options.edge_length.unwrap_or_else(|| Remesh::default_length(mesh));
    if !(options.feature_angle > 0.0 && options.feature_angle <= 180.0) {
        return Err(SurfaceError::field("feature_angle", "above 0 and at most 180 degrees"));
    }
    check_iterations(options.iterations, MAX_REMESH_ITERATIONS)?;
    let mut pace = Pace::new(progress);
    pace.at(0.0)?;
    if mesh.face_count() == 0 {
        return Ok(Mesh::new());
    }
    if !(length > 0.0 && length.is_finite()) {
        return Err(SurfaceError::field("edge_length", "a finite number above 0"));
    }
    let expected = Remesh::expected(crate::measure::surface_area(mesh), length);
    if expected > MAX_REMESHED_TRIANGLES as f64 {
        return Err(SurfaceError::TooManyFaces { faces: expected as u64, limit: MAX_REMESHED_TRIANGLES });
    }
    let tri = TriMesh::new(mesh);
    let (_, least_cos) = crate::trig::sin_cos_turns(options.feature_angle / 360.0);
    let length = length / tri.frame.scale;
    let mut work = Work::new(mesh, tri, length, least_cos, options.project);
    pace.at(0.05)?;
    for iteration in 0..options.iterations {
        let share = |i: u32| 0.05 + 0.8 * i as f32 / options.iterations as f32;
        let mut part = pace.part(share(iteration), share(iteration + 1));
        split_long(&mut work, &mut part.part(0.0, 0.1))?;
        collapse_short(&mut work, &mut part.part(0.1, 0.2))?;
        if work.unordered > work.tri.faces / 8 {
            work.put_in_order();
        }
        flip_to_valence(&mut work, &mut part.part(0.2, 0.4))?;
        relax(&mut work, &mut part.part(0.4, 1.0))?;
    }
    polish::polish(&mut work, &mut pace.part(0.85, 0.95))?;
    let tri = work.finish();
    let result = tri.into_mesh(mesh);
    pace.at(1.0)?;
    Ok(result)
}

/// Calls `edit` with each edge that exists by then, including those made meanwhile.
fn each_edge(
    work: &mut Work,
    pace: &mut Pace<'_, '_>,
    mut edit: impl FnMut(&mut Work, u32),
) -> Result<(), SurfaceError> {
    let mut h = 0;
    while h < work.tri.v.len() as u32 {
        if h % 65_536 == 0 {
            pace.at(h as f32 / work.tri.v.len() as f32)?;
        }
        // The smaller of an edge's half-edges stands for it; NONE is larger than all ids.
        if work.tri.is_alive(h) && h < work.tri.opp(h) {
            edit(work, h);
        }
        h += 1;
    }
    Ok(())
}

/// How much longer an edge may become by a merge along a curve, squared.
const CURVE_STRETCH_SQUARED: f64 = 1.6;

fn split_long(work: &mut Work, pace: &mut Pace<'_, '_>) -> Result<(), SurfaceError> {
    each_edge(work, pace, |work, h| {
        while work.length_squared(h) > work.longest {
            let longest = work.longest_near(h);
            if !work.has_middle(longest) {
                break;
            }
            work.split(longest);
        }
    })
}

fn collapse_short(work: &mut Work, pace: &mut Pace<'_, '_>) -> Result<(), SurfaceError> {
    each_edge(work, pace, |work, h| {
        if work.length_squared(h) < work.shortest {
            // Along a curve the next edge takes all of the removed length, until places are evened out.
            let longest = if work.is_kept(h) { work.longest * CURVE_STRETCH_SQUARED } else { work.longest };
            if let Some(merge) = work.merges_of(h).find(|&merge| work.can_merge(merge, longest)) {
                work.merge(merge);
            }
        }
    })
}

/// Flips edges where that brings valences closer to six, or on the boundary to four. As long as there are many
/// slivers, also flips edges where that improves a poor triangle: chains of slivers along a finely divided curve
/// would prevent all merges there.
fn flip_to_valence(work: &mut Work, pace: &mut Pace<'_, '_>) -> Result<(), SurfaceError> {
    // Per vertex how far its valence is above the best one.
    let mut excess: Vec<i32> = (0..work.tri.out.len() as u32)
        .map(|v| if work.tri.is_boundary_vertex(v) { -4 } else { -6 })
        .collect();
    for h in 0..work.tri.v.len() as u32 {
        if work.tri.is_alive(h) {
            excess[work.tri.from(h) as usize] += 1;
            if work.tri.opp(h) == NONE {
                excess[work.tri.to(h) as usize] += 1;
            }
        }
    }
    // Testing shapes takes as long as everything else.
    let many_slivers = work.slivers > work.tri.faces / 1000;
    work.slivers = 0;
    each_edge(work, pace, |work, h| {
        let across = work.tri.opp(h);
        if across == NONE {
            return;
        }
        let ends = [work.tri.from(h), work.tri.to(h)];
        let apexes = [work.tri.apex(h), work.tri.apex(across)];
        let sum = |vs: [u32; 2]| vs.iter().map(|&v| excess[v as usize]).sum::<i32>();
        // The sum of squares changes by twice the apexes' sum less twice the ends' sum, plus four.
        let is_better = sum(apexes) - sum(ends) + 2 < 0;
        if !(is_better || many_slivers && work.is_better_flipped(h)) || !work.can_flip(h) {
            return;
        }
        work.slivers += usize::from(!is_better);
        work.flip(h);
        for v in ends {
            excess[v as usize] -= 1;
        }
        for v in apexes {
            excess[v as usize] += 1;
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Shape;
    use std::ops::ControlFlow;

    /// The ends of all kept edges are at their places on the curves.
    fn check(work: &Work, step: &str) {
        for h in 0..work.tri.v.len() as u32 {
            if !work.tri.is_alive(h) || !work.is_kept(h) {
                continue;
            }
            let arc = work.arcs[work.arc.get(h) as usize / 2];
            for (v, place) in [work.tri.from(h), work.tri.to(h)].into_iter().zip(work.places(h)) {
                let off = work.curves.at(arc.curve, place).distance(work.tri.at(v));
                // Positions are rounded to floats.
                assert!(off < 1e-7, "after {step}: {off}");
            }
        }
    }

    #[test]
    fn edges_know_their_places_on_curves_throughout() {
        let mut never_cancel = |_: f32| ControlFlow::Continue(());
        let progress: &mut Progress<'_> = &mut never_cancel;
        for (name, length) in [("tetrahedron", 0.2), ("cube", 0.3), ("cylinder", 0.15), ("plane", 0.2)] {
            let mesh = Shape::named(name).expect("listed").build().expect("fits");
            let tri = TriMesh::new(&mesh);
            let length = length / tri.frame.scale;
            let mut work = Work::new(&mesh, tri, length, 0.7, true);
            let mut pace = Pace::new(&mut *progress);
            check(&work, "start");
            for _ in 0..4 {
                split_long(&mut work, &mut pace).expect("not cancelled");
                check(&work, "split");
                collapse_short(&mut work, &mut pace).expect("not cancelled");
                check(&work, "collapse");
                work.put_in_order();
                check(&work, "order");
                flip_to_valence(&mut work, &mut pace).expect("not cancelled");
                check(&work, "flip");
                relax(&mut work, &mut pace).expect("not cancelled");
                check(&work, "relax");
            }
            polish::polish(&mut work, &mut pace).expect("not cancelled");
            check(&work, "polish");
        }
    }
}
