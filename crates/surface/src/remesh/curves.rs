//! The curves of the input that are kept: boundaries, sharp edges, seams, creases and borders.
//!
//! Between two corners, or once round, a curve is a polyline, and a place on it a length along it. Each
//! kept edge of the mesh being worked on knows the places of its two ends, so that a vertex slides along
//! its curve exactly, whatever the curve does in space, and never past its neighbours.

use crate::trimesh::TriMesh;
use glam::DVec3;
use halfedge::{Mesh, NONE, keys};

/// What a vertex is part of.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Role {
    /// Nothing but the surface.
    Free,
    /// A curve that passes through it: it slides along that.
    Curve,
    /// Where curves end, meet or turn: it stays where it is.
    Fixed,
}

/// A kept edge: a piece of a curve.
#[derive(Clone, Copy)]
pub(super) struct Arc {
    /// Which curve.
    pub curve: u32,
    /// The places of its two ends, as lengths along the curve. Past the end of a closed curve it goes
    /// on from the start.
    pub ends: [f64; 2],
}

/// One polyline.
struct Curve {
    /// Where its points start in [`Curves::points`], and how many there are.
    first: usize,
    count: usize,
    closed: bool,
}

/// All of them.
#[derive(Default)]
pub(super) struct Curves {
    curves: Vec<Curve>,
    /// Points of all curves; a closed one ends with its first point again.
    points: Vec<DVec3>,
    /// Per point: the length of its curve up to it.
    along: Vec<f64>,
}

/// The curves of a mesh and how its edges and vertices lie on them.
pub(super) struct Found {
    pub curves: Curves,
    /// Per half-edge: twice its edge's place in `arcs`, plus 1 if it goes from the second end to the
    /// first; or [`NONE`].
    pub arc: Vec<u32>,
    pub arcs: Vec<Arc>,
    /// Per vertex.
    pub roles: Vec<Role>,
}

/// Sharp edges that hang together are kept if they are this many edges long in all.
const SPECK: f64 = 5.0;

/// A triangle is a sliver when it is lower than this, as a share of its longest side.
const SLIVER: f64 = 0.1;

/// Why an edge is kept.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kept {
    No,
    /// For the angle of its faces only.
    Sharp,
    /// For what it separates or carries.
    Border,
}

impl Curves {
    /// The point at a place.
    pub fn at(&self, curve: u32, place: f64) -> DVec3 {
        let Curve { first, count, closed } = self.curves[curve as usize];
        let (points, along) = (&self.points[first..first + count], &self.along[first..first + count]);
        let length = along[count - 1];
        let place = if closed && length > 0.0 { place - length * (place / length).floor() } else { place };
        // The first point past the place, so that the piece before it has it.
        let end = along.partition_point(|&at| at <= place).clamp(1, count - 1);
        let piece = along[end] - along[end - 1];
        let t = if piece > 0.0 { ((place - along[end - 1]) / piece).clamp(0.0, 1.0) } else { 0.0 };
        points[end - 1] + (points[end] - points[end - 1]) * t
    }

    /// Finds the curves of `tri`, the triangles of `mesh`. Sharp edges are those whose faces' normals
    /// have a smaller cosine than `least_cos`; `length` is how long edges are going to be.
    pub fn find(mesh: &Mesh, tri: &TriMesh, least_cos: f64, length: f64) -> Found {
        let mut kept = kept_edges(mesh, tri, least_cos);
        drop_long_sides(tri, &mut kept);
        drop_specks(tri, &mut kept, SPECK * length);
        loop {
            let found = Search::new(tri, &kept, least_cos, length).run();
            if !drop_short(tri, &found, &mut kept, length) {
                return found;
            }
        }
    }
}

fn kept_edges(mesh: &Mesh, tri: &TriMesh, least_cos: f64) -> Vec<Kept> {
    let material = mesh.attribute(keys::FACE_MATERIAL);
    let group = mesh.attribute(keys::FACE_GROUP);
    let color = mesh.attribute(keys::FACE_COLOR);
    let crease = mesh.attribute(keys::EDGE_CREASE);
    let area = |h: u32| {
        let [a, b, c] = [tri.from(h), tri.to(h), tri.apex(h)].map(|v| tri.at(v));
        (b - a).cross(c - a)
    };
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
        let (n, m) = (area(h), area(across));
        if a != b && n.dot(m) < least_cos * (n.length_squared() * m.length_squared()).sqrt() {
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
/// faces says nothing, and the two other sides keep the same curve.
fn drop_long_sides(tri: &TriMesh, kept: &mut [Kept]) {
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
        let [a, b, c] = sides.map(|h| tri.at(tri.from(h)));
        let height = (b - a).cross(c - a).length() / squared[longest];
        if height < SLIVER {
            kept[sides[longest] as usize] = Kept::No;
            kept[tri.opp(sides[longest]) as usize] = Kept::No;
        }
    }
}

/// No longer keeps sharp edges where those that hang together are not `length` long in all: noise, too.
fn drop_specks(tri: &TriMesh, kept: &mut [Kept], length: f64) {
    let sharp: Vec<u32> =
        (0..tri.v.len() as u32).filter(|&h| kept[h as usize] == Kept::Sharp && tri.edge(h) == h).collect();
    // Sets of vertices that are joined, each pointing towards the smallest of its set.
    let mut set: Vec<u32> = (0..tri.out.len() as u32).collect();
    let mut lengths = vec![0.0; set.len()];
    let root = |set: &mut [u32], mut v: u32| {
        while set[v as usize] != v {
            set[v as usize] = set[set[v as usize] as usize];
            v = set[v as usize];
        }
        v
    };
    for &h in &sharp {
        let (a, b) = (root(&mut set, tri.from(h)), root(&mut set, tri.to(h)));
        set[a.max(b) as usize] = a.min(b);
    }
    for &h in &sharp {
        lengths[root(&mut set, tri.from(h)) as usize] += tri.at(tri.from(h)).distance(tri.at(tri.to(h)));
    }
    for &h in &sharp {
        if lengths[root(&mut set, tri.from(h)) as usize] < length {
            kept[h as usize] = Kept::No;
            kept[tri.opp(h) as usize] = Kept::No;
        }
    }
}

/// No longer keeps sharp edges that end in the middle of the surface before they are `length` long:
/// noise, which edges of that length can't follow. Says whether there were any.
fn drop_short(tri: &TriMesh, found: &Found, kept: &mut [Kept], length: f64) -> bool {
    let mut sharp = vec![true; found.curves.curves.len()];
    let mut loose = vec![false; found.curves.curves.len()];
    let mut degree = vec![0u8; tri.out.len()];
    let edges = || (0..tri.v.len() as u32).filter(|&h| kept[h as usize] != Kept::No && tri.edge(h) == h);
    for h in edges() {
        for v in [tri.from(h), tri.to(h)] {
            degree[v as usize] = degree[v as usize].saturating_add(1);
        }
    }
    for h in edges() {
        let curve = found.arcs[found.arc[h as usize] as usize / 2].curve as usize;
        sharp[curve] &= kept[h as usize] == Kept::Sharp;
        loose[curve] |= degree[tri.from(h) as usize] == 1 || degree[tri.to(h) as usize] == 1;
    }
    let dropped: Vec<bool> = (found.curves.curves.iter().zip(sharp).zip(loose))
        .map(|((curve, sharp), loose)| {
            sharp && loose && found.curves.along[curve.first + curve.count - 1] < length
        })
        .collect();
    if !dropped.contains(&true) {
        return false;
    }
    for (kept, &arc) in kept.iter_mut().zip(&found.arc) {
        if arc != NONE && dropped[found.arcs[arc as usize / 2].curve as usize] {
            *kept = Kept::No;
        }
    }
    true
}

/// The kept edges at a vertex, up to two.
type Pair = [u32; 2];

struct Search<'a> {
    tri: &'a TriMesh,
    kept: &'a [Kept],
    /// Per vertex.
    pairs: Vec<Pair>,
    found: Found,
}

impl<'a> Search<'a> {
    fn new(tri: &'a TriMesh, kept: &'a [Kept], least_cos: f64, length: f64) -> Self {
        let mut pairs = vec![[NONE; 2]; tri.out.len()];
        let mut degree = vec![0u8; tri.out.len()];
        for h in 0..tri.v.len() as u32 {
            if kept[h as usize] == Kept::No || tri.edge(h) != h {
                continue;
            }
            for v in [tri.from(h), tri.to(h)] {
                let count = &mut degree[v as usize];
                if let Some(slot) = pairs[v as usize].get_mut(*count as usize) {
                    *slot = h;
                }
                *count = count.saturating_add(1);
            }
        }
        let roles = degree
            .iter()
            .map(|count| match count {
                0 => Role::Free,
                2 => Role::Curve,
                _ => Role::Fixed,
            })
            .collect();
        let found =
            Found { curves: Curves::default(), arc: vec![NONE; tri.v.len()], arcs: Vec::new(), roles };
        let mut search = Self { tri, kept, pairs, found };
        search.fix_corners(least_cos, length);
        search
    }

    /// The other end of an edge.
    fn other(&self, edge: u32, v: u32) -> u32 {
        let (from, to) = (self.tri.from(edge), self.tri.to(edge));
        if v == from { to } else { from }
    }

    /// A curve that turns by more than the feature angle within the length of an edge has a corner where
    /// it turns most. What is finer than edges can follow is no corner.
    fn fix_corners(&mut self, least_cos: f64, length: f64) {
        let on_curve: Vec<u32> =
            (0..self.tri.out.len() as u32).filter(|&v| self.found.roles[v as usize] == Role::Curve).collect();
        let mut turns: Vec<(f64, u32)> = Vec::new();
        for &v in &on_curve {
            let here = self.tri.at(v);
            let [a, b] = self.pairs[v as usize].map(|edge| {
                let (there, _) = self.walk(v, edge, length);
                (self.tri.at(there) - here).normalize_or_zero()
            });
            let straight = -a.dot(b);
            if straight < least_cos {
                turns.push((straight, v));
            }
        }
        turns.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        // The sharpest first; those within half an edge of a sharper one are the same corner.
        let mut near = vec![false; self.tri.out.len()];
        for (_, v) in turns {
            if near[v as usize] {
                continue;
            }
            for edge in self.pairs[v as usize] {
                let (mut at, mut edge, mut gone) = (v, edge, 0.0);
                loop {
                    let next = self.other(edge, at);
                    gone += self.tri.at(at).distance(self.tri.at(next));
                    if gone > 0.5 * length || next == v || self.found.roles[next as usize] != Role::Curve {
                        break;
                    }
                    near[next as usize] = true;
                    edge = self.after(edge, next);
                    at = next;
                }
            }
            self.found.roles[v as usize] = Role::Fixed;
        }
    }

    /// The edge of a curve after `edge` at `v`.
    fn after(&self, edge: u32, v: u32) -> u32 {
        let [a, b] = self.pairs[v as usize];
        if a == edge { b } else { a }
    }

    /// Goes from a vertex along an edge and its curve for a length, at least over that edge and at most
    /// to the curve's end; gives the vertex and edge reached.
    fn walk(&self, v: u32, edge: u32, length: f64) -> (u32, u32) {
        let (mut at, mut edge) = (self.other(edge, v), edge);
        let mut gone = self.tri.at(v).distance(self.tri.at(at));
        while self.found.roles[at as usize] == Role::Curve && at != v {
            let following = self.after(edge, at);
            let next = self.other(following, at);
            gone += self.tri.at(at).distance(self.tri.at(next));
            if gone > length {
                break;
            }
            (at, edge) = (next, following);
        }
        (at, edge)
    }

    fn run(mut self) -> Found {
        for v in 0..self.tri.out.len() as u32 {
            if self.found.roles[v as usize] == Role::Fixed {
                let tri = self.tri;
                tri.around(v, |out| {
                    self.trace(v, tri.edge(out));
                    if tri.turn(out) == NONE {
                        self.trace(v, crate::trimesh::prev(out));
                    }
                });
            }
        }
        // What is left goes round without corners.
        for h in 0..self.tri.v.len() as u32 {
            if self.tri.edge(h) == h {
                self.trace(self.tri.from(h), h);
            }
        }
        self.found
    }

    /// Notes the curve that starts at a vertex with an edge, if that is kept and new.
    fn trace(&mut self, start: u32, edge: u32) {
        if self.kept[edge as usize] == Kept::No || self.found.arc[edge as usize] != NONE {
            return;
        }
        let tri = self.tri;
        let Found { curves, arc, arcs, roles } = &mut self.found;
        let first = curves.points.len();
        let (mut at, mut edge, mut along) = (start, edge, 0.0);
        curves.points.push(tri.at(at));
        curves.along.push(along);
        loop {
            let forward = tri.from(edge) == at;
            let next = if forward { tri.to(edge) } else { tri.from(edge) };
            let before = along;
            along += tri.at(at).distance(tri.at(next));
            curves.points.push(tri.at(next));
            curves.along.push(along);
            let number = 2 * arcs.len() as u32;
            arcs.push(Arc { curve: curves.curves.len() as u32, ends: [before, along] });
            arc[edge as usize] = number + u32::from(!forward);
            let across = tri.opp(edge);
            if across != NONE {
                arc[across as usize] = number + u32::from(forward);
            }
            if next == start || roles[next as usize] != Role::Curve {
                break;
            }
            let [a, b] = self.pairs[next as usize];
            edge = if a == edge { b } else { a };
            at = next;
        }
        let closed = roles[start as usize] == Role::Curve;
        curves.curves.push(Curve { first, count: curves.points.len() - first, closed });
    }
}
