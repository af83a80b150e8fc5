//! The mesh being remeshed, with the curves that are kept.

use super::curves::{Arc, Curves};
use super::pieces_of_sliver;
use super::side_numbers::SideNumbers;
use crate::trimesh::{Order, Role, TriMesh, prev, with_room};
use glam::DVec3;
use halfedge::{Element, Mesh, NONE};

/// The cosine of the largest angle by which a triangle may turn in a merge or flip.
pub(super) const MIN_TURN_COS: f64 = 0.5;

/// With the usual limits, 4/3 and 4/5 of the length, edges become a little too long on average; limits smaller by
/// this factor make them as long as asked for.
const LIMIT_CORRECTION: f64 = 0.97;

/// The length above which edges are split.
pub(super) fn split_above(length: f64) -> f64 {
    LIMIT_CORRECTION * length * 4.0 / 3.0
}

/// The triangles with everything needed to change them.
pub(super) struct Work {
    /// The triangles; their sources are triangles of the input.
    pub tri: TriMesh,
    pub curves: Curves,
    /// The input that vertices are projected onto; none if they aren't.
    input: Option<TriMesh>,
    /// Per triangle of the input: its face of the mesh. Empty if faces have no attributes.
    face: Vec<u32>,
    /// Per half-edge and per kept edge; see [`super::curves::Found`].
    pub arc: SideNumbers,
    pub arcs: Vec<Arc>,
    /// Per vertex: how it may move.
    pub roles: Vec<Role>,
    /// Per vertex: the triangle of the input that it was last closest to.
    pub near: Vec<u32>,
    pub stamps: Vec<u32>,
    pub stamp: u32,
    /// The squared lengths above which edges are split and below which they are merged, in the frame.
    pub longest: f64,
    pub shortest: f64,
    /// The number of triangles made since the arrays were last ordered.
    pub unordered: usize,
    /// The number of edges that the last round flipped only for the sake of poor triangles.
    pub slivers: usize,
}

/// The squared sine of the smallest angle, which is opposite the shortest side: 3/4 at best.
#[inline]
pub(super) fn quality(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let area = (b - a).cross(c - a).length_squared();
    let (x, y, z) = (a.distance_squared(b), b.distance_squared(c), c.distance_squared(a));
    let shortest = x.min(y).min(z);
    // The product of the two longer sides.
    let longer = if shortest == x {
        y * z
    } else if shortest == y {
        x * z
    } else {
        x * y
    };
    if longer > 0.0 { area / longer } else { 0.0 }
}

impl Work {
    /// Prepares remeshing to edges of this length in the frame.
    pub fn new(mesh: &Mesh, mut tri: TriMesh, length: f64, least_cos: f64, project: bool) -> Self {
        let square = |x: f64| x * x;
        let longest = square(split_above(length));
        // Arrays that grow in turns fragment the memory: room for the first splits is reserved at once, and for
        // some more, as longer edges nearby are split first.
        let splits = (0..tri.v.len() as u32)
            .filter(|&h| h < tri.opp(h) && tri.at(tri.from(h)).distance_squared(tri.at(tri.to(h))) > longest);
        let splits = splits.count() * 17 / 16;
        let found = Curves::find(mesh, &tri, least_cos, length);
        let own = (0..tri.face_source.len() as u32).collect();
        let mut face = std::mem::replace(&mut tri.face_source, own);
        if mesh.columns().of(Element::Face).is_empty() {
            face = Vec::new();
        }
        tri.reserve_splits(splits);
        Self {
            near: with_room(tri.out.iter().map(|out| out / 3), splits),
            input: project.then(|| tri.bare_copy()),
            face,
            curves: found.curves,
            arc: found.arc,
            arcs: found.arcs,
            roles: found.roles,
            stamps: with_room(tri.out.iter().map(|_| 0), splits),
            stamp: 0,
            longest,
            shortest: square(LIMIT_CORRECTION * length * 4.0 / 5.0),
            unordered: 0,
            slivers: usize::MAX,
            tri,
        }
    }

    /// The triangles; frees everything else.
    pub fn finish(self) -> TriMesh {
        let Self { mut tri, face, .. } = self;
        if face.is_empty() {
            tri.face_source = Vec::new();
        }
        for source in &mut tri.face_source {
            *source = face[*source as usize];
        }
        tri
    }

    /// Orders the arrays again so that neighbours are close in memory, without removed elements.
    pub fn put_in_order(&mut self) {
        self.stamps = Vec::new();
        let Order { vertices, triangles } = self.tri.put_in_order();
        vertices.apply(&mut self.roles);
        vertices.apply(&mut self.near);
        self.stamps = vec![0; vertices.len()];
        self.stamp = 0;
        self.arc.reorder(&triangles);
        self.unordered = 0;
    }

    /// The fewest triangles that splitting the long edges makes.
    pub fn least_pieces(&self) -> f64 {
        let triangles = (0..self.tri.v.len() as u32 / 3).map(|f| 3 * f).filter(|&h| self.tri.is_alive(h));
        let pieces = triangles.map(|h| {
            let longest =
                [h, h + 1, h + 2].map(|side| self.length_squared(side)).into_iter().fold(0.0, f64::max);
            pieces_of_sliver((0.5 * (longest / self.longest).log2()).floor())
        });
        pieces.sum()
    }

    #[inline]
    pub fn is_kept(&self, h: u32) -> bool {
        self.arc.get(h) != NONE
    }

    #[inline]
    pub fn length_squared(&self, h: u32) -> f64 {
        self.tri.at(self.tri.from(h)).distance_squared(self.tri.at(self.tri.to(h)))
    }

    /// The places of a kept half-edge's start and end on its curve.
    pub fn places(&self, h: u32) -> [f64; 2] {
        let arc = self.arc.get(h);
        let [a, b] = self.arcs[arc as usize / 2].ends;
        if arc.is_multiple_of(2) { [a, b] } else { [b, a] }
    }

    /// Sets the place of a kept half-edge's start.
    fn set_start(&mut self, h: u32, place: f64) {
        let arc = self.arc.get(h);
        self.arcs[arc as usize / 2].ends[arc as usize % 2] = place;
    }

    fn set_end(&mut self, h: u32, place: f64) {
        let arc = self.arc.get(h);
        self.arcs[arc as usize / 2].ends[1 - arc as usize % 2] = place;
    }

    /// The first two kept half-edges at a vertex: those that leave, or come in where none leaves.
    pub fn kept_at(&self, v: u32) -> [u32; 2] {
        let (mut pair, mut count) = ([NONE; 2], 0);
        let mut put = |h: u32| {
            if let Some(slot) = pair.get_mut(count) {
                *slot = h;
            }
            count += 1;
        };
        self.tri.around(v, |out| {
            if self.is_kept(out) {
                put(out);
            }
            // The last edge on the boundary has only a half-edge that comes in.
            if self.tri.turn(out) == NONE {
                put(prev(out));
            }
        });
        pair
    }

    /// The point at a place on a kept half-edge's curve.
    pub fn curve_point(&self, h: u32, place: f64) -> DVec3 {
        self.curves.at(self.arcs[self.arc.get(h) as usize / 2].curve, place)
    }

    /// Changes the place of a vertex on its curve.
    pub fn slide(&mut self, v: u32, by: f64) {
        for h in self.kept_at(v) {
            if h != NONE {
                let [place, _] = self.places_from(v, h);
                self.set_place(v, h, place + by);
            }
        }
    }

    /// The places of a kept half-edge's end at `v` and of its other end.
    pub fn places_from(&self, v: u32, h: u32) -> [f64; 2] {
        let [a, b] = self.places(h);
        if self.tri.from(h) == v { [a, b] } else { [b, a] }
    }

    /// Sets the place of a kept half-edge's end at `v`.
    fn set_place(&mut self, v: u32, h: u32, place: f64) {
        if self.tri.from(h) == v { self.set_start(h, place) } else { self.set_end(h, place) }
    }

    /// Projects a point near a vertex onto the input; returns the point and its triangle.
    pub fn project(&self, v: u32, p: DVec3) -> (DVec3, u32) {
        let near = self.near[v as usize];
        match &self.input {
            Some(input) => {
                let foot = input.closest(near, p);
                (foot.at, foot.face)
            }
            None => (p, near),
        }
    }

    /// Whether no triangle of a vertex turns over if it moves.
    pub fn may_move(&self, v: u32, to: DVec3) -> bool {
        let tri = &self.tri;
        let here = tri.at(v);
        let mut good = true;
        tri.around(v, |out| {
            let (x, y) = (tri.at(tri.to(out)), tri.at(tri.apex(out)));
            let (old, new) = ((x - here).cross(y - here), (x - to).cross(y - to));
            good &= new.dot(old) > 0.0 || old == DVec3::ZERO;
        });
        good
    }

    /// The end of an edge other than `v`.
    pub fn other_end(&self, v: u32, h: u32) -> u32 {
        if self.tri.from(h) == v { self.tri.to(h) } else { self.tri.from(h) }
    }
}
