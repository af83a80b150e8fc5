//! Bridge: bands of faces between boundary loops, or between regions of faces that they replace.
//!
//! A band goes along both loops at once. Where it goes on by an edge of both loops there is a quad, where only the longer
//! loop goes on a triangle; loops of equal length get quads only. Which vertices it joins is chosen so that its edges across
//! are short. Possible exactly if no edge joins the loops where a band would have one: the loops have no vertex in common,
//! the band takes the free sides of their edges, and it joins each pair of vertices once.

use crate::edit::patch::{Corner, Patch, Plan};
use crate::edit::shared::{Blend, outline};
use crate::edit::{Made, Refusal};
use crate::geometry::face_area_vector;
use crate::mesh::Mesh;
use crate::{Element, FaceId, HalfedgeId, NumberRange, VertexId};
use glam::DVec3;
use rustc_hash::{FxHashMap, FxHashSet};

/// The most distances that are measured to find how two loops fit best.
const MAX_MEASURED_DISTANCES: usize = 1 << 22;

/// The numbers of cuts along a band.
pub const BRIDGE_CUTS_RANGE: NumberRange = NumberRange::counts(0, 1000);

/// How far bands go on from the surfaces.
pub const BRIDGE_SMOOTHNESS_RANGE: NumberRange = NumberRange::new(0.0, 4.0);

/// The most loops at once: the distances between all of them are compared.
const MAX_LOOPS: usize = 2000;

/// What bands between loops are like.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bands {
    /// By how many vertices of the second loop the pairing is shifted from the best one.
    pub twist: i32,
    /// How many loops of new vertices lie between the two, evenly spaced.
    pub cuts: u32,
    /// Across a band, these vertices lie on a curve that leaves both surfaces in their directions: a cubic Bezier curve whose
    /// inner control points are this many thirds of the straight distance away. With 0 it is straight.
    pub smoothness: f32,
}

/// Whether [`bridge`] would succeed.
pub fn can_bridge(mesh: &Mesh, halfedges: &[HalfedgeId], bands: Bands) -> Result<(), Refusal> {
    plan_bridge(mesh, halfedges, bands).map(drop)
}

/// Whether [`bridge_faces`] would succeed.
pub fn can_bridge_faces(mesh: &Mesh, faces: &[FaceId], bands: Bands) -> Result<(), Refusal> {
    plan_bridge_faces(mesh, faces, bands).map(drop)
}

fn plan_bridge(mesh: &Mesh, halfedges: &[HalfedgeId], bands: Bands) -> Result<Plan, Refusal> {
    let mut seen: FxHashSet<HalfedgeId> = FxHashSet::default();
    let mut loops = Vec::new();
    for &h in halfedges {
        mesh.require_halfedge(h)?;
        if !mesh.is_boundary_halfedge(h) {
            return Err(Refusal::NotABoundaryHalfedge(h));
        }
        if !seen.contains(&h) {
            let sides: Vec<HalfedgeId> = mesh.loop_of(h).collect();
            seen.extend(&sides);
            loops.push(sides);
        }
    }
    match *halfedges {
        [] => return Err(Refusal::NothingGiven(Element::Halfedge)),
        [h] => return Err(Refusal::OnlyOne(Element::Halfedge, h.raw())),
        [one, other, ..] if loops.len() == 1 => return Err(Refusal::SameLoop(one, other)),
        _ => {}
    }
    let mut patch = Patch::new(mesh);
    add_bands(mesh, &mut patch, loops, bands)?;
    patch.plan(mesh)
}

fn plan_bridge_faces(mesh: &Mesh, faces: &[FaceId], bands: Bands) -> Result<Plan, Refusal> {
    let mut given: FxHashSet<FaceId> = FxHashSet::default();
    for &face in faces {
        mesh.require_face(face)?;
        if !given.insert(face) {
            return Err(Refusal::GivenTwice(Element::Face, face.raw()));
        }
    }
    match *faces {
        [] => return Err(Refusal::NothingGiven(Element::Face)),
        [face] => return Err(Refusal::OnlyOne(Element::Face, face.raw())),
        _ => {}
    }
    let regions = regions(mesh, faces, &given);
    let mut corners: FxHashMap<VertexId, (usize, FaceId)> = FxHashMap::default();
    for (at, region) in regions.iter().enumerate() {
        for &face in region {
            for v in mesh.face_vertices(face) {
                let (other, near) = *corners.entry(v).or_insert((at, face));
                let is_only = regions.len() == 1 && near != face;
                if other != at || is_only {
                    return Err(Refusal::FacesTouch(near, face, v));
                }
            }
        }
    }
    let mut loops = Vec::with_capacity(regions.len());
    for region in &regions {
        loops.push(outline(mesh, &region.iter().copied().collect())?);
    }
    let mut patch = Patch::new(mesh);
    add_bands(mesh, &mut patch, loops, bands)?;
    patch.remove = faces.to_vec();
    patch.plan(mesh)
}

/// The given faces in groups that are joined by edges, in the order in which their first faces were given.
fn regions(mesh: &Mesh, faces: &[FaceId], given: &FxHashSet<FaceId>) -> Vec<Vec<FaceId>> {
    let mut found: FxHashSet<FaceId> = FxHashSet::default();
    let mut regions = Vec::new();
    for &first in faces {
        if !found.insert(first) {
            continue;
        }
        let mut region = vec![first];
        let mut at = 0;
        while let Some(&face) = region.get(at) {
            let beside = mesh.face_halfedges(face).filter_map(|h| mesh.face_of(h.twin()));
            region.extend(beside.filter(|other| given.contains(other) && found.insert(*other)));
            at += 1;
        }
        regions.push(region);
    }
    regions
}

/// Adds the bands between loops of sides, which they take.
fn add_bands(
    mesh: &Mesh,
    patch: &mut Patch,
    loops: Vec<Vec<HalfedgeId>>,
    bands: Bands,
) -> Result<(), Refusal> {
    BRIDGE_CUTS_RANGE.require("cuts", bands.cuts as f32)?;
    BRIDGE_SMOOTHNESS_RANGE.require("smoothness", bands.smoothness)?;
    if loops.len() % 2 == 1 || loops.len() > MAX_LOOPS {
        return Err(Refusal::NotInPairs(loops.len()));
    }
    for (one, other) in nearest_pairs(mesh, &loops) {
        if let (Some(a), Some(b)) = (loops.get(one), loops.get(other)) {
            add_band(mesh, patch, a, b, bands);
        }
    }
    Ok(())
}

/// Each loop with another: the two closest ones first, by their mean positions, then the closest of the others.
fn nearest_pairs(mesh: &Mesh, loops: &[Vec<HalfedgeId>]) -> Vec<(usize, usize)> {
    let middles: Vec<DVec3> = loops
        .iter()
        .map(|sides| sides.iter().map(|&h| position(mesh, h)).sum::<DVec3>() / sides.len() as f64)
        .collect();
    let mut pairs: Vec<(f64, usize, usize)> = Vec::new();
    for (i, a) in middles.iter().enumerate() {
        pairs.extend(middles.iter().enumerate().skip(i + 1).map(|(j, b)| (a.distance_squared(*b), i, j)));
    }
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut is_paired = vec![false; loops.len()];
    let mut chosen = Vec::new();
    for (_, i, j) in pairs {
        if !is_paired[i] && !is_paired[j] {
            (is_paired[i], is_paired[j]) = (true, true);
            chosen.push((i, j));
        }
    }
    chosen
}

fn position(mesh: &Mesh, h: HalfedgeId) -> DVec3 {
    mesh.position(mesh.from(h)).as_dvec3()
}

/// Adds the band between two loops.
fn add_band(mesh: &Mesh, patch: &mut Patch, a: &[HalfedgeId], b: &[HalfedgeId], bands: Bands) {
    let ways = [a, b].map(|sides| if bands.smoothness > 0.0 { ways_out(mesh, sides) } else { Vec::new() });
    // Seen from the band, the second loop runs backward.
    let last = b.len() - 1;
    let b: Vec<HalfedgeId> = b.iter().rev().copied().collect();
    let mut pairs = best_pairs(mesh, a, &b);
    for (_, j) in &mut pairs {
        *j = (*j as i64 + i64::from(bands.twist)).rem_euclid(b.len() as i64) as usize;
    }
    let curve = |i: usize, j: usize| {
        let ways = [ways[0].get(i), ways[1].get(last - j)].map(|way| way.copied().unwrap_or_default());
        Curve::new([a[i], b[j]].map(|h| position(mesh, h)), ways, f64::from(bands.smoothness))
    };
    let lines: Vec<Vec<Corner>> = pairs
        .iter()
        .map(|&(i, j)| line_across(mesh, patch, [a[i], b[j]], &curve(i, j), bands.cuts))
        .collect();
    for (at, &(i, j)) in pairs.iter().enumerate() {
        let next = (at + 1) % pairs.len();
        let (here, there) = (&lines[at], &lines[next]);
        let attributes_of = mesh.face_of(a[i].twin()).or(mesh.face_of(a[i]));
        let last = here.len() - 2;
        for row in 0..=last {
            let mut corners = vec![here[row].clone()];
            if row > 0 || pairs[next].0 != i {
                corners.push(there[row].clone());
            }
            if row < last || pairs[next].1 != j {
                corners.push(there[row + 1].clone());
            }
            corners.push(here[row + 1].clone());
            patch.add_face(attributes_of, corners);
        }
    }
}

/// The way on from the surface at the vertex that each side of a loop leaves, of length 1: along the faces beside the loop, at
/// right angles to its edges. Of faces that have nothing beside them it is the way that they face.
fn ways_out(mesh: &Mesh, sides: &[HalfedgeId]) -> Vec<DVec3> {
    let across = |h: HalfedgeId| {
        let twin = h.twin();
        let along = position(mesh, h) - position(mesh, twin);
        let way = match (mesh.face_of(twin), mesh.face_of(h)) {
            (Some(face), _) => along.cross(face_area_vector(mesh, face)),
            (None, Some(face)) => face_area_vector(mesh, face),
            (None, None) => DVec3::ZERO,
        };
        way.normalize_or_zero()
    };
    let of_sides: Vec<DVec3> = sides.iter().map(|h| across(*h)).collect();
    let before = of_sides.iter().cycle().skip(of_sides.len().saturating_sub(1));
    of_sides.iter().zip(before).map(|(after, before)| (*before + *after).normalize_or_zero()).collect()
}

/// A line across a band: a cubic Bezier curve.
struct Curve([DVec3; 4]);

impl Curve {
    /// The curve between two points that leaves them these ways; see [`Bands::smoothness`].
    fn new([from, to]: [DVec3; 2], ways: [DVec3; 2], smoothness: f64) -> Self {
        let straight = (to - from) / 3.0;
        let handle = straight.length() * smoothness;
        let rest = straight * (1.0 - smoothness.min(1.0));
        Self([from, from + rest + ways[0] * handle, to - rest + ways[1] * handle, to])
    }

    fn at(&self, t: f64) -> DVec3 {
        let Self([a, b, c, d]) = *self;
        let [ab, bc, cd] = [a.lerp(b, t), b.lerp(c, t), c.lerp(d, t)];
        ab.lerp(bc, t).lerp(bc.lerp(cd, t), t)
    }
}

/// The corners from the vertex that a side of one loop leaves to that of the other.
fn line_across(
    mesh: &Mesh,
    patch: &mut Patch,
    [a, b]: [HalfedgeId; 2],
    curve: &Curve,
    cuts: u32,
) -> Vec<Corner> {
    let [va, vb] = [a, b].map(|h| mesh.from(h));
    let [ca, cb] = [a, b].map(|h| corner_across(mesh, h));
    let mut line = vec![Corner::new(va, ca)];
    for cut in 1..=cuts {
        let t = cut as f32 / (cuts + 1) as f32;
        let position = curve.at(f64::from(t)).as_vec3();
        let vertex = patch.add_vertex(position, Blend::Mix(va.raw(), vb.raw(), t));
        line.push(Corner { vertex, value: Blend::Mix(ca.raw(), cb.raw(), t), replaces: None });
    }
    line.push(Corner::new(vb, cb));
    line
}

/// The corner whose values the band takes over at the vertex that a side leaves: that of the face across the side, or else of
/// its own face.
fn corner_across(mesh: &Mesh, h: HalfedgeId) -> HalfedgeId {
    if mesh.is_boundary_halfedge(h.twin()) { h } else { mesh.next(h.twin()) }
}

/// The places in both loops that the edges across join, in order, so that the sum of their lengths is small: least among
/// the ways to go along both loops evenly, and then least of all that have the shortest of these edges in common. For very
/// long loops, evenly from the vertex closest to the first vertex of the first loop.
fn best_pairs(mesh: &Mesh, a: &[HalfedgeId], b: &[HalfedgeId]) -> Vec<(usize, usize)> {
    let (n, m) = (a.len(), b.len());
    let steps = n.max(m);
    let is_measured = steps * n.min(m) <= MAX_MEASURED_DISTANCES;
    let [at_a, at_b] = [a, b].map(|sides| sides.iter().map(|&h| position(mesh, h)).collect::<Vec<_>>());
    let evenly = |turn: usize| (0..steps).map(move |k| (k * n / steps, (k * m / steps + turn) % m));
    let distance = |(i, j): (usize, usize)| at_a[i].distance(at_b[j]);
    let samples = if steps * m <= MAX_MEASURED_DISTANCES { steps } else { 1 };
    // Lengths, not their squares: those of two circles side by side have the same sum whatever the turn.
    let mut best = (f64::INFINITY, 0);
    for turn in 0..m {
        let cost: f64 = evenly(turn).take(samples).map(distance).sum();
        // Turns that differ by rounding alone are equally good.
        if cost < best.0 * (1.0 - 1e-9) {
            best = (cost, turn);
        }
    }
    let pairs: Vec<(usize, usize)> = evenly(best.1).collect();
    if n == m || !is_measured {
        return pairs;
    }
    let shortest = pairs.iter().copied().min_by(|x, y| distance(*x).total_cmp(&distance(*y)));
    let (i, j) = shortest.unwrap_or_default();
    if n > m {
        let steps = shortest_steps(n, m, |k, l| distance(((i + k) % n, (j + l) % m)));
        (0..n).zip(steps).map(|(k, l)| ((i + k) % n, (j + l) % m)).collect()
    } else {
        let steps = shortest_steps(m, n, |k, l| distance(((i + l) % n, (j + k) % m)));
        (0..m).zip(steps).map(|(k, l)| ((i + l) % n, (j + k) % m)).collect()
    }
}

/// For each vertex of the longer loop, how many edges the shorter one has gone on: those with the least sum of distances of
/// all that begin at 0, go on by at most one at a time and arrive where they began.
fn shortest_steps(long: usize, short: usize, distance: impl Fn(usize, usize) -> f64) -> Vec<usize> {
    // The least sums up to a vertex of the longer loop, by the place in the shorter one, and whether it went on there.
    let mut sums = vec![f64::INFINITY; short + 1];
    let mut went_on = vec![false; long * (short + 1)];
    for k in 0..long {
        for l in (0..=short).rev() {
            let before = if l > 0 { sums[l - 1] } else { f64::INFINITY };
            let (sum, moves) = match k {
                0 => (if l == 0 { 0.0 } else { f64::INFINITY }, false),
                _ if before < sums[l] => (before, true),
                _ => (sums[l], false),
            };
            sums[l] = if sum.is_finite() { sum + distance(k, l) } else { sum };
            went_on[k * (short + 1) + l] = moves;
        }
    }
    // The last step arrives at the first vertices of both, with or without an edge of the shorter loop.
    let mut l = if sums[short - 1] < sums[short] { short - 1 } else { short };
    let mut steps = vec![0; long];
    for k in (0..long).rev() {
        steps[k] = l;
        l -= usize::from(went_on[k * (short + 1) + l]);
    }
    steps
}

/// Puts bands of quads and triangles between the boundary loops of half-edges: between two loops, or between the pairs
/// among an even number of them that are closest, by their mean positions. Of each loop any number of half-edges may be
/// given. The edges across are as short as the pairing of vertices allows, except for a twist, and have new vertices for
/// cuts.
///
/// All ids survive. Costs O(product of the loops' lengths) up to 4 million, beyond that O(lengths), plus the valences of
/// the vertices and the vertices of cuts, and for many loops O(square of their number). Attributes: faces copy those across
/// the first loop, corners those of the faces across their loop; those of cuts are interpolated.
pub fn bridge(mesh: &mut Mesh, halfedges: &[HalfedgeId], bands: Bands) -> Result<Made, Refusal> {
    Ok(plan_bridge(mesh, halfedges, bands)?.apply(mesh))
}

/// Puts bands between regions of faces in place of them, as [`bridge`] does between loops: a handle, or a passage where
/// they face away from each other. A region is faces that are joined by edges, and has to be a disc.
///
/// The faces are removed, with the edges and vertices inside regions; all other ids survive. Cost and attributes are those
/// of [`bridge`], with the outlines of the regions as the loops.
pub fn bridge_faces(mesh: &mut Mesh, faces: &[FaceId], bands: Bands) -> Result<Made, Refusal> {
    Ok(plan_bridge_faces(mesh, faces, bands)?.apply(mesh))
}
