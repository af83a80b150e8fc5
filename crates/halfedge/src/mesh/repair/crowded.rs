//! Edges where more than two faces meet.

use super::orient::Orientation;
use super::side::{Kept, Side};
use crate::geometry::polygon_area_vector;
use crate::mesh::PolygonSoup;
use std::ops::Range;

/// Faces at an edge whose directions differ by less are in one plane, in radians.
const SAME_ANGLE: f64 = 1e-5;

/// A side at an edge.
struct Spoke {
    /// The number of the side.
    side: usize,
    /// The direction of the face from the edge, as an angle about the edge.
    angle: f64,
    /// Whether the face runs along the edge from its smaller to its larger vertex. Seen along the edge, what
    /// the face bounds lies clockwise of it then, and counter-clockwise otherwise.
    upward: bool,
    part: u32,
}

/// Rule 3: the pairs of sides at an edge that stay joined. Around the edge, the faces that bound a wedge of a
/// solid follow each other: the first runs down along the edge, the other one up. First the faces of each part
/// are paired, then the others where as many run up as down. Costs O(n log n) for n faces.
pub(super) fn pair_sides(
    soup: &PolygonSoup,
    faces: &[Kept],
    sides: &[Side],
    orientation: &Orientation,
    edge: Range<usize>,
) -> Vec<(usize, usize)> {
    let mut spokes = spokes(soup, faces, sides, orientation, edge);
    let mut pairs = Vec::new();
    let mut parts: Vec<u32> = spokes.iter().map(|spoke| spoke.part).collect();
    parts.sort_unstable();
    for same in parts.chunk_by(|a, b| a == b).filter(|same| same.len() > 1) {
        pair_wedges(&mut spokes, |spoke| spoke.part == same[0], &mut pairs);
    }
    if spokes.iter().filter(|spoke| spoke.upward).count() * 2 == spokes.len() {
        pair_wedges(&mut spokes, |_| true, &mut pairs);
    }
    pairs
}

/// The sides at an edge in order of angle. In one plane, faces that end a wedge come before those that start
/// one. Faces without an area have no angle and are left out.
fn spokes(
    soup: &PolygonSoup,
    faces: &[Kept],
    sides: &[Side],
    orientation: &Orientation,
    edge: Range<usize>,
) -> Vec<Spoke> {
    let (low, high) = sides[edge.start].ends;
    let position = |v: u32| soup.positions[v as usize].as_dvec3();
    let Some(along) = (position(high) - position(low)).try_normalize() else { return Vec::new() };
    let (u, v) = along.any_orthonormal_pair();
    let spoke = |number: usize| {
        let side = &sides[number];
        let face = &faces[side.face as usize];
        let corners = (0..face.corners.len()).map(|slot| soup.positions[face.vertex(soup, slot) as usize]);
        // To the left of the side, seen from where the face runs counter-clockwise.
        let inward = polygon_area_vector(corners).try_normalize()?.cross(along);
        let inward = if side.is_upward(soup, faces) { inward } else { -inward };
        let (x, y) = (inward.dot(u), inward.dot(v));
        (x != 0.0 || y != 0.0).then(|| Spoke {
            side: number,
            angle: y.atan2(x),
            upward: orientation.is_upward(soup, faces, side),
            part: orientation.part[side.face as usize],
        })
    };
    let mut spokes: Vec<Spoke> = edge.filter_map(spoke).collect();
    spokes.sort_by(|a, b| a.angle.total_cmp(&b.angle));
    // Start behind the widest gap, so that no plane is on both ends of the order.
    let full = std::f64::consts::TAU;
    let gap = |i: usize| {
        let before = if i == 0 { spokes[spokes.len() - 1].angle - full } else { spokes[i - 1].angle };
        spokes[i].angle - before
    };
    if let Some(start) = (0..spokes.len()).max_by(|&a, &b| gap(a).total_cmp(&gap(b))) {
        spokes[..start].iter_mut().for_each(|spoke| spoke.angle += full);
        spokes.rotate_left(start);
    }
    for plane in spokes.chunk_by_mut(|a, b| b.angle - a.angle < SAME_ANGLE) {
        plane.sort_by_key(|spoke| !spoke.upward);
    }
    spokes
}

/// Removes pairs of spokes like brackets around a circle: each spoke that runs down, with the next one
/// after it that runs up. Considers only spokes for which `counts` is true.
fn pair_wedges(spokes: &mut Vec<Spoke>, counts: impl Fn(&Spoke) -> bool, pairs: &mut Vec<(usize, usize)>) {
    let mut open = Vec::new();
    let mut paired = vec![false; spokes.len()];
    // The second round closes wedges that contain the start.
    for round in 0..2 {
        for (i, spoke) in spokes.iter().enumerate().filter(|(_, spoke)| counts(spoke)) {
            if spoke.upward && !paired[i] {
                if let Some(start) = open.pop() {
                    let start: usize = start;
                    (paired[start], paired[i]) = (true, true);
                    pairs.push((spokes[start].side, spoke.side));
                }
            } else if !spoke.upward && round == 0 {
                open.push(i);
            }
        }
    }
    let mut i = 0;
    spokes.retain(|_| {
        i += 1;
        !paired[i - 1]
    });
}
