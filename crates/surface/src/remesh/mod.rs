//! Isotropic remeshing: triangles with sides of one length.
//!
//! Botsch and Kobbelt: A remeshing approach to multiresolution modeling (2004). Each iteration splits
//! edges longer than 4/3 of the length, collapses those shorter than 4/5, flips edges towards valence 6
//! (4 on the boundary), moves vertices along the surface to the middle of their triangles, and puts them
//! back on the input. In the end the worst triangles are made better one by one.
//!
//! Boundaries, edges sharper than the feature angle (folds of polygons that are not flat among them), seams
//! of corner attributes, creases and borders between materials, groups and colours are kept: their vertices
//! slide along them, and where such curves end, meet or turn they stay. Sharp edges that are nothing but
//! noise at the new length are not kept: those that hang together over less than five edge lengths on a piece
//! wider than that, and ends that lie loose in the surface and are shorter than one, and sides of slivers,
//! folded ones among them, beyond which the surface does not turn. All others are kept as they are: where
//! they run closer together than an edge is long, or meet at a small angle, triangles between them have small
//! angles too.

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

/// The most iterations that [`remesh`] takes: after a few dozen nothing gets better.
pub const MAX_REMESH_ITERATIONS: u32 = 1000;

/// How to remesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Remesh {
    /// The length of edges, in mesh units; none for the mean of the input's.
    pub edge_length: Option<f64>,
    /// How many rounds: up to [`MAX_REMESH_ITERATIONS`].
    pub iterations: u32,
    /// Edges whose faces' normals differ by more than this are kept, in degrees.
    pub feature_angle: f64,
    /// Whether vertices are put back on the input each round.
    pub project: bool,
}

impl Default for Remesh {
    fn default() -> Self {
        Self { edge_length: None, iterations: 5, feature_angle: 45.0, project: true }
    }
}

impl Remesh {
    /// About how many triangles with sides of this length a surface of this area takes: equilateral ones.
    pub fn expected(area: f64, edge_length: f64) -> f64 {
        // An equilateral triangle has sqrt(3)/4 of its side's square.
        area / (edge_length * edge_length * 0.433)
    }
}

/// The most triangles that remeshing may make.
const MAX_TRIANGLES: u64 = 8_000_000;

/// Remeshes a surface; the input is untouched. Polygons are cut into triangles first, isolated vertices
/// left out. Triangles have the face attributes of the one they were cut from; corner, vertex and edge
/// attributes are mixed where edges are split and merged. Costs O(iterations x (mesh + result)).
///
/// A vertex is put on the point of the input that is closest among those it can reach by getting ever
/// closer from where it was: never on the far side of a thin wall. A vertex on a kept curve is on that
/// curve of the input exactly, unless a triangle would turn over.
///
/// # Errors
/// [`SurfaceError::BadField`]; [`SurfaceError::TooManyFaces`] beforehand, for an edge length so short;
/// [`SurfaceError::Cancelled`].
pub fn remesh(mesh: &Mesh, options: &Remesh, progress: &mut Progress<'_>) -> Result<Mesh, SurfaceError> {
    let length = options.edge_length.unwrap_or_else(|| crate::measure::mean_edge_length(mesh));
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
    if expected > MAX_TRIANGLES as f64 {
        return Err(SurfaceError::TooManyFaces { faces: expected as u64, limit: MAX_TRIANGLES });
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

/// Calls `edit` with each edge that exists when its turn comes, those made meanwhile included.
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
        // The smaller of an edge's half-edges stands for it; NONE is larger than all.
        if work.tri.is_alive(h) && h < work.tri.opp(h) {
            edit(work, h);
        }
        h += 1;
    }
    Ok(())
}

/// The square of how much longer than others an edge may become by a merge along a curve.
const ALONG: f64 = 1.6;

fn split_long(work: &mut Work, pace: &mut Pace<'_, '_>) -> Result<(), SurfaceError> {
    each_edge(work, pace, |work, h| {
        while work.length_squared(h) > work.longest {
            let longest = work.longest_near(h);
            work.split(longest);
        }
    })
}

fn collapse_short(work: &mut Work, pace: &mut Pace<'_, '_>) -> Result<(), SurfaceError> {
    each_edge(work, pace, |work, h| {
        if work.length_squared(h) < work.shortest {
            // Along a curve the next edge takes up all of what goes, until they are evened out.
            let longest = if work.is_kept(h) { work.longest * ALONG } else { work.longest };
            if let Some(merge) = work.merges_of(h).find(|&merge| work.can_merge(merge, longest)) {
                work.merge(merge);
            }
        }
    })
}

/// Flips edges where that brings valences closer to six, or to four on the boundary, where half a disc
/// of triangles is; and, as long as there are many, where a poor triangle gets better: chains of slivers
/// along a finely cut curve would refuse all merges there.
fn flip_to_valence(work: &mut Work, pace: &mut Pace<'_, '_>) -> Result<(), SurfaceError> {
    // How far each vertex is above its best.
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
    // Looking at shapes takes as long as all the rest.
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

    /// Every kept edge's ends are at their places on its curve.
    fn check(work: &Work, step: &str) {
        for h in 0..work.tri.v.len() as u32 {
            if !work.tri.is_alive(h) || !work.is_kept(h) {
                continue;
            }
            let arc = work.arcs[work.arc.get(h) as usize / 2];
            for (v, place) in [work.tri.from(h), work.tri.to(h)].into_iter().zip(work.places(h)) {
                let off = work.curves.at(arc.curve, place).distance(work.tri.at(v));
                // Vertices are where rounding to floats leaves them.
                assert!(off < 1e-7, "after {step}: {off}");
            }
        }
    }

    #[test]
    fn edges_know_their_places_on_curves_throughout() {
        let mut go_on = |_: f32| ControlFlow::Continue(());
        let progress: &mut Progress<'_> = &mut go_on;
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
