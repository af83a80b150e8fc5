//! Which edges of the input are kept, and which sharp ones are only noise.

use crate::trimesh::{Borders, TriMesh, area_vector};
use glam::DVec3;
use halfedge::geometry::UnionFind;
use halfedge::{Mesh, NONE};

/// Connected sharp edges are kept if they are at least this many edge lengths long in all.
const MIN_SHARP_LENGTH_EDGES: f64 = 5.0;

/// A triangle is a sliver if its height is less than this share of its longest side.
const MAX_SLIVER_HEIGHT: f64 = 0.1;

/// Whether and why an edge is kept.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kept {
    No,
    /// Only for the angle between its faces.
    Sharp,
    /// For what it separates, or for its crease.
    Border,
}

/// Per half-edge of `tri`, the triangles of `mesh`, whether its edge is kept. Edges are sharp if the cosine of the
/// angle between the normals of their faces is less than `least_cos`; `length` is the new edge length.
pub(super) fn kept_edges(mesh: &Mesh, tri: &TriMesh, least_cos: f64, length: f64) -> Vec<Kept> {
    let mut kept = marked_edges(mesh, tri, least_cos);
    drop_sliver_sides(tri, &mut kept, least_cos);
    drop_specks(tri, &mut kept, MIN_SHARP_LENGTH_EDGES * length);
    kept
}

fn marked_edges(mesh: &Mesh, tri: &TriMesh, least_cos: f64) -> Vec<Kept> {
    let borders = Borders::new(mesh);
    let kept = |h: u32| {
        let across = tri.opp(h);
        if across == NONE || tri.is_seam(h) {
            return Kept::Border;
        }
        if across < h {
            // Copied from the other side below.
            return Kept::No;
        }
        if borders.has(tri, h) {
            return Kept::Border;
        }
        if turns(area(tri, h), area(tri, across), least_cos) {
            return Kept::Sharp;
        }
        Kept::No
    };
    let mut all: Vec<Kept> = (0..tri.v.len() as u32).map(kept).collect();
    for h in 0..all.len() {
        let across = tri.opp[h];
        if across != NONE && across < h as u32 {
            all[h] = all[across as usize];
        }
    }
    all
}

/// Drops the longest side of slivers whose sides are all sharp: the normal of such a triangle means nothing, and
/// the two other sides keep the same curve. These are only kept if they are sharp relative to the triangle across
/// the longest side.
fn drop_sliver_sides(tri: &TriMesh, kept: &mut [Kept], least_cos: f64) {
    for h in (0..tri.v.len() as u32).step_by(3) {
        let sides = [h, h + 1, h + 2];
        if sides.iter().any(|&h| kept[h as usize] != Kept::Sharp) {
            continue;
        }
        let squared = sides.map(|h| tri.at(tri.from(h)).distance_squared(tri.at(tri.to(h))));
        let longest = if squared[0] >= squared[1] && squared[0] >= squared[2] {
            0
        } else if squared[1] >= squared[2] {
            1
        } else {
            2
        };
        if area(tri, h).length() / squared[longest] >= MAX_SLIVER_HEIGHT {
            continue;
        }
        let behind = area(tri, tri.opp(sides[longest]));
        for (k, h) in sides.into_iter().enumerate() {
            let across = tri.opp(h);
            if k == longest || !turns(behind, area(tri, across), least_cos) {
                kept[h as usize] = Kept::No;
                kept[across as usize] = Kept::No;
            }
        }
    }
}

/// Twice the area vector of a half-edge's triangle.
fn area(tri: &TriMesh, h: u32) -> DVec3 {
    area_vector(&[tri.from(h), tri.to(h), tri.apex(h)].map(|v| tri.at(v)))
}

/// Whether two normals, of any length, differ by more than the feature angle.
fn turns(n: DVec3, m: DVec3, least_cos: f64) -> bool {
    n.dot(m) < least_cos * (n.length_squared() * m.length_squared()).sqrt()
}

/// Drops connected sharp edges that are shorter in all than `length` and than the width of their component of the
/// mesh: they are noise too.
fn drop_specks(tri: &TriMesh, kept: &mut [Kept], length: f64) {
    let sharp: Vec<u32> =
        (0..tri.v.len() as u32).filter(|&h| kept[h as usize] == Kept::Sharp && tri.edge(h) == h).collect();
    let mut sets = UnionFind::new(tri.out.len());
    for &h in &sharp {
        sets.union(tri.from(h), tri.to(h));
    }
    let mut lengths = vec![0.0; tri.out.len()];
    for &h in &sharp {
        lengths[sets.find(tri.from(h)) as usize] += tri.at(tri.from(h)).distance(tri.at(tri.to(h)));
    }
    let short: Vec<u32> =
        sharp.into_iter().filter(|&h| lengths[sets.find(tri.from(h)) as usize] < length).collect();
    if short.is_empty() {
        return;
    }
    let mut pieces = UnionFind::new(tri.out.len());
    let mut areas = vec![0.0; tri.out.len()];
    for h in 0..tri.v.len() as u32 {
        pieces.union(tri.from(h), tri.to(h));
    }
    for h in (0..tri.v.len() as u32).step_by(3) {
        let [a, b, c] = [h, h + 1, h + 2].map(|h| tri.at(tri.from(h)));
        areas[pieces.find(tri.from(h)) as usize] += 0.5 * (b - a).cross(c - a).length();
    }
    for h in short {
        let v = tri.from(h);
        if lengths[sets.find(v) as usize] < areas[pieces.find(v) as usize].sqrt() {
            kept[h as usize] = Kept::No;
            kept[tri.opp(h) as usize] = Kept::No;
        }
    }
}
