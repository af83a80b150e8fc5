//! Moving free vertices along the surface to the middle of their triangles, and vertices on curves to the middle
//! between their neighbours.

use super::work::Work;
use crate::SurfaceError;
use crate::pace::Pace;
use crate::trimesh::Role;
use glam::DVec3;
use halfedge::NONE;

/// How often the vertices of a curve are moved to the middle between their neighbours in an iteration.
const CURVE_SWEEPS: u32 = 8;
/// The share of the way to a neighbour on the curve that a vertex may move in an iteration: less than half, so that
/// vertices stay in order even where one of them may not move.
const MAX_SLIDE_SHARE: f64 = 0.45;

/// The least share of its area that a triangle keeps when a vertex moves.
const MIN_AREA_SHARE: f64 = 0.05;

/// A vertex on a curve.
struct Sliding {
    v: u32,
    /// One of its two edges there.
    edge: u32,
    /// The lengths along the curve to its neighbours; one of them is negative.
    gaps: [f64; 2],
    /// The neighbours' indices in the list of such vertices, or [`NONE`] if they stay.
    ends: [u32; 2],
    /// How far it moves along the curve.
    shift: f64,
}

/// Moves vertices on curves first, then free ones, each according to the current positions of its neighbours.
/// Vertices whose move would turn a triangle over stay.
pub(super) fn relax(work: &mut Work, pace: &mut Pace<'_, '_>) -> Result<(), SurfaceError> {
    slide(work);
    let mut star = Vec::new();
    pace.chunks(work.tri.out.len(), |range| {
        for v in range.start as u32..range.end as u32 {
            if work.roles[v as usize] == Role::Free && work.tri.out[v as usize] != NONE {
                move_to_middle(work, v, &mut star);
            }
        }
    })
}

/// Evens out the places of vertices on curves.
fn slide(work: &mut Work) {
    let mut sliding = sliding(work);
    for _ in 0..CURVE_SWEEPS {
        for i in 0..sliding.len() {
            let Sliding { gaps, ends, .. } = sliding[i];
            // One gap is positive, the other one negative.
            let [p, q] = ends.map(|end| sliding.get(end as usize).map_or(0.0, |end| end.shift));
            sliding[i].shift = 0.5 * ((gaps[0] + p) + (gaps[1] + q));
        }
    }
    for Sliding { v, edge, gaps, shift, .. } in sliding {
        let (low, high) = (
            MAX_SLIDE_SHARE * gaps[0].min(gaps[1]).min(0.0),
            MAX_SLIDE_SHARE * gaps[0].max(gaps[1]).max(0.0),
        );
        let shift = shift.clamp(low, high);
        let [here, _] = work.places_from(v, edge);
        let to = work.curve_point(edge, here + shift);
        if to != work.tri.at(v) && work.may_move(v, to) {
            work.slide(v, shift);
            work.tri.slide(v, to);
        }
    }
}

/// The vertices on curves, in order of number.
fn sliding(work: &Work) -> Vec<Sliding> {
    let mut list = Vec::new();
    for v in 0..work.tri.out.len() as u32 {
        if work.roles[v as usize] != Role::Curve || work.tri.out[v as usize] == NONE {
            continue;
        }
        let [a, b] = work.kept_at(v);
        if a == NONE || b == NONE {
            continue;
        }
        let gaps = [a, b].map(|h| {
            let [here, there] = work.places_from(v, h);
            there - here
        });
        let ends = [a, b].map(|h| work.other_end(v, h));
        list.push(Sliding { v, edge: a, gaps, ends, shift: 0.0 });
    }
    for i in 0..list.len() {
        let ends = list[i].ends;
        let place = |end: u32| list.binary_search_by_key(&end, |at| at.v).map_or(NONE, |i| i as u32);
        list[i].ends = ends.map(place);
    }
    list
}

/// Moves a free vertex to the middle of its triangles on its tangent plane, and projects it onto the input. `star`
/// is scratch memory.
fn move_to_middle(work: &mut Work, v: u32, star: &mut Vec<DVec3>) {
    let tri = &work.tri;
    let here = tri.at(v);
    star.clear();
    tri.around(v, |out| star.push(tri.at(tri.to(out))));
    let Some(&last) = star.last() else { return };
    let (mut before, mut all) = (last, DVec3::ZERO);
    let (mut middles, mut weights) = (DVec3::ZERO, 0.0);
    for &after in &*star {
        let normal = (before - here).cross(after - here);
        let weight = normal.length();
        all += normal;
        middles += (before + after + here) * weight;
        weights += weight;
        before = after;
    }
    let squared = all.length_squared();
    if squared.is_nan() || squared <= 0.0 {
        return;
    }
    let by = middles / (3.0 * weights) - here;
    let (to, near) = work.project(v, here + by - all * (by.dot(all) / squared));
    let mut before = last;
    for &after in &*star {
        let old = (before - here).cross(after - here);
        let turned = (before - to).cross(after - to).dot(old);
        // A triangle with hardly any area at a fold of the input would lose it by rounding to floats.
        if turned <= MIN_AREA_SHARE * old.length_squared() && old != DVec3::ZERO {
            return;
        }
        before = after;
    }
    work.tri.slide(v, to);
    work.near[v as usize] = near;
}
