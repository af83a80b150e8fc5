//! Which edges of the input are kept, and which sharp ones are only noise.

use crate::trimesh::{TriMesh, area_vector};
use glam::DVec3;
use halfedge::geometry::UnionFind;
use halfedge::{Mesh, NONE, keys};

/// Sharp edges that hang together are kept if they are this many edges long in all.
const SPECK: f64 = 5.0;

/// A triangle is a sliver when it is lower than this, as a share of its longest side.
const SLIVER: f64 = 0.1;

/// Why an edge is kept.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kept {
    No,
    /// For the angle of its faces only.
    Sharp,
    /// For what it separates or carries.
    Border,
}

/// Per half-edge of `tri`, the triangles of `mesh`: whether its edge is kept. Sharp edges are those whose
/// faces' normals have a smaller cosine than `least_cos`; `length` is how long edges are going to be.
pub(super) fn kept_edges(mesh: &Mesh, tri: &TriMesh, least_cos: f64, length: f64) -> Vec<Kept> {
    let mut kept = marked_edges(mesh, tri, least_cos);
    drop_sliver_sides(tri, &mut kept, least_cos);
    drop_specks(tri, &mut kept, SPECK * length);
    kept
}

fn marked_edges(mesh: &Mesh, tri: &TriMesh, least_cos: f64) -> Vec<Kept> {
    let material = mesh.attribute(keys::FACE_MATERIAL);
    let group = mesh.attribute(keys::FACE_GROUP);
    let color = mesh.attribute(keys::FACE_COLOR);
    let crease = mesh.attribute(keys::EDGE_CREASE);
    let kept = |h: u32| {
        let across = tri.opp(h);
        if across == NONE || tri.is_seam(h) {
            return Kept::Border;
        }
        if across < h {
            // Filled in from the other side.
            return Kept::No;
        }
        let [a, b] = [h, across].map(|h| tri.face_source[h as usize / 3] as usize);
        let creased = crease
            .zip(tri.edge_source.get(h as usize))
            .is_some_and(|(crease, &e)| crease.get(e as usize).is_some_and(|&sharpness| sharpness > 0.0));
        if creased
            || material.is_some_and(|m| m[a] != m[b])
            || group.is_some_and(|g| g[a] != g[b])
            || color.is_some_and(|c| c[a] != c[b])
        {
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

/// No longer keeps the longest side of slivers all of whose sides are sharp: which way such a triangle
/// faces says nothing, and the two other sides keep the same curve. Those are only kept where they are
/// sharp towards what is across the longest side.
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
        if area(tri, h).length() / squared[longest] >= SLIVER {
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

/// No longer keeps sharp edges where those that hang together are shorter in all than `length` and than
/// the piece of the mesh that they are on is wide: noise, too.
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
