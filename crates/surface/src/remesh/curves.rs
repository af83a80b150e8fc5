//! The kept curves of the input: boundaries, sharp edges, seams, creases and borders.
//!
//! A curve is a polyline between two corners, or closed; a place on it is a length along it. Each kept edge of the
//! mesh has the places of its two ends, so that a vertex slides exactly along its curve, whatever the curve's
//! shape, and never past its neighbours.

use super::kept_edges::{Kept, kept_edges};
use super::side_numbers::SideNumbers;
use crate::trimesh::{Role, TriMesh};
use glam::DVec3;
use halfedge::{Mesh, NONE};

/// A kept edge: a piece of a curve.
#[derive(Clone, Copy)]
pub(super) struct Arc {
    /// The curve.
    pub curve: u32,
    /// The places of the two ends, as lengths along the curve. A place past the end of a closed curve continues from
    /// its start.
    pub ends: [f64; 2],
}

/// One polyline.
struct Curve {
    /// The first of its points in [`Curves::points`], and their number.
    first: usize,
    count: usize,
    closed: bool,
}

/// All curves.
#[derive(Default)]
pub(super) struct Curves {
    curves: Vec<Curve>,
    /// The points of all curves; a closed curve repeats its first point at the end.
    points: Vec<DVec3>,
    /// Per point: the length of its curve up to there.
    along: Vec<f64>,
}

/// The curves of a mesh, with its edges and vertices on them.
pub(super) struct Found {
    pub curves: Curves,
    /// Per half-edge: twice its edge's index in `arcs`, plus 1 if it leads from the second end to the first; or
    /// [`NONE`].
    pub arc: SideNumbers,
    pub arcs: Vec<Arc>,
    /// Per vertex: how it may move.
    pub roles: Vec<Role>,
}

impl Curves {
    /// The point at a place.
    pub fn at(&self, curve: u32, place: f64) -> DVec3 {
        let Curve { first, count, closed } = self.curves[curve as usize];
        let (points, along) = (&self.points[first..first + count], &self.along[first..first + count]);
        let length = along[count - 1];
        let place = if closed && length > 0.0 { place - length * (place / length).floor() } else { place };
        // The first point past the place: the segment before it contains the place.
        let end = along.partition_point(|&at| at <= place).clamp(1, count - 1);
        let piece = along[end] - along[end - 1];
        let t = if piece > 0.0 { ((place - along[end - 1]) / piece).clamp(0.0, 1.0) } else { 0.0 };
        points[end - 1] + (points[end] - points[end - 1]) * t
    }

    fn length(&self, curve: u32) -> f64 {
        let Curve { first, count, .. } = self.curves[curve as usize];
        self.along[first + count - 1]
    }

    /// Finds the curves of `tri`, the triangles of `mesh`. Edges are sharp if the cosine of the angle between the
    /// normals of their faces is less than `least_cos`; `length` is the new edge length.
    pub fn find(mesh: &Mesh, tri: &TriMesh, least_cos: f64, length: f64) -> Found {
        let mut kept = kept_edges(mesh, tri, least_cos, length);
        loop {
            let found = find_all(tri, &kept, least_cos, length);
            if !drop_short(tri, &found, &mut kept, length) {
                return found;
            }
        }
    }
}

/// Drops sharp curves with a loose end that are shorter than `length`: they are noise, which edges of that length
/// can't follow. Returns whether there were any.
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
        let curve = found.arcs[found.arc.get(h) as usize / 2].curve as usize;
        sharp[curve] &= kept[h as usize] == Kept::Sharp;
        loose[curve] |= degree[tri.from(h) as usize] == 1 || degree[tri.to(h) as usize] == 1;
    }
    let dropped: Vec<bool> = ((0u32..).zip(sharp).zip(loose))
        .map(|((curve, sharp), loose)| sharp && loose && found.curves.length(curve) < length)
        .collect();
    if !dropped.contains(&true) {
        return false;
    }
    for (h, kept) in (0u32..).zip(kept) {
        let arc = found.arc.get(h);
        if arc != NONE && dropped[found.arcs[arc as usize / 2].curve as usize] {
            *kept = Kept::No;
        }
    }
    true
}

/// Up to two kept edges at a vertex.
type Pair = [u32; 2];

fn find_all(tri: &TriMesh, kept: &[Kept], least_cos: f64, length: f64) -> Found {
    let mut search = Search::new(tri, kept);
    search.trace_all();
    search.fix_corners(least_cos, length);
    let roles = std::mem::take(&mut search.found.roles);
    search.found = Found::nothing(tri, roles);
    search.trace_all();
    search.found
}

impl Found {
    fn nothing(tri: &TriMesh, roles: Vec<Role>) -> Self {
        Self { curves: Curves::default(), arc: SideNumbers::new(tri.v.len() / 3), arcs: Vec::new(), roles }
    }
}

struct Search<'a> {
    tri: &'a TriMesh,
    kept: &'a [Kept],
    /// Per vertex.
    pairs: Vec<Pair>,
    found: Found,
}

impl<'a> Search<'a> {
    fn new(tri: &'a TriMesh, kept: &'a [Kept]) -> Self {
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
        Self { tri, kept, pairs, found: Found::nothing(tri, roles) }
    }

    /// The other end of an edge.
    fn other(&self, edge: u32, v: u32) -> u32 {
        let (from, to) = (self.tri.from(edge), self.tri.to(edge));
        if v == from { to } else { from }
    }

    /// Fixes corners of curves: where a curve turns by more than the feature angle within an edge length, or an
    /// eighth of its own length, its sharpest point there is a corner.
    fn fix_corners(&mut self, least_cos: f64, length: f64) {
        let on_curve: Vec<u32> =
            (0..self.tri.out.len() as u32).filter(|&v| self.found.roles[v as usize] == Role::Curve).collect();
        let mut turns: Vec<(f64, u32)> = Vec::new();
        for &v in &on_curve {
            let here = self.tri.at(v);
            let length = self.corner_range(v, length);
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
        // Sharpest first; points within half an edge length of a sharper one belong to the same corner.
        let mut near = vec![false; self.tri.out.len()];
        for (_, v) in turns {
            if near[v as usize] {
                continue;
            }
            let length = self.corner_range(v, length);
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

    /// The length of the curve on either side of a vertex that decides whether it is a corner.
    fn corner_range(&self, v: u32, length: f64) -> f64 {
        let arc = self.found.arcs[self.found.arc.get(self.pairs[v as usize][0]) as usize / 2];
        length.min(0.125 * self.found.curves.length(arc.curve))
    }

    /// The edge of a curve that follows `edge` at `v`.
    fn after(&self, edge: u32, v: u32) -> u32 {
        let [a, b] = self.pairs[v as usize];
        if a == edge { b } else { a }
    }

    /// Walks from a vertex along an edge and its curve for a length, at least over that edge and at most to the
    /// curve's end; returns the vertex and edge reached.
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

    fn trace_all(&mut self) {
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
        // The rest are closed curves without corners.
        for h in 0..self.tri.v.len() as u32 {
            if self.tri.edge(h) == h {
                self.trace(self.tri.from(h), h);
            }
        }
    }

    /// Records the curve that starts at a vertex with an edge, if the edge is kept and new.
    fn trace(&mut self, start: u32, edge: u32) {
        if self.kept[edge as usize] == Kept::No || self.found.arc.get(edge) != NONE {
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
            arc.set(edge, number + u32::from(!forward));
            let across = tri.opp(edge);
            if across != NONE {
                arc.set(across, number + u32::from(forward));
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Shape;

    fn found(mesh: &Mesh, length: f64) -> (TriMesh, Found) {
        let tri = TriMesh::new(mesh);
        let found = Curves::find(mesh, &tri, 0.7, length / tri.frame.scale);
        (tri, found)
    }

    fn shape(name: &str) -> Mesh {
        Shape::named(name).expect("listed").build().expect("fits")
    }

    #[test]
    fn a_cube_has_twelve_curves_and_a_cylinder_two_that_are_closed() {
        let (_, of_cube) = found(&shape("cube"), 0.5);
        assert_eq!(of_cube.curves.curves.len(), 12);
        assert!(of_cube.roles.iter().all(|&role| role == Role::Fixed));
        let (tri, of_cylinder) = found(&shape("cylinder"), 0.5);
        assert!(of_cylinder.curves.curves.iter().map(|c| c.closed).eq([true, true]));
        assert_eq!(of_cylinder.arcs.len(), 64);
        // Both half-edges of a kept edge know its places, the other way round.
        for h in 0..tri.v.len() as u32 {
            let arc = of_cylinder.arc.get(h);
            if arc == NONE {
                continue;
            }
            assert_eq!(of_cylinder.arc.get(tri.opp(h)), arc ^ 1);
            let Arc { curve, ends } = of_cylinder.arcs[arc as usize / 2];
            let start = of_cylinder.curves.at(curve, ends[arc as usize % 2]);
            assert!(start.distance(tri.at(tri.from(h))) < 1e-12);
        }
    }

    #[test]
    fn places_go_round_closed_curves_and_stop_at_the_ends_of_open_ones() {
        let square = vec![DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Y, DVec3::ZERO];
        let along = vec![0.0, 1.0, 2.0, 3.0, 4.0];
        let curve = |closed| Curves {
            curves: vec![Curve { first: 0, count: 5, closed }],
            points: square.clone(),
            along: along.clone(),
        };
        let (round, open) = (curve(true), curve(false));
        for (place, on_round, on_open) in [
            (1.5, DVec3::new(1.0, 0.5, 0.0), DVec3::new(1.0, 0.5, 0.0)),
            (4.25, DVec3::new(0.25, 0.0, 0.0), DVec3::ZERO),
            (-0.5, DVec3::new(0.0, 0.5, 0.0), DVec3::ZERO),
            (3.0, DVec3::Y, DVec3::Y),
        ] {
            assert_eq!(round.at(0, place), on_round);
            assert_eq!(open.at(0, place), on_open);
        }
    }

    #[test]
    fn a_speck_on_a_wide_surface_is_no_curve() {
        let mut sphere = shape("ico-sphere");
        let spike = sphere.vertices().next().expect("has vertices");
        sphere.set_position(spike, sphere.position(spike) * 1.5);
        let count = |mesh: &Mesh, length| found(mesh, length).1.curves.curves.len();
        assert_eq!(count(&sphere, 1.0), 0);
        assert!(count(&sphere, 0.1) >= 5);
        assert_eq!(count(&shape("cube"), 6.0), 12, "nothing else would be left of it");
    }

    #[test]
    fn a_folded_sliver_is_no_curve() {
        // Two flat triangles with a thin one between them that is folded back over the first: its sides
        // are sharp, but what lies beyond it is flat.
        let p = |x: f32, y: f32| glam::Vec3::new(x, y, 0.0);
        let positions = vec![p(-9.0, 0.0), p(9.0, 0.0), p(0.0, 9.0), p(0.0, -9.0), p(1.0, 0.2)];
        let faces = [[0, 1, 2], [1, 0, 4], [0, 3, 4], [3, 1, 4]];
        let mesh = Mesh::build(halfedge::PolygonSoup::new(positions, &faces)).expect("small").mesh;
        let tri = TriMesh::new(&mesh);
        let kept = kept_edges(&mesh, &tri, 0.7, 1e-6);
        let borders = kept.iter().filter(|&&kept| kept == Kept::Border).count();
        assert_eq!((borders, kept.iter().filter(|&&kept| kept == Kept::Sharp).count()), (4, 0));
    }
}
