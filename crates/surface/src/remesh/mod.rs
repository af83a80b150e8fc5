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

use crate::error::{SurfaceError, require};
use crate::pace::Pace;
use crate::trimesh::TriMesh;
use glam::DVec3;
use halfedge::{FaceId, HalfedgeId, Mesh, NONE, NumberRange, Progress};
use relax::relax;
use work::Work;

/// The numbers of iterations of [`remesh`]: after a few dozen nothing improves.
pub const REMESH_ITERATIONS_RANGE: NumberRange = NumberRange::counts(1, 1000);

/// The feature angles of [`remesh`] in degrees.
pub const REMESH_FEATURE_ANGLE_RANGE: NumberRange = NumberRange::above(0.0, 180.0);

/// Options of remeshing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Remesh {
    /// The length of edges in mesh units; [`Remesh::default_length`] if none.
    pub edge_length: Option<f64>,
    /// The number of iterations, in [`REMESH_ITERATIONS_RANGE`].
    pub iterations: u32,
    /// Edges are kept if the normals of their faces differ by more than this, in degrees, in [`REMESH_FEATURE_ANGLE_RANGE`].
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

/// The most by which the default length of edges is below the mean. Long slivers have little area, so the length that
/// keeps the number of triangles would cut their sides into thousands of pieces.
const MAX_MEAN_DIVISION: f64 = 8.0;

impl Remesh {
    /// The length of edges that is taken by default; see [`Remesh::fitted_length`]. Costs O(mesh).
    pub fn default_length(mesh: &Mesh) -> f64 {
        let triangles: usize = mesh.faces().map(|f| mesh.face_degree(f).saturating_sub(2)).sum();
        let mean = crate::measure::mean_edge_length(mesh);
        Self::fitted_length(mean, crate::measure::surface_area(mesh), triangles)
    }

    /// The mean length of edges, kept within a factor of two of the length of as many equilateral triangles as the faces
    /// can be cut into, but never below an eighth of the mean. The mean alone says little of a mesh with large polygons:
    /// the sides of a disc of a thousand corners are so short that triangles of that size would be hundreds of times as
    /// many.
    pub fn fitted_length(mean: f64, area: f64, triangles: usize) -> f64 {
        let even = (area / (triangles as f64 * EQUILATERAL_AREA)).sqrt();
        if !(even > 0.0 && even.is_finite()) {
            return mean;
        }
        mean.clamp(even / MAX_LENGTH_CHANGE, (even * MAX_LENGTH_CHANGE).max(mean / MAX_MEAN_DIVISION))
    }

    /// The approximate number of equilateral triangles with this edge length on a surface of this area.
    pub fn expected(area: f64, edge_length: f64) -> f64 {
        area / (edge_length * edge_length * EQUILATERAL_AREA)
    }

    /// About the most triangles that there are at a time while a mesh is remeshed to this edge length: more than
    /// [`Remesh::expected`] where slivers are split, whose number doesn't follow from their area. Costs O(mesh).
    pub fn most_triangles(mesh: &Mesh, edge_length: f64) -> f64 {
        let limit = work::split_above(edge_length);
        let pieces = mesh.faces().map(|f| {
            let triangles = mesh.face_degree(f).saturating_sub(2) as f64;
            triangles * pieces_of_sliver((longest_in(mesh, f) / limit).log2().ceil())
        });
        Self::expected(crate::measure::surface_area(mesh), edge_length) + pieces.sum::<f64>()
    }
}

/// The longest edge that a triangle of a face can have.
fn longest_in(mesh: &Mesh, f: FaceId) -> f64 {
    let h = mesh.halfedge_of(f);
    if mesh.next(mesh.next(h)) == mesh.prev(h) {
        return mesh
            .face_halfedges(f)
            .map(|h| crate::measure::edge_length(mesh, h.edge()))
            .fold(0.0, f64::max);
    }
    // A diagonal is as long as the face's bounding box at most.
    let corners = || mesh.face_vertices(f).map(|v| mesh.position(v).as_dvec3());
    let (least, most) = (corners().reduce(DVec3::min), corners().reduce(DVec3::max));
    least.zip(most).map_or(0.0, |(least, most)| least.distance(most))
}

/// The number of triangles that a sliver is cut into when its longest edge is halved this often. Each halving of the
/// longest edges makes three of one, however narrow they are: two of them share the new edge along the sliver.
fn pieces_of_sliver(halvings: f64) -> f64 {
    3f64.powf(halvings.max(0.0))
}

/// The most triangles that remeshing may make.
const MAX_REMESHED_TRIANGLES: usize = 8_000_000;

fn too_many(faces: f64) -> SurfaceError {
    SurfaceError::TooManyFaces { faces: faces as u64, limit: MAX_REMESHED_TRIANGLES as u64 }
}

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
    require("feature_angle", options.feature_angle, REMESH_FEATURE_ANGLE_RANGE)?;
    require("iterations", options.iterations.into(), REMESH_ITERATIONS_RANGE)?;
    let mut pace = Pace::new(progress);
    pace.at(0.0)?;
    if mesh.face_count() == 0 {
        return Ok(Mesh::new());
    }
    require("edge_length", length, NumberRange::POSITIVE)?;
    let expected = Remesh::expected(crate::measure::surface_area(mesh), length);
    if expected > MAX_REMESHED_TRIANGLES as f64 {
        return Err(too_many(expected));
    }
    let poked = poke_doubled_triangles(mesh)?;
    let mesh = poked.as_ref().unwrap_or(mesh);
    let tri = TriMesh::new(mesh);
    let (_, least_cos) = crate::trig::sin_cos_turns(options.feature_angle / 360.0);
    let length = length / tri.frame.scale;
    let mut work = Work::new(mesh, tri, length, least_cos, options.project);
    let pieces = work.least_pieces();
    if pieces > MAX_REMESHED_TRIANGLES as f64 {
        return Err(too_many(pieces));
    }
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

/// A copy of the mesh where one of two triangles on the same three vertices has a fourth vertex in its middle; none if
/// there are no such triangles. They share all three edges, so splitting one of these would join the new vertex to the
/// third vertex by two edges.
fn poke_doubled_triangles(mesh: &Mesh) -> Result<Option<Mesh>, SurfaceError> {
    let is_doubled = |&f: &FaceId| {
        let across = |h: HalfedgeId| mesh.face_of(h.twin());
        let h = mesh.halfedge_of(f);
        let [n, p] = [mesh.next(h), mesh.prev(h)];
        mesh.next(n) == p && across(h).is_some_and(|g| g > f && across(n) == Some(g) && across(p) == Some(g))
    };
    let doubled: Vec<FaceId> = mesh.faces().filter(is_doubled).collect();
    if doubled.is_empty() {
        return Ok(None);
    }
    let mut poked = mesh.clone();
    let fits = halfedge::edit::poke_faces(&mut poked, &doubled).is_ok();
    Ok(fits.then_some(poked))
}

/// The edges visited between two progress reports.
const VISITS_PER_REPORT: u32 = 1 << 16;

/// Calls `edit` with each edge that exists by then, including those made meanwhile, and again with the same edge as long
/// as it returns true.
fn each_edge(
    work: &mut Work,
    pace: &mut Pace<'_, '_>,
    mut edit: impl FnMut(&mut Work, u32) -> Result<bool, SurfaceError>,
) -> Result<(), SurfaceError> {
    let (mut h, mut visits) = (0, 0u32);
    while h < work.tri.v.len() as u32 {
        if visits.is_multiple_of(VISITS_PER_REPORT) {
            pace.at(h as f32 / work.tri.v.len() as f32)?;
        }
        visits = visits.wrapping_add(1);
        // The smaller of an edge's half-edges stands for it; NONE is larger than all ids.
        let is_edge = work.tri.is_alive(h) && h < work.tri.opp(h);
        if !(is_edge && edit(work, h)?) {
            h += 1;
        }
    }
    Ok(())
}

/// How much longer an edge may become by a merge along a curve, squared.
const CURVE_STRETCH_SQUARED: f64 = 1.6;

fn split_long(work: &mut Work, pace: &mut Pace<'_, '_>) -> Result<(), SurfaceError> {
    each_edge(work, pace, |work, h| {
        if work.length_squared(h) <= work.longest {
            return Ok(false);
        }
        let longest = work.longest_near(h);
        if !work.can_split(longest) {
            return Ok(false);
        }
        if work.tri.faces >= MAX_REMESHED_TRIANGLES {
            return Err(too_many(work.least_pieces().max(work.tri.faces as f64 + 2.0)));
        }
        work.split(longest);
        Ok(true)
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
        Ok(false)
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
            return Ok(false);
        }
        let ends = [work.tri.from(h), work.tri.to(h)];
        let apexes = [work.tri.apex(h), work.tri.apex(across)];
        let sum = |vs: [u32; 2]| vs.iter().map(|&v| excess[v as usize]).sum::<i32>();
        // The sum of squares changes by twice the apexes' sum less twice the ends' sum, plus four.
        let is_better = sum(apexes) - sum(ends) + 2 < 0;
        if !(is_better || many_slivers && work.is_better_flipped(h)) || !work.can_flip(h) {
            return Ok(false);
        }
        work.slivers += usize::from(!is_better);
        work.flip(h);
        for v in ends {
            excess[v as usize] -= 1;
        }
        for v in apexes {
            excess[v as usize] += 1;
        }
        Ok(false)
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
